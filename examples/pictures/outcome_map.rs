//! Pictures of the example `outcome_map`.

use crate::common::film::hex;
use crate::common::{self, BLUE, Drawn, GREY, INK, ORANGE, blend};
use crate::{END, First};
use plotters::style::{RGBColor, WHITE};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::fmt::Write;
use std::path::PathBuf;

/// Shades by time, and what a picture may weigh (bytes).
const SHADES: usize = 5;
const LARGEST: usize = 1_000_000;

/// The shade of an outcome, counted from zero: none, then those of the inner rod, then those of the outer one.
pub fn shade(first: First) -> usize {
    first.map_or(0, |(rod, time)| 1 + rod * SHADES + ((SHADES as f64 * time / END) as usize).min(SHADES - 1))
}

fn colour(shade: usize) -> RGBColor {
    let Some(k) = shade.checked_sub(1) else { return RGBColor(246, 247, 249) };
    blend([BLUE, ORANGE][k / SHADES], WHITE, 0.75 * (k % SHADES) as f64 / (SHADES - 1) as f64)
}

/// Rows of cells as bars of one shade: a path for each shade, in cells.
fn bars(n: usize, firsts: &[First]) -> Drawn<String> {
    let (mut paths, mut svg) = (vec![String::new(); 1 + 2 * SHADES], String::new());
    for (row, firsts) in firsts.chunks(n).enumerate() {
        let mut shades = firsts.iter().map(|first| shade(*first)).enumerate().peekable();
        while let Some((from, shade)) = shades.next() {
            let mut to = from;
            while let Some((column, _)) = shades.next_if(|(_, next)| *next == shade) {
                to = column;
            }
            write!(paths[shade], "M{from} {row}h{}", to + 1 - from)?;
        }
    }
    for (shade, path) in paths.iter().enumerate().filter(|(_, path)| !path.is_empty()) {
        writeln!(svg, r#"<path stroke="{}" d="{path}"/>"#, hex(colour(shade)))?;
    }
    Ok(svg)
}

/// Half of the line within which no rod has the energy to turn over, 3 cos of the inner angle and cos of the outer one make 2.
fn line() -> Vec<(f64, f64)> {
    let at = |k: i32| {
        let outer = PI * (FRAC_PI_2 * f64::from(k) / 90.0).sin(); // close together where the line turns
        (((2.0 - outer.cos()) / 3.0).min(1.0).acos(), outer)
    };
    (-90..=90).map(at).collect()
}

pub fn draw(n: usize, firsts: &[First]) -> Drawn<PathBuf> {
    let ([left, top, side], [ink, grey]) = ([64.0, 84.0, 560.0], [hex(INK), hex(GREY)]);
    let (width, height, right, low) = (side + 200.0, side + 140.0, left + side, top + side);
    let mut svg = String::new();
    writeln!(
        svg,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" role="img">"#
    )?;
    writeln!(svg, "<style>text{{font-family:Helvetica,Arial,sans-serif;fill:{grey}}}</style>")?;
    writeln!(svg, r#"<rect width="{width}" height="{height}" fill="white"/>"#)?;
    let scale = side / n as f64;
    let turned = format!("translate({left} {low}) scale({scale} -{scale}) translate(0 0.5)");
    // Bars a little higher than their cells leave no gaps between rows.
    writeln!(svg, r#"<g fill="none" stroke-width="1.02" transform="{turned}">"#)?;
    writeln!(svg, "{}</g>", bars(n, firsts)?)?;
    let half = line();
    let around = half.iter().copied().chain(half.iter().rev().map(|(inner, outer)| (-inner, *outer)));
    let place = |start: f64, angle: f64| start + side * (angle + PI) / TAU;
    let points: Vec<_> =
        around.map(|(inner, outer)| format!("{:.1},{:.1}", place(left, inner), place(top, -outer))).collect();
    writeln!(svg, r#"<polygon points="{}" fill="none" stroke="{ink}" stroke-width="1.2"/>"#, points.join(" "))?;

    let mut text = |x: f64, y: f64, look: &str, text: &str| {
        writeln!(svg, r#"<text x="{x}" y="{y}" font-size={look}>{text}</text>"#)
    };
    let (plain, middle, end) = (r#""12""#, r#""12" text-anchor="middle""#, r#""12" text-anchor="end""#);
    let [bold, large] = [12, 21].map(|size| format!(r#""{size}" font-weight="bold" style="fill:{ink}""#));
    text(24.0, 34.0, &large, "Which rod turns over first")?;
    let subtitle = format!(
        "A double pendulum let go from rest, {n} × {n} starts. Within the line no rod has the energy to turn over."
    );
    text(24.0, 58.0, r#""13.5""#, &subtitle)?;
    for (k, name) in ["−180°", "−90°", "0°", "90°", "180°"].into_iter().enumerate() {
        let along = 0.25 * side * k as f64;
        text(left + along, low + 18.0, middle, name)?;
        text(left - 6.0, low + 4.0 - along, end, name)?;
    }
    text(right, low + 38.0, end, "inner rod from hanging")?;
    text(left, top - 7.0, plain, "outer rod from hanging")?;
    let key = [
        ("neither", 96.0, 0..1),
        ("inner rod", 148.0, 1..1 + SHADES),
        ("outer rod", 276.0, 1 + SHADES..1 + 2 * SHADES),
    ];
    for (name, y, shades) in key.clone() {
        text(right + 20.0, y, &bold, name)?;
        for (k, _) in shades.skip_while(|shade| *shade == 0).enumerate() {
            let until = format!("by {:.1} s", END / SHADES as f64 * (k + 1) as f64);
            text(right + 48.0, y + 19.5 + 18.0 * k as f64, plain, &until)?;
        }
    }
    for (k, y, shade) in
        key.into_iter().flat_map(|(_, y, shades)| shades.enumerate().map(move |(k, shade)| (k, y, shade)))
    {
        let (x, y, fill) = (right + 20.0, y + 8.0 + 18.0 * k as f64, hex(colour(shade)));
        writeln!(
            svg,
            r#"<rect x="{x}" y="{y}" width="22" height="14" fill="{fill}" stroke="{grey}" stroke-width="0.5"/>"#
        )?;
    }
    svg.push_str("</svg>\n");
    if svg.len() > LARGEST {
        return Err(format!("{} bytes are more than a picture may have", svg.len()).into());
    }
    common::save("outcome_map", &svg)
}
