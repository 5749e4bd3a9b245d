//! What lies outboard of a body's origin, F = S p + e in axes of the body, and its eliminations.
//!
//! p = (a, α), F = (f, t), S = [[L, K], [Kᵀ, H]], 21 numbers; f and t act ON the outboard part. After a hinge about z, the z column of K and
//! the z row of H are zero; after a slide along z, the z row of L and of K. A free link has a constant S with zeros of its own.

use super::number::{Number, Rows, Triangle, Triple, masked, transposed, triangle, triangle_values, triple, values};
use super::sparse::Sparse;
use crate::mechanics::spatial::weld::InertialAxes;
use crate::relation::spatial::algebra::{Columns, Symmetric3};
use crate::relation::spatial::{Empty, Full, Spatial};
use crate::relation::{AccelerationOf, Close, Cuts, Join, Open, Promote};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// The relation at the origin of a body that carries others, in axes of that body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Local<T> {
    pub(super) linear: [T; 6],
    pub(super) coupling: [[T; 3]; 3],
    pub(super) angular: [T; 6],
    pub(super) force: [T; 3],
    pub(super) torque: [T; 3],
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
    #[cfg_attr(not(debug_assertions), inline(always))]
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
#[cfg_attr(not(debug_assertions), inline(always))]
fn own<T: Scalar>(mass: T, moment: Triple<T>, tensor: Triangle<T>, force: Triple<T>, torque: Triple<T>) -> Sparse<T> {
    let (m, o) = (Number::of(mass), Number::zero());
    let [x, y, z] = moment;
    let coupling = [[o, z, y.negated()], [z.negated(), o, x], [y, x.negated(), o]];
    Sparse { linear: [m, m, m, o, o, o], coupling, angular: tensor, force, torque }
}

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> Alone<T, MOMENT, TENSOR> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn parts(self) -> Sparse<T> {
        let (moment, tensor) = (masked(MOMENT, self.moment), triangle(TENSOR, self.tensor));
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
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sparse(self) -> Sparse<T> {
        let Self { linear, coupling: [x, y, z], angular, force, torque } = self;
        Sparse {
            linear: triangle(63, linear),
            coupling: [triple(x), triple(y), triple(z)],
            angular: triangle(63, angular),
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

    /// With the inertia of a body at rest.
    #[inline(always)]
    pub fn with_body(self, mass: T, moment: Triple<T>, tensor: Triangle<T>) -> Self {
        let none = [Number::zero(); 3];
        self.sparse().plus(&own(mass, moment, tensor, none, none)).dense()
    }

    /// Force and torque for accelerations of the origin and of the body.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn answer(&self, [a, angular]: [Vector3<T>; 2]) -> [Vector3<T>; 2] {
        let dot = |row: [T; 3], v: Vector3<T>| row[0].mul_add(v.x, row[1].mul_add(v.y, row[2] * v.z));
        let by = |rows: [[T; 3]; 3], v: Vector3<T>| Vector3::new(dot(rows[0], v), dot(rows[1], v), dot(rows[2], v));
        let whole = |[xx, yy, zz, yz, xz, xy]: [T; 6]| [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let [x, y, z] = self.coupling;
        let back = [[x[0], y[0], z[0]], [x[1], y[1], z[1]], [x[2], y[2], z[2]]];
        [by(whole(self.linear), a) + by(self.coupling, angular), by(back, a) + by(whole(self.angular), angular)]
    }

    /// In inertial axes, of which `attitude` holds those of the body.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn turned(self, attitude: &Rows<T>) -> Full<T> {
        let Sparse { linear, coupling, angular, force, torque } = self.sparse().turned(attitude);
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

/// A triangle as the type that relations in inertial axes have.
#[inline(always)]
fn symmetric<T: Scalar>(s: Triangle<T>) -> Symmetric3<T> {
    let [xx, yy, zz, yz, xz, xy] = triangle_values(s);
    Symmetric3 { xx, xy, xz, yy, yz, zz }
}

impl<T: Scalar> Join<Local<T>> for Local<T> {
    type Out = Self;
    #[inline(always)]
    fn join(self, arm: Self) -> Self {
        self.sparse().plus(&arm.sparse()).dense()
    }
}

/// What the ground bears: nothing that anything inboard would have to know.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Borne;

impl Join<Self> for Borne {
    type Out = Self;
    #[inline(always)]
    fn join(self, _: Self) -> Self {
        self
    }
}

impl Promote<Empty> for Borne {
    fn promote(_: Empty) -> Self {
        Self
    }
}

/// A relation in inertial axes that nobody reads: what clamps or welds it needs to know as little as a base does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Settled;

impl<T: Scalar> InertialAxes<T> for Settled {}

macro_rules! close {
    ($($Relation:ident),*) => {$(
        impl<T: Scalar> Close<Spatial<T>, Open> for $Relation {
            #[inline(always)]
            fn multipliers(&self, _: &AccelerationOf<Spatial<T>>) {}
            #[inline(always)]
            fn compliance(&self) {}
        }
    )*};
}
close!(Borne, Settled);

impl<T: Scalar> Promote<Empty> for Local<T> {
    fn promote(_: Empty) -> Self {
        let o = T::zero();
        Self { linear: [o; 6], coupling: [[o; 3]; 3], angular: [o; 6], force: [o; 3], torque: [o; 3] }
    }
}
