//! Driven joints of robots: sweeps against a dense robot that is handed what drives exert, runs against the elements of inertial axes under
//! every kind of rule.

#[path = "../../../tests/it/robots/kit.rs"]
#[allow(dead_code)] // each test needs some of it
mod kit;

use catena::robot::*;
use catena_oracle::space::Vector;
use catena_oracle::space::robot as plain;
use catena_oracle::{Noise, near};
use kit::{GRAVITY, agree, body, flat, general, lean, list, plain_fixed, plain_floating, round};

const LAWS: [[f64; 3]; 4] = [[0.9, 2.0, 0.3], [0.2, 3.0, -0.4], [0.6, 1.7, 1.1], [0.3, 2.6, -1.2]];

/// a sin(ω t + p), with derivatives.
fn swing([a, w, p]: [f64; 3]) -> impl Fn(f64) -> [f64; 3] + Copy + 'static {
    move |time| {
        let (s, c) = (w * time + p).sin_cos();
        [a * s, a * w * c, -a * w * w * s]
    }
}

/// Force or torque of a drive from that of its station, with what dampers and reflected inertia of the joint take.
fn drive(instant: &plain::Instant, robot: &plain::Robot, k: usize, station: [Vector; 2], law: [f64; 3]) -> f64 {
    let (part, [force, torque]) = (robot.parts[k], station);
    let axis = instant.bodies[k].attitude.column(2).into_owned();
    let inner = if part.slides { axis.dot(&force) } else { -axis.dot(&torque) };
    inner + part.armature * law[2] + part.damping * law[1]
}

/// What drives exert, at the stations of the links on them, and what they are in the dense robot.
macro_rules! drives {
    ($scene:expr, $motion:expr, $robot:expr, $instant:expr, [$($name:literal: $k:expr => $law:expr),*]) => {{
        let stations = $scene.stations($motion, &Unloaded)?;
        [$({
            let station = $scene.joint($name)?.station.expect("a joint of the chain");
            let internal = stations.get(station + 1).expect("a link on it").internal;
            let (force, torque) = (internal.force, internal.torque);
            let station = [Vector::new(force.x, force.y, force.z), Vector::new(torque.x, torque.y, torque.z)];
            drive(&$instant, &$robot, $k, station, $law)
        }),*]
    }};
}

#[test]
fn a_tree_moves_as_under_the_efforts_of_its_drives() -> Result<(), catena::Error> {
    let [crank, side, shoulder, spindle] = LAWS.map(swing);
    let (mid, bars) = (flat(3), [round(2), round(5)]);
    let bar = |k: usize| Link::<f64, 0b100, 0b111>::new(bars[k].0, bars[k].1, bars[k].2);
    let slide = Slide::at::<0b010>([0.0, 0.2, 0.0]).turned(Quarter::<8>);
    let arm = (Driven::new(slide, side).named("side"), general(body(1)), Hinge::at::<0b111>([0.1, -0.2, 0.3]), bar(0));
    let hinge = Hinge::at::<0b101>([0.3, 0.0, -0.1]).turned(Quarter::<30>).with(Spring::damping(0.3)).geared(0.2);
    let slide = Slide::at::<0b111>([0.1, 0.2, 0.15]).turned(Turned::by(lean())).with(Spring::damping(0.4)).geared(0.5);
    let tail = (
        Driven::new(hinge, shoulder).named("shoulder"),
        Link::<f64, 0b110, 0b1111>::new(mid.0, mid.1, mid.2),
        Hinge::at::<0b001>([0.25, 0.0, 0.0]).turned(Leaning::by(0.6)),
        general(body(4)),
        Driven::new(slide, spindle).named("spindle"),
        bar(1),
    );
    let chain = (Driven::new(Hinge::level().grounded(), crank).named("crank"), general(body(0)), Branch(arm), tail);
    let scene = System::new(Base::origin(), chain, Free)?.with_gravity(GRAVITY);

    let (robot, mut noise) = (plain_fixed(), Noise::new(5));
    for _ in 0..100 {
        let (time, q, v): (_, [f64; 2], [f64; 2]) =
            (noise.between(0.0, 9.0), list(&mut noise, 2.0), list(&mut noise, 2.0));
        let mut start = scene.motion().at_time(time);
        start.set_coordinates(&q)?;
        start.set_rates(&v)?;
        let motion = scene.with_accelerations(start, &Unloaded)?;
        let laws = [crank(time), side(time), shoulder(time), spindle(time)];
        let [a, b, c, d] = laws;
        let (all_q, all_v) = ([a[0], b[0], q[0], c[0], q[1], d[0]], [a[1], b[1], v[0], c[1], v[1], d[1]]);
        let instant = robot.at(&all_q, &all_v);
        let [a, b, c, d] = drives!(scene, &motion, robot, instant,
            ["crank": 0 => a, "side": 1 => b, "shoulder": 3 => c, "spindle": 5 => d]);
        let seconds = robot.forward_dynamics(&all_q, &all_v, &[a, b, 0.0, c, 0.0, d]);
        let own = motion.accelerations();
        let expected = [laws[0][2], laws[1][2], own[0], laws[2][2], own[1], laws[3][2]];
        agree(seconds.as_slice(), &expected, 1e-11);
        let budget = scene.budget(&motion)?;
        agree(&[budget.kinetic, budget.potential], &[instant.kinetic, instant.potential], 1e-13);
    }
    Ok(())
}

#[test]
fn a_base_floats_under_the_efforts_of_its_drives() -> Result<(), catena::Error> {
    let [side, wrist, ..] = LAWS.map(swing);
    let (mid, bars) = (flat(3), [round(2), round(5)]);
    let bar = |k: usize| Link::<f64, 0b100, 0b111>::new(bars[k].0, bars[k].1, bars[k].2);
    let slide = Slide::at::<0b010>([0.0, 0.2, 0.0]).turned(Quarter::<8>);
    let arm = (Driven::new(slide, side).named("side"), general(body(1)), Hinge::at::<0b111>([0.1, -0.2, 0.3]), bar(0));
    let tail = (
        Hinge::at::<0b101>([0.3, 0.0, -0.1]).turned(Quarter::<30>).with(Spring::damping(0.3)).geared(0.2),
        Link::<f64, 0b110, 0b1111>::new(mid.0, mid.1, mid.2),
        Driven::new(Hinge::at::<0b001>([0.25, 0.0, 0.0]).turned(Leaning::by(0.6)), wrist).named("wrist"),
        general(body(4)),
        Slide::at::<0b111>([0.1, 0.2, 0.15]).turned(Turned::by(lean())).with(Spring::damping(0.4)).geared(0.5),
        bar(1),
    );
    let scene = System::new(Free, (BodyAxes, general(body(0)), Branch(arm), tail), Free)?.with_gravity(GRAVITY);

    let mut noise = Noise::new(6);
    for _ in 0..100 {
        let [place, velocity, spin, angles, q, v]: [[f64; 3]; 6] = std::array::from_fn(|_| list(&mut noise, 1.0));
        let (time, attitude) = (noise.between(0.0, 9.0), Rotation::from_angles(angles));
        let robot = plain_floating(place, &attitude, [velocity, spin]);
        let mut start = scene.motion().at_time(time);
        let coordinates: Vec<f64> = place.into_iter().chain(attitude.quaternion()).chain(q).collect();
        start.set_coordinates(&coordinates)?;
        let rates: Vec<f64> = velocity.into_iter().chain(spin).chain(v).collect();
        let motion = scene.with_accelerations(scene.with_rates(start, &rates)?, &Unloaded)?;
        let [a, b] = [side(time), wrist(time)];
        let (all_q, all_v) = ([a[0], q[0], q[1], b[0], q[2]], [a[1], v[0], v[1], b[1], v[2]]);
        let instant = robot.at(&all_q, &all_v);
        let [push, turn] = drives!(scene, &motion, robot, instant, ["side": 0 => a, "wrist": 3 => b]);
        let mut forces = [0.0; 11];
        (forces[6], forces[9]) = (push, turn);
        let own = motion.accelerations();
        let mut expected = own[..6].to_vec();
        expected.extend([a[2], own[6], own[7], b[2], own[8]]);
        agree(robot.forward_dynamics(&all_q, &all_v, &forces).as_slice(), &expected, 1e-11);
    }
    Ok(())
}

#[test]
fn runs_agree_with_those_in_inertial_axes() -> Result<(), Box<dyn std::error::Error>> {
    let [crank, spindle, ..] = LAWS.map(swing);
    let turns = [[0.4, -0.7, 1.1], [0.2, 0.5, -0.3], [1.0, 0.1, 0.6]].map(Rotation::from_angles);
    let places = [[0.3, 0.0, -0.1], [0.1, 0.2, 0.15], [0.0, 0.1, 0.2]];
    let at = |k: usize| Hinge::at::<0b111>(places[k]).turned(Turned::by(turns[k]));
    let slide = Slide::at::<0b111>(places[1]).turned(Turned::by(turns[1]));
    let chain = (
        Driven::new(Hinge::level().grounded(), crank),
        general(body(0)),
        at(0).with(Spring::stiffness(3.0).damped(0.3)),
        general(body(1)),
        Driven::new(slide, spindle),
        general(body(2)),
        at(2),
        general(body(4)),
    );
    let own = System::new(Base::origin(), chain, Free)?.with_gravity(GRAVITY);

    let (z, weld) = ([0.0, 0.0, 1.0], |k: usize| Weld::at(turns[k]));
    let rigid = |k: usize, next: usize| {
        let (mass, centre, tensor) = body(k);
        RigidBody::new(mass, tensor, centre, places[next])
    };
    let chain = (
        Driven::new(Revolute::about(z), crank),
        rigid(0, 0),
        weld(0),
        Revolute::about(z).with(Spring::stiffness(3.0).damped(0.3)),
        rigid(1, 1),
        weld(1),
        Driven::new(Prismatic::along(z), spindle),
        rigid(2, 2),
        weld(2),
        Revolute::about(z),
        rigid(4, 0),
    );
    let other = System::new(Clamped::origin(), chain, Free)?.with_gravity(GRAVITY);
    macro_rules! agree_by {
        ($rule:expr, $tolerance:expr) => {
            for time in [0.0, 2.5] {
                let end =
                    own.simulation($rule).run(own.at_rest(&[0.4, -0.8])?.at_time(time), time + 1.0, |_| ())?.motion;
                let start = other.at_rest(&[0.4, -0.8])?.at_time(time);
                let right = other.simulation($rule).run(start, time + 1.0, |_| ())?.motion;
                let pairs = end.coordinates().into_iter().zip(right.coordinates());
                pairs.chain(end.rates().into_iter().zip(right.rates())).for_each(|(x, y)| near(x, y, $tolerance));
            }
        };
    }
    agree_by!(Rk4::step(0.01), 1e-12);
    agree_by!(Dop853::tolerance(1e-9), 1e-10);
    agree_by!(Sdirk4::new().step(0.01), 1e-11);
    agree_by!(GeneralizedAlpha::new(0.8).step(0.005), 1e-11);
    agree_by!(Vcabm::new().tolerance(1e-8), 1e-9);
    Ok(())
}
