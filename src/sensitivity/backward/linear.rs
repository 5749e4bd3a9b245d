//! Steps with their Jacobians.

use super::Backward;
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleRoot, ReversibleTip};
use crate::element::{Element, RealOf, Unloaded};
use crate::error::{Error, Fault, counted};
use crate::loading::EffortOf;
use crate::mirror::Rate;
use crate::relation::Additive;
use crate::system::{Dynamics, Elements, MotionOf, Runs, System};
use crate::time::Explicit;
use num_traits::{One, Zero};

impl<S, R, C, P, M, L> Backward<'_, S, R, C, P, M, L>
where
    S: Reversed,
    R: ReversibleRoot<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Explicit,
    L: BodyLaw<S>,
    Elements<S, R, C>: Reversible<S> + Burdened<S, L>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
    EffortOf<S>: Additive,
{
    /// A step of a size (s) with its Jacobians: with x the positions of all n coordinates and then their rates, u the torques in all m joints
    /// (the root's first) held over the step, A = ∂x′/∂x (2n × 2n) and B = ∂x′/∂u (2n × m), row by row. No torques stand for zeros; a list
    /// for B may be empty.
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let arm = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    /// let now = arm.at_rest(&[-1.0, -0.5])?;
    /// let (mut next, mut a, mut b) = (now, [0.0_f64; 16], [0.0; 8]);
    /// arm.backward(Rk4).linearised_step(&now, 0.01, &[0.3, -0.1], &mut next, &mut a, &mut b)?;
    /// // How the second angle after the step changes with its rate before it, and with the torque in the first joint.
    /// let (by_rate, by_torque) = (a[4 + 3], b[2]);
    /// assert!((by_rate - 0.01).abs() < 1e-4 && by_torque < 0.0);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # What it costs
    ///
    /// Each row is a costate that is pulled back through the stages of the step, which are evaluated once: with RK4 and n rods on pins
    /// 3.9, 11 and 29 to 34 plain steps for n = 2, 7 and 20 (x86-64-v3, all 2n × 3n entries, two cores shared with other work).
    ///
    /// # Errors
    /// [`Fault::Count`] for lists of another length, [`Fault::Shape`] for motions of another scene; [`Fault::NonFiniteMotion`] or
    /// [`Fault::AngleOutOfRange`].
    pub fn linearised_step(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        size: RealOf<S>,
        torques: &[EffortOf<S>],
        next: &mut MotionOf<S, R, C, P>,
        by_state: &mut [S::Scalar],
        by_torques: &mut [EffortOf<S>],
    ) -> Result<(), Error> {
        if !(self.fits(past) && self.fits(next)) {
            return Err(Error::new(Fault::Shape));
        }
        let (rows, joints) = (2 * past.rate_count(), self.steps.scene.joints());
        self.admits(1, torques.len())?;
        counted(rows * rows, by_state.len())?;
        if !by_torques.is_empty() {
            counted(rows * joints, by_torques.len())?;
        }
        self.steps.take_torques(torques, 0);
        self.steps.give_torques(&mut [], 0);
        let end = past.time + size;
        self.steps.step_to(end, past, &mut self.record, next);
        for (k, row) in by_state.chunks_exact_mut(rows.max(1)).enumerate() {
            let mut count = 0;
            let mut unit = |_| {
                count += 1;
                if count == k + 1 { S::Scalar::one() } else { S::Scalar::zero() }
            };
            let start = &mut self.scratch.start;
            start.position.replace(&mut unit);
            start.rate.replace(&mut unit);
            self.steps.pull_back(past, end - past.time, &self.record, &mut self.scratch);
            let mut entries = row.iter_mut();
            let mut put = |x| entries.next().into_iter().for_each(|entry| *entry = x);
            self.scratch.start.position.visit(&mut put);
            self.scratch.start.rate.visit(&mut put);
            self.steps.give_torques(by_torques.get_mut(k * joints..(k + 1) * joints).unwrap_or_default(), 0);
        }
        Dynamics::<Unloaded>::accept(self.steps.scene, next)
    }
}
