//! Pictures of mechanisms that swing: their first poses and the paths of joints on the left, two charts over time on the right.

use super::{Area, Drawn, FAINT, INK, blend, chart, curve, dots, heading, legend, line, links, picture, pixels, range};
use plotters::style::RGBColor;
use std::ops::Range;
use std::path::PathBuf;

type Points = Vec<(f64, f64)>;

/// A name, a colour, and points over time.
pub type Series<'a> = (&'a str, RGBColor, Points);

/// What is drawn of a mechanism.
pub struct Linkage<'a> {
    /// Of the file and at the head of the picture.
    pub name: &'a str,
    pub title: &'a str,
    pub subtitle: &'a str,
    /// What is seen of the plane (m), and its title.
    pub view: (Range<f64>, Range<f64>),
    pub above: &'a str,
    /// Points that the ground holds.
    pub ground: &'a [(f64, f64)],
    /// Links from joint to joint and the joints that move, the earliest instant first.
    pub poses: Vec<(Points, Points)>,
    pub paths: Vec<(RGBColor, Points)>,
    /// Titles and curves of the charts on the right, the upper one first.
    pub charts: [(&'a str, Vec<Series<'a>>); 2],
}

impl Linkage<'_> {
    /// Draws it into target/ and returns where it is.
    pub fn draw(&self) -> Drawn<PathBuf> {
        picture(self.name, (1000, 560), |area| {
            let area = heading(area, self.title, self.subtitle)?;
            let (left, right) = area.split_horizontally(pixels(470.0));
            let (upper, lower) = right.split_vertically(pixels(250.0));
            let mut path = chart(&left, self.above, "", self.view.0.clone(), self.view.1.clone())?;
            for (k, (points, moving)) in self.poses.iter().enumerate() {
                let share = k as f64 / (self.poses.len() - 1).max(1) as f64;
                let colour = blend(FAINT, INK, 0.1 + 0.7 * share * share);
                links(&mut path, points.clone(), line(colour, 3.0))?;
                dots(&mut path, moving.iter().copied(), 4.0, colour)?;
            }
            for (colour, points) in &self.paths {
                curve(&mut path, points.iter().copied(), line(*colour, 1.2))?;
            }
            dots(&mut path, self.ground.iter().copied(), 5.0, INK)?;
            for ((area, (title, series)), width) in [upper, lower].iter().zip(&self.charts).zip([1.6, 1.2]) {
                over_time(area, title, series, width)?;
            }
            Ok(())
        })
    }
}

/// A chart of series over time, as wide as their range, with lines of a width (pixels).
fn over_time(area: &Area, title: &str, series: &[Series], width: f64) -> Drawn {
    let all = || series.iter().flat_map(|(.., points)| points.iter().copied());
    let [times, values] = [range(all().map(|p| p.0), 0.0), range(all().map(|p| p.1), 0.08)];
    let mut chart = chart(area, title, "time (s)", times, values)?;
    legend(area, &series.iter().map(|(name, colour, _)| (*name, *colour)).collect::<Vec<_>>())?;
    for (_, colour, points) in series {
        curve(&mut chart, points.iter().copied(), line(*colour, width))?;
    }
    Ok(())
}
