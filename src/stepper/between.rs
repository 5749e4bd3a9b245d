//! Motions between the ends of a step, completed.

use super::MotionIn;
use crate::motion::Motion;
use crate::system::Dynamics;

/// Accelerations of a motion between steps, after its closures are closed; says how many sweeps that takes.
///
/// They are closed through gains at this motion: those of the sweep before it, a stage somewhere in the step, may be gains of a place
/// where closures depend on each other, and would throw it anywhere.
pub(super) fn complete<D: Dynamics<L>, L>(
    scene: &D,
    between: &mut MotionIn<D, L>,
    loads: &L,
    workspace: &mut D::Workspace,
) -> usize {
    let sweep = |between: &mut MotionIn<D, L>, workspace: &mut D::Workspace| {
        let Motion { time, position, rate, acceleration, multipliers } = between;
        *multipliers = scene.accelerations(*time, position, rate, loads, workspace, acceleration);
    };
    if D::CLOSED {
        sweep(between, workspace);
        scene.project(between, loads, workspace);
    }
    sweep(between, workspace);
    1 + usize::from(D::CLOSED)
}
