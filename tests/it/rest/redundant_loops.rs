//! Equilibria and modes of loops that are held more often than they can move, against closed forms and the same in the plane.

use catena::{Error, planar, spatial};
use catena_oracle::near;
use core::f64::consts::FRAC_PI_2;

const G: f64 = 9.81;

/// Three parallel cranks of which one is redundant, and a platform: a pendulum of inertia 3 · 1/3 + 2 · 1 kg m² under 3 · g/2 + 2 g N m.
#[test]
fn parallel_cranks_hang_and_swing_as_one() -> Result<(), Error> {
    use planar::*;
    let rod = Rod::uniform(1.0, 1.0);
    let reach = |x| RigidBody::massless([x, 0.0]);
    let inner = Network::new((Pin, rod, Pin, rod), (reach(1.0), Pin, rod), Pin);
    let net = Network::new((inner, rod), (reach(2.0), Pin, rod), LeastNorm(Pin));
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), net, Free)?.with_gravity(G);
    let hanging = scene.at_rest(&[-FRAC_PI_2, 0.0, -FRAC_PI_2, -FRAC_PI_2])?;
    let modes = scene.modes(&hanging, &Unloaded)?;
    assert_eq!(modes.len(), 1);
    let expected = (3.5 * G / 3.0).sqrt();
    near(modes.get(0).map_or(f64::NAN, |mode| mode.frequency()), expected, 1e-11 * expected);
    // From a radian away they fall to where they hang.
    let guess = scene.at_rest(&[-0.6, 0.0, -0.6, -0.6])?;
    let rest = scene.equilibrium(guess, &Unloaded)?;
    let mut found = vec![];
    catena::system::Position::visit(rest.position(), &mut |x: f64| found.push(x));
    for (found, expected) in found.iter().zip([-FRAC_PI_2, 0.0, -FRAC_PI_2, -FRAC_PI_2]) {
        near(*found, expected, 1e-12);
    }
    // Away from rest there are no modes.
    assert!(scene.modes(&scene.at_rest(&[-0.6, 0.0, -0.6, -0.6])?, &Unloaded).is_err());
    Ok(())
}

/// A four-bar linkage of revolutes in space, whose plane is tilted, against the same in the plane.
#[test]
fn a_linkage_of_revolutes_in_space_rests_and_swings_as_in_the_plane() -> Result<(), Error> {
    let lengths = [0.5, 1.0, 0.5, 1.2];
    let [a, b, c, d] = lengths;
    let (frequency, angles) = {
        use planar::*;
        let rod = |length: f64| Rod::uniform(length, length);
        let net = Network::new((Pin, rod(a), Pin, rod(b)), (RigidBody::massless([d, 0.0]), Pin, rod(c)), Pin);
        let scene = System::new(Clamped::at(0.0, 0.0, 0.0), net, Free)?.with_gravity(G);
        let rest = scene.equilibrium(scene.at_rest(&[-1.9, 0.1, -1.3])?, &Unloaded)?;
        let mode = scene.modes(&rest, &Unloaded)?.get(0).map(|mode| mode.frequency());
        let mut found = vec![];
        catena::system::Position::visit(rest.position(), &mut |x: f64| found.push(x));
        (mode.unwrap_or(f64::NAN), found)
    };
    use spatial::*;
    for tilt in [[0.0; 3], [0.3, 0.4, 0.5]] {
        // The linkage is in the plane of x and y of a ground that is turned, and gravity with it.
        let attitude = Rotation::from_angles(tilt);
        let hinge = Revolute::about([0.0, 0.0, 1.0]);
        let rod = |length: f64| Rod::new(length, length, 0.5 * length, 1e-4, length.powi(3) / 12.0);
        let arms = (hinge, rod(a), hinge, rod(b));
        let net = Network::new(arms, (RigidBody::massless([d, 0.0, 0.0]), hinge, rod(c)), LeastNorm(hinge));
        let gravity = attitude.turned([0.0, -G, 0.0]);
        let scene = System::new(Clamped::at([0.0; 3], attitude), net, Free)?.with_gravity(gravity);
        let rest = scene.equilibrium(scene.at_rest(&[-1.9, 2.0, -1.3])?, &Unloaded)?;
        let mut found = vec![];
        catena::system::Position::visit(rest.position(), &mut |x: f64| found.push(x));
        // Revolutes are relative.
        for (found, expected) in found.iter().zip([angles[0], angles[1] - angles[0], angles[2]]) {
            near(*found, expected, 1e-11);
        }
        let modes = scene.modes(&rest, &Unloaded)?;
        assert_eq!(modes.len(), 1);
        near(modes.get(0).map_or(f64::NAN, |mode| mode.frequency()), frequency, 1e-9 * frequency);
    }
    Ok(())
}
