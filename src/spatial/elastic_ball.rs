//! The ball joint with a spring.

use super::inertia::{finite, not_negative};
use super::loads::Drive;
use super::maps::{spring_couple, spring_slope};
use super::{Acceleration, Frame, Joint, JointMotion, Rotation, Spatial, Turn, joint::Stored};
use crate::element::{Condense, Explicit, Given, Implicit, InJoint, Posture, Springs, Sweep};
use crate::error::Fault;
use crate::lift::Lift;
use crate::relation::space::algebra::{Columns, Symmetric3, cross, dot, zero};
use crate::relation::space::{BallGain, Couple, Full, Gain, Point, Rigid};
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
/// Explicit rules keep their order on it. Implicit ones take its law at the attitude without the acceleration sought, and have order 2
/// at any stiffness; that is what [`Sdirk4`](super::Sdirk4) has too, whose order 4 needs springs about axes
/// ([`Revolute`](super::Revolute), [`Universal`](super::Universal)).
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

/// How the rule of a sweep treats the spring of a ball.
pub trait BallRule<T: Scalar>: Springs<T> {
    /// The relation handed on.
    type Out<C: Closures>: Copy;
    /// Eliminates the rotation under a torque, of a spring with the slope and the damping given as functions; `bias` is the angular
    /// acceleration that rates alone cause.
    fn ball<C: Closures>(
        self,
        outer: Full<T, C>,
        torque: Vector3<T>,
        slope: impl FnOnce() -> Symmetric3<T>,
        damping: impl FnOnce(T) -> T,
        bias: Vector3<T>,
    ) -> (Self::Out<C>, BallGain<T, C>);
}

impl<T: Scalar> BallRule<T> for Explicit {
    type Out<C: Closures> = Point<T, Couple<T>, C>;

    #[inline(always)]
    fn ball<C: Closures>(
        self,
        outer: Full<T, C>,
        torque: Vector3<T>,
        _: impl FnOnce() -> Symmetric3<T>,
        _: impl FnOnce(T) -> T,
        _: Vector3<T>,
    ) -> (Self::Out<C>, BallGain<T, C>) {
        let (relation, gain) = outer.balled(Couple(torque));
        (relation, BallGain::absolute(gain))
    }
}

impl<T: Scalar> BallRule<T> for Implicit<T::Real> {
    type Out<C: Closures> = Full<T, C>;

    #[inline(always)]
    fn ball<C: Closures>(
        self,
        outer: Full<T, C>,
        torque: Vector3<T>,
        slope: impl FnOnce() -> Symmetric3<T>,
        damping: impl FnOnce(T) -> T,
        bias: Vector3<T>,
    ) -> (Full<T, C>, BallGain<T, C>) {
        let stiffness = slope().scaled(self.position).plus_diagonal(damping(T::constant(self.rate)));
        let (relation, gain) = outer.sprung(torque, stiffness);
        (relation.turning(bias), gain)
    }
}

impl<T: Scalar, D: Coefficient<T>> Joint<T> for ElasticBall<T, D> {
    type Position = Rotation<T>;
    type Rate = [T; 3];
    type Kept<C: Closures> = BallGain<T, C>;

    fn position() -> Rotation<T> {
        Rotation::identity()
    }
    fn rate() -> [T; 3] {
        [T::zero(); 3]
    }
    fn kept<C: Closures>() -> BallGain<T, C> {
        BallGain::blank()
    }
    fn is_finite<C: Closures>(kept: &BallGain<T, C>) -> bool {
        kept.is_finite()
    }
    /// Three absolute angles 1-2-3.
    fn aim(&self, position: &mut Rotation<T>, inboard: Turn<T>, next: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
        let absolute = Rotation::from_angles([(); 3].map(|()| next(inboard)));
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
        kept: &BallGain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut [T; 3],
    ) -> Acceleration<T> {
        let carried = inboard.angular + bias;
        let relative = kept.relative(inboard.linear, carried, multipliers);
        *rate = attitude.transposed(relative).into();
        Acceleration { angular: carried + relative, ..inboard }
    }
    #[inline(always)]
    fn responded<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        (attitude, _): (&Columns<T>, &[Vector3<T>; 2]),
        kept: &BallGain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut [T; 3],
    ) -> Acceleration<T> {
        let homogeneous = BallGain { absolute: Gain { free: zero(), ..kept.absolute }, ..*kept };
        self.recovered::<C>(inboard, (attitude, &[zero(); 2]), &homogeneous, multipliers, rate)
    }
}

impl<T: Scalar, D: Coefficient<T>, R: Rigid<T>, W> Condense<Spatial<T>, R, W> for ElasticBall<T, D>
where
    W: Sweep<Spatial<T>, Springs: BallRule<T>, Closures = R::Closures>,
    InJoint<Spatial<T>, W>: Drive<T>,
{
    type Out = <W::Springs as BallRule<T>>::Out<W::Closures>;

    #[inline(always)]
    fn condense(
        &self,
        outer: R,
        posture: Posture<'_, Spatial<T>, Self>,
        given: Given<'_, Spatial<T>, Self, W>,
        kept: &mut BallGain<T, W::Closures>,
    ) -> Self::Out {
        let (attitude, position) = (posture.x, given.position);
        let torque = given.in_joints.couple(attitude).add_to(self.torque(attitude, position, given.rate));
        let slope = || {
            let own = spring_slope(Vector3::from(position.log()), Vector3::from(self.stiffness));
            own.turned(&attitude.times(&position.inverse().matrix()))
        };
        let damping = |rate: T| self.damping.times_onto(rate, T::zero());
        let (relation, gain) = given.springs.ball(outer.full(), torque, slope, damping, posture.y[1]);
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
