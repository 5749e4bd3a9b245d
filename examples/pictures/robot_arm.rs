//! Pictures of the example `robot_arm`.

use crate::arm::{LEG, POSES};
use crate::common::film::{Film, Stroke};
use crate::common::{self, BLUE, Drawn, FAINT, GREEN, GREY, INK, ORANGE, blend, line};
use crate::{CYCLE, LOAD, Sample};
use nalgebra::Vector3;
use std::path::PathBuf;

/// A place in a parallel view, from the front and above.
fn seen(p: &Vector3<f64>) -> (f64, f64) {
    (0.8 * p.y + 0.6 * p.x, p.z + 0.25 * p.y - 0.33 * p.x)
}

/// The arm from the side and its hand's way on the left; errors and torques over time on the right.
pub fn draw(computed: &[Sample], compensated: &[Sample]) -> Drawn<PathBuf> {
    common::picture("robot_arm", (1000, 620), |area| {
        let subtitle = format!("Six revolute joints, from pose to pose with {LOAD} kg that the controllers ignore.");
        let area = common::heading(area, "Robot arm", &subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(480.0));
        let (upper, rest) = right.split_vertically(common::pixels(277.0));
        let mut way = common::chart(&left, "The arm, seen aslant (m)", "", -0.85..1.35, -0.85..1.35)?;
        common::legend(&left, &[("wanted", GREY), ("computed", BLUE), ("compensated", ORANGE)])?;
        let poses: Vec<_> = computed.iter().step_by(200).collect();
        for (k, sample) in poses.iter().enumerate() {
            let colour = blend(FAINT, INK, 0.05 + 0.6 * (k as f64 / poses.len() as f64).powi(2));
            let points: Vec<_> = [(0.0, 0.0)].into_iter().chain(sample.places.iter().map(seen)).collect();
            common::dots(&mut way, points.iter().copied().skip(1), 2.5, colour)?;
            common::links(&mut way, points, line(colour, 1.6))?;
        }
        let thin = |log: &[Sample]| log.iter().step_by(10).copied().collect::<Vec<_>>();
        let (one, two) = (thin(computed), thin(compensated));
        common::curve(&mut way, one.iter().map(|sample| seen(&sample.target)), line(GREY, 4.0))?;
        common::curve(&mut way, two.iter().map(|sample| seen(&sample.places[3])), line(ORANGE, 1.4))?;
        common::curve(&mut way, one.iter().map(|sample| seen(&sample.places[3])), line(BLUE, 1.4))?;
        common::dots(&mut way, [(0.0, 0.0)], 5.0, INK)?;

        let end = CYCLE * computed.len() as f64;
        let most = one.iter().chain(&two).map(Sample::error).fold(0.0, f64::max);
        let mut chart = common::chart(&upper, "Error of the hand (mm)", "time (s)", 0.0..end, 0.0..1.08 * most)?;
        common::legend(&upper, &[("computed torque", BLUE), ("gravity compensation", ORANGE)])?;
        for (log, colour) in [(&one, BLUE), (&two, ORANGE)] {
            common::curve(&mut chart, log.iter().map(|sample| (sample.time, sample.error())), line(colour, 1.6))?;
        }
        let range = common::range(one.iter().flat_map(|sample| sample.torques), 0.08);
        let mut chart = common::chart(&rest, "Torques, computed (N·m)", "time (s)", 0.0..end, range)?;
        common::legend(&rest, &[("turntable", BLUE), ("shoulder", ORANGE), ("elbow", GREEN), ("others", GREY)])?;
        for (k, colour) in [BLUE, ORANGE, GREEN, GREY, GREY, GREY].into_iter().enumerate() {
            common::curve(&mut chart, one.iter().map(|sample| (sample.time, sample.torques[k])), line(colour, 1.4))?;
        }
        Ok(())
    })
}

/// The arm under computed torque as it moves, seen aslant.
pub fn film(log: &[Sample]) -> Drawn<PathBuf> {
    let frames: Vec<_> = log
        .iter()
        .step_by(24)
        .map(|now| vec![[(0.0, 0.0)].into_iter().chain(now.places.iter().map(seen)).collect()])
        .collect();
    let film = Film {
        title: "Robot arm",
        subtitle: "Computed torque carries a load that the controller ignores.",
        view: (-0.9..1.4, -0.75..1.1),
        scale: 220.0,
        seconds: [LEG * (POSES.len() - 1) as f64; 2],
        strokes: &[Stroke::links(BLUE, 9.0)],
        trace: Some((0, 4, ORANGE)),
        ground: &[(0.0, 0.0)],
        ..Film::default()
    };
    film.save("robot_arm_moving", &frames)
}
