//! Motions of elastic hinges in space: against the dense oracle integrated by extrapolation, energy and momentum, orders of rules,
//! stiffness without end, forms of scenes.

use catena::Error;
use catena::spatial::*;
use catena_oracle::extrapolation::extrapolate;
use catena_oracle::space as oracle;
use catena_oracle::space::elastic::Law;
use catena_oracle::{has_order, slope};
use core::f64::consts::PI;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

mod numbers;

const TENSOR: [[f64; 3]; 3] = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
const CENTRE: [f64; 3] = [0.5, 0.03, -0.02];
const OUTBOARD: [f64; 3] = [1.0, 0.1, -0.05];

fn body() -> RigidBody<f64> {
    RigidBody::new(1.0, TENSOR, CENTRE, OUTBOARD)
}

type Full3<D> = ElasticHinge<RotarySpring<f64, D>, Linear<f64, Spring<f64, D>, Spring<f64, D>, Spring<f64, D>>>;

/// Undamped, all stiffnesses different.
fn elastic(scale: f64) -> Full3<catena::planar::Absent> {
    let along = |k: f64| Spring::stiffness(scale * k);
    ElasticHinge::rotary([3.0, 8.0, 5.0].map(|k| scale * k)).with_linear(along(60.0), along(90.0), along(40.0))
}

/// A chain on shaken ground, with all parts of one hinge and half of those of another, for a while: places, attitudes and reactions.
#[test]
fn motions_are_those_of_the_oracle() -> Result<(), Error> {
    const END: f64 = 0.5;
    let along = [[60.0, 1.0, 0.05], [90.0, 0.5, -0.02], [40.0, 0.8, 0.03]];
    let all = Law {
        rotary: [3.0, 8.0, 5.0],
        damping: [0.1, 0.3, 0.2],
        rest: [0.2, -0.1, 0.3],
        linear: along,
        together: false,
    };
    let half = Law { linear: along, ..Law::default() };
    let shaken = |t: f64| oracle::Frame {
        place: oracle::Vector::new(0.1 * (3.0 * t).sin(), 0.05 * (2.0 * t).cos(), 0.0),
        velocity: oracle::Vector::new(0.3 * (3.0 * t).cos(), -0.1 * (2.0 * t).sin(), 0.0),
        linear: oracle::Vector::new(-0.9 * (3.0 * t).sin(), -0.2 * (2.0 * t).cos(), 0.0),
        ..oracle::Frame::still()
    };
    let ground = Moving(move |t: f64| {
        let oracle::Frame { place, velocity, linear, .. } = shaken(t);
        GroundMotion { place: place.into(), velocity: velocity.into(), acceleration: linear.into() }
    });
    let spring = |[k, c, rest]: [f64; 3]| Spring::stiffness(k).damped(c).resting_at(rest);
    let [x, y, z] = along.map(spring);
    let first = ElasticHinge::rotary(all.rotary).damped_about(all.damping).resting_at(all.rest).with_linear(x, y, z);
    let second = ElasticHinge::linear(x, y, z);
    let root = Clamped { place: ground, attitude: Rotation::identity() };
    let system = System::new(root, (body(), first, body(), second, body()), Free)?.with_gravity([0.0, -9.81, 0.0]);
    let mut start = system.motion();
    start.position_mut().1.1 = ([0.02, -0.05, 0.03], Rotation::exp([0.3, -0.2, 0.4]));
    start.position_mut().1.3 = ([-0.01, 0.04, 0.02], Rotation::exp([-0.5, 0.3, 0.8]));
    start.rate_mut().1.1 = ([0.1, -0.2, 0.3], [1.0, -1.0, 0.5]);
    start.rate_mut().1.3 = ([0.0, 0.3, -0.1], [-1.0, 0.5, 2.0]);

    // Coordinates of a hinge: displacement, quaternion, their rates.
    let twin = oracle::Body {
        mass: 1.0,
        inertia: oracle::Matrix::from_fn(|i, j| TENSOR[i][j]),
        centre: CENTRE.into(),
        outboard: OUTBOARD.into(),
        force: oracle::Vector::zeros(),
        at: oracle::Vector::zeros(),
        torque: oracle::Vector::zeros(),
    };
    let gravity = oracle::Vector::new(0.0, -9.81, 0.0);
    let of = |y: &[f64], at: usize| oracle::Vector::new(y[at], y[at + 1], y[at + 2]);
    let quaternion = |y: &[f64]| Quaternion::new(y[3], y[4], y[5], y[6]);
    let joints = |y: &[f64]| {
        let joint = |law: &Law, y: &[f64]| {
            let attitude = UnitQuaternion::from_quaternion(quaternion(y)).to_rotation_matrix();
            let phi = oracle::elastic::logarithm(*attitude.matrix());
            law.joint(of(y, 0), of(y, 7), phi, of(y, 10), oracle::Vector::zeros())
        };
        let weld = oracle::Joint::Weld { attitude: oracle::Matrix::identity() };
        [weld, joint(&all, &y[..13]), joint(&half, &y[13..])]
    };
    let parents = [None, Some(0), Some(1)];
    let solve = |t: f64, y: &[f64]| oracle::solve(shaken(t), gravity, &[twin; 3], &joints(y), oracle::Tip::Free);
    let slope = |t: f64, y: &[f64]| {
        let frames = oracle::kinematics(shaken(t), &parents, &[twin; 3], &joints(y));
        let answer = solve(t, y);
        let mut slopes = vec![];
        for k in [1, 2] {
            let (inner, outer, y) = (&frames[k - 1], &frames[k], &y[13 * (k - 1)..13 * k]);
            let point = |k: usize, at: oracle::Vector| {
                let arm = frames[k].attitude * (at - twin.centre);
                answer.linear[k] + answer.angular[k].cross(&arm) + frames[k].spin.cross(&frames[k].spin.cross(&arm))
            };
            let (d, sliding) = (inner.attitude * of(y, 0), inner.attitude * of(y, 7));
            let (spin, turning) = (inner.spin, answer.angular[k - 1]);
            let carried = turning.cross(&d) + spin.cross(&spin.cross(&d)) + 2.0 * spin.cross(&sliding);
            let along = point(k, oracle::Vector::zeros()) - point(k - 1, twin.outboard) - carried;
            let relative = outer.spin - inner.spin;
            let about = answer.angular[k] - turning - spin.cross(&relative);
            let rate = quaternion(y) * Quaternion::from_imag(of(y, 10)) * 0.5;
            slopes.extend(of(y, 7).iter());
            slopes.extend([rate.w, rate.i, rate.j, rate.k]);
            slopes.extend((inner.attitude.transpose() * along).iter());
            slopes.extend((outer.attitude.transpose() * about).iter());
        }
        slopes
    };
    let mut first = vec![];
    let ((_, positions), (_, rates)) = (start.position(), start.rate());
    for ((at, turned), (place, spin)) in [(positions.1, rates.1), (positions.3, rates.3)] {
        first.extend(at);
        first.extend(turned.quaternion());
        first.extend(place);
        first.extend(spin);
    }
    let last = extrapolate(slope, 0.0, END, &first, 1e-13);
    let answer = solve(END, &last);
    let frames = oracle::kinematics(shaken(END), &parents, &[twin; 3], &joints(&last));

    let run = system.simulate(start, Dop853::tolerance(1e-14), END, |_| ())?;
    let stations = system.stations(&run.motion, &Unloaded)?;
    let mut errors = vec![];
    for (k, frame) in frames.iter().enumerate() {
        let station = stations.get(2 * k).expect("a body's inboard end");
        errors.push((station.frame.place - frame.place).norm());
        errors.push((station.frame.turn.attitude.x - frame.attitude.column(0)).norm());
        errors.push((station.internal.force - answer.forces[k]).norm());
        errors.push((station.torque_outboard() - answer.torques[k]).norm());
    }
    println!("places, attitudes, forces, torques: {errors:?}, the second hinge {:?} m apart", &last[13..16]);
    assert!(errors.iter().all(|error| *error < 1e-10));
    Ok(())
}

/// Two free bodies on an undamped hinge: energy and momentum of the motion, by how much explicit rules miss them.
#[test]
fn undamped_hinges_conserve_energy_and_momentum() -> Result<(), Error> {
    const END: f64 = 2.0;
    let system = System::new(Free, (body(), elastic(1.0), body()), Free)?;
    let start = system.at_rest(&[0.3, 0.2, -0.4, 0.9, -0.3, 0.4])?;
    let mut start = system.with_rates(start, &[0.1, -0.2, 0.3, 1.0, -0.6, 0.5, 0.5, -0.7, 0.4, 0.3, 1.1, -0.8])?;
    start.position_mut().1.1.0 = [0.1, -0.05, 0.08];
    let first = system.budget(&start)?;
    let errors = |motion: &_| {
        let last = system.budget(motion).unwrap();
        [
            f64::abs(last.energy() - first.energy()),
            (last.momentum - first.momentum).norm(),
            (last.angular_momentum - first.angular_momentum).norm(),
        ]
    };
    let mut worst = [0.0_f64; 3];
    system.simulate(start, Dop853::tolerance(1e-14), END, |now| {
        for (worst, error) in worst.iter_mut().zip(errors(now.motion())) {
            *worst = worst.max(error);
        }
    })?;
    println!("DOP853 at 1e-14: {worst:?} of {:.2} J", first.energy());
    assert!(worst.iter().all(|worst| *worst < 1e-12));
    let names = ["energy", "momentum", "angular momentum"];
    let mut points = [(); 6].map(|()| vec![]);
    for n in [200, 400, 800] {
        let h = END / f64::from(n);
        let fourth = errors(&system.simulate(start, Rk4::step(h), END, |_| ())?.motion);
        let fifth = errors(&system.simulate(start, Dopri5::step(h), END, |_| ())?.motion);
        for (points, error) in points.iter_mut().zip(fourth.into_iter().chain(fifth)) {
            points.push((h, error));
        }
    }
    for (k, points) in points.iter().enumerate() {
        let (order, found) = ([4.0, 5.0][k / 3], slope(points));
        println!("{} of order {order}: {points:?}, {found:.2}", names[k % 3]);
        assert!(found > order - 0.2 && points[2].1 > 1e-14);
    }
    Ok(())
}

const END: f64 = 1.0;

/// Errors of places and attitude of the tip, and of force and torque at the root.
macro_rules! errors {
    ($system:expr, $motion:expr, $exact:expr) => {{
        let [a, b] = [&$motion, &$exact].map(|motion| $system.stations(motion, &Unloaded).unwrap());
        let (tip, end) = (a.tip().frame, b.tip().frame);
        let (root, start) = (a.root().internal, b.root().internal);
        [
            (tip.place - end.place).norm() + (tip.turn.attitude.y - end.turn.attitude.y).norm(),
            (root.force - start.force).norm(),
            (root.torque - start.torque).norm(),
        ]
    }};
}

#[test]
fn implicit_rules_have_their_orders() -> Result<(), Error> {
    let damped = |k: f64| Spring::stiffness(k).damped(0.02 * k);
    let hinge = ElasticHinge::rotary([5.0, 9.0, 7.0]).damped_about([0.1, 0.2, 0.3]).resting_at([0.2, -0.3, 0.1]);
    let hinge = hinge.with_linear(damped(60.0), damped(90.0), Spring::stiffness(200.0).resting_at(0.02));
    let loose = ElasticHinge::linear(damped(150.0), Spring::stiffness(100.0), damped(80.0));
    let chain = (body(), hinge, body(), loose, body());
    let system = System::new(Clamped::origin(), chain, Free)?.with_gravity([0.0, -3.0, 0.0]);
    let mut start = system.motion();
    start.rate_mut().1.1 = ([0.1, -0.2, 0.3], [1.0, -1.0, 0.5]);
    start.rate_mut().1.3 = ([0.0, 0.3, -0.1], [-1.0, 0.5, 1.0]);
    let exact = system.simulate(start, Dop853::tolerance(1e-14), END, |_| ())?.motion;
    let names = ["place and attitude", "force", "torque"];
    let mut points = [(); 6].map(|()| vec![]);
    for (coarse, fine) in [(200, 100), (400, 160), (800, 250)] {
        let (g, h) = (END / f64::from(coarse), END / f64::from(fine));
        let second = system.simulate(start, GeneralizedAlpha::new(0.8).step(g), END, |_| ())?.motion;
        let fourth = system.simulate(start, Sdirk4::new().step(h), END, |_| ())?.motion;
        for (k, error) in errors!(system, second, exact).into_iter().enumerate() {
            points[k].push((g, error));
        }
        for (k, error) in errors!(system, fourth, exact).into_iter().enumerate() {
            points[3 + k].push((h, error));
        }
    }
    for (k, points) in points.iter().enumerate() {
        let (rule, order) = [("generalised-α", 2.0), ("SDIRK4", 4.0)][k / 3];
        has_order(&format!("{rule}, {}", names[k % 3]), order, 1e-12, points);
    }
    Ok(())
}

/// Hinges of any stiffness are welds but for the reciprocal of it.
#[test]
fn stiff_hinges_are_welds() -> Result<(), Error> {
    let weld = Weld::at(Rotation::identity());
    let welded = System::new(Clamped::origin(), (body(), weld, body(), Ball, body(), weld, body()), Free)?;
    let welded = welded.with_gravity([0.0, -3.0, 0.0]);
    let exact = welded.simulate(welded.motion(), Dop853::tolerance(1e-13), END, |_| ())?.motion;
    for k in [1e6, 1e8, 1e10] {
        let c = 0.2 * f64::sqrt(k); // so that what the start leaves of vibration has died away
        let along = Spring::stiffness(k).damped(c);
        let stiff = ElasticHinge::rotary([k, 0.5 * k, 2.0 * k]).damped(c).with_linear(along, along, along);
        let system = System::new(Clamped::origin(), (body(), stiff, body(), Ball, body(), stiff, body()), Free)?;
        let system = system.with_gravity([0.0, -3.0, 0.0]);
        let second = system.simulate(system.motion(), GeneralizedAlpha::new(0.8).step(0.0025), END, |_| ())?.motion;
        let fourth = system.simulate(system.motion(), Sdirk4::new().step(0.005), END, |_| ())?.motion;
        let forces = [system.stations(&second, &Unloaded)?, system.stations(&fourth, &Unloaded)?];
        let expected = welded.stations(&exact, &Unloaded)?.root().internal.force;
        let errors = forces.map(|stations| (stations.root().internal.force - expected).norm());
        println!("k = {k:.0e}: generalised-α {:.1e}, SDIRK4 {:.1e}", errors[0], errors[1]);
        // Of second order, and of fourth order or c/k, by which dampers delay springs.
        assert!(errors[0] < 5e-4 && errors[1] < 1e-6 + 2.0 * c / k);
    }
    Ok(())
}

/// A tip held beyond hinges: what holds it, by an explicit and by implicit rules.
#[test]
fn tips_are_held_beyond_hinges() -> Result<(), Error> {
    let along = Spring::stiffness(300.0).damped(2.0);
    let hinge = ElasticHinge::rotary([20.0, 30.0, 25.0]).damped(0.3).with_linear(along, along, along);
    let system = System::new(Pinned::origin(), (body(), hinge, body(), hinge, body()), Pinned::at([3.0, 0.3, -0.15]))?;
    let system = system.with_gravity([0.0, -9.81, 0.0]);
    let start = system.motion();
    let end = 0.4;
    let exact = system.simulate(start, Dop853::tolerance(1e-13), end, |_| ())?.motion;
    let expected = Vector3::from(*exact.multipliers());
    let mut points = [vec![], vec![]];
    for (coarse, fine) in [(100, 40), (200, 60), (400, 90)] {
        let (g, h) = (end / f64::from(coarse), end / f64::from(fine));
        let second = system.simulate(start, GeneralizedAlpha::new(0.8).step(g), end, |_| ())?.motion;
        let fourth = system.simulate(start, Sdirk4::new().step(h), end, |_| ())?.motion;
        points[0].push((g, (Vector3::from(*second.multipliers()) - expected).norm()));
        points[1].push((h, (Vector3::from(*fourth.multipliers()) - expected).norm()));
    }
    has_order("generalised-α, force at the tip", 2.0, 1e-11, &points[0]);
    has_order("SDIRK4, force at the tip", 4.0, 1e-11, &points[1]);
    Ok(())
}

/// Tuples, arrays and vectors of hinges before and after other elements move alike, bit by bit.
#[test]
fn forms_of_a_chain_of_hinges_are_bit_identical() -> Result<(), Error> {
    let (h, b) = (elastic(1.0), body());
    let pin = Revolute::about([0.0, 1.0, 0.2]);
    let flat = System::new(Pinned::origin(), (b, h, b, h, b, h, b, pin, b), Free)?.with_gravity([0.0, -9.81, 0.0]);
    let nested =
        System::new(Pinned::origin(), ((b, h, b), (h, b), h, (b, pin, b)), Free)?.with_gravity([0.0, -9.81, 0.0]);
    let array = System::new(Pinned::origin(), (b, [(h, b); 3], pin, b), Free)?.with_gravity([0.0, -9.81, 0.0]);
    let vector = System::new(Pinned::origin(), (b, vec![(h, b); 3], pin, b), Free)?.with_gravity([0.0, -9.81, 0.0]);
    macro_rules! tip {
        ($system:expr, $rule:expr) => {{
            let angles: Vec<f64> = (0..13).map(|k| 0.3 * f64::from(k).sin()).collect();
            let run = $system.simulate($system.at_rest(&angles)?, $rule, 0.1, |_| ())?;
            let stations = $system.stations(&run.motion, &Unloaded).unwrap();
            (stations.tip().frame.place, stations.root().internal.force)
        }};
    }
    macro_rules! compare {
        ($rule:expr) => {
            let flat = tip!(flat, $rule);
            assert_eq!(flat, tip!(nested, $rule));
            assert_eq!(flat, tip!(array, $rule));
            assert_eq!(flat, tip!(vector, $rule));
            assert!(flat.0.norm() > 1.0 && flat.0.x < 5.0 * PI);
        };
    }
    compare!(Dopri5::step(0.01));
    compare!(Sdirk4::new().step(0.01));
    compare!(GeneralizedAlpha::new(0.8).step(0.01));
    Ok(())
}
