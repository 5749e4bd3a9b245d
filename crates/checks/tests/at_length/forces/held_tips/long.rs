//! Long chains between two ends: balance of every body, closure, and closure forces against a banded solution.

use super::banded::Banded;
use super::chains::{DRIFT, End, Link, between, held};
use catena::Error;
use catena::planar::*;

/// What is left of the laws, as shares of the largest force or acceleration.
#[derive(Clone, Copy, Default)]
struct Defects {
    /// Of Newton's and Euler's laws of each body under the forces of its stations.
    balance: f64,
    /// Torques that inverse dynamics leaves in smooth pins: rounding errors of all bodies outboard times their levers, and so a
    /// share of the largest force times the length of the chain.
    pins: f64,
    /// Forces of the stations, from the banded solution.
    forces: f64,
    /// Of the acceleration that the closure demands.
    closure: f64,
    /// Closure forces, and accelerations of bodies, from the banded solution.
    multipliers: f64,
    accelerations: f64,
    /// The condition of Λ.
    condition: f64,
}

fn defects(links: &[Link], ends: [End; 2]) -> Result<Defects, Error> {
    let n = links.len();
    let banded = Banded::new(links, ends);
    let (expected, accelerations) = banded.answer();
    let multipliers = &expected[expected.len() - banded.held()..];
    let mut found = Defects { condition: banded.condition(), ..Defects::default() };
    let (mut force, mut size) = (1.0_f64, 1.0_f64);
    between!(ends, links, |scene, motion| {
        let (stations, bodies) = (scene.stations(&motion, &Unloaded).unwrap(), scene.body_motions(&motion).unwrap());
        let internal = |k: usize| stations.get(k).map_or(stations.tip().internal, |station| station.internal);
        for (k, body) in bodies.iter().enumerate() {
            let (inner, outer) = (internal(2 * k), internal(2 * k + 1));
            let (mass, inertia, centre) = (links[k].mass, links[k].inertia(), body.centre().acceleration);
            let half = [0.5 * links[k].length * links[k].angle.cos(), 0.5 * links[k].length * links[k].angle.sin()];
            let sum = inner.force + outer.force;
            let moment = outer.torque - inner.torque - (half[0] * sum.y - half[1] * sum.x) - inertia * centre.angular;
            let pin = if k > 0 || ends[0] == End::Pinned { inner.torque } else { 0.0 };
            let rest = [
                inner.force.x - outer.force.x - mass * centre.linear.x,
                inner.force.y - outer.force.y - mass * (centre.linear.y + 9.81),
                moment,
            ];
            found.pins = found.pins.max(pin.abs());
            let row = expected.len() - multipliers.len() - 2 * (n - k);
            for (x, y) in [inner.force.x, inner.force.y].into_iter().zip(&expected[row..]) {
                found.forces = found.forces.max(if k == 0 { 0.0 } else { (x - y).abs() });
            }
            found.balance = rest.iter().fold(found.balance, |worst, x| worst.max(x.abs()));
            force = force.max(inner.force.norm()).max(inner.torque.abs());
            for (x, y) in [centre.linear.x, centre.linear.y, centre.angular].into_iter().zip(accelerations[k]) {
                found.accelerations = found.accelerations.max((x - y).abs());
                size = size.max(y.abs());
            }
        }
        let tip = stations.tip().frame.acceleration;
        let off = [tip.linear.x - DRIFT[1][0], tip.linear.y - DRIFT[1][1]];
        let missed = match ends[1] {
            End::Pinned => [off[0], off[1], 0.0],
            End::Clamped => [off[0], off[1], tip.angular],
            End::Guided(line) => {
                let (sine, cosine) = (links[n - 1].angle + line).sin_cos();
                [cosine * off[1] - sine * off[0], tip.angular, 0.0]
            }
        };
        found.closure = missed.iter().fold(0.0_f64, |worst, x| worst.max(x.abs()));
        for (x, y) in motion.multipliers().iter().zip(multipliers) {
            found.multipliers = found.multipliers.max((x - y).abs());
        }
    });
    let length: f64 = links.iter().map(|link| link.length).sum();
    found.balance /= force;
    found.forces /= force;
    found.pins /= force * length;
    found.multipliers /= multipliers.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    found.closure /= size;
    found.accelerations /= size;
    Ok(found)
}

#[test]
fn long_chains_between_two_ends_balance() -> Result<(), Error> {
    let (pinned, clamped) = (End::Pinned, End::Clamped);
    let guides = [End::Guided(0.0), End::Guided(0.7)];
    let pairs = [
        [pinned, pinned],
        [pinned, guides[0]],
        [pinned, guides[1]],
        [clamped, guides[0]],
        [guides[0], guides[1]],
        [guides[1], guides[1]],
        [clamped, clamped],
        [guides[0], clamped],
    ];
    for ends in pairs {
        let fewest = if ends == [clamped; 2] { 4 } else { 3 };
        for n in [fewest, 10, 100, 300, 1000] {
            let found = defects(&held(n, ends), ends)?;
            let Defects { balance, pins, forces, closure, multipliers, accelerations, condition } = found;
            println!(
                "{ends:?}, {n} rods: balance {balance:.0e}, pins {pins:.0e}, forces {forces:.0e}, closure {closure:.0e}, accelerations {accelerations:.0e}, \
                 λ {multipliers:.0e} at condition {condition:.0}"
            );
            assert!(balance < 1e-11 && pins < 1e-11 && forces < 1e-11 && closure < 1e-11 && accelerations < 1e-11);
            assert!(multipliers < 1e-14 * condition); // some tens of roundings, times the condition of Λ
        }
    }
    Ok(())
}

/// A zigzag of a thousandth of a radian: the closure forces are known as well as the condition of Λ, up to 6e5, allows.
#[test]
fn chains_that_are_almost_straight_are_solved() -> Result<(), Error> {
    for ends in [[End::Pinned; 2], [End::Clamped, End::Pinned], [End::Clamped; 2]] {
        for n in [4, 20, 300] {
            let mut links = held(n, ends);
            for (k, link) in links.iter_mut().enumerate() {
                link.angle = 0.4 + if k % 2 == 0 { 1e-3 } else { -1e-3 };
            }
            let Defects { closure, accelerations, multipliers, condition, .. } = defects(&links, ends)?;
            println!(
                "{ends:?}, {n} rods: closure {closure:.0e}, accelerations {accelerations:.0e}, λ {multipliers:.0e} at {condition:.0e}"
            );
            assert!(closure.max(accelerations).max(multipliers) < 1e-14 * condition);
        }
    }
    Ok(())
}
