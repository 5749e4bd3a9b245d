//! What lies outboard of a body's origin, F = S p + e in axes of the body, and its eliminations.
//!
//! p = (a, α), F = (f, t), S = [[L, K], [Kᵀ, H]], 21 numbers; f and t act ON the outboard part. After a hinge about z, the z column of K and
//! the z row of H are zero; after a slide along z, the z row of L and of K. A free link has a constant S with zeros of its own.

use super::number::{Number, Rows, Triangle, Triple, masked, transposed, triangle, triangle_values, triple, values};
use super::sparse::Sparse;
use crate::mechanics::spatial::weld::InertialAxes;
use crate::relation::spatial::algebra::{Columns, Symmetric3};
use crate::relation::spatial::{Empty, Full, FullColumn, Spatial};
use crate::relation::{AccelerationOf, Close, Closures, Cuts, Join, Open, Promote, Solvable};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// What a relation says of closure forces, in axes of a body.
pub type LocalCuts<T, C> = Cuts<FullColumn<T>, T, C>;

/// The relation at the origin of a body that carries others, in axes of that body.
#[derive(Clone, Copy)]
pub struct Local<T: Scalar, C: Closures = Open> {
    pub(super) linear: [T; 6],
    pub(super) coupling: [[T; 3]; 3],
    pub(super) angular: [T; 6],
    pub(super) force: [T; 3],
    pub(super) torque: [T; 3],
    pub(super) cuts: LocalCuts<T, C>,
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
    /// Closure forces that the relation carries.
    type Closures: Closures;
    /// The relation with what is known of it.
    fn sparse(self) -> Sparse<T>;
    /// What the relation says of closure forces.
    fn cuts(self) -> LocalCuts<T, Self::Closures>;
}

/// What eliminating a coordinate leaves behind: q̈ = free − a · (its gains) − α · (its gains), in axes of the outboard body.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Gains<T> {
    /// For the acceleration of the body's origin.
    pub linear: [T; 3],
    /// For its angular acceleration: x and y for a hinge, whose z is one.
    pub angular: [T; 3],
    /// Without any.
    pub free: T,
}

impl<T: Scalar> Gains<T> {
    /// No gain yet.
    pub fn blank() -> Self {
        let o = T::zero();
        Self { linear: [o; 3], angular: [o; 3], free: o }
    }

    /// No gain yet but that for the coordinate's own axis, which inertia alone leaves at one.
    pub fn along(turns: bool) -> Self {
        let mut gains = Self::blank();
        *(if turns { &mut gains.angular[2] } else { &mut gains.linear[2] }) = T::one();
        gains
    }

    /// Stores what is read of gains: that for the coordinate's own axis is one unless something else than inertia outboard adds to the
    /// pivot.
    #[cfg_attr(optimised, inline(always))]
    pub fn set(&mut self, Self { linear, angular, free }: Self, turns: bool, stiffened: bool) {
        for k in 0..3 {
            if k < 2 || !turns || stiffened {
                self.angular[k] = angular[k];
            }
            if k < 2 || turns || stiffened {
                self.linear[k] = linear[k];
            }
        }
        self.free = free;
    }

    /// Whether the pivot resists.
    pub fn is_finite(&self) -> bool {
        self.linear.iter().chain(&self.angular).all(|x| x.is_finite())
    }
}

/// The relation of a body's own inertia: m, σ (kg·m), J about the origin (kg·m²), f and t of its velocities.
#[cfg_attr(optimised, inline(always))]
fn own<T: Scalar>(mass: T, moment: Triple<T>, tensor: Triangle<T>, force: Triple<T>, torque: Triple<T>) -> Sparse<T> {
    let (m, o) = (Number::of(mass), Number::zero());
    let [x, y, z] = moment;
    let coupling = [[o, z, y.negated()], [z.negated(), o, x], [y, x.negated(), o]];
    Sparse { linear: [m, m, m, o, o, o], coupling, angular: tensor, force, torque }
}

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> Alone<T, MOMENT, TENSOR> {
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn parts(self) -> Sparse<T> {
        let (moment, tensor) = (masked(MOMENT, self.moment), triangle(TENSOR, self.tensor));
        let force = if MOMENT & 7 == 0 { [Number::zero(); 3] } else { triple(self.force) };
        own(self.mass, moment, tensor, force, triple(self.torque))
    }
}

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> Outboard<T> for Alone<T, MOMENT, TENSOR> {
    type Closures = Open;
    #[inline(always)]
    fn sparse(self) -> Sparse<T> {
        self.parts()
    }
    #[inline(always)]
    fn cuts(self) -> LocalCuts<T, Open> {
        Cuts::none()
    }
}

impl<T: Scalar, C: Closures> Outboard<T> for Local<T, C> {
    type Closures = C;
    #[inline(always)]
    fn cuts(self) -> LocalCuts<T, C> {
        self.cuts
    }
    #[cfg_attr(optimised, inline(always))]
    fn sparse(self) -> Sparse<T> {
        let Self { linear, coupling: [x, y, z], angular, force, torque, .. } = self;
        Sparse {
            linear: triangle(63, linear),
            coupling: [triple(x), triple(y), triple(z)],
            angular: triangle(63, angular),
            force: triple(force),
            torque: triple(torque),
        }
    }
}

impl<T: Scalar, C: Closures> Local<T, C> {
    /// With the inertia of the body at whose origin this is.
    #[inline(always)]
    pub fn with<const MOMENT: u8, const TENSOR: u8>(self, body: Alone<T, MOMENT, TENSOR>) -> Self {
        self.sparse().plus(&body.parts()).dense().cut(self.cuts)
    }

    /// A relation in inertial axes, in axes of a body of an attitude.
    #[cfg_attr(optimised, inline(always))]
    pub fn of(full: &Full<T, C>, attitude: &Columns<T>) -> Self {
        let back = |v| attitude.transposed(v);
        let cuts = full.cuts.mapped(|w| FullColumn { force: back(w.force), torque: back(w.torque) });
        Sparse::of(full).turned(&transposed(&axes(attitude))).dense().cut(cuts)
    }

    /// A relation in axes of a body, as one in axes that are not said.
    #[cfg_attr(optimised, inline(always))]
    pub fn of_own(full: &Full<T, C>) -> Self {
        Sparse::of(full).dense().cut(full.cuts)
    }

    /// This relation, in axes that are not said.
    #[cfg_attr(optimised, inline(always))]
    pub fn full(self) -> Full<T, C> {
        self.sparse().full().cut(self.cuts)
    }

    /// In inertial axes, of which `attitude` holds those of the body.
    #[cfg_attr(optimised, inline(always))]
    pub fn turned(self, attitude: &Columns<T>) -> Full<T, C> {
        self.sparse().turned(&axes(attitude)).full().cut(turned(&self.cuts, attitude))
    }
}

impl<T: Scalar> Sparse<T> {
    /// Of a relation of the type that those in inertial axes have.
    #[cfg_attr(optimised, inline(always))]
    fn of<C: Closures>(full: &Full<T, C>) -> Self {
        let Columns { x, y, z } = full.coupling;
        Self {
            linear: triangle_of(full.linear),
            coupling: [triple([x.x, y.x, z.x]), triple([x.y, y.y, z.y]), triple([x.z, y.z, z.z])],
            angular: triangle_of(full.angular),
            force: triple(full.force.into()),
            torque: triple(full.torque.into()),
        }
    }

    /// A relation of that type.
    #[cfg_attr(optimised, inline(always))]
    fn full(self) -> Full<T> {
        let Self { linear, coupling, angular, force, torque } = self;
        let [x, y, z] = transposed(&coupling);
        let (x, y, z) = (Vector3::from(values(x)), Vector3::from(values(y)), Vector3::from(values(z)));
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

/// The matrix of an attitude.
#[inline(always)]
pub(super) fn axes<T: Scalar>(&Columns { x, y, z }: &Columns<T>) -> Rows<T> {
    [triple([x.x, y.x, z.x]), triple([x.y, y.y, z.y]), triple([x.z, y.z, z.z])]
}

/// Columns in axes of which `attitude` holds the present ones.
#[inline(always)]
fn turned<T: Scalar, C: Closures>(cuts: &LocalCuts<T, C>, attitude: &Columns<T>) -> LocalCuts<T, C> {
    cuts.mapped(|w| FullColumn { force: attitude.apply(w.force), torque: attitude.apply(w.torque) })
}

impl<T: Scalar> Local<T> {
    /// With closure forces.
    #[inline(always)]
    pub(super) fn cut<C: Closures>(self, cuts: LocalCuts<T, C>) -> Local<T, C> {
        let Self { linear, coupling, angular, force, torque, .. } = self;
        Local { linear, coupling, angular, force, torque, cuts }
    }

    /// With the inertia of a body at rest.
    #[inline(always)]
    pub fn with_body(self, mass: T, moment: Triple<T>, tensor: Triangle<T>) -> Self {
        let none = [Number::zero(); 3];
        self.sparse().plus(&own(mass, moment, tensor, none, none)).dense()
    }

    /// Force and torque for accelerations of the origin and of the body.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn answer(&self, [a, angular]: [Vector3<T>; 2]) -> [Vector3<T>; 2] {
        let dot = |row: [T; 3], v: Vector3<T>| row[0].mul_add(v.x, row[1].mul_add(v.y, row[2] * v.z));
        let by = |rows: [[T; 3]; 3], v: Vector3<T>| Vector3::new(dot(rows[0], v), dot(rows[1], v), dot(rows[2], v));
        let whole = |[xx, yy, zz, yz, xz, xy]: [T; 6]| [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let [x, y, z] = self.coupling;
        let back = [[x[0], y[0], z[0]], [x[1], y[1], z[1]], [x[2], y[2], z[2]]];
        [by(whole(self.linear), a) + by(self.coupling, angular), by(back, a) + by(whole(self.angular), angular)]
    }
}

/// A triangle from the type that relations in inertial axes have.
#[inline(always)]
fn triangle_of<T: Scalar>(Symmetric3 { xx, xy, xz, yy, yz, zz }: Symmetric3<T>) -> Triangle<T> {
    triangle(63, [xx, yy, zz, yz, xz, xy])
}

/// A triangle as the type that relations in inertial axes have.
#[inline(always)]
fn symmetric<T: Scalar>(s: Triangle<T>) -> Symmetric3<T> {
    let [xx, yy, zz, yz, xz, xy] = triangle_values(s);
    Symmetric3 { xx, xy, xz, yy, yz, zz }
}

impl<T: Scalar, C: Closures> Join<Local<T>> for Local<T, C> {
    type Out = Self;
    #[inline(always)]
    fn join(self, arm: Local<T>) -> Self {
        self.sparse().plus(&arm.sparse()).dense().cut(self.cuts)
    }
}

/// What the ground bears: nothing that anything inboard would have to know, but for closure forces.
#[derive(Clone, Copy)]
pub struct Borne<T: Scalar, C: Closures = Open> {
    cuts: LocalCuts<T, C>,
}

impl<T: Scalar, C: Closures> Borne<T, C> {
    /// Bears a relation, of which only closure forces are asked for, if there are any.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn of(relation: impl FnOnce() -> Local<T, C>) -> Self {
        if const { C::COUNT > 0 } {
            return Self { cuts: relation().cuts };
        }
        let none = FullColumn::none();
        Self { cuts: Cuts::at_tip(C::each(|_| none), C::each(|_| T::zero())) }
    }

    /// In inertial axes, of which `attitude` holds the present ones.
    #[inline(always)]
    pub(super) fn settled(self, attitude: &Columns<T>) -> Settled<T, C> {
        Settled { cuts: turned(&self.cuts, attitude) }
    }
}

impl<T: Scalar, C: Closures> Join<Borne<T>> for Borne<T, C> {
    type Out = Self;
    #[inline(always)]
    fn join(self, _: Borne<T>) -> Self {
        self
    }
}

impl<T: Scalar> Promote<Empty> for Borne<T> {
    fn promote(_: Empty) -> Self {
        Self { cuts: Cuts::none() }
    }
}

/// A relation in inertial axes that nobody reads but for closure forces: what clamps or welds it needs to know as little as a base does.
#[derive(Clone, Copy)]
pub struct Settled<T: Scalar, C: Closures = Open> {
    cuts: LocalCuts<T, C>,
}

impl<T: Scalar, C: Closures> InertialAxes<T> for Settled<T, C> {}

macro_rules! close {
    ($($Relation:ident),*) => {$(
        impl<T: Scalar, C: Solvable> Close<Spatial<T>, C> for $Relation<T, C> {
            #[inline(always)]
            fn multipliers(&self, root: &AccelerationOf<Spatial<T>>) -> C::Each<T> {
                let cuts = &self.cuts;
                C::solve(&cuts.compliance, &C::zip(&cuts.columns, &cuts.gap, |w, gap| w.work(root) - gap))
            }
            #[inline(always)]
            fn compliance(&self) -> C::Pairs<T> {
                self.cuts.compliance
            }
        }
    )*};
}
close!(Borne, Settled);

impl<T: Scalar> Promote<Empty> for Local<T> {
    fn promote(_: Empty) -> Self {
        let o = T::zero();
        let (linear, coupling, angular) = ([o; 6], [[o; 3]; 3], [o; 6]);
        Self { linear, coupling, angular, force: [o; 3], torque: [o; 3], cuts: Cuts::none() }
    }
}
