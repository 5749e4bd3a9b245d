//! A scene inside a control loop: one fixed step per cycle, torques computed anew each time, nothing on the heap.
//!
//! An arm of two links moves its hand around a circle. Its controller knows a model of the arm, itself a scene: inverse
//! dynamics of the model give the torques for the accelerations that it wants (gravity is compensated on the way). The
//! arm that is simulated carries a load of which the model knows nothing, so there is something left for the feedback.
//!
//! ```text
//! cargo run --release --example control_loop
//! ```

mod common;
#[path = "pictures/control_loop.rs"]
mod pictures;

use catena::Scalar;
use catena::loading::Unloaded;
use catena::planar::*;
use catena::simulate::{MotionIn, StepperOf};
use num_dual::Dual2_64;
use std::error::Error;
use std::f64::consts::TAU;
use std::time::Instant;

/// The arm and the model of it: the same type, other parameters.
type Arm = System<f64, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>), Free>;
/// What drives it: a torque in each joint (N·m), from the root's on.
type Torques = Loads<Absent, Values<[f64; 2]>>;
/// Motions have the shape of their scene: a coordinate for each pin, none for a rod.
type ArmMotion = MotionIn<Arm, Torques>;

const CYCLE: f64 = 1e-3; // (s)
const CYCLES: usize = 4000;
const LENGTHS: [f64; 2] = [0.7, 0.6]; // (m)
const GAINS: [f64; 2] = [225.0, 30.0]; // of angle (1/s²) and rate (1/s): critically damped at 15 rad/s

/// What is kept of each cycle.
#[derive(Clone, Copy, Default)]
struct Sample {
    time: f64,
    torques: [f64; 2],
    wanted: [f64; 2],
    elbow: [f64; 2],
    hand: [f64; 2],
}

impl Sample {
    /// Distance of the hand from where it should be (mm).
    fn error(&self) -> f64 {
        1e3 * (self.hand[0] - self.wanted[0]).hypot(self.hand[1] - self.wanted[1])
    }
}

/// The arm as its controller has it: torques go in, a motion comes out. All the room there is: a stepper and two motions to alternate between.
struct Plant {
    arm: StepperOf<Rk4, Arm, Torques>,
    now: ArmMotion,
    next: ArmMotion,
    torques: Torques,
}

impl Plant {
    fn new(arm: Arm, angles: &[f64]) -> Result<Self, catena::Error> {
        let now = arm.at_rest(angles)?;
        Ok(Self { arm: arm.into_stepper(Rk4), now, next: now, torques: Loads::none().torques([0.0; 2]) })
    }

    /// One cycle, in which torques stay as they are. A step reads one motion and writes another: one that fails loses nothing.
    fn cycle(&mut self, torques: [f64; 2]) -> Result<(), catena::Error> {
        self.torques = Loads::none().torques(torques);
        self.arm.step(&self.now, &self.torques, CYCLE, &mut self.next)?;
        std::mem::swap(&mut self.now, &mut self.next);
        Ok(())
    }
}

/// An arm that holds a load (kg) in its hand, which adds a point mass at the end of its second rod.
fn arm(load: f64) -> Result<Arm, catena::Error> {
    let ([upper, fore], mass) = (LENGTHS, 1.5);
    let centre = (0.5 * mass + load) * fore / (mass + load);
    let about_centre = mass * fore * fore / 12.0 + mass * load / (mass + load) * (0.5 * fore).powi(2);
    let forearm = Rod::new(fore, mass + load, centre, about_centre);
    Ok(System::new(Pinned::origin(), (Rod::uniform(upper, 2.0), Pin, forearm), Free)?.with_gravity(9.81))
}

/// Where the hand should be: on a circle that it goes around in two seconds.
fn target<T: Scalar<Real = f64>>(time: T) -> [T; 2] {
    let (sine, cosine) = time.scale(TAU / 2.0).sin_cos();
    [T::literal(0.75) + cosine.scale(0.3), T::literal(0.2) + sine.scale(0.3)]
}

/// The absolute angles of both links that bring the hand to a place, elbow down.
fn reach<T: Scalar<Real = f64>>([x, y]: [T; 2]) -> [T; 2] {
    let [upper, fore] = LENGTHS;
    let cosine = (x * x + y * y - T::literal(upper * upper + fore * fore)).scale(0.5 / (upper * fore));
    let sine = (T::one() - cosine * cosine).sqrt();
    let first = y.atan2(x) - sine.scale(fore).atan2(cosine.scale(fore) + T::literal(upper));
    [first, first + sine.atan2(cosine)]
}

/// The torques that should make the arm follow: feedback chooses accelerations, inverse dynamics say what they take.
fn control(model: &Arm, motion: &ArmMotion) -> Option<[f64; 2]> {
    // On numbers that carry two derivatives, the way to the angles gives their rates and accelerations as well.
    let wanted = reach(target(Dual2_64::from_re(motion.time()).derivative()));
    let [stiffness, damping] = GAINS;
    let follow =
        |want: Dual2_64, angle: f64, rate: f64| want.v2 + stiffness * (want.re - angle) + damping * (want.v1 - rate);

    let (first, ((), second, ())) = *motion.position();
    let (first_rate, ((), second_rate, ())) = *motion.rate();
    let mut plan = *motion;
    *plan.acceleration_mut() = (follow(wanted[0], first, first_rate), ((), follow(wanted[1], second, second_rate), ()));

    // A torque in a joint acts on its outboard body, and is −m at the joint's station.
    let stations = model.stations(&plan, &Unloaded).ok()?;
    Some([-stations.root().internal.torque, -stations.get(1)?.internal.torque])
}

fn main() -> Result<(), Box<dyn Error>> {
    let (real, model) = (arm(0.1)?, arm(0.0)?);

    let mut plant = Plant::new(real.clone(), &reach([0.95, 0.15]))?;
    let mut log = vec![Sample::default(); CYCLES];

    let clock = Instant::now();
    for sample in &mut log {
        let torques = control(&model, &plant.now).ok_or("the model has two joints")?;
        plant.cycle(torques)?;

        let Plant { now, torques: loads, .. } = &plant;
        let stations = real.stations(now, loads)?;
        let elbow = stations.get(1).ok_or("station 1 is the elbow")?.frame.place.into();
        let hand = stations.tip().frame.place.into();
        *sample = Sample { time: now.time(), torques, wanted: target(now.time()), elbow, hand };
    }
    let nanoseconds = clock.elapsed().as_nanos() / CYCLES as u128;

    println!("A two-link arm follows a circle: {CYCLES} cycles of {} ms, RK4\n", CYCLE * 1e3);
    let places = [("time (s)", 8), ("target x (m)", 12), ("y (m)", 8), ("hand x (m)", 12), ("y (m)", 8)];
    let others = [("error (mm)", 10), ("shoulder (N·m)", 14), ("elbow (N·m)", 11)];
    common::heads(&[&places[..], &others].concat());
    for sample in log.iter().skip(249).step_by(250) {
        let Sample { time, torques: [shoulder, elbow], wanted: [wx, wy], hand: [x, y], .. } = sample;
        let error = sample.error();
        println!("  {time:8.2}  {wx:12.4}  {wy:8.4}  {x:12.4}  {y:8.4}  {error:10.3}  {shoulder:14.3}  {elbow:11.3}");
    }
    println!("\nA cycle takes {nanoseconds} ns: control, step and readings.");
    println!("Picture: {}", pictures::draw(&log)?.display());
    Ok(())
}
