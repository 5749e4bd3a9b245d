//! Runs of a chain with a window in it, backward, however they are made and kept: on a tape, with few states, under error control, under
//! loads; loops that are held twice in the same way.

use crate::drag::Drag;
use catena::Fault;
use catena::planar::*;
use catena::sensitivity::{Checkpoints, Costate};

const STEPS: usize = 5;
const H: f64 = 0.02;

/// A rod, a window and a rod under gravity, and a start that moves.
macro_rules! scene {
    ($gravity:expr) => {{
        let rod = |length| Rod::uniform(length, length);
        let window = Network::new((Pin, rod(0.5), Pin, rod(0.6)), (Pin, rod(0.55), Pin, rod(0.5)), Pin);
        let scene = System::new(Pinned::origin(), (rod(0.6), window, Pin, rod(0.4)), Free).unwrap();
        let mut guess = scene.at_rest(&[-1.2, -0.4, -1.6, -1.5, -0.5, -0.9]).unwrap();
        guess.set_rates(&[0.5, -0.4, 0.3, 0.6, -0.2, 1.0]).unwrap();
        let start = scene.assembled(guess, &Unloaded).unwrap();
        (scene.with_gravity($gravity), start)
    }};
}

/// What costs read at the end, and its derivatives.
macro_rules! at_end {
    ($last:expr) => {
        |step: usize, _: &_, by: &mut Costate<_, f64>| {
            let (position, rate) = ([0.0, 1.0, 0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 0.5, 0.0, 0.0, 0.0]);
            if step == $last { by.add(&position, &rate) } else { Ok(()) }
        }
    };
}

/// The value after steps of given sizes, made by a stepper.
macro_rules! stepped {
    ($gravity:expr, $method:expr, $sizes:expr, $loads:expr) => {{
        let ((scene, mut now), loads) = (scene!($gravity), $loads);
        let (mut next, mut stepper) = (now, scene.stepper($method));
        for h in $sizes {
            stepper.step(&now, &loads, h, &mut next).unwrap();
            core::mem::swap(&mut now, &mut next);
        }
        let (q, v) = (now.coordinates(), now.rates());
        q[1] + q[5] + 0.5 * v[2]
    }};
}

/// Compares with a central difference about a number.
fn near(found: f64, x: f64, of: impl Fn(f64) -> f64) {
    let e = 1e-5 * x;
    let expected = (of(x + e) - of(x - e)) / (2.0 * e);
    let far = (found - expected).abs() / expected.abs();
    assert!(expected.abs() > 1e-6 && far < 1e-6, "{found} not {expected}");
}

#[test]
fn on_tapes() {
    let (scene, start) = scene!(9.81);
    let mut backward = scene.backward(Rk4);
    let torques: Vec<f64> = (0..scene.joints() * STEPS).map(|k| 0.3 * (0.7 * k as f64).sin()).collect();
    let plan = Checkpoints { step: H, steps: STEPS, every: 2 };
    let (mut states, mut few) = (vec![start; STEPS + 1], vec![start; plan.states()]);
    let (mut tape, mut end) = (vec![backward.tape(); STEPS], start);
    let mut by = [(); 3].map(|()| vec![f64::NAN; torques.len()]);
    backward.run(&start, H, STEPS, &torques, &mut states).unwrap();
    let all = backward.gradient(&torques, &states, &mut by[0], at_end!(STEPS)).unwrap();
    backward.run_between(&start, plan, &torques, &mut few).unwrap();
    let between = backward.gradient_between(plan, &torques, &few, &mut tape, &mut by[1], at_end!(STEPS)).unwrap();
    backward.run_on_tape(&start, H, STEPS, &torques, &mut tape, &mut end).unwrap();
    let taped = backward.gradient_on_tape(STEPS, &tape, &end, &mut by[2], at_end!(STEPS)).unwrap();
    for (gradient, by_torques) in [(&between, &by[1]), (&taped, &by[2])] {
        assert_eq!(gradient.by_position(), all.by_position());
        assert_eq!(gradient.by_rate(), all.by_rate());
        assert_eq!(*by_torques, by[0]);
    }
}

/// The steps are those of the stepper, to the last digit but one, and forces that close loops belong to their accelerations.
#[test]
fn steps_are_those_of_the_rule() {
    let (scene, start) = scene!(9.81);
    let mut states = vec![start; STEPS + 1];
    scene.backward(Rk4).run(&start, H, STEPS, &[], &mut states).unwrap();
    let (mut now, mut next, mut stepper) = (start, start, scene.stepper(Rk4));
    for state in &states[..STEPS] {
        let (q, v) = (now.coordinates(), now.rates());
        let mut pairs = state.coordinates().into_iter().zip(q).chain(state.rates().into_iter().zip(v));
        assert!(pairs.all(|(a, b): (f64, f64)| (a - b).abs() < 1e-14 * b.abs().max(1.0)));
        let again = scene.with_accelerations(now, &Unloaded).unwrap();
        let forces = [state, &again].map(|state| scene.stations(state, &Unloaded).unwrap());
        for (one, other) in forces[0].iter().zip(forces[1].iter()) {
            let (one, other) = (one.internal.force, other.internal.force);
            assert!((one - other).norm() < 1e-11 * other.norm().max(1.0), "{one} not {other}");
        }
        stepper.step(&now, &Unloaded, H, &mut next).unwrap();
        core::mem::swap(&mut now, &mut next);
    }
}

#[test]
fn under_error_control() {
    let (scene, start) = scene!(9.81);
    let (mut backward, mut states) = (scene.backward(Dopri5), vec![start; 200]);
    let steps = backward.run_adaptive(&start, 1e-7, 0.12, &[], &mut states).unwrap();
    let states = &states[..=steps];
    let sizes: Vec<f64> = states.windows(2).map(|pair| pair[1].time() - pair[0].time()).collect();
    assert!(steps > 1 && sizes.iter().any(|size| (size - sizes[0]).abs() > 1e-3 * sizes[0]), "{sizes:?}");
    let gradient = backward.gradient(&[], states, &mut [], at_end!(steps)).unwrap();
    near(-gradient.by_gravity().y, 9.81, |g| stepped!(g, Dopri5, sizes.iter().copied(), Unloaded));
}

#[test]
fn under_loads() {
    let (scene, start) = scene!(9.81);
    let (mut backward, mut states) = (scene.backward(Rk4).under(Drag { drag: 0.7 }), vec![start; STEPS + 1]);
    backward.run(&start, H, STEPS, &[], &mut states).unwrap();
    let gradient = backward.gradient(&[], &states, &mut [], at_end!(STEPS)).unwrap();
    let of = |drag, gravity| stepped!(gravity, Rk4, [H; STEPS], Loads::none().on_bodies_by(Drag { drag }));
    near(gradient.by_loads().unwrap()[0], 0.7, |drag| of(drag, 9.81));
    near(-gradient.by_gravity().y, 9.81, |gravity| of(0.7, gravity));
}

/// Both arms of a loop are straight: nothing tells the forces along them apart.
#[test]
fn held_twice() {
    let rod = Rod::uniform(0.5, 0.4);
    let net = Network::new((Pin, rod, Pin, rod), (Pin, rod, Pin, rod), Pin);
    let scene = System::new(Pinned::origin(), (rod, net), Free).unwrap();
    let start = scene.at_rest(&[-1.0; 5]).unwrap();
    let mut states = [start; 2];
    let fault = scene.backward(Rk4).run(&start, H, 1, &[], &mut states).unwrap_err().fault;
    assert!(matches!(fault, Fault::RedundantClosures { .. }), "{fault}");
}
