//! Robots whose tips are held: accelerations and forces against dense multipliers.

#[path = "../../../tests/it/robots/kit.rs"]
#[allow(dead_code)] // each test needs some of it
mod kit;

use catena::robot::*;
use catena_oracle::Noise;
use catena_oracle::space::robot::{Instant, Part, Robot};
use catena_oracle::space::{Matrix, Vector, tilde};
use kit::{GRAVITY, agree, body, general, list, matrix, plain_fixed, tree};
use nalgebra::{DMatrix, DVector};

/// Where the last link is held (m), in its axes.
const PLACE: [f64; 3] = [0.05, -0.1, 0.3];
/// How the ground moves there.
const VELOCITY: [f64; 3] = [0.3, -0.2, 0.5];
const ACCELERATION: [f64; 3] = [-1.0, 2.0, 0.7];
const SPIN: [f64; 3] = [0.4, 0.9, -0.6];
const ANGULAR: [f64; 3] = [1.5, -0.8, 0.2];

/// Where three more hinges sit, and how their bodies are turned there.
const PLACES: [[f64; 3]; 3] = [[0.1, -0.05, 0.25], [0.0, 0.3, 0.1], [0.2, 0.1, -0.15]];
const ANGLES: [[f64; 3]; 3] = [[0.3, 0.8, -0.5], [-1.1, 0.2, 0.4], [0.7, -0.6, 0.9]];

fn turn(k: usize) -> Rotation<f64> {
    Rotation::from_angles(ANGLES[k])
}

/// The tree of the kit on a base, with three more links beyond its last: nine joints, seven of them on the way to the tip.
macro_rules! held {
    ($tip:expr) => {{
        let hinge = |k: usize| Hinge::at::<0b111>(PLACES[k]).turned(Turned::by(turn(k)));
        let more = (hinge(0), general(body(1)), hinge(1), general(body(2)), hinge(2), general(body(3)));
        let chain = (Hinge::level().grounded(), tree(), more, Flange::at(PLACE));
        System::new(Base::origin(), chain, $tip)?.with_gravity(GRAVITY)
    }};
}

/// The same as a list.
fn plain() -> Robot {
    let mut robot = plain_fixed();
    for k in 0..3 {
        let (mass, centre, tensor) = body(k + 1);
        let tensor = Matrix::from_fn(|i, j| tensor[i][j]);
        let (place, turn, parent) = (Vector::from(PLACES[k]), matrix(&turn(k)), Some(k + 5));
        let centre = Vector::from(centre);
        robot.parts.push(Part {
            parent,
            slides: false,
            place,
            turn,
            mass,
            centre,
            tensor,
            armature: 0.0,
            damping: 0.0,
        });
    }
    robot
}

/// The tip of the last link: its place and attitude, the six rows of its Jacobian, and its acceleration where coordinates have none.
fn tip(now: &Instant) -> (Vector, Matrix, DMatrix<f64>, [Vector; 2]) {
    let body = &now.bodies[now.bodies.len() - 1];
    let arm = body.attitude * Vector::from(PLACE);
    let of_place = &body.of_place - tilde(arm) * &body.of_turn;
    let n = of_place.ncols();
    let rows = DMatrix::from_fn(6, n, |i, k| if i < 3 { of_place[(i, k)] } else { body.of_turn[(i - 3, k)] });
    let linear = body.linear + body.angular.cross(&arm) + body.spin.cross(&body.spin.cross(&arm));
    (body.place + arm, body.attitude, rows, [linear, body.angular])
}

/// Accelerations and multipliers where directions of the tip are held: six numbers for each direction, and the acceleration along it.
fn by_multipliers(now: &Instant, forces: &[f64], held: &[([f64; 6], f64)]) -> (Vec<f64>, Vec<f64>) {
    let (_, _, rows, [linear, angular]) = tip(now);
    let (n, m) = (forces.len(), held.len());
    let directions = DMatrix::from_fn(m, 6, |i, k| held[i].0[k]);
    let still = DVector::from_iterator(6, linear.iter().chain(&angular).copied());
    let jacobian = &directions * rows;
    let demand = DVector::from_fn(m, |i, _| held[i].1) - &directions * still;
    let mut matrix = DMatrix::zeros(n + m, n + m);
    matrix.view_mut((0, 0), (n, n)).copy_from(&now.mass);
    matrix.view_mut((n, 0), (m, n)).copy_from(&jacobian);
    matrix.view_mut((0, n), (n, m)).copy_from(&(-jacobian.transpose()));
    let right = DVector::from_fn(n + m, |k, _| if k < n { forces[k] - now.bias[k] } else { demand[k - n] });
    let found = matrix.lu().solve(&right).expect("closures are independent");
    (found.rows(0, n).iter().copied().collect(), found.rows(n, m).iter().copied().collect())
}

/// The first directions of six, with what is demanded of them.
fn along(demands: &[f64]) -> Vec<([f64; 6], f64)> {
    demands.iter().enumerate().map(|(i, demand)| (std::array::from_fn(|k| f64::from(k == i)), *demand)).collect()
}

fn array(v: Vector) -> [f64; 3] {
    [v.x, v.y, v.z]
}

/// Ground that moves and turns, at a place and an attitude.
macro_rules! ground {
    ($place:expr, $attitude:expr) => {{
        let (place, attitude) = ($place, $attitude);
        let moving = Moving(move |_: f64| GroundMotion { place, velocity: VELOCITY, acceleration: ACCELERATION });
        Clamped::on(moving, Turning(move |_: f64| AttitudeMotion { attitude, spin: SPIN, acceleration: ANGULAR }))
    }};
}

/// Nine joints under torques, and a tip held by an end that is made for its place and attitude.
macro_rules! agrees {
    ($seed:expr, |$place:ident, $attitude:ident, $now:ident| $end:expr, $held:expr) => {{
        let (plain, mut noise) = (plain(), Noise::new($seed));
        for _ in 0..30 {
            let [q, v, torques]: [[f64; 9]; 3] = std::array::from_fn(|_| list(&mut noise, 2.0));
            let $now = plain.at(&q, &v);
            let (place, own, ..) = tip(&$now);
            let [x, y, z] = [0, 1, 2].map(|k| own.column(k).into_owned());
            let ($place, $attitude) = (array(place), Rotation::from_matrix(&Columns { x, y, z }));
            let scene = held!($end);
            let mut start = scene.motion();
            start.set_coordinates(&q)?;
            let moving = scene.with_accelerations(scene.with_rates(start, &v)?, &Torques(torques))?;

            let forces: Vec<f64> = (0..9).map(|k| torques[k] - plain.parts[k].damping * v[k]).collect();
            let rows: Vec<([f64; 6], f64)> = $held;
            let (seconds, held) = by_multipliers(&$now, &forces, &rows);
            agree(&moving.accelerations(), &seconds, 1e-11);
            // What the end exerts, as six numbers.
            let mut expected = [0.0; 6];
            rows.iter().zip(&held).for_each(|((row, _), force)| (0..6).for_each(|k| expected[k] += row[k] * force));
            let internal = scene.stations(&moving, &Torques(torques))?.tip().internal;
            agree(&[array(-internal.force), array(internal.torque)].concat(), &expected, 1e-11);
        }
    }};
}

#[test]
fn a_pinned_tip_on_ground_that_moves() -> Result<(), catena::Error> {
    agrees!(
        21,
        |place, _attitude, now| Pinned::on(Moving(move |_: f64| {
            GroundMotion { place, velocity: VELOCITY, acceleration: ACCELERATION }
        })),
        along(&ACCELERATION)
    );
    Ok(())
}

#[test]
fn a_clamped_tip_on_ground_that_turns() -> Result<(), catena::Error> {
    let demands = [ACCELERATION, ANGULAR].concat();
    agrees!(22, |place, attitude, now| ground!(place, attitude), along(&demands));
    Ok(())
}

#[test]
fn a_hinged_tip_on_ground_that_turns() -> Result<(), catena::Error> {
    let axis = Vector::new(0.6, 0.0, 0.8);
    let across = [Vector::new(0.8, 0.0, -0.6), Vector::y()];
    agrees!(23, |place, attitude, now| Hinged::on(ground!(place, attitude), array(axis)), {
        // Directions turn with the ground: t · α = t · α_g − (ω_g × t) · (ω − ω_g).
        let (_, own, ..) = tip(&now);
        let (spin, angular) = (Vector::from(SPIN), Vector::from(ANGULAR));
        let relative = now.bodies[now.bodies.len() - 1].spin - spin;
        let mut rows = along(&ACCELERATION);
        for direction in across {
            let t = own * direction;
            rows.push(([0.0, 0.0, 0.0, t.x, t.y, t.z], t.dot(&angular) - spin.cross(&t).dot(&relative)));
        }
        rows
    });
    Ok(())
}
