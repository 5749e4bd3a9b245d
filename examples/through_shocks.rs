//! Aiming through shocks: how fast a cart on a rail and the rod that hangs from it have to begin for the rod's end to be at a place at an
//! instant, though the cart bumps into the ends of the rail on the way. Newton's method, by derivatives of runs that go through the shocks.
//!
//! ```text
//! cargo run --release --example through_shocks
//! ```

mod common;

use catena::planar::*;
use catena::scalar::Jet;
use common::{BLUE, Drawn, GREY, INK, ORANGE, line};
use std::cell::Cell;
use std::error::Error;
use std::path::PathBuf;

/// Where the end of the rod is to be (m), and when (s).
const TARGET: [f64; 2] = [0.6, -0.2];
const END: f64 = 1.5;
/// The cart goes so far to either side (m), and gives back a share of its speed there.
const RAIL: f64 = 0.5;
const RESTITUTION: f64 = 0.7;

/// A number with derivatives by both rates of the start.
type Number = Jet<f64, 2>;

/// What is seen of a run: the end of the rod (m) over time, where it is at last, with derivatives, and how often the cart strikes.
struct Throw {
    path: Vec<(f64, f64)>,
    end: [Number; 2],
    shocks: usize,
}

/// Lets go with a rate of the cart (m/s) and of the rod (rad/s).
fn thrown(rates: [f64; 2]) -> Result<Throw, Box<dyn Error>> {
    let of = Number::of;
    let rail = HardStops::between(Slider::along(of(0.0)), [of(-RAIL), of(RAIL)]).rebounding(of(RESTITUTION));
    let cart = RigidBody::new(of(2.0), of(0.1), [of(0.0); 2], [of(0.0); 2]);
    let rod = Rod::uniform(of(0.8), of(1.0));
    let crane = System::new(Clamped::origin(), (rail, cart, Revolute::smooth(), rod), Free)?.with_gravity(of(9.81));
    let mut start = crane.motion();
    start.set_coordinates(&[of(0.0), of(-1.2)])?;
    let start = crane.with_rates(start, &[Number::seed(rates[0], 0), Number::seed(rates[1], 1)])?;
    let (mut path, before) = (vec![], Cell::new(0.0));
    let mut run = crane.simulation(Dop853::tolerance(1e-11)).longest_step(0.01).begin(start, END, |now| {
        before.set(now.motion().rates()[0].re);
        path.extend(now.bodies().iter().last().map(|rod| rod.outboard().place).map(|at| (at.x.re, at.y.re)));
    })?;
    let mut shocks = 0;
    while run.step()? {
        shocks += usize::from((run.motion().rates()[0].re - before.get()).abs() > 1e-6);
    }
    let motion = run.finish()?.motion;
    let end = crane.body_motions(&motion)?.iter().last().map(|rod| rod.outboard().place.into()).ok_or("no rod")?;
    Ok(Throw { path, end, shocks })
}

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "A cart of 2 kg on a rail of {} m, whose ends give back {RESTITUTION} of its speed, and a rod of 0.8 m that",
        2.0 * RAIL
    );
    println!("hangs from it, whose end is to be at ({}, {}) m after {END} s: Newton's method.\n", TARGET[0], TARGET[1]);
    let columns = [("guess", 5), ("cart (m/s)", 14), ("rod (rad/s)", 14), ("shocks", 6), ("misses by (m)", 13)];
    common::heads(&columns);
    let (mut rates, mut throws) = ([3.5, -0.3], vec![]);
    for guess in 1..=12 {
        let throw = thrown(rates)?;
        let missed = [throw.end[0].re - TARGET[0], throw.end[1].re - TARGET[1]];
        let miss = missed[0].hypot(missed[1]);
        println!("  {guess:5}  {:14.10}  {:14.10}  {:6}  {miss:13.1e}", rates[0], rates[1], throw.shocks);
        throws.push(throw.path);
        if miss < 1e-10 {
            break;
        }
        let [[a, b], [c, d]] = throw.end.map(|x| x.eps);
        let determinant = a * d - b * c;
        let step = [(b * missed[1] - d * missed[0]) / determinant, (c * missed[0] - a * missed[1]) / determinant];
        let share = (0.25 / step[0].hypot(step[1])).min(1.0); // not too far at a time
        rates = [rates[0] + share * step[0], rates[1] + share * step[1]];
    }
    println!("\nPicture: {}", draw(&throws)?.display());
    Ok(())
}

/// Paths of the end of the rod: of the first guess, of others, of the last.
fn draw(throws: &[Vec<(f64, f64)>]) -> Drawn<PathBuf> {
    common::picture("through_shocks", (860, 690), |area| {
        let subtitle = "Paths of the rod's end: first guess, others, the last one, to the cross. They have corners where the cart strikes.";
        let area = common::heading(area, "Aiming through shocks", subtitle)?;
        let mut chart = common::chart(&area, "y (m)", "x (m)", -1.35..1.35, -1.0..0.95)?;
        common::curve(&mut chart, [(-RAIL, 0.0), (RAIL, 0.0)], line(INK, 3.0))?;
        let [first, others @ .., last] = throws else { return Ok(()) };
        let others = others.iter().map(|path| (path, line(GREY, 0.8)));
        for (path, style) in others.chain([(first, line(ORANGE, 1.8)), (last, line(BLUE, 2.4))]) {
            common::curve(&mut chart, path.iter().copied(), style)?;
        }
        let [x, y] = TARGET;
        for (dx, dy) in [(0.03, 0.0), (0.0, 0.03)] {
            common::curve(&mut chart, [(x - dx, y - dy), (x + dx, y + dy)], line(INK, 2.0))?;
        }
        Ok(())
    })
}
