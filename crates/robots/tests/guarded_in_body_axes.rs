//! Joints of robots that stick, slip and strike stops: sweeps and shocks against a dense robot, runs against the elements of inertial axes.

#[path = "../../../tests/it/robots/kit.rs"]
#[allow(dead_code)] // each test needs some of it
mod kit;

use catena::robot::*;
use catena_oracle::{Noise, near};
use kit::{GRAVITY, agree, body, flat, general, lean, list, plain_fixed, round};
use nalgebra::{DMatrix, DVector};

/// The tree of the kit with some joints of its own: on the ground, where an arm leaves, geared at the shoulder, geared along the slide.
macro_rules! tree {
    ($crank:expr, $side:expr, $shoulder:expr, $spindle:expr) => {{
        let (mid, bars) = (flat(3), [round(2), round(5)]);
        let bar = |k: usize| Link::<f64, 0b100, 0b111>::new(bars[k].0, bars[k].1, bars[k].2);
        let slide = Slide::at::<0b010>([0.0, 0.2, 0.0]).turned(Quarter::<8>);
        let arm = ($side(slide), general(body(1)), Hinge::at::<0b111>([0.1, -0.2, 0.3]), bar(0));
        let hinge = Hinge::at::<0b101>([0.3, 0.0, -0.1]).turned(Quarter::<30>).geared(0.2);
        let slide = Slide::at::<0b111>([0.1, 0.2, 0.15]).turned(Turned::by(lean())).geared(0.5);
        let tail = (
            $shoulder(hinge),
            Link::<f64, 0b110, 0b1111>::new(mid.0, mid.1, mid.2),
            Hinge::at::<0b001>([0.25, 0.0, 0.0]).turned(Leaning::by(0.6)),
            general(body(4)),
            $spindle(slide),
            bar(1),
        );
        let chain = ($crank(Hinge::level().grounded()), general(body(0)), Branch(arm), tail);
        System::new(Base::origin(), chain, Free)?.with_gravity(GRAVITY)
    }};
}

const FRICTION: [f64; 4] = [0.7, 0.5, 0.9, 0.4];
/// Those with friction, in the order of all joints.
const RUBBING: [usize; 4] = [0, 1, 3, 5];

#[test]
fn a_tree_slips_and_sticks_as_a_dense_one() -> Result<(), catena::Error> {
    let scene = tree!(
        |joint| Coulomb::new(joint, FRICTION[0]),
        |joint| Coulomb::new(joint, FRICTION[1]),
        |joint| Coulomb::new(joint, FRICTION[2]).with(Spring::damping(0.3)),
        |joint| Coulomb::new(joint, FRICTION[3]).with(Spring::damping(0.4))
    );
    let (robot, mut noise) = (plain_fixed(), Noise::new(11));
    for sticking in (0..16).cycle().take(160) {
        let (q, mut v): ([f64; 6], [f64; 6]) = (list(&mut noise, 2.0), list(&mut noise, 2.0));
        let sticks = |k: usize| RUBBING.iter().position(|joint| *joint == k).is_some_and(|k| sticking >> k & 1 == 1);
        (0..6).filter(|k| sticks(*k)).for_each(|k| v[k] = 0.0);
        let mut start = scene.motion();
        start.set_coordinates(&q)?;
        let motion = scene.with_accelerations(scene.with_rates(start, &v)?, &Unloaded)?;

        let now = robot.at(&q, &v);
        let loose: Vec<usize> = (0..6).filter(|k| !sticks(*k)).collect();
        let force = |k: usize| {
            let rubs = RUBBING.iter().position(|joint| *joint == k).map_or(0.0, |i| FRICTION[i] * v[k].signum());
            -now.bias[k] - robot.parts[k].damping * v[k] - rubs
        };
        let mass = DMatrix::from_fn(loose.len(), loose.len(), |i, k| now.mass[(loose[i], loose[k])]);
        let found =
            mass.lu().solve(&DVector::from_iterator(loose.len(), loose.iter().map(|k| force(*k)))).expect("mass");
        let mut expected = [0.0; 6];
        loose.iter().zip(&found).for_each(|(k, second)| expected[*k] = *second);
        agree(&motion.accelerations(), &expected, 1e-11);
        let budget = scene.budget(&motion)?;
        agree(&[budget.kinetic, budget.potential], &[now.kinetic, now.potential], 1e-13);
    }
    Ok(())
}

#[test]
fn a_tree_strikes_a_stop_as_a_dense_one() -> Result<(), Box<dyn std::error::Error>> {
    const RESTITUTION: f64 = 0.6;
    const SHORT: f64 = 1e-9; // (s)
    let none = |joint| joint;
    let (robot, mut noise) = (plain_fixed(), Noise::new(12));
    for _ in 0..20 {
        let (mut q, v): ([f64; 6], [f64; 6]) = (list(&mut noise, 2.0), list(&mut noise, 2.0));
        // The hinge at its upper stop, or at its lower one.
        let stops = if v[3] > 0.0 { [q[3] - 1.0, q[3]] } else { [q[3], q[3] + 1.0] };
        let scene = tree!(
            none,
            |joint| joint,
            |joint| HardStops::between(joint, stops).rebounding(RESTITUTION).with(Spring::damping(0.3)),
            |joint: Slide<f64, Turned<f64>, 0b111, Spring, f64>| joint.with(Spring::damping(0.4))
        );
        let after = robot.at(&q, &v).mass.lu().solve(&DVector::from_fn(6, |k, _| f64::from(k == 3))).expect("mass");
        let expected: Vec<f64> = (0..6).map(|k| v[k] - (1.0 + RESTITUTION) * v[3] * after[k] / after[3]).collect();
        q[3] -= v[3] * SHORT;
        let mut start = scene.motion();
        start.set_coordinates(&q)?;
        let end = scene.simulation(Rk4::step(SHORT)).run(scene.with_rates(start, &v)?, 4.0 * SHORT, |_| ())?.motion;
        agree(&end.rates(), &expected, 1e-6); // in what time is left, too
    }
    Ok(())
}

#[test]
fn runs_agree_with_those_in_inertial_axes() -> Result<(), Box<dyn std::error::Error>> {
    let turns = [[0.4, -0.7, 1.1], [0.2, 0.5, -0.3], [1.0, 0.1, 0.6]].map(Rotation::from_angles);
    let places = [[0.3, 0.0, -0.1], [0.1, 0.2, 0.15], [0.0, 0.1, 0.2]];
    let at = |k: usize| Hinge::at::<0b111>(places[k]).turned(Turned::by(turns[k]));
    let slide = Slide::at::<0b111>(places[1]).turned(Turned::by(turns[1]));
    let (friction, stops, spring) = ([12.0, 2.0], [-0.4, 0.5], Spring::stiffness(30.0));
    let chain = (
        Coulomb::new(Hinge::level().grounded(), friction[0]),
        general(body(0)),
        HardStops::between(at(0), stops).rebounding(0.5).with(Spring::damping(0.1)),
        general(body(1)),
        Coulomb::new(slide, friction[1]).with(spring),
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
        Coulomb::new(Revolute::about(z), friction[0]),
        rigid(0, 0),
        weld(0),
        HardStops::between(Revolute::about(z), stops).rebounding(0.5).with(Spring::damping(0.1)),
        rigid(1, 1),
        weld(1),
        Coulomb::new(Prismatic::along(z), friction[1]).with(spring),
        rigid(2, 2),
        weld(2),
        Revolute::about(z),
        rigid(4, 0),
    );
    let other = System::new(Clamped::origin(), chain, Free)?.with_gravity(GRAVITY);
    let (q, v) = ([0.2, 0.1, 0.0, -0.6], [0.8, 0.0, 0.3, 0.0]);
    macro_rules! agree_by {
        ($rule:expr, $tolerance:expr) => {{
            let (mut start, mut rests, mut reached) = (own.motion(), false, false);
            start.set_coordinates(&q)?;
            let end = own.simulation($rule).run(own.with_rates(start, &v)?, 1.0, |now| {
                let (q, v) = (now.motion().coordinates(), now.motion().rates());
                rests |= v[0] == 0.0;
                reached |= stops.iter().any(|stop| (q[1] - stop).abs() < 1e-9);
            })?;
            let mut start = other.motion();
            start.set_coordinates(&q)?;
            let right = other.simulation($rule).run(other.with_rates(start, &v)?, 1.0, |_| ())?.motion;
            assert!(rests && reached);
            for (x, y) in [(end.motion.coordinates(), right.coordinates()), (end.motion.rates(), right.rates())] {
                x.iter().zip(&y).for_each(|(x, y)| near(*x, *y, $tolerance));
            }
        }};
    }
    agree_by!(Dop853::tolerance(1e-10), 1e-8);
    agree_by!(Sdirk4::new().step(0.005), 1e-8);
    Ok(())
}
