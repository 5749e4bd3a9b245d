//! What a module leaves out of its description, or changes in it: nothing silently.

use std::collections::HashMap;
use std::fmt;

/// A remark about a description, with the lines that it concerns.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// Lines of the description, counted from one.
    pub lines: Vec<usize>,
    /// What is remarked.
    pub remark: Remark,
}

/// What there is to remark.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Remark {
    /// Elements that the module knows nothing of.
    LeftOut {
        /// Name of the elements.
        element: String,
        /// The element around these.
        inside: String,
    },
    /// Attributes that the module knows nothing of.
    AttributeLeftOut {
        /// Name of the attributes.
        attribute: String,
        /// The element that has these attributes.
        of: String,
    },
    /// Numbers that the module has as constants, while the scene does not act by them.
    ConstantOnly {
        /// The numbers, in words.
        what: &'static str,
    },
    /// A joint that must have limits has none written, and is unlimited.
    NoLimits {
        /// The joint.
        joint: String,
    },
    /// A joint has limits of effort or velocity, but none of both that is positive, or a reduction of zero: it has no motor.
    NoMotor {
        /// The joint.
        joint: String,
    },
    /// The lower limit lies above the upper one.
    LimitsReversed {
        /// The joint.
        joint: String,
    },
    /// A joint follows another one: the module's `couplings` are loads that make it, and without them it moves by itself.
    MimicFree {
        /// The joint.
        joint: String,
        /// The joint followed.
        of: String,
    },
    /// A joint follows one that has no coordinate of its own, fixed, held or floating: it moves by itself, and the module does not say how it
    /// would follow.
    MimicOfFixed {
        /// The joint.
        joint: String,
        /// The joint followed.
        of: String,
    },
    /// A transmission that does not belong to one joint of the description.
    Transmission {
        /// Name of the transmission.
        name: String,
    },
    /// Masses of links that are fixed to the ground.
    MassOfGround,
    /// A link has moments of inertia without a mass.
    TensorWithoutMass {
        /// The link.
        link: String,
    },
    /// A planar joint became two slides and a hinge: along two directions of the parent, then about the normal.
    PlanarSplit {
        /// The joint.
        joint: String,
    },
    /// An angle (or an axis) was taken for a right one.
    Snapped {
        /// What was turned.
        of: String,
        /// By how much (rad).
        by: f64,
    },
    /// No distribution of mass has these moments of inertia.
    Impossible {
        /// The link or the body.
        of: String,
        /// The least second moment, relative to the trace of the tensor.
        deficit: f64,
        /// Whether the inertia was repaired: negative second moments became zero.
        repaired: bool,
    },
    /// A whole body has moments of inertia that no distribution of mass has: catena refuses it where one is negative.
    Doubtful {
        /// The body's link.
        of: String,
    },
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const SHOWN: usize = 4;
        match self.lines.as_slice() {
            [] => (),
            [line] => write!(f, "line {line}: ")?,
            lines => {
                let shown: Vec<_> = lines.iter().take(SHOWN).map(usize::to_string).collect();
                write!(f, "lines {}", shown.join(", "))?;
                match lines.len().checked_sub(SHOWN) {
                    None | Some(0) => f.write_str(": ")?,
                    Some(more) => write!(f, " and {more} more: ")?,
                }
            }
        }
        self.remark.fmt(f)
    }
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LeftOut { element, inside } => write!(f, "<{element}> in <{inside}> is left out"),
            Self::AttributeLeftOut { attribute, of } => write!(f, "{attribute} of <{of}> is left out"),
            Self::ConstantOnly { what } => {
                write!(f, "{what} is among the constants of the module; its scene does not act by it")
            }
            Self::NoLimits { joint } => write!(f, "joint {joint:?} has no <limit>, and is taken as unlimited"),
            Self::NoMotor { joint } => {
                write!(
                    f,
                    "joint {joint:?} has no motor: that takes limits of effort and velocity above zero, and a reduction"
                )
            }
            Self::LimitsReversed { joint } => write!(f, "joint {joint:?} has its lower limit above its upper one"),
            Self::MimicFree { joint, of } => {
                write!(
                    f,
                    "joint {joint:?} follows {of:?} under the loads of `couplings`: without them it moves by itself"
                )
            }
            Self::MimicOfFixed { joint, of } => {
                write!(
                    f,
                    "joint {joint:?} follows {of:?}, which has no coordinate of its own: left out, it moves by itself unless it is held, too"
                )
            }
            Self::Transmission { name } => {
                write!(f, "transmission {name:?} is left out: it has not one joint of this robot and one reduction")
            }
            Self::MassOfGround => f.write_str("the mass of what is fixed to the ground is left out"),
            Self::TensorWithoutMass { link } => write!(f, "link {link:?} has moments of inertia, but no mass"),
            Self::PlanarSplit { joint } => {
                write!(f, "planar joint {joint:?} became two slides across its normal and a hinge about it")
            }
            Self::Snapped { of, by } => write!(f, "{of} turned by {by:.1e} rad to a right angle"),
            Self::Impossible { of, deficit, repaired } => {
                let percent = 100.0 * deficit;
                let percent = if percent > -0.01 { format!("{percent:.1e}") } else { format!("{percent:.2}") };
                write!(f, "no body has the moments of inertia of {of:?}: a second moment is {percent} % of the trace")?;
                f.write_str(if *repaired { "; it became zero, the others stay" } else { "" })
            }
            Self::Doubtful { of } => {
                write!(
                    f,
                    "no distribution of mass has the moments of inertia of the body of {of:?}: have it repaired, or catena lists it as doubtful, and refuses one of which a principal moment is negative"
                )
            }
        }
    }
}

/// Notes as they come, equal remarks at several lines as one.
#[derive(Default)]
pub(crate) struct Notes {
    notes: Vec<Note>,
    known: HashMap<String, usize>,
}

impl Notes {
    pub fn add(&mut self, line: usize, remark: Remark) {
        let next = self.notes.len();
        let at = *self.known.entry(remark.to_string()).or_insert(next);
        match self.notes.get_mut(at) {
            Some(note) => note.lines.push(line),
            None => self.notes.push(Note { lines: vec![line], remark }),
        }
    }

    pub fn into_list(self) -> Vec<Note> {
        self.notes
    }
}
