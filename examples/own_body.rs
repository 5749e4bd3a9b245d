//! A body of one's own: a tank on a pendulum in which liquid sloshes.
//!
//! ```text
//! cargo run --release --example own_body
//! ```

#[path = "elements/tank.rs"]
mod tank;

use catena::extend::check_element;
use catena::loading::Unloaded;
use catena::planar::*;
use std::error::Error;
use tank::{Liquid, Tank};

fn main() -> Result<(), Box<dyn Error>> {
    // Half of the tank's mass is liquid that swings across it at 3 rad/s, were it alone.
    let spring = Spring::new(2.0 * 3.0 * 3.0).damped(0.0);
    let liquid = Liquid { mass: 2.0, place: [0.5, 0.0], direction: std::f64::consts::FRAC_PI_2, spring };
    let tank = Tank::new((2.0, 0.1, [0.5, 0.0]), liquid, [1.0, 0.0]);
    let rod = Rod::uniform(1.5, 0.5);
    let pendulum = System::new(Pinned::origin(), (rod, Weld::at(0.0), tank), Free)?.with_gravity(9.81);
    check_element(&pendulum, 10)?;

    let down = pendulum.at_rest(&[-std::f64::consts::FRAC_PI_2])?;
    let modes = pendulum.modes(&down, &Unloaded)?;
    println!("natural frequencies: {:.4?} rad/s", modes.frequencies().collect::<Vec<_>>());

    let start = pendulum.at_rest(&[-1.0])?;
    let (energy, mut drift, mut far) = (pendulum.budget(&start)?.energy(), 0.0_f64, 0.0_f64);
    pendulum.simulate(start, Dop853::tolerance(1e-13), 10.0, |now| {
        drift = drift.max((now.energy() - energy).abs());
        // Coordinates: the angle of the root's pin; in the tank, which is the third element, that of the slider in its arm.
        let (_, (_, _, (_, (slid, _), _))) = now.motion().position();
        far = far.max(slid.abs());
    })?;
    println!("the liquid moves by {far:.3} m, energy drifts by {drift:.1e} J in 10 s");
    assert!(drift < 1e-11);
    Ok(())
}
