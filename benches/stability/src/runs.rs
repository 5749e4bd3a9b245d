//! Runs by every rule: steps from 1e-1 to 1e-5 s, stiffness from 1 to 1e14.
//!
//! Base scenes: two rods of 1/2 m and 1/2 kg on pins, released from the horizontal, for 2 s; and five rods of 1/5 m and 1/5 kg on
//! springs of 20 N·m/rad, straight and at rest, for 0.5 s at steps of 10 ms. Errors are those of the angles (rad).

use crate::table::Table;
use catena::loading::Unloaded;
use catena::paper;
use catena::planar::*;

fn say(error: impl std::fmt::Display) -> String {
    error.to_string()
}

/// Absolute angles of two rods on pins after 2 s, by a rule over numbers of one type.
macro_rules! steps {
    ($table:ident, $T:ident, $exact:ident, $least:expr) => {{
        let rod = Rod::uniform(0.5 as $T, 0.5);
        let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free).expect("a scene").with_gravity(9.81 as $T);
        let start = scene.at_rest(&[0.0, 0.0]).expect("a start");
        let off = |motion| -> Result<f64, String> {
            let angles = scene.angles(&motion).map_err(say)?;
            let worst = angles.iter().zip(&$exact).fold(0.0_f64, |worst, (a, b)| worst.max((f64::from(*a) - b).abs()));
            if worst.is_finite() { Ok(worst) } else { Err("not finite, and no error returned".to_owned()) }
        };
        macro_rules! rule {
            ($name:literal, $rule:expr) => {
                for dt in STEPS.into_iter().filter(|dt| *dt >= $least) {
                    crate::progress(&format!("runs, {} {} {dt:.0e}", $name, stringify!($T)));
                    let rule = $rule;
                    let run = scene.simulate(start, rule(dt as $T), 2.0, |_| ()).map_err(|stopped| say(stopped.error));
                    let outcome = run.and_then(|run| off(run.motion));
                    $table.add("runs", "2 rods on pins", "step (s)", dt, $name, stringify!($T), outcome);
                }
            };
        }
        rule!("RK4", Rk4::step);
        rule!("DOPRI5", Dopri5::step);
        rule!("DOP853", Dop853::step);
        rule!("Adams", Adams::step);
        rule!("Vcabm", |dt| Vcabm::default().step(dt));
        rule!("Taylor 16", Taylor::<16>::step);
        rule!("generalised-alpha", |dt| GeneralizedAlpha::new(0.8).step(dt));
        rule!("SDIRK4", |dt| Sdirk4::new().step(dt));
        macro_rules! scheme {
            ($name:literal, $scheme:expr) => {
                for dt in STEPS.into_iter().filter(|dt| *dt >= $least) {
                    crate::progress(&format!("runs, {} {} {dt:.0e}", $name, stringify!($T)));
                    let scheme = $scheme.solved_by(paper::Solver::Riccati);
                    let run = scheme.start(&scene, &start, &Unloaded, dt as $T).map_err(say);
                    let outcome = run.and_then(|mut run| {
                        run.run_to(2.0).map_err(say)?;
                        let of = |(angle, exact): ($T, &f64)| (f64::from(angle) - exact).abs();
                        let worst = run.angles().zip(&$exact).map(of).fold(0.0_f64, f64::max);
                        if worst.is_finite() { Ok(worst) } else { Err("not finite".to_owned()) }
                    });
                    $table.add("runs", "2 rods on pins", "step (s)", dt, $name, stringify!($T), outcome);
                }
            };
        }
        scheme!("2005, γ = 1/2", paper::Scheme::new(paper::Newmark::new(0.25, 0.5)));
        scheme!("2005, γ = 0.6", paper::Scheme::new(paper::Newmark::damped(0.6)));
        scheme!(
            "2005, gen.-alpha",
            paper::Scheme::new(paper::GeneralizedAlpha::new(0.8)).linearized(paper::At::Predictor)
        );
    }};
}

const STEPS: [f64; 5] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5];

pub fn run(table: &mut Table, quick: bool) {
    let rod = Rod::uniform(0.5, 0.5);
    let exact = || -> Result<Vec<f64>, String> {
        let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free).map_err(say)?.with_gravity(9.81);
        let start = scene.at_rest(&[0.0, 0.0]).map_err(say)?;
        let run = scene.simulate(start, Dop853::tolerance(1e-14), 2.0, |_| ()).map_err(say)?;
        Ok(scene.angles(&run.motion).map_err(say)?.iter().copied().collect())
    };
    let exact = exact().unwrap_or_default();
    let least = if quick { 1e-3 } else { 1e-5 };
    steps!(table, f64, exact, least);
    steps!(table, f32, exact, least);
    stiff(table, quick);
}

/// Angles of five rods after half a second, at rest at first, by a rule.
macro_rules! bent {
    ($joint:expr, $rule:expr) => {{
        let rod = Rod::uniform(0.2, 0.2);
        (|| -> Result<Vec<f64>, String> {
            let scene = System::new(Pinned::origin(), (rod, [($joint, rod); 4]), Free).map_err(say)?.with_gravity(9.81);
            let angles = if scene.motion().rate_count() == 1 { vec![0.0] } else { vec![0.0; 5] };
            let start = scene.at_rest(&angles).map_err(say)?;
            let run = scene.simulate(start, $rule, 0.5, |_| ()).map_err(|stopped| say(stopped.error))?;
            Ok(scene.angles(&run.motion).map_err(say)?.iter().copied().collect())
        })()
    }};
}

/// Stiff springs: beyond 1e7 N·m/rad the reference is the motion of welds, from which springs differ by some 1e-8 rad.
fn stiff(table: &mut Table, quick: bool) {
    for stiffness in [1.0, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14] {
        crate::progress(&format!("runs, stiffness {stiffness:.0e}"));
        let spring = ElasticHinge::rotary(stiffness);
        let exact = match stiffness < 1e7 && !(quick && stiffness > 1e5) {
            true => bent!(spring, Dop853::tolerance(1e-13)),
            false => bent!(Weld::at(0.0), Dop853::tolerance(1e-13)),
        };
        let mut add = |name: &str, found: Result<Vec<f64>, String>| {
            let outcome = found.and_then(|found| {
                let exact = exact.as_ref().map_err(|text| format!("no reference: {text}"))?;
                let worst = found.iter().zip(exact).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
                if worst.is_finite() { Ok(worst) } else { Err("not finite, and no error returned".to_owned()) }
            });
            table.add("runs", "5 rods on springs", "stiffness (N·m/rad)", stiffness, name, "f64", outcome);
        };
        add("RK4 of 10 ms", bent!(spring, Rk4::step(0.01)));
        add("generalised-alpha of 10 ms", bent!(spring, GeneralizedAlpha::new(0.8).step(0.01)));
        add("SDIRK4 of 10 ms", bent!(spring, Sdirk4::new().step(0.01)));
        add("generalised-alpha, 1e-8", bent!(spring, GeneralizedAlpha::new(0.8).tolerance(1e-8)));
        add("SDIRK4, 1e-10", bent!(spring, Sdirk4::new().tolerance(1e-10)));
        if stiffness < 1e9 && !quick {
            add("DOP853, 1e-10", bent!(spring, Dop853::tolerance(1e-10)));
        }
    }
}
