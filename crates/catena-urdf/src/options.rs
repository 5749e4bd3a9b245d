//! How a description is read.

use crate::algebra::Vector;
use crate::dynamics;
use crate::error::{Error, Fault};
use crate::frames::{self, Frames};
use crate::note::Notes;
use crate::robot::Robot;
use crate::{emit, lump, read};
use std::fmt::Display;
use std::path::Path;

/// What the root link is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Base {
    /// Fixed to the ground; but where it has no mass, and a floating joint as its only one, it is the ground, and its child floats.
    #[default]
    Written,
    /// Fixed to the ground.
    Fixed,
    /// Floating.
    Floating,
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
        Self { snap: 0.0, repair: false, base, frames, held: Vec::new(), gravity, test: true }
    }

    /// Takes angles, and axes of joints, within a tolerance (rad) of a right angle for right, and notes by how much each was
    /// turned. Those right to the last bit of a double are right in any case.
    pub fn snap(self, tolerance: f64) -> Self {
        Self { snap: tolerance, ..self }
    }

    /// Repairs moments of inertia that no body has: negative second moments ∫ (x·n)² dm about the mass centre become zero, the
    /// others and their directions stay. Without, they are noted only, and catena refuses bodies that have them.
    pub fn repair(self) -> Self {
        Self { repair: true, ..self }
    }

    /// What the root link is.
    pub fn base(self, base: Base) -> Self {
        Self { base, ..self }
    }

    /// How axes of bodies are chosen.
    pub fn frames(self, frames: Frames) -> Self {
        Self { frames, ..self }
    }

    /// Holds a joint at an angle (rad) or a way (m), as if it were fixed there: a gripper, a wheel.
    pub fn hold(mut self, joint: &str, at: f64) -> Self {
        self.held.push((joint.to_owned(), at));
        self
    }

    /// Gravity (m/s²).
    pub fn gravity(self, gravity: [f64; 3]) -> Self {
        Self { gravity, ..self }
    }

    /// Writes no test into the module.
    pub fn without_test(self) -> Self {
        Self { test: false, ..self }
    }

    /// Reads a description.
    ///
    /// # Errors
    /// What is wrong with it, and at which line.
    pub fn read(&self, text: &str) -> Result<Robot, Error> {
        let mut notes = Notes::default();
        let model = read::model(text, self, &mut notes)?;
        let mut robot = lump::robot(&model, self, &mut notes)?;
        frames::choose(&mut robot, self.frames);
        dynamics::check_inertia(&robot)?;
        robot.notes = notes.into_list();
        Ok(robot)
    }

    /// For build scripts: reads a file, named from the folder of the package, and writes its module to `OUT_DIR`; file and module are
    /// named after it. Says notes as warnings of the build, and when to build again.
    ///
    /// # Errors
    /// What is wrong with the description, and at which line; a file or variable that is not there.
    pub fn build(&self, path: impl AsRef<Path>) -> Result<Robot, Error> {
        let path = path.as_ref();
        println!("cargo::rerun-if-changed={}", path.display());
        let failed = |what: &dyn Display, error: &dyn Display| Error::new(Fault::File(format!("{what}: {error}")));
        let text = std::fs::read_to_string(path).map_err(|error| failed(&path.display(), &error))?;
        let robot = self.read(&text).map_err(|error| Error { file: Some(path.to_owned()), ..error })?;
        for note in robot.notes() {
            println!("cargo::warning={}: {note}", path.display());
        }
        let folder = std::env::var("OUT_DIR").map_err(|error| failed(&"OUT_DIR", &error))?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let target = Path::new(&folder).join(&*name).with_extension("rs");
        std::fs::write(&target, emit::module(&robot, &name)).map_err(|error| failed(&target.display(), &error))?;
        Ok(robot)
    }
}
