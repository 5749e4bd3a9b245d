//! Gradients of runs that end at an event while something acts that depends on time: loads, joints that are driven, ground that moves. Against
//! central differences of such runs: by a thousandth of a number, they err by 5e-9 of what a cost changes by, and by 4e-11 for the time, where
//! they are those of a smoother function.

use super::driven::Swing;
use super::misuse::{Fading, Growing};
use super::names::*;
use catena::sensitivity::Costate;

/// Length, mass, stiffness, damping, gravity; coordinates; rates.
const NUMBERS: [f64; 9] = [0.8, 1.3, 4.0, 0.2, 9.81, -1.0, 0.7, 0.4, -0.3];
const KINDS: [(&str, usize); 6] =
    [("length", 1), ("mass", 1), ("spring", 2), ("gravity", 1), ("angles", 2), ("rates", 2)];
/// For cost and time.
const BOUNDS: [f64; 2] = [1e-8, 1e-10];
/// Size of a step (s).
const H: f64 = 0.03;

/// Whether gradients of a cost and of the time, by these numbers from the first on, are slopes of runs of `$scene`, whose loads are `$law`, up to where
/// its second coordinate is a tenth of the time.
macro_rules! slopes {
    ($name:expr, $method:expr, $first:literal $(by $parameters:literal parameters)?, |$x:ident| $scene:expr, $law:expr) => {{
        let run = |numbers: &[f64; 9]| {
            let system = {
                let $x = |k: usize| numbers[k];
                $scene
            };
            let mut start = system.motion().at_time(0.25);
            start.set_coordinates(&numbers[5..7]).unwrap();
            start.set_rates(&numbers[7..]).unwrap();
            let (mut backward, mut states) = (system.backward($method).under($law), [start; 41]);
            backward.run(&start, H, 40, &[], &mut states).unwrap();
            let cut = backward.cut(&[], &mut states, |state| state.coordinates()[1] - 0.1 * state.time()).unwrap();
            let (steps, mut found) = (cut.unwrap(), vec![]);
            let (q, v, time) = (states[steps].coordinates(), states[steps].rates(), states[steps].time());
            for of_time in [false, true] {
                let cost = |k: usize, _: &_, by: &mut Costate<_>| match (k == steps, of_time) {
                    (false, _) => Ok(()),
                    (true, false) => {
                        by.time += q[0];
                        by.add(&[2.0 * q[0] + time, 0.0], &[v[1], v[0]])
                    }
                    (true, true) => {
                        by.time += 1.0;
                        Ok(())
                    }
                };
                let event = |_: &_, by: &mut Costate<_>| {
                    by.time -= 0.1;
                    by.add(&[0.0, 1.0], &[0.0; 2])
                };
                let gradient = backward.gradient_to_event(&[], &states[..=steps], &mut [], cost, event).unwrap();
                $({
                    let $x = |k: usize| Jet::<f64, $parameters>::seed(numbers[k], k);
                    found.extend(gradient.along(&$scene).unwrap());
                })?
                found.extend(gradient.by_position().into_iter().chain(gradient.by_rate()));
            }
            (steps, [q[0] * q[0] + v[0] * v[1] + time * q[0], time], found)
        };
        let (steps, [_, time], found) = run(&NUMBERS);
        let rest = (time - 0.25) % H;
        println!("{}: {steps} steps to {time}", $name);
        assert!(steps > 3 && steps < 40 && rest > 0.1 * H && rest < 0.95 * H);
        for (which, found) in found.chunks_exact(9 - $first).enumerate() {
            let slope = |j: usize| {
                let e = 1e-3 * NUMBERS[j].abs();
                let at = |e: f64| {
                    let mut numbers = NUMBERS;
                    numbers[j] += e;
                    let (number, values, _) = run(&numbers);
                    assert_eq!(number, steps);
                    values[which]
                };
                derivative(e, at)
            };
            let expected: Vec<f64> = ($first..9).map(slope).collect();
            let kinds = if $first == 0 { &KINDS[..] } else { &KINDS[4..] };
            alike(&format!("{} of {}", ["cost", "time"][which], $name), kinds, found, &expected, BOUNDS[which]);
        }
    }};
}

/// Two rods on a hinge with a spring.
macro_rules! rods {
    ($root:expr, $x:expr) => {{
        let rod = Rod::uniform($x(0), $x(1));
        let hinge = ElasticHinge::rotary($x(2)).damped($x(3));
        System::new($root, (rod, hinge, rod), Free).unwrap().with_gravity($x(4))
    }};
}

#[test]
fn under_loads_that_depend_on_time() {
    slopes!("a force that grows", Rk4, 0 by 5 parameters, |x| rods!(Pinned::origin(), x), Growing { pace: 2.0 });
    slopes!("a brake that fades in", Dop853, 0 by 5 parameters, |x| rods!(Pinned::origin(), x), Fading { pace: 0.8 });
    slopes!("a force and a rule that remembers", GeneralizedAlpha::new(0.8), 0 by 5 parameters, |x| rods!(Pinned::origin(), x), Growing { pace: 2.0 });
    slopes!("a force and a stiff rule", Sdirk4::new(), 0 by 5 parameters, |x| rods!(Pinned::origin(), x), Growing { pace: 2.0 });
}

/// A number of the type of another one.
fn like<T: Scalar>(_: T, value: f64) -> T {
    T::literal(value)
}

#[test]
fn with_joints_that_are_driven() {
    macro_rules! cranked {
        ($x:expr) => {{
            let of = |value: f64| like($x(0), value);
            let law = Swing { offset: of(0.4), drift: of(-0.7), amplitude: of(0.5), frequency: of(3.1) };
            let rod = Rod::uniform($x(0), $x(1));
            let hinge = ElasticHinge::rotary($x(2)).damped($x(3));
            let chain = (Driven::new(Revolute::smooth(), law), rod, Pin, rod, hinge, rod);
            System::new(Clamped::at(of(0.0), of(0.0), of(0.0)), chain, Free).unwrap().with_gravity($x(4))
        }};
    }
    slopes!("a crank", Rk4, 0 by 5 parameters, |x| cranked!(x), Absent);
}

#[test]
fn on_ground_that_moves() {
    let shaken = || {
        Pinned::on(Moving(|time: f64| GroundMotion {
            place: [0.08 * (5.0 * time).sin(), 0.0],
            velocity: [0.4 * (5.0 * time).cos(), 0.0],
            acceleration: [-2.0 * (5.0 * time).sin(), 0.0],
        }))
    };
    slopes!("a pin that is shaken", Rk4, 5, |x| rods!(shaken(), x), Absent);
}
