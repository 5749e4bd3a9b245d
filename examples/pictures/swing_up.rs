//! Pictures of the example `swing_up`.

use crate::cart::{H, LENGTHS, State};
use crate::common::film::{Course, Film, Stroke};
use crate::common::panel::{Curve, Panel};
use crate::common::{self, BLUE, Chart, Drawn, FAINT, GREEN, GREY, INK, ORANGE, blend, line};
use crate::{HOLD, Plan, SWING};
use std::f64::consts::FRAC_PI_2;
use std::path::PathBuf;

pub fn draw(plan: &Plan, held: &Plan) -> Drawn<PathBuf> {
    common::picture("swing_up", (760, 760), |area| {
        let subtitle =
            "A cart with two rods, every 0.1 s from hanging (grey) to standing (black), and the way of the tip.";
        let area = common::heading(area, "Swing up", subtitle)?;
        let (upper, lower) = area.split_vertically(common::pixels(464.0));
        let mut chart = common::chart(&upper, "Height (m)", "x (m)", -1.75..1.75, -1.0..1.05)?;
        links(&mut chart, plan)?;
        let all = || plan.states.iter().chain(&held.states[1..]).enumerate().map(|(k, state)| (k as f64 * H, state));
        let end = H * (SWING + HOLD) as f64;
        let range = common::range(all().flat_map(|(_, s)| [s[0], s[1] - FRAC_PI_2, s[2] - FRAC_PI_2]), 0.08);
        let mut chart =
            common::chart(&lower, "Rods from upright (rad), cart from the middle (m)", "time (s)", 0.0..end, range)?;
        common::legend(&lower, &[("cart", GREEN), ("lower rod", BLUE), ("upper rod", ORANGE)])?;
        for (i, from, colour) in [(0, 0.0, GREEN), (1, FRAC_PI_2, BLUE), (2, FRAC_PI_2, ORANGE)] {
            common::curve(&mut chart, all().map(|(time, state)| (time, state[i] - from)), line(colour, 1.8))?;
        }
        Ok(())
    })
}

/// Cart, joint between the rods, and tip (m).
fn points(state: &State) -> Vec<(f64, f64)> {
    let mut points = vec![(state[0], 0.0)];
    for i in 0..2 {
        let (x, y) = points[i];
        points.push((x + LENGTHS[i] * state[i + 1].cos(), y + LENGTHS[i] * state[i + 1].sin()));
    }
    points
}

/// Cart and rods at instants of the swing, and the way of the tip.
fn links(chart: &mut Chart, plan: &Plan) -> Drawn {
    common::links(chart, vec![(-1.75, 0.0), (1.75, 0.0)], line(GREY, 1.0))?;
    common::curve(chart, plan.states.iter().map(|state| points(state)[2]), line(ORANGE, 1.6))?;
    for (k, state) in plan.states.iter().enumerate().step_by(10) {
        let (last, points) = (k == SWING, points(state));
        let colour = if last { INK } else { blend(FAINT, BLUE, 0.2 + 0.8 * k as f64 / SWING as f64) };
        common::dots(chart, [points[0], points[1]], 2.5, colour)?;
        common::links(chart, points, line(colour, if last { 3.5 } else { 1.2 }))?;
    }
    Ok(())
}

/// The swing, and the costate that goes backward under it.
pub fn film(plan: &Plan, costates: &[State]) -> Drawn<PathBuf> {
    let names = [("cart", GREEN, 0.0), ("lower rod", BLUE, FRAC_PI_2), ("upper rod", ORANGE, FRAC_PI_2)];
    let curves = |states: &[State], upright: f64| {
        let each = names.into_iter().enumerate();
        each.map(|(i, (name, colour, from))| Curve {
            name,
            colour,
            values: states.iter().map(|state| state[i] - upright * from).collect(),
        })
        .collect()
    };
    let panels = [
        Panel { title: "Run, forward (m, rad)", curves: curves(&plan.states, 1.0), backward: false },
        Panel { title: "Costate, backward (1/m, 1/rad)", curves: curves(costates, 0.0), backward: true },
    ];
    let frames: Vec<_> = plan.states.iter().step_by(5).map(|state| vec![points(state)]).collect();
    let film = Film {
        title: "Swing up",
        subtitle: "Backward goes the costate: what the rest will cost more, if one is off.",
        view: (-1.75..1.75, -1.0..1.05),
        scale: 140.0,
        seconds: [H * SWING as f64, 12.0],
        course: Course::ThereAndBack,
        strokes: &[Stroke::links(BLUE, 6.0)],
        floor: &[vec![(-1.75, 0.0), (1.75, 0.0)]],
        panels: &panels,
        ..Film::default()
    };
    film.save("swing_up_moving", &frames)
}
