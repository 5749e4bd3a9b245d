//! Pictures of the example `held_beam`.

use crate::common::{self, BLUE, Drawn, FAINT, GREEN, GREY, INK, ORANGE, blend, line};
use crate::{K, LENGTH, Record, TIMES};
use std::path::PathBuf;

/// Shapes on the left; deflection and reactions over time on the right.
pub fn draw(held: &Record, sliding: &Record) -> Drawn<PathBuf> {
    common::picture("held_beam", (1000, 560), |area| {
        let subtitle =
            format!("Steel, 1 m × 10 mm × 1 mm, in {K} segments, struck by 30 N for 2 ms. SDIRK4, steps of 0.1 ms.");
        let area = common::heading(area, "A strip clamped at both ends, struck in the middle", &subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(470.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));

        let mut shapes = common::chart(
            &left,
            "Shapes, every 1 ms of the first 12 ms (mm)",
            "along the strip (m)",
            0.0..LENGTH,
            -1.5..6.5,
        )?;
        let early: Vec<_> = held.readings.iter().take(121).step_by(10).collect();
        for (k, reading) in early.iter().enumerate() {
            let share = k as f64 / (early.len() - 1) as f64;
            let points = reading.shape.iter().map(|(x, y)| (*x, 1e3 * y));
            common::curve(&mut shapes, points, line(blend(FAINT, BLUE, 0.1 + 0.9 * share * share), 1.6))?;
        }
        let deflections = |record: &Record| -> Vec<(f64, f64)> {
            record.readings.iter().map(|now| (1e3 * now.time, 1e3 * now.middle)).collect()
        };
        let (fast, slow) = (deflections(held), deflections(sliding));
        let range = common::range(slow.iter().map(|point| point.1), 0.08);
        let mut chart =
            common::chart(&upper, "Deflection of the middle (mm)", "time (ms)", 0.0..1e3 * TIMES[0], range)?;
        common::legend(&upper, &[("both ends held", BLUE), ("an end slides", GREY)])?;
        common::curve(&mut chart, slow, line(GREY, 1.4))?;
        common::curve(&mut chart, fast, line(BLUE, 1.8))?;

        let reaction = |k: usize| held.readings.iter().map(move |now| (1e3 * now.time, now.ends[0][k]));
        let range = common::range(reaction(0).chain(reaction(1)).map(|point| point.1), 0.08);
        let mut chart =
            common::chart(&lower, "Force of the ground on the left end (N)", "time (ms)", 0.0..1e3 * TIMES[0], range)?;
        common::legend(&lower, &[("along", ORANGE), ("across", GREEN)])?;
        common::curve(&mut chart, reaction(0), line(ORANGE, 1.4))?;
        common::curve(&mut chart, reaction(1), line(GREEN, 1.4))?;
        common::dots(&mut shapes, [(0.0, 0.0), (LENGTH, 0.0)], 5.0, INK)
    })
}
