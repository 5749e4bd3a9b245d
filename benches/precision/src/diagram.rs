//! The diagram of work against precision.

use super::{Point, Scene, Series};
use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;
use std::path::Path;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Time and sweeps against error, and which line is whose.
pub fn draw(path: &Path, scene: &Scene) -> Result<(), Box<dyn Error>> {
    let named = scene.series.iter().filter(|series| series.scalar == "f64").count() as u32;
    let root = SVGBackend::new(path, (1400, 600.max(90 + 20 * named))).into_drawing_area();
    root.fill(&WHITE)?;
    let (panels, names) = root.split_horizontally(1180);
    let (left, right) = panels.split_horizontally(590);
    panel(&left, scene, "time (ms)", |point| point.seconds * 1e3)?;
    panel(&right, scene, "sweeps", |point| point.sweeps as f64)?;
    let font = ("sans-serif", 13);
    let mut y = 50;
    for series in scene.series.iter().filter(|series| series.scalar == "f64") {
        let name = series.name();
        let parts: &[[i32; 2]] = if series.rival.is_none() { &[[4, 26]] } else { &[[4, 9], [13, 18], [22, 27]] };
        for [from, to] in parts {
            names.draw(&PathElement::new([(*from, y + 6), (*to, y + 6)], colour(series).stroke_width(2)))?;
        }
        names.draw(&Text::new(name.trim_end_matches(" f64").to_owned(), (32, y), font))?;
        y += 20;
    }
    if scene.series.iter().any(|series| series.scalar == "f32") {
        names.draw(&Text::new("pale: f32", (32, y + 6), font))?;
    }
    root.present()?;
    Ok(())
}

/// One colour a rule, one a library of others, whose rules of lower order are lighter; single precision is pale.
fn colour(series: &Series) -> RGBAColor {
    let colour = match (series.rival.as_deref().unwrap_or(&series.rule), series.control) {
        ("Pinocchio", _) => RGBColor(0, 158, 115),
        ("Pinocchio native", _) => RGBColor(0, 95, 70),
        ("Drake", _) => RGBColor(140, 90, 40),
        ("Exudyn", _) => RGBColor(235, 120, 110),
        ("heyoka", _) => RGBColor(20, 40, 200),
        ("phyz", _) => RGBColor(110, 180, 30),
        ("ode_solvers by hand", _) => RGBColor(255, 110, 0),
        ("MuJoCo", _) => RGBColor(204, 121, 167),
        ("RK4", _) => RGBColor(0, 0, 0),
        ("DOPRI5", "fixed") => RGBColor(86, 180, 233),
        ("DOPRI5", _) => RGBColor(0, 114, 178),
        ("DOP853", "fixed") => RGBColor(230, 159, 0),
        ("DOP853", _) => RGBColor(213, 94, 0),
        ("Adams", "fixed") => RGBColor(190, 190, 120),
        ("Adams", _) => RGBColor(130, 130, 40),
        ("Vcabm", _) => RGBColor(120, 60, 160),
        ("Taylor 24", _) => RGBColor(200, 0, 60),
        ("generalised-alpha", "fixed") => RGBColor(170, 170, 170),
        ("generalised-alpha", _) => RGBColor(100, 100, 100),
        ("SDIRK4", "fixed") => RGBColor(150, 210, 170),
        ("Auto", _) => RGBColor(30, 30, 90),
        ("AutoTaylor 24", _) => RGBColor(230, 110, 150),
        _ => RGBColor(40, 140, 80),
    };
    let lower = series.rival.is_some() && ["RK4", "RK44", "runge_kutta3"].contains(&series.rule.as_str());
    colour.mix(if series.scalar == "f32" {
        0.25
    } else if lower {
        0.55
    } else {
        1.0
    })
}

fn panel(area: &Area<'_>, scene: &Scene, work: &str, value: impl Fn(&Point) -> f64) -> Result<(), Box<dyn Error>> {
    let shown = |point: &&Point| point.error.is_finite() && point.error < 1.0 && value(point) > 0.0;
    let all = || scene.series.iter().flat_map(|series| &series.points).filter(&shown).map(&value);
    let (low, high) = all().fold((f64::INFINITY, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
    let caption = format!("{}: {work} against error", scene.name);
    let mut chart = ChartBuilder::on(area)
        .caption(caption, ("sans-serif", 18))
        .margin(12)
        .x_label_area_size(40)
        .y_label_area_size(70)
        .build_cartesian_2d((1e-13..1.0).log_scale(), (0.8 * low..1.25 * high).log_scale())?;
    let power = |x: &f64| format!("{x:.0e}");
    let mut mesh = chart.configure_mesh();
    mesh.x_desc(format!("error ({})", scene.unit))
        .y_desc(work)
        .x_label_formatter(&power)
        .y_label_formatter(&power)
        .draw()?;
    for series in &scene.series {
        let colour = colour(series);
        let points: Vec<(f64, f64)> =
            series.points.iter().filter(&shown).map(|point| (point.error.max(1e-13), value(point))).collect();
        if series.rival.is_none() {
            chart.draw_series(LineSeries::new(points.clone(), colour.stroke_width(2)))?;
        } else {
            chart.draw_series(DashedLineSeries::new(points.clone(), 5, 4, colour.stroke_width(2)))?;
        }
        chart.draw_series(points.into_iter().map(|point| Circle::new(point, 2, colour.filled())))?;
    }
    Ok(())
}
