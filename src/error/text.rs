//! What errors say.

use super::{Cause, Error, Fault, Place};
use core::fmt;

/// A number to be read: with an exponent where it would be a row of zeros.
struct Number(f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        let plain = size == 0.0 || !size.is_finite() || (1e-5..1e16).contains(&size);
        if plain { self.0.fmt(f) } else { fmt::LowerExp::fmt(&self.0, f) }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Fault::NotZero { parameter } => write!(f, "{parameter} must be zero"),
            Fault::NotPositive { parameter, value } => {
                let finite = if value > 0.0 { " and finite" } else { "" };
                write!(f, "{parameter} must be positive{finite}, but is {}", Number(value))
            }
            Fault::Negative { parameter, value } => {
                write!(f, "{parameter} must not be negative, but is {}", Number(value))
            }
            Fault::OutOfRange { parameter, value, least, most, outside } if least == most => {
                let [value, least] = [value, least].map(Number);
                write!(f, "{parameter} must be {least}, but is {value}: {outside}")
            }
            Fault::OutOfRange { parameter, value, least, most, outside } if most.is_finite() => {
                let [value, least, most] = [value, least, most].map(Number);
                write!(f, "{parameter} must lie between {least} and {most}, but is {value}: {outside}")
            }
            Fault::OutOfRange { parameter, value, least, outside, .. } => {
                let [value, least] = [value, least].map(Number);
                write!(f, "{parameter} must be finite and at least {least}, but is {value}: {outside}")
            }
            Fault::NotFinite { parameter } => write!(f, "{parameter} must be finite"),
            Fault::NotSymmetric { parameter } => write!(f, "{parameter} must be symmetric"),
            Fault::ImpossibleInertia { excess } => {
                write!(
                    f,
                    "no body has these moments of inertia: one exceeds the sum of the others by {excess} kg m2",
                    excess = Number(excess)
                )
            }
            Fault::ParallelAxes => write!(f, "the axes of the joint are parallel"),
            Fault::SingularJoint => write!(
                f,
                "nothing resists the motion in this joint (what lies outboard has no mass or inertia along or about it, or another joint there moves alike)"
            ),
            Fault::NonFiniteLoad => write!(f, "a load is not finite"),
            Fault::NonFiniteMotion => write!(
                f,
                "the motion is not finite: where a step has led there a shorter one may not (a body of space turns by less than half a turn in each)"
            ),
            Fault::AngleOutOfRange { angle } => {
                write!(
                    f,
                    "the angle {angle} rad lies beyond 4e5 rad, where sines lose digits: wrap it, or take shorter steps if a run has led there",
                    angle = Number(angle)
                )
            }
            Fault::StepTooSmall { step, cause } => {
                write!(f, "steps have become too small (the last: {step} s): {cause}", step = Number(step))
            }
            Fault::NoSuchBody { body, bodies } => {
                write!(f, "there is no body {body}: the scene has {bodies}, from 0 on")
            }
            Fault::NoSuchJoint { joint, joints } => {
                write!(f, "there is no joint {joint}: there are {joints}, from 0 on")
            }
            Fault::NoSuchName { what, name } => write!(f, "there is no {what} named \"{name}\""),
            Fault::AmbiguousName { what, name, count } => {
                write!(f, "\"{name}\" names {count} of kind {what}: reach them by number")
            }
            Fault::ImpossibleTurn { residual } => {
                write!(
                    f,
                    "this joint cannot turn its body so: it misses by {residual} (rad, or rad/s)",
                    residual = Number(residual)
                )
            }
            Fault::Count { list, expected, given } => {
                write!(f, "a list of {list} needs {expected} values, but has {given}")
            }
            Fault::NoBodies => write!(f, "the chain has no body"),
            Fault::Shape => write!(f, "the motion, or what was made for a scene, belongs to one of another shape"),
            Fault::RedundantClosures { closure, independent, of } => {
                write!(
                    f,
                    "closures are redundant in this posture: {independent} of {of} are independent, one that is not holds \
                     {closure}; a straight guess has to be bent, a tip be within reach, a singular posture be left (as where drives, or \
                     joints that stick, hold all that a mechanism can do), and a loop that is held more often than it can move is one for a \
                     `Network` that `LeastNorm` closes"
                )
            }
            Fault::Jammed { joint } => write!(
                f,
                "joint {joint} of those with dry friction or hard stops, from 0 on, does not move, and drives and closures leave no other way: let \
                 them give way, as by a torque or a spring for a drive"
            ),
            Fault::SingularTransfer => write!(
                f,
                "no transfer matrix exists: the joint is the centre of percussion of what lies outboard, or nothing yields where a loop is closed; sweep instead"
            ),
            Fault::NotClosed { residual } => {
                write!(
                    f,
                    "what is held together cannot be brought there from this motion: it misses by {residual} (m, or rad)",
                    residual = Number(residual)
                )
            }
            Fault::NotAssembled { residual } => {
                write!(
                    f,
                    "what is held together is apart by {residual} (m, or rad; of rates, a second): no run begins there; assemble it first",
                    residual = Number(residual)
                )
            }
            Fault::ImpossibleHold { what, residual } => {
                write!(
                    f,
                    "nothing closes from this guess with the {what} that are to stay: it misses by {residual} (m or rad; of rates, m/s or rad/s)",
                    residual = Number(residual)
                )
            }
            Fault::NoEquilibrium { residual } => {
                write!(
                    f,
                    "no equilibrium found from this guess: an acceleration of {residual} (rad/s2, or m/s2) is left; guess nearer, or let a run with dampers come to rest and begin there",
                    residual = Number(residual)
                )
            }
            Fault::NotAtRest { distance } => {
                write!(
                    f,
                    "the motion is not at rest: rest is about {distance} (rad, or m) away",
                    distance = Number(distance)
                )
            }
            Fault::NotSteady { acceleration } => {
                write!(
                    f,
                    "the motion is not steady: a coordinate accelerates by {acceleration} (rad/s2, or m/s2)",
                    acceleration = Number(acceleration)
                )
            }
            Fault::NotConservative { asymmetry } => {
                write!(
                    f,
                    "forces have no potential: the stiffness is asymmetric by {asymmetry}",
                    asymmetry = Number(asymmetry)
                )
            }
            Fault::CentreOfPercussion => write!(
                f,
                "this pin has no transfer matrix (40), for the outboard end of its body is the centre of percussion; solve by Riccati"
            ),
            Fault::SingularAngles { angle } => write!(
                f,
                "the angles 1-2-3 are singular where theta2 = {angle} rad is a right angle; let rotation vectors stand in their slot",
                angle = Number(angle)
            ),
            Fault::NotConverged { sweeps } => {
                write!(f, "the equations of a step are not met after {sweeps} sweeps: take smaller steps")
            }
            Fault::Unsupported { what } => write!(f, "not supported: {what}"),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.fault.fmt(f)?;
        match self.place {
            Some(Place::Station(station)) => write!(f, ", at station {station}")?,
            Some(Place::Root) => write!(f, ", at the root")?,
            Some(Place::Tip) => write!(f, ", at the tip")?,
            None => (),
        }
        match self.time {
            Some(time) => write!(f, ", at t = {time} s", time = Number(time)),
            None => Ok(()),
        }
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self, self.fault()) {
            (_, Some(fault)) => fault.fmt(f),
            (Self::Modes { joint }, None) => {
                write!(
                    f,
                    "no modes of joints with dry friction or hard stops belong together at joint {joint} of these, from 0 on"
                )
            }
            (_, None) => write!(f, "its estimated error exceeds the tolerance"),
        }
    }
}
