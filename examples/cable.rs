//! A cable hangs between two hooks, one of which lets go: its rest beside a closed form, its fall, and the crack of the whip.
//!
//! The scene that hangs and the one that falls differ in their tip, and the motion of the one is the start of the other.
//!
//! ```text
//! cargo run --release --example cable
//! ```

mod common;
#[path = "pictures/cable.rs"]
mod pictures;

use catena::planar::*;
use std::error::Error;

/// Links, their length (m), and the mass of a metre (kg/m).
const N: usize = 40;
const LINK: f64 = 0.05;
const DENSITY: f64 = 0.5;
/// Distance of the hooks (m).
const SPAN: f64 = 1.2;
const GRAVITY: f64 = 9.81;
const END: f64 = 1.6; // (s)

/// What is kept of an instant.
struct Reading {
    time: f64,
    /// Ends of the links, from the hook to the tip (m).
    places: Vec<(f64, f64)>,
    /// Speed of the tip (m/s), pull at the hook (N).
    speed: f64,
    pull: f64,
    energy: f64,
}

/// Angles of N links at rest between hooks: the horizontal force H is one throughout and the vertical one grows by a link's weight w from
/// each middle to the next, so tan φ_k = (k − (N − 1)/2) w / H, and the links span what the hooks do.
fn catenary() -> [f64; N] {
    let weight = DENSITY * LINK * GRAVITY;
    let angles = |force: f64| std::array::from_fn(|k| ((k as f64 - (N - 1) as f64 / 2.0) * weight / force).atan());
    let span = |angles: [f64; N]| angles.iter().map(|angle| LINK * angle.cos()).sum::<f64>();
    let (mut low, mut high) = (1e-3, 1e3); // (N)
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if span(angles(middle)) < SPAN { low = middle } else { high = middle }
    }
    angles(low)
}

fn main() -> Result<(), Box<dyn Error>> {
    let link = Rod::uniform(LINK, DENSITY * LINK);
    let chain = || (link, [(Pin, link); N - 1]);
    let held = System::new(Pinned::origin(), chain(), Pinned::at(SPAN, 0.0))?.with_gravity(GRAVITY);
    let free = System::new(Pinned::origin(), chain(), Free)?.with_gravity(GRAVITY);

    // Its rest, found from a triangle.
    let steep = (SPAN / (N as f64 * LINK)).acos();
    let guess: [f64; N] = std::array::from_fn(|k| if k < N / 2 { -steep } else { steep });
    let rest = held.equilibrium(held.at_rest(&guess)?, &Unloaded)?;
    let mut angles = [0.0; N];
    rest.coordinates_into(&mut angles)?;
    let miss = angles.iter().zip(catenary()).fold(0.0_f64, |most, (found, known)| most.max((found - known).abs()));
    println!("A cable of {N} links, {} m long, hangs between hooks {SPAN} m apart.", N as f64 * LINK);
    println!("Angles at rest differ by {miss:.1e} rad at most from the closed form.\n");

    // The far hook lets go.
    let start = free.at_rest(&angles)?;
    let mut readings = vec![];
    free.simulation(Dop853::tolerance(1e-10)).every(0.002).run(start, END, |now| {
        let stations = now.stations();
        // Inboard ends of links and pins in turn: every other one is a link's.
        let ends = stations.iter().step_by(2).chain([stations.tip()]);
        let places = ends.map(|station| (station.frame.place.x, station.frame.place.y)).collect();
        let pull = stations.root().internal.force;
        readings.push(Reading {
            time: now.time(),
            places,
            speed: stations.tip().frame.velocity.norm(),
            pull: pull.x.hypot(pull.y),
            energy: now.energy(),
        });
    })?;
    common::heads(&[
        ("time (s)", 8),
        ("tip x (m)", 9),
        ("tip y (m)", 9),
        ("speed (m/s)", 11),
        ("pull at the hook (N)", 20),
        ("energy error (J)", 16),
    ]);
    for Reading { time, places, speed, pull, energy } in readings.iter().step_by(50) {
        let ((x, y), error) = (places[places.len() - 1], energy - readings[0].energy);
        println!("  {time:8.2}  {x:9.4}  {y:9.4}  {speed:11.4}  {pull:20.4}  {error:16.1e}");
    }
    let fastest = readings.iter().max_by(|a, b| a.speed.total_cmp(&b.speed)).ok_or("nothing was shown")?;
    let fallen = (2.0 * GRAVITY * -fastest.places[fastest.places.len() - 1].1).sqrt();
    println!(
        "\nThe tip is fastest at {:.2} s: {:.1} m/s, where falling freely it would have {fallen:.1} m/s.",
        fastest.time, fastest.speed
    );
    println!("Picture: {}", pictures::film(&readings)?.display());
    Ok(())
}
