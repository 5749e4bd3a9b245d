//! Pictures of the example `paper_figure_10`.

use crate::common::{self, BLUE, Drawn, GREEN, GREY, INK, ORANGE};
use plotters::style::RGBColor;
use std::path::PathBuf;

const RED: RGBColor = RGBColor(176, 32, 60);

pub fn draw(curves: [Vec<(f64, f64)>; 6]) -> Drawn<PathBuf> {
    common::picture("paper_figure_10", (900, 520), |area| {
        let subtitle = "n rods of 1/n m and 1/n kg with springs of 20 N·m/rad between them. Global equations: formed and factorised anew.";
        let area = common::heading(area, "Figure 10: time of a step against the number of bodies", subtitle)?;
        let names =
            ["paper, product", "paper, Riccati", "joint coordinates", "this crate", "global, dense", "global, blocks"];
        let colours = [ORANGE, GREEN, INK, BLUE, GREY, RED];
        let mut chart = common::log_log(&area, "Time of a step (µs)", "number of bodies", 0.0..5.2, -1.0..6.0)?;
        common::legend(&area, &core::array::from_fn::<_, 6, _>(|k| (names[k], colours[k])))?;
        for (points, colour) in curves.into_iter().zip(colours) {
            common::dots(&mut chart, points.clone(), 3.5, colour)?;
            common::curve(&mut chart, points, common::line(colour, 1.8))?;
        }
        Ok(())
    })
}
