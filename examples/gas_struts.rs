//! A tailgate that its two gas struts lift: struts as loads, once in double and once in single precision.
//!
//! A gas strut is a spring so long that its force hardly changes on the way, and a damper. Both of a car push alike, so one of twice their
//! strength stands for them. What the gate comes to rest at is known otherwise: where their torque about the hinge is that of the weight.
//!
//! ```text
//! cargo run --release --example gas_struts
//! ```

mod common;

use catena::planar::*;
use catena::scalar::Real;
use common::{BLUE, Drawn, GREEN, GREY, ORANGE, line};
use std::error::Error;
use std::path::PathBuf;

/// The gate: length (m) and mass (kg), hinged to the roof; its angle from the horizontal where it is closed (rad).
const GATE: [f64; 2] = [0.9, 15.0];
const CLOSED: f64 = -1.3;
/// Where the struts hold the gate, along it from the hinge, and the car, from the hinge (m).
const HELD: f64 = 0.3;
const STANDS: [f64; 2] = [0.0, -0.45];
/// Both struts: stiffness (N/m), damping (N·s/m) and the length at which they would no longer push (m).
const STIFFNESS: f64 = 300.0;
const DAMPING: f64 = 400.0;
const LENGTH: f64 = 1.6;
const GRAVITY: f64 = 9.81; // (m/s²)
const STEP: f64 = 2e-3; // (s)
const END: f64 = 8.0; // (s)

/// What is seen at an instant: time (s), angle (rad), force of the roof on the gate (N).
struct Seen {
    time: f64,
    angle: f64,
    hinge: [f64; 2],
}

/// Lets the gate go where it is closed. Nothing in here knows how many digits its numbers have.
fn opens<T: Real>() -> Result<Vec<Seen>, Box<dyn Error>> {
    let number = T::of;
    let gate = Rod::uniform(number(GATE[0]), number(GATE[1]));
    let car = System::new(Pinned::origin(), gate, Free)?.with_gravity(number(GRAVITY));
    let strut = Strut::to_ground((0, [number(HELD), number(0.0)]), STANDS.map(number));
    let strut = strut.with_stiffness(number(STIFFNESS)).with_damping(number(DAMPING)).with_length(number(LENGTH));
    let struts = Struts::of([strut]);

    let mut motions = vec![];
    let simulation = car.simulation(Rk4::step(number(STEP))).every(number(0.05)).loads(&struts);
    simulation.run(car.at_rest(&[number(CLOSED)])?, number(END), |now| motions.push(*now.motion()))?;
    let seen = motions.iter().map(|motion| {
        let force = car.stations(motion, &struts)?.root().internal.force;
        let (angle, ()) = *motion.position();
        Ok(Seen { time: motion.time().as_f64(), angle: angle.as_f64(), hinge: [force.x.as_f64(), force.y.as_f64()] })
    });
    seen.collect()
}

/// Torque of springs and weight about the hinge (N·m), and the force of the springs (N).
fn balance(angle: f64) -> (f64, f64) {
    let held = [HELD * angle.cos(), HELD * angle.sin()];
    let along = [held[0] - STANDS[0], held[1] - STANDS[1]];
    let length = along[0].hypot(along[1]);
    let force = STIFFNESS * (LENGTH - length);
    let lever = (held[0] * along[1] - held[1] * along[0]) / length;
    (force * lever - GATE[1] * GRAVITY * 0.5 * GATE[0] * angle.cos(), force)
}

/// Where the gate rests: between closed and upright torques change their sign once.
fn rest() -> f64 {
    let [mut low, mut high] = [CLOSED, std::f64::consts::FRAC_PI_2];
    while high - low > 1e-15 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        *(if balance(middle).0 > 0.0 { &mut low } else { &mut high }) = middle;
    }
    low
}

fn main() -> Result<(), Box<dyn Error>> {
    let (double, single) = (opens::<f64>()?, opens::<f32>()?);
    println!("A tailgate of {} kg on two gas struts, let go where it is closed; RK4, steps of 2 ms\n", GATE[1]);
    common::heads(&[
        ("time (s)", 8),
        ("angle (degrees)", 15),
        ("springs (N)", 11),
        ("hinge x (N)", 11),
        ("hinge y (N)", 11),
        ("in f32, off by (degrees)", 24),
    ]);
    for (Seen { time, angle, hinge: [x, y] }, other) in double.iter().zip(&single).step_by(16) {
        let (off, force) = ((other.angle - angle).to_degrees(), balance(*angle).1);
        println!("  {time:8.2}  {:15.4}  {force:11.1}  {x:11.2}  {y:11.2}  {off:24.1e}", angle.to_degrees());
    }
    let rest = rest();
    let off = |seen: &[Seen]| seen.last().map_or(f64::NAN, |seen| (seen.angle - rest).to_degrees());
    println!(
        "\nTorques balance at {:.6} degrees. At the end the gate is off by {:.1e} degrees,",
        rest.to_degrees(),
        off(&double)
    );
    println!("in single precision by {:.1e}.", off(&single));
    println!("Picture: {}", draw(&double, rest)?.display());
    Ok(())
}

/// The gate as it opens on the left; its angle and the force of the struts over time on the right.
fn draw(seen: &[Seen], rest: f64) -> Drawn<PathBuf> {
    common::picture("gas_struts", (1000, 560), |area| {
        let subtitle = "15 kg, hinged to the roof, and two gas struts that stand on the car: it opens by itself.";
        let area = common::heading(area, "A tailgate on gas struts", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(480.0));
        let (upper, lower) = right.split_vertically(common::pixels(247.0));
        let mut places = common::chart(&left, "Every 0.2 s of the first 2 s (m)", "", -0.35..1.05, -1.0..0.5)?;
        common::legend(&left, &[("gate", BLUE), ("struts", GREY)])?;
        for Seen { angle, .. } in seen.iter().take(41).step_by(4) {
            let at = |far: f64| (far * angle.cos(), far * angle.sin());
            common::links(&mut places, vec![(STANDS[0], STANDS[1]), at(HELD)], line(GREY, 1.5))?;
            common::links(&mut places, vec![(0.0, 0.0), at(GATE[0])], line(BLUE, 3.0))?;
        }
        let angles = seen.iter().map(|seen| (seen.time, seen.angle.to_degrees()));
        let mut chart = common::chart(&upper, "Angle (degrees)", "time (s)", 0.0..END, -85.0..35.0)?;
        common::legend(&upper, &[("gate", BLUE), ("where torques balance", GREEN)])?;
        common::curve(&mut chart, [(0.0, rest.to_degrees()), (END, rest.to_degrees())], line(GREEN, 1.2))?;
        common::curve(&mut chart, angles, line(BLUE, 1.8))?;
        let forces: Vec<_> = seen.iter().map(|seen| (seen.time, balance(seen.angle).1)).collect();
        let range = common::range(forces.iter().map(|(_, force)| *force), 0.1);
        let mut chart = common::chart(&lower, "Springs of the struts (N)", "time (s)", 0.0..END, range)?;
        common::curve(&mut chart, forces, line(ORANGE, 1.8))
    })
}
