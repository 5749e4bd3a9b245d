//! Gradients of runs by implicit rules in space, backward: revolutes with springs, against jets through the same steps and central differences.

use super::held::share;
use catena::Scalar;
use catena::scalar::Jet;
use catena::spatial::*;

/// A scene from numbers: parameters of kinds, coordinates that are assembled first, rates, torques in all joints.
macro_rules! gradients {
    ($name:expr, $kinds:expr, $parameters:expr, $angles:expr, $joints:expr, $method:expr, $steps:expr, $h:expr, |$x:ident| $scene:block) => {{
        let (mut numbers, angles, joints): (Vec<f64>, Vec<f64>, usize) = ($parameters, $angles, $joints);
        let (parameters, n, steps, h): (usize, usize, usize, f64) = (numbers.len(), angles.len(), $steps, $h);
        macro_rules! scene {
            ($N:ty, $number:expr) => {{
                type N = $N;
                let $x = $number;
                $scene
            }};
        }
        let system = scene!(f64, |k: usize| -> f64 { numbers[k] });
        let mut guess = system.motion();
        guess.set_coordinates(&angles).unwrap();
        guess.set_rates(&(0..n).map(|k| 0.5 * (1.0 + k as f64).cos()).collect::<Vec<_>>()).unwrap();
        let start = system.assembled(guess, &Unloaded).unwrap();
        numbers.extend(start.coordinates().into_iter().chain(start.rates()));
        numbers.extend((0..steps * joints).map(|k| 0.3 * (0.7 * k as f64).sin()));
        let first_torque = parameters + 2 * n;
        macro_rules! cost {
            ($N:ty, $number:expr) => {{
                let number = $number;
                let system = scene!($N, number);
                let of: Vec<$N> = (0..numbers.len()).map(number).collect();
                let mut now = system.motion();
                now.set_coordinates(&of[parameters..][..n]).unwrap();
                now.set_rates(&of[parameters + n..][..n]).unwrap();
                let (mut next, mut stepper, mut sum) = (now.clone(), system.stepper($method), <$N>::constant(0.0));
                for step in 0..=steps {
                    let (q, v) = (now.coordinates(), now.rates());
                    sum = (0..n).fold(sum, |sum, i| sum + share(step, steps, i, q[i], v[i]));
                    if step < steps {
                        let none = <$N>::constant(0.0);
                        let torques = of[first_torque + step * joints..][..joints].iter();
                        let torques: Vec<_> = torques.map(|torque| Effort([*torque, none, none])).collect();
                        let loads = Loads::none().efforts(torques);
                        stepper.step(&now, &loads, h, &mut next).unwrap();
                        core::mem::swap(&mut now, &mut next);
                    }
                }
                sum
            }};
        }
        let torques: Vec<_> = numbers[first_torque..].iter().map(|torque| Effort([*torque, 0.0, 0.0])).collect();
        let (mut states, mut by_torques) = (vec![start.clone(); steps + 1], torques.clone());
        let mut backward = system.backward($method);
        backward.run(&start, h, steps, &torques, &mut states).unwrap();
        let gradient = backward
            .gradient(&torques, &states, &mut by_torques, |step, state, by| {
                let (q, v) = (state.coordinates(), state.rates());
                let parts = |k: usize| -> Vec<f64> {
                    (0..n)
                        .map(|i| share(step, steps, i, Jet::<f64, 2>::seed(q[i], 0), Jet::seed(v[i], 1)).eps[k])
                        .collect()
                };
                by.add(&parts(0), &parts(1))
            })
            .unwrap();
        let (mut found, mut expected) = (vec![], vec![]);
        for first in (0..numbers.len()).step_by(8) {
            type J = Jet<f64, 8>;
            let number = |k: usize| -> J { J::seed(numbers[k], usize::wrapping_sub(k, first)) };
            expected.extend(cost!(J, number).eps);
            found.extend(gradient.along(&scene!(J, number)).unwrap());
        }
        expected.truncate(numbers.len());
        found.truncate(parameters);
        found.extend(gradient.by_position().into_iter().chain(gradient.by_rate()));
        found.extend(by_torques.iter().map(|torque| torque.0[0]));
        let mut kinds: Vec<(&str, usize)> = $kinds.to_vec();
        kinds.extend([("coordinates", n), ("rates", n), ("torques", steps * joints)]);
        let mut first = 0;
        for (kind, count) in kinds {
            let (found, expected) = (&found[first..first + count], &expected[first..first + count]);
            let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            assert!(size > 0.0, "{}: {kind} do nothing", $name);
            let far = found.iter().zip(expected).fold(0.0_f64, |far, (f, e)| far.max((f - e).abs() / size));
            println!("{}, {kind}: {far:.1e}", $name);
            assert!(
                found.iter().all(|x| x.is_finite()) && far < 1e-12,
                "{}, {kind}: {found:?} not {expected:?}",
                $name
            );
            // One of each kind by a central difference.
            let k = first + count / 2;
            let e = 1e-5 * numbers[k].abs().max(0.1);
            let at = |e: f64| cost!(f64, |j: usize| -> f64 { numbers[j] + if j == k { e } else { 0.0 } });
            let slope = (at(e) - at(-e)) / (2.0 * e);
            assert!(
                (found[count / 2] - slope).abs() < 1e-6 * size,
                "{}, {kind}: {} not {slope}",
                $name,
                found[count / 2]
            );
            first += count;
        }
        assert_eq!(first, numbers.len());
    }};
}

/// Lengths, radii and masses of three kinds of rods, axes, gravity, a spring.
fn numbers(stiffness: f64) -> Vec<f64> {
    let mut list = vec![0.5, 0.4, 0.6, 0.05, 0.04, 0.06, 1.2, 0.7, 0.9];
    list.extend([0.1, 0.3, 1.0, 0.4, 1.0, -0.2, 0.2, -0.6, 0.8, 0.5, 0.1, -9.81]);
    list.extend([stiffness, 0.02 * stiffness, 0.2]);
    list
}

const KINDS: [(&str, usize); 6] =
    [("lengths", 3), ("radii", 3), ("masses", 3), ("axes", 9), ("gravity", 3), ("springs", 3)];

/// Runs what needs more stack than a test's thread has: jets of eight derivatives in arrays of all sweeps of a step.
fn on_a_large_stack(test: fn()) {
    let run = std::thread::Builder::new().stack_size(256 << 20).spawn(test).unwrap().join();
    run.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
}

#[test]
fn chains() {
    on_a_large_stack(chain_and_arm);
}

#[test]
fn tip_on_a_ball() {
    on_a_large_stack(tip_held_by_a_ball);
}

#[test]
fn loops() {
    on_a_large_stack(arms_that_meet);
}

/// A chain and an arm on revolutes, with a weld.
fn chain_and_arm() {
    macro_rules! of {
        ($name:expr, $stiffness:literal, $method:expr) => {
            let kinds = [&KINDS[..], &[("weld", 3)]].concat();
            let mut parameters = numbers($stiffness);
            parameters.extend([0.2, -0.3, 0.4]);
            gradients!($name, kinds, parameters, vec![0.3, -0.4, 0.5, 0.2, -0.6], 7, $method, 4, 0.02, |x| {
                let rod = |i: usize| Rod::<N>::uniform(x(i), x(3 + i), x(6 + i));
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let spring = Spring::new(x(21)).damped(x(22)).resting_at(x(23));
                let (a, b, c) = (Revolute::about(vector(9)), Revolute::about(vector(12)), Revolute::about(vector(15)));
                let weld = Weld::at(Rotation::from_angles(vector(24)));
                let arm = (b.with(spring), rod(0), c, rod(1));
                let chain = (a, rod(0), b.with(spring), rod(1), Branch(arm), weld, rod(1), c.with(spring), rod(2));
                let root = Clamped::at([0.0; 3].map(N::constant), Rotation::from_angles([0.0; 3].map(N::constant)));
                System::new(root, chain, Free).unwrap().with_gravity(vector(18))
            });
        };
    }
    of!("Sdirk4", 10.0, Sdirk4::new());
    of!("generalised alpha", 10.0, GeneralizedAlpha::new(0.8));
    of!("generalised alpha, three sweeps", 300.0, GeneralizedAlpha::new(0.8).with_sweeps(3));
}

/// Six revolutes between the ground and a ball that holds the tip.
fn tip_held_by_a_ball() {
    macro_rules! of {
        ($name:expr, $method:expr) => {
            let kinds = [&KINDS[..], &[("tip", 3)]].concat();
            let mut parameters = numbers(10.0);
            parameters.extend([1.2, 0.9, 0.6]);
            let angles = vec![0.3, -0.4, 0.5, 0.8, -0.6, 0.4];
            gradients!($name, kinds, parameters, angles, 7, $method, 3, 0.01, |x| {
                let rod = |i: usize| Rod::<N>::uniform(x(i), x(3 + i), x(6 + i));
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let spring = Spring::new(x(21)).damped(x(22)).resting_at(x(23));
                let (a, b, c) = (Revolute::about(vector(9)), Revolute::about(vector(12)), Revolute::about(vector(15)));
                let root = Clamped::at([0.0; 3].map(N::constant), Rotation::from_angles([0.0; 3].map(N::constant)));
                let chain =
                    (a, rod(0), b.with(spring), rod(1), c, rod(2), a, rod(0), b.with(spring), rod(1), c, rod(2));
                System::new(root, chain, Pinned::on(vector(24))).unwrap().with_gravity(vector(18))
            });
        };
    }
    of!("Sdirk4", Sdirk4::new());
    of!("generalised alpha", GeneralizedAlpha::new(0.8));
}

/// Two arms on revolutes that meet in a ball.
fn arms_that_meet() {
    macro_rules! of {
        ($name:expr, $method:expr) => {
            let angles = vec![0.2, 0.6, -0.4, 0.3, -0.5, 0.4, -0.6];
            gradients!($name, KINDS, numbers(10.0), angles, 9, $method, 3, 0.01, |x| {
                let rod = |i: usize| Rod::<N>::uniform(x(i), x(3 + i), x(6 + i));
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let spring = Spring::new(x(21)).damped(x(22)).resting_at(x(23));
                let (a, b, c) = (Revolute::about(vector(9)), Revolute::about(vector(12)), Revolute::about(vector(15)));
                let root = Clamped::at([0.0; 3].map(N::constant), Rotation::from_angles([0.0; 3].map(N::constant)));
                let main = (a, rod(0), b.with(spring), rod(1), c, rod(2));
                let side = (c, rod(0), a.with(spring), rod(1), b, rod(2));
                System::new(root, (b, rod(0), Network::new(main, side, Ball)), Free).unwrap().with_gravity(vector(18))
            });
        };
    }
    of!("Sdirk4", Sdirk4::new());
    of!("generalised alpha", GeneralizedAlpha::new(0.8));
}
