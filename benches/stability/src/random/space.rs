//! Scenes at random in space.

use super::{Tallies, rules, size, trial, worst};
use catena::nalgebra::Vector3;
use catena::spatial::*;
use catena::system::{Element, MotionOf, Root, Tip};
use catena_oracle::Noise;

fn body(noise: &mut Noise) -> RigidBody<f64> {
    let (mass, length) = (size(noise), size(noise));
    // Of point masses, so that some body has it.
    let mut tensor = [[0.0; 3]; 3];
    for _ in 0..4 {
        let r = [noise.next(), noise.next(), noise.next()].map(|x| 0.4 * length * x);
        let square: f64 = r.iter().map(|x| x * x).sum();
        for (i, row) in tensor.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry += 0.25 * mass * (if i == j { square } else { 0.0 } - r[i] * r[j]);
            }
        }
    }
    let mut at = || [noise.next(), noise.next(), noise.next()].map(|x| length * x);
    RigidBody::new(mass, tensor, at(), at())
}

/// Torques in joints that should have none along `free`, a unit vector in axes of the inboard body, or in any direction.
fn balance<R, C, P>(
    scene: &System<f64, R, C, P>,
    motion: &MotionOf<Spatial<f64>, R, C, P>,
    skipped: usize,
    free: impl Fn(usize) -> Option<Vector3<f64>>,
    held: bool,
) -> Result<f64, catena::Error>
where
    R: Root<Spatial<f64>>,
    C: Element<Spatial<f64>>,
    P: Tip<Spatial<f64>>,
{
    worst!(scene, motion, held, |stations, note| {
        for k in skipped..scene.joints() {
            let Some(station) = stations.joint(scene.joint(k)?) else { continue };
            let torque = station.torque_outboard();
            note(match free(k) {
                Some(axis) => station.frame.turn.attitude.apply(axis).dot(&torque).abs(),
                None => torque.norm(),
            });
        }
    })
}

const DOWN: [f64; 3] = [0.0, 0.0, -9.81];

pub fn balls(all: &mut Tallies, seed: u64) -> Result<(), catena::Error> {
    let noise = &mut Noise::new(seed);
    let n = 1 + (seed % 6) as usize;
    let links: Vec<_> = (1..n).map(|_| (Ball, body(noise))).collect();
    let scene = System::new(Pinned::origin(), (body(noise), links), Free)?.with_gravity(DOWN);
    let angles: Vec<f64> = (0..3 * n).map(|_| 1.5 * noise.next()).collect();
    let rates: Vec<f64> = (0..3 * n).map(|_| 4.0 * noise.next()).collect();
    let start = scene.with_rates(scene.at_rest(&angles)?, &rates)?;
    rules!(all, "bodies on balls", seed, scene, start, &|scene, end| balance(scene, end, 0, |_| None, false));
    Ok(())
}

pub fn revolutes(all: &mut Tallies, seed: u64) -> Result<(), catena::Error> {
    let noise = &mut Noise::new(seed);
    let n = 1 + (seed % 7) as usize;
    let axes: Vec<[f64; 3]> = (0..n).map(|_| [noise.next(), noise.next(), noise.next()]).collect();
    let links: Vec<_> = axes.iter().map(|axis| (Revolute::about(*axis), body(noise))).collect();
    let scene = System::new(Clamped::origin(), links, Free)?.with_gravity(DOWN);
    let angles: Vec<f64> = (0..n).map(|_| 3.0 * noise.next()).collect();
    let rates: Vec<f64> = (0..n).map(|_| 4.0 * noise.next()).collect();
    let start = scene.with_rates(scene.at_rest(&angles)?, &rates)?;
    let free = |k: usize| axes.get(k.wrapping_sub(1)).map(|axis| Vector3::from(*axis).normalize());
    rules!(all, "bodies on revolutes", seed, scene, start, &|scene, end| balance(scene, end, 1, free, false));
    Ok(())
}

pub fn floating(all: &mut Tallies, seed: u64) -> Result<(), catena::Error> {
    let noise = &mut Noise::new(seed);
    let n = 2 + (seed % 4) as usize;
    let links: Vec<_> = (1..n).map(|_| (Ball, body(noise))).collect();
    let scene = System::new(Free, (body(noise), links), Free)?.with_gravity(DOWN);
    let mut start = scene.motion();
    let rates: Vec<f64> = (0..start.rate_count()).map(|_| 3.0 * noise.next()).collect();
    start.set_rates(&rates)?;
    let start = scene.with_accelerations(start, &Unloaded)?;
    rules!(all, "floating bodies", seed, scene, start, &|scene, end| balance(scene, end, 1, |_| None, false));
    Ok(())
}

pub fn held(all: &mut Tallies, seed: u64) -> Result<(), catena::Error> {
    let noise = &mut Noise::new(seed);
    let n = 2 + (seed % 4) as usize;
    let rods: Vec<_> = (0..n).map(|_| (size(noise), size(noise))).collect();
    let make = |(length, mass): &(f64, f64)| Rod::uniform(*length, 0.1 * length, *mass);
    let links: Vec<_> = rods.iter().skip(1).map(|rod| (Ball, make(rod))).collect();
    let angles: Vec<f64> = (0..3 * n).map(|_| 0.7 * noise.next()).collect();
    let rates: Vec<f64> = (0..3 * n).map(|_| noise.next()).collect();
    let free = System::new(Pinned::origin(), (make(&rods[0]), links.clone()), Free)?;
    let tip = free.stations(&free.at_rest(&angles)?, &Unloaded)?.tip().frame.place;
    let scene = System::new(Pinned::origin(), (make(&rods[0]), links), Pinned::at([tip.x, tip.y, tip.z]))?;
    let scene = scene.with_gravity(DOWN);
    let start = scene.assembled(scene.with_rates(scene.at_rest(&angles)?, &rates)?, &Unloaded)?;
    rules!(all, "balls, tip held", seed, scene, start, &|scene, end| balance(scene, end, 0, |_| None, true));
    Ok(())
}
