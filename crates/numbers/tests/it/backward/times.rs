//! Gradients of runs whose steps are of unequal sizes: under error control, and cut at an event.

use super::names::*;
use catena::sensitivity::Costate;
use catena::{Error, Fault};

/// A double pendulum with a spring, from lengths, stiffness, gravity.
macro_rules! scene {
    ($x:expr) => {{
        let rod = |length| Rod::uniform(length, $x[1]);
        let hinge = ElasticHinge::rotary($x[2]).damped($x[3]);
        System::new(Pinned::origin(), (rod($x[0]), hinge, rod($x[0])), Free).unwrap().with_gravity($x[4])
    }};
}

/// Positions and rates of two coordinates.
macro_rules! read {
    ($state:expr) => {{
        let (q, v) = ($state.coordinates(), $state.rates());
        ([q[0], q[1]], [v[0], v[1]])
    }};
}

/// Length, mass, stiffness, damping, gravity; coordinates; rates; torques.
const NUMBERS: [f64; 11] = [0.8, 1.3, 4.0, 0.2, 9.81, -1.0, 0.7, 0.4, -0.3, 0.5, -0.2];

fn jet(first: usize) -> [Jet<f64, 4>; 11] {
    core::array::from_fn(|k| Jet::seed(NUMBERS[k], usize::wrapping_sub(k, first)))
}

/// The accepted steps, once more over jets with their sizes: by everything, torques held over the run.
#[test]
fn error_controlled_runs_have_the_gradients_of_their_steps() {
    let system = scene!(NUMBERS);
    let mut start = system.motion().at_time(0.25);
    start.set_coordinates(&NUMBERS[5..7]).unwrap();
    start.set_rates(&NUMBERS[7..9]).unwrap();
    let torques = &NUMBERS[9..];
    let (mut backward, mut states) = (system.backward(Dop853), [start; 40]);
    let steps = backward.run_adaptive(&start, 1e-8, 1.5, torques, &mut states).unwrap();
    let states = &states[..=steps];
    let sizes: Vec<f64> = states.windows(2).map(|pair| pair[1].time() - pair[0].time()).collect();
    let unequal = sizes.iter().fold(0.0, |most: f64, h| most.max(*h)) / sizes[0];
    assert!(steps > 3 && states[steps].time() == 1.5 && unequal > 1.5, "{sizes:?}");
    let cost = |k: usize, _: &_, by: &mut Costate<_>| {
        let (q, v) = read!(states[k]);
        by.add(&q.map(|x| 2.0 * x), &[0.3 * v[1], 0.3 * v[0]])
    };
    let mut by_torques = [0.0; 2];
    let gradient = backward.gradient(torques, states, &mut by_torques, cost).unwrap();
    // The same torques, as those of each step.
    let (each, mut by_each) = (torques.repeat(steps), vec![0.0; 2 * steps]);
    backward.gradient(&each, states, &mut by_each, cost).unwrap();
    let sum = |joint: usize| by_each.iter().skip(joint).step_by(2).sum::<f64>();
    near(by_torques[0], sum(0), 1e-12 * by_torques[0].abs());
    near(by_torques[1], sum(1), 1e-12 * by_torques[1].abs());
    let (mut found, mut expected) = (vec![], vec![]);
    for first in [0, 4, 8] {
        let of = jet(first);
        let scene = scene!(of);
        found.extend(gradient.along(&scene).unwrap());
        let mut now = scene.motion();
        now.set_coordinates(&of[5..7]).unwrap();
        now.set_rates(&of[7..9]).unwrap();
        let (mut next, mut stepper, mut sum) = (now, scene.stepper(Dop853), Jet::of(0.0));
        for size in sizes.iter().map(Some).chain([None]) {
            let (q, v) = read!(&now);
            sum += q[0] * q[0] + q[1] * q[1] + v[0] * v[1] * Jet::of(0.3);
            if let Some(&size) = size {
                stepper.step(&now, &Loads::none().torques(&of[9..]), size, &mut next).unwrap();
                core::mem::swap(&mut now, &mut next);
            }
        }
        expected.extend(sum.eps);
    }
    found.truncate(5);
    found.extend(gradient.by_position().into_iter().chain(gradient.by_rate()).chain(by_torques));
    let kinds =
        [("lengths", 1), ("masses", 1), ("springs", 2), ("gravity", 1), ("angles", 2), ("rates", 2), ("torques", 2)];
    alike("under error control", &kinds, &found, &expected[..11], ROUNDING);
    // A slice that is too short says how many states the run has.
    let found = backward.run_adaptive(&start, 1e-8, 1.5, torques, &mut [start; 3]).unwrap_err().fault;
    assert!(matches!(found, Fault::Count { expected, given: 3, .. } if expected == steps + 1), "{found:?}");
}

/// A run that ends where the lower rod hangs straight below the upper one: its cost and its time, against central differences of such runs.
#[test]
fn events_move_with_all_that_runs_depend_on() {
    const H: f64 = 0.03;
    let run = |x: &[f64; 11]| -> Result<_, Error> {
        let system = scene!(x);
        let mut start = system.motion().at_time(0.25);
        start.set_coordinates(&x[5..7])?;
        start.set_rates(&x[7..9])?;
        let (mut backward, mut states) = (system.backward(Rk4), [start; 31]);
        backward.run(&start, H, 30, &x[9..], &mut states)?;
        let crossed = backward.cut(&x[9..], &mut states, |state| read!(state).0[1] - 0.1 * state.time())?;
        let steps = crossed.unwrap();
        let end = states[steps];
        let (q, v) = read!(&end);
        let cost = q[0] * q[0] + v[1] * v[0] + end.time() * q[0];
        // By what the cost reads, and by the event: q₁ − t/10.
        let by_cost = |k: usize, _: &_, by: &mut Costate<_>| {
            if k < steps {
                return Ok(());
            }
            by.time += q[0];
            by.add(&[2.0 * q[0] + end.time(), 0.0], &[v[1], v[0]])
        };
        let by_event = |_: &_, by: &mut Costate<_>| {
            by.time -= 0.1;
            by.add(&[0.0, 1.0], &[0.0; 2])
        };
        let mut list = vec![];
        let mut all = |of_time: bool| -> Result<(), Error> {
            let mut by_torques = [0.0; 2];
            let cost = |k: usize, state: &_, by: &mut Costate<_>| match of_time {
                false => by_cost(k, state, by),
                true => {
                    by.time += if k == steps { 1.0 } else { 0.0 };
                    Ok(())
                }
            };
            let states = &states[..=steps];
            let gradient = backward.gradient_to_event(&x[9..], states, &mut by_torques, cost, by_event)?;
            for first in [0, 4] {
                let of = jet(first);
                list.extend(gradient.along(&scene!(of))?);
            }
            list.truncate(list.len() - 3);
            list.extend(gradient.by_position().into_iter().chain(gradient.by_rate()).chain(by_torques));
            Ok(())
        };
        all(false)?;
        all(true)?;
        Ok((steps, [cost, end.time()], list))
    };
    let (steps, [_, time], found) = run(&NUMBERS).unwrap();
    assert!(steps > 5 && steps < 30 && (time - 0.25) % H > 0.1 * H, "{steps} {time}");
    let difference = |which: usize, j: usize| {
        let e = 1e-3 * NUMBERS[j].abs();
        let at = |e: f64| {
            let mut numbers = NUMBERS;
            numbers[j] += e;
            let (number, values, _) = run(&numbers).unwrap();
            assert_eq!(number, steps);
            values[which]
        };
        derivative(e, at)
    };
    let expected: Vec<f64> =
        (0..2).flat_map(|which| (0..11).map(move |j| (which, j))).map(|(w, j)| difference(w, j)).collect();
    let kinds =
        [("lengths", 1), ("masses", 1), ("springs", 2), ("gravity", 1), ("angles", 2), ("rates", 2), ("torques", 2)];
    alike("cost at an event", &kinds, &found[..11], &expected[..11], 1e-8);
    alike("time of an event", &kinds, &found[11..], &expected[11..], 1e-8);
}

/// Fixed steps end where those of a run by the rule end, bit for bit, and lead there but for rounding.
#[test]
fn fixed_steps_are_those_of_the_rule() {
    let system = scene!(NUMBERS);
    let start = system.at_rest(&[-1.0, 0.2]).unwrap();
    let (mut states, mut k) = ([start; 101], 0);
    system.backward(Rk4).run(&start, 0.01, 100, &[], &mut states).unwrap();
    system
        .simulate(start, Rk4::step(0.01), 1.0, |now| {
            assert_eq!(now.time(), states[k].time());
            let ((q, v), (p, r)) = (read!(now.motion()), read!(&states[k]));
            for i in 0..2 {
                near(q[i], p[i], 1e-13);
                near(v[i], r[i], 1e-12);
            }
            k += 1;
        })
        .unwrap();
    assert_eq!(k, 101);
}
