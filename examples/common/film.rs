//! Pictures that move: the links of a scene over time as an SVG animated by itself (SMIL), without a script.
//!
//! Where readers ask for less motion they see the still: the whole path of the traced point, and the links as they are at the start or at an
//! instant that says more.

use super::panel::Panel;
use super::{Drawn, FAINT, GREY, INK};
use plotters::style::RGBColor;
use std::fmt::Write;
use std::ops::Range;
use std::path::PathBuf;

/// More than this (bytes) is too much for a page that shows several.
const LARGEST: usize = 100_000;
/// Width of a letter of the subtitle (pixels), rather too much.
const LETTER: f64 = 6.3;
/// What is above and below the scene (pixels).
const MARGINS: [f64; 2] = [62.0, 30.0];

/// Points of each stroke, from joint to joint, in the order in which `Film::strokes` names them.
pub type Frame = Vec<Vec<(f64, f64)>>;

/// How a stroke looks.
#[derive(Clone, Copy)]
pub struct Stroke {
    colour: RGBColor,
    /// Pixels.
    width: f64,
    look: Look,
}

#[derive(Clone, Copy, PartialEq)]
enum Look {
    Links,
    Line,
    Face,
}

impl Stroke {
    /// Links of a width (pixels), with a ring at each joint.
    pub const fn links(colour: RGBColor, width: f64) -> Self {
        Self { colour, width, look: Look::Links }
    }

    /// A line of a width (pixels); where all its points are one, a dot.
    pub const fn line(colour: RGBColor, width: f64) -> Self {
        Self { colour, width, look: Look::Line }
    }

    /// A filled face; where all its points are one, nothing.
    pub const fn face(colour: RGBColor) -> Self {
        Self { colour, width: 0.0, look: Look::Face }
    }
}

/// How a film goes through its frames.
#[derive(Clone, Copy, Default, PartialEq)]
pub enum Course {
    #[default]
    Forward,
    /// To the end and, after a moment, back.
    ThereAndBack,
}

impl Course {
    /// Shares of a film that goes there and back at which it has come to the end, turns, and is at the start again.
    pub const TURNS: [f64; 3] = [0.46, 0.5, 0.96];

    /// Share of the run's time at a share of the film's.
    fn at(self, share: f64) -> f64 {
        let [end, turn, start] = Self::TURNS;
        match self {
            Self::Forward => share,
            Self::ThereAndBack if share <= turn => (share / end).min(1.0),
            Self::ThereAndBack => ((start - share) / (start - turn)).max(0.0),
        }
    }

    /// Numbers of the frames as they follow each other, at equal distances.
    fn order(self, frames: usize) -> Vec<usize> {
        let last = frames.saturating_sub(1);
        let shown = if self == Self::Forward { last } else { (last as f64 / Self::TURNS[0]).ceil() as usize };
        (0..=shown).map(|k| (self.at(k as f64 / shown.max(1) as f64) * last as f64).round() as usize).collect()
    }
}

/// What does not move in a moving picture.
#[derive(Default)]
pub struct Film<'a> {
    pub title: &'a str,
    pub subtitle: &'a str,
    /// What is seen of the plane (m).
    pub view: (Range<f64>, Range<f64>),
    /// Pixels of a metre.
    pub scale: f64,
    /// Time that the frames span, and time that they are shown (s).
    pub seconds: [f64; 2],
    pub course: Course,
    /// Number of the frame that is shown where nothing moves.
    pub still: usize,
    pub strokes: &'a [Stroke],
    /// The point that leaves a trace: its stroke, its place in that, and the colour.
    pub trace: Option<(usize, usize, RGBColor)>,
    /// Points that the ground holds.
    pub ground: &'a [(f64, f64)],
    /// Faint lines behind all else: a floor.
    pub floor: &'a [Vec<(f64, f64)>],
    /// What colours mean.
    pub legend: &'a [(&'a str, RGBColor)],
    /// Curves over time below the scene.
    pub panels: &'a [Panel<'a>],
}

impl Film<'_> {
    /// Writes the picture into target/ and returns where it is.
    pub fn save(&self, name: &str, frames: &[Frame]) -> Drawn<PathBuf> {
        let svg = self.svg(frames)?;
        let (across, up) = &self.view;
        let seen = |(x, y): &(f64, f64)| across.contains(x) && up.contains(y);
        if let Some((x, y)) = frames.iter().flatten().flatten().find(|place| !seen(place)) {
            return Err(format!("{name}: ({x:.3}, {y:.3}) m is outside what is seen").into());
        }
        if svg.len() > LARGEST {
            return Err(format!("{name}: {} bytes are more than a moving picture may have", svg.len()).into());
        }
        super::save(name, &svg)
    }

    /// A place in pixels, to a tenth.
    fn pixel(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let (across, up) = &self.view;
        let tenth = |x: f64| (10.0 * x).round() / 10.0;
        (tenth(self.scale * (x - across.start)), tenth(MARGINS[0] + self.scale * (up.end - y)))
    }

    fn points(&self, places: impl IntoIterator<Item = (f64, f64)>) -> String {
        let each = places.into_iter().map(|place| {
            let (x, y) = self.pixel(place);
            format!("{x},{y}")
        });
        each.collect::<Vec<_>>().join(" ")
    }

    fn svg(&self, frames: &[Frame]) -> Drawn<String> {
        let (across, up) = &self.view;
        let width = (self.scale * (across.end - across.start)).round();
        let low = MARGINS[0] + self.scale * (up.end - up.start); // where the scene ends
        let height = (low + Panel::HEIGHT * self.panels.len() as f64 + MARGINS[1]).round();
        let [span, shown] = self.seconds;
        if LETTER * self.subtitle.chars().count() as f64 > width - 40.0 {
            return Err(format!("{}: the subtitle is longer than the picture is wide", self.title).into());
        }
        let again = format!(r#"dur="{shown}s" repeatCount="indefinite""#);
        let mut svg = String::new();
        writeln!(
            svg,
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" style="max-width:100%;height:auto" role="img">"#
        )?;
        writeln!(svg, "<title>{}</title><desc>{}</desc>", self.title, self.subtitle)?;
        svg.push_str("<style>text{font-family:Helvetica,Arial,sans-serif}polyline{fill:none;stroke-linecap:round;stroke-linejoin:round}.still{display:none}@media(prefers-reduced-motion:reduce){.moving{display:none}.still{display:inline}}</style>\n");
        writeln!(svg, r#"<rect width="{width}" height="{height}" fill="white"/>"#)?;
        writeln!(
            svg,
            r#"<text x="20" y="30" font-size="19" font-weight="bold" fill="{}">{}</text>"#,
            hex(INK),
            self.title
        )?;
        writeln!(svg, r#"<text x="20" y="50" font-size="12.5" fill="{}">{}</text>"#, hex(GREY), self.subtitle)?;
        for line in self.floor {
            let points = self.points(line.iter().copied());
            writeln!(svg, r#"<polyline points="{points}" stroke="{}" stroke-width="1"/>"#, hex(FAINT))?;
        }
        if !self.floor.is_empty() {
            // Not behind the words below.
            writeln!(svg, r#"<rect y="{low:.0}" width="{width}" height="{}" fill="white"/>"#, MARGINS[1])?;
        }
        for (k, Stroke { colour, width, look }) in self.strokes.iter().enumerate() {
            if *look != Look::Links {
                continue;
            }
            let radius = 0.85 * width;
            writeln!(
                svg,
                r#"<marker id="j{k}" markerUnits="userSpaceOnUse" markerWidth="20" markerHeight="20" refX="10" refY="10"><circle cx="10" cy="10" r="{radius}" fill="white" stroke="{}" stroke-width="{}"/></marker>"#,
                hex(*colour),
                0.4 * width
            )?;
        }
        if let Some(trace) = self.trace {
            self.trace(&mut svg, trace, frames, &again)?;
        }
        let order = self.course.order(frames.len());
        for class in ["still", "moving"] {
            writeln!(svg, r#"<g class="{class}">"#)?;
            for (k, Stroke { colour, width, look }) in self.strokes.iter().enumerate() {
                let first =
                    frames.get(self.still).map_or_else(String::new, |frame| self.points(frame[k].iter().copied()));
                let colour = hex(*colour);
                write!(svg, r#"<polyline points="{first}" "#)?;
                match look {
                    Look::Face => write!(svg, r#"style="fill:{colour}">"#)?,
                    Look::Line => write!(svg, r#"stroke="{colour}" stroke-width="{width}">"#)?,
                    Look::Links => write!(
                        svg,
                        r#"stroke="{colour}" stroke-width="{width}" marker-start="url(#j{k})" marker-mid="url(#j{k})" marker-end="url(#j{k})">"#
                    )?,
                }
                if class == "moving" {
                    let each = order.iter().filter_map(|i| frames.get(*i));
                    let all: Vec<_> = each.map(|frame| self.points(frame[k].iter().copied())).collect();
                    write!(svg, r#"<animate attributeName="points" {again} values="{}"/>"#, all.join(";"))?;
                }
                svg.push_str("</polyline>\n");
            }
            svg.push_str("</g>\n");
        }
        for place in self.ground {
            let (x, y) = self.pixel(*place);
            writeln!(svg, r#"<circle cx="{x}" cy="{y}" r="5.5" fill="{}"/>"#, hex(INK))?;
        }
        for (k, panel) in self.panels.iter().enumerate() {
            panel.write(&mut svg, k, (low + Panel::HEIGHT * k as f64, width), (self.course, &again))?;
        }
        let (low, end) = (height - 14.0, width - 20.0);
        let mut left = 20.0;
        for (name, colour) in self.legend {
            let y = low - 7.0;
            writeln!(svg, r#"<text x="{left:.0}" y="{y}" font-size="12.5" fill="{}">{name}</text>"#, hex(*colour))?;
            left += LETTER * name.chars().count() as f64 + 22.0;
        }
        let (how, shown, places) = match self.course {
            Course::Forward => ("", shown, format!(r#"values="20;{end}""#)),
            Course::ThereAndBack => {
                let [first, second, third] = Course::TURNS;
                let times = format!(r#"keyTimes="0;{first};{second};{third};1""#);
                (" there and back", shown * first, format!(r#"values="20;{end};{end};20;20" {times}"#))
            }
        };
        let pace = if (span - shown).abs() < 1e-9 {
            "as fast as in truth".to_owned()
        } else if shown < span {
            format!("{} times faster", short(span / shown))
        } else {
            format!("{} times slower", short(shown / span))
        };
        writeln!(
            svg,
            r#"<text x="{end}" y="{}" font-size="11" text-anchor="end" fill="{}">{} s{how}, {pace}</text>"#,
            low - 7.0, // the dot below touches no word
            hex(GREY),
            short(span)
        )?;
        writeln!(svg, r#"<path d="M20 {low}H{end}" stroke="{}" stroke-opacity="0.25" stroke-width="2"/>"#, hex(GREY))?;
        writeln!(
            svg,
            r#"<circle class="moving" cx="20" cy="{low}" r="4" fill="{}"><animate attributeName="cx" {again} {places}/></circle>"#,
            hex(GREY)
        )?;
        svg.push_str("</svg>\n");
        Ok(svg)
    }

    /// The way of a point, drawn as the point goes: dashes as long as the way, moved along it.
    fn trace(
        &self,
        svg: &mut String,
        (stroke, place, colour): (usize, usize, RGBColor),
        frames: &[Frame],
        again: &str,
    ) -> Drawn {
        let way: Vec<_> = frames.iter().map(|frame| frame[stroke][place]).collect();
        let mut gone = vec![0.0];
        for pair in way.windows(2) {
            let ((a, b), (c, d)) = (self.pixel(pair[0]), self.pixel(pair[1]));
            gone.push(gone[gone.len() - 1] + (c - a).hypot(d - b));
        }
        let all = gone[gone.len() - 1].max(f64::MIN_POSITIVE);
        let points = self.points(way);
        let line = format!(r#"points="{points}" stroke="{}" stroke-width="1.3" stroke-opacity="0.75""#, hex(colour));
        let left: Vec<_> = gone.iter().map(|gone| format!("{:.0}", all - gone)).collect();
        let beyond = all + 20.0; // browsers round lengths: no next dash at the end of the way
        writeln!(svg, r#"<polyline class="still" {line}/>"#)?;
        writeln!(
            svg,
            r#"<polyline class="moving" {line} stroke-dasharray="{all:.0} {beyond:.0}" stroke-dashoffset="{all:.0}"><animate attributeName="stroke-dashoffset" {again} values="{}"/></polyline>"#,
            left.join(";")
        )?;
        Ok(())
    }
}

pub fn hex(RGBColor(r, g, b): RGBColor) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// A number of few digits.
pub fn short(x: f64) -> String {
    let text = format!("{x:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
