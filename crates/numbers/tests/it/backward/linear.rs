//! Jacobians of steps.

use super::names::*;
use catena::Fault;

#[test]
fn steps_have_the_jacobians_of_jets() {
    type J = Jet<f64, 9>;
    let rod = Rod::uniform(0.8_f64, 1.3);
    let hinge = ElasticHinge::rotary(4.0).damped(0.2);
    let system = System::new(Pinned::origin(), (rod, hinge, rod, Pin, rod), Free).unwrap().with_gravity(9.81);
    let mut now = system.at_rest(&[-1.0, -0.5, 0.3]).unwrap().at_time(0.7);
    now.set_rates(&[0.5, -1.0, 0.8]).unwrap();
    let (torques, h) = ([0.3, -0.8, 0.2], 0.04);
    let (mut next, mut a, mut b) = (now, [0.0; 36], [0.0; 18]);
    let mut backward = system.backward(Dopri5);
    backward.linearised_step(&now, h, &torques, &mut next, &mut a, &mut b).unwrap();
    let lifted = system.lift(J::of);
    let start = lifted.with_seeds(now.lift(J::of), 0);
    let seeded: Vec<J> = (0..3).map(|i| J::seed(torques[i], 6 + i)).collect();
    let mut end = start;
    lifted.stepper(Dopri5).step(&start, &Loads::none().torques(seeded), h, &mut end).unwrap();
    let rows: Vec<J> = end.coordinates().into_iter().chain(end.rates()).collect();
    let (values, found): (Vec<f64>, Vec<f64>) =
        (rows.iter().map(|x| x.re).collect(), next.coordinates().into_iter().chain(next.rates()).collect());
    found.iter().zip(values).for_each(|(found, value)| near(*found, value, 1e-14));
    assert_eq!(next.time(), end.time());
    // Blocks: positions and rates by positions, by rates, by torques.
    for (name, top) in [("positions", 0), ("rates", 3)] {
        let block = |of: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
            (0..9).flat_map(|column| (top..top + 3).map(move |row| (row, column))).map(|(r, c)| of(r, c)).collect()
        };
        let found = block(&|r, c| if c < 6 { a[6 * r + c] } else { b[3 * r + c - 6] });
        let expected = block(&|r, c| rows[r].eps[c]);
        alike(name, &[("by positions", 9), ("by rates", 9), ("by torques", 9)], &found, &expected, ROUNDING);
    }
    // Without torques, and without asking for their part.
    let (mut still, mut other) = ([0.0; 36], next);
    backward.linearised_step(&now, h, &[0.0; 3], &mut next, &mut still, &mut b).unwrap();
    backward.linearised_step(&now, h, &[], &mut other, &mut a, &mut []).unwrap();
    assert!(still == a && next.coordinates() == other.coordinates());
    let mut fault =
        |a: &mut [f64], b: &mut [f64]| backward.linearised_step(&now, h, &[], &mut next, a, b).unwrap_err().fault;
    let found = fault(&mut [0.0; 35], &mut []);
    assert!(matches!(found, Fault::Count { expected: 36, given: 35, .. }), "{found:?}");
    let found = fault(&mut [0.0; 36], &mut [0.0; 17]);
    assert!(matches!(found, Fault::Count { expected: 18, given: 17, .. }), "{found:?}");
}

/// However late it is, a step has the size that it is given, as a stepper's; runs refuse steps that the clock rounds away.
#[test]
fn late_steps_are_as_long_as_early_ones() {
    let rod = Rod::uniform(1.0_f32, 1.0);
    let system = System::new(Pinned::origin(), (rod, Pin, rod), Free).unwrap().with_gravity(9.81);
    let early = system.with_rates(system.at_rest(&[0.3, 1.0]).unwrap(), &[0.4, -1.0]).unwrap();
    let mut backward = system.backward(Rk4);
    let mut linear = |time: f32| {
        let (mut next, mut a) = (early, [0.0; 16]);
        backward.linearised_step(&early.at_time(time), 5e-4, &[], &mut next, &mut a, &mut []).unwrap();
        (next.coordinates(), next.rates(), a)
    };
    assert_eq!(linear(20_000.0), linear(0.0));
    let (late, mut states) = (early.at_time(20_000.0), [early; 6]);
    let refused = backward.run(&late, 5e-4, 5, &[], &mut states).unwrap_err().fault;
    assert!(matches!(refused, Fault::OutOfRange { parameter: "step size", .. }), "{refused:?}");
}

/// What is no number is said of what it is of, and of when that is.
#[test]
fn numbers_that_are_none_are_named() {
    let rod = Rod::uniform(1.0_f64, 1.0);
    let system = System::new(Pinned::origin(), (rod, Pin, rod), Free).unwrap().with_gravity(9.81);
    let start = system.at_rest(&[0.3, 1.0]).unwrap().at_time(3.0);
    let mut backward = system.backward(Rk4);
    let (mut next, mut a, mut states) = (start, [0.0; 16], [start; 4]);
    let found = backward.linearised_step(&start, 0.01, &[0.0, f64::NAN], &mut next, &mut a, &mut []).unwrap_err();
    assert_eq!(
        (found.fault, found.time, found.place),
        (Fault::NonFiniteLoad, Some(3.0), Some(catena::Place::Station(1)))
    );
    let torques = [0.0, 0.0, 0.0, 0.0, f64::INFINITY, 0.0];
    let found = backward.run(&start, 0.5, 3, &torques, &mut states).unwrap_err();
    assert_eq!((found.fault, found.time, found.place), (Fault::NonFiniteLoad, Some(4.0), Some(catena::Place::Root)));
    let lost = system.with_rates(start, &[0.0, 1.0]).unwrap();
    let mut lost = lost;
    lost.rate_mut().0 = f64::NAN;
    let found = backward.linearised_step(&lost, 0.01, &[], &mut next, &mut a, &mut []).unwrap_err();
    assert_eq!((found.fault, found.time), (Fault::NonFiniteMotion, Some(3.0)));
}
