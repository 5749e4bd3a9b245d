//! A law of one's own in a joint: the spring of a light switch, which drives its lever away from the middle to either side. How hard
//! must one push?
//!
//! ```text
//! cargo run --release --example own_law
//! ```

mod common;

use catena::Fault;
use catena::planar::*;
use common::{BLUE, Drawn, GREY, INK, ORANGE, line};
use std::error::Error;
use std::path::PathBuf;

/// τ = k φ (1 − φ² / a²) − c φ̇: no torque in the middle and at ±a, where the lever rests.
#[derive(Clone, Copy, Debug)]
struct Toggle {
    /// Stiffness k (N·m/rad), where the lever rests a (rad), friction c (N·m·s/rad).
    stiffness: f64,
    rest: f64,
    friction: f64,
}

impl SpringLaw<f64> for Toggle {
    fn force(&self, angle: f64, rate: f64) -> f64 {
        let share = angle / self.rest;
        self.stiffness * angle * (1.0 - share * share) - self.friction * rate
    }
    // What implicit rules, equilibrium and modes know of it: how its torque falls with angle and with rate.
    fn pivot(&self, angle: f64, _: f64, springs: impl Springs<f64>) -> f64 {
        let share = angle / self.rest;
        springs.pivot(self.stiffness * (3.0 * share * share - 1.0), self.friction)
    }
    fn energy(&self, angle: f64) -> f64 {
        let share = angle / self.rest;
        self.stiffness * angle * angle * (0.25 * share * share - 0.5)
    }
    fn check(&self) -> Result<(), Fault> {
        if self.rest > 0.0 { Ok(()) } else { Err(Fault::Negative { parameter: "rest", value: self.rest }) }
    }
}

/// The lever: a rod of 3 cm and 5 g. Spring and friction of its hinge.
const LEVER: [f64; 2] = [0.03, 5e-3];
const TOGGLE: Toggle = Toggle { stiffness: 0.02, rest: 0.35, friction: 1e-4 };
/// How long a finger pushes (s), and how long is looked at.
const PUSH: f64 = 0.02;
const END: f64 = 0.3;

/// A push and what came of it: angles (rad) and rates (rad/s) over time (s).
struct Record {
    torque: f64,
    points: Vec<(f64, f64, f64)>,
    sweeps: [usize; 2],
    apart: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let [length, mass] = LEVER;
    let chain = (ElasticHinge::with(TOGGLE), Rod::uniform(length, mass));
    let switch = System::new(Clamped::at(0.0, 0.0, 0.0), chain, Free)?; // it hangs on a wall: gravity is along its axis

    // Three rests, of which the middle one is none that lasts. At the others the slope is 2 k, and ω² = 2 k / I.
    common::heads(&[("rest (rad)", 10), ("energy (mJ)", 11), ("frequency (rad/s)", 17), ("by hand (rad/s)", 15)]);
    for (guess, slope) in [(-0.3, 2.0), (0.001, -1.0), (0.3, 2.0)] {
        let rest = switch.equilibrium(switch.at_rest(&[guess])?, &Unloaded)?;
        let [angle, energy] =
            [switch.angles(&rest)?.get(0).copied().unwrap_or(f64::NAN), switch.budget(&rest)?.energy()];
        let frequency = switch.modes(&rest, &Unloaded)?.frequencies().next().unwrap_or(f64::NAN);
        let square = slope * TOGGLE.stiffness / (mass * length * length / 3.0);
        let by_hand = square.abs().sqrt().copysign(square); // what departs is written as negative
        println!("  {angle:10.4}  {:11.4}  {frequency:17.6}  {by_hand:15.6}", 1e3 * energy);
    }

    println!();
    common::heads(&[
        ("push (N·mm)", 11),
        ("farthest (rad)", 14),
        ("ends at (rad)", 13),
        ("sweeps, DOP853", 14),
        ("SDIRK4", 8),
        ("differ by (rad)", 15),
    ]);
    let mut records = vec![];
    for torque in [2e-3, 3e-3, 4e-3, 5e-3, 6e-3, 8e-3] {
        let finger = Loads::none().in_joints(
            |time: f64, joint, _: &JointMotion<f64>| {
                if joint == 1 && time < PUSH { torque } else { 0.0 }
            },
        );
        // From one side; the push ends at a step, for what jumps is not to be stepped over.
        let start = switch.at_rest(&[-TOGGLE.rest])?;
        let mut points = vec![];
        let mut keep = |time, position: (f64, ()), rate: (f64, ())| points.push((time, position.0, rate.0));
        let explicit = Dop853::tolerance(1e-10);
        let pushed = switch.simulation(explicit).loads(&finger).every(2e-4).run(start, PUSH, |now| {
            let (position, rate) = (now.motion().position(), now.motion().rate());
            keep(now.time(), position.1, rate.1);
        })?;
        let freed = switch.simulation(explicit).every(2e-4).run(pushed.motion, END, |now| {
            let (position, rate) = (now.motion().position(), now.motion().rate());
            keep(now.time(), position.1, rate.1);
        })?;
        // By an implicit rule, which takes the law's slopes.
        let first = switch.simulation(Sdirk4::new().tolerance(1e-8)).loads(&finger).run(start, PUSH, |_| ())?;
        let second = switch.simulation(Sdirk4::new().tolerance(1e-8)).run(first.motion, END, |_| ())?;
        let apart = second.motion.coordinates()[0] - freed.motion.coordinates()[0];
        let sweeps = [pushed.sweeps + freed.sweeps, first.sweeps + second.sweeps];
        records.push(Record { torque, points, sweeps, apart });
    }
    for Record { torque, points, sweeps: [one, other], apart } in &records {
        let farthest = points.iter().map(|point| point.1).fold(f64::MIN, f64::max);
        let end = points.last().map_or(f64::NAN, |point| point.1);
        println!("  {:11.1}  {farthest:14.4}  {end:13.4}  {one:14}  {other:8}  {apart:15.0e}", 1e3 * torque);
    }
    println!("\nPicture: {}", draw(&records)?.display());
    Ok(())
}

/// Energy of the spring, and the way of each push through angle and rate, on the left; angles over time on the right.
fn draw(records: &[Record]) -> Drawn<PathBuf> {
    common::picture("own_law", (1000, 560), |area| {
        let subtitle = "A lever of 3 cm on a spring with two rests, pushed for 20 ms by 2 to 8 N·mm.";
        let area = common::heading(area, "A switch: how hard must one push?", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(480.0));
        let (upper, lower) = left.split_vertically(common::pixels(190.0));
        let angles = -0.6..0.6;

        let mut energy = common::chart(&upper, "Energy of the spring (mJ)", "angle (rad)", angles.clone(), -0.8..1.4)?;
        let points = (-60..=60).map(|k| 0.01 * f64::from(k)).map(|angle| (angle, 1e3 * TOGGLE.energy(angle)));
        common::curve(&mut energy, points.filter(|point| point.1 < 1.4), line(INK, 1.8))?;
        let rests = [-TOGGLE.rest, TOGGLE.rest].map(|angle| (angle, 1e3 * TOGGLE.energy(angle)));
        common::dots(&mut energy, rests, 4.0, INK)?;

        let range = common::range(records.iter().flat_map(|record| &record.points).map(|point| point.2), 0.08);
        let mut phase = common::chart(&lower, "Rate over angle (rad/s)", "angle (rad)", angles, range)?;
        let mut over = common::chart(&right, "Angle (rad)", "time (s)", 0.0..END, -0.6..0.6)?;
        common::legend(&right, &[("comes back", BLUE), ("goes over", ORANGE), ("pushed until here", GREY)])?;
        common::curve(&mut over, [(PUSH, -0.6), (PUSH, 0.6)], line(GREY, 1.0))?;
        for Record { points, .. } in records {
            let end = points.last().map_or(0.0, |point| point.1);
            let colour = if end > 0.0 { ORANGE } else { BLUE };
            common::curve(&mut phase, points.iter().map(|(_, angle, rate)| (*angle, *rate)), line(colour, 1.4))?;
            common::curve(&mut over, points.iter().map(|(time, angle, _)| (*time, *angle)), line(colour, 1.4))?;
        }
        Ok(())
    })
}
