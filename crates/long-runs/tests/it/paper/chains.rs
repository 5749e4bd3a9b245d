//! The paper's scheme on elastic chains of many bodies: solvers against each other, the reference of its example 2, the beam of example 3.

use catena::Error;
use catena::loading::Unloaded;
use catena::paper::{At, GeneralizedAlpha, JointScheme, Newmark, Scheme, Solver};
use catena::planar::index::{M, QX, QY, THETA, X, Y};
use catena::planar::{BodyMotion, Clamped, ElasticHinge, Free, Loads, Pinned, Rod, Spring, System};
use core::f64::consts::FRAC_PI_3;

fn chain(n: usize) -> Result<Chain, Error> {
    let size = 1.0 / n as f64;
    let rod = Rod::uniform(size, size);
    let links = vec![(ElasticHinge::rotary(20.0), rod); n - 1];
    Ok(System::new(Pinned::origin(), (rod, links), Free)?.with_gravity(9.81))
}

type Chain = System<f64, Pinned<[f64; 2]>, Links, Free>;
type Links = (Rod<f64>, Vec<(ElasticHinge<Spring<f64>>, Rod<f64>)>);

/// Bent, and moving.
fn bent(n: usize) -> (Vec<f64>, Vec<f64>) {
    let angles: Vec<f64> = (0..n).map(|k| -FRAC_PI_3 + 0.3 * (k as f64 / n as f64)).collect();
    let mut rates = vec![1.0];
    rates.extend((1..n).map(|k| 0.5 / n as f64 * (k as f64).cos()));
    (angles, rates)
}

#[test]
fn product_and_riccati_agree_on_short_chains() -> Result<(), Error> {
    for n in 2..=6 {
        let scene = chain(n)?;
        let (angles, rates) = bent(n);
        let start = scene.with_rates(scene.at_rest(&angles)?, &rates)?;
        for at in [At::Previous, At::Predictor, At::Iterated] {
            let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).linearized(at);
            let mut product = scheme.start(&scene, &start, &Unloaded, 0.01)?;
            let mut riccati = scheme.solved_by(Solver::Riccati).start(&scene, &start, &Unloaded, 0.01)?;
            product.step()?;
            riccati.step()?;
            let (mut position, mut force) = (0.0_f64, 0.0_f64);
            for (a, b) in product.stations().iter().zip(riccati.stations()) {
                position = [X, Y, THETA].into_iter().fold(position, |worst, i| worst.max((a[i] - b[i]).abs()));
                force = [M, QX, QY].into_iter().fold(force, |worst, i| worst.max((a[i] - b[i]).abs()));
            }
            let largest =
                product.stations().iter().fold(0.0_f64, |w, z| [M, QX, QY].iter().fold(w, |w, i| w.max(z[*i].abs())));
            println!("n = {n}, {at:?}: positions {position:.1e}, forces {force:.1e} N of {largest:.0}");
            assert!(position < 1e-10 && force < 1e-10 * largest);
        }
    }
    Ok(())
}

/// The chain of section 5.5.
#[test]
fn riccati_holds_for_a_hundred_thousand_bodies() -> Result<(), Box<dyn std::error::Error>> {
    let n = 100_000;
    let scene = chain(n)?;
    let (angles, rates) = bent(n);
    let start = scene.with_rates(scene.at_rest(&angles)?, &rates)?;
    let scheme =
        Scheme::new(GeneralizedAlpha::new(0.8)).linearized(At::Predictor).solved_by(Solver::Riccati).keeping_matrices();
    let mut run = scheme.start(&scene, &start, &Unloaded, 0.01)?;
    run.step()?;
    let residual = run.residual().ok_or("no matrices")?;
    println!("scaled residual with {n} bodies: {residual:.1e}");
    assert!(residual < 1e-9);
    Ok(())
}

/// Example 2, twenty bodies: the tip of an order-8 integration of dense equations, at t = 1 s from −60°; errors (m) of another
/// implementation of joint coordinates, to two digits.
#[test]
fn flexible_pendulum_meets_the_reference() -> Result<(), Error> {
    let scene = chain(20)?;
    let start = scene.at_rest(&[-FRAC_PI_3; 20])?;
    macro_rules! error {
        ($name:expr, $scheme:expr, $dt:expr) => {{
            let mut run = $scheme.start(&scene, &start, &Unloaded, $dt)?;
            run.run_to(1.0)?;
            let tip = run.stations().last().unwrap();
            let error = (tip[X] + 0.43225486262).abs().max((tip[Y] + 0.90061862755).abs());
            println!("{}, step {}: {error:.2e} m, {} sweeps", $name, $dt, run.sweeps());
            error
        }};
    }
    let joints = JointScheme::new(Newmark::new(0.25, 0.5));
    for (dt, known) in [(0.01, 1.1e-3), (0.0025, 4e-5), (0.001, 2.2e-6)] {
        let found = error!("joints", joints, dt);
        assert!((found / known - 1.0_f64).abs() < 0.1, "{found:e} {known:e}");
    }
    for (dt, known) in [(0.01, 1.2e-3), (0.0025, 4.5e-5)] {
        let found = error!("joints, one sweep", joints.with_sweeps(1), dt);
        assert!((found / known - 1.0_f64).abs() < 0.1, "{found:e} {known:e}");
    }
    let alpha = Scheme::new(GeneralizedAlpha::new(0.8)).solved_by(Solver::Riccati);
    for at in [At::Previous, At::Predictor, At::Iterated] {
        let [coarse, fine] =
            [0.002, 0.001].map(|dt| -> Result<f64, Error> { Ok(error!(format!("{at:?}"), alpha.linearized(at), dt)) });
        let (coarse, fine): (f64, f64) = (coarse?, fine?);
        assert!(fine < 0.5 * coarse && fine < 1e-3, "{coarse:e} {fine:e}");
    }
    Ok(())
}

/// Example 3: a clamped beam (L, ρA and EI one) under 1e-3 N · sin 5t at its end, against w = A R sin ωt − modal terms, with the
/// receptance R in closed form. The spring at the clamp is that of half a segment, 2EI/ℓ.
#[test]
fn cantilever_converges_to_the_beam_with_order_two() -> Result<(), Error> {
    let (force, omega) = (1e-3, 5.0);
    let exact = |t: f64| {
        let receptance = -0.306289527747543;
        // cos β cosh β = −1, by Newton's method from the asymptote.
        let modes = (0..60).map(|r| {
            let mut beta = if r == 0 { 1.8751 } else { (r as f64 + 0.5) * core::f64::consts::PI };
            for _ in 0..6 {
                let value = beta.cos() + 1.0 / beta.cosh();
                beta -= value / (-beta.sin() - beta.tanh() / beta.cosh());
            }
            let own = beta * beta;
            omega * (own * t).sin() / (own * (own * own - omega * omega))
        });
        force * receptance * (omega * t).sin() - 4.0 * force * modes.sum::<f64>()
    };
    // The series against values of an independent evaluation.
    assert!((exact(2.0) - 4.7295195602412e-4).abs() < 1e-12);

    let mut errors = vec![];
    for n in [20, 40, 80] {
        let size = 1.0 / n as f64;
        let rod = Rod::uniform(size, size);
        let clamp = ElasticHinge::rotary(2.0 / size);
        let links = vec![(ElasticHinge::rotary(1.0 / size), rod); n - 1];
        let scene = System::new(Clamped::at(0.0, 0.0, 0.0), (clamp, rod, links), Free)?;
        let start = scene.at_rest(&vec![0.0; n])?;
        let loads = Loads::none().on_bodies(|t, body, motion: &BodyMotion<f64>| {
            let pull = if body == n - 1 { force * f64::sin(omega * t) } else { 0.0 };
            motion.force_at([size, 0.0], [0.0, pull])
        });
        let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).linearized(At::Predictor).solved_by(Solver::Riccati);
        let mut run = scheme.start(&scene, &start, &loads, 1e-3)?;
        let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
        for time in [0.25, 0.5, 1.0, 2.0, 5.0, 10.0] {
            run.run_to(time)?;
            let w = run.stations()[2 * n + 1][Y];
            worst = worst.max((w - exact(time)).abs());
            largest = largest.max(exact(time).abs());
        }
        println!("n = {n}: {:.4}", worst / largest);
        errors.push(worst / largest);
    }
    assert!((errors[0] / 0.0363 - 1.0).abs() < 0.1, "{errors:?}");
    for pair in errors.windows(2) {
        let fall = pair[0] / pair[1];
        assert!((fall - 4.0).abs() < 0.3, "{errors:?}");
    }
    Ok(())
}
