//! The flexible pendulum: 20 rods with rotary springs between them, under every kind of rule.

use catena::Error;
use catena::element::Unloaded;
use catena::planar::*;
use core::f64::consts::FRAC_PI_3;

type Pendulum = System<f64, Pinned<[f64; 2]>, (Rod<f64>, [(ElasticHinge<Rotary<f64>>, Rod<f64>); 19]), Free>;

/// Length 1 m, mass 1 kg, EI = 1 N·m² in 20 segments: springs EI/ℓ between them.
fn pendulum() -> Result<Pendulum, Error> {
    let rod = Rod::uniform(0.05, 0.05);
    Ok(System::new(Pinned::origin(), (rod, [(ElasticHinge::rotary(20.0), rod); 19]), Free)?.with_gravity(9.81))
}

/// Order-8 integration at 1e-13 of dense equations in relative coordinates, which agrees with other tolerances to 2e-11:
/// time, first and last angle, pivot force.
const FROM_60_DEGREES: [(f64, [f64; 2], [f64; 2]); 3] = [
    (0.1, [-1.12169572331, -1.02925061284], [-3.09664549, 8.60487169]),
    (0.5, [-1.74835990285, -1.69361309640], [2.19929286, 11.22066973]),
    (1.0, [-1.94868975084, -2.07565916812], [2.47777679, 9.35481087]),
];

#[test]
fn explicit_integration_meets_the_reference() -> Result<(), Error> {
    let pendulum = pendulum()?;
    let mut motion = pendulum.at_rest(&[-FRAC_PI_3; 20])?;
    for (time, angles, force) in FROM_60_DEGREES {
        motion = pendulum.simulate(motion, Dop853::tolerance(1e-12), time, |_| ())?.motion;
        let found = pendulum.angles(&motion);
        let root = pendulum.stations(&motion, &Unloaded).root().unwrap().internal.force;
        println!("{time} {:e} {:e}", found.get(0).unwrap() - angles[0], found.get(19).unwrap() - angles[1]);
        println!("{:e} {:e}", root.x - force[0], root.y - force[1]);
        assert!(
            (found.get(0).unwrap() - angles[0]).abs() < 3e-11 && (found.get(19).unwrap() - angles[1]).abs() < 3e-11
        );
        assert!((root.x - force[0]).abs() < 2e-8 && (root.y - force[1]).abs() < 2e-8);
    }
    Ok(())
}

#[test]
fn two_sweeps_a_step_survive_where_one_does_not() -> Result<(), Error> {
    let pendulum = pendulum()?;
    for (name, rule) in [("alpha", GeneralizedAlpha::new(0.8)), ("trapezoidal", GeneralizedAlpha::trapezoidal())] {
        for sweeps in [1, 2, 3] {
            for h in [0.02, 0.01, 0.005, 0.0025] {
                let start = pendulum.at_rest(&[-FRAC_PI_3; 20])?;
                let (mut first, mut drift) = (None, 0.0_f64);
                let outcome = pendulum.simulate(start, rule.with_sweeps(sweeps).step(h), 45.0, |now| {
                    let energy = now.energy();
                    let first = *first.get_or_insert(energy);
                    if now.time() > 40.0 {
                        drift = drift.max((energy - first).abs());
                    }
                });
                println!("{name} {sweeps} {h} {:?} {drift:e}", outcome.map(|run| run.steps).map_err(|e| e.error));
            }
        }
    }
    Ok(())
}
