//! What functions of robots cost: instructions; beside another library's; the aims that they miss.

use crate::tables::{Row, Rows, head, line};

const TARGETS: [&str; 2] = ["default", "native"];
/// How many times faster a function was to be: on which robots (on all by an empty name), and what it is called.
const AIMS: &[(&str, &str, f64)] = &[
    ("sweep", "arm7", 6.0),
    ("sweep", "quadruped, fixed", 5.0),
    ("sweep", "quadruped", 4.2),
    ("sweep", "humanoid", 4.0),
    ("inverse_dynamics", "", 1.5),
    ("mass_matrix", "", 2.0),
    ("forward_dynamics_derivatives", "", 2.0),
];

fn aim(robot: &str, function: &str) -> Option<f64> {
    let fits = |aim: &&(&str, &str, f64)| aim.0 == function && (aim.1.is_empty() || aim.1 == robot);
    AIMS.iter().find(fits).map(|aim| aim.2)
}

/// A function of a robot: nanoseconds of ours and of another library, and the latter's way.
struct Pair<'r> {
    ours: f64,
    theirs: f64,
    way: &'r str,
}

impl<'r> Pair<'r> {
    fn of(rows: &'r Rows, [robot, function, target]: [&str; 3], other: &str) -> Self {
        let key = [("robot", robot), ("function", function), ("target", target)];
        let of = |library: &str| {
            let same = |row: &&Row| {
                row.get("library") == library && key.iter().all(|(column, value)| row.get(column) == *value)
            };
            rows.0.iter().find(same)
        };
        let time = |row: Option<&Row>| row.map_or(f64::NAN, |row| row.number("nanoseconds"));
        let (ours, theirs) = (of("Catena"), of(other));
        Self { ours: time(ours), theirs: time(theirs), way: theirs.map_or("", |row| row.get("way")) }
    }

    fn ratio(&self) -> f64 {
        self.theirs / self.ours
    }
}

fn number(x: f64, digits: usize) -> String {
    if x.is_finite() { format!("{x:.digits$}") } else { "–".to_owned() }
}

/// All robots and functions, once each.
fn keys(rows: &Rows) -> Vec<[&str; 2]> {
    let mut found = vec![];
    for row in &rows.0 {
        let key = [row.get("robot"), row.get("function")];
        if !found.contains(&key) {
            found.push(key);
        }
    }
    found
}

/// Instructions of a call, of each function for each robot: on x86-64-v3, then on the default target.
pub fn counted(rows: &Rows) -> String {
    let (mut robots, mut functions) = (vec![], vec![]);
    for [robot, function] in keys(rows) {
        for (list, name) in [(&mut robots, robot), (&mut functions, function)] {
            if !list.contains(&name) {
                list.push(name);
            }
        }
    }
    let mut text =
        head(std::iter::once("instructions, v3 / default").chain(robots.iter().copied()).map(str::to_owned).collect());
    for function in functions {
        let mut cells = vec![function.to_owned()];
        for robot in &robots {
            let row = rows.0.iter().find(|row| row.get("robot") == *robot && row.get("function") == function);
            let of = |target: &str| row.map_or(f64::NAN, |row| row.number(target));
            let (v3, default) = (of("v3"), of("default"));
            let none = v3.is_nan() && default.is_nan();
            cells.push(if none { "–".to_owned() } else { format!("{} / {}", number(v3, 0), number(default, 0)) });
        }
        text += &line(cells);
    }
    text
}

/// Nanoseconds of both, and how many times faster ours are: bold where they miss the aim.
pub fn beside(rows: &Rows) -> String {
    let mut heads = vec!["robot".to_owned(), "function".to_owned()];
    for target in TARGETS {
        heads.extend([format!("ns, {target}"), "Pinocchio".to_owned(), "times".to_owned(), "dynibo, times".to_owned()]);
    }
    heads.push("aim".to_owned());
    let mut text = head(heads);
    for [robot, function] in keys(rows) {
        let mut cells = vec![robot.to_owned(), format!("`{function}`")];
        let aim = aim(robot, function);
        for target in TARGETS {
            let [pair, third] = ["Pinocchio", "dynibo"].map(|other| Pair::of(rows, [robot, function, target], other));
            let ratio = number(pair.ratio(), 2);
            let missed = aim.is_some_and(|aim| pair.ratio() < aim);
            cells.extend([number(pair.ours, 0), format!("{} (`{}`)", number(pair.theirs, 0), pair.way)]);
            cells.push(if missed { format!("**{ratio}**") } else { ratio });
            let ratio = number(third.ratio(), 2);
            cells.push(if third.ratio() < 1.0 { format!("**{ratio}**") } else { ratio });
        }
        cells.push(aim.map_or_else(String::new, |aim| aim.to_string()));
        text += &line(cells);
    }
    text
}

/// How many times faster a sweep of a published robot was to be.
const PUBLISHED: [(&str, f64); 10] = [
    ("iiwa", 6.0),
    ("panda", 6.0),
    ("ur5", 6.0),
    ("tiago", 6.0),
    ("hyq", 5.0),
    ("hyq, floating", 4.2),
    ("anymal", 4.2),
    ("atlas", 4.0),
    ("g1", 4.0),
    ("talos", 4.0),
];

/// Nanoseconds of ours for each robot, in brackets how many times as long Pinocchio takes: bold where that misses the aim.
pub fn published(rows: &Rows) -> String {
    let mut functions = vec![];
    for [_, function] in keys(rows) {
        if !functions.contains(&function) {
            functions.push(function);
        }
    }
    let names = ["robot"].into_iter().chain(functions.iter().copied()).chain(["numbers differ by", "aim of the sweep"]);
    let mut text = head(names.map(str::to_owned).collect());
    for (robot, of_sweep) in PUBLISHED {
        let row =
            |function: &str| rows.0.iter().find(|row| row.get("robot") == robot && row.get("function") == function);
        let mut cells = vec![robot.to_owned()];
        for function in &functions {
            let times = |name| row(function).map_or(f64::NAN, |row| row.number(name));
            let (ours, theirs) = (times("Catena"), times("Pinocchio"));
            let aim = if *function == "sweep" { Some(of_sweep) } else { aim(robot, function) };
            let ratio = number(theirs / ours, 2);
            let missed = aim.is_some_and(|aim| theirs / ours < aim);
            cells.push(format!("{} ({})", number(ours, 0), if missed { format!("**{ratio}**") } else { ratio }));
        }
        cells.push(row("sweep").map_or("–", |row| row.get("off")).to_owned());
        cells.push(of_sweep.to_string());
        text += &line(cells);
    }
    text
}

/// A line for each function whose aim is missed.
pub fn losses(rows: &Rows) -> String {
    let mut text = String::new();
    let mut functions = vec![];
    for (function, ..) in AIMS {
        if !functions.contains(function) {
            functions.push(function);
        }
    }
    for function in functions {
        let mut missed = vec![];
        for [robot, of] in keys(rows) {
            let Some(aim) = aim(robot, function).filter(|_| *of == *function) else { continue };
            let ratios = TARGETS.map(|target| Pair::of(rows, [robot, function, target], "Pinocchio").ratio());
            if ratios.iter().all(|ratio| ratio.is_nan()) {
                missed.push(format!("{robot} not there"));
            } else if ratios.iter().any(|ratio| *ratio < aim) {
                let [default, native] = ratios.map(|ratio| number(ratio, 2));
                missed.push(format!("{robot} {default} and {native} (aim {aim})"));
            }
        }
        if !missed.is_empty() {
            text += &format!("- **Beside Pinocchio, `{function}`** is this many times faster, default and native: ");
            text += &format!("{}.\n", missed.join("; "));
        }
    }
    if text.is_empty() { "- Beside Pinocchio robots miss no aim.\n".to_owned() } else { text }
}

/// Steps of a robot that stands: each way of either library, and how many times as long as ours it takes.
pub fn in_real_time(rows: &Rows) -> String {
    let ours = |target: &str| {
        let same = |row: &&Row| row.get("library") == "Catena" && row.get("target") == target;
        rows.0.iter().find(same).map_or(f64::NAN, |row| row.number("microseconds"))
    };
    let targets = TARGETS.map(ours);
    let names = ["library", "way", "µs a step", "times ours, default", "native", "height of the trunk (m)"];
    let mut text = head(names.map(str::to_owned).to_vec());
    for row in &rows.0 {
        let (library, taken) = (row.get("library"), row.number("microseconds"));
        let (way, times) = if library == "Catena" {
            (format!("`{}`, {}", row.get("way"), row.get("target")), [const { String::new() }; 2])
        } else {
            (row.get("way").to_lowercase(), targets.map(|ours| number(taken / ours, 2)))
        };
        let [default, native] = times;
        text += &line([library.to_owned(), way, number(taken, 2), default, native, row.get("height").to_owned()]);
    }
    text
}
