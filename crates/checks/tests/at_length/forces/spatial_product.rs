//! The plain product of transfer matrices in space against the Riccati sweep, and against the equations of Newton and Euler.

use catena::internals::transfer::Efforts;
use catena::loading::{Loading, Unloaded};
use catena::spatial::index::{M, ONE, Q, R, THETA};
use catena::spatial::*;
use catena::system::Element;
use catena::system::Root;
use catena::system::{MotionOf, Runs};
use catena::{Error, Fault, Place, StateVector, TransferMatrix};
use catena_oracle::Noise;
use nalgebra::Vector3;

type State = StateVector<f64, 13>;

fn part(state: &State, at: usize) -> Vector3<f64> {
    Vector3::new(state[at], state[at + 1], state[at + 2])
}

/// The largest difference between two states, in parts of the largest entries of their kinds.
fn apart(found: &State, expected: &State) -> f64 {
    let size = |at: usize| part(expected, at).amax().max(1.0);
    [R, THETA, M, Q]
        .iter()
        .fold(0.0, |worst: f64, at| worst.max((part(found, *at) - part(expected, *at)).amax() / size(*at)))
}

fn body() -> RigidBody<f64> {
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
    RigidBody::new(1.0, tensor, [0.3, 0.03, -0.02], [0.7, 0.1, 0.05])
}

/// All joints, with springs, dampers and rest values, and bodies of all kinds.
macro_rules! chain {
    () => {{
        let rod = Rod::uniform(0.6, 0.05, 0.8);
        let hinge = Revolute::about([0.2, 1.0, 0.3]).with(Spring::stiffness(3.0).damped(0.2).resting_at(0.4));
        let cardan =
            Universal::about([1.0, 0.0, 0.2], [0.0, 0.5, 1.0]).with(Spring::stiffness(2.0), Spring::damping(0.3));
        let sleeve = Cylindrical::on([1.0, 0.2, 0.1]).with(Spring::stiffness(25.0).damped(1.0), Spring::damping(0.1));
        let slide = Prismatic::along([0.1, 0.9, 0.2]).with(Spring::stiffness(40.0).resting_at(0.1));
        let bent = Weld::at(Rotation::from_angles([0.3, -0.5, 0.4]));
        let elastic = ElasticBall::rotary([2.0, 1.0, 3.0]).damped(0.1);
        let soft = ElasticHinge::linear(Spring::stiffness(30.0).damped(0.5), Spring::none(), Spring::stiffness(20.0));
        (
            (body(), hinge, rod, cardan, body(), slide, rod),
            (sleeve, body(), bent, rod, PointMass::new(0.2, 0.3), elastic, body()),
            (Ball, rod, Revolute::about([0.0, 0.0, 1.0]), PointMass::new(0.3, 0.4), body(), soft, body()),
        )
    }};
}

/// A scene in general position under loads on all bodies and in all joints, and the accelerations of a sweep.
macro_rules! in_general_position {
    ($root:expr, $seed:expr) => {{
        let scene = System::new($root, chain!(), Free)?.with_gravity_vector(Vector3::new(0.3, -9.81, 0.7));
        let mut noise = Noise::new($seed);
        let mut motion = scene.motion();
        let mut step = *motion.rate();
        catena::system::Rate::replace(&mut step, &mut |_: f64| 0.8 * noise.next());
        catena::system::Position::displace(motion.position_mut(), &step);
        catena::system::Rate::replace(motion.rate_mut(), &mut |_: f64| 2.0 * noise.next());
        let loads = Loads::none()
            .in_joints(|_, joint, _: &JointMotion<f64>| Effort([0.3 + 0.1 * joint as f64, -0.8, 0.5]))
            .on_bodies(|_, body, motion: &BodyMotion<f64>| {
                motion.force_at([0.1, 0.2, -0.1], [1.0 + body as f64, -0.5, 0.3]) + Wrench::torque([0.1, 0.0, -0.2])
            });
        let motion = scene.with_accelerations(motion, &loads)?;
        (scene, motion, loads)
    }};
}

/// Every matrix takes the sweep's state at an element's inboard end to that at its outboard end, and the product finds the state of
/// the sweep at the root.
fn check<G, C, L>(
    name: &str,
    scene: &System<f64, G, C, Free>,
    motion: &MotionOf<Spatial<f64>, G, C, Free>,
    loads: &L,
) -> Result<(), Error>
where
    G: Root<Spatial<f64>>,
    C: Element<Spatial<f64>>,
    L: Loading<Spatial<f64>, InJoint: Efforts<Spatial<f64>>>,
    System<f64, G, C, Free>: Runs<L, Spatial<f64>, G, C, Free>,
{
    let stations = scene.stations(motion, loads).unwrap();
    let state = |k: usize| stations.get(k).expect("a station").acceleration_state();
    let (mut worst, mut largest) = ([0.0_f64; 2], 0.0_f64);
    scene.transfer_matrix(motion, loads, |element, u: &TransferMatrix<f64, 13>| {
        largest = largest.max(u.as_matrix().amax());
        worst[0] = worst[0].max(apart(&(*u * state(element)), &state(element + 1)));
    })?;
    worst[1] = apart(&scene.root_state(motion, loads)?, &state(0));
    println!("{name}: matrices {:.1e} (entries to {largest:.1e}), product {:.1e}", worst[0], worst[1]);
    assert!(worst[0] < 1e-13 * largest && worst[1] < 1e-10, "{worst:?}"); // rounding of entries, and of their products
    Ok(())
}

#[test]
fn matrices_of_all_elements_transfer_the_states_of_a_sweep() -> Result<(), Error> {
    for seed in 0..10 {
        let (scene, motion, loads) = in_general_position!(Pinned::at([0.1, -0.2, 0.3]), seed);
        check("ball", &scene, &motion, &loads)?;
    }
    let ground = Clamped {
        place: Moving(|_: f64| GroundMotion {
            place: [0.1; 3],
            velocity: [0.3, -0.2, 0.5],
            acceleration: [1.0, 2.0, -0.5],
        }),
        attitude: Turning(|_: f64| AttitudeMotion {
            attitude: Rotation::from_angles([0.3, -0.2, 0.5]),
            spin: [0.4, -1.0, 0.3],
            acceleration: [0.3, 0.8, -1.0],
        }),
    };
    let (scene, motion, loads) = in_general_position!(ground, 21);
    check("clamp", &scene, &motion, &loads)?;
    let (scene, motion, loads) = in_general_position!(Hinged::on(ground, [0.2, 0.3, 1.0]), 22);
    check("hinge", &scene, &motion, &loads)?;
    let (scene, motion, loads) = in_general_position!(Free, 23);
    check("free", &scene, &motion, &loads)?;
    Ok(())
}

/// The states that the product finds obey Newton's and Euler's equations, body by body, and pull at nothing at the tip.
#[test]
fn states_of_the_product_obey_newton_and_euler() -> Result<(), Error> {
    let (scene, motion, loads) = in_general_position!(Pinned::origin(), 5);
    let mut matrices = vec![];
    scene.transfer_matrix(&motion, &loads, |_, u: &TransferMatrix<f64, 13>| matrices.push(*u))?;
    matrices.reverse();
    let mut states = vec![scene.root_state(&motion, &loads)?];
    for u in &matrices {
        states.push(*u * states[states.len() - 1]);
    }
    // Bodies are elements 0, 2, 4, 6, 8, 10, 11, 13, 15, 17, 18 and 20 of the chain: after a weld there are two in a row.
    let bodies = [0, 2, 4, 6, 8, 10, 11, 13, 15, 17, 18, 20];
    let mut worst = 0.0_f64;
    for (k, (body, element)) in scene.body_motions(&motion)?.iter().zip(bodies).enumerate() {
        let (inner, outer) = (&states[element], &states[element + 1]);
        let (spin, alpha) = (body.inboard.turn.spin, part(inner, THETA));
        let (c, o) = (body.to_centre, body.arm);
        let acceleration = part(inner, R) + alpha.cross(&c) + spin.cross(&spin.cross(&c));
        let load = Vector3::new(1.0 + k as f64, -0.5, 0.3);
        let at = body.turned([0.1, 0.2, -0.1]);
        let pull = Vector3::new(0.3, -9.81, 0.7) * body.inertia.mass + load;
        let force = part(inner, Q) - part(outer, Q) + pull - acceleration * body.inertia.mass;
        let axes = body.attitude().matrix();
        let turned = |v: Vector3<f64>| axes.apply(body.inertia.matrix().apply(axes.transposed(v)));
        let torque = part(outer, M) - part(inner, M) - c.cross(&part(inner, Q)) - (o - c).cross(&part(outer, Q))
            + (at - c).cross(&load)
            + Vector3::new(0.1, 0.0, -0.2)
            - turned(alpha)
            - spin.cross(&turned(spin));
        worst = worst.max(force.amax()).max(torque.amax());
    }
    let tip = states[states.len() - 1];
    let (pull, size) = (part(&tip, Q).amax().max(part(&tip, M).amax()), part(&states[0], Q).amax());
    println!("force at the root {size:.1} N; residuals {worst:.1e} N, N·m; at the tip {pull:.1e}");
    assert_eq!(bodies.len(), scene.bodies());
    assert!(worst < 1e-11 * size && pull < 1e-8 * size); // a body's own rounding, and that of the whole product
    Ok(())
}

/// What the paper's form loses with every body, and why sweeps do not use it.
#[test]
fn digits_go_with_every_body() -> Result<(), Error> {
    let rod = Rod::uniform(1.0, 0.05, 1.0);
    println!("  bodies   balls     hinges");
    for (n, bound) in [(2, 1e-13), (4, 1e-13), (8, 1e-12), (16, 1e-9), (24, 1e-9), (32, 1e-6), (64, 1.0)] {
        let mut noise = Noise::new(7);
        let hinge = |k: usize| Revolute::about([0.1, if k.is_multiple_of(2) { 1.0 } else { 0.0 }, 1.0]);
        let balls =
            System::new(Pinned::origin(), (rod, vec![(Ball, rod); n - 1]), Free)?.with_gravity([0.0, -9.81, 0.0]);
        let links: Vec<_> = (1..n).map(|k| (hinge(k), rod)).collect();
        let hinges =
            System::new(Hinged::at([0.0; 3], [0.0, 1.0, 0.0]), (rod, links), Free)?.with_gravity([0.0, -9.81, 0.0]);
        let angles: Vec<f64> = (0..3 * n).map(|_| 0.5 * noise.next()).collect();
        let rates: Vec<f64> = (0..3 * n).map(|_| noise.next()).collect();
        let one = balls.with_accelerations(balls.with_rates(balls.at_rest(&angles)?, &rates)?, &Unloaded)?;
        let two = hinges.with_rates(hinges.at_rest(&angles[..n])?, &rates[..n])?;
        let two = hinges.with_accelerations(two, &Unloaded)?;
        let first = |station: Option<&Station<f64>>| station.expect("a station").acceleration_state();
        let balls = apart(&balls.root_state(&one, &Unloaded)?, &first(balls.stations(&one, &Unloaded)?.get(0)));
        let hinges = apart(&hinges.root_state(&two, &Unloaded)?, &first(hinges.stations(&two, &Unloaded)?.get(0)));
        println!("  {n:6}   {balls:.1e}   {hinges:.1e}");
        assert!(balls < bound && hinges < bound, "{n} bodies: {balls:e}, {hinges:e}");
        assert!(n < 64 || (balls > 1e-9 && hinges > 1e-9), "a long product keeps its digits: {balls:e}, {hinges:e}");
    }
    Ok(())
}

#[test]
fn matrices_of_bodies_have_determinant_one_and_those_of_balls_none() -> Result<(), Error> {
    let scene = System::new(Pinned::origin(), (body(), Ball, Rod::uniform(1.0, 0.1, 1.0)), Free)?
        .with_gravity([0.0, -9.81, 0.0]);
    let motion =
        scene.with_rates(scene.at_rest(&[0.3, 0.2, 0.1, -0.4, 0.5, 0.6])?, &[1.0, 0.5, -2.0, 0.3, 1.0, 0.7])?;
    scene.transfer_matrix(&motion, &Unloaded, |element, u: &TransferMatrix<f64, 13>| {
        let expected = if element == 1 { 0.0 } else { 1.0 };
        assert!((u.as_matrix().determinant() - expected).abs() < 1e-13, "{element}");
        assert_eq!((u[(ONE, ONE)], u[(ONE, R)]), (1.0, 0.0));
    })?;
    Ok(())
}

/// A bob on a universal joint swings well, but the torque at its own place says nothing of that; arms are no factors of a product.
#[test]
fn what_has_no_matrix_is_named() -> Result<(), Error> {
    let cardan = Universal::about([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let scene = System::new(Pinned::origin(), (body(), cardan, PointMass::new(1.0, 1.0)), Free)?;
    let motion = scene.with_accelerations(scene.at_rest(&[0.1, 0.2, 0.3, 0.4, 0.5])?, &Unloaded)?;
    let error = scene.transfer_matrix(&motion, &Unloaded, |_, _: &TransferMatrix<f64, 13>| ()).unwrap_err();
    assert_eq!((error.fault, error.place), (Fault::SingularTransfer, Some(Place::Station(1))));
    let tree = System::new(Pinned::origin(), (body(), Branch((Ball, body())), Ball, body()), Free)?;
    let error = tree.transfer_matrix(&tree.motion(), &Unloaded, |_, _: &TransferMatrix<f64, 13>| ()).unwrap_err();
    assert!(matches!(error.fault, Fault::Unsupported { .. }), "{error:?}");
    Ok(())
}
