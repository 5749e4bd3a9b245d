//! A humanoid whose motors are off falls: 29 joints and a floating pelvis from a description (URDF), stops that hold knees and elbows, points
//! of feet, knees, trunk, arms and head that touch the ground.
//!
//! Its joints have the description's damping, dry friction and stops as laws. Contacts are compliant, with friction. Both are taken linearly
//! implicitly, so that steps need not resolve how feet creep at rest. At the end it falls once more, by the rule for real time.
//!
//! ```text
//! cargo run --release -p catena-robots --example humanoid_falls
//! ```

#[path = "../../../examples/common/mod.rs"]
mod common;
#[path = "pictures/humanoid_falls.rs"]
mod pictures;
#[path = "shapes/humanoid.rs"]
mod shape;

use catena::robot::*;
use catena::system::MotionOf;
use catena_robots::humanoid::{self, frame as of};
use common::Drawn;
use shape::{Ground, START, ground, point, strokes};
use std::io::{IsTerminal, Write};
use std::time::Instant;

type Scene = humanoid::Scene<f64>;
type State = MotionOf<Spatial<f64>, Free, humanoid::Chain<f64>, Free>;

const STEP: f64 = 1e-3; // (s)
const END: f64 = 3.0; // (s)
/// How fast it tips over to begin with: forward and to its left (rad/s).
const TIPPING: [f64; 2] = [0.7, 0.25];

/// What is seen of an instant.
struct Sample {
    time: f64,
    /// Heights of pelvis and head (m).
    heights: [f64; 2],
    /// Of motion and place, and in what stops store (J).
    energy: f64,
    /// Force of the ground (N), upward, and how many points bear some.
    borne: (f64, usize),
    /// Joints that have gone beyond their limits.
    stopped: usize,
    frame: Vec<Vec<[f64; 3]>>,
}

fn sample(scene: &Scene, now: &State, ground: &Ground, strokes: &[Vec<(usize, [f64; 3])>]) -> Drawn<Sample> {
    let bodies = scene.body_motions(now)?;
    let at = |(body, place): (usize, [f64; 3])| {
        bodies.get(body).map_or([f64::NAN; 3], |body| body.point(place).place.into())
    };
    let forces = ground.points().iter().enumerate().map(|(k, (body, _))| {
        let body = bodies.get(*body);
        body.map_or(f64::NAN, |body| ground.force(k, body)[2])
    });
    let mut list = [0.0; 36];
    now.coordinates_into(&mut list)?;
    let beyond = |(k, q): (usize, &f64)| *q < humanoid::LOWER[k] || *q > humanoid::UPPER[k];
    Ok(Sample {
        time: now.time(),
        heights: [at(point(of::PELVIS, [0.0; 3]))[2], at(point(of::HEAD, [0.02, 0.0, 0.08]))[2]],
        energy: scene.budget(now)?.energy(),
        borne: forces.fold((0.0, 0), |(sum, count), force| (sum + force, count + usize::from(force > 0.0))),
        stopped: list[7..].iter().enumerate().filter(|joint| beyond(*joint)).count(),
        frame: strokes.iter().map(|stroke| stroke.iter().map(|point| at(*point)).collect()).collect(),
    })
}

/// It stands with its lowest point on the ground, about to tip over.
fn start(scene: &Scene, ground: &Ground) -> Drawn<State> {
    let mut now = scene.motion();
    let mut list = [0.0; 36];
    list[3] = 1.0;
    for (name, angle) in START {
        let joint = humanoid::JOINTS.iter().position(|joint| *joint == name).ok_or(name)?;
        list[7 + joint] = angle;
    }
    now.set_coordinates(&list)?;
    let bodies = scene.body_motions(&now)?;
    let height =
        |(body, place): &(usize, [f64; 3])| bodies.get(*body).map_or(f64::NAN, |body| body.point(*place).place.z);
    list[2] = -ground.points().iter().map(height).fold(f64::INFINITY, f64::min);
    now.set_coordinates(&list)?;
    let mut rates = [0.0; 35];
    // It turns about its feet.
    (rates[0], rates[1]) = (TIPPING[0] * list[2], TIPPING[1] * list[2]);
    (rates[3], rates[4]) = (-TIPPING[1], TIPPING[0]);
    now.set_rates(&rates)?;
    Ok(now)
}

fn main() -> Drawn {
    let (scene, ground, strokes) = (humanoid::scene::<f64>()?, ground(), strokes());
    let mut now = start(&scene, &ground)?;
    let mut next = now;
    let mass: f64 = scene.body_motions(&now)?.iter().map(|body| body.inertia.mass).sum();
    let loads = Loads::none().on_bodies_by(ground);
    let mut log = vec![sample(&scene, &now, &ground, &strokes)?];
    let (mut stepper, started, mut worked) = (scene.stepper(Sdirk4::new()), Instant::now(), 0.0);
    let steps = (END / STEP).round() as usize;
    let (mut told, terminal) = (0, std::io::stderr().is_terminal());
    for step in 1..=steps {
        let begun = started.elapsed().as_secs_f64();
        stepper.step(&now, &loads, STEP, &mut next)?;
        worked += started.elapsed().as_secs_f64() - begun;
        core::mem::swap(&mut now, &mut next);
        log.push(sample(&scene, &now, &ground, &strokes)?);
        if terminal && 100 * step / steps > told {
            told = 100 * step / steps;
            eprint!("\r{told:3} %");
            std::io::stderr().flush()?;
        }
    }
    if terminal {
        eprint!("\r     \r");
    }
    println!("A humanoid of {mass:.1} kg, its motors off, tips over and falls.\n");
    common::heads(&[
        ("time (s)", 8),
        ("pelvis (m)", 10),
        ("head (m)", 8),
        ("energy (J)", 10),
        ("ground / weight", 15),
        ("points down", 11),
        ("joints at stops", 15),
    ]);
    for Sample { time, heights: [pelvis, head], energy, borne: (force, points), stopped, .. } in log.iter().step_by(200)
    {
        let share = force / (9.81 * mass);
        println!("  {time:8.2}  {pelvis:10.3}  {head:8.3}  {energy:10.2}  {share:15.3}  {points:11}  {stopped:15}");
    }
    let hardest = log.iter().map(|sample| sample.borne.0).fold(0.0, f64::max) / (9.81 * mass);
    println!("\nAt most the ground pushes with {hardest:.1} times the weight.");
    println!("{END} s take {worked:.2} s, {:.0} µs a step of {:.0} ms.", 1e6 * worked * STEP / END, 1e3 * STEP);
    let (mut now, mut stepper, started) = (start(&scene, &ground)?, scene.stepper(MoreauJean), Instant::now());
    for _ in 0..steps {
        stepper.step(&now, &loads, STEP, &mut next)?;
        core::mem::swap(&mut now, &mut next);
    }
    let took = 1e6 * started.elapsed().as_secs_f64() / steps as f64;
    println!("By the rule for real time, of order one, a step takes {took:.0} µs.");
    let [pelvis, head] = log.last().map_or([f64::NAN; 2], |sample| sample.heights);
    let lowest = log.iter().flat_map(|sample| sample.heights).fold(f64::INFINITY, f64::min);
    if !(pelvis < 0.3 && head < 0.5 && lowest > 0.0) {
        return Err("it does not lie on the ground".into());
    }
    println!("{}", pictures::draw(&log)?.display());
    Ok(())
}
