//! A chain whose tip is pinned, against the dense system of all angles and multipliers, differentiated by dual numbers of its own: the
//! run, its projection and its gradient backward, without a line of the library.

use catena::planar::*;
use catena::scalar::Jet;
use core::ops::{Add, Div, Mul, Neg, Sub};

const N: usize = 3;
const STEPS: usize = 5;
const H: f64 = 0.02;
/// Lengths, masses, gravity, place of the tip.
const PARAMETERS: usize = 2 * N + 3;

/// A number and its derivative.
#[derive(Clone, Copy)]
struct D(f64, f64);

impl Add for D {
    type Output = D;
    fn add(self, o: D) -> D {
        D(self.0 + o.0, self.1 + o.1)
    }
}
impl Sub for D {
    type Output = D;
    fn sub(self, o: D) -> D {
        D(self.0 - o.0, self.1 - o.1)
    }
}
impl Mul for D {
    type Output = D;
    fn mul(self, o: D) -> D {
        D(self.0 * o.0, self.0 * o.1 + self.1 * o.0)
    }
}
impl Div for D {
    type Output = D;
    fn div(self, o: D) -> D {
        D(self.0 / o.0, (self.1 - self.0 / o.0 * o.1) / o.0)
    }
}
impl Neg for D {
    type Output = D;
    fn neg(self) -> D {
        D(-self.0, -self.1)
    }
}
impl D {
    fn sin(self) -> D {
        D(self.0.sin(), self.0.cos() * self.1)
    }
    fn cos(self) -> D {
        D(self.0.cos(), -self.0.sin() * self.1)
    }
}
fn of(x: f64) -> D {
    D(x, 0.0)
}
fn sum(list: impl Iterator<Item = D>) -> D {
    list.fold(of(0.0), |sum, x| sum + x)
}

/// Gaussian elimination with partial pivoting.
fn solve(mut a: Vec<Vec<D>>, mut b: Vec<D>) -> Vec<D> {
    let n = b.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|i, j| a[*i][k].0.abs().total_cmp(&a[*j][k].0.abs())).unwrap();
        a.swap(k, pivot);
        b.swap(k, pivot);
        for i in k + 1..n {
            let share = a[i][k] / a[k][k];
            let row = a[k].clone();
            a[i].iter_mut().zip(row).skip(k).for_each(|(x, pivot)| *x = *x - share * pivot);
            b[i] = b[i] - share * b[k];
        }
    }
    for k in (0..n).rev() {
        let rest = sum((k + 1..n).map(|j| a[k][j] * b[j]));
        b[k] = (b[k] - rest) / a[k][k];
    }
    b
}

/// Rods on pins, by absolute angles, and what holds their tip.
struct Dense<'x> {
    x: &'x [D],
}

impl Dense<'_> {
    fn length(&self, i: usize) -> D {
        self.x[i]
    }
    fn mass(&self, i: usize) -> D {
        self.x[N + i]
    }
    fn beyond(&self, i: usize) -> D {
        sum((i + 1..N).map(|k| self.mass(k)))
    }
    fn inertia(&self, i: usize, j: usize) -> D {
        let last = i.max(j);
        let share = of(if i == j { 1.0 / 3.0 } else { 0.5 });
        self.length(i) * self.length(j) * (self.mass(last) * share + self.beyond(last))
    }
    /// Γ: how the tip moves.
    fn lever(&self, q: &[D], i: usize) -> [D; 2] {
        [-(self.length(i) * q[i].sin()), self.length(i) * q[i].cos()]
    }
    /// The bordered matrix of M and Γ, solved: M x − Γᵀλ = force, Γ x = demand.
    fn closed(&self, q: &[D], force: Vec<D>, demand: [D; 2]) -> Vec<D> {
        let mut a = vec![vec![of(0.0); N + 2]; N + 2];
        for i in 0..N {
            for j in 0..N {
                a[i][j] = self.inertia(i, j) * (q[i] - q[j]).cos();
            }
            for (k, lever) in self.lever(q, i).into_iter().enumerate() {
                (a[i][N + k], a[N + k][i]) = (-lever, lever);
            }
        }
        let mut x = solve(a, force.into_iter().chain(demand).collect());
        x.truncate(N);
        x
    }
    fn accelerations(&self, q: &[D], v: &[D], torques: &[D]) -> Vec<D> {
        let force = (0..N).map(|i| {
            let bent = sum((0..N).map(|j| self.inertia(i, j) * (q[i] - q[j]).sin() * v[j] * v[j]));
            let weight = self.x[2 * N] * self.length(i) * q[i].cos() * (self.mass(i) * of(0.5) + self.beyond(i));
            let outer = if i + 1 < N { torques[i + 1] } else { of(0.0) };
            torques[i] - outer - bent - weight
        });
        let demand = [
            sum((0..N).map(|i| self.length(i) * q[i].cos() * v[i] * v[i])),
            sum((0..N).map(|i| self.length(i) * q[i].sin() * v[i] * v[i])),
        ];
        self.closed(q, force.collect(), demand)
    }
    /// What the tip misses.
    fn missed(&self, q: &[D]) -> [D; 2] {
        let place =
            [sum((0..N).map(|i| self.length(i) * q[i].cos())), sum((0..N).map(|i| self.length(i) * q[i].sin()))];
        [place[0] - self.x[2 * N + 1], place[1] - self.x[2 * N + 2]]
    }
    /// The step of Kutta's rule, put back through M and Γ of its last stage.
    fn step(&self, q: &mut Vec<D>, v: &mut Vec<D>, torques: &[D]) {
        let moved =
            |x: &[D], h: f64, by: &[D]| -> Vec<D> { x.iter().zip(by).map(|(x, by)| *x + of(h) * *by).collect() };
        let a1 = self.accelerations(q, v, torques);
        let (q2, v2) = (moved(q, H / 2.0, v), moved(v, H / 2.0, &a1));
        let a2 = self.accelerations(&q2, &v2, torques);
        let (q3, v3) = (moved(q, H / 2.0, &v2), moved(v, H / 2.0, &a2));
        let a3 = self.accelerations(&q3, &v3, torques);
        let (q4, v4) = (moved(q, H, &v3), moved(v, H, &a3));
        let a4 = self.accelerations(&q4, &v4, torques);
        let mean = |i: usize, [a, b, c, d]: [&[D]; 4]| (a[i] + of(2.0) * b[i] + of(2.0) * c[i] + d[i]) / of(6.0);
        let rates: Vec<D> = (0..N).map(|i| mean(i, [v, &v2, &v3, &v4])).collect();
        let slopes: Vec<D> = (0..N).map(|i| mean(i, [&a1, &a2, &a3, &a4])).collect();
        (*q, *v) = (moved(q, H, &rates), moved(v, H, &slopes));
        let none = || vec![of(0.0); N];
        for _ in 0..2 {
            let back = self.closed(&q4, none(), self.missed(q));
            *q = moved(q, -1.0, &back);
        }
        let velocity = (0..N).fold([of(0.0); 2], |[x, y], i| {
            let lever = self.lever(q, i);
            [x + lever[0] * v[i], y + lever[1] * v[i]]
        });
        let back = self.closed(&q4, none(), velocity);
        *v = moved(v, -1.0, &back);
    }
}

/// Cost of a run, from all numbers.
fn cost(x: &[D]) -> D {
    let dense = Dense { x };
    let (mut q, mut v) = (x[PARAMETERS..][..N].to_vec(), x[PARAMETERS + N..][..N].to_vec());
    for step in 0..STEPS {
        dense.step(&mut q, &mut v, &x[PARAMETERS + 2 * N + step * N..][..N]);
    }
    sum((0..N).map(|i| of(1.0 + 0.1 * i as f64) * q[i] + of(0.5) * v[i] * v[i]))
}

#[test]
fn a_pinned_tip_is_that_of_dense_multipliers() {
    let mut x = vec![0.5, 1.2, 0.9, 1.0, 0.8, 1.1, 9.81, 1.5, 0.1];
    macro_rules! scene {
        ($number:expr) => {{
            let x = $number;
            let rod = |i: usize| Rod::uniform(x(i), x(N + i));
            let chain = (rod(0), Pin, rod(1), Pin, rod(2));
            System::new(Pinned::origin(), chain, Pinned::at(x(2 * N + 1), x(2 * N + 2))).unwrap().with_gravity(x(2 * N))
        }};
    }
    let scene = scene!(|k: usize| x[k]);
    let mut guess = scene.at_rest(&[1.0, 0.3, -1.2]).unwrap();
    guess.set_rates(&[0.8, -0.5, 0.3]).unwrap();
    let start = scene.assembled(guess, &Unloaded).unwrap();
    x.extend(start.coordinates().into_iter().chain(start.rates()));
    x.extend((0..STEPS * N).map(|k| 0.4 * (0.9 * k as f64).cos()));
    let torques = &x[PARAMETERS + 2 * N..];
    let (mut states, mut by_torques) = (vec![start; STEPS + 1], torques.to_vec());
    let mut backward = scene.backward(Rk4);
    backward.run(&start, H, STEPS, torques, &mut states).unwrap();
    let gradient = backward.gradient(torques, &states, &mut by_torques, |step, state, by| match step {
        STEPS => by.add(&[1.0, 1.1, 1.2], &state.rates()),
        _ => Ok(()),
    });
    let gradient = gradient.unwrap();
    let mut found: Vec<f64> =
        gradient.along(&scene!(|k: usize| Jet::<f64, PARAMETERS>::seed(x[k], k))).unwrap().to_vec();
    found.extend(gradient.by_position().into_iter().chain(gradient.by_rate()).chain(by_torques));
    let end = &states[STEPS];
    let value: f64 = (0..N).map(|i| (1.0 + 0.1 * i as f64) * end.coordinates()[i] + 0.5 * end.rates()[i].powi(2)).sum();
    let mut worst = 0.0_f64;
    let expected: Vec<f64> = (0..x.len())
        .map(|k| {
            let seeded: Vec<D> = x.iter().enumerate().map(|(i, x)| D(*x, if i == k { 1.0 } else { 0.0 })).collect();
            let D(cost, slope) = cost(&seeded);
            worst = worst.max((cost - value).abs());
            slope
        })
        .collect();
    assert!(worst < 1e-13, "{worst:e}");
    let mut first = 0;
    for (kind, count) in
        [("lengths", N), ("masses", N), ("gravity", 1), ("tip", 2), ("angles", N), ("rates", N), ("torques", STEPS * N)]
    {
        let (found, expected) = (&found[first..][..count], &expected[first..][..count]);
        let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let far = found.iter().zip(expected).fold(0.0_f64, |far, (f, e)| far.max((f - e).abs() / size));
        println!("{kind}: {far:.1e}");
        assert!(size > 0.0 && far < 1e-12, "{kind}: {found:?} not {expected:?}");
        first += count;
    }
}
