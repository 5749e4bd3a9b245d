//! Why a trial step was refused.

use super::Fault;

/// What is wrong with a trial step from a motion that is sound, so that a shorter step is tried: faults of these names.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Cause {
    /// The estimated error of the step exceeds the tolerance.
    Inaccurate,
    /// No modes of joints with dry friction or hard stops belong together: what each would do does not go with what the others do.
    Modes {
        /// A joint that would change its mode again: its number among those with modes.
        joint: usize,
    },
    /// [`Fault::NonFiniteMotion`].
    NonFiniteMotion,
    /// [`Fault::NonFiniteLoad`].
    NonFiniteLoad,
    /// [`Fault::NotFinite`]: the motion of the ground, for example.
    NotFinite {
        /// Name of the parameter or input.
        parameter: &'static str,
    },
    /// [`Fault::SingularJoint`].
    SingularJoint,
    /// [`Fault::AngleOutOfRange`].
    AngleOutOfRange {
        /// The angle (rad).
        angle: f64,
    },
    /// [`Fault::NotClosed`].
    NotClosed {
        /// Residual of the closures (m, or rad for an angle).
        residual: f64,
    },
    /// [`Fault::RedundantClosures`].
    RedundantClosures {
        /// What one of those that depend on others holds.
        closure: &'static str,
        /// Number of independent closures.
        independent: usize,
        /// Number of closures.
        of: usize,
    },
}

impl Cause {
    /// The cause of this fault's name; none for what no shorter step would mend.
    pub(crate) const fn of(fault: Fault) -> Option<Self> {
        Some(match fault {
            Fault::NonFiniteMotion => Self::NonFiniteMotion,
            Fault::NonFiniteLoad => Self::NonFiniteLoad,
            Fault::NotFinite { parameter } => Self::NotFinite { parameter },
            Fault::SingularJoint => Self::SingularJoint,
            Fault::AngleOutOfRange { angle } => Self::AngleOutOfRange { angle },
            Fault::NotClosed { residual } => Self::NotClosed { residual },
            Fault::RedundantClosures { closure, independent, of } => {
                Self::RedundantClosures { closure, independent, of }
            }
            _ => return None,
        })
    }

    /// The fault of this name; none for a step that is only inaccurate, or modes that do not belong together.
    pub const fn fault(self) -> Option<Fault> {
        Some(match self {
            Self::Inaccurate | Self::Modes { .. } => return None,
            Self::NonFiniteMotion => Fault::NonFiniteMotion,
            Self::NonFiniteLoad => Fault::NonFiniteLoad,
            Self::NotFinite { parameter } => Fault::NotFinite { parameter },
            Self::SingularJoint => Fault::SingularJoint,
            Self::AngleOutOfRange { angle } => Fault::AngleOutOfRange { angle },
            Self::NotClosed { residual } => Fault::NotClosed { residual },
            Self::RedundantClosures { closure, independent, of } => {
                Fault::RedundantClosures { closure, independent, of }
            }
        })
    }
}
