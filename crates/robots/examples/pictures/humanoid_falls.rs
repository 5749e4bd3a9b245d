//! Pictures of the example `humanoid_falls`.

use crate::common::camera::Camera;
use crate::common::film::{Film, Frame, Stroke};
use crate::common::{BLUE, Drawn, GREY, ORANGE};
use crate::{END, Sample};
use std::path::PathBuf;

/// The robot as it falls.
pub fn draw(log: &[Sample]) -> Drawn<PathBuf> {
    let camera = Camera::new([1.7, -2.9, 1.25], [0.4, 0.05, 0.6]);
    let frames: Vec<Frame> = log
        .iter()
        .step_by(40)
        .map(|sample| {
            sample.frame.iter().map(|stroke| stroke.iter().map(|place| camera.sees(*place)).collect()).collect()
        })
        .collect();
    let floor = camera.floor([[-0.6, -0.8], [1.6, 1.0]], 0.2);
    let film = Film {
        title: "Humanoid",
        subtitle: "Motors off: friction and stops in 29 joints, 28 points that may touch the ground.",
        view: (-1.1..1.1, -0.85..1.15),
        scale: 270.0,
        seconds: [END; 2],
        strokes: &[
            Stroke::links(GREY, 6.0),
            Stroke::links(GREY, 4.0),
            Stroke::links(GREY, 5.0),
            Stroke::links(ORANGE, 7.0),
            Stroke::links(ORANGE, 6.0),
            Stroke::links(BLUE, 7.0),
            Stroke::links(BLUE, 5.0),
            Stroke::links(BLUE, 6.0),
        ],
        trace: Some((4, 1, ORANGE)),
        floor: &floor,
        ..Film::default()
    };
    film.save("humanoid_falls", &frames)
}
