//! The rigid joint.

use super::axes::Coincident;
use super::{Acceleration, Frame, Joint, JointMotion, Planar, Turn};
use crate::element::{Condense, Given, Posture, Sweep};
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::Closures;
use crate::release::Release;
use crate::scalar::Scalar;

/// Two bodies joined rigidly at an angle: what a hinge of infinite stiffness is.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0, 1.0);
/// let bracket = System::new(Pinned::origin(), (rod, Weld::at(0.5), rod), Free)?;
/// assert_eq!(bracket.angles(&bracket.at_rest(&[0.2])?)?.body::<1>(), Some(&0.7));
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Weld<T> {
    angle: T,
}

impl<T: Scalar> Weld<T> {
    /// The outboard body's angle relative to the inboard one (rad).
    pub fn at(angle: T) -> Self {
        Self { angle }
    }

    /// The outboard body's angle relative to the inboard one (rad).
    pub fn angle(&self) -> T {
        self.angle
    }
}

impl<T: Scalar> Joint<T> for Weld<T> {
    type Position = ();
    type Rate = ();
    type Kept<C: Closures> = ();

    type Axes = Coincident;

    fn still() -> ((), ()) {
        ((), ())
    }
    fn kept<C: Closures>() {}
    fn homogeneous<C: Closures>((): &()) {}
    fn is_finite<C: Closures>((): &()) -> bool {
        true
    }
    fn configure(&self, (): &mut (), inboard: Turn<T>, _: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
        self.turned(&(), &(), inboard)
    }
    #[inline(always)]
    fn turned(&self, (): &(), (): &(), inboard: Turn<T>) -> Turn<T> {
        Turn { angle: inboard.angle + self.angle, ..inboard }
    }
    #[inline(always)]
    fn moved(&self, inboard: Frame<T>, (): &(), (): &(), (): &()) -> JointMotion<T> {
        let outboard = Frame { turn: self.turned(&(), &(), inboard.turn), ..inboard };
        JointMotion::coincident(inboard, outboard, false)
    }
    fn check(&self) -> Result<(), Fault> {
        if self.angle.is_finite() { Ok(()) } else { Err(Fault::NotFinite { parameter: "angle" }) }
    }
    fn release(&self, _: &JointMotion<T>, _: &(), _: &()) -> Release<Planar<T>> {
        Release::nothing()
    }
    #[cfg_attr(optimised, inline(always))]
    fn recovered<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        (): (),
        (): &(),
        _: &C::Each<T>,
        (): &mut (),
    ) -> Acceleration<T> {
        inboard
    }
}

impl<T: Scalar, R: Copy, W: Sweep<Planar<T>>> Condense<Planar<T>, R, W> for Weld<T> {
    type Out = R;

    #[inline(always)]
    fn condense(&self, outer: R, _: Posture<'_, Planar<T>, Self>, _: Given<'_, Planar<T>, Self, W>, (): &mut ()) -> R {
        outer
    }
}

lift!(Weld { angle });
