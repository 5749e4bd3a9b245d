//! Derivatives through kept gains in space: against dual numbers through the same steps, part by part.

use super::sensitivities::{FIXED, Parts, ROUNDING, alike, as_dual_numbers, parts};
use catena::Error;
use catena::scalar::Jet;
use catena::spatial::*;
use num_dual::DualSVec64;

#[test]
fn balls_and_bodies_have_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("balls", 26 seeds, Rk4::step(0.01), 0.3, |x| {
        let tensor = [
            [x(0.30, 0), x(0.02, FIXED), x(-0.03, FIXED)],
            [x(0.02, FIXED), x(0.25, 1), x(0.01, FIXED)],
            [x(-0.03, FIXED), x(0.01, FIXED), x(0.2, 2)],
        ];
        let centre = [x(0.4, 3), x(0.15, 4), x(-0.1, 5)];
        let body = RigidBody::new(x(1.3, 6), tensor, centre, [x(0.9, 7), x(-0.2, 8), x(0.1, 9)]);
        let rod = Rod::uniform(x(0.7, 10), x(0.3, 11), x(0.8, 12));
        let bob = PointMass::new(x(0.4, 13), x(0.3, 14));
        let root = Pinned::at([x(0.0, FIXED), x(0.0, FIXED), x(0.0, FIXED)]);
        let system = System::new(root, (body, Ball, rod, bob), Free)?.with_gravity([x(0.0, FIXED), -x(9.81, 15), x(0.0, FIXED)]);
        let angles = [x(0.3, 16), x(-0.4, 17), x(0.9, 18), x(0.1, FIXED), x(0.5, 19), x(-0.6, 20)];
        let rates = [x(0.3, 22), x(-0.4, 23), x(0.9, 24), x(0.1, 21), x(0.5, 25), x(-0.6, FIXED)];
        let start = system.with_rates(system.at_rest(&angles)?, &rates)?;
        (system, start, Unloaded)
    });
    Ok(())
}

#[test]
fn slides_have_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("slides", 23 seeds, Rk4::step(0.01), 0.4, |x| {
        let rod = Rod::uniform(x(0.7, 0), x(0.3, 1), x(0.8, 2));
        let o = x(0.0, FIXED);
        let tensor = [[x(0.3, 3), o, o], [o, x(0.25, 4), o], [o, o, x(0.2, 5)]];
        let body = RigidBody::new(x(1.3, 6), tensor, [x(0.4, 7), x(0.15, 8), x(-0.1, 9)], [x(0.9, 10), x(-0.2, 11), x(0.1, FIXED)]);
        let track = Prismatic::along([x(0.2, 12), x(0.3, 13), x(0.9, 14)])
            .with(Spring::stiffness(x(20.0, 15)));
        let (spindle, bob) = (Prismatic::along([x(0.0, FIXED), x(1.0, 16), x(0.4, FIXED)]), PointMass::new(x(0.4, 17), x(0.3, FIXED)));
        let turning = Revolute::about([x(0.1, FIXED), x(1.0, FIXED), x(0.3, FIXED)]);
        let arm = Branch((turning, rod, spindle, bob));
        let chain = (track, body, turning, rod, arm, spindle, body, Ball, rod);
        let system = System::new(Clamped::origin(), chain, Free)?.with_gravity([o, -x(9.81, 18), o]);
        let mut start = system.motion();
        let numbers = [0.3, -0.4, 0.7, 0.2, 0.35];
        let rates = [0.6, -0.9, 1.4, -0.3, 0.8, 0.7, -1.1, 0.4];
        let mut list = start.coordinates();
        (0..5).for_each(|i| list[i] = x(numbers[i], if i == 4 { 19 } else { FIXED }));
        start.set_coordinates(&list)?;
        start.set_rates(&core::array::from_fn::<_, 8, _>(|i| x(rates[i], if i < 2 { 20 + i } else { FIXED })))?;
        let efforts: [_; 7] = core::array::from_fn(|i| {
            Effort([x(0.2 * i as f64 - 0.5, if i == 5 { 22 } else { FIXED }), x(0.1, FIXED), o])
        });
        (system, start, Loads::none().efforts(efforts))
    });
    Ok(())
}

#[test]
fn axes_and_their_springs_have_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("axes", 24 seeds, Dop853::tolerance(1e-9), 0.5, |x| {
        let rod = Rod::uniform(x(0.7, 0), x(0.3, 1), x(0.8, 2));
        let centre = [x(0.4, 3), x(0.15, 4), x(-0.1, 5)];
        let tensor = [[x(0.3, 6), x(0.0, FIXED), x(0.0, FIXED)], [x(0.0, FIXED), x(0.25, 7), x(0.0, FIXED)], [x(0.0, FIXED), x(0.0, FIXED), x(0.2, 8)]];
        let body = RigidBody::new(x(1.3, 9), tensor, centre, [x(0.9, 10), x(-0.2, 11), x(0.1, 12)]);
        let sprung = Revolute::about([x(0.2, 13), x(0.3, 14), x(0.9, 15)]).with(Spring::stiffness(x(20.0, 16)));
        let cardan = Universal::about([x(0.1, FIXED), x(1.0, 17), x(0.0, FIXED)], [x(0.2, 18), x(0.0, FIXED), x(1.0, FIXED)])
            .with(Spring::stiffness(x(3.0, 19)), Spring::stiffness(x(4.0, FIXED)));
        let chain = (sprung, body, cardan, rod, Weld::at(Rotation::from_angles([x(0.3, FIXED), x(0.2, 20), x(0.1, FIXED)])), rod, Ball, rod);
        let system = System::new(Clamped::origin(), chain, Free)?.with_gravity([x(0.0, FIXED), -x(9.81, FIXED), x(0.0, FIXED)]);
        let angles = [x(0.3, FIXED), x(-0.4, 21), x(0.9, 22), x(0.1, FIXED), x(0.5, FIXED), x(-0.6, FIXED)];
        let rates = [x(0.8, FIXED), x(-0.4, FIXED), x(0.9, 23), x(0.1, FIXED), x(0.5, FIXED), x(-0.6, FIXED)];
        let start = system.with_rates(system.at_rest(&angles)?, &rates)?;
        (system, start, Unloaded)
    });
    Ok(())
}
