//! Forces after steps by implicit rules: a smooth pin bears no torque, forces keep their order, and reading them changes no step.

use catena::loading::Unloaded;
use catena::planar::*;
use catena::simulate::Stepper;
use catena::time::Sdirk4;
use catena::{Error, spatial};
use catena_oracle::has_order;
use core::f64::consts::FRAC_PI_2;

const G: f64 = 9.81;
const START: [f64; 3] = [-0.3, 0.2, 0.1];

type Chain = (Rod<f64>, Pin, Rod<f64>, Pin, Rod<f64>);
type Pendulum = System<f64, Pinned<[f64; 2]>, Chain, Free>;

fn pendulum() -> Result<Pendulum, Error> {
    let rod = Rod::uniform(0.5, 1.0);
    Ok(System::new(Pinned::origin(), (rod, Pin, rod, Pin, rod), Free)?.with_gravity(G))
}

/// The largest torque in a pin (N·m): inverse dynamics, which knows nothing of how accelerations were found.
macro_rules! torque_in_pins {
    ($stations:expr) => {{
        let stations = $stations;
        let pins = [stations.get(1), stations.get(3)].into_iter().flatten().chain([stations.root()]);
        pins.map(|station| f64::abs(station.internal.torque)).fold(0.0, f64::max)
    }};
}

/// Does the same with a rule of both kinds, of an order.
macro_rules! with_every_rule {
    (|$rule:ident, $order:ident| $what:expr) => {{
        {
            let ($rule, $order) = (GeneralizedAlpha::new(0.8), 2.0);
            $what
        }
        {
            let ($rule, $order) = (Sdirk4::new(), 4.0);
            $what
        }
    }};
}

#[test]
fn a_smooth_pin_bears_no_torque() -> Result<(), Error> {
    let scene = pendulum()?;
    with_every_rule!(|rule, order| {
        let mut worst = [0.0_f64; 4];
        let run = scene.simulation(rule.step(0.01)).event(|now| torque_in_pins!(now.stations()) - 1.0).run(
            scene.at_rest(&START)?,
            1.0,
            |now| {
                worst[0] = worst[0].max(torque_in_pins!(now.stations()));
                worst[1] = worst[1].max(torque_in_pins!(scene.stations(now.motion(), &Unloaded).unwrap()));
                worst[2] = worst[2].max(torque_in_pins!(scene.stations(now.stepped(), &Unloaded).unwrap()));
                assert!(!now.is_event());
            },
        )?;
        worst[3] =
            torque_in_pins!(scene.stations(&scene.with_accelerations(run.motion, &Unloaded)?, &Unloaded).unwrap());
        println!("order {order}: torques {worst:?} N·m");
        // Rounding of moments of 20 N·m; and the rule's own accelerations do bear one, or this would show nothing.
        assert!(worst[0] < 1e-13 && worst[1] < 1e-13 && worst[3] < 1e-13 && worst[2] > 1e-8);
        assert_eq!(run.sweeps % 100, 0);
    });
    Ok(())
}

#[test]
fn forces_found_anew_keep_their_order() -> Result<(), Error> {
    let scene = pendulum()?;
    let exact = scene.simulate(scene.at_rest(&START)?, Dop853::tolerance(1e-13), 1.0, |_| ())?.motion;
    let force = |motion: &_| scene.stations(motion, &Unloaded).unwrap().root().internal.force;
    with_every_rule!(|rule, order| {
        let mut errors = vec![];
        for step in [0.005, 0.0025, 0.00125] {
            let run = scene.simulate(scene.at_rest(&START)?, rule.step(step), 1.0, |_| ())?;
            let settled = scene.with_accelerations(run.motion, &Unloaded)?;
            errors.push((step, (force(&settled) - force(&exact)).norm()));
        }
        has_order("force at the pivot", order, 1e-12, &errors);
    });
    Ok(())
}

#[test]
fn stiff_hinges_bear_the_same_forces() -> Result<(), Error> {
    // Rods that are as good as welded: one rod of the same mass and length, whose force at the pivot is elliptic.
    let (rod, whole) = (Rod::uniform(0.3, 0.3), Rod::uniform(1.2, 1.2));
    let pendulum = System::new(Pinned::origin(), whole, Free)?.with_gravity(G);
    let exact = pendulum.simulate(pendulum.at_rest(&[-0.5])?, Dop853::tolerance(1e-13), 1.0, |_| ())?.motion;
    let expected = pendulum.stations(&exact, &Unloaded)?.root().internal.force;
    for stiffness in [1e8_f64, 1e10] {
        let hinge = ElasticHinge::rotary(stiffness).damped(0.02 * stiffness.sqrt());
        let scene = System::new(Pinned::origin(), (rod, [(hinge, rod); 3]), Free)?.with_gravity(G);
        let mut errors = vec![];
        for step in [0.01, 0.005, 0.0025] {
            let run = scene.simulate(scene.at_rest(&[-0.5; 4])?, GeneralizedAlpha::new(0.8).step(step), 1.0, |_| ())?;
            let settled = scene.with_accelerations(run.motion, &Unloaded)?;
            let found = scene.stations(&settled, &Unloaded)?.root().internal.force;
            errors.push((step, (found - expected).norm()));
        }
        has_order("force at the pivot of stiff rods", 2.0, 1e-8, &errors);
    }
    Ok(())
}

#[test]
fn reading_forces_changes_no_step() -> Result<(), Error> {
    let scene = pendulum()?;
    with_every_rule!(|rule, _order| {
        let mut stepper = scene.stepper(rule);
        let mut past = scene.with_accelerations(scene.at_rest(&START)?, &Unloaded)?;
        let mut steps = 0;
        scene.simulate(scene.at_rest(&START)?, rule.step(0.0078125), 1.0, |now| {
            assert!(torque_in_pins!(now.stations()) < 1e-13);
            assert!(*now.stepped() == past && now.motion().position() == past.position());
            let mut next = past;
            stepper.advance(&past, &Unloaded, 0.0078125, &mut next).expect("a step");
            past = next;
            steps += 1;
        })?;
        assert_eq!(steps, 129);
    });
    Ok(())
}

#[test]
fn a_ball_bears_no_torque_either() -> Result<(), Error> {
    use spatial::*;
    let rod = Rod::uniform(0.5, 0.05, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Ball, rod), Free)?.with_gravity([0.0, -G, 0.0]);
    let start = scene.at_rest(&[0.0, 0.3, -0.2, 0.1, -0.5, 0.4 - FRAC_PI_2])?;
    with_every_rule!(|rule, _order| {
        let mut worst = 0.0_f64;
        let run = scene.simulate(start, rule.step(0.01), 0.5, |now| {
            worst = worst.max(now.stations().get(1).map_or(f64::NAN, |station| station.internal.torque.norm()));
        })?;
        let settled = scene.with_accelerations(run.motion, &Unloaded)?;
        let left = scene.stations(&settled, &Unloaded).unwrap().root().internal.torque.norm();
        println!("torque in a ball {worst:.1e}, at the root {left:.1e} N·m");
        assert!(worst < 1e-12 && left < 1e-12);
    });
    Ok(())
}
