//! Joints that follow others in scenes whose tip is held or whose loops are closed: accelerations and forces against dense multipliers, a run
//! against the one freedom that is left, all rules, what a coupling says that closures say as well.

use catena::planar::*;
use catena::scalar::{Jet, Scalar};
use catena::simulate::EnergyDrift;
use catena::{Error, Fault, robot, spatial};
use catena_oracle::plane::{self, Coordinates, Ground, Tip};
use catena_oracle::{Noise, near};
use std::f64::consts::PI;

const GRAVITY: f64 = 9.81;
const RATIO: f64 = -0.7;

/// Mass, inertia about the mass centre, mass centre, outboard end.
type Plate = (f64, f64, [f64; 2], [f64; 2]);

fn plates(noise: &mut Noise) -> [Plate; 4] {
    std::array::from_fn(|_| {
        let [m, i, x, y] = [0; 4].map(|_| noise.between(0.5, 1.5));
        (m, 0.05 * i, [0.3 * x, 0.1 * (y - 1.0)], [0.8, 0.0])
    })
}

fn body((mass, inertia, centre, outboard): Plate) -> RigidBody<f64> {
    RigidBody::new(mass, inertia, centre, outboard)
}

/// A chain of four plates to a pin, whose last joint follows the second.
macro_rules! chain {
    ($plates:expr) => {{
        let [a, b, c, d] = $plates.map(body);
        let j = Revolute::smooth();
        System::new(Clamped::origin(), (j, a, j, b, j, c, j.named("last"), d), Pinned::at(1.6, 0.2))?
            .with_gravity(GRAVITY)
    }};
}

#[test]
fn a_held_chain_is_that_of_dense_multipliers() -> Result<(), Error> {
    let mut noise = Noise::new(3);
    let (mut worst, mut most) = (0.0_f64, 0.0_f64);
    for _ in 0..100 {
        let plates = plates(&mut noise);
        let scene = chain!(plates);
        let couplings = Couplings::of(&scene, [Coupling::new("last", 2).ratio(RATIO).offset(-0.3)])?;
        let mut start = scene.motion();
        start.set_coordinates(&[0.92, 0.42, -1.96, -0.6].map(|x| x + noise.between(-0.1, 0.1)))?;
        start.set_rates(&[0; 4].map(|_| noise.between(-1.0, 1.0)))?;
        let torques = [0; 4].map(|_| noise.between(-2.0, 2.0));
        let loads = couplings.and(Loads::none().torques([&[0.0], &torques[..]].concat()));
        let motion = scene.assembled(couplings.joined(start), &loads)?;
        let (q, v, found) = (motion.coordinates(), motion.rates(), motion.accelerations());
        near(q[3], RATIO * q[1] - 0.3, 1e-14);
        near(v[3], RATIO * v[1], 1e-14);
        near(found[3], RATIO * found[1], 1e-11 * (1.0 + found[1].abs()));

        let bodies =
            plates.map(|(mass, inertia_c, centre, outboard)| plane::Body { mass, inertia_c, centre, outboard });
        let tip = Tip::pinned(Ground::at([1.6, 0.2]));
        let dense = plane::Scene { tip, ..plane::Scene::pinned(bodies.to_vec()) };
        let state = dense.place(&std::array::from_fn::<_, 4, _>(|k| Coordinates::angle(q[k], v[k])));
        let relative = |under: [f64; 4]| {
            let answer = dense.solve(&state, &under, &[]);
            let alpha = &answer.angular_acceleration;
            (std::array::from_fn::<_, 4, _>(|k| alpha[k] - if k > 0 { alpha[k - 1] } else { 0.0 }), answer)
        };
        // λ in the last joint and −r λ in the second, such that the one follows the other.
        let pulled = |force: f64| [torques[0], torques[1] - RATIO * force, torques[2], torques[3] + force];
        let missed = |force: f64| {
            let (a, _) = relative(pulled(force));
            a[3] - RATIO * a[1]
        };
        let force = missed(0.0) / (missed(0.0) - missed(1.0));
        let (expected, answer) = relative(pulled(force));
        let size = expected.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
        found.iter().zip(expected).for_each(|(x, y)| worst = worst.max((x - y).abs() / size));
        // What holds the tip, and what the joints exert.
        let stations = scene.stations(&motion, &loads)?;
        let tip = stations.tip().internal.force;
        let size = answer.tip_force.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
        let off = (tip.x - answer.q_outboard[3][0]).abs().max((tip.y - answer.q_outboard[3][1]).abs());
        let torque = -stations.joint(scene.joint("last")?).expect("a station").internal.torque;
        most = most.max(off / size).max((torque - pulled(force)[3]).abs() / (1.0 + force.abs()));
    }
    println!("accelerations {worst:.1e}, forces {most:.1e}");
    // Both solve the same equations: rounding, times the condition of a mass matrix of four links.
    assert!(worst < 1e-11 && most < 1e-11);
    Ok(())
}

const BASE: f64 = 1.6;
const LINKS: [f64; 2] = [0.9, 0.8];
/// Mass (kg), inertia about the mass centre (kg·m²), and how far that is along the link (m).
const BARS: [[f64; 3]; 4] = [[1.0, 0.06, 0.4], [0.6, 0.03, 0.5], [1.4, 0.09, 0.3], [0.8, 0.05, 0.6]];

/// Two arms that meet, alike in lengths, not in masses, whose coupling keeps them symmetric: one freedom is left.
macro_rules! symmetric {
    () => {
        symmetric!(Revolute::smooth())
    };
    ($shoulder:expr) => {{
        let bar = |k: usize, length| {
            let [mass, inertia, at] = BARS[k];
            RigidBody::new(mass, inertia, [at, 0.0], [length, 0.0])
        };
        let ([a, c], j) = (LINKS, Revolute::smooth());
        let chain = ($shoulder, bar(0, a), j.named("left"), bar(1, c), j, bar(2, c), j.named("right"), bar(3, a));
        let scene = System::new(Clamped::origin(), chain, Pinned::at(BASE, 0.0))?.with_gravity(GRAVITY);
        let couplings = Couplings::of(&scene, [Coupling::new("right", "left")])?;
        (scene, couplings)
    }};
}

/// Angles of the two links on the left, how the second one turns with the first.
fn left(theta: f64) -> (f64, f64) {
    let [a, c] = LINKS;
    let phi = ((0.5 * BASE - a * theta.cos()) / c).acos();
    (phi, -a * theta.sin() / (c * phi.sin()))
}

/// Coordinates and rates at an angle of the first link.
fn coordinates(theta: f64, rate: f64) -> [[f64; 4]; 2] {
    let (phi, turn) = left(theta);
    let twist = phi - theta;
    [[theta, twist, -2.0 * phi, twist], [rate, (turn - 1.0) * rate, -2.0 * turn * rate, (turn - 1.0) * rate]]
}

/// Twice the kinetic energy at a unit rate, and the potential energy.
fn energies(theta: f64) -> [f64; 2] {
    let ([a, c], (phi, turn)) = (LINKS, left(theta));
    // Of each link: where it begins, how that moves, its angle, and how that turns.
    let elbow = [a * theta.cos(), a * theta.sin()];
    let elbow_moves = [-elbow[1], elbow[0]];
    let top = elbow[1] + c * phi.sin();
    let top_moves = elbow_moves[1] + c * phi.cos() * turn;
    let links = [
        ([0.0, 0.0], [0.0, 0.0], theta, 1.0),
        (elbow, elbow_moves, phi, turn),
        ([0.5 * BASE, top], [0.0, top_moves], -phi, -turn),
        ([BASE - elbow[0], elbow[1]], [-elbow_moves[0], elbow_moves[1]], -theta, -1.0),
    ];
    let mut sum = [0.0; 2];
    for ([mass, inertia, at], (begin, moves, angle, turns)) in BARS.into_iter().zip(links) {
        let v = [moves[0] - at * angle.sin() * turns, moves[1] + at * angle.cos() * turns];
        sum[0] += mass * (v[0] * v[0] + v[1] * v[1]) + inertia * turns * turns;
        sum[1] += mass * GRAVITY * (begin[1] + at * angle.sin());
    }
    sum
}

#[test]
fn two_arms_fall_as_the_one_freedom_that_is_left() -> Result<(), Error> {
    let (scene, couplings) = symmetric!();
    let ([from, to], rate) = ([1.3, 0.7], -2.5);
    let mut start = scene.motion();
    let [q, v] = coordinates(from, rate);
    start.set_coordinates(&q)?;
    start.set_rates(&v)?;
    let start = scene.assembled(couplings.joined(start), &couplings)?;
    start.coordinates().iter().zip(q).for_each(|(x, y)| near(*x, y, 1e-14));
    let run = scene.simulation(Dop853::tolerance(1e-13)).loads(&couplings);
    let end = run.event(|now| now.motion().coordinates()[0] - to).stopping().run(start, 2.0, |_| ())?.motion;
    // t = ∫ dθ / θ̇ by Simpson's rule.
    let [inertia, height] = energies(from);
    let energy = 0.5 * inertia * rate * rate + height;
    let slowness = |theta: f64| {
        let [inertia, height] = energies(theta);
        (inertia / (2.0 * (energy - height))).sqrt()
    };
    let (count, mut time) = (4000, 0.0);
    for k in 0..=2 * count {
        let weight = if k == 0 || k == 2 * count { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
        time += weight * slowness(from + (to - from) * f64::from(k) / f64::from(2 * count));
    }
    time *= (from - to) / f64::from(6 * count);
    // Simpson's rule errs by the fourth power of 1e-4, the run by its tolerance.
    near(end.time(), time, 1e-11);
    let [q, v] = coordinates(to, -slowness(to).recip());
    end.coordinates().iter().zip(q).for_each(|(x, y)| near(*x, y, 1e-10));
    end.rates().iter().zip(v).for_each(|(x, y)| near(*x, y, 1e-9));
    Ok(())
}

/// On a spring at the shoulder they rest where its energy and that of their weights are least, and swing as one body.
#[test]
fn two_arms_rest_and_swing_as_the_one_freedom_that_is_left() -> Result<(), Error> {
    let (stiffness, unloaded) = (300.0, 1.25);
    let (scene, couplings) = symmetric!(ElasticHinge::rotary(stiffness).resting_at(unloaded));
    let mut start = scene.motion();
    start.set_coordinates(&coordinates(1.0, 0.0)[0])?;
    let rest = scene.equilibrium(couplings.joined(start), &couplings)?;
    let energy = |theta: f64| energies(theta)[1] + 0.5 * stiffness * (theta - unloaded) * (theta - unloaded);
    let theta = rest.coordinates()[0];
    rest.coordinates().iter().zip(coordinates(theta, 0.0)[0]).for_each(|(x, y)| near(*x, y, 1e-13));
    // Differences of order four: slopes to rounding of energies of some 40 J over 1e-3, curvatures to the fourth power of 1e-2.
    let (h, at) = (1e-2, |steps: f64, h: f64| energy(theta + steps * h));
    let slope = (8.0 * (at(1.0, 1e-3) - at(-1.0, 1e-3)) - (at(2.0, 1e-3) - at(-2.0, 1e-3))) / 12e-3;
    near(slope, 0.0, 1e-9);
    let curvature =
        (16.0 * (at(1.0, h) + at(-1.0, h)) - (at(2.0, h) + at(-2.0, h)) - 30.0 * energy(theta)) / (12.0 * h * h);
    let frequency = (curvature / energies(theta)[0]).sqrt();
    let modes = scene.modes(&rest, &couplings)?;
    assert_eq!(modes.len(), 1);
    modes.frequencies().for_each(|found| near(found, frequency, 1e-7 * frequency));
    Ok(())
}

#[test]
fn all_rules_keep_what_is_coupled_and_closed() -> Result<(), Error> {
    let (scene, couplings) = symmetric!();
    let mut start = scene.motion();
    let [q, v] = coordinates(1.3, -0.4);
    start.set_coordinates(&q)?;
    start.set_rates(&v)?;
    let start = scene.assembled(start, &couplings)?;
    let reference =
        scene.simulation(Dop853::tolerance(1e-13)).loads(&couplings).run(start, 0.5, |_| ())?.motion.coordinates();
    macro_rules! keeps {
        ($name:literal, $rule:expr, $off:literal) => {{
            let mut missed = 0.0_f64;
            let run = scene.simulation($rule).loads(&couplings).run(start, 0.5, |now| {
                let (motion, tip) = (now.stepped(), now.stations().tip().frame);
                let (q, v) = (motion.coordinates(), motion.rates());
                let of_tip = (tip.place.x - BASE)
                    .abs()
                    .max(tip.place.y.abs())
                    .max(tip.velocity.x.abs())
                    .max(tip.velocity.y.abs());
                missed = missed.max((q[3] - q[1]).abs()).max((v[3] - v[1]).abs()).max(of_tip);
            })?;
            let off =
                run.motion.coordinates().iter().zip(&reference).fold(0.0, |most: f64, (x, y)| most.max((x - y).abs()));
            println!("{}: misses {missed:.1e}, off {off:.1e}", $name);
            // Kept to some hundred roundings; off by what each rule errs with this step or tolerance.
            assert!(missed < 2e-13 && off < $off);
        }};
    }
    keeps!("RK4", Rk4::step(0.005), 1e-6);
    keeps!("DOPRI5", Dopri5::tolerance(1e-9), 1e-7);
    keeps!("DOP853", Dop853::tolerance(1e-9), 1e-7);
    keeps!("Adams", Adams::tolerance(1e-9), 1e-6);
    keeps!("VCABM", Vcabm::new().tolerance(1e-9), 1e-6);
    keeps!("generalised-alpha", GeneralizedAlpha::new(0.8).step(0.001), 1e-4);
    keeps!("SDIRK4", Sdirk4::new().step(0.005), 1e-6);
    keeps!("Moreau-Jean", MoreauJean::step(0.0005), 1e-2);
    keeps!("Auto", Auto::tolerance(1e-9), 1e-6);
    Ok(())
}

#[test]
fn a_coupling_that_a_loop_says_as_well_changes_nothing() -> Result<(), Error> {
    // A parallelogram: its cranks turn alike.
    let bar = |length, mass| RigidBody::new(mass, 0.05, [0.5 * length, 0.1], [length, 0.0]);
    let j = Revolute::smooth();
    let scene =
        System::new(Clamped::origin(), (j, bar(0.7, 1.0), j, bar(1.5, 2.0), j, bar(0.7, 0.5)), Pinned::at(1.5, 0.0))?;
    let scene = scene.with_gravity(GRAVITY);
    let mut start = scene.motion();
    start.set_coordinates(&[1.1, -1.1, 1.1 - PI])?;
    start.set_rates(&[0.8, -0.8, 0.8])?;
    let couplings = Couplings::of(&scene, [Coupling::new(3, 2).ratio(-1.0).offset(-PI)])?;
    let start = scene.assembled(start, &couplings)?;
    let free = scene.with_accelerations(start, &Unloaded)?;
    start.accelerations().iter().zip(free.accelerations()).for_each(|(x, y)| near(*x, y, 1e-13 * (1.0 + y.abs())));
    let torque = |motion, loads: &Couplings<f64, 1>| -> Result<f64, Error> {
        Ok(scene.stations(motion, loads)?.joint(scene.joint(3)?).expect("a station").internal.torque)
    };
    near(torque(&start, &couplings)?, 0.0, 1e-12);
    Ok(())
}

/// Parallel cranks on gears, which their loop has turn alike but at its dead points: gears get no force in any posture, and runs through dead points are
/// those without, step by step.
#[test]
fn gears_of_parallel_cranks_change_nothing() -> Result<(), Error> {
    let (crank, j) = (Rod::uniform(0.2, 1.0), Revolute::smooth());
    let side = (RigidBody::massless([1.0, 0.0]), j.named("other"), crank);
    let net = Network::new((j.named("crank"), crank, j, Rod::uniform(1.0, 2.0)), side, Pin);
    let scene = System::new(Clamped::origin(), net, Free)?.with_gravity(GRAVITY);
    let gears = Couplings::of(&scene, [Coupling::new("other", "crank")])?;
    let turned = |angle: f64, rate: f64| {
        let mut start = scene.motion();
        start.set_coordinates(&[angle, -angle, angle])?;
        start.set_rates(&[rate, -rate, rate])?;
        scene.assembled(start, &gears)
    };
    for angle in [-0.5, -0.500_000_1, -0.6, 1.0, 2.8, 1e-3, 1e-4] {
        let start = turned(angle, 0.0)?;
        let free = scene.with_accelerations(start, &Unloaded)?;
        let [geared, free] = [scene.stations(&start, &gears)?, scene.stations(&free, &Unloaded)?].map(|stations| {
            ["crank", "other"].map(|name| {
                let joint = scene.joint(name).expect("a joint");
                stations.joint(joint).expect("a station").internal
            })
        });
        for (geared, free) in geared.iter().zip(&free) {
            near(geared.torque, 0.0, 1e-13);
            near(geared.force.x, free.force.x, 1e-9 * (1.0 + free.force.norm()));
            near(geared.force.y, free.force.y, 1e-9 * (1.0 + free.force.norm()));
        }
    }
    // Gears that would have them turn otherwise.
    let against = Couplings::of(&scene, [Coupling::new("other", "crank").offset(0.1)])?;
    let fault = scene.assembled(turned(1.0, 0.0)?, &against).map(|_| ()).map_err(|error| error.fault);
    assert!(matches!(fault, Err(Fault::NotClosed { residual }) if residual > 0.05), "{fault:?}");
    let start = turned(1.0, 12.0)?;
    for tolerance in [1e-8, 1e-12] {
        let geared = scene.simulation(Dop853::tolerance(tolerance)).loads(&gears).run(start, 5.0, |_| ())?;
        let free = scene.simulate(start, Dop853::tolerance(tolerance), 5.0, |_| ())?;
        assert!(free.motion.coordinates()[0] > 70.0); // eleven times round
        near(geared.motion.coordinates()[0], free.motion.coordinates()[0], 1e-8);
    }
    Ok(())
}

/// A coupling that is said twice, and one in single precision: as once, and as in double.
#[test]
fn a_held_chain_is_coupled_twice_and_in_single_precision() -> Result<(), Error> {
    let plates = plates(&mut Noise::new(5));
    let scene = chain!(plates);
    let follows = Coupling::new("last", 2).ratio(RATIO).offset(-0.3);
    let (once, twice) = (Couplings::of(&scene, [follows])?, Couplings::of(&scene, [follows, follows])?);
    let mut guess = scene.motion();
    guess.set_coordinates(&[0.92, 0.42, -1.96, -0.6])?;
    let start = scene.assembled(once.joined(guess), &once)?;
    let run = |loads: &Couplings<f64, 2>| -> Result<_, Error> {
        Ok(scene.simulation(Dop853::tolerance(1e-10)).loads(loads).run(start, 0.5, |_| ())?)
    };
    let found = run(&twice)?.motion.coordinates();
    let expected =
        scene.simulation(Dop853::tolerance(1e-10)).loads(&once).run(start, 0.5, |_| ())?.motion.coordinates();
    found.iter().zip(&expected).for_each(|(x, y)| near(*x, *y, 1e-10));
    let (single, start) = (scene.lift(|x| x as f32), start.lift(|x| x as f32));
    let geared = Couplings::of(&single, [Coupling::new("last", 2).ratio(RATIO as f32).offset(-0.3)])?;
    let start = single.assembled(start, &geared)?;
    for end in [
        single.simulation(Rk4::step(0.005)).loads(&geared).run(start, 0.5, |_| ())?.motion,
        single.simulation(Sdirk4::new().step(0.005)).loads(&geared).run(start, 0.5, |_| ())?.motion,
    ] {
        let q = end.coordinates();
        near(f64::from(q[3]), RATIO * f64::from(q[1]) - 0.3, 1e-6);
        q.iter().zip(&expected).for_each(|(x, y)| near(f64::from(*x), *y, 1e-4));
    }
    Ok(())
}

/// From a guess whose coupling is far apart: a parallelogram whose arms go round, and arms of other lengths.
#[test]
fn couplings_far_apart_are_assembled() -> Result<(), Error> {
    let (rod, j) = (Rod::uniform(1.0, 1.0), Revolute::smooth());
    let left = (RigidBody::massless([-0.3, 0.4]), j.named("left"), rod, Pin, Rod::uniform(0.7, 1.0));
    let right = (RigidBody::massless([0.3, 0.4]), j.named("right"), rod);
    let scene = System::new(Clamped::origin(), Network::new(left, right, Pin), Free)?.with_gravity(GRAVITY);
    let mut guess = scene.motion();
    guess.set_coordinates(&[1.31, -0.05, 1.18])?;
    let follows = Couplings::of(&scene, [Coupling::new("right", "left").ratio(-1.0).offset(3.3)])?;
    let found = scene.assembled(guess, &follows)?.coordinates();
    // By Newton's method for the three equations.
    found.iter().zip([1.700_16, 0.011_33, 1.599_84]).for_each(|(x, y)| near(*x, y, 1e-5));
    near(found[2], 3.3 - found[0], 1e-14);
    // To a held tip.
    let plates = plates(&mut Noise::new(9));
    let scene = chain!(plates);
    for offset in [-1.0, -0.3, 0.5] {
        let follows = Couplings::of(&scene, [Coupling::new("last", 2).ratio(RATIO).offset(offset)])?;
        let mut guess = scene.motion();
        guess.set_coordinates(&[0.92, 0.42, -1.96, -0.6])?;
        let found = scene.assembled(guess, &follows)?.coordinates();
        near(found[3], RATIO * found[1] + offset, 1e-13);
    }
    Ok(())
}

#[test]
fn what_cannot_be_joined_says_so() -> Result<(), Error> {
    let (scene, _) = symmetric!();
    let couplings = Couplings::of(&scene, [Coupling::new("right", "left").offset(9.0)])?;
    let mut start = scene.motion();
    start.set_coordinates(&coordinates(1.3, 0.0)[0])?;
    let fault = scene.assembled(start, &couplings).map_err(|error| error.fault);
    assert!(matches!(fault, Err(Fault::NotClosed { residual }) if residual > 0.1), "{fault:?}");
    Ok(())
}

/// An arm of space whose links are coupled, and whose tip the ground holds: of five joints less three closures and a coupling one is left.
#[test]
fn a_held_robot_with_a_coupling_keeps_its_energy() -> Result<(), Error> {
    use robot::*;
    let link = |x: f64| {
        Link::general(1.0 + x, [0.02, 0.03 * x, 0.2], [[0.06, 0.002, 0.0], [0.002, 0.05, 0.001], [0.0, 0.001, 0.02]])
    };
    let hinge = |z: f64| Hinge::at::<0b111>([0.05, -0.02, z]).turned(Quarter::<30>);
    let chain = (
        Hinge::level().grounded(),
        link(0.1),
        hinge(0.4),
        link(0.2),
        hinge(0.45),
        link(0.3),
        hinge(0.4),
        link(0.0),
        hinge(0.5),
        link(0.5),
    );
    let chain = (chain, Flange::at([0.03, 0.0, 0.3]));
    let scene =
        System::new(Base::origin(), chain, spatial::Pinned::at([0.3, 0.2, 0.9]))?.with_gravity([0.3, -0.2, -9.81]);
    let couplings = Couplings::of(&scene, [Coupling::by_coordinate(3, 2).ratio(0.6).offset(0.1)])?;
    let mut start = scene.motion();
    start.set_coordinates(&[0.2, 0.5, -0.8, 0.0, 0.4])?;
    start.set_rates(&[0.3, -0.2, 0.5, 0.0, 0.1])?;
    let start = scene.assembled(couplings.joined(start), &couplings)?;
    let mut drift = EnergyDrift::default();
    let mut missed = 0.0_f64;
    let run = scene.simulation(Dop853::tolerance(1e-12)).loads(&couplings).run(start, 1.0, |now| {
        drift.observe(now);
        let (q, v) = (now.motion().coordinates(), now.motion().rates());
        missed = missed.max((q[3] - 0.6 * q[2] - 0.1).abs()).max((v[3] - 0.6 * v[2]).abs());
    })?;
    println!("drift {:.1e} J, misses {missed:.1e}, {} steps", drift.largest(), run.steps);
    assert!(drift.largest() < 1e-9 && missed < 1e-12);
    Ok(())
}

/// A loop of two freedoms in an arm, one of whose cranks follows the arm's shoulder.
#[test]
fn a_loop_with_a_coupling_keeps_its_energy() -> Result<(), Error> {
    let (rod, j) = (|length: f64| Rod::uniform(length, 2.0 * length), Revolute::smooth());
    let chain = (j.named("shoulder"), RigidBody::new(1.0, 0.1, [0.3, 0.05], [0.6, 0.0]));
    let cranks = (j.named("crank"), rod(0.5), j, rod(0.7), j, rod(0.7), j, rod(0.5));
    let swing = ClosedLoop::ending_at([0.8, 0.0], cranks, Pin);
    let scene = System::new(Clamped::origin(), (chain, swing, j, rod(0.3)), Free)?.with_gravity(GRAVITY);
    let couplings = Couplings::of(&scene, [Coupling::new("crank", "shoulder").ratio(-1.5)])?;
    let mut start = scene.motion();
    start.set_coordinates(&[-0.6, 0.9, 0.3, -1.1, -0.9, 0.4])?;
    start.set_rates(&[1.0, 0.0, 0.5, 0.0, 0.0, -0.3])?;
    let start = scene.assembled(couplings.joined(start), &couplings)?;
    let numbers = [scene.joint("crank")?, scene.joint("shoulder")?];
    let (mut drift, mut missed) = (EnergyDrift::default(), 0.0_f64);
    scene.simulation(Dop853::tolerance(1e-12)).loads(&couplings).run(start, 1.0, |now| {
        drift.observe(now);
        let [crank, shoulder] = numbers.map(|joint| now.motion().coordinates_of::<1>(joint).map_or(f64::NAN, |[x]| x));
        let off = (crank + 1.5 * shoulder).abs();
        missed = if off <= missed { missed } else { off };
    })?;
    println!("drift {:.1e} J, misses {missed:.1e}", drift.largest());
    assert!(drift.largest() < 1e-9 && missed < 1e-13);
    Ok(())
}

/// Arms whose first joint rubs come to rest, as events find it and as time stepping does.
#[test]
fn arms_that_rub_come_to_rest_together() -> Result<(), Error> {
    let (scene, couplings) = symmetric!(Coulomb::new(Revolute::smooth(), 8.0)); // (N·m)
    let mut start = scene.motion();
    let [q, v] = coordinates(1.2, -1.0);
    start.set_coordinates(&q)?;
    start.set_rates(&v)?;
    let start = scene.assembled(start, &couplings)?;
    let mut ends = vec![];
    for stepped in [false, true] {
        let mut missed = 0.0_f64;
        let mut observe = |q: Vec<f64>| missed = missed.max((q[3] - q[1]).abs());
        let end = if stepped {
            let run = scene.simulation(MoreauJean::step(1e-4)).loads(&couplings);
            run.run(start, 3.0, |now| observe(now.stepped().coordinates()))?.motion
        } else {
            let run = scene.simulation(Dop853::tolerance(1e-9)).loads(&couplings);
            run.run(start, 3.0, |now| observe(now.stepped().coordinates()))?.motion
        };
        println!("{:?}, misses {missed:.1e}", end.coordinates());
        assert!(missed < 1e-12 && end.rates().iter().all(|rate| rate.abs() < 1e-12));
        ends.push(end.coordinates());
    }
    // Time stepping is of order one: 1e-4 s at some rad/s.
    ends[0].iter().zip(&ends[1]).for_each(|(x, y)| near(*x, *y, 2e-3));
    Ok(())
}

#[test]
fn friction_holds_what_weighs_on_all_links() -> Result<(), Error> {
    let (scene, couplings) = symmetric!(Coulomb::new(Revolute::smooth(), 100.0)); // (N·m)
    let mut start = scene.motion();
    start.set_coordinates(&coordinates(0.5, 0.0)[0])?;
    let start = scene.assembled(start, &couplings)?;
    let torque = scene.stations(&start, &couplings)?.joint(scene.joint(1)?).expect("a station").internal.torque;
    let [[_, above], [_, below]] = [energies(0.5 + 1e-4), energies(0.5 - 1e-4)];
    near(-torque, (above - below) / 2e-4, 1e-6);
    start.accelerations().iter().for_each(|a| near(*a, 0.0, 1e-13));
    Ok(())
}

/// A run over numbers with derivatives, by the offset of the coupling and the rate of the start, its assembly included.
#[test]
fn derivatives_go_forward() -> Result<(), Error> {
    type T = Jet<f64, 2>;
    fn end<T: Scalar<Real = f64>>(offset: T, rate: T) -> Result<[T; 2], Error> {
        let number = |x: f64| T::constant(x);
        let bar = |k: usize, length| {
            let [mass, inertia, at] = BARS[k].map(number);
            RigidBody::new(mass, inertia, [at, number(0.0)], [number(length), number(0.0)])
        };
        let ([a, c], j) = (LINKS, Revolute::smooth());
        let chain = (j, bar(0, a), j.named("left"), bar(1, c), j, bar(2, c), j.named("right"), bar(3, a));
        let root = Clamped::at(number(0.0), number(0.0), number(0.0));
        let scene = System::new(root, chain, Pinned::at(number(BASE), number(0.0)))?.with_gravity(number(GRAVITY));
        let couplings = Couplings::of(&scene, [Coupling::new("right", "left").ratio(number(1.0)).offset(offset)])?;
        let mut start = scene.motion();
        let [q, _] = coordinates(1.3, 0.0);
        start.set_coordinates(&q.map(number))?;
        start.set_rates(&[rate, number(0.0), number(0.0), number(0.0)])?;
        let start = scene.assembled(couplings.joined(start), &couplings)?;
        let end = scene.simulation(Rk4::step(0.01)).loads(&couplings).run(start, 0.5, |_| ())?.motion;
        Ok([end.coordinates()[0], end.rates()[1]])
    }
    let seeded = |x: f64, k: usize| T { re: x, eps: std::array::from_fn(|i| f64::from(u8::from(i == k))) };
    let ([offset, rate], h) = ([0.05, -0.4], 1e-5);
    let found = end(seeded(offset, 0), seeded(rate, 1))?;
    let by = |d: [f64; 2]| -> Result<[f64; 2], Error> {
        let [above, below] = [1.0, -1.0].map(|sign| end(offset + sign * d[0], rate + sign * d[1]));
        let (above, below) = (above?, below?);
        Ok(std::array::from_fn(|i| (above[i] - below[i]) / (2.0 * h)))
    };
    for (k, expected) in [by([h, 0.0])?, by([0.0, h])?].into_iter().enumerate() {
        for (found, expected) in found.iter().zip(expected) {
            println!("{k}: {} {expected}", found.eps[k]);
            // Central differences err by h² and by a rounding over h, 1e-11.
            near(found.eps[k], expected, 1e-7 * (1.0 + expected.abs()));
        }
    }
    Ok(())
}
