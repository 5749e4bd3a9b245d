//! Pictures of the example `network`.

use crate::Reading;
use crate::common::film::Film;
use crate::common::{self, BLUE, Drawn, FAINT, GREEN, INK, ORANGE, blend, line};
use std::path::PathBuf;

/// The first swing on the left; angles and forces over time on the right.
pub fn draw(readings: &[Reading]) -> Drawn<PathBuf> {
    common::picture("network", (1000, 560), |area| {
        let subtitle =
            "A stem of 0.8 m carries arms of 0.6 + 0.5 m and 0.45 + 0.55 m whose ends are joined; released at rest.";
        let area = common::heading(area, "Network", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(470.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));

        let title = "First second (every 0.1 s) and path of the end (m)";
        let mut path = common::chart(&left, title, "", -1.6..1.4, -2.2..0.4)?;
        let swing: Vec<_> = readings.iter().take(101).step_by(10).collect();
        for (k, reading) in swing.iter().enumerate() {
            let share = k as f64 / (swing.len() - 1) as f64;
            let [fork, knee, end, other, _] = reading.places;
            let colour = blend(FAINT, INK, 0.1 + 0.7 * share * share);
            common::links(&mut path, vec![(0.0, 0.0), fork, knee, end, other, fork], line(colour, 3.0))?;
            common::dots(&mut path, [fork, knee, end, other], 4.0, colour)?;
        }
        let places = readings.iter().take(401).map(|reading| reading.places[2]);
        common::curve(&mut path, places, line(ORANGE, 1.2))?;
        common::dots(&mut path, [(0.0, 0.0)], 5.0, INK)?;

        let names = [("stem", BLUE), ("main arm", ORANGE), ("side arm", GREEN), ("where they meet", INK)];
        let of = [0, 1, 3];
        let all = readings.iter().flat_map(|reading| of.map(|k| reading.angles[k]));
        let title = "Angles of first rods (rad)";
        let mut angles = common::chart(&upper, title, "time (s)", 0.0..10.0, common::range(all, 0.08))?;
        common::legend(&upper, &names[..3])?;
        let all = readings.iter().flat_map(|reading| reading.forces);
        let mut forces = common::chart(&lower, "Forces in pins (N)", "time (s)", 0.0..10.0, common::range(all, 0.08))?;
        common::legend(&lower, &names)?;
        for (k, (_, colour)) in names.into_iter().enumerate() {
            if let Some(of) = of.get(k) {
                common::curve(&mut angles, readings.iter().map(|r| (r.time, r.angles[*of])), line(colour, 1.6))?;
            }
            common::curve(&mut forces, readings.iter().map(|r| (r.time, r.forces[k])), line(colour, 1.2))?;
        }
        Ok(())
    })
}

/// The network as it moves.
pub fn film(readings: &[Reading]) -> Drawn<PathBuf> {
    let frames: Vec<_> = readings
        .iter()
        .take(801)
        .step_by(4)
        .map(|now| {
            let [fork, knee, end, other, _] = now.places;
            vec![vec![(0.0, 0.0), fork], vec![fork, other, end], vec![fork, knee, end]]
        })
        .collect();
    let film = Film {
        title: "Network",
        subtitle: "Two arms that meet again hang from a stem; released at rest.",
        view: (-1.8..1.8, -2.1..0.4),
        scale: 140.0,
        seconds: [8.0; 2],
        strokes: &[(INK, 7.0), (GREEN, 6.0), (BLUE, 6.0)],
        trace: (2, 2, ORANGE),
        ground: &[(0.0, 0.0)],
        floor: &[],
    };
    film.save("network_moving", &frames)
}
