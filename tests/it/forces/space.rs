//! Accelerations and reactions of spatial chains in general position, against a dense system of Newton-Euler equations.

mod twins;

use catena::Error;
use catena::spatial::*;
use catena_oracle::Noise;
use catena_oracle::space as oracle;
use catena_oracle::space::Vector;
use twins::{TOLERANCE, body, difference, vector};

fn axis(noise: &mut Noise) -> Vector {
    let axis = vector(noise);
    if axis.norm() > 0.3 { axis } else { axis + Vector::new(0.7, 0.2, -0.4) }
}

/// Every joint, with springs, dampers, rest values and efforts, every body under a load.
#[test]
fn every_joint_in_general_position() -> Result<(), Error> {
    let mut worst = 0.0_f64;
    for seed in 0..20 {
        let mut noise = Noise::new(seed);
        let pairs: Vec<_> = (0..8).map(|_| body(&mut noise)).collect();
        let b: Vec<RigidBody<f64>> = pairs.iter().map(|pair| pair.0).collect();
        let mut twins: Vec<oracle::Body> = pairs.iter().map(|pair| pair.1).collect();
        let axes: [Vector; 5] = core::array::from_fn(|_| axis(&mut noise));
        let second = axes[1].cross(&axes[4]) + axes[1] * 0.3; // not parallel, and not at right angles
        let welded = [noise.next(), noise.next(), noise.next()];
        let chain = (
            (
                b[0],
                Revolute::about(axes[0].into()).with(Spring::stiffness(3.0).damped(0.2).resting_at(0.4)),
                b[1],
                Universal::about(axes[1].into(), second.into()).with(Spring::stiffness(2.0), Spring::damping(0.3)),
                b[2],
                Prismatic::along(axes[2].into()).with(Spring::stiffness(40.0).resting_at(0.1)),
                b[3],
            ),
            Cylindrical::on(axes[3].into()).with(Spring::stiffness(25.0).damped(1.0), Spring::damping(0.1)),
            b[4],
            Weld::at(Rotation::from_angles(welded)),
            b[5],
            Ball,
            b[6],
            Revolute::about([0.0, 1.0, 0.0]),
            b[7],
        );
        let gravity = Vector::new(0.3, -9.81, 0.7);
        let system = System::new(Pinned::at([0.1, -0.2, 0.3]), chain, Free)?.with_gravity_vector(gravity);
        let mut motion = system.motion();
        let root = [noise.next(), noise.next(), noise.next()];
        let ball = [noise.next(), noise.next(), noise.next()];
        let root_spin = vector(&mut noise);
        let ball_spin = vector(&mut noise) * 2.0;
        let q: [f64; 7] = core::array::from_fn(|_| noise.next());
        let v: [f64; 7] = core::array::from_fn(|_| 2.0 * noise.next());
        let (first, rest) = motion.position_mut();
        *first = Rotation::from_angles(root);
        rest.0.1 = q[0];
        rest.0.3 = [q[1], q[2]];
        rest.0.5 = q[3];
        rest.1 = [q[4], q[5]];
        rest.5 = Rotation::from_angles(ball);
        rest.7 = q[6];
        let (first, rest) = motion.rate_mut();
        *first = root_spin.into();
        rest.0.1 = v[0];
        rest.0.3 = [v[1], v[2]];
        rest.0.5 = v[3];
        rest.1 = [v[4], v[5]];
        rest.5 = ball_spin.into();
        rest.7 = v[6];

        let efforts: [[f64; 3]; 8] = core::array::from_fn(|_| core::array::from_fn(|_| noise.next()));
        let (at, force, torque) = (vector(&mut noise), vector(&mut noise) * 3.0, vector(&mut noise));
        for twin in &mut twins {
            (twin.at, twin.force, twin.torque) = (at, force, torque);
        }
        let loads = Loads::none().efforts(efforts.map(Effort)).on_bodies(|_: f64, _, body: &BodyMotion<f64>| {
            body.force_at(at.into(), force.into()) + Wrench::torque(torque.into())
        });
        let motion = system.with_accelerations(motion, &loads)?;

        let e = |k: usize, i: usize| efforts[k][i];
        let joints = [
            oracle::Joint::Ball { attitude: oracle::angles(root), spin: root_spin, torque: efforts[0].into() },
            oracle::Joint::Revolute {
                axis: axes[0],
                angle: q[0],
                rate: v[0],
                torque: e(1, 0) - 3.0 * (q[0] - 0.4) - 0.2 * v[0],
            },
            oracle::Joint::Universal {
                axes: [axes[1], second],
                angles: [q[1], q[2]],
                rates: [v[1], v[2]],
                torques: [e(2, 0) - 2.0 * q[1], e(2, 1) - 0.3 * v[2]],
            },
            oracle::Joint::Prismatic { axis: axes[2], slide: q[3], rate: v[3], force: e(3, 0) - 40.0 * (q[3] - 0.1) },
            oracle::Joint::Cylindrical {
                axis: axes[3],
                position: [q[4], q[5]],
                rates: [v[4], v[5]],
                efforts: [e(4, 0) - 25.0 * q[4] - v[4], e(4, 1) - 0.1 * v[5]],
            },
            oracle::Joint::Weld { attitude: oracle::angles(welded) },
            oracle::Joint::Ball { attitude: oracle::angles(ball), spin: ball_spin, torque: efforts[6].into() },
            oracle::Joint::Revolute { axis: Vector::y(), angle: q[6], rate: v[6], torque: e(7, 0) },
        ];
        let ground = oracle::Frame { place: Vector::new(0.1, -0.2, 0.3), ..oracle::Frame::still() };
        let answer = oracle::solve(ground, gravity, &twins, &joints, oracle::Tip::Free);
        worst = worst.max(difference(&system, &motion, &loads, &answer));
    }
    println!("largest relative difference {worst:.1e}");
    assert!(worst < TOLERANCE, "{worst:.1e}");
    Ok(())
}

/// Rods and bobs are rigid bodies with fewer numbers; ends move and turn, float, and hold.
#[test]
fn every_end_in_general_position() -> Result<(), Error> {
    let mut worst = [0.0_f64; 9];
    for seed in 100..120 {
        let mut noise = Noise::new(seed);
        let (b0, t0) = body(&mut noise);
        let (b2, t2) = body(&mut noise);
        let (length, radius, mass) = (noise.between(0.5, 1.0), noise.between(0.05, 0.2), noise.between(0.5, 2.0));
        let rod = Rod::uniform(length, radius, mass);
        let across = mass * (3.0 * radius * radius + length * length) / 12.0;
        let diagonal = Vector::new(0.5 * mass * radius * radius, across, across);
        let t1 = oracle::Body {
            mass,
            inertia: oracle::Matrix::from_diagonal(&diagonal),
            centre: Vector::new(0.5 * length, 0.0, 0.0),
            outboard: Vector::new(length, 0.0, 0.0),
            ..t0
        };
        let (short, bob) = (noise.between(0.2, 0.4), noise.between(0.1, 0.5));
        let t3 = oracle::Body {
            mass: bob,
            inertia: oracle::Matrix::zeros(),
            centre: Vector::new(short, 0.0, 0.0),
            outboard: Vector::new(short, 0.0, 0.0),
            ..t0
        };
        let axes: [Vector; 3] = core::array::from_fn(|_| axis(&mut noise));
        let chain = (b0, Ball, rod, Universal::about([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]), b2);
        let gravity = Vector::new(0.0, -9.81, 0.0);
        let (one, three) = ([noise.next(), noise.next(), noise.next()], [noise.next(), noise.next(), noise.next()]);
        let (root_spin, spin) = (vector(&mut noise), vector(&mut noise));
        let (q, v): ([f64; 2], [f64; 2]) = ([noise.next(), noise.next()], [noise.next(), noise.next()]);
        let ball = oracle::Joint::Ball { attitude: oracle::angles(one), spin, torque: Vector::zeros() };
        let cardan =
            oracle::Joint::Universal { axes: [Vector::y(), Vector::z()], angles: q, rates: v, torques: [0.0; 2] };
        let twins = [t0, t1, t2];
        let still = oracle::Frame::still();
        let root_ball =
            oracle::Joint::Ball { attitude: oracle::angles(three), spin: root_spin, torque: Vector::zeros() };
        macro_rules! set {
            ($motion:expr, $first:expr, $rate:expr) => {{
                $motion.position_mut().0 = $first;
                $motion.position_mut().1.1 = Rotation::from_angles(one);
                $motion.position_mut().1.3 = q;
                $motion.rate_mut().0 = $rate;
                $motion.rate_mut().1.1 = spin.into();
                $motion.rate_mut().1.3 = v;
            }};
        }
        macro_rules! compare {
            ($case:literal, $system:expr, $first:expr, $rate:expr, $ground:expr, $joint:expr, $tip:expr) => {{
                let system = $system?.with_gravity_vector(gravity);
                let mut motion = system.motion();
                set!(motion, $first, $rate);
                let motion = system.with_accelerations(motion, &Unloaded)?;
                let answer = oracle::solve($ground, gravity, &twins, &[$joint, ball, cardan], $tip);
                let found = difference(&system, &motion, &Unloaded, &answer);
                worst[$case] = worst[$case].max(found);
            }};
        }
        // A root whose ground moves and turns.
        let (velocity, linear, turning, angular) =
            (vector(&mut noise), vector(&mut noise), vector(&mut noise), vector(&mut noise));
        let tilted = [noise.next(), noise.next(), noise.next()];
        let shaken = oracle::Frame { velocity, linear, ..still };
        let turned = oracle::Frame { attitude: oracle::angles(tilted), spin: turning, angular, ..shaken };
        let moving = Moving(move |_: f64| GroundMotion {
            place: [0.0; 3],
            velocity: velocity.into(),
            acceleration: linear.into(),
        });
        let attitude = Turning(move |_: f64| AttitudeMotion {
            attitude: Rotation::from_angles(tilted),
            spin: turning.into(),
            acceleration: angular.into(),
        });
        let clamp = Clamped { place: moving, attitude };
        let weld = oracle::Joint::Weld { attitude: oracle::Matrix::identity() };
        let first = Rotation::from_angles(three);
        let rate: [f64; 3] = root_spin.into();
        compare!(0, System::new(Pinned::on(moving), chain, Free), first, rate, shaken, root_ball, oracle::Tip::Free);
        compare!(1, System::new(clamp, chain, Free), (), (), turned, weld, oracle::Tip::Free);
        let hinge = oracle::Joint::Revolute { axis: axes[0], angle: 0.7, rate: -0.4, torque: 0.0 };
        let hinged = System::new(Hinged::at([0.0; 3], axes[0].into()), chain, Free);
        compare!(2, hinged, 0.7, -0.4, still, hinge, oracle::Tip::Free);
        let free =
            oracle::Joint::Free { place: axes[1], velocity: axes[2], attitude: oracle::angles(three), spin: root_spin };
        let (place, velocity) = ((axes[1].into(), first), (axes[2].into(), rate));
        compare!(3, System::new(Free, chain, Free), place, velocity, still, free, oracle::Tip::Free);
        let pinned = System::new(Pinned::origin(), chain, Pinned::on(moving));
        compare!(4, pinned, first, rate, still, root_ball, oracle::Tip::Pinned(linear));
        let clamped = System::new(Pinned::origin(), chain, clamp);
        compare!(5, clamped, first, rate, still, root_ball, oracle::Tip::Clamped(linear, angular));

        let still_hinge = Hinged::at([0.0; 3], axes[2].into());
        let pinned = System::new(Pinned::origin(), chain, still_hinge);
        compare!(6, pinned, first, rate, still, root_ball, oracle::Tip::Hinged(still, axes[2]));
        let pinned = System::new(Pinned::origin(), chain, Hinged::on(clamp, axes[2].into()));
        compare!(7, pinned, first, rate, still, root_ball, oracle::Tip::Hinged(turned, axes[2]));
        let hinged = System::new(Hinged::on(clamp, axes[0].into()), chain, Free);
        compare!(8, hinged, 0.7, -0.4, turned, hinge, oracle::Tip::Free);

        // A bob hangs from a universal joint, which keeps it from spinning.
        let chain = (b0, Universal::about([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]), PointMass::new(short, bob));
        let system = System::new(Pinned::origin(), chain, Free)?.with_gravity_vector(gravity);
        let mut motion = system.motion();
        motion.position_mut().0 = first;
        motion.position_mut().1.1 = q;
        motion.rate_mut().0 = rate;
        motion.rate_mut().1.1 = v;
        let motion = system.with_accelerations(motion, &Unloaded)?;
        let answer = oracle::solve(still, gravity, &[t0, t3], &[root_ball, cardan], oracle::Tip::Free);
        worst[0] = worst[0].max(difference(&system, &motion, &Unloaded, &answer));
    }
    println!("largest relative differences {worst:?}");
    assert!(worst.iter().all(|worst| *worst < TOLERANCE), "{worst:?}");
    Ok(())
}
