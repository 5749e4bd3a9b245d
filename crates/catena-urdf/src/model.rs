//! A description as it is written: links, and joints between them.

use crate::Options;
use crate::algebra::{IDENTITY, Matrix, Vector, ZERO, add, apply, times};

/// Where something stands and how it is turned, seen from something else.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Origin of what stands there (m), in the other's axes.
    pub place: Vector,
    /// Axes of what stands there, as columns, in the other's axes.
    pub turn: Matrix,
}

impl Pose {
    pub(crate) const IDENTITY: Self = Self { place: ZERO, turn: IDENTITY };

    /// What stands at `inner` as seen from here, seen from where this is.
    pub(crate) fn then(&self, inner: &Self) -> Self {
        Self { place: add(self.place, apply(&self.turn, inner.place)), turn: times(&self.turn, &inner.turn) }
    }
}

/// All that is read of a description.
pub(crate) struct Model {
    pub name: String,
    pub links: Vec<Link>,
    pub joints: Vec<Joint>,
}

/// A link as written.
pub(crate) struct Link {
    pub name: String,
    pub line: usize,
    pub inertial: Option<Inertial>,
}

/// Mass, mass centre and tensor about it, with the line.
pub(crate) struct Inertial {
    pub line: usize,
    /// The mass centre, and the axes in which the tensor is written.
    pub origin: Pose,
    pub mass: f64,
    pub tensor: Matrix,
}

/// What a joint lets happen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    Revolute,
    Continuous,
    Prismatic,
    Fixed,
    Floating,
    Planar,
}

/// A joint as written, its links by number.
pub(crate) struct Joint {
    pub name: String,
    pub line: usize,
    pub kind: Kind,
    pub parent: usize,
    pub child: usize,
    pub origin: Pose,
    /// A unit vector in the child's axes.
    pub axis: Vector,
    pub furniture: Furniture,
}

impl Joint {
    /// Whether the joint is fixed, or held.
    pub fn stays(&self, options: &Options) -> bool {
        self.kind == Kind::Fixed || options.held.iter().any(|(name, _)| *name == self.name)
    }
}

/// What a joint has besides its freedom: constants of the module.
#[derive(Clone, Debug, PartialEq)]
pub struct Furniture {
    /// Lower limit (rad or m), minus infinity where there is none.
    pub lower: f64,
    /// Upper limit (rad or m), infinity where there is none.
    pub upper: f64,
    /// Largest torque (N·m) or force (N), infinity where none is written.
    pub effort: f64,
    /// Largest speed (rad/s or m/s), infinity where none is written.
    pub velocity: f64,
    /// Viscous damping (N·m·s/rad or N·s/m).
    pub damping: f64,
    /// Dry friction (N·m or N).
    pub friction: f64,
    /// Turns of the motor a turn of the joint, where a transmission says so.
    pub reduction: Option<f64>,
    /// The joint that this one follows.
    pub mimic: Option<Mimic>,
}

/// q = `multiplier` · q of another joint + `offset`.
#[derive(Clone, Debug, PartialEq)]
pub struct Mimic {
    /// The joint followed.
    pub joint: String,
    /// Factor.
    pub multiplier: f64,
    /// Offset (rad or m).
    pub offset: f64,
}

impl Default for Furniture {
    fn default() -> Self {
        let far = f64::INFINITY;
        let (lower, upper, effort, velocity) = (-far, far, far, far);
        Self { lower, upper, effort, velocity, damping: 0.0, friction: 0.0, reduction: None, mimic: None }
    }
}
