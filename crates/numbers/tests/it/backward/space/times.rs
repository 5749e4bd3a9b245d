//! Runs in space up to an event, by rules that solve a step by several sweeps: their gradients against central differences of such runs.

use super::*;
use catena::sensitivity::Costate;

/// Two lengths, a mass, a spring with a damper, gravity, and rates of a ball, a hinge and a ball.
const NUMBERS: [f64; 13] = [0.7, 0.5, 1.2, 40.0, 0.5, -9.0, 1.0, -0.6, 0.4, -2.0, 0.3, -0.2, 0.5];
const KINDS: Kinds<'static> = &[("lengths", 2), ("mass", 1), ("spring", 2), ("gravity", 1), ("rates", 7)];

macro_rules! scene {
    ($N:ty, $x:expr) => {{
        let of = $x;
        let (number, hinge) = (<$N>::constant, Revolute::about([0.3, -0.4, 0.8].map(<$N>::constant)));
        let rod = |length: $N, mass: $N| Rod::uniform(length, number(0.05), mass);
        let sprung = hinge.with(Spring::new(of(3)).damped(of(4)));
        let chain = (rod(of(0), of(2)), sprung, rod(of(1), number(0.8)), Ball, rod(of(1), of(2)));
        let gravity = [number(0.0), number(0.5), of(5)];
        System::new(Pinned::on([0.0; 3].map(number)), chain, Free).unwrap().with_gravity(gravity)
    }};
}

/// The hinge has turned to where it is a tenth of the time: cost and time there, and the gradients of both.
macro_rules! up_to_an_event {
    ($method:expr) => {{
        let run = |x: &[f64; 13]| {
            let system = scene!(f64, |k: usize| x[k]);
            let angles = [0.2, 0.5, 0.1, 0.4, -0.3, 0.2, 0.6];
            let start = system.with_rates(system.at_rest(&angles).unwrap(), &x[6..]).unwrap();
            let (mut backward, mut states) = (system.backward($method), vec![start.clone(); 21]);
            backward.run(&start, 0.01, 20, &[], &mut states).unwrap();
            let steps = backward.cut(&[], &mut states, |now| now.coordinates()[4] - 0.1 * now.time()).unwrap().unwrap();
            let end = states[steps].clone();
            let (angle, rate, time) = (end.coordinates()[4], end.rates()[0], end.time());
            let mut both = vec![];
            for of_time in [false, true] {
                let cost = |k: usize, _: &_, by: &mut Costate<_>| match (k == steps, of_time) {
                    (false, _) => Ok(()),
                    (_, true) => {
                        by.time += 1.0;
                        Ok(())
                    }
                    _ => {
                        by.time += angle;
                        let (mut by_position, mut by_rate) = ([0.0; 7], [0.0; 7]);
                        (by_position[3], by_rate[0]) = (2.0 * angle + time, 2.0 * rate);
                        by.add(&by_position, &by_rate)
                    }
                };
                let event = |_: &_, by: &mut Costate<_>| {
                    by.time -= 0.1;
                    by.add(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0], &[0.0; 7])
                };
                let gradient = backward.gradient_to_event(&[], &states[..=steps], &mut [], cost, event).unwrap();
                let along = gradient.along(&scene!(Jet<f64, 8>, |k: usize| Jet::seed(x[k], k))).unwrap();
                both.push(along[..6].iter().copied().chain(gradient.by_rate()).collect::<Vec<_>>());
            }
            (steps, [angle * angle + rate * rate + time * angle, time], both)
        };
        let (steps, _, found) = run(&NUMBERS);
        assert!(steps > 2 && steps < 20, "{steps}");
        for (which, found) in found.iter().enumerate() {
            let difference = |j: usize| {
                let e = 1e-3 * NUMBERS[j].abs();
                let at = |e: f64| {
                    let mut numbers = NUMBERS;
                    numbers[j] += e;
                    let (number, values, _) = run(&numbers);
                    assert_eq!(number, steps);
                    values[which]
                };
                catena_oracle::derivative(e, at)
            };
            let differences: Vec<f64> = (0..13).map(difference).collect();
            alike(&format!("up to an event, {:?}, {which}", $method), KINDS, found, &differences, 1e-7);
        }
    }};
}

#[test]
fn events_move_with_all_that_runs_by_implicit_rules_depend_on() {
    up_to_an_event!(Rk4);
    up_to_an_event!(Sdirk4::new());
    up_to_an_event!(GeneralizedAlpha::new(0.8));
}
