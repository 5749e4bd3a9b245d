//! Trees in the plane.

use super::*;
use catena::Error;
use catena::loading::Loading;
use catena::planar::{self, *};
use catena::system::MotionOf;
use catena::system::{Root, Tip};

/// A body in general position, and its twin: in the plane nothing depends on its other moments of inertia.
fn body(noise: &mut Noise) -> (RigidBody<f64>, oracle::Body) {
    let (mass, about_centre) = (noise.between(0.5, 2.0), noise.between(0.02, 0.2));
    let centre = [noise.between(0.2, 0.6), noise.between(-0.2, 0.2)];
    let outboard = [noise.between(0.5, 1.0), noise.between(-0.3, 0.3)];
    (RigidBody::new(mass, about_centre, centre, outboard), twin(mass, about_centre, centre, outboard))
}

fn twin(mass: f64, about_centre: f64, centre: [f64; 2], outboard: [f64; 2]) -> oracle::Body {
    let inertia = oracle::Matrix::from_diagonal(&Vector::new(0.7, 0.8, 1.0)) * about_centre;
    let o = Vector::zeros();
    oracle::Body { mass, inertia, centre: flat(centre), outboard: flat(outboard), force: o, at: o, torque: o }
}

fn flat([x, y]: [f64; 2]) -> Vector {
    Vector::new(x, y, 0.0)
}

fn axial(z: f64) -> Vector {
    Vector::new(0.0, 0.0, z)
}

/// A pin holds no more than a ball, and a ball in the plane turns about z alone.
fn pin(angle: f64, rate: f64, torque: f64) -> oracle::Joint {
    oracle::Joint::Ball { attitude: oracle::about(Vector::z(), angle), spin: axial(rate), torque: axial(torque) }
}

fn read<R, C, P, L>(system: &planar::System<f64, R, C, P>, motion: &MotionOf<Planar<f64>, R, C, P>, loads: &L) -> Found
where
    R: Root<Planar<f64>>,
    C: catena::system::Element<Planar<f64>>,
    P: Tip<Planar<f64>>,
    L: Loading<Planar<f64>>,
{
    let bodies = system.body_motions(motion).unwrap();
    let stations = system.stations(motion, loads).unwrap();
    let of = |station: &Station<f64>| {
        let force = flat(station.internal.force.into());
        [force, axial(station.torque_outboard()), flat(station.frame.place.into())]
    };
    let ([force, torque, _], tip) = (of(stations.root()), of(stations.tip()));
    Found {
        linear: bodies.iter().map(|body| flat(body.centre().acceleration.linear.into())).collect(),
        angular: bodies.iter().map(|body| axial(body.inboard.acceleration.angular)).collect(),
        stations: stations.iter().map(of).collect(),
        root: [force, torque],
        tip: [-tip[0], -tip[1]],
    }
}

/// Trees of random shape under gravity, loads on all bodies and torques in all pins, with a free tip or one that moves as it must.
#[test]
fn of_random_shape() -> Result<(), Error> {
    let (mut worst, mut most) = (0.0_f64, 0);
    for seed in 0..40 {
        let mut grower = Grower::new(seed, Pin, body);
        let (first, trunk, last) = grower.tree();
        let Grower { mut noise, parents, mut twins, .. } = grower;
        let n = twins.len();
        most = most.max(n);
        let mut numbers = |size: f64| (0..n).map(|_| size * noise.next()).collect::<Vec<f64>>();
        let (angles, rates, torques) = (numbers(3.0), numbers(2.0), numbers(1.0));
        let forces: Vec<[f64; 2]> = numbers(3.0).into_iter().zip(numbers(3.0)).map(Into::into).collect();
        let at = [0.4, -0.1];
        let joints: Vec<_> = (0..n).map(|k| pin(angles[k], rates[k], torques[k])).collect();
        for (twin, force) in twins.iter_mut().zip(&forces) {
            (twin.at, twin.force, twin.torque) = (flat(at), flat(*force), axial(0.5));
        }
        let loads = Loads::none()
            .on_bodies(|_, k: usize, body: &BodyMotion<f64>| body.force_at(at, forces[k]) + Wrench::torque(0.5))
            .torques(&torques);
        let (ground, gravity) = (oracle::Frame::still(), Vector::new(0.3, -9.81, 0.0));
        macro_rules! compare {
            ($tip:expr, $held:expr) => {{
                let system = System::new(Pinned::origin(), (first, trunk.clone()), $tip)?;
                let system = system.with_gravity_vector(gravity.xy());
                let motion = system.with_rates(system.at_rest(&angles)?, &rates)?;
                let motion = system.with_accelerations(motion, &loads)?;
                let answer = oracle::solve_tree(ground, gravity, &parents, &twins, &joints, (last, $held));
                worst = worst.max(read(&system, &motion, &loads).difference(&answer, &alternating(n)));
            }};
        }
        compare!(Free, oracle::Tip::Free);
        let acceleration = [noise.next(), noise.next()];
        let moving = Moving(move |_: f64| GroundMotion { place: [0.0; 2], velocity: [0.0; 2], acceleration });
        compare!(Pinned::on(moving), oracle::Tip::Pinned(flat(acceleration)));
    }
    assert!(most > 30, "at most {most} bodies");
    conclude(worst);
    Ok(())
}

/// Every joint at the foot of an arm, arms within arms, an arm fixed to its body, an array of arms: positions and rates from those of
/// the joints, which must set out from the same body for every arm.
#[test]
fn with_every_joint() -> Result<(), Error> {
    let mut worst = 0.0_f64;
    for seed in 0..20 {
        let mut noise = Noise::new(seed);
        let pairs: [_; 6] = core::array::from_fn(|_| body(&mut noise));
        let plates = pairs.map(|pair| pair.0);
        let (length, mass) = (noise.between(0.5, 1.0), noise.between(0.5, 2.0));
        let rod = Rod::uniform(length, mass);
        let rod_twin = twin(mass, mass * length * length / 12.0, [0.5 * length, 0.0], [length, 0.0]);
        let bob = PointMass::new(0.3, 0.4);
        let bob_twin = twin(0.4, 0.0, [0.3, 0.0], [0.3, 0.0]);
        let hinge = ElasticHinge::rotary(7.0).damped(0.3).resting_at(0.2);
        let slider = Slider::along(0.6).with(Spring::new(40.0).damped(2.0).resting_at(0.1));
        let chain = (
            rod,
            Branch((hinge, rod, Branch((Pin, bob)), slider, plates[0])),
            Branch((Weld::at(-0.7), plates[1], Branch(rod))),
            Pin,
            plates[2],
            [Branch((Pin, rod)); 2],
            (Branch((slider, plates[3], hinge, plates[4])), hinge, plates[5]),
        );
        let rod = |parent| (parent, rod_twin);
        let plate = |parent, k: usize| (parent, pairs[k].1);
        let twins = [
            rod(None),
            rod(Some(0)),
            (Some(1), bob_twin),
            plate(Some(1), 0),
            plate(Some(0), 1),
            rod(Some(4)),
            plate(Some(0), 2),
            rod(Some(6)),
            rod(Some(6)),
            plate(Some(6), 3),
            plate(Some(9), 4),
            plate(Some(6), 5),
        ];
        let parents = twins.map(|twin| twin.0);
        let twins = twins.map(|twin| twin.1);
        // A body without a joint of its own follows its parent's station at once.
        let inboard = [0, 2, 4, 6, 8, 9, 11, 13, 15, 17, 19, 21];

        // Numbers of joints: of bodies but the one without.
        let n = twins.len();
        let turn: [f64; 12] = core::array::from_fn(|_| noise.next());
        let rate: [f64; 12] = core::array::from_fn(|_| 2.0 * noise.next());
        let turning = [0, 1, 2, 6, 7, 8, 10, 11];
        let sliding = [3, 9];
        let mut torques = vec![0.0; n - 1];
        for k in turning {
            torques[if k > 5 { k - 1 } else { k }] = noise.next();
        }
        let torque = |k: usize| torques[if k > 5 { k - 1 } else { k }];

        let mut angles = [0.0; 12];
        let mut rates = [0.0; 12];
        let joints: [oracle::Joint; 12] = core::array::from_fn(|k| {
            let (angle, spin) = parents[k].map_or((0.0, 0.0), |j| (angles[j], rates[j]));
            (angles[k], rates[k]) = (angle, spin);
            match k {
                4 => angles[k] -= 0.7,
                3 | 5 | 9 => (),
                _ => (angles[k], rates[k]) = (angle + turn[k], spin + rate[k]),
            }
            let axis = Vector::new(0.6_f64.cos(), 0.6_f64.sin(), 0.0);
            match k {
                0 | 6 | 7 | 8 => pin(angles[k], rates[k], torque(k)),
                // A bob on a ball could spin as it likes.
                2 => oracle::Joint::Revolute { axis: Vector::z(), angle: turn[k], rate: rate[k], torque: torque(k) },
                4 => oracle::Joint::Weld { attitude: oracle::about(Vector::z(), -0.7) },
                5 => oracle::Joint::Weld { attitude: oracle::Matrix::identity() },
                3 | 9 => {
                    let force = -40.0 * (turn[k] - 0.1) - 2.0 * rate[k];
                    oracle::Joint::Prismatic { axis, slide: turn[k], rate: rate[k], force }
                }
                _ => {
                    let torque = torque(k) - 7.0 * (turn[k] - 0.2) - 0.3 * rate[k];
                    oracle::Joint::Revolute { axis: Vector::z(), angle: turn[k], rate: rate[k], torque }
                }
            }
        });

        let loads = Loads::none().torques(&torques);
        let (ground, gravity) = (oracle::Frame::still(), Vector::new(0.3, -9.81, 0.0));
        macro_rules! compare {
            ($tip:expr, $held:expr) => {{
                let system = System::new(Pinned::origin(), chain, $tip)?.with_gravity_vector(gravity.xy());
                let mut motion = system.at_joint_angles(&turning.map(|k| turn[k]))?;
                motion = system.with_joint_rates(motion, &turning.map(|k| rate[k]))?;
                let [arm, other] = sliding.map(|k| [turn[k], rate[k]]);
                (motion.position_mut().1.1.3, motion.position_mut().1.6.0.0) = (arm[0], other[0]);
                (motion.rate_mut().1.1.3, motion.rate_mut().1.6.0.0) = (arm[1], other[1]);
                let motion = system.with_accelerations(motion, &loads)?;
                let answer = oracle::solve_tree(ground, gravity, &parents, &twins, &joints, (n - 1, $held));
                worst = worst.max(read(&system, &motion, &loads).difference(&answer, &inboard));
            }};
        }
        compare!(Free, oracle::Tip::Free);
        compare!(Pinned::at(0.0, 0.0), oracle::Tip::Pinned(Vector::zeros()));
    }
    conclude(worst);
    Ok(())
}
