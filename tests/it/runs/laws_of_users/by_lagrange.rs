//! Two scenes by the equations of Lagrange, and the classical Runge-Kutta rule.

pub const LENGTH: f64 = 0.5; // of a uniform rod (m)
pub const MASS: f64 = 1.0; // (kg)
pub const CART: f64 = 2.0; // (kg)
pub const GRAVITY: f64 = 9.81; // along −y (m/s²)

/// Positions, then rates.
pub type State = [f64; 4];

/// Solves a symmetric system of two equations.
fn solve([a, b, c]: [f64; 3], [p, q]: [f64; 2]) -> [f64; 2] {
    let determinant = a * c - b * b;
    [(c * p - b * q) / determinant, (a * q - b * p) / determinant]
}

/// Two rods, pinned at the origin and joined by a hinge: absolute angles and rates. The law has the relative ones and gives a torque on
/// the second rod.
pub fn two_rods([a, b, v, w]: State, law: impl Fn(f64, f64) -> f64) -> State {
    let (square, weight) = (MASS * LENGTH * LENGTH, MASS * GRAVITY * LENGTH);
    let torque = law(b - a, w - v);
    let inertia = [square * 4.0 / 3.0, 0.5 * square * (a - b).cos(), square / 3.0];
    let turning = 0.5 * square * (a - b).sin();
    let right = [-turning * w * w - 1.5 * weight * a.cos() - torque, turning * v * v - 0.5 * weight * b.cos() + torque];
    let [x, y] = solve(inertia, right);
    [v, w, x, y]
}

/// A cart on a line along x, from which a rod hangs: the place of the cart and the angle of the rod. The law gives a force on the cart.
pub fn cart_and_rod([x, a, u, w]: State, law: impl Fn(f64, f64) -> f64) -> State {
    let lever = 0.5 * MASS * LENGTH;
    let inertia = [CART + MASS, -lever * a.sin(), MASS * LENGTH * LENGTH / 3.0];
    let right = [law(x, u) + lever * a.cos() * w * w, -lever * GRAVITY * a.cos()];
    let [p, q] = solve(inertia, right);
    [u, w, p, q]
}

fn step(s: State, h: f64, mut slope: impl FnMut(State) -> State) -> State {
    let moved = |k: State, h: f64| core::array::from_fn(|i| s[i] + h * k[i]);
    let a = slope(s);
    let b = slope(moved(a, 0.5 * h));
    let c = slope(moved(b, 0.5 * h));
    let d = slope(moved(c, h));
    core::array::from_fn(|i| s[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]))
}

/// The state at the end (s), by steps of about this size (s).
pub fn integrate(start: State, end: f64, size: f64, slope: impl Fn(State) -> State) -> State {
    let steps = (end / size).ceil();
    (0..steps as usize).fold(start, |s, _| step(s, end / steps, &slope))
}

/// The same with a stop in the relative angle `at`, where steps end: the slope is told whether the stop is touched. Gives the largest
/// relative angle too.
pub fn integrate_to_stops(
    start: State,
    end: f64,
    size: f64,
    at: f64,
    slope: impl Fn(State, bool) -> State,
) -> (State, f64) {
    let beyond = |s: &State| s[1] - s[0] > at;
    let (mut s, mut time, mut most) = (start, 0.0, start[1] - start[0]);
    let mut touching = beyond(&s);
    while time < end {
        let mut h = size.min(end - time);
        if beyond(&step(s, h, |s| slope(s, touching))) != touching {
            let mut low = 0.0;
            for _ in 0..60 {
                let middle = 0.5 * (low + h);
                let crossed = beyond(&step(s, middle, |s| slope(s, touching))) != touching;
                if crossed { h = middle } else { low = middle }
            }
            s = step(s, h, |s| slope(s, touching));
            touching = !touching;
        } else {
            s = step(s, h, |s| slope(s, touching));
        }
        time += h;
        most = f64::max(most, s[1] - s[0]);
    }
    (s, most)
}
