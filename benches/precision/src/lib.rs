//! Run time and sweeps against error: every rule, with fixed steps and with error control, in single and double precision.
//!
//! ```text
//! cargo run --release -p catena-precision --bin chains        # 2, 20, 100 rods on pins; 3, 20 on balls
//! cargo run --release -p catena-precision --bin stiff         # 20 rods on springs, a stiff pendulum, a slender rod of 40 segments
//! cargo run --release -p catena-precision --bin mechanisms    # heavy top, four-bar, Andrews' mechanism, an arm of seven joints
//! ```
//!
//! `--bin pictures` draws all files anew without running anything. Words on the command line choose scenes by parts of their names. Each scene's runs go to `benches/results/precision/SCENE-TARGET.csv`,
//! with a diagram beside it; runs of other libraries that `benches/rivals/rivals.py` left in `benches/results/rivals.csv` stand in both.
//! With `RUSTFLAGS="-C target-cpu=x86-64-v3"` the target is that.

mod diagram;
pub mod rules;

use std::error::Error;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

/// How long a run is repeated for its median time, and the longest that one run may take.
const BUDGET: Duration = Duration::from_millis(30);
const LONGEST: f64 = 2.0;
/// Errors for the table.
const LEVELS: [f64; 3] = [1e-3, 1e-6, 1e-9];
const TARGET: &str = if cfg!(target_feature = "fma") { "v3" } else { "default" };

/// One run.
pub struct Point {
    /// Step (s) or tolerance.
    pub parameter: f64,
    pub sweeps: usize,
    pub error: f64,
    pub seconds: f64,
}

/// The runs of a rule, from coarse to fine.
pub struct Series {
    /// Whose it is, if not Catena's.
    rival: Option<String>,
    rule: String,
    control: &'static str,
    scalar: &'static str,
    points: Vec<Point>,
}

/// A scene and what is known of its motion.
pub struct Scene {
    name: String,
    bodies: usize,
    /// When runs end (s).
    end: f64,
    /// What the error is of, at the end.
    reference: f64,
    unit: &'static str,
    series: Vec<Series>,
}

/// Says what long work is about, on one line that is written over.
fn progress(what: &str) {
    eprint!("\r\x1b[K{what}");
}

/// The middle one of values; not a number if there are none.
fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Values from `coarse` down to `fine`, each a share `ratio` of the one before.
pub fn ladder(coarse: f64, fine: f64, ratio: f64) -> Vec<f64> {
    let all = std::iter::successors(Some(coarse), move |value| Some(value * ratio));
    all.take_while(move |value| *value >= 0.99 * fine).collect()
}

/// Whether the command line asks for a scene.
pub fn is_wanted(name: &str) -> bool {
    let mut words = std::env::args().skip(1).peekable();
    words.peek().is_none() || words.any(|word| name.contains(&word))
}

/// The first of two values for the same thing by different rules at their tightest, and says by how much they differ.
pub fn agreed(name: &str, values: [Option<f64>; 2]) -> f64 {
    let [first, second] = values.map(|value| value.unwrap_or(f64::NAN));
    println!("reference of {name}: {first:.15}, two rules differ by {:.1e}", (first - second).abs());
    first
}

impl Scene {
    /// A scene by its name, number of bodies, end of runs (s), reference at the end and its unit.
    pub fn new(name: &'static str, bodies: usize, end: f64, reference: f64, unit: &'static str) -> Self {
        Self { name: name.to_owned(), bodies, end, reference, unit, series: Vec::new() }
    }

    pub fn end(&self) -> f64 {
        self.end
    }

    /// Runs a rule at all parameters, from coarse to fine. `run` yields sweeps and what is read at the end, or nothing where a run fails.
    pub fn measure(
        &mut self,
        (rule, control, scalar): (&str, &'static str, &'static str),
        parameters: &[f64],
        mut run: impl FnMut(f64) -> Option<(usize, f64)>,
    ) {
        let mut points = Vec::new();
        for parameter in parameters {
            progress(&format!("{}: {rule} {control} {scalar}, {parameter:.1e}", self.name));
            let (start, mut times, mut outcome) = (Instant::now(), Vec::new(), None);
            while times.len() < 3 || (start.elapsed() < BUDGET && times.len() < 1000) {
                let one = Instant::now();
                outcome = run(*parameter);
                times.push(one.elapsed().as_secs_f64());
                if start.elapsed().as_secs_f64() > LONGEST {
                    break;
                }
            }
            let (sweeps, found) = outcome.unwrap_or((0, f64::NAN));
            let seconds = median(&mut times);
            points.push(Point { parameter: *parameter, sweeps, error: (found - self.reference).abs(), seconds });
            if seconds > LONGEST {
                break; // finer ones take longer
            }
        }
        self.series.push(Series { rival: None, rule: rule.to_owned(), control, scalar, points });
    }

    /// Writes all runs and the diagram, and prints what it takes to reach an error.
    ///
    /// # Errors
    /// Those of files and of drawing.
    pub fn finish(mut self) -> Result<(), Box<dyn Error>> {
        let results = Path::new(env!("CARGO_MANIFEST_DIR")).join("../results");
        self.rivals(&results.join("rivals.csv"));
        let directory = results.join("precision");
        fs::create_dir_all(&directory)?;
        let name: String = self.name.chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
        progress("");
        fs::write(directory.join(format!("{name}-{TARGET}.csv")), self.csv())?;
        diagram::draw(&directory.join(format!("{name}-{TARGET}.svg")), &self)?;
        self.print();
        Ok(())
    }

    /// Draws what a file of runs holds, without running anything.
    ///
    /// # Errors
    /// Those of files and of drawing.
    pub fn redraw(csv: &Path) -> Result<(), Box<dyn Error>> {
        let text = fs::read_to_string(csv)?;
        let mut scene = Self::new("", 0, 0.0, 0.0, "rad or m");
        for line in text.lines().skip(1) {
            let fields: Vec<&str> = line.split(',').collect();
            let [name, library, rule, control, scalar, _, parameter, sweeps, error, seconds] = fields[..] else {
                continue;
            };
            scene.name = name.to_owned();
            let rival = (library != "Catena").then(|| library.to_owned());
            let control = if control == "fixed" { "fixed" } else { "controlled" };
            let scalar = if scalar == "f32" { "f32" } else { "f64" };
            let key = |s: &Series| (s.rival.clone(), s.rule.clone(), s.control, s.scalar);
            let own = (rival.clone(), rule.to_owned(), control, scalar);
            let (parameter, sweeps) = (parameter.parse()?, sweeps.parse()?);
            let point = Point { parameter, sweeps, error: error.parse()?, seconds: seconds.parse()? };
            match scene.series.iter_mut().find(|series| key(series) == own) {
                Some(series) => series.points.push(point),
                None => {
                    scene.series.push(Series { rival, rule: rule.to_owned(), control, scalar, points: vec![point] })
                }
            }
        }
        diagram::draw(&csv.with_extension("svg"), &scene)
    }

    /// Runs of other libraries, if they are there.
    fn rivals(&mut self, path: &Path) {
        let Ok(text) = fs::read_to_string(path) else { return };
        for line in text.lines().skip(1) {
            let fields: Vec<&str> = line.split(',').collect();
            let [name, library, rule, parameter, error, seconds] = fields[..] else { continue };
            let (Ok(parameter), Ok(error), Ok(seconds)) = (parameter.parse(), error.parse(), seconds.parse()) else {
                continue;
            };
            if name != self.name {
                continue;
            }
            let point = Point { parameter, sweeps: 0, error, seconds };
            let own = |series: &&mut Series| series.rival.as_deref() == Some(library) && series.rule == rule;
            match self.series.iter_mut().find(own) {
                Some(series) => series.points.push(point),
                None => self.series.push(Series {
                    rival: Some(library.to_owned()),
                    rule: rule.to_owned(),
                    control: "",
                    scalar: "f64",
                    points: vec![point],
                }),
            }
        }
    }

    fn csv(&self) -> String {
        let mut text = "scene,library,rule,control,scalar,target,step_or_tolerance,sweeps,error,seconds\n".to_owned();
        for Series { rival, rule, control, scalar, points } in &self.series {
            let library = rival.as_deref().unwrap_or("Catena");
            for Point { parameter, sweeps, error, seconds } in points {
                let how = format!("{library},{rule},{control},{scalar},{TARGET},{parameter:e}");
                text += &format!("{},{how},{sweeps},{error:.3e},{seconds:.3e}\n", self.name);
            }
        }
        text
    }

    /// What it takes to reach an error, as a table in Markdown.
    fn print(&self) {
        println!("\n{}, {} s: milliseconds to an error, and nanoseconds per body and sweep\n", self.name, self.end);
        let levels: String = LEVELS.iter().map(|level| format!(" {level:.0e} {} |", self.unit)).collect();
        println!("| rule |{levels} ns |\n|---|{}---:|", "---:|".repeat(LEVELS.len()));
        for series in &self.series {
            let mut line = format!("| {} |", series.name());
            for level in LEVELS {
                line += &series.time_to(level).map_or(" – |".to_owned(), |time| format!(" {:.3} |", time * 1e3));
            }
            let per_sweep = |point: &Point| point.seconds * 1e9 / (point.sweeps * self.bodies) as f64;
            let mut costs: Vec<f64> = series.points.iter().rev().take(5).map(per_sweep).collect();
            match series.rival {
                Some(_) => println!("{line} |"),
                None => println!("{line} {:.1} |", median(&mut costs)),
            }
        }
    }
}

impl Series {
    fn name(&self) -> String {
        match &self.rival {
            Some(rival) => format!("{rival}, {}", self.rule),
            None => format!("{} {} {}", self.rule, self.control, self.scalar),
        }
    }

    /// The least time (s) of a run with an error below `level`, if the next finer one is below it too: an error may
    /// vanish by chance where it changes sign.
    fn time_to(&self, level: f64) -> Option<f64> {
        let pairs = self.points.iter().zip(self.points.iter().skip(1));
        let exact = pairs.filter(|(point, finer)| point.error <= level && finer.error <= level);
        exact.map(|(point, _)| point.seconds).min_by(f64::total_cmp)
    }
}
