//! Heavy loads on ropes in space come to rest from afar, in few steps: counted by sweeps, against dense Newton iterations in the plane and
//! the balance of torques in space.

use catena::loading::Unloaded;
use catena::spatial::*;
use catena::{Error, Fault};
use core::cell::Cell;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

const G: f64 = 9.81;
const LENGTH: f64 = 20.0;
const BENDING: f64 = 50.0;
const TORSION: f64 = 20.0;
const DENSITY: f64 = 1.0;
const LOAD: f64 = 500.0;

type Root = Clamped<[f64; 3], Rotation<f64>>;
type Chain = (Segments<f64, Vec<(ElasticBall<f64>, Rod<f64>)>>, RigidBody<f64>);
type Crane = System<f64, Root, Chain, Free>;
type Rest = catena::system::MotionOf<Spatial<f64>, Root, Chain, Free>;

/// A rope along x in so many segments with a load of 500 kg whose mass centre is at a place in its axes.
fn crane(segments: usize, centre: [f64; 3], pull: Vector3<f64>) -> Result<Crane, Error> {
    let rope = Beam::new(LENGTH, [BENDING; 2], TORSION, DENSITY, 1e-4);
    let own = |k: usize| core::array::from_fn(|i| if i == k { 50.0 } else { 0.0 });
    let load = RigidBody::new(LOAD, [own(0), own(1), own(2)], centre, [0.1, 0.0, 0.0]);
    Ok(System::new(Clamped::origin(), (rope.segments_in_vec(segments), load), Free)?.with_gravity_vector(pull))
}

/// The equilibrium from a straight guess, and how many steps of Newton's method it took: each linearises by sixteen sweeps for each
/// coordinate, and a sweep asks once for the load on each body.
fn rest(crane: &Crane, segments: usize) -> Result<(Rest, f64), Error> {
    let asked = Cell::new(0_usize);
    let count = Loads::none().on_bodies(|_: f64, body, _: &BodyMotion<f64>| {
        asked.set(asked.get() + usize::from(body == 0));
        Wrench::default()
    });
    let found = crane.equilibrium(crane.motion(), &count)?;
    Ok((found, asked.get() as f64 / (16 * 3 * segments) as f64))
}

/// φ of a rotation matrix by its skew part: exact below a quarter turn.
fn rotation_vector(turn: Matrix3<f64>) -> Vector3<f64> {
    let skew =
        0.5 * Vector3::new(turn[(2, 1)] - turn[(1, 2)], turn[(0, 2)] - turn[(2, 0)], turn[(1, 0)] - turn[(0, 1)]);
    let sine = skew.norm();
    let angle = sine.atan2(0.5 * (turn.trace() - 1.0));
    if sine == 0.0 { skew } else { skew * (angle / sine) }
}

/// The largest torque (N·m) that is left in a spring of the rope, with those that it balances as a measure: springs (1 + ½ φ × + c φ × φ ×) K φ
/// against the moments of all weights outboard, from places and attitudes of bodies alone.
fn torque_left(crane: &Crane, at: &Rest, segments: usize, pull: Vector3<f64>) -> [f64; 2] {
    let bodies: Vec<_> = crane.body_motions(at).unwrap().iter().copied().collect();
    let spacing = LENGTH / segments as f64;
    let masses: Vec<f64> = (0..=segments)
        .map(|k| DENSITY * spacing * if k == 0 || k == segments { 0.5 } else { 1.0 })
        .chain([LOAD])
        .collect();
    let frame = |body: &BodyMotion<f64>| {
        Matrix3::from_columns(&[
            body.turned([1.0, 0.0, 0.0]),
            body.turned([0.0, 1.0, 0.0]),
            body.turned([0.0, 0.0, 1.0]),
        ])
    };
    let stiffness = Vector3::new(TORSION, BENDING, BENDING) / spacing;
    let mut worst = [0.0_f64; 2];
    for k in 1..=segments {
        let (inboard, outboard) = (frame(&bodies[k - 1]), frame(&bodies[k]));
        let phi = rotation_vector(inboard.transpose() * outboard);
        let angle = phi.norm();
        let c = if angle < 1e-3 {
            1.0 / 12.0 + angle * angle / 720.0
        } else {
            (1.0 - 0.5 * angle / (0.5 * angle).tan()) / (angle * angle)
        };
        let force = phi.component_mul(&stiffness);
        let spring = inboard * (force + 0.5 * phi.cross(&force) + c * phi.cross(&phi.cross(&force)));
        let hinge = bodies[k].inboard.place;
        let moment = (k..masses.len())
            .fold(Vector3::zeros(), |sum, j| sum + (bodies[j].centre().place - hinge).cross(&(pull * masses[j])));
        worst = [worst[0].max((moment - spring).amax()), worst[1].max(spring.amax())];
    }
    worst
}

/// Slopes of the rope's bodies in the plane of its load, x along gravity, by Newton's method on the energy
/// Σ ½ k (θ_i − θ_{i−1})² − Σ m g x, from a guess.
fn dense(segments: usize, centre: [f64; 2], guess: &[f64]) -> Vec<f64> {
    let spacing = LENGTH / segments as f64;
    let mut angles = guess.to_vec();
    let (n, spring) = (segments, BENDING / spacing);
    for _ in 0..50 {
        let (mut k, mut right) = (DMatrix::<f64>::zeros(n, n), DVector::<f64>::zeros(n));
        let mut outboard = LOAD * G;
        for i in (0..n).rev() {
            let (s, c) = angles[i].sin_cos();
            // The last rod is half a one, and carries the load.
            let length = if i + 1 == n { 0.5 * spacing } else { spacing };
            let weight = DENSITY * length * G;
            let pull = length * (outboard + 0.5 * weight);
            outboard += weight;
            right[i] -= pull * s;
            k[(i, i)] += pull * c;
            if i + 1 == n {
                right[i] -= LOAD * G * (centre[0] * s + centre[1] * c);
                k[(i, i)] += LOAD * G * (centre[0] * c - centre[1] * s);
            }
            let strain = angles[i] - if i > 0 { angles[i - 1] } else { 0.0 };
            right[i] -= spring * strain;
            k[(i, i)] += spring;
            if i > 0 {
                right[i - 1] += spring * strain;
                k[(i - 1, i - 1)] += spring;
                k[(i, i - 1)] -= spring;
                k[(i - 1, i)] -= spring;
            }
        }
        let step = k.lu().solve(&right).expect("a stable equilibrium");
        (0..n).for_each(|i| angles[i] += step[i]);
        if step.amax() < 1e-15 {
            break;
        }
    }
    angles
}

#[test]
fn a_load_beside_its_rope_comes_to_rest_in_few_steps() -> Result<(), Error> {
    // The load hangs 5 cm beside the rope, in a plane askew.
    let (across, up) = (0.8, 0.6);
    for segments in [8, 10, 50] {
        let pull = Vector3::new(G, 0.0, 0.0);
        let crane = crane(segments, [0.0, 0.05 * across, 0.05 * up], pull)?;
        let (found, steps) = rest(&crane, segments)?;
        let [left, most] = torque_left(&crane, &found, segments, pull);
        let arms: Vec<Vector3<f64>> =
            crane.body_motions(&found)?.iter().map(|body| body.turned([1.0, 0.0, 0.0])).collect();
        let slopes: Vec<f64> =
            arms[1..=segments].iter().map(|arm| (arm.y * across + arm.z * up).atan2(arm.x)).collect();
        let expected = dense(segments, [0.0, 0.05], &slopes);
        let off = slopes.iter().zip(&expected).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        let aside = arms.iter().fold(0.0_f64, |most, arm| most.max((arm.z * across - arm.y * up).abs()));
        println!(
            "{segments}: {steps:.1} steps, {off:.1e} rad off, {aside:.1e} out of the plane, {left:.1e} of {most:.1} N·m left"
        );
        assert!(steps < 7.0 && off < 1e-13 && aside < 1e-13 && left < 1e-9 * most, "{segments}");
    }
    Ok(())
}

#[test]
fn a_load_falls_to_rest_from_the_horizontal() -> Result<(), Error> {
    let pull = Vector3::new(0.0, -G, 0.0);
    for centre in [[0.0, 0.05, 0.0], [0.0, 0.0, 0.05], [0.05, 0.0, 0.0], [0.03, -0.02, 0.04]] {
        for segments in [8, 10, 20] {
            let crane = crane(segments, centre, pull)?;
            let (found, steps) = rest(&crane, segments)?;
            let [left, most] = torque_left(&crane, &found, segments, pull);
            println!("{segments}, load at {centre:?}: {steps:.1} steps, {left:.1e} of {most:.1} N·m left");
            assert!(steps < 50.0 && left < 1e-9 * most, "{segments}, {centre:?}");
        }
    }
    Ok(())
}

/// A long rope: some seconds.
#[test]
fn two_hundred_segments_take_no_more_steps() -> Result<(), Error> {
    let pull = Vector3::new(G, 0.0, 0.0);
    let crane = crane(200, [0.0, 0.03, 0.04], pull)?;
    let (found, steps) = rest(&crane, 200)?;
    let [left, most] = torque_left(&crane, &found, 200, pull);
    println!("200: {steps:.1} steps, {left:.1e} of {most:.1} N·m left");
    assert!(steps < 8.0 && left < 1e-9 * most);
    Ok(())
}

#[test]
fn what_finds_no_rest_is_told_what_to_do() -> Result<(), Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let falling = System::new(Free, (rod, Ball, rod), Free)?.with_gravity([0.0, -G, 0.0]);
    let Err(error) = falling.equilibrium(falling.motion(), &Unloaded) else { panic!("nothing holds it") };
    assert!(matches!(error.fault, Fault::NoEquilibrium { .. }));
    assert!(error.to_string().contains("guess nearer, or let a run with dampers come to rest"), "{error}");
    Ok(())
}
