//! Pictures of the example `four_bar`.

use crate::Reading;
use crate::common::film::Film;
use crate::common::{self, BLUE, Drawn, FAINT, GREEN, INK, ORANGE, blend, line};
use std::path::PathBuf;

/// The linkage and the path of its middle pins on the left; angles and forces over time on the right.
pub fn draw(readings: &[Reading]) -> Drawn<PathBuf> {
    common::picture("four_bar", (1000, 560), |area| {
        let subtitle =
            "A crank of 0.5 m, a coupler of 1.2 m and a rocker of 0.9 m between pins 1 m apart; released at rest.";
        let area = common::heading(area, "Four-bar linkage", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(470.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));

        let mut path =
            common::chart(&left, "First half second (every 0.05 s) and paths of pins (m)", "", -0.7..1.7, -0.95..1.75)?;
        let swing: Vec<_> = readings.iter().take(51).step_by(5).collect();
        for (k, reading) in swing.iter().enumerate() {
            let share = k as f64 / (swing.len() - 1) as f64;
            let [crank, coupler] = reading.places;
            let colour = blend(FAINT, INK, 0.1 + 0.7 * share * share);
            common::links(&mut path, vec![(0.0, 0.0), crank, coupler, (1.0, 0.0)], line(colour, 3.0))?;
            common::dots(&mut path, [crank, coupler], 4.0, colour)?;
        }
        for (end, colour) in [(0, ORANGE), (1, GREEN)] {
            let places = readings.iter().take(401).map(|reading| reading.places[end]);
            common::curve(&mut path, places, line(colour, 1.2))?;
        }
        common::dots(&mut path, [(0.0, 0.0), (1.0, 0.0)], 5.0, INK)?;

        let names = [("crank", BLUE), ("coupler", ORANGE), ("rocker", GREEN)];
        let all = readings.iter().flat_map(|reading| reading.angles);
        let mut angles = common::chart(&upper, "Angles (rad)", "time (s)", 0.0..10.0, common::range(all, 0.08))?;
        common::legend(&upper, &names)?;
        let all = readings.iter().flat_map(|reading| reading.forces);
        let mut forces = common::chart(&lower, "Forces in pins (N)", "time (s)", 0.0..10.0, common::range(all, 0.08))?;
        common::legend(&lower, &[("of the crank", BLUE), ("of the rocker", ORANGE), ("closing", GREEN)])?;
        for (k, (_, colour)) in names.into_iter().enumerate() {
            common::curve(&mut angles, readings.iter().map(|r| (r.time, r.angles[k])), line(colour, 1.6))?;
            common::curve(&mut forces, readings.iter().map(|r| (r.time, r.forces[k])), line(colour, 1.2))?;
        }
        Ok(())
    })
}

/// The linkage as it moves.
pub fn film(readings: &[Reading]) -> Drawn<PathBuf> {
    let frames: Vec<_> = readings
        .iter()
        .take(601)
        .step_by(4)
        .map(|now| {
            vec![vec![(0.0, 0.0), now.places[0]], vec![now.places[0], now.places[1]], vec![now.places[1], (1.0, 0.0)]]
        })
        .collect();
    let film = Film {
        title: "Four-bar linkage",
        subtitle: "Released at rest; the way of the pin between coupler and rocker.",
        view: (-1.0..1.9, -1.0..1.6),
        scale: 165.0,
        seconds: [6.0; 2],
        strokes: &[(BLUE, 7.0), (INK, 7.0), (GREEN, 7.0)],
        trace: (1, 1, ORANGE),
        ground: &[(0.0, 0.0), (1.0, 0.0)],
        floor: &[],
    };
    film.save("four_bar_moving", &frames)
}
