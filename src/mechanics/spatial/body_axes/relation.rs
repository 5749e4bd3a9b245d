//! What lies outboard of a body's origin, F = S p + e in axes of the body, and its eliminations.
//!
//! p = (a, α), F = (f, t), S = [[L, K], [Kᵀ, H]], 21 numbers; f and t act ON the outboard part. After a hinge about z, the z column of K and
//! the z row of H are zero; after a slide along z, the z row of L and of K. A free link has a constant S with zeros of its own.

use super::number::{
    Number, Rows, Triangle, Triple, apply, apply_onto, congruent, cross_onto, dot_onto, entry, masked, product, rows, sum as added, tilde,
    transposed, triple, values,
};
use crate::relation::spatial::algebra::{Columns, Symmetric3};
use crate::relation::spatial::{Empty, Full};
use crate::relation::{Cuts, Join, Promote};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// A relation whose zeros are known.
#[derive(Clone, Copy)]
pub struct Sparse<T> {
    pub linear: Triangle<T>,
    pub coupling: Rows<T>,
    pub angular: Triangle<T>,
    pub force: Triple<T>,
    pub torque: Triple<T>,
}

/// The relation at the origin of a body that carries others, in axes of that body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Local<T> {
    linear: [T; 6],
    coupling: [[T; 3]; 3],
    angular: [T; 6],
    force: [T; 3],
    torque: [T; 3],
}

/// The relation at the origin of a body that carries none: its own inertia, with zeros where `MOMENT` and `TENSOR` have no bits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alone<T, const MOMENT: u8, const TENSOR: u8> {
    pub mass: T,
    pub moment: [T; 3],
    pub tensor: [T; 6],
    pub force: [T; 3],
    pub torque: [T; 3],
}

/// What a joint can take in axes of the body outboard of it.
#[diagnostic::on_unimplemented(
    message = "a joint in body axes needs a `Link` on its outboard side, but meets `{Self}`",
    label = "no link outboard of a joint",
    note = "a robot is a chain of `Hinge` or `Slide` and `Link`, with arms in `Branch`, after `BodyAxes`; its tip is `Free`"
)]
pub trait Outboard<T: Scalar>: Copy {
    /// The relation with what is known of it.
    fn sparse(self) -> Sparse<T>;
}

/// What eliminating a coordinate leaves behind: q̈ = free − a · (its gains) − α · (its gains), in axes of the outboard body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gains<T> {
    /// For the acceleration of the body's origin.
    pub linear: [T; 3],
    /// For its angular acceleration: x and y for a hinge, whose z is one.
    pub angular: [T; 3],
    /// Without any.
    pub free: T,
    /// 1 / D, of the pivot.
    pub inverse: T,
}

impl<T: Scalar> Gains<T> {
    /// No gain yet.
    pub fn blank() -> Self {
        let o = T::zero();
        Self { linear: [o; 3], angular: [o; 3], free: o, inverse: o }
    }

    /// Whether the pivot resists.
    pub fn is_finite(&self) -> bool {
        self.inverse.is_finite() && self.linear.iter().chain(&self.angular).all(|x| x.is_finite())
    }
}

/// The relation of a body's own inertia: m, σ (kg·m), J about the origin (kg·m²), f and t of its velocities.
#[inline(always)]
fn own<T: Scalar>(mass: T, moment: Triple<T>, tensor: Triangle<T>, force: Triple<T>, torque: Triple<T>) -> Sparse<T> {
    let (m, o) = (Number::of(mass), Number::zero());
    let [x, y, z] = moment;
    let coupling = [[o, z, y.negated()], [z.negated(), o, x], [y, x.negated(), o]];
    Sparse { linear: [m, m, m, o, o, o], coupling, angular: tensor, force, torque }
}

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> Alone<T, MOMENT, TENSOR> {
    #[inline(always)]
    fn parts(self) -> Sparse<T> {
        let [a, b, c, d, e, f] = self.tensor;
        let of = |bit: usize, value: T| Number::masked(TENSOR, bit, value);
        let tensor = [of(0, a), of(1, b), of(2, c), of(3, d), of(4, e), of(5, f)];
        let moment = masked(MOMENT, self.moment);
        let force = if MOMENT & 7 == 0 { [Number::zero(); 3] } else { triple(self.force) };
        own(self.mass, moment, tensor, force, triple(self.torque))
    }
}

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> Outboard<T> for Alone<T, MOMENT, TENSOR> {
    #[inline(always)]
    fn sparse(self) -> Sparse<T> {
        self.parts()
    }
}

impl<T: Scalar> Outboard<T> for Local<T> {
    #[inline(always)]
    fn sparse(self) -> Sparse<T> {
        let Self { linear, coupling: [x, y, z], angular, force, torque } = self;
        let triangle = |[a, b, c, d, e, f]: [T; 6]| {
            [Number::of(a), Number::of(b), Number::of(c), Number::of(d), Number::of(e), Number::of(f)]
        };
        Sparse {
            linear: triangle(linear),
            coupling: [triple(x), triple(y), triple(z)],
            angular: triangle(angular),
            force: triple(force),
            torque: triple(torque),
        }
    }
}

impl<T: Scalar> Local<T> {
    /// With the inertia of the body at whose origin this is.
    #[inline(always)]
    pub fn with<const MOMENT: u8, const TENSOR: u8>(self, body: Alone<T, MOMENT, TENSOR>) -> Self {
        self.sparse().plus(&body.parts()).dense()
    }

    /// In inertial axes, of which `attitude` holds those of the body.
    #[inline(always)]
    pub fn turned(self, attitude: &Rows<T>) -> Full<T> {
        let Sparse { linear, coupling, angular, force, torque } = self.sparse().turned(attitude);
        let symmetric = |s: Triangle<T>| {
            let [xx, yy, zz, yz, xz, xy] = s.map(Number::value);
            Symmetric3 { xx, xy, xz, yy, yz, zz }
        };
        let [x, y, z] = transposed(&coupling).map(|column| Vector3::from(values(column)));
        Full {
            linear: symmetric(linear),
            coupling: Columns { x, y, z },
            angular: symmetric(angular),
            force: Vector3::from(values(force)),
            torque: Vector3::from(values(torque)),
            cuts: Cuts::none(),
        }
    }
}

impl<T: Scalar> Sparse<T> {
    #[inline(always)]
    fn plus(&self, other: &Self) -> Self {
        let add = |a: &Triangle<T>, b: &Triangle<T>| {
            let of = |i: usize| a[i].plus(b[i]);
            [of(0), of(1), of(2), of(3), of(4), of(5)]
        };
        let row = |i: usize| added(self.coupling[i], other.coupling[i]);
        Self {
            linear: add(&self.linear, &other.linear),
            coupling: [row(0), row(1), row(2)],
            angular: add(&self.angular, &other.angular),
            force: added(self.force, other.force),
            torque: added(self.torque, other.torque),
        }
    }

    /// Without what is known.
    #[inline(always)]
    pub fn dense(self) -> Local<T> {
        let [x, y, z] = self.coupling;
        let triangle = |[a, b, c, d, e, f]: Triangle<T>| {
            [a.value(), b.value(), c.value(), d.value(), e.value(), f.value()]
        };
        Local {
            linear: triangle(self.linear),
            coupling: [values(x), values(y), values(z)],
            angular: triangle(self.angular),
            force: values(self.force),
            torque: values(self.torque),
        }
    }

    /// Lets the body turn about z under a torque, with what else adds to the pivot; the other side of the hinge accelerates by (0, c)
    /// besides, c_z = 0. What is left of S about z is the share of that addition in the pivot: nothing without.
    #[inline(always)]
    pub fn hinged(mut self, effort: T, more: Number<T>, [cx, cy]: [T; 2]) -> (Self, Gains<T>) {
        let u = [self.coupling[0][2], self.coupling[1][2], self.coupling[2][2]];
        let (w, own) = ([self.angular[entry(0, 2)], self.angular[entry(1, 2)]], self.angular[2]);
        let inverse = own.plus(more).value().recip();
        let free = (effort - self.torque[2].value()) * inverse;
        let one = Number::of(inverse);
        let share = more.times(one);
        let (g, b) = ([u[0].times(one), u[1].times(one), u[2].times(one)], [w[0].times(one), w[1].times(one)]);
        for (i, j) in [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)] {
            let at = entry(i, j);
            self.linear[at] = u[i].times_off(g[j], self.linear[at]);
        }
        let [left_x, left_y] = [w[0].times(share), w[1].times(share)];
        let [xx, yy, xy] = [(0, 0), (1, 1), (0, 1)].map(|(i, j)| w[i].times_off(b[j], self.angular[entry(i, j)]));
        self.angular = [xx, yy, own.times(share), left_y, left_x, xy];
        let (released, c) = (Number::of(free), [Number::of(cx), Number::of(cy)]);
        for i in 0..3 {
            let row = &mut self.coupling[i];
            *row = [u[i].times_off(b[0], row[0]), u[i].times_off(b[1], row[1]), u[i].times(share)];
            let force = u[i].times_onto(released, self.force[i]);
            self.force[i] = row[0].times_onto(c[0], row[1].times_onto(c[1], force));
        }
        let torque = [
            w[0].times_onto(released, self.torque[0]),
            w[1].times_onto(released, self.torque[1]),
            more.times_off(released, Number::of(effort)),
        ];
        self.torque = [
            xx.times_onto(c[0], xy.times_onto(c[1], torque[0])),
            xy.times_onto(c[0], yy.times_onto(c[1], torque[1])),
            left_x.times_onto(c[0], left_y.times_onto(c[1], torque[2])),
        ];
        let last = Number::one().minus(share).value();
        (self, Gains { linear: values(g), angular: [b[0].value(), b[1].value(), last], free, inverse })
    }

    /// Lets the body slide along z under a force, with what else adds to the pivot; the other side accelerates by (c, 0) besides.
    #[inline(always)]
    pub fn slid(mut self, effort: T, more: Number<T>, c: [T; 3]) -> (Self, Gains<T>) {
        let (u, own) = ([self.linear[entry(0, 2)], self.linear[entry(1, 2)]], self.linear[2]);
        let w = self.coupling[2];
        let inverse = own.plus(more).value().recip();
        let free = (effort - self.force[2].value()) * inverse;
        let one = Number::of(inverse);
        let share = more.times(one);
        let (g, b) = ([u[0].times(one), u[1].times(one)], [w[0].times(one), w[1].times(one), w[2].times(one)]);
        let [xx, yy, xy] = [(0, 0), (1, 1), (0, 1)].map(|(i, j)| u[i].times_off(g[j], self.linear[entry(i, j)]));
        self.linear = [xx, yy, own.times(share), u[1].times(share), u[0].times(share), xy];
        for (i, j) in [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)] {
            let at = entry(i, j);
            self.angular[at] = w[i].times_off(b[j], self.angular[at]);
        }
        let released = Number::of(free);
        for j in 0..3 {
            for i in 0..2 {
                self.coupling[i][j] = u[i].times_off(b[j], self.coupling[i][j]);
            }
            self.coupling[2][j] = w[j].times(share);
            self.torque[j] = w[j].times_onto(released, self.torque[j]);
        }
        let force = [
            u[0].times_onto(released, self.force[0]),
            u[1].times_onto(released, self.force[1]),
            more.times_off(released, Number::of(effort)),
        ];
        let c = triple(c);
        self.force = apply_onto(&rows(&self.linear), c, force);
        self.torque = apply_onto(&transposed(&self.coupling), c, self.torque);
        let last = Number::one().minus(share).value();
        (self, Gains { linear: [g[0].value(), g[1].value(), last], angular: values(b), free, inverse })
    }

    /// Turned about z by an angle of this sine and cosine: 8 operations for a symmetric pair.
    #[inline(always)]
    pub fn turned_about_z(mut self, sine: T, cosine: T) -> Self {
        let (s, c) = (Number::of(sine), Number::of(cosine));
        let (ss, sc) = (s.times(s), s.times(c));
        let plane = |[x, y]: [Number<T>; 2]| {
            [s.times_off(y, c.times(x)), s.times_onto(x, c.times(y))]
        };
        let pair = |a: Number<T>, d: Number<T>, twice: Number<T>| {
            let difference = a.minus(d);
            // What xx loses and yy gains, and what both off-diagonal entries gain.
            [ss.times_onto(difference, sc.times(twice)), ss.times_off(twice, sc.times(difference))]
        };
        for s in [&mut self.linear, &mut self.angular] {
            let [w, more] = pair(s[0], s[1], s[5].plus(s[5]));
            (s[0], s[1], s[5]) = (s[0].minus(w), s[1].plus(w), s[5].plus(more));
            [s[4], s[3]] = plane([s[4], s[3]]);
        }
        let k = &mut self.coupling;
        let [w, more] = pair(k[0][0], k[1][1], k[0][1].plus(k[1][0]));
        (k[0][0], k[1][1]) = (k[0][0].minus(w), k[1][1].plus(w));
        (k[0][1], k[1][0]) = (k[0][1].plus(more), k[1][0].plus(more));
        [k[2][0], k[2][1]] = plane([k[2][0], k[2][1]]);
        [k[0][2], k[1][2]] = plane([k[0][2], k[1][2]]);
        [self.force[0], self.force[1]] = plane([self.force[0], self.force[1]]);
        [self.torque[0], self.torque[1]] = plane([self.torque[0], self.torque[1]]);
        self
    }

    /// In other axes, of which the matrix holds the present ones.
    #[inline(always)]
    pub fn turned(self, turn: &Rows<T>) -> Self {
        Self {
            linear: congruent(turn, &self.linear),
            coupling: product(&product(turn, &self.coupling), &transposed(turn)),
            angular: congruent(turn, &self.angular),
            force: apply(turn, self.force),
            torque: apply(turn, self.torque),
        }
    }

    /// About the point at −d on the same body, where the present one accelerates by k besides: F' = Xᵀ (S (X p + k) + e).
    #[inline(always)]
    pub fn shifted(self, d: Triple<T>, k: Triple<T>) -> Self {
        let Self { linear, coupling, angular, force, torque } = self;
        let (arm, mass) = (tilde(d), rows(&linear));
        let columns = transposed(&arm);
        let moved = |i: usize, j: usize| {
            let of = |m: usize, sum: Number<T>| mass[i][m].times_off(columns[j][m], sum);
            of(2, of(1, of(0, coupling[i][j])))
        };
        let row = |i: usize| [moved(i, 0), moved(i, 1), moved(i, 2)];
        let shifted = [row(0), row(1), row(2)];
        let (before, after) = (transposed(&coupling), transposed(&shifted));
        let about = |i: usize, j: usize| {
            dot_onto(arm[i], after[j], dot_onto(arm[j], before[i], angular[entry(i, j)]))
        };
        let force = apply_onto(&mass, k, force);
        Self {
            linear,
            coupling: shifted,
            angular: [about(0, 0), about(1, 1), about(2, 2), about(1, 2), about(0, 2), about(0, 1)],
            force,
            torque: cross_onto(d, force, apply_onto(&before, k, torque)),
        }
    }
}

impl<T: Scalar> Join<Local<T>> for Local<T> {
    type Out = Self;
    #[inline(always)]
    fn join(self, arm: Self) -> Self {
        self.sparse().plus(&arm.sparse()).dense()
    }
}

impl<T: Scalar> Promote<Empty> for Local<T> {
    fn promote(_: Empty) -> Self {
        let o = T::zero();
        Self { linear: [o; 6], coupling: [[o; 3]; 3], angular: [o; 6], force: [o; 3], torque: [o; 3] }
    }
}
