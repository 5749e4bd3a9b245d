//! Gradients of runs of which few states are kept.

use super::names::*;
use catena::Fault;
use catena::sensitivity::{Checkpoints, Costate};

/// Numbers by which a gradient is told from another one to the last bit.
fn bits(list: impl IntoIterator<Item = f64>) -> Vec<u64> {
    list.into_iter().map(f64::to_bits).collect()
}

#[test]
fn few_states_have_the_gradient_of_all_bit_for_bit() {
    let rod = Rod::uniform(0.8_f64, 1.3);
    let hinge = ElasticHinge::rotary(4.0).damped(0.2);
    let system = System::new(Pinned::origin(), (rod, hinge, rod, Pin, rod), Free).unwrap().with_gravity(9.81);
    let start = system.at_rest(&[-1.0, -0.5, 0.3]).unwrap();
    let (steps, h) = (23, 0.02);
    let torques: Vec<f64> = (0..3 * steps).map(|k| (0.7 * k as f64).sin()).collect();
    let mut backward = system.backward(Rk4);
    let (mut states, mut by_torques) = (vec![start; steps + 1], vec![0.0; 3 * steps]);
    backward.run(&start, h, steps, &torques, &mut states).unwrap();
    let end = states[steps].coordinates();
    // Reads all of each state, its accelerations too.
    let cost = |_: usize, by: &mut Costate<_>, q: Vec<f64>, v: Vec<f64>, a: Vec<f64>| {
        by.add(&q, &[v[0] + a[0], v[1], v[2] - a[2]])
    };
    macro_rules! cost {
        () => {
            |k: usize, state: &_, by: &mut Costate<_>| {
                let state: &catena::Motion<_, _> = state;
                cost(k, by, state.coordinates(), state.rates(), state.accelerations())
            }
        };
    }
    let all = backward.gradient(&torques, &states, &mut by_torques, cost!()).unwrap();
    let lifted = system.lift(Jet::<f64, 1>::of).with_gravity(Jet::seed(9.81, 0));
    let list = |gradient: &catena::sensitivity::Gradient<Planar<f64>, _>, by_torques: &[f64]| {
        let [along] = gradient.along(&lifted).unwrap();
        let each = gradient.by_position().into_iter().chain(gradient.by_rate());
        bits(each.chain(by_torques.to_vec()).chain([along]))
    };
    let expected = list(&all, &by_torques);
    for every in [1, 5, 7, 22, 23, 40] {
        let plan = Checkpoints { step: h, steps, every };
        let (mut few, mut tape) = (vec![start; plan.states()], vec![backward.tape(); every.min(steps)]);
        let mut by_torques = vec![0.0; 3 * steps];
        backward.run_between(&start, plan, &torques, &mut few).unwrap();
        assert_eq!(bits(few[few.len() - 1].coordinates()), bits(end.clone()));
        let found = backward.gradient_between(plan, &torques, &few, &mut tape, &mut by_torques, cost!()).unwrap();
        assert_eq!(list(&found, &by_torques), expected, "every {every}");
    }
    // States in two levels, and a tape that is shorter.
    for (every, length) in [(7, 3), (22, 5), (23, 1), (40, 22), (5, 9)] {
        let plan = Checkpoints { step: h, steps, every };
        let (mut few, mut tape) = (vec![start; plan.states()], vec![backward.tape(); length]);
        let (mut middle, mut by_torques) = (vec![start; every.div_ceil(length)], vec![0.0; 3 * steps]);
        backward.run_between(&start, plan, &torques, &mut few).unwrap();
        let found = backward
            .gradient_in_levels(plan, &torques, &few, &mut middle, &mut tape, &mut by_torques, cost!())
            .unwrap();
        assert_eq!(list(&found, &by_torques), expected, "every {every}, {length} on the tape");
    }
    // All on the tape, which has room to spare.
    let (mut tape, mut last, mut by_torques) = (vec![backward.tape(); 30], start, vec![0.0; 3 * steps]);
    backward.run_on_tape(&start, h, steps, &torques, &mut tape, &mut last).unwrap();
    assert_eq!(bits(last.coordinates()), bits(end));
    let found = backward.gradient_on_tape(steps, &tape, &last, &mut by_torques, cost!()).unwrap();
    assert_eq!(list(&found, &by_torques), expected);
}

/// Lists that are too short say how long they must be.
#[test]
fn checkpoints_and_tape_say_how_many_are_needed() {
    let rod = Rod::uniform(1.0_f64, 1.0);
    let system = System::new(Pinned::origin(), (rod, Pin, rod), Free).unwrap();
    let start = system.at_rest(&[-1.0, -0.5]).unwrap();
    let mut backward = system.backward(Rk4);
    let plan = Checkpoints { step: 0.01, steps: 100, every: 7 };
    assert_eq!(plan.states(), 16);
    let found = backward.run_between(&start, plan, &[], &mut [start; 15]).unwrap_err().fault;
    assert!(matches!(found, Fault::Count { expected: 16, given: 15, .. }), "{found:?}");
    let found = backward.run_between(&start, plan, &[0.0; 199], &mut [start; 16]).unwrap_err().fault;
    assert!(matches!(found, Fault::Count { expected: 200, given: 199, .. }), "{found:?}");
    let mut tape = vec![backward.tape(); 6];
    let gradient = backward.gradient_between(plan, &[], &[start; 16], &mut tape, &mut [], |_, _, _| Ok(()));
    let found = gradient.map(|_| ()).unwrap_err().fault;
    assert!(matches!(found, Fault::Count { expected: 7, given: 6, .. }), "{found:?}");
    let gradient =
        backward.gradient_in_levels(plan, &[], &[start; 16], &mut [start], &mut tape, &mut [], |_, _, _| Ok(()));
    let found = gradient.map(|_| ()).unwrap_err().fault;
    assert!(matches!(found, Fault::Count { expected: 2, given: 1, .. }), "{found:?}");
    let mut end = start;
    let found = backward.run_on_tape(&start, 0.01, 7, &[], &mut tape, &mut end).unwrap_err().fault;
    assert!(matches!(found, Fault::Count { expected: 7, given: 6, .. }), "{found:?}");
    let found = backward.run_on_tape(&start, f64::NAN, 6, &[], &mut tape, &mut end).unwrap_err().fault;
    assert!(matches!(found, Fault::NotPositive { parameter: "step size", .. }), "{found:?}");
}

/// A million steps of twenty rods by RK4, all that is kept of them.
#[test]
fn a_million_steps_take_less_than_a_megabyte() {
    let rod = Rod::uniform(1.0_f64, 1.0);
    let system = System::new(Pinned::origin(), (rod, [(Pin, rod); 19]), Free).unwrap();
    let (plan, middle, tape) = (Checkpoints { step: 1e-4, steps: 1_000_000, every: 5000 }, 200, 25);
    assert!(middle * tape >= plan.every);
    let states = (plan.states() + middle) * size_of_val(&system.motion());
    let bytes = states + tape * size_of_val(&system.backward(Rk4).tape());
    println!("{} kB", bytes / 1000);
    assert!(bytes < 1_000_000);
}
