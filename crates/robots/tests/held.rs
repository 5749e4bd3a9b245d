//! Robots whose tips are held: accelerations and forces against dense multipliers.

#[path = "../../../tests/it/robots/kit.rs"]
#[allow(dead_code)] // each test needs some of it
mod kit;

use catena::robot::*;
use catena_oracle::Noise;
use catena_oracle::space::robot::{Instant, Moving as Moved, Part, Robot};
use catena_oracle::space::{Matrix, Vector};
use kit::{Drift, GRAVITY, agree, body, drift, floating, general, list, matrix, plain_fixed, tree};
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
    for (k, place) in PLACES.into_iter().enumerate() {
        let (mass, centre, tensor) = body(k + 1);
        let tensor = Matrix::from_fn(|i, j| tensor[i][j]);
        let (place, turn, parent) = (Vector::from(place), matrix(&turn(k)), Some(k + 5));
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

/// Where the last link is held.
fn tip(now: &Instant) -> Moved {
    let body = &now.bodies[now.bodies.len() - 1];
    body.at(body.attitude * Vector::from(PLACE))
}

/// Accelerations and multipliers where directions of the tip are held: six numbers for each direction, and the acceleration along it.
fn by_multipliers(now: &Instant, forces: &[f64], held: &[([f64; 6], f64)]) -> [DVector<f64>; 2] {
    let tip = tip(now);
    let of_tip = |i: usize, k: usize| if i < 3 { tip.of_place[(i, k)] } else { tip.of_turn[(i - 3, k)] };
    let directions = DMatrix::from_fn(held.len(), 6, |i, k| held[i].0[k]);
    let still = DVector::from_iterator(6, tip.linear.iter().chain(&tip.angular).copied());
    let demand = DVector::from_fn(held.len(), |i, _| held[i].1) - &directions * still;
    now.held(forces, &(directions * DMatrix::from_fn(6, forces.len(), of_tip)), &demand)
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
            let Moved { place, attitude: own, .. } = tip(&$now);
            let [x, y, z] = [0, 1, 2].map(|k| own.column(k).into_owned());
            let ($place, $attitude) = (array(place), Rotation::from_matrix(&Columns { x, y, z }));
            let scene = held!($end);
            let mut start = scene.motion();
            start.set_coordinates(&q)?;
            let moving = scene.with_accelerations(scene.with_rates(start, &v)?, &Torques(torques))?;

            let forces: Vec<f64> = (0..9).map(|k| torques[k] - plain.parts[k].damping * v[k]).collect();
            let rows: Vec<([f64; 6], f64)> = $held;
            let [seconds, held] = by_multipliers(&$now, &forces, &rows);
            agree(&moving.accelerations(), seconds.as_slice(), 1e-11);
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
        let own = tip(&now).attitude;
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

/// A base that floats: a ball or a hinge holds the tip of its tail, or it is clamped.
macro_rules! afloat {
    ($seed:expr, |$place:ident, $attitude:ident| $end:expr, $held:expr) => {{
        let (open, mut noise) = (floating()?, Noise::new($seed));
        for _ in 0..30 {
            let Drift { start: same, plain, q, v } = drift(&open, &mut noise)?;
            let now = plain.at(&q, &v);
            let Moved { place, attitude: own, .. } = tip(&now);
            let [x, y, z] = [0, 1, 2].map(|k| own.column(k).into_owned());
            let ($place, $attitude) = (array(place), Rotation::from_matrix(&Columns { x, y, z }));
            let scene = System::new(Free, (BodyAxes, tree(), Flange::at(PLACE)), $end)?.with_gravity(GRAVITY);
            let mut start = scene.motion();
            start.set_coordinates(&same.coordinates())?;
            let moving = scene.with_accelerations(scene.with_rates(start, &same.rates())?, &Unloaded)?;

            let dampers = plain.parts.iter().zip(v).map(|(part, v)| -part.damping * v);
            let forces: Vec<f64> = [0.0; 6].into_iter().chain(dampers).collect();
            let rows: Vec<([f64; 6], f64)> = $held;
            let [seconds, held] = by_multipliers(&now, &forces, &rows);
            agree(&moving.accelerations(), seconds.as_slice(), 1e-10);
            let mut expected = [0.0; 6];
            rows.iter().zip(&held).for_each(|((row, _), force)| (0..6).for_each(|k| expected[k] += row[k] * force));
            let internal = scene.stations(&moving, &Unloaded)?.tip().internal;
            agree(&[array(-internal.force), array(internal.torque)].concat(), &expected, 1e-10);
        }
    }};
}

#[test]
fn tips_of_robots_that_float() -> Result<(), catena::Error> {
    let moving = |place| Moving(move |_: f64| GroundMotion { place, velocity: VELOCITY, acceleration: ACCELERATION });
    afloat!(24, |place, _attitude| Pinned::on(moving(place)), along(&ACCELERATION));
    let demands = [ACCELERATION, ANGULAR].concat();
    afloat!(25, |place, attitude| ground!(place, attitude), along(&demands));
    Ok(())
}

/// A foot that a ball holds while the robot tumbles about it: its energy stays, and so does the foot.
#[test]
fn a_robot_tumbles_about_its_foot() -> Result<(), Box<dyn std::error::Error>> {
    let (upper, lower) = (Hinge::at::<0b111>(PLACES[0]).turned(Turned::by(turn(0))), Hinge::at::<0b111>(PLACES[1]));
    let chain = (BodyAxes, general(body(0)), upper, general(body(1)), lower, general(body(2)), Flange::at(PLACE));
    let open = System::new(Free, chain, Free)?;
    let mut start = open.motion();
    let coordinates = [0.1, -0.2, 0.9, 1.0, 0.0, 0.0, 0.0, 0.4, -0.7];
    start.set_coordinates(&coordinates)?;
    let place = array(open.stations(&start, &Unloaded)?.tip().frame.place);
    let scene = System::new(Free, chain, Pinned::at(place))?.with_gravity(GRAVITY);
    let mut start = scene.motion();
    start.set_coordinates(&coordinates)?;
    let rates = [0.0, 0.0, 0.0, 1.0, -0.5, 0.8, 0.6, -0.4];
    let start = scene.assembled(scene.with_rates(start, &rates)?, &Unloaded)?;
    let end = scene.simulation(Dop853::tolerance(1e-11)).run(start, 1.0, |_| ())?.motion;
    agree(&[scene.budget(&end)?.energy()], &[scene.budget(&start)?.energy()], 1e-9);
    agree(&array(scene.stations(&end, &Unloaded)?.tip().frame.place), &place, 1e-12);
    Ok(())
}
