//! Gradients of costs at samples between steps: against jets through the same dense output, and central differences.

use super::Kinds;
use super::names::*;
use catena::Fault;
use catena::time::{GeneralizedAlpha, Sdirk4};

/// Size of a step, and how far samples are apart: they fall anywhere in steps, three in some, and on ends of some.
pub(super) const H: f64 = 0.04;
pub(super) const EVERY: f64 = 0.015;
const STEPS: usize = 6;
const SAMPLES: usize = 17;

/// A run from numbers, the last of them coordinates, rates, and torques held over the run: the sum of shares at samples, over jets and backward.
macro_rules! samples {
    ($name:expr, $kinds:expr, $numbers:expr, [$n:expr, $joints:expr], $method:expr, |$system:ident, $now:ident, $torques:ident, $read:ident| $run:block,
     |$x:ident| $scene:block) => {{
        let (numbers, n): (Vec<f64>, usize) = ($numbers, $n);
        let parameters = numbers.len() - 2 * n - $joints;
        macro_rules! cost {
            ($N:ty, $number:expr) => {{
                let $x = $number;
                let of: Vec<$N> = (0..numbers.len()).map(&$x).collect();
                let $system = {
                    type N = $N;
                    $scene
                };
                let mut $now = $system.motion();
                $now.set_coordinates(&of[parameters..][..n]).unwrap();
                $now.set_rates(&of[parameters + n..][..n]).unwrap();
                let $torques = &of[parameters + 2 * n..];
                let (mut sum, mut sample) = (<$N>::constant(0.0), 0);
                let mut $read = |q: Vec<$N>, v: Vec<$N>| {
                    (0..n).for_each(|i| sum += share(sample, SAMPLES - 1, i, q[i], v[i]));
                    sample += 1;
                };
                $run
                assert_eq!(sample, SAMPLES);
                sum
            }};
        }
        let system = {
            type N = f64;
            let $x = |k: usize| -> N { numbers[k] };
            $scene
        };
        let mut start = system.motion();
        start.set_coordinates(&numbers[parameters..][..n]).unwrap();
        start.set_rates(&numbers[parameters + n..][..n]).unwrap();
        let (mut states, torques) = (vec![start.clone(); STEPS + 1], &numbers[parameters + 2 * n..]);
        let (mut by_torques, mut backward) = (vec![0.0; torques.len()], system.backward($method));
        backward.run(&start, H, STEPS, torques, &mut states).unwrap();
        let (mut total, times) = (0.0, core::array::from_fn::<f64, SAMPLES, _>(|k| EVERY * k as f64));
        let gradient = backward
            .gradient_at(torques, &states, &times, &mut by_torques, |sample, state, by| {
                near(state.time(), times[sample], 1e-15);
                let (q, v) = (state.coordinates(), state.rates());
                let part = |k: usize| -> Vec<f64> {
                    let jets =
                        |i: usize| share(sample, SAMPLES - 1, i, Jet::<f64, 2>::seed(q[i], 0), Jet::seed(v[i], 1));
                    (0..n).map(|i| jets(i).eps[k]).collect()
                };
                total += (0..n).map(|i| share(sample, SAMPLES - 1, i, q[i], v[i])).sum::<f64>();
                by.add(&part(0), &part(1))
            })
            .unwrap();
        let plain = cost!(f64, |k: usize| -> f64 { numbers[k] });
        near(total, plain, 1e-12 * (1.0 + plain.abs()));
        let [mut expected, mut found] = by_jets(&numbers, |number| {
            let system = {
                type N = Jet<f64, 8>;
                let $x = number;
                $scene
            };
            [cost!(Jet<f64, 8>, number).eps, gradient.along(&system).unwrap()]
        });
        expected.truncate(numbers.len());
        found.truncate(parameters);
        found.extend(gradient.by_position().into_iter().chain(gradient.by_rate()).chain(by_torques));
        let cost = |number: &dyn Fn(usize) -> f64| cost!(f64, number);
        agrees($name, $kinds, &numbers, ([&expected, &found], ROUNDING), |_| true, cost);
    }};
    // As runs show them.
    ($name:expr, $kinds:expr, $numbers:expr, $sizes:tt, $method:expr, |$x:ident| $scene:block) => {
        samples!(
            $name,
            $kinds,
            $numbers,
            $sizes,
            $method,
            |system, now, torques, read| {
                let loads = Loads::none().torques(torques.to_vec());
                let rule = Fixed::fixed($method, H);
                let run = system.simulation(rule).loads(&loads).every(EVERY);
                run.run(now, H * STEPS as f64, |now| read(now.motion().coordinates(), now.motion().rates())).unwrap();
            },
            |$x| $scene
        )
    };
}

/// Rules by fixed steps.
pub(super) trait Fixed: Sized {
    fn fixed(self, size: f64) -> catena::time::Rule<Self, f64>;
}

macro_rules! fixed {
    ($($Method:ident),*) => {$(
        impl Fixed for $Method {
            fn fixed(self, size: f64) -> catena::time::Rule<Self, f64> {
                $Method::step(size)
            }
        }
    )*};
}
fixed!(Rk4, Dopri5, Dop853);

impl Fixed for Sdirk4 {
    fn fixed(self, size: f64) -> catena::time::Rule<Self, f64> {
        self.step(size)
    }
}

/// Two lengths, masses, a stiffness, damping, gravity; coordinates, rates, torques.
const NUMBERS: [f64; 12] = [0.8, 1.1, 1.3, 4.0, 0.2, 9.81, -1.0, 0.7, 0.4, -0.3, 0.5, -0.2];
const KINDS: Kinds<'static> =
    &[("lengths", 2), ("mass", 1), ("springs", 2), ("gravity", 1), ("angles", 2), ("rates", 2), ("torques", 2)];

macro_rules! pendulum {
    ($x:ident) => {{
        let hinge = ElasticHinge::rotary($x(3)).damped($x(4));
        let root = Pinned::on([N::constant(0.0); 2]);
        let chain = (Rod::uniform($x(0), $x(2)), hinge, Rod::uniform($x(1), N::constant(0.9)));
        System::new(root, chain, Free).unwrap().with_gravity($x(5))
    }};
}

#[test]
fn samples_between_explicit_steps() {
    samples!("RK4", KINDS, NUMBERS.to_vec(), [2, 2], Rk4, |x| { pendulum!(x) });
    samples!("DOPRI5", KINDS, NUMBERS.to_vec(), [2, 2], Dopri5, |x| { pendulum!(x) });
    samples!("DOP853", KINDS, NUMBERS.to_vec(), [2, 2], Dop853, |x| { pendulum!(x) });
}

#[test]
fn samples_between_implicit_steps() {
    let mut numbers = NUMBERS.to_vec();
    numbers[3] = 3e3;
    samples!("Sdirk4", KINDS, numbers.clone(), [2, 2], Sdirk4::default(), |x| { pendulum!(x) });
    // Steps of a stepper's own, as those of runs begin with accelerations that the last sweep has left.
    let rule = GeneralizedAlpha::new(0.7);
    samples!(
        "GeneralizedAlpha",
        KINDS,
        numbers,
        [2, 2],
        rule,
        |system, now, torques, read| {
            let (loads, mut stepper) = (Loads::none().torques(torques.to_vec()), system.stepper(rule));
            let (mut next, mut k) = (now.clone(), 0);
            read(now.coordinates(), now.rates());
            for step in 1..=STEPS {
                let mut part = now.clone();
                loop {
                    k += 1;
                    let size = EVERY * k as f64 - now.time();
                    if size > H - 1e-9 {
                        break;
                    }
                    stepper.step(&now, &loads, size, &mut part).unwrap();
                    read(part.coordinates(), part.rates());
                }
                stepper.step(&now, &loads, H * step as f64 - now.time(), &mut next).unwrap();
                core::mem::swap(&mut now, &mut next);
                if EVERY * k as f64 > now.time() + 1e-9 {
                    k -= 1;
                } else {
                    read(now.coordinates(), now.rates());
                }
            }
        },
        |x| { pendulum!(x) }
    );
}

/// Two rods and a third whose tip is pinned: what closes them closes them at samples, too.
#[test]
fn samples_of_a_tip_that_is_held() {
    let kinds: Kinds = &[("lengths", 3), ("tip", 2), ("gravity", 1), ("angles", 3), ("rates", 3), ("torques", 3)];
    macro_rules! four_bar {
        ($x:ident) => {{
            let rod = |k: usize| Rod::uniform($x(k), N::constant(1.0 + 0.2 * k as f64));
            let chain = (rod(0), Pin, rod(1), Pin, rod(2));
            System::new(Pinned::on([N::constant(0.0); 2]), chain, Pinned::at($x(3), $x(4))).unwrap().with_gravity($x(5))
        }};
    }
    let mut numbers = vec![0.5, 1.2, 0.9, 1.0, 0.1, 9.81];
    let start = {
        type N = f64;
        let x = |k: usize| -> N { numbers[k] };
        let system = four_bar!(x);
        let guess = system.with_rates(system.at_rest(&[1.0, 0.3, -2.0]).unwrap(), &[2.0, 0.0, 0.0]).unwrap();
        system.assembled(guess, &Unloaded).unwrap()
    };
    numbers.extend(start.coordinates().into_iter().chain(start.rates()).chain([0.2, -0.1, 0.3]));
    samples!("held, RK4", kinds, numbers.clone(), [3, 3], Rk4, |x| { four_bar!(x) });
    samples!("held, DOP853", kinds, numbers, [3, 3], Dop853, |x| { four_bar!(x) });
}

#[test]
fn times_of_samples_rise_within_the_run() {
    let rod = Rod::uniform(1.0_f64, 1.0);
    let system = System::new(Pinned::origin(), (rod, Pin, rod), Free).unwrap();
    let start = system.at_rest(&[-1.0, -0.5]).unwrap();
    let (mut backward, mut states) = (system.backward(Rk4), [start; 3]);
    backward.run(&start, 0.1, 2, &[], &mut states).unwrap();
    let mut refused = |times: &[f64]| {
        let found = backward.gradient_at(&[], &states, times, &mut [], |_, _, _| Ok(())).map(|_| ());
        matches!(found.map_err(|error| error.fault), Err(Fault::OutOfRange { .. }))
    };
    assert!(refused(&[0.1, 0.05]) && refused(&[0.21]) && refused(&[-0.01]) && refused(&[f64::NAN]));
    assert!(!refused(&[0.0, 0.05, 0.05, 0.2]) && !refused(&[]));
}
