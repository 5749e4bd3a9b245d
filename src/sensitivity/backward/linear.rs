//! Steps with their Jacobians.

use super::Backward;
use super::rules::Staged;
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, RealOf, Unloaded};
use crate::ends::Root;
use crate::error::{Error, Fault, counted};
use crate::lift::Lift;
use crate::loading::EffortOf;
use crate::mirror::{Position, Rate};
use crate::relation::{Additive, Geometry};
use crate::scalar::{Pack, Scalar};
use crate::stepper::advances;
use crate::system::{Dynamics, Elements, MotionOf, Runs, System};
use crate::walks::unspread;
use num_traits::{One, Zero};

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
    /// Makes the step that is to be linearised, where lists are as long as its Jacobians.
    fn begin_linear(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        size: RealOf<S>,
        torques: &[EffortOf<S>],
        next: &mut MotionOf<S, R, C, P>,
        (by_state, by_torques): (usize, usize),
    ) -> Result<(), Error> {
        if !(self.fits(past) && self.fits(next)) {
            return Err(Error::new(Fault::Shape));
        }
        let (rows, joints) = (2 * past.rate_count(), self.steps.scene.joints());
        advances(size)?;
        self.admits(1, torques.len())?;
        counted("derivatives by the state", rows * rows, by_state)?;
        if by_torques > 0 {
            counted("derivatives by torques", rows * joints, by_torques)?;
        }
        self.independent(past)?;
        self.steps.take_torques(torques, 0);
        self.steps.give_torques(&mut [], 0);
        self.finite(past, (size, 1), torques)?;
        self.steps.step_by(size, &self.spare, &mut self.record, next);
        Ok(())
    }

    /// A step of a size (s), whose end `next` has no accelerations but zeros, with its Jacobians: with x the positions of all n coordinates
    /// and then their rates, u the torques in all m joints (the root's first) held over the step, A = ∂x′/∂x (2n × 2n) and B = ∂x′/∂u (2n × m), row by row. No torques stand for zeros; a list
    /// for B may be empty. By `GeneralizedAlpha` it is the first of a run: what the rule remembers of steps before is no part of x.
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
    /// Where joints [follow others](crate::planar::Couplings) x has all of them, as if they were free, and a step takes what they miss along: before
    /// a Riccati equation is solved, add the columns of A by followers, times their ratios, to those by their leaders, and leave followers out.
    /// Tips that are held and loops are closed by the step, so that what misses them is gone after it.
    ///
    /// # What it costs
    ///
    /// Each row is a costate that is pulled back through the stages of the step, which are evaluated once: with RK4 and n rods on pins
    /// 5.5, 9.7 and 29.8 plain steps for n = 2, 7 and 20 (x86-64-v3, all 2n × 3n entries, two cores shared with other work). Several rows
    /// at once cost less: [`linearised_step_in_rows`](Self::linearised_step_in_rows).
    ///
    /// # Errors
    /// [`Fault::Count`] for lists of another length, [`Fault::Shape`] for motions of another scene; [`Fault::NonFiniteMotion`],
    /// [`Fault::AngleOutOfRange`], or [`Fault::NonFiniteLoad`] for torques; [`Fault::RedundantClosures`] where the step begins with a tip held twice in the same way; what the loads on
    /// bodies refuse, as in [`run`](Self::run).
    pub fn linearised_step(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        size: RealOf<S>,
        torques: &[EffortOf<S>],
        next: &mut MotionOf<S, R, C, P>,
        by_state: &mut [S::Scalar],
        by_torques: &mut [EffortOf<S>],
    ) -> Result<(), Error> {
        let (rows, joints) = (2 * past.rate_count(), self.steps.scene.joints());
        self.begin_linear(past, size, torques, next, (by_state.len(), by_torques.len()))?;
        for (k, row) in by_state.chunks_exact_mut(rows.max(1)).enumerate() {
            let mut count = 0;
            let mut unit = |_| {
                count += 1;
                if count == k + 1 { S::Scalar::one() } else { S::Scalar::zero() }
            };
            let start = &mut self.scratch.start;
            start.position.replace(&mut unit);
            start.rate.replace(&mut unit);
            self.steps.of_memory.set(&self.steps.zero);
            self.steps.pull_back(&self.spare, size, &self.record, None, &mut self.scratch);
            let mut entries = row.iter_mut();
            let mut put = |x| entries.next().into_iter().for_each(|entry| *entry = x);
            self.scratch.start.position.visit(&mut put);
            self.scratch.start.rate.visit(&mut put);
            self.steps.give_torques(by_torques.get_mut(k * joints..(k + 1) * joints).unwrap_or_default(), 0);
        }
        Dynamics::<Unloaded>::accept(self.steps.scene, next)
    }

    /// A step with its Jacobians, as [`linearised_step`](Self::linearised_step), `N` rows at a time: of a scene over
    /// [packs](Pack), all of whose numbers are the same side by side, and so are those of the motion and the torques.
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::scalar::Pack;
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let arm = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    /// let now = arm.at_rest(&[-1.0, -0.5])?.lift(Pack::<f64, 4>::of);
    /// let arm = arm.lift(Pack::<f64, 4>::of);
    /// let (mut next, mut a, mut b, torques) = (now, [0.0_f64; 16], [0.0; 8], [0.3, -0.1].map(Pack::of));
    /// arm.backward(Rk4).linearised_step_in_rows(&now, 0.01, &torques, &mut next, &mut a, &mut b)?;
    /// assert!((a[4 + 3] - 0.01).abs() < 1e-4 && b[2] < 0.0);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// With RK4, n rods on pins and four rows at a time 2.5, 3.9 and 10.2 plain steps for n = 2, 7 and 20 (x86-64-v3, two cores shared with other
    /// work). `N` is one or more, or the program does not compile.
    ///
    /// # Errors
    /// As [`linearised_step`](Self::linearised_step); [`Fault::Unsupported`] for a motion or torques of packs whose numbers differ.
    pub fn linearised_step_in_rows<T: Scalar, const N: usize>(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        size: RealOf<S>,
        torques: &[EffortOf<S>],
        next: &mut MotionOf<S, R, C, P>,
        by_state: &mut [T],
        by_torques: &mut [<EffortOf<S> as Lift<Pack<T, N>, T>>::Over],
    ) -> Result<(), Error>
    where
        S: Geometry<Scalar = Pack<T, N>>,
        EffortOf<S>: Lift<Pack<T, N>, T>,
    {
        const { assert!(N > 0, "no rows at a time") };
        let mut alike = true;
        torques.iter().for_each(|torque| {
            torque.lift(&mut |x| {
                alike &= x.is_even();
                x.0[0]
            });
        });
        past.position.visit(&mut |x| alike &= x.is_even());
        past.rate.visit(&mut |x| alike &= x.is_even());
        if !alike {
            return Err(Error::new(Fault::Unsupported { what: "rows of a step of numbers that differ side by side" }));
        }
        let (rows, joints) = (2 * past.rate_count(), self.steps.scene.joints());
        self.begin_linear(past, size, torques, next, (by_state.len(), by_torques.len()))?;
        for first in (0..rows).step_by(N) {
            let mut count = 0;
            let mut unit = |_| {
                count += 1;
                Pack(core::array::from_fn(|k| if count == first + k + 1 { T::one() } else { T::zero() }))
            };
            let start = &mut self.scratch.start;
            start.position.replace(&mut unit);
            start.rate.replace(&mut unit);
            self.steps.of_memory.set(&self.steps.zero);
            self.steps.pull_back(&self.spare, size, &self.record, None, &mut self.scratch);
            let mut column = 0;
            let mut put = |x: Pack<T, N>| {
                let list = by_state.iter_mut().skip(first * rows + column).step_by(rows);
                list.zip(x.0).for_each(|(entry, x)| *entry = x);
                column += 1;
            };
            self.scratch.start.position.visit(&mut put);
            self.scratch.start.rate.visit(&mut put);
            let mut column = 0;
            let of_torques = &mut self.steps.of_torques;
            let mut put = |torque: &mut EffortOf<S>| {
                let all = core::mem::replace(torque, EffortOf::<S>::null());
                let list = by_torques.iter_mut().skip(first * joints + column).step_by(joints.max(1));
                list.take(N).enumerate().for_each(|(k, entry)| *entry = all.lift(&mut |x| x.0[k]));
                column += 1;
            };
            unspread::each_joint(self.steps.scene.elements(), of_torques, &mut put);
        }
        Dynamics::<Unloaded>::accept(self.steps.scene, next)
    }
}
