//! Random arms whose joints rub, strike and do both: no run is refused, whatever friction at rest is beside that of a slip, and none gains energy.

use catena::Error;
use catena::planar::*;
use catena_oracle::Noise;

/// Of these some joint once had no mode, was turned round by a shock, or came to rest and slipped on within a step.
const HARD: [u64; 12] = [29, 57, 298, 435, 507, 723, 1050, 1396, 1550, 3435, 3528, 3903];

/// The largest rise of energy (J) of an arm in two seconds, whose joints break away at up to so many times the friction with which they slip.
fn rise(seed: u64, most: f64) -> Result<f64, Error> {
    let mut random = Noise::new(seed);
    let mut between = |least: f64, most: f64| random.between(least, most);
    let rods = [0; 4].map(|_| Rod::uniform(between(0.4, 1.0), between(0.5, 1.5)));
    let friction = between(0.05, 0.8);
    let shoulder = Coulomb::new(Revolute::smooth(), friction).breaking_away(friction * between(1.0, most));
    let range = [between(-1.0, -0.2), between(0.2, 1.0)];
    let elbow = HardStops::between(Revolute::smooth(), range).rebounding(between(0.2, 0.9));
    let (friction, range) = (between(0.02, 0.4), [between(-1.0, -0.2), between(0.2, 1.0)]);
    let wrist = Coulomb::new(Revolute::smooth(), friction).breaking_away(friction * between(1.0, most));
    let wrist = wrist.between(range).rebounding(between(0.2, 0.9));
    let chain = (rods[0], shoulder, rods[1], elbow, rods[2], wrist, rods[3]);
    let arm = System::new(Pinned::origin(), chain, Free)?.with_gravity(between(8.0, 10.0));
    let mut start = arm.motion();
    start.set_coordinates(&[between(-0.5, 0.5), between(-1.0, 1.0), between(-0.19, 0.19), between(-0.19, 0.19)])?;
    let rates = [between(-2.0, 2.0), between(-2.0, 2.0), between(-2.0, 2.0), between(-2.0, 2.0)];
    let start = arm.with_rates(start, &rates)?;
    let (mut rise, mut last) = (0.0_f64, f64::INFINITY);
    arm.simulation(Dop853::tolerance(1e-9)).run(start, 2.0, |now| {
        rise = rise.max(now.energy() - last);
        last = now.energy();
    })?;
    Ok(rise)
}

#[test]
fn random_arms_are_never_refused_and_gain_no_energy() -> Result<(), Error> {
    let mut largest = 0.0_f64;
    for seed in (0..40).chain(HARD) {
        for most in [1.0, 1.5, 3.0] {
            largest = largest.max(rise(seed, most)?);
        }
    }
    println!("energy rises by {largest:.1e} J at most");
    assert!(largest < 1e-7, "{largest}");
    Ok(())
}
