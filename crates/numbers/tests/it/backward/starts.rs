//! Starts that are assembled, and starts over jets: runs from them backward, by whatever the scene is made of.

use super::{Kinds, ROUNDING, alike};
use catena::scalar::Jet;
use catena::system::{Position, Rate};
use catena::{Fault, Scalar};

/// What a cost reads of rates: unlike for each of them.
fn share<T: Scalar<Real = f64>>(i: usize, v: T) -> T {
    v.scale(1.0 + 0.3 * i as f64) + (v * v).scale(0.5)
}

/// A scene from numbers and a guess, run from where that is assembled: as plain numbers backward, through assembly and by a start over jets, and
/// over jets from assembled starts. Numbers are parameters, then displacements of the start and changes of its rates before it is assembled
/// once more.
macro_rules! starts {
    ($name:expr, $kinds:expr, $numbers:expr, $method:expr, |$system:ident| $guess:expr, |$x:ident| $scene:block) => {{
        const STEPS: usize = 4;
        const H: f64 = 0.02;
        let mut numbers: Vec<f64> = $numbers;
        let parameters = numbers.len();
        let $system = {
            type N = f64;
            let $x = |k: usize| -> N { numbers[k] };
            $scene
        };
        let start = $system.assembled($guess, &Unloaded).unwrap();
        let n = start.rates().len();
        numbers.extend((0..2 * n).map(|_| 0.0));
        macro_rules! start {
            ($N:ty, $made:expr, $number:expr) => {{
                let mut from = start.clone().lift(<$N>::constant);
                let (mut step, mut change) = (from.rate().clone(), from.rate().clone());
                let mut list = (parameters..parameters + 2 * n).map($number);
                for part in [&mut step, &mut change] {
                    Rate::<$N>::replace(part, &mut |_| list.next().unwrap());
                }
                Position::<$N>::displace(from.position_mut(), &step);
                Rate::<$N>::add(from.rate_mut(), &change);
                $made.assembled(from, &Unloaded).unwrap()
            }};
        }
        macro_rules! cost {
            ($N:ty, $number:expr) => {{
                let $x = $number;
                let made = {
                    type N = $N;
                    $scene
                };
                let mut now = start!($N, made, &$x);
                let (mut next, mut stepper) = (now.clone(), made.stepper($method));
                for _ in 0..STEPS {
                    stepper.step(&now, &Unloaded, H, &mut next).unwrap();
                    core::mem::swap(&mut now, &mut next);
                }
                now.rates().iter().enumerate().fold(<$N>::constant(0.0), |sum, (i, v)| sum + share(i, *v))
            }};
        }
        let mut states = vec![start.clone(); STEPS + 1];
        $system.backward($method).run(&start, H, STEPS, &[], &mut states).unwrap();
        let gradient = |assembled: bool| {
            let backward = $system.backward($method);
            let mut backward = if assembled { backward.assembled() } else { backward };
            backward.gradient(&[], &states, &mut [], |step, state, by| {
                let slopes = state.rates().into_iter().enumerate();
                let slopes: Vec<_> = slopes.map(|(i, v)| share(i, Jet::<f64, 1>::seed(v, 0)).eps[0]).collect();
                if step == STEPS { by.add(&vec![0.0; n], &slopes) } else { Ok(()) }
            })
        };
        let (through, plain) = (gradient(true).unwrap(), gradient(false).unwrap());
        let (mut found, mut by_start, mut expected) = (vec![], vec![], vec![]);
        for first in (0..numbers.len()).step_by(8) {
            type J = Jet<f64, 8>;
            let $x = |k: usize| -> J { J::seed(numbers[k], usize::wrapping_sub(k, first)) };
            expected.extend(cost!(J, $x).eps);
            let made = {
                type N = J;
                $scene
            };
            found.extend(through.along(&made).unwrap());
            let start = start!(J, made, &$x);
            let (a, b) = (plain.along(&made).unwrap(), plain.along_start(&start).unwrap());
            by_start.extend(a.iter().zip(b).map(|(a, b)| a + b));
        }
        found.truncate(parameters);
        found.extend(through.by_position().into_iter().chain(through.by_rate()));
        by_start.truncate(numbers.len());
        expected.truncate(numbers.len());
        let mut kinds = $kinds.to_vec();
        kinds.extend([("displacements", n), ("rates", n)]);
        let kinds: Kinds = &kinds;
        alike($name, kinds, &found, &expected, ROUNDING);
        alike($name, kinds, &by_start, &expected, ROUNDING);
        let differences: Vec<f64> = (0..numbers.len())
            .map(|j| {
                let e = 2e-4 * numbers[j].abs().max(0.1);
                let at = |e: f64| cost!(f64, |k: usize| -> f64 { numbers[k] + if k == j { e } else { 0.0 } });
                catena_oracle::derivative(e, at)
            })
            .collect();
        alike($name, kinds, &found, &differences, 1e-6);
    }};
}

mod plane {
    use super::*;
    use catena::planar::*;
    use catena::time::{GeneralizedAlpha, Sdirk4};

    /// Lengths, masses, a place of the tip, gravity.
    const FOUR_BAR: [f64; 9] = [0.5, 1.2, 0.9, 1.0, 1.3, 0.7, 1.0, 0.1, 9.81];
    const KINDS: Kinds<'static> = &[("lengths", 3), ("masses", 3), ("tip", 2), ("gravity", 1)];

    macro_rules! four_bar {
        ($x:ident, $joint:expr) => {{
            let rod = |k| Rod::uniform($x(k), $x(3 + k));
            let chain = (rod(0), $joint, rod(1), Pin, rod(2));
            System::new(Pinned::on([N::constant(0.0); 2]), chain, Pinned::at($x(6), $x(7))).unwrap().with_gravity($x(8))
        }};
    }

    #[test]
    fn a_tip_is_held_as_lengths_change() {
        starts!(
            "four-bar",
            KINDS,
            FOUR_BAR.to_vec(),
            Rk4,
            |system| {
                let guess = system.at_rest(&[1.0, 0.3, -2.0]).unwrap();
                system.with_rates(guess, &[2.0, 0.0, 0.0]).unwrap()
            },
            |x| { four_bar!(x, Pin) }
        );
    }

    #[test]
    fn assembly_knows_no_springs_of_implicit_rules() {
        macro_rules! by {
            ($name:expr, $rule:expr) => {
                starts!(
                    $name,
                    KINDS,
                    FOUR_BAR.to_vec(),
                    $rule,
                    |system| {
                        let guess = system.at_rest(&[1.0, 0.3, -2.0]).unwrap();
                        system.with_rates(guess, &[2.0, 0.0, 0.0]).unwrap()
                    },
                    |x| { four_bar!(x, ElasticHinge::rotary(N::constant(50.0)).damped(N::constant(0.4))) }
                );
            };
        }
        by!("Sdirk4", Sdirk4::default());
        by!("GeneralizedAlpha", GeneralizedAlpha::new(0.8));
    }

    /// A loop, outboard of which a rod is held at its tip: one pass of corrections does not close both.
    #[test]
    fn a_loop_closes_and_the_tip_beyond_it_is_held() {
        let kinds = [("lengths", 5), ("tip", 2), ("gravity", 1)];
        let numbers = vec![0.5, 1.2, 0.9, 1.1, 0.8, 1.9, 0.3, 9.81];
        starts!(
            "loop and tip",
            kinds,
            numbers,
            Rk4,
            |system| system.at_rest(&[1.0, 0.3, 1.1, 0.4, -1.5]).unwrap(),
            |x| {
                let rod = |k: usize| Rod::uniform(x(k), N::constant(1.0 + 0.2 * k as f64));
                let side = (RigidBody::massless([N::constant(1.0), N::constant(0.0)]), Pin, rod(2));
                let net = Network::new((Pin, rod(0), Pin, rod(1)), side, Pin);
                let root = Clamped::on([N::constant(0.0); 2], N::constant(0.0));
                System::new(root, (net, Pin, rod(3), Pin, rod(4)), Pinned::at(x(5), x(6))).unwrap().with_gravity(x(7))
            }
        );
    }

    /// A start that is not closed is no assembled one.
    #[test]
    fn open_starts_are_refused() {
        let x = |k: usize| FOUR_BAR[k];
        type N = f64;
        let system = four_bar!(x, Pin);
        let open = system.at_rest(&[1.0, 0.3, -2.0]).unwrap();
        let mut backward = system.backward(Rk4).assembled();
        let found = backward.run(&open, 0.01, 1, &[], &mut [open; 2]).unwrap_err().fault;
        assert!(matches!(found, Fault::NotAssembled { residual } if residual > 0.1), "{found:?}");
        // One that a step closes is none either.
        let mut open = system.assembled(open, &Unloaded).unwrap();
        let closed = open.coordinates();
        open.set_coordinates(&[closed[0], closed[1], closed[2] + 0.05]).unwrap();
        let mut states = [open; 2];
        backward.run(&open, 0.01, 1, &[], &mut states).unwrap();
        let found = backward.gradient(&[], &states, &mut [], |_, _, _| Ok(())).map(|_| ()).unwrap_err().fault;
        assert!(matches!(found, Fault::NotClosed { residual } if residual > 0.01), "{found:?}");
    }
}

mod space {
    use super::*;
    use catena::spatial::*;

    #[test]
    fn a_tip_on_a_ball_and_a_window_close() {
        let kinds = [("lengths", 2), ("tip", 3), ("gravity", 3)];
        starts!(
            "tip on a ball",
            kinds,
            vec![0.9, 1.1, 1.2, 0.3, -0.4, 1.0, -2.0, -9.0],
            Rk4,
            |system| {
                let guess = system.at_rest(&[0.2, 0.9, 0.3, -0.1, -0.7, 0.4]).unwrap();
                system.with_rates(guess, &[0.4, -0.2, 1.0, 0.3, 0.2, -0.5]).unwrap()
            },
            |x| {
                let rod = |k: usize| Rod::uniform(x(k), N::constant(0.05), N::constant(1.0 + k as f64));
                let zero = N::constant(0.0);
                let root = Pinned::on([zero; 3]);
                System::new(root, (rod(0), Ball, rod(1)), Pinned::on([x(2), x(3), x(4)])).unwrap().with_gravity([
                    x(5),
                    x(6),
                    x(7),
                ])
            }
        );
        starts!(
            "window",
            [("lengths", 4), ("gravity", 3)],
            vec![0.9, 1.1, 1.0, 0.8, 1.0, -2.0, -9.0],
            Rk4,
            |system| {
                let guess = system.at_rest(&[0.1, 0.2, 0.3, 0.3, -0.5, 0.2, -0.2, 0.6, 0.1, -0.4, -0.3, 0.2]).unwrap();
                system.with_rates(guess, &[0.4, -0.2, 1.0, 0.3, 0.2, -0.5, 0.1, 0.3, -0.2, 0.6, 0.2, 0.1]).unwrap()
            },
            |x| {
                let rod = |k: usize| Rod::uniform(x(k), N::constant(0.05), N::constant(1.0 + 0.3 * k as f64));
                let zero = N::constant(0.0);
                let net = Network::new((Ball, rod(1), Ball, rod(2)), (Ball, rod(3)), Ball);
                System::new(Pinned::on([zero; 3]), (rod(0), net), Free).unwrap().with_gravity([x(4), x(5), x(6)])
            }
        );
    }
}
