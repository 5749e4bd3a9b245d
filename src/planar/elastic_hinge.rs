//! The elastic hinge: a joint with springs and dampers.

use super::body::not_negative;
use super::{Acceleration, Frame, Joint, Planar, SpringState, Turn};
use crate::element::{Condense, Explicit, Given, Implicit, InJoint, Posture, Springs, Sweep};
use crate::error::Fault;
use crate::lift::{Lift, lift};
use crate::relation::plane::{Full, HingeGain, Point, Rigid};
use crate::relation::{Absent, Closures, Coefficient, Term};
use crate::scalar::{Real, Scalar};
use num_traits::Zero;

/// A joint with springs and dampers. Its points coincide unless it has linear springs.
///
/// A stiffness may have any finite value; an infinite one is a [`Weld`](super::Weld).
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(0.5, 1.0);
/// let hinge = ElasticHinge::rotary(20.0).damped(0.01); // stiffness (N·m/rad), damping (N·m·s/rad)
/// let blade = System::new(Pinned::origin(), (rod, hinge, rod), Free)?.with_gravity(9.81);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticHinge<R> {
    rotary: R,
}

/// The rotary part of an elastic hinge: stiffness, and damping and rest angle where there are any.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotary<T, D = Absent, P = Absent> {
    stiffness: T,
    damping: D,
    rest: P,
}

impl<T: Scalar> ElasticHinge<Rotary<T>> {
    /// A pin with a rotary spring of a stiffness (N·m/rad).
    pub fn rotary(stiffness: T) -> Self {
        Self { rotary: Rotary { stiffness, damping: Absent, rest: Absent } }
    }
}

impl<T: Scalar, P> ElasticHinge<Rotary<T, Absent, P>> {
    /// With a rotary damper (N·m·s/rad).
    pub fn damped(self, damping: T) -> ElasticHinge<Rotary<T, T, P>> {
        let Rotary { stiffness, rest, .. } = self.rotary;
        ElasticHinge { rotary: Rotary { stiffness, damping, rest } }
    }
}

impl<T: Scalar, D> ElasticHinge<Rotary<T, D, Absent>> {
    /// With a rest angle (rad) of the outboard body relative to the inboard one.
    pub fn resting_at(self, rest: T) -> ElasticHinge<Rotary<T, D, T>> {
        let Rotary { stiffness, damping, .. } = self.rotary;
        ElasticHinge { rotary: Rotary { stiffness, damping, rest } }
    }
}

impl<T: Scalar, D: Coefficient<T>, P: Term<T>> Rotary<T, D, P> {
    /// Torque on the outboard body: −k (φ − φ₀) − c φ̇.
    #[inline(always)]
    fn torque(&self, angle: T, rate: T) -> T {
        let strain = self.rest.take_from(angle);
        self.damping.times_onto(-rate, -(self.stiffness * strain))
    }
}

/// How the rule of a sweep treats a rotary spring.
pub trait HingeRule<T: Scalar>: Springs<T> {
    /// The relation handed on.
    type Out<C: Closures>: Copy;
    /// Eliminates the rotation.
    fn hinge<C: Closures, D: Coefficient<T>, P: Term<T>>(
        self,
        spring: &Rotary<T, D, P>,
        torque: T,
        outer: Full<T, C>,
    ) -> (Self::Out<C>, HingeGain<T, C>);
}

impl<T: Scalar> HingeRule<T> for Explicit {
    type Out<C: Closures> = Point<T, T, C>;

    #[inline(always)]
    fn hinge<C: Closures, D: Coefficient<T>, P: Term<T>>(
        self,
        _: &Rotary<T, D, P>,
        torque: T,
        outer: Full<T, C>,
    ) -> (Point<T, T, C>, HingeGain<T, C>) {
        let (relation, gain) = outer.pinned(torque);
        (relation, HingeGain::absolute(gain))
    }
}

impl<T: Scalar> HingeRule<T> for Implicit<T::Real> {
    type Out<C: Closures> = Full<T, C>;

    #[inline(always)]
    fn hinge<C: Closures, D: Coefficient<T>, P: Term<T>>(
        self,
        spring: &Rotary<T, D, P>,
        torque: T,
        outer: Full<T, C>,
    ) -> (Full<T, C>, HingeGain<T, C>) {
        let stiffness = spring.damping.times_onto(T::constant(self.rate), spring.stiffness.scale(self.position));
        outer.hinged(torque, stiffness)
    }
}

impl<T: Scalar, D: Coefficient<T>, P: Term<T>> Joint<T> for ElasticHinge<Rotary<T, D, P>> {
    type Position = T;
    type Rate = T;
    type Kept<C: Closures> = HingeGain<T, C>;

    const TURNS: bool = true;

    fn position() -> T {
        T::zero()
    }
    fn rate() -> T {
        T::zero()
    }
    fn kept<C: Closures>() -> HingeGain<T, C> {
        HingeGain::blank()
    }
    #[inline(always)]
    fn homogeneous<C: Closures>(kept: &HingeGain<T, C>) -> HingeGain<T, C> {
        HingeGain { free: T::zero(), ..*kept }
    }
    fn is_finite<C: Closures>(kept: &HingeGain<T, C>) -> bool {
        kept.is_finite()
    }
    fn aim(&self, position: &mut T, inboard: Turn<T>, next: &mut impl FnMut() -> T) -> Turn<T> {
        let angle = next();
        *position = angle - inboard.angle;
        Turn { angle, rate: T::zero() }
    }
    #[inline(always)]
    fn turned(&self, position: &T, rate: &T, inboard: Turn<T>) -> Turn<T> {
        Turn { angle: inboard.angle + *position, rate: inboard.rate + *rate }
    }
    #[inline(always)]
    fn moved(&self, inboard: Frame<T>, position: &T, rate: &T, acceleration: &T) -> Frame<T> {
        let angular = inboard.acceleration.angular + *acceleration;
        Frame {
            turn: self.turned(position, rate, inboard.turn),
            acceleration: Acceleration { angular, ..inboard.acceleration },
            ..inboard
        }
    }
    fn spring(&self, position: &T, rate: &T) -> SpringState<T> {
        let Rotary { stiffness, rest, .. } = self.rotary;
        let strain = rest.take_from(*position);
        let energy = (stiffness * strain * strain).scale(T::Real::of(0.5));
        SpringState { torque: self.rotary.torque(*position, *rate), energy }
    }
    fn check(&self) -> Result<(), Fault> {
        let Rotary { stiffness, damping, rest } = self.rotary;
        let none = T::Real::zero();
        not_negative("stiffness", stiffness, none)?;
        not_negative("damping", damping.times_onto(T::one(), T::zero()), none)?;
        if rest.is_finite() { Ok(()) } else { Err(Fault::NotFinite { parameter: "rest angle" }) }
    }
    #[inline(always)]
    fn recovered<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        kept: &HingeGain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut T,
    ) -> Acceleration<T> {
        *rate = kept.relative(inboard.linear, inboard.angular, multipliers);
        Acceleration { angular: inboard.angular + *rate, ..inboard }
    }
}

impl<T: Scalar, D: Coefficient<T>, P: Term<T>, R: Rigid<T>, W> Condense<Planar<T>, R, W>
    for ElasticHinge<Rotary<T, D, P>>
where
    W: Sweep<Planar<T>, Springs: HingeRule<T>, Closures = R::Closures>,
    InJoint<Planar<T>, W>: Term<T>,
{
    type Out = <W::Springs as HingeRule<T>>::Out<W::Closures>;

    #[inline(always)]
    fn condense(
        &self,
        outer: R,
        _: Posture<'_, Planar<T>, Self>,
        given: Given<'_, Planar<T>, Self, W>,
        kept: &mut HingeGain<T, W::Closures>,
    ) -> Self::Out {
        let torque = given.in_joints.add_to(self.rotary.torque(*given.position, *given.rate));
        let (relation, gain) = given.springs.hinge(&self.rotary, torque, outer.full());
        *kept = gain;
        relation
    }
}

impl<T: Scalar, U: Scalar, D: Lift<T, U>, P: Lift<T, U>> Lift<T, U> for ElasticHinge<Rotary<T, D, P>> {
    type Over = ElasticHinge<Rotary<U, D::Over, P::Over>>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        let Rotary { stiffness, damping, rest } = &self.rotary;
        let rotary =
            Rotary { stiffness: stiffness.lift(number), damping: damping.lift(number), rest: rest.lift(number) };
        ElasticHinge { rotary }
    }
}

lift!(Absent);
