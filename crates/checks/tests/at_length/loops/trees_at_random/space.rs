//! Trees in space.

use super::*;
use crate::forces::space::twins::body;
use catena::Error;
use catena::loading::Loading;
use catena::spatial::{self, *};
use catena::system::MotionOf;
use catena::system::{Root, Tip};

fn read<R, C, P, L>(
    system: &spatial::System<f64, R, C, P>,
    motion: &MotionOf<Spatial<f64>, R, C, P>,
    loads: &L,
) -> Found
where
    R: Root<Spatial<f64>>,
    C: catena::system::Element<Spatial<f64>>,
    P: Tip<Spatial<f64>>,
    L: Loading<Spatial<f64>>,
{
    let bodies = system.body_motions(motion).unwrap();
    let stations = system.stations(motion, loads).unwrap();
    let of = |station: &Station<f64>| [station.internal.force, station.torque_outboard(), station.frame.place];
    let ([force, torque, _], tip) = (of(stations.root()), of(stations.tip()));
    Found {
        linear: bodies.iter().map(|body| body.centre().acceleration.linear).collect(),
        angular: bodies.iter().map(|body| body.inboard.acceleration.angular).collect(),
        stations: stations.iter().map(of).collect(),
        root: [force, torque],
        tip: [-tip[0], -tip[1]],
    }
}

fn vector(noise: &mut Noise) -> Vector {
    Vector::new(noise.next(), noise.next(), noise.next())
}

/// Trees of random shape under gravity, loads on all bodies and torques in all balls, with a free tip or one that moves as it must.
#[test]
fn of_random_shape() -> Result<(), Error> {
    let (mut worst, mut most) = (0.0_f64, 0);
    for seed in 0..30 {
        let mut grower = Grower::new(seed, Ball, body);
        let (first, trunk, last) = grower.tree();
        let Grower { mut noise, parents, mut twins, .. } = grower;
        let n = twins.len();
        most = most.max(n);
        let mut vectors = |size: f64| (0..n).map(|_| vector(&mut noise) * size).collect::<Vec<Vector>>();
        let (angles, spins, torques, forces) = (vectors(1.4), vectors(2.0), vectors(1.0), vectors(3.0));
        let at = [0.4, -0.1, 0.2];
        let ball = |k: usize| oracle::Joint::Ball {
            attitude: oracle::angles(angles[k].into()),
            spin: spins[k],
            torque: torques[k],
        };
        let joints: Vec<_> = (0..n).map(ball).collect();
        for (twin, force) in twins.iter_mut().zip(&forces) {
            (twin.at, twin.force, twin.torque) = (at.into(), *force, Vector::new(0.5, 0.0, -0.2));
        }
        let loads = Loads::none()
            .on_bodies(|_, k: usize, body: &BodyMotion<f64>| {
                body.force_at(at, forces[k].into()) + Wrench::torque([0.5, 0.0, -0.2])
            })
            .efforts(torques.iter().map(|torque| Effort((*torque).into())).collect::<Vec<_>>());
        let numbers = |vectors: &[Vector]| vectors.iter().flat_map(|v| [v.x, v.y, v.z]).collect::<Vec<f64>>();
        let (ground, gravity) = (oracle::Frame::still(), Vector::new(0.3, -9.81, 0.7));
        macro_rules! compare {
            ($tip:expr, $held:expr) => {{
                let system = System::new(Pinned::origin(), (first, trunk.clone()), $tip)?;
                let system = system.with_gravity_vector(gravity);
                let motion = system.with_rates(system.at_rest(&numbers(&angles))?, &numbers(&spins))?;
                let motion = system.with_accelerations(motion, &loads)?;
                let answer = oracle::solve_tree(ground, gravity, &parents, &twins, &joints, (last, $held));
                worst = worst.max(read(&system, &motion, &loads).difference(&answer, &alternating(n)));
            }};
        }
        compare!(Free, oracle::Tip::Free);
        let acceleration = vector(&mut noise);
        let moving = Moving(move |_: f64| GroundMotion {
            place: [0.0; 3],
            velocity: [0.0; 3],
            acceleration: acceleration.into(),
        });
        compare!(Pinned::on(moving), oracle::Tip::Pinned(acceleration));
    }
    assert!(most > 30, "at most {most} bodies");
    conclude(worst);
    Ok(())
}

/// Every joint at the foot of an arm, arms within arms, an arm fixed to its body.
#[test]
fn with_every_joint() -> Result<(), Error> {
    let mut worst = 0.0_f64;
    for seed in 0..20 {
        let mut noise = Noise::new(seed);
        let pairs: [_; 9] = core::array::from_fn(|_| body(&mut noise));
        let (b, twins) = (pairs.map(|pair| pair.0), pairs.map(|pair| pair.1));
        let mut axis = || vector(&mut noise) + Vector::new(1.2, 0.3, -0.4);
        let axes: [Vector; 4] = core::array::from_fn(|_| axis());
        let second = axes[1].cross(&axes[3]) + axes[1] * 0.3; // not parallel, and not at right angles
        let welded = [noise.next(), noise.next(), noise.next()];
        let chain = (
            b[0],
            Branch((
                Revolute::about(axes[0].into()).with(Spring::stiffness(3.0).damped(0.2).resting_at(0.4)),
                b[1],
                Branch((
                    Universal::about(axes[1].into(), second.into()).with(Spring::stiffness(2.0), Spring::none()),
                    b[2],
                )),
                Ball,
                b[3],
            )),
            Branch((
                Prismatic::along(axes[2].into()).with(Spring::stiffness(40.0).resting_at(0.1)),
                b[4],
                Branch(b[5]),
            )),
            Branch((Weld::at(Rotation::from_angles(welded)), b[6])),
            Cylindrical::on(axes[3].into()).with(Spring::stiffness(25.0).damped(1.0), Spring::damping(0.1)),
            b[7],
            Ball,
            b[8],
        );
        let parents = [None, Some(0), Some(1), Some(1), Some(0), Some(4), Some(0), Some(0), Some(7)];
        let inboard = [0, 2, 4, 6, 8, 9, 11, 13, 15];
        let balls: [[f64; 3]; 3] = core::array::from_fn(|_| vector(&mut noise).into());
        let spins: [Vector; 3] = core::array::from_fn(|_| vector(&mut noise) * 2.0);
        let q: [f64; 6] = core::array::from_fn(|_| noise.next());
        let v: [f64; 6] = core::array::from_fn(|_| 2.0 * noise.next());
        // Of all joints: the body fixed to its parent has none.
        let efforts: [[f64; 3]; 8] = core::array::from_fn(|_| vector(&mut noise).into());
        let loads = Loads::none().efforts(efforts.map(Effort));
        let ball = |k: usize, joint: usize| oracle::Joint::Ball {
            attitude: oracle::angles(balls[k]),
            spin: spins[k],
            torque: efforts[joint].into(),
        };
        let e = |k: usize, i: usize| efforts[k][i];
        let joints = [
            ball(0, 0),
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
                torques: [e(2, 0) - 2.0 * q[1], e(2, 1)],
            },
            ball(1, 3),
            oracle::Joint::Prismatic { axis: axes[2], slide: q[3], rate: v[3], force: e(4, 0) - 40.0 * (q[3] - 0.1) },
            oracle::Joint::Weld { attitude: oracle::Matrix::identity() },
            oracle::Joint::Weld { attitude: oracle::angles(welded) },
            oracle::Joint::Cylindrical {
                axis: axes[3],
                position: [q[4], q[5]],
                rates: [v[4], v[5]],
                efforts: [e(6, 0) - 25.0 * q[4] - v[4], e(6, 1) - 0.1 * v[5]],
            },
            ball(2, 7),
        ];
        let (ground, gravity) = (oracle::Frame::still(), Vector::new(0.3, -9.81, 0.7));
        macro_rules! compare {
            ($tip:expr, $held:expr) => {{
                let system = System::new(Pinned::origin(), chain, $tip)?.with_gravity_vector(gravity);
                let mut motion = system.motion();
                let (root, rest) = motion.position_mut();
                *root = Rotation::from_angles(balls[0]);
                (rest.1.0, rest.1.2.0, rest.1.3) = (q[0], [q[1], q[2]], Rotation::from_angles(balls[1]));
                (rest.2.0, rest.4, rest.6) = (q[3], [q[4], q[5]], Rotation::from_angles(balls[2]));
                let (root, rest) = motion.rate_mut();
                *root = spins[0].into();
                (rest.1.0, rest.1.2.0, rest.1.3) = (v[0], [v[1], v[2]], spins[1].into());
                (rest.2.0, rest.4, rest.6) = (v[3], [v[4], v[5]], spins[2].into());
                let motion = system.with_accelerations(motion, &loads)?;
                let answer = oracle::solve_tree(ground, gravity, &parents, &twins, &joints, (8, $held));
                worst = worst.max(read(&system, &motion, &loads).difference(&answer, &inboard));
            }};
        }
        compare!(Free, oracle::Tip::Free);
        compare!(Pinned::at([0.0, 0.0, 0.0]), oracle::Tip::Pinned(Vector::zeros()));
    }
    conclude(worst);
    Ok(())
}
