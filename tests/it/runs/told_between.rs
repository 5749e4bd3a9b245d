//! Runs whose loads are told by their caller between steps: what acts is seen where it changes.

use catena::planar::*;
use catena::{Error, Fault};
use catena_oracle::near;
use core::cell::Cell;

/// A pendulum of inertia J = 1/3 kg m² under a controller u = −20 (q − 0.5) − 4 q̇, sampled each 10 ms, by RK4 of its own.
fn exact() -> [f64; 2] {
    let (mut x, h) = ([-1.0, 0.0], 1e-4);
    for _ in 0..100 {
        let torque = -20.0 * (x[0] - 0.5) - 4.0 * x[1];
        let slope = |x: [f64; 2]| [x[1], 3.0 * (torque - 0.5 * 9.81 * f64::cos(x[0]))];
        let along = |x: [f64; 2], k: [f64; 2], h: f64| [x[0] + h * k[0], x[1] + h * k[1]];
        for _ in 0..100 {
            let k1 = slope(x);
            let k2 = slope(along(x, k1, 0.5 * h));
            let k3 = slope(along(x, k2, 0.5 * h));
            let k4 = slope(along(x, k3, h));
            for i in 0..2 {
                x[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
            }
        }
    }
    x
}

#[test]
fn a_sampled_controller_tells_a_run_its_torque() -> Result<(), Box<dyn std::error::Error>> {
    let scene = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Free)?.with_gravity(9.81);
    let exact = exact();
    macro_rules! check {
        ($rule:expr, $tolerance:expr) => {{
            let torque = Cell::new(f64::NAN);
            let loads = Loads::none().in_joints(|_, _, _: &JointMotion<f64>| torque.get());
            let control =
                |motion: &catena::Motion<f64, _, _>| -20.0 * (motion.coordinates()[0] - 0.5) - 4.0 * motion.rates()[0];
            let start = scene.at_rest(&[-1.0])?;
            torque.set(0.0); // of before, and not what the first step is to see
            let mut run = scene.simulation($rule).loads(&loads).begin(start, 1.0, |_| ())?;
            for sample in 1..=100 {
                torque.set(control(run.motion()));
                run.until(0.01 * f64::from(sample) - 1e-9)?;
            }
            let motion = run.finish()?.motion;
            near(motion.coordinates()[0], exact[0], $tolerance);
            near(motion.rates()[0], exact[1], 10.0 * $tolerance);
        }};
    }
    // By steps that end where samples are taken.
    macro_rules! check_up_to {
        ($rule:expr, $tolerance:expr) => {{
            let torque = Cell::new(f64::NAN);
            let loads = Loads::none().in_joints(|_, _, _: &JointMotion<f64>| torque.get());
            torque.set(0.0);
            let mut run = scene.simulation($rule).loads(&loads).begin(scene.at_rest(&[-1.0])?, 1.0, |_| ())?;
            for sample in 1..=100 {
                torque.set(-20.0 * (run.motion().coordinates()[0] - 0.5) - 4.0 * run.motion().rates()[0]);
                run.up_to(0.01 * f64::from(sample))?;
                near(run.motion().time(), 0.01 * f64::from(sample), 1e-15);
            }
            let run = run.finish()?;
            near(run.motion.coordinates()[0], exact[0], $tolerance);
            near(run.motion.rates()[0], exact[1], 10.0 * $tolerance);
            run.steps
        }};
    }
    assert_eq!(check_up_to!(Dop853::tolerance(1e-10), 1e-12), 100);
    check_up_to!(Dopri5::tolerance(1e-10), 1e-9);
    check_up_to!(Vcabm::new().tolerance(1e-10), 1e-8);
    check_up_to!(Auto::tolerance(1e-9), 1e-8);
    assert_eq!(check_up_to!(Rk4::step(4e-3), 1e-9), 300); // 4, 4 and 2 ms
    check!(Rk4::step(1e-3), 1e-11);
    check!(Dopri5::step(1e-3), 1e-13);
    check!(Dop853::step(2e-3), 1e-13);
    check!(Adams::step(1e-3), 1e-11);
    check!(Vcabm::new().step(1e-3), 1e-9);
    check!(Sdirk4::new().step(1e-3), 1e-10);
    check!(GeneralizedAlpha::new(0.8).step(1e-3), 1e-5);
    Ok(())
}

/// Calls that make no step see nothing: what was told before one is there for the next step.
#[test]
fn calls_without_steps_see_nothing() -> Result<(), Box<dyn std::error::Error>> {
    let scene = System::new(Pinned::origin(), RigidBody::new(1.0, 1.0, [0.0; 2], [0.0; 2]), Free)?;
    let torque = Cell::new(0.0);
    let loads = Loads::none().in_joints(|_, _, _: &JointMotion<f64>| torque.get());
    let mut run = scene.simulation(Rk4::step(0.1)).loads(&loads).begin(scene.motion(), 1.0, |_| ())?;
    run.until(0.5)?;
    torque.set(1.0);
    run.until(0.2)?;
    run.up_to(0.3)?;
    run.until(1.0)?;
    near(run.motion().rates()[0], 0.5, 1e-15);
    Ok(())
}

#[test]
fn a_run_that_is_told_nothing_new_is_the_same() -> Result<(), Box<dyn std::error::Error>> {
    let rod = Rod::uniform(0.5, 1.0);
    let hinge = ElasticHinge::rotary(20.0).damped(0.1);
    let scene = System::new(Pinned::origin(), (rod, [(hinge, rod); 2]), Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[-1.0, 0.2, 0.0])?;
    macro_rules! check {
        ($rule:expr) => {{
            let mut run = scene.simulation($rule).begin(start, 1.0, |_| ())?;
            for k in 1..20 {
                run.until(0.05 * f64::from(k))?;
            }
            assert_eq!(run.finish()?.motion, scene.simulate(start, $rule, 1.0, |_| ())?.motion);
        }};
    }
    check!(Dop853::tolerance(1e-9));
    check!(Vcabm::new().tolerance(1e-9));
    check!(Auto::tolerance(1e-6));
    check!(Sdirk4::new().tolerance(1e-6));
    check!(GeneralizedAlpha::new(0.8).step(1e-2));
    check!(Taylor::<16>::tolerance(1e-12));
    Ok(())
}

/// A wheel of 1 kg m² on a damper of 2 N·m·s/rad under pulses of 3 N·m, 30 of each 100 ms.
#[test]
fn pulses_are_met_at_their_edges() -> Result<(), Box<dyn std::error::Error>> {
    let wheel = RigidBody::new(1.0, 1.0, [0.0; 2], [0.0; 2]);
    let hinge = ElasticHinge::with(Spring::damping(2.0));
    let scene = System::new(Clamped::origin(), (hinge, wheel), Free)?;
    let pulse = Cell::new(0.0);
    let loads = Loads::none().in_joints(|_, joint, _: &JointMotion<f64>| if joint == 1 { pulse.get() } else { 0.0 });
    let mut samples = Vec::new();
    let see = |now: &catena::simulate::Now<'_, _, _, _, _, _>| samples.push(now.time());
    let simulation = scene.simulation(Dop853::tolerance(1e-11)).loads(&loads).every(0.25);
    let mut run = simulation.begin(scene.motion(), 1.0, see)?;
    let mut exact = 0.0_f64; // rad/s
    for k in 0..10 {
        for (torque, width) in [(3.0, 0.03), (0.0, 0.07)] {
            pulse.set(torque);
            let begins = run.motion().time();
            run.up_to(if torque > 0.0 { 0.1 * f64::from(k) + 0.03 } else { 0.1 * f64::from(k + 1) })?;
            near(run.motion().time() - begins, width, 1e-15);
            exact = 0.5 * torque + (exact - 0.5 * torque) * (-2.0 * width).exp();
            near(run.motion().rates()[0], exact, 1e-13);
        }
    }
    assert!(!run.step()?);
    let run = run.finish()?;
    // Besides those to the edges a few that grow.
    assert!(run.steps < 40 && run.rejected == 0);
    assert_eq!(samples.len(), 5);
    samples.iter().zip([0.0, 0.25, 0.5, 0.75, 1.0]).for_each(|(found, expected)| near(*found, expected, 1e-15));
    Ok(())
}

/// A block of 1 kg whose friction holds up to 1 N.
#[test]
fn a_step_by_hand_says_that_friction_holds_no_longer() -> Result<(), Error> {
    use catena::simulate::Stepper;
    let block = RigidBody::new(1.0, 1.0, [0.0; 2], [0.0; 2]);
    let scene = System::new(Clamped::origin(), (Coulomb::new(Slider::along(0.0), 1.0), block), Free)?;
    let (start, mut next) = (scene.motion(), scene.motion());
    let (hold, pull) = (Loads::none().torques([0.0, 0.9]), Loads::none().torques([0.0, 10.0]));
    macro_rules! check {
        ($method:expr) => {{
            scene.stepper($method).step(&start, &hold, 0.01, &mut next)?;
            assert_eq!(next.rates(), [0.0]);
            let error = scene.stepper($method).step(&start, &pull, 0.01, &mut next).unwrap_err();
            assert!(matches!(error.fault, Fault::Unsupported { what } if what.contains("holds no longer")), "{error}");
        }};
    }
    check!(Rk4);
    check!(Dop853);
    check!(Sdirk4::new());
    check!(GeneralizedAlpha::new(0.8));
    scene.stepper(MoreauJean).step(&start, &pull, 0.01, &mut next)?;
    near(next.rates()[0], 0.09, 1e-15);
    Ok(())
}

#[test]
fn a_step_by_hand_says_that_a_joint_leaves_its_stop() -> Result<(), Error> {
    use catena::simulate::Stepper;
    let block = RigidBody::new(1.0, 1.0, [0.0; 2], [0.0; 2]);
    let stops = HardStops::between(Slider::along(0.0), [0.0, 1.0]);
    let scene = System::new(Clamped::origin(), (stops, block), Free)?;
    // A run has come to rest against the lower stop.
    let push = Loads::none().torques([0.0, -2.0]);
    let rest = scene.simulation(Rk4::step(0.01)).loads(&push).run(scene.motion(), 0.1, |_| ())?.motion;
    let mut next = rest;
    scene.stepper(Rk4).step(&rest, &push, 0.01, &mut next)?;
    assert_eq!(next.coordinates(), [0.0]);
    let error = scene.stepper(Rk4).step(&rest, &Loads::none().torques([0.0, 2.0]), 0.01, &mut next).unwrap_err();
    assert!(matches!(error.fault, Fault::Unsupported { what } if what.contains("leaves its stop")), "{error}");
    Ok(())
}
