//! Pictures of the example `quadruped_stands`.

use crate::common::camera::Camera;
use crate::common::film::{Film, Frame, Stroke};
use crate::common::{BLUE, Drawn, GREY, ORANGE};
use crate::{FILMED, Sample};
use std::path::PathBuf;

/// The robot as it falls, is pushed and stands.
pub fn draw(log: &[Sample]) -> Drawn<PathBuf> {
    let camera = Camera::new([1.5, -2.2, 1.1], [0.0, 0.05, 0.3]);
    let filmed = log.iter().take_while(|sample| sample.time <= FILMED).step_by(20);
    let frames: Vec<Frame> = filmed
        .map(|sample| {
            sample.frame.iter().map(|stroke| stroke.iter().map(|place| camera.sees(*place)).collect()).collect()
        })
        .collect();
    let floor = camera.floor([[-0.8, -0.6], [0.8, 0.8]], 0.2);
    let film = Film {
        title: "Quadruped",
        subtitle: "Dropped by 25 cm, pushed from the side at 1.6 s; feet that touch, slip and stick.",
        view: (-0.85..0.85, -0.62..0.6),
        scale: 330.0,
        seconds: [FILMED; 2],
        strokes: &[
            Stroke::links(GREY, 6.0),
            Stroke::links(GREY, 6.0),
            Stroke::links(ORANGE, 8.0),
            Stroke::links(BLUE, 7.0),
            Stroke::links(BLUE, 7.0),
        ],
        trace: Some((2, 1, ORANGE)),
        floor: &floor,
        ..Film::default()
    };
    film.save("quadruped_stands", &frames)
}
