//! The double pendulum of two uniform rods (1 m, 1 kg) released at −π/3: values of an order-8 integration at 1e-13,
//! checked against a Taylor series of 30 digits.

use catena::Error;
use catena::loading::Unloaded;
use catena::planar::*;
use catena::time::{Explicit, Rule};
use catena_oracle::{has_order, near};
use core::f64::consts::FRAC_PI_3;

const ANGLES: [f64; 2] = [-1.3564198519106136, -1.1306522396578225];
const ROOT_FORCE: [f64; 2] = [-3.354922171594491, 20.855383568488572];

type Pendulum = System<f64, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>), Free>;

fn pendulum() -> Result<Pendulum, Error> {
    let rod = Rod::uniform(1.0, 1.0);
    Ok(System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81))
}

/// Errors of the angles and of the pivot force at two seconds.
fn errors<M: Explicit>(rule: Rule<M, f64>) -> Result<[f64; 2], Error> {
    let pendulum = pendulum()?;
    let start = pendulum.at_rest(&[-FRAC_PI_3; 2])?;
    let run = pendulum.simulate(start, rule, 2.0, |_| ())?;
    assert_eq!(run.motion.time(), 2.0);
    let angles = pendulum.angles(&run.motion)?;
    let force = pendulum.stations(&run.motion, &Unloaded)?.root().internal.force;
    let largest = |of: &dyn Fn(usize) -> f64| of(0).abs().max(of(1).abs());
    Ok([largest(&|k| angles.get(k).unwrap() - ANGLES[k]), largest(&|k| force[k] - ROOT_FORCE[k])])
}

#[test]
fn reaches_the_reference_at_two_seconds() -> Result<(), Error> {
    // Error control at 1e-13 leaves about a tenth of that in the angles; forces are some 20 N here, and have the
    // angular accelerations in them.
    let [angles, force] = errors(Dop853::tolerance(1e-13))?;
    println!("angles {angles:.1e} rad, force {force:.1e} N");
    assert!(angles < 1e-12 && force < 1e-10);
    Ok(())
}

#[test]
fn keeps_its_energy_and_its_angles_over_a_minute() -> Result<(), Error> {
    keeps_its_energy(Dop853::tolerance(1e-13))?;
    keeps_its_energy(Dop853::step(0.01))
}

fn keeps_its_energy<M: Explicit>(rule: Rule<M, f64>) -> Result<(), Error> {
    let pendulum = pendulum()?;
    let start = pendulum.at_rest(&[-FRAC_PI_3; 2])?;
    // −(3/2 + 1/2) m g l sin(π/3) = −√3 · 9.81 J.
    let energy = -16.99141842225069;
    let mut drift = 0.0_f64;
    let run = pendulum.simulate(start, rule, 60.0, |now| drift = drift.max((now.energy() - energy).abs()))?;
    println!("drift {drift:.1e} J in {} steps ({} rejected)", run.steps, run.rejected);
    // Rounding alone leaves a tenth of it: 17 J · 1e-16 · the root of 6000 steps.
    assert!(drift < 1e-12);
    // As many digits as the reference has; the motion is regular and multiplies errors by a hundred at most.
    let angles = pendulum.angles(&run.motion)?;
    for (k, expected) in [-1.47135385, -1.28390151].into_iter().enumerate() {
        near(*angles.get(k).unwrap(), expected, 1e-8);
    }
    Ok(())
}

#[test]
fn every_rule_has_its_order_in_angles_and_in_the_pivot_force() -> Result<(), Error> {
    has_its_order("RK4", 4.0, [0.01, 0.005, 0.0025], Rk4::step)?;
    has_its_order("DOPRI5", 5.0, [0.01, 0.005, 0.0025], Dopri5::step)?;
    has_its_order("DOP853", 8.0, [0.05, 0.04, 0.03125, 0.025], Dop853::step)
}

fn has_its_order<M: Explicit, const N: usize>(
    name: &str,
    order: f64,
    steps: [f64; N],
    rule: impl Fn(f64) -> Rule<M, f64>,
) -> Result<(), Error> {
    let mut points = [[(0.0, 0.0); N]; 2];
    for (i, step) in steps.into_iter().enumerate() {
        let [angles, force] = errors(rule(step))?;
        points[0][i] = (step, angles);
        points[1][i] = (step, force);
    }
    // What very small steps leave: 1e-14 rad and 1e-13 N.
    has_order(&format!("{name}, angles"), order, 2e-14, &points[0]);
    has_order(&format!("{name}, pivot force"), order, 2e-13, &points[1]);
    Ok(())
}
