//! Motions and loads of other scenes of the same type, told apart.

use crate::element::{Element, Loading, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault, Place};
use crate::loading::suits;
use crate::motion::Motion;
use crate::scalar::Real;
use crate::system::{MotionOf, System};
use crate::walks::count::coordinates as coordinates_of;
use crate::walks::fits::fits;

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Refuses a motion of another scene: one with vectors of another length. (Those of another type do not compile.) Whatever reads
    /// a motion asks this first, which costs nothing where no vector is.
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0_f64, 1.0);
    /// let chain = |links: usize| System::new(Pinned::origin(), (rod, vec![(Pin, rod); links]), Free);
    /// let (short, long) = (chain(2)?, chain(3)?);
    /// let motion = long.motion();
    /// assert!(long.fits(&motion).is_ok());
    /// assert_eq!(short.fits(&motion), Err(catena::Error::new(catena::Fault::Shape)));
    /// assert!(short.budget(&motion).is_err());
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

    /// Refuses loads that do not fit the scene's bodies and joints.
    #[inline]
    pub(crate) fn loadable<L: Loading<S>>(&self, loads: &L) -> Result<(), Error> {
        let joints = if const { L::BY_COORDINATE } { coordinates_of(&self.chain) } else { self.joints() };
        loads.check(self.bodies(), joints).map_err(Error::new)
    }

    /// Refuses a motion that is not as these loads hold it.
    #[inline]
    pub(crate) fn suited<L: Loading<S>>(&self, motion: &MotionOf<S, R, C, P>, loads: &L) -> Result<(), Error> {
        let Motion { time, position, rate, .. } = motion;
        suits::<S, _>(loads, position, rate)
            .map_err(|(fault, joint)| self.at_joint(fault, joint).at_time(time.as_f64()))
    }

    /// What went wrong at a joint.
    pub(crate) fn at_joint(&self, fault: Fault, joint: usize) -> Error {
        let place = self.joint(joint).ok().map(|numbers| numbers.station.map_or(Place::Root, Place::Station));
        place.map_or(Error::new(fault), |place| Error::new(fault).at(place))
    }
}
