//! Pictures of the example `spatial_loop`.

use crate::common::film::Film;
use crate::common::{self, BLUE, Drawn, FAINT, GREEN, INK, ORANGE, blend, line};
use crate::{FAR, Reading};
use nalgebra::Vector3;
use std::path::PathBuf;

/// A place as seen from a height, aslant.
fn seen(place: &Vector3<f64>) -> (f64, f64) {
    (0.95 * place.x - 0.3 * place.y, 0.9 * place.z + 0.15 * place.x + 0.4 * place.y)
}

/// The linkage and the paths of its balls on the left; rates and forces over time on the right.
pub fn draw(readings: &[Reading]) -> Drawn<PathBuf> {
    common::picture("spatial_loop", (1000, 560), |area| {
        let subtitle = "A crank about z, a coupler between two balls, a rocker about a skew axis; released at rest.";
        let area = common::heading(area, "Spatial four-bar linkage", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(470.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));

        let all = readings.iter().flat_map(|reading| reading.places.iter().map(seen)).chain([(0.0, 0.0)]);
        let (xs, ys): (Vec<_>, Vec<_>) = all.unzip();
        let (xs, ys) = (common::range(xs, 0.1), common::range(ys, 0.1));
        let mut path = common::chart(&left, "First second (every 0.1 s) and paths of balls, aslant (m)", "", xs, ys)?;
        let swing: Vec<_> = readings.iter().take(101).step_by(10).collect();
        let far = seen(&Vector3::from(FAR));
        for (k, reading) in swing.iter().enumerate() {
            let share = k as f64 / (swing.len() - 1) as f64;
            let [crank, coupler] = reading.places.each_ref().map(seen);
            let colour = blend(FAINT, INK, 0.1 + 0.7 * share * share);
            common::links(&mut path, vec![(0.0, 0.0), crank, coupler, far], line(colour, 3.0))?;
            common::dots(&mut path, [crank, coupler], 4.0, colour)?;
        }
        for (end, colour) in [(0, ORANGE), (1, GREEN)] {
            let places = readings.iter().map(|reading| seen(&reading.places[end]));
            common::curve(&mut path, places, line(colour, 1.2))?;
        }
        common::dots(&mut path, [(0.0, 0.0), far], 5.0, INK)?;

        let names = [("crank", BLUE), ("rocker", ORANGE)];
        let all = readings.iter().flat_map(|reading| reading.rates);
        let mut rates = common::chart(&upper, "Rates (rad/s)", "time (s)", 0.0..10.0, common::range(all, 0.08))?;
        common::legend(&upper, &names)?;
        for (k, (_, colour)) in names.into_iter().enumerate() {
            common::curve(&mut rates, readings.iter().map(|r| (r.time, r.rates[k])), line(colour, 1.6))?;
        }
        let names = [("hinge of the crank", BLUE), ("hinge of the rocker", ORANGE), ("closing ball", GREEN)];
        let all = readings.iter().flat_map(|reading| reading.forces);
        let mut forces = common::chart(&lower, "Forces (N)", "time (s)", 0.0..10.0, common::range(all, 0.08))?;
        common::legend(&lower, &names)?;
        for (k, (_, colour)) in names.into_iter().enumerate() {
            common::curve(&mut forces, readings.iter().map(|r| (r.time, r.forces[k])), line(colour, 1.2))?;
        }
        Ok(())
    })
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
        strokes: &[(BLUE, 7.0), (INK, 7.0), (GREEN, 7.0)],
        trace: (1, 1, ORANGE),
        ground: &[(0.0, 0.0), seen(&Vector3::from(FAR))],
        floor: &[],
    };
    film.save("spatial_loop_moving", &frames)
}
