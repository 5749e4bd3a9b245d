//! Rotors behind gears against the same rotors as bodies: the dense robot has each as a part of its own on a hinge, whose rate is n times
//! that of the joint, M = Gᵀ M̂ G and b = Gᵀ b̂.

#[allow(dead_code)] // robots that other tests share
#[path = "../../../tests/it/robots/kit.rs"]
mod kit;

use catena::robot::*;
use catena::{Error, Fault};
use catena_oracle::Noise;
use catena_oracle::space::robot as plain;
use catena_oracle::space::{Matrix, Vector};
use kit::{GRAVITY, agree, list, matrix};
use nalgebra::{DMatrix, DVector};

/// Mass (kg), transverse moment and moment about the axis (kg·m²), and n: against the joint, fast, slower than the joint.
const ROTORS: [([f64; 3], f64); 3] = [([0.4, 2e-4, 3e-4], -60.0), ([0.3, 1e-4, 2e-4], 100.0), ([0.5, 4e-4, 6e-4], 0.4)];
/// Where joints sit on their parents, and where rotors do.
const PLACES: [[f64; 3]; 3] = [[0.0; 3], [0.1, -0.2, 0.3], [0.3, 0.1, 0.2]];
const MOTORS: [[f64; 3]; 3] = [[0.1, 0.0, 0.2], [0.0, -0.1, 0.25], [0.2, 0.1, 0.0]];

fn turns() -> [Rotation<f64>; 3] {
    [[0.0; 3], [0.4, -0.7, 1.1], [-1.2, 0.3, 0.5]].map(Rotation::from_angles)
}

/// A body of small moments.
fn slim(k: usize) -> (f64, Vector, Matrix) {
    let (mass, centre, tensor) = kit::body(k);
    (mass, Vector::from(centre), Matrix::from_fn(|i, j| 0.3 * tensor[i][j]))
}

fn tensor_of(k: usize) -> Matrix {
    let [_, across, along] = ROTORS[k].0;
    Matrix::from_diagonal(&Vector::new(across, across, along))
}

/// A link that carries the rotor of joint k at rest, if any.
fn link((mass, centre, tensor): (f64, Vector, Matrix), rotor: Option<usize>) -> Link<f64> {
    let (mut sum, mut moment) = (mass, centre * mass);
    let about = |mass: f64, at: Vector| (Matrix::identity() * at.norm_squared() - at * at.transpose()) * mass;
    let mut whole = tensor + about(mass, centre);
    if let Some(k) = rotor {
        let (own, at, turn) = (ROTORS[k].0[0], Vector::from(MOTORS[k]), matrix(&turns()[k]));
        sum += own;
        moment += at * own;
        whole += turn * tensor_of(k) * turn.transpose() + about(own, at);
    }
    let centre = moment / sum;
    let tensor = whole - about(sum, centre);
    let tensor = (tensor + tensor.transpose()) * 0.5;
    Link::general(sum, centre.into(), std::array::from_fn(|i| std::array::from_fn(|j| tensor[(i, j)])))
}

fn rotor(k: usize) -> Rotor<f64> {
    Rotor::new(ROTORS[k].0[2], ROTORS[k].1)
}

/// Bodies on the hinges from `first` on, then their rotors; the first of each is on the base, or on the ground.
fn parts(first: usize) -> Vec<plain::Part> {
    let turns = turns().map(|turn| matrix(&turn));
    let part = |parent, place: [f64; 3], k: usize, (mass, centre, tensor): (f64, Vector, Matrix)| plain::Part {
        parent,
        slides: false,
        place: Vector::from(place),
        turn: turns[k],
        mass,
        centre,
        tensor,
        armature: 0.0,
        damping: 0.0,
    };
    let inboard = |k: usize| k.checked_sub(first + 1);
    let bodies = (first..3).map(|k| part(inboard(k), PLACES[k], k, slim(k)));
    let rotors = (first..3).map(|k| part(inboard(k), MOTORS[k], k, (ROTORS[k].0[0], Vector::zeros(), tensor_of(k))));
    bodies.chain(rotors).collect()
}

/// Numbers of the dense robot for joints alone: M, b, and rates of all that it has.
fn reduced(robot: &plain::Robot, q: &[f64], v: &[f64], ratios: &[f64]) -> (DMatrix<f64>, DVector<f64>, plain::Instant) {
    let (offset, n) = (robot.offset(), q.len());
    let all = |x: &[f64]| -> Vec<f64> { x.iter().copied().chain(x.iter().zip(ratios).map(|(x, n)| x * n)).collect() };
    let now = robot.at(&all(q), &all(v));
    let g = DMatrix::from_fn(offset + 2 * n, offset + n, |i, j| match i.checked_sub(offset + n) {
        Some(k) if j == offset + k => ratios[k],
        None if i == j => 1.0,
        _ => 0.0,
    });
    (g.transpose() * &now.mass * &g, g.transpose() * &now.bias, now)
}

#[test]
fn on_the_ground() -> Result<(), Error> {
    let [_, second, third] = turns();
    let [a, b, c] = [link(slim(0), Some(1)), link(slim(1), Some(2)), link(slim(2), None)];
    let (waist, a) = rotor(0).on_ground(Hinge::level().grounded(), a)?;
    let elbow = Hinge::at::<7>(PLACES[1]).turned(Turned::by(second));
    let (a, elbow, b) = rotor(1).between(a, elbow, b)?;
    let wrist = Hinge::at::<7>(PLACES[2]).turned(Turned::by(third));
    let (b, wrist, c) = rotor(2).between(b, wrist, c)?;
    // A moment of the first link is negative: no body is like it.
    assert!(matches!(a.inertia().check(), Err(Fault::Negative { .. })));
    let scene = System::new(Base::origin(), (waist, a, elbow, b, wrist, c), Free)?.with_gravity(GRAVITY);
    let robot = plain::Robot { base: None, parts: parts(0), gravity: Vector::from(GRAVITY) };
    let (ratios, mut noise) = (ROTORS.map(|(_, n)| n), Noise::new(71));
    for _ in 0..50 {
        let [q, v, torques]: [[f64; 3]; 3] = [list(&mut noise, 2.0), list(&mut noise, 3.0), list(&mut noise, 5.0)];
        let (mass, bias, now) = reduced(&robot, &q, &v, &ratios);
        agree(scene.mass_matrix(&q)?.as_flattened(), mass.as_slice(), 1e-13);
        agree(&scene.bias(&q, &v)?, bias.as_slice(), 1e-13);
        let right = mass.clone().lu().solve(&(DVector::from_row_slice(&torques) - &bias)).unwrap();
        agree(&scene.forward_dynamics(&q, &v, &torques)?, right.as_slice(), 1e-12);
        let start = scene.with_accelerations(scene.at_joints(&q, &v)?, &Torques(&torques))?;
        agree(&start.accelerations(), right.as_slice(), 1e-12);
        agree(&scene.joint_energy(&q, &v)?[..1], &[now.kinetic], 1e-13);
        let slopes = scene.forward_dynamics_derivatives(&q, &v, &torques)?;
        agree(slopes.1.as_flattened(), mass.try_inverse().unwrap().as_slice(), 1e-12);
    }
    Ok(())
}

#[test]
fn afloat() -> Result<(), Error> {
    let [_, second, third] = turns();
    // The base has the first rotor at rest, and so on.
    let [a, b, c] = [link(slim(0), Some(1)), link(slim(1), Some(2)), link(slim(2), None)];
    let (a, elbow, b) = rotor(1).between(a, Hinge::at::<7>(PLACES[1]).turned(Turned::by(second)), b)?;
    let (b, wrist, c) = rotor(2).between(b, Hinge::at::<7>(PLACES[2]).turned(Turned::by(third)), c)?;
    let scene = System::new(Free, (BodyAxes, a, elbow, b, wrist, c), Free)?.with_gravity(GRAVITY);
    let (ratios, mut noise) = ([ROTORS[1].1, ROTORS[2].1], Noise::new(72));
    for _ in 0..50 {
        let [q, v]: [[f64; 2]; 2] = [list(&mut noise, 2.0), list(&mut noise, 3.0)];
        let [place, velocity, spin, angles]: [[f64; 3]; 4] = std::array::from_fn(|_| list(&mut noise, 1.0));
        let attitude = Rotation::from_angles(angles);
        let mut start = scene.motion();
        let coordinates: Vec<f64> = place.into_iter().chain(attitude.quaternion()).chain(q).collect();
        start.set_coordinates(&coordinates)?;
        let rates: Vec<f64> = velocity.into_iter().chain(spin).chain(v).collect();
        let start = scene.with_accelerations(scene.with_rates(start, &rates)?, &Loads::none())?;

        let (mass, centre, tensor) = slim(0);
        let attitude = matrix(&attitude);
        let base = plain::Base {
            mass,
            centre,
            tensor,
            place: Vector::from(place),
            attitude,
            velocity: Vector::from(velocity),
            spin: Vector::from(spin),
        };
        let robot = plain::Robot { base: Some(base), parts: parts(1), gravity: Vector::from(GRAVITY) };
        let (mass, bias, now) = reduced(&robot, &q, &v, &ratios);
        let right = mass.lu().solve(&-bias).unwrap();
        agree(&start.accelerations(), right.as_slice(), 1e-12);
        let base = scene.body_motions(&start)?.get(0).map(Afloat::of).expect("a base");
        agree(&scene.joint_energy_afloat(base, &q, &v)?[..1], &[now.kinetic], 1e-13);
        let [_, found] = scene.snapshot_afloat(base, &q, &v)?.centroidal_momentum();
        agree(found.as_slice(), robot.momenta(&now).2.as_slice(), 1e-12);
    }
    Ok(())
}

/// Nothing outside acts: energy stays, to the error of the run.
#[test]
fn energy_is_kept_while_rotors_spin() -> Result<(), Error> {
    let [_, second, _] = turns();
    let (a, b) = (link(slim(0), Some(1)), link(slim(1), None));
    let (waist, a) = rotor(0).on_ground(Hinge::level().grounded(), a)?;
    let (a, elbow, b) = rotor(1).between(a, Hinge::at::<7>(PLACES[1]).turned(Turned::by(second)), b)?;
    let scene = System::new(Base::origin(), (waist, a, elbow, b), Free)?;
    let start = scene.at_joints(&[0.3, -0.4], &[2.0, -3.0])?;
    let [before, _] = scene.joint_energy(&[0.3, -0.4], &[2.0, -3.0])?;
    let end = scene.simulate(start, Dop853::tolerance(1e-12), 10.0, |_| ())?.motion;
    let [q, v] = [end.coordinates(), end.rates()].map(|list| [list[0], list[1]]);
    let drift = scene.joint_energy(&q, &v)?[0] - before;
    println!("{before} J, drift {drift:.1e} J");
    assert!(drift.abs() < 1e-10 * before);
    Ok(())
}

#[test]
fn what_makes_no_rotor_is_refused() {
    let link = || Link::general(1.0, [0.0; 3], [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]);
    let fault = |rotor: Rotor<f64>| rotor.between(link(), Hinge::level(), link()).map(|_| ()).unwrap_err().fault;
    assert_eq!(fault(Rotor::new(-1e-4, 10.0)), Fault::Negative { parameter: "inertia of a rotor", value: -1e-4 });
    assert_eq!(fault(Rotor::new(1e-4, f64::NAN)), Fault::NotFinite { parameter: "ratio of a gear" });
    // What is wrong with a body is found before it shares in a rotor, and a share that leaves none behind another mask.
    let odd = Link::general(1.0, [0.0; 3], [[-0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]);
    let refused = Rotor::new(1e-4, 10.0).between(odd, Hinge::level(), link()).map(|_| ()).unwrap_err();
    assert!(matches!(refused.fault, Fault::Negative { parameter: "principal moment of inertia", .. }));
    let (less, ..) = Rotor::new(0.02, 10.0).between(link(), Hinge::level(), link()).unwrap();
    let alone = System::new(Base::origin(), (Hinge::level().grounded(), less.masked::<7, 63>()), Free).unwrap_err();
    assert!(matches!(alone.fault, Fault::Negative { parameter: "principal moment of inertia", .. }));
}
