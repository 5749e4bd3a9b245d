//! Joints with linear coordinates (springs along axes, sliders, guided ends) against a dense solution of all equations at once,
//! and the orders of rules on them.

mod numbers;

use catena::Error;
use catena::loading::Unloaded;
use catena::planar::Absent;
use catena::planar::*;
use catena::simulate::Method;
use catena::system::Element;
use catena::system::{Runs, StiffDynamics};
use catena_oracle::plane::{self as oracle, Axes, Coordinates, Elastic, Scene, Tip};
use catena_oracle::{has_order, near};

/// Stiffness, damping and rest value along x, along y, and of the angle.
const SPRINGS: [[f64; 3]; 3] = [[300.0, 1.2, 0.1], [150.0, 0.7, -0.05], [8.0, 0.2, 0.3]];
/// Direction of the slider, and its spring.
const SLIDER: (f64, [f64; 3]) = (0.6, [80.0, 0.9, 0.2]);
/// Displacement and relative angle of the hinge, and their rates.
const HINGE: [[f64; 3]; 2] = [[0.13, -0.2, 0.5], [0.7, -1.1, 1.4]];
/// Distance along the slider and its rate.
const SLID: [f64; 2] = [0.35, -0.8];
/// Absolute angle of the last body and its rate.
const LAST: [f64; 2] = [-0.9, 2.0];
/// Place on the root's line and its rate; of a pinned root the first angle and its rate.
const ROOT: [f64; 2] = [0.4, 1.3];
const LINE: f64 = 0.8;

fn spring([k, c, rest]: [f64; 3]) -> Spring<f64, f64, f64> {
    Spring::new(k).damped(c).resting_at(rest)
}

fn plate() -> RigidBody<f64> {
    RigidBody::new(0.9, 0.05, [0.3, 0.1], [0.7, -0.2])
}

fn rod() -> Rod<f64> {
    Rod::new(0.8, 1.3, 0.3, 0.07)
}

/// A ground that moves and turns, at time zero.
fn ground() -> oracle::Ground {
    oracle::Ground {
        position: [0.2, -0.1],
        velocity: [0.3, 0.5],
        acceleration: [-0.7, 0.4],
        angle: 0.3,
        rate: -0.6,
        angular_acceleration: 0.9,
    }
}

type MovingGround = Clamped<Moving<fn(f64) -> GroundMotion<f64>>, Turning<fn(f64) -> [f64; 3]>>;

fn moving() -> MovingGround {
    let place: fn(f64) -> GroundMotion<f64> =
        |_| GroundMotion { place: [0.2, -0.1], velocity: [0.3, 0.5], acceleration: [-0.7, 0.4] };
    Clamped { place: Moving(place), attitude: Turning(|_| [0.3, -0.6, 0.9]) }
}

/// Where the hinge of a scene is, for the oracle.
fn hinge_coordinates(displaced: bool) -> Coordinates {
    let [place, rate] = HINGE;
    let (u, u_rate) = if displaced { ([place[0], place[1]], [rate[0], rate[1]]) } else { ([0.0; 2], [0.0; 2]) };
    Coordinates { u, phi: place[2], u_rate, phi_rate: rate[2] }
}

/// The scene of [`compare`] for the oracle, and its state.
fn dense(joint: oracle::Joint, displaced: bool) -> (Scene, oracle::State) {
    let plate = oracle::Body { mass: 0.9, inertia_c: 0.05, centre: [0.3, 0.1], outboard: [0.7, -0.2] };
    let rod = oracle::Body { mass: 1.3, inertia_c: 0.07, centre: [0.3, 0.0], outboard: [0.8, 0.0] };
    let axis = |angle: f64| [angle.cos(), angle.sin()];
    let scene = Scene {
        bodies: vec![plate, rod, plate, rod],
        joints: vec![
            oracle::Joint::Slider { axis: axis(LINE), spring: [0.0; 3] },
            joint,
            oracle::Joint::Slider { axis: axis(SLIDER.0), spring: SLIDER.1 },
            oracle::Joint::Pin,
        ],
        ground: ground(),
        tip: Tip::Free,
        gravity: [0.0, -9.81],
    };
    let hinge = hinge_coordinates(displaced);
    let ground = ground();
    let state = scene.place(&[
        Coordinates::along(axis(LINE), ROOT[0], ROOT[1], 0.0),
        hinge,
        Coordinates::along(axis(SLIDER.0), SLID[0], SLID[1], 0.0),
        Coordinates::angle(LAST[0] - ground.angle - hinge.phi, LAST[1] - ground.rate - hinge.phi_rate),
    ]);
    (scene, state)
}

/// A plate on a guided root, the hinge, a rod, a slider with a spring, a plate, a pin, a rod, beside the oracle.
macro_rules! compare {
    ($name:literal, $hinge:expr, $joint:expr, |$coordinates:ident| $set:expr, $displaced:expr) => {{
        let track = Slider::along(SLIDER.0).with(spring(SLIDER.1));
        let chain = (plate(), $hinge, rod(), track, plate(), Pin, rod());
        let scene = System::new(Guided::on(moving(), LINE), chain, Free)?.with_gravity(9.81);
        let mut motion = scene.motion();
        let set = |$coordinates: [f64; 3]| $set;
        *motion.position_mut() = (ROOT[0], ((), set(HINGE[0]), (), SLID[0], (), LAST[0], ()));
        *motion.rate_mut() = (ROOT[1], ((), set(HINGE[1]), (), SLID[1], (), LAST[1], ()));
        let motion = scene.with_accelerations(motion, &Unloaded)?;
        let (dense, state) = dense($joint, $displaced);
        let answer = dense.solve(&state, &[], &[]);
        let (stations, bodies) = (scene.stations(&motion, &Unloaded).unwrap(), scene.body_motions(&motion).unwrap());
        let mut worst: f64 = 0.0;
        let mut meet = |found: f64, expected: f64| {
            worst = worst.max((found - expected).abs());
            near(found, expected, 1e-10);
        };
        for k in 0..4 {
            let body = bodies.get(k).unwrap();
            meet(body.inboard.place.x, state.position[k][0]);
            meet(body.inboard.velocity.y, state.velocity[k][1]);
            meet(body.inboard.acceleration.linear.x, answer.acceleration[k][0]);
            meet(body.inboard.acceleration.linear.y, answer.acceleration[k][1]);
            meet(body.inboard.acceleration.angular, answer.angular_acceleration[k]);
            let station = stations.get(2 * k).unwrap().internal;
            meet(station.force.x, answer.q_inboard[k][0]);
            meet(station.force.y, answer.q_inboard[k][1]);
            meet(station.torque, answer.m_inboard[k]);
            meet(stations.get(2 * k + 1).unwrap().internal.torque, answer.m_outboard[k]);
        }
        meet(scene.budget(&motion).unwrap().potential, dense.potential_energy(&state));
        println!("{}: {worst:.1e}", $name);
    }};
}

/// Springs of the oracle's hinge: those that are there.
fn elastic(parts: [bool; 3], axes: Axes) -> oracle::Joint {
    let part = |i: usize| if parts[i] { SPRINGS[i] } else { [0.0; 3] };
    let column = |j: usize| [part(0)[j], part(1)[j], part(2)[j]];
    oracle::Joint::Elastic(Elastic { stiffness: column(0), damping: column(1), rest: column(2), axes })
}

#[test]
fn each_part_of_a_hinge_agrees_with_the_dense_system() -> Result<(), Error> {
    let [x, y, turn] = SPRINGS;
    let rotary = || ElasticHinge::rotary(turn[0]).damped(turn[1]).resting_at(turn[2]);
    let all = || rotary().with_linear(spring(x), spring(y));
    compare!("inboard axes", all(), elastic([true; 3], Axes::Inboard), |c| (c[0], c[1], c[2]), true);
    compare!("fixed axes", all().in_fixed_axes(), elastic([true; 3], Axes::Fixed), |c| (c[0], c[1], c[2]), true);
    let unbalanced = elastic([true; 3], Axes::FixedUnbalanced);
    compare!("unbalanced axes", all().in_unbalanced_axes(), unbalanced, |c| (c[0], c[1], c[2]), true);
    let only_x = ElasticHinge::linear(spring(x), Absent);
    compare!("x alone", only_x, elastic([true, false, false], Axes::Inboard), |c| (c[0], c[1], c[2]), true);
    let only_y = ElasticHinge::linear(Absent, spring(y)).in_fixed_axes();
    compare!("y alone", only_y, elastic([false, true, false], Axes::Fixed), |c| (c[0], c[1], c[2]), true);
    let no_rotary = ElasticHinge::linear(spring(x), spring(y));
    compare!("x and y", no_rotary, elastic([true, true, false], Axes::Inboard), |c| (c[0], c[1], c[2]), true);
    let [stiffness, damping, rest] = turn;
    compare!("rotary", rotary(), oracle::Joint::Rotary { stiffness, damping, rest }, |c| c[2], false);
    Ok(())
}

/// Where errors are measured (s): at several times, because at a single one a leading term may vanish.
const TIMES: [f64; 4] = [0.4, 0.5, 0.6, 0.7];

/// Errors of the tip's place and the root's force against DOP853, root of the sum of squares over the times.
fn errors<C, M>(
    scene: &System<f64, Pinned<[f64; 2]>, C, Free>,
    rule: impl Fn(f64) -> catena::time::Rule<M, f64>,
    steps: &[f64],
    start: &MotionOf<C>,
) -> Result<[Vec<(f64, f64)>; 2], Error>
where
    C: Element<Planar<f64>>,
    System<f64, Pinned<[f64; 2]>, C, Free>:
        StiffDynamics<Unloaded> + Runs<Unloaded, Planar<f64>, Pinned<[f64; 2]>, C, Free>,
    M: for<'s> Method<&'s System<f64, Pinned<[f64; 2]>, C, Free>, Unloaded>,
{
    let read = |motion: &MotionOf<C>| {
        let stations = scene.stations(motion, &Unloaded).unwrap();
        [stations.tip().frame.place, stations.root().internal.force]
    };
    let mut exact = start.clone();
    let mut expected = vec![];
    for time in TIMES {
        exact = scene.simulate(exact, Dop853::tolerance(1e-13), time, |_| ())?.motion;
        expected.push(read(&exact));
    }
    let mut points = [vec![], vec![]];
    for h in steps {
        let mut squares = [0.0; 2];
        scene.simulate(start.clone(), rule(*h), TIMES[3], |now| {
            if let Some(k) = TIMES.iter().position(|time| (now.time() - time).abs() < 1e-9) {
                let found = read(now.motion());
                (0..2).for_each(|i| squares[i] += (found[i] - expected[k][i]).norm_squared());
            }
        })?;
        (0..2).for_each(|i| points[i].push((*h, squares[i].sqrt())));
    }
    Ok(points)
}

type MotionOf<C> = catena::system::MotionOf<Planar<f64>, Pinned<[f64; 2]>, C, Free>;

/// A pinned plate, the hinge, a rod, a slider with a spring, a rod: in place and force, by these rules.
macro_rules! orders {
    ($name:literal, $hinge:expr, $stage:expr) => {{
        let track = Slider::along(SLIDER.0).with(spring(SLIDER.1));
        let scene = System::new(Pinned::origin(), (plate(), $hinge, rod(), track, rod()), Free)?.with_gravity(9.81);
        let mut start = scene.motion();
        *start.position_mut() = (-0.5, ((), (0.1, -0.05, 0.3), (), 0.2, ()));
        *start.rate_mut() = (0.5, ((), (0.0, 0.3, -0.4), (), 0.0, ()));
        let name = |rule: &str, what: &str| format!("{}, {rule}, {what}", $name);
        let [places, forces] = errors(&scene, Rk4::step, &[0.005, 0.0025, 0.00125], &start)?;
        has_order(&name("RK4", "place"), 4.0, 1e-12, &places);
        has_order(&name("RK4", "force"), 4.0, 1e-11, &forces);
        let rule = |h| GeneralizedAlpha::new(0.8).step(h);
        let [places, forces] = errors(&scene, rule, &[0.002, 0.001, 0.0005], &start)?;
        has_order(&name("generalised-alpha", "place"), 2.0, 1e-12, &places);
        has_order(&name("generalised-alpha", "force"), 2.0, 1e-11, &forces);
        let [places, forces] = errors(&scene, |h| Sdirk4::new().step(h), &[0.01, 0.005, 0.0025], &start)?;
        has_order(&name("SDIRK4", "place"), $stage, 1e-12, &places);
        has_order(&name("SDIRK4", "force"), $stage, 1e-11, &forces);
    }};
}

#[test]
fn rules_have_their_order_on_linear_springs() -> Result<(), Error> {
    let [x, y, turn] = SPRINGS;
    let all = || ElasticHinge::rotary(turn[0]).damped(turn[1]).resting_at(turn[2]).with_linear(spring(x), spring(y));
    orders!("inboard axes", all(), 4.0);
    orders!("unbalanced axes", all().in_unbalanced_axes(), 4.0);
    orders!("fixed axes", all().in_fixed_axes(), 4.0);
    Ok(())
}

/// A stiffness in three directions makes a weld, whatever its size.
#[test]
fn stiff_linear_springs_approach_a_weld() -> Result<(), Error> {
    let scene = |k: f64| {
        let hinge = ElasticHinge::rotary(k)
            .damped(1e-2 * k)
            .with_linear(Spring::new(k).damped(1e-2 * k), Spring::new(k).damped(1e-2 * k));
        System::new(Pinned::origin(), (rod(), hinge, plate(), Pin, rod()), Free).map(|s| s.with_gravity(9.81))
    };
    let welded = System::new(Pinned::origin(), (rod(), Weld::at(0.0), plate(), Pin, rod()), Free)?.with_gravity(9.81);
    let rule = || GeneralizedAlpha::new(0.8).step(0.002);
    let limit = welded.simulate(welded.at_rest(&[-0.5, 0.3])?, rule(), 0.4, |_| ())?.motion;
    let (place, force) = (welded.stations(&limit, &Unloaded)?.tip().frame.place, {
        welded.stations(&limit, &Unloaded)?.root().internal.force
    });
    for k in [1e6, 1e8, 1e10, 1e12] {
        let scene = scene(k)?;
        let run = scene.simulate(scene.at_rest(&[-0.5, -0.5, 0.3])?, rule(), 0.4, |_| ())?.motion;
        let stations = scene.stations(&run, &Unloaded)?;
        let (off, pull) = (stations.tip().frame.place - place, stations.root().internal.force - force);
        println!("k = {k:.0e}: {:.1e} m, {:.1e} N", off.norm(), pull.norm());
        // The springs stretch by some 20 N / k. They start unstrained, and the rule forgets that jump within some steps, which
        // leaves 1e-8 m however stiff they are.
        assert!(off.norm() < 1e2 / k + 2e-8);
        assert!(pull.norm() < 1e4 / k + 1e-6);
    }
    Ok(())
}
