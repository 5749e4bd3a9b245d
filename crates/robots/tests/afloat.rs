//! Robots whose base floats: energy and impacts against a dense robot, bases whose attitude is none.

#[path = "../../../tests/it/robots/kit.rs"]
#[allow(dead_code)] // each test needs some of it
mod kit;

use catena::robot::*;
use catena::{Error, Fault};
use catena_oracle::Noise;
use kit::{Drift, agree, drift, floating};
use nalgebra::{DVector, Vector3};

const DIRECT: f64 = 1e-13;
/// Times the condition of the mass matrix.
const INVERTED: f64 = 1e-12;

/// Rates of base and joints.
fn rates(base: &Afloat<f64>, v: &[f64; 5]) -> DVector<f64> {
    DVector::from_iterator(11, base.velocity.iter().chain(base.spin.iter()).chain(v).copied())
}

#[test]
fn energies() -> Result<(), Error> {
    let (scene, mut noise) = (floating()?, Noise::new(71));
    for _ in 0..20 {
        let Drift { start, plain, q, v } = drift(&scene, &mut noise)?;
        let base = scene.body_motions(&start)?.get(0).map(Afloat::of).expect("a base");
        let now = plain.at(&q, &v);
        agree(&scene.joint_energy_afloat(base, &q, &v)?, &[now.kinetic, now.potential], DIRECT);
    }
    Ok(())
}

/// M (v⁺ − v⁻) is an impulse on the joint alone, whose rate is turned over.
#[test]
fn impacts() -> Result<(), Error> {
    const RESTITUTION: f64 = 0.6;
    let (scene, mut noise) = (floating()?, Noise::new(72));
    for _ in 0..10 {
        let Drift { start, plain, q, v } = drift(&scene, &mut noise)?;
        let base = scene.body_motions(&start)?.get(0).map(Afloat::of).expect("a base");
        let mass = plain.at(&q, &v).mass;
        for joint in 0..5 {
            let (moved, after, impulse) = scene.impact_afloat(base, &q, &v, joint, RESTITUTION)?;
            assert_eq!(moved.place, base.place);
            agree(&[after[joint]], &[-RESTITUTION * v[joint]], INVERTED);
            let mut right = [0.0; 11];
            right[6 + joint] = impulse;
            agree((mass.clone() * (rates(&moved, &after) - rates(&base, &v))).as_slice(), &right, INVERTED);
            // What nothing outside acts on keeps its momenta, and what a stop takes is half its impulse times (1 − e) v.
            let [before, behind] = [scene.snapshot_afloat(base, &q, &v)?, scene.snapshot_afloat(moved, &q, &after)?];
            let ([p, l], [r, m]) = (before.centroidal_momentum(), behind.centroidal_momentum());
            agree(p.as_slice(), r.as_slice(), INVERTED);
            agree(l.as_slice(), m.as_slice(), INVERTED);
            let [[first, _], [second, _]] =
                [scene.joint_energy_afloat(base, &q, &v)?, scene.joint_energy_afloat(moved, &q, &after)?];
            agree(&[second], &[first + 0.5 * impulse * (1.0 - RESTITUTION) * v[joint]], INVERTED);
        }
        let fault = |joint, e| scene.impact_afloat(base, &q, &v, joint, e).map(|_| ()).map_err(|error| error.fault);
        assert_eq!(fault(5, 0.5), Err(Fault::NoSuchJoint { joint: 5, joints: 5 }));
        assert!(matches!(fault(0, 1.5), Err(Fault::OutOfRange { value: 1.5, .. })));
    }
    Ok(())
}

/// Axes that are 1.01 long, sheared or mirrored gave wrong numbers.
#[test]
fn attitudes_that_are_none_are_refused() -> Result<(), Error> {
    let (scene, still) = (floating()?, Vector3::zeros());
    let (q, o, wrench) = ([0.3; 5], [0.0; 5], [0.0; 6]);
    let Columns { x, y, z } = kit::lean().matrix();
    let (nan, none) = (Vector3::repeat(f64::NAN), Vector3::zeros());
    let spoilt = [
        (Columns { x: x * 1.01, y: y * 1.01, z: z * 1.01 }, none),
        (Columns { x, y: y + x * 0.01, z }, none),
        (Columns { x, y, z: -z }, none),
        (Columns { x: none, y: none, z: none }, none),
        (Columns { x, y, z: nan }, none),
        (Columns { x, y, z }, nan),
    ];
    let answers = |place: Place<f64>| {
        let base = Afloat { place, velocity: still, spin: still };
        [
            scene.snapshot_afloat(base, &q, &o).map(|_| ()),
            scene.forward_dynamics_afloat(base, &q, &o, &wrench, &o).map(|_| ()),
            scene.inverse_dynamics_afloat(base, &q, &o, &wrench, &o).map(|_| ()),
            scene.inverse_dynamics_derivatives_afloat(base, &q, &o, &wrench, &o).map(|_| ()),
            scene.forward_dynamics_derivatives_afloat(base, &q, &o, &wrench, &o).map(|_| ()),
            scene.jacobian_afloat(place, &q, Some(1), [0.0; 3]).map(|_| ()),
            scene.jacobian_afloat(place, &q, None, [0.0; 3]).map(|_| ()),
            scene.mass_matrix_afloat(place, &q).map(|_| ()),
            scene.mass_solved_afloat(place, &q, &wrench, &o).map(|_| ()),
            scene.mass_inverse_afloat(place, &q).map(|_| ()),
            scene.joint_energy_afloat(base, &q, &o).map(|_| ()),
            scene.impact_afloat(base, &q, &o, 0, 0.5).map(|_| ()),
            scene
                .difference_afloat((place, &q), (Place { place: still, attitude: Columns { x, y, z } }, &q))
                .map(|_| ()),
            scene
                .difference_afloat((Place { place: still, attitude: Columns { x, y, z } }, &q), (place, &q))
                .map(|_| ()),
            scene.integrate_afloat((place, &q), (&wrench, &o)).map(|_| ()),
        ]
    };
    for (k, (attitude, place)) in spoilt.into_iter().enumerate() {
        for (i, answer) in answers(Place { place, attitude }).into_iter().enumerate() {
            let fault = answer.expect_err("no turn").fault;
            let right = if k < 4 { matches!(fault, Fault::NotZero { .. }) } else { fault == Fault::NonFiniteMotion };
            assert!(right, "attitude {k}, function {i}: {fault:?}");
        }
    }
    assert!(answers(Place { place: still, attitude: Columns { x, y, z } }).iter().all(Result::is_ok));
    Ok(())
}
