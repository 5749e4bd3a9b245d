//! Readings of a motion: bodies, stations, energy and momentum.

use crate::element::{Budget, Element, Loading, Space};
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::observe::{PerBody, Stations, budget};
use crate::space::MovingBody;
use crate::system::{Elements, MotionOf, System, coordinates};

/// A motion of another scene, or a list of loads of another length, is refused; runs, which have asked at their start, read without
/// asking again (`…_of`).
#[allow(clippy::type_complexity)] // the types are those of the scene
impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Motion of every body, in one walk outward.
    ///
    /// # Errors
    /// [`Fault::Shape`](crate::Fault::Shape) for a motion of another scene.
    #[inline]
    pub fn body_motions(
        &self,
        motion: &MotionOf<S, R, C, P>,
    ) -> Result<PerBody<'_, S, Elements<S, R, C>, S::BodyMotion>, Error> {
        self.fits(motion)?;
        Ok(self.body_motions_of(motion))
    }

    /// Orientation of every body: in the plane absolute angles (rad).
    ///
    /// # Errors
    /// [`Fault::Shape`](crate::Fault::Shape) for a motion of another scene.
    #[inline]
    pub fn angles(&self, motion: &MotionOf<S, R, C, P>) -> Result<PerBody<'_, S, Elements<S, R, C>, S::Angles>, Error> {
        self.fits(motion)?;
        Ok(self.angles_of(motion))
    }

    /// Inverse dynamics: motion, internal force and torque at every station, from positions, rates and accelerations.
    ///
    /// With the accelerations of [`with_accelerations`](Self::with_accelerations) these are the forces of the motion. With
    /// accelerations of the user's choice they are what it takes: the torque a joint must exert ON its outboard body is −m
    /// at its station; of a joint with reflected inertia I, its drive exerts I q̈ more. Where loops close or a tip is held they are so with the closure
    /// forces that the motion has, and not those of the plan: see [`loops`](crate::guide::loops).
    ///
    /// # Errors
    /// [`Fault::Shape`](crate::Fault::Shape) for a motion of another scene; [`Fault::Count`](crate::Fault::Count) and
    /// [`Fault::NoSuchBody`](crate::Fault::NoSuchBody) for loads of another one.
    #[inline]
    pub fn stations<L: Loading<S>>(
        &self,
        motion: &MotionOf<S, R, C, P>,
        loads: &L,
    ) -> Result<Stations<'_, S, Elements<S, R, C>>, Error> {
        self.fits(motion)?;
        self.loadable(loads)?;
        Ok(self.stations_of(motion, loads))
    }

    /// Energy and momentum of all bodies and of the springs in joints. That of loads, as of struts, is not in it: [`Struts::readings`] tells it.
    ///
    /// [`Struts::readings`]: crate::planar::Struts::readings
    ///
    /// # Errors
    /// [`Fault::Shape`](crate::Fault::Shape) for a motion of another scene.
    #[inline]
    pub fn budget(&self, motion: &MotionOf<S, R, C, P>) -> Result<Budget<S>, Error> {
        self.fits(motion)?;
        Ok(self.budget_of(motion))
    }

    pub(crate) fn body_motions_of(
        &self,
        motion: &MotionOf<S, R, C, P>,
    ) -> PerBody<'_, S, Elements<S, R, C>, S::BodyMotion> {
        PerBody::of(&self.chain, self.root.ground(motion.time), coordinates(motion), |body| *body)
    }

    pub(crate) fn angles_of(&self, motion: &MotionOf<S, R, C, P>) -> PerBody<'_, S, Elements<S, R, C>, S::Angles> {
        PerBody::of(&self.chain, self.root.ground(motion.time), coordinates(motion), |body| body.angles())
    }

    pub(crate) fn stations_of<L: Loading<S>>(
        &self,
        motion: &MotionOf<S, R, C, P>,
        loads: &L,
    ) -> Stations<'_, S, Elements<S, R, C>> {
        let (ground, tip) = (self.root.ground(motion.time), self.tip.internal(motion.time, &motion.multipliers));
        Stations::of(&self.chain, ground, self.gravity, coordinates(motion), motion.time, loads, tip)
    }

    pub(crate) fn budget_of(&self, motion: &MotionOf<S, R, C, P>) -> Budget<S> {
        budget(&self.chain, self.root.ground(motion.time), self.gravity, coordinates(motion))
    }
}
