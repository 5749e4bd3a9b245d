//! Pictures of the example `double_pendulum`.

use crate::Reading;
use crate::common::film::{Film, Frame, Stroke};
use crate::common::{self, BLUE, Drawn, FAINT, GREEN, INK, ORANGE, blend, line};
use std::path::PathBuf;

/// The pendulum as it moves, released from above.
pub fn film(frames: &[Frame]) -> Drawn<PathBuf> {
    let film = Film {
        title: "Double pendulum",
        subtitle: "Two uniform rods, 1 m and 1 kg each; the way of the tip.",
        view: (-2.2..2.2, -2.15..2.15),
        scale: 110.0,
        seconds: [12.0; 2],
        strokes: &[Stroke::links(BLUE, 7.0)],
        trace: Some((0, 2, ORANGE)),
        ground: &[(0.0, 0.0)],
        ..Film::default()
    };
    film.save("double_pendulum_moving", frames)
}

/// The path of the tip on the left; angles and energy error over time on the right.
pub fn draw(readings: &[Reading], energies: &[(f64, f64)], steps: usize) -> Drawn<PathBuf> {
    common::picture("double_pendulum", (1000, 560), |area| {
        let steps = format!("10 s in {steps} steps of DOP853, tolerance 1e-13.");
        let subtitle =
            format!("Two uniform rods, 1 m and 1 kg each, released at rest 60° below the horizontal. {steps}");
        let area = common::heading(area, "Double pendulum", &subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(470.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));

        // One metre is as long across as it is down.
        let mut path =
            common::chart(&left, "First swing (every 0.1 s) and path of the tip (m)", "", -1.1..1.1, -2.2..0.205)?;
        let swing: Vec<_> = readings.iter().take(111).step_by(10).collect();
        for (k, reading) in swing.iter().enumerate() {
            let share = k as f64 / (swing.len() - 1) as f64;
            let [elbow, tip] = reading.places;
            let colour = blend(FAINT, BLUE, 0.1 + 0.9 * share * share);
            common::links(&mut path, vec![(0.0, 0.0), elbow, tip], line(colour, 3.5))?;
            common::dots(&mut path, [elbow, tip], 4.5, colour)?;
        }
        common::curve(&mut path, readings.iter().map(|reading| reading.places[1]), line(ORANGE, 1.2))?;
        common::dots(&mut path, [(0.0, 0.0)], 5.0, INK)?;

        let all = readings.iter().flat_map(|reading| reading.angles);
        let mut angles = common::chart(&upper, "Angles (rad)", "time (s)", 0.0..10.0, common::range(all, 0.08))?;
        common::legend(&upper, &[("inner rod", BLUE), ("outer rod", ORANGE)])?;
        for (k, colour) in [BLUE, ORANGE].into_iter().enumerate() {
            common::curve(
                &mut angles,
                readings.iter().map(|reading| (reading.time, reading.angles[k])),
                line(colour, 1.8),
            )?;
        }

        let points = energies.iter().map(|(time, error)| (*time, error * 1e13));
        let range = common::range(points.clone().map(|(_, error)| error), 0.15);
        let mut error = common::chart(&lower, "Energy error (10⁻¹³ J)", "time (s)", 0.0..10.0, range)?;
        common::curve(&mut error, points, line(GREEN, 1.4))
    })
}
