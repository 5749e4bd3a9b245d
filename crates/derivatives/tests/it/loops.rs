//! Gradients of runs with closed loops, backward: against jets through the same steps, projection included, central differences, and a
//! dense system with multipliers.

use super::held::share;
use catena::Scalar;
use catena::planar::*;
use catena::scalar::Jet;

/// A four-bar linkage on a ground that is turned, with a spring in its crank.
#[test]
fn four_bar() {
    let kinds = [("lengths", 3), ("masses", 3), ("reach", 2), ("ground", 3), ("spring", 3), ("gravity", 1)];
    let parameters = vec![0.5, 1.2, 0.9, 0.6, 1.1, 0.8, 1.0, 0.1, 0.1, -0.2, 0.3, 8.0, 0.2, 0.4, 9.81];
    macro_rules! of {
        ($method:expr, $steps:expr, $h:expr) => {
            gradients!("four-bar", kinds, parameters.clone(), vec![1.0, -0.3, 1.1], 5, $method, $steps, $h, |x| {
                let rod = |i: usize| Rod::<N>::uniform(x(i), x(3 + i));
                let reach = RigidBody::<N>::massless([x(6), x(7)]);
                let knee = ElasticHinge::rotary(x(11)).damped(x(12)).resting_at(x(13));
                let net = Network::new((Pin, rod(0), knee, rod(1)), (reach, Pin, rod(2)), Pin.named("latch"));
                System::new(Clamped::at(x(8), x(9), x(10)), net, Free).unwrap().with_gravity(x(14))
            })
        };
    }
    of!(Rk4, 6, 0.02);
    of!(Dop853, 3, 0.05);
    of!(GeneralizedAlpha::new(0.8), 6, 0.02);
    of!(GeneralizedAlpha::new(0.8).with_sweeps(3), 6, 0.02);
    of!(Sdirk4::new(), 4, 0.02);
}

/// A chain with a window in it, whose loop begins where joints inboard of it could move, too.
#[test]
fn window() {
    let kinds = [("lengths", 6), ("masses", 6), ("gravity", 1)];
    let parameters = vec![0.6, 0.5, 0.6, 0.55, 0.5, 0.7, 0.8, 0.6, 0.7, 0.5, 0.9, 0.4, 9.81];
    gradients!("window", kinds, parameters, vec![-1.2, -0.4, -1.6, -1.5, -0.5, -0.9], 7, Rk4, 6, 0.02, |x| {
        let rod = |i: usize| Rod::<N>::uniform(x(i), x(6 + i));
        let window = Network::new((Pin, rod(1), Pin, rod(2)), (Pin, rod(3), Pin, rod(4)), Pin);
        System::new(Pinned::origin(), (rod(0), window, Pin, rod(5)), Free).unwrap().with_gravity(x(12))
    });
}

/// Two windows in a row.
#[test]
fn two_in_a_row() {
    let kinds = [("lengths", 4), ("masses", 4), ("gravity", 1)];
    let parameters = vec![0.5, 0.6, 0.55, 0.5, 0.6, 0.7, 0.5, 0.9, 9.81];
    let angles = vec![-0.9, -0.4, -1.6, -1.5, -0.5, -0.6, -1.8, -1.7, -0.7];
    gradients!("two in a row", kinds, parameters, angles, 11, Rk4, 5, 0.02, |x| {
        let rod = |i: usize| Rod::<N>::uniform(x(i), x(4 + i));
        let window = Network::new((Pin, rod(0), Pin, rod(1)), (Pin, rod(2), Pin, rod(3)), Pin);
        System::new(Pinned::origin(), (rod(0), [window; 2]), Free).unwrap().with_gravity(x(8))
    });
}

/// A window in an arm of another, the main arm or the side arm, and a tip that is held beyond it.
#[test]
fn nested() {
    let kinds = [("lengths", 4), ("masses", 4), ("place", 2), ("gravity", 1)];
    let parameters = vec![0.5, 0.6, 0.55, 0.5, 0.6, 0.7, 0.5, 0.9, 1.3, -1.5, 9.81];
    macro_rules! of {
        ($name:expr, $method:expr, $angles:expr, |$inner:ident, $plain:ident| $arms:expr) => {
            gradients!($name, kinds, parameters.clone(), $angles, 12, $method, 4, 0.02, |x| {
                let rod = |i: usize| Rod::<N>::uniform(x(i), x(4 + i));
                let window = Network::new((Pin, rod(0), Pin, rod(1)), (Pin, rod(2), Pin, rod(3)), Pin);
                let $inner = (Pin, rod(0), window);
                let $plain = (Pin, rod(3), Pin, rod(2), Pin, rod(1));
                let (main, side) = $arms;
                let chain = (rod(1), Network::new(main, side, Pin), Pin, rod(0));
                System::new(Pinned::origin(), chain, Pinned::at(x(8), x(9))).unwrap().with_gravity(x(10))
            })
        };
    }
    let (inner, plain) = ([-1.0, -0.8, -1.6, -1.5, -1.0], [-1.8, -1.2, -0.9]);
    let of_arms = |first: &[f64], second: &[f64]| [&[-1.3], first, second, &[-0.7]].concat();
    of!("in a main arm", Rk4, of_arms(&inner, &plain), |inner, plain| (inner, plain));
    of!("in a side arm", Rk4, of_arms(&plain, &inner), |inner, plain| (plain, inner));
    let alpha = GeneralizedAlpha::new(0.8);
    of!("in a main arm, SDIRK4", Sdirk4::new(), of_arms(&inner, &plain), |inner, plain| (inner, plain));
    of!("in a side arm, generalised-α", alpha, of_arms(&plain, &inner), |inner, plain| (plain, inner));
}

/// A loop that a weld closes, on a body that slides, with a rigid body, a weld and an arm within.
#[test]
fn welded() {
    let kinds = [("bodies", 8), ("angles", 2), ("line", 1), ("gravity", 1)];
    let parameters = vec![0.6, 0.9, 0.7, 0.2, 0.3, 0.08, 0.65, -0.1, 0.5, 0.2, 0.3, 9.81];
    let angles = vec![-0.3, 0.2, -0.4, -1.4, -1.96, -1.5, 0.0, -1.9];
    gradients!("welded", kinds, parameters, angles, 10, Rk4, 5, 0.01, |x| {
        let (rod, end) = (Rod::<N>::uniform(x(0), x(1)), Rod::<N>::uniform(x(6), x(2)));
        let rigid = RigidBody::<N>::new(x(2), x(3), [x(4), x(5)], [x(6), x(7)]);
        let main = (Pin, rigid, Pin, end);
        let side = (Pin, rod, Branch((Pin, end)), Pin, rod, Weld::at(x(9)), end, Pin, rigid);
        let chain = (Slider::along(x(10)), rod, Network::new(main, side, Weld::at(x(8))));
        System::new(Pinned::origin(), (end, chain), Free).unwrap().with_gravity(x(11))
    });
}

/// A number with a derivative: an oracle shares none with the library.
#[derive(Clone, Copy)]
struct Dual(f64, f64);

macro_rules! operators {
    ($($Op:ident $op:ident |$a:ident, $b:ident| $value:expr, $slope:expr;)*) => {$(
        impl core::ops::$Op for Dual {
            type Output = Self;
            fn $op(self, other: Self) -> Self {
                let ($a, $b) = (self, other);
                Self($value, $slope)
            }
        }
    )*};
}
operators! {
    Add add |a, b| a.0 + b.0, a.1 + b.1;
    Sub sub |a, b| a.0 - b.0, a.1 - b.1;
    Mul mul |a, b| a.0 * b.0, a.1 * b.0 + a.0 * b.1;
    Div div |a, b| a.0 / b.0, (a.1 - a.0 / b.0 * b.1) / b.0;
}

/// (cos, sin).
fn direction(angle: Dual) -> [Dual; 2] {
    let (sin, cos) = angle.0.sin_cos();
    [Dual(cos, -sin * angle.1), Dual(sin, cos * angle.1)]
}

/// The solution of a dense system, by elimination with pivots.
fn solve(mut rows: Vec<Vec<Dual>>) -> Vec<Dual> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|i, j| rows[*i][k].0.abs().total_cmp(&rows[*j][k].0.abs())).unwrap();
        rows.swap(k, pivot);
        for i in (0..n).filter(|i| *i != k) {
            let (factor, pivot) = (rows[i][k] / rows[k][k], rows[k].clone());
            rows[i].iter_mut().zip(pivot).for_each(|(x, pivot)| *x = *x - factor * pivot);
        }
    }
    (0..n).map(|k| rows[k][n] / rows[k][k]).collect()
}

/// The cost of a run of a four-bar linkage, crank, coupler and rocker from (1, 0) m, by a dense system in three angles with multipliers, and
/// its derivative by one of the numbers: lengths, masses, gravity, angles, rates, torque on the crank at each step.
fn dense_four_bar(numbers: &[f64], seed: usize, steps: usize, h: f64) -> (f64, f64) {
    let x: Vec<Dual> = numbers.iter().enumerate().map(|(k, x)| Dual(*x, f64::from(k == seed))).collect();
    let of = |value: f64| Dual(value, 0.0);
    let [zero, half, third] = [0.0, 0.5, 1.0 / 3.0].map(of);
    let (l, m, g) = (&x[..3], &x[3..6], x[6]);
    let (mut q, mut v) = (x[7..10].to_vec(), x[10..13].to_vec());
    // M, and Γ of the place of the rocker's end less that of the coupler's.
    let system = |q: &[Dual]| {
        let e: Vec<_> = q.iter().map(|q| direction(*q)).collect();
        let coupling = half * m[1] * l[0] * l[1];
        let cos = e[0][0] * e[1][0] + e[0][1] * e[1][1];
        let mut rows = vec![vec![zero; 6]; 5];
        rows[0][0] = (m[0] * third + m[1]) * l[0] * l[0];
        rows[1][1] = m[1] * l[1] * l[1] * third;
        rows[2][2] = m[2] * l[2] * l[2] * third;
        (rows[0][1], rows[1][0]) = (coupling * cos, coupling * cos);
        for i in 0..3 {
            let lever = if i == 2 { l[i] } else { zero - l[i] };
            for (row, part) in [(3, zero - lever * e[i][1]), (4, lever * e[i][0])] {
                (rows[i][row], rows[row][i]) = (zero - part, part);
            }
        }
        (rows, e, coupling)
    };
    let accelerate = |q: &[Dual], v: &[Dual], torque: Dual| {
        let (mut rows, e, coupling) = system(q);
        let sin = e[0][1] * e[1][0] - e[0][0] * e[1][1];
        let weights = [half * m[0] + m[1], half * m[1], half * m[2]];
        for i in 0..3 {
            rows[i][5] = zero - g * weights[i] * l[i] * e[i][0];
        }
        rows[0][5] = rows[0][5] + torque - coupling * sin * v[1] * v[1];
        rows[1][5] = rows[1][5] + coupling * sin * v[0] * v[0];
        for k in 0..2 {
            let centripetal = |i: usize| l[i] * e[i][k] * v[i] * v[i];
            rows[3 + k][5] = centripetal(2) - centripetal(0) - centripetal(1);
        }
        solve(rows)[..3].to_vec()
    };
    let plus =
        |a: &[Dual], s: f64, b: &[Dual]| -> Vec<Dual> { a.iter().zip(b).map(|(a, b)| *a + of(s) * *b).collect() };
    for step in 0..steps {
        let (mut slopes, torque) = (vec![], x[13 + step]);
        let (mut at, mut rate) = (q.clone(), v.clone());
        for row in 0..4 {
            slopes.push((rate.clone(), accelerate(&at, &rate, torque)));
            let part = [0.5, 0.5, 1.0, 1.0][row] * h;
            if row < 3 {
                (at, rate) = (plus(&q, part, &slopes[row].0), plus(&v, part, &slopes[row].1));
            }
        }
        for (slope, weight) in slopes.iter().zip([1.0, 2.0, 2.0, 1.0]) {
            (q, v) = (plus(&q, h * weight / 6.0, &slope.0), plus(&v, h * weight / 6.0, &slope.1));
        }
        // By M and Γ of the last stage, until nothing but rounding is left.
        let correct = |missed: [Dual; 2]| {
            let (mut rows, ..) = system(&at);
            (rows[3][5], rows[4][5]) = (missed[0], missed[1]);
            solve(rows)[..3].to_vec()
        };
        for _ in 0..8 {
            let e: Vec<_> = q.iter().map(|q| direction(*q)).collect();
            let end = |k: usize| l[2] * e[2][k] - l[0] * e[0][k] - l[1] * e[1][k];
            q = plus(&q, -1.0, &correct([of(1.0) + end(0), end(1)]));
        }
        for _ in 0..8 {
            let (rows, ..) = system(&q);
            let end = |row: &[Dual]| row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
            v = plus(&v, -1.0, &correct([end(&rows[3]), end(&rows[4])]));
        }
    }
    let cost = (0..3).fold(zero, |sum, i| sum + share_of(i, q[i], v[i]));
    (cost.0, cost.1)
}

/// What that cost reads of a coordinate and its rate at the end.
fn share_of(i: usize, q: Dual, v: Dual) -> Dual {
    Dual(1.0 + 0.1 * i as f64, 0.0) * q + Dual(0.5, 0.0) * v * v
}

/// Against a dense system with multipliers, which shares no code with the library.
#[test]
fn four_bar_by_multipliers() {
    const STEPS: usize = 8;
    let h = 0.02;
    macro_rules! scene {
        ($N:ty, $x:expr) => {{
            let x = $x;
            let rod = |i: usize| Rod::<$N>::uniform(x(i), x(3 + i));
            let place = [<$N>::constant(1.0), <$N>::constant(0.0)];
            let net = Network::new((Pin, rod(0), Pin, rod(1)), (RigidBody::massless(place), Pin, rod(2)), Pin);
            let root = Clamped::at(<$N>::constant(0.0), <$N>::constant(0.0), <$N>::constant(0.0));
            System::new(root, net, Free).unwrap().with_gravity(x(6))
        }};
    }
    let mut numbers = vec![0.5, 1.2, 0.9, 0.6, 1.1, 0.8, 9.81];
    let scene = scene!(f64, |k: usize| numbers[k]);
    let mut guess = scene.at_rest(&[1.0, 0.3, 1.1]).unwrap();
    guess.set_rates(&[0.4, -0.2, 0.3]).unwrap();
    let start = scene.assembled(guess, &Unloaded).unwrap();
    numbers.extend(start.coordinates().into_iter().chain(start.rates()));
    numbers.extend((0..STEPS).map(|k| 0.3 * (0.7 * k as f64).cos()));
    let torques: Vec<f64> = numbers[13..].iter().flat_map(|torque| [0.0, *torque, 0.0, 0.0, 0.0]).collect();
    let (mut states, mut by_torques) = (vec![start; STEPS + 1], torques.clone());
    let mut backward = scene.backward(Rk4);
    backward.run(&start, h, STEPS, &torques, &mut states).unwrap();
    let gradient = backward
        .gradient(&torques, &states, &mut by_torques, |step, state, by| {
            let v = state.rates();
            if step == STEPS { by.add(&[1.0, 1.1, 1.2], &[v[0], v[1], v[2]]) } else { Ok(()) }
        })
        .unwrap();
    let mut found = gradient.along(&scene!(Jet<f64, 7>, |k: usize| Jet::seed(numbers[k], k))).unwrap().to_vec();
    found.extend(gradient.by_position().into_iter().chain(gradient.by_rate()));
    found.extend((0..STEPS).map(|k| by_torques[5 * k + 1]));
    assert_eq!(found.len(), numbers.len());
    for (k, found) in found.iter().enumerate() {
        let (_, expected) = dense_four_bar(&numbers, k, STEPS, h);
        println!("{k}: {found} {expected} {:.1e}", (found - expected).abs());
        assert!((found - expected).abs() < 1e-11 * expected.abs().max(1.0), "{k}: {found} not {expected}");
    }
}
