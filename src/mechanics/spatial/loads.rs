//! What acts on spatial scenes besides gravity.

use super::{BodyMotion, Frame, JointMotion, Spatial};
use crate::lift::Lift;
use crate::lift::lift;
use crate::loading::{LoadLaw, OverTime, Seen, SeriesLaw, TimeLaw};
use crate::relation::spatial::Couple;
use crate::relation::spatial::algebra::{Columns, cross};
use crate::relation::{self, Absent, Additive, Part, Term};
use crate::scalar::{Powers, Scalar};
use crate::struts::Points;
use core::ops::Add;
use nalgebra::Vector3;

/// A force and a torque on a body, about its inboard end, in inertial axes.
pub type Wrench<T> = relation::Wrench<Vector3<T>, Vector3<T>>;

impl<T: Scalar> Wrench<T> {
    /// A pure torque (N·m), inertial axes.
    pub fn torque(torque: [T; 3]) -> Self {
        Self { torque: Vector3::from(torque), ..Self::default() }
    }
}

impl<T: Scalar, U: Scalar> Lift<T, U> for Wrench<T> {
    type Over = Wrench<U>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Wrench<U> {
        Wrench { force: self.force.lift(number), torque: self.torque.lift(number) }
    }
}

impl<T: Scalar> BodyMotion<T> {
    /// The wrench of a force (N, inertial axes) at a point of this body (m, body axes from the inboard end).
    pub fn force_at(&self, point: [T; 3], force: [T; 3]) -> Wrench<T> {
        let force = Vector3::from(force);
        Wrench { force, torque: cross(self.turned(point), force) }
    }
}

impl<T> crate::sealed::Sealed for BodyMotion<T> {}

impl<T: Scalar> Seen for BodyMotion<T> {
    type Space = Spatial<T>;
    type Load = Wrench<T>;
    #[inline(always)]
    fn unaccelerated(&self) -> Self {
        Self { inboard: self.inboard.without_acceleration(), ..*self }
    }
}

impl<T> crate::sealed::Sealed for JointMotion<T> {}

impl<T: Scalar> Seen for JointMotion<T> {
    type Space = Spatial<T>;
    type Load = Effort<T>;
    #[inline(always)]
    fn unaccelerated(&self) -> Self {
        let [inboard, outboard] = [self.inboard, self.outboard].map(|frame| frame.without_acceleration());
        Self { inboard, outboard, ..*self }
    }
}

impl<T: Scalar> Points<3> for Spatial<T> {
    fn point(body: &BodyMotion<T>, at: [T; 3]) -> [Vector3<T>; 2] {
        let Frame { place, velocity, .. } = body.point(at);
        [place, velocity]
    }
    fn pull(body: &BodyMotion<T>, at: [T; 3], force: Vector3<T>) -> Wrench<T> {
        body.force_at(at, force.into())
    }
}

/// Generalised forces on the coordinates of a joint, in the order of its rates, ON the outboard body: torques (N·m) about axes,
/// forces (N) along them; in a ball a torque in axes of the outboard body. What exceeds the coordinates has no effect.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Effort<T>(pub [T; 3]);

lift!(Effort<N> { 0 });

impl<T: Scalar> Default for Effort<T> {
    fn default() -> Self {
        Self::null()
    }
}

impl<T: Scalar> Add for Effort<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(core::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl<T: Scalar> Additive for Effort<T> {
    fn null() -> Self {
        Self([T::zero(); 3])
    }
}

impl<T: Scalar> Part for Effort<T> {
    fn is_finite(self) -> bool {
        self.0.iter().all(|x| x.is_finite())
    }
    fn is_same(self, other: Self) -> bool {
        self.0.iter().zip(other.0).all(|(x, y)| x.is_identical(y))
    }
}

/// What is applied in a joint: an [`Effort`], or nothing.
pub trait Drive<T: Scalar>: Part {
    /// A torque in a ball, or nothing.
    type Couple: Term<Vector3<T>>;
    /// Adds the generalised force on coordinate `k` to a sum.
    fn onto(self, k: usize, sum: T) -> T;
    /// The torque (inertial axes) in a ball, for an outboard body of this attitude.
    fn couple(self, attitude: &Columns<T>) -> Self::Couple;
}

impl<T: Scalar> Drive<T> for Absent {
    type Couple = Absent;
    #[inline(always)]
    fn onto(self, _: usize, sum: T) -> T {
        sum
    }
    #[inline(always)]
    fn couple(self, _: &Columns<T>) -> Absent {
        Absent
    }
}

impl<T: Scalar> Drive<T> for Effort<T> {
    type Couple = Couple<T>;
    #[inline(always)]
    fn onto(self, k: usize, sum: T) -> T {
        sum + self.0[k]
    }
    #[inline(always)]
    fn couple(self, attitude: &Columns<T>) -> Couple<T> {
        Couple(attitude.apply(Vector3::from(self.0)))
    }
}

impl<T: Scalar, F: TimeLaw<T::Real>> LoadLaw<JointMotion<T>> for OverTime<F> {
    type Value = Effort<T>;
    fn at(&self, time: T::Real, joint: usize, _: &JointMotion<T>) -> Effort<T> {
        Effort(self.0.in_space(T::constant(time), joint))
    }
}

impl<T: Scalar, F: TimeLaw<T::Real>> SeriesLaw<JointMotion<T>> for OverTime<F> {
    fn series<const N: usize>(&self, time: T::Real, joint: usize, asked: usize) -> [Effort<T>; N] {
        let time = Powers::<T, N>::variable(T::constant(time), asked);
        let [first, second, third] = self.0.in_space(time, joint).map(Powers::terms);
        core::array::from_fn(|k| Effort([first[k], second[k], third[k]]))
    }
}
