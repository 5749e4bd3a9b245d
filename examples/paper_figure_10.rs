//! Figure 10 of the paper: computing time against the number of bodies, of the chain of its section 5.5.
//!
//! The paper's chain: n rods of 1/n m and 1/n kg with rotary springs of 20 N·m/rad between them, from rest at −60°. The root, a smooth
//! pin, and gravity are assumed; so is the "ordinary method": one linear system for all bodies, formed and factorised anew in each step.
//! It is solved densely in all angles, to 1000 bodies, and block by block in all coordinates and pin forces. Times are those of one step of
//! this machine.
//!
//! ```text
//! cargo run --release --example paper_figure_10          # the best of three rounds
//! cargo run --release --example paper_figure_10 -- 1     # of one
//! ```

mod common;
#[path = "common/global.rs"]
mod global;
#[path = "pictures/paper_figure_10.rs"]
mod pictures;

use catena::loading::Unloaded;
use catena::paper::*;
use catena::planar::{ElasticHinge, Free, Pinned, Rod, Spring as HingeSpring, Stepper, System};
use indicatif::ProgressBar;
use std::f64::consts::FRAC_PI_3;
use std::hint::black_box;
use std::time::Instant;

type Chain = System<f64, Pinned<[f64; 2]>, (Rod<f64>, Vec<(ElasticHinge<HingeSpring<f64>>, Rod<f64>)>), Free>;

/// Time of one call (s): the median of batches of at least 20 ms in all.
fn time(mut call: impl FnMut() -> Result<(), catena::Error>) -> Result<f64, catena::Error> {
    call()?;
    let mut samples = vec![];
    let begin = Instant::now();
    while samples.len() < 5 || begin.elapsed().as_secs_f64() < 0.02 {
        let start = Instant::now();
        call()?;
        samples.push(start.elapsed().as_secs_f64());
        if begin.elapsed().as_secs_f64() > 2.0 {
            break;
        }
    }
    samples.sort_by(f64::total_cmp);
    Ok(samples[samples.len() / 2])
}

/// Times (s) of a step of n bodies: by the product, by the transform, in joint coordinates, by this crate, by global equations
/// solved densely and block by block.
fn measure(n: usize) -> Result<[Option<f64>; 6], catena::Error> {
    let size = 1.0 / n as f64;
    let rod = Rod::uniform(size, size);
    let links = vec![(ElasticHinge::rotary(20.0), rod); n - 1];
    let scene: &Chain = &System::new(Pinned::origin(), (rod, links), Free)?.with_gravity(9.81);
    let start = scene.at_rest(&vec![-FRAC_PI_3; n])?;
    let dt = 1e-3;
    let alpha = GeneralizedAlpha::new(0.8);
    let scheme = Scheme::new(alpha).linearized(At::Predictor);
    // The product, which would not live long, takes the same step again and again, of a clone of the run; what cloning takes is taken
    // off. The others go on from step to step.
    macro_rules! first_step_of {
        ($run:expr) => {{
            let run = $run;
            let mut copy = run.clone();
            let copying = time(|| Ok(_ = black_box(run.clone())))?;
            let stepping = time(|| {
                copy = run.clone();
                copy.step()
            })?;
            Some(stepping - copying)
        }};
    }
    macro_rules! step_of {
        ($run:expr) => {{
            let mut run = $run;
            Some(time(|| run.step())?)
        }};
    }
    let product = if n <= 500 { first_step_of!(scheme.start(scene, &start, &Unloaded, 0.01)?) } else { None };
    let riccati = step_of!(scheme.solved_by(Solver::Riccati).start(scene, &start, &Unloaded, dt)?);
    let joints = step_of!(JointScheme::new(alpha).with_sweeps(2).start(scene, &start, &Unloaded, dt)?);
    let own = {
        let start = scene.with_accelerations(start.clone(), &Unloaded)?;
        let mut stepper = scene.stepper(catena::planar::GeneralizedAlpha::new(0.8));
        let mut next = start.clone();
        Some(time(|| stepper.step(&start, &Unloaded, dt, &mut next))?)
    };
    let (angles, rates) = (vec![-FRAC_PI_3; n], vec![0.1; n]);
    let dense = if n <= 1000 { Some(time(|| Ok(_ = black_box(global::dense(&angles, &rates))))?) } else { None };
    let sparse = Some(time(|| Ok(_ = black_box(global::sparse(&angles, &rates))))?);
    Ok([product, riccati, joints, own, dense, sparse])
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rounds = std::env::args().nth(1).map_or(Ok(3), |text| text.parse::<std::num::NonZeroU8>().map(u8::from))?;
    println!("Figure 10: time of a step (µs) against the number of bodies, the chain of section 5.5.\n");
    // Two ways to the same accelerations, of bent and moving rods.
    let bent: [Vec<f64>; 2] = [0.7, 1.9].map(|wave| (0..50).map(|k| (wave * f64::from(k)).sin()).collect());
    let ways = [global::dense(&bent[0], &bent[1]), global::sparse(&bent[0], &bent[1])].map(Option::unwrap_or_default);
    let size = ways[0].iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    let apart = ways[0].iter().zip(&ways[1]).fold(0.0_f64, |apart, (a, b)| apart.max((a - b).abs()));
    println!("Dense and block by block the global equations of 50 bodies agree to {:.0e}.\n", apart / size);
    // Neighbours on the machine slow down whatever runs just then: the best of several rounds.
    let numbers = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 5000, 20_000, 100_000];
    let mut best = [[None::<f64>; 6]; 13];
    let bar = ProgressBar::new(u64::from(rounds) * numbers.len() as u64);
    for _ in 0..rounds {
        for (n, best) in numbers.into_iter().zip(&mut best) {
            for (best, time) in best.iter_mut().zip(measure(n)?) {
                *best = best.map_or(time, |best| time.map(|time| time.min(best)));
            }
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    let ways =
        ["paper, product", "paper, Riccati", "joint coordinates", "this crate", "global, dense", "global, blocks"];
    common::heads(&[&[("bodies", 7)], &ways.map(|way| (way, way.len()))[..]].concat());
    let mut curves: [Vec<(f64, f64)>; 6] = Default::default();
    for (n, times) in numbers.into_iter().zip(best) {
        let [a, b, c, d, e, f] = times.map(|t| t.map_or("-".to_owned(), |t| format!("{:.2}", t * 1e6)));
        println!("  {n:7}  {a:>14}  {b:>14}  {c:>17}  {d:>10}  {e:>13}  {f:>14}");
        for (curve, time) in curves.iter_mut().zip(times) {
            if let Some(time) = time {
                curve.push(((n as f64).log10(), (time * 1e6).max(1e-3).log10()));
            }
        }
    }
    println!(
        "\n  Steps are of 1 ms, those of the product of 10 ms: at 1 ms it has hardly a digit left with 10 bodies, at 10 with 1000."
    );
    let slope = |curve: &[(f64, f64)], from: f64, to: f64| {
        common::slope(curve.iter().filter(|(n, _)| (from.log10()..=to.log10() + 1e-9).contains(n)))
    };
    println!(
        "\nSlopes: paper, Riccati {:.2}, this crate {:.2} (n = 100 to 20 000); global equations {:.2} (dense, n = 100 to 1000) and {:.2} (blocks).",
        slope(&curves[1], 100.0, 20_000.0),
        slope(&curves[3], 100.0, 20_000.0),
        slope(&curves[4], 100.0, 1000.0),
        slope(&curves[5], 100.0, 20_000.0)
    );
    for (name, curve) in [("the paper's scheme, Riccati", &curves[1]), ("this crate", &curves[3])] {
        let first = curve.iter().zip(&curves[4]).find(|(own, global)| global.1 > own.1);
        if let Some(((n, _), _)) = first {
            println!("From n = {:.0} on dense global equations are slower than {name}.", 10_f64.powf(*n));
        }
    }
    println!("\nPicture: {}", pictures::draw(curves)?.display());
    Ok(())
}
