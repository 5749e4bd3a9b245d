//! What can go wrong, as values that say when, where and what.

mod cause;
pub(crate) mod checks;
mod text;

pub use cause::Cause;

use crate::names::Label;

/// Why a scene, a sweep or a step was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(deserialize = "'de: 'static")))]
pub struct Error {
    /// Time of the instant (s), where there is one.
    pub time: Option<f64>,
    /// The place in the chain, where there is one.
    pub place: Option<Place>,
    /// What went wrong.
    pub fault: Fault,
}

/// A place in a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Place {
    /// A station: the inboard end of the chain's k-th element (counted from 0 at the root, bodies and joints alike).
    Station(usize),
    /// The end held by the ground or free at the root.
    Root,
    /// The far end.
    Tip,
}

/// What went wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Fault {
    /// A parameter that must be zero is not: the type of its element leaves it out.
    NotZero {
        /// Which one.
        parameter: &'static str,
    },
    /// A parameter that must be positive is not.
    NotPositive {
        /// Name of the parameter.
        parameter: &'static str,
        /// Value of the parameter.
        value: f64,
    },
    /// A parameter that must not be negative is.
    Negative {
        /// Name of the parameter.
        parameter: &'static str,
        /// Value of the parameter.
        value: f64,
    },
    /// A parameter is outside the range in which it makes sense (or NaN).
    OutOfRange {
        /// Name of the parameter.
        parameter: &'static str,
        /// Value of the parameter.
        value: f64,
        /// The least value allowed.
        least: f64,
        /// The greatest value allowed.
        most: f64,
        /// What happens outside.
        outside: &'static str,
    },
    /// A parameter or an input is NaN or infinite.
    NotFinite {
        /// Name of the parameter or input.
        parameter: &'static str,
    },
    /// A matrix that must be symmetric is not.
    NotSymmetric {
        /// Name of the matrix.
        parameter: &'static str,
    },
    /// Moments of inertia that no distribution of mass has, for one is larger than the sum of the other two. Sweeps can do with them.
    ImpossibleInertia {
        /// Excess of the largest moment over the sum of the other two (kg·m²).
        excess: f64,
    },
    /// Two axes of a joint are parallel.
    ParallelAxes,
    /// Nothing resists the motion in a joint: what lies outboard of it has no inertia about its axis, or no mass along it.
    SingularJoint,
    /// A load (force or torque) is NaN or infinite.
    NonFiniteLoad,
    /// The motion became NaN or infinite: the step is too large or the motion was not finite before.
    NonFiniteMotion,
    /// An angle left the range in which sine and cosine keep their accuracy.
    AngleOutOfRange {
        /// The angle (rad).
        angle: f64,
    },
    /// Error control asks for a step that no longer advances time, or a thousand trial steps have hardly advanced it. Where a place made
    /// trial steps fail, the error names it.
    StepTooSmall {
        /// The step refused (s).
        step: f64,
        /// What was wrong with the last trial step that was rejected.
        cause: Cause,
    },
    /// A load acts on a body that the scene does not have.
    NoSuchBody {
        /// Number of the body, counted from 0 at the root.
        body: usize,
        /// Number of bodies.
        bodies: usize,
    },
    /// The scene does not have such a joint.
    NoSuchJoint {
        /// Number of the joint, counted from 0 at the root.
        joint: usize,
        /// Number of joints.
        joints: usize,
    },
    /// Nothing has this name.
    NoSuchName {
        /// What was sought: a joint or a body.
        what: &'static str,
        /// The name.
        name: Label,
    },
    /// Several have this name: they are reached by number.
    AmbiguousName {
        /// What was sought: a joint or a body.
        what: &'static str,
        /// The name.
        name: Label,
        /// Number of joints or bodies that have the name.
        count: usize,
    },
    /// A joint cannot turn its body so.
    ImpossibleTurn {
        /// Residual of the turn at least (rad, or rad/s).
        residual: f64,
    },
    /// A list of coordinates, rates, loads or states has the wrong length.
    Count {
        /// Of what.
        list: &'static str,
        /// Values needed.
        expected: usize,
        /// Values given.
        given: usize,
    },
    /// The chain has no body.
    NoBodies,
    /// A motion, or what was made for a scene, belongs to one of another shape.
    Shape,
    /// Closures do not hold independently of each other: too many for the chain, or one that the chain cannot meet.
    RedundantClosures {
        /// What one of those that depend on others holds.
        closure: &'static str,
        /// Number of independent closures.
        independent: usize,
        /// Number of closures.
        of: usize,
    },
    /// A joint sticks or rests at its stop, and drives and closures leave the scene no other way to move.
    Jammed {
        /// Number of the joint among those with dry friction or hard stops, counted from 0.
        joint: usize,
    },
    /// A transfer matrix does not exist here: the joint is the centre of percussion of what lies outboard.
    SingularTransfer,
    /// The tip cannot be brought to where it is held, the ends of a loop to each other, or joints to where couplings have them, from this guess. In
    /// a run: the ends of a loop that [`LeastNorm`](crate::planar::LeastNorm) closes have come apart, as where two drives contradict each other.
    NotClosed {
        /// Residual of the closures or couplings (m, or rad for an angle).
        residual: f64,
    },
    /// The tip is not where it is held, or the ends of a loop are apart, by more than steps close: no run begins there.
    NotAssembled {
        /// Residual of the closures (m, or rad for an angle; m/s or rad/s where rates are what they do not allow).
        residual: f64,
    },
    /// With what is held as it is given, the tip cannot be brought to where it is held, or the ends of a loop to each other, from this
    /// guess.
    ImpossibleHold {
        /// What is held: coordinates or rates.
        what: &'static str,
        /// Residual of the closures (m or rad; of rates, these a second).
        residual: f64,
    },
    /// No equilibrium was found from this guess.
    NoEquilibrium {
        /// The largest acceleration of a coordinate that is left (rad/s², or m/s² for a length).
        residual: f64,
    },
    /// A motion does not rest where it is to be linearised.
    NotAtRest {
        /// About how far the position of rest is (rad, or m for a length).
        distance: f64,
    },
    /// A motion whose coordinates accelerate is to be linearised as a steady one.
    NotSteady {
        /// The largest acceleration of a coordinate (rad/s², or m/s² for a length).
        acceleration: f64,
    },
    /// Forces have no potential, so that there are no modes of vibration with real shapes.
    NotConservative {
        /// Asymmetry of the stiffness, relative to its size.
        asymmetry: f64,
    },
    /// The paper's matrix of a smooth pin does not exist here: the pin's pivot vanishes at the centre of percussion.
    CentreOfPercussion,
    /// The angles 1-2-3 of a body cannot say its orientation: at θ₂ = ±π/2 two of them turn about the same axis.
    SingularAngles {
        /// θ₂ (rad).
        angle: f64,
    },
    /// The equations of a step were not met.
    NotConverged {
        /// Sweeps taken.
        sweeps: usize,
    },
    /// Not supported.
    Unsupported {
        /// What is not.
        what: &'static str,
    },
}

impl Error {
    /// A fault without time or place.
    pub const fn new(fault: Fault) -> Self {
        Self { time: None, place: None, fault }
    }

    /// This error at a station.
    #[must_use]
    pub const fn at_station(self, station: usize) -> Self {
        Self { place: Some(Place::Station(station)), ..self }
    }

    /// This error at a place.
    #[must_use]
    pub const fn at(self, place: Place) -> Self {
        Self { place: Some(place), ..self }
    }

    /// This error at its place in the chain, where stations were counted from the root's joint on.
    #[must_use]
    pub(crate) const fn beyond_root(self) -> Self {
        match self.place {
            Some(Place::Station(0)) => self.at(Place::Root),
            Some(Place::Station(entry)) => self.at_station(entry - 1),
            _ => self,
        }
    }

    /// This error at a time (s).
    #[must_use]
    pub const fn at_time(self, time: f64) -> Self {
        Self { time: Some(time), ..self }
    }
}

impl core::error::Error for Error {}

/// Refuses a list of another length.
pub(crate) fn counted(list: &'static str, expected: usize, given: usize) -> Result<(), Error> {
    if given == expected { Ok(()) } else { Err(Error::new(Fault::Count { list, expected, given })) }
}

/// Refuses numbers that are not finite.
pub(crate) fn ensure_finite(is: bool, parameter: &'static str) -> Result<(), Error> {
    if is { Ok(()) } else { Err(Error::new(Fault::NotFinite { parameter })) }
}
