//! Relations whose zeros are known, and their eliminations: one kernel for all of them.

use super::number::{
    Number, Rows, Triangle, Triple, apply, apply_onto, congruent, cross_onto, dot_onto, less, more as more_of, product,
    rows, scaled, sum as added, tilde, transposed, triangle_less, triangle_sum, triangle_values, triple, values,
};
use super::relation::{Gains, Local};
use super::standing::Stand;
use crate::relation::Cuts;
use crate::scalar::Scalar;

/// A relation whose zeros are known.
#[derive(Clone, Copy)]
pub struct Sparse<T> {
    pub linear: Triangle<T>,
    pub coupling: Rows<T>,
    pub angular: Triangle<T>,
    pub force: Triple<T>,
    pub torque: Triple<T>,
}

impl<T: Scalar> Sparse<T> {
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn plus(&self, other: &Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.coupling, other.coupling);
        Self {
            linear: triangle_sum(&self.linear, &other.linear),
            coupling: [added(a, d), added(b, e), added(c, f)],
            angular: triangle_sum(&self.angular, &other.angular),
            force: added(self.force, other.force),
            torque: added(self.torque, other.torque),
        }
    }

    /// Without what is known.
    #[cfg_attr(optimised, inline(always))]
    pub fn dense(self) -> Local<T> {
        let [x, y, z] = self.coupling;
        Local {
            linear: triangle_values(self.linear),
            coupling: [values(x), values(y), values(z)],
            angular: triangle_values(self.angular),
            force: values(self.force),
            torque: values(self.torque),
            cuts: Cuts::none(),
        }
    }

    /// Lets the body turn about z under a torque, with what else adds to the pivot; the other side of the hinge accelerates by (0, c)
    /// besides, c_z = 0. What is left of S about z is the share of that addition in the pivot: nothing without. The third answer is 1 / D.
    #[cfg_attr(optimised, inline(always))]
    pub fn hinged(self, effort: T, more: Number<T>, [cx, cy]: [T; 2]) -> (Self, Gains<T>, T) {
        let Self { linear, coupling: [kx, ky, kz], angular, force, torque } = self;
        // U = S z, without its own row; G = U / D.
        let (u, w, own) = ([kx[2], ky[2], kz[2]], [angular[4], angular[3]], angular[2]);
        let inverse = own.plus(more).value().recip();
        let free = (effort - torque[2].value()) * inverse;
        let (one, o) = (Number::of(inverse), Number::zero());
        let share = more.times(one);
        let (g, b) = (scaled(u, one), [w[0].times(one), w[1].times(one)]);
        // S − U Gᵀ.
        let linear = triangle_less(&linear, u, g);
        let kx = [u[0].times_off(b[0], kx[0]), u[0].times_off(b[1], kx[1]), u[0].times(share)];
        let ky = [u[1].times_off(b[0], ky[0]), u[1].times_off(b[1], ky[1]), u[1].times(share)];
        let kz = [u[2].times_off(b[0], kz[0]), u[2].times_off(b[1], kz[1]), u[2].times(share)];
        let left = [w[0].times(share), w[1].times(share), own.times(share)];
        let reduced = triangle_less(&[angular[0], angular[1], o, o, o, angular[5]], [w[0], w[1], o], [b[0], b[1], o]);
        let angular = [reduced[0], reduced[1], left[2], left[1], left[0], reduced[5]];
        // e + U free + S c.
        let (c, released) = ([Number::of(cx), Number::of(cy), o], Number::of(free));
        let force = apply_onto(&[kx, ky, kz], c, more_of(force, released, u));
        let torque =
            more_of([torque[0], torque[1], more.times_off(released, Number::of(effort))], released, [w[0], w[1], o]);
        let torque = apply_onto(&rows(&angular), c, torque);
        let gains = Gains {
            linear: values(g),
            angular: [b[0].value(), b[1].value(), Number::one().minus(share).value()],
            free,
        };
        (Self { linear, coupling: [kx, ky, kz], angular, force, torque }, gains, inverse)
    }

    /// Lets the body slide along z under a force, with what else adds to the pivot; the other side accelerates by (c, 0) besides.
    #[cfg_attr(optimised, inline(always))]
    pub fn slid(self, effort: T, more: Number<T>, c: [T; 3]) -> (Self, Gains<T>, T) {
        let Self { linear, coupling: [kx, ky, kz], angular, force, torque } = self;
        let (u, w, own) = ([linear[4], linear[3]], kz, linear[2]);
        let inverse = own.plus(more).value().recip();
        let free = (effort - force[2].value()) * inverse;
        let (one, o) = (Number::of(inverse), Number::zero());
        let share = more.times(one);
        let (g, b) = ([u[0].times(one), u[1].times(one)], scaled(w, one));
        let left = [u[0].times(share), u[1].times(share), own.times(share)];
        let reduced = triangle_less(&[linear[0], linear[1], o, o, o, linear[5]], [u[0], u[1], o], [g[0], g[1], o]);
        let linear = [reduced[0], reduced[1], left[2], left[1], left[0], reduced[5]];
        let coupling = [less(kx, u[0], b), less(ky, u[1], b), scaled(kz, share)];
        let angular = triangle_less(&angular, w, b);
        let (c, released) = (triple(c), Number::of(free));
        let force =
            more_of([force[0], force[1], more.times_off(released, Number::of(effort))], released, [u[0], u[1], o]);
        let torque = apply_onto(&transposed(&coupling), c, more_of(torque, released, w));
        let force = apply_onto(&rows(&linear), c, force);
        let gains = Gains {
            linear: [g[0].value(), g[1].value(), Number::one().minus(share).value()],
            angular: values(b),
            free,
        };
        (Self { linear, coupling, angular, force, torque }, gains, inverse)
    }

    /// The body accelerates by (c, γ) besides: e + S (c, γ).
    #[cfg_attr(optimised, inline(always))]
    pub fn accelerated(self, [c, gamma]: [Triple<T>; 2]) -> Self {
        let (linear, angular, back) = (rows(&self.linear), rows(&self.angular), transposed(&self.coupling));
        let force = apply_onto(&self.coupling, gamma, apply_onto(&linear, c, self.force));
        let torque = apply_onto(&angular, gamma, apply_onto(&back, c, self.torque));
        Self { force, torque, ..self }
    }

    /// Turned about z by an angle of this sine and cosine: 8 operations for a symmetric pair.
    #[cfg_attr(optimised, inline(always))]
    pub fn turned_about_z(self, sine: T, cosine: T) -> Self {
        let (s, c) = (Number::of(sine), Number::of(cosine));
        let squares = [s.times(s), s.times(c)];
        let [kx, ky, kz] = self.coupling;
        let [w, more] = exchanged(squares, kx[0], ky[1], kx[1].plus(ky[0]));
        let ([kzx, kzy], [kxz, kyz]) = (in_plane(s, c, kz[0], kz[1]), in_plane(s, c, kx[2], ky[2]));
        let ([fx, fy], [tx, ty]) =
            (in_plane(s, c, self.force[0], self.force[1]), in_plane(s, c, self.torque[0], self.torque[1]));
        Self {
            linear: triangle_about_z(squares, s, c, self.linear),
            coupling: [
                [kx[0].minus(w), kx[1].plus(more), kxz],
                [ky[0].plus(more), ky[1].plus(w), kyz],
                [kzx, kzy, kz[2]],
            ],
            angular: triangle_about_z(squares, s, c, self.angular),
            force: [fx, fy, self.force[2]],
            torque: [tx, ty, self.torque[2]],
        }
    }

    /// From the body's origin to the joint's place, in axes that its offset alone turns.
    #[cfg_attr(optimised, inline(always))]
    pub fn at_joint(self, turns: bool, stand: Stand<T>) -> Self {
        if turns {
            return self.turned_about_z(stand[0], stand[1]);
        }
        let o = Number::zero();
        self.shifted([o, o, Number::of(stand[1])], [o; 3])
    }

    /// In other axes, of which the matrix holds the present ones.
    #[cfg_attr(optimised, inline(always))]
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
    #[cfg_attr(optimised, inline(always))]
    pub fn shifted(self, d: Triple<T>, k: Triple<T>) -> Self {
        let Self { linear, coupling, angular, force, torque } = self;
        let (arm, mass) = (tilde(d), rows(&linear));
        let [kx, ky, kz] = coupling;
        // K − L d~: a row of L d~ is that of L times the columns of d~, and −d × it.
        let shifted = [cross_onto(d, mass[0], kx), cross_onto(d, mass[1], ky), cross_onto(d, mass[2], kz)];
        // H + d~ K' + (d~ K)ᵀ.
        let (k0, k1) = (transposed(&coupling), transposed(&shifted));
        let angular = [
            dot_onto(arm[0], k1[0], dot_onto(arm[0], k0[0], angular[0])),
            dot_onto(arm[1], k1[1], dot_onto(arm[1], k0[1], angular[1])),
            dot_onto(arm[2], k1[2], dot_onto(arm[2], k0[2], angular[2])),
            dot_onto(arm[1], k1[2], dot_onto(arm[2], k0[1], angular[3])),
            dot_onto(arm[0], k1[2], dot_onto(arm[2], k0[0], angular[4])),
            dot_onto(arm[0], k1[1], dot_onto(arm[1], k0[0], angular[5])),
        ];
        let force = apply_onto(&mass, k, force);
        let torque = cross_onto(d, force, apply_onto(&k0, k, torque));
        Self { linear, coupling: shifted, angular, force, torque }
    }
}

/// What xx loses and yy gains by a turn about z, and what both entries beside the diagonal gain.
#[inline(always)]
fn exchanged<T: Scalar>([ss, sc]: [Number<T>; 2], xx: Number<T>, yy: Number<T>, both: Number<T>) -> [Number<T>; 2] {
    let difference = xx.minus(yy);
    [ss.times_onto(difference, sc.times(both)), ss.times_off(both, sc.times(difference))]
}

/// A vector of the xy plane, turned.
#[inline(always)]
fn in_plane<T: Scalar>(s: Number<T>, c: Number<T>, x: Number<T>, y: Number<T>) -> [Number<T>; 2] {
    [s.times_off(y, c.times(x)), s.times_onto(x, c.times(y))]
}

/// A symmetric matrix, turned about z.
#[cfg_attr(optimised, inline(always))]
fn triangle_about_z<T: Scalar>(
    squares: [Number<T>; 2],
    s: Number<T>,
    c: Number<T>,
    [xx, yy, zz, yz, xz, xy]: Triangle<T>,
) -> Triangle<T> {
    let [w, more] = exchanged(squares, xx, yy, xy.plus(xy));
    let [xz, yz] = in_plane(s, c, xz, yz);
    [xx.minus(w), yy.plus(w), zz, yz, xz, xy.plus(more)]
}
