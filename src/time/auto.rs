//! The rule that chooses among rules.

use super::{Control, Rule, Taylor};

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
/// type: where `Taylor::<24>::knows(&scene)` compiles, [`AutoTaylor`] chooses from it, too, and is quicker.
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

/// [`Taylor`] of orders up to `P`, [`Dop853`](super::Dop853), [`Vcabm`](super::Vcabm) or [`Sdirk4`](super::Sdirk4), by loads, scene, tolerance and stiffness: what [`Auto`] is, for
/// scenes that Taylor series know.
///
/// Where nothing is stiff it is `Vcabm` for scenes of seven coordinates or more at tolerances from 1e-3 on, and `Taylor` for all others. Under
/// efforts that are functions of time, whose series are dear, it is what `Auto` is at tolerances from 1e-10 on, and among laws that are not
/// linear, whose series are dearer, at any. Steps
/// by a series look limited by stability if the fastest spring or damper turns, or dies, by more than one in them; the race is that of `Auto`.
///
/// Time for the same error of the last coordinate, as a multiple of that of the best of `Taylor::<24>`, `Dop853`, `Vcabm` and `Sdirk4` alone
/// (x86-64-v3, all in one run of one program; `Auto` in brackets):
///
/// | scene | 1e-4 | 1e-6 | 1e-8 | 1e-10 |
/// |---|---|---|---|---|
/// | one rod on a pin, 2 s | 1.20 (1.06) | 1.04 (1.18) | 1.03 (1.30) | 1.02 (1.70) |
/// | two rods on pins, 2 s | 1.11 (1.03) | 0.97 (1.19) | 0.95 (1.41) | 0.96 (1.74) |
/// | eight rods on pins, 0.5 s | 1.18 (1.75) | 1.05 (1.62) | 1.01 (1.86) | 1.01 (2.58) |
/// | twenty rods on pins, 0.5 s | 0.75 (1.01) | 1.14 (1.01) | 1.01 (1.74) | 0.99 (1.53) |
/// | twenty rods, hinges of 20 N·m/rad, 0.5 s | | 1.09 (1.57) | 1.06 (1.75) | 1.06 (2.30) |
/// | the same with 2000 N·m/rad | | 1.05 (2.40) | 1.01 (1.37) | 1.00 (2.13) |
/// | four rods, damped hinges of 1e3 N·m/rad, 1 s | | | 0.97 (1.23) | 1.11 (1.53) |
/// | the same with 1e5 N·m/rad | | | | 0.70 (0.69) |
/// | three rods on balls, 1 s | 1.14 (1.05) | 1.05 (1.25) | 1.03 (1.21) | 1.02 (1.73) |
/// | two rods on pins, driven by sines of time | 1.02 (1.01) | 1.01 (1.01) | 1.01 (1.01) | 1.03 (1.00) |
///
/// (No figure where no tolerance gives so large an error.)
///
/// ```
/// use catena::planar::*;
/// use catena::simulate::Chosen;
/// let rod = Rod::uniform(0.5, 0.5);
/// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
/// let mut run = pendulum.simulation(AutoTaylor::<24>::tolerance(1e-9)).begin(pendulum.at_rest(&[0.0; 2])?, 1.0, |_| ())?;
/// run.until(0.5)?;
/// assert_eq!(run.stepper().chosen(), Chosen::Taylor);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AutoTaylor<const P: usize>;

impl<const P: usize> AutoTaylor<P> {
    /// Steps that keep the error of each within a tolerance, absolute (rad, m) and relative.
    pub fn tolerance<R>(tolerance: R) -> Rule<Self, R> {
        const { Taylor::<P>::KNOWN };
        Rule { method: Self, control: Control::Tolerance(tolerance) }
    }
}
