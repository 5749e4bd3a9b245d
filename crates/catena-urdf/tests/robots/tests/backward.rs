//! Gradients of runs of shipped robots, backward, against central differences of the same runs.

use catena::robot::{Effort, Loads, Rk4, Stepper};
use catena_urdf_robots::{arm7_local, cart_local, humanoid_local, quadruped_local};
use std::error::Error;

const STEPS: usize = 20;
const STEP: f64 = 0.002;

/// Weight of a number of the end.
fn weight(k: usize) -> f64 {
    1.0 + 0.1 * k as f64
}

/// A cost of joint positions and of all rates at the end: its gradient by rates and joint positions of the start and by torques, of which
/// each `$every`th is checked. The joints of `$module` come after `$base` numbers of a base that floats, if there are any.
macro_rules! backward {
    ($module:ident, $joints:literal, $base:literal, $every:literal) => {{
        let scene = $module::scene::<f64>()?;
        let n = $base + $joints;
        let mut start = scene.motion();
        // A base that floats has a quaternion.
        let mut positions = start.coordinates();
        let first = positions.len() - $joints;
        (0..$joints).for_each(|k| positions[first + k] = 0.4 * (1.0 + k as f64).sin());
        let rates: Vec<f64> = (0..n).map(|k| 0.5 * (2.0 + k as f64).cos()).collect();
        let torques: Vec<f64> = (0..STEPS * $joints).map(|k| 2.0 * (0.3 * k as f64).sin()).collect();
        let efforts = |torques: &[f64]| -> Vec<Effort<f64>> {
            let of_step = |step: usize| $module::efforts(std::array::from_fn(|k| torques[step * $joints + k]));
            (0..STEPS).flat_map(of_step).collect()
        };
        let made = |positions: &[f64], rates: &[f64]| -> Result<_, catena::Error> {
            let mut start = scene.motion();
            start.set_coordinates(positions)?;
            start.set_rates(rates)?;
            Ok(start)
        };
        let cost = |positions: &[f64], rates: &[f64], torques: &[f64]| -> Result<f64, catena::Error> {
            let (mut now, all, mut stepper) = (made(positions, rates)?, efforts(torques), scene.stepper(Rk4));
            let mut next = now.clone();
            for held in all.chunks(all.len() / STEPS) {
                stepper.step(&now, &Loads::none().efforts(held), STEP, &mut next)?;
                core::mem::swap(&mut now, &mut next);
            }
            let ends = now.coordinates();
            let joints = ends[first..].iter().enumerate().map(|(k, q)| weight($base + k) * q);
            Ok(joints.sum::<f64>() + now.rates().iter().enumerate().map(|(k, v)| 0.1 * weight(k) * v).sum::<f64>())
        };
        start.clone_from(&made(&positions, &rates)?);
        let all = efforts(&torques);
        let (mut backward, mut states, mut by_efforts) =
            (scene.backward(Rk4), vec![start.clone(); STEPS + 1], all.clone());
        backward.run(&start, STEP, STEPS, &all, &mut states)?;
        let gradient = backward.gradient(&all, &states, &mut by_efforts, |step, _, by| {
            let of_joints = [vec![0.0; $base], ($base..n).map(weight).collect()].concat();
            let of_rates: Vec<f64> = (0..n).map(|k| 0.1 * weight(k)).collect();
            if step == STEPS { by.add(&of_joints, &of_rates) } else { Ok(()) }
        })?;
        // Of efforts the place of each torque is known by what `efforts` makes of numbers.
        let marks = efforts(&(1..=torques.len()).map(|k| k as f64).collect::<Vec<_>>());
        let by_torque = |k: usize| {
            let at = marks.iter().position(|Effort([mark, ..])| *mark == (k + 1) as f64).expect("a torque");
            by_efforts[at].0[0]
        };
        let e = 1e-5;
        let changed = |list: &[f64], k: usize, by: f64| {
            let mut list = list.to_vec();
            list[k] += by;
            list
        };
        let mut worst = 0.0_f64;
        let mut agrees = |found: f64, [above, below]: [f64; 2], size: f64| {
            let slope = (above - below) / (2.0 * e);
            worst = worst.max((found - slope).abs() / size);
        };
        let size = gradient.by_rate().iter().chain(&gradient.by_position()).fold(0.0_f64, |most, x| most.max(x.abs()));
        for k in 0..n {
            let at = |by: f64| cost(&positions, &changed(&rates, k, by), &torques);
            agrees(gradient.by_rate()[k], [at(e)?, at(-e)?], size);
        }
        for k in 0..$joints {
            let at = |by: f64| cost(&changed(&positions, first + k, by), &rates, &torques);
            agrees(gradient.by_position()[$base + k], [at(e)?, at(-e)?], size);
        }
        let size = (0..torques.len()).fold(0.0_f64, |most, k| most.max(by_torque(k).abs()));
        assert!(size > 0.0);
        for k in (0..torques.len()).step_by($every) {
            let at = |by: f64| cost(&positions, &rates, &changed(&torques, k, by));
            agrees(by_torque(k), [at(e)?, at(-e)?], size);
        }
        println!("{}: {worst:.1e}", stringify!($module));
        assert!(worst < 1e-6, "{}: {worst}", stringify!($module));
    }};
}

#[test]
fn an_arm_and_a_cart() -> Result<(), Box<dyn Error>> {
    backward!(arm7_local, 7, 0, 3);
    backward!(cart_local, 8, 0, 3);
    Ok(())
}

#[test]
fn a_quadruped_afloat() -> Result<(), Box<dyn Error>> {
    backward!(quadruped_local, 12, 6, 11);
    Ok(())
}

#[test]
fn a_humanoid_afloat() -> Result<(), Box<dyn Error>> {
    backward!(humanoid_local, 29, 6, 31);
    Ok(())
}
