//! Pictures of the example `tuning`.

use crate::common::{self, BLUE, Drawn, ORANGE, line};
use crate::{N, PIECE, PLAN, THICKNESS, Thicknesses};
use std::path::PathBuf;

pub fn draw(thicknesses: &Thicknesses, at_first: &[f64], heights: &[f64]) -> Drawn<PathBuf> {
    common::picture("tuning", (760, 560), |area| {
        let subtitle = "A blade on a hub that stops: thicknesses by which its tip vibrates least, at the same mass.";
        let area = common::heading(area, "Tuning", subtitle)?;
        let (upper, lower) = area.split_vertically(common::pixels(200.0));
        let length = N as f64 * PIECE;
        let mut chart = common::chart(&upper, "Thickness (mm)", "from the hub (m)", 0.0..length, -3.0..3.0)?;
        common::legend(&upper, &[("at first", BLUE), ("tuned", ORANGE)])?;
        for (profile, colour) in [(&[THICKNESS; N], BLUE), (thicknesses, ORANGE)] {
            for side in [0.5, -0.5] {
                let edges = profile
                    .iter()
                    .enumerate()
                    .flat_map(|(i, h)| [i, i + 1].map(|k| (k as f64 * PIECE, side * 1e3 * h)));
                common::curve(&mut chart, edges, line(colour, 1.8))?;
            }
        }
        let end = PLAN.step * PLAN.steps as f64;
        let all = at_first.iter().chain(heights).map(|y| 1e3 * y);
        let mut chart = common::chart(&lower, "Tip (mm)", "time (s)", 0.0..end, common::range(all, 0.08))?;
        for (list, colour) in [(at_first, BLUE), (heights, ORANGE)] {
            let share = end / (list.len() - 1) as f64;
            let points = list.iter().enumerate().map(|(k, y)| (share * k as f64, 1e3 * y));
            common::curve(&mut chart, points, line(colour, 1.8))?;
        }
        Ok(())
    })
}
