//! Pictures of the example `flexible_pendulum`.

use crate::common::{self, BLUE, Drawn, FAINT, GREEN, GREY, INK, ORANGE, blend, line};
use crate::{LONG, Pendulum, Record, SHORT};
use catena::planar::Dop853;
use std::f64::consts::FRAC_PI_3;
use std::path::PathBuf;

/// The swing on the left; bend and energy errors on the right.
pub fn draw(pendulum: &Pendulum, exact: &Record, long: &[Record]) -> Drawn<PathBuf> {
    // Places of all rods every 10 ms.
    let mut shapes = vec![];
    let start = pendulum.at_rest(&[-FRAC_PI_3; 20])?;
    pendulum.simulation(Dop853::tolerance(1e-10)).every(0.01).run(start, SHORT, |now| {
        let mut shape: Vec<_> = now.bodies().iter().map(|rod| (rod.inboard.place.x, rod.inboard.place.y)).collect();
        let tip = now.stations().tip().frame.place;
        shape.push((tip.x, tip.y));
        shapes.push(shape);
    })?;
    common::picture("flexible_pendulum", (1000, 560), |area| {
        let subtitle = "Twenty rods with springs: 1 m, 1 kg and 1 N·m² in all, released straight and at rest 60° below the horizontal.";
        let area = common::heading(area, "Flexible pendulum", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(500.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));

        // One metre is as long across as it is down.
        let mut path =
            common::chart(&left, "First swing, every 50 ms, and path of the tip (m)", "", -0.6..0.6, -1.1..0.1)?;
        let swing: Vec<_> = shapes.iter().take(91).step_by(5).collect();
        for (k, shape) in swing.iter().enumerate() {
            let share = k as f64 / (swing.len() - 1) as f64;
            let colour = blend(FAINT, BLUE, 0.1 + 0.9 * share * share);
            common::links(&mut path, (*shape).clone(), line(colour, 2.2))?;
        }
        common::curve(&mut path, shapes.iter().filter_map(|shape| shape.last().copied()), line(ORANGE, 1.2))?;
        common::dots(&mut path, [(0.0, 0.0)], 5.0, INK)?;

        // Steps of 10 ms follow the bend, if not the fastest vibration.
        let bends = |record: &Record| -> Vec<(f64, f64)> {
            record.readings.iter().take_while(|now| now[0] <= SHORT).map(|[time, _, bend]| (*time, *bend)).collect()
        };
        let range = common::range(bends(exact).iter().map(|point| point.1), 0.08);
        let mut bend = common::chart(&upper, "Angle from first rod to last (rad)", "time (s)", 0.0..SHORT, range)?;
        common::legend(&upper, &[("DOP853", GREY), ("SDIRK4, 10 ms", GREEN)])?;
        common::curve(&mut bend, bends(exact), line(GREY, 2.4))?;
        for record in long.iter().filter(|record| record.name == "SDIRK4") {
            common::curve(&mut bend, bends(record), line(GREEN, 1.2))?;
        }

        // By powers of ten. A step may come to have no error at all by chance.
        let title = "Energy error, 10 ms (J)";
        let mut energy = common::powers(&lower, title, "time (s)", 0.0..LONG, -8.0..-3.0)?;
        let colours = [BLUE, ORANGE, GREEN];
        common::legend(&lower, &[("gen. α", BLUE), ("trapezoidal", ORANGE), ("SDIRK4", GREEN)])?;
        for (record, colour) in long.iter().zip(colours) {
            let errors = record.readings.iter().skip(1);
            let logs = errors.map(|[time, error, _]| (*time, error.abs().log10().max(-8.0)));
            common::curve(&mut energy, logs, line(colour, 1.2))?;
        }
        Ok(())
    })
}
