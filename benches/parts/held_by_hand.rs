//! A chain of rods on a wall whose tip a pin holds, by hand, as [`by_hand`](crate::by_hand) writes chains with free tips.
//!
//! Beside mass and force, B and e, the walk inward carries what forces λ at the tip do: f = B a + e + W λ with −Wᵀ a + Λ λ + y = 0. These are
//! nine numbers, with 19 operations a body more inward, two more outward, and two stores:
//!
//! ```text
//! inward     m = −Wᵀ n    r = m / D    y ← y − Wᵀ p + φ m    Λ ← Λ + m rᵀ    W ← W + u rᵀ
//! outward    θ̈ = φ − w·a + r·λ
//! ```

use crate::by_hand::{Scene, directions, fma, same_length};
use crate::scenes::{Case, GRAVITY, state};
use std::hint::black_box;

/// Rods, no more.
struct Rods;
impl Scene for Rods {}

/// Parameters, state, stores and accelerations.
pub struct Held<const N: usize> {
    length: [f64; N],
    inertia: [f64; N],
    mass: [f64; N],
    tip: f64,
    angle: [f64; N],
    rate: [f64; N],
    arm: [[f64; N]; 2],
    centripetal: [[f64; N]; 2],
    per_acceleration: [[f64; N]; 2],
    per_force: [[f64; N]; 2],
    acceleration: [f64; N],
}

impl<const N: usize> Held<N> {
    /// Uniform rods of together 1 m and 1 kg: halves of their masses at their ends, and what is left of their inertia.
    pub fn rods() -> Self {
        let (share, zero) = (1.0 / N as f64, [0.0; N]);
        let square = share * share * share;
        let mut mass = [share; N];
        mass[0] = 0.5 * share;
        Self {
            length: [share; N],
            inertia: [square / 3.0 - square / 2.0; N],
            mass,
            tip: 0.5 * share,
            angle: std::array::from_fn(|i| state(i).0),
            rate: std::array::from_fn(|i| state(i).1),
            arm: [zero; 2],
            centripetal: [zero; 2],
            per_acceleration: [zero; 2],
            per_force: [zero; 2],
            acceleration: zero,
        }
    }

    /// One sweep. Not inlined, as the library's is not.
    #[inline(never)]
    fn once(&mut self) {
        let Self {
            length,
            inertia,
            mass,
            tip,
            angle,
            rate,
            arm,
            centripetal,
            per_acceleration,
            per_force,
            acceleration,
        } = self;
        let ([x, y], [p, q]) = (arm, centripetal);
        directions::<Rods>(length, angle, rate, x, y, p, q);
        let ([wx, wy], [rx, ry]) = (per_acceleration, per_force);
        walk(GRAVITY, *tip, inertia, mass, x, y, p, q, wx, wy, rx, ry, acceleration);
    }
}

impl<const N: usize> Case for Held<N> {
    fn sweep(&mut self, times: usize) {
        for _ in 0..times {
            black_box(&mut *self).once();
        }
    }
    fn accelerations(&self) -> Vec<f64> {
        self.acceleration.to_vec()
    }
}

/// The walk inward and the walk outward. Slices are arguments, because of these alone the compiler knows that they do not overlap.
#[inline(always)]
#[allow(clippy::too_many_arguments, clippy::many_single_char_names)] // slices that march together
fn walk(
    gravity: f64,
    tip: f64,
    inertia: &[f64],
    mass: &[f64],
    x: &[f64],
    y: &[f64],
    p: &[f64],
    q: &[f64],
    wx: &mut [f64],
    wy: &mut [f64],
    rx: &mut [f64],
    ry: &mut [f64],
    acceleration: &mut [f64],
) {
    let n = acceleration.len();
    same_length!(n: inertia, mass, x, y, p, q, wx, wy, rx, ry);
    if n < 2 {
        return;
    }
    let last = n - 1;
    // The tip: B = tip 1, e = 0, W = 1, Λ = 0, y = (0, g).
    let (mut xx, mut xy, mut yy);
    let mut e;
    let (mut a00, mut a01, mut a10, mut a11); // W: row is component, column is force
    let (mut l00, mut l01, mut l11);
    let (mut y0, mut y1);
    {
        let i = last;
        let u = [-tip * y[i], tip * x[i]];
        let f = [tip * p[i], tip * q[i]];
        let inverse = 1.0 / fma(-y[i], u[0], fma(x[i], u[1], inertia[i]));
        let w = [u[0] * inverse, u[1] * inverse];
        // n·p = 0: nothing turns; t = n
        let r = [y[i] * inverse, -(x[i] * inverse)]; // −t / D
        (wx[i], wy[i], acceleration[i], rx[i], ry[i]) = (w[0], w[1], 0.0, r[0], r[1]);
        let sum = tip + mass[i];
        (xx, xy, yy) = (fma(-u[0], w[0], sum), -(u[0] * w[1]), fma(-u[1], w[1], sum));
        e = f;
        (a00, a01, a10, a11) = (fma(u[0], r[0], 1.0), u[0] * r[1], u[1] * r[0], fma(u[1], r[1], 1.0));
        (l00, l01, l11) = (y[i] * r[0], y[i] * r[1], -(x[i] * r[1]));
        (y0, y1) = (-p[i], gravity - q[i]);
    }
    for i in (0..n - 2).rev().map(|i| i + 1) {
        let u = [fma(xy, x[i], -(xx * y[i])), fma(yy, x[i], -(xy * y[i]))];
        let f = [fma(xx, p[i], fma(xy, q[i], e[0])), fma(xy, p[i], fma(yy, q[i], e[1]))];
        let inverse = 1.0 / fma(-y[i], u[0], fma(x[i], u[1], inertia[i]));
        let phi = fma(y[i], f[0], -(x[i] * f[1])) * inverse;
        let w = [u[0] * inverse, u[1] * inverse];
        // minus t
        let m = [fma(y[i], a00, -(x[i] * a10)), fma(y[i], a01, -(x[i] * a11))];
        let r = [m[0] * inverse, m[1] * inverse];
        (wx[i], wy[i], acceleration[i], rx[i], ry[i]) = (w[0], w[1], phi, r[0], r[1]);
        y0 = fma(phi, m[0], fma(-a00, p[i], fma(-a10, q[i], y0)));
        y1 = fma(phi, m[1], fma(-a01, p[i], fma(-a11, q[i], y1)));
        (l00, l01, l11) = (fma(m[0], r[0], l00), fma(m[0], r[1], l01), fma(m[1], r[1], l11));
        (a00, a01, a10, a11) = (fma(u[0], r[0], a00), fma(u[0], r[1], a01), fma(u[1], r[0], a10), fma(u[1], r[1], a11));
        e = [fma(phi, u[0], f[0]), fma(phi, u[1], f[1])];
        (xx, xy, yy) = (fma(-u[0], w[0], xx + mass[i]), fma(-u[0], w[1], xy), fma(-u[1], w[1], yy + mass[i]));
    }
    // The root.
    let u = [fma(xy, x[0], -(xx * y[0])), fma(yy, x[0], -(xy * y[0]))];
    let f = [fma(xx, p[0], fma(xy, q[0], e[0])), fma(xy, p[0], fma(yy, q[0], e[1]))];
    let inverse = 1.0 / fma(-y[0], u[0], fma(x[0], u[1], inertia[0]));
    let phi = fma(y[0], f[0], -(x[0] * f[1])) * inverse;
    let m = [fma(y[0], a00, -(x[0] * a10)), fma(y[0], a01, -(x[0] * a11))];
    let r = [m[0] * inverse, m[1] * inverse];
    y0 = fma(phi, m[0], fma(-a00, p[0], fma(-a10, q[0], y0)));
    y1 = fma(phi, m[1], fma(-a01, p[0], fma(-a11, q[0], y1)));
    (l00, l01, l11) = (fma(m[0], r[0], l00), fma(m[0], r[1], l01), fma(m[1], r[1], l11));
    (a10, a11) = (fma(u[1], r[0], a10), fma(u[1], r[1], a11));
    let (b0, b1) = (fma(a10, gravity, -y0), fma(a11, gravity, -y1));
    let det = 1.0 / fma(l00, l11, -(l01 * l01));
    let (s0, s1) = (fma(l11, b0, -(l01 * b1)) * det, fma(l00, b1, -(l01 * b0)) * det);
    acceleration[0] = fma(r[0], s0, fma(r[1], s1, fma(-u[1] * inverse, gravity, phi)));
    let mut a = [fma(-acceleration[0], y[0], p[0]), fma(acceleration[0], x[0], q[0] + gravity)];
    for i in 1..last {
        let angular = fma(-wx[i], a[0], fma(-wy[i], a[1], fma(rx[i], s0, fma(ry[i], s1, acceleration[i]))));
        acceleration[i] = angular;
        a = [fma(-angular, y[i], a[0] + p[i]), fma(angular, x[i], a[1] + q[i])];
    }
    acceleration[last] =
        fma(-wx[last], a[0], fma(-wy[last], a[1], fma(rx[last], s0, fma(ry[last], s1, acceleration[last]))));
}
