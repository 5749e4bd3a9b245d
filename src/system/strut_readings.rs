//! What struts do in a motion: length, rate, tension and energy of each.

use super::{MotionOf, System, coordinates};
use crate::element::{Element, Loading};
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use crate::struts::{Points, StrutReading, Struts};
use crate::visit::survey;

impl<T: Scalar, const D: usize, const N: usize, L, W: SpringLaw<T>> Struts<T, D, N, L, W> {
    /// Length, rate, tension and energy of each strut in a motion. Energies of scenes ([`System::budget`]) are without those of struts.
    ///
    /// ```
    /// use catena::planar::*;
    /// let scene = System::new(Pinned::origin(), Rod::uniform(1.0, 2.0), Free)?.with_gravity(9.81);
    /// let strut = Strut::to_ground((0, [1.0, 0.0]), [1.0, 0.5]).with_stiffness(40.0).with_length(0.3);
    /// let [reading] = Struts::of([strut]).readings(&scene, &scene.at_rest(&[0.0_f64])?)?;
    /// assert!((reading.tension - 40.0 * 0.2).abs() < 1e-12 && (reading.energy - 0.5 * 40.0 * 0.04).abs() < 1e-12);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// Over lanes of which the ends meet in some alone, these have no rate and no tension (NaN).
    ///
    /// # Errors
    /// [`Fault::Shape`](crate::Fault::Shape) for a motion of another scene, [`Fault::NoSuchBody`](crate::Fault::NoSuchBody) and those of wrong numbers
    /// for struts of another one.
    pub fn readings<S, R, C, P>(
        &self,
        scene: &System<S, R, C, P>,
        motion: &MotionOf<S, R, C, P>,
    ) -> Result<[StrutReading<T>; N], Error>
    where
        S: Points<D, Scalar = T>,
        R: Root<S>,
        C: Element<S>,
        P: Tip<S>,
        L: Loading<S>,
    {
        scene.fits(motion)?;
        scene.loadable(self)?;
        let (sight, _) = survey(scene.elements(), scene.ground(motion.time), coordinates(motion), self);
        Ok(self.readings_at(&sight.ends))
    }
}
