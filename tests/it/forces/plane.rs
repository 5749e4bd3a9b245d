//! Accelerations and internal forces of random chains against a dense solution of all equations at once.
//!
//! Both come from sines, matrices and divisions that are rounded, and what rounding does to them is multiplied by the
//! condition of the chain's mass matrix: some ten to a thousand for these chains. Differences are relative to the
//! largest quantity of their kind in the chain, because a balance of large forces cannot give a small one to more
//! digits.

use catena::Error;
use catena::loading::{Loading, Unloaded};
use catena::planar::*;
use catena::system::Element;
use catena::system::Rate;
use catena::system::Root;
use catena::system::{MotionOf, Runs};
use catena_oracle::plane::{self as oracle, Answer, Load, Scene, State, Tip, add, cross, perp, rotate, scale, sub};
use catena_oracle::{Noise, near};
use nalgebra::Vector2;

/// Relative differences: see above.
const ROUNDING: f64 = 1e-12;

type Plane = Planar<f64>;

/// A body of the crate, and the same one for the oracle.
type Twin<B> = (B, oracle::Body);

fn rigid(noise: &mut Noise) -> Twin<RigidBody<f64>> {
    let mass = noise.between(0.3, 3.0);
    let inertia_c = noise.between(0.05, 0.6);
    let centre = scale(0.6, noise.pair());
    let outboard = add([0.8, 0.0], scale(0.6, noise.pair()));
    (RigidBody::new(mass, inertia_c, centre, outboard), oracle::Body { mass, inertia_c, centre, outboard })
}

fn rod(noise: &mut Noise) -> Twin<Rod<f64>> {
    let (length, mass) = (noise.between(0.4, 1.6), noise.between(0.3, 3.0));
    let (share, inertia_c) = (noise.between(-0.2, 1.2), noise.between(0.02, 0.6));
    let centre = share * length;
    let body = oracle::Body { mass, inertia_c, centre: [centre, 0.0], outboard: [length, 0.0] };
    (Rod::new(length, mass, centre, inertia_c), body)
}

fn point(noise: &mut Noise) -> Twin<PointMass<f64>> {
    let (length, mass) = (noise.between(0.4, 1.6), noise.between(0.3, 3.0));
    (
        PointMass::new(length, mass),
        oracle::Body { mass, inertia_c: 0.0, centre: [length, 0.0], outboard: [length, 0.0] },
    )
}

/// A chain of one kind of body, with pins between them.
fn alike<B>(n: usize, noise: &mut Noise, make: impl Fn(&mut Noise) -> Twin<B>) -> (Links<B>, Vec<oracle::Body>) {
    let (first, body) = make(noise);
    let mut bodies = vec![body];
    let mut links = vec![];
    for _ in 1..n {
        let (link, body) = make(noise);
        links.push((Pin, link));
        bodies.push(body);
    }
    ((first, links), bodies)
}

type Links<B> = (B, Vec<(Pin, B)>);
type Mixed = (RigidBody<f64>, Vec<(Pin, Rod<f64>, Pin, PointMass<f64>, Pin, RigidBody<f64>)>);

/// A chain of 3 `groups` + 1 bodies of all kinds.
fn mixed(groups: usize, noise: &mut Noise) -> (Mixed, Vec<oracle::Body>) {
    let (first, body) = rigid(noise);
    let mut bodies = vec![body];
    let mut links = vec![];
    for _ in 0..groups {
        let (a, b, c) = (rod(noise), point(noise), rigid(noise));
        links.push((Pin, a.0, Pin, b.0, Pin, c.0));
        bodies.extend([a.1, b.1, c.1]);
    }
    ((first, links), bodies)
}

/// A ground point that moves in every way; not at rest at any time.
fn shaken(t: f64) -> GroundMotion<f64> {
    let (s, c) = (1.3 * t + 0.4).sin_cos();
    GroundMotion {
        place: [0.3 + c, s - 0.5 * t],
        velocity: [-1.3 * s, 1.3 * c - 0.5],
        acceleration: [-1.69 * c, -1.69 * s],
    }
}

type Shaken = Pinned<Moving<fn(f64) -> GroundMotion<f64>>>;

fn oracle_ground(motion: GroundMotion<f64>) -> oracle::Ground {
    let GroundMotion { place, velocity, acceleration } = motion;
    oracle::Ground { position: place, velocity, acceleration, ..oracle::Ground::default() }
}

/// What acts on a body: a force at a point and a torque, both growing with time, and a drag on the point.
#[derive(Clone, Copy)]
struct Push {
    point: [f64; 2],
    force: [f64; 2],
    torque: f64,
    drag: f64,
}

/// What acts in a joint: a torque, and a damper and spring between the bodies.
#[derive(Clone, Copy)]
struct Drive {
    torque: f64,
    damping: f64,
    stiffness: f64,
}

/// Inputs of a scene.
struct Inputs {
    time: f64,
    angles: Vec<f64>,
    rates: Vec<f64>,
    gravity: [f64; 2],
    pushes: Vec<Push>,
    drives: Vec<Drive>,
}

impl Inputs {
    fn random(bodies: usize, noise: &mut Noise) -> Self {
        let list = |make: &mut dyn FnMut() -> f64| (0..bodies).map(|_| make()).collect();
        Self {
            time: noise.between(0.5, 2.0),
            angles: list(&mut || noise.between(-3.0, 3.0)),
            rates: list(&mut || noise.between(-2.0, 2.0)),
            gravity: scale(9.81, rotate(noise.between(-3.0, 3.0), [1.0, 0.0])),
            pushes: (0..bodies)
                .map(|_| Push {
                    point: noise.pair(),
                    force: scale(5.0, noise.pair()),
                    torque: 3.0 * noise.next(),
                    drag: 1.0 + noise.next(),
                })
                .collect(),
            drives: (0..bodies)
                .map(|_| Drive {
                    torque: 3.0 * noise.next(),
                    damping: 1.0 + noise.next(),
                    stiffness: 2.0 * noise.next(),
                })
                .collect(),
        }
    }

    fn loads(&self) -> impl Loading<Plane, OnBody = Wrench<f64>, InJoint = f64> {
        Loads::none()
            .on_bodies(|time, body, motion: &BodyMotion<f64>| {
                let Push { point, force, torque, drag } = self.pushes[body];
                let velocity = motion.point(point).velocity;
                let force = [time * force[0] - drag * velocity.x, time * force[1] - drag * velocity.y];
                motion.force_at(point, force) + Wrench::torque(time * torque)
            })
            .in_joints(|time, joint, motion: &JointMotion<f64>| {
                let Drive { torque, damping, stiffness } = self.drives[joint];
                time * torque - damping * motion.rate() - stiffness * motion.angle()
            })
    }

    /// The same for the oracle, which has no notion of loads that depend on the motion.
    fn oracle_loads(&self, state: &State) -> (Vec<f64>, Vec<Load>) {
        let load = |(body, push): (usize, &Push)| {
            let arm = rotate(state.angle[body], push.point);
            let velocity = add(state.velocity[body], scale(state.rate[body], perp(arm)));
            let force = sub(scale(self.time, push.force), scale(push.drag, velocity));
            Load { body, point: push.point, force, torque: self.time * push.torque }
        };
        let torque = |(joint, drive): (usize, &Drive)| {
            let inner = |list: &[f64]| if joint == 0 { 0.0 } else { list[joint - 1] };
            let angle = state.angle[joint] - inner(&state.angle);
            let rate = state.rate[joint] - inner(&state.rate);
            self.time * drive.torque - drive.damping * rate - drive.stiffness * angle
        };
        (self.drives.iter().enumerate().map(torque).collect(), self.pushes.iter().enumerate().map(load).collect())
    }
}

/// Motion, force and torque at a station as the oracle has them: x, y, θ and their accelerations, m, q.
struct Expected {
    position: [f64; 3],
    velocity: [f64; 2],
    acceleration: [f64; 3],
    torque: f64,
    force: [f64; 2],
}

/// The stations of a chain: inboard end of every body, outboard end of those that a joint follows, tip.
fn expected(scene: &Scene, state: &State, answer: &Answer) -> Vec<Expected> {
    let mut stations = vec![];
    for (k, body) in scene.bodies.iter().enumerate() {
        let (place, velocity) = (state.position[k], state.velocity[k]);
        let (angle, rate, alpha) = (state.angle[k], state.rate[k], answer.angular_acceleration[k]);
        let [x, y] = answer.acceleration[k];
        stations.push(Expected {
            position: [place[0], place[1], angle],
            velocity,
            acceleration: [x, y, alpha],
            torque: answer.m_inboard[k],
            force: answer.q_inboard[k],
        });
        let joined = scene.joints.get(k + 1).is_none_or(|joint| matches!(joint, oracle::Joint::Pin));
        if joined {
            let arm = rotate(angle, body.outboard);
            let place = add(place, arm);
            let turning = sub(scale(alpha, perp(arm)), scale(rate * rate, arm));
            stations.push(Expected {
                position: [place[0], place[1], angle],
                velocity: add(velocity, scale(rate, perp(arm))),
                acceleration: [x + turning[0], y + turning[1], alpha],
                torque: answer.m_outboard[k],
                force: answer.q_outboard[k],
            });
        }
    }
    stations
}

/// The largest magnitude, at least one: that of the masses, lengths and rates of all chains here.
fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(1.0, |largest, value| largest.max(value.abs()))
}

/// Every station of a scene agrees with the oracle; the largest relative difference of accelerations, forces and
/// torques.
fn agrees<R, C, L>(
    system: &System<f64, R, C, Free>,
    motion: MotionOf<Plane, R, C, Free>,
    loads: &L,
    scene: &Scene,
    state: &State,
    answer: &Answer,
) -> Result<f64, Error>
where
    R: Root<Plane>,
    C: Element<Plane>,
    L: Loading<Plane>,
    System<f64, R, C, Free>: Runs<L, Plane, R, C, Free>,
{
    let motion = system.with_accelerations(motion, loads)?;
    let stations = system.stations(&motion, loads).unwrap();
    let expected = expected(scene, state, answer);
    assert_eq!(stations.iter().count(), expected.len());
    assert_eq!(stations.elements(), expected.len() - 1);

    let linear = largest(expected.iter().flat_map(|s| [s.acceleration[0], s.acceleration[1]]));
    let angular = largest(expected.iter().map(|s| s.acceleration[2]));
    let force = largest(expected.iter().flat_map(|s| s.force));
    let torque = force.max(largest(expected.iter().map(|s| s.torque))); // arms are about a metre long
    let length = largest(expected.iter().flat_map(|s| [s.position[0], s.position[1]]));
    let velocity = largest(expected.iter().flat_map(|s| s.velocity));

    let mut worst = 0.0_f64;
    let mut note = |what: &str, k: usize, found: f64, expected: f64, scale: f64| {
        let difference = (found - expected).abs() / scale;
        assert!(difference <= ROUNDING, "{what} at station {k}: {found:e} instead of {expected:e} ({difference:.1e})");
        worst = worst.max(difference);
    };
    for (k, (station, expected)) in stations.iter().zip(&expected).enumerate() {
        let [x, y, angle] = expected.position;
        let [ax, ay, alpha] = expected.acceleration;
        let (m, [qx, qy]) = (expected.torque, expected.force);
        let forces = [(m, torque), (qx, force), (qy, force)];
        let position = [(x, length), (y, length), (angle, 1.0)].into_iter().chain(forces);
        let acceleration = [(ax, linear), (ay, linear), (alpha, angular)].into_iter().chain(forces);
        for (i, (expected, scale)) in position.enumerate() {
            note("state", k, station.state()[i], expected, scale);
        }
        for (i, (expected, scale)) in acceleration.enumerate() {
            note("acceleration state", k, station.acceleration_state()[i], expected, scale);
        }
        for i in 0..2 {
            note("velocity", k, station.frame.velocity[i], expected.velocity[i], velocity);
        }
        assert_eq!([station.state()[index::ONE], station.acceleration_state()[index::ONE]], [1.0; 2]);
    }
    // The ground's side of the root.
    let root = stations.root();
    for i in 0..2 {
        note("root force", 0, root.internal.force[i], answer.q_ground[i], force);
    }
    note("root torque", 0, root.internal.torque, answer.m_ground, torque);
    let rates: Vec<f64> =
        system.body_motions(&motion).unwrap().iter().map(|body| body.inboard.acceleration.angular).collect();
    for (k, (found, expected)) in rates.iter().zip(&answer.angular_acceleration).enumerate() {
        note("angular acceleration of body", k, *found, *expected, angular);
    }
    Ok(worst)
}

/// A chain under everything at once.
fn check<C: Element<Plane>, L: Loading<Plane>>(
    chain: C,
    bodies: Vec<oracle::Body>,
    inputs: &Inputs,
    loads: &L,
) -> Result<f64, Error>
where
    System<f64, Shaken, C, Free>: Runs<L, Plane, Shaken, C, Free> + Runs<Unloaded, Plane, Shaken, C, Free>,
{
    let root: Shaken = Pinned::on(Moving(shaken));
    let system = System::new(root, chain, Free)?.with_gravity_vector(Vector2::from(inputs.gravity));
    assert_eq!((system.bodies(), system.joints()), (bodies.len(), bodies.len()));
    let mut scene = Scene::pinned(bodies);
    scene.ground = oracle_ground(shaken(inputs.time));
    scene.gravity = inputs.gravity;
    let state = scene.assemble(&inputs.angles, &inputs.rates);
    let (torques, wrenches) = inputs.oracle_loads(&state);

    let motion = system.with_rates(system.at_rest(&inputs.angles)?, &inputs.rates)?.at_time(inputs.time);
    let free = agrees(&system, motion.clone(), &Unloaded, &scene, &state, &scene.solve(&state, &[], &[]))?;
    let loaded = agrees(&system, motion, loads, &scene, &state, &scene.solve(&state, &torques, &wrenches))?;
    Ok(free.max(loaded))
}

#[test]
fn random_chains_of_every_kind_agree_with_the_oracle_at_every_station() -> Result<(), Error> {
    let mut worst = 0.0_f64;
    for seed in 0..4 {
        for n in 1..=8 {
            let noise = &mut Noise::new(1000 * seed + n as u64);
            let inputs = Inputs::random(n, noise);
            let loads = inputs.loads();
            let (chain, bodies) = alike(n, noise, rigid);
            worst = worst.max(check(chain, bodies, &inputs, &loads)?);
            let (chain, bodies) = alike(n, noise, rod);
            worst = worst.max(check(chain, bodies, &inputs, &loads)?);
            let (chain, bodies) = alike(n, noise, point);
            worst = worst.max(check(chain, bodies, &inputs, &loads)?);
        }
        for groups in 0..=2 {
            let noise = &mut Noise::new(7777 * seed + groups as u64);
            let inputs = Inputs::random(3 * groups + 1, noise);
            let (chain, bodies) = mixed(groups, noise);
            worst = worst.max(check(chain, bodies, &inputs, &inputs.loads())?);
        }
    }
    println!("largest relative difference {worst:.1e}");
    Ok(())
}

#[test]
fn chains_of_thirty_bodies_agree_with_the_oracle_at_every_station() -> Result<(), Error> {
    let noise = &mut Noise::new(30);
    let inputs = Inputs::random(30, noise);
    let (chain, bodies) = alike(30, noise, rigid);
    let of_one_kind = check(chain, bodies, &inputs, &inputs.loads())?;
    let inputs = Inputs::random(31, noise);
    let (chain, bodies) = mixed(10, noise);
    let of_all = check(chain, bodies, &inputs, &inputs.loads())?;
    println!("largest relative difference {of_one_kind:.1e} (rigid bodies), {of_all:.1e} (all kinds)");
    Ok(())
}

/// Bodies 0 and 1 and bodies 2, 3 and 4 are one rigid piece each.
#[test]
fn adjacent_bodies_without_a_joint_are_welded() -> Result<(), Error> {
    let mut worst = 0.0_f64;
    for seed in 0..4 {
        let noise = &mut Noise::new(50 + seed);
        let [a, d] = core::array::from_fn(|_| rod(noise));
        let [b, c] = core::array::from_fn(|_| rigid(noise));
        let e = point(noise);
        let root: Shaken = Pinned::on(Moving(shaken));
        let inputs = Inputs::random(5, noise);
        let gravity = Vector2::from(inputs.gravity);
        let system = System::new(root, ((a.0, b.0), Pin, c.0, (d.0, e.0)), Free)?.with_gravity_vector(gravity);
        assert_eq!((system.bodies(), system.joints()), (5, 2));

        let (angles, rates) = (&inputs.angles[..2], &inputs.rates[..2]);
        let motion = system.with_rates(system.at_rest(angles)?, rates)?.at_time(inputs.time);
        let per_body = |list: &[f64]| [list[0], list[0], list[1], list[1], list[1]];
        let mut scene = Scene::pinned(vec![a.1, b.1, c.1, d.1, e.1]);
        for welded in [1, 3, 4] {
            scene.joints[welded] = oracle::Joint::Weld;
        }
        scene.ground = oracle_ground(shaken(inputs.time));
        scene.gravity = inputs.gravity;
        let state = scene.assemble(&per_body(angles), &per_body(rates));
        let (_, wrenches) = inputs.oracle_loads(&state);
        // The crate's joint 1 is the oracle's joint 2.
        let torques = [1.7, 0.0, -2.3, 0.0, 0.0];
        let pushes = &inputs.pushes;
        let loads = Loads::none()
            .on_bodies(|time, body, motion: &BodyMotion<f64>| {
                let Push { point, force, torque, drag } = pushes[body];
                let velocity = motion.point(point).velocity;
                let force = Vector2::from(force) * time - velocity * drag;
                motion.force_at(point, force.into()) + Wrench::torque(time * torque)
            })
            .in_joints(|_, joint, _: &JointMotion<f64>| [torques[0], torques[2]][joint]);
        let answer = scene.solve(&state, &torques, &wrenches);
        worst = worst.max(agrees(&system, motion, &loads, &scene, &state, &answer)?);
    }
    println!("largest relative difference {worst:.1e}");
    Ok(())
}

#[test]
fn floating_chains_agree_with_the_oracle_at_every_station() -> Result<(), Error> {
    let mut worst = 0.0_f64;
    for seed in 0..4 {
        for n in 1..=6 {
            let noise = &mut Noise::new(900 * seed + n as u64);
            let mut inputs = Inputs::random(n, noise);
            inputs.drives[0] = Drive { torque: 0.0, damping: 0.0, stiffness: 0.0 }; // there is no joint at the root
            let (chain, bodies) = alike(n, noise, rigid);
            let system = System::new(Free, chain, Free)?.with_gravity_vector(Vector2::from(inputs.gravity));
            let (place, velocity) = (noise.pair(), noise.pair());
            let mut motion = system.at_rest(&inputs.angles)?;
            (motion.position_mut().0.0, motion.position_mut().0.1) = (place[0], place[1]);
            let rates = [&velocity[..], &inputs.rates].concat();
            let motion = system.with_rates(motion, &rates)?.at_time(inputs.time);

            let mut scene = Scene::pinned(bodies);
            scene.joints[0] = oracle::Joint::Free;
            scene.tip = Tip::Free;
            scene.gravity = inputs.gravity;
            scene.ground.position = place; // only to assemble the state from
            scene.ground.velocity = velocity;
            let state = scene.assemble(&inputs.angles, &inputs.rates);
            let (torques, wrenches) = inputs.oracle_loads(&state);
            let answer = scene.solve(&state, &torques, &wrenches);
            worst = worst.max(agrees(&system, motion, &inputs.loads(), &scene, &state, &answer)?);
        }
    }
    println!("largest relative difference {worst:.1e}");
    Ok(())
}

#[test]
fn torques_found_by_inverse_dynamics_cause_the_accelerations_that_were_asked_for() -> Result<(), Error> {
    for (seed, n) in [(1, 1), (2, 2), (3, 5), (4, 8)] {
        let noise = &mut Noise::new(seed);
        let inputs = Inputs::random(n, noise);
        let (chain, bodies) = alike(n, noise, rigid);
        let root: Shaken = Pinned::on(Moving(shaken));
        let system = System::new(root, chain, Free)?.with_gravity_vector(Vector2::from(inputs.gravity));
        let mut motion = system.with_rates(system.at_rest(&inputs.angles)?, &inputs.rates)?.at_time(inputs.time);
        let wanted: Vec<f64> = (0..n).map(|_| 20.0 * noise.next()).collect();
        let mut next = wanted.iter();
        motion.acceleration_mut().replace(&mut |_| *next.next().unwrap());

        let pushes = &inputs.pushes;
        let push = |_: f64, body: usize, motion: &BodyMotion<f64>| {
            motion.force_at(pushes[body].point, pushes[body].force) + Wrench::torque(pushes[body].torque)
        };
        let stations = system.stations(&motion, &Loads::none().on_bodies(push))?;
        // Pins are the elements of odd number; the root's is the ground's side of the chain.
        let pins = core::iter::once(Some(stations.root())).chain((0..n - 1).map(|k| stations.get(2 * k + 1)));
        let torques: Vec<f64> = pins.map(|pin| -pin.unwrap().internal.torque).collect();

        let loads = Loads::none().on_bodies(push).in_joints(|_, joint, _: &JointMotion<f64>| torques[joint]);
        let found = system.with_accelerations(motion, &loads)?;
        let scale = largest(wanted.iter().copied());
        let mut next = wanted.iter();
        found.acceleration().visit(&mut |alpha| near(alpha, *next.next().unwrap(), ROUNDING * scale));
        assert_eq!(next.next(), None);

        // The oracle agrees that these torques do it.
        let mut scene = Scene::pinned(bodies);
        scene.ground = oracle_ground(shaken(inputs.time));
        scene.gravity = inputs.gravity;
        let state = scene.assemble(&inputs.angles, &inputs.rates);
        let load = |(body, p): (usize, &Push)| Load { body, point: p.point, force: p.force, torque: p.torque };
        let wrenches: Vec<Load> = pushes.iter().enumerate().map(load).collect();
        let answer = scene.solve(&state, &torques, &wrenches);
        for (alpha, wanted) in answer.angular_acceleration.iter().zip(&wanted) {
            near(*alpha, *wanted, ROUNDING * scale);
        }
    }
    Ok(())
}

/// The wrench of a force is its moment about the inboard end, and wrenches add.
#[test]
fn a_force_at_a_point_has_its_moment_about_the_inboard_end() -> Result<(), Error> {
    let (angle, at, force) = (0.7, [0.4, -0.3], [2.0, -5.0]);
    let system = System::new(Pinned::at(1.0, 2.0), RigidBody::new(2.0, 0.3, [0.4, 0.1], [0.8, -0.2]), Free)?;
    let motion = system.at_rest(&[angle])?;
    let bodies = system.body_motions(&motion)?;
    let wrench = bodies.get(0).unwrap().force_at(at, force) + Wrench::torque(0.25);
    // Exact but for the rounding of a sine and three products.
    near(wrench.torque, cross(rotate(angle, at), force) + 0.25, 1e-15 * 10.0);
    assert_eq!([wrench.force.x, wrench.force.y], force);
    Ok(())
}
