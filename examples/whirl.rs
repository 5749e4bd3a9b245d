//! When does what is steady begin to shake? An overhung rotor whose whirl splits with its speed (Campbell's diagram), and a column under a
//! force that follows it, which flutters: the sooner for a little damping (Ziegler). Complex modes beside closed forms.
//!
//! ```text
//! cargo run --release --example whirl
//! ```

mod common;

use catena::modes::ComplexModes;
use catena::{planar, spatial};
use common::{BLUE, Drawn, GREY, INK, ORANGE, line};
use std::error::Error;
use std::path::PathBuf;

/// A disc of mass (kg), inertias along and across its axis (kg·m²), out on a shaft (m), whose bearing yields by a stiffness (N·m/rad) and
/// rubs by a damping (N·m·s/rad).
const MASS: f64 = 4.0;
const ALONG: f64 = 0.08;
const ACROSS: f64 = 0.045;
const SHAFT: f64 = 0.1;
const STIFFNESS: f64 = 900.0;
const DAMPING: f64 = 0.05;
/// The column: springs of 1 N·m/rad, rods of 1 m, masses of 2 and 1 kg at their ends. Without damping it flutters from here on (N), and with
/// hardly any from there on (H. Ziegler, 1952; G. Herrmann, I.-C. Jong, 1965).
const UNDAMPED: f64 = 3.5 - std::f64::consts::SQRT_2;
const DAMPED: f64 = 41.0 / 28.0;

/// The rotor's modes at a speed (rad/s). The first are its spin, which is free.
fn rotor(speed: f64) -> Result<ComplexModes, catena::Error> {
    use spatial::{Clamped, Free, Revolute, RigidBody, Spring, System, Unloaded};
    let bearing = |axis| Revolute::about(axis).with(Spring::new(STIFFNESS).damped(DAMPING));
    let inertia = [[ACROSS, 0.0, 0.0], [0.0, ACROSS, 0.0], [0.0, 0.0, ALONG]];
    let disc = RigidBody::new(MASS, inertia, [0.0, 0.0, SHAFT], [0.0, 0.0, SHAFT]);
    let ring = RigidBody::massless([0.0; 3]);
    let chain =
        (bearing([1.0, 0.0, 0.0]), ring, bearing([0.0, 1.0, 0.0]), ring, Revolute::about([0.0, 0.0, 1.0]), disc);
    let scene = System::new(Clamped::origin(), chain, Free)?;
    scene.complex_modes(&scene.with_rates(scene.motion(), &[0.0, 0.0, speed])?, &Unloaded)
}

/// Backward and forward whirl (rad/s) by hand: J ω² ∓ J₃ Ω ω − k = 0, without damping.
fn by_hand(speed: f64) -> [f64; 2] {
    let inertia = ACROSS + MASS * SHAFT * SHAFT;
    let half = 0.5 * ALONG * speed / inertia;
    let mean = (STIFFNESS / inertia + half * half).sqrt();
    [mean - half, mean + half]
}

/// The column's modes under a push (N), with a damping (N·m·s/rad) in both joints.
fn column(push: f64, damping: f64) -> Result<ComplexModes, catena::Error> {
    use planar::{BodyMotion, Clamped, ElasticHinge, Free, Loads, PointMass, System};
    let joint = ElasticHinge::rotary(1.0).damped(damping);
    let chain = (joint, PointMass::new(1.0, 2.0), joint, PointMass::new(1.0, 1.0));
    let scene = System::new(Clamped::origin(), chain, Free)?;
    let follows = Loads::none().on_bodies(move |_: f64, body, motion: &BodyMotion<f64>| {
        let push = if body == 1 { [-push, 0.0] } else { [0.0; 2] };
        motion.force_at([1.0, 0.0], motion.turned(push).into())
    });
    scene.complex_modes(&scene.motion(), &follows)
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("A disc of {MASS} kg on a shaft of {SHAFT} m in a bearing that yields.\n");
    common::heads(&[
        ("speed (rad/s)", 13),
        ("backward", 10),
        ("by hand", 10),
        ("forward", 10),
        ("by hand", 10),
        ("damping", 9),
    ]);
    let mut whirl = Vec::new();
    for k in 0..=24 {
        let speed = 10.0 * f64::from(k);
        let modes = rotor(speed)?;
        let swings: Vec<_> = modes.iter().filter(|mode| mode.frequency() > 1.0).collect();
        let [slow, fast] = swings[..] else { return Err("the rotor has two whirls".into()) };
        whirl.push((speed, [slow.frequency(), fast.frequency()]));
        if k % 4 == 0 {
            let [backward, forward] = by_hand(speed);
            let (a, b, damping) = (slow.frequency(), fast.frequency(), fast.damping_ratio());
            println!("  {speed:13.0}  {a:10.4}  {backward:10.4}  {b:10.4}  {forward:10.4}  {damping:9.6}");
        }
    }
    println!(
        "\nA column under a force that follows it: by hand it flutters from {UNDAMPED:.4} N, hardly damped from {DAMPED:.4} N.\n"
    );
    common::heads(&[("push (N)", 9), ("undamped (1/s)", 14), ("damped (1/s)", 13)]);
    let mut growth = [Vec::new(), Vec::new()];
    for k in 0..=250 {
        let push = 0.01 * f64::from(k);
        let found = [0.0, 0.02].map(|damping| column(push, damping).map(|modes| modes.largest_growth()));
        let [undamped, damped] = found;
        let found = [undamped?, damped?];
        growth.iter_mut().zip(found).for_each(|(list, found)| list.push((push, found)));
        if k % 25 == 0 {
            println!("  {push:9.2}  {:14.6}  {:13.6}", found[0], found[1]);
        }
    }
    println!("\nPicture: {}", draw(&whirl, &growth)?.display());
    Ok(())
}

/// Campbell's diagram on the left, the column's growth on the right.
fn draw(whirl: &[(f64, [f64; 2])], growth: &[Vec<(f64, f64)>; 2]) -> Drawn<PathBuf> {
    common::picture("whirl", (1000, 480), |area| {
        let subtitle =
            "An overhung rotor whirls otherwise at each speed; a column under a force that follows it flutters.";
        let area = common::heading(area, "When does what is steady begin to shake?", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(500.0));
        let mut chart = common::chart(&left, "Whirl (rad/s)", "speed (rad/s)", 0.0..250.0, 0.0..300.0)?;
        common::legend(
            &left,
            &[("backward", BLUE), ("forward", ORANGE), ("by hand", GREY), ("as fast as it turns", INK)],
        )?;
        common::curve(&mut chart, [(0.0, 0.0), (250.0, 250.0)], line(INK, 1.0))?;
        for (way, colour) in [BLUE, ORANGE].into_iter().enumerate() {
            let exact = (0..=240).map(f64::from).map(|speed| (speed, by_hand(speed)[way]));
            common::curve(&mut chart, exact, line(GREY, 1.2))?;
            common::dots(&mut chart, whirl.iter().map(|(speed, both)| (*speed, both[way])), 3.0, colour)?;
        }
        let mut chart = common::chart(&right, "Growth of the column (1/s)", "push (N)", 1.0..2.3, -0.004..0.02)?;
        common::legend(&right, &[("undamped", BLUE), ("damped", ORANGE), ("by hand", INK)])?;
        for (limit, colour, points) in [(UNDAMPED, BLUE, &growth[0]), (DAMPED, ORANGE, &growth[1])] {
            common::curve(&mut chart, [(limit, -0.004), (limit, 0.02)], line(INK, 1.0))?;
            let seen = points.iter().copied().filter(|(push, growth)| *push >= 1.0 && *growth <= 0.02);
            common::curve(&mut chart, seen, line(colour, 1.8))?;
        }
        Ok(())
    })
}
