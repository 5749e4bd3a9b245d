//! Pictures of the example `network`.

use crate::Reading;
use crate::common::film::{Film, Stroke};
use crate::common::linkage::Linkage;
use crate::common::{BLUE, Drawn, GREEN, INK, ORANGE};
use std::path::PathBuf;

/// The first swing on the left; angles and forces over time on the right.
pub fn draw(readings: &[Reading]) -> Drawn<PathBuf> {
    let poses = readings.iter().take(101).step_by(10).map(|now| {
        let [fork, knee, end, other, _] = now.places;
        (vec![(0.0, 0.0), fork, knee, end, other, fork], vec![fork, knee, end, other])
    });
    let names = [("stem", BLUE), ("main arm", ORANGE), ("side arm", GREEN), ("where they meet", INK)];
    let angles = [0, 1, 3].into_iter().zip(names);
    let angles =
        angles.map(|(k, (name, colour))| (name, colour, readings.iter().map(|r| (r.time, r.angles[k])).collect()));
    let forces = names.into_iter().enumerate();
    let forces =
        forces.map(|(k, (name, colour))| (name, colour, readings.iter().map(|r| (r.time, r.forces[k])).collect()));
    let linkage = Linkage {
        name: "network",
        title: "Network",
        subtitle: "A stem of 0.8 m carries arms of 0.6 + 0.5 m and 0.45 + 0.55 m whose ends are joined; released at rest.",
        view: (-1.6..1.4, -2.2..0.4),
        above: "First second (every 0.1 s) and path of the end (m)",
        ground: &[(0.0, 0.0)],
        poses: poses.collect(),
        paths: vec![(ORANGE, readings.iter().take(401).map(|now| now.places[2]).collect())],
        charts: [("Angles of first rods (rad)", angles.collect()), ("Forces in pins (N)", forces.collect())],
    };
    linkage.draw()
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
        strokes: &[Stroke::links(INK, 7.0), Stroke::links(GREEN, 6.0), Stroke::links(BLUE, 6.0)],
        trace: Some((2, 2, ORANGE)),
        ground: &[(0.0, 0.0)],
        ..Film::default()
    };
    film.save("network_moving", &frames)
}
