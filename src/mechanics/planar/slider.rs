//! The joint that slides.

use super::axes::{Inboard, Offset};
use super::{Acceleration, Frame, Joint, JointMotion, Planar, Spring, SpringState, Turn, release};
use crate::element::{Condense, Given, InJoint, Posture, Sweep};
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::planar::{Full, Relation, RelativeGain, Slides, along, back};
use crate::relation::{Absent, Closures, Term};
use crate::release::Release;
use crate::scalar::Scalar;
use crate::spring::{SpringLaw, read};
use nalgebra::Vector2;

/// A joint whose outboard point slides along a straight line of the inboard body while the bodies do not turn relative to each
/// other, with a spring and damper along the line if there are any. Its coordinate is the distance from the inboard point (m). A load
/// in the joint is a force along the line (N), ON the outboard body.
///
/// ```
/// use catena::planar::*;
/// let (cart, rod) = (RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]), Rod::uniform(1.0, 0.5));
/// let track = Slider::along(0.0).with(Spring::new(50.0)); // direction (rad) in the axes of the inboard body
/// let crane = System::new(Clamped::at(0.0, 0.0, 0.0), (track, cart, Pin, rod), Free)?.with_gravity(9.81);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: serde::Serialize, S: serde::Serialize",
        deserialize = "T: serde::Deserialize<'de>, S: serde::Deserialize<'de>, T: num_traits::Zero"
    ))
)]
pub struct Slider<T, S = Absent> {
    pub(super) direction: T,
    pub(super) spring: S,
    /// Point mass that the outboard body lumps at its inboard end, in a scene.
    #[cfg_attr(feature = "serde", serde(skip, default = "num_traits::zero"))]
    pub(super) lumped: T,
}

impl<T: Scalar> Slider<T> {
    /// Along a direction (rad) in the axes of the inboard body.
    pub fn along(direction: T) -> Self {
        Self { direction, spring: Absent, lumped: T::zero() }
    }

    /// With a spring along the line.
    #[deprecated(note = "`with` takes springs, too")]
    pub fn sprung<D, P>(self, spring: Spring<T, D, P>) -> Slider<T, Spring<T, D, P>>
    where
        Spring<T, D, P>: SpringLaw<T>,
    {
        self.with(spring)
    }

    /// With a spring or a law of the user's own along the line, see [`SpringLaw`].
    pub fn with<L: SpringLaw<T>>(self, law: L) -> Slider<T, L> {
        Slider { direction: self.direction, spring: law, lumped: self.lumped }
    }
}

impl<T: Scalar, S: SpringLaw<T>> Joint<T> for Slider<T, S> {
    type Position = T;
    type Rate = T;
    type Kept<C: Closures> = RelativeGain<T, C>;
    type Axes = Inboard;

    const LINEAR: bool = S::LINEAR;

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
    fn configure(&self, _: &mut T, inboard: Turn<T>, _: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
        inboard
    }
    fn lump(&mut self, mass: T) -> T {
        self.lumped = mass;
        T::zero()
    }
    #[inline(always)]
    fn turned(&self, _: &T, _: &T, inboard: Turn<T>) -> Turn<T> {
        inboard
    }
    #[cfg_attr(optimised, inline(always))]
    fn orient(
        &self,
        position: &T,
        rate: &T,
        inboard: Turn<T>,
        x: &mut [T; 2],
        y: &mut [T; 2],
        p: &mut [T; 2],
        q: &mut [T; 2],
    ) -> Turn<T> {
        let axis = Turn { angle: inboard.angle + self.direction, ..inboard };
        Inboard::keep(axis, [[*position, T::zero()], [*rate, T::zero()]], x, y, p, q);
        inboard
    }
    #[cfg_attr(optimised, inline(always))]
    fn moved(&self, inboard: Frame<T>, position: &T, rate: &T, acceleration: &T) -> JointMotion<T> {
        let (sine, cosine) = (inboard.turn.angle + self.direction).sin_cos();
        let line = Vector2::new(cosine, sine);
        let outboard = inboard.displaced([line * *position, line * *rate, line * *acceleration]);
        let force = [self.spring.force(*position, *rate), T::zero()];
        JointMotion {
            arm: outboard.place - inboard.place,
            spring: SpringState { torque: T::zero(), force, energy: self.spring.energy(*position) },
            slide: [*position, T::zero()],
            sliding: [*rate, T::zero()],
            ..JointMotion::coincident(inboard, outboard, false)
        }
    }
    fn check(&self) -> Result<(), Fault> {
        if !self.direction.is_finite() {
            return Err(Fault::NotFinite { parameter: "direction" });
        }
        self.spring.check()
    }
    fn release(&self, motion: &JointMotion<T>, position: &T, rate: &T) -> Release<Planar<T>> {
        release::slider(self, motion, [*position, *rate])
    }
    #[cfg_attr(optimised, inline(always))]
    fn recovered<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        offset: Offset<T>,
        kept: &RelativeGain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut T,
    ) -> Acceleration<T> {
        let Offset { direction, arm, acceleration } = offset;
        let carried = inboard.shifted(arm, acceleration);
        *rate = kept.relative(along(carried.linear, direction), carried.angular, multipliers);
        Acceleration { linear: carried.linear + direction * *rate, ..carried }
    }
}

impl<T: Scalar, S> Slider<T, S> {
    /// Lets the outboard point slide along the line against a force, and what stiffness or inertia adds to the pivot.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn loosen<R: Slides<T>>(
        &self,
        outer: R,
        Offset { direction, arm, acceleration }: Offset<T>,
        force: T,
        pivot: T,
        kept: &mut RelativeGain<T, R::Closures>,
    ) -> Full<T, R::Closures> {
        let (relation, gain) = outer.with_mass(self.lumped).along(direction).slid(force, pivot);
        *kept = gain;
        relation.along(back(direction)).carried(arm, acceleration)
    }

    /// Takes the outboard point along at a given acceleration on the line.
    #[inline(always)]
    pub(super) fn carry<C: Closures>(&self, outer: Full<T, C>, offset: Offset<T>, second: T) -> Full<T, C> {
        let Offset { direction, arm, acceleration } = offset;
        outer.with_mass(self.lumped).carried(arm, acceleration + direction * second)
    }
}

impl<T: Scalar, S: SpringLaw<T>, R: Slides<T>, W> Condense<Planar<T>, R, W> for Slider<T, S>
where
    W: Sweep<Planar<T>, Closures = R::Closures>,
    InJoint<Planar<T>, W>: Term<T>,
{
    type Out = Full<T, R::Closures>;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: R,
        posture: Posture<'_, Planar<T>, Self>,
        given: Given<'_, Planar<T>, Self, W>,
        kept: &mut RelativeGain<T, W::Closures>,
    ) -> Self::Out {
        let offset = super::joint::offset::<T, Self>(posture);
        let Given { in_joints, position, rate, reading, springs, .. } = given;
        let [force, pivot] = read(&self.spring, (*position, *rate), reading, springs);
        self.loosen(outer, offset, in_joints.add_to(force), pivot, kept)
    }
}

lift!(Slider<T, S> { direction, lumped, spring });
