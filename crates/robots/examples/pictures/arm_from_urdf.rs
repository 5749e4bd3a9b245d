//! Pictures of the example `arm_from_urdf`.

use crate::Sample;
use crate::common::camera::Camera;
use crate::common::film::{Film, Frame, Stroke};
use crate::common::{BLUE, Drawn, ORANGE};
use std::path::PathBuf;

/// The arm as it moves.
pub fn draw(log: &[Sample]) -> Drawn<PathBuf> {
    let camera = Camera::new([2.4, -2.6, 1.6], [0.0, 0.0, 0.55]);
    let filmed = log.iter().step_by(100);
    let frames: Vec<Frame> =
        filmed.map(|sample| vec![sample.places.iter().map(|place| camera.sees(*place)).collect()]).collect();
    let floor = camera.floor([[-0.8, -0.8], [0.8, 0.8]], 0.2);
    let seconds = log.last().map_or(0.0, |sample| sample.time);
    let film = Film {
        title: "Arm from its description",
        subtitle: "Computed torque at 1 kHz; friction, motors and stops from the file.",
        view: (-1.0..1.0, -0.75..1.1),
        scale: 270.0,
        seconds: [seconds; 2],
        strokes: &[Stroke::links(BLUE, 8.0)],
        trace: Some((0, 8, ORANGE)),
        ground: &[camera.sees([0.0; 3])],
        floor: &floor,
        ..Film::default()
    };
    film.save("arm_from_urdf", &frames)
}
