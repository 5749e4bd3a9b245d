//! Motions with joints where loads couple them.

use crate::element::{Element, Level, Loading, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::loading::couples;
use crate::mirror::{Position, Rate};
use crate::system::{Dynamics, MotionOf, Runs, System};
use num_traits::Zero;

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Puts joints where they are coupled, where nothing is closed, along what forces between them move.
    pub(super) fn join<L: Loading<S>>(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        loads: &L,
        workspace: &mut <Self as Dynamics<L>>::Workspace,
    ) -> Result<(), Error>
    where
        Self: Runs<L, S, R, C, P>,
    {
        if const { !couples::<S, L>() } {
            return Ok(());
        }
        let (mut responses, mut found) = (L::Responses::default(), motion.rate.clone());
        loads.accelerated(true, Some(&mut responses), &mut found, |loads, _, found| {
            self.accelerations(motion.time, &motion.position, &motion.rate, loads, workspace, found);
        });
        let mut correct = |level, motion: &MotionOf<S, R, C, P>| {
            found.replace(&mut |_| S::Scalar::zero());
            loads.rejoin(&responses, level, (&motion.position, &motion.rate), &mut found);
            found.clone()
        };
        motion.position.displace(&correct(Level::Place, motion));
        motion.rate.add(&correct(Level::Velocity, motion));
        self.joined(motion, loads, |residual| Fault::NotClosed { residual })
    }

    /// Refuses a motion whose joints could not be put where they are coupled, by a fault of what is missed.
    pub(super) fn joined<L: Loading<S>>(
        &self,
        motion: &MotionOf<S, R, C, P>,
        loads: &L,
        apart: impl FnOnce(f64) -> Fault,
    ) -> Result<(), Error> {
        self.suited(motion, loads).map_err(|error| match error.fault {
            Fault::NotAssembled { residual } => Error { fault: apart(residual), ..error },
            _ => error,
        })
    }
}
