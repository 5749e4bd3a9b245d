//! Numerical example 3 of the paper: a cantilever beam under A sin ωt at its free end, against the analytic response.
//!
//! The paper models the beam by rigid bodies and rotary springs as in its example 2 (its text prints the force as A sin t). Its
//! parameters stand in figure 4(a), which the text does not repeat. Here: L = 1 m, ρA = 1 kg/m, EI = 1 N·m², A = 1e-3 N, ω = 5 rad/s.
//! The spring at the clamp is that of half a segment, 2EI/ℓ: with EI/ℓ the model converges with order one only.
//!
//! ```text
//! cargo run --release --example paper_example_3
//! ```

mod common;

use catena::paper::*;
use catena::planar::index::Y;
use catena::planar::{BodyMotion, Clamped, ElasticHinge, Free, Loads, Rod, System};
use common::{BLUE, Drawn, GREY, ORANGE, line};
use indicatif::ProgressBar;
use std::f64::consts::PI;
use std::path::PathBuf;

const FORCE: f64 = 1e-3;
const OMEGA: f64 = 5.0;

/// Deflection of the beam's end (m): forced response by the closed form of the receptance, free response by sixty modes.
fn beam(t: f64) -> f64 {
    let k = OMEGA.sqrt(); // (ρA ω² / EI)^¼
    let receptance = (k.sin() * k.cosh() - k.cos() * k.sinh()) / (k * k * k * (1.0 + k.cos() * k.cosh()));
    let modes = (0..60).map(|r| {
        let mut beta = if r == 0 { 1.8751 } else { (f64::from(r) + 0.5) * PI };
        for _ in 0..6 {
            // cos β cosh β = −1 by Newton's method
            beta -= (beta.cos() + 1.0 / beta.cosh()) / (-beta.sin() - beta.tanh() / beta.cosh());
        }
        let own = beta * beta;
        OMEGA * (own * t).sin() / (own * (own * own - OMEGA * OMEGA))
    });
    FORCE * receptance * (OMEGA * t).sin() - 4.0 * FORCE * modes.sum::<f64>()
}

/// Where tables of the method compare it (s).
const INSTANTS: [f64; 6] = [0.25, 0.5, 1.0, 2.0, 5.0, 10.0];
/// Step (s): what is left is of the division into bodies.
const STEP: f64 = 5e-4;

/// The end's deflection (m) every 10 ms, by `n` bodies, by the paper's scheme and by this crate's default for stiff scenes.
fn chain(n: usize, end: f64) -> Result<[Vec<(f64, f64)>; 2], catena::Error> {
    let size = 1.0 / n as f64;
    let rod = Rod::uniform(size, size);
    let links = vec![(ElasticHinge::rotary(1.0 / size), rod); n - 1];
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), (ElasticHinge::rotary(2.0 / size), rod, links), Free)?;
    let start = scene.at_rest(&vec![0.0; n])?;
    let loads = Loads::none().on_bodies(|t, body, motion: &BodyMotion<f64>| {
        let pull = if body == n - 1 { FORCE * f64::sin(OMEGA * t) } else { 0.0 };
        motion.force_at([size, 0.0], [0.0, pull])
    });
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).linearized(At::Predictor).solved_by(Solver::Riccati);
    let mut run = scheme.start(&scene, &start, &loads, STEP)?;
    let mut paper = vec![];
    while run.time() < end - 0.5 * STEP {
        for _ in 0..20 {
            run.step()?;
        }
        if let Some(tip) = run.stations().last() {
            paper.push((run.time(), tip[Y]));
        }
    }
    let mut own = vec![];
    let rule = catena::planar::GeneralizedAlpha::new(0.8).step(STEP);
    scene.simulation(rule).loads(&loads).every(0.01).run(start, end, |now| {
        own.push((now.time(), now.stations().tip().frame.place.y));
    })?;
    own.remove(0);
    Ok([paper, own])
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "Example 3: cantilever under A sin ωt, steps of 0.5 ms. Largest error of the end's deflection, of the largest deflection: in 10 s,"
    );
    println!("and at t = 0.25, 0.5, 1, 2, 5 and 10 s. All parameters are stand-ins.\n");
    println!("  bodies   paper's scheme   falls by   at instants   falls by   this crate");
    let (mut last, mut shown) = (None, vec![]);
    let bar = ProgressBar::new(4);
    for n in [10, 20, 40, 80] {
        let runs = chain(n, 10.0)?;
        let error = |run: &[(f64, f64)], counts: &dyn Fn(f64) -> bool| {
            let points = run.iter().filter(|(t, _)| counts(*t));
            let (worst, largest) = points.fold((0.0_f64, 0.0_f64), |(worst, largest), (t, w)| {
                (worst.max((w - beam(*t)).abs()), largest.max(beam(*t).abs()))
            });
            worst / largest
        };
        let at_instant = |t: f64| INSTANTS.iter().any(|instant| (t - instant).abs() < STEP);
        let [paper, own] = runs.each_ref().map(|run| error(run, &|_| true));
        let table = error(&runs[0], &at_instant);
        let [falls, table_falls] = match last {
            Some((paper_before, table_before)) => {
                [paper_before / paper, table_before / table].map(|x: f64| format!("{x:.2}"))
            }
            None => ["-", "-"].map(String::from),
        };
        bar.suspend(|| println!("  {n:6} {paper:16.4} {falls:>10} {table:13.4} {table_falls:>10} {own:12.4}"));
        bar.inc(1);
        last = Some((paper, table));
        if n == 20 {
            shown = runs[0].clone();
        }
    }
    bar.finish_and_clear();
    println!("\nPicture: {}", draw(&shown)?.display());
    Ok(())
}

fn draw(shown: &[(f64, f64)]) -> Drawn<PathBuf> {
    common::picture("paper_example_3", (1000, 560), |area| {
        let subtitle = "L = 1 m, ρA = 1 kg/m, EI = 1 N·m², A = 1e-3 N, ω = 5 rad/s. Twenty bodies, steps of 0.5 ms.";
        let area = common::heading(area, "Example 3: cantilever beam under A sin ωt", subtitle)?;
        let (upper, lower) = area.split_vertically(common::pixels(290.0));
        let scaled = |w: f64| w * 1e4;
        let exact = shown.iter().map(|(t, _)| (*t, scaled(beam(*t))));
        let range = common::range(exact.clone().map(|(_, w)| w), 0.1);
        let mut chart = common::chart(&upper, "Deflection of the end (10⁻⁴ m)", "time (s)", 0.0..10.0, range)?;
        common::legend(&upper, &[("analytic", GREY), ("paper's scheme", ORANGE)])?;
        common::curve(&mut chart, exact, line(GREY, 5.0))?;
        common::curve(&mut chart, shown.iter().map(|(t, w)| (*t, scaled(*w))), line(ORANGE, 1.6))?;
        let error = shown.iter().map(|(t, w)| (*t, scaled(w - beam(*t))));
        let range = common::range(error.clone().map(|(_, w)| w), 0.1);
        let title = "Difference (10⁻⁴ m): the phase of the first mode, by the division into bodies";
        let mut chart = common::chart(&lower, title, "time (s)", 0.0..10.0, range)?;
        common::curve(&mut chart, error, line(BLUE, 1.4))
    })
}
