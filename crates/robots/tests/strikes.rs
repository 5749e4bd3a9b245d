//! Impacts of points of bodies against planes: beside a dense robot, and a run of bounces beside its parabolas.

#[path = "../../../tests/it/robots/kit.rs"]
#[allow(dead_code)] // each test needs some of it
mod kit;

use catena::robot::*;
use catena::{Error, Fault};
use catena_oracle::{Noise, near};
use kit::{Drift, agree, drift, fixed, floating, list, plain_fixed};
use nalgebra::{DVector, Vector3};

/// Times the condition of the mass matrix.
const INVERTED: f64 = 1e-12;
const RESTITUTION: f64 = 0.6;
/// Of no length in particular: 3, so that what is along it shows what divides by that.
const NORMAL: [f64; 3] = [1.0, -2.0, 2.0];
const POINT: [f64; 3] = [0.1, -0.2, 0.3];

/// M (v⁺ − v⁻) is Jᵀ n λ for the point's dense J, whose velocity along the normal is turned over if it leads into the plane.
fn strikes(
    now: &catena_oracle::space::robot::Instant,
    joint: Option<usize>,
    [before, after]: [&DVector<f64>; 2],
    impulse: f64,
) {
    let body = joint.map_or_else(|| now.base.as_ref().expect("a base"), |joint| &now.bodies[joint]);
    let arm = body.attitude * Vector3::from(POINT);
    let of_point = &body.of_place - arm.cross_matrix() * &body.of_turn;
    let row = of_point.transpose() * Vector3::from(NORMAL) / 3.0;
    let [approach, rebound] = [row.dot(before), row.dot(after)];
    if approach >= 0.0 {
        assert!(after == before && impulse == 0.0, "what leaves a plane is not struck: {impulse}");
        return;
    }
    let moved = &now.mass * (after - before);
    assert!(impulse > 0.0, "{impulse}");
    agree(&[rebound], &[-RESTITUTION * approach], INVERTED);
    agree(moved.as_slice(), (&row * impulse).as_slice(), INVERTED);
    // What the plane takes is half the impulse times (1 − e) times the approach.
    let energy = |v: &DVector<f64>| 0.5 * v.dot(&(&now.mass * v));
    agree(&[energy(after)], &[energy(before) + 0.5 * impulse * (1.0 - RESTITUTION) * approach], INVERTED);
}

#[test]
fn of_a_fixed_base() -> Result<(), Error> {
    let (scene, plain, mut noise) = (fixed()?, plain_fixed(), Noise::new(81));
    for _ in 0..10 {
        let (q, v) = (list::<6>(&mut noise, 2.0), list::<6>(&mut noise, 2.0));
        let now = plain.at(&q, &v);
        for joint in 0..6 {
            let (after, impulse) = scene.impact_of_point(&q, &v, (joint, POINT), NORMAL, RESTITUTION)?;
            let [before, after] = [v, after].map(|list| DVector::from_column_slice(&list));
            strikes(&now, Some(joint), [&before, &after], impulse);
        }
    }
    Ok(())
}

#[test]
fn of_a_base_that_floats() -> Result<(), Error> {
    let (scene, mut noise) = (floating()?, Noise::new(82));
    let rates = |base: &Afloat<f64>, v: &[f64; 5]| {
        DVector::from_iterator(11, base.velocity.iter().chain(base.spin.iter()).chain(v).copied())
    };
    for _ in 0..10 {
        let Drift { start, plain, q, v } = drift(&scene, &mut noise)?;
        let base = scene.body_motions(&start)?.get(0).map(Afloat::of).expect("a base");
        let now = plain.at(&q, &v);
        for joint in [None, Some(0), Some(1), Some(2), Some(3), Some(4)] {
            let (moved, after, impulse) =
                scene.impact_of_point_afloat(base, [&q, &v], (joint, POINT), NORMAL, RESTITUTION)?;
            assert_eq!(moved.place, base.place);
            strikes(&now, joint, [&rates(&base, &v), &rates(&moved, &after)], impulse);
        }
    }
    Ok(())
}

/// A weight on a vertical slide falls upon the floor, again and again: parabolas whose heights shrink by e².
#[test]
fn bounces() -> Result<(), Error> {
    const FALL: f64 = 1.25; // (m)
    const GRAVITY: f64 = 10.0;
    let weight = Link::general(2.0, [0.0; 3], [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]);
    let scene = System::new(Base::origin(), (Slide::level(), weight), Free)?.with_gravity([0.0, 0.0, -GRAVITY]);
    let (foot, up) = ([0.0, 0.0, -0.1], [0.0, 0.0, 1.0]);
    let mut now = scene.at_joints(&[FALL + 0.1], &[0.0])?;
    let (mut speed, mut expected) = ((2.0 * GRAVITY * FALL).sqrt(), (2.0 * FALL / GRAVITY).sqrt());
    let mut impacts = 0;
    while impacts < 6 {
        let run =
            scene.simulation(Dop853::tolerance(1e-12)).event(|now| now.motion().coordinates()[0] - 0.1).stopping();
        now = run.run(now, 10.0, |_| ())?.motion;
        let (mut q, mut v) = ([0.0], [0.0]);
        now.coordinates_into(&mut q)?;
        now.rates_into(&mut v)?;
        impacts += 1;
        near(now.time(), expected, 1e-11);
        near(v[0], -speed, 1e-11);
        let (after, impulse) = scene.impact_of_point(&q, &v, (0, foot), up, RESTITUTION)?;
        near(impulse, 2.0 * speed * (1.0 + RESTITUTION), 1e-11);
        speed *= RESTITUTION;
        expected += 2.0 * speed / GRAVITY;
        now = scene.with_rates(now, &after)?;
    }
    Ok(())
}

#[test]
fn what_makes_no_sense_is_refused() -> Result<(), Error> {
    let (scene, q, v) = (fixed()?, [0.3; 6], [0.1; 6]);
    let fault = |joint, point, normal, e| {
        scene.impact_of_point(&q, &v, (joint, point), normal, e).map(|_| ()).map_err(|error| error.fault)
    };
    assert_eq!(fault(6, POINT, NORMAL, 0.5), Err(Fault::NoSuchJoint { joint: 6, joints: 6 }));
    assert!(matches!(fault(0, POINT, NORMAL, 1.5), Err(Fault::OutOfRange { value: 1.5, .. })));
    assert_eq!(fault(0, [f64::NAN; 3], NORMAL, 0.5), Err(Fault::NonFiniteMotion));
    assert_eq!(fault(0, POINT, [f64::INFINITY; 3], 0.5), Err(Fault::NonFiniteMotion));
    // No direction; the first hinge about z moves no point along it.
    assert_eq!(fault(0, POINT, [0.0; 3], 0.5), Err(Fault::NonFiniteMotion));
    assert_eq!(fault(0, POINT, [0.0, 0.0, 1.0], 0.5), Err(Fault::NonFiniteMotion));
    Ok(())
}
