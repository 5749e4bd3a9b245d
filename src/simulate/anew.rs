//! A change of mode of a run, made once more from a motion that differs from that before it by derivatives alone.

use super::jump::shifted;
use super::{EventFunction, Now, Progress, Simulation};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::relation::Geometry;
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

/// A motion past a change of mode, and that just before and just after at the time of the change, all of which derivatives move.
pub(crate) struct Changed<M, T> {
    pub(crate) next: M,
    pub(crate) before: M,
    pub(crate) after: M,
    /// How much later the change is than at the time found (s): by nothing but derivatives.
    pub(crate) delay: T,
}

/// A change of mode of a scene.
pub(crate) type ChangedOf<S, R, C, P> = Changed<MotionOf<S, R, C, P>, <S as Geometry>::Scalar>;

impl<'a, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L: Loading<S>, M, E> Simulation<'a, S, R, C, P, L, M, E>
where
    System<S, R, C, P>: Runs<L, S, R, C, P>,
    M: Method<&'a System<S, R, C, P>, L>,
    E: for<'n> EventFunction<Now<'n, S, R, C, P, L>, S::Scalar>,
{
    /// A change of mode, by the motion before it and that in which the step began that ends there.
    ///
    /// # Errors
    /// Those of the run, and of its derivatives.
    pub(crate) fn changed(
        self,
        change: Change<RealOf<S>>,
        began: &MotionOf<S, R, C, P>,
        before: MotionOf<S, R, C, P>,
    ) -> Result<ChangedOf<S, R, C, P>, Error> {
        let (system, loads) = (self.system, self.loads);
        let (from, size) = match change {
            Change::Begins => (before.clone(), Zero::zero()),
            Change::Ends(size) => (began.clone(), size),
            Change::Goes(size) => (before.clone(), size),
        };
        let (end, progress) = (from.time, Progress::at(from.time, size));
        let mut run = self.running(from, end, |_: &Now<'_, S, R, C, P, L>| (), progress);
        let mut workspace = Dynamics::<L>::workspace(system);
        system.accelerate(&mut run.past, loads, &mut workspace)?;
        let mut at = before.clone();
        let delay = match change {
            Change::Begins => {
                run.next = run.past.clone();
                run.begin_modes(true)?;
                Zero::zero()
            }
            Change::Ends(size) => {
                let memory = run.stepper.memory();
                run.make_anew(&memory, size)?;
                run.next = before;
                run.switch(|run, due| run.pace(due, size))?.time()
            }
            Change::Goes(size) => run.let_go(size)?.time(),
        };
        system.accelerate(&mut at, loads, &mut workspace)?;
        let (next, mut after) = (run.next.clone(), run.next);
        for motion in [&mut at, &mut after] {
            shifted(motion, delay);
        }
        Ok(Changed { next, before: at, after, delay })
    }
}
