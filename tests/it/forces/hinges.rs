//! Hinges with springs and welds against a dense solution of all equations at once, and the orders of implicit rules on them.

use catena::Error;
use catena::loading::Unloaded;
use catena::planar::*;
use catena_oracle::plane::{self as oracle, Coordinates, Ground, Scene, Tip};
use catena_oracle::{has_order, near};

/// Stiffness, damping and rest angle of the hinges.
const SPRINGS: [[f64; 3]; 2] = [[7.0, 0.3, 0.2], [4.0, 0.0, 0.0]];
const WELD: f64 = -0.7;
const ANGLES: [f64; 5] = [-0.4, 0.5, 0.3, 0.1, -1.0]; // of the bodies outboard of each joint; the fourth is welded
const RATES: [f64; 4] = [1.1, -0.6, 0.8, 2.0]; // of the root, the two hinges (relative) and the pin (absolute)

/// A plate, a damped hinge with a rest angle, a rod, a hinge, a plate welded to a rod, a pin, a rod.
macro_rules! scene {
    () => {{
        let plate = RigidBody::new(0.9, 0.05, [0.3, 0.1], [0.7, -0.2]);
        let rod = Rod::new(0.8, 1.3, 0.3, 0.07);
        let [[k, c, rest], [soft, ..]] = SPRINGS;
        let damped = ElasticHinge::rotary(k).damped(c).resting_at(rest);
        let chain = (plate, damped, rod, ElasticHinge::rotary(soft), (plate, Weld::at(WELD), rod), Pin, rod);
        System::new(Pinned::origin(), chain, Free).map(|system| system.with_gravity(9.81))
    }};
}

fn oracle_scene() -> Scene {
    let plate = oracle::Body { mass: 0.9, inertia_c: 0.05, centre: [0.3, 0.1], outboard: [0.7, -0.2] };
    let rod = oracle::Body { mass: 1.3, inertia_c: 0.07, centre: [0.3, 0.0], outboard: [0.8, 0.0] };
    let spring = |[stiffness, damping, rest]: [f64; 3]| oracle::Joint::Rotary { stiffness, damping, rest };
    Scene {
        bodies: vec![plate, rod, plate, rod, rod],
        joints: vec![
            oracle::Joint::Pin,
            spring(SPRINGS[0]),
            spring(SPRINGS[1]),
            oracle::Joint::Weld,
            oracle::Joint::Pin,
        ],
        ground: Ground::default(),
        tip: Tip::Free,
        gravity: [0.0, -9.81],
    }
}

#[test]
fn springs_dampers_and_welds_agree_with_the_dense_system() -> Result<(), Error> {
    let scene = scene!()?;
    let [a, b, c, _, e] = ANGLES;
    let motion = scene.with_rates(scene.at_rest(&[a, b, c, e])?, &RATES)?;
    let motion = scene.with_accelerations(motion, &Unloaded)?;
    let d = c + WELD;
    let relative = [(a, 1.1), (b - a, -0.6), (c - b, 0.8), (WELD, 0.0)];
    let third_rate = 1.1 - 0.6 + 0.8;
    let mut coordinates: Vec<_> = relative.iter().map(|(phi, rate)| Coordinates::angle(*phi, *rate)).collect();
    coordinates.push(Coordinates::angle(e - d, 2.0 - third_rate));
    let dense = oracle_scene();
    let state = dense.place(&coordinates);
    let answer = dense.solve(&state, &[], &[]);

    let stations = scene.stations(&motion, &Unloaded)?;
    let bodies = scene.body_motions(&motion)?;
    // Rounding, times the condition of a chain of five bodies, relative to accelerations of 1e2 and forces of 1e2.
    let rounding = 1e-11;
    for (k, element) in [0, 2, 4, 6, 8].into_iter().enumerate() {
        let body = bodies.get(k).unwrap();
        near(body.inboard.acceleration.angular, answer.angular_acceleration[k], rounding);
        let station = stations.get(element).unwrap().internal;
        near(station.force.x, answer.q_inboard[k][0], rounding);
        near(station.force.y, answer.q_inboard[k][1], rounding);
        near(station.torque, answer.m_inboard[k], rounding);
    }
    near(scene.budget(&motion)?.potential, dense.potential_energy(&state), 1e-12);
    Ok(())
}

/// Errors of the first angle and of the pivot force after half a second, for steps of these sizes.
fn errors(rule: GeneralizedAlpha, steps: &[f64]) -> Result<[Vec<(f64, f64)>; 2], Error> {
    let scene = scene!()?;
    let start = || scene.with_rates(scene.at_rest(&[-0.4, -0.2, -0.2, -0.5])?, &[1.0, 0.3, -0.2, 1.0]);
    let read = |motion: &_| {
        let force: [f64; 2] = scene.stations(motion, &Unloaded).unwrap().root().internal.force.into();
        (*scene.angles(motion).unwrap().get(0).unwrap_or(&f64::NAN), force)
    };
    let (angle, force) = read(&scene.simulate(start()?, Dop853::tolerance(1e-13), 0.5, |_| ())?.motion);
    let [mut angles, mut forces] = [vec![], vec![]];
    for h in steps {
        let (a, f) = read(&scene.simulate(start()?, rule.step(*h), 0.5, |_| ())?.motion);
        angles.push((*h, (a - angle).abs()));
        forces.push((*h, (f[0] - force[0]).hypot(f[1] - force[1])));
    }
    Ok([angles, forces])
}

#[test]
fn implicit_rules_have_their_order_in_angles_and_forces() -> Result<(), Error> {
    let steps = [0.004, 0.002, 0.001, 0.0005];
    for (name, rule, order) in [
        ("generalised-alpha", GeneralizedAlpha::new(0.8), 2.0),
        ("trapezoidal", GeneralizedAlpha::trapezoidal(), 2.0),
        ("three sweeps", GeneralizedAlpha::new(0.5).with_sweeps(3), 2.0),
        ("damped Newmark", GeneralizedAlpha::newmark(0.3025, 0.6), 1.0),
    ] {
        let [angles, forces] = errors(rule, &steps)?;
        has_order(&format!("{name}, angle"), order, 1e-12, &angles);
        has_order(&format!("{name}, force"), order, 1e-11, &forces);
    }
    Ok(())
}

#[test]
fn any_finite_stiffness_works_and_approaches_a_weld() -> Result<(), Error> {
    let rod = Rod::uniform(0.5_f64, 0.7);
    let welded = System::new(Pinned::origin(), (rod, Weld::at(0.3), rod), Free)?.with_gravity(9.81);
    let rule = GeneralizedAlpha::new(0.8).step(0.005);
    let limit = welded.simulate(welded.at_rest(&[-0.5])?, rule, 0.5, |_| ())?.motion;
    let limit = *welded.angles(&limit)?.get(0).unwrap();
    let mut before = f64::INFINITY;
    for stiffness in [1e3, 1e5, 1e7, 1e9, 1e11] {
        let hinge = ElasticHinge::rotary(stiffness).damped(stiffness * 1e-3).resting_at(0.3);
        let stiff = System::new(Pinned::origin(), (rod, hinge, rod), Free)?.with_gravity(9.81);
        let motion = stiff.simulate(stiff.at_rest(&[-0.5, -0.2])?, rule, 0.5, |_| ())?.motion;
        let distance = (stiff.angles(&motion)?.get(0).unwrap() - limit).abs();
        println!("stiffness {stiffness:e}: {distance:.1e} from the weld");
        // The compliance falls by 100 each time, until what is left is rounding: an angle off by 1e-16 strains the spring.
        assert!(distance < (before / 10.0).max(1e-9));
        before = distance;
    }
    Ok(())
}
