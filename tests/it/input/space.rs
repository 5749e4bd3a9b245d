//! What makes no mechanics in space is refused, with what and where.

use catena::spatial::*;
use catena::system::Element;
use catena::system::Runs;
use catena::{Error, Fault, Place, Scalar};
use catena_oracle::near;
use nalgebra::Vector3;

const NAN: f64 = f64::NAN;

fn rod() -> Rod<f64> {
    Rod::uniform(1.0, 0.1, 1.0)
}

/// A scene of a good rod, a ball, and a body: the body's inboard end is station 2.
fn second<B>(body: B) -> Result<(), Fault>
where
    B: Element<Spatial<f64>>,
    System<f64, Pinned<[f64; 3]>, (Rod<f64>, Ball, B), Free>:
        Runs<Unloaded, Spatial<f64>, Pinned<[f64; 3]>, (Rod<f64>, Ball, B), Free>,
{
    System::new(Pinned::origin(), (rod(), Ball, body), Free).map(|_| ()).map_err(|error| {
        assert_eq!((error.time, error.place), (None, Some(Place::Station(2))));
        error.fault
    })
}

/// A scene of two rods on a joint, at station 1.
fn joined<J>(joint: J) -> Result<(), Fault>
where
    J: Element<Spatial<f64>>,
    System<f64, Pinned<[f64; 3]>, (Rod<f64>, J, Rod<f64>), Free>:
        Runs<Unloaded, Spatial<f64>, Pinned<[f64; 3]>, (Rod<f64>, J, Rod<f64>), Free>,
{
    System::new(Pinned::origin(), (rod(), joint, rod()), Free).map(|_| ()).map_err(|error| {
        assert_eq!((error.time, error.place), (None, Some(Place::Station(1))));
        error.fault
    })
}

fn of_moments([a, b, c]: [f64; 3]) -> RigidBody<f64> {
    RigidBody::new(1.0, [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]], [0.5, 0.0, 0.0], [1.0, 0.0, 0.0])
}

/// Refused for a principal moment that is negative.
#[track_caller]
fn negative(outcome: Result<(), Fault>, least: f64) {
    let Err(Fault::Negative { parameter: "principal moment of inertia", value }) = outcome else {
        panic!("{outcome:?}")
    };
    assert!((value - least).abs() < 1e-15, "{value}");
}

#[test]
fn tensors_that_are_none_are_refused() {
    assert_eq!(second(of_moments([1.0, 2.0, 2.5])), Ok(()));
    assert_eq!(second(of_moments([1.0, 2.0, 3.0])), Ok(())); // a plate
    assert_eq!(second(of_moments([0.0, 1.0, 1.0])), Ok(())); // a thin rod
    // No body has these, but every pivot is positive: `doubtful_bodies` has what becomes of them.
    assert_eq!(second(of_moments([1.0, 2.0, 3.1])), Ok(()));
    assert_eq!(second(of_moments([5.0, 2.0, 2.0])), Ok(()));
    negative(second(of_moments([-1.0, 2.0, 2.0])), -1.0);
    let tensor = |xy: f64, yx: f64| {
        RigidBody::new(1.0, [[1.0, xy, 0.0], [yx, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.5, 0.0, 0.0], [1.0, 0.0, 0.0])
    };
    assert_eq!(second(tensor(0.3, 0.3)), Ok(()));
    assert_eq!(second(tensor(0.3, 0.4)), Err(Fault::NotSymmetric { parameter: "inertia tensor" }));
    assert_eq!(second(tensor(0.6, 0.6)), Ok(())); // moments 0.4, 1.6, 1
    negative(second(tensor(1.25, 1.25)), -0.25);
    assert_eq!(second(tensor(NAN, NAN)), Err(Fault::NotFinite { parameter: "inertia tensor" }));
}

#[test]
fn impossible_bodies_are_refused() {
    let moments = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let body = |mass, centre, outboard| RigidBody::new(mass, moments, [centre, 0.0, 0.0], [0.0, outboard, 0.0]);
    assert_eq!(second(body(-1.0, 0.0, 1.0)), Err(Fault::Negative { parameter: "mass", value: -1.0 }));
    assert_eq!(second(body(1.0, NAN, 1.0)), Err(Fault::NotFinite { parameter: "mass centre" }));
    assert_eq!(second(body(1.0, 0.0, f64::INFINITY)), Err(Fault::NotFinite { parameter: "outboard end" }));
    assert_eq!(second(Rod::uniform(0.0, 0.1, 1.0)), Err(Fault::NotPositive { parameter: "length", value: 0.0 }));
    assert_eq!(second(Rod::uniform(1.0, 0.1, 0.0)), Err(Fault::NotPositive { parameter: "mass", value: 0.0 }));
    assert_eq!(second(Rod::new(1.0, 1.0, 0.5, 0.3, 0.1)), Ok(()));
    let across = second(Rod::new(1.0, 1.0, 0.5, 0.1, -0.1)); // the value goes through base parameters
    assert!(
        matches!(across, Err(Fault::Negative { parameter: "moment of inertia", value }) if (value + 0.1).abs() < 1e-14),
        "{across:?}"
    );
    let negative = Fault::Negative { parameter: "moment of inertia", value: -0.1 };
    assert_eq!(second(Rod::new(1.0, 1.0, 0.5, -0.1, 0.1)), Err(negative));
    assert_eq!(second(PointMass::new(-1.0, 1.0)), Err(Fault::NotPositive { parameter: "length", value: -1.0 }));
    assert_eq!(second(PointMass::new(1.0, NAN)), Err(Fault::NotFinite { parameter: "mass" }));
}

#[test]
fn axes_that_are_none_are_refused() {
    let none = Fault::NotPositive { parameter: "length of the axis", value: 0.0 };
    assert_eq!(joined(Revolute::about([0.0, 0.0, 2.0])), Ok(()));
    assert_eq!(joined(Revolute::about([0.0; 3])), Err(none));
    assert_eq!(joined(Revolute::about([0.0, NAN, 0.0])), Err(Fault::NotFinite { parameter: "axis" }));
    assert_eq!(joined(Prismatic::along([0.0; 3])), Err(none));
    assert_eq!(joined(Cylindrical::on([0.0; 3])), Err(none));
    assert_eq!(joined(Universal::about([0.0; 3], [1.0, 0.0, 0.0])), Err(none));
    let slanted = Universal::about([1.0, 0.0, 0.0], [1.0, 0.1, 0.0]);
    assert_eq!(joined(slanted), Ok(()));
    assert_eq!(joined(Universal::about([1.0, 2.0, 3.0], [-2.0, -4.0, -6.0])), Err(Fault::ParallelAxes));
}

#[test]
fn springs_that_push_out_are_refused() {
    let hinge = Revolute::about([0.0, 0.0, 1.0]);
    let negative = |parameter| Err(Fault::Negative { parameter, value: -1.0 });
    assert_eq!(joined(hinge.with(Spring::stiffness(-1.0))), negative("stiffness"));
    assert_eq!(joined(hinge.with(Spring::damping(-1.0))), negative("damping"));
    let rest = hinge.with(Spring::stiffness(1.0).resting_at(NAN));
    assert_eq!(joined(rest), Err(Fault::NotFinite { parameter: "rest value" }));
}

#[test]
fn hinges_that_push_out_are_refused() {
    let negative = |parameter| Err(Fault::Negative { parameter, value: -1.0 });
    let infinite = |parameter| Err(Fault::NotFinite { parameter });
    let hinge = ElasticHinge::rotary([1.0, 0.0, 2.0]);
    let good = Spring::stiffness(1.0).damped(0.1).resting_at(0.1);
    assert_eq!(joined(hinge), Ok(()));
    assert_eq!(joined(hinge.with_linear(good, good, Spring::none())), Ok(()));
    for k in 0..3 {
        let with = |x: f64| core::array::from_fn(|i| if i == k { x } else { 1.0 });
        assert_eq!(joined(ElasticHinge::rotary(with(-1.0))), negative("stiffness"));
        assert_eq!(joined(ElasticHinge::rotary(with(NAN))), infinite("stiffness"));
        assert_eq!(joined(ElasticHinge::rotary(with(f64::INFINITY))), infinite("stiffness"));
        assert_eq!(joined(hinge.damped_about(with(-1.0))), negative("damping"));
        assert_eq!(joined(hinge.damped_about(with(NAN))), infinite("damping"));
        assert_eq!(joined(hinge.resting_at(with(NAN))), infinite("rest value"));
        let pick = |bad| core::array::from_fn(|i| if i == k { bad } else { good });
        let along = |bad| {
            let [x, y, z] = pick(bad);
            joined(hinge.with_linear(x, y, z))
        };
        assert_eq!(along(Spring::stiffness(-1.0).damped(0.1).resting_at(0.1)), negative("stiffness"));
        assert_eq!(along(Spring::stiffness(1.0).damped(-1.0).resting_at(0.1)), negative("damping"));
        assert_eq!(along(Spring::stiffness(1.0).damped(NAN).resting_at(0.1)), infinite("damping"));
        assert_eq!(along(Spring::stiffness(1.0).damped(0.1).resting_at(NAN)), infinite("rest value"));
    }
    assert_eq!(joined(hinge.damped(-1.0)), negative("damping"));
}

#[test]
fn quaternions_without_length_are_refused() {
    assert!(Rotation::from_quaternion([2.0, 0.0, 0.0, 0.0]).is_ok_and(|unit| unit == Rotation::identity()));
    assert!(Rotation::from_quaternion([0.0; 4]).is_err());
    assert!(Rotation::from_quaternion([NAN, 0.0, 0.0, 1.0]).is_err());
    assert!(Rotation::from_quaternion([f64::INFINITY, 0.0, 0.0, 1.0]).is_err());
}

/// Squares of these are no numbers, or have lost digits.
#[test]
fn quaternions_and_axes_are_of_any_length() -> Result<(), Error> {
    for tiny in [1e-22_f32, 1e22] {
        let [w, x, ..] = Rotation::from_quaternion([tiny, tiny, 0.0, 0.0])?.quaternion().map(f64::from);
        near(w.hypot(x), 1.0, 1e-6);
    }
    for size in [1e-200_f64, 1e200] {
        let [w, x, ..] = Rotation::from_quaternion([size, size, 0.0, 0.0])?.quaternion();
        near(w.hypot(x), 1.0, 1e-15);
        let turning = System::new(Hinged::at([0.0; 3], [size, 0.0, size]), rod(), Free)?;
        let unit = System::new(Hinged::at([0.0; 3], [1.0, 0.0, 1.0]), rod(), Free)?;
        let [one, other] = [turning, unit].map(|scene| scene.with_gravity([0.0, -9.81, 0.0]));
        let rate = |scene: &System<_, _, _, _>| {
            scene.with_accelerations(scene.motion(), &Unloaded).map(|motion| motion.acceleration().0)
        };
        near(rate(&one)?, rate(&other)?, 1e-14);
    }
    Ok(())
}

/// A matrix of two digits would stretch the body that it turns, by a thousandth.
#[test]
fn attitudes_that_stretch_are_refused() {
    let (cosine, sine) = (0.87, 0.5);
    let columns = Columns {
        x: Vector3::new(cosine, sine, 0.0),
        y: Vector3::new(-sine, cosine, 0.0),
        z: Vector3::new(0.0, 0.0, 1.0),
    };
    let rounded = Rotation::from_matrix(&columns);
    let stretches = |fault: Option<Error>, place| {
        let Some(Error { fault: Fault::OutOfRange { parameter, .. }, place: found, .. }) = fault else {
            panic!("{fault:?}")
        };
        assert_eq!((parameter, found), ("length of the quaternion", Some(place)));
    };
    stretches(System::new(Clamped::at([0.0; 3], rounded), rod(), Free).err(), Place::Root);
    stretches(System::new(Pinned::origin(), rod(), Clamped::at([0.0; 3], rounded)).err(), Place::Tip);
    let hinged = Hinged::on(Clamped::at([0.0; 3], rounded), [0.0, 0.0, 1.0]);
    stretches(System::new(hinged, rod(), Free).err(), Place::Root);
}

#[test]
fn ends_that_are_nowhere_are_refused() {
    let ground = Fault::NotFinite { parameter: "motion of the ground" };
    let pinned = System::new(Pinned::at([0.0, NAN, 0.0]), rod(), Free).map(|_| ());
    assert_eq!(pinned, Err(Error::new(ground).at(Place::Root)));
    let held = System::new(Pinned::origin(), rod(), Pinned::at([0.0, 0.0, NAN])).map(|_| ());
    assert_eq!(held, Err(Error::new(ground).at(Place::Tip)));
    let hinged = System::new(Hinged::at([0.0; 3], [0.0; 3]), rod(), Free).map(|_| ());
    let none = Fault::NotPositive { parameter: "length of the axis", value: 0.0 };
    assert_eq!(hinged, Err(Error::new(none).at(Place::Root)));
}

#[test]
fn counts_of_numbers_are_checked() -> Result<(), Error> {
    let system = System::new(Pinned::origin(), (rod(), Revolute::about([0.0, 0.0, 1.0]), rod()), Free)?;
    assert!(system.at_rest(&[0.0; 4]).is_ok());
    let count = |error: Error| error.fault;
    assert_eq!(
        system.at_rest(&[0.0; 3]).map_err(count).err(),
        Some(Fault::Count { list: "orientations", expected: 4, given: 3 })
    );
    let rates = system.with_rates(system.motion(), &[0.0; 5]).map_err(count).err();
    assert_eq!(rates, Some(Fault::Count { list: "rates", expected: 4, given: 5 }));
    Ok(())
}

/// A bob on a ball may spin about its link as it likes.
#[test]
fn a_ball_that_nothing_resists_is_named() -> Result<(), Error> {
    let system =
        System::new(Pinned::origin(), (rod(), Ball, PointMass::new(1.0, 1.0)), Free)?.with_gravity([0.0, -9.81, 0.0]);
    let error = system.with_accelerations(system.motion(), &Unloaded).err();
    let singular = Error { time: Some(0.0), place: Some(Place::Station(1)), fault: Fault::SingularJoint };
    assert_eq!(error, Some(singular));
    // However it stands: the pivot is then the rounding of zero, and its inverse a number. At the tip, before a ball, in a body of any kind.
    let thin = RigidBody::new(1.0, [[0.0; 3], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]], [0.4, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let at = |place| Some(Error { time: Some(0.0), place: Some(place), fault: Fault::SingularJoint });
    for angles in [[0.3, 0.4, 0.5], [0.0, 0.4, 0.5], [0.1, -0.7, 1.0]] {
        let bob = System::new(Pinned::origin(), PointMass::new(1.0, 1.0), Free)?.with_gravity([0.0, 0.0, -9.81]);
        assert_eq!(bob.with_accelerations(bob.at_rest(&angles)?, &Unloaded).err(), at(Place::Root));
        let chain = (rod(), Ball, thin, Ball, rod());
        let between = System::new(Pinned::origin(), chain, Free)?.with_gravity([0.0, 0.0, -9.81]);
        let all = [angles, angles, [0.2, 0.1, 0.4]].concat();
        assert_eq!(between.with_accelerations(between.at_rest(&all)?, &Unloaded).err(), at(Place::Station(1)));
        // At the end of an arm.
        let chain = (rod(), Branch((Ball, thin)), Ball, rod());
        let arm = System::new(Pinned::origin(), chain, Free)?.with_gravity([0.0, 0.0, -9.81]);
        assert_eq!(arm.with_accelerations(arm.at_rest(&all)?, &Unloaded).err(), at(Place::Station(1)));
        // A joint that hands on torques keeps it from spinning.
        let chain = (thin, Revolute::about([0.0, 0.0, 1.0]), rod());
        let held = System::new(Pinned::origin(), chain, Free)?.with_gravity([0.0, 0.0, -9.81]);
        held.with_accelerations(held.at_rest(&[angles[0], angles[1], angles[2], 0.5])?, &Unloaded)?;
    }
    Ok(())
}

/// Half a turn in one step has no coordinates: the step is refused, and the start given back.
#[test]
fn a_step_of_half_a_turn_is_refused() -> Result<(), Error> {
    let system = System::new(Pinned::origin(), rod(), Free)?;
    let start = system.with_rates(system.motion(), &[0.0, 0.0, 10.0])?;
    let interrupted = system.simulate(start, Rk4::step(1.0), 3.0, |_| ()).err();
    let (fault, last) = interrupted.map(|interrupted| (interrupted.error.fault, interrupted.last)).unzip();
    assert_eq!(fault, Some(Fault::NonFiniteMotion));
    assert_eq!(last.map(|last| last.position().0), Some(start.position().0));
    Ok(())
}

/// Angles of joints have a range, in which sines are accurate. Slides have none, nor has the turning of balls.
#[test]
fn an_angle_out_of_range_is_named() -> Result<(), Error> {
    let range = <f64 as Scalar>::ANGLE_RANGE;
    let o = [0.0, 0.0, 1.0];
    let cardan = Universal::about([0.0, 1.0, 0.0], o);
    let chain = (rod(), Revolute::about(o), rod(), cardan, rod(), Cylindrical::on([1.0, 0.0, 0.0]), rod());
    let scene = System::new(Pinned::origin(), chain, Free)?;
    let run = |revolute: f64, second: f64, cylindrical: [f64; 2]| {
        let mut motion = scene.motion().at_time(0.25);
        motion.position_mut().1.1 = revolute;
        motion.position_mut().1.3[1] = second;
        motion.position_mut().1.5 = cylindrical;
        scene.simulate(motion, Rk4::step(0.01), 0.26, |_| ()).map(|_| ()).map_err(|interrupted| interrupted.error)
    };
    let too_far = |angle: f64| Err(Error::new(Fault::AngleOutOfRange { angle }).at_time(0.25));
    assert_eq!(run(range - 1.0, 1.0 - range, [2.0 * range, range - 1.0]), Ok(()));
    assert_eq!(run(range + 1.0, 0.0, [0.0; 2]), too_far(range + 1.0));
    assert_eq!(run(0.0, -1e9, [0.0; 2]), too_far(-1e9));
    assert_eq!(run(0.0, 0.0, [0.0, 1e6]), too_far(1e6));

    // Spun up to where it leaves the range within a step: 1 rad goes by in half a step.
    let wheel = System::new(Hinged::at([0.0; 3], o), rod(), Free)?;
    let mut fast = wheel.motion();
    (*fast.position_mut(), *fast.rate_mut()) = ((range - 1.0, ()), (200.0, ()));
    let error = wheel.simulate(fast, Rk4::step(0.01), 1.0, |_| ()).err().map(|interrupted| interrupted.error);
    let Some(Error { time: Some(time), fault: Fault::AngleOutOfRange { angle }, .. }) = error else {
        panic!("{error:?}");
    };
    assert!(angle > range && angle < range + 2.0 && time < 0.02, "{angle} at {time}");

    // A ball has no angle that could leave a range: hundreds of turns.
    let ball = System::new(Pinned::origin(), rod(), Free)?;
    let fast = ball.with_rates(ball.motion(), &[300.0, 0.0, 0.0])?;
    let run = ball.simulate(fast, Dop853::step(1e-3), 10.0, |_| ()).map_err(|interrupted| interrupted.error)?;

    assert!((run.motion.rate().0[0] - 300.0).abs() < 1e-6);
    Ok(())
}
