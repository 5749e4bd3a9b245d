//! What the examples share: the look of their pictures. No mechanics here.
#![allow(dead_code)] // each example uses its share

pub mod camera;
pub mod film;
pub mod linkage;
pub mod panel;

use plotters::chart::{ChartBuilder, ChartContext};
use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::{
    Cartesian2d, Circle, DrawingArea, IntoDrawingArea, IntoFont, LineSeries, PathElement, SVGBackend, Text,
};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontStyle, RGBColor, ShapeStyle, TextStyle, WHITE};
use std::error::Error;
use std::ops::Range;
use std::path::PathBuf;

pub const BLUE: RGBColor = RGBColor(0, 98, 165);
pub const ORANGE: RGBColor = RGBColor(214, 84, 18);
pub const GREEN: RGBColor = RGBColor(0, 135, 100);
pub const INK: RGBColor = RGBColor(31, 41, 51);
pub const GREY: RGBColor = RGBColor(123, 135, 148);
pub const FAINT: RGBColor = RGBColor(225, 229, 234);

/// The whole picture or a part of it.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// A part with axes.
pub type Chart<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;
/// What drawing may fail with.
pub type Drawn<T = ()> = Result<T, Box<dyn Error>>;

/// Plotters rounds coordinates to whole units, so a pixel is this many of them.
const FINE: i32 = 10;

/// Pixels in units of the drawing.
pub fn pixels(n: f64) -> i32 {
    (n * f64::from(FINE)).round() as i32
}

/// Draws a picture of this size (pixels) into target/ and returns where it is.
pub fn picture(name: &str, (width, height): (u32, u32), draw: impl FnOnce(&Area) -> Drawn) -> Drawn<PathBuf> {
    let mut svg = String::new();
    let fine = FINE as u32;
    {
        let area = SVGBackend::with_string(&mut svg, (width * fine, height * fine)).into_drawing_area();
        area.fill(&WHITE)?;
        draw(&area)?;
        area.present()?;
    }
    let (coarse, extra) = (format!(r#"width="{width}" height="{height}""#), r#" stroke-linejoin="round""#);
    let svg = svg.replacen(&format!(r#"width="{}" height="{}""#, width * fine, height * fine), &(coarse + extra), 1);

    save(name, &svg)
}

/// Writes a picture into target/ and returns where it is.
pub fn save(name: &str, svg: &str) -> Drawn<PathBuf> {
    // Of the repository, whichever package the example is in.
    let package = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let root = package.ancestors().find(|folder| folder.join("examples/common").is_dir());
    let folder = root.unwrap_or(&package).join("target");
    std::fs::create_dir_all(&folder)?;
    let path = folder.join(name).with_extension("svg");
    std::fs::write(&path, svg)?;
    Ok(path)
}

/// Text of a size (pixels).
pub fn font(size: f64, colour: RGBColor) -> TextStyle<'static> {
    // The factor undoes what the SVG backend does to sizes.
    let font = ("Helvetica, Arial, sans-serif", f64::from(pixels(size)) * 1.24).into_font();
    TextStyle { font, color: colour.to_backend_color(), pos: Pos::default() }
}

/// A bold line and a plain one at the top of the picture; returns the area below.
pub fn heading<'a>(area: &Area<'a>, title: &str, subtitle: &str) -> Drawn<Area<'a>> {
    let (top, rest) = area.split_vertically(pixels(66.0));
    let bold = TextStyle { font: font(21.0, INK).font.style(FontStyle::Bold), ..font(21.0, INK) };
    top.draw(&Text::new(title.to_owned(), (pixels(24.0), pixels(16.0)), bold))?;
    top.draw(&Text::new(subtitle.to_owned(), (pixels(24.0), pixels(44.0)), font(13.5, GREY)))?;
    Ok(rest)
}

/// A chart with a title above it and the name of the x axis below it.
pub fn chart<'a>(area: &Area<'a>, title: &str, x_name: &str, x: Range<f64>, y: Range<f64>) -> Drawn<Chart<'a>> {
    axes(area, title, x_name, (x, y), [number; 2])
}

/// The same of y by powers of ten: what is drawn are logarithms, what is written are powers.
pub fn powers<'a>(area: &Area<'a>, title: &str, x_name: &str, x: Range<f64>, y: Range<f64>) -> Drawn<Chart<'a>> {
    axes(area, title, x_name, (x, y), [number, power])
}

/// A chart both of whose axes are powers of ten.
pub fn log_log<'a>(area: &Area<'a>, title: &str, x_name: &str, x: Range<f64>, y: Range<f64>) -> Drawn<Chart<'a>> {
    axes(area, title, x_name, (x, y), [power; 2])
}

/// Axes whose labels are written so.
fn axes<'a>(
    area: &Area<'a>,
    title: &str,
    x_name: &str,
    (x, y): (Range<f64>, Range<f64>),
    [write_x, write_y]: [fn(f64) -> String; 2],
) -> Drawn<Chart<'a>> {
    let (width, height) = area.dim_in_pixel();
    let bold = TextStyle { font: font(14.0, INK).font.style(FontStyle::Bold), ..font(14.0, INK) };
    area.draw(&Text::new(title.to_owned(), (pixels(24.0), pixels(8.0)), bold))?;
    let right = font(12.0, GREY).pos(Pos::new(HPos::Right, VPos::Bottom));
    let corner = (width as i32 - pixels(28.0), height as i32 - pixels(2.0));
    area.draw(&Text::new(x_name.to_owned(), corner, right))?;

    let mut chart = ChartBuilder::on(area)
        .margin_left(pixels(10.0))
        .margin_right(pixels(28.0))
        .margin_top(pixels(34.0))
        .margin_bottom(pixels(14.0))
        .x_label_area_size(pixels(24.0))
        .y_label_area_size(pixels(46.0))
        .build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .light_line_style(WHITE)
        .bold_line_style(line(FAINT, 1.0))
        .axis_style(line(GREY, 1.0))
        .x_labels(7)
        .y_labels(6)
        .x_label_formatter(&|x| write_x(*x))
        .y_label_formatter(&|y| write_y(*y))
        .set_all_tick_mark_size(pixels(4.0))
        .label_style(font(12.0, GREY))
        .draw()?;
    Ok(chart)
}

/// Prints the heads of a table's columns and a line below, each as wide as its numbers are printed.
pub fn heads(columns: &[(&str, usize)]) {
    let text: String = columns.iter().map(|(head, width)| format!("  {head:>width$}")).collect();
    println!("{text}\n  {}", "-".repeat(text.chars().count().saturating_sub(2)));
}

/// A power of ten, by its exponent; none where that is not whole.
pub fn power(exponent: f64) -> String {
    let whole = exponent.round();
    if (exponent - whole).abs() > 1e-6 {
        return String::new();
    }
    let raised = |c: char| match c {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        c => char::from_u32(u32::from('⁴') + u32::from(c).saturating_sub(u32::from('4'))).unwrap_or(c),
    };
    format!("10{}", format!("{whole:.0}").chars().map(raised).collect::<String>())
}

/// A short number with a true minus sign.
pub fn number(x: f64) -> String {
    let text = format!("{:.6}", x + 0.0);
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.replace('-', "−") }
}

/// A line of a width (pixels).
pub fn line(colour: impl Color, width: f64) -> ShapeStyle {
    ShapeStyle { color: colour.to_rgba(), filled: false, stroke_width: pixels(width) as u32 }
}

/// A curve through points.
pub fn curve(chart: &mut Chart, points: impl IntoIterator<Item = (f64, f64)>, style: ShapeStyle) -> Drawn {
    chart.draw_series(LineSeries::new(points, style))?;
    Ok(())
}

/// Straight lines from point to point that may leave the axes' order: links of a mechanism.
pub fn links(chart: &mut Chart, points: Vec<(f64, f64)>, style: ShapeStyle) -> Drawn {
    chart.draw_series([PathElement::new(points, style)])?;
    Ok(())
}

/// Filled dots of a radius (pixels).
pub fn dots(chart: &mut Chart, points: impl IntoIterator<Item = (f64, f64)>, radius: f64, colour: impl Color) -> Drawn {
    chart.draw_series(points.into_iter().map(|point| Circle::new(point, pixels(radius), colour.filled())))?;
    Ok(())
}

/// The names of curves, in their colours, at the right end of the chart's title.
pub fn legend(area: &Area, names: &[(&str, RGBColor)]) -> Drawn {
    let mut right = area.dim_in_pixel().0 as i32 - pixels(28.0);
    for (name, colour) in names.iter().rev() {
        let style = font(13.0, *colour).pos(Pos::new(HPos::Right, VPos::Top));
        area.draw(&Text::new((*name).to_owned(), (right, pixels(9.0)), style))?;
        right -= pixels(18.0 + 6.8 * name.chars().count() as f64);
    }
    Ok(())
}

/// Text beside a point.
pub fn name(chart: &Chart, (x, y): (f64, f64), text: &str, colour: RGBColor) -> Drawn {
    chart.plotting_area().draw(&Text::new(text.to_owned(), (x, y), font(13.0, colour)))?;
    Ok(())
}

/// A colour between two.
pub fn blend(from: RGBColor, to: RGBColor, share: f64) -> RGBColor {
    let mix = |a: u8, b: u8| (f64::from(a) + (f64::from(b) - f64::from(a)) * share) as u8;
    RGBColor(mix(from.0, to.0), mix(from.1, to.1), mix(from.2, to.2))
}

/// The range of numbers, widened by a share of its size on both sides.
pub fn range(numbers: impl IntoIterator<Item = f64>, share: f64) -> Range<f64> {
    let (low, high) = numbers.into_iter().fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
    let slack = (high - low).max(f64::MIN_POSITIVE) * share;
    low - slack..high + slack
}

/// The slope of a straight line through points, by least squares.
pub fn slope<'p>(points: impl IntoIterator<Item = &'p (f64, f64)>) -> f64 {
    let points: Vec<_> = points.into_iter().collect();
    let count = points.len() as f64;
    let (x, y) = points.iter().fold((0.0, 0.0), |(x, y), p| (x + p.0 / count, y + p.1 / count));
    let above: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    above / points.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>()
}
