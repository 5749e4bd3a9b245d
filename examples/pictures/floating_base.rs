//! Pictures of the example `floating_base`.

use crate::common::film::{Film, Stroke};
use crate::common::{self, BLUE, Drawn, FAINT, GREEN, INK, ORANGE, blend, line};
use crate::{ROUND, ROUNDS, Reading};
use std::path::PathBuf;

/// One round of the arm on the left; angles over time on the right.
pub fn draw(readings: &[Reading]) -> Drawn<PathBuf> {
    common::picture("floating_base", (1000, 560), |area| {
        let subtitle = "A disc of 40 kg, two rods of 8 kg; motors in both joints. Neither momentum changes, and yet the hub turns.";
        let area = common::heading(area, "A satellite turns itself with its arm", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(480.0));
        let mut round = common::chart(&left, "The first round (m)", "", -0.5..2.7, -1.2..2.1)?;
        common::legend(&left, &[("hub", INK), ("arm", BLUE), ("way of the hand", ORANGE)])?;
        for (k, now) in readings.iter().take(61).step_by(10).enumerate() {
            let shade = blend(FAINT, BLUE, 0.1 + 0.15 * k as f64);
            common::links(&mut round, now.places[1..].to_vec(), line(shade, 3.0))?;
            common::links(&mut round, now.places[..2].to_vec(), line(blend(FAINT, INK, 0.1 + 0.15 * k as f64), 6.0))?;
        }
        common::curve(&mut round, readings.iter().take(61).map(|now| now.places[3]), line(ORANGE, 1.4))?;

        let degrees = |k: usize, now: &Reading| [now.hub, now.joints[0], now.joints[1]][k].to_degrees();
        let end = ROUND * ROUNDS as f64;
        let mut angles = common::chart(&right, "Angles (degrees)", "time (s)", 0.0..end, -140.0..185.0)?;
        let names = [("hub", INK), ("shoulder", BLUE), ("elbow", GREEN)];
        common::legend(&right, &names)?;
        for k in [1, 2, 0] {
            let points = readings.iter().map(|now| (now.time, degrees(k, now)));
            common::curve(&mut angles, points, line(names[k].1, if k == 0 { 2.4 } else { 1.0 }))?;
        }
        Ok(())
    })
}

/// Hub and arm as they move.
pub fn film(readings: &[Reading]) -> Drawn<PathBuf> {
    let frames: Vec<_> = readings.iter().map(|now| vec![now.places[1..].to_vec(), now.places[..2].to_vec()]).collect();
    let film = Film {
        title: "A satellite turns itself",
        subtitle: "Nothing holds it: the arm goes round, and the hub turns.",
        view: (-0.7..2.8, -1.0..2.3),
        scale: 135.0,
        seconds: [ROUND * ROUNDS as f64, 12.0],
        strokes: &[Stroke::links(BLUE, 7.0), Stroke::links(INK, 8.5)],
        trace: Some((0, 2, ORANGE)),
        ..Film::default()
    };
    film.save("floating_base_moving", &frames)
}
