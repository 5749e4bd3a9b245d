//! The paper's scheme on scenes of all kinds: solvers against each other, against other integrations, against closed forms.
#![cfg(feature = "std")]

use catena::loading::Unloaded;
use catena::paper::{At, GeneralizedAlpha, JointScheme, Newmark, Scheme, Solver};
use catena::planar::index::{M, QX, QY, THETA, X, Y};
use catena::planar::{
    Beam, BodyMotion, Branch, Clamped, Dop853, ElasticHinge, Free, GroundMotion, Guided, JointMotion, Loads, Moving,
    Pin, Pinned, PointMass, RigidBody, Rod, Slider, System, Turning, Weld,
};
use catena::{Error, Fault, Place};
use catena_oracle::slope;

/// Errors of all angles, and of all forces relative to their largest, against order 8 at three steps: their orders.
macro_rules! orders {
    ($name:expr, $scene:expr, $start:expr, $loads:expr, $end:expr, $scheme:expr) => {{
        let (scene, loads) = (&$scene, &$loads);
        let start = scene.with_accelerations($start.clone(), loads)?;
        let (mut angles, mut forces) = (vec![], vec![]);
        let exact = scene.simulation(Dop853::tolerance(1e-12)).loads(loads).run(start.clone(), $end, |_| ())?.motion;
        let stations = scene.stations(&exact, loads).unwrap();
        // At larger steps the printed linearisation shows terms of the next order.
        for dt in [0.002, 0.001, 0.0005] {
            let mut run = $scheme.start(scene, &start, loads, dt)?;
            run.run_to($end)?;
            let expected: Vec<f64> = scene.angles(&exact).unwrap().iter().copied().collect();
            let angle = run.angles().zip(&expected).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
            let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
            for (k, z) in run.stations()[1..].iter().enumerate() {
                let state = stations.get(k).unwrap().state();
                for i in [M, QX, QY] {
                    worst = worst.max((z[i] - state[i]).abs());
                    largest = largest.max(state[i].abs());
                }
                assert!((0..3).all(|i| (z[i] - state[i]).abs() < 10.0 * dt), "{} {k}: {z:?} {state:?}", $name);
            }
            angles.push((dt, angle));
            forces.push((dt, worst / largest));
        }
        let [a, f] = [slope(&angles), slope(&forces)];
        println!("{}: angles {:.1e} order {a:.2}, forces {:.1e} order {f:.2}", $name, angles[2].1, forces[2].1);
        assert!((a - 2.0).abs() < 0.2 && (f - 2.0).abs() < 0.2, "{}: {angles:?} {forces:?}", $name);
    }};
}

/// The formulations of second order.
macro_rules! all_orders {
    ($scene:expr, $start:expr, $loads:expr, $end:expr) => {{
        let alpha = GeneralizedAlpha::new(0.8);
        let scheme = Scheme::new(alpha);
        orders!("as printed, product", $scene, $start, $loads, $end, scheme);
        orders!("predictor, product", $scene, $start, $loads, $end, scheme.linearized(At::Predictor));
        let riccati = scheme.solved_by(Solver::Riccati);
        orders!("as printed, Riccati", $scene, $start, $loads, $end, riccati);
        orders!("predictor, Riccati", $scene, $start, $loads, $end, riccati.linearized(At::Predictor));
        orders!("iterated, Riccati", $scene, $start, $loads, $end, riccati.linearized(At::Iterated));
        orders!("joints", $scene, $start, $loads, $end, JointScheme::new(alpha));
        let newmark = Newmark::new(0.25, 0.5);
        orders!("joints, Newmark, one sweep", $scene, $start, $loads, $end, JointScheme::new(newmark).with_sweeps(1));
    }};
}

/// The same in the coordinates of bodies alone: joint coordinates know free tips only.
macro_rules! chain_orders {
    ($scene:expr, $start:expr, $end:expr) => {{
        let scheme = Scheme::new(GeneralizedAlpha::new(0.8));
        let riccati = scheme.solved_by(Solver::Riccati);
        orders!("as printed, Riccati", $scene, $start, Loads::none(), $end, riccati);
        orders!("predictor, Riccati", $scene, $start, Loads::none(), $end, riccati.linearized(At::Predictor));
        orders!("iterated, Riccati", $scene, $start, Loads::none(), $end, riccati.linearized(At::Iterated));
        // At steps for orders the product keeps too few digits of five bodies: it is held against the transform at a longer one.
        let mut product = scheme.start(&$scene, &$start, &Unloaded, 0.04)?;
        let mut transform = riccati.start(&$scene, &$start, &Unloaded, 0.04)?;
        for _ in 0..3 {
            product.step()?;
            transform.step()?;
        }
        let pairs = product.stations().iter().zip(transform.stations());
        let worst = pairs.fold(0.0_f64, |worst, (a, b)| (0..6).fold(worst, |worst, i| worst.max((a[i] - b[i]).abs())));
        println!("product against transform: {worst:.1e}");
        assert!(worst < 1e-6, "{worst}");
    }};
}

/// Bodies with mass centres beside their axes, pins, welds, hinges with dampers and rest angles, a moving ground, forces and torques
/// that depend on time and motion.
#[test]
fn general_scene_has_order_two() -> Result<(), Error> {
    let plate = RigidBody::new(0.9, 0.05, [0.3, 0.1], [0.7, -0.2]);
    let rod = Rod::new(0.8, 1.3, 0.3, 0.07);
    let hinge = ElasticHinge::rotary(3.0).damped(0.2).resting_at(0.4);
    let ground = Moving(|t: f64| GroundMotion {
        place: [0.1 * t.sin(), 0.0],
        velocity: [0.1 * t.cos(), 0.0],
        acceleration: [-0.1 * t.sin(), 0.0],
    });
    let scene =
        System::new(Pinned::on(ground), (plate, Pin, rod, Weld::at(0.5), plate, hinge, rod), Free)?.with_gravity(9.81);
    let start = scene.with_rates(scene.at_rest(&[-0.3, 0.2, 0.9])?, &[1.0, -0.5, 0.3])?;
    let loads = Loads::none()
        .in_joints(|t, joint, motion: &JointMotion<f64>| 0.3 * f64::sin(t + joint as f64) - 0.05 * motion.rate())
        .on_bodies(|t, body, motion: &BodyMotion<f64>| {
            motion.force_at([0.1, 0.2], [f64::cos(3.0 * t), 0.2 * body as f64 - 0.1 * motion.rate()])
        });
    all_orders!(scene, start, loads, 0.5);
    Ok(())
}

#[test]
fn clamped_scene_has_order_two() -> Result<(), Error> {
    let rod = Rod::uniform(0.4, 0.5);
    let hinge = ElasticHinge::rotary(8.0).damped(0.1);
    let shaken = Clamped {
        place: [0.1, 0.2],
        attitude: Turning(|t: f64| [0.2 * (3.0 * t).sin(), 0.6 * (3.0 * t).cos(), -1.8 * (3.0 * t).sin()]),
    };
    let scene = System::new(shaken, (rod, hinge, rod, Pin, rod), Free)?.with_gravity(9.81);
    let start = scene.with_rates(scene.at_rest(&[0.1, -0.4])?, &[0.2, 1.0])?;
    all_orders!(scene, start, Loads::none(), 0.5);
    // A hinge at the clamp itself.
    let scene = System::new(Clamped::at(0.0, 0.0, 0.3), (hinge, rod, hinge, rod), Free)?.with_gravity(9.81);
    all_orders!(scene, scene.at_rest(&[0.1, -0.1])?, Loads::none(), 0.5);
    Ok(())
}

#[test]
fn floating_scene_has_order_two() -> Result<(), Error> {
    let rod = Rod::uniform(0.4, 0.5);
    let hinge = ElasticHinge::rotary(2.0).damped(0.02);
    let scene = System::new(Free, (rod, hinge, rod, Pin, rod), Free)?.with_gravity(1.0);
    let start = scene.with_rates(scene.at_rest(&[0.1, 0.5, -0.4])?, &[0.2, -0.1, 1.0, -2.0, 3.0])?;
    all_orders!(scene, start, Loads::none(), 0.5);
    // A torque on what floats.
    let loads = Loads::none().in_joints(|t, joint, _: &JointMotion<f64>| 0.3 * f64::sin(t + 1.0 + joint as f64));
    let riccati = Scheme::new(GeneralizedAlpha::new(0.8)).solved_by(Solver::Riccati);
    orders!("driven, Riccati", scene, start, loads, 0.5, riccati.linearized(At::Predictor));
    Ok(())
}

/// Boundary conditions of a product: a root on a line, and tips held by a pin, by a clamp, on a line.
#[test]
fn guided_roots_and_held_tips_have_order_two() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 0.4);
    let hinge = ElasticHinge::rotary(4.0).damped(0.05);
    // A line at 0.3 rad on a ground at 0.2 rad: the trolley starts on it, moving.
    let line = Guided::on(Clamped::at(0.1, -0.2, 0.2), 0.1);
    let scene = System::new(line, (rod, Pin, rod, hinge, rod), Free)?.with_gravity(9.81);
    let start = scene.with_rates(scene.at_rest(&[-0.8, -0.5])?, &[0.4, 1.0, -0.5])?;
    chain_orders!(scene, start, 0.5);

    let tips = (rod, Pin, rod, Pin, rod, hinge, rod);
    let angles = [-0.9, -0.4, 0.5, 0.8];
    macro_rules! tip {
        ($scene:expr) => {{
            let scene = $scene?.with_gravity(9.81);
            let start = scene.assembled(scene.at_rest(&angles)?, &Unloaded)?;
            chain_orders!(scene, start, 0.3);
        }};
    }
    tip!(System::new(Pinned::origin(), tips, Pinned::at(1.5, 0.0)));
    let elastic = (rod, hinge, rod, hinge, rod, hinge, rod, hinge, rod);
    let scene = System::new(Pinned::origin(), elastic, Clamped::at(1.7, 0.2, 0.9))?.with_gravity(9.81);
    let start = scene.assembled(scene.at_rest(&[-0.7, -0.3, 0.2, 0.6, 0.8])?, &Unloaded)?;
    chain_orders!(scene, start, 0.3);
    let scene =
        System::new(Pinned::origin(), (rod, hinge, rod, hinge, rod), Guided::at(0.0, 0.3, 0.4))?.with_gravity(9.81);
    let start = scene.assembled(scene.at_rest(&[-0.5, 0.6, 0.4])?, &Unloaded)?;
    chain_orders!(scene, start, 0.2);
    Ok(())
}

/// A beam is its segments: half a rod, springs and rods, half a rod.
#[test]
fn beams_have_order_two() -> Result<(), Error> {
    let beam = Beam::new(1.0, 0.5, 1.0).damped(0.01); // 100 rad/s at most
    let scene = System::new(Pinned::origin(), beam.segments::<4>(), Free)?.with_gravity(9.81);
    chain_orders!(scene, scene.at_rest(&[-0.5, -0.48, -0.45, -0.4, -0.36])?, 0.3);
    Ok(())
}

/// (40) of a pin next to a clamped tip would have to know the torque there.
#[test]
fn smooth_joints_next_to_clamped_tips_ask_for_the_transform() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 0.4);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod, Pin, rod), Clamped::at(1.2, 0.0, 0.4))?;
    let start = scene.assembled(scene.at_rest(&[-0.5, 0.3, 0.4])?, &Unloaded)?;
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8));
    let error = scheme.start(&scene, &start, &Unloaded, 0.01)?.step().unwrap_err();
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
    assert_eq!((error.fault, error.time), (Fault::NonFiniteMotion, Some(0.03)));
    assert!(run.time() == 0.02 && run.angles().eq(before));
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
