//! The rule that chooses among rules.

use super::{Control, Rule};

/// [`Dop853`](super::Dop853), [`Vcabm`](super::Vcabm) or [`Sdirk4`](super::Sdirk4), by scene, tolerance and stiffness: for who does not
/// want to choose.
///
/// Where nothing is stiff it is `Vcabm` for scenes of seven coordinates or more (if some are turns in space, at tolerances from 1e-3 on), and
/// `Dop853` for all others.
/// How fast springs and dampers are (1/s) is found by power iteration, at most six sweeps; a scene without them is left to the rule for what
/// is not stiff. Explicit rules lead a motion by some 0.4 of the inverse in a sweep, and no more than 0.7: a run begins by `Sdirk4`, and goes
/// on by it, as long as its steps lead farther for their sixteen sweeps. Where they do not, steps that look limited by stability rather than
/// by the tolerance (by how much accelerations at the end of a step of `Dop853` differ from those of its last stage; by orders of `Vcabm` that
/// stay low) bring it on trial again, after 100 sweeps and after twice as many each time that it loses; an explicit rule is tried again after
/// 400, unless the springs are too fast for it. So vibration that nobody asked for, below the tolerance and faster than the motion, is not
/// followed from its first step on.
/// [`AutoStepper::chosen`](crate::simulate::AutoStepper::chosen) tells which rule makes the steps, during a run
/// [`Running::stepper`](crate::simulate::Running::stepper). [`Taylor`](super::Taylor) is not among them, for a scene must be known to it by
/// type: where `Taylor::<24>::knows(&scene)` compiles, that rule is quicker than all of these on pins, unless the scene is stiff.
///
/// It chooses under error control. A stepper that is told its steps takes the rule for what is not stiff.
///
/// Time of a run by the best of the three rules alone, at the same tolerance, and by this one as a multiple of that (x86-64-v3):
///
/// | scene | 1e-2 | 1e-3 | 1e-5 | 1e-7 | 1e-9 |
/// |---|---|---|---|---|---|
/// | two rods on pins, 2 s | `Dop853`, 1.07 | `Dop853`, 1.03 | `Dop853`, 1.03 | `Dop853`, 1.02 | `Dop853`, 1.01 |
/// | eight rods on pins, 0.5 s | `Vcabm`, 1.06 | `Vcabm`, 1.05 | `Vcabm`, 1.01 | `Vcabm`, 1.00 | `Vcabm`, 1.00 |
/// | twenty rods on pins, 0.5 s | `Vcabm`, 1.02 | `Vcabm`, 1.01 | `Vcabm`, 1.01 | `Vcabm`, 1.01 | `Vcabm`, 1.02 |
/// | three rods on balls, 2 s | `Vcabm`, 1.05 | `Vcabm`, 1.04 | `Dop853`, 1.02 | `Dop853`, 1.02 | `Dop853`, 1.06 |
/// | twenty rods, hinges of 20 N·m/rad, 0.5 s | `Sdirk4`, 0.91 | `Vcabm`, 1.10 | `Vcabm`, 1.04 | `Vcabm`, 1.02 | `Vcabm`, 1.02 |
/// | the same with 2000 N·m/rad | `Sdirk4`, 0.95 | `Sdirk4`, 1.01 | `Dop853`, 1.30 | `Vcabm`, 1.02 | `Vcabm`, 0.93 |
/// | four rods, damped hinges of 1e3 N·m/rad, 1 s | `Sdirk4`, 1.16 | `Sdirk4`, 0.86 | `Dop853`, 0.81 | `Dop853`, 1.04 | `Dop853`, 1.07 |
/// | the same with 1e5 N·m/rad | `Sdirk4`, 1.10 | `Sdirk4`, 1.06 | `Sdirk4`, 0.70 | `Sdirk4`, 0.48 | `Dop853`, 0.72 |
/// | twenty rods, damped hinges of 20 N·m/rad, 1 s | `Sdirk4`, 1.11 | `Sdirk4`, 0.99 | `Sdirk4`, 1.03 | `Sdirk4`, 1.00 | `Sdirk4`, 0.70 |
///
/// [`GeneralizedAlpha`](super::GeneralizedAlpha) is not among them: it is quicker on stiff scenes than all of these, and off by more than its
/// tolerance. Of twenty undamped hinges of 2000 N·m/rad it makes 38 sweeps at 1e-3, and 728 at 1e-6, and errs by 8e-4 and 3e-4 rad in the last
/// angle, for it looks at what positions are moved by alone and damps the rest; this one makes 327 at 1e-2 and errs by 6e-5, at 1e-6
/// it follows the vibration.
///
/// Where vibration dies away, implicit
/// steps at first and explicit ones later are quicker than either alone.
///
/// ```
/// use catena::planar::*;
/// use catena::simulate::Chosen;
/// let rod = Rod::uniform(0.3, 0.3);
/// let hinge = ElasticHinge::rotary(1e5).damped(6.0); // stiff
/// let chain = System::new(Pinned::origin(), (rod, [(hinge, rod); 3]), Free)?.with_gravity(9.81);
/// let start = chain.at_rest(&[-0.5; 4])?;
/// let mut run = chain.simulation(Auto::tolerance(1e-4)).begin(start, 1.0, |_| ())?;
/// run.until(0.5)?;
/// assert_eq!(run.stepper().chosen(), Chosen::Sdirk4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Auto;

impl Auto {
    /// Steps that keep the error of each within a tolerance, absolute (rad, m) and relative.
    pub fn tolerance<R>(tolerance: R) -> Rule<Self, R> {
        Rule { method: Self, control: Control::Tolerance(tolerance) }
    }
}
