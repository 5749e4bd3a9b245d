//! Pictures of the example `andrews_squeezer`.

use crate::Reading;
use crate::common::film::{Film, Stroke};
use crate::common::{self, BLUE, Drawn, FAINT, GREEN, INK, ORANGE, blend, line};
use crate::squeezer::{A, B, C, END};
use std::path::PathBuf;

/// The mechanism at the start and at the end and the path of E on the left; angles and forces over time on the right.
pub fn draw(readings: &[Reading]) -> Drawn<PathBuf> {
    common::picture("andrews_squeezer", (1000, 560), |area| {
        let subtitle = "Seven bodies, four arms from the ground to one point; a constant moment drives the crank.";
        let area = common::heading(area, "Andrews' squeezing mechanism", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(470.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));

        let title = "Every 2 ms from 0.012 s, path of their end (mm)";
        let mm = |(x, y): (f64, f64)| (1e3 * x, 1e3 * y);
        let ground = |[x, y]: [f64; 2]| mm((x, y));
        let mut path = common::chart(&left, title, "", -80.0..30.0, -50.0..80.0)?;
        let shown: Vec<_> = readings.iter().skip(240).step_by(40).collect();
        for (k, reading) in shown.iter().enumerate() {
            let share = k as f64 / (shown.len() - 1) as f64;
            let colour = blend(FAINT, INK, 0.1 + 0.8 * share.powi(3));
            let [k1, _, _, k5, _, k7, _] = reading.ends.map(mm);
            let meet = mm(reading.ends[1]);
            for arm in [
                vec![(0.0, 0.0), k1, meet],
                vec![ground(B), meet],
                vec![ground(A), k5, meet],
                vec![ground(A), k7, meet],
                vec![ground(B), mm(reading.hook)],
            ] {
                common::links(&mut path, arm, line(colour, 2.4))?;
            }
            common::links(&mut path, vec![ground(C), mm(reading.hook)], line(blend(FAINT, GREEN, share.powi(3)), 1.4))?;
            common::dots(&mut path, [k1, k5, k7, meet], 3.0, colour)?;
        }
        common::curve(&mut path, readings.iter().map(|reading| mm(reading.ends[1])), line(ORANGE, 1.2))?;
        common::dots(&mut path, [(0.0, 0.0), ground(A), ground(B), ground(C)], 4.5, INK)?;

        let names = [("gamma", 2, BLUE), ("Phi", 3, ORANGE), ("delta", 4, GREEN), ("epsilon", 6, INK)];
        let end = 1e3 * END;
        let all = readings.iter().flat_map(|reading| names.map(|(_, k, _)| reading.angles[k]));
        let mut angles = common::chart(&upper, "Angles (rad)", "time (ms)", 0.0..end, common::range(all, 0.08))?;
        common::legend(&upper, &names.map(|(name, _, colour)| (name, colour)))?;
        for (_, k, colour) in names {
            common::curve(&mut angles, readings.iter().map(|r| (1e3 * r.time, r.angles[k])), line(colour, 1.4))?;
        }
        let names = [("K3", BLUE), ("K4", ORANGE), ("K6", GREEN)];
        let all = readings.iter().flat_map(|reading| reading.forces);
        let title = "Forces at the point where the arms meet (N)";
        let mut forces = common::chart(&lower, title, "time (ms)", 0.0..end, common::range(all, 0.08))?;
        common::legend(&lower, &names)?;
        for (k, (_, colour)) in names.into_iter().enumerate() {
            common::curve(&mut forces, readings.iter().map(|r| (1e3 * r.time, r.forces[k])), line(colour, 1.4))?;
        }
        Ok(())
    })
}

/// The mechanism as it moves, slowed down.
pub fn film(readings: &[Reading]) -> Drawn<PathBuf> {
    let frames: Vec<_> = readings
        .iter()
        .step_by(4)
        .map(|now| {
            let [k1, _, _, k5, _, k7, _] = now.ends;
            let meet = now.ends[1];
            let ground = |[x, y]: [f64; 2]| (x, y);
            vec![
                vec![(0.0, 0.0), k1, meet],
                vec![ground(A), k5, meet],
                vec![ground(A), k7, meet],
                vec![ground(B), now.hook, meet],
                vec![ground(C), now.hook],
            ]
        })
        .collect();
    let film = Film {
        title: "Andrews' squeezing mechanism",
        subtitle: "Seven bodies meet in one point; a constant moment drives the crank.",
        view: (-0.085..0.045, -0.045..0.085),
        scale: 4000.0,
        seconds: [END, 12.0],
        strokes: &[
            Stroke::links(ORANGE, 5.0),
            Stroke::links(BLUE, 5.0),
            Stroke::links(BLUE, 5.0),
            Stroke::links(INK, 5.0),
            Stroke::links(GREEN, 2.0),
        ],
        trace: Some((0, 2, ORANGE)),
        ground: &[(0.0, 0.0), (A[0], A[1]), (B[0], B[1]), (C[0], C[1])],
        ..Film::default()
    };
    film.save("andrews_squeezer_moving", &frames)
}
