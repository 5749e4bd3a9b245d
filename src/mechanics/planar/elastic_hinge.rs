//! The elastic hinge: a joint with springs and dampers.

use super::axes::Coincident;
use super::{Acceleration, Frame, Joint, JointMotion, Linear, Planar, Spring, SpringState, Turn, release};
use crate::element::{Condense, Explicit, Given, Implicit, InJoint, Posture, Springs, Sweep};
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::planar::{Full, Point, RelativeGain, Rigid, Slides};
use crate::relation::{Absent, Closures, Minus, Term};
use crate::release::Release;
use crate::scalar::Scalar;
use crate::spring::{Custom, SpringLaw, read};

/// A joint with springs and dampers: rotary ones, and linear ones where there are any (see [`Linear`]). Without linear springs
/// its points coincide.
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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ElasticHinge<R, L = Absent> {
    pub(super) rotary: R,
    pub(super) linear: L,
}

impl<T: Scalar> ElasticHinge<Spring<T>> {
    /// A pin with a rotary spring of a stiffness (N·m/rad).
    pub fn rotary(stiffness: T) -> Self {
        Self { rotary: Spring::new(stiffness), linear: Absent }
    }
}

impl<L> ElasticHinge<Custom<L>> {
    /// A pin with a law of the user's own, see [`SpringLaw`].
    pub fn with(law: L) -> Self {
        Self { rotary: Custom(law), linear: Absent }
    }
}

impl<T: Scalar, X: SpringLaw<T>, Y: SpringLaw<T>> ElasticHinge<Absent, Linear<T, X, Y>> {
    /// Springs along the axes of the inboard body, between bodies that turn freely.
    pub fn linear(x: X, y: Y) -> Self {
        Self { rotary: Absent, linear: Linear::new(x, y) }
    }
}

impl<T: Scalar, P, L> ElasticHinge<Spring<T, Absent, P>, L> {
    /// With a rotary damper (N·m·s/rad).
    pub fn damped(self, damping: T) -> ElasticHinge<Spring<T, T, P>, L> {
        ElasticHinge { rotary: self.rotary.damped(damping), linear: self.linear }
    }
}

impl<T: Scalar, D, L> ElasticHinge<Spring<T, D, Absent>, L> {
    /// With a rest angle (rad) of the outboard body relative to the inboard one.
    pub fn resting_at(self, rest: T) -> ElasticHinge<Spring<T, D, T>, L> {
        ElasticHinge { rotary: self.rotary.resting_at(rest), linear: self.linear }
    }
}

impl<R> ElasticHinge<R> {
    /// With springs along the axes of the inboard body.
    pub fn with_linear<T: Scalar, X: SpringLaw<T>, Y: SpringLaw<T>>(
        self,
        x: X,
        y: Y,
    ) -> ElasticHinge<R, Linear<T, X, Y>> {
        ElasticHinge { rotary: self.rotary, linear: Linear::new(x, y) }
    }
}

/// A pin whose coordinate is the angle of the outboard body relative to the inboard one: a hinge without springs, from which joints of
/// a user's own are made ([`extend`](crate::extend)). Where nothing resists, [`Pin`](super::Pin) is cheaper.
pub type Revolute = ElasticHinge<Absent>;

impl Revolute {
    /// A smooth pin.
    pub fn smooth() -> Self {
        Self { rotary: Absent, linear: Absent }
    }
}

impl Default for Revolute {
    fn default() -> Self {
        Self::smooth()
    }
}

/// How the rule of a sweep treats a rotary spring.
pub trait HingeRule<T: Scalar>: Springs<T> {
    /// The relation handed on.
    type Out<C: Closures>: Slides<T, Closures = C>;
    /// Eliminates the rotation against a torque, and what a spring adds to the pivot.
    fn hinge<C: Closures>(self, torque: T, pivot: T, outer: Full<T, C>, kept: &mut RelativeGain<T, C>) -> Self::Out<C>;
}

impl<T: Scalar> HingeRule<T> for Explicit {
    type Out<C: Closures> = Point<T, Minus<T>, C>;

    #[cfg_attr(optimised, inline(always))]
    fn hinge<C: Closures>(self, torque: T, _: T, outer: Full<T, C>, kept: &mut RelativeGain<T, C>) -> Self::Out<C> {
        let (relation, gain) = outer.pinned(Minus(-torque));
        kept.absolute(gain);
        relation
    }
}

impl<T: Scalar> HingeRule<T> for Implicit<T::Real> {
    type Out<C: Closures> = Full<T, C>;

    #[cfg_attr(optimised, inline(always))]
    fn hinge<C: Closures>(self, torque: T, pivot: T, outer: Full<T, C>, kept: &mut RelativeGain<T, C>) -> Full<T, C> {
        let (relation, gain) = outer.hinged(torque, pivot);
        *kept = gain;
        relation
    }
}

impl<T: Scalar, R: SpringLaw<T>> Joint<T> for ElasticHinge<R> {
    type Position = T;
    type Rate = T;
    type Kept<C: Closures> = RelativeGain<T, C>;
    type Axes = Coincident;

    const LINEAR: bool = R::LINEAR;

    fn kind() -> &'static str {
        if R::ON { core::any::type_name::<Self>() } else { "Revolute" }
    }
    fn still() -> (T, T) {
        (T::zero(), T::zero())
    }
    fn kept<C: Closures>() -> RelativeGain<T, C> {
        RelativeGain::blank()
    }
    #[inline(always)]
    fn homogeneous<C: Closures>(kept: &RelativeGain<T, C>) -> RelativeGain<T, C> {
        kept.homogeneous()
    }
    fn is_finite<C: Closures>(kept: &RelativeGain<T, C>) -> bool {
        kept.is_finite()
    }
    fn configure(&self, position: &mut T, inboard: Turn<T>, next: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
        let angle = next(inboard);
        *position = angle - inboard.angle;
        Turn { angle, rate: T::zero() }
    }
    #[inline(always)]
    fn turned(&self, position: &T, rate: &T, inboard: Turn<T>) -> Turn<T> {
        Turn { angle: inboard.angle + *position, rate: inboard.rate + *rate }
    }
    #[cfg_attr(optimised, inline(always))]
    fn moved(&self, inboard: Frame<T>, position: &T, rate: &T, acceleration: &T) -> JointMotion<T> {
        let angular = inboard.acceleration.angular + *acceleration;
        let outboard = Frame {
            turn: self.turned(position, rate, inboard.turn),
            acceleration: Acceleration { angular, ..inboard.acceleration },
            ..inboard
        };
        let (torque, energy) = (self.rotary.force(*position, *rate), self.rotary.energy(*position));
        let spring = SpringState { torque, force: [T::zero(); 2], energy };
        JointMotion { spring, ..JointMotion::coincident(inboard, outboard, true) }
    }
    fn check(&self) -> Result<(), Fault> {
        self.rotary.check()
    }
    fn release(&self, _: &JointMotion<T>, position: &T, rate: &T) -> Release<Planar<T>> {
        release::rotary(self, [*position, *rate])
    }
    #[cfg_attr(optimised, inline(always))]
    fn recovered<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        (): (),
        kept: &RelativeGain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut T,
    ) -> Acceleration<T> {
        *rate = kept.relative(inboard.linear, inboard.angular, multipliers);
        Acceleration { angular: inboard.angular + *rate, ..inboard }
    }
    #[cfg_attr(optimised, inline(always))]
    fn recovered_after<C: Closures, By: Springs<T>>(
        &self,
        inboard: Acceleration<T>,
        (): (),
        kept: &mut RelativeGain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut T,
    ) -> Acceleration<T> {
        if By::STIFF {
            return self.recovered::<C>(inboard, (), kept, multipliers, rate);
        }
        // As behind a pin, so that no body waits for the sum with the one before.
        let angular = kept.angular(inboard.linear, multipliers);
        *rate = angular - inboard.angular;
        Acceleration { angular, ..inboard }
    }
}

impl<T: Scalar, L: SpringLaw<T>, R: Rigid<T>, W> Condense<Planar<T>, R, W> for ElasticHinge<L>
where
    W: Sweep<Planar<T>, Springs: HingeRule<T>, Closures = R::Closures>,
    InJoint<Planar<T>, W>: Term<T>,
{
    type Out = <W::Springs as HingeRule<T>>::Out<W::Closures>;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: R,
        _: Posture<'_, Planar<T>, Self>,
        given: Given<'_, Planar<T>, Self, W>,
        kept: &mut RelativeGain<T, W::Closures>,
    ) -> Self::Out {
        let Given { in_joints, position, rate, reading, springs, .. } = given;
        let [torque, pivot] = read(&self.rotary, (*position, *rate), reading, springs);
        springs.hinge(in_joints.add_to(torque), pivot, outer.full(), kept)
    }
}

lift!(ElasticHinge<R, L> { rotary, linear });

lift!(Absent);
