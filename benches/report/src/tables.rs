//! How rows of files become tables in Markdown.

use std::fmt::Write;
use std::path::Path;

/// A row of a file: values by the names of its columns.
pub struct Row(Vec<(String, String)>);

impl Row {
    pub fn get(&self, column: &str) -> &str {
        self.0.iter().find(|(name, _)| name == column).map_or("", |(_, value)| value)
    }
    pub fn number(&self, column: &str) -> f64 {
        self.get(column).parse().unwrap_or(f64::NAN)
    }
}

/// The rows of a file, or of all files in a folder or whose names begin so, in the order of their names.
pub struct Rows(pub Vec<Row>);

impl Rows {
    pub fn read(results: &Path, source: &str) -> std::io::Result<Self> {
        let whole = results.join(source);
        let (folder, start) = match whole.is_dir() {
            true => (whole, String::new()),
            false => {
                let name = whole.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
                (whole.parent().unwrap_or(results).to_owned(), name)
            }
        };
        let mut files = vec![];
        if folder.is_dir() {
            for entry in std::fs::read_dir(folder)? {
                let path = entry?.path();
                let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
                if name.starts_with(&start) && name.ends_with(".csv") {
                    files.push(path);
                }
            }
        }
        files.sort();
        let mut rows = vec![];
        for file in files {
            let text = std::fs::read_to_string(file)?;
            let mut lines = text.lines();
            let names: Vec<&str> = lines.next().unwrap_or("").split(',').collect();
            rows.extend(lines.map(|line| {
                // Commas within a value are written as semicolons.
                let pair = |(name, value): (&&str, &str)| ((*name).to_owned(), value.replace(';', ","));
                Row(names.iter().zip(line.split(',')).map(pair).collect())
            }));
        }
        Ok(Self(rows))
    }

    /// What a column holds, each once, in the order met.
    fn distinct<'r>(rows: &[&'r Row], columns: &[&str]) -> Vec<Vec<&'r str>> {
        let mut found: Vec<Vec<&str>> = vec![];
        for row in rows {
            let key: Vec<&str> = columns.iter().map(|column| row.get(column)).collect();
            if !found.contains(&key) {
                found.push(key);
            }
        }
        found
    }
}

/// An error as it is printed: plain where it holds, in italics where it degrades, bold where it fails.
fn cell(row: &Row) -> String {
    let error = row.number("error");
    let number = if error.is_finite() { format!("{error:.0e}") } else { "–".to_owned() };
    match row.get("verdict") {
        "holds" => number,
        "degrades" => format!("*{number}*"),
        _ => format!("**{number}**"),
    }
}

/// A line of a table.
pub fn line(cells: impl IntoIterator<Item = String>) -> String {
    let cells: Vec<String> = cells.into_iter().collect();
    format!("| {} |\n", cells.join(" | "))
}

/// The head of a table.
pub fn head(cells: Vec<String>) -> String {
    let rule = format!("|{}\n", "---|".repeat(cells.len()));
    line(cells) + &rule
}

/// A table for each scene and axis: ways and scalars down, values across. An axis of one value for all scenes is one table.
pub fn cases(rows: &Rows) -> String {
    let all: Vec<&Row> = rows.0.iter().collect();
    let mut text = String::new();
    let columns = if all.first().is_some_and(|row| row.get("part") == "random") { "way" } else { "value" };
    for axis in Rows::distinct(&all, &["axis"]) {
        let own: Vec<&Row> = all.iter().copied().filter(|row| row.get("axis") == axis[0]).collect();
        let across = Rows::distinct(&own, &[columns]);
        let names = across.iter().map(|value| match value[0].parse::<f64>() {
            Ok(number) if columns == "value" => format!("{number:.0e}"),
            _ => value[0].to_owned(),
        });
        let mut heads = vec![axis[0].to_owned()];
        heads.extend(names);
        text += &head(heads);
        let down = if columns == "value" { vec!["scene", "way", "scalar"] } else { vec!["scene"] };
        for key in Rows::distinct(&own, &down) {
            let of = |value: &Vec<&str>| {
                let same = |row: &&&Row| {
                    row.get(columns) == value[0] && down.iter().zip(&key).all(|(column, part)| row.get(column) == *part)
                };
                own.iter().find(same).map_or_else(String::new, |row| cell(row))
            };
            text += &line(std::iter::once(key.join(", ")).chain(across.iter().map(of)));
        }
        text.push('\n');
    }
    text
}

/// One row each, with what there is to say.
pub fn noted(rows: &Rows) -> String {
    let mut text = head(["scene", "rule", "of what", "largest", ""].map(str::to_owned).to_vec());
    for row in &rows.0 {
        let cells = [row.get("scene"), row.get("way"), row.get("axis")].map(str::to_owned);
        text += &line(cells.into_iter().chain([cell(row), row.get("note").to_owned()]));
    }
    text
}

/// How many cases of each part hold, degrade and fail.
pub fn losses(rows: &Rows) -> String {
    let all: Vec<&Row> = rows.0.iter().collect();
    let mut text = head(["part", "holds", "degrades", "fails"].map(str::to_owned).to_vec());
    for part in Rows::distinct(&all, &["part"]) {
        let count = |verdict: &str| {
            all.iter().filter(|row| row.get("part") == part[0] && row.get("verdict") == verdict).count().to_string()
        };
        text += &line([part[0].to_owned(), count("holds"), count("degrades"), count("fails")]);
    }
    text
}

/// Instructions of both targets side by side.
pub fn skip(rows: &Rows) -> String {
    let all: Vec<&Row> = rows.0.iter().collect();
    let mut text = head(["feature", "scene", "default", "v3", "bytes"].map(str::to_owned).to_vec());
    for key in Rows::distinct(&all, &["feature", "scene"]) {
        let own = |target: &str| {
            let same =
                |row: &&&Row| row.get("feature") == key[0] && row.get("scene") == key[1] && row.get("target") == target;
            let count = all.iter().find(same).map_or(f64::NAN, |row| row.number("instructions"));
            if count.is_finite() { format!("{count:.1}") } else { "–".to_owned() }
        };
        let first = all.iter().find(|row| row.get("feature") == key[0] && row.get("scene") == key[1]);
        let bytes = first.map_or_else(String::new, |row| {
            let parts = ["scene_bytes", "motion_bytes", "stepper_bytes"].map(|column| row.get(column));
            if parts[0].is_empty() { String::new() } else { parts.join(", ") }
        });
        text += &line([key[0].to_owned(), key[1].to_owned(), own("default"), own("v3"), bytes]);
    }
    text
}

/// Instructions and nanoseconds of the sweeps of a part, both targets, and what multiple they are of those of the row that they compare to.
pub fn sweeps(rows: &Rows, part: &str, beside: Option<&str>) -> String {
    let number =
        |row: &Row, column: &str| Some(row.get(column)).filter(|text| !text.is_empty()).unwrap_or("–").to_owned();
    let mut heads = ["scene", "form", "n", "instr/body default", "v3"].map(str::to_owned).to_vec();
    heads.extend(beside.iter().flat_map(|beside| [format!(": {beside}, default"), "v3".to_owned()]));
    heads.extend(["ns/body default", "v3"].map(str::to_owned));
    let mut text = head(heads);
    for row in rows.0.iter().filter(|row| row.get("part") == part) {
        let mut cells = [row.get("scene"), row.get("form"), row.get("n")].map(str::to_owned).to_vec();
        let ratios: &[&str] = if beside.is_some() { &["default_ratio", "v3_ratio"] } else { &[] };
        let columns = ["default", "v3"].iter().chain(ratios).chain(&["default_ns", "v3_ns"]);
        cells.extend(columns.map(|column| number(row, column)));
        text += &line(cells);
    }
    text
}

/// Where runs were timed against their errors.
pub const MEASURED: &str = "One core of two, the other one idle";

/// Milliseconds and sweeps to three errors, a table for each scene and target. A run counts if the next finer one is as good: errors may vanish by
/// chance where they change sign.
pub fn precision(rows: &Rows) -> String {
    const LEVELS: [f64; 3] = [1e-3, 1e-6, 1e-9];
    let all: Vec<&Row> = rows.0.iter().collect();
    let mut text = format!("{MEASURED}.\n\n");
    for scene in Rows::distinct(&all, &["scene", "target"]) {
        let of_scene = |row: &&&Row| row.get("scene") == scene[0] && row.get("target") == scene[1];
        let own: Vec<&Row> = all.iter().filter(of_scene).copied().collect();
        let names = LEVELS.map(|level| format!("{level:.0e}"));
        text += &head(
            [format!("{}, {}: ms (sweeps) to an error of", scene[0], scene[1])].into_iter().chain(names).collect(),
        );
        for rule in Rows::distinct(&own, &["library", "rule", "control", "scalar"]) {
            let columns = ["library", "rule", "control", "scalar"];
            let same = |row: &&&Row| columns.iter().zip(&rule).all(|(column, part)| row.get(column) == *part);
            let points = own.iter().filter(same);
            let points: Vec<[f64; 3]> =
                points.map(|row| [row.number("error"), 1e3 * row.number("seconds"), row.number("sweeps")]).collect();
            let best = |level: f64| {
                let good = points.windows(2).filter(|pair| pair[0][0] <= level && pair[1][0] <= level);
                good.map(|pair| pair[0]).min_by(|a, b| a[1].total_cmp(&b[1]))
            };
            let times = LEVELS.map(|level| match best(level) {
                Some([_, time, sweeps]) if sweeps > 0.0 => format!("{} ({sweeps:.0})", figures(time)),
                Some([_, time, _]) => figures(time),
                None => "–".to_owned(),
            });
            let name = if rule[0] == "Catena" { rule[1..].join(" ") } else { rule[..2].join(", ") };
            text += &line(std::iter::once(name).chain(times));
        }
        text.push('\n');
    }
    text
}

/// Two figures.
fn figures(x: f64) -> String {
    let mut text = String::new();
    let digits = (1.0 - x.abs().log10().floor()).max(0.0) as usize;
    let _ = write!(text, "{x:.digits$}");
    text
}

/// Gradients backward as multiples of their own plain runs: bodies down, libraries across.
pub fn gradients(rows: &Rows) -> String {
    let all: Vec<&Row> = rows.0.iter().collect();
    let libraries = Rows::distinct(&all, &["library"]);
    let names = libraries.iter().map(|library| format!("{}: gradient / plain run (ms)", library[0]));
    let mut text = head(std::iter::once("bodies".to_owned()).chain(names).collect());
    for bodies in Rows::distinct(&all, &["bodies"]) {
        let cells = libraries.iter().map(|library| {
            let row = all.iter().find(|row| row.get("library") == library[0] && row.get("bodies") == bodies[0]);
            row.map_or("–".to_owned(), |row| {
                let [plain, whole] = ["plain", "gradient"].map(|column| 1e3 * row.number(column));
                format!("{:.1} ({} / {})", whole / plain, figures(whole), figures(plain))
            })
        });
        text += &line(std::iter::once(bodies[0].to_owned()).chain(cells));
    }
    text
}

/// Ensembles: nanoseconds of a scene and step on one thread and on two, and shares of plain numbers on one thread.
pub fn ensembles(rows: &Rows) -> String {
    let all: Vec<&Row> = rows.0.iter().collect();
    let columns = ["scene", "way", "one thread (ns)", "of plain numbers", "two threads (ns)", "faster than one"];
    let mut text = head(columns.map(str::to_owned).to_vec());
    for way in Rows::distinct(&all, &["scene", "library", "scalar", "lanes"]) {
        let [scene, library, scalar, lanes] = [0, 1, 2, 3].map(|k| way[k]);
        let columns = ["scene", "library", "scalar", "lanes"];
        let own = |row: &&&Row| columns.iter().zip(&way).all(|(column, value)| row.get(column) == *value);
        let on = |threads: &str| all.iter().filter(own).find(|row| row.get("threads") == threads);
        let Some(one) = on("1") else { continue };
        let alone = one.number("nanoseconds");
        let both = on("2").map_or(["–".to_owned(), "–".to_owned()], |row| {
            let taken = row.number("nanoseconds");
            [figures(taken), format!("{:.2}", alone / taken)]
        });
        let name = if library == "Catena" { format!("{scalar} × {lanes}") } else { library.to_owned() };
        let share = if lanes == "1" { "–".to_owned() } else { format!("{:.3}", one.number("share")) };
        text += &line([scene.to_owned(), name, figures(alone), share].into_iter().chain(both));
    }
    text
}
