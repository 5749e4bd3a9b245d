//! Runs by an implicit rule, backward: cut at an event, under torques on a tape, and what their states keep.

use crate::stiffening::Stiffening;
use catena::planar::*;
use catena::scalar::{Jet, Scalar};
use catena::sensitivity::{Checkpoints, Costate};
use catena::system::Rate;
use catena::{Error, Fault};

const STEPS: usize = 30;
const H: f64 = 0.02;
/// Length, stiffness, damping, gravity; coordinates; rates.
const NUMBERS: [f64; 8] = [0.5, 400.0, 0.3, 9.81, -0.6, 0.02, 2.0, -0.5];

/// Two rods with a hinge that the steps do not resolve, and how they begin to move.
macro_rules! scene {
    ($x:expr) => {
        scene!($x, ElasticHinge::rotary($x[1]).damped($x[2]))
    };
    (law, $x:expr) => {
        scene!($x, ElasticHinge::with(Stiffening { stiffness: $x[1], damping: $x[2], rest: Scalar::literal(0.05) }))
    };
    (spring, $x:expr) => {
        scene!($x)
    };
    ($x:expr, $hinge:expr) => {{
        let rod = Rod::uniform($x[0], Scalar::literal(0.6));
        let chain = (rod, $hinge, rod);
        let scene = System::new(Pinned::origin(), chain, Free).unwrap().with_gravity($x[3]);
        let mut start = scene.motion();
        start.set_coordinates(&$x[4..6]).unwrap();
        start.set_rates(&$x[6..]).unwrap();
        (scene, start)
    }};
}

/// Torques that change their sign from step to step.
fn torques() -> Vec<f64> {
    (0..2 * STEPS).map(|k| if k % 4 < 2 { 1.0 } else { -1.5 }).collect()
}

/// Where the upper rod has an angle: what the lower one does there, and when, against central differences of such runs.
macro_rules! events {
    ($which:ident, $method:expr) => {{
        let run = |x: &[f64; 8]| -> Result<_, Error> {
            let (scene, start) = scene!($which, x);
            let (mut backward, mut states, torques) = (scene.backward($method), [start; STEPS + 1], torques());
            backward.run(&start, H, STEPS, &torques, &mut states)?;
            let steps = backward.cut(&torques, &mut states, |state| state.coordinates()[0] + 1.0)?.unwrap();
            let torques = &torques[..2 * steps];
            let ([q0, q1], [v0, v1], time) = (
                [states[steps].coordinates()[0], states[steps].coordinates()[1]],
                [states[steps].rates()[0], states[steps].rates()[1]],
                states[steps].time(),
            );
            let mut rows = vec![];
            for (of_time, position, rate) in
                [(0.0, [0.0, 1.0], [0.0; 2]), (0.0, [0.0; 2], [v1, v0]), (1.0, [0.0; 2], [0.0; 2])]
            {
                let cost = |k: usize, _: &_, by: &mut Costate<_>| {
                    if k < steps {
                        return Ok(());
                    }
                    by.time += of_time;
                    by.add(&position, &rate)
                };
                let event = |_: &_, by: &mut Costate<_>| by.add(&[1.0, 0.0], &[0.0; 2]);
                let gradient = backward.gradient_to_event(torques, &states[..=steps], &mut [], cost, event)?;
                let of: [Jet<f64, 4>; 8] = core::array::from_fn(|k| Jet::seed(x[k], k));
                let mut row = gradient.along(&scene!($which, of).0)?.to_vec();
                row.extend(gradient.by_position().into_iter().chain(gradient.by_rate()));
                rows.push(row);
            }
            assert!((q0 + 1.0).abs() < 1e-12);
            Ok((steps, [q1, v0 * v1, time], rows))
        };
        let (steps, [.., time], rows) = run(&NUMBERS).unwrap();
        assert!(steps > 3 && steps < STEPS && time % H > 0.1 * H && time % H < 0.9 * H, "{steps} {time}");
        for (which, row) in rows.iter().enumerate() {
            for (j, found) in row.iter().enumerate() {
                let at = |e: f64| {
                    let mut numbers = NUMBERS;
                    numbers[j] += e;
                    let (number, values, _) = run(&numbers).unwrap();
                    assert_eq!(number, steps);
                    values[which]
                };
                let e = 1e-4 * NUMBERS[j].abs();
                let slope = (8.0 * (at(e) - at(-e)) - (at(2.0 * e) - at(-2.0 * e))) / (12.0 * e);
                println!("{which} {j} {found} {slope} {:.1e}", (found - slope).abs() / slope.abs());
                assert!((found - slope).abs() < 1e-7 * slope.abs(), "{which} {j}: {found} not {slope}");
            }
        }
    }};
}

#[test]
fn events() {
    events!(spring, Sdirk4::new());
    events!(spring, GeneralizedAlpha::new(0.8));
}

/// Events under a law that is not linear, which sweeps read where the last one has led.
#[test]
fn events_under_a_law() {
    events!(law, Sdirk4::new());
    events!(law, GeneralizedAlpha::new(0.8));
    events!(law, GeneralizedAlpha::new(0.8).with_sweeps(1));
}

/// Sweeps that are made once more on the way back meet the torques of their step, with all states kept, few, or none.
macro_rules! torques_of_each_step {
    ($method:expr, $remembers:literal) => {{
        let (scene, start) = scene!(NUMBERS);
        let end = |step: usize, _: &_, by: &mut Costate<_, f64>| {
            if step == STEPS { by.add(&[1.0, 0.5], &[0.2, 0.0]) } else { Ok(()) }
        };
        let (mut backward, torques) = (scene.backward($method), torques());
        let (mut states, mut by_torques) = (vec![start; STEPS + 1], torques.clone());
        backward.run(&start, H, STEPS, &torques, &mut states).unwrap();
        let expected = backward.gradient(&torques, &states, &mut by_torques, end).unwrap();
        // No accelerations are kept where steps begin: none that belong elsewhere are shown, but what a rule remembers.
        for state in &states[..if $remembers { 1 } else { STEPS + 1 }] {
            state.acceleration().visit(&mut |x| assert_eq!(x, 0.0));
        }
        let (mut tape, mut last, mut by_tape) = (vec![backward.tape(); STEPS], start, torques.clone());
        backward.run_on_tape(&start, H, STEPS, &torques, &mut tape, &mut last).unwrap();
        let taped = backward.gradient_on_tape(STEPS, &tape, &last, &mut by_tape, end).unwrap();
        let plan = Checkpoints { step: H, steps: STEPS, every: 7 };
        let (mut few, mut by_few) = (vec![start; plan.states()], torques.clone());
        backward.run_between(&start, plan, &torques, &mut few).unwrap();
        let between = backward.gradient_between(plan, &torques, &few, &mut tape, &mut by_few, end).unwrap();
        for (found, by) in [(taped, by_tape), (between, by_few)] {
            assert_eq!(found.by_position(), expected.by_position());
            assert_eq!(found.by_rate(), expected.by_rate());
            assert_eq!(by, by_torques);
        }
    }};
}

#[test]
fn torques_of_each_step() {
    torques_of_each_step!(Sdirk4::new(), false);
    torques_of_each_step!(GeneralizedAlpha::new(0.8), true);
}

/// The states of a run by another rule, or by simulation, are not those of a rule that remembers.
#[test]
fn states_of_another_run_are_refused() {
    let (scene, start) = scene!(NUMBERS);
    let mut states = vec![start; STEPS + 1];
    scene.backward(Sdirk4::new()).run(&start, H, STEPS, &[], &mut states).unwrap();
    let mut backward = scene.backward(GeneralizedAlpha::new(0.8));
    let end = |_: usize, _: &_, by: &mut Costate<_, f64>| by.add(&[1.0, 0.5], &[0.2, 0.0]);
    let error = backward.gradient(&[], &states, &mut [], end).err().unwrap();
    assert!(matches!(error.fault, Fault::Unsupported { .. }), "{error:?}");
    assert_eq!(error.time, Some(H * STEPS as f64));
    let plan = Checkpoints { step: H, steps: STEPS, every: 7 };
    let (mut few, mut tape) = (vec![start; plan.states()], vec![backward.tape(); STEPS]);
    backward.run_between(&start, plan, &[], &mut few).unwrap();
    assert!(backward.gradient_between(plan, &[], &few, &mut tape, &mut [], end).is_ok());
    scene.backward(Sdirk4::new()).run_between(&start, plan, &[], &mut few).unwrap();
    let error = backward.gradient_between(plan, &[], &few, &mut tape, &mut [], end).err().unwrap();
    assert!(matches!(error.fault, Fault::Unsupported { .. }), "{error:?}");
    // Steps of no size lead nowhere, and are refused as in a plain run.
    let error = backward.run(&start, 0.0, 2, &[], &mut states).err().unwrap();
    assert!(matches!(error.fault, Fault::NotPositive { parameter: "step size", .. }), "{error:?}");
    // What makes no rule makes no run.
    let error = scene.backward(GeneralizedAlpha::new(1.5)).run(&start, H, STEPS, &[], &mut states).err().unwrap();
    assert!(matches!(error.fault, Fault::OutOfRange { parameter: "rho", .. }), "{error:?}");
}

/// Steps linearised are first steps: by each row the gradient of a run of one.
#[test]
fn linearised_steps_are_first_ones() {
    let (scene, start) = scene!(NUMBERS);
    let (mut backward, torques) = (scene.backward(GeneralizedAlpha::new(0.8)), [1.0, -0.5]);
    let (mut states, mut next) = ([start; 2], start);
    let (mut by_state, mut by_torques) = ([0.0; 16], [0.0; 8]);
    let moved = scene.with_accelerations(start, &Unloaded).unwrap(); // these are of no use to it
    backward.linearised_step(&moved, H, &torques, &mut next, &mut by_state, &mut by_torques).unwrap();
    backward.run(&start, H, 1, &torques, &mut states).unwrap();
    assert_eq!(next.coordinates(), states[1].coordinates());
    for row in 0..4 {
        let unit = |k: usize| if k == row { 1.0 } else { 0.0 };
        let mut by = [0.0; 2];
        let cost = |step: usize, _: &_, by: &mut Costate<_, f64>| match step {
            1 => by.add(&[unit(0), unit(1)], &[unit(2), unit(3)]),
            _ => Ok(()),
        };
        let gradient = backward.gradient(&torques, &states, &mut by, cost).unwrap();
        let expected: Vec<f64> = gradient.by_position().into_iter().chain(gradient.by_rate()).collect();
        assert_eq!(by_state[4 * row..][..4], expected[..]);
        assert_eq!(by_torques[2 * row..][..2], by);
    }
}

/// Times of jets are plain numbers: the time of an event would lose its derivatives.
#[test]
fn events_of_jets_are_refused() {
    let of: [Jet<f64, 1>; 8] = core::array::from_fn(|k| Jet::seed(NUMBERS[k], k));
    let (scene, start) = scene!(of);
    let (mut backward, mut states) = (scene.backward(Rk4), [start; 3]);
    backward.run(&start, H, 2, &[], &mut states).unwrap();
    let cost = |_: usize, _: &_, _: &mut Costate<_, _>| Ok(());
    let event = |_: &_, by: &mut Costate<_, _>| by.add(&[Jet::of(1.0), Jet::of(0.0)], &[Jet::of(0.0); 2]);
    let found = backward.gradient_to_event(&[], &states, &mut [], cost, event).err().map(|error| error.fault);
    assert!(matches!(found, Some(Fault::Unsupported { .. })), "{found:?}");
}
