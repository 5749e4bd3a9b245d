//! Runs under error control, their accepted steps kept for gradients.

use super::Backward;
use super::rules::Staged;
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, RealOf, Unloaded};
use crate::ends::Root;
use crate::error::{Error, Fault};
use crate::loading::{EffortOf, LoadLaw, Seen};
use crate::mirror::Rate;
use crate::relation::Additive;
use crate::system::{Elements, MotionOf, Runs, System};
use crate::time::{Control, Explicit, Rule};

/// Efforts in all joints, or in none.
#[derive(Clone, Copy, Debug)]
pub struct Held<'t, X>(&'t [X]);

impl<M: Seen> LoadLaw<M> for Held<'_, M::Load> {
    type Value = M::Load;
    const READS: bool = false;

    #[inline(always)]
    fn at(&self, _: RealOf<M::Space>, number: usize, _: &M) -> M::Load {
        self.0.get(number).copied().unwrap_or_else(M::Load::null)
    }
    #[inline(always)]
    fn list(&self) -> &[M::Load] {
        self.0
    }
}

impl<S, R, C, P, M, L> Backward<'_, S, R, C, P, M, L>
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Explicit + Staged,
    L: BodyLaw<S>,
    Elements<S, R, C>: Reversible<S, P::Closures, M::Springs<S::Scalar>> + Burdened<S, L, P::Closures>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
{
    /// Runs to the time `end` (s) by steps that error control chooses within a tolerance, absolute and relative, and keeps the state before
    /// each of them and after the last; gives their number. `torques` are those in all joints, held over the run, or none.
    ///
    /// The gradient of such a run is that of the steps that were accepted, their sizes held: it has no part for a size that another motion
    /// would have been given.
    ///
    /// # Errors
    /// [`Fault::Count`], which says how many states are needed, once the run has come to its end, or how many torques; [`Fault::Unsupported`] for a method
    /// that does not estimate its errors, as `Rk4`; those of the run.
    pub fn run_adaptive<'t>(
        &mut self,
        start: &MotionOf<S, R, C, P>,
        tolerance: RealOf<S>,
        end: RealOf<S>,
        torques: &'t [EffortOf<S>],
        states: &mut [MotionOf<S, R, C, P>],
    ) -> Result<usize, Error>
    where
        System<S, R, C, P>: Runs<L::Whole<Held<'t, EffortOf<S>>>, S, R, C, P>,
    {
        self.admits(1, torques.len())?;
        if !(self.fits(start) && states.iter().all(|state| state.fits(start))) {
            return Err(Error::new(Fault::Shape));
        }
        if System::<S, R, C, P>::CLOSED > 0 {
            self.steps.scene.led(start)?;
        }
        let rule = Rule { method: self.method, control: Control::Tolerance(tolerance) };
        let loads = self.steps.loads.law.whole(Held(torques));
        let (mut count, mut list) = (0, states.iter_mut());
        let simulation = self.steps.scene.simulation(rule).loads(&loads);
        simulation.run(start.clone(), end, |now| {
            count += 1;
            if let Some(state) = list.next() {
                state.copy_state(now.stepped());
                state.acceleration.set(&now.stepped().acceleration);
            }
        })?;
        if count > states.len() {
            return Err(Error::new(Fault::Count { list: "states", expected: count, given: states.len() }));
        }
        Ok(count - 1)
    }
}
