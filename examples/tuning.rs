//! A blade whose tip vibrates least: thirty thicknesses, their gradients backward through a run.
//!
//! A hub that turns stops at once, and the blade on it rings. Pieces of the blade are rods, on springs as stiff as thicknesses make them. The
//! gradient of how far the tip swings, on average, by all thicknesses costs three runs, however many there are; of the run's thousands of
//! states few are kept. Gradient descent follows it, at a mass that stays.
//!
//! ```text
//! cargo run --release --example tuning
//! ```

mod common;
#[path = "pictures/tuning.rs"]
mod pictures;

use catena::planar::*;
use catena::scalar::{Jet, Scalar};
use catena::sensitivity::{Checkpoints, Costate};
use catena::{Error, Lift};
use indicatif::ProgressBar;
use std::time::Instant;

const N: usize = 30;
const PIECE: f64 = 0.4 / N as f64; // (m)
const WIDTH: f64 = 0.04; // (m)
const DENSITY: f64 = 1200.0; // (kg/m³)
const YOUNG: f64 = 2e9; // (N/m²)
const RELAXATION: f64 = 4e-6; // damping over stiffness (s)
const THICKNESS: f64 = 3e-3; // at first (m)
const BOUNDS: [f64; 2] = [1.2e-3, 5e-3]; // (m)
const SPIN: f64 = 3.0; // of the hub that stops (rad/s)
const PLAN: Checkpoints<f64> = Checkpoints { step: 2.5e-5, steps: 16_000, every: 100 }; // 0.4 s
const ROUNDS: u64 = 14;

type Link<T> = (ElasticHinge<Spring<T, T>>, Rod<T>);
type Blade<T> = System<T, Clamped<[T; 2], T>, Vec<Link<T>>, Free>;
type Thicknesses = [f64; N];

/// The blade, of numbers of any kind.
fn blade<T: Scalar<Real = f64>>(thicknesses: &[T; N]) -> Result<Blade<T>, Error> {
    let link = |h: &T| {
        let stiffness = (*h * *h * *h).scale(YOUNG * WIDTH / (12.0 * PIECE));
        let rod = Rod::uniform(T::literal(PIECE), h.scale(DENSITY * WIDTH * PIECE));
        (ElasticHinge::rotary(stiffness).damped(stiffness.scale(RELAXATION)), rod)
    };
    System::new(Clamped::origin(), thicknesses.iter().map(link).collect(), Free)
}

/// Height of the tip (m) and, if asked for, its derivatives by all relative angles.
fn tip(angles: &[f64], slopes: Option<&mut [f64]>) -> f64 {
    let (mut angle, mut height, mut along) = (0.0, 0.0, [0.0; N]);
    for (i, relative) in angles.iter().enumerate() {
        angle += relative;
        height += PIECE * angle.sin();
        along[i] = PIECE * angle.cos();
    }
    if let Some(slopes) = slopes {
        let mut sum = 0.0;
        for (slope, along) in slopes.iter_mut().zip(along).rev() {
            sum += along;
            *slope = sum;
        }
    }
    height
}

/// Mean square of the tip's height (m²) at every tenth step, its gradient, and the heights.
fn vibration(thicknesses: &Thicknesses) -> Result<(f64, Thicknesses, Vec<f64>), Error> {
    let scene = blade(thicknesses)?;
    let mut start = scene.motion();
    let mut rates = [0.0; N];
    rates[0] = SPIN; // the others turn with it
    start.set_rates(&rates)?;
    let mut backward = scene.backward(Rk4);
    let (mut states, mut tape) = (vec![start.clone(); PLAN.states()], vec![backward.tape(); PLAN.every]);
    backward.run_between(&start, PLAN, &[], &mut states)?;
    let (mut mean, mut heights, share) = (0.0, vec![], 10.0 / PLAN.steps as f64);
    let mut angles = [0.0; N];
    let gradient =
        backward.gradient_between(PLAN, &[], &states, &mut tape, &mut [], |step, state, by: &mut Costate<_>| {
            if step % 10 > 0 {
                return Ok(());
            }
            let mut slopes = [0.0; N];
            state.coordinates_into(&mut angles)?;
            let height = tip(&angles, Some(&mut slopes));
            mean += share * height * height;
            heights.push(height);
            by.add(&slopes.map(|slope| 2.0 * share * height * slope), &[0.0; N])
        })?;
    heights.reverse();
    let mut k = 0;
    let seeded: [Jet<f64, N>; N] = thicknesses.lift(&mut |h: f64| {
        k += 1;
        Jet::seed(h, k - 1)
    });
    Ok((mean, gradient.along(&blade(&seeded)?)?, heights))
}

/// Thicknesses within bounds, of the mass at first.
fn admissible(mut thicknesses: Thicknesses) -> Thicknesses {
    for _ in 0..50 {
        let share = N as f64 * THICKNESS / thicknesses.iter().sum::<f64>();
        thicknesses = thicknesses.map(|h| (share * h).clamp(BOUNDS[0], BOUNDS[1]));
    }
    thicknesses
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let clock = Instant::now();
    let mut thicknesses = [THICKNESS; N];
    let (mut mean, mut gradient, at_first) = vibration(&thicknesses)?;
    let (mut heights, mut most) = (at_first.clone(), 0.15);
    let bar = ProgressBar::new(ROUNDS);
    let mut rows = vec![(0, mean, 0.0)];
    for round in 1..=ROUNDS {
        bar.inc(1);
        // What changes nothing but the mass is left out; no thickness by more than a share.
        let common = gradient.iter().sum::<f64>() / N as f64;
        let steepest = gradient.iter().fold(0.0_f64, |most, slope| most.max((slope - common).abs()));
        let step = most * THICKNESS / steepest;
        let tried = admissible(core::array::from_fn(|i| thicknesses[i] - step * (gradient[i] - common)));
        let (other, slopes, swing) = vibration(&tried)?;
        if other < mean {
            (thicknesses, mean, gradient, heights, most) = (tried, other, slopes, swing, 1.2 * most);
            rows.push((round, mean, step * steepest));
        } else {
            most *= 0.4;
        }
    }
    bar.finish_and_clear();
    common::heads(&[("round", 5), ("root mean square of the tip (mm)", 32), ("largest change (mm)", 19)]);
    for (round, mean, change) in rows {
        println!("  {round:5}  {:32.3}  {:19.3}", 1e3 * mean.sqrt(), 1e3 * change);
    }
    println!("\n{} runs of {} steps with their gradients: {:.1?}", ROUNDS + 1, PLAN.steps, clock.elapsed());
    println!("Picture: {}", pictures::draw(&thicknesses, &at_first, &heights)?.display());
    Ok(())
}
