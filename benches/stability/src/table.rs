//! Rows of the table, and what they say: holds, degrades, fails.

use std::fmt::Write;
use std::path::Path;

/// One case: what was varied, to which value, by what it was solved, and how far off it is.
pub struct Row {
    pub part: &'static str,
    pub scene: String,
    /// What is varied, all else being that of the base scene.
    pub axis: &'static str,
    pub value: f64,
    pub way: String,
    pub scalar: &'static str,
    /// Relative error, or what the part says; not a number where there is none.
    pub error: f64,
    /// Why there is no number, or what else there is to say.
    pub note: String,
}

impl Row {
    /// Holds below 1e-6 (`f32`: 1e-2), degrades below 1e-2, fails beyond or where an error is returned.
    pub fn verdict(&self) -> &'static str {
        let holds = if self.scalar == "f32" { 1e-2 } else { 1e-6 };
        match self.error {
            error if error < holds => "holds",
            error if error < 1e-2 => "degrades",
            _ => "fails",
        }
    }
}

/// All cases of a run of this program.
#[derive(Default)]
pub struct Table(pub Vec<Row>);

const HEADER: &str = "part,scene,axis,value,way,scalar,verdict,error,note\n";

impl Table {
    /// Adds a row.
    #[allow(clippy::too_many_arguments)] // the columns
    pub fn add(
        &mut self,
        part: &'static str,
        scene: &str,
        axis: &'static str,
        value: f64,
        way: &str,
        scalar: &'static str,
        outcome: Result<f64, String>,
    ) {
        let (error, note) = match outcome {
            Ok(error) => (error, String::new()),
            Err(note) => (f64::NAN, note),
        };
        let (scene, way) = (scene.to_owned(), way.to_owned());
        self.0.push(Row { part, scene, axis, value, way, scalar, error, note });
    }

    /// Says something about the row added last.
    pub fn note(&mut self, note: String) {
        if let Some(row) = self.0.last_mut() {
            row.note = note;
        }
    }

    /// Values of an axis side by side, a line for each way of solving.
    pub fn print(&self) {
        let mut last = ("", "", "");
        let mut done: Vec<(&str, &str, &str, &str, &str)> = vec![];
        for row in &self.0 {
            let head = (row.part, row.scene.as_str(), row.axis);
            let line = (row.part, row.scene.as_str(), row.axis, row.way.as_str(), row.scalar);
            if done.contains(&line) {
                continue;
            }
            done.push(line);
            if head != last {
                println!("\n{}: {}, {}", head.0, head.1, head.2);
                last = head;
            }
            let mut text = format!("  {:22} {:4}", row.way, row.scalar);
            let same =
                |other: &&Row| (other.part, other.scene.as_str(), other.axis, other.way.as_str(), other.scalar) == line;
            for cell in self.0.iter().filter(same) {
                let _ = match cell.error.is_nan() {
                    true => write!(text, "  {:.0e} fails", cell.value),
                    false => write!(text, "  {:.0e} {} {:.0e}", cell.value, cell.verdict(), cell.error),
                };
                if !cell.note.is_empty() {
                    let _ = write!(text, " ({})", cell.note);
                }
            }
            println!("{text}");
        }
    }

    /// Writes the rows of each part to a file of its own.
    pub fn save(&self, directory: &Path) -> std::io::Result<()> {
        std::fs::create_dir_all(directory)?;
        let mut parts: Vec<&str> = vec![];
        for row in &self.0 {
            if !parts.contains(&row.part) {
                parts.push(row.part);
            }
        }
        for part in parts {
            let mut text = HEADER.to_owned();
            for row in self.0.iter().filter(|row| row.part == part) {
                let Row { scene, axis, value, way, scalar, error, note, .. } = row;
                let [scene, way, note] = [scene, way, note].map(|text| text.replace([',', '\n'], ";"));
                let _ = writeln!(
                    text,
                    "{part},{scene},{axis},{value:e},{way},{scalar},{},{error:.1e},{note}",
                    row.verdict()
                );
            }
            std::fs::write(directory.join(format!("{part}.csv")), text)?;
        }
        Ok(())
    }

    /// How many rows hold, degrade and fail.
    pub fn counts(&self) -> [usize; 3] {
        ["holds", "degrades", "fails"].map(|word| self.0.iter().filter(|row| row.verdict() == word).count())
    }
}
