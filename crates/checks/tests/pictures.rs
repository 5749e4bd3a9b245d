//! Texts in pictures do not overlap and lie within; every picture has a title; those that move are small, and stand still for readers who
//! ask for it. Pictures are those of the documentation and of examples that have been run.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

type Failure = Box<dyn Error>;

/// What a picture that moves may weigh (bytes).
const LARGEST: usize = 100_000;
/// Fonts that stand in for Helvetica are wider by about this much.
const WIDER: f64 = 1.1;
/// Boxes may share this much of the smaller one's height: letters do not fill theirs.
const SHARED: f64 = 0.2;

/// A text and the box that it takes.
struct Place {
    text: String,
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

/// The value of an attribute within a tag.
fn attribute<'t>(tag: &'t str, name: &str) -> Option<&'t str> {
    tag.split(&format!(" {name}=\"")).nth(1)?.split('"').next()
}

fn number(tag: &str, name: &str) -> Option<f64> {
    attribute(tag, name)?.parse().ok()
}

/// Width of a letter of Helvetica, of its size.
fn width(letter: char) -> f64 {
    match letter {
        'i' | 'j' | 'l' | '\'' | '|' => 0.22,
        ' ' | '!' | ',' | '.' | ':' | ';' | '/' | '·' | 'f' | 't' | 'I' => 0.28,
        '(' | ')' | '-' | 'r' | '⁰'..='⁾' | '²' | '³' | '¹' | '₀'..='₎' => 0.33,
        'c' | 'k' | 's' | 'v' | 'x' | 'y' | 'z' | 'J' => 0.5,
        'm' | 'M' | 'w' | 'W' | '½' | '–' => 0.85,
        'A'..='Z' => 0.7,
        _ => 0.56,
    }
}

/// A shift of a baseline in sizes of the font, `0.76em` or `-0.5ex`.
fn shift(dy: &str) -> f64 {
    let digits = dy.trim_end_matches(['e', 'm', 'x']);
    digits.parse::<f64>().unwrap_or(0.0) * if dy.ends_with("ex") { 0.52 } else { 1.0 }
}

/// All upright texts of a picture.
fn boxes(svg: &str) -> Result<Vec<Place>, Failure> {
    let mut found = vec![];
    for rest in svg.split("<text").skip(1) {
        let (tag, rest) = rest.split_once('>').ok_or("a tag does not end")?;
        let text = rest.split("</text>").next().unwrap_or_default().trim().replace("&apos;", "'").replace("&amp;", "&");
        if attribute(tag, "transform").is_some() || text.is_empty() {
            continue;
        }
        let place = |name| number(tag, name).ok_or(format!("{text:?} has no {name}"));
        let (x, y, size) = (place("x")?, place("y")?, place("font-size")?);
        let bold = if attribute(tag, "font-weight").is_some() { 1.06 } else { 1.0 };
        let long = WIDER * bold * size * text.chars().map(width).sum::<f64>();
        let left = x - long
            * match attribute(tag, "text-anchor") {
                Some("end") => 1.0,
                Some("middle") => 0.5,
                _ => 0.0,
            };
        let base = y + size * attribute(tag, "dy").map_or(0.0, shift);
        found.push(Place { text, left, right: left + long, top: base - 0.73 * size, bottom: base + 0.21 * size });
    }
    Ok(found)
}

/// What is wrong with a picture.
fn faults(svg: &str) -> Result<Vec<String>, Failure> {
    let (boxes, mut faults) = (boxes(svg)?, vec![]);
    let root = svg.split('>').next().unwrap_or_default();
    let view: Vec<f64> = attribute(root, "viewBox").ok_or("no viewBox")?.split(' ').flat_map(str::parse).collect();
    let [_, _, wide, high] = view[..] else { return Err("a viewBox is four numbers".into()) };
    // The head is larger than the names of axes.
    let heights = || boxes.iter().map(|place| place.bottom - place.top);
    if heights().fold(0.0, f64::max) < 1.3 * heights().fold(f64::INFINITY, f64::min) {
        faults.push("no title".to_owned());
    }
    if svg.contains("<animate") && (svg.len() > LARGEST || !svg.contains("prefers-reduced-motion")) {
        faults.push(format!("moves, and has {} bytes or no still", svg.len()));
    }
    for (k, a) in boxes.iter().enumerate() {
        if a.left < 0.0 || a.top < 0.0 || a.right > wide || a.bottom > high {
            faults.push(format!("{:?} is not within", a.text));
        }
        for b in &boxes[k + 1..] {
            let beside = a.right.min(b.right) - a.left.max(b.left);
            let over = a.bottom.min(b.bottom) - a.top.max(b.top);
            let low = (a.bottom - a.top).min(b.bottom - b.top);
            if beside > 0.0 && over > SHARED * low {
                faults.push(format!("{:?} over {:?}", a.text, b.text));
            }
        }
    }
    Ok(faults)
}

#[test]
fn what_is_wrong_is_seen() -> Result<(), Failure> {
    let picture = |texts: &str| format!(r#"<svg width="200" viewBox="0 0 200 100"><rect/>{texts}<animate/></svg>"#);
    let long = r#"<text x="190" y="50" font-size="10">too long to end here</text>"#;
    let pair = r#"<text x="10" y="50" font-size="10">one word</text><text x="60" y="52" text-anchor="end" font-size="10">other</text>"#;
    for (texts, expected) in [(long, "is not within"), (pair, "over \"other\""), ("", "no still"), ("", "no title")] {
        let faults = faults(&picture(texts))?;
        assert!(faults.iter().any(|fault| fault.contains(expected)), "{expected}: {faults:?}");
    }
    Ok(())
}

#[test]
fn texts_of_pictures_lie_apart() -> Result<(), Failure> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let (mut seen, mut wrong) = (0, vec![]);
    for folder in ["docs", "docs/pictures", "target", "benches/results/precision"] {
        let Ok(entries) = fs::read_dir(root.join(folder)) else { continue };
        let paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
        for path in paths.iter().filter(|path| path.extension().is_some_and(|ending| ending == "svg")) {
            seen += 1;
            let faults = faults(&fs::read_to_string(path)?)?;
            wrong.extend(faults.into_iter().map(|fault| format!("{}: {fault}", path.display())));
        }
    }
    println!("{seen} pictures");
    assert!(seen > 10 && wrong.is_empty(), "{}", wrong.join("\n"));
    Ok(())
}
