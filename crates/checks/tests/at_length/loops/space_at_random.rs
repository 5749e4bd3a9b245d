//! Accelerations, reactions and closure forces of loops in space, of random parameters, against a dense system of Newton-Euler
//! equations with multipliers in which loops are nothing special.

use catena::loading::Unloaded;
use catena::spatial::*;
use catena::system::Element;
use catena::system::Rate;
use catena::{Error, Fault};
use catena_oracle::Noise;
use catena_oracle::space as oracle;
use catena_oracle::space::{Closing, Matrix, Vector};

/// Relative to the largest acceleration or reaction: a hundred times what rounding leaves in the dense system.
const TOLERANCE: f64 = 1e-12;
const SEEDS: u64 = 20;

/// A body in general position, and its twin.
fn body(noise: &mut Noise) -> (RigidBody<f64>, oracle::Body) {
    let mass = noise.between(0.5, 2.0);
    let axes = oracle::angles([noise.next(), noise.next(), noise.next()]);
    // Moments from second moments of mass, so that they are possible.
    let [a, b, c] = [noise.between(0.01, 0.1), noise.between(0.01, 0.1), noise.between(0.01, 0.1)];
    let inertia = axes * Matrix::from_diagonal(&Vector::new(b + c, a + c, a + b)) * axes.transpose();
    let inertia = (inertia + inertia.transpose()) * 0.5;
    let centre = Vector::new(noise.between(0.2, 0.6), noise.between(-0.2, 0.2), noise.between(-0.2, 0.2));
    let outboard = Vector::new(noise.between(0.7, 1.0), noise.between(-0.2, 0.2), noise.between(-0.2, 0.2));
    let o = Vector::zeros();
    let twin = oracle::Body { mass, inertia, centre, outboard, force: o, at: o, torque: o };
    let tensor = core::array::from_fn(|i| core::array::from_fn(|j| inertia[(i, j)]));
    (RigidBody::new(mass, tensor, centre.into(), outboard.into()), twin)
}

fn matrix(attitude: Rotation<f64>) -> Matrix {
    let axes = attitude.matrix();
    Matrix::from_columns(&[axes.x, axes.y, axes.z])
}

/// A joint of the oracle's scene: a ball, or a revolute about this axis.
type Hinge = Option<Vector>;

/// What is told to the oracle of a scene: for each body its parent, and the joint on it with its number.
struct Plan {
    parents: Vec<Option<usize>>,
    hinges: Vec<(Hinge, usize)>,
    /// Main and side body, number of the joint, and how: a ball, a revolute about an axis, or a weld.
    closings: Vec<(usize, usize, usize, Kind)>,
    /// Stations of the bodies' joints and of the closings.
    joints: usize,
}

#[derive(Clone, Copy)]
enum Kind {
    Ball,
    Revolute(Vector),
    Weld,
}

/// Compares a chain of these bodies on a ball; the rates and angles of its revolutes are read by `angles`.
fn compare<C>(
    chain: C,
    twins: &[oracle::Body],
    plan: &Plan,
    noise: &mut Noise,
    angles: impl Fn(&catena::system::MotionOf<Spatial<f64>, Pinned<[f64; 3]>, C, Free>) -> Vec<(f64, f64)>,
) -> Result<Option<f64>, Error>
where
    C: Element<Spatial<f64>>,
    System<f64, Pinned<[f64; 3]>, C, Free>: catena::system::Runs<Unloaded, Spatial<f64>, Pinned<[f64; 3]>, C, Free>
        + catena::system::Runs<Given, Spatial<f64>, Pinned<[f64; 3]>, C, Free>,
{
    let gravity = Vector::new(0.3, -9.81, 0.7);
    let system = System::new(Pinned::origin(), chain, Free)?.with_gravity_vector(gravity);
    let efforts: Vec<_> = (0..plan.joints).map(|_| Effort([noise.next(), noise.next(), noise.next()])).collect();
    let mut wrench = || Wrench {
        force: Vector::new(noise.next(), noise.next(), noise.next()) * 3.0,
        torque: Vector::new(noise.next(), noise.next(), noise.next()),
    };
    let wrenches: Vec<_> = twins.iter().map(|_| wrench()).collect();
    let loads = Loads::none().wrenches(wrenches.clone()).efforts(efforts.clone());

    let mut guess = system.motion();
    let mut turn = guess.rate().clone();
    turn.replace(&mut |_| 0.9 * noise.next());
    catena::system::Position::displace(guess.position_mut(), &turn);
    guess.rate_mut().replace(&mut |_| 2.0 * noise.next());
    let motion = match system.assembled(guess, &Unloaded) {
        Err(Error { fault: Fault::NotClosed { .. }, .. }) => return Ok(None), // it does not reach
        outcome => system.with_accelerations(outcome?, &loads)?,
    };

    let bodies: Vec<_> = system.body_motions(&motion).unwrap().iter().copied().collect();
    let mut turning = angles(&motion).into_iter();
    let joints: Vec<_> = plan
        .hinges
        .iter()
        .zip(&bodies)
        .map(|((hinge, number), body)| match hinge {
            None => oracle::Joint::Ball {
                attitude: matrix(body.attitude()),
                spin: body.rate().into(),
                torque: efforts[*number].0.into(),
            },
            Some(axis) => {
                let (angle, rate) = turning.next().expect("a revolute's coordinates");
                oracle::Joint::Revolute { axis: *axis, angle, rate, torque: efforts[*number].0[0] }
            }
        })
        .collect();
    let mut twins = twins.to_vec();
    for (twin, wrench) in twins.iter_mut().zip(&wrenches) {
        (twin.force, twin.torque) = (wrench.force, wrench.torque);
    }
    let unit = [Vector::x(), Vector::y(), Vector::z()];
    let closing = |&(main, side, joint, kind): &(usize, usize, usize, Kind)| {
        let attitude = matrix(bodies[main].attitude());
        let effort = Vector::from(efforts[joint].0);
        let (about, torque) = match kind {
            Kind::Ball => (vec![], attitude * effort),
            Kind::Weld => (unit.to_vec(), Vector::zeros()),
            Kind::Revolute(axis) => {
                let u = attitude * axis.normalize();
                let e = u.cross(&if u.x.abs() < 0.5 { unit[0] } else { unit[1] }).normalize();
                (vec![e, u.cross(&e)], u * effort.x)
            }
        };
        Closing { main, side, along: unit.to_vec(), about, torque }
    };
    let closings: Vec<_> = plan.closings.iter().map(closing).collect();
    let free = (twins.len() - 1, oracle::Tip::Free);
    let answer = oracle::solve_closed(oracle::Frame::still(), gravity, &plan.parents, &twins, &joints, free, &closings);
    assert!(answer.residual < 1e-13, "loops miss by {:.1e}", answer.residual);

    let size = [&answer.linear, &answer.angular, &answer.forces, &answer.torques];
    let size = size.into_iter().flatten().fold(1.0_f64, |size, v| size.max(v.amax()));
    let stations = system.stations(&motion, &loads).unwrap();
    // The root's joint is number 0 and stands before all stations.
    let at = |number: usize| stations.iter().nth(number).copied().expect("a station");
    let mut worst = 0.0_f64;
    let mut numbers = Numbers::of(plan);
    for (k, body) in bodies.iter().enumerate() {
        worst = worst.max((body.centre().acceleration.linear - answer.linear[k]).amax());
        worst = worst.max((body.inboard.acceleration.angular - answer.angular[k]).amax());
        let force = numbers.of_body(k).map_or_else(|| stations.root().internal, |number| at(number).internal);
        worst = worst.max((force.force - answer.forces[k]).amax());
        worst = worst.max((-force.torque - answer.torques[k]).amax());
    }
    for (k, [force, torque]) in answer.closings.iter().enumerate() {
        let internal = at(numbers.of_closing(k)).internal;
        worst = worst.max((internal.force - force).amax());
        worst = worst.max((-internal.torque - torque).amax());
    }
    Ok(Some(worst / size))
}

/// Forces and torques on bodies, and efforts in joints.
type Given = Loads<Values<Vec<Wrench<f64>>>, Values<Vec<Effort<f64>>>>;

/// Stations of joints: bodies and joints are numbered together, the root's joint is not.
struct Numbers {
    bodies: Vec<Option<usize>>,
    closings: Vec<usize>,
}

impl Numbers {
    fn of(plan: &Plan) -> Self {
        // Joint j stands after all joints before it and after all bodies whose joints come before.
        let before = |joint: usize| plan.hinges.iter().filter(|(_, number)| *number < joint).count();
        let station = |joint: usize| (joint + before(joint)).checked_sub(1);
        Self {
            bodies: plan.hinges.iter().map(|(_, joint)| station(*joint)).collect(),
            closings: plan.closings.iter().map(|(_, _, joint, _)| station(*joint).unwrap_or(0)).collect(),
        }
    }
    fn of_body(&mut self, k: usize) -> Option<usize> {
        self.bodies[k]
    }
    fn of_closing(&mut self, k: usize) -> usize {
        self.closings[k]
    }
}

/// Runs a scene with many seeds; enough of the guesses must close.
fn many(name: &str, one: impl Fn(&mut Noise) -> Result<Option<f64>, Error>) -> Result<(), Error> {
    let (mut worst, mut closed) = (0.0_f64, 0);
    for seed in 0..SEEDS {
        if let Some(difference) = one(&mut Noise::new(seed))? {
            worst = worst.max(difference);
            closed += 1;
        }
    }
    println!("{name}: {closed} scenes, differences to {worst:.1e}");
    assert!(closed > SEEDS / 2 && worst < TOLERANCE, "{name}: {closed} scenes, {worst:.1e}");
    Ok(())
}

/// A loop of five bodies on the first, with a revolute, from whose end the chain goes on, and a branch in its main arm.
macro_rules! a_loop {
    ($name:ident, $closing:expr, $kind:expr) => {
        #[test]
        fn $name() -> Result<(), Error> {
            many(stringify!($name), |noise| {
                let pairs: [_; 8] = core::array::from_fn(|_| body(noise));
                let (b, twins) = (pairs.map(|pair| pair.0), pairs.map(|pair| pair.1));
                let axis = Vector::new(0.4, 1.0, noise.next());
                let main = (Ball, b[1], Branch((Ball, b[2])), Revolute::about(axis.into()), b[3], Ball, b[4]);
                let net = Network::new(main, (Ball, b[5], Ball, b[6]), $closing);
                let ball = |k| (None, k);
                let plan = Plan {
                    parents: vec![None, Some(0), Some(1), Some(1), Some(3), Some(0), Some(5), Some(4)],
                    hinges: vec![ball(0), ball(1), ball(2), (Some(axis), 3), ball(4), ball(5), ball(6), ball(8)],
                    closings: vec![(4, 6, 7, $kind)],
                    joints: 9,
                };
                compare((b[0], net, Ball, b[7]), &twins, &plan, noise, |motion| {
                    let (angle, rate) = (&motion.position().1.1.arms.0, &motion.rate().1.1.arms.0);
                    vec![(angle.3, rate.3)]
                })
            })
        }
    };
}
const CLOSING_AXIS: [f64; 3] = [0.2, -0.3, 1.0];
a_loop!(closed_by_a_ball, Ball, Kind::Ball);
a_loop!(closed_by_a_weld, Weld::at(Rotation::identity()), Kind::Weld);
a_loop!(closed_by_a_revolute, Revolute::about(CLOSING_AXIS), Kind::Revolute(CLOSING_AXIS.into()));

/// Three arms in parallel, of which one carries a loop of its own in a branch.
#[test]
fn three_arms_and_a_loop_in_a_branch() -> Result<(), Error> {
    many("three arms", |noise| {
        let pairs: [_; 10] = core::array::from_fn(|_| body(noise));
        let (b, twins) = (pairs.map(|pair| pair.0), pairs.map(|pair| pair.1));
        let swing = Branch(Network::new((Ball, b[2], Ball, b[3]), (Ball, b[4]), Ball));
        let inner = Network::new((Ball, b[1], swing, Ball, b[5]), (Ball, b[6], Ball, b[7]), Ball);
        let net = Network::new(inner, (Ball, b[8], Ball, b[9]), Revolute::about(CLOSING_AXIS));
        let ball = |k| (None, k);
        let parents = [None, Some(0), Some(1), Some(2), Some(1), Some(1), Some(0), Some(6), Some(0), Some(8)];
        let plan = Plan {
            parents: parents.to_vec(),
            // Joint 5 closes the swing, 9 the inner network, 12 the outer one.
            hinges: [0, 1, 2, 3, 4, 6, 7, 8, 10, 11].map(ball).to_vec(),
            closings: vec![
                (3, 4, 5, Kind::Ball),
                (5, 7, 9, Kind::Ball),
                (5, 9, 12, Kind::Revolute(CLOSING_AXIS.into())),
            ],
            joints: 13,
        };
        compare((b[0], net), &twins, &plan, noise, |_| vec![])
    })
}
