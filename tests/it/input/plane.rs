//! What makes no mechanics is refused, with what, where and when; and what was good before stays as it was.

mod joints;

use catena::loading::{Loading, Unloaded};
use catena::planar::*;
use catena::simulate::Interrupted;
use catena::simulate::{Method, Stepper};
use catena::system::Element;
use catena::system::Root;
use catena::system::{MotionOf, Runs};
use catena::system::{Position, Rate};
use catena::time::{Explicit, Rule, Sdirk4};
use catena::{Cause, Error, Fault, Motion, Place, Scalar};
use core::fmt::Debug;

const NAN: f64 = f64::NAN;
const INFINITY: f64 = f64::INFINITY;

fn rod() -> Rod<f64> {
    Rod::uniform(1.0, 1.0)
}

/// A scene of a good rod, a pin, and a body: the body's inboard end is station 2.
fn second<B>(body: B) -> Result<(), Error>
where
    B: Element<Planar<f64>>,
    System<f64, Pinned<[f64; 2]>, (Rod<f64>, Pin, B), Free>:
        Runs<Unloaded, Planar<f64>, Pinned<[f64; 2]>, (Rod<f64>, Pin, B), Free>,
{
    System::new(Pinned::origin(), (rod(), Pin, body), Free).map(|_| ())
}

/// An error without time at station 2.
fn at_two(fault: Fault) -> Result<(), Error> {
    Err(Error { time: None, place: Some(Place::Station(2)), fault })
}

fn negative(parameter: &'static str, value: f64) -> Result<(), Error> {
    at_two(Fault::Negative { parameter, value })
}

fn not_positive(parameter: &'static str, value: f64) -> Result<(), Error> {
    at_two(Fault::NotPositive { parameter, value })
}

fn not_finite(parameter: &'static str) -> Result<(), Error> {
    at_two(Fault::NotFinite { parameter })
}

#[test]
fn bodies_without_mechanics_are_refused_with_their_station() {
    let plate = |mass, inertia| RigidBody::new(mass, inertia, [0.4, 0.1], [0.8, 0.2]);
    assert_eq!(second(plate(1.0, 0.1)), Ok(()));
    assert_eq!(second(plate(-1.0, 0.1)), negative("mass", -1.0));
    assert_eq!(second(plate(1.0, -0.1)), negative("moment of inertia", -0.1));
    for bad in [NAN, INFINITY, -INFINITY] {
        assert_eq!(second(plate(bad, 0.1)), not_finite("mass"));
        assert_eq!(second(plate(1.0, bad)), not_finite("moment of inertia"));
        assert_eq!(second(RigidBody::new(1.0, 0.1, [bad, 0.0], [1.0, 0.0])), not_finite("mass centre"));
        assert_eq!(second(RigidBody::new(1.0, 0.1, [0.0, bad], [1.0, 0.0])), not_finite("mass centre"));
        assert_eq!(second(RigidBody::new(1.0, 0.1, [0.0, 0.0], [bad, 0.0])), not_finite("outboard end"));
        assert_eq!(second(RigidBody::new(1.0, 0.1, [0.0, 0.0], [1.0, bad])), not_finite("outboard end"));
    }

    assert_eq!(second(Rod::uniform(0.0, 1.0)), not_positive("length", 0.0));
    assert_eq!(second(Rod::uniform(-2.0, 1.0)), not_positive("length", -2.0));
    assert_eq!(second(Rod::uniform(1.0, 0.0)), not_positive("mass", 0.0));
    assert_eq!(second(Rod::uniform(1.0, -3.0)), not_positive("mass", -3.0));
    // A body lighter in rotation than any with its mass centre could be; rods store other numbers, hence the rounding.
    let refused = second(Rod::new(1.0, 1.0, 0.25, -0.5));
    let Err(Error { time: None, place: Some(Place::Station(2)), fault: Fault::Negative { parameter, value } }) =
        refused
    else {
        panic!("{refused:?}");
    };
    assert!(parameter == "moment of inertia" && (value + 0.5).abs() < 1e-15);
    for bad in [NAN, INFINITY, -INFINITY] {
        assert_eq!(second(Rod::uniform(bad, 1.0)), not_finite("length"));
        assert_eq!(second(Rod::uniform(1.0, bad)), not_finite("mass"));
        assert!(matches!(second(Rod::new(1.0, 1.0, bad, 0.1)), Err(Error { fault: Fault::NotFinite { .. }, .. })));
        assert_eq!(second(Rod::new(1.0, 1.0, 0.5, bad)), not_finite("moment of inertia"));
    }

    assert_eq!(second(PointMass::new(0.0, 1.0)), not_positive("length", 0.0));
    assert_eq!(second(PointMass::new(-1.0, 1.0)), not_positive("length", -1.0));
    assert_eq!(second(PointMass::new(1.0, -1.0)), negative("mass", -1.0));
    for bad in [NAN, INFINITY] {
        assert_eq!(second(PointMass::new(bad, 1.0)), not_finite("length"));
        assert_eq!(second(PointMass::new(1.0, bad)), not_finite("mass"));
    }
}

#[test]
fn stations_are_counted_through_tuples_arrays_and_vectors() {
    let bad = Rod::uniform(1.0, NAN);
    let link = |k: usize| (Pin, if k == 3 { bad } else { rod() });
    let fault = Fault::NotFinite { parameter: "mass" };
    let at = |station| Some(Error::new(fault).at_station(station));
    assert_eq!(System::new(Pinned::origin(), bad, Free).err(), at(0));
    assert_eq!(System::new(Free, (rod(), bad), Free).err(), at(1));
    // Bodies 0, 1, 2 and 3 are elements 0, 2, 4 and 6.
    assert_eq!(System::new(Pinned::origin(), (rod(), [link(1), link(2), link(3)]), Free).err(), at(6));
    assert_eq!(System::new(Pinned::origin(), (rod(), vec![link(1), link(2), link(3), link(4)]), Free).err(), at(6));
    let nested = ((rod(), [link(1)]), (vec![link(2)], link(3)), link(3));
    assert_eq!(System::new(Pinned::origin(), nested, Free).err(), at(6));
}

#[test]
fn chains_without_bodies_are_refused() {
    let nothing = Some(Error::new(Fault::NoBodies));
    let no_rods: [Rod<f64>; 0] = [];
    let no_links: [(Pin, Rod<f64>); 0] = [];
    assert_eq!(System::new(Pinned::origin(), Vec::<Rod<f64>>::new(), Free).err(), nothing);
    assert_eq!(System::new(Free, no_rods, Free).err(), nothing);
    assert_eq!(System::new(Free, (no_rods, Vec::<Rod<f64>>::new()), Free).err(), nothing);
    assert!(System::new(Pinned::origin(), (rod(), Vec::<(Pin, Rod<f64>)>::new()), Free).is_ok());
    assert!(System::new(Pinned::origin(), (rod(), no_links), Free).is_ok());
}

#[test]
fn a_place_of_the_root_that_is_no_number_is_refused() {
    let refused = Error::new(Fault::NotFinite { parameter: "motion of the ground" }).at(Place::Root);
    for bad in [NAN, INFINITY] {
        assert_eq!(System::new(Pinned::at(bad, 0.0), rod(), Free).err(), Some(refused));
        assert_eq!(System::new(Pinned::at(0.0, bad), rod(), Free).err(), Some(refused));
    }
}

#[cfg(feature = "num-dual")]
#[test]
fn a_parameter_with_a_derivative_that_is_no_number_is_refused() {
    use num_dual::Dual64;
    let rod = Rod::uniform(Dual64::literal(1.0), Dual64::new(1.0, NAN));
    let refused = Error::new(Fault::NotFinite { parameter: "mass" }).at_station(0);
    assert_eq!(System::new(Free, rod, Free).err(), Some(refused));
}

/// A double pendulum of rods, and a start that moves.
type Pendulum = System<f64, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>), Free>;
type Moving2 = MotionOf<Planar<f64>, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>), Free>;

fn pendulum() -> Result<(Pendulum, Moving2), Error> {
    let system = System::new(Pinned::origin(), (rod(), Pin, rod()), Free)?.with_gravity(9.81);
    let start = system.with_rates(system.at_rest(&[0.3, -0.2])?, &[1.0, -1.0])?.at_time(0.25);
    let start = system.with_accelerations(start, &Unloaded)?;
    Ok((system, start))
}

#[test]
fn wrong_numbers_of_angles_and_rates_are_counted() -> Result<(), Error> {
    let (system, start) = pendulum()?;
    for given in [0, 1, 3, 100] {
        let refused = |list| Some(Error::new(Fault::Count { list, expected: 2, given }));
        assert_eq!(system.at_rest(&vec![0.1; given]).err(), refused("orientations"));
        assert_eq!(system.with_rates(start, &vec![0.1; given]).err(), refused("rates"));
    }
    // A floating chain has two rates more than angles.
    let system = System::new(Free, (rod(), vec![(Pin, rod()); 2]), Free)?;
    assert_eq!(
        system.at_rest(&[0.0; 5]).err(),
        Some(Error::new(Fault::Count { list: "orientations", expected: 3, given: 5 }))
    );
    let start = system.at_rest(&[0.0; 3])?;
    assert_eq!(
        system.with_rates(start, &[0.0; 3]).err(),
        Some(Error::new(Fault::Count { list: "rates", expected: 5, given: 3 }))
    );
    Ok(())
}

#[test]
fn angles_and_rates_that_are_no_numbers_are_refused() -> Result<(), Error> {
    let (system, start) = pendulum()?;
    for bad in [NAN, INFINITY] {
        let orientation = Error::new(Fault::NotFinite { parameter: "orientation" });
        assert_eq!(system.at_rest(&[0.0, bad]).err(), Some(orientation));
        let rate = Error::new(Fault::NotFinite { parameter: "rate" });
        assert_eq!(system.with_rates(start, &[bad, 0.0]).err(), Some(rate));
    }
    Ok(())
}

/// All numbers of a motion by their bits.
fn bits<P: Position<f64>>(motion: &Motion<f64, P>) -> Vec<u64> {
    let mut bits = vec![motion.time().to_bits()];
    Position::visit(motion.position(), &mut |x| bits.push(x.to_bits()));
    Rate::visit(motion.rate(), &mut |x| bits.push(x.to_bits()));
    Rate::visit(motion.acceleration(), &mut |x| bits.push(x.to_bits()));
    bits
}

/// The bits of time, positions and rates: a run finds the accelerations of its start anew.
fn start_bits<P: Position<f64>>(motion: &Motion<f64, P>) -> Vec<u64> {
    let mut all = bits(motion);
    Rate::visit(motion.acceleration(), &mut |_| _ = all.pop());
    all
}

/// The error of a step by a rule, both ways; the past motion keeps its bits.
fn failing_step<R, C, L, M>(
    system: &System<f64, R, C, Free>,
    past: &MotionOf<Planar<f64>, R, C, Free>,
    loads: &L,
    method: M,
) -> [Error; 2]
where
    R: Root<Planar<f64>>,
    C: Element<Planar<f64>>,
    L: Loading<Planar<f64>>,
    M: for<'s> Method<&'s System<f64, R, C, Free>, L>,
    System<f64, R, C, Free>: Runs<L, Planar<f64>, R, C, Free>,
{
    let before = bits(past);
    let mut next = past.clone();
    let mut stepper = system.stepper(method);
    let errors = [
        stepper.step(past, loads, 0.125, &mut next).unwrap_err(),
        stepper.advance(past, loads, 0.125, &mut next).unwrap_err(),
    ];
    assert_eq!(bits(past), before);
    errors
}

/// The same for every rule, and by a run, whose last motion is the start.
macro_rules! fails {
    ($system:expr, $past:expr, $loads:expr) => {{
        let (system, past, loads) = (&$system, &$past, &$loads);
        let mut errors = [
            failing_step(system, past, loads, Rk4),
            failing_step(system, past, loads, Dopri5),
            failing_step(system, past, loads, Dop853),
            failing_step(system, past, loads, GeneralizedAlpha::new(0.8)),
            failing_step(system, past, loads, Sdirk4::new()),
        ]
        .concat();
        let run = system.simulation(Rk4::step(0.125)).loads(loads).run(past.clone(), 1.0, |_| ());
        let Interrupted { error, last } = run.unwrap_err();
        assert_eq!(start_bits(&last), start_bits(past));
        errors.push(error);
        errors
    }};
}

#[test]
fn a_joint_that_nothing_resists_is_named() -> Result<(), Error> {
    let massless = PointMass::new(1.0, 0.0);
    let flywheel = RigidBody::new(1.0, 0.0, [0.0; 2], [1.0, 0.0]);
    let singular = |place| Error::new(Fault::SingularJoint).at(place).at_time(0.25);

    // Without inertia at the tip, about the pin before it: element 1.
    let system = System::new(Pinned::origin(), (rod(), Pin, massless), Free)?.with_gravity(9.81);
    let start = system.at_rest(&[0.1, 0.2])?.at_time(0.25);
    assert_eq!(system.with_accelerations(start, &Unloaded).err(), Some(singular(Place::Station(1))));
    for error in fails!(system, start, Unloaded) {
        assert_eq!(error.fault, Fault::SingularJoint);
        assert_eq!(error.place, Some(Place::Station(1)));
        // At the start, or in the step where the accelerations of the start were taken for granted.
        assert!(error.time.is_some_and(|time| (0.25..=0.375).contains(&time)), "{error:?}");
    }
    let system = System::new(Pinned::origin(), (rod(), vec![(Pin, rod()), (Pin, rod())], Pin, flywheel), Free)?;
    let start = system.at_rest(&[0.1; 4])?.at_time(0.25);
    assert_eq!(system.with_accelerations(start, &Unloaded).err(), Some(singular(Place::Station(5))));

    // About the root's joint, pinned or floating.
    let system = System::new(Pinned::origin(), massless, Free)?;
    let start = system.at_rest(&[0.1])?.at_time(0.25);
    assert_eq!(system.with_accelerations(start, &Unloaded).err(), Some(singular(Place::Root)));
    let system = System::new(Free, massless, Free)?;
    let start = system.at_rest(&[0.1])?.at_time(0.25);
    assert_eq!(system.with_accelerations(start, &Unloaded).err(), Some(singular(Place::Root)));

    // Links without mass are no harm where something lies outboard of them.
    let system = System::new(Pinned::origin(), (massless, Pin, flywheel, Pin, rod()), Free)?.with_gravity(9.81);
    assert!(system.with_accelerations(system.at_rest(&[0.1, 0.7, 1.9])?, &Unloaded).is_ok());
    Ok(())
}

#[test]
fn a_load_that_is_no_number_is_named_with_its_station_and_its_time() -> Result<(), Error> {
    let (system, start) = pendulum()?;
    for bad in [NAN, INFINITY] {
        for (body, station) in [(0, 0), (1, 2)] {
            for part in 0..2 {
                let loads = Loads::none().on_bodies(move |time: f64, k, motion: &BodyMotion<f64>| {
                    let value = if k == body && time > 0.25 { bad } else { 1.0 };
                    let [force, torque] = if part == 0 { [value, 1.0] } else { [1.0, value] };
                    motion.force_at([0.5, 0.0], [1.0, force]) + Wrench::torque(torque)
                });
                for error in fails!(system, start, loads) {
                    assert_eq!(error.fault, Fault::NonFiniteLoad);
                    assert_eq!(error.place, Some(Place::Station(station)));
                    assert!(error.time.is_some_and(|time| time > 0.25 && time <= 0.375), "{error:?}");
                }
            }
        }
        for (joint, place) in [(0, Place::Root), (1, Place::Station(1))] {
            let loads = Loads::none().in_joints(
                move |time: f64, k, _: &JointMotion<f64>| {
                    if k == joint && time > 0.25 { bad } else { 1.0 }
                },
            );
            for error in fails!(system, start, loads) {
                assert_eq!((error.fault, error.place), (Fault::NonFiniteLoad, Some(place)));
                assert!(error.time.is_some_and(|time| time > 0.25 && time <= 0.375), "{error:?}");
            }
        }
    }
    // At the start, too.
    let loads = Loads::none().in_joints(|_, joint, _: &JointMotion<f64>| if joint == 1 { NAN } else { 0.0 });
    let expected = Error::new(Fault::NonFiniteLoad).at_station(1).at_time(0.25);
    assert_eq!(system.with_accelerations(start, &loads).err(), Some(expected));
    Ok(())
}

#[test]
fn a_run_that_fails_at_its_start_gives_the_start_back() -> Result<(), Error> {
    let (system, start) = pendulum()?;
    let loads = Loads::none().in_joints(|_, joint, _: &JointMotion<f64>| if joint == 1 { NAN } else { 0.0 });
    let run = system.simulation(Dop853::tolerance(1e-9)).loads(&loads).run(start, 1.0, |_| ());
    let Interrupted { error, last } = run.unwrap_err();
    assert_eq!(error, Error::new(Fault::NonFiniteLoad).at_station(1).at_time(0.25));
    assert_eq!(bits(&last), bits(&start));
    Ok(())
}

#[test]
fn a_run_that_fails_gives_the_error_and_the_last_motion_it_accepted() -> Result<(), Error> {
    let (system, start) = pendulum()?;
    let loads = Loads::none().in_joints(|time: f64, _, _: &JointMotion<f64>| if time > 0.6 { NAN } else { 0.1 });
    let mut shown = vec![];
    let run = system.simulation(Rk4::step(0.0625)).loads(&loads).run(start, 2.0, |now| shown.push(bits(now.motion())));
    let Interrupted { error, last } = run.unwrap_err();
    // Steps end at 0.3125, 0.375, .. 0.5625; the next one has a stage in its middle, at 0.59375, and one at its end.
    assert_eq!(error, Error::new(Fault::NonFiniteLoad).at_station(1).at_time(0.625));
    assert_eq!(last.time(), 0.5625);
    assert_eq!(shown.last(), Some(&bits(&last)));
    assert_eq!(shown.len(), 6);
    // As an error it reads well, and says the same.
    assert_eq!(Interrupted { error, last }.to_string(), "a load is not finite, at station 1, at t = 0.625 s");
    Ok(())
}

#[test]
fn motions_of_another_shape_are_refused() -> Result<(), Error> {
    let scene = |n| System::new(Pinned::origin(), (rod(), vec![(Pin, rod()); n]), Free);
    let (small, large) = (scene(2)?, scene(3)?);
    let (start, other) = (small.at_rest(&[0.1; 3])?, large.at_rest(&[0.1; 4])?);
    let shape = Some(Error::new(Fault::Shape));
    assert_eq!(small.with_accelerations(other.clone(), &Unloaded).err(), shape);
    let run = small.simulate(other, Rk4::step(0.1), 1.0, |_| ()).map_err(|interrupted| interrupted.error);
    assert_eq!(run.err(), shape);
    assert!(small.simulate(start, Rk4::step(0.1), 1.0, |_| ()).is_ok());
    Ok(())
}

/// Steps to and from motions of another shape by every rule.
#[test]
fn steps_refuse_motions_of_another_shape() -> Result<(), Error> {
    type Scene = System<f64, Pinned<[f64; 2]>, (Rod<f64>, Vec<(Pin, Rod<f64>)>), Free>;
    fn refuse<M: for<'s> Method<&'s Scene, Unloaded>>(method: M) -> Result<(), Error> {
        let scene = |n| System::new(Pinned::origin(), (rod(), vec![(Pin, rod()); n]), Free);
        let (small, large) = (scene(2)?, scene(3)?);
        let (start, other) = (small.at_rest(&[0.1; 3])?, large.at_rest(&[0.1; 4])?);
        let (mut next, mut wrong) = (start.clone(), other.clone());
        let mut stepper = small.stepper(method);
        let shape = Err(Error::new(Fault::Shape));
        assert_eq!(stepper.step(&other, &Unloaded, 0.1, &mut next), shape);
        assert_eq!(stepper.step(&start, &Unloaded, 0.1, &mut wrong), shape);
        assert_eq!(stepper.advance(&other, &Unloaded, 0.1, &mut next), shape);
        assert_eq!(stepper.advance(&start, &Unloaded, 0.1, &mut wrong), shape);
        // Nothing came of it, and the stepper still works.
        assert_eq!((bits(&next), bits(&wrong)), (bits(&start), bits(&other)));
        assert_eq!(stepper.step(&start, &Unloaded, 0.1, &mut next), Ok(()));
        assert_eq!(stepper.advance(&start, &Unloaded, 0.1, &mut next), Ok(()));
        Ok(())
    }
    refuse(Rk4)?;
    refuse(Dopri5)?;
    refuse(Dop853)?;
    refuse(GeneralizedAlpha::new(0.8))?;
    refuse(Sdirk4::new())
}

#[test]
fn motions_of_another_shape_with_as_many_numbers_are_refused() -> Result<(), Error> {
    let scene = |m, n| System::new(Pinned::origin(), (rod(), [vec![(Pin, rod()); m], vec![(Pin, rod()); n]]), Free);
    let (this, other) = (scene(1, 2)?, scene(2, 1)?);
    let start = other.at_rest(&[0.1; 4])?;
    assert_eq!(this.with_accelerations(start, &Unloaded).err(), Some(Error::new(Fault::Shape)));
    Ok(())
}

#[test]
fn an_angle_out_of_range_is_named() -> Result<(), Error> {
    let (system, _) = pendulum()?;
    let range = f64::ANGLE_RANGE;
    let too_far = |angle: f64, time| Some(Error::new(Fault::AngleOutOfRange { angle }).at_time(time));

    let inside = system.at_rest(&[0.0, range - 1.0])?;
    assert!(system.simulate(inside, Rk4::step(0.1), 0.1, |_| ()).is_ok());
    for angle in [range + 1.0, -1e9] {
        let outside = system.at_rest(&[0.0, angle])?.at_time(0.25);
        let run = system.simulate(outside, Rk4::step(0.1), 1.0, |_| ()).map_err(|interrupted| interrupted.error);
        assert_eq!(run.err(), too_far(angle, 0.25));
    }

    // Spun up to where it leaves the range within a step; without gravity the rate stays.
    let single = System::new(Pinned::origin(), rod(), Free)?;
    let fast = single.with_rates(single.at_rest(&[range - 1.0])?.at_time(0.25), &[16.0])?;
    for error in fails!(single, fast, Unloaded) {
        let Error { time: Some(time), place: None, fault: Fault::AngleOutOfRange { angle } } = error else {
            panic!("{error:?}");
        };
        // One radian goes by in half a step.
        assert!(angle > range && angle < range + 1.1 && time == 0.375);
    }
    Ok(())
}

#[test]
fn a_start_that_is_no_number_is_refused() -> Result<(), Error> {
    let (system, start) = pendulum()?;
    let refused = Error::new(Fault::NonFiniteMotion).at_time(0.25);
    for bad in [NAN, INFINITY] {
        let mut position = start;
        position.position_mut().1.1 = bad;
        let mut rate = start;
        rate.rate_mut().0 = bad;
        for motion in [position, rate] {
            assert_eq!(system.with_accelerations(motion, &Unloaded).err(), Some(refused));
            for error in fails!(system, motion, Unloaded) {
                assert_eq!(error, refused);
            }
        }
    }
    Ok(())
}

/// A torque that grows with the square of the rate: the rate is 1/(1 − t), and infinite at one second.
#[test]
fn steps_too_small_to_advance_time_end_a_run() -> Result<(), Error> {
    let system = System::new(Pinned::origin(), PointMass::new(1.0, 1.0), Free)?;
    let start = system.with_rates(system.at_rest(&[0.0])?, &[1.0])?;
    let loads = Loads::none().in_joints(|_, _, motion: &JointMotion<f64>| motion.rate() * motion.rate());
    let mut shown = vec![];
    let run = system.simulation(Dop853::tolerance(1e-10)).loads(&loads).run(start, 2.0, |now| {
        assert!(shown.len() < 10_000, "the run does not end");
        shown.push(bits(now.motion()));
    });
    let Interrupted { error, last } = run.unwrap_err();
    let Error { time: Some(time), place: None, fault: Fault::StepTooSmall { step, cause } } = error else {
        panic!("{error:?}");
    };
    println!("{error}, after {} steps", shown.len());
    // Where the solution ends but for the errors of the steps; a step of half an ulp.
    assert!((time - 1.0).abs() < 1e-8 && step > 0.0 && step < 2.3e-16);
    assert!(matches!(cause, Cause::Inaccurate | Cause::NonFiniteMotion), "{cause:?}");
    assert_eq!(last.time(), time);
    assert_eq!(shown.last(), Some(&bits(&last)));
    Ok(())
}

/// Why a run from the pendulum's start was refused; an error of the test where it was not, or does not end.
fn refused<M: Explicit>(rule: Rule<M, f64>, every: Option<f64>, end: f64) -> Result<Fault, Error> {
    let (system, start) = pendulum()?;
    let mut calls = 0;
    let simulation = system.simulation(rule);
    let simulation = if let Some(every) = every { simulation.every(every) } else { simulation };
    let run = simulation.run(start, end, |_| {
        calls += 1;
        assert!(calls < 1000, "the run does not end");
    });
    let Interrupted { error, last } = run.unwrap_err();
    assert_eq!(bits(&last), bits(&start));
    Ok(error.fault)
}

fn of_a_number(fault: Fault) -> bool {
    matches!(fault, Fault::NotPositive { .. } | Fault::NotFinite { .. })
}

#[test]
fn runs_that_end_before_they_start_are_refused() -> Result<(), Error> {
    for end in [NAN, INFINITY] {
        assert!(matches!(refused(Rk4::step(0.1), None, end)?, Fault::NotFinite { .. }), "end {end}");
    }
    assert!(matches!(refused(Rk4::step(0.1), None, 0.0)?, Fault::OutOfRange { value: 0.0, .. }));
    Ok(())
}

#[test]
fn runs_with_steps_that_are_no_steps_are_refused() -> Result<(), Error> {
    for step in [0.0, -0.1, NAN, INFINITY] {
        assert!(of_a_number(refused(Rk4::step(step), None, 1.0)?), "step {step}");
    }
    Ok(())
}

#[test]
fn runs_with_tolerances_that_are_no_tolerances_are_refused() -> Result<(), Error> {
    for tolerance in [0.0, -1e-9, NAN, INFINITY] {
        assert!(of_a_number(refused(Dopri5::tolerance(tolerance), None, 1.0)?), "DOPRI5, tolerance {tolerance}");
        assert!(of_a_number(refused(Dop853::tolerance(tolerance), None, 1.0)?), "DOP853, tolerance {tolerance}");
    }
    Ok(())
}

#[test]
fn runs_with_intervals_that_are_no_intervals_are_refused() -> Result<(), Error> {
    for every in [0.0, -0.1, NAN] {
        assert!(of_a_number(refused(Rk4::step(0.1), Some(every), 1.0)?), "interval {every}");
    }
    Ok(())
}

#[test]
fn gravity_that_is_no_number_is_named() -> Result<(), Error> {
    let system = System::new(Pinned::origin(), rod(), Free)?.with_gravity(NAN);
    let error = system.with_accelerations(system.at_rest(&[0.1])?, &Unloaded).unwrap_err();
    assert_eq!(error.fault, Fault::NotFinite { parameter: "gravity" });
    Ok(())
}

#[test]
fn ground_whose_motion_is_no_number_is_named() -> Result<(), Error> {
    let ground = Moving(|t: f64| GroundMotion {
        place: [0.0; 2],
        velocity: [0.0; 2],
        acceleration: [if t > 0.5 { NAN } else { 0.0 }, 0.0],
    });
    let system = System::new(Pinned::on(ground), rod(), Free)?;
    let error = system.with_accelerations(system.at_rest(&[0.1])?.at_time(0.75), &Unloaded).unwrap_err();
    assert_eq!(error.fault, Fault::NotFinite { parameter: "motion of the ground" });
    assert_eq!((error.place, error.time), (Some(Place::Root), Some(0.75)));
    Ok(())
}

/// Errors are values: copied, compared, printed, and the standard trait's.
#[test]
fn errors_say_what_where_and_when() {
    fn is_error<E: std::error::Error + Copy + PartialEq + Debug>(error: E) -> String {
        error.to_string()
    }
    let error = Error::new(Fault::NotPositive { parameter: "length", value: -2.0 }).at_station(4);
    assert_eq!(is_error(error), "length must be positive, but is -2, at station 4");
    // Numbers that would be rows of zeros have exponents.
    let error = Error::new(Fault::Negative { parameter: "mass", value: -2e300 }).at_time(3e-9);
    assert_eq!(is_error(error), "mass must not be negative, but is -2e300, at t = 3e-9 s");
    let range = |least, most| Fault::OutOfRange { parameter: "share", value: 0.7, least, most, outside: "no more" };
    assert_eq!(range(0.0, 0.5).to_string(), "share must lie between 0 and 0.5, but is 0.7: no more");
    assert_eq!(range(1e-30, f64::INFINITY).to_string(), "share must be finite and at least 1e-30, but is 0.7: no more");
    assert_eq!(range(0.0, 0.0).to_string(), "share must be 0, but is 0.7: no more");
    let error = Error::new(Fault::SingularJoint).at(Place::Root).at_time(1.5);
    assert_eq!(
        is_error(error),
        "nothing resists the motion in this joint (what lies outboard has no mass or inertia along or about it, or another joint there moves alike), at the root, at t = 1.5 s"
    );
}

/// Ground that is lost on the way ends a run there, though no joint feels where it is.
#[test]
fn ground_that_is_lost_on_the_way_is_named() -> Result<(), Error> {
    let (still, place) = ([0.0; 2], |time: f64| [if time > 0.5 { NAN } else { 0.0 }, 0.0]);
    let ground = Moving(move |time| GroundMotion { place: place(time), velocity: still, acceleration: still });
    let system = System::new(Pinned::on(ground), (rod(), Pin, rod()), Free)?;
    let stopped = system.simulation(Rk4::step(0.01)).run(system.at_rest(&[0.3, 0.1])?, 1.0, |_| ()).unwrap_err();
    assert_eq!(stopped.error.fault, Fault::NotFinite { parameter: "motion of the ground" });
    assert_eq!(stopped.error.place, Some(Place::Root));
    assert!((stopped.last.time() - 0.5).abs() < 0.011, "{}", stopped.last.time());
    Ok(())
}

#[test]
fn a_time_that_is_no_number_is_none_to_go_on_to() -> Result<(), Error> {
    let (system, start) = pendulum()?;
    let mut run = system.simulation(Rk4::step(0.01)).begin(start, 1.0, |_| ()).map_err(|stopped| stopped.error)?;
    assert_eq!(run.until(NAN).unwrap_err().fault, Fault::NotFinite { parameter: "time until which a run is to go on" });
    run.until(INFINITY)?;
    assert_eq!(run.motion().time(), 1.0);
    Ok(())
}
