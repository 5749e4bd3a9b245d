//! Scenes at random in the plane.

use super::{Tallies, rules, size, trial, worst};
use catena::planar::*;
use catena::system::{Element, MotionOf, Root, Tip};
use catena_oracle::Noise;

fn rod(noise: &mut Noise) -> Rod<f64> {
    Rod::uniform(size(noise), size(noise))
}

fn plate(noise: &mut Noise) -> RigidBody<f64> {
    let (mass, length) = (size(noise), size(noise));
    let inertia = mass * length * length * noise.between(0.02, 0.3);
    let at = |noise: &mut Noise| noise.pair().map(|x| length * x);
    RigidBody::new(mass, inertia, at(noise), at(noise))
}

/// Torques in joints that should have none, or that of `spring`, by their number and coordinate.
fn balance<R, C, P>(
    scene: &System<f64, R, C, P>,
    motion: &MotionOf<Planar<f64>, R, C, P>,
    spring: impl Fn(usize, f64) -> f64,
    held: bool,
) -> Result<f64, catena::Error>
where
    R: Root<Planar<f64>>,
    C: Element<Planar<f64>>,
    P: Tip<Planar<f64>>,
{
    worst!(scene, motion, held, |stations, note| {
        for k in 0..scene.joints() {
            let numbers = scene.joint(k)?;
            let Some(station) = stations.joint(numbers) else { continue };
            let coordinate = match motion.coordinates_of::<1>(numbers) {
                Ok([coordinate]) => coordinate,
                Err(_) => continue, // a floating root
            };
            note((station.torque_outboard() - spring(k, coordinate)).abs());
        }
    })
}

fn none(_: usize, _: f64) -> f64 {
    0.0
}

pub fn plates(all: &mut Tallies, seed: u64) -> Result<(), catena::Error> {
    let noise = &mut Noise::new(seed);
    let n = 1 + (seed % 8) as usize;
    let (first, links) = (plate(noise), (1..n).map(|_| (Pin, plate(noise))).collect::<Vec<_>>());
    let scene = System::new(Pinned::origin(), (first, links), Free)?.with_gravity(9.81);
    let angles: Vec<f64> = (0..n).map(|_| 3.0 * noise.next()).collect();
    let rates: Vec<f64> = (0..n).map(|_| 5.0 * noise.next()).collect();
    let start = scene.with_rates(scene.at_rest(&angles)?, &rates)?;
    rules!(taylor all, "plates on pins", seed, scene, start, &|scene, end| balance(scene, end, none, false));
    Ok(())
}

pub fn springs(all: &mut Tallies, seed: u64) -> Result<(), catena::Error> {
    let noise = &mut Noise::new(seed);
    let n = 1 + (seed % 8) as usize;
    let stiff: Vec<f64> = (0..n).map(|_| 10_f64.powf(noise.between(-1.0, 4.0))).collect();
    let links: Vec<_> = (1..n).map(|k| (ElasticHinge::rotary(stiff[k]), rod(noise))).collect();
    let scene = System::new(Pinned::origin(), (rod(noise), links), Free)?.with_gravity(9.81);
    let angles: Vec<f64> = (0..n).map(|_| noise.next()).collect();
    let rates: Vec<f64> = (0..n).map(|_| noise.next()).collect();
    let start = scene.with_rates(scene.at_rest(&angles)?, &rates)?;
    let spring = |k: usize, angle: f64| if k == 0 { 0.0 } else { -stiff.get(k).map_or(0.0, |s| s * angle) };
    rules!(taylor all, "rods on springs", seed, scene, start, &|scene, end| balance(scene, end, spring, false));
    Ok(())
}

pub fn trees(all: &mut Tallies, seed: u64) -> Result<(), catena::Error> {
    let noise = &mut Noise::new(seed);
    let n = 1 + (seed % 4) as usize;
    let arm = |noise: &mut Noise| (0..1 + (seed % 3) as usize).map(|_| (Pin, rod(noise))).collect::<Vec<_>>();
    let links: Vec<_> = (0..n).map(|_| (Branch(arm(noise)), Pin, plate(noise))).collect();
    let scene = System::new(Pinned::origin(), (plate(noise), links), Free)?.with_gravity(9.81);
    let angles: Vec<f64> = (0..scene.bodies()).map(|_| 3.0 * noise.next()).collect();
    let rates: Vec<f64> = (0..scene.bodies()).map(|_| 3.0 * noise.next()).collect();
    let start = scene.with_rates(scene.at_rest(&angles)?, &rates)?;
    rules!(all, "trees on pins", seed, scene, start, &|scene, end| balance(scene, end, none, false));
    Ok(())
}

pub fn held(all: &mut Tallies, seed: u64) -> Result<(), catena::Error> {
    let noise = &mut Noise::new(seed);
    let n = 3 + (seed % 6) as usize;
    let lengths: Vec<f64> = (0..n).map(|_| size(noise)).collect();
    let angles: Vec<f64> = (0..n).map(|_| 1.4 * noise.next()).collect();
    let tip = lengths.iter().zip(&angles).fold([0.0; 2], |[x, y], (l, a)| [x + l * a.cos(), y + l * a.sin()]);
    let rods: Vec<_> = lengths.iter().map(|length| Rod::uniform(*length, size(noise))).collect();
    let links: Vec<_> = rods.iter().skip(1).map(|rod| (Pin, *rod)).collect();
    let scene = System::new(Pinned::origin(), (rods[0], links), Pinned::at(tip[0], tip[1]))?.with_gravity(9.81);
    let rates: Vec<f64> = (0..n).map(|_| noise.next()).collect();
    let start = scene.with_rates(scene.at_rest(&angles)?, &rates)?;
    let start = scene.assembled(start, &Unloaded)?;
    rules!(all, "pins, tip held", seed, scene, start, &|scene, end| balance(scene, end, none, true));
    Ok(())
}

pub fn networks(all: &mut Tallies, seed: u64) -> Result<(), catena::Error> {
    let noise = &mut Noise::new(seed);
    let mut bar = || {
        let length = noise.between(0.5, 1.0);
        Rod::uniform(length, size(noise))
    };
    let net = Network::new((Pin, bar(), Pin, bar()), (Pin, bar(), Pin, bar()), Pin);
    let chain = (bar(), net, Pin, bar());
    let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
    let angles: Vec<f64> = [0.0, 0.6, -0.6, -0.6, 0.6, 0.0].iter().map(|angle| angle + 0.3 * noise.next()).collect();
    let rates: Vec<f64> = (0..6).map(|_| noise.next()).collect();
    let start = scene.with_rates(scene.at_rest(&angles)?, &rates)?;
    let start = scene.assembled(start, &Unloaded)?;
    rules!(all, "networks of pins", seed, scene, start, &|scene, end| balance(scene, end, none, false));
    Ok(())
}

pub fn floating(all: &mut Tallies, seed: u64) -> Result<(), catena::Error> {
    let noise = &mut Noise::new(seed);
    let n = 2 + (seed % 6) as usize;
    let links: Vec<_> = (1..n).map(|_| (Pin, plate(noise))).collect();
    let scene = System::new(Free, (plate(noise), links), Free)?.with_gravity(9.81);
    let angles: Vec<f64> = (0..n).map(|_| 3.0 * noise.next()).collect();
    let rates: Vec<f64> = (0..n).map(|_| 5.0 * noise.next()).collect();
    let start = scene.with_body_rates(scene.at_rest(&angles)?, &rates)?;
    rules!(all, "floating plates", seed, scene, start, &|scene, end| balance(scene, end, none, false));
    Ok(())
}
