//! Accelerations, and their readings.

use super::kit::{Drift, agree, drift, fixed, floating, list, plain_fixed};
use catena::robot::*;
use catena::system::Rate;
use catena_oracle::Noise;

/// Efforts of joints, from the root's on: one of the ground, one that goes into body axes, the others.
fn efforts<const N: usize>(torques: &[f64]) -> [Effort<f64>; N] {
    std::array::from_fn(|k| Effort([k.checked_sub(2).map_or(0.0, |k| torques[k]), 0.0, 0.0]))
}

#[test]
fn accelerations_of_a_tree_on_the_ground() -> Result<(), catena::Error> {
    let (scene, plain, mut noise) = (fixed()?, plain_fixed(), Noise::new(1));
    for _ in 0..100 {
        let [q, v, torques]: [[f64; 6]; 3] = std::array::from_fn(|_| list(&mut noise, 2.0));
        let mut start = scene.motion();
        start.set_coordinates(&q)?;
        let start = scene.with_rates(start, &v)?;
        let moving = scene.with_accelerations(start, &Torques(torques))?;
        let (mut found, now) = (vec![], plain.at(&q, &v));
        moving.acceleration().visit(&mut |x: f64| found.push(x));
        agree(&found, plain.forward_dynamics(&q, &v, &torques).as_slice(), 1e-12);
        let budget = scene.budget(&moving)?;
        agree(&[budget.kinetic, budget.potential], &[now.kinetic, now.potential], 1e-13);
    }
    Ok(())
}

#[test]
fn accelerations_of_a_tree_that_floats() -> Result<(), catena::Error> {
    let (scene, mut noise) = (floating()?, Noise::new(2));
    for _ in 0..100 {
        let Drift { start, plain, q, v } = drift(&scene, &mut noise)?;
        let torques: [f64; 5] = list(&mut noise, 2.0);
        let moving = scene.with_accelerations(start, &Loads::none().efforts(efforts::<7>(&torques)))?;
        let (mut found, now) = (vec![], plain.at(&q, &v));
        moving.acceleration().visit(&mut |x: f64| found.push(x));
        let forces: Vec<f64> = [0.0; 6].into_iter().chain(torques).collect();
        agree(&found, plain.forward_dynamics(&q, &v, &forces).as_slice(), 1e-11);
        let budget = scene.budget(&moving)?;
        agree(&[budget.kinetic, budget.potential], &[now.kinetic, now.potential], 1e-13);
    }
    Ok(())
}

/// A serial arm in both ways of writing space: in body axes, and as joints, welds, massless distances and bodies in inertial axes.
mod serial {
    use crate::robots::kit::{GRAVITY, body, flat, lean};
    use catena::robot::*;

    type Arm = (
        BodyAxes,
        Hinge<f64>,
        Link<f64>,
        Hinge<f64, Quarter<30>, 0b101, Spring<Absent, f64>>,
        Link<f64, 0b110, 0b1111>,
        Slide<f64, Turned<f64>, 0b111>,
        Link<f64>,
    );
    pub type Local = System<f64, Clamped<[f64; 3], Rotation<f64>>, Arm, Free>;

    pub fn local() -> Result<Local, catena::Error> {
        let [(m, c, t), (n, d, u), (o, e, w)] = [body(0), flat(3), body(2)];
        let arm = (
            BodyAxes,
            Hinge::level(),
            Link::general(m, c, t),
            Hinge::at::<0b101>([0.3, 0.0, -0.1]).turned(Quarter::<30>).with(Spring::damping(0.3)),
            Link::new(n, d, u),
            Slide::at::<0b111>([0.1, 0.2, 0.15]).turned(Turned::by(lean())),
            Link::general(o, e, w),
        );
        Ok(System::new(Clamped::origin(), arm, Free)?.with_gravity(GRAVITY))
    }

    type Old = (
        Revolute<f64>,
        RigidBody<f64>,
        Weld<f64>,
        Revolute<f64, Spring<Absent, f64>>,
        RigidBody<f64>,
        Weld<f64>,
        Prismatic<f64>,
        RigidBody<f64>,
    );
    pub type Inertial = System<f64, Clamped<[f64; 3], Rotation<f64>>, Old, Free>;

    pub fn inertial() -> Result<Inertial, catena::Error> {
        let [(m, c, t), (n, d, u), (o, e, w)] = [body(0), flat(3), body(2)];
        let z = [0.0, 0.0, 1.0];
        // Quarter 30: x stays, y points along −z of the parent, z along y: a quarter about −x.
        let quarter = Weld::at(Rotation::from_angles([-core::f64::consts::FRAC_PI_2, 0.0, 0.0]));
        let arm = (
            Revolute::about(z),
            RigidBody::new(m, t, c, [0.3, 0.0, -0.1]),
            quarter,
            Revolute::about(z).with(Spring::damping(0.3)),
            RigidBody::new(n, u, d, [0.1, 0.2, 0.15]),
            Weld::at(lean()),
            Prismatic::along(z),
            RigidBody::new(o, w, e, [0.0; 3]),
        );
        Ok(System::new(Clamped::origin(), arm, Free)?.with_gravity(GRAVITY))
    }
}

#[test]
fn runs_agree_with_those_in_inertial_axes() -> Result<(), catena::Error> {
    let (local, inertial) = (serial::local()?, serial::inertial()?);
    let (q, v) = ([0.3, -0.4, 0.1], [0.5, -0.2, 0.3]);
    let first = local.simulate(local.at_joints(&q, &v)?, Dop853::tolerance(1e-13), 0.5, |_| ())?;
    let second = inertial.simulate(inertial.at_joints(&q, &v)?, Dop853::tolerance(1e-13), 0.5, |_| ())?;
    agree(&first.motion.coordinates(), &second.motion.coordinates(), 1e-12);
    // Forces at joints, too, in inertial axes: what the ground exerts on the first body, and energies.
    let [one, other] = [local.budget(&first.motion)?, inertial.budget(&second.motion)?];
    agree(&[one.kinetic, one.potential], &[other.kinetic, other.potential], 1e-11);
    let root = |internal: &Internal<f64>| [internal.force, internal.torque].map(|x| [x.x, x.y, x.z]).concat();
    let here = local.stations(&first.motion, &Unloaded)?;
    let there = inertial.stations(&second.motion, &Unloaded)?;
    agree(&root(&here.root().internal), &root(&there.root().internal), 1e-11);
    Ok(())
}

/// Gravity along and across a hinge, by hand.
#[test]
fn a_base_is_tilted_by_its_clamp_or_by_a_weld_on_it() -> Result<(), catena::Error> {
    let link = || Link::general(1.0, [1.0, 0.0, 0.0], [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]);
    let quarter = Rotation::from_angles([core::f64::consts::FRAC_PI_2, 0.0, 0.0]);
    let arm = || (BodyAxes, Hinge::level().grounded(), link());
    let clamped = System::new(Clamped::at([0.0; 3], quarter), arm(), Free)?.with_gravity([0.0, 0.0, -9.81]);
    let welded = System::new(Clamped::origin(), (Weld::at(quarter), arm()), Free)?.with_gravity([0.0, 0.0, -9.81]);
    let upright = System::new(Clamped::origin(), arm(), Free)?.with_gravity([0.0, 0.0, -9.81]);
    let mut found = vec![];
    clamped.with_accelerations(clamped.motion(), &Unloaded)?.acceleration().visit(&mut |x: f64| found.push(x));
    welded.with_accelerations(welded.motion(), &Unloaded)?.acceleration().visit(&mut |x: f64| found.push(x));
    upright.with_accelerations(upright.motion(), &Unloaded)?.acceleration().visit(&mut |x: f64| found.push(x));
    agree(&found, &[-9.81 / 1.1, -9.81 / 1.1, 0.0], 1e-15); // m g r / (J + m r²)
    Ok(())
}

#[test]
fn explicit_and_implicit_rules_run_robots() -> Result<(), catena::Error> {
    let scene = serial::local()?;
    let (q, v) = ([0.3, -0.4, 0.1], [0.5, -0.2, 0.3]);
    let start = scene.at_joints(&q, &v)?;
    let best = scene.simulate(start, Dop853::tolerance(1e-13), 0.2, |_| ())?.motion.coordinates();
    let worst = |found: Vec<f64>| found.iter().zip(&best).fold(0.0_f64, |most, (x, y)| most.max((x - y).abs()));
    let of = |rule: f64| -> Result<f64, catena::Error> {
        Ok(worst(scene.simulate(start, Rk4::step(rule), 0.2, |_| ())?.motion.coordinates()))
    };
    let points: Vec<(f64, f64)> =
        [0.02, 0.01, 0.005].into_iter().map(|step| Ok((step, of(step)?))).collect::<Result<_, catena::Error>>()?;
    catena_oracle::has_order("Rk4", 4.0, 1e-14, &points);
    let stiff: Vec<(f64, f64)> = [0.02, 0.01, 0.005]
        .into_iter()
        .map(|step| {
            Ok((step, worst(scene.simulate(start, Sdirk4::new().step(step), 0.2, |_| ())?.motion.coordinates())))
        })
        .collect::<Result<_, catena::Error>>()?;
    catena_oracle::has_order("Sdirk4", 4.0, 1e-14, &stiff);
    Ok(())
}

#[test]
fn energy_stays_where_nothing_takes_it() -> Result<(), catena::Error> {
    let (mass, centre, tensor) = super::kit::body(1);
    let link = Link::general(mass, centre, tensor);
    let elbow = Hinge::at::<0b101>([0.3, 0.0, -0.1]).turned(Quarter::<30>).geared(0.05);
    let scene = System::new(Clamped::origin(), (BodyAxes, Hinge::level(), link, elbow, link), Free)?
        .with_gravity(super::kit::GRAVITY);
    let start = scene.at_joints(&[0.3, -0.4], &[0.5, -0.2])?;
    let (mut first, mut worst) = (None, 0.0_f64);
    scene.simulate(start, Dop853::tolerance(1e-12), 5.0, |now| {
        let energy = now.energy();
        worst = worst.max((energy - *first.get_or_insert(energy)).abs());
    })?;
    // Of some 20 J that go to and fro.
    assert!(worst < 1e-10, "{worst}");
    Ok(())
}
