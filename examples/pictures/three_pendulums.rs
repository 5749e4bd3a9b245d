//! Pictures of the example `three_pendulums`.

use crate::common::{self, BLUE, Drawn, GREEN, GREY, ORANGE, line};
use crate::{END, Reading};
use std::path::PathBuf;

/// The angles of all bodies, and how far both ways are apart.
pub fn draw(readings: &[Reading]) -> Drawn<PathBuf> {
    common::picture("three_pendulums", (1000, 620), |area| {
        let subtitle =
            "Three bodies on smooth balls, released in a horizontal row, by sweeps and by the equations (41), (42).";
        let area = common::heading(area, "Example 5 of the paper", subtitle)?;
        let (upper, lower) = area.split_vertically(common::pixels(350.0));
        let (left, right) = upper.split_horizontally(common::pixels(500.0));
        let names = [("body 2", BLUE), ("body 4", ORANGE), ("body 6", GREEN)];
        for (area, axis, title) in [(&left, 2, "Angle θ₃ (rad)"), (&right, 0, "Angle θ₁ (rad)")] {
            let all = readings.iter().flat_map(|now| now.angles.map(|angles| angles[axis]));
            let mut chart = common::chart(area, title, "time (s)", 0.0..END, common::range(all, 0.08))?;
            common::legend(area, &names)?;
            for (k, (_, colour)) in names.iter().enumerate() {
                let points = readings.iter().map(|now| (now.time, now.angles[k][axis]));
                common::curve(&mut chart, points, line(*colour, 1.8))?;
            }
        }
        let logs = |which: usize| {
            readings.iter().skip(1).map(move |now| (now.time, now.differences[which].max(1e-17).log10()))
        };
        let title = "Differences: attitudes of two runs (rad), accelerations at one state (relative)";
        let mut chart = common::powers(&lower, title, "time (s)", 0.0..END, -17.0..-11.0)?;
        common::curve(&mut chart, logs(0), line(ORANGE, 1.6))?;
        common::curve(&mut chart, logs(1), line(GREY, 1.4))?;
        common::legend(&lower, &[("attitudes", ORANGE), ("accelerations", GREY)])
    })
}
