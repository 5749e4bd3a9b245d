//! Samples between steps of closed scenes, near places where closures depend on each other.

use catena::Error;
use catena::planar::*;
use core::f64::consts::PI;

/// A parallelogram that becomes flat twenty times: samples keep the energy about as well as the steps they lie between.
#[test]
fn samples_of_a_parallelogram_that_is_all_but_flat_keep_its_energy() -> Result<(), Error> {
    let rod = |length| Rod::uniform(length, length);
    let chain = (rod(0.5), Pin, rod(1.0), Pin, rod(0.5));
    let scene = System::new(Pinned::origin(), chain, Pinned::at(1.0, 0.0))?.with_gravity(1.0);
    let start = scene.with_rates(scene.at_rest(&[1.0, 0.0, 1.0 + PI])?, &[6.0, 0.0, 6.0])?;
    let start = scene.assembled(start, &Unloaded)?;
    let before = scene.budget(&start)?;
    let all = before.kinetic + before.potential;
    for tolerance in [1e-6, 1e-8, 1e-12] {
        let drift = |interval: Option<f64>| -> Result<f64, Error> {
            let run = scene.simulation(Dop853::tolerance(tolerance));
            let run = if let Some(interval) = interval { run.every(interval) } else { run };
            let mut worst = 0.0_f64;
            let ended = run.run(start, 20.0, |now| worst = worst.max((now.energy() - all).abs()));
            ended.map(|_| worst).map_err(|stopped| stopped.error)
        };
        let (steps, samples) = (drift(None)?, drift(Some(0.01))?);
        println!("{tolerance:e}: energy {steps:.1e} J at steps, {samples:.1e} J at samples");
        assert!(samples < 10.0 * steps, "{tolerance:e}: {samples:e} {steps:e}");
    }
    Ok(())
}
