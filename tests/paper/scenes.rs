//! What the paper's scheme refuses, and where it asks for another solver.
#![cfg(feature = "std")]

use catena::loading::Unloaded;
use catena::paper::{At, GeneralizedAlpha, JointScheme, Newmark, Scheme, Solver};
use catena::planar::index::{THETA, X, Y};
use catena::planar::{
    BodyMotion, Branch, Clamped, Free, JointMotion, Loads, Pin, Pinned, PointMass, Rod, Slider, System, Weld,
};
use catena::{Error, Fault, Place, spatial};

/// (40) of a pin next to a clamped tip would have to know the torque there.
#[test]
fn smooth_joints_next_to_clamped_tips_ask_for_the_transform() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 0.4);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod, Pin, rod), Clamped::at(1.2, 0.0, 0.4))?;
    let start = scene.assembled(scene.at_rest(&[-0.5, 0.3, 0.4])?, &Unloaded)?;
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8));
    let error = scheme.start(&scene, &start, &Unloaded, 0.01).map(|_| ()).unwrap_err();
    println!("{error}");
    assert!(matches!(error.fault, Fault::Unsupported { what } if what.contains("solve by Riccati")));
    assert_eq!(error.place, Some(Place::Station(3)));
    let mut run = scheme.solved_by(Solver::Riccati).start(&scene, &start, &Unloaded, 0.01)?;
    run.run_to(0.5)?;
    let tip = run.stations().last().unwrap();
    let misses: [f64; 3] = [tip[X] - 1.2, tip[Y], tip[THETA] - 0.4];
    assert!(misses.iter().all(|miss| miss.abs() < 1e-13), "{tip:?}");
    Ok(())
}

#[test]
fn runs_say_what_is_wrong() -> Result<(), Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[0.1, 0.2])?;
    let refused = |beta, gamma, dt| {
        Scheme::new(Newmark::new(beta, gamma)).start(&scene, &start, &Unloaded, dt).map(|_| ()).unwrap_err().fault
    };
    assert_eq!(refused(0.0, 0.5, 0.01), Fault::NotPositive { parameter: "beta", value: 0.0 });
    assert!(matches!(refused(0.25, 0.4, 0.01), Fault::OutOfRange { parameter: "gamma", .. }));
    assert_eq!(refused(0.25, 0.5, -0.01), Fault::NotPositive { parameter: "step", value: -0.01 });
    assert_eq!(refused(0.25, 0.5, f64::NAN), Fault::NotFinite { parameter: "step" });

    // A bob is the centre of percussion of its pin: no product, but a transform.
    let bob = PointMass::new(1.0, 1.0);
    let scene = System::new(Pinned::origin(), (bob, Pin, bob), Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[0.1, 0.2])?;
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8));
    let error = scheme.start(&scene, &start, &Unloaded, 0.01)?.step().unwrap_err();
    assert_eq!(
        (error.fault, error.place, error.time),
        (Fault::CentreOfPercussion, Some(Place::Station(1)), Some(0.01))
    );
    assert!(error.to_string().contains("solve by Riccati"), "{error}");
    let mut run = scheme.solved_by(Solver::Riccati).start(&scene, &start, &Unloaded, 0.01)?;
    run.run_to(10.0)?;

    // Ends that are none, or that no run reaches; those that are past.
    let mut joints = JointScheme::new(GeneralizedAlpha::new(0.8)).start(&scene, &start, &Unloaded, 0.01)?;
    for (end, is_time) in [(f64::INFINITY, false), (f64::NAN, false), (1e30, true)] {
        for refused in [run.run_to(end), joints.run_to(end)] {
            match refused.unwrap_err().fault {
                Fault::NotFinite { .. } => assert!(!is_time),
                fault => assert!(is_time && matches!(fault, Fault::OutOfRange { .. }), "{fault:?}"),
            }
        }
    }
    run.run_to(3.0)?;
    assert_eq!((run.time(), joints.time()), (10.0, 0.0));

    // A failed step leaves the run where it was.
    let burst = Loads::none().on_bodies(|t, _, motion: &BodyMotion<f64>| {
        motion.force_at([1.0, 0.0], [0.0, if t > 0.025 { f64::NAN } else { 0.0 }])
    });
    let mut run = scheme.solved_by(Solver::Riccati).start(&scene, &start, &burst, 0.01)?;
    run.run_to(0.02)?;
    let before: Vec<f64> = run.angles().collect();
    let error = run.step().unwrap_err();
    assert_eq!((error.fault, error.time), (Fault::NonFiniteLoad, Some(0.03)));
    assert!(run.time() == 0.02 && run.angles().eq(before));
    Ok(())
}

/// As other rules have it: a load that is not finite is said to be one, with its station, whatever it broke first.
#[test]
fn loads_that_are_not_finite_are_named() -> Result<(), Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[-1.0, -0.5])?;
    macro_rules! named {
        ($loads:expr, $place:expr) => {{
            let loads = $loads;
            let mut found = vec![];
            for at in [At::Previous, At::Predictor, At::Iterated] {
                let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).linearized(at);
                found.push(scheme.start(&scene, &start, &loads, 0.01)?.run_to(0.1).unwrap_err());
                found.push(
                    scheme.solved_by(Solver::Riccati).start(&scene, &start, &loads, 0.01)?.run_to(0.1).unwrap_err(),
                );
            }
            let joints = JointScheme::new(GeneralizedAlpha::new(0.8));
            found.push(joints.start(&scene, &start, &loads, 0.01)?.run_to(0.1).unwrap_err());
            found.push(joints.with_sweeps(1).start(&scene, &start, &loads, 0.01)?.run_to(0.1).unwrap_err());
            let rule = catena::planar::GeneralizedAlpha::new(0.8).step(0.01);
            found.push(scene.simulation(rule).loads(&loads).run(start.clone(), 0.1, |_| ()).unwrap_err().error);
            for error in found {
                println!("{error}");
                assert_eq!((error.fault, error.place), (Fault::NonFiniteLoad, Some($place)));
                assert!(error.time.is_some_and(|time| (time - 0.06).abs() < 1e-12), "{error}");
            }
        }};
    }
    let late = |t: f64, hit: bool| if hit && t > 0.055 { f64::NAN } else { 0.0 };
    let torque = |which: usize| Loads::none().in_joints(move |t, k, _: &JointMotion<f64>| late(t, k == which));
    named!(torque(0), Place::Root);
    named!(torque(1), Place::Station(1));
    let force =
        Loads::none().on_bodies(|t, k, motion: &BodyMotion<f64>| motion.force_at([0.0; 2], [0.0, late(t, k == 1)]));
    named!(force, Place::Station(2));

    let rod = spatial::Rod::uniform(1.0, 0.1, 1.0);
    let scene = spatial::System::new(spatial::Pinned::origin(), (rod, spatial::Ball, rod), spatial::Free)?;
    let loads = Loads::none()
        .on_bodies(|t, k, motion: &spatial::BodyMotion<f64>| motion.force_at([0.0; 3], [0.0, late(t, k == 1), 0.0]));
    for solver in [Solver::Product, Solver::Riccati] {
        let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).solved_by(solver);
        let error = scheme.start(&scene, &scene.motion(), &loads, 0.01)?.run_to(0.1).unwrap_err();
        assert_eq!((error.fault, error.place), (Fault::NonFiniteLoad, Some(Place::Station(2))));
    }
    Ok(())
}

/// What (32) to (40) do not know is refused, with its place.
#[test]
fn elements_that_the_paper_has_not_are_refused() -> Result<(), Error> {
    macro_rules! refused {
        ($scene:expr) => {{
            let scene = $scene?;
            let start = scene.motion();
            let scheme = Scheme::new(GeneralizedAlpha::new(0.8));
            let error = scheme.start(&scene, &start, &Unloaded, 0.01).map(|_| ()).unwrap_err();
            println!("{error}");
            (error.fault, error.place)
        }};
    }
    let rod = Rod::uniform(0.3, 0.4);
    let slider = System::new(Pinned::origin(), (rod, Slider::along(0.0), rod), Free);
    let slides = Fault::Unsupported { what: "a joint that slides" };
    assert_eq!(refused!(slider), (slides, Some(Place::Station(1))));
    let beside = System::new(Pinned::origin(), (rod, Pin, rod, Pin, rod, Weld::at(0.3)), Clamped::at(0.5, 0.0, 0.4))?;
    let start = beside.assembled(beside.at_rest(&[-0.9, 0.5, 0.1])?, &Unloaded)?;
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).solved_by(Solver::Riccati);
    let error = scheme.start(&beside, &start, &Unloaded, 0.01).map(|_| ()).unwrap_err();
    let fault = Fault::Unsupported { what: "a joint next to a tip whose attitude is held" };
    assert_eq!((error.fault, error.place), (fault, Some(Place::Tip)));
    // Along a branch (47) to (60) hold, not a chain's overall equation.
    let arm = (rod, Pin, rod, Branch((Pin, rod)), Pin, rod);
    let branched = System::new(Pinned::origin(), arm, Free);
    assert_eq!(refused!(branched), (Fault::Unsupported { what: "a chain that branches" }, Some(Place::Station(3))));
    Ok(())
}
