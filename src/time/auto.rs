//! The rule that chooses among rules.

use super::{Control, Rule};

/// [`Dop853`](super::Dop853), [`Vcabm`](super::Vcabm) or [`Sdirk4`](super::Sdirk4), by scene, tolerance and stiffness: for who does not
/// want to choose.
///
/// Where nothing is stiff it is `Vcabm` for scenes of eight coordinates or more, none of them a turn in space, and `Dop853` for all others.
/// Steps that look limited by stability rather than by the tolerance (by how much accelerations at the end of a step of `Dop853` differ from
/// those of its last stage; by orders of `Vcabm` that stay low) bring `Sdirk4` on trial: the rule that leads the motion farther a sweep is
/// kept. The one that has lost is tried again after 400 sweeps, and after twice as many each time that it loses again.
/// [`AutoStepper::chosen`](crate::simulate::AutoStepper::chosen) tells which rule makes the steps, during a run
/// [`Running::stepper`](crate::simulate::Running::stepper). [`Taylor`](super::Taylor) is not among them, for a scene must be known to it by
/// type: where `Taylor::<24>::knows(&scene)` compiles, that rule is quicker than all of these on pins, unless the scene is stiff.
///
/// It chooses under error control. A stepper that is told its steps takes the rule for what is not stiff.
///
/// Time of a run by the best of the three rules alone, at the same tolerance, and by this one as a multiple of that (x86-64-v3):
///
/// | scene | 1e-3 | 1e-5 | 1e-7 | 1e-9 |
/// |---|---|---|---|---|
/// | two rods on pins, 2 s | `Dop853`, 1.01 | `Dop853`, 1.00 | `Dop853`, 1.01 | `Dop853`, 1.00 |
/// | twenty rods on pins, 0.5 s | `Vcabm`, 1.04 | `Vcabm`, 1.03 | `Vcabm`, 1.03 | `Vcabm`, 1.03 |
/// | three rods on balls, 2 s | `Vcabm`, 1.27 | `Dop853`, 1.01 | `Dop853`, 1.01 | `Dop853`, 1.01 |
/// | four rods, damped hinges of 1e3 N·m/rad, 1 s | `Sdirk4`, 1.23 | `Dop853`, 1.06 | `Dop853`, 1.13 | |
/// | the same with 1e5 N·m/rad | `Sdirk4`, 1.38 | `Sdirk4`, 0.78 | `Sdirk4`, 0.59 | |
/// | twenty rods, damped hinges of 20 N·m/rad, 1 s | `Sdirk4`, 1.31 | `Sdirk4`, 1.14 | `Sdirk4`, 1.06 in sweeps, up to 2.35 in time on a busy machine | |
///
/// Runs of less than a thousand sweeps lose most: a rule must make some steps before it can be judged. Where vibration dies away, implicit
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
