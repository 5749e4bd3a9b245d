//! Initial motions from angles and rates of joints or of bodies.

use catena::loading::Unloaded;
use catena::planar::*;
use catena::scalar::Jet;
use catena::{Error, Fault};
use catena_oracle::{Noise, near};

const WELD: f64 = -0.7;

/// A floating plate, a hinge, a rod welded to another, a pin, a rod, and an array of hinged and pinned rods.
macro_rules! scene {
    ($root:expr) => {{
        let plate = RigidBody::new(0.9, 0.05, [0.3, 0.1], [0.7, -0.2]);
        let rod = Rod::uniform(0.4, 0.8);
        let hinge = ElasticHinge::rotary(7.0);
        let links = [(hinge, rod, Pin, rod); 3];
        System::new($root, (plate, hinge, (rod, Weld::at(WELD), rod), Pin, rod, links), Free)?
    }};
}
/// Of these bodies the angle is free where the root is pinned or free: all but the third, which is welded.
const FREE: [usize; 9] = [0, 1, 3, 4, 5, 6, 7, 8, 9];

fn angles(seed: u64) -> Vec<f64> {
    let mut noise = Noise::new(seed);
    FREE.iter().map(|_| 3.0 * noise.next()).collect()
}

#[test]
fn joint_angles_are_those_of_bodies_relative_to_each_other() -> Result<(), Error> {
    for ground in [0.0, 0.4] {
        let scene = scene!(Clamped::at(0.0, 0.0, ground));
        // The plate is clamped: its joint has no coordinate.
        let given = &angles(3)[1..];
        let motion = scene.at_joint_angles(given)?;
        let found = scene.angles(&motion)?;
        let angle = |body: usize| *found.get(body).unwrap_or(&f64::NAN);
        near(angle(0), ground, 0.0);
        near(angle(2) - angle(1), WELD, 1e-15);
        for (k, body) in FREE[1..].iter().copied().enumerate() {
            near(angle(body) - angle(body - 1), given[k], 1e-14); // rounding of angles up to 20
        }
    }
    Ok(())
}

#[test]
fn hinges_get_their_angles_to_the_last_digit() -> Result<(), Error> {
    let rod = Rod::uniform(1e-3, 1e-3);
    let n = 1000;
    let chain: Vec<_> = (0..n).map(|_| (rod, ElasticHinge::rotary(1e9))).collect();
    let blade = System::new(Clamped::at(0.0, 0.0, 0.3), (chain, rod), Free)?;
    let mut noise = Noise::new(5);
    let given: Vec<f64> = (0..n).map(|_| 0.01 * noise.next()).collect();
    let motion = blade.at_joint_angles(&given)?;
    let mut found = vec![];
    catena::system::Position::visit(motion.position(), &mut |x: f64| found.push(x));
    assert_eq!(found, given);
    Ok(())
}

#[test]
fn rates_of_joints_and_of_bodies_are_what_bodies_then_have() -> Result<(), Error> {
    let scene = scene!(Free);
    let given = angles(9);
    let mut start = scene.at_joint_angles(&angles(4))?;
    start.rate_mut().0.0 = 1.5; // the plate's place moves along x
    let place = |motion: &_| scene.body_motions(motion).unwrap().get(0).map(|body| body.inboard.velocity.x);
    let rates = |motion: &_| scene.body_motions(motion).unwrap().iter().map(BodyMotion::rate).collect::<Vec<_>>();

    let absolute = scene.with_body_rates(start, &given)?;
    let found = rates(&absolute);
    near(found[2], found[1], 0.0); // a weld
    for (k, body) in FREE.into_iter().enumerate() {
        near(found[body], given[k], 1e-14);
    }
    assert_eq!(place(&absolute), Some(1.5));

    let relative = scene.with_joint_rates(start, &given)?;
    let found = rates(&relative);
    for (k, body) in FREE.into_iter().enumerate() {
        let inboard = if body == 0 { 0.0 } else { found[body - 1] };
        near(found[body] - inboard, given[k], 1e-14);
    }
    assert_eq!(place(&relative), Some(1.5));
    Ok(())
}

#[test]
fn rates_are_relative_to_ground_that_turns() -> Result<(), Error> {
    let turning = Clamped { place: [0.0, 0.0], attitude: Turning(|t: f64| [0.2 + 3.0 * t, 3.0, 0.0]) };
    let rod = Rod::uniform(1.0, 1.0);
    let rotor = System::new(turning, (rod, ElasticHinge::rotary(1.0), rod, Pin, rod), Free)?;
    let motion = rotor.with_joint_rates(rotor.at_joint_angles(&[0.1, 0.2])?, &[0.5, -2.0])?;
    let found: Vec<_> = rotor.body_motions(&motion)?.iter().map(|body| (body.angle(), body.rate())).collect();
    for (found, expected) in found.iter().zip([(0.2, 3.0), (0.3, 3.5), (0.5, 1.5)]) {
        near(found.0, expected.0, 1e-15);
        near(found.1, expected.1, 1e-15);
    }
    let motion = rotor.with_body_rates(motion, &[3.5, 1.5])?;
    near(rotor.body_motions(&motion)?.get(1).unwrap().rate(), 3.5, 1e-15);
    Ok(())
}

#[test]
fn wrong_counts_and_nan_are_named() -> Result<(), Error> {
    let scene = scene!(Pinned::origin());
    let fault = |result: Result<_, Error>| result.map(|_| ()).map_err(|error| error.fault);
    let expected = FREE.len();
    assert_eq!(fault(scene.at_joint_angles(&[0.0; 3])), Err(Fault::Count { list: "joint angles", expected, given: 3 }));
    assert_eq!(fault(scene.at_joint_angles(&[f64::NAN; 9])), Err(Fault::NotFinite { parameter: "joint angle" }));
    let rest = scene.at_joint_angles(&[0.0; 9])?;
    assert_eq!(
        fault(scene.with_body_rates(rest, &[0.0; 10])),
        Err(Fault::Count { list: "rates", expected, given: 10 })
    );
    assert_eq!(fault(scene.with_joint_rates(rest, &[f64::INFINITY; 9])), Err(Fault::NotFinite { parameter: "rate" }));
    Ok(())
}

#[test]
fn tips_are_brought_to_where_they_are_held() -> Result<(), Error> {
    let rod = |length| Rod::uniform(length, length);
    let chain = (rod(0.5), Pin, rod(1.2), Pin, rod(0.9));
    let four_bar = System::new(Pinned::origin(), chain, Pinned::at(1.0, 0.0))?.with_gravity(9.81);
    let rough = four_bar.with_rates(four_bar.at_rest(&[1.0, 0.4, -1.8])?, &[1.0, 0.0, 0.0])?;
    let motion = four_bar.assembled(rough, &Unloaded)?;
    let tip = *four_bar.stations(&motion, &Unloaded)?.tip();
    near(tip.frame.place.x, 1.0, 2e-16);
    near(tip.frame.place.y, 0.0, 2e-16);
    near(tip.frame.velocity.norm(), 0.0, 5e-16);
    near(tip.frame.acceleration.linear.norm(), 0.0, 1e-13); // of accelerations of some 10 rad/s²

    // Out of reach: 2.6 m of rods, 5 m away.
    let far = System::new(Pinned::origin(), chain, Pinned::at(5.0, 0.0))?.with_gravity(9.81);
    match far.assembled(far.at_rest(&[1.0, 0.4, -1.8])?, &Unloaded) {
        Err(Error { fault: Fault::NotClosed { residual }, .. }) => assert!(residual > 2.4 - 1e-9, "{residual}"),
        other => panic!("no motion can reach there: {other:?}"),
    }
    Ok(())
}

/// An absolute angle is a sum of joint angles, also where those inboard are zero.
#[test]
fn joint_angles_keep_their_derivatives() -> Result<(), Error> {
    let rod = Rod::uniform(Jet::<f64, 2>::of(1.0), Jet::of(1.0));
    let hinge = ElasticHinge::rotary(Jet::of(3.0));
    let chain = System::new(Pinned::origin(), (rod, Pin, rod, hinge, rod), Free)?;
    for first in [0.0, 0.7] {
        let motion = chain.at_joint_angles(&[Jet::seed(first, 0), Jet::seed(0.3, 1), Jet::of(0.2)])?;
        let mut found = vec![];
        catena::system::Position::visit(motion.position(), &mut |x: Jet<f64, 2>| found.push(x));
        assert_eq!(found.iter().map(|x| x.eps).collect::<Vec<_>>(), [[1.0, 0.0], [1.0, 1.0], [0.0, 0.0]]);
        assert_eq!((found[0].re, found[2].re), (first, 0.2));
        near(found[1].re, first + 0.3, 1e-16);
    }
    Ok(())
}
