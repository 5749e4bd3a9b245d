//! Joints with dry friction that move as drives and closures say, whatever rubs: they slip on where their rates pass zero.

use super::drive::Running;
use super::{EventFunction, Now};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::mirror::{Mode, Position};
use crate::scalar::{Real, Scalar};
use crate::stepper::Stepper;
use crate::system::{Dynamics, MotionOf, Runs, System};
use num_traits::Zero;

impl<'a, S, R, C, P, L, M, E, K, O> Running<'a, S, R, C, P, L, M, E, K, O>
where
    S: Space,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    L: Loading<S>,
    System<S, R, C, P>: Runs<L, S, R, C, P>,
    K: Stepper<&'a System<S, R, C, P>, L>,
    E: for<'n> EventFunction<Now<'n, S, R, C, P, L>, S::Scalar>,
    O: FnMut(&Now<'_, S, R, C, P, L>),
{
    /// Lets joints slip that stick where closures leave nothing free to, if friction of either sign leaves them the same acceleration: the way that
    /// this goes. Gives whether there are such joints.
    pub(super) fn slip_as_prescribed(&mut self) -> bool {
        let [Some(mut forward), Some(mut back)] = [Mode::SlipsForward, Mode::SlipsBack].map(|mode| self.slipping(mode))
        else {
            return false;
        };
        let (mut joint, mut found) = (0, false);
        while let Some((mode, rate, _)) = Self::joint(&mut self.next, joint) {
            let [a, b] = [&mut forward, &mut back]
                .map(|motion| Self::joint(motion, joint).map_or(f64::NAN, |(.., told)| told.rate.real().as_f64()));
            let near = Mode::reluctance::<RealOf<S>>().as_f64() * (1.0 + a.abs() + b.abs());
            if mode == Mode::Sticks && rate.real().is_zero() && (a - b).abs() <= near {
                self.set_mode(joint, if a < 0.0 { Mode::SlipsBack } else { Mode::SlipsForward });
                found = true;
            }
            joint += 1;
        }
        found
    }

    /// What is next if all joints that stick slipped one way, with the accelerations that follow.
    fn slipping(&self, slips: Mode) -> Option<MotionOf<S, R, C, P>> {
        let (system, mut motion) = (self.plan.system, self.next.clone());
        motion.position.each_mode(&mut motion.rate, &motion.acceleration, &mut |mode, _, _| {
            if *mode == Mode::Sticks {
                *mode = slips;
            }
        });
        system.accelerate(&mut motion, self.plan.loads, &mut Dynamics::<L>::workspace(system)).ok()?;
        Some(motion)
    }
}
