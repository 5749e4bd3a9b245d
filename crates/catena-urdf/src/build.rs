//! The way from a file to a module: read, lumped, framed, checked, written.

use crate::error::{Error, Fault};
use crate::frames::Frames;
use crate::note::Notes;
use crate::options::{Elements, Options};
use crate::robot::Robot;
use crate::{dynamics, emit, frames, lump, read, zeros};
use std::fmt::Display;
use std::path::Path;

impl Options {
    /// Reads a description.
    ///
    /// # Errors
    /// What is wrong with it, and at which line.
    pub fn read(&self, text: &str) -> Result<Robot, Error> {
        self.check()?;
        let mut notes = Notes::default();
        let model = read::model(text, self, &mut notes)?;
        let mut robot = lump::robot(&model, self, &mut notes)?;
        if self.elements == Elements::Inertial {
            frames::choose(&mut robot, self.frames);
        } else {
            frames::choose(&mut robot, Frames::AlongHinges);
            zeros::show(&mut robot);
            frames::lay_along_z(&mut robot);
        }
        dynamics::check_inertia(&robot)?;
        robot.notes = notes.into_list();
        Ok(robot)
    }

    /// For build scripts: reads a file, named from the folder of the package, and writes its module to `OUT_DIR`; file and module are
    /// named after it, the latter as Rust writes names ([`module`](crate::module)). Says notes as warnings of the build, and when to build again.
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
        let target = Path::new(&folder).join(format!("{name}.rs"));
        std::fs::write(&target, emit::module(&robot, &name)).map_err(|error| failed(&target.display(), &error))?;
        Ok(robot)
    }
}
