//! Pictures of the example `spatial_loop`.

use crate::common::film::{Film, Stroke};
use crate::common::linkage::Linkage;
use crate::common::{self, BLUE, Drawn, GREEN, INK, ORANGE};
use crate::{FAR, Reading};
use nalgebra::Vector3;
use std::path::PathBuf;

/// A place as seen from a height, aslant.
fn seen(place: &Vector3<f64>) -> (f64, f64) {
    (0.95 * place.x - 0.3 * place.y, 0.9 * place.z + 0.15 * place.x + 0.4 * place.y)
}

/// The linkage and the paths of its balls on the left; rates and forces over time on the right.
pub fn draw(readings: &[Reading]) -> Drawn<PathBuf> {
    let far = seen(&Vector3::from(FAR));
    let poses = readings.iter().take(101).step_by(10).map(|now| {
        let [crank, coupler] = now.places.each_ref().map(seen);
        (vec![(0.0, 0.0), crank, coupler, far], vec![crank, coupler])
    });
    let path = |end: usize| -> Vec<_> { readings.iter().map(|now| seen(&now.places[end])).collect() };
    let (xs, ys): (Vec<_>, Vec<_>) = path(0).into_iter().chain(path(1)).chain([(0.0, 0.0)]).unzip();
    let rates = |k: usize| readings.iter().map(|now| (now.time, now.rates[k])).collect();
    let forces = |k: usize| readings.iter().map(|now| (now.time, now.forces[k])).collect();
    let linkage = Linkage {
        name: "spatial_loop",
        title: "Spatial four-bar linkage",
        subtitle: "A crank about z, a coupler between two balls, a rocker about a skew axis; released at rest.",
        view: (common::range(xs, 0.1), common::range(ys, 0.1)),
        above: "First second (every 0.1 s) and paths of balls, aslant (m)",
        ground: &[(0.0, 0.0), far],
        poses: poses.collect(),
        paths: vec![(ORANGE, path(0)), (GREEN, path(1))],
        charts: [
            ("Rates (rad/s)", vec![("crank", BLUE, rates(0)), ("rocker", ORANGE, rates(1))]),
            (
                "Forces (N)",
                vec![
                    ("hinge of the crank", BLUE, forces(0)),
                    ("hinge of the rocker", ORANGE, forces(1)),
                    ("closing ball", GREEN, forces(2)),
                ],
            ),
        ],
    };
    linkage.draw()
}

/// The linkage as it moves, seen aslant.
pub fn film(readings: &[Reading]) -> Drawn<PathBuf> {
    let frames: Vec<_> = readings
        .iter()
        .take(801)
        .step_by(4)
        .map(|now| {
            let [crank, coupler] = now.places.each_ref().map(seen);
            vec![vec![(0.0, 0.0), crank], vec![crank, coupler], vec![coupler, seen(&Vector3::from(FAR))]]
        })
        .collect();
    let film = Film {
        title: "Spatial four-bar linkage",
        subtitle: "Crank, coupler between two balls, rocker about a skew axis.",
        view: (-0.6..1.6, -0.75..1.05),
        scale: 220.0,
        seconds: [8.0; 2],
        strokes: &[Stroke::links(BLUE, 7.0), Stroke::links(INK, 7.0), Stroke::links(GREEN, 7.0)],
        trace: Some((1, 1, ORANGE)),
        ground: &[(0.0, 0.0), seen(&Vector3::from(FAR))],
        ..Film::default()
    };
    film.save("spatial_loop_moving", &frames)
}
