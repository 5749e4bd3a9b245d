//! Gradients in space at singular attitudes, from tapes, and by way of Jacobians.

use super::ROUNDING;
use catena::scalar::Jet;
use catena::spatial::*;
use catena::system::{Position, Rate};
use catena_oracle::near;

/// At rest and straight, where angles 1-2-3 are singular, with gravity along the chain and without: finite, and right.
#[test]
fn straight_chains_at_rest_have_a_gradient() {
    let right = 0.5 * core::f64::consts::PI;
    for gravity in [9.81, 0.0] {
        let rod = Rod::uniform(0.5_f64, 0.02, 1.0);
        let hinge = Revolute::about([0.0, 0.0, 1.0]);
        let system = System::new(Pinned::origin(), (rod, Ball, rod, hinge, rod), Free).unwrap();
        let system = system.with_gravity([0.0, 0.0, -gravity]);
        let start = system.at_rest(&[0.0, right, 0.0, 0.0, right, 0.0, 0.0]).unwrap();
        let mut states = vec![start; 11];
        let mut backward = system.backward(Rk4);
        backward.run(&start, 0.02, 10, &[], &mut states).unwrap();
        let weights = [0.3, 0.2, -0.4, 0.5, 0.1, 0.6, 0.8];
        let found = backward
            .gradient(
                &[],
                &states,
                &mut [],
                |step, _, by| {
                    if step == 10 { by.add(&[0.0; 7], &weights) } else { Ok(()) }
                },
            )
            .unwrap();
        let lifted = system.lift(Jet::<f64, 7>::of);
        let mut jets = lifted.at_rest(&[0.0, right, 0.0, 0.0, right, 0.0, 0.0].map(Jet::of)).unwrap();
        let (mut step, mut k) = (*jets.rate(), 0..);
        Rate::replace(&mut step, &mut |_| Jet::<f64, 7>::seed(0.0, k.next().unwrap()));
        Position::displace(jets.position_mut(), &step);
        let end = lifted.simulation(Rk4::step(0.02)).run(jets, 0.2, |_| ()).unwrap().motion;
        let sum = |k: usize| end.rates().iter().zip(weights).map(|(v, weight)| v.eps[k] * weight).sum::<f64>();
        found.by_position().iter().enumerate().for_each(|(k, found)| near(*found, sum(k), ROUNDING));
        let (rates, [_, _, down]) = (found.by_rate(), <[f64; 3]>::from(found.by_gravity()));
        assert!(rates.iter().all(|x| x.is_finite()) && down.abs() < ROUNDING, "{rates:?}, {down}");
    }
}

/// From a tape as from states, bit for bit: each step goes back under its own torques. And a step has the Jacobians that go with it.
#[test]
fn tapes_and_jacobians_have_the_gradient_of_states() {
    let rod = Rod::uniform(0.5_f64, 0.02, 1.0);
    let hinge = Revolute::about([0.0, 0.0, 1.0]);
    let system = System::new(Pinned::origin(), (rod, Ball, rod, hinge, rod), Free).unwrap();
    let start = system.at_rest(&[0.1, -0.2, 0.3, 0.4, 0.2, -0.5, 0.6]).unwrap();
    let torques: Vec<_> = (0..12).map(|k| Effort([0, 1, 2].map(|i| 2e-3 * f64::from(3 * k + i).sin()))).collect();
    let mut backward = system.backward(Rk4);
    let (mut states, mut tape, mut end) = (vec![start; 5], vec![backward.tape(); 4], start);
    let cost = |step: usize, _: &_, by: &mut catena::sensitivity::Costate<_>| {
        if step == 4 { by.add(&[0.3, 0.1, 0.2, 0.5, 0.4, 0.7, 0.6], &[0.2; 7]) } else { Ok(()) }
    };
    let (mut of_states, mut of_tape) = ([Effort([0.0; 3]); 12], [Effort([0.0; 3]); 12]);
    backward.run(&start, 0.05, 4, &torques, &mut states).unwrap();
    let all = backward.gradient(&torques, &states, &mut of_states, cost).unwrap();
    backward.run_on_tape(&start, 0.05, 4, &torques, &mut tape, &mut end).unwrap();
    let taped = backward.gradient_on_tape(4, &tape, &end, &mut of_tape, cost).unwrap();
    assert!(of_states == of_tape && all.by_position() == taped.by_position() && all.by_rate() == taped.by_rate());
    // The last costate through the Jacobians of four steps.
    let mut costate: Vec<f64> = [0.3, 0.1, 0.2, 0.5, 0.4, 0.7, 0.6].into_iter().chain([0.2; 7]).collect();
    for k in (0..4).rev() {
        let (mut next, mut a, mut b) = (start, [0.0; 14 * 14], [Effort([0.0; 3]); 14 * 3]);
        backward.linearised_step(&states[k], 0.05, &torques[3 * k..][..3], &mut next, &mut a, &mut b).unwrap();
        let of_torques = &of_states[3 * k..][..3];
        for (joint, expected) in of_torques.iter().enumerate() {
            for i in 0..3 {
                let found: f64 = (0..14).map(|row| costate[row] * b[3 * row + joint].0[i]).sum();
                near(found, expected.0[i], ROUNDING);
            }
        }
        costate = (0..14).map(|j| (0..14).map(|row| costate[row] * a[14 * row + j]).sum()).collect();
    }
    costate
        .iter()
        .zip(all.by_position().iter().chain(&all.by_rate()))
        .for_each(|(found, x)| near(*found, *x, ROUNDING));
}
