//! A change of mode of a run, made once more from a motion that differs from that before it by derivatives alone.

use super::{EventFunction, Now, Progress, Simulation};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::stepper::{Method, Stepper};
use crate::system::{Dynamics, MotionOf, Runs, System};
use num_traits::Zero;

/// When modes of joints change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Change<R> {
    /// Where a run begins.
    Begins,
    /// Where a step of a size (s) ends.
    Ends(R),
    /// Where a step of a size (s) begins.
    Goes(R),
}

impl<'a, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L: Loading<S>, M, E> Simulation<'a, S, R, C, P, L, M, E>
where
    System<S, R, C, P>: Runs<L, S, R, C, P>,
    M: Method<&'a System<S, R, C, P>, L>,
    E: for<'n> EventFunction<Now<'n, S, R, C, P, L>, S::Scalar>,
{
    /// The motion after a change of mode, by that before it and that in which the step began that ends there.
    ///
    /// # Errors
    /// Those of the run, and of its derivatives.
    pub(crate) fn changed(
        self,
        change: Change<RealOf<S>>,
        began: &MotionOf<S, R, C, P>,
        before: MotionOf<S, R, C, P>,
    ) -> Result<MotionOf<S, R, C, P>, Error> {
        let (system, loads) = (self.system, self.loads);
        let (from, size) = match change {
            Change::Begins => (before.clone(), Zero::zero()),
            Change::Ends(size) => (began.clone(), size),
            Change::Goes(size) => (before.clone(), size),
        };
        let (end, progress) = (from.time, Progress::at(from.time, size));
        let mut run = self.running(from, end, |_: &Now<'_, S, R, C, P, L>| (), progress);
        system.accelerate(&mut run.past, loads, &mut Dynamics::<L>::workspace(system))?;
        match change {
            Change::Begins => {
                run.next = run.past.clone();
                run.begin_modes()?;
            }
            Change::Ends(size) => {
                let memory = run.stepper.memory();
                run.make_anew(&memory, size)?;
                run.next = before;
                run.switch(|run, due| run.pace(due, size))?;
            }
            Change::Goes(size) => run.let_go(size)?,
        }
        Ok(run.next)
    }
}
