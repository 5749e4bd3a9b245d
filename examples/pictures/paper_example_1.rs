//! Pictures of the example `paper_example_1`.

use crate::common::{self, BLUE, Drawn, GREEN, GREY, ORANGE, line};
use crate::{Instant, Record};
use std::path::PathBuf;

/// The last rod's angle over time, and the force at the root.
pub fn draw(exact: &[Instant], printed: &Record, damped: &Record, joints: &Record) -> Drawn<PathBuf> {
    common::picture("paper_example_1", (1000, 620), |area| {
        let subtitle = "Outer rod of two (1 m, 1 kg each), released at rest 60° below the horizontal. Steps of 0.01 s.";
        let area = common::heading(area, "Example 1: the paper's scheme on a rigid double pendulum", subtitle)?;
        let (upper, lower) = area.split_vertically(common::pixels(280.0));
        let names =
            [("DOP853", GREY), ("as printed, γ = ½", ORANGE), ("γ = 0.6", GREEN), ("joint coordinates, γ = ½", BLUE)];
        // Those that agree lie on each other: the wider below.
        let curves = [(&printed.instants, ORANGE, 1.4), (&damped.instants, GREEN, 4.0), (&joints.instants, BLUE, 1.4)];
        let until = 8.0;
        let mut angles = common::chart(&upper, "Angle of the outer rod (rad)", "time (s)", 0.0..until, -4.0..1.0)?;
        common::legend(&upper, &names)?;
        let near = |t: f64| t <= until;
        let points = exact.iter().filter(|now| near(now.time)).map(|now| (now.time, now.angles[1]));
        common::curve(&mut angles, points, line(GREY, 7.0))?;
        for (instants, colour, width) in curves {
            let inside = instants.iter().filter(|now| near(now.time)).take_while(|now| now.angles[1].abs() < 4.0);
            common::curve(&mut angles, inside.map(|now| (now.time, now.angles[1])), line(colour, width))?;
        }
        let title = "Vertical force at the root (N): with γ = ½ it alternates";
        let mut force = common::chart(&lower, title, "time (s)", 0.0..until, -20.0..60.0)?;
        for (instants, colour, width) in curves {
            let inside = instants.iter().filter(|now| near(now.time)).take_while(|now| now.angles[1].abs() < 4.0);
            let clipped = inside.map(|now| (now.time, now.force[1].clamp(-20.0, 60.0)));
            common::curve(&mut force, clipped, line(colour, width))?;
        }
        Ok(())
    })
}
