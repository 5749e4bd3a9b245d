//! Joints and ends with springs and lines: what makes no mechanics is refused, with its station.

use super::{INFINITY, NAN, rod};
use catena::planar::Absent;
use catena::planar::*;
use catena::{Error, Fault, Place};

/// What comes of a joint between two rods: its station is 1.
macro_rules! between {
    ($joint:expr) => {
        System::new(Pinned::origin(), (rod(), $joint, rod()), Free).map(|_| ())
    };
}

fn at_one(fault: Fault) -> Result<(), Error> {
    Err(Error { time: None, place: Some(Place::Station(1)), fault })
}

fn not_finite(parameter: &'static str) -> Result<(), Error> {
    at_one(Fault::NotFinite { parameter })
}

fn negative(parameter: &'static str, value: f64) -> Result<(), Error> {
    at_one(Fault::Negative { parameter, value })
}

/// A spring, and what is said of it.
type Refused = (Spring<f64, f64, f64>, Result<(), Error>);

/// Springs with something wrong, and what is wrong with them.
fn bad_springs() -> Vec<Refused> {
    let spring = |k: f64, c: f64, rest: f64| Spring::new(k).damped(c).resting_at(rest);
    let mut all = vec![
        (spring(-2.0, 0.1, 0.1), negative("stiffness", -2.0)),
        (spring(2.0, -0.1, 0.1), negative("damping", -0.1)),
        (spring(-INFINITY, 0.1, 0.1), not_finite("stiffness")),
    ];
    for bad in [NAN, INFINITY] {
        all.push((spring(bad, 0.1, 0.1), not_finite("stiffness")));
        all.push((spring(2.0, bad, 0.1), not_finite("damping")));
        all.push((spring(2.0, 0.1, bad), not_finite("rest value")));
    }
    all
}

#[test]
fn springs_without_mechanics_are_refused_wherever_they_are() {
    let good = Spring::new(3.0).damped(0.0).resting_at(-0.1);
    assert_eq!(between!(ElasticHinge::linear(good, good)), Ok(()));
    assert_eq!(between!(ElasticHinge::linear(Spring::new(0.0), Absent)), Ok(()));
    assert_eq!(between!(Slider::along(0.3).with(good)), Ok(()));
    for (bad, refused) in bad_springs() {
        assert_eq!(between!(ElasticHinge::linear(bad, good)), refused);
        assert_eq!(between!(ElasticHinge::linear(good, bad)), refused);
        assert_eq!(between!(ElasticHinge::linear(bad, Absent)), refused);
        assert_eq!(between!(ElasticHinge::linear(Absent, bad).in_fixed_axes()), refused);
        assert_eq!(between!(ElasticHinge::rotary(1.0).with_linear(good, bad).in_unbalanced_axes()), refused);
        assert_eq!(between!(Slider::along(0.3).with(bad)), refused);
    }
    // Of a rotary spring, too.
    for bad in [NAN, INFINITY] {
        assert_eq!(between!(ElasticHinge::rotary(bad).with_linear(good, good)), not_finite("stiffness"));
        assert_eq!(between!(ElasticHinge::rotary(1.0).damped(bad)), not_finite("damping"));
        assert_eq!(between!(ElasticHinge::rotary(1.0).resting_at(bad)), not_finite("rest value"));
    }
    assert_eq!(between!(ElasticHinge::rotary(-1.0)), negative("stiffness", -1.0));
    assert_eq!(between!(ElasticHinge::rotary(1.0).damped(-1.0).with_linear(good, good)), negative("damping", -1.0));
}

#[test]
fn directions_that_are_no_numbers_are_refused() {
    let refused = |place, parameter| Some(Error::new(Fault::NotFinite { parameter }).at(place));
    for bad in [NAN, INFINITY] {
        assert_eq!(between!(Slider::along(bad)), not_finite("direction"));
        assert_eq!(between!(Slider::along(bad).with(Spring::new(1.0))), not_finite("direction"));
        let clamp = |angle| Clamped::at(0.0, 0.0, angle);
        let (line, angle) = (Guided::on(clamp(0.2), bad), Guided::at(0.0, 0.0, bad));
        assert_eq!(
            System::new(line, rod(), Free).err(),
            refused(Place::Root, "direction of the line"),
            "as a root, line {bad}"
        );
        assert_eq!(System::new(angle, rod(), Free).err(), refused(Place::Root, "angle of the ground"));
        let chain = || (rod(), Pin, rod(), Pin, rod());
        assert_eq!(System::new(Pinned::origin(), chain(), line).err(), refused(Place::Tip, "direction of the line"));
        assert_eq!(System::new(Pinned::origin(), chain(), angle).err(), refused(Place::Tip, "angle of the ground"));
        for place in [Guided::at(bad, 0.0, 0.2), Guided::at(0.0, bad, 0.2)] {
            let found = System::new(Pinned::origin(), chain(), place).err();
            assert_eq!(found, refused(Place::Tip, "motion of the ground"));
        }
    }
}

/// A slider without anything behind it that has mass along its line.
#[test]
fn a_slider_that_nothing_resists_is_named() -> Result<(), Error> {
    let massless = PointMass::new(1.0, 0.0);
    let scene = System::new(Pinned::origin(), (rod(), Slider::along(0.3), massless), Free)?.with_gravity(9.81);
    let found = scene.with_accelerations(scene.at_rest(&[0.1])?, &catena::loading::Unloaded);
    assert_eq!(
        found.err().map(|error| (error.fault, error.place)),
        Some((Fault::SingularJoint, Some(Place::Station(1))))
    );
    Ok(())
}
