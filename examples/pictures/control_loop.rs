//! Pictures of the example `control_loop`.

use crate::common::{self, BLUE, Drawn, FAINT, GREEN, GREY, INK, ORANGE, blend, line};
use crate::{CYCLE, CYCLES, Sample};
use std::path::PathBuf;

/// The hand's way on the left; its error and the torques over time on the right.
pub fn draw(log: &[Sample]) -> Drawn<PathBuf> {
    common::picture("control_loop", (1000, 520), |area| {
        let subtitle =
            "A two-link arm goes around a circle under model-based control, with a load that the model ignores.";
        let area = common::heading(area, "Control loop", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(470.0));
        let (upper, lower) = right.split_vertically(common::pixels(227.0));

        // Curves are as smooth with every eighth sample.
        let (thin, point) = (log.iter().step_by(8), |[x, y]: [f64; 2]| (x, y));
        let mut way = common::chart(&left, "Way of the hand (m)", "", -0.1..1.15, -0.7..0.537)?;
        common::legend(&left, &[("target", GREY), ("hand", ORANGE)])?;
        let poses: Vec<_> = log.iter().take(1875).step_by(125).collect();
        // The first turn, fading in.
        for (k, sample) in poses.iter().enumerate() {
            let colour = blend(FAINT, BLUE, 0.8 * k as f64 / poses.len() as f64);
            let places = [(0.0, 0.0), point(sample.elbow), point(sample.hand)];
            common::links(&mut way, places.to_vec(), line(colour, 2.0))?;
            common::dots(&mut way, [places[1]], 3.0, colour)?;
        }
        common::curve(&mut way, thin.clone().map(|sample| point(sample.wanted)), line(GREY, 4.0))?;
        common::curve(&mut way, thin.clone().map(|sample| point(sample.hand)), line(ORANGE, 1.6))?;
        common::dots(&mut way, [(0.0, 0.0)], 5.0, INK)?;

        let end = CYCLE * CYCLES as f64;
        let errors = thin.clone().map(|sample| (sample.time, sample.error()));
        let range = common::range(errors.clone().map(|(_, error)| error), 0.08);
        let mut chart = common::chart(&upper, "Error of the hand (mm)", "time (s)", 0.0..end, range)?;
        common::curve(&mut chart, errors, line(GREEN, 1.6))?;

        let all = thin.clone().flat_map(|sample| sample.torques);
        let mut chart = common::chart(&lower, "Torques (N·m)", "time (s)", 0.0..end, common::range(all, 0.08))?;
        common::legend(&lower, &[("shoulder", BLUE), ("elbow", ORANGE)])?;
        for (joint, colour) in [BLUE, ORANGE].into_iter().enumerate() {
            common::curve(
                &mut chart,
                thin.clone().map(|sample| (sample.time, sample.torques[joint])),
                line(colour, 1.6),
            )?;
        }
        Ok(())
    })
}
