//! Roots of the paper's scheme: loads in their joint, and hinges and bodies on ground that turns, against closed forms and order 8.
#![cfg(feature = "std")]

use catena::loading::Unloaded;
use catena::paper::{At, GeneralizedAlpha, JointScheme, Midpoint, Newmark, Scheme, Slots, Solver, Wilson};
use catena::planar::index::{M, QX, QY, THETA, X, Y};
use catena::planar::*;
use catena::{Error, spatial};
use catena_oracle::{has_order, near};

const ATS: [At; 3] = [At::Previous, At::Predictor, At::Iterated];
const SOLVERS: [Solver; 2] = [Solver::Product, Solver::Riccati];
const STEPS: [f64; 3] = [0.01, 0.005, 0.0025];

type Law = fn(f64, usize, &JointMotion<f64>) -> f64;

fn in_joints(law: Law) -> Loads<Absent, InJoints<Law>> {
    Loads::none().in_joints(law)
}

/// The ground turns by 0.4 sin 2t (rad).
fn sway(t: f64) -> [f64; 3] {
    [0.4 * (2.0 * t).sin(), 0.8 * (2.0 * t).cos(), -1.6 * (2.0 * t).sin()]
}

/// J = 1/12 kg·m² about the mass centre, whatever the rod does besides: θ = M t² / 2J under a torque M = 2 N·m, and
/// θ = ω J/c (1 − exp(−ct/J)) under one of −cθ̇.
#[test]
fn torques_in_joint_0_turn_what_nothing_holds() -> Result<(), Error> {
    let scene = System::new(Free, Rod::uniform(1.0, 1.0), Free)?;
    let (start, push) = (scene.motion(), in_joints(|_, _, _| 2.0));
    macro_rules! pushed {
        ($scheme:expr) => {{
            let mut run = $scheme.start(&scene, &start, &push, 0.01)?;
            run.run_to(0.5)?;
            near(run.angles().next().unwrap_or(f64::NAN), 3.0, 1e-11);
            near(run.stations()[0][M], -2.0, 1e-11);
        }};
    }
    pushed!(JointScheme::new(GeneralizedAlpha::new(0.8)));
    pushed!(JointScheme::new(GeneralizedAlpha::new(0.8)).with_sweeps(1));
    pushed!(JointScheme::new(Newmark::damped(0.6)));
    pushed!(JointScheme::new(Wilson::new(1.42)));
    pushed!(JointScheme::new(Midpoint));

    let start = scene.with_rates(scene.motion(), &[0.0, -0.5, 1.0])?;
    let (damper, end) = (in_joints(|_, _, motion| -0.3 * motion.rate()), 0.5);
    let exact = (1.0 - f64::exp(-0.3 * 12.0 * end)) / (0.3 * 12.0);
    let mut errors = [vec![], vec![], vec![]];
    for dt in STEPS {
        let scheme = JointScheme::new(GeneralizedAlpha::new(0.8));
        let mut run = scheme.start(&scene, &start, &damper, dt)?;
        run.run_to(end)?;
        let mut once = scheme.with_sweeps(1).start(&scene, &start, &damper, dt)?;
        once.run_to(end)?;
        let mut plain = Scheme::new(GeneralizedAlpha::new(0.8)).solved_by(Solver::Riccati);
        plain = plain.linearized(At::Predictor);
        let mut plain = plain.start(&scene, &start, &damper, dt)?;
        plain.run_to(end)?;
        // Its own inboard end stands where the ground's side would.
        near(run.stations()[0][THETA], run.stations()[1][THETA], 0.0);
        near(plain.stations()[0][THETA], plain.stations()[1][THETA], 0.0);
        let found = [run.angles().next(), once.angles().next(), plain.angles().next()];
        for (errors, found) in errors.iter_mut().zip(found) {
            errors.push((dt, (found.unwrap_or(f64::NAN) - exact).abs()));
        }
    }
    for (name, errors) in ["iterated", "one sweep", "as printed"].iter().zip(&errors) {
        has_order(name, 2.0, 1e-12, errors);
    }
    Ok(())
}

/// Along the line a rod of 1 kg is a point: s = t² under 2 N, s = F/c (t − (1 − exp(−ct))/c) with a damper besides; and s = t², if the load
/// takes off the centrifugal force of a line that turns at Ω = 3 rad/s.
#[test]
fn forces_in_joint_0_push_along_the_line_of_a_guided_root() -> Result<(), Error> {
    let rod = Rod::uniform(1.0, 1.0);
    macro_rules! slid {
        ($name:expr, $scene:expr, $load:expr, $end:expr, $exact:expr, $order:expr) => {{
            let (scene, loads) = ($scene?, in_joints($load));
            let start = scene.motion();
            for (at, solver) in ATS.into_iter().flat_map(|at| SOLVERS.map(|solver| (at, solver))) {
                let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).linearized(at).solved_by(solver);
                let mut errors = vec![];
                for dt in STEPS {
                    let mut run = scheme.start(&scene, &start, &loads, dt)?;
                    run.run_to($end)?;
                    let z = run.stations()[0];
                    let [x, y, _]: [f64; 3] = $exact;
                    let off = (z[X] - x).hypot(z[Y] - y);
                    errors.push((dt, off));
                    if !$order {
                        near(off, 0.0, 1e-7);
                        // The force ON the body along the line.
                        near(z[QX] * x + z[QY] * y, $exact[2] * x.hypot(y), 1e-9);
                    }
                }
                if $order {
                    has_order(&format!("{}, {at:?}, {solver:?}", $name), 2.0, 1e-10, &errors);
                }
            }
        }};
    }
    let place = |s: f64, direction: f64, force: f64| [s * direction.cos(), s * direction.sin(), force];
    let leaning = || System::new(Guided::on(Clamped::at(0.0, 0.0, 0.3), 0.2), rod, Free);
    let (upright, back) = (core::f64::consts::FRAC_PI_2, 2.5);
    slid!("leaning", leaning(), |_, _, _| 2.0, 0.5, place(0.25, 0.5, 2.0), false);
    let along = |angle: f64| System::new(Guided::on(Clamped::origin(), angle), rod, Free);
    slid!("upright", along(upright), |_, _, _| 2.0, 0.5, place(0.25, upright, 2.0), false);
    slid!("back", along(back), |_, _, _| 2.0, 0.5, place(0.25, back, 2.0), false);
    let damped = (2.0 / 0.8) * (0.5 - (1.0 - f64::exp(-0.4)) / 0.8);
    slid!("damped", leaning(), |_, _, motion| 2.0 - 0.8 * motion.driven_rate(), 0.5, place(damped, 0.5, 0.0), true);
    let turning = Clamped { place: [0.0, 0.0], attitude: Turning(|t: f64| [3.0 * t, 3.0, 0.0]) };
    // The mass centre lies s + ½ cos 0.2 along the line.
    let slung: Law = |_, _, motion| 2.0 - 9.0 * (motion.driven() + 0.5 * f64::cos(0.2));
    slid!("turning", System::new(Guided::on(turning, 0.2), rod, Free), slung, 0.5, place(0.25, 1.7, 0.0), true);
    Ok(())
}

/// A rod that turns with the ground from the start goes on with it: its spring is never strained.
#[test]
fn springs_on_ground_that_turns_steadily_stay_unstrained() -> Result<(), Error> {
    let ground = Clamped { place: [0.0, 0.0], attitude: Turning(|t: f64| [0.2 * t, 0.2, 0.0]) };
    let scene = System::new(ground, (ElasticHinge::rotary(20.0), Rod::uniform(1.0, 1.0)), Free)?;
    let start = scene.motion();
    macro_rules! steady {
        ($scheme:expr) => {{
            let mut run = $scheme.start(&scene, &start, &Unloaded, 0.01)?;
            run.run_to(1.0)?;
            near(run.angles().next().unwrap_or(f64::NAN), 0.2, 1e-12);
        }};
    }
    for (at, solver) in ATS.into_iter().flat_map(|at| SOLVERS.map(|solver| (at, solver))) {
        steady!(Scheme::new(Midpoint).linearized(at).solved_by(solver));
        steady!(Scheme::new(Wilson::new(1.42)).linearized(at).solved_by(solver));
    }

    let turning = spatial::Turning(|t: f64| spatial::AttitudeMotion {
        attitude: spatial::Rotation::exp([0.0, 0.0, 0.2 * t]),
        spin: [0.0, 0.0, 0.2],
        acceleration: [0.0; 3],
    });
    let chain = (spatial::ElasticHinge::rotary([20.0; 3]), spatial::Rod::uniform(1.0, 0.2, 1.0));
    let scene = spatial::System::new(spatial::Clamped::on([0.0; 3], turning), chain, spatial::Free)?;
    let start = scene.motion();
    macro_rules! steady {
        ($scheme:expr) => {{
            let mut run = $scheme.solved_by(Solver::Riccati).start(&scene, &start, &Unloaded, 0.01)?;
            run.run_to(1.0)?;
            let angles = run.attitude(0).unwrap_or([f64::NAN; 3]);
            angles.iter().zip([0.0, 0.0, 0.2]).for_each(|(found, expected)| near(*found, expected, 1e-11));
        }};
    }
    for slots in [Slots::Angles, Slots::RotationVectors] {
        steady!(Scheme::new(Midpoint).linearized(At::Predictor).turning_by(slots));
        steady!(Scheme::new(Wilson::new(1.42)).linearized(At::Predictor).turning_by(slots));
    }
    Ok(())
}

/// A rod held fast, or on a spring, by ground that sways, and a second one on a pin.
#[test]
fn rules_that_balance_elsewhere_have_order_two_on_ground_that_turns() -> Result<(), Error> {
    let rod = Rod::uniform(1.0, 1.0);
    macro_rules! order {
        ($name:expr, $scene:expr, $scheme:expr) => {{
            let start = $scene.motion();
            let end = $scene.simulate(start.clone(), Dop853::tolerance(1e-12), 0.6, |_| ())?.motion;
            let exact = $scene.angles(&end)?;
            let mut errors = vec![];
            for dt in STEPS {
                let mut run = $scheme.start(&$scene, &start, &Unloaded, dt)?;
                run.run_to(0.6)?;
                let error = run.angles().zip(exact.iter()).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
                errors.push((dt, error));
            }
            has_order($name, 2.0, 1e-11, &errors);
        }};
    }
    let ground = Clamped { place: [0.0, 0.0], attitude: Turning(sway as fn(f64) -> [f64; 3]) };
    let fast = System::new(ground, (rod, Pin, rod), Free)?.with_gravity(9.81);
    let sprung = System::new(ground, (ElasticHinge::rotary(20.0).damped(0.3), rod, Pin, rod), Free)?.with_gravity(9.81);
    order!("held fast, midpoint, joint coordinates", fast, JointScheme::new(Midpoint));
    order!("held fast, Wilson, joint coordinates", fast, JointScheme::new(Wilson::new(1.42)));
    order!("sprung, midpoint, joint coordinates", sprung, JointScheme::new(Midpoint));
    let riccati = Scheme::new(Wilson::new(1.42)).solved_by(Solver::Riccati).linearized(At::Predictor);
    order!("sprung, Wilson, Riccati", sprung, riccati);
    let iterated = Scheme::new(Midpoint).solved_by(Solver::Riccati).linearized(At::Iterated);
    order!("sprung, midpoint, Riccati, iterated", sprung, iterated);
    Ok(())
}
