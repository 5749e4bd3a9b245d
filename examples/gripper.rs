//! A gripper with one motor: three joints follow the one that it turns, until that strikes its stop and all four stand.
//!
//! ```text
//! cargo run --release --example gripper
//! ```

mod common;

use catena::planar::*;
use common::{BLUE, Drawn, GREY, ORANGE, line};
use std::error::Error;
use std::f64::consts::PI;
use std::path::PathBuf;

/// Half of the palm (m), links of the fingers (m, kg), and where the motor's joint is when the hand is closed and open (rad).
const PALM: f64 = 0.03;
const LINK: [f64; 2] = [0.05, 0.02];
const RANGE: [f64; 2] = [1.75, 2.3];
/// How much the outer link of a finger bends where the inner one turns, and how far it is bent when the hand is open (rad).
const BEND: [f64; 2] = [0.8, -0.3];
/// Torque of the motor (N·m), how long is looked at (s), and how often.
const TORQUE: f64 = -0.05;
const END: f64 = 0.3;
const EVERY: f64 = 0.005;

/// What is seen at an instant: time (s), coordinates (rad), torques on the motor's joint and on the first that follows (N·m).
struct Seen {
    time: f64,
    angles: [f64; 4],
    torques: [f64; 2],
}

/// Joints of a finger as they stand on the palm, and its tip (m).
fn finger(base: f64, [inner, outer]: [f64; 2]) -> [(f64, f64); 3] {
    let step = |(x, y): (f64, f64), angle: f64| (x + LINK[0] * angle.cos(), y + LINK[0] * angle.sin());
    let knuckle = step((base, 0.0), inner);
    [(base, 0.0), knuckle, step(knuckle, inner + outer)]
}

impl Seen {
    /// Both fingers.
    fn fingers(&self) -> [[(f64, f64); 3]; 2] {
        let [left, bent, right, bent_right] = self.angles;
        [finger(-PALM, [left, bent]), finger(PALM, [right, bent_right])]
    }
    /// How far the tips are apart (m).
    fn opening(&self) -> f64 {
        let [left, right] = self.fingers();
        right[2].0 - left[2].0
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let (link, joint) = (Rod::uniform(LINK[0], LINK[1]), Revolute::smooth());
    let motor = HardStops::between(joint, RANGE).rebounding(0.2).with(Spring::damping(1e-4));
    let base = |x: f64| RigidBody::massless([x, 0.0]);
    let left = (base(-PALM), motor.named("left"), link, joint.named("left bend"), link);
    let hand = (Branch(left), base(PALM), joint.named("right"), link, joint.named("right bend"), link);
    let scene = System::new(Clamped::origin(), hand, Free)?.with_gravity(9.81);
    let bend = Coupling::new("left bend", "left").ratio(BEND[0]).offset(BEND[1] - BEND[0] * RANGE[1]);
    let mirror = Coupling::new("right", "left").ratio(-1.0).offset(PI);
    let couplings = Couplings::of(&scene, [bend, mirror, Coupling::new("right bend", "left bend").ratio(-1.0)])?;

    let (motor, follower) = (scene.joint("left")?, scene.joint("right")?);
    let mut torques = vec![0.0; scene.joints()];
    torques[motor.joint] = TORQUE;
    let loads = couplings.and(Loads::none().torques(torques));
    let mut start = scene.motion();
    start.set_coordinates_of(motor, &[RANGE[1]])?;
    let start = couplings.joined(start); // the other three where they have to be

    let mut seen: Vec<Seen> = vec![];
    scene.simulation(Dop853::tolerance(1e-9)).loads(&loads).every(EVERY).run(start, END, |now| {
        let stations = now.stations();
        let torque = |joint| stations.joint(joint).map_or(f64::NAN, |station| -station.internal.torque);
        let angles = now.motion().coordinates().try_into().unwrap_or([f64::NAN; 4]);
        seen.push(Seen { time: now.time(), angles, torques: [torque(motor), torque(follower)] });
    })?;

    println!("A hand of four links, 5 cm and 20 g each; a motor turns one joint by {TORQUE} N·m, three follow it\n");
    common::heads(&[
        ("time (s)", 8),
        ("opening (mm)", 12),
        ("left (degrees)", 14),
        ("bend (degrees)", 14),
        ("on left (mN·m)", 14),
        ("on right (mN·m)", 15),
    ]);
    for now in seen.iter().step_by(4) {
        let ([left, bend, ..], [own, other]) =
            (now.angles.map(f64::to_degrees), now.torques.map(|torque| 1e3 * torque));
        println!(
            "  {:8.3}  {:12.2}  {left:14.3}  {bend:14.3}  {own:14.3}  {other:15.3}",
            now.time,
            1e3 * now.opening()
        );
    }
    let apart = |now: &Seen| {
        let [left, bend, right, bend_right] = now.angles;
        let misses = [bend - BEND[0] * (left - RANGE[1]) - BEND[1], right + left - PI, bend_right + bend];
        misses.into_iter().fold(0.0, |most: f64, miss| most.max(miss.abs()))
    };
    let worst = seen.iter().map(apart).fold(0.0, f64::max);
    println!("\nJoints miss what they follow by {worst:.0e} rad at most.");
    println!("Picture: {}", draw(&seen)?.display());
    Ok(())
}

/// The hand as it closes on the left; how far it is open, and what acts in two of its joints, on the right.
fn draw(seen: &[Seen]) -> Drawn<PathBuf> {
    common::picture("gripper", (1000, 560), |area| {
        let subtitle =
            "One motor, four joints: the three that follow are coupled to the first, also when it strikes its stop.";
        let area = common::heading(area, "A gripper that closes", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(480.0));
        let (upper, lower) = right.split_vertically(common::pixels(247.0));
        let mut places = common::chart(&left, "Every 0.02 s (m)", "", -0.13..0.13, -0.02..0.12)?;
        common::links(&mut places, vec![(-PALM, 0.0), (PALM, 0.0)], line(GREY, 3.0))?;
        for now in seen.iter().step_by(4) {
            let [left, right] = now.fingers();
            common::links(&mut places, left.to_vec(), line(BLUE, 2.0))?;
            common::links(&mut places, right.to_vec(), line(ORANGE, 2.0))?;
        }
        let opening = || seen.iter().map(|now| (now.time, 1e3 * now.opening()));
        let range = common::range(opening().map(|(_, x)| x), 0.1);
        let mut chart = common::chart(&upper, "Between the tips (mm)", "time (s)", 0.0..END, range)?;
        common::curve(&mut chart, opening(), line(BLUE, 1.8))?;
        let torque = |k: usize| seen.iter().map(move |now| (now.time, 1e3 * now.torques[k]));
        let range = common::range(torque(0).chain(torque(1)).map(|(_, x)| x), 0.1);
        let mut chart = common::chart(&lower, "Torques of the inner joints (mN·m)", "time (s)", 0.0..END, range)?;
        common::legend(&lower, &[("left", BLUE), ("right", ORANGE)])?;
        common::curve(&mut chart, torque(0), line(BLUE, 1.8))?;
        common::curve(&mut chart, torque(1), line(ORANGE, 1.8))
    })
}
