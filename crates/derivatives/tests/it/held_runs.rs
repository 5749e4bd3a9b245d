//! Runs of a chain between two pins, backward, however they are kept: on a tape, to an event, under error control, under loads; and tips
//! that are held twice in the same way.

use crate::drag::Drag;
use catena::planar::*;
use catena::sensitivity::{Checkpoints, Costate};
use catena::{Error, Fault};

const STEPS: usize = 6;
const H: f64 = 0.02;

/// Four rods between pins under gravity, and a start that moves.
macro_rules! scene {
    ($gravity:expr) => {{
        let (rod, link) = (Rod::uniform(0.5, 1.0), (Pin, Rod::uniform(0.9, 0.8)));
        let scene = System::new(Pinned::origin(), (rod, [link; 3]), Pinned::at(1.5, 0.1)).unwrap();
        let mut guess = scene.motion();
        guess.set_coordinates(&[1.0, 0.3, -0.7, -1.2]).unwrap();
        guess.set_rates(&[0.5, -0.4, 0.3, 0.6]).unwrap();
        let start = scene.assembled(guess, &Unloaded).unwrap();
        (scene.with_gravity($gravity), start)
    }};
}

/// What costs read of the coordinates and rates at the end.
fn value(coordinates: &[f64], rates: &[f64]) -> f64 {
    coordinates[1] + 0.5 * rates[2]
}

/// Derivatives of that.
macro_rules! at_end {
    ($last:expr) => {
        |step: usize, _: &_, by: &mut Costate<_, f64>| {
            if step == $last { by.add(&[0.0, 1.0, 0.0, 0.0], &[0.0, 0.0, 0.5, 0.0]) } else { Ok(()) }
        }
    };
}

/// Central difference about a number.
fn slope(x: f64, of: impl Fn(f64) -> f64) -> f64 {
    let e = 1e-5 * x;
    (of(x + e) - of(x - e)) / (2.0 * e)
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
        value(&now.coordinates(), &now.rates())
    }};
}

fn near(found: f64, expected: f64) {
    assert!(
        expected.abs() > 1e-6 && (found - expected).abs() < 1e-6 * expected.abs().max(0.1),
        "{found} not {expected}"
    );
}

#[test]
fn on_tapes() {
    let (scene, start) = scene!(9.81);
    let mut backward = scene.backward(Rk4);
    let torques: Vec<f64> = (0..4 * STEPS).map(|k| 0.3 * (0.7 * k as f64).sin()).collect();
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
    near(
        -all.by_gravity().y,
        slope(9.81, |g| {
            let torques = |k: usize| Loads::none().torques(torques[4 * k..][..4].to_vec());
            let (scene, mut now) = scene!(g);
            let (mut next, mut stepper) = (now, scene.stepper(Rk4));
            for k in 0..STEPS {
                stepper.step(&now, &torques(k), H, &mut next).unwrap();
                core::mem::swap(&mut now, &mut next);
            }
            value(&now.coordinates(), &now.rates())
        }),
    );
    for (gradient, by_torques) in [(&between, &by[1]), (&taped, &by[2])] {
        assert_eq!(gradient.by_position(), all.by_position());
        assert_eq!(gradient.by_rate(), all.by_rate());
        assert_eq!(gradient.by_gravity().y, all.by_gravity().y);
        assert_eq!(*by_torques, by[0]);
    }
}

/// No derivative by torques that were never there, whatever the list held.
#[test]
fn without_steps() {
    let (scene, start) = scene!(9.81);
    let mut backward = scene.backward(Rk4);
    let (states, plan) = ([start], Checkpoints { step: H, steps: 0, every: 1 });
    let mut by = [[7.0; 4]; 3];
    backward.gradient(&[], &states, &mut by[0], at_end!(0)).unwrap();
    backward.gradient_between(plan, &[], &states, &mut [], &mut by[1], at_end!(0)).unwrap();
    backward.gradient_on_tape(0, &[], &start, &mut by[2], at_end!(0)).unwrap();
    assert_eq!(by, [[0.0; 4]; 3]);
}

#[test]
fn to_an_event() {
    let level = {
        let (scene, start) = scene!(9.81);
        let mut states = vec![start; STEPS + 1];
        scene.backward(Rk4).run(&start, H, STEPS, &[], &mut states).unwrap();
        0.4 * states[3].coordinates()[0] + 0.6 * states[4].coordinates()[0]
    };
    // The time of the event and the value there.
    macro_rules! cut {
        ($gravity:expr, |$backward:ident, $states:ident, $steps:ident| $then:expr) => {{
            let (scene, start) = scene!($gravity);
            let (mut $backward, mut $states) = (scene.backward(Rk4), vec![start; STEPS + 1]);
            $backward.run(&start, H, STEPS, &[], &mut $states).unwrap();
            let $steps = $backward.cut(&[], &mut $states, |state| state.coordinates()[0] - level).unwrap().unwrap();
            $then
        }};
    }
    let expected = slope(9.81, |g| {
        cut!(g, |_backward, states, steps| {
            let end = &states[steps];
            value(&end.coordinates(), &end.rates()) + end.time()
        })
    });
    cut!(9.81, |backward, states, steps| {
        let cost = |step: usize, state: &_, by: &mut Costate<_, f64>| {
            by.time += if step == steps { 1.0 } else { 0.0 };
            at_end!(steps)(step, state, by)
        };
        let event = |_: &_, by: &mut Costate<_, f64>| by.add(&[1.0, 0.0, 0.0, 0.0], &[0.0; 4]);
        let gradient = backward.gradient_to_event(&[], &states[..=steps], &mut [], cost, event).unwrap();
        near(-gradient.by_gravity().y, expected);
    });
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
    near(-gradient.by_gravity().y, slope(9.81, |g| stepped!(g, Dopri5, sizes.iter().copied(), Unloaded)));
}

#[test]
fn under_loads() {
    let (scene, start) = scene!(9.81);
    let (mut backward, mut states) = (scene.backward(Rk4).under(Drag { drag: 0.7 }), vec![start; STEPS + 1]);
    backward.run(&start, H, STEPS, &[], &mut states).unwrap();
    let gradient = backward.gradient(&[], &states, &mut [], at_end!(STEPS)).unwrap();
    let value = |g: f64, drag: f64| stepped!(g, Rk4, [H; STEPS], Loads::none().on_bodies_by(Drag { drag }));
    near(gradient.by_loads().unwrap()[0], slope(0.7, |drag| value(9.81, drag)));
    near(-gradient.by_gravity().y, slope(9.81, |g| value(g, 0.7)));
}

/// A rod between two pins: both hold its length.
#[test]
fn tips_held_twice() {
    let scene = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Pinned::at(1.0, 0.0)).unwrap().with_gravity(9.81);
    let start = scene.at_rest(&[0.0]).unwrap();
    let (mut backward, mut states, mut end) = (scene.backward(Rk4), vec![start; 3], start);
    let (mut tape, plan) = (vec![backward.tape(); 2], Checkpoints { step: H, steps: 2, every: 1 });
    let refused = |found: Result<(), Error>| {
        let found = found.map_err(|error| error.fault);
        assert!(matches!(found, Err(Fault::RedundantClosures { .. })), "{found:?}");
    };
    refused(backward.run(&start, H, 2, &[], &mut states));
    refused(backward.run_between(&start, plan, &[], &mut states));
    refused(backward.run_on_tape(&start, H, 2, &[], &mut tape, &mut end));
    refused(backward.linearised_step(&start, H, &[], &mut end, &mut [0.0; 4], &mut []));
}
