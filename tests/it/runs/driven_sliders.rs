//! Sliders in the plane under loads in joints: a drive pushes along the line, and a law sees how far and how fast it has slid.

use catena::Error;
use catena::loading::{Loading, Unloaded};
use catena::planar::*;
use catena_oracle::near;

/// Rounding of a few products.
const ROUNDING: f64 = 1e-13;

const CART: f64 = 2.0; // (kg)
const ROD: [f64; 2] = [0.8, 1.5]; // (m), (kg)
const GRAVITY: f64 = 9.81;

/// Accelerations of a cart pushed along a line in the direction `line` and of the rod that hangs from it, by the equations of Lagrange.
fn cart_and_rod(line: f64, push: f64, angle: f64, rate: f64) -> [f64; 2] {
    let ([length, mass], half) = (ROD, 0.5 * ROD[0]);
    let (along, turned) = ([line.cos(), line.sin()], [-angle.sin(), angle.cos()]);
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let coupling = mass * half * dot(along, turned);
    let [a, c] = [CART + mass, mass * length * length / 3.0];
    let sliding = push - a * GRAVITY * along[1] + mass * half * rate * rate * dot(along, [angle.cos(), angle.sin()]);
    let turning = -mass * GRAVITY * half * angle.cos();
    let determinant = a * c - coupling * coupling;
    [(c * sliding - coupling * turning) / determinant, (a * turning - coupling * sliding) / determinant]
}

fn cart() -> RigidBody<f64> {
    RigidBody::new(CART, 0.1, [0.0; 2], [0.0; 2])
}

fn rod() -> Rod<f64> {
    Rod::uniform(ROD[0], ROD[1])
}

#[test]
fn a_force_in_a_slider_accelerates_its_cart() -> Result<(), Error> {
    for (line, push, angle, rate) in [(0.0, 5.0, -1.2, 0.0), (0.4, -3.0, 0.7, 2.0), (2.5, 8.0, 3.0, -4.0)] {
        let track = Clamped::at(0.3, -0.2, 0.1); // the line turns with the ground
        let scene = System::new(track, (Slider::along(line - 0.1), cart(), Pin, rod()), Free)?.with_gravity(GRAVITY);
        let start = scene.with_rates(scene.at_rest(&[angle])?, &[0.6, rate])?;
        let want = cart_and_rod(line, push, angle, rate);
        let by_values = || -> Result<_, Error> {
            let loads = Loads::none().torques([0.0, push, 0.0]);
            let moving = scene.with_accelerations(start, &loads)?;
            // What the slider passes on along its line is what drives it.
            let force = scene.stations(&moving, &loads)?.get(0).unwrap().internal.force;
            near(force.x * line.cos() + force.y * line.sin(), push, 1e-12 * 50.0);
            let (_, (along, (), turning, ())) = moving.acceleration();
            Ok([*along, *turning])
        };
        let by_law = || -> Result<_, Error> {
            let law = |_: f64, joint, motion: &JointMotion<f64>| {
                if joint == 1 { push * motion.driven_rate() / 0.6 } else { 0.0 }
            };
            let moving = scene.with_accelerations(start, &Loads::none().in_joints(law))?;
            let (_, (along, (), turning, ())) = moving.acceleration();
            Ok([*along, *turning])
        };
        for found in [by_values()?, by_law()?] {
            for (found, want) in found.into_iter().zip(want) {
                near(found, want, ROUNDING * want.abs().max(10.0));
            }
        }
    }
    Ok(())
}

#[test]
fn the_joint_of_a_guided_root_is_driven_like_any_slider() -> Result<(), Error> {
    let scene = System::new(Guided::at(0.0, 0.0, 0.0), (cart(), Pin, rod()), Free)?.with_gravity(GRAVITY);
    let start = scene.with_rates(scene.at_rest(&[-0.9])?, &[0.0, 1.5])?;
    let loads = Loads::none().torques([5.0, 0.0]);
    let moving = scene.with_accelerations(start, &loads)?;
    let (along, ((), turning, ())) = *moving.acceleration();
    let want = cart_and_rod(0.0, 5.0, -0.9, 1.5);
    near(along, want[0], ROUNDING * 10.0);
    near(turning, want[1], ROUNDING * 10.0);
    // The plain product of transfer matrices, an independent way to the same accelerations.
    let root: catena::StateVector<f64, 7> = scene.root_state(&start, &loads)?;
    near(root[index::X], want[0], 1e-11);
    Ok(())
}

/// A force between two bodies pushes both, and momentum stays.
#[test]
fn a_force_between_two_bodies_acts_on_both() -> Result<(), Error> {
    let body = |mass: f64| RigidBody::new(mass, 0.2, [0.0; 2], [0.0; 2]);
    let scene = System::new(Free, (body(2.0), Slider::along(0.0), body(3.0)), Free)?;
    let loads = Loads::none().torques([0.0, 6.0]);
    let moving = scene.with_accelerations(scene.at_rest(&[0.7])?, &loads)?;
    let (_, ((), apart, ())) = *moving.acceleration();
    near(apart, 6.0 / 2.0 + 6.0 / 3.0, ROUNDING * 5.0);
    let bodies = scene.body_motions(&moving)?;
    let push = |k: usize, mass: f64| bodies.get(k).unwrap().centre().acceleration.linear * mass;
    near((push(0, 2.0) + push(1, 3.0)).norm(), 0.0, ROUNDING * 6.0);
    Ok(())
}

#[test]
fn a_law_sees_how_far_and_how_fast_a_joint_has_moved() -> Result<(), Error> {
    let springs = ElasticHinge::rotary(1.0).with_linear(Spring::new(5.0), Spring::new(7.0));
    let chain = (Slider::along(0.3), cart(), Pin, rod(), springs, rod());
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), chain, Free)?;
    let mut start = scene.with_rates(scene.motion(), &[0.5, -2.0, 0.01, 0.02, 3.0])?;
    *start.position_mut() = ((), (1.25, (), 0.4, (), (0.1, -0.2, 0.6), ()));
    let seen = core::cell::RefCell::new(vec![]);
    let law = |_: f64, _, motion: &JointMotion<f64>| {
        let driven = [motion.driven(), motion.driven_rate()];
        seen.borrow_mut().push((driven, motion.slide, motion.sliding));
        0.0
    };
    scene.with_accelerations(start, &Loads::none().in_joints(law))?;
    let none = [0.0; 2];
    let want = [
        (none, none, none), // the weld of the root
        ([1.25, 0.5], [1.25, 0.0], [0.5, 0.0]),
        ([0.4, -2.0], none, none),
        ([0.6, 3.0], [0.1, -0.2], [0.01, 0.02]),
    ];
    let seen = seen.into_inner();
    assert_eq!(seen.len(), want.len());
    for ((driven, slide, sliding), (want, displaced, moving)) in seen.into_iter().zip(want) {
        assert_eq!((slide, sliding), (displaced, moving));
        near(driven[0], want[0], 1e-15);
        near(driven[1], want[1], 1e-15);
    }
    Ok(())
}

/// A cart alone under a constant force: s = F t² / 2 m, which every rule of order two or more meets.
#[test]
fn every_rule_takes_the_drive() -> Result<(), Error> {
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), (Slider::along(0.0), cart()), Free)?;
    let loads = Loads::none().torques([0.0, 5.0]);
    let want = 5.0 / (2.0 * CART);
    let run = |s: f64| near(s, want, 1e-12);
    let start = scene.motion();
    run(scene.simulation(Rk4::step(0.1)).loads(&loads).run(start, 1.0, |_| ())?.motion.position().1.0);
    run(scene.simulation(Dop853::tolerance(1e-9)).loads(&loads).run(start, 1.0, |_| ())?.motion.position().1.0);
    run(scene
        .simulation(GeneralizedAlpha::new(0.8).step(0.1))
        .loads(&loads)
        .run(start, 1.0, |_| ())?
        .motion
        .position()
        .1
        .0);
    run(scene.simulation(Sdirk4::new().step(0.1)).loads(&loads).run(start, 1.0, |_| ())?.motion.position().1.0);
    Ok(())
}

/// Without a drive nothing changes.
#[test]
fn no_drive_is_a_drive_of_nothing() -> Result<(), Error> {
    fn accelerations<L: Loading<Planar<f64>>>(loads: &L) -> Result<[f64; 2], Error>
    where
        System<f64, Clamped<[f64; 2], f64>, (Slider<f64>, RigidBody<f64>, Pin, Rod<f64>), Free>: catena::system::Runs<
                L,
                Planar<f64>,
                Clamped<[f64; 2], f64>,
                (Slider<f64>, RigidBody<f64>, Pin, Rod<f64>),
                Free,
            >,
    {
        let scene = System::new(Clamped::at(0.0, 0.0, 0.0), (Slider::along(0.5), cart(), Pin, rod()), Free)?;
        let scene = scene.with_gravity(GRAVITY);
        let moving = scene.with_accelerations(scene.with_rates(scene.at_rest(&[0.3])?, &[1.0, 2.0])?, loads)?;
        let (_, (along, (), turning, ())) = *moving.acceleration();
        Ok([along, turning])
    }
    assert_eq!(accelerations(&Unloaded)?, accelerations(&Loads::none().torques([0.0; 3]))?);
    Ok(())
}
