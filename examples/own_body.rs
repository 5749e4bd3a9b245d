//! A body of one's own: a tank on a pendulum in which liquid sloshes.
//!
//! ```text
//! cargo run --release --example own_body
//! ```

mod common;
#[path = "elements/tank.rs"]
mod tank;

use catena::extend::check_element;
use catena::loading::Unloaded;
use catena::planar::*;
use common::{BLUE, Drawn, ORANGE, line};
use std::error::Error;
use std::path::PathBuf;
use tank::{Liquid, Tank};

/// How long is looked at (s).
const END: f64 = 10.0;

/// What is kept of an instant (s): angle of the pendulum (rad), how far the liquid has moved (m), by how much energy is off (J).
struct Reading {
    time: f64,
    angle: f64,
    moved: f64,
    off: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    // Half of the tank's mass is liquid that swings across it at 3 rad/s, were it alone.
    let spring = Spring::new(2.0 * 3.0 * 3.0).damped(0.0);
    let liquid = Liquid { mass: 2.0, place: [0.5, 0.0], direction: std::f64::consts::FRAC_PI_2, spring };
    let tank = Tank::new((2.0, 0.1, [0.5, 0.0]), liquid, [1.0, 0.0]);
    let rod = Rod::uniform(1.5, 0.5);
    let pendulum = System::new(Pinned::origin(), (rod, Weld::at(0.0), tank), Free)?.with_gravity(9.81);
    check_element(&pendulum, 10)?;

    let down = pendulum.at_rest(&[-std::f64::consts::FRAC_PI_2])?;
    let frequencies: Vec<_> = pendulum.modes(&down, &Unloaded)?.frequencies().collect();
    println!(
        "A tank of 2 kg with 2 kg of liquid on a pendulum of 1.5 m: natural frequencies {frequencies:.4?} rad/s\n"
    );

    let start = pendulum.at_rest(&[-1.0])?;
    let energy = pendulum.budget(&start)?.energy();
    let mut readings = vec![];
    pendulum.simulation(Dop853::tolerance(1e-13)).every(0.02).run(start, END, |now| {
        // Coordinates: the angle of the root's pin; in the tank, which is the third element, that of the slider in its arm.
        let (angle, (_, _, (_, (moved, _), _))) = *now.motion().position();
        readings.push(Reading { time: now.time(), angle, moved, off: now.energy() - energy });
    })?;
    common::heads(&[("time (s)", 8), ("angle (rad)", 11), ("liquid moved by (m)", 19), ("energy error (J)", 16)]);
    for Reading { time, angle, moved, off } in readings.iter().step_by(50) {
        println!("  {time:8.1}  {angle:11.6}  {moved:19.6}  {off:16.1e}");
    }
    // At the ends of steps energy is kept better than at samples between them.
    let mut drift = 0.0_f64;
    pendulum.simulate(start, Dop853::tolerance(1e-13), END, |now| drift = drift.max((now.energy() - energy).abs()))?;
    println!("Energy drifts by {drift:.1e} J in {END} s.");
    assert!(drift < 1e-11);
    println!("\nPicture: {}", draw(&readings)?.display());
    Ok(())
}

/// Angle of the pendulum, and where the liquid is.
fn draw(readings: &[Reading]) -> Drawn<PathBuf> {
    common::picture("own_body", (860, 520), |area| {
        let subtitle = "Half of the tank's 4 kg is liquid, which swings across it.";
        let area = common::heading(area, "A tank on a pendulum", subtitle)?;
        let (upper, lower) = area.split_vertically(common::pixels(227.0));
        let curves = [("Angle (rad)", BLUE), ("Liquid from its rest in the tank (m)", ORANGE)];
        for ((title, colour), (k, part)) in curves.into_iter().zip([(0, upper), (1, lower)]) {
            let points = readings.iter().map(|now| (now.time, [now.angle, now.moved][k]));
            let range = common::range(points.clone().map(|point| point.1), 0.08);
            let mut chart = common::chart(&part, title, "time (s)", 0.0..END, range)?;
            common::curve(&mut chart, points, line(colour, 1.8))?;
        }
        Ok(())
    })
}
