//! What acts on planar scenes besides gravity.

use super::{BodyMotion, Frame, JointMotion, Planar};
use crate::lift::Lift;
use crate::loading::{LoadLaw, OverTime, Seen, SeriesLaw, TimeLaw};
use crate::relation;
use crate::relation::planar::algebra::cross;
use crate::scalar::{Powers, Scalar};
use crate::struts::Points;
use nalgebra::Vector2;

/// A force and a torque on a body, about its inboard end, in inertial axes.
pub type Wrench<T> = relation::Wrench<Vector2<T>, T>;

impl<T: Scalar> Wrench<T> {
    /// A pure torque (N·m).
    pub fn torque(torque: T) -> Self {
        Self { torque, ..Self::default() }
    }
}

impl<T: Scalar, U: Scalar> Lift<T, U> for Wrench<T> {
    type Over = Wrench<U>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Wrench<U> {
        let Self { force, torque } = self;
        Wrench { force: Vector2::new(number(force.x), number(force.y)), torque: number(*torque) }
    }
}

impl<T: Scalar> BodyMotion<T> {
    /// The wrench of a force (N, inertial axes) at a point of this body (m, body axes from the inboard end).
    pub fn force_at(&self, point: [T; 2], force: [T; 2]) -> Wrench<T> {
        let force = Vector2::new(force[0], force[1]);
        Wrench { force, torque: cross(self.turned(point), force) }
    }
}

impl<T> crate::sealed::Sealed for BodyMotion<T> {}

impl<T: Scalar> Seen for BodyMotion<T> {
    type Space = Planar<T>;
    type Load = Wrench<T>;
    #[inline(always)]
    fn unaccelerated(&self) -> Self {
        Self { inboard: self.inboard.without_acceleration(), ..*self }
    }
}

impl<T> crate::sealed::Sealed for JointMotion<T> {}

impl<T: Scalar> Seen for JointMotion<T> {
    type Space = Planar<T>;
    type Load = T;
    #[inline(always)]
    fn unaccelerated(&self) -> Self {
        let [inboard, outboard] = [self.inboard, self.outboard].map(|frame| frame.without_acceleration());
        Self { inboard, outboard, ..*self }
    }
}

impl<T: Scalar> Points<2> for Planar<T> {
    fn point(body: &BodyMotion<T>, at: [T; 2]) -> [Vector2<T>; 2] {
        let Frame { place, velocity, .. } = body.point(at);
        [place, velocity]
    }
    fn pull(body: &BodyMotion<T>, at: [T; 2], force: Vector2<T>) -> Wrench<T> {
        body.force_at(at, force.into())
    }
}

impl<T: Scalar, F: TimeLaw<T::Real>> LoadLaw<JointMotion<T>> for OverTime<F> {
    type Value = T;
    fn at(&self, time: T::Real, joint: usize, _: &JointMotion<T>) -> T {
        self.0.at(T::constant(time), joint)
    }
}

impl<T: Scalar, F: TimeLaw<T::Real>> SeriesLaw<JointMotion<T>> for OverTime<F> {
    fn series<const N: usize>(&self, time: T::Real, joint: usize, asked: usize) -> [T; N] {
        self.0.at(Powers::<T, N>::variable(T::constant(time), asked), joint).terms()
    }
}
