//! An arm of seven joints from its description (URDF), driven at 1 kHz: computed torque, with friction in the model and without.
//!
//! The description's damping, dry friction and limits are laws of the joints; motors give what they can. *Computed torque* lets inverse
//! dynamics of a model say what the accelerations take that path and feedback want. One model is the scene itself, laws included; the
//! other knows masses alone. The last leg asks for more than the limit of a joint lets through, and a stop holds.
//!
//! ```text
//! cargo run --release -p catena-robots --example arm_from_urdf
//! ```

#[path = "../../../examples/common/mod.rs"]
mod common;
#[path = "pictures/arm_from_urdf.rs"]
mod pictures;

use catena::robot::*;
use catena_robots::{arm7, arm7_bare};
use common::Drawn;

type Joints = [f64; 7];

const CYCLE: f64 = 1e-3; // (s)
const LEG: f64 = 2.4; // from one pose to the next (s)
/// Angles (rad): upright, forward, across, down; and up against the elbow's stop.
const POSES: [Joints; 5] = [
    [0.0, 0.2, 0.0, 0.4, 0.0, 0.3, 0.0],
    [0.9, 0.8, 0.3, 0.9, -0.4, 0.7, 0.5],
    [-0.8, 0.9, -0.4, 1.2, 0.5, 0.4, -0.6],
    [-0.3, 1.2, 0.2, 0.6, 0.2, 1.0, 0.8],
    [0.0, 0.3, 0.0, 2.2, 0.0, 0.5, 0.0],
];
/// Of angle (1/s²) and rate (1/s), critically damped at 25 rad/s.
const FEEDBACK: [f64; 2] = [625.0, 50.0];

/// Angles, rates and accelerations wanted: polynomials of fifth degree from pose to pose, at rest in each.
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

/// What the controller believes.
#[derive(Clone, Copy, PartialEq)]
enum Model {
    WithLaws,
    Bare,
}

struct Sample {
    time: f64,
    angles: Joints,
    error: f64,
    limited: bool,
    /// The base, origins of all bodies, and the tip of the tool.
    places: Vec<[f64; 3]>,
}

fn run(model: Model) -> Result<Vec<Sample>, catena::Error> {
    let (arm, bare, motors) = (arm7::scene::<f64>()?, arm7_bare::scene::<f64>()?, arm7::motors::<f64>());
    let tip = arm7::frame::TOOL_TIP;
    let mut now = arm.at_joints(&POSES[0], &[0.0; 7])?;
    let (mut next, mut stepper, mut log) = (now, arm.stepper(Sdirk4::new()), vec![]);
    let end = LEG * (POSES.len() - 1) as f64 + 0.4;
    for cycle in 0..(end / CYCLE).round() as usize {
        let time = cycle as f64 * CYCLE;
        let (mut q, mut v) = ([0.0; 7], [0.0; 7]);
        now.coordinates_into(&mut q)?;
        now.rates_into(&mut v)?;
        let [target, rates, seconds] = wanted(time);
        let [k, d] = FEEDBACK;
        let x = core::array::from_fn(|i| seconds[i] + k * (target[i] - q[i]) + d * (rates[i] - v[i]));
        // Friction is that of the rates wanted: measured ones would feed on themselves. Stops are no part of either model.
        let laws: Joints = match model {
            Model::WithLaws => {
                let moving = core::array::from_fn(|i| target[i].clamp(arm7::LOWER[i], arm7::UPPER[i]));
                let [own, without] = [arm.bias(&moving, &rates)?, bare.bias(&moving, &rates)?];
                core::array::from_fn(|i| own[i] - without[i])
            }
            Model::Bare => [0.0; 7],
        };
        let torques = bare.inverse_dynamics(&q, &v, &x)?;
        let asked: Joints = core::array::from_fn(|i| torques[i] + laws[i]);
        let given: Joints = core::array::from_fn(|i| motors[i].map_or(asked[i], |motor| motor.torque(asked[i], v[i])));
        let bodies = arm.body_motions(&now)?;
        let mut places: Vec<[f64; 3]> = vec![[0.0; 3]];
        places.extend(bodies.iter().map(|body| <[f64; 3]>::from(body.inboard.place)));
        places.extend(
            tip.body.and_then(|body| bodies.get(body)).map(|body| <[f64; 3]>::from(body.point(tip.place).place)),
        );
        log.push(Sample {
            time,
            angles: q,
            error: (0..7).map(|i| (target[i] - q[i]).abs()).fold(0.0, f64::max),
            limited: (0..7).any(|i| (given[i] - asked[i]).abs() > 1e-9 * (1.0 + asked[i].abs())),
            places,
        });
        stepper.step(&now, &Torques(given), CYCLE, &mut next)?;
        core::mem::swap(&mut now, &mut next);
    }
    Ok(log)
}

fn main() -> Drawn {
    let logs = [run(Model::WithLaws)?, run(Model::Bare)?];
    println!("An arm of seven joints, 1 kHz: largest error of an angle in each leg (mrad).\n");
    println!("  leg     friction known   masses alone   cycles in which a motor was at its limit");
    let legs = POSES.len() - 1;
    let of = |log: &[Sample], leg: usize| {
        let own = log.iter().filter(|sample| (sample.time / LEG) as usize == leg);
        own.fold((0.0, 0), |(most, count), sample| (f64::max(most, sample.error), count + usize::from(sample.limited)))
    };
    let mut errors = vec![];
    for leg in 0..legs {
        let [(one, limited), (two, other)] = [of(&logs[0], leg), of(&logs[1], leg)];
        println!("  {}       {:12.3}   {:12.3}   {limited} {other}", leg + 1, 1e3 * one, 1e3 * two);
        errors.push([one, two]);
    }
    let elbow = arm7::joint::ELBOW;
    let highest = logs[0].iter().map(|sample| sample.angles[elbow]).fold(0.0, f64::max);
    let (asked, limit) = (POSES[legs][elbow], arm7::UPPER[elbow]);
    println!(
        "\nThe elbow is asked for {asked} rad, its limit is {limit}; the stop holds it at {highest:.4} rad at most."
    );
    if errors[..legs - 1].iter().any(|[one, two]| one.is_nan() || one >= two) {
        return Err("friction that is known should do better".into());
    }
    if highest < limit || highest > limit + 0.04 {
        return Err("the stop does not hold".into());
    }
    println!("{}", pictures::draw(&logs[0])?.display());
    Ok(())
}
