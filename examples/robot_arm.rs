//! An arm with six revolute joints carries a load from place to place, under two controllers, at a fixed step.
//!
//! *Computed torque* lets inverse dynamics of a model say what the accelerations take that path and feedback want. *Gravity compensation*
//! asks the model only what it takes to stand still, and leaves the rest to springs and dampers of software. The model knows nothing of
//! the load.
//!
//! ```text
//! cargo run --release --example robot_arm
//! ```

#[path = "common/arm.rs"]
mod arm;
mod common;
#[path = "pictures/robot_arm.rs"]
mod pictures;

use arm::{AXES, Arm, ArmMotion, Joints, LEG, NAMES, POSES, arm, state, wanted};
use catena::JointNumbers;
use catena::spatial::*;
use nalgebra::Vector3;
use std::error::Error;
use std::time::Instant;

const CYCLE: f64 = 1e-3; // (s)
const LOAD: f64 = 0.5; // (kg)
/// Computed torque: of angle (1/s²) and rate (1/s), critically damped at 30 rad/s.
const FEEDBACK: [f64; 2] = [900.0, 60.0];
/// Gravity compensation: stiffness (N·m/rad) and damping (N·m·s/rad) of each joint.
const SPRINGS: Joints = [600.0, 900.0, 400.0, 40.0, 60.0, 15.0];
const DAMPERS: Joints = [60.0, 90.0, 35.0, 2.5, 5.0, 0.8];

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
        let wanted = real.at_rest(&q)?;
        let (ends, aims) = (real.body_motions(&past)?, real.body_motions(&wanted)?);
        let end = |k: usize| ends.get(k).map(|body| body.outboard().place);
        let places = [end(0), end(1), end(3), end(hand)].map(Option::unwrap_or_default);
        log.push(Sample {
            time: past.time(),
            places,
            target: aims.get(hand).map(|body| body.outboard().place).unwrap_or_default(),
            angle: 1e3 * (0..6).fold(0.0_f64, |most, k| most.max((q[k] - angles[k]).abs())),
            torques,
        });
    }
    Ok((log, busy / cycles as u128))
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{}\n", arm(LOAD)?.describe());
    let (computed, nanoseconds) = run(Control::ComputedTorque)?;
    let (compensated, other) = run(Control::GravityCompensation)?;
    let cycles = computed.len();
    println!("An arm of six joints carries {LOAD} kg that its controllers ignore: {cycles} cycles of 1 ms, RK4\n");
    println!("             computed torque            gravity compensation       computed torque");
    println!("  time (s)   angle (mrad)   hand (mm)   angle (mrad)   hand (mm)   hand x, y, z (m)");
    for (one, two) in computed.iter().zip(&compensated).skip(299).step_by(300) {
        let [x, y, z]: [f64; 3] = one.places[3].into();
        let ([a, b], [c, d]) = ([one, two].map(|sample| sample.angle), [one, two].map(Sample::error));
        println!("  {:8.2}   {a:12.3}   {c:9.3}   {b:12.3}   {d:9.3}   {x:7.4} {y:7.4} {z:7.4}", one.time);
    }
    for (name, log) in [("computed torque", &computed), ("gravity compensation", &compensated)] {
        let most = log.iter().map(Sample::error).fold(0.0, f64::max);
        let mean = (log.iter().map(|sample| sample.error().powi(2)).sum::<f64>() / log.len() as f64).sqrt();
        let torque = log.iter().flat_map(|sample| sample.torques).fold(0.0_f64, |most, x| most.max(x.abs()));
        println!("{name:>22}: hand off by {most:.2} mm at most, {mean:.2} mm rms; torques to {torque:.1} N·m");
    }
    println!("\nA cycle takes {nanoseconds} ns with computed torque, {other} ns with gravity compensation.");
    println!("Pictures: {}", pictures::draw(&computed, &compensated)?.display());
    println!("          {}", pictures::film(&computed)?.display());
    Ok(())
}
