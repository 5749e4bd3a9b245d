//! A gradient backward around a loop, by a central difference. Loops of every kind are in `crates/derivatives`.

use super::names::*;
use catena::Error;

/// The angle of the crank of a four-bar linkage after some steps under gravity (m/s²), and its derivative by that.
fn crank(gravity: f64) -> Result<[f64; 2], Error> {
    const STEPS: usize = 10;
    let rod = |length| Rod::uniform(length, length);
    let rocker = (RigidBody::massless([1.0, 0.0]), Pin, rod(0.9));
    let net = Network::new((Pin, rod(0.5), Pin, rod(1.2)), rocker, Pin);
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), net, Free)?.with_gravity(gravity);
    let start = scene.assembled(scene.at_rest(&[1.0, 0.3, 1.1])?, &Unloaded)?;
    let (mut backward, mut states) = (scene.backward(Rk4), [start; STEPS + 1]);
    backward.run(&start, 0.02, STEPS, &[], &mut states)?;
    let gradient = backward.gradient(&[], &states, &mut [], |step, _, by| {
        if step == STEPS { by.add(&[1.0, 0.0, 0.0], &[0.0; 3]) } else { Ok(()) }
    })?;
    Ok([states[STEPS].coordinates()[0], -gradient.by_gravity().y])
}

#[test]
fn a_four_bar_linkage_goes_backward() -> Result<(), Error> {
    let [[more, _], [_, found], [less, _]] = [crank(9.811)?, crank(9.81)?, crank(9.809)?];
    near(found, (more - less) / 2e-3, 1e-7 * found.abs());
    Ok(())
}
