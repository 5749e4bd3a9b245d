//! A humanoid whose motors are off falls: 29 joints and a floating pelvis from a description (URDF), stops that hold knees and elbows, points
//! of feet, knees, trunk, arms and head that touch the ground.
//!
//! Its joints have the description's damping, dry friction and stops as laws. Contacts are compliant, with friction. Both are taken linearly
//! implicitly, so that steps need not resolve how feet creep at rest.
//!
//! ```text
//! cargo run --release -p catena-robots --example humanoid_falls
//! ```

#[path = "../../../examples/common/mod.rs"]
mod common;

use catena::robot::*;
use catena::system::MotionOf;
use catena_robots::humanoid::{self, frame as of};
use common::camera::Camera;
use common::film::{Film, Frame};
use common::{BLUE, Drawn, GREY, ORANGE};
use std::io::{IsTerminal, Write};
use std::path::PathBuf;
use std::time::Instant;

type Scene = humanoid::Scene<f64>;
type State = MotionOf<Spatial<f64>, Free, humanoid::Chain<f64>, Free>;
type Ground = Contacts<[(usize, [f64; 3]); POINTS], Plane<f64>, Contact<f64>>;

const STEP: f64 = 1e-3; // (s)
const END: f64 = 3.0; // (s)
const POINTS: usize = 28;
/// Angles at which it begins, others are zero: knees a little bent, arms lifted to the front.
const START: [(&str, f64); 14] = [
    ("left_hip_pitch", -0.25),
    ("right_hip_pitch", -0.2),
    ("left_knee", 0.5),
    ("right_knee", 0.4),
    ("left_ankle_pitch", -0.25),
    ("right_ankle_pitch", -0.2),
    ("left_shoulder_pitch", -0.3),
    ("right_shoulder_pitch", -0.5),
    ("left_shoulder_roll", 0.25),
    ("right_shoulder_roll", -0.25),
    ("left_elbow", 0.6),
    ("right_elbow", 0.9),
    ("neck_yaw", 0.2),
    ("waist_yaw", 0.1),
];
/// How fast it tips over to begin with: forward and to its left (rad/s).
const TIPPING: [f64; 2] = [0.7, 0.25];

/// A place in axes of a frame of the description, as a body and a place in its axes. A frame of the ground has no body: contacts refuse it.
fn point(frame: humanoid::Frame, place: [f64; 3]) -> (usize, [f64; 3]) {
    let along = |row: [f64; 3]| row.iter().zip(place).map(|(a, b)| a * b).sum::<f64>();
    (frame.body.unwrap_or(usize::MAX), core::array::from_fn(|k| frame.place[k] + along(frame.turn[k])))
}

/// What can touch the ground: corners of the soles, knees, hips, back and front of the trunk, elbows, hands, head.
fn ground() -> Ground {
    let sole = |frame, x, y| point(frame, [x, y, 0.0]);
    let points = [
        sole(of::LEFT_SOLE, 0.11, 0.035),
        sole(of::LEFT_SOLE, 0.11, -0.035),
        sole(of::LEFT_SOLE, -0.08, 0.03),
        sole(of::LEFT_SOLE, -0.08, -0.03),
        sole(of::RIGHT_SOLE, 0.11, 0.035),
        sole(of::RIGHT_SOLE, 0.11, -0.035),
        sole(of::RIGHT_SOLE, -0.08, 0.03),
        sole(of::RIGHT_SOLE, -0.08, -0.03),
        point(of::LEFT_SHIN, [0.06, 0.0, 0.0]),
        point(of::RIGHT_SHIN, [0.06, 0.0, 0.0]),
        point(of::LEFT_HIP_BLOCK, [0.0, 0.06, 0.0]),
        point(of::RIGHT_HIP_BLOCK, [0.0, -0.06, 0.0]),
        point(of::PELVIS, [-0.09, 0.0, -0.06]),
        point(of::PELVIS, [0.08, 0.0, -0.04]),
        point(of::CHEST, [0.1, 0.08, 0.22]),
        point(of::CHEST, [0.1, -0.08, 0.22]),
        point(of::CHEST, [-0.09, 0.08, 0.22]),
        point(of::CHEST, [-0.09, -0.08, 0.22]),
        point(of::LEFT_SHOULDER_BLOCK, [0.0, 0.05, 0.0]),
        point(of::RIGHT_SHOULDER_BLOCK, [0.0, -0.05, 0.0]),
        point(of::LEFT_FOREARM, [-0.03, 0.0, 0.0]),
        point(of::RIGHT_FOREARM, [-0.03, 0.0, 0.0]),
        point(of::LEFT_PALM, [0.13, 0.0, 0.0]),
        point(of::RIGHT_PALM, [0.13, 0.0, 0.0]),
        point(of::HEAD, [0.1, 0.0, 0.08]),
        point(of::HEAD, [-0.08, 0.0, 0.09]),
        point(of::HEAD, [0.02, 0.07, 0.1]),
        point(of::HEAD, [0.02, -0.07, 0.1]),
    ];
    // Stiffness (N/m) that sets in over a depth (m), damping (s/m), coefficient of friction and the speed of creeping (m/s).
    Contacts::of(points, Plane::level(0.0), Contact::new(4e4, 1e-3).damped(1.5).rubbing(0.7, 1e-3))
}

/// Lines that show the robot, those farther away first, through origins of links and other points of them.
fn strokes() -> [Vec<(usize, [f64; 3])>; 8] {
    let at = |frame| point(frame, [0.0; 3]);
    let sole = |frame| [point(frame, [-0.08, 0.0, 0.0]), point(frame, [0.11, 0.0, 0.0])];
    let foot = |ankle, frame| {
        let [heel, toe] = sole(frame);
        vec![at(ankle), heel, toe, at(ankle)]
    };
    [
        vec![at(of::LEFT_HIP_BLOCK), at(of::LEFT_THIGH), at(of::LEFT_SHIN), at(of::LEFT_ANKLE_CROSS)],
        foot(of::LEFT_ANKLE_CROSS, of::LEFT_SOLE),
        vec![
            at(of::LEFT_SHOULDER_BLOCK),
            at(of::LEFT_UPPER_ARM),
            at(of::LEFT_FOREARM),
            at(of::LEFT_WRIST),
            point(of::LEFT_PALM, [0.13, 0.0, 0.0]),
        ],
        // The trunk: hips, shoulders, and back.
        vec![
            at(of::LEFT_HIP_BLOCK),
            at(of::RIGHT_HIP_BLOCK),
            at(of::WAIST_YOKE),
            at(of::CHEST),
            at(of::RIGHT_SHOULDER_BLOCK),
            at(of::LEFT_SHOULDER_BLOCK),
            at(of::CHEST),
            at(of::WAIST_YOKE),
            at(of::LEFT_HIP_BLOCK),
        ],
        vec![
            point(of::CHEST, [0.0, 0.0, 0.3]),
            at(of::HEAD),
            point(of::HEAD, [-0.08, 0.0, 0.08]),
            point(of::HEAD, [0.02, 0.0, 0.18]),
            point(of::HEAD, [0.1, 0.0, 0.08]),
            at(of::HEAD),
        ],
        vec![at(of::RIGHT_HIP_BLOCK), at(of::RIGHT_THIGH), at(of::RIGHT_SHIN), at(of::RIGHT_ANKLE_CROSS)],
        foot(of::RIGHT_ANKLE_CROSS, of::RIGHT_SOLE),
        vec![
            at(of::RIGHT_SHOULDER_BLOCK),
            at(of::RIGHT_UPPER_ARM),
            at(of::RIGHT_FOREARM),
            at(of::RIGHT_WRIST),
            point(of::RIGHT_PALM, [0.13, 0.0, 0.0]),
        ],
    ]
}

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
    let [pelvis, head] = log.last().map_or([f64::NAN; 2], |sample| sample.heights);
    let lowest = log.iter().flat_map(|sample| sample.heights).fold(f64::INFINITY, f64::min);
    if !(pelvis < 0.3 && head < 0.5 && lowest > 0.0) {
        return Err("it does not lie on the ground".into());
    }
    println!("{}", draw(&log)?.display());
    Ok(())
}

/// The robot as it falls.
fn draw(log: &[Sample]) -> Drawn<PathBuf> {
    let camera = Camera::new([1.7, -2.9, 1.25], [0.4, 0.05, 0.6]);
    let frames: Vec<Frame> = log
        .iter()
        .step_by(40)
        .map(|sample| {
            sample.frame.iter().map(|stroke| stroke.iter().map(|place| camera.sees(*place)).collect()).collect()
        })
        .collect();
    let floor = camera.floor([[-0.6, -0.8], [1.6, 1.0]], 0.2);
    let film = Film {
        title: "Humanoid",
        subtitle: "Motors off: friction and stops in 29 joints, 28 points that may touch the ground.",
        view: (-1.1..1.1, -0.85..1.15),
        scale: 270.0,
        seconds: [END; 2],
        strokes: &[
            (GREY, 6.0),
            (GREY, 4.0),
            (GREY, 5.0),
            (ORANGE, 7.0),
            (ORANGE, 6.0),
            (BLUE, 7.0),
            (BLUE, 5.0),
            (BLUE, 6.0),
        ],
        trace: (4, 1, ORANGE),
        ground: &[],
        floor: &floor,
    };
    film.save("humanoid_falls", &frames)
}
