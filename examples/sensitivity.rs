//! Derivatives of a whole run: the same code on dual numbers.
//!
//! Where does the tip of a double pendulum go if its rods are a little longer? A dual number carries its derivative
//! through every operation of the run, exact but for rounding. A central finite difference, beside it, needs two runs and
//! a good choice of their distance.
//!
//! ```text
//! cargo run --release --example sensitivity
//! ```

mod common;

use catena::planar::*;
use catena::{Error, Scalar};
use common::{BLUE, Drawn, GREEN, GREY, ORANGE, line};
use num_dual::Dual64;
use std::f64::consts::FRAC_PI_3;
use std::path::PathBuf;

const INTERVAL: f64 = 0.02; // between two places of the path (s)
const END: f64 = 5.0; // (s)

/// The path of the tip (m) of a double pendulum with rods of this length (m).
///
/// Written once for all numbers: nothing in it knows whether `T` is `f64` or carries a derivative. Time is not
/// differentiated, so it is of the plain number `T::Real` behind `T`.
fn path<T: Scalar<Real = f64>>(length: T) -> Result<Vec<[T; 2]>, Error> {
    let rod = Rod::uniform(length, T::one());
    let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(T::literal(9.81));
    let start = pendulum.at_rest(&[T::literal(-FRAC_PI_3); 2])?;
    let mut places = Vec::new();
    pendulum.simulation(Dop853::tolerance(1e-13)).every(INTERVAL).run(start, END, |now| {
        let tip = now.stations().tip().frame.place;
        places.push([tip.x, tip.y]);
    })?;
    Ok(places)
}

/// d tip / d length by a central difference of two runs with rods longer and shorter by `h` (m).
fn difference(h: f64) -> Result<Vec<[f64; 2]>, Error> {
    let (longer, shorter) = (path(1.0 + h)?, path(1.0 - h)?);
    Ok(longer.iter().zip(&shorter).map(|(a, b)| [0, 1].map(|k| (a[k] - b[k]) / (2.0 * h))).collect())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // `derivative` marks the number with respect to which all others are differentiated.
    let dual = path(Dual64::from_re(1.0).derivative())?;
    let exact: Vec<[f64; 2]> = dual.iter().map(|place| place.map(|x| x.eps)).collect();

    let distance = 1e-4;
    let differences = difference(distance)?;
    println!("d tip / d length of a double pendulum: dual numbers, and a central difference over ±{distance:.0e} m\n");
    let tip = [("time (s)", 8), ("tip x (m)", 11), ("tip y (m)", 11), ("dx/dl, dual", 11), ("dy/dl, dual", 11)];
    let by_differences = [("dx/dl, diff.", 12), ("dy/dl, diff.", 12), ("largest deviation", 17)];
    common::heads(&[&tip[..], &by_differences[..]].concat());
    for k in (0..exact.len()).step_by(25) {
        let time = k as f64 * INTERVAL;
        let ([x, y], [dx, dy], [fx, fy]) = (dual[k].map(|x| x.re), exact[k], differences[k]);
        let off = (fx - dx).abs().max((fy - dy).abs());
        println!("  {time:8.2}  {x:11.7}  {y:11.7}  {dx:11.7}  {dy:11.7}  {fx:12.7}  {fy:12.7}  {off:17.1e}");
    }

    // The trouble with finite differences: too far apart they are wrong, too close together they are noise.
    println!("\nThe difference depends on its distance h; largest deviation from the dual numbers over {END} s:\n");
    println!("      h (m)   deviation");
    let mut deviations = Vec::new();
    for k in 0..=22 {
        let h = 10f64.powf(-1.0 - 0.5 * f64::from(k));
        let largest = difference(h)?.iter().zip(&exact).fold(0.0f64, |largest, (found, exact)| {
            largest.max((found[0] - exact[0]).abs()).max((found[1] - exact[1]).abs())
        });
        deviations.push((h, largest));
        if k % 2 == 0 {
            println!("  {h:9.0e}   {largest:9.1e}");
        }
    }

    println!("\nPicture: {}", draw(&exact, &differences, &deviations)?.display());
    Ok(())
}

/// The derivatives over time on the left; what finite differences make of them on the right.
fn draw(exact: &[[f64; 2]], differences: &[[f64; 2]], deviations: &[(f64, f64)]) -> Drawn<PathBuf> {
    common::picture("sensitivity", (1000, 400), |area| {
        let subtitle =
            "d tip / d length of a double pendulum: one run on dual numbers, and finite differences of two runs.";
        let area = common::heading(area, "Sensitivity", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(560.0));

        let range = common::range(exact.iter().copied().flatten(), 0.08);
        let mut chart = common::chart(&left, "d tip / d length", "time (s)", 0.0..END, range)?;
        common::legend(&left, &[("x", BLUE), ("y", ORANGE), ("difference", GREY)])?;
        for (axis, colour) in [BLUE, ORANGE].into_iter().enumerate() {
            let over = |values: &[[f64; 2]]| -> Vec<(f64, f64)> {
                values.iter().enumerate().map(|(k, value)| (k as f64 * INTERVAL, value[axis])).collect()
            };
            common::curve(&mut chart, over(exact), line(colour, 1.8))?;
            common::dots(&mut chart, over(differences).into_iter().step_by(10), 2.6, GREY)?;
        }

        let points = deviations.iter().map(|(h, deviation)| (h.log10(), deviation.log10()));
        let range = common::range(points.clone().map(|(_, deviation)| deviation), 0.1);
        let mut chart =
            common::log_log(&right, "Deviation of the difference", "its distance h (m)", -12.2..-0.8, range)?;
        common::curve(&mut chart, points.clone(), line(GREEN, 1.4))?;
        common::dots(&mut chart, points, 3.0, GREEN)
    })
}
