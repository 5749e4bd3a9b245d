//! What moves the tip of a chain: derivatives of one run by eight parameters, through kept gains.
//!
//! Five rods, one of them on a spring, swing for two seconds. A number that carries eight derivatives sends all of them through the run;
//! `through_gains` lets only values be eliminated, and derivatives follow by a few products a body. The same run by the rule itself,
//! and a finite difference of two plain runs for each parameter, say the same.
//!
//! ```text
//! cargo run --release --example influences
//! ```

mod common;

use catena::planar::*;
use catena::scalar::{Jet, Scalar};
use catena::{Error, Lift};
use common::{BLUE, Drawn, GREEN, GREY, ORANGE, line};
use std::path::PathBuf;
use std::time::Instant;

/// What the derivatives are by: name, unit, value.
const PARAMETERS: [(&str, &str, f64); 8] = [
    ("length of the first rod", "m", 0.4),
    ("its mass", "kg", 0.5),
    ("length of the others", "m", 0.3),
    ("their mass", "kg", 0.3),
    ("stiffness of the spring", "N·m/rad", 4.0),
    ("its damping", "N·m·s/rad", 0.02),
    ("gravity", "m/s²", 9.81),
    ("angle at the start", "rad", -0.3),
];
const END: f64 = 2.0; // (s)
const EVERY: f64 = 0.004; // (s)
type Number = Jet<f64, 8>;

/// The scene and where it starts, for numbers of any kind.
macro_rules! scene {
    ($number:ty, $parameters:expr) => {{
        let [first, mass, length, others, stiffness, damping, gravity, angle]: [$number; 8] = $parameters;
        let rod = Rod::uniform(length, others);
        let sprung = (ElasticHinge::rotary(stiffness).damped(damping), rod);
        let chain = (Rod::uniform(first, mass), sprung, [(Pin, rod); 3]);
        let system = System::new(Pinned::origin(), chain, Free)?.with_gravity(gravity);
        let start = system.at_rest(&[angle; 5])?;
        (system, start)
    }};
}

/// The tip (m) at the end of a plain run.
fn tip(parameters: [f64; 8]) -> Result<[f64; 2], Error> {
    let (system, start) = scene!(f64, parameters);
    let run = system.simulate(start, Rk4::step(1e-3), END, |_| ())?;
    Ok(system.stations(&run.motion, &Unloaded)?.tip().frame.place.into())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let values = PARAMETERS.map(|(_, _, value)| value);
    let mut k = 0;
    let seeds: [Number; 8] = values.lift(&mut |value: f64| {
        k += 1;
        Number::seed(value, k - 1)
    });

    let (system, start) = scene!(Number, seeds);
    let rule = Rk4::step(1e-3);
    let mut path = vec![];
    let clock = Instant::now();
    let run = system.simulation(rule.through_gains()).every(EVERY).run(start, END, |now| {
        path.push(now.stations().tip().frame.place);
    })?;
    let through = clock.elapsed();
    let place = system.stations(&run.motion, &Unloaded)?.tip().frame.place;
    let clock = Instant::now();
    let by_rule = system.simulate(start, rule, END, |_| ())?;
    let itself = clock.elapsed();
    let same = system.stations(&by_rule.motion, &Unloaded)?.tip().frame.place;
    let clock = Instant::now();
    tip(values)?;
    let plain = clock.elapsed();

    println!(
        "The tip after {END} s stands at x = {:.6} m. Its derivatives, in m per unit of the parameter\n",
        place.x.re
    );
    common::heads(&[("by", 24), ("unit", 9), ("through gains", 14), ("by the rule", 12), ("by a difference", 16)]);
    for (i, (name, unit, value)) in PARAMETERS.iter().enumerate() {
        let h = 1e-5 * value.abs();
        let moved = |by: f64| {
            let mut values = values;
            values[i] += by;
            tip(values)
        };
        let difference = (moved(h)?[0] - moved(-h)?[0]) / (2.0 * h);
        println!("  {name:>24}  {unit:>9}  {:14.7}  {:12.7}  {difference:16.7}", place.x.eps[i], same.x.eps[i]);
    }
    println!(
        "\nA plain run takes {plain:.1?}, one with derivatives {through:.1?} through gains and {itself:.1?} by the rule."
    );
    println!("Picture: {}", draw(&path)?.display());
    Ok(())
}

/// How the place of the tip depends on three parameters, over time.
fn draw(path: &[nalgebra::Vector2<Number>]) -> Drawn<PathBuf> {
    common::picture("influences", (760, 400), |area| {
        let subtitle =
            "Derivatives of the tip's x by parameters, each times a hundredth of the parameter: what 1 % more does.";
        let area = common::heading(area, "What moves the tip", subtitle)?;
        let curves = [(0, BLUE), (4, ORANGE), (6, GREEN), (3, GREY)];
        let over = |k: usize| -> Vec<(f64, f64)> {
            let share = 0.01 * PARAMETERS[k].2 * 1e3;
            path.iter().enumerate().map(|(i, place)| (i as f64 * EVERY, place.x.eps[k].scale(share))).collect()
        };
        let range = common::range(curves.iter().flat_map(|(k, _)| over(*k)).map(|(_, y)| y), 0.08);
        let mut chart = common::chart(&area, "Change of x (mm)", "time (s)", 0.0..END, range)?;
        common::legend(&area, &curves.map(|(k, colour)| (PARAMETERS[k].0, colour)))?;
        for (k, colour) in curves {
            common::curve(&mut chart, over(k), line(colour, 1.8))?;
        }
        Ok(())
    })
}
