//! Pictures of the example `four_bar`.

use crate::Reading;
use crate::common::film::{Film, Stroke};
use crate::common::linkage::Linkage;
use crate::common::{BLUE, Drawn, GREEN, INK, ORANGE};
use std::path::PathBuf;

const GROUND: [(f64, f64); 2] = [(0.0, 0.0), (1.0, 0.0)];

/// The linkage and the path of its middle pins on the left; angles and forces over time on the right.
pub fn draw(readings: &[Reading]) -> Drawn<PathBuf> {
    let poses = readings.iter().take(51).step_by(5).map(|now| {
        let [crank, coupler] = now.places;
        (vec![GROUND[0], crank, coupler, GROUND[1]], vec![crank, coupler])
    });
    let path = |end: usize| readings.iter().take(401).map(|now| now.places[end]).collect();
    let angles = |k: usize| readings.iter().map(|now| (now.time, now.angles[k])).collect();
    let forces = |k: usize| readings.iter().map(|now| (now.time, now.forces[k])).collect();
    let linkage = Linkage {
        name: "four_bar",
        title: "Four-bar linkage",
        subtitle: "A crank of 0.5 m, a coupler of 1.2 m and a rocker of 0.9 m between pins 1 m apart; released at rest.",
        view: (-0.7..1.7, -0.95..1.75),
        above: "First half second (every 0.05 s) and paths of pins (m)",
        ground: &GROUND,
        poses: poses.collect(),
        paths: vec![(ORANGE, path(0)), (GREEN, path(1))],
        charts: [
            (
                "Angles (rad)",
                vec![("crank", BLUE, angles(0)), ("coupler", ORANGE, angles(1)), ("rocker", GREEN, angles(2))],
            ),
            (
                "Forces in pins (N)",
                vec![
                    ("of the crank", BLUE, forces(0)),
                    ("of the rocker", ORANGE, forces(1)),
                    ("closing", GREEN, forces(2)),
                ],
            ),
        ],
    };
    linkage.draw()
}

/// The linkage as it moves.
pub fn film(readings: &[Reading]) -> Drawn<PathBuf> {
    let frames: Vec<_> = readings
        .iter()
        .take(601)
        .step_by(4)
        .map(|now| vec![vec![GROUND[0], now.places[0]], now.places.to_vec(), vec![now.places[1], GROUND[1]]])
        .collect();
    let film = Film {
        title: "Four-bar linkage",
        subtitle: "Released at rest; the way of the pin between coupler and rocker.",
        view: (-1.0..1.9, -1.0..1.6),
        scale: 165.0,
        seconds: [6.0; 2],
        strokes: &[Stroke::links(BLUE, 7.0), Stroke::links(INK, 7.0), Stroke::links(GREEN, 7.0)],
        trace: Some((1, 1, ORANGE)),
        ground: &GROUND,
        ..Film::default()
    };
    film.save("four_bar_moving", &frames)
}
