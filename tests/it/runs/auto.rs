//! The rule that chooses among rules: what it chooses, what that costs, and that runs go on as they were saved.

use catena::planar::*;
use catena::simulate::{Chosen, Stepper};
use std::error::Error;

/// Sweeps that find that a scene has neither springs nor dampers.
const LOOK: usize = 3;

#[test]
fn what_is_not_stiff_runs_by_one_rule() -> Result<(), Box<dyn Error>> {
    let rod = Rod::uniform(0.5, 0.5);
    let two = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let start = two.at_rest(&[0.0; 2])?;
    let (auto, alone) = (
        two.simulate(start, Auto::tolerance(1e-8), 2.0, |_| ())?,
        two.simulate(start, Dop853::tolerance(1e-8), 2.0, |_| ())?,
    );
    assert_eq!((auto.motion.coordinates(), auto.sweeps), (alone.motion.coordinates(), alone.sweeps + LOOK));
    let rod = Rod::uniform(0.1, 0.1);
    let many = System::new(Pinned::origin(), (rod, [(Pin, rod); 9]), Free)?.with_gravity(9.81);
    let start = many.at_rest(&[0.0; 10])?;
    let (auto, alone) = (
        many.simulate(start, Auto::tolerance(1e-8), 0.5, |_| ())?,
        many.simulate(start, Vcabm::new().tolerance(1e-8), 0.5, |_| ())?,
    );
    assert_eq!((auto.motion.coordinates(), auto.sweeps), (alone.motion.coordinates(), alone.sweeps + LOOK));
    Ok(())
}

#[test]
fn with_series_runs_are_by_these_or_at_coarse_tolerances_by_steps() -> Result<(), Box<dyn Error>> {
    let rod = Rod::uniform(0.1, 0.1);
    let many = System::new(Pinned::origin(), (rod, [(Pin, rod); 9]), Free)?.with_gravity(9.81);
    let start = many.at_rest(&[0.0; 10])?;
    let auto = many.simulate(start, AutoTaylor::<24>::tolerance(1e-8), 0.5, |_| ())?;
    let alone = many.simulate(start, Taylor::<24>::tolerance(1e-8), 0.5, |_| ())?;
    assert_eq!((auto.motion.coordinates(), auto.sweeps), (alone.motion.coordinates(), alone.sweeps + LOOK));
    let mut run = many.simulation(AutoTaylor::<24>::tolerance(1e-3)).begin(start, 0.5, |_| ())?;
    run.until(0.3)?;
    assert_eq!(run.stepper().chosen(), Chosen::Vcabm);
    // A race of another kind is refused.
    let mut run = many.simulation(AutoTaylor::<24>::tolerance(1e-8)).begin(start, 0.5, |_| ())?;
    run.until(0.1)?;
    let refused = many.simulation(Auto::tolerance(1e-8)).resume(run.save(), 0.5, |_| ()).err().ok_or("taken")?;
    assert_eq!(refused.error.fault, catena::Fault::Shape);
    Ok(())
}

/// Drives each joint by a sine of time.
struct Sines;

impl catena::loading::TimeLaw<f64> for Sines {
    fn at<X: catena::Scalar<Real = f64>>(&self, time: X, joint: usize) -> X {
        (X::literal(3.0 + 2.0 * joint as f64) * time).sin_cos().0 * X::literal(0.3)
    }
}

/// Where efforts are functions of time, and tolerances coarse, stages are cheaper than series: those of `Auto`.
#[test]
fn with_series_efforts_over_time_are_left_to_stages_at_coarse_tolerances() -> Result<(), Box<dyn Error>> {
    let rod = Rod::uniform(0.5, 0.5);
    let two = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let (start, loads) = (two.at_rest(&[0.0; 2])?, Loads::none().in_joints_over_time(Sines));
    let series = two.simulation(AutoTaylor::<24>::tolerance(1e-6)).loads(&loads);
    let mut run = series.begin(start, 2.0, |_| ())?;
    run.until(0.7)?;
    assert_eq!(run.stepper().chosen(), Chosen::Dop853);
    let (saved, whole) = (run.save(), run.finish()?);
    let stages = two.simulation(Auto::tolerance(1e-6)).loads(&loads).run(start, 2.0, |_| ())?;
    assert_eq!((whole.motion, whole.sweeps), (stages.motion, stages.sweeps));
    let resumed =
        two.simulation(AutoTaylor::<24>::tolerance(1e-6)).loads(&loads).resume(saved, 2.0, |_| ())?.finish()?;
    assert_eq!((resumed.motion, resumed.sweeps), (whole.motion, whole.sweeps));

    let mut run = two.simulation(AutoTaylor::<24>::tolerance(1e-12)).loads(&loads).begin(start, 2.0, |_| ())?;
    run.until(0.7)?;
    assert_eq!(run.stepper().chosen(), Chosen::Taylor);
    let (run, alone) =
        (run.finish()?, two.simulation(Taylor::<24>::tolerance(1e-12)).loads(&loads).run(start, 2.0, |_| ())?);
    assert_eq!(run.motion.coordinates(), alone.motion.coordinates());
    for (a, b) in run.motion.coordinates().iter().zip(whole.motion.coordinates()) {
        assert!(f64::abs(a - b) < 1e-4, "{a} {b}");
    }
    // Values that are held are no functions of time.
    let held = Loads::none().efforts([0.3, -0.2]);
    let mut run = two.simulation(AutoTaylor::<24>::tolerance(1e-6)).loads(&held).begin(start, 2.0, |_| ())?;
    run.until(0.7)?;
    assert_eq!(run.stepper().chosen(), Chosen::Taylor);
    Ok(())
}

/// Four rods on damped hinges of a stiffness (N·m/rad).
macro_rules! stiff {
    ($stiffness:expr) => {{
        let (rod, hinge) =
            (Rod::uniform(0.3, 0.3), ElasticHinge::rotary($stiffness).damped(0.02 * f64::sqrt($stiffness)));
        System::new(Pinned::origin(), (rod, [(hinge, rod); 3]), Free)?.with_gravity(9.81)
    }};
}

#[test]
fn what_is_stiff_takes_little_more_than_by_an_implicit_rule() -> Result<(), Box<dyn Error>> {
    let scene = stiff!(1e5);
    let start = scene.at_rest(&[-0.5; 4])?;
    let mut run = scene.simulation(Auto::tolerance(1e-5)).begin(start, 1.0, |_| ())?;
    assert_eq!(run.stepper().chosen(), Chosen::Dop853);
    run.until(0.7)?;
    assert_eq!(run.stepper().chosen(), Chosen::Sdirk4);
    let auto = run.finish()?;
    let series = scene.simulate(start, AutoTaylor::<24>::tolerance(1e-5), 1.0, |_| ())?;
    let alone = scene.simulate(start, Sdirk4::new().tolerance(1e-5), 1.0, |_| ())?;
    let finer = scene.simulate(start, Sdirk4::new().tolerance(1e-7), 1.0, |_| ())?;
    println!("{} sweeps, {} with series, {} by Sdirk4", auto.sweeps, series.sweeps, alone.sweeps);
    assert!(10 * auto.sweeps.max(series.sweeps) < 12 * alone.sweeps);
    for run in [auto, series] {
        for (a, b) in run.motion.coordinates().iter().zip(finer.motion.coordinates()) {
            assert!((a - b).abs() < 1e-6, "{a} {b}");
        }
    }
    Ok(())
}

/// Sweeps of a run by a rule, and the last angle at its end.
macro_rules! by {
    ($scene:ident, $start:ident, $end:expr, $rule:expr) => {{
        let run = $scene.simulate($start.clone(), $rule, $end, |_| ())?;
        (run.sweeps, *$scene.angles(&run.motion)?.iter().last().ok_or("no angle")?)
    }};
}

/// Undamped springs shake a scene that is released at rest, faster than steps are long and by less than the tolerance.
#[test]
fn vibration_below_the_tolerance_is_not_followed() -> Result<(), Box<dyn Error>> {
    let rod = Rod::uniform(0.05, 0.05);
    let chain = (rod, [(ElasticHinge::rotary(2000.0), rod); 19]);
    let pendulum = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
    let released = pendulum.at_rest(&[-1.0; 20])?;
    let beam = Beam::new(1.0, 1.0, 1.0).segments::<40>();
    let slender = System::new(Clamped::at(0.0, 0.0, 0.0), beam, Free)?.with_gravity(1.0);
    let straight = slender.motion();
    macro_rules! no_more_than_alone {
        ($scene:ident, $start:ident, $end:expr) => {{
            let (_, exact) = by!($scene, $start, $end, Vcabm::new().tolerance(1e-7));
            let (alone, _) = by!($scene, $start, $end, Sdirk4::new().tolerance(1e-2));
            let (auto, angle) = by!($scene, $start, $end, Auto::tolerance(1e-2));
            let (explicit, _) = by!($scene, $start, $end, Vcabm::new().tolerance(1e-6));
            println!("{auto} sweeps, {alone} by Sdirk4, {explicit} by Vcabm, off by {:.1e}", angle - exact);
            assert!(10 * auto < 13 * alone && 10 * auto < explicit);
            assert!(f64::abs(angle - exact) < 1e-2);
        }};
    }
    no_more_than_alone!(pendulum, released, 0.1);
    no_more_than_alone!(slender, straight, 0.1);
    Ok(())
}

/// Springs that are soft for the tolerance cost no more than a look and a trial step.
#[test]
fn soft_springs_are_left_to_the_explicit_rule() -> Result<(), Box<dyn Error>> {
    let rod = Rod::uniform(0.3, 0.3);
    let soft = System::new(Pinned::origin(), (rod, [(ElasticHinge::rotary(3.0), rod); 3]), Free)?.with_gravity(9.81);
    let start = soft.at_rest(&[-0.5; 4])?;
    for tolerance in [1e-3, 1e-6] {
        let (alone, _) = by!(soft, start, 1.0, Dop853::tolerance(tolerance));
        let (auto, _) = by!(soft, start, 1.0, Auto::tolerance(tolerance));
        println!("{auto} sweeps, {alone} by Dop853");
        assert!(auto <= alone + 40, "{auto} {alone}");
    }
    Ok(())
}

/// A rod on a wall by a spring and a damper is ẍ = −ω² x − δ ẋ: stages of SDIRK4 and its errors in closed form. Steps that err too much have
/// errors of rates divided by 1 + γ h δ + (γ h ω)², others the plain ones.
#[test]
fn errors_of_rates_are_those_that_springs_let_last() -> Result<(), Box<dyn Error>> {
    let (stiffness, damping, length, mass, dt) = (3e4, 2.0, 0.4, 0.7, 0.02);
    let inertia = mass * length * length / 3.0;
    let (square, delta) = (stiffness / inertia, damping / inertia);
    let chain = (ElasticHinge::rotary(stiffness).damped(damping), Rod::uniform(length, mass));
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), chain, Free)?;
    let start = scene.with_rates(scene.at_rest(&[0.3])?, &[2.0])?;
    // Table IV.6.5 of Hairer and Wanner, and its weights less those of order 3.
    let (gamma, table) = (
        0.25,
        [
            [0.0, 0.0, 0.0, 0.0],
            [0.5, 0.0, 0.0, 0.0],
            [17.0 / 50.0, -1.0 / 25.0, 0.0, 0.0],
            [371.0 / 1360.0, -137.0 / 2720.0, 15.0 / 544.0, 0.0],
            [25.0 / 24.0, -49.0 / 48.0, 125.0 / 16.0, -85.0 / 12.0],
        ],
    );
    let error = [-3.0 / 16.0, -27.0 / 32.0, 25.0 / 32.0, 0.0, gamma];
    let solve = |[x, v]: [f64; 2], own: f64| {
        let rate = (v - own * square * x) / (1.0 + own * delta + own * own * square);
        [x + own * rate, rate]
    };
    let (mut slopes, mut end) = ([[0.0; 2]; 5], [0.0; 2]);
    for stage in 0..5 {
        let mut free = [0.3, 2.0];
        for (weight, slope) in table[stage].iter().zip(&slopes[..stage]) {
            free = [free[0] + dt * weight * slope[0], free[1] + dt * weight * slope[1]];
        }
        end = solve(free, gamma * dt);
        slopes[stage] = [end[1], -square * end[0] - delta * end[1]];
    }
    let of = |k: usize| dt * error.iter().zip(&slopes).map(|(weight, slope)| weight * slope[k]).sum::<f64>();
    let plain = [of(0), of(1)];
    let [_, filtered] = solve(plain, gamma * dt);
    let measured = |[x, v]: [f64; 2], tolerance: f64| {
        let [x, v] = [x / (tolerance * (1.0 + end[0].abs())), v / (tolerance * (1.0 + end[1].abs()))];
        (0.5 * (x * x + v * v)).sqrt()
    };
    for tolerance in [1e-6, 10.0] {
        let (mut stepper, mut next) = (scene.stepper(Sdirk4::new()), start);
        stepper.propose(&start, &Unloaded, tolerance);
        stepper.advance(&start, &Unloaded, dt, &mut next)?;
        let found = stepper.error(&start, dt, &next, tolerance).ok_or("no error")?;
        let rejected = measured(plain, tolerance) > 1.0;
        let expected = measured(if rejected { [plain[0], filtered] } else { plain }, tolerance);
        assert_eq!(rejected, tolerance < 1.0);
        assert!((found - expected).abs() < 1e-9 * expected, "{found} {expected}");
        assert_eq!(stepper.sweeps(), 16 + usize::from(rejected));
    }
    assert!(filtered.abs() < 0.2 * plain[1].abs());
    Ok(())
}

#[test]
fn runs_that_are_saved_go_on_bit_by_bit() -> Result<(), Box<dyn Error>> {
    let scene = stiff!(1e5);
    let start = scene.at_rest(&[-0.5; 4])?;
    macro_rules! goes_on {
        ($rule:expr) => {
            for time in [0.002, 0.02, 0.3] {
                let mut run = scene.simulation($rule).begin(start, 0.6, |_| ())?;
                run.until(time)?;
                let saved = run.save();
                let whole = run.finish()?;
                let resumed = scene.simulation($rule).resume(saved, 0.6, |_| ())?.finish()?;
                assert_eq!((resumed.motion, resumed.sweeps), (whole.motion, whole.sweeps), "{time}");
            }
        };
    }
    goes_on!(Auto::tolerance(1e-5));
    goes_on!(AutoTaylor::<24>::tolerance(1e-5));
    Ok(())
}
