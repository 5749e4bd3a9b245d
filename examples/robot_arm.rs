//! An arm with six revolute joints carries a load from place to place, under two controllers, at a fixed step.
//!
//! *Computed torque* lets inverse dynamics of a model say what the accelerations take that path and feedback want. *Gravity compensation*
//! asks the model only what it takes to stand still, and leaves the rest to springs and dampers of software. The model knows nothing of
//! the load.
//!
//! ```text
//! cargo run --release --example robot_arm
//! ```

mod common;

use catena::JointNumbers;
use catena::spatial::*;
use catena::system::MotionOf;
use common::film::Film;
use common::{BLUE, Drawn, FAINT, GREEN, GREY, INK, ORANGE, blend, line};
use nalgebra::Vector3;
use std::error::Error;
use std::path::PathBuf;
use std::time::Instant;

type Hinge = Named<Revolute<f64>>;
/// Shoulder, upper arm, forearm, two links of the wrist and the hand, with what it holds.
type Chain = (
    RigidBody<f64>,
    Hinge,
    RigidBody<f64>,
    Hinge,
    RigidBody<f64>,
    Hinge,
    RigidBody<f64>,
    Hinge,
    RigidBody<f64>,
    Hinge,
    (Named<RigidBody<f64>>, PointMass<f64>),
);
/// The arm stands on a turntable.
type Turntable = Named<Hinged<[f64; 3], Rotation<f64>, f64>>;
type Arm = System<f64, Turntable, Chain, Free>;
type ArmMotion = MotionOf<Spatial<f64>, Turntable, Chain, Free>;
type Joints = [f64; 6];

const CYCLE: f64 = 1e-3; // (s)
const LEG: f64 = 1.2; // from one pose to the next (s)
const LOAD: f64 = 0.5; // (kg)
/// Axes of the joints, each in axes of the link before it, which all coincide where all angles are zero.
const AXES: [[f64; 3]; 6] =
    [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
const NAMES: [&str; 6] = ["turntable", "shoulder", "elbow", "forearm", "wrist", "hand"];
/// Angles of the joints (rad): ready, above, at the load, across, and down.
const POSES: [Joints; 5] = [
    [0.0, -1.2, 1.6, 0.0, 0.4, 0.0],
    [0.8, -0.6, 1.3, 0.5, 0.7, -0.5],
    [0.8, -0.1, 1.0, 0.5, 0.9, -0.5],
    [-0.9, -0.9, 1.4, -0.6, 0.5, 1.0],
    [-0.9, -0.2, 1.1, 0.0, 0.8, 1.5],
];
/// Computed torque: of angle (1/s²) and rate (1/s), critically damped at 30 rad/s.
const FEEDBACK: [f64; 2] = [900.0, 60.0];
/// Gravity compensation: stiffness (N·m/rad) and damping (N·m·s/rad) of each joint.
const SPRINGS: Joints = [600.0, 900.0, 400.0, 40.0, 60.0, 15.0];
const DAMPERS: Joints = [60.0, 90.0, 35.0, 2.5, 5.0, 0.8];

/// A cylinder along the way to the next joint: way (m), radius (m), mass (kg).
fn link(way: [f64; 3], radius: f64, mass: f64) -> RigidBody<f64> {
    let way = Vector3::from(way);
    let (square, along) = (way.norm_squared(), way.normalize());
    let tensor = core::array::from_fn(|i| {
        core::array::from_fn(|k| {
            let (one, both) = (if i == k { 1.0 } else { 0.0 }, along[i] * along[k]);
            mass * (0.5 * radius * radius * both + (0.25 * radius * radius + square / 12.0) * (one - both))
        })
    });
    RigidBody::new(mass, tensor, (way * 0.5).into(), way.into())
}

fn arm(load: f64) -> Result<Arm, catena::Error> {
    let joint = |k: usize| Revolute::about(AXES[k]).named(NAMES[k]);
    let hand = (link([0.12, 0.0, 0.0], 0.04, 0.8).named("hand"), PointMass::new(0.05, load));
    let chain = (
        link([0.0, 0.0, 0.45], 0.12, 15.0),
        joint(1),
        link([0.55, 0.0, 0.0], 0.08, 9.0),
        joint(2),
        link([0.3, 0.0, 0.0], 0.07, 5.0),
        joint(3),
        link([0.2, 0.0, 0.0], 0.06, 2.5),
        joint(4),
        link([0.1, 0.0, 0.0], 0.05, 1.2),
        joint(5),
        hand,
    );
    Ok(System::new(Hinged::at([0.0; 3], AXES[0]).named(NAMES[0]), chain, Free)?.with_gravity([0.0, 0.0, -9.81]))
}

/// Angles, rates and accelerations wanted at a time: from pose to pose by polynomials of fifth degree, at rest in each.
fn wanted(time: f64) -> [Joints; 3] {
    let leg = ((time / LEG) as usize).min(POSES.len() - 2);
    let s = (time / LEG - leg as f64).min(1.0);
    let way = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
    let rate = 30.0 * s * s * (1.0 - s) * (1.0 - s) / LEG;
    let second = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / (LEG * LEG);
    let step = |k: usize| POSES[leg + 1][k] - POSES[leg][k];
    let of = |factor: f64| core::array::from_fn(|k| factor * step(k));
    [core::array::from_fn(|k| POSES[leg][k] + way * step(k)), of(rate), of(second)]
}

/// Positions and rates of the joints.
fn state(motion: &ArmMotion) -> Result<[Joints; 2], catena::Error> {
    let (mut angles, mut rates) = ([0.0; 6], [0.0; 6]);
    motion.coordinates_into(&mut angles)?;
    motion.rates_into(&mut rates)?;
    Ok([angles, rates])
}

/// How torques come about.
#[derive(Clone, Copy, PartialEq)]
enum Control {
    ComputedTorque,
    GravityCompensation,
}

impl Control {
    /// Torques of the joints, from the motion of the arm as its sensors see it.
    fn torques(self, model: &Arm, joints: &[JointNumbers], motion: &ArmMotion) -> Result<Joints, Box<dyn Error>> {
        let [angles, rates] = state(motion)?;
        let [q, v, a] = wanted(motion.time());
        let mut plan = *motion;
        let mut accelerations = [0.0; 6];
        if self == Self::ComputedTorque {
            let [stiffness, damping] = FEEDBACK;
            accelerations =
                core::array::from_fn(|k| a[k] + stiffness * (q[k] - angles[k]) + damping * (v[k] - rates[k]));
        } else {
            plan.set_rates(&[0.0; 6])?;
        }
        plan.set_accelerations(&accelerations)?;

        // Inverse dynamics: −m at a joint's station is what the joint must exert ON its outboard link.
        let stations = model.stations(&plan, &Unloaded)?;
        let mut torques = [0.0; 6];
        for (k, (torque, joint)) in torques.iter_mut().zip(joints).enumerate() {
            let station = stations.joint(*joint).ok_or("every joint has a station")?;
            let axis = station.frame.turn.attitude.apply(Vector3::from(AXES[k]));
            *torque = station.torque_outboard().dot(&axis);
            if self == Self::GravityCompensation {
                *torque += SPRINGS[k] * (q[k] - angles[k]) + DAMPERS[k] * (v[k] - rates[k]);
            }
        }
        Ok(torques)
    }
}

/// What is kept of each cycle.
#[derive(Clone, Copy)]
struct Sample {
    time: f64,
    /// Places of shoulder, elbow, wrist and hand (m).
    places: [Vector3<f64>; 4],
    /// Where the hand should be (m).
    target: Vector3<f64>,
    /// Largest error of an angle (mrad).
    angle: f64,
    torques: Joints,
}

impl Sample {
    /// Distance of the hand from where it should be (mm).
    fn error(&self) -> f64 {
        1e3 * (self.places[3] - self.target).norm()
    }
}

/// The whole way under one controller, and what a cycle takes (ns).
fn run(control: Control) -> Result<(Vec<Sample>, u128), Box<dyn Error>> {
    let (real, model) = (arm(LOAD)?, arm(0.0)?);
    let cycles = (LEG * (POSES.len() - 1) as f64 / CYCLE).round() as usize;
    // Two motions to alternate between, a stepper with its workspace, and the log: cycles allocate nothing.
    let joints = NAMES.iter().map(|name| model.joint(*name)).collect::<Result<Vec<_>, _>>()?;
    let hand = real.body("hand")?.body;
    let mut past = real.at_rest(&POSES[0])?;
    let mut next = past;
    let mut stepper = real.stepper(Rk4);
    let mut log = Vec::with_capacity(cycles);
    let mut busy = 0;
    for _ in 0..cycles {
        let clock = Instant::now();
        let torques = control.torques(&model, &joints, &past)?;
        let loads = Loads::none().efforts(torques.map(|torque| Effort([torque, 0.0, 0.0])));
        stepper.step(&past, &loads, CYCLE, &mut next)?;
        std::mem::swap(&mut past, &mut next);
        busy += clock.elapsed().as_nanos();

        let [q, ..] = wanted(past.time());
        let [angles, _] = state(&past)?;
        let place = |motion: &ArmMotion| -> Option<Vector3<f64>> {
            real.body_motions(motion).ok()?.get(hand).map(|body| body.outboard().place)
        };
        let ends = real.body_motions(&past)?;
        let end = |k: usize| ends.get(k).map(|body| body.outboard().place);
        let places = [end(0), end(1), end(3), end(hand)].map(Option::unwrap_or_default);
        let off = |k: usize| (q[k] - angles[k]).abs();
        log.push(Sample {
            time: past.time(),
            places,
            target: place(&real.at_rest(&q)?).ok_or("the hand is a body")?,
            angle: 1e3 * (0..6).fold(0.0_f64, |most, k| most.max(off(k))),
            torques,
        });
    }
    Ok((log, busy / cycles as u128))
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}\n", arm(LOAD)?.describe());
    let (computed, nanoseconds) = run(Control::ComputedTorque)?;
    let (compensated, other) = run(Control::GravityCompensation)?;
    println!(
        "An arm of six joints carries {LOAD} kg that its controllers ignore: {} cycles of 1 ms, RK4\n",
        computed.len()
    );
    println!("             computed torque            gravity compensation       computed torque");
    println!("  time (s)   angle (mrad)   hand (mm)   angle (mrad)   hand (mm)   hand x, y, z (m)");
    for (one, two) in computed.iter().zip(&compensated).skip(299).step_by(300) {
        let [x, y, z]: [f64; 3] = one.places[3].into();
        println!(
            "  {:8.2}   {:12.3}   {:9.3}   {:12.3}   {:9.3}   {x:7.4} {y:7.4} {z:7.4}",
            one.time,
            one.angle,
            one.error(),
            two.angle,
            two.error()
        );
    }
    for (name, log) in [("computed torque", &computed), ("gravity compensation", &compensated)] {
        let most = log.iter().map(Sample::error).fold(0.0, f64::max);
        let mean = (log.iter().map(|sample| sample.error().powi(2)).sum::<f64>() / log.len() as f64).sqrt();
        let torque = log.iter().flat_map(|sample| sample.torques).fold(0.0_f64, |most, x| most.max(x.abs()));
        println!("{name:>22}: hand off by {most:.2} mm at most, {mean:.2} mm rms; torques to {torque:.1} N·m");
    }
    println!(
        "\nA cycle takes {nanoseconds} ns with computed torque, {other} ns with gravity compensation: control and step."
    );
    println!("Pictures: {}", draw(&computed, &compensated)?.display());
    println!("          {}", film(&computed)?.display());
    Ok(())
}

/// A place in a parallel view, from the front and above.
fn seen(p: &Vector3<f64>) -> (f64, f64) {
    (0.8 * p.y + 0.6 * p.x, p.z + 0.25 * p.y - 0.33 * p.x)
}

/// The arm from the side and its hand's way on the left; errors and torques over time on the right.
fn draw(computed: &[Sample], compensated: &[Sample]) -> Drawn<PathBuf> {
    common::picture("robot_arm", (1000, 620), |area| {
        let subtitle = format!("Six revolute joints, from pose to pose with {LOAD} kg that the controllers ignore.");
        let area = common::heading(area, "Robot arm", &subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(480.0));
        let (upper, rest) = right.split_vertically(common::pixels(277.0));
        let mut way = common::chart(&left, "The arm, seen aslant (m)", "", -0.85..1.35, -0.85..1.35)?;
        common::legend(&left, &[("wanted", GREY), ("computed", BLUE), ("compensated", ORANGE)])?;
        let poses: Vec<_> = computed.iter().step_by(200).collect();
        for (k, sample) in poses.iter().enumerate() {
            let colour = blend(FAINT, INK, 0.05 + 0.6 * (k as f64 / poses.len() as f64).powi(2));
            let points: Vec<_> = [(0.0, 0.0)].into_iter().chain(sample.places.iter().map(seen)).collect();
            common::dots(&mut way, points.iter().copied().skip(1), 2.5, colour)?;
            common::links(&mut way, points, line(colour, 1.6))?;
        }
        let thin = |log: &[Sample]| log.iter().step_by(10).copied().collect::<Vec<_>>();
        let (one, two) = (thin(computed), thin(compensated));
        common::curve(&mut way, one.iter().map(|sample| seen(&sample.target)), line(GREY, 4.0))?;
        common::curve(&mut way, two.iter().map(|sample| seen(&sample.places[3])), line(ORANGE, 1.4))?;
        common::curve(&mut way, one.iter().map(|sample| seen(&sample.places[3])), line(BLUE, 1.4))?;
        common::dots(&mut way, [(0.0, 0.0)], 5.0, INK)?;

        let end = CYCLE * computed.len() as f64;
        let most = one.iter().chain(&two).map(Sample::error).fold(0.0, f64::max);
        let mut chart = common::chart(&upper, "Error of the hand (mm)", "time (s)", 0.0..end, 0.0..1.08 * most)?;
        common::legend(&upper, &[("computed torque", BLUE), ("gravity compensation", ORANGE)])?;
        for (log, colour) in [(&one, BLUE), (&two, ORANGE)] {
            common::curve(&mut chart, log.iter().map(|sample| (sample.time, sample.error())), line(colour, 1.6))?;
        }
        let range = common::range(one.iter().flat_map(|sample| sample.torques), 0.08);
        let mut chart = common::chart(&rest, "Torques, computed (N·m)", "time (s)", 0.0..end, range)?;
        common::legend(&rest, &[("turntable", BLUE), ("shoulder", ORANGE), ("elbow", GREEN), ("wrist", GREY)])?;
        for (k, colour) in [BLUE, ORANGE, GREEN, GREY, GREY, GREY].into_iter().enumerate() {
            common::curve(&mut chart, one.iter().map(|sample| (sample.time, sample.torques[k])), line(colour, 1.4))?;
        }
        Ok(())
    })
}

/// The arm under computed torque as it moves, seen aslant.
fn film(log: &[Sample]) -> Drawn<PathBuf> {
    let frames: Vec<_> = log
        .iter()
        .step_by(24)
        .map(|now| vec![[(0.0, 0.0)].into_iter().chain(now.places.iter().map(seen)).collect()])
        .collect();
    let film = Film {
        title: "Robot arm",
        subtitle: "Computed torque carries a load that the controller ignores.",
        view: (-0.9..1.4, -0.75..1.1),
        scale: 220.0,
        seconds: [LEG * (POSES.len() - 1) as f64; 2],
        strokes: &[(BLUE, 9.0)],
        trace: (0, 4, ORANGE),
        ground: &[(0.0, 0.0)],
        floor: &[],
    };
    film.save("robot_arm_moving", &frames)
}
