//! Gradients of costs at samples between steps, in space: attitudes at samples, and what closes there.

use super::super::samples::{EVERY, Fixed, H};
use super::*;

const STEPS: usize = 4;
const SAMPLES: usize = 11;

/// Lengths of two rods, gravity, a place of the tip if there is one; displacements from the start, and rates.
macro_rules! samples {
    ($name:expr, $rounding:expr, $kinds:expr, $parameters:expr, $method:expr, |$system:ident| $start:expr, |$x:ident| $scene:block) => {{
        let mut numbers: Vec<f64> = $parameters;
        let parameters = numbers.len();
        let $system = {
            type N = f64;
            let $x = |k: usize| -> N { numbers[k] };
            $scene
        };
        let start = $start;
        let n = start.rates().len();
        numbers.extend((0..n).map(|_| 0.0).chain(start.rates()));
        macro_rules! cost {
            ($N:ty, $number:expr) => {{
                let $x = $number;
                let made = {
                    type N = $N;
                    $scene
                };
                let rates: Vec<$N> = (0..n).map(|i| $x(parameters + n + i)).collect();
                let mut from = made.with_rates(start.clone().lift(<$N>::constant), &rates).unwrap();
                let (mut step, mut list) = (from.rate().clone(), (parameters..).map(&$x));
                Rate::<$N>::replace(&mut step, &mut |_| list.next().unwrap());
                Position::<$N>::displace(from.position_mut(), &step);
                let (mut sum, mut sample) = (<$N>::constant(0.0), 0);
                let run = made.simulation(Fixed::fixed($method, H)).every(EVERY);
                run.run(from, H * STEPS as f64, |now| {
                    sum += share(sample, SAMPLES - 1, &now.motion().coordinates(), &now.motion().rates());
                    sample += 1;
                })
                .unwrap();
                assert_eq!(sample, SAMPLES);
                sum
            }};
        }
        let mut states = vec![start.clone(); STEPS + 1];
        let mut backward = $system.backward($method);
        backward.run(&start, H, STEPS, &[], &mut states).unwrap();
        let times: [f64; SAMPLES] = core::array::from_fn(|k| EVERY * k as f64);
        let mut total = 0.0;
        let gradient = backward
            .gradient_at(&[], &states, &times, &mut [], |sample, state, by| {
                let (q, v) = (state.coordinates(), state.rates());
                total += share(sample, SAMPLES - 1, &q, &v);
                let [by_position, by_rate] = slopes(sample, SAMPLES - 1, &[true, true], &q, &v);
                by.add(&by_position, &by_rate)
            })
            .unwrap();
        let plain = cost!(f64, |k: usize| -> f64 { numbers[k] });
        near(total, plain, 1e-12 * (1.0 + plain.abs()));
        let [mut expected, mut found] = by_jets(&numbers, |number| {
            let made = {
                type N = Jet<f64, 8>;
                let $x = number;
                $scene
            };
            [cost!(Jet<f64, 8>, number).eps, gradient.along(&made).unwrap()]
        });
        expected.truncate(numbers.len());
        found.truncate(parameters);
        found.extend(gradient.by_position().into_iter().chain(gradient.by_rate()));
        let mut kinds = $kinds.to_vec();
        kinds.extend([("attitudes", n), ("rates", n)]);
        let cost = |number: &dyn Fn(usize) -> f64| cost!(f64, number);
        agrees($name, &kinds, &numbers, ([&expected, &found], $rounding), |_| true, cost);
    }};
}

const ANGLES: [f64; 6] = [0.2, 0.9, 0.3, -0.1, -0.7, 0.4];
const RATES: [f64; 6] = [0.4, -0.2, 1.0, 0.3, 0.2, -0.5];

macro_rules! rods {
    ($x:ident, $tip:expr) => {{
        let rod = |k: usize| Rod::uniform($x(k), N::constant(0.05), N::constant(1.0 + k as f64));
        let root = Pinned::on([N::constant(0.0); 3]);
        System::new(root, (rod(0), Ball, rod(1)), $tip).unwrap().with_gravity([$x(2), $x(3), $x(4)])
    }};
}

#[test]
fn attitudes_at_samples() {
    macro_rules! by {
        ($name:expr, $Method:expr) => {
            samples!(
                $name,
                ROUNDING,
                [("lengths", 2), ("gravity", 3)],
                vec![0.9, 1.1, 1.0, -2.0, -9.0],
                $Method,
                |system| system.with_rates(system.at_rest(&ANGLES).unwrap(), &RATES).unwrap(),
                |x| { rods!(x, Free) }
            );
        };
    }
    by!("RK4", Rk4);
    by!("DOPRI5", Dopri5);
    by!("DOP853", Dop853);
    by!("SDIRK4", Sdirk4::new());
}

#[test]
fn a_tip_is_held_at_samples() {
    macro_rules! by {
        ($name:expr, $rounding:expr, $Method:expr) => {
            samples!(
                $name,
                $rounding,
                [("lengths", 2), ("gravity", 3), ("tip", 3)],
                vec![0.9, 1.1, 1.0, -2.0, -9.0, 1.2, 0.3, -0.4],
                $Method,
                |system| {
                    let guess = system.with_rates(system.at_rest(&ANGLES).unwrap(), &RATES).unwrap();
                    system.assembled(guess, &Unloaded).unwrap()
                },
                |x| { rods!(x, Pinned::on([x(5), x(6), x(7)])) }
            );
        };
    }
    by!("tip on a ball, RK4", ROUNDING, Rk4);
    by!("tip on a ball, DOPRI5", ROUNDING, Dopri5);
    by!("tip on a ball, DOP853", ROUNDING_BETWEEN, Dop853);
}
