//! Why a description is refused: values that say where and what.

use std::fmt;
use std::path::PathBuf;

/// Why a description is refused. Debug output is the text, too: that is what Cargo shows of a `build.rs` whose `main` returns it.
#[derive(Clone, PartialEq)]
pub struct Error {
    /// The file, where one was read.
    pub file: Option<PathBuf>,
    /// The line of the description, counted from one, where there is one.
    pub line: Option<usize>,
    /// What is wrong there.
    pub fault: Fault,
}

/// What is wrong with a description.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Fault {
    /// The text is no XML.
    Xml(String),
    /// A file cannot be read or written, or a variable of the build is not there.
    File(String),
    /// The outermost element is not `<robot>`.
    NotARobot {
        /// Name of the outermost element.
        element: String,
    },
    /// An element lacks an attribute or an element inside.
    Missing {
        /// The attribute or element that is not there.
        what: &'static str,
        /// The element that lacks it.
        of: String,
    },
    /// An element stands twice where it may stand once.
    Repeated {
        /// The element.
        element: &'static str,
        /// The element or joint that it belongs to.
        of: String,
    },
    /// Two links, or two joints, have one name.
    Duplicate {
        /// `link` or `joint`.
        kind: &'static str,
        /// Name that both have.
        name: String,
        /// The line of the first.
        first: usize,
    },
    /// Text that must be a number is not.
    NotANumber {
        /// The attribute.
        attribute: &'static str,
        /// Text of the attribute.
        text: String,
    },
    /// A number is NaN or infinite.
    NotFinite {
        /// The attribute.
        attribute: &'static str,
        /// Text of the attribute.
        text: String,
    },
    /// A number that must not be negative is.
    Negative {
        /// The attribute.
        attribute: &'static str,
        /// Value of the attribute.
        value: f64,
    },
    /// A number of [`Options`](crate::Options) or [`Laws`](crate::Laws) makes no mechanics.
    Law {
        /// The number, and what it must be.
        what: &'static str,
        /// Value of the number.
        value: f64,
    },
    /// A list of numbers has the wrong length.
    Count {
        /// The attribute.
        attribute: &'static str,
        /// Numbers needed.
        expected: usize,
        /// Numbers given.
        given: usize,
    },
    /// The type of a joint is none that URDF has.
    UnknownKind {
        /// The joint.
        joint: String,
        /// Type of the joint.
        kind: String,
    },
    /// The axis of a joint has no direction.
    ZeroAxis {
        /// The joint.
        joint: String,
    },
    /// A joint names a link that is not there.
    UnknownLink {
        /// The joint.
        joint: String,
        /// The link.
        link: String,
    },
    /// A joint to be followed or held is not there.
    UnknownJoint {
        /// What names the joint.
        by: String,
        /// The joint.
        joint: String,
    },
    /// Joints follow one another in a circle.
    MimicCircle {
        /// One of the joints.
        joint: String,
    },
    /// A link is the child of two joints.
    SeveralParents {
        /// The link.
        link: String,
        /// The line of the first joint.
        first: usize,
    },
    /// Links that are each other's parents: no root leads to this one.
    Cycle {
        /// A link of the circle.
        link: String,
    },
    /// Two links have no parent.
    SeveralRoots {
        /// The first.
        first: String,
        /// The second.
        second: String,
    },
    /// There is no link.
    NoLinks,
    /// No joint moves: there is nothing to simulate.
    NothingMoves,
    /// A mass is negative.
    NegativeMass {
        /// The link.
        link: String,
        /// Mass of the link (kg).
        mass: f64,
    },
    /// A floating joint elsewhere than between the root and its only child, where scenes of catena have none.
    FloatingInside {
        /// The joint.
        joint: String,
    },
    /// A joint to be held has no single coordinate.
    CannotHold {
        /// The joint.
        joint: String,
    },
    /// A joint is to be held at two places.
    HeldTwice {
        /// The joint.
        joint: String,
    },
    /// What lies beyond a joint has no inertia about (or along) its axis, so that no torque has an answer.
    NoInertia {
        /// The joint.
        joint: String,
    },
    /// The floating base and all that it carries have no inertia about or along some axis.
    NoInertiaOfBase,
    /// Numbers are so large that sums of them are not finite.
    Overflow {
        /// The link or joint at which sums overflow.
        of: String,
    },
    /// More joints than a Rust type should have.
    TooLarge {
        /// Moving joints.
        joints: usize,
        /// Allowed.
        most: usize,
    },
}

impl Error {
    /// A fault at a line.
    pub(crate) fn at(line: usize, fault: Fault) -> Self {
        Self { file: None, line: Some(line), fault }
    }

    /// A fault of the whole.
    pub(crate) fn new(fault: Fault) -> Self {
        Self { file: None, line: None, fault }
    }
}

impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(file) = &self.file {
            write!(f, "{}: ", file.display())?;
        }
        if let Some(line) = self.line {
            write!(f, "line {line}: ")?;
        }
        self.fault.fmt(f)
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Xml(what) => write!(f, "no XML: {what}"),
            Self::File(what) => f.write_str(what),
            Self::NotARobot { element } => write!(f, "the outermost element is <{element}>, not <robot>"),
            Self::Missing { what, of } => write!(f, "{of} has no {what}"),
            Self::Repeated { element, of } => write!(f, "{of} has more than one <{element}>"),
            Self::Duplicate { kind, name, first } => {
                write!(f, "{kind} {name:?} is there already, at line {first}")
            }
            Self::NotANumber { attribute, text } => write!(f, "{attribute} is no number: {text:?}"),
            Self::NotFinite { attribute, text } => write!(f, "{attribute} is not finite: {text:?}"),
            Self::Negative { attribute, value } => write!(f, "{attribute} is negative: {value}"),
            Self::Law { what, value } => write!(f, "{what}, not {value}"),
            Self::Count { attribute, expected, given } => {
                write!(f, "{attribute} takes {expected} numbers, but has {given}")
            }
            Self::UnknownKind { joint, kind } => write!(f, "joint {joint:?} is of unknown type {kind:?}"),
            Self::ZeroAxis { joint } => write!(f, "the axis of joint {joint:?} has no direction"),
            Self::UnknownLink { joint, link } => write!(f, "joint {joint:?} names link {link:?}, which is not there"),
            Self::UnknownJoint { by, joint } => write!(f, "{by} names joint {joint:?}, which is not there"),
            Self::MimicCircle { joint } => write!(f, "joint {joint:?} follows itself"),
            Self::SeveralParents { link, first } => {
                write!(f, "link {link:?} has a parent already, by the joint at line {first}")
            }
            Self::Cycle { link } => write!(f, "link {link:?} hangs on itself: no root leads to it"),
            Self::SeveralRoots { first, second } => {
                write!(f, "link {second:?} has no parent, nor has link {first:?}: there must be one root")
            }
            Self::NoLinks => f.write_str("there is no link"),
            Self::NothingMoves => f.write_str("no joint moves"),
            Self::NegativeMass { link, mass } => write!(f, "link {link:?} has a negative mass: {mass} kg"),
            Self::FloatingInside { joint } => {
                write!(f, "joint {joint:?} floats, but is not the only joint of a root without mass")
            }
            Self::CannotHold { joint } => write!(f, "joint {joint:?} has no single coordinate to be held at"),
            Self::HeldTwice { joint } => write!(f, "joint {joint:?} is to be held twice"),
            Self::NoInertia { joint } => {
                write!(f, "nothing beyond joint {joint:?} resists it: no inertia about or along its axis")
            }
            Self::NoInertiaOfBase => {
                f.write_str("the floating base, with all that it carries, has no inertia in some direction")
            }
            Self::Overflow { of } => write!(f, "the numbers of {of} are too large to be added up"),
            Self::TooLarge { joints, most } => write!(f, "{joints} moving joints are more than {most}"),
        }
    }
}

impl std::error::Error for Error {}
