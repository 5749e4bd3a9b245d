//! A double pendulum whose elbow bounces between hard stops, against piecewise integration of Lagrange's equations.

use catena::Error;
use catena::robot::*;
use catena_oracle::{has_order, near};

const LENGTH: f64 = 0.5; // of uniform rods (m)
const MASS: f64 = 1.0; // (kg)
const GRAVITY: f64 = 9.81; // along −y (m/s²)
const STOPS: [f64; 2] = [-0.2, 1.0]; // of the elbow (rad)
const RESTITUTION: f64 = 0.8;
const START: [f64; 2] = [0.0, 0.5]; // shoulder, elbow (rad)
const END: f64 = 2.0; // (s)

type Pendulum = System<f64, Base<f64>, (Hinge<f64>, Link<f64>, Hinge<f64, Level, 1>, Link<f64>), Free>;

fn pendulum() -> Result<Pendulum, Error> {
    let across = MASS * LENGTH * LENGTH / 12.0;
    let tensor = [[1e-3, 0.0, 0.0], [0.0, across, 0.0], [0.0, 0.0, across]];
    let rod = Link::general(MASS, [0.5 * LENGTH, 0.0, 0.0], tensor);
    let chain = (Hinge::level(), rod, Hinge::at::<1>([LENGTH, 0.0, 0.0]), rod);
    Ok(System::new(Base::origin(), chain, Free)?.with_gravity([0.0, -GRAVITY, 0.0]))
}

/// By runs up to impacts; gives absolute angles and rates, and the number of impacts.
fn by_runs<K>(rule: K) -> Result<([f64; 4], usize), Error>
where
    K: Copy + catena::time::IntoRule<f64>,
    for<'s> K::Method: catena::simulate::Method<&'s Pendulum, Unloaded>,
{
    let scene = pendulum()?;
    let (mut now, mut impacts) = (scene.at_joints(&START, &[0.0; 2])?, 0);
    let state = |now: &_| -> Result<[[f64; 2]; 2], Error> {
        let (mut q, mut v) = ([0.0; 2], [0.0; 2]);
        catena::Motion::coordinates_into(now, &mut q)?;
        catena::Motion::rates_into(now, &mut v)?;
        Ok([q, v])
    };
    while now.time() < END {
        let distance = |list: &[f64]| (list[1] - STOPS[0]).min(STOPS[1] - list[1]);
        let run = scene.simulation(rule).event(|now| distance(&now.motion().coordinates())).stopping();
        now = run.run(now, END, |_| ())?.motion;
        let [q, v] = state(&now)?;
        // A run that begins at a stop does not find it again.
        if now.time() < END {
            let (after, _) = scene.impact(&q, &v, 1, RESTITUTION)?;
            now = scene.with_rates(now, &after)?;
            impacts += 1;
        }
    }
    let [q, v] = state(&now)?;
    Ok(([q[0], q[0] + q[1], v[0], v[0] + v[1]], impacts))
}

/// The mass matrix of absolute angles.
fn mass([a, b, ..]: [f64; 4]) -> [f64; 3] {
    let square = MASS * LENGTH * LENGTH;
    [square * 4.0 / 3.0, 0.5 * square * (a - b).cos(), square / 3.0]
}

fn solve([a, b, c]: [f64; 3], [p, q]: [f64; 2]) -> [f64; 2] {
    let determinant = a * c - b * b;
    [(c * p - b * q) / determinant, (a * q - b * p) / determinant]
}

fn slope(s: [f64; 4]) -> [f64; 4] {
    let [a, b, v, w] = s;
    let (turning, weight) = (0.5 * MASS * LENGTH * LENGTH * (a - b).sin(), MASS * GRAVITY * LENGTH);
    let right = [-turning * w * w - 1.5 * weight * a.cos(), turning * v * v - 0.5 * weight * b.cos()];
    let [x, y] = solve(mass(s), right);
    [v, w, x, y]
}

fn step(s: [f64; 4], h: f64) -> [f64; 4] {
    let moved = |k: [f64; 4], h: f64| core::array::from_fn(|i| s[i] + h * k[i]);
    let a = slope(s);
    let b = slope(moved(a, 0.5 * h));
    let c = slope(moved(b, 0.5 * h));
    let d = slope(moved(c, h));
    core::array::from_fn(|i| s[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]))
}

/// Piecewise, step by step, each impact found by bisection.
fn piecewise(size: f64) -> ([f64; 4], usize) {
    let beyond = |s: &[f64; 4]| s[1] - s[0] < STOPS[0] || s[1] - s[0] > STOPS[1];
    let (mut s, mut time, mut impacts) = ([START[0], START[0] + START[1], 0.0, 0.0], 0.0, 0);
    while END - time > 1e-13 {
        let mut h = size.min(END - time);
        let mut next = step(s, h);
        if beyond(&next) {
            let (mut low, mut high) = (0.0, h);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if beyond(&step(s, middle)) { high = middle } else { low = middle }
            }
            // Just before, so that the next step begins inside.
            (h, next) = (low, step(s, low));
            let [x, y] = solve(mass(next), [-1.0, 1.0]);
            let impulse = -(1.0 + RESTITUTION) * (next[3] - next[2]) / (y - x);
            (next[2], next[3]) = (next[2] + impulse * x, next[3] + impulse * y);
            impacts += 1;
        }
        (s, time) = (next, time + h);
    }
    (s, impacts)
}

#[test]
fn an_elbow_bounces_between_its_stops() -> Result<(), Error> {
    let (truth, impacts) = piecewise(2e-5);
    let (found, count) = by_runs(Dop853::tolerance(1e-13))?;
    println!("{impacts} impacts: {truth:?} {found:?}");
    assert!(impacts >= 4 && count == impacts, "{count} of {impacts}");
    found.iter().zip(truth).for_each(|(x, y)| near(*x, y, 1e-9));

    // Fixed steps keep their order across impacts, which are found on the polynomial of a step.
    let mut points = vec![];
    for n in [200, 400, 800, 1600, 3200] {
        let (found, _) = by_runs(Rk4::step(END / f64::from(n)))?;
        points.push((
            END / f64::from(n),
            found.iter().zip(truth).fold(0.0, |most, (x, y)| f64::max(most, (x - y).abs())),
        ));
    }
    has_order("RK4 across impacts", 4.0, 1e-12, &points);
    Ok(())
}
