//! The ball joint with a spring.

use super::inertia::{finite, not_negative};
use super::loads::Drive;
use super::maps::spring_couple;
use super::{Acceleration, Frame, Joint, JointMotion, Rotation, Spatial, Turn, joint::Stored};
use crate::element::{Condense, Explicit, Given, InJoint, Posture, Sweep};
use crate::error::Fault;
use crate::lift::Lift;
use crate::relation::space::algebra::{Columns, cross, dot, zero};
use crate::relation::space::{Couple, Gain, Point, Rigid};
use crate::relation::{Absent, Closures, Coefficient, Term};
use crate::scalar::{Real, Scalar};
use nalgebra::Vector3;

/// A ball joint with a rotary spring, and a damper where there is one.
///
/// The spring stores V = ½ φᵀ K φ for the rotation vector φ of the outboard body relative to the inboard one, with stiffnesses K along
/// axes of the inboard body. (34) of the paper multiplies differences of angles instead, which is neither conservative nor the same
/// in all inertial axes. The spring follows relative turns of up to one whole turn.
///
/// Its coordinate is the attitude relative to the inboard body, its rate the relative angular velocity in axes of the outboard body.
/// Explicit rules take it; in implicit ones, springs about axes ([`Revolute`](super::Revolute), [`Universal`](super::Universal)) do.
///
/// ```
/// use catena::spatial::*;
/// let rod = Rod::uniform(0.5, 0.05, 1.0);
/// let joint = ElasticBall::rotary([20.0, 5.0, 20.0]).damped(0.01); // (N·m/rad), (N·m·s/rad)
/// let blade = System::new(Clamped::origin(), (rod, joint, rod), Free)?.with_gravity(9.81);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticBall<T, D = Absent> {
    stiffness: [T; 3],
    damping: D,
}

impl<T: Scalar> ElasticBall<T> {
    /// With stiffnesses (N·m/rad) about the axes of the inboard body.
    pub fn rotary(stiffness: [T; 3]) -> Self {
        Self { stiffness, damping: Absent }
    }

    /// With a rotary damper (N·m·s/rad), alike about all axes.
    pub fn damped(self, damping: T) -> ElasticBall<T, T> {
        ElasticBall { stiffness: self.stiffness, damping }
    }
}

impl<T: Scalar, D: Coefficient<T>> ElasticBall<T, D> {
    /// Torque on the outboard body, inertial axes.
    #[inline(always)]
    fn torque(&self, attitude: &Columns<T>, position: &Rotation<T>, rate: &[T; 3]) -> Vector3<T> {
        let spring = spring_couple(Vector3::from(position.log()), Vector3::from(self.stiffness));
        let own = position.matrix().transposed(spring);
        let damped = |k: usize| self.damping.times_onto(-rate[k], -own[k]);
        attitude.apply(Vector3::new(damped(0), damped(1), damped(2)))
    }
}

impl<T: Scalar, D: Coefficient<T>> Joint<T> for ElasticBall<T, D> {
    type Position = Rotation<T>;
    type Rate = [T; 3];
    type Kept<C: Closures> = Gain<T, C>;

    fn position() -> Rotation<T> {
        Rotation::identity()
    }
    fn rate() -> [T; 3] {
        [T::zero(); 3]
    }
    fn kept<C: Closures>() -> Gain<T, C> {
        Gain::blank()
    }
    fn is_finite<C: Closures>(kept: &Gain<T, C>) -> bool {
        kept.is_finite()
    }
    /// Three absolute angles 1-2-3.
    fn aim(&self, position: &mut Rotation<T>, inboard: Turn<T>, next: &mut impl FnMut() -> T) -> Turn<T> {
        let absolute = Rotation::from_angles([next(), next(), next()]);
        *position = absolute.relative_to(&Rotation::from_matrix(&inboard.attitude)).shortest();
        Turn { attitude: absolute.matrix(), spin: zero() }
    }
    #[inline(always)]
    fn oriented(&self, position: &Rotation<T>, rate: &[T; 3], inboard: Turn<T>) -> (Turn<T>, Stored<T>) {
        let attitude = inboard.attitude.times(&position.matrix());
        let relative = attitude.apply(Vector3::from(*rate));
        let bias = cross(inboard.spin, relative);
        (Turn { attitude, spin: inboard.spin + relative }, (attitude, [zero(), bias]))
    }
    #[inline(always)]
    fn moved(&self, inboard: Frame<T>, position: &Rotation<T>, rate: &[T; 3], acceleration: &[T; 3]) -> JointMotion<T> {
        let (turn, (attitude, [_, bias])) = self.oriented(position, rate, inboard.turn);
        let angular = attitude.apply_onto(Vector3::from(*acceleration), inboard.acceleration.angular + bias);
        let outboard = Frame { turn, acceleration: Acceleration { angular, ..inboard.acceleration }, ..inboard };
        let phi = Vector3::from(position.log());
        let energy = dot(phi, phi.component_mul(&Vector3::from(self.stiffness))).scale(T::Real::of(0.5));
        JointMotion { inboard, outboard, position: phi.into(), rate: *rate, energy }
    }
    fn check(&self) -> Result<(), Fault> {
        finite("stiffness", &self.stiffness)?;
        self.stiffness.iter().try_for_each(|k| not_negative("stiffness", *k))?;
        not_negative("damping", self.damping.times_onto(T::one(), T::zero()))
    }
    #[inline(always)]
    fn recovered<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        (attitude, [_, bias]): (&Columns<T>, &[Vector3<T>; 2]),
        kept: &Gain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut [T; 3],
    ) -> Acceleration<T> {
        let angular = kept.angular(inboard.linear, multipliers);
        *rate = attitude.transposed(angular - inboard.angular - bias).into();
        Acceleration { angular, ..inboard }
    }
    #[inline(always)]
    fn responded<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        (attitude, _): (&Columns<T>, &[Vector3<T>; 2]),
        kept: &Gain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut [T; 3],
    ) -> Acceleration<T> {
        let homogeneous = Gain { free: zero(), ..*kept };
        self.recovered::<C>(inboard, (attitude, &[zero(); 2]), &homogeneous, multipliers, rate)
    }
}

impl<T: Scalar, D: Coefficient<T>, R: Rigid<T>, W> Condense<Spatial<T>, R, W> for ElasticBall<T, D>
where
    W: Sweep<Spatial<T>, Springs = Explicit, Closures = R::Closures>,
    InJoint<Spatial<T>, W>: Drive<T>,
{
    type Out = Point<T, Couple<T>, W::Closures>;

    #[inline(always)]
    fn condense(
        &self,
        outer: R,
        posture: Posture<'_, Spatial<T>, Self>,
        given: Given<'_, Spatial<T>, Self, W>,
        kept: &mut Gain<T, W::Closures>,
    ) -> Self::Out {
        let own = self.torque(posture.x, given.position, given.rate);
        let torque = given.in_joints.couple(posture.x).add_to(own);
        let (relation, gain) = outer.full().balled(Couple(torque));
        *kept = gain;
        relation
    }
}

impl<T: Scalar, U: Scalar, D: Lift<T, U>> Lift<T, U> for ElasticBall<T, D> {
    type Over = ElasticBall<U, D::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        ElasticBall { stiffness: self.stiffness.lift(number), damping: self.damping.lift(number) }
    }
}
