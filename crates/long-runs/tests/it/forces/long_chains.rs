//! Chains that are hard on a sweep: links without mass, a hundred thousand bodies, chains that float, half precision.

use catena::loading::Unloaded;
use catena::planar::*;
use catena::system::{Position, Rate};
use catena::{Error, Scalar};
use catena_oracle::Noise;
use catena_oracle::plane::{self as oracle, Scene};
use core::f64::consts::{FRAC_PI_2, TAU};

const G: f64 = 9.81;

/// The outboard end of such a link is the centre of percussion of its inboard end: no transfer matrix exists.
#[test]
fn a_chain_of_point_masses_moves_as_the_oracle_says_and_keeps_its_energy() -> Result<(), Error> {
    let noise = &mut Noise::new(5);
    let sizes: Vec<[f64; 2]> = (0..4).map(|_| [noise.between(0.5, 1.2), noise.between(0.5, 2.0)]).collect();
    let angles: Vec<f64> = (0..4).map(|_| noise.between(-1.5, 0.3)).collect();
    let rates: Vec<f64> = (0..4).map(|_| noise.next()).collect();

    let links = sizes.iter().map(|[length, mass]| PointMass::new(*length, *mass));
    let chain = (links.clone().next().unwrap(), links.skip(1).map(|link| (Pin, link)).collect::<Vec<_>>());
    let system = System::new(Pinned::origin(), chain, Free)?.with_gravity(G);
    let start = system.with_rates(system.at_rest(&angles)?, &rates)?;
    let before = system.budget(&start)?;
    let before = before.kinetic + before.potential;
    let mut drift = 0.0_f64;
    let run = system.simulate(start, Dop853::tolerance(1e-13), 1.0, |now| {
        drift = drift.max((now.energy() - before).abs());
    })?;

    let body = |[length, mass]: &[f64; 2]| oracle::Body {
        mass: *mass,
        inertia_c: 0.0,
        centre: [*length, 0.0],
        outboard: [*length, 0.0],
    };
    let scene = Scene::pinned(sizes.iter().map(body).collect());
    let (expected, expected_rates) = scene.integrate(&angles, &rates, 1.0, 1e-12);
    let bodies = system.body_motions(&run.motion)?;
    let mut worst = 0.0_f64;
    for (k, body) in bodies.iter().enumerate() {
        worst = worst.max((body.angle() - expected[k]).abs()).max((body.rate() - expected_rates[k]).abs());
    }
    println!("{} steps, largest difference {worst:.1e}, energy drift {drift:.1e} J", run.steps);
    // The oracle's own tolerance is 1e-12 a step, and four links that fall multiply errors by about ten in a second.
    assert!(worst < 1e-10);
    // Some fifty joules, tolerance 1e-13 in each step.
    assert!(drift < 1e-11);
    Ok(())
}

const LENGTH: f64 = 1.0;
const MASS: f64 = 1.0;

/// A bent chain of `n` equal rods that moves: angles and rates vary smoothly along it.
fn bent(n: usize) -> (Vec<f64>, Vec<f64>) {
    let along = |k: usize| k as f64 / n as f64;
    let angle = |k| -FRAC_PI_2 + 0.8 * (3.0 * TAU * along(k)).sin() + 0.3 * (7.0 * TAU * along(k)).cos();
    let rate = |k| 0.02 * (2.0 * TAU * along(k)).cos() + 0.01 * (5.0 * TAU * along(k)).sin();
    ((0..n).map(angle).collect(), (0..n).map(rate).collect())
}

/// What Newton's and Euler's laws leave of the moment at each pin, relative to the largest force times a rod's length:
/// from angles, rates and angular accelerations, body by body, by a recursion that has nothing in common with the
/// crate. The accelerations of the pins come from the root outward, the forces from the tip inward.
fn residual(angles: &[f64], rates: &[f64], accelerations: &[f64]) -> f64 {
    let turn = |k: usize, share: f64| {
        let (s, c) = f64::sin_cos(angles[k]);
        let (length, w2, a) = (share * LENGTH, rates[k] * rates[k], accelerations[k]);
        [length * (-s * a - c * w2), length * (c * a - s * w2)]
    };
    let mut pin = [0.0; 2];
    let mut centres = vec![];
    for k in 0..angles.len() {
        let (half, whole) = (turn(k, 0.5), turn(k, 1.0));
        centres.push([pin[0] + half[0], pin[1] + half[1]]);
        pin = [pin[0] + whole[0], pin[1] + whole[1]];
    }
    let (mut force, mut largest, mut worst) = ([0.0_f64; 2], 0.0_f64, 0.0_f64);
    for k in (0..angles.len()).rev() {
        // Moments about the mass centre: the forces at both ends, and J_C α.
        let (s, c) = f64::sin_cos(angles[k]);
        let arm = [0.5 * LENGTH * c, 0.5 * LENGTH * s];
        let outer = force;
        force = [outer[0] + MASS * centres[k][0], outer[1] + MASS * (centres[k][1] + G)];
        let sum = [outer[0] + force[0], outer[1] + force[1]];
        let moment = -(arm[0] * sum[1] - arm[1] * sum[0]) - MASS * LENGTH * LENGTH / 12.0 * accelerations[k];
        worst = worst.max(moment.abs());
        largest = largest.max(force[0].hypot(force[1]));
    }
    worst / (largest * LENGTH)
}

/// A bent chain with its accelerations, and what is left of the moments at its pins.
///
/// Inverse dynamics has no pins to start anew from: what is left at a pin is the sum of the residuals of all bodies
/// outboard of it. So a body's own residual, the difference from one pin to the next, is measured by a rod's length,
/// and the sum by the length of the chain, both times the largest force. The recursion above gives each body's own.
fn residuals<T: Scalar>(n: usize, read: impl Fn(T) -> f64) -> Result<[f64; 3], Error> {
    let rod = Rod::uniform(T::literal(LENGTH), T::literal(MASS));
    let system = System::new(Pinned::origin(), (rod, vec![(Pin, rod); n - 1]), Free)?.with_gravity(T::literal(G));
    let (angles, rates) = bent(n);
    let of = |list: &[f64]| list.iter().map(|x| T::literal(*x)).collect::<Vec<_>>();
    let motion = system.with_rates(system.at_rest(&of(&angles))?, &of(&rates))?;
    let motion = system.with_accelerations(motion, &Unloaded)?;

    let stations = system.stations(&motion, &Unloaded)?;
    let (mut own, mut sum, mut force, mut inner) = (0.0_f64, 0.0_f64, 0.0_f64, None);
    for station in stations.iter() {
        let moment = read(station.internal.torque);
        own = own.max((moment - inner.unwrap_or(moment)).abs());
        sum = sum.max(moment.abs());
        force = force.max(read(station.internal.force.x).hypot(read(station.internal.force.y)));
        inner = Some(moment);
    }
    // Exactly the numbers that the sweep saw.
    let (mut angles, mut rates, mut accelerations) = (vec![], vec![], vec![]);
    Position::visit(motion.position(), &mut |x| angles.push(read(x)));
    Rate::visit(motion.rate(), &mut |x| rates.push(read(x)));
    Rate::visit(motion.acceleration(), &mut |x| accelerations.push(read(x)));
    let largest = accelerations.iter().fold(0.0, |largest: f64, a| largest.max(a.abs()));
    println!("{n} bodies: largest force {force:.2e} N, largest angular acceleration {largest:.2e} rad/s²");
    let found = [own / (force * LENGTH), sum / (force * LENGTH * n as f64), residual(&angles, &rates, &accelerations)];
    println!("  of a body {:.1e}, of all {:.1e}, of a body by the recursion {:.1e}", found[0], found[1], found[2]);
    Ok(found)
}

#[test]
fn a_hundred_thousand_moving_bodies_are_in_balance() -> Result<(), Error> {
    // Accelerations of pins are sums over the chain: rounded a hundred thousand times, to some 1e-14 of the largest.
    assert!(residuals::<f64>(100_000, |x| x)?.iter().all(|residual| *residual < 1e-11));
    // The same in half the digits.
    assert!(residuals::<f32>(100_000, f64::from)?.iter().all(|residual| *residual < 1e-2));
    Ok(())
}

#[test]
fn a_hundred_thousand_bodies_take_steps() -> Result<(), Error> {
    let n = 100_000;
    let rod = Rod::uniform(LENGTH, MASS);
    let system = System::new(Pinned::origin(), (rod, vec![(Pin, rod); n - 1]), Free)?.with_gravity(G);
    let (angles, rates) = bent(n);
    let start = system.with_rates(system.at_rest(&angles)?, &rates)?;
    let before = system.budget(&start)?;
    let run = system.simulate(start, Rk4::step(1e-3), 5e-3, |_| ())?;
    let after = system.budget(&run.motion)?;
    let drift = (after.kinetic + after.potential - before.kinetic - before.potential).abs();
    let exchanged = (after.kinetic - before.kinetic).abs();
    println!("energy drift {:.1e} of the energy exchanged, {exchanged:.1e} J", drift / exchanged);
    // Fourth powers of 1e-3 s against a time scale of some 0.1 s, and sums of 1e5 energies.
    assert!(drift / exchanged < 1e-6);
    Ok(())
}

#[test]
fn a_floating_chain_keeps_its_momenta_and_its_energy() -> Result<(), Error> {
    let noise = &mut Noise::new(17);
    let mut body = || {
        let centre = [0.3 * noise.next(), 0.3 * noise.next()];
        let outboard = [0.8 + 0.3 * noise.next(), 0.3 * noise.next()];
        RigidBody::new(noise.between(0.5, 2.0), noise.between(0.1, 0.4), centre, outboard)
    };
    let chain = (body(), [(Pin, body()), (Pin, body()), (Pin, body()), (Pin, body())]);
    let angles = [0.4, -0.7, 1.1, -0.2, 2.0];
    let rates = [0.3, -0.5, 1.5, -2.0, 1.0, -0.7, 0.9]; // x, y, and the angles
    for g in [0.0, G] {
        let system = System::new(Free, chain, Free)?.with_gravity(g);
        let start = system.with_rates(system.at_rest(&angles)?, &rates)?;
        let before = system.budget(&start)?;
        let bodies = system.body_motions(&start)?;
        let mass: f64 = bodies.iter().map(|body| body.inertia.mass).sum();
        let first: f64 = bodies.iter().map(|body| body.inertia.mass * body.centre().place.x).sum();
        let mut worst = [0.0_f64; 4];
        let run = system.simulate(start, Dop853::tolerance(1e-13), 10.0, |now| {
            let (t, after) = (now.time(), now.budget());
            // Gravity adds −m g t to the momentum, and the moment of the whole weight, whose centre moves evenly along
            // x.
            let moment = -g * (first * t + before.momentum.x * t * t / 2.0);
            let quantities = [
                (after.momentum.x, before.momentum.x),
                (after.momentum.y, before.momentum.y - mass * g * t),
                (after.angular_momentum, before.angular_momentum + moment),
                (after.kinetic + after.potential, before.kinetic + before.potential),
            ];
            // Relative to the potential and kinetic energies of which the last is the difference, and to what else
            // grows.
            let sizes = [1.0, 1.0, 1.0 + moment.abs(), 1.0 + after.kinetic];
            for ((worst, (found, expected)), size) in worst.iter_mut().zip(quantities).zip(sizes) {
                *worst = worst.max((found - expected).abs() / size.max(found.abs()));
            }
        })?;
        println!(
            "g = {g}: momentum {:.1e} {:.1e}, angular {:.1e}, energy {:.1e}",
            worst[0], worst[1], worst[2], worst[3]
        );
        // No more than the tolerances of all steps.
        let most = 1e-13 * run.steps as f64;
        assert!(worst.iter().all(|worst| *worst < most), "{} steps", run.steps);
    }
    Ok(())
}
