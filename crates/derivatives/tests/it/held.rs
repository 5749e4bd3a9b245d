//! Gradients of runs whose tip is held, backward: against jets through the same steps, projection included, and central differences.

use catena::Scalar;
use catena::planar::*;
use catena::scalar::Jet;

/// What a cost reads of one coordinate and its rate at a step.
pub fn share<T: Scalar<Real = f64>>(step: usize, last: usize, i: usize, q: T, v: T) -> T {
    let weight = 1.0 + 0.1 * i as f64;
    if step == last { q.scale(weight) + (v * v).scale(0.5) } else { (q * v).scale(0.05 * weight) }
}

/// How one number acts in a joint of the plane.
pub mod torques {
    pub fn of<T>(torque: T) -> T {
        torque
    }
    pub fn number<T: Copy>(torque: &T) -> T {
        *torque
    }
}

/// A scene from numbers: parameters of kinds, coordinates that are assembled first, rates, a torque in each joint, as a module says how they act.
macro_rules! gradients {
    ($name:expr, $kinds:expr, $parameters:expr, $angles:expr, $joints:expr, $method:expr, $steps:expr, $h:expr, |$x:ident| $scene:block $(, under $law:expr)?) => {
        gradients!(super::held::torques, $name, $kinds, $parameters, $angles, $joints, $method, $steps, $h, |$x| $scene $(, under $law)?)
    };
    ($acts:path, $name:expr, $kinds:expr, $parameters:expr, $angles:expr, $joints:expr, $method:expr, $steps:expr, $h:expr, |$x:ident| $scene:block $(, under $law:expr)?) => {{
        use $acts as acts;
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
                        let torques = of[parameters + 2 * n + step * joints..][..joints].iter();
                        let torques: Vec<_> = torques.map(|torque| acts::of(*torque)).collect();
                        let loads = Loads::none().efforts(torques)$(.on_bodies_by($law))?;
                        stepper.step(&now, &loads, h, &mut next).unwrap();
                        core::mem::swap(&mut now, &mut next);
                    }
                }
                sum
            }};
        }
        let torques: Vec<_> = numbers[parameters + 2 * n..].iter().map(|torque| acts::of(*torque)).collect();
        let (mut states, mut by_torques) = (vec![start.clone(); steps + 1], torques.clone());
        let mut backward = system.backward($method)$(.under($law))?;
        backward.run(&start, h, steps, &torques, &mut states).unwrap();
        let gradient = backward
            .gradient(&torques, &states, &mut by_torques, |step, state, by| {
                let (q, v) = (state.coordinates(), state.rates());
                let parts = |k: usize| -> Vec<f64> {
                    (0..n).map(|i| share(step, steps, i, Jet::<f64, 2>::seed(q[i], 0), Jet::seed(v[i], 1)).eps[k]).collect()
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
        found.extend(by_torques.iter().map(acts::number));
        let mut kinds: Vec<(&str, usize)> = $kinds.to_vec();
        kinds.extend([("coordinates", n), ("rates", n), ("torques", steps * joints)]);
        let mut first = 0;
        for (kind, count) in kinds {
            let of = |list: &[f64]| list[first..first + count].to_vec();
            let (found, expected) = (of(&found), of(&expected));
            let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            assert!(size > 0.0, "{}: {kind} do nothing", $name);
            let far = found.iter().zip(&expected).fold(0.0_f64, |far, (f, e)| far.max((f - e).abs() / size));
            println!("{}, {kind}: {far:.1e}", $name);
            assert!(found.iter().all(|x| x.is_finite()) && far < 1e-12, "{}, {kind}: {found:?} not {expected:?}", $name);
            // One of each kind by a central difference.
            let k = first + count / 2;
            let e = 1e-5 * numbers[k].abs().max(0.1);
            let at = |e: f64| cost!(f64, |j: usize| -> f64 { numbers[j] + if j == k { e } else { 0.0 } });
            let slope = (at(e) - at(-e)) / (2.0 * e);
            assert!((found[count / 2] - slope).abs() < 1e-6 * size, "{}, {kind}: {} not {slope}", $name, found[count / 2]);
            first += count;
        }
        assert_eq!(first, numbers.len());
    }};
}

/// Rods between two pins, and the numbers of the pins.
#[test]
fn pinned() {
    let kinds = [("lengths", 4), ("masses", 4), ("gravity", 1), ("tip", 2)];
    let parameters = vec![0.5, 1.2, 0.9, 0.4, 1.0, 0.8, 1.1, 0.5, 9.81, 1.5, 0.1];
    macro_rules! of {
        ($method:expr, $steps:expr, $h:expr) => {
            gradients!("pinned", kinds, parameters.clone(), vec![1.0, 0.3, -1.0, -0.4], 4, $method, $steps, $h, |x| {
                let rod = |i: usize| Rod::<N>::uniform(x(i), x(4 + i));
                let chain = (rod(0), [(Pin, rod(1)), (Pin, rod(2)), (Pin, rod(3))]);
                System::new(Pinned::origin(), chain, Pinned::at(x(9), x(10))).unwrap().with_gravity(x(8))
            })
        };
    }
    of!(Rk4, 6, 0.02);
    of!(Dop853, 3, 0.05);
    of!(GeneralizedAlpha::new(0.8), 6, 0.02);
    of!(Sdirk4::new(), 4, 0.02);
}

/// Rigid bodies, a hinge with a spring and a damper, a weld, an arm and a joint that slides, clamped at both ends.
#[test]
fn clamped() {
    let kinds = [("bodies", 10), ("springs", 3), ("angles", 2), ("ends", 6), ("gravity", 1)];
    let mut parameters = vec![1.0, 0.8, 0.35, 0.07, 1.3, 0.2, 0.4, 0.1, 0.8, -0.2, 12.0, 0.3, 0.4, 0.3, 0.4];
    parameters.extend([0.1, 0.2, 0.3, 1.9, 0.2, 0.5, 9.81]);
    macro_rules! of {
        ($name:expr, $method:expr) => {
            gradients!(
                $name,
                kinds,
                parameters.clone(),
                vec![0.6, -0.5, 0.3, 0.2, -0.3, -0.9],
                8,
                $method,
                5,
                0.01,
                |x| {
                    let rod = Rod::<N>::new(x(0), x(1), x(2), x(3));
                    let rigid = RigidBody::<N>::new(x(4), x(5), [x(6), x(7)], [x(8), x(9)]);
                    let hinge = ElasticHinge::rotary(x(10)).damped(x(11)).resting_at(x(12));
                    let chain = (
                        hinge,
                        rigid,
                        Branch((Pin, rod)),
                        Pin,
                        rod,
                        Weld::at(x(13)),
                        rod,
                        Slider::along(x(14)),
                        rigid,
                        Pin,
                        rod,
                        Pin,
                        rod,
                    );
                    let root = Clamped::at(x(15), x(16), x(17));
                    System::new(root, chain, Clamped::at(x(18), x(19), x(20))).unwrap().with_gravity(x(21))
                }
            );
        };
    }
    of!("clamped", Rk4);
    of!("clamped, generalised-α", GeneralizedAlpha::new(0.8));
    of!("clamped, SDIRK4", Sdirk4::new());
    of!("clamped, SDIRK4, one sweep", Sdirk4::new().with_sweeps(1));
    of!("clamped, generalised-α, one sweep", GeneralizedAlpha::new(0.2).with_sweeps(1));
}

/// A tip that a line guides.
#[test]
fn guided() {
    let kinds = [("lengths", 4), ("masses", 4), ("gravity", 1), ("tip", 3)];
    let parameters = vec![0.5, 1.2, 0.9, 0.4, 1.0, 0.8, 1.1, 0.5, 9.81, 1.5, 0.1, -0.3];
    gradients!("guided", kinds, parameters, vec![1.0, 0.3, -1.0, -0.3], 4, Rk4, 6, 0.02, |x| {
        let rod = |i: usize| Rod::<N>::uniform(x(i), x(4 + i));
        let chain = (rod(0), [(Pin, rod(1)), (Pin, rod(2)), (Pin, rod(3))]);
        System::new(Pinned::origin(), chain, Guided::at(x(9), x(10), x(11))).unwrap().with_gravity(x(8))
    });
}

/// Hinges with springs along axes that do not turn, before a tip that is held and in a loop.
#[test]
fn springs_along_fixed_axes() {
    let kinds = [("bodies", 10), ("springs", 8), ("tip, or a weld", 2), ("gravity", 1)];
    let mut parameters = vec![1.0, 0.8, 0.35, 0.07, 1.3, 0.2, 0.4, 0.1, 0.8, -0.2];
    parameters.extend([20.0, 0.6, 0.1, 30.0, 1.2, 0.05, 18.0, 0.24, 1.9, -0.4, 9.81]);
    macro_rules! of {
        ($name:expr, $angles:expr, $joints:expr, |$x:ident, $rod:ident, $rigid:ident, $full:ident| $scene:expr) => {
            gradients!($name, kinds, parameters.clone(), $angles, $joints, Rk4, 5, 0.01, |$x| {
                let $rod = Rod::<N>::new($x(0), $x(1), $x(2), $x(3));
                let $rigid = RigidBody::<N>::new($x(4), $x(5), [$x(6), $x(7)], [$x(8), $x(9)]);
                let one = Spring::new($x(10)).damped($x(11)).resting_at($x(12));
                let other = Spring::new($x(13)).damped($x(14)).resting_at($x(15));
                let $full = ElasticHinge::rotary($x(16)).damped($x(17)).with_linear(one, other).in_fixed_axes();
                $scene
            })
        };
    }
    of!("fixed axes, held", vec![-0.3, 0.1, -0.05, 0.4, -0.8], 3, |x, rod, rigid, full| {
        let chain = (rigid, full, rod, Pin, rod);
        System::new(Pinned::origin(), chain, Pinned::at(x(18), x(19))).unwrap().with_gravity(x(20))
    });
    of!("fixed axes, in a loop", vec![-1.2, 0.6, 0.1, 0.05, -0.4, 0.5, -0.9], 7, |x, rod, rigid, full| {
        let loops = Network::new((Pin, rod, full, rigid), (Pin, rigid, Pin, rod), Pin);
        let before = (rod, Weld::at(x(19)), Rod::uniform(x(18), x(1)));
        System::new(Pinned::origin(), (before, loops), Free).unwrap().with_gravity(x(20))
    });
}
