//! Pictures of the example `heavy_top`.

use crate::Reading;
use crate::common::camera::Camera;
use crate::common::film::{Film, Frame, Stroke};
use crate::common::{self, BLUE, Drawn, FAINT, GREEN, GREY, INK, ORANGE, blend, line};
use nalgebra::Vector3;
use std::f64::consts::TAU;
use std::path::PathBuf;

/// Radius of the disc on the arm (m): its inertia about the axis is ½ m R², that about a diameter ¼ m R².
const DISC: f64 = 0.25;
/// Height of the pivot above the floor, and the eye (m).
const PIVOT: [f64; 3] = [0.0, 0.0, 1.2];
const EYE: [f64; 3] = [-1.2, -3.6, 2.4];

/// The path of the mass centre from above and its height; the energy error.
pub fn draw(readings: &[Reading], initial: f64, steps: usize) -> Drawn<PathBuf> {
    common::picture("heavy_top", (1000, 560), |area| {
        let subtitle = format!(
            "15 kg on an arm of 1 m, 150 rad/s about its axis. 2 s in {steps} steps of DOP853, tolerance 1e-12."
        );
        let area = common::heading(area, "Heavy top", &subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(490.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));

        let title = "Mass centre from above, x and y (m)";
        let mut path = common::chart(&left, title, "", -1.12..1.12, -1.12..1.12)?;
        common::curve(&mut path, readings.iter().map(|now| (now.centre.x, now.centre.y)), line(BLUE, 1.4))?;
        common::dots(&mut path, [(0.0, 0.0)], 5.0, INK)?;

        let heights = readings.iter().map(|now| now.centre.z);
        let mut height = common::chart(&upper, "Height (m)", "time (s)", 0.0..2.0, common::range(heights, 0.08))?;
        common::curve(&mut height, readings.iter().map(|now| (now.time, now.centre.z)), line(ORANGE, 1.6))?;

        let points = readings.iter().map(|now| (now.time, (now.energy / initial - 1.0) * 1e12));
        let range = common::range(points.clone().map(|(_, error)| error), 0.15);
        let mut error = common::chart(&lower, "Energy error (10⁻¹² of the energy)", "time (s)", 0.0..2.0, range)?;
        common::curve(&mut error, points, line(GREEN, 1.4))
    })
}

/// The disc on its arm as it moves, in perspective and slowed down; its spin, 150 rad/s, is too fast to be shown.
pub fn film(readings: &[Reading]) -> Drawn<PathBuf> {
    let camera = Camera::new(EYE, [0.0, 0.0, 0.9]);
    let frames: Vec<Frame> = readings
        .iter()
        .step_by(8)
        .map(|now| {
            let (centre, axis) = (now.centre + Vector3::from(PIVOT), now.centre.normalize());
            let side = axis.cross(&Vector3::z()).normalize();
            let across = axis.cross(&side);
            let rim = (0..24).map(|k| f64::from(k) * TAU / 24.0);
            let rim = rim.map(|turn| centre + DISC * (side * turn.cos() + across * turn.sin()));
            let rim: Vec<_> = rim.map(|place| camera.sees(place.into())).collect();
            // One of its sides is seen, and the other one is a point behind it; the arm hides behind the far one.
            let (seen, far) = (camera.sees(centre.into()), axis.dot(&(Vector3::from(EYE) - centre)) > 0.0);
            let hidden = vec![seen; rim.len()];
            let arm = vec![camera.sees(PIVOT), seen];
            let (behind, before) = if far { (arm, vec![seen; 2]) } else { (vec![seen; 2], arm) };
            let (outer, inner) = if far { (rim, hidden) } else { (hidden, rim) };
            vec![behind, outer, inner, before, vec![seen; 2]]
        })
        .collect();
    let floor = camera.floor([[-1.2, -1.2], [1.2, 1.2]], 0.4);
    let film = Film {
        title: "Heavy top",
        subtitle: "A disc of 15 kg spins at 150 rad/s on an arm of 1 m.",
        view: (-1.5..1.5, -1.35..1.25),
        scale: 175.0,
        seconds: [2.0, 10.0],
        strokes: &[
            Stroke::line(GREY, 6.0),
            Stroke::face(BLUE),
            Stroke::face(blend(BLUE, FAINT, 0.45)),
            Stroke::line(GREY, 6.0),
            Stroke::line(INK, 7.0),
        ],
        trace: Some((4, 0, ORANGE)),
        ground: &[camera.sees(PIVOT)],
        floor: &floor,
        ..Film::default()
    };
    film.save("heavy_top_moving", &frames)
}
