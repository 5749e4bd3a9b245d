//! Steps of changing size, steps chosen by error control, and steps and rules that are none.

use catena::loading::Unloaded;
use catena::planar::*;
use catena::simulate::{Method, Stepper};
use catena::time::{Rule, Sdirk4};
use catena::{Error, Fault};
use catena_oracle::{Noise, has_order};

type Hinge = ElasticHinge<Spring<f64, f64, f64>>;
type Scene = System<f64, Pinned<[f64; 2]>, (Rod<f64>, Hinge, Rod<f64>, Hinge, Rod<f64>), Free>;
type Rods = System<f64, Pinned<[f64; 2]>, (Rod<f64>, [(ElasticHinge<Spring<f64, f64>>, Rod<f64>); 3]), Free>;
type Start = <Scene as catena::system::Dynamics<Unloaded>>::Position;

fn scene() -> Result<Scene, Error> {
    let rod = |length| Rod::uniform(length, 0.8);
    let hinge = |stiffness, rest| ElasticHinge::rotary(stiffness).damped(0.2).resting_at(rest);
    let chain = (rod(0.5), hinge(30.0, 0.3), rod(0.7), hinge(20.0, -0.2), rod(0.4));
    Ok(System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81))
}

/// Angles and pivot force.
fn read(scene: &Scene, motion: &catena::Motion<f64, Start>) -> [f64; 5] {
    let force = scene.stations(motion, &Unloaded).unwrap().root().internal.force;
    let mut angles = [0.0; 3];
    angles.iter_mut().zip(scene.angles(motion).unwrap().iter()).for_each(|(to, from)| *to = *from);
    [angles[0], angles[1], angles[2], force.x, force.y]
}

fn start(scene: &Scene) -> Result<catena::Motion<f64, Start>, Error> {
    scene.with_rates(scene.at_rest(&[-0.4, -0.1, -0.3])?, &[1.0, -0.5, 0.7])
}

/// Errors in angles and in force.
fn distance(a: [f64; 5], b: [f64; 5]) -> [f64; 2] {
    let square = |range: core::ops::Range<usize>| range.map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
    [square(0..3), square(3..5)]
}

/// Each step up to four times as large as the one before, or as small.
#[test]
fn generalised_alpha_keeps_its_order_with_steps_of_random_size() -> Result<(), Error> {
    let scene = scene()?;
    let exact = scene.simulate(start(&scene)?, Dop853::tolerance(1e-13), 1.0, |_| ())?.motion;
    let expected = read(&scene, &exact);
    for rho in [0.0, 0.5, 0.8, 1.0] {
        let [mut angles, mut forces] = [vec![], vec![]];
        for n in [400, 800, 1600, 3200_u32] {
            let mut noise = Noise::new(3);
            let shares: Vec<f64> = (0..n).map(|_| noise.between(0.4, 1.6)).collect();
            let unit = 1.0 / shares.iter().sum::<f64>();
            let mut stepper = scene.stepper(GeneralizedAlpha::new(rho));
            let mut past = start(&scene)?;
            let mut next = past;
            for share in shares {
                stepper.step(&past, &Unloaded, share * unit, &mut next)?;
                core::mem::swap(&mut past, &mut next);
            }
            let [angle, force] = distance(read(&scene, &past), expected);
            angles.push((f64::from(n).recip(), angle));
            forces.push((f64::from(n).recip(), force));
        }
        has_order(&format!("rho {rho}, angles"), 2.0, 1e-12, &angles);
        has_order(&format!("rho {rho}, force"), 2.0, 1e-11, &forces);
    }
    Ok(())
}

/// A run by error control: its errors, steps and rejections.
fn controlled<M>(rule: Rule<M, f64>, expected: [f64; 5]) -> Result<([f64; 2], usize, usize), Error>
where
    M: for<'s> Method<&'s Scene, Unloaded>,
{
    let scene = scene()?;
    let run = scene.simulate(start(&scene)?, rule, 1.0, |_| ())?;
    Ok((distance(read(&scene, &run.motion), expected), run.steps, run.rejected))
}

#[test]
fn error_control_follows_its_tolerance() -> Result<(), Error> {
    let scene = scene()?;
    let expected = read(&scene, &scene.simulate(start(&scene)?, Dop853::tolerance(1e-13), 1.0, |_| ())?.motion);
    let tolerances = [1e-4, 1e-5, 1e-6, 1e-7, 1e-8];
    // An error of h^(p+1) a step is held at the tolerance: steps grow with its power 1/(p+1), errors with p/(p+1).
    for (name, share, rule) in [
        (
            "alpha",
            2.0 / 3.0,
            &(|tol| controlled(GeneralizedAlpha::new(0.8).tolerance(tol), expected)) as &dyn Fn(f64) -> _,
        ),
        ("trapezoidal", 2.0 / 3.0, &|tol| controlled(GeneralizedAlpha::trapezoidal().tolerance(tol), expected)),
        ("SDIRK4", 1.0, &|tol| controlled(Sdirk4::new().tolerance(tol), expected)),
    ] {
        let mut points = vec![];
        for tolerance in tolerances {
            let ([angle, force], steps, rejected): ([f64; 2], usize, usize) = rule(tolerance)?;
            println!(
                "{name}, {tolerance:.0e}: angles {angle:.1e}, force {force:.1e}, {steps} steps, {rejected} rejected"
            );
            assert!(rejected < steps / 2);
            points.push((tolerance, angle));
        }
        has_order(name, share, 1e-12, &points);
    }
    Ok(())
}

/// Two flywheels and a spring: a linear scene, in which a second sweep changes nothing. It is the change of the acceleration that
/// makes the steps what they should be.
#[test]
fn error_control_sees_linear_motion() -> Result<(), Error> {
    let flywheel = RigidBody::new(1.0, 0.5, [0.0; 2], [0.0; 2]);
    let hinge = ElasticHinge::rotary(40.0);
    let scene = System::new(Pinned::origin(), (flywheel, hinge, flywheel), Free)?;
    for tolerance in [1e-4, 1e-5, 1e-6] {
        let rule = GeneralizedAlpha::new(1.0).tolerance(tolerance);
        let run = scene.simulate(scene.at_rest(&[0.0, 0.1])?, rule, 1.0, |_| ())?;
        let exact = 0.05 - 0.05 * (40.0_f64 * 4.0).sqrt().cos(); // ω² = k (1/J + 1/J)
        let error = (scene.angles(&run.motion)?.get(0).unwrap_or(&f64::NAN) - exact).abs();
        println!("{tolerance:.0e}: {} steps, {} rejected, error {error:.1e}", run.steps, run.rejected);
        assert!(run.steps > 10 && error < tolerance * run.steps as f64);
    }
    Ok(())
}

/// Samples within steps are as good as the steps, also where hinges are stiff and forces would show any strain.
#[test]
fn samples_between_steps_are_as_good_as_steps() -> Result<(), Error> {
    let rod = Rod::uniform(0.3, 0.3);
    let hinge = ElasticHinge::rotary(1e8).damped(200.0);
    let scene = System::new(Pinned::origin(), (rod, [(hinge, rod); 3]), Free)?.with_gravity(9.81);
    let welds = System::new(Pinned::origin(), (rod, [(Weld::at(0.0), rod); 3]), Free)?.with_gravity(9.81);
    let mut exact = vec![];
    welds.simulation(Dop853::tolerance(1e-13)).every(0.1).run(welds.at_rest(&[-0.5])?, 1.0, |now| {
        exact.push(now.stations().root().internal.force);
    })?;
    // The first two samples are of the vibration with which the hinges take up their load.
    fn worst<M>(scene: &Rods, rule: Rule<M, f64>, exact: &[nalgebra::Vector2<f64>]) -> Result<f64, Error>
    where
        M: for<'s> Method<&'s Rods, Unloaded>,
    {
        let (mut worst, mut sample) = (0.0_f64, 0);
        scene.simulation(rule).every(0.1).run(scene.at_rest(&[-0.5; 4])?, 1.0, |now| {
            let error = (now.stations().root().internal.force - exact[sample]).norm();
            worst = worst.max(if sample < 2 { 0.0 } else { error });
            sample += 1;
        })?;
        assert_eq!(sample, exact.len());
        Ok(worst)
    }
    // Steps of 4 ms end at the samples, those of 3.7 ms do not.
    let alpha = [0.004, 0.0037].map(|h| worst(&scene, GeneralizedAlpha::new(0.8).step(h), &exact));
    let sdirk = [0.004, 0.0037].map(|h| worst(&scene, Sdirk4::new().step(h), &exact));
    for (name, [at_steps, between]) in [("generalised-alpha", alpha), ("SDIRK4", sdirk)] {
        let (at_steps, between) = (at_steps?, between?);
        println!("{name}: {at_steps:.1e} N at steps, {between:.1e} N between");
        assert!(between < 2.0 * at_steps + 1e-7); // hinges are no welds: ten times the compliance
    }
    Ok(())
}

fn refused<M: for<'s> Method<&'s Scene, Unloaded>>(rule: Rule<M, f64>) -> Result<Fault, Error> {
    let scene = scene()?;
    let outcome = scene.simulate(start(&scene)?, rule, 1.0, |_| ());
    outcome.map_or_else(|broken| Ok(broken.error.fault), |run| panic!("accepted: {:?}", run.motion))
}

#[test]
fn parameters_that_make_no_rule_are_refused() -> Result<(), Error> {
    const NAN: f64 = f64::NAN;
    for rho in [-0.1, 1.1, -1.0, 2.0, f64::INFINITY] {
        let refusals = [
            refused(GeneralizedAlpha::new(rho).step(0.01))?,
            refused(GeneralizedAlpha::new(rho).with_sweeps(3).tolerance(1e-6))?,
        ];
        for fault in refusals {
            let Fault::OutOfRange { parameter: "rho", value, least: 0.0, most: 1.0, .. } = fault else {
                panic!("{fault:?}");
            };
            assert_eq!(value, rho);
        }
    }
    assert!(matches!(refused(GeneralizedAlpha::new(NAN).step(0.01))?, Fault::OutOfRange { parameter: "rho", .. }));
    for beta in [0.0, -0.25, NAN, f64::INFINITY] {
        let fault = refused(GeneralizedAlpha::newmark(beta, 0.5).step(0.01))?;
        assert!(matches!(fault, Fault::NotPositive { parameter: "beta", .. }), "{fault:?}");
    }
    for gamma in [0.49, -1.0, NAN, f64::INFINITY] {
        let fault = refused(GeneralizedAlpha::newmark(0.25, gamma).step(0.01))?;
        assert!(matches!(fault, Fault::OutOfRange { parameter: "gamma", .. }), "{fault:?}");
    }
    let error = Error::new(refused(GeneralizedAlpha::new(1.5).step(0.01))?);
    assert_eq!(
        error.to_string(),
        "rho must lie between 0 and 1, but is 1.5: it is the share that a step leaves of fast vibration"
    );
    Ok(())
}

#[test]
fn steps_and_tolerances_that_are_none_are_refused() -> Result<(), Error> {
    fn steps<M: for<'s> Method<&'s Scene, Unloaded> + Copy>(method: M) -> Result<(), Error> {
        let scene = scene()?;
        let past = start(&scene)?;
        let mut next = past;
        for dt in [0.0, -0.01, f64::NAN, f64::INFINITY] {
            let mut stepper = scene.stepper(method);
            for outcome in
                [stepper.step(&past, &Unloaded, dt, &mut next), stepper.advance(&past, &Unloaded, dt, &mut next)]
            {
                let fault = outcome.map_err(|error| error.fault);
                assert!(matches!(fault, Err(Fault::NotPositive { parameter: "step size", .. })), "{dt}: {fault:?}");
            }
        }
        Ok(())
    }
    steps(GeneralizedAlpha::new(0.8))?;
    steps(Sdirk4::new())?;
    for bad in [0.0, -1e-6, f64::NAN, f64::INFINITY] {
        for fault in [
            refused(GeneralizedAlpha::new(0.8).tolerance(bad))?,
            refused(GeneralizedAlpha::new(0.8).step(bad))?,
            refused(Sdirk4::new().tolerance(bad))?,
            refused(Sdirk4::new().step(bad))?,
        ] {
            assert!(matches!(fault, Fault::NotPositive { .. }), "{bad}: {fault:?}");
        }
    }
    Ok(())
}
