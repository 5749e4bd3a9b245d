//! Picture of the example `past_shocks`.

use crate::common::{self, BLUE, Drawn, GREY, INK, ORANGE, line};
use crate::{END, RAIL, Seen, TARGET};
use std::path::PathBuf;

pub fn draw(tries: &[Seen]) -> Drawn<PathBuf> {
    common::picture("past_shocks", (860, 720), |area| {
        let subtitle = "A cart that rubs and bumps, and the end of the rod that hangs from it, from rest to a motion asked for. Dots: modes change.";
        let area = common::heading(area, "Steering past shocks", subtitle)?;
        let (upper, lower) = area.split_vertically(common::pixels(430.0));
        let mut chart = common::chart(&upper, "Cart, and thin the rod's end (m)", "time (s)", 0.0..END, -1.0..1.0)?;
        common::legend(&upper, &[("first try", ORANGE), ("last try", BLUE)])?;
        for (place, width) in [(RAIL, 1.6), (-RAIL, 1.6), (TARGET[0], 0.6)] {
            common::curve(&mut chart, [(0.0, place), (END, place)], line(if width > 1.0 { INK } else { GREY }, width))?;
        }
        let [first, .., last] = tries else { return Ok(()) };
        for (seen, colour) in [(first, ORANGE), (last, BLUE)] {
            for (k, width) in [(2, 0.9), (1, 2.2)] {
                common::curve(&mut chart, seen.path.iter().map(|at| (at[0], at[k])), line(colour, width))?;
            }
            let at = seen.path.iter().filter(|at| seen.changes.contains(&at[0])).map(|at| (at[0], at[1]));
            common::dots(&mut chart, at, 3.0, colour)?;
        }
        let all = first.forces.iter().chain(&last.forces).copied();
        let mut chart = common::chart(&lower, "Force on the cart (N)", "time (s)", 0.0..END, common::range(all, 0.1))?;
        for (seen, colour) in [(first, ORANGE), (last, BLUE)] {
            let share = END / seen.forces.len() as f64;
            let steps = seen.forces.iter().enumerate();
            let steps = steps.flat_map(|(k, force)| [k, k + 1].map(|k| (share * k as f64, *force)));
            common::curve(&mut chart, steps, line(colour, 1.8))?;
        }
        Ok(())
    })
}
