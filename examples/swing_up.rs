//! A double pendulum on a cart swings up: forces on the cart found by steps linearised backward, and then held upright.
//!
//! Iterative LQR: each step of a run with its Jacobians (`Backward::linearised_step`), from the last step to the first the best change of
//! the force where costs are quadratic and steps linear, a run with some of that change, until nothing changes any more. At the top the gains
//! of a regulator, from the same Jacobians, take over, and a push does not upset them.
//!
//! ```text
//! cargo run --release --example swing_up
//! ```

#[path = "common/cart.rs"]
mod cart;
mod common;
#[path = "pictures/swing_up.rs"]
mod pictures;

use cart::{H, Scene, Square, State, linearised, motion_of, push, regulator, scene, state_of};
use catena::Error;
use catena::planar::*;
use indicatif::ProgressBar;
use nalgebra::RowVector6;
use std::f64::consts::FRAC_PI_2;
use std::time::Instant;

const SWING: usize = 250; // steps, 2.5 s
const HOLD: usize = 300; // 3 s
const FORCE: f64 = 1e-3; // weight of the force, ½ ∫ F² dt (1/N²)
const PLACE: f64 = 0.5; // that of the place on the way, ½ ∫ x² dt (1/m²)
const UPRIGHT: State = State::new(0.0, FRAC_PI_2, FRAC_PI_2, 0.0, 0.0, 0.0);
const AT_END: State = State::new(50.0, 200.0, 200.0, 5.0, 5.0, 5.0); // weights of what is missed at the end

/// A run: its states, the forces that are held over its steps (N), and what it costs.
struct Plan {
    states: Vec<State>,
    forces: Vec<f64>,
    cost: f64,
}

/// What a run costs at its end, and the derivative.
fn missed(state: &State) -> (f64, State) {
    let weighted = AT_END.component_mul(&(state - UPRIGHT));
    (0.5 * weighted.dot(&(state - UPRIGHT)), weighted)
}

/// Goes on from a state by forces that answer to where it is.
fn run(scene: &Scene, start: State, steps: usize, mut force: impl FnMut(usize, &State) -> f64) -> Result<Plan, Error> {
    let mut now = motion_of(scene, &start)?;
    let (mut next, mut stepper) = (now, scene.stepper(Rk4));
    let mut plan = Plan { states: vec![start], forces: vec![], cost: 0.0 };
    for k in 0..steps {
        let state = plan.states[k];
        let force = force(k, &state);
        plan.cost += 0.5 * H * (FORCE * force * force + PLACE * state[0] * state[0]);
        plan.forces.push(force);
        stepper.step(&now, &Loads::none().torques(push(force)), H, &mut next)?;
        core::mem::swap(&mut now, &mut next);
        plan.states.push(state_of(&now)?);
    }
    plan.cost += missed(&plan.states[steps]).0;
    Ok(plan)
}

/// Changes of the forces of a run that cost least where it is linearised, gains about it.
fn improved(scene: &Scene, plan: &Plan, damping: f64) -> Result<Vec<(f64, RowVector6<f64>)>, Error> {
    let (mut slope, mut bend) = (missed(&plan.states[SWING]).1, Square::from_diagonal(&AT_END));
    let mut changes = vec![(0.0, RowVector6::zeros()); SWING];
    for k in (0..SWING).rev() {
        let (a, b) = linearised(scene, &plan.states[k], plan.forces[k])?;
        let (by_force, damped) = (b.dot(&slope) + H * FORCE * plan.forces[k], bend + Square::identity() * damping);
        let stiff = b.dot(&(damped * b)) + H * FORCE;
        let (change, gain) = (-by_force / stiff, -(b.transpose() * damped * a) / stiff);
        let closed = a + b * gain;
        slope = closed.transpose() * (slope + bend * b * change)
            + gain.transpose() * (H * FORCE * (plan.forces[k] + change));
        slope[0] += H * PLACE * plan.states[k][0];
        bend = closed.transpose() * bend * closed + gain.transpose() * gain * (H * FORCE);
        bend[(0, 0)] += H * PLACE;
        changes[k] = (change, gain);
    }
    Ok(changes)
}

/// What the cost of the rest of a run changes by with the state at each instant, which goes backward from the end to the start, and the most that
/// it changes by with a force (1/N): nothing where forces are the best.
fn costates(scene: &Scene, plan: &Plan) -> Result<(Vec<State>, f64), Error> {
    let (mut costates, mut most) = (vec![missed(&plan.states[SWING]).1; SWING + 1], 0.0_f64);
    for k in (0..SWING).rev() {
        let (a, b) = linearised(scene, &plan.states[k], plan.forces[k])?;
        most = most.max((b.dot(&costates[k + 1]) + H * FORCE * plan.forces[k]).abs());
        costates[k] = a.transpose() * costates[k + 1];
        costates[k][0] += H * PLACE * plan.states[k][0];
    }
    Ok((costates, most))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (scene, clock) = (scene()?, Instant::now());
    let start = State::new(0.0, -FRAC_PI_2, -FRAC_PI_2, 0.0, 0.0, 0.0);
    let mut plan = run(&scene, start, SWING, |k, _| 3.0 * (0.05 * k as f64).sin())?;
    let (mut damping, mut rows) = (1.0, vec![]);
    let bar = ProgressBar::new(300);
    for round in 1..=300 {
        bar.inc(1);
        let changes = improved(&scene, &plan, damping)?;
        let better = (0..10).map(|halved| 0.5_f64.powi(halved)).find_map(|share| {
            let tried = run(&scene, start, SWING, |k, state| {
                let (change, gain) = changes[k];
                plan.forces[k] + share * change + (gain * (state - plan.states[k]))[0]
            });
            tried.ok().filter(|tried| tried.cost < plan.cost).map(|tried| (share, tried))
        });
        let Some((share, tried)) = better else {
            damping *= 10.0;
            continue;
        };
        let done = plan.cost - tried.cost < 1e-6 * plan.cost;
        (plan, damping) = (tried, (damping * 0.3).max(1e-8));
        rows.push((round, plan.cost, share, missed(&plan.states[SWING]).0));
        if done {
            break;
        }
    }
    bar.finish_and_clear();
    common::heads(&[("round", 5), ("cost", 10), ("share of the change", 19), ("missed (rad, m, per s)", 22)]);
    let shown = rows.len().div_ceil(12);
    for (i, (round, cost, share, missed)) in rows.iter().enumerate() {
        if i % shown == 0 || i + 1 == rows.len() {
            println!("  {round:5}  {cost:10.5}  {share:19.3}  {missed:22.5}");
        }
    }
    let most = plan.forces.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
    println!("\nLargest force {most:.1} N, {:.1} s in all.", clock.elapsed().as_secs_f64());
    let (costates, slope) = costates(&scene, &plan)?;
    println!("By its costates, no force changes the cost by more than {slope:.1e} per N.");
    // The upper rod is pushed on the way to standing still.
    let gain = regulator(&scene, &UPRIGHT, FORCE, &AT_END)?;
    let mut top = plan.states[SWING];
    top[5] += 0.5;
    let held = run(&scene, top, HOLD, |_, state| (gain * (state - UPRIGHT))[0])?;
    let off = (held.states[HOLD] - UPRIGHT).amax();
    println!(
        "Pushed by 0.5 rad/s at the top, it is off by {off:.1e} (m, rad, m/s, rad/s) after {:.1} s.",
        H * HOLD as f64
    );
    println!("Pictures: {}", pictures::draw(&plan, &held)?.display());
    println!("          {}", pictures::film(&plan, &costates)?.display());
    Ok(())
}
