//! Panels of pictures that move: curves over time that draw themselves as the run goes, forward or backward.

use super::film::{Course, hex, short};
use super::{Drawn, FAINT, GREY, INK};
use plotters::style::RGBColor;
use std::fmt::Write;

/// Where curves begin and how far from the right edge they end (pixels).
const SIDES: [f64; 2] = [52.0, 20.0];
/// What is above and below the curves (pixels).
const MARGINS: [f64; 2] = [26.0, 8.0];
/// Width of a letter of a name (pixels), rather too much.
const LETTER: f64 = 6.8;

/// A curve with its name: values at equal distances of time.
pub struct Curve<'a> {
    pub name: &'a str,
    pub colour: RGBColor,
    pub values: Vec<f64>,
}

/// Curves over the time of a film.
pub struct Panel<'a> {
    pub title: &'a str,
    pub curves: Vec<Curve<'a>>,
    /// Whether they are drawn as the film goes back, from their end to their start.
    pub backward: bool,
}

impl Panel<'_> {
    /// Pixels that one takes.
    pub const HEIGHT: f64 = 128.0;

    /// Writes panel number `k` below a height, across a width (pixels), of a film with this course.
    pub fn write(
        &self,
        svg: &mut String,
        k: usize,
        (above, width): (f64, f64),
        (course, again): (Course, &str),
    ) -> Drawn {
        let [left, right] = [SIDES[0], width - SIDES[1]];
        let [top, low] = [above + MARGINS[0], above + Self::HEIGHT - MARGINS[1]];
        let (across, head) = (right - left, above + 16.0);
        let all = || self.curves.iter().flat_map(|curve| curve.values.iter().copied());
        let most = all().fold(f64::MIN_POSITIVE, |most, x| most.max(x.abs()));
        let (least, greatest) = (all().fold(0.0, f64::min), all().fold(0.0, f64::max));
        let y = |value: f64| low - (low - top) * (value - least) / (greatest - least).max(f64::MIN_POSITIVE);
        writeln!(
            svg,
            r#"<text x="20" y="{head}" font-size="13.5" font-weight="bold" fill="{}">{}</text>"#,
            hex(INK),
            self.title
        )?;
        let mut end = right;
        for Curve { name, colour, .. } in self.curves.iter().rev() {
            writeln!(
                svg,
                r#"<text x="{end:.0}" y="{head}" font-size="12.5" text-anchor="end" fill="{}">{name}</text>"#,
                hex(*colour)
            )?;
            end -= LETTER * name.chars().count() as f64 + 14.0;
        }
        let tick = round_below(0.9 * most);
        for value in [-tick, 0.0, tick].into_iter().filter(|value| (least..=greatest).contains(value)) {
            let (y, text) = (y(value), short(value).replace('-', "−"));
            writeln!(svg, r#"<path d="M{left} {y:.1}H{right}" stroke="{}"/>"#, hex(FAINT))?;
            writeln!(
                svg,
                r#"<text x="{}" y="{:.1}" font-size="11" text-anchor="end" fill="{}">{text}</text>"#,
                left - 6.0,
                y + 4.0,
                hex(GREY)
            )?;
        }
        let beyond = right + 3.0; // ends of lines are round
        let (high, [first, second, third]) = (low - top + 4.0, Course::TURNS);
        let (shown, cursor) = match (course, self.backward) {
            (Course::Forward, _) => {
                (format!(r#""width" {again} values="0;{across}""#), format!(r#"values="0;{across}""#))
            }
            (Course::ThereAndBack, backward) => {
                let shown = match backward {
                    false => format!(r#""width" {again} values="0;{across};{across}" keyTimes="0;{first};1""#),
                    true => {
                        format!(
                            r#""x" {again} values="{beyond};{beyond};{left};{left}" keyTimes="0;{second};{third};1""#
                        )
                    }
                };
                (shown, format!(r#"values="0;{across};{across};0;0" keyTimes="0;{first};{second};{third};1""#))
            }
        };
        writeln!(
            svg,
            r#"<clipPath id="p{k}"><rect x="{left}" y="{:.1}" width="{across}" height="{high:.1}"><animate attributeName={shown}/></rect></clipPath>"#,
            top - 2.0
        )?;
        for class in [r#"class="still""#.to_owned(), format!(r#"class="moving" clip-path="url(#p{k})""#)] {
            writeln!(svg, "<g {class}>")?;
            for Curve { colour, values, .. } in &self.curves {
                let apart = across / values.len().saturating_sub(1).max(1) as f64;
                let each = values.iter().enumerate();
                let points: Vec<_> =
                    each.map(|(i, x)| format!("{:.1},{:.1}", left + apart * i as f64, y(*x))).collect();
                writeln!(
                    svg,
                    r#"<polyline points="{}" stroke="{}" stroke-width="1.8"/>"#,
                    points.join(" "),
                    hex(*colour)
                )?;
            }
            svg.push_str("</g>\n");
        }
        writeln!(
            svg,
            r#"<path class="moving" d="M{left} {top:.1}V{low:.1}" stroke="{}"><animateTransform attributeName="transform" type="translate" {again} {cursor}/></path>"#,
            hex(GREY)
        )?;
        Ok(())
    }
}

/// The largest of 1, 2 and 5 by a power of ten that is not above a number.
fn round_below(x: f64) -> f64 {
    let power = 10_f64.powf(x.log10().floor());
    [5.0, 2.0].into_iter().map(|digit| digit * power).find(|y| *y <= x).unwrap_or(power)
}
