//! An arm whose elbow goes from stretched to a right angle: it strikes its stops, bounces off, and rests against them for a while.
//!
//! ```text
//! cargo run --release --example hard_stops
//! ```

mod common;

use catena::planar::*;
use common::{BLUE, Drawn, GREY, ORANGE, line};
use std::cell::RefCell;
use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use std::path::PathBuf;

/// How long is looked at (s), and the share of its rate that the elbow gets back.
const END: f64 = 6.0;
const RESTITUTION: f64 = 0.5;

/// What is seen at an instant: time (s), angle of the elbow (degrees), energy (J).
type Seen = (f64, f64, f64);

fn main() -> Result<(), Box<dyn Error>> {
    let bone = Rod::uniform(0.4, 1.5);
    let elbow = HardStops::between(Revolute::smooth(), [0.0, FRAC_PI_2]).rebounding(RESTITUTION);
    let arm = System::new(Pinned::origin(), (bone, elbow.named("elbow"), bone), Free)?.with_gravity(9.81);
    let start = arm.at_rest(&[0.2, 0.6])?; // the upper arm from the horizontal, the elbow from stretched (rad)

    // The end of a step is shown as it is before a shock; where the run goes on from is after it.
    let (seen, before) = (RefCell::new(vec![]), RefCell::new((0.0, 0.0)));
    let mut run = arm.simulation(Dop853::tolerance(1e-9)).longest_step(0.02).begin(start, END, |now| {
        let (angle, rate) = (now.motion().coordinates()[1], now.motion().rates()[1]);
        seen.borrow_mut().push((now.time(), angle.to_degrees(), now.energy()));
        *before.borrow_mut() = (rate, now.energy());
    })?;
    println!(
        "An arm of two bones, 0.4 m and 1.5 kg each; its elbow goes from 0 to 90 degrees, restitution {RESTITUTION}\n"
    );
    common::heads(&[
        ("time (s)", 8),
        ("elbow (degrees)", 15),
        ("rate before (rad/s)", 19),
        ("after (rad/s)", 13),
        ("energy taken (J)", 16),
    ]);
    let (mut small, mut rests) = (0, vec![]);
    while run.step()? {
        let ((rate, energy), after) = (*before.borrow(), run.motion().rates()[1]);
        if after == 0.0 {
            rests.push(run.motion().time());
        }
        if after * rate < 0.0 || (after == 0.0 && rate != 0.0) {
            let taken = energy - arm.budget(run.motion())?.energy();
            if rate.abs() > 1.0 {
                let (time, angle) = (run.motion().time(), run.motion().coordinates()[1].to_degrees());
                println!("  {time:8.4}  {angle:15.3}  {rate:19.4}  {after:13.4}  {taken:16.5}");
            } else {
                small += 1;
            }
        }
    }
    println!("\nAnd {small} shocks below 1 rad/s. The elbow rests at the end of {} steps.", rests.len());
    let seen = seen.borrow();
    let gained = seen.windows(2).map(|pair| pair[1].2 - pair[0].2).fold(0.0, f64::max);
    println!("Between shocks energy is kept: the largest gain in a step is {gained:.1e} J.");
    println!("Picture: {}", draw(&seen)?.display());
    Ok(())
}

/// The elbow between its stops, and the energy that shocks take.
fn draw(seen: &[Seen]) -> Drawn<PathBuf> {
    common::picture("hard_stops", (860, 560), |area| {
        let subtitle =
            "The elbow strikes its stops at 0 and 90 degrees, gives back half of its rate, and rests against them.";
        let area = common::heading(area, "An arm with an elbow", subtitle)?;
        let (upper, lower) = area.split_vertically(common::pixels(290.0));
        let mut elbow = common::chart(&upper, "Elbow (degrees)", "time (s)", 0.0..END, -8.0..98.0)?;
        for stop in [0.0, 90.0] {
            common::curve(&mut elbow, [(0.0, stop), (END, stop)], line(GREY, 1.0))?;
        }
        common::curve(&mut elbow, seen.iter().map(|(time, angle, _)| (*time, *angle)), line(BLUE, 1.8))?;
        let range = common::range(seen.iter().map(|(.., energy)| *energy), 0.1);
        let mut energy = common::chart(&lower, "Energy (J)", "time (s)", 0.0..END, range)?;
        common::curve(&mut energy, seen.iter().map(|(time, _, energy)| (*time, *energy)), line(ORANGE, 1.8))
    })
}
