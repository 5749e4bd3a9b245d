//! Motions of other scenes of the same type, told apart.

use crate::element::{Element, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate};
use crate::scalar::{Real, Scalar};
use crate::system::{MotionOf, System};
use crate::walks::fits::fits;

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Refuses a motion of another scene: one with vectors of another length. (Those of another type do not compile.)
    ///
    /// Readings do not fail: what they read of such a motion is not a number, anywhere.
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0_f64, 1.0);
    /// let chain = |links: usize| System::new(Pinned::origin(), (rod, vec![(Pin, rod); links]), Free);
    /// let (short, long) = (chain(2)?, chain(3)?);
    /// let motion = long.motion();
    /// assert!(long.fits(&motion).is_ok());
    /// assert_eq!(short.fits(&motion), Err(catena::Error::new(catena::Fault::Shape)));
    /// assert!(short.budget(&motion).energy().is_nan());
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::Shape`].
    #[inline]
    pub fn fits(&self, motion: &MotionOf<S, R, C, P>) -> Result<(), Error> {
        let chain = self.elements();
        let fits = fits(chain, &motion.position, &motion.rate) && fits(chain, &motion.position, &motion.acceleration);
        if fits { Ok(()) } else { Err(Error::new(Fault::Shape)) }
    }

    /// Reads a motion of this scene; instead of another one's, a motion of which no number is one.
    #[inline]
    pub(super) fn reading<X>(&self, motion: &MotionOf<S, R, C, P>, read: impl FnOnce(&MotionOf<S, R, C, P>) -> X) -> X {
        if self.fits(motion).is_ok() { read(motion) } else { read(&self.nowhere().at_time(motion.time)) }
    }

    #[cold]
    fn nowhere(&self) -> MotionOf<S, R, C, P> {
        let (mut motion, nothing) = (self.motion(), S::Scalar::constant(RealOf::<S>::of(f64::NAN)));
        motion.position.replace(&mut |_| nothing);
        motion.rate.replace(&mut |_| nothing);
        motion.acceleration.replace(&mut |_| nothing);
        motion
    }
}
