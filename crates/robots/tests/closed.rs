//! Robots in loops, and in runs with held tips: against dense multipliers, and against the elements of inertial axes.

#[path = "../../../tests/it/robots/kit.rs"]
#[allow(dead_code)] // each test needs some of it
mod kit;

use catena::robot::*;
use catena_oracle::space::robot::{Instant, Part, Robot};
use catena_oracle::space::{Matrix, Vector};
use catena_oracle::{Noise, near};
use kit::{GRAVITY, agree, body, general, list, matrix};
use nalgebra::{DMatrix, DVector};

/// Where joints sit on their parents (m), and how bodies are turned there (rad).
const PLACES: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [0.1, -0.05, 0.35], [0.0, 0.3, 0.1], [0.2, 0.1, -0.25]];
const ANGLES: [[f64; 3]; 4] = [[0.2, -0.3, 0.6], [0.3, 0.8, -0.5], [-1.1, 0.2, 0.4], [0.7, -0.6, 0.9]];
/// Where arms end on their last links (m).
const ENDS: [[f64; 3]; 2] = [[0.05, -0.1, 0.3], [-0.1, 0.2, 0.15]];

fn turn(k: usize) -> Rotation<f64> {
    Rotation::from_angles(ANGLES[k])
}

fn hinge(k: usize) -> Hinge<f64, Turned<f64>, 0b111> {
    Hinge::at::<0b111>(PLACES[k]).turned(Turned::by(turn(k)))
}

fn part(parent: Option<usize>, sits: usize, of: usize) -> Part {
    let (mass, centre, tensor) = body(of);
    let (tensor, centre) = (Matrix::from_fn(|i, j| tensor[i][j]), Vector::from(centre));
    let (place, turn) = (Vector::from(PLACES[sits]), matrix(&turn(sits)));
    Part { parent, slides: false, place, turn, mass, centre, tensor, armature: 0.0, damping: 0.0 }
}

/// Two arms on the first link, closed at their ends, and one link beyond the end of the main arm.
macro_rules! looped {
    ($closing:expr) => {{
        let main = (BodyAxes, hinge(1), general(body(1)), hinge(2), general(body(2)), hinge(3), general(body(3)));
        let side = (BodyAxes, hinge(2), general(body(4)), hinge(3), general(body(5)), hinge(1), general(body(0)));
        let net = Network::new((main, Flange::at(ENDS[0])), (side, Flange::at(ENDS[1])), $closing);
        let beyond = (BodyAxes, hinge(2), general(body(1)));
        let chain = (hinge(0).grounded(), general(body(0)), Flange::at([0.0; 3]), net, beyond);
        System::new(Base::origin(), chain, Free)?.with_gravity(GRAVITY)
    }};
}

/// The same as a list, open: first link, main arm, side arm, what is beyond.
fn plain() -> Robot {
    let arms = [(Some(0), 1, 1), (Some(1), 2, 2), (Some(2), 3, 3), (Some(0), 2, 4), (Some(4), 3, 5), (Some(5), 1, 0)];
    let mut parts = vec![part(None, 0, 0)];
    parts.extend(arms.map(|(parent, sits, of)| part(parent, sits, of)));
    let mut beyond = part(Some(3), 2, 1);
    beyond.place += Vector::from(ENDS[0]);
    parts.push(beyond);
    Robot { base: None, parts, gravity: Vector::from(GRAVITY) }
}

/// What a ball between both ends demands: their distance, rows, and how fast the ends part where coordinates do not accelerate.
fn gap(now: &Instant) -> (Vector, DMatrix<f64>, Vector) {
    let [main, side] = [(3, ENDS[0]), (6, ENDS[1])].map(|(body, end)| {
        let body = &now.bodies[body];
        body.at(body.attitude * Vector::from(end))
    });
    let rows = main.of_place - side.of_place;
    (main.place - side.place, DMatrix::from_fn(3, rows.ncols(), |i, k| rows[(i, k)]), main.linear - side.linear)
}

#[test]
fn a_ball_closes_a_loop_of_two_arms() -> Result<(), catena::Error> {
    let (scene, plain, mut noise) = (looped!(Ball), plain(), Noise::new(31));
    for _ in 0..40 {
        let [q, v, torques]: [[f64; 8]; 3] = std::array::from_fn(|_| list(&mut noise, 2.0));
        let mut start = scene.motion();
        start.set_coordinates(&q)?;
        let moving = scene.with_accelerations(scene.with_rates(start, &v)?, &Torques(torques))?;

        let now = plain.at(&q, &v);
        let (_, rows, parting) = gap(&now);
        let [found, _] = now.held(&torques, &rows, &DVector::from_fn(3, |i, _| -parting[i]));
        agree(&moving.accelerations(), found.as_slice(), 1e-10);
    }
    Ok(())
}

#[test]
fn a_loop_assembles_and_runs_at_constant_energy() -> Result<(), Box<dyn std::error::Error>> {
    let (scene, plain) = (looped!(Ball), plain());
    let mut start = scene.motion();
    start.set_coordinates(&[0.3, 0.5, -0.4, 0.8, -0.2, 0.6, 0.1, 0.4])?;
    let start = scene.assembled(scene.with_rates(start, &[0.5, -0.3, 0.2, 0.4, 0.1, -0.6, 0.3, 0.2])?, &Unloaded)?;
    let apart = |motion: &[f64]| gap(&plain.at(motion, &[0.0; 8])).0.norm();
    assert!(apart(&start.coordinates()) < 1e-12);
    let end = scene.simulation(Dop853::tolerance(1e-10)).run(start, 1.0, |_| ())?.motion;
    assert!(apart(&end.coordinates()) < 1e-12);
    near(scene.budget(&end)?.energy(), scene.budget(&start)?.energy(), 1e-7);
    Ok(())
}

/// Six joints to a tip that a ball holds, with a spring, a stop and a drive among them.
#[test]
fn runs_to_a_held_tip_agree_with_those_in_inertial_axes() -> Result<(), Box<dyn std::error::Error>> {
    let (z, weld) = ([0.0, 0.0, 1.0], |k: usize| Weld::at(turn(k)));
    let slide = Slide::at::<0b111>(PLACES[2]).turned(Turned::by(turn(2)));
    let crank = |t: f64| [0.2 + 0.3 * t * t, 0.6 * t, 0.6];
    const END: f64 = 0.4; // (s)
    let (spring, stops) = (Spring::stiffness(300.0), [-0.36, 0.62]);
    let rigid = |of: usize, end: [f64; 3]| {
        let (mass, centre, tensor) = body(of);
        RigidBody::new(mass, tensor, centre, end)
    };
    macro_rules! own {
        ($tip:expr) => {{
            let first = (Driven::new(hinge(0).grounded(), crank), general(body(0)), hinge(1), general(body(1)));
            let second = (slide.with(spring), general(body(2)), HardStops::between(hinge(3), stops).rebounding(0.5));
            let third = (general(body(3)), hinge(1), general(body(4)), hinge(3), general(body(5)), Flange::at(ENDS[0]));
            System::new(Base::origin(), (first, second, third), $tip)?.with_gravity(GRAVITY)
        }};
    }
    macro_rules! other {
        ($tip:expr) => {{
            let first =
                (weld(0), Driven::new(Revolute::about(z), crank), rigid(0, PLACES[1]), weld(1), Revolute::about(z));
            let stop = HardStops::between(Revolute::about(z), stops).rebounding(0.5);
            let slide = Prismatic::along(z).with(spring);
            let second = (rigid(1, PLACES[2]), weld(2), slide, rigid(2, PLACES[3]), weld(3), stop);
            let third = (rigid(3, PLACES[1]), weld(1), Revolute::about(z), rigid(4, PLACES[3]), weld(3));
            let last = (Revolute::about(z), rigid(5, ENDS[0]));
            System::new(Clamped::origin(), (first, second, third, last), $tip)?.with_gravity(GRAVITY)
        }};
    }
    let q = [0.5, 0.05, 0.6, -0.3, 0.4];
    let free = own!(Free);
    let mut start = free.motion();
    start.set_coordinates(&q)?;
    let place = array(free.stations(&start, &Unloaded)?.tip().frame.place);
    let (own, other) = (own!(Pinned::at(place)), other!(Pinned::at(place)));
    macro_rules! agree_by {
        ($rule:expr, $tolerance:expr) => {{
            let (mut here, mut there, mut met) = (own.motion(), other.motion(), false);
            here.set_coordinates(&q)?;
            there.set_coordinates(&q)?;
            let (here, there) = (own.assembled(here, &Unloaded)?, other.assembled(there, &Unloaded)?);
            let end = own.simulation($rule).run(here, END, |now| {
                let angle = now.motion().coordinates()[2];
                met |= stops.iter().any(|stop| (angle - stop).abs() < 1e-9);
            })?;
            let right = other.simulation($rule).run(there, END, |_| ())?.motion;
            assert!(met);
            for (x, y) in [(end.motion.coordinates(), right.coordinates()), (end.motion.rates(), right.rates())] {
                x.iter().zip(&y).for_each(|(x, y)| near(*x, *y, $tolerance));
            }
            let tip = own.stations(&end.motion, &Unloaded)?.tip().frame.place;
            array(tip).iter().zip(place).for_each(|(x, y)| near(*x, y, 1e-11));
        }};
    }
    agree_by!(Dop853::tolerance(1e-10), 1e-7);
    agree_by!(Sdirk4::new().step(0.005), 1e-7);
    Ok(())
}

/// Springs in all joints, the end held by a ball: forces at both ends, the place where it rests, and how it swings there.
#[test]
fn a_held_arm_rests_and_swings_as_in_inertial_axes() -> Result<(), Box<dyn std::error::Error>> {
    let z = [0.0, 0.0, 1.0];
    let (spring, strong) = (Spring::stiffness(60.0), Spring::stiffness(900.0));
    let slide = Slide::at::<0b111>(PLACES[2]).turned(Turned::by(turn(2))).with(strong);
    let first = (BodyAxes, hinge(0).with(spring), general(body(0)), hinge(1).with(spring), general(body(1)));
    let last =
        (slide, general(body(2)), hinge(3).with(spring), general(body(3)), hinge(1).with(spring), general(body(4)));
    let open = System::new(Clamped::origin(), (first, last, Flange::at(ENDS[0])), Free)?;
    let (q, v) = ([0.3, 0.2, 0.05, -0.4, 0.1], [0.4, -0.3, 0.1, 0.2, 0.6]);
    let mut start = open.motion();
    start.set_coordinates(&q)?;
    let held = Pinned::at(array(open.stations(&start, &Unloaded)?.tip().frame.place));
    let own = System::new(Clamped::origin(), (first, last, Flange::at(ENDS[0])), held)?.with_gravity(GRAVITY);

    let rigid = |of: usize, end: [f64; 3]| {
        let (mass, centre, tensor) = body(of);
        RigidBody::new(mass, tensor, centre, end)
    };
    let (weld, hinge) = (|k: usize| Weld::at(turn(k)), Revolute::about(z).with(spring));
    let first = (weld(0), hinge, rigid(0, PLACES[1]), weld(1), hinge, rigid(1, PLACES[2]), weld(2));
    let last = (Prismatic::along(z).with(strong), rigid(2, PLACES[3]), weld(3), hinge, rigid(3, PLACES[1]), weld(1));
    let chain = (first, last, hinge, rigid(4, ENDS[0]));
    let other = System::new(Clamped::origin(), chain, held)?.with_gravity(GRAVITY);
    macro_rules! of {
        ($scene:expr) => {{
            let mut start = $scene.motion();
            start.set_coordinates(&q)?;
            let moving = $scene.assembled($scene.with_rates(start, &v)?, &Unloaded)?;
            let stations = $scene.stations(&moving, &Unloaded)?;
            let [root, tip] = [stations.root(), stations.tip()].map(|station| station.internal);
            let forces = [array(root.force), array(root.torque), array(tip.force)].concat();
            let rest = $scene.equilibrium(moving, &Unloaded)?;
            let swings: Vec<f64> = $scene.modes(&rest, &Unloaded)?.frequencies().collect();
            (moving.rates(), forces, rest.coordinates(), swings)
        }};
    }
    let (found, expected) = (of!(own), of!(other));
    agree(&found.0, &expected.0, 1e-11);
    agree(&found.1, &expected.1, 1e-11);
    agree(&found.2, &expected.2, 1e-9);
    agree(&found.3, &expected.3, 1e-7);
    assert_eq!(found.3.len(), 2);
    Ok(())
}

/// Rods on balls hang from the flange of an arm.
#[test]
fn a_rope_hangs_from_a_flange() -> Result<(), catena::Error> {
    let rope = (Ball, Rod::uniform(0.4, 0.01, 0.3), Ball, Rod::uniform(0.3, 0.01, 0.2));
    let arm = (BodyAxes, hinge(0), general(body(0)), hinge(1), general(body(1)), Flange::at(ENDS[0]));
    let own = System::new(Clamped::origin(), (arm, rope), Free)?.with_gravity(GRAVITY);
    let (z, weld) = ([0.0, 0.0, 1.0], |k: usize| Weld::at(turn(k)));
    let rigid = |of: usize, end: [f64; 3]| {
        let (mass, centre, tensor) = body(of);
        RigidBody::new(mass, tensor, centre, end)
    };
    let arm = (weld(0), Revolute::about(z), rigid(0, PLACES[1]), weld(1), Revolute::about(z), rigid(1, ENDS[0]));
    let other = System::new(Clamped::origin(), (arm, rope), Free)?.with_gravity(GRAVITY);
    let rates = [0.7, -0.4, 0.3, 0.2, -0.5, 0.6, 0.1, -0.2];
    let here = own.with_rates(own.at_rest(&[0.3, -0.6, 0.2, 0.5, -0.1, 0.4, 0.3, 0.1])?, &rates)?;
    let there = other.with_rates(other.at_rest(&[0.3, -0.6, 0.2, 0.5, -0.1, 0.4, 0.3, 0.1])?, &rates)?;
    let [here, there] = [
        own.simulate(here, Dop853::tolerance(1e-11), 0.3, |_| ())?.motion.coordinates(),
        other.simulate(there, Dop853::tolerance(1e-11), 0.3, |_| ())?.motion.coordinates(),
    ];
    agree(&here, &there, 1e-9);
    Ok(())
}

fn array(v: Vector) -> [f64; 3] {
    [v.x, v.y, v.z]
}
