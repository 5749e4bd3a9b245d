//! What joints that are driven ([`Driven`](crate::driven::Driven)) or have modes ([`Guarded`](crate::guarded::Guarded)) ask of the joint
//! inside: all [`Kinematics`] can, and joints in axes of their bodies.

use crate::kinematics::{Acting, Kinematics, Outboard};
use crate::relation::Full;
use crate::shape::{Joint, JointPosture};
use crate::space::Space;
use crate::sweep::Sweep;

/// What is asked of a joint that can be driven, besides its motion: how it turns what it carries.
pub trait Drivable<S: Space>: Joint<S, Position = S::Scalar, Rate = S::Scalar> {
    /// [`Kinematics::lump`].
    fn lump(&mut self, mass: S::Scalar) -> S::Scalar;
    /// [`Kinematics::turned`].
    fn turned(&self, position: &S::Scalar, rate: &S::Scalar, inboard: S::Turn) -> S::Turn;
    /// [`Kinematics::orient`].
    #[allow(clippy::too_many_arguments)] // one store each
    fn orient(
        &self,
        position: &S::Scalar,
        rate: &S::Scalar,
        inboard: S::Turn,
        x: &mut Self::Per<S::X>,
        y: &mut Self::Per<S::Y>,
        p: &mut Self::Per<S::P>,
        q: &mut Self::Per<S::Q>,
    ) -> S::Turn;
    /// [`Kinematics::resolve`].
    fn resolve(x: &mut Self::Per<S::X>, y: &mut Self::Per<S::Y>, p: &mut Self::Per<S::P>, q: &mut Self::Per<S::Q>);
}

/// A joint that can have modes ([`Guarded`](crate::guarded::Guarded)): one that resists by nothing of its own but inertia.
pub trait Guardable<S: Space>: Drivable<S> {
    /// [`Kinematics::under`].
    fn under(motion: S::JointMotion, model: Acting<S::Scalar>) -> S::JointMotion;
}

/// How the relation outboard of a joint goes through it, whatever kind of relation that is.
pub trait Eliminates<S: Space, Outer: Copy, W: Sweep<S>>: Drivable<S> {
    /// The relation of the inboard side.
    type Out: Copy;
    /// [`Kinematics::eliminate`].
    fn eliminate(
        &self,
        outer: Outer,
        posture: JointPosture<'_, S, Self>,
        force: S::Scalar,
        resistance: S::Scalar,
        kept: &mut Self::Kept<W::Closures>,
    ) -> Self::Out;
    /// [`Kinematics::drive`].
    fn drive(
        &self,
        outer: Outer,
        posture: JointPosture<'_, S, Self>,
        acceleration: S::Scalar,
        kept: &mut Self::Kept<W::Closures>,
    ) -> Self::Out;
}

impl<S: Space, J: Kinematics<S>> Guardable<S> for J {
    fn under(motion: S::JointMotion, model: Acting<S::Scalar>) -> S::JointMotion {
        <J as Kinematics<S>>::under(motion, model)
    }
}

impl<S: Space, J: Kinematics<S>, Outer: Outboard<S>, W: Sweep<S, Closures = Outer::Closures>> Eliminates<S, Outer, W>
    for J
{
    type Out = Full<S, Outer::Closures>;
    #[cfg_attr(optimised, inline(always))]
    fn eliminate(
        &self,
        outer: Outer,
        posture: JointPosture<'_, S, Self>,
        force: S::Scalar,
        resistance: S::Scalar,
        kept: &mut Self::Kept<Outer::Closures>,
    ) -> Self::Out {
        Kinematics::eliminate::<Outer::Closures>(self, outer.whole(), posture, force, resistance, kept)
    }
    #[cfg_attr(optimised, inline(always))]
    fn drive(
        &self,
        outer: Outer,
        posture: JointPosture<'_, S, Self>,
        acceleration: S::Scalar,
        kept: &mut Self::Kept<Outer::Closures>,
    ) -> Self::Out {
        Kinematics::drive::<Outer::Closures>(self, outer.whole(), posture, acceleration, kept)
    }
}

impl<S: Space, J: Kinematics<S>> Drivable<S> for J {
    fn lump(&mut self, mass: S::Scalar) -> S::Scalar {
        Kinematics::lump(self, mass)
    }
    #[inline(always)]
    fn turned(&self, position: &S::Scalar, rate: &S::Scalar, inboard: S::Turn) -> S::Turn {
        Kinematics::turned(self, position, rate, inboard)
    }
    #[cfg_attr(optimised, inline(always))]
    fn orient(
        &self,
        position: &S::Scalar,
        rate: &S::Scalar,
        inboard: S::Turn,
        x: &mut Self::Per<S::X>,
        y: &mut Self::Per<S::Y>,
        p: &mut Self::Per<S::P>,
        q: &mut Self::Per<S::Q>,
    ) -> S::Turn {
        Kinematics::orient(self, position, rate, inboard, x, y, p, q)
    }
    #[inline(always)]
    fn resolve(x: &mut Self::Per<S::X>, y: &mut Self::Per<S::Y>, p: &mut Self::Per<S::P>, q: &mut Self::Per<S::Q>) {
        <J as Kinematics<S>>::resolve(x, y, p, q);
    }
}
