//! Steering past shocks: forces on a cart over forty intervals, found so that the cart and the rod that hangs from it are at places and move at rates
//! asked for at an instant. The cart rubs on its rail, sticks, and bumps into the rail's ends; gradients go back past all of that, four of them for
//! each try.
//!
//! ```text
//! cargo run --release --example past_shocks
//! ```

mod common;
#[path = "pictures/past_shocks.rs"]
mod pictures;

use catena::planar::*;
use indicatif::ProgressBar;
use nalgebra::{SMatrix, SVector};
use std::error::Error;
use std::f64::consts::FRAC_PI_2;

/// Forces on the cart (N), held over equal intervals; a run of two seconds.
const N: usize = 40;
const END: f64 = 2.0;
/// Length of the rod (m).
const ROD: f64 = 0.8;
/// The cart goes so far to either side (m), and gives back a share of its speed there; friction of the rail and in the pivot (N, N·m).
const RAIL: f64 = 0.5;
const RESTITUTION: f64 = 0.4;
const FRICTION: [f64; 2] = [3.0, 0.02];
/// Where cart and rod are to be (m, rad), and how fast (m/s, rad/s).
const TARGET: [f64; 4] = [0.3, -1.0, 0.4, 2.0];
const ROUNDS: u64 = 20;

type Forces = SVector<f64, N>;

/// What is seen of a try: time (s), place of the cart and of the rod's end (m) at each state of the run.
struct Seen {
    path: Vec<[f64; 3]>,
    /// (N).
    forces: Forces,
    /// Times (s) at which modes change.
    changes: Vec<f64>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let rail = Coulomb::new(Slider::along(0.0), FRICTION[0]).between([-RAIL, RAIL]).rebounding(RESTITUTION);
    let cart = RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
    let chain = (rail, cart, Coulomb::new(Revolute::smooth(), FRICTION[1]), Rod::uniform(ROD, 1.0));
    let crane = System::new(Clamped::origin(), chain, Free)?.with_gravity(9.81);
    let mut start = crane.motion();
    start.set_coordinates(&[-0.3, -FRAC_PI_2])?;
    let mut backward = crane.backward(Dop853);
    // At first a push that sends the cart into the rail's end.
    let mut forces = Forces::from_fn(|k, _| if k < 12 { 14.0 } else { 0.0 });
    let (mut tries, mut rows, bar) = (vec![], vec![], ProgressBar::new(ROUNDS));
    for round in 0..=ROUNDS {
        bar.inc(1);
        let torques: Vec<f64> = forces.iter().flat_map(|force| [0.0, *force, 0.0]).collect();
        let course = backward.course(&start, Dop853::tolerance(1e-9), END, &torques)?;
        let Some(end) = course.states().last() else { continue };
        let now = [end.coordinates(), end.rates()].concat();
        let missed = SVector::<f64, 4>::from_fn(|k, _| now[k] - TARGET[k]);
        let path = course.states().iter().map(|state| {
            let (place, angle) = (state.coordinates()[0], state.coordinates()[1]);
            [state.time(), place, place + ROD * angle.cos()]
        });
        let path = path.collect();
        let changes: Vec<f64> = course.changes().skip(1).map(|number| course.states()[number].time()).collect();
        rows.push((round, missed, changes.len(), forces.norm()));
        tries.push(Seen { path, forces, changes });
        if missed.amax() < 1e-9 {
            break;
        }
        // What each of the four numbers changes by with each force.
        let (mut slopes, last) = (SMatrix::<f64, 4, N>::zeros(), course.states().len() - 1);
        for k in 0..4 {
            let (mut by, mut unit) = (vec![0.0; 3 * N], [0.0; 4]);
            unit[k] = 1.0;
            backward.gradient_past(&course, &mut by, |step, _, costate| {
                if step == last { costate.add(&unit[..2], &unit[2..]) } else { Ok(()) }
            })?;
            slopes.set_row(k, &Forces::from_fn(|interval, _| by[3 * interval + 1]).transpose());
        }
        // Newton's method by the least change of forces, none by more than 4 N.
        let square = slopes * slopes.transpose() + SMatrix::<f64, 4, 4>::identity() * 1e-12;
        let change = slopes.transpose() * square.lu().solve(&missed).ok_or("nothing moves it")?;
        forces -= change * (4.0 / change.amax()).min(1.0);
    }
    bar.finish_and_clear();
    let (whole, [place, angle, speed, spin]) = (2.0 * RAIL, TARGET);
    println!(
        "A cart of 2 kg that rubs on a rail of {whole} m, and a rod of {ROD} m that hangs from it: from rest, by {N} forces over"
    );
    println!(
        "{END} s, to {place} m and {angle} rad at {speed} m/s and {spin} rad/s. Newton's method, its slopes backward past all changes.\n"
    );
    common::heads(&[
        ("try", 4),
        ("misses by (m)", 13),
        ("(rad)", 9),
        ("(m/s)", 9),
        ("(rad/s)", 9),
        ("changes", 7),
        ("forces (N)", 10),
    ]);
    for (round, missed, changes, size) in rows {
        let [place, angle, speed, spin] = [0, 1, 2, 3].map(|k: usize| missed[k].abs());
        println!("  {round:4}  {place:13.1e}  {angle:9.1e}  {speed:9.1e}  {spin:9.1e}  {changes:7}  {size:10.3}");
    }
    println!("\nPicture: {}", pictures::draw(&tries)?.display());
    Ok(())
}
