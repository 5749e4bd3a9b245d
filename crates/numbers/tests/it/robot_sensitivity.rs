//! Derivatives through kept gains in body axes: against dual numbers through the same steps, part by part.

use super::sensitivities::{FIXED, Parts, ROUNDING, alike, as_dual_numbers, parts};
use catena::Error;
use catena::robot::*;
use catena::scalar::{Jet, Scalar};
use catena::spatial::{self, BodyMotion, GroundMotion, Moving, Pinned, Revolute, RigidBody, Rod, Wrench};
use num_dual::DualSVec64;

/// A turn by angles.
fn turn<N: Parts>(angles: [N; 3]) -> Turned<N> {
    Turned::by(Rotation::from_angles(angles))
}

/// A link of which everything is there, with seeds from `first` on: mass, mass centre, two moments, a product.
fn link<N: Parts>(x: impl Fn(f64, usize) -> N, first: usize) -> Link<N> {
    let product = x(0.004, first + 6);
    let tensor = [
        [x(0.05, first + 4), product, x(0.001, FIXED)],
        [product, x(0.06, first + 5), x(-0.002, FIXED)],
        [x(0.001, FIXED), x(-0.002, FIXED), x(0.03, FIXED)],
    ];
    Link::general(x(1.7, first), [x(0.02, first + 1), x(-0.03, first + 2), x(0.21, first + 3)], tensor)
}

/// Number `i` of a list without a pattern.
fn number(i: usize) -> f64 {
    (1.3 * i as f64 + 0.4).sin()
}

#[test]
fn hinges_and_slides_have_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("hinges and slides", 47 seeds, Rk4::step(0.01), 0.3, |x| {
        let o = x(0.0, FIXED);
        let first = Hinge::level().with(Spring::damping(x(0.3, 14))).geared(x(0.02, 15)).grounded();
        let second = Hinge::at::<0b011>([x(0.1, 16), x(0.4, 17), o]).turned(Quarter::<30>);
        let second = second.ahead(x(-0.3, 46)).with(Spring::stiffness(x(4.0, 18)));
        let slide = Slide::at::<0b111>([x(0.2, 19), x(-0.1, 20), x(0.3, 21)])
            .turned(turn([x(0.3, 22), x(-0.5, 23), x(0.2, 24)]))
            .with(Spring::stiffness(x(80.0, 25)).damped(x(3.0, FIXED)).resting_at(x(0.1, 26)))
            .geared(x(0.4, 27));
        let leaning = Hinge::at::<0b010>([o, x(0.25, 28), o]).turned(Leaning::by(x(0.7, 29))).ahead(x(0.4, 46));
        let plain = Slide::level().turned(Quarter::<2>).with(Spring::stiffness(x(50.0, FIXED)));
        let bare = link(&x, FIXED - 10).masked::<7, 63>();
        let thin = Link::<_, 0b100, 0b111>::new(x(0.8, 30), [o, o, x(0.3, 31)], {
            [[x(0.02, 32), o, o], [o, x(0.02, FIXED), o], [o, o, x(0.01, FIXED)]]
        });
        let arm = Branch((leaning, thin, plain, thin));
        let chain = (first, bare, second, link(&x, 7), arm, slide, link(&x, 0), leaning, bare);
        let system = System::new(Base::origin(), chain, Free)?.with_gravity([x(0.8, 33), o, -x(9.81, 34)]);
        let torques: [_; 6] = core::array::from_fn(|i| x(0.4 * number(i), if i == 2 { 35 } else { FIXED }));
        let mut motion = system.motion();
        motion.set_coordinates(&core::array::from_fn::<_, 6, _>(|i| x(number(i), if i < 5 { 36 + i } else { FIXED })))?;
        motion.set_rates(&core::array::from_fn::<_, 6, _>(|i| x(number(i + 9), if i < 5 { 41 + i } else { FIXED })))?;
        (system, motion, Torques(torques))
    });
    Ok(())
}

#[test]
fn robots_on_bodies_and_on_bases_that_move_have_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("on a body", 31 seeds, Dop853::tolerance(1e-9), 0.4, |x| {
        let o = x(0.0, FIXED);
        let tensor = [[x(0.3, 14), o, o], [o, x(0.25, FIXED), o], [o, o, x(0.2, FIXED)]];
        let body = RigidBody::new(x(1.3, 15), tensor, [x(0.4, 16), x(0.1, FIXED), o], [x(0.9, 17), x(-0.2, FIXED), o]);
        let rod = Rod::uniform(x(0.7, 18), x(0.3, FIXED), x(0.01, FIXED));
        let elbow = Hinge::at::<0b001>([x(0.3, 19), o, o]).turned(Quarter::<30>);
        const ABOUT_X: u32 = Turned::<f64>::code([[2, 1, 1], [1, 0, 0], [1, 0, 0]]);
        let lean = turn([x(0.4, FIXED), o, o]).known::<ABOUT_X>();
        let robot = (BodyAxes, Hinge::level().turned(lean), link(&x, 0), elbow, link(&x, 7), Branch((elbow, link(&x, FIXED - 10))));
        let joint = Revolute::about([x(0.1, 20), x(1.0, FIXED), x(0.3, FIXED)]);
        let shaken = x(0.1, 30);
        let ground = Moving(move |t: f64| GroundMotion {
            place: [shaken * N::literal((3.0 * t).sin()), o, o],
            velocity: [shaken * N::literal(3.0 * (3.0 * t).cos()), o, o],
            acceleration: [shaken * N::literal(-9.0 * (3.0 * t).sin()), o, o],
        });
        let system = System::new(Pinned::on(ground), (rod, joint, body, robot), Free)?.with_gravity([o, o, -x(9.81, 21)]);
        let numbers: [_; 7] = core::array::from_fn(|i| x(number(i), if i < 2 { 22 + i } else { FIXED }));
        let mut motion = system.at_rest(&numbers)?;
        let count = motion.rates().len();
        motion.set_rates(&(0..count).map(|i| x(number(i + 9), if i < 6 { 24 + i } else { FIXED })).collect::<Vec<_>>())?;
        (system, motion, Unloaded)
    });
    Ok(())
}

#[test]
fn robots_that_float_have_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("afloat", 37 seeds, Rk4::step(0.01), 0.3, |x| {
        let o = x(0.0, FIXED);
        let hip = |y: f64, seed| Hinge::at::<0b111>([x(0.3, seed), x(y, FIXED), o]).turned(Quarter::<30>).geared(x(0.01, FIXED));
        let knee = Hinge::at::<0b100>([o, o, x(0.3, 16)]).with(Spring::damping(x(0.1, FIXED)));
        let legs = [0, 1].map(|i| Branch((hip([0.2, -0.2][i], 14 + i), link(&x, 7), knee, link(&x, FIXED - 10))));
        let system = System::new(spatial::Free, (BodyAxes, link(&x, 0), legs), Free)?.with_gravity([o, o, -x(9.81, 17)]);
        let mut motion = system.motion();
        motion.position_mut().0.1 = Rotation::from_angles([x(0.3, 18), x(-0.4, FIXED), x(0.5, FIXED)]);
        let mut list = motion.coordinates();
        (0..4).for_each(|i| list[7 + i] = x(number(i), 19 + i));
        motion.set_coordinates(&list)?;
        motion.set_rates(&core::array::from_fn::<_, 10, _>(|i| x(number(i + 9), 23 + i)))?;
        let loads = Loads::none().on_bodies(move |time: f64, i, body: &BodyMotion<N>| {
            let push = body.force_at([o, x(0.1, 33), o], [x(2.0, 34), x(time, FIXED), -body.inboard.velocity.x]);
            if i == 2 { push } else { Wrench::torque([x(0.3, 35), o, body.inboard.turn.spin.z * x(-0.2, 36)]) }
        });
        (system, motion, loads)
    });
    Ok(())
}

#[test]
fn rods_that_float_have_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("rods afloat", 17 seeds, Rk4::step(0.01), 0.3, |x| {
        let o = x(0.0, FIXED);
        let rod = Rod::uniform(x(0.7, 0), x(0.3, 1), x(0.01, 2));
        let bob = spatial::PointMass::new(x(0.4, 3), x(0.3, 4));
        let arm = Branch((spatial::Ball, rod));
        let system = System::new(spatial::Free, (rod, arm, spatial::Ball, rod, bob), spatial::Free)?.with_gravity([o, o, -x(9.81, 5)]);
        let mut motion = system.at_rest(&core::array::from_fn::<_, 9, _>(|i| x(number(i), if i < 2 { 6 + i } else { FIXED })))?;
        motion.set_rates(&core::array::from_fn::<_, 12, _>(|i| x(number(i + 9), if i < 9 { 8 + i } else { FIXED })))?;
        (system, motion, Unloaded)
    });
    Ok(())
}

#[test]
fn rotors_have_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("rotors", 10 seeds, Rk4::step(0.01), 0.3, |x| {
        let o = x(0.0, FIXED);
        let whole = link(&x, FIXED - 10);
        let (upper, elbow, fore) = Rotor::new(x(3e-5, 0), x(100.0, 1)).between(whole, Hinge::at::<0b001>([x(0.4, 2), o, o]).turned(Quarter::<30>), whole)?;
        let chain = (Hinge::level().turned(Quarter::<30>).grounded(), upper, elbow, fore);
        let system = System::new(Base::origin(), chain, Free)?.with_gravity([o, o, -x(9.81, 3)]);
        let mut motion = system.motion();
        motion.set_coordinates(&[x(0.3, 4), x(-0.8, 5)])?;
        motion.set_rates(&[x(0.9, 6), x(1.4, 7)])?;
        (system, motion, Torques([x(0.3, 8), x(-0.2, 9)]))
    });
    Ok(())
}
