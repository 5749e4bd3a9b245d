//! Robots in body axes beyond loops of other elements: what closes the loop moves them as it moves the same robot in inertial axes.

use catena::Error;
use catena::loading::Unloaded;
use catena::robot::*;
use catena::spatial::{Ball, Network, Revolute, RigidBody, Rod};

const UP: [f64; 3] = [0.0, 0.0, 1.0];
const TENSOR: [[f64; 3]; 3] = [[0.02, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.04]];
const CENTRE: [f64; 3] = [0.15, 0.02, 0.0];

/// A four-bar of rods; on its rocker sits what follows.
macro_rules! on_rocker {
    ($($beyond:expr),*) => {{
        let rod = |length: f64| Rod::uniform(length, 0.05, length);
        let rocker = (RigidBody::massless([0.8, 0.0, 0.0]), Revolute::about(UP), rod(0.6));
        let crank = (Revolute::about(UP), rod(0.3), Ball, rod(0.9));
        System::new(Clamped::origin(), (Network::new(rocker, crank, Ball), $($beyond),*), Free)?.with_gravity([0.0, -9.81, 0.0])
    }};
}

/// Rocker, crank, coupler, and the arm (rad): they do not close.
const OPEN: [f64; 6] = [1.5, 1.0, 0.0, 0.0, 0.4, 0.3];

#[test]
fn a_loop_that_closes_moves_the_arm_beyond_it() -> Result<(), Error> {
    let local = on_rocker!(BodyAxes, Hinge::level(), Link::general(2.0, CENTRE, TENSOR));
    let inertial = on_rocker!(Revolute::about(UP), RigidBody::new(2.0, TENSOR, CENTRE, [0.3, 0.0, 0.0]));
    let found = local.assembled(local.at_rest(&OPEN)?, &Unloaded)?.coordinates();
    let expected = inertial.assembled(inertial.at_rest(&OPEN)?, &Unloaded)?.coordinates();
    println!("{found:?}\n{expected:?}");
    assert!((expected[0] - OPEN[0]).abs() > 0.05, "nothing to close");
    assert_eq!(found.len(), expected.len());
    for (x, y) in found.iter().zip(&expected) {
        assert!((x - y).abs() < 1e-9, "{x} {y}");
    }
    Ok(())
}
