//! How tall may a strip of steel stand? Clamped upright it carries its own weight up to a height; beyond, it bends over. Rests and
//! vibrations for a row of lengths, beside Greenhill's formula.
//!
//! ```text
//! cargo run --release --example statics_and_modes
//! ```

mod common;

use catena::planar::*;
use common::{BLUE, Drawn, FAINT, GREY, INK, ORANGE, blend, line};
use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use std::path::PathBuf;

/// Segments of the strip.
const K: usize = 16;
/// Spring steel, 20 mm wide and 0.5 mm thick: E I (N·m²) with E = 210 GPa, ρ A (kg/m).
const BENDING: f64 = 0.04375;
const DENSITY: f64 = 0.0785;
const GRAVITY: f64 = 9.81;
/// The clamp leans by this much, as clamps do (rad): it decides to which side the strip goes.
const LEAN: f64 = 2e-3;
/// E I / (ρ A g L³) at which an upright strip begins to bend over (A. G. Greenhill, 1881).
const GREENHILL: f64 = 7.8373;
/// ω² of the lowest mode without gravity: (1.8751⁴) E I / (ρ A L⁴).
const FIRST: f64 = 12.3624;

/// What is found for a length.
struct Rest {
    length: f64,
    /// Places of segments' ends (m).
    shape: Vec<(f64, f64)>,
    /// The three lowest angular frequencies (rad/s), and the torque at the clamp (N·m).
    frequencies: [f64; 3],
    torque: f64,
}

fn rest(length: f64) -> Result<Rest, Box<dyn Error>> {
    let strip = Beam::new(length, BENDING, DENSITY).segments::<K>();
    let scene = System::new(Clamped::at(0.0, 0.0, FRAC_PI_2 - LEAN), strip, Free)?.with_gravity(GRAVITY);
    // From a strip that is bent over, downhill from there: those that can stand rise.
    let bent: [f64; K] = std::array::from_fn(|k| FRAC_PI_2 - 0.1 * (k + 1) as f64);
    let rest = scene.equilibrium(scene.at_rest(&bent)?, &Unloaded)?;
    let modes = scene.modes(&rest, &Unloaded)?;
    let mut frequencies = modes.frequencies();
    let bodies = scene.body_motions(&rest)?;
    Ok(Rest {
        length,
        shape: bodies
            .iter()
            .map(|body| body.inboard.place)
            .chain(bodies.get(K).map(|body| body.outboard().place))
            .map(|place| (place.x, place.y))
            .collect(),
        frequencies: [(); 3].map(|()| frequencies.next().unwrap_or(f64::NAN)),
        torque: scene.stations(&rest, &Unloaded)?.root().torque_outboard(),
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let critical = (GREENHILL * BENDING / (DENSITY * GRAVITY)).cbrt();
    println!("A strip of spring steel, 20 mm × 0.5 mm, clamped upright, in {K} segments.");
    println!("Greenhill: beyond {critical:.4} m it bends over. The clamp leans by {} mrad.\n", 1e3 * LEAN);
    common::heads(&[
        ("length (m)", 10),
        ("tip aside (m)", 13),
        ("tip height (m)", 14),
        ("torque (N·m)", 12),
        ("ω₁ (rad/s)", 10),
        ("ω₂ (rad/s)", 10),
        ("ω₃ (rad/s)", 10),
        ("ω₁ weightless", 13),
    ]);
    let shares = [0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 1.0, 1.05, 1.1, 1.2, 1.35, 1.5];
    let rests = shares.iter().map(|share| rest(share * critical)).collect::<Result<Vec<_>, _>>()?;
    for Rest { length, shape, frequencies: [a, b, c], torque } in &rests {
        let (x, y) = shape[K + 1];
        let alone = weightless(*length);
        println!("  {length:10.4}  {x:13.4}  {y:14.4}  {torque:12.4}  {a:10.4}  {b:10.4}  {c:10.4}  {alone:13.4}");
    }
    // Upright, ω² falls in proportion to the weight but for some percent: where it would vanish is where the strip bends over.
    let ratio = |rest: &Rest| (rest.frequencies[0] / weightless(rest.length)).powi(2);
    let cube = |k: usize| shares[k].powi(3);
    let line = (cube(2) * ratio(&rests[1]) - cube(1) * ratio(&rests[2])) / (ratio(&rests[1]) - ratio(&rests[2]));
    println!("\nω₁² of the third and second length goes to zero at {:.4} m.", critical * line.cbrt());
    println!("Picture: {}", draw(&rests, critical)?.display());
    Ok(())
}

/// The lowest frequency where there is no gravity (rad/s).
fn weightless(length: f64) -> f64 {
    (FIRST * BENDING / DENSITY).sqrt() / (length * length)
}

/// Rests on the left; the lowest frequency and the tip's place over length on the right.
fn draw(rests: &[Rest], critical: f64) -> Drawn<PathBuf> {
    common::picture("statics_and_modes", (1000, 560), |area| {
        let subtitle = format!(
            "Spring steel, 20 mm × 0.5 mm, clamped upright. Beyond Greenhill's height, {critical:.3} m, it bends over."
        );
        let area = common::heading(area, "How tall may a strip stand?", &subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(440.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));
        let mut shapes = common::chart(&left, "Rests for twelve lengths, x and y (m)", "", -0.3..1.1, -0.65..0.95)?;
        for (k, rest) in rests.iter().enumerate() {
            let share = k as f64 / (rests.len() - 1) as f64;
            let colour = if rest.length > critical * 1.001 { ORANGE } else { BLUE };
            common::curve(&mut shapes, rest.shape.clone(), line(blend(FAINT, colour, 0.4 + 0.6 * share), 2.0))?;
        }
        common::dots(&mut shapes, [(0.0, 0.0)], 5.0, INK)?;

        let lengths = 0.2..1.3;
        let mut chart = common::chart(&upper, "Lowest frequency (rad/s)", "length (m)", lengths.clone(), 0.0..32.0)?;
        common::legend(&upper, &[("found", BLUE), ("weightless", GREY), ("Greenhill", INK)])?;
        let alone = (0..=100).map(|k| 0.27 + 0.01 * f64::from(k)).map(|length| (length, weightless(length)));
        common::curve(&mut chart, alone.filter(|point| point.1 < 32.0), line(GREY, 1.2))?;
        common::curve(&mut chart, [(critical, 0.0), (critical, 32.0)], line(INK, 1.0))?;
        let points: Vec<_> = rests.iter().map(|rest| (rest.length, rest.frequencies[0])).collect();
        common::curve(&mut chart, points.iter().copied().filter(|point| point.1 < 32.0), line(BLUE, 1.6))?;
        common::dots(&mut chart, points.into_iter().filter(|point| point.1 < 32.0), 3.0, BLUE)?;

        let mut chart = common::chart(&lower, "Tip aside (m)", "length (m)", lengths, -0.05..0.75)?;
        common::curve(&mut chart, [(critical, -0.05), (critical, 0.75)], line(INK, 1.0))?;
        let points: Vec<_> = rests.iter().map(|rest| (rest.length, rest.shape[K + 1].0)).collect();
        common::curve(&mut chart, points.iter().copied(), line(ORANGE, 1.6))?;
        common::dots(&mut chart, points, 3.0, ORANGE)
    })
}
