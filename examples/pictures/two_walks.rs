//! Pictures of the example `two_walks`.

use crate::common::film::{Film, Frame, Stroke};
use crate::common::{BLUE, Drawn, GREEN, ORANGE, blend};
use crate::{LENGTH, Sweep};
use nalgebra::{Matrix2, Vector2};
use plotters::style::WHITE;
use std::f64::consts::TAU;
use std::path::PathBuf;

/// Length of an arrow for an acceleration (m per m/s²), and of an axis for an inertia (m/kg).
const ARROW: f64 = 0.02;
const AXIS: f64 = 0.3;
/// Instants apart from one sweep that is shown to the next, and how many frames each walk takes.
const APART: usize = 3;
const WALK: usize = 5;

type Point = [f64; 2];

fn between(a: Point, b: Point, share: f64) -> Point {
    [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]
}

fn circle([x, y]: Point, radius: f64, corners: u32) -> Vec<(f64, f64)> {
    let turns = (0..corners).map(|k| f64::from(k) * TAU / f64::from(corners));
    turns.map(|turn| (x + radius * turn.cos(), y + radius * turn.sin())).collect()
}

/// The inertia that a hand would feel at a point: S u for all directions u, as far as it has grown.
fn felt([x, y]: Point, inertia: &Matrix2<f64>, grown: f64) -> Vec<(f64, f64)> {
    let force = |(a, b): (f64, f64)| AXIS * grown * (inertia * Vector2::new(a, b));
    circle([0.0; 2], 1.0, 14).into_iter().map(force).map(|force| (x + force.x, y + force.y)).collect()
}

/// An arrow from a point, as far as it has grown.
fn arrow([x, y]: Point, [a, b]: Point, grown: f64) -> Vec<(f64, f64)> {
    let (a, b) = (ARROW * grown * a, ARROW * grown * b);
    let barb = |side: f64| (x + 0.8 * a - 0.1 * side * b, y + 0.8 * b + 0.1 * side * a);
    vec![(x, y), (x + a, y + b), barb(1.0), (x + a, y + b), barb(-1.0)]
}

/// The pendulum from sweep to sweep: in each the walk inward and that outward, then it moves on.
pub fn film(sweeps: &[Sweep]) -> Drawn<PathBuf> {
    let mut frames = vec![];
    for (k, sweep) in sweeps.iter().enumerate().take(9 * APART) {
        let mut places = [[0.0; 2]; 3];
        for (i, angle) in sweep.angles.iter().enumerate() {
            places[i + 1] = [places[i][0] + LENGTH * angle.cos(), places[i][1] + LENGTH * angle.sin()];
        }
        let frame = |inward: f64, outward: f64| -> Frame {
            // Each walk passes two rods; beyond that it is over.
            let at = |passed: f64| {
                let rod = if passed < 1.0 { 0 } else { 1 };
                between(places[rod], places[rod + 1], (passed - rod as f64).clamp(0.0, 1.0))
            };
            let dot =
                |rods: f64, passed: f64| circle(at(rods), 0.06 * (4.0 * passed.min(2.0 - passed)).clamp(0.0, 1.0), 8);
            let [root, elbow] = &sweep.relations;
            let [first, second] = sweep.accelerations.map(<[f64; 2]>::from);
            let gone = |passed: f64| (passed - 1.0).clamp(0.0, 1.0);
            vec![
                felt(places[0], &root.inertia, (3.0 * gone(inward)).min(1.0)),
                felt(places[1], &elbow.inertia, (3.0 * inward.clamp(0.0, 1.0) - 2.0).max(0.0)),
                arrow(places[1], first, (3.0 * outward.clamp(0.0, 1.0) - 2.0).max(0.0)),
                arrow(places[2], second, (3.0 * gone(outward) - 2.0).max(0.0)),
                places.map(|[x, y]| (x, y)).to_vec(),
                dot(2.0 - inward, inward + 0.25),
                dot(outward, outward),
            ]
        };
        if k % APART != 0 {
            frames.push(frame(0.0, -1.0));
            continue;
        }
        let walk = |i: usize| 2.0 * i as f64 / WALK as f64;
        frames.extend((0..=WALK).map(|i| frame(walk(i), -1.0)));
        frames.extend((0..=WALK + 1).map(|i| frame(2.01, walk(i))));
    }
    let film = Film {
        title: "Two walks",
        subtitle: "A sweep goes in from the tip, and out again from the root.",
        view: (-1.7..2.05, -2.0..1.75),
        scale: 134.0,
        seconds: [1.3, 18.0],
        strokes: &[
            Stroke::face(blend(WHITE, GREEN, 0.3)),
            Stroke::face(blend(WHITE, GREEN, 0.3)),
            Stroke::line(ORANGE, 2.5),
            Stroke::line(ORANGE, 2.5),
            Stroke::links(BLUE, 7.0),
            Stroke::face(GREEN),
            Stroke::face(ORANGE),
        ],
        still: 2 * WALK + 1,
        ground: &[(0.0, 0.0)],
        legend: &[("in: inertia felt, gains kept", GREEN), ("out: accelerations", ORANGE)],
        ..Film::default()
    };
    film.save("two_walks_moving", &frames)
}
