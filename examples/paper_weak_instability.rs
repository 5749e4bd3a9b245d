//! The weak instability of the scheme as printed: by how much the angles of a double pendulum are off, over time.
//!
//! Two uniform rods of 1 m and 1 kg, released at rest 60° below the horizontal; β = ¼, γ = ½ on every coordinate at three steps, and two rules
//! with damping. It draws the picture of module `paper` (docs/weak_instability.svg is a copy).
//!
//! ```text
//! cargo run --release --example paper_weak_instability
//! ```

mod common;

use catena::loading::Unloaded;
use catena::paper::{GeneralizedAlpha, Newmark, Scheme};
use catena::planar::{Dop853, Free, Pin, Pinned, Rod, System};
use common::{BLUE, GREEN, INK, ORANGE, blend, line};
use std::f64::consts::FRAC_PI_3;

const END: f64 = 7.0;
/// Where points are drawn (s).
const EVERY: f64 = 0.05;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rod = Rod::uniform(1.0, 1.0); // length (m), mass (kg)
    let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let start = pendulum.at_rest(&[-FRAC_PI_3; 2])?;
    let mut exact = vec![];
    pendulum.simulation(Dop853::tolerance(1e-12)).every(EVERY).run(start, END, |now| {
        let (first, ((), second, ())) = *now.motion().position();
        exact.push([first, second]);
    })?;
    let mut curves = vec![];
    macro_rules! curve {
        ($name:expr, $rule:expr, $dt:expr, $colour:expr) => {{
            let mut run = Scheme::new($rule).start(&pendulum, &start, &Unloaded, $dt)?;
            let (mut points, mut off) = (vec![], None);
            for (k, exact) in exact.iter().enumerate().skip(1) {
                let time = k as f64 * EVERY;
                // Steps fail soon after angles are lost.
                let failed = run.run_to(time).is_err();
                let error = run.angles().zip(exact).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
                points.push((run.time(), error.clamp(1e-6, 3.0).log10()));
                if failed || error > 1.0 {
                    off = Some(run.time());
                    break;
                }
            }
            println!(
                "  {:>22}  {:8}  {:>19}",
                $name,
                $dt,
                off.map_or("stays".to_owned(), |t| format!("1 rad off at {t:.2} s"))
            );
            curves.push(($name, points, $colour));
        }};
    }
    common::heads(&[("rule", 22), ("step (s)", 8), ("outcome", 19)]);
    curve!("γ = ½, 10 ms", Newmark::new(0.25, 0.5), 0.01, ORANGE);
    curve!("γ = ½, 5 ms", Newmark::new(0.25, 0.5), 0.005, blend(ORANGE, INK, 0.4));
    curve!("γ = ½, 2 ms", Newmark::new(0.25, 0.5), 0.002, INK);
    curve!("γ = 0.6, 10 ms", Newmark::damped(0.6), 0.01, GREEN);
    curve!("generalised-α, 10 ms", GeneralizedAlpha::new(0.8), 0.01, BLUE);

    let picture = common::picture("paper_weak_instability", (860, 420), |area| {
        let subtitle = "Largest error of both angles by the paper's scheme: undamped Newmark loses the motion, damped rules do not.";
        let area = common::heading(area, "A weak instability of undamped rules", subtitle)?;
        let mut chart = common::powers(&area, "Error (rad)", "time (s)", 0.0..END, -6.0..0.5)?;
        let names: Vec<_> = curves.iter().map(|(name, _, colour)| (*name, *colour)).collect();
        common::legend(&area, &names)?;
        for (_, points, colour) in &curves {
            common::curve(&mut chart, points.iter().copied(), line(*colour, 1.8))?;
        }
        Ok(())
    })?;
    println!("\nPicture: {}", picture.display());
    Ok(())
}
