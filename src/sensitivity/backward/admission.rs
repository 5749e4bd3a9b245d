//! What runs and gradients are handed: states, starts and torques that fit the scene.

use super::Backward;
use super::rules::Staged;
use super::steps::Steps;
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip, Ties};
use crate::element::{Element, RealOf, Unloaded};
use crate::ends::Root;
use crate::error::{Error, Fault, Place, counted};
use crate::loading::{EffortOf, Loading};
use crate::mirror::{Position, Rate};
use crate::relation::{Absent, Part};
use crate::release::Release;
use crate::scalar::Real;
use crate::simulate::limits;
use crate::space::Space;
use crate::system::{Dynamics, Elements, MotionOf, PositionOf, Runs, System, coordinates};
use crate::time::Control;
use crate::visit::Watch;
use crate::walks::fits::fits;
use crate::walks::travel::show;

impl<S, R, C, P, M, L> Backward<'_, S, R, C, P, M, L>
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Staged,
    L: BodyLaw<S>,
    Elements<S, R, C>: Reversible<S, P::Closures, M::Springs<S::Scalar>> + Burdened<S, L, P::Closures>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
{
    /// Refuses states of another scene or that go back in time, as those beyond the end of a run, and torques of another number; gives the last state.
    pub(super) fn check<'a>(
        &self,
        torques: &[EffortOf<S>],
        states: &'a [MotionOf<S, R, C, P>],
    ) -> Result<&'a MotionOf<S, R, C, P>, Error> {
        let Some(last) = states.last() else {
            return Err(Error::new(Fault::Count { list: "states", expected: 1, given: 0 }));
        };
        self.admits(states.len() - 1, torques.len())?;
        let fit = self.fits(last) && states.iter().all(|state| state.fits(last));
        if !fit {
            return Err(Error::new(Fault::Shape));
        }
        for pair in states.windows(2) {
            let [past, next] = pair else { continue };
            let size = (next.time - past.time).as_f64();
            // As an event leaves them, states may be at one time.
            if !(size >= 0.0 && size.is_finite()) {
                let (parameter, outside) =
                    ("time from one state to the next", "states beyond the end of a run are of none");
                let fault = Fault::OutOfRange { parameter, value: size, least: 0.0, most: f64::INFINITY, outside };
                return Err(Error::new(fault).at_time(past.time.as_f64()));
            }
        }
        Ok(last)
    }

    /// Whether a motion is one of this scene.
    pub(super) fn fits(&self, motion: &MotionOf<S, R, C, P>) -> bool {
        fits(self.steps.scene.elements(), &motion.position, &motion.rate)
    }

    /// Refuses a motion whose tip is held, or one of whose loops is closed, twice in the same way, in which runs begin, and one in which joints
    /// are not coupled as they are to be.
    pub(super) fn independent(&mut self, start: &MotionOf<S, R, C, P>) -> Result<(), Error> {
        let (ties, scene) = (self.steps.loads.law.ties(), self.steps.scene);
        let suits = ties.suits(&start.position, &start.rate);
        suits.map_err(|(fault, joint)| scene.at_joint(fault, joint).at_time(start.time.as_f64()))?;
        if const { System::<S, R, C, P>::CLOSED == 0 } {
            return Ok(());
        }
        if const { Steps::<S, R, C, P, M, L>::TIED } {
            let mut look = LookForFixedAxes(false);
            show(scene.elements(), scene.ground(start.time), coordinates(start), &mut look);
            if look.0 {
                let what = "the gradient of a run whose joints are coupled beside linear springs along fixed axes, where something is held or closed";
                return Err(Error::new(Fault::Unsupported { what }));
            }
        }
        self.spare.copy_state(start);
        scene.accelerate(&mut self.spare, &Unloaded, &mut scene.workspace())
    }

    /// Refuses a start and torques of steps of a size (s) that make no run: what [`independent`](Self::independent) refuses, a start that steps
    /// would not close but by a jump, numbers that are none, and steps that the clock rounds away.
    pub(super) fn begins(
        &mut self,
        start: &MotionOf<S, R, C, P>,
        (step, steps): (RealOf<S>, usize),
        torques: &[EffortOf<S>],
    ) -> Result<(), Error> {
        let end = start.time + step * RealOf::<S>::of(steps as f64);
        limits::check([start.time, end], Control::Fixed(step), None, None)?;
        self.independent(start)?;
        self.finite(start, (step, steps), torques)?;
        if const { System::<S, R, C, P>::CLOSED == 0 } {
            return Ok(());
        }
        let scene = self.steps.scene;
        scene.nearly_closed::<Unloaded>(start, &Unloaded, &mut scene.workspace())
    }

    /// Refuses a start, and torques of steps of a size (s) from there, that are no numbers.
    pub(super) fn finite(
        &mut self,
        start: &MotionOf<S, R, C, P>,
        (size, steps): (RealOf<S>, usize),
        torques: &[EffortOf<S>],
    ) -> Result<(), Error> {
        let (scene, joints) = (self.steps.scene, self.steps.scene.joints());
        // Accelerations of a start are not read.
        self.spare.copy_state(start);
        self.spare.acceleration.set(&self.steps.zero);
        Dynamics::<Unloaded>::accept(scene, &self.spare)?;
        let Some(number) = torques.iter().take(steps.saturating_mul(joints)).position(|torque| !torque.is_finite())
        else {
            return Ok(());
        };
        let place = scene.joint(number % joints)?.station.map_or(Place::Root, Place::Station);
        let time = start.time + size * RealOf::<S>::of((number / joints) as f64);
        Err(Error::new(Fault::NonFiniteLoad).at(place).at_time(time.as_f64()))
    }

    /// Refuses what [`suits`](Self::suits) does, and joints with modes, which runs past changes of mode alone know.
    pub(super) fn admits(&self, steps: usize, given: usize) -> Result<(), Error> {
        if const { PositionOf::<S, R, C>::MODES } {
            let what = "the gradient of a run whose joints have modes, but past their changes: `Backward::course`";
            return Err(Error::new(Fault::Unsupported { what }));
        }
        self.suits(steps, given)
    }

    /// Refuses lists of torques of another length, parameters that make no rule, and a law of loads that does not fit the scene.
    pub(super) fn suits(&self, steps: usize, given: usize) -> Result<(), Error> {
        self.method.fault().map_or(Ok(()), |fault| Err(Error::new(fault)))?;
        // Where such laws were read stands in the stage, but for a prediction.
        if Steps::<S, R, C, P, M, L>::FOLLOWS
            && !Steps::<S, R, C, P, M, L>::STAYS
            && M::REMEMBERS
            && System::<S, R, C, P>::CLOSED > 0
            && self.method.sweeps(1) < 2
        {
            let what = "the gradient of a run by one sweep a step where something is closed and laws are not linear";
            return Err(Error::new(Fault::Unsupported { what }));
        }
        let (bodies, joints) = (self.steps.scene.elements().bodies(), self.steps.scene.joints());
        self.steps.loads.law.ties().check(bodies, joints).map_err(Error::new)?;
        Loading::<S>::check(&self.steps.loads.law.beside(Absent), bodies, joints).map_err(Error::new)?;
        if given == 0 || given == joints {
            Ok(())
        } else {
            counted("torques of all steps (or of one, or none)", steps.saturating_mul(joints), given)
        }
    }
}

/// Looks for a joint whose coordinates move otherwise than virtual velocities do: what couplings move there puts nothing back.
struct LookForFixedAxes(bool);

impl<S: Space> Watch<S> for LookForFixedAxes {
    fn joint_with(&mut self, _: &S::JointMotion, release: &dyn Fn() -> Release<S>) {
        let release = release();
        self.0 |= release.balanced && !release.swings;
    }
}
