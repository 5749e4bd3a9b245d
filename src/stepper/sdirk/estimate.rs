//! What estimates of errors of [`Sdirk4`](crate::time::Sdirk4) add to a sum of stages, and take from it.

use super::SdirkStepper;
use crate::element::{Implicit, Reading};
use crate::mirror::{Position, Rate};
use crate::scalar::{Real, Scalar};
use crate::stepper::{MotionIn, TimeIn};
use crate::system::StiffDynamics;
use crate::time::sdirk4::{GAMMA, STAGES, TABLE};
use num_traits::Zero;

/// Accelerations of the start that differ from what stages point back to by so many times what these differ among themselves are no curve.
const KNOWN: f64 = 2.0;

impl<D: StiffDynamics<L>, L> SdirkStepper<D, L> {
    /// Adds to errors of rates what no stage sees: a load that sets in before the first of them, which all others agree with. The accelerations of the
    /// start, where the last step has ended, differ then from what the stages point back to, by more than these differ among themselves.
    pub(super) fn note_unseen(&mut self, past: &MotionIn<D, L>, dt: TimeIn<D, L>) {
        let real = TimeIn::<D, L>::of;
        let Self { slopes: [first, others @ ..], range: (least, largest), room, .. } = self;
        least.set(first);
        largest.set(first);
        for slope in others.iter() {
            least.join(slope, &mut |a, b| (b - a).if_negative(b, a));
            largest.join(slope, &mut |a, b| (b - a).if_negative(a, b));
        }
        largest.join(least, &mut |a, b| a - b);
        room.mix_3(&self.zero, (real(1.0), &past.acceleration), (real(-2.0), first), (real(1.0), &others[2]));
        let share = real(TABLE.nodes[0]) * dt;
        room.join(largest, &mut |jump, range| {
            let more = jump.abs() - range.scale(real(KNOWN));
            let unseen = more.if_negative(D::Scalar::zero(), more).scale(share);
            jump.if_negative(-unseen, unseen)
        });
        self.estimate.1.add(&self.room);
    }

    /// Takes from errors of rates what springs would not let last: of e in positions and ė in rates (1 + γ h D + γ² h² K)⁻¹ (ė − γ h K e)
    /// is left, by one more sweep of the last stage with its springs displaced by e + γ h ė (E. Hairer, G. Wanner, IV.8).
    pub(super) fn filter(&mut self, loads: &L, dt: TimeIn<D, L>, next: &MotionIn<D, L>) {
        let own = TimeIn::<D, L>::of(GAMMA) * dt;
        let springs = Implicit { position: own * own, rate: own };
        let (position, rate) = &mut self.estimate;
        self.room.mix_1(position, (own, rate));
        self.free.0.displace(&self.room);
        self.free.1.add(rate);
        if Self::FOLLOWS {
            self.at.0.displace(&self.room);
            self.at.1.add(rate);
        } else {
            self.led.set(&self.slopes[STAGES - 1]);
        }
        let (at, free) = ((&self.at.0, &self.at.1), (&self.free.0, &self.free.1));
        let reading = if Self::FOLLOWS {
            Reading { position: at.0, rate: at.1, acceleration: &self.led }
        } else {
            Reading { position: free.0, rate: free.1, acceleration: &self.zero }
        };
        self.scene.copy_gains(self.scene.gains(&self.stiff), &mut self.kept);
        let (pushed, stiff) = (&mut self.room, &mut self.stiff);
        self.scene.implicit_accelerations(next.time, at, free, reading, springs, loads, stiff, pushed);
        core::mem::swap(self.scene.gains_mut(&mut self.stiff), &mut self.kept);
        self.sweeps += 1;
        self.slopes[0].mix_2(&self.zero, (own, &self.room), (-own, &self.led));
        rate.add(&self.slopes[0]);
    }
}
