//! The paper's scheme on scenes of all kinds: its order, by slopes against another integration.

use catena::Error;
use catena::loading::Unloaded;
use catena::paper::{At, GeneralizedAlpha, JointScheme, Newmark, Scheme, Solver};
use catena::planar::index::{M, QX, QY};
use catena::planar::{
    Beam, BodyMotion, Clamped, Dop853, ElasticHinge, Free, GroundMotion, Guided, JointMotion, Loads, Moving, Pin,
    Pinned, RigidBody, Rod, System, Turning, Weld,
};
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
