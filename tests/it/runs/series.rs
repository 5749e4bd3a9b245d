//! Taylor series through kept gains: coefficients, runs, what is read within steps.
//!
//! Coefficients are those of `series.csv`, whose head says how they were found.

use super::by_series::{Drive, apart, are_coefficients_of, beside_dop853, expansion, hangs_at_odd_quarters};
use catena::Error;
use catena::planar::*;
use catena_oracle::{has_order, near};
use core::f64::consts::FRAC_PI_2;

const G: f64 = 9.81;

/// The pendulum of two unlike rods that move.
macro_rules! pendulum {
    () => {{
        let scene = System::new(Pinned::origin(), (Rod::uniform(1.0, 1.0), Pin, Rod::uniform(0.7, 0.4)), Free)?;
        let scene = scene.with_gravity(G);
        let start = scene.with_rates(scene.at_rest(&[-1.0, -0.5])?, &[0.8, -1.5])?;
        (scene, start)
    }};
}

/// Two rods that are released from the horizontal.
macro_rules! released {
    () => {{
        let rod = Rod::uniform(0.5, 0.5);
        let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(G);
        let start = scene.at_rest(&[0.0, 0.0])?;
        (scene, start)
    }};
}

/// A tree with an arm, of all bodies and joints that have series.
macro_rules! tree {
    () => {{
        let (rod, body) = (Rod::uniform(0.5, 0.5), RigidBody::new(0.8, 0.05, [0.2, 0.1], [0.4, -0.1]));
        let hinge = ElasticHinge::rotary(3.0).damped(0.1).resting_at(0.2);
        let arm = Branch((hinge, rod, Weld::at(0.4), body));
        let rest = (PointMass::new(0.3, 0.2), rod, hinge.named("knee"), [(rod, Pin); 2], body);
        let scene = System::new(Clamped::at(0.1, 0.2, 0.3).named("wall"), (body, arm, Pin, rest), Free)?;
        let scene = scene.with_gravity(G);
        let rates = [0.3, -0.2, 0.5, 0.1, 0.7];
        // The first hinge stands against the body on the wall, the second against the rod before it.
        let start = scene.with_rates(scene.at_rest(&[0.3, -0.2, 0.5, 0.1, 0.7])?, &rates)?;
        (scene, start)
    }};
}

/// A tree whose bodies slide along each other, one of them on a spring.
macro_rules! sliders {
    () => {{
        let (rod, body) = (Rod::uniform(0.5, 0.5), RigidBody::new(0.8, 0.05, [0.2, 0.1], [0.4, -0.1]));
        let track = Slider::along(0.2).with(Spring::new(50.0).damped(0.5).resting_at(0.1));
        let arm = Branch((Slider::along(0.7), rod));
        let chain = (track, body, Pin, rod, arm, Slider::along(-0.4), body);
        let scene = System::new(Clamped::at(0.1, 0.2, 0.3), chain, Free)?.with_gravity(G);
        let mut start = scene.with_rates(scene.at_rest(&[-0.4])?, &[0.3, 1.2, -0.5, 0.4])?;
        start.set_coordinates(&[0.15, -0.4, 0.2, -0.1])?;
        (scene, start)
    }};
}

/// By how much coefficients of each order miss those of the file, as a share of the largest of that order.
macro_rules! misses {
    ($name:expr, $scene:expr, $start:expr, $order:literal) => {
        misses!($name, $scene, $start, $order, Unloaded)
    };
    ($name:expr, $scene:expr, $start:expr, $order:literal, $loads:expr) => {{
        let (found, stepped) = expansion!($order, $scene, $start, $loads, 1e-3);
        stepped?;
        are_coefficients_of(include_str!("series.csv"), $name, &found, 1e-13);
        found
    }};
}

#[test]
fn coefficients_are_those_of_lagranges_equations() -> Result<(), Error> {
    let (scene, start) = pendulum!();
    misses!("pendulum", scene, start, 30);
    let (scene, start) = tree!();
    misses!("tree", scene, start, 20);
    let (scene, start) = sliders!();
    misses!("sliders", scene, start, 20);
    misses!("driven", scene, start.at_time(0.7), 20, Loads::none().in_joints_over_time(Drive));
    Ok(())
}

#[test]
fn from_the_horizontal_every_fourth_is_not_zero() -> Result<(), Error> {
    let (scene, start) = released!();
    let found = misses!("horizontal", scene, start, 20);
    for (k, row) in found.iter().enumerate() {
        assert!(row.iter().all(|x| (*x != 0.0) == (k % 4 == 0)), "order {}: {row:?}", k + 1);
    }
    Ok(())
}

#[test]
fn runs_end_at_the_references() -> Result<(), Error> {
    // As in `references.rs`: all digits of an independent integration at 30 digits.
    let (scene, start) = released!();
    for tolerance in [1e-4, 1e-8, 1e-12, 1e-15] {
        let run = scene.simulate(start, Taylor::<30>::tolerance(tolerance), 2.0, |_| ())?;
        let error = (run.motion.position().1.1 + 0.9071302549910606).abs();
        println!("two rods, {tolerance:e}: {} steps, error {error:.1e}", run.steps);
        assert!(error < 50.0 * tolerance + 1e-13 && run.rejected == 0 && run.sweeps == run.steps);
    }
    let rod = Rod::uniform(0.05, 0.05);
    let chain = System::new(Pinned::origin(), (rod, [(Pin, rod); 19]), Free)?.with_gravity(G);
    let run = chain.simulate(chain.at_rest(&[0.0; 20])?, Taylor::<20>::tolerance(1e-15), 0.5, |_| ())?;
    println!("twenty rods: {} steps, error {:.1e}", run.steps, run.motion.position().1.1[18].0 + 3.0330002988365);
    near(run.motion.position().1.1[18].0, -3.0330002988365, 1e-11);
    Ok(())
}

#[test]
fn trees_move_as_under_dop853() -> Result<(), Error> {
    macro_rules! compare {
        ($scene:expr, $loads:expr) => {{
            let (scene, start) = $scene;
            let (series, other) = beside_dop853!(20, scene, $loads, start, 1.0);
            let (series_end, other_end) = (&series.motion, &other.motion);
            let miss = apart(&series_end.coordinates(), &other_end.coordinates());
            let miss = miss.max(1e-2 * apart(&series_end.accelerations(), &other_end.accelerations()));
            println!("{} steps, apart by {miss:.1e}", series.steps);
            assert!(miss < 1e-11);
        }};
    }
    compare!(tree!(), Unloaded);
    compare!(sliders!(), Unloaded);
    compare!(sliders!(), Loads::none().in_joints_over_time(Drive));
    Ok(())
}

#[test]
fn torques_may_jump_between_steps() -> Result<(), Error> {
    let (scene, start) = pendulum!();
    let (mut series, mut other) = (scene.stepper(Taylor::<20>), scene.stepper(Dop853));
    let (mut now, mut next, mut by_other) = (start, start, start);
    for cycle in 0..20 {
        let loads = Loads::none().torques([if cycle % 3 == 0 { 2.0 } else { -1.0 }, 0.1 * f64::from(cycle)]);
        series.step(&now, &loads, 0.01, &mut next)?;
        core::mem::swap(&mut now, &mut next);
        other.step(&by_other, &loads, 0.01, &mut next)?;
        core::mem::swap(&mut by_other, &mut next);
    }
    near(now.position().1.1, by_other.position().1.1, 1e-11);
    near(now.acceleration().1.1, by_other.acceleration().1.1, 1e-8);
    Ok(())
}

#[test]
fn tolerances_choose_orders() -> Result<(), Error> {
    let (scene, start) = pendulum!();
    let (mut any, mut few) = (scene.stepper(Taylor::<30>), scene.stepper(Taylor::<12>));
    let mut orders = vec![];
    for tolerance in [1e-3, 1e-13, 1e-7] {
        let (long, short) = (any.propose(&start, &Unloaded, tolerance), few.propose(&start, &Unloaded, tolerance));
        orders.push((any.error_order(), few.error_order()));
        // More orders reach farther.
        assert!(long >= short && (any.error_order() > 12) == (long > short), "{long:?} {short:?}");
    }
    assert_eq!(orders, [(8, 8), (24, 12), (14, 12)]);
    Ok(())
}

#[test]
fn energy_stays() -> Result<(), Error> {
    let (scene, start) = pendulum!();
    let (first, mut drift) = (scene.budget(&start)?.energy(), 0.0_f64);
    let run = scene.simulate(start, Taylor::<20>::tolerance(1e-15), 20.0, |now| {
        drift = drift.max((now.energy() - first).abs());
    })?;
    println!("{} steps, {drift:.1e} J of {first:.1}", run.steps);
    assert!(drift < 2e-12);
    Ok(())
}

#[test]
fn orders_are_those_of_the_series() -> Result<(), Error> {
    let (scene, start) = pendulum!();
    let (mut few, mut many) = (scene.stepper(Taylor::<8>), scene.stepper(Taylor::<30>));
    let (mut next, mut exact, mut end) = (start, start, start);
    let (mut within, mut rates, mut whole) = (vec![], vec![], vec![]);
    for dt in [0.12, 0.1, 0.08, 0.06] {
        few.step(&start, &Unloaded, dt, &mut next)?;
        many.step(&start, &Unloaded, dt, &mut end)?;
        few.interpolate(&start, &Unloaded, dt, &next.clone(), 0.7, &mut next);
        many.interpolate(&start, &Unloaded, dt, &end, 0.7, &mut exact);
        within.push((dt, (next.position().1.1 - exact.position().1.1).abs()));
        rates.push((dt, (next.rate().1.1 - exact.rate().1.1).abs()));
    }
    // What is left out begins with the power P + 2 of positions, P + 1 of rates.
    has_order("position within a step", 10.0, 1e-15, &within);
    has_order("rate within a step", 9.0, 1e-15, &rates);
    let exact = scene.simulate(start, Taylor::<30>::tolerance(1e-15), 0.6, |_| ())?.motion;
    for dt in [0.06, 0.05, 0.04, 0.03] {
        let run = scene.simulate(start, Taylor::<8>::step(dt), 0.6, |_| ())?;
        whole.push((dt, (run.motion.position().1.1 - exact.position().1.1).abs()));
    }
    has_order("a run of steps of one size", 8.0, 1e-14, &whole);
    Ok(())
}

#[test]
fn events_are_found_on_the_polynomial() -> Result<(), Error> {
    // A rod released from the horizontal hangs after K(sin 45°) / √(3 g / 2 l), K the complete elliptic integral (Abramowitz and
    // Stegun, table 17.1).
    let pendulum = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Free)?.with_gravity(G);
    let quarter = 1.854_074_677_301_372 / (1.5 * G).sqrt();
    let mut found = vec![];
    let run = pendulum
        .simulation(Taylor::<20>::tolerance(1e-14))
        .event(|now| now.motion().position().0 + FRAC_PI_2)
        .run(pendulum.at_rest(&[0.0])?, 7.5 * quarter, |now| {
            if now.is_event() {
                found.push(now.time());
            }
        })?;
    println!("{} steps, events at {found:?}, a quarter is {quarter}", run.steps);
    hangs_at_odd_quarters(&found, quarter);
    Ok(())
}

#[test]
fn single_precision_keeps_its_digits() -> Result<(), Error> {
    let (scene, start) = pendulum!();
    let exact = scene.simulate(start, Taylor::<20>::tolerance(1e-14), 1.0, |_| ())?.motion;
    let single = scene.lift(|x| x as f32);
    let start = single.with_rates(single.at_rest(&[-1.0, -0.5])?, &[0.8, -1.5])?;
    let run = single.simulate(start, Taylor::<8>::tolerance(1e-6), 1.0, |_| ())?;
    let miss = (f64::from(run.motion.position().1.1) - exact.position().1.1).abs();
    println!("{} steps, {miss:.1e}", run.steps);
    assert!(miss < 2e-5 && run.rejected == 0);
    Ok(())
}

#[test]
fn what_does_not_move_takes_one_step() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 0.5);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
    let run = scene.simulate(scene.at_rest(&[0.3, 0.4])?, Taylor::<12>::tolerance(1e-9), 10.0, |_| ())?;
    assert_eq!((run.steps, run.motion.position().1.1), (1, 0.4));
    Ok(())
}

#[test]
fn faults_are_those_of_other_rules() -> Result<(), Error> {
    let (rod, link) = (Rod::uniform(0.5, 0.5), RigidBody::massless([0.5, 0.0]));
    let scene = System::new(Pinned::origin(), (rod, Pin, link), Free)?.with_gravity(G);
    let start = scene.at_rest(&[0.3, 0.4])?;
    let mut next = start;
    let by_series = scene.stepper(Taylor::<12>).step(&start, &Unloaded, 0.01, &mut next);
    let by_sweeps = scene.stepper(Dop853).step(&start, &Unloaded, 0.01, &mut next);
    assert!(by_series.is_err() && by_series == by_sweeps, "{by_series:?}, {by_sweeps:?}");
    // A wheel that nothing holds back turns farther than angles are known.
    let wheel = System::new(Pinned::origin(), rod, Free)?;
    let start = wheel.with_rates(wheel.motion(), &[1.0])?;
    let by_series = wheel.simulate(start, Taylor::<12>::tolerance(1e-9), 1e12, |_| ()).unwrap_err().error;
    assert!(matches!(by_series.fault, catena::Fault::AngleOutOfRange { .. }), "{by_series:?}");
    Ok(())
}

/// The error of each coordinate is kept by its own size: a pendulum is as exact on a slider that moves at a thousand kilometres a second.
#[test]
fn what_moves_fast_does_not_loosen_the_tolerance_of_others() -> Result<(), Error> {
    let body = RigidBody::new(1.0, 0.1, [0.0; 2], [0.0; 2]);
    let chain = (Slider::along(0.0), body, Pin, Rod::uniform(1.0, 1.0));
    let scene = System::new(Clamped::origin(), chain, Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[0.3])?;
    let exact = scene.simulate(start, Dop853::tolerance(1e-14), 2.0, |_| ())?.motion.coordinates()[1];
    for speed in [0.0, 1e6] {
        let start = scene.with_rates(start, &[speed, 0.0])?;
        let run = scene.simulate(start, Taylor::<24>::tolerance(1e-10), 2.0, |_| ())?;
        println!("{speed} m/s: {} steps, error {:.1e}", run.steps, run.motion.coordinates()[1] - exact);
        near(run.motion.coordinates()[1], exact, 1e-8);
    }
    Ok(())
}
