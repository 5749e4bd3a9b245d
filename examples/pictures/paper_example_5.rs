//! Pictures of the example `paper_example_5`.

use crate::Record;
use crate::common::{self, BLUE, Drawn, GREEN, GREY, ORANGE, line};
use std::path::PathBuf;

/// The angles of the three bodies, by this crate's default and by the paper's scheme at the predictor, and the force at the root, which
/// alternates as printed.
pub fn draw(exact: &Record, shown: &[Record]) -> Drawn<PathBuf> {
    common::picture("paper_example_5", (1000, 640), |area| {
        let subtitle = "Angle θ₃ of three bodies, released from a horizontal row. Wide: DOP853; thin: the paper's scheme at the predictor.";
        let area = common::heading(area, "Example 5: three bodies on smooth balls", subtitle)?;
        let (Some(printed), Some(found)) = (shown.first(), shown.get(4)) else { return Ok(()) };
        let (upper, lower) = area.split_vertically(common::pixels(340.0));
        let mut chart = common::chart(&upper, "Angle θ₃ (rad)", "time (s)", 0.0..1.0, -3.0..0.5)?;
        common::legend(&upper, &[("body 2", BLUE), ("body 4", ORANGE), ("body 6", GREEN)])?;
        for (k, colour) in [BLUE, ORANGE, GREEN].into_iter().enumerate() {
            let of = |record: &Record| record.iter().map(|(t, angles, _)| (*t, angles[k][2])).collect::<Vec<_>>();
            common::curve(&mut chart, of(exact), line(GREY, 5.0))?;
            common::curve(&mut chart, of(found), line(colour, 1.6))?;
        }
        let title = "Vertical force at the root (N)";
        let mut chart = common::chart(&lower, title, "time (s)", 0.0..1.0, -100.0..150.0)?;
        common::legend(&lower, &[("DOP853", GREY), ("as printed, γ = ½", ORANGE), ("generalised-α", BLUE)])?;
        let of = |record: &Record| record.iter().map(|(t, _, q)| (*t, q[1].clamp(-100.0, 150.0))).collect::<Vec<_>>();
        for (record, style) in [(printed, line(ORANGE, 1.0)), (exact, line(GREY, 5.0)), (found, line(BLUE, 1.6))] {
            common::curve(&mut chart, of(record), style)?;
        }
        Ok(())
    })
}
