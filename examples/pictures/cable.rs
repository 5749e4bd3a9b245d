//! Pictures of the example `cable`.

use crate::common::film::{Film, Stroke};
use crate::common::panel::{Curve, Panel};
use crate::common::{BLUE, Drawn, GREEN, ORANGE};
use crate::{END, Reading};
use std::path::PathBuf;

/// The cable as it falls; its tip's speed and the pull at the hook below.
pub fn film(readings: &[Reading]) -> Drawn<PathBuf> {
    let every = |k| readings.iter().step_by(k); // the last reading is one of them
    let frames: Vec<_> = every(8).map(|now| vec![now.places.clone()]).collect();
    let curve = |name, colour, of: fn(&Reading) -> f64| Curve { name, colour, values: every(2).map(of).collect() };
    let panels = [
        Panel { title: "Speed of the tip (m/s)", curves: vec![curve("", ORANGE, |now| now.speed)], backward: false },
        Panel { title: "Pull at the hook (N)", curves: vec![curve("", GREEN, |now| now.pull)], backward: false },
    ];
    let film = Film {
        title: "A cable let go",
        subtitle: "It hangs between two hooks, and one of them lets go.",
        view: (-1.6..1.6, -2.1..0.3),
        scale: 150.0,
        seconds: [END, 4.0 * END],
        strokes: &[Stroke::line(BLUE, 4.0)],
        trace: Some((0, readings[0].places.len() - 1, ORANGE)),
        ground: &[(0.0, 0.0)],
        panels: &panels,
        ..Film::default()
    };
    film.save("cable_moving", &frames)
}
