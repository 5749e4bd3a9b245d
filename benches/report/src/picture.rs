//! The picture of run time against error, which draws itself: `docs/pictures/work_precision.svg`.

use crate::tables::{MEASURED, Row, Rows};
use std::fmt::Write;

/// What is shown: scenes by their names in the files, and what is said of them.
const SCENES: [[&str; 2]; 3] = [
    ["2 rods on pins", "2 rods on pins, 2 s"],
    ["20 rods on pins", "20 rods on pins, 0.5 s"],
    ["arm of seven joints", "An arm of seven joints"],
];
/// Rules by name and control, what they are called, and their colours.
const RULES: [[&str; 4]; 8] = [
    ["Taylor 24", "controlled", "Taylor, order to 24", "#c8003c"],
    ["Vcabm", "controlled", "Vcabm", "#783ca0"],
    ["DOP853", "controlled", "Dop853", "#d65412"],
    ["DOPRI5", "controlled", "Dopri5", "#0062a5"],
    ["Adams", "controlled", "Adams", "#82822a"],
    ["RK4", "fixed", "Rk4, fixed steps", "#1f2933"],
    ["SDIRK4", "controlled", "Sdirk4", "#008764"],
    ["generalised-alpha", "controlled", "GeneralizedAlpha", "#7b8794"],
];
const INK: &str = "#1f2933";
const GREY: &str = "#7b8794";
const FAINT: &str = "#e1e5ea";
/// Size of the picture, place of the first panel, size of a panel, and how far panels are apart (pixels).
const SIZE: [f64; 2] = [1060.0, 440.0];
const FIRST: [f64; 2] = [56.0, 108.0];
const PANEL: [f64; 2] = [250.0, 280.0];
const APART: f64 = 46.0;
/// Errors from left to right and times from bottom to top, by powers of ten (rad or m, ms).
const ERRORS: [i32; 2] = [-2, -12];
const TIMES: [i32; 2] = [-2, 3];

/// Errors and times (ms) of a rule, from coarse to fine. An error counts as that of the next finer run where this is larger: it may vanish by
/// chance.
fn runs(rows: &[&Row], scene: &str, [rule, control, ..]: [&str; 4]) -> Vec<[f64; 2]> {
    let own = |row: &&&Row| {
        let kind = [("target", "default"), ("scalar", "f64"), ("library", "Catena")];
        let known = [("scene", scene), ("rule", rule), ("control", control)];
        known.iter().chain(&kind).all(|(column, value)| row.get(column) == *value)
    };
    let runs: Vec<[f64; 2]> =
        rows.iter().filter(own).map(|row| ["error", "seconds"].map(|column| row.number(column))).collect();
    let pairs = runs.windows(2).map(|pair| [pair[0][0].max(pair[1][0]), 1e3 * pair[0][1]]);
    let shown = |[error, _]: &[f64; 2]| *error > 10_f64.powi(ERRORS[1]) && *error < 10_f64.powi(ERRORS[0]);
    pairs.filter(shown).collect()
}

/// Ten to a power as it is printed.
fn power(exponent: i32) -> String {
    let plain = exponent.to_string();
    let digits = plain.chars().map(|c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        c => char::from_u32(0x2070 + c.to_digit(10).unwrap_or(0)).unwrap_or(c),
    });
    format!("10{}", digits.collect::<String>())
}

/// A scene's panel, `left` from the picture's edge.
fn panel(svg: &mut String, rows: &[&Row], left: f64, [scene, title]: [&str; 2]) -> std::fmt::Result {
    let (top, [width, height]) = (FIRST[1], PANEL);
    let share = |x: f64, [from, to]: [i32; 2]| (x - f64::from(from)) / f64::from(to - from);
    let (x, y) = (|e: f64| left + width * share(e, ERRORS), |t: f64| top + height * (1.0 - share(t, TIMES)));
    let low = top + height;
    writeln!(
        svg,
        r#"<text x="{left}" y="{}" font-size="14" font-weight="bold" fill="{INK}">{title}</text>"#,
        top - 12.0
    )?;
    for exponent in (ERRORS[1]..=ERRORS[0]).step_by(2) {
        let at = x(f64::from(exponent));
        writeln!(svg, r#"<path d="M{at:.1} {top}V{low}" stroke="{FAINT}"/>"#)?;
        writeln!(
            svg,
            r#"<text x="{at:.1}" y="{}" font-size="12" text-anchor="middle" fill="{GREY}">{}</text>"#,
            low + 18.0,
            power(exponent)
        )?;
    }
    for exponent in TIMES[0]..=TIMES[1] {
        let at = y(f64::from(exponent));
        writeln!(svg, r#"<path d="M{left} {at:.1}h{width}" stroke="{FAINT}"/>"#)?;
        writeln!(
            svg,
            r#"<text x="{}" y="{:.1}" font-size="12" text-anchor="end" fill="{GREY}">{}</text>"#,
            left - 6.0,
            at + 4.0,
            power(exponent)
        )?;
    }
    for rule in RULES {
        let points: Vec<String> = runs(rows, scene, rule)
            .iter()
            .map(|[error, time]| format!("{:.1} {:.1}", x(error.log10()), y(time.log10())))
            .collect();
        if points.is_empty() {
            continue;
        }
        let way = format!(r#"d="M{}" stroke="{}" stroke-width="2""#, points.join("L"), rule[3]);
        writeln!(svg, r#"<path class="still" {way}/>"#)?;
        // It stands for a while, and then draws itself anew from coarse to fine.
        writeln!(
            svg,
            r#"<path class="moving" {way} pathLength="1" stroke-dasharray="1 2"><animate attributeName="stroke-dashoffset" dur="9s" repeatCount="indefinite" values="0;0;1;0" keyTimes="0;.6;.6;1"/></path>"#
        )?;
    }
    let right = left + width;
    writeln!(
        svg,
        r#"<text x="{right}" y="{}" font-size="12" text-anchor="end" fill="{GREY}">error (rad), more digits to the right</text>"#,
        low + 38.0
    )
}

/// The picture.
pub fn draw(rows: &Rows) -> Result<String, std::fmt::Error> {
    let all: Vec<&Row> = rows.0.iter().collect();
    let ([width, height], mut svg) = (SIZE, String::new());
    writeln!(
        svg,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" style="max-width:100%;height:auto" role="img">"#
    )?;
    let title = "What an error costs";
    let subtitle = format!(
        "Milliseconds of a run against its error at the end, rule by rule; lower is better. Default target. {MEASURED}."
    );
    writeln!(svg, "<title>{title}</title><desc>{subtitle}</desc>")?;
    // Nothing that would reach beyond the picture where a page has it as its own.
    writeln!(
        svg,
        "<style>.still{{display:none}}@media(prefers-reduced-motion:reduce){{.moving{{display:none}}.still{{display:inline}}}}</style>"
    )?;
    writeln!(svg, r#"<g fill="none" stroke-linejoin="round" font-family="Helvetica, Arial, sans-serif">"#)?;
    writeln!(svg, r#"<rect width="{width}" height="{height}" fill="white"/>"#)?;
    writeln!(svg, r#"<text x="24" y="34" font-size="21" font-weight="bold" fill="{INK}">{title}</text>"#)?;
    writeln!(svg, r#"<text x="24" y="58" font-size="13.5" fill="{GREY}">{subtitle}</text>"#)?;
    let pitch = PANEL[0] + APART;
    for (k, scene) in SCENES.into_iter().enumerate() {
        panel(&mut svg, &all, FIRST[0] + pitch * k as f64, scene)?;
    }
    let left = FIRST[0] + pitch * SCENES.len() as f64 - 24.0;
    for (k, [_, _, name, colour]) in RULES.into_iter().enumerate() {
        let y = FIRST[1] + 12.0 + 24.0 * k as f64;
        writeln!(svg, r#"<text x="{left}" y="{y}" font-size="13" fill="{colour}">{name}</text>"#)?;
    }
    svg.push_str("</g>\n</svg>\n");
    Ok(svg)
}
