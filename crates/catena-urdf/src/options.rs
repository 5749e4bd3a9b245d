//! How a description is read.

use crate::algebra::Vector;
use crate::error::{Error, Fault};
use crate::frames::Frames;
use crate::laws::Laws;

/// What the root link is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Base {
    /// Fixed to the ground; but where it has no mass, and a floating joint as its only one, it is the ground, and its child floats.
    #[default]
    Written,
    /// Fixed to the ground, and so is what would float as written.
    Fixed,
    /// Floating.
    Floating,
}

/// In which elements of the library a module is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Elements {
    /// Elements of `catena::spatial`, in inertial axes.
    #[default]
    Inertial,
    /// Elements of `catena::robot`, in axes of the bodies, z along each joint's axis: what is zero, and turns that are quarters, become
    /// types. 0.30 to 0.47 of the instructions, and functions of lists. Origins are anywhere on the joints' axes: the module's frames say where
    /// links stand.
    Local,
    /// Elements of `catena::robot` with no number known to be zero: to measure by.
    LocalGeneral,
}

/// How a description is read. The defaults change nothing in it.
#[derive(Clone, Debug, PartialEq)]
#[must_use]
pub struct Options {
    pub(crate) snap: f64,
    pub(crate) repair: bool,
    pub(crate) base: Base,
    pub(crate) frames: Frames,
    pub(crate) held: Vec<(String, f64)>,
    pub(crate) gravity: Vector,
    pub(crate) test: bool,
    pub(crate) elements: Elements,
    pub(crate) laws: Laws,
}

impl Default for Options {
    fn default() -> Self {
        Self::new()
    }
}

impl Options {
    /// Nothing snapped, nothing repaired, the base as written, gravity 9.81 m/s² along −z, with a test.
    pub fn new() -> Self {
        let (base, frames) = (Base::Written, Frames::AlongHinges);
        let gravity = [0.0, 0.0, -9.81];
        Self {
            snap: 0.0,
            repair: false,
            base,
            frames,
            held: Vec::new(),
            gravity,
            test: true,
            elements: Elements::Inertial,
            laws: Laws::none(),
        }
    }

    /// Takes angles, and axes of joints, within a tolerance (rad) of a right angle for right, and notes by how much each was
    /// turned. Those right to the last bit of a double are right in any case. At most 0.1.
    pub fn snap(self, tolerance: f64) -> Self {
        Self { snap: tolerance, ..self }
    }

    /// Repairs moments of inertia that no body has: negative second moments ∫ (x·n)² dm about the mass centre become zero, the
    /// others and their directions stay. Without, they are noted only; catena refuses bodies of which a moment is negative.
    pub fn repair(self) -> Self {
        Self { repair: true, ..self }
    }

    /// What the root link is.
    pub fn base(self, base: Base) -> Self {
        Self { base, ..self }
    }

    /// How axes of bodies are chosen. In [`Elements::Local`] and [`Elements::LocalGeneral`] the joints choose them: this has no effect there.
    pub fn frames(self, frames: Frames) -> Self {
        Self { frames, ..self }
    }

    /// Holds a joint at an angle (rad) or a way (m), as if it were fixed there: a gripper, a wheel. Joints that follow it are to be held, too, or move by
    /// themselves, as a note says.
    pub fn hold(mut self, joint: &str, at: f64) -> Self {
        self.held.push((joint.to_owned(), at));
        self
    }

    /// In which elements of the library the module is written.
    pub fn elements(self, elements: Elements) -> Self {
        Self { elements, ..self }
    }

    /// Which furniture of the joints the scene acts by.
    pub fn laws(self, laws: Laws) -> Self {
        Self { laws, ..self }
    }

    /// Gravity (m/s²).
    pub fn gravity(self, gravity: [f64; 3]) -> Self {
        Self { gravity, ..self }
    }

    /// Writes no test into the module.
    pub fn without_test(self) -> Self {
        Self { test: false, ..self }
    }

    /// Rejects numbers that make no mechanics.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let small = |x| (0.0..=0.1).contains(&x); // farther off than six degrees no angle is meant to be right
        fits("a tolerance of right angles (rad) must be from 0 to 0.1", [self.snap], small)?;
        fits("where a joint is held must be finite", self.held.iter().map(|(_, at)| *at), |_| true)?;
        fits("gravity must be finite", self.gravity, |_| true)?;
        self.laws.check()
    }
}

/// Rejects numbers that are not finite, or do not fit.
pub(crate) fn fits(
    what: &'static str,
    values: impl IntoIterator<Item = f64>,
    fits: fn(f64) -> bool,
) -> Result<(), Error> {
    let wrong = values.into_iter().find(|value| !(value.is_finite() && fits(*value)));
    wrong.map_or(Ok(()), |value| Err(Error::new(Fault::Law { what, value })))
}
