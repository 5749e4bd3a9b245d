//! The yardstick for the library: the same sweeps written by hand, with as few operations as we know how.
//!
//! Every body is replaced by point masses at its ends and what is left of its inertia. Point masses that meet in a
//! joint are added up beforehand; the tip (nothing outboard) and the root (which does not move) are treated apart. Arms and
//! centripetal accelerations come out of the vectorised pass over the angles. The rest is one walk inward with 23
//! operations a body (a fused multiply-add is one) and one walk outward with 8:
//!
//! ```text
//! d = l (cos θ, sin θ)    n = ẑ × d    p = −ω² d
//! inward     u = B n     D = J′ + n·u    f = e + B p    φ = −n·f / D    w = u / D
//!            e ← f + φ u                 B ← B + μ 1 − u wᵀ
//! outward    θ̈ = φ − w·a                 a ← a + θ̈ n + p
//! ```
//!
//! B and e are mass and force that a joint feels; the tip starts with B = μ 1 and e = 0, and the root's acceleration is
//! (0, g), because the frame falls.

use std::marker::PhantomData;

/// What a scene has beyond rods: constants, so that what is not there costs nothing.
pub trait Scene {
    /// A rotary inertia besides that of the point masses.
    const INERTIA: bool = true;
    /// Mass centres beside the line between the ends.
    const OFF_AXIS: bool = false;
    /// Viscous torques in the joints, −c (difference of rates).
    const TORQUES: bool = false;
    /// Viscous forces at the outboard ends, −c v.
    const FORCES: bool = false;
    /// Sine and cosine of the system instead of the library's.
    const SYSTEM_SINE: bool = false;
}

/// Parameters, state, stores and accelerations of a chain; `V` is `[f64; N]` or `Vec<f64>`.
pub struct Chain<S, V> {
    pub gravity: f64,
    /// c, of torques or forces.
    pub damping: f64,
    pub length: V,
    /// J′.
    pub inertia: V,
    /// μ, all that is lumped in the joint at the inboard end of body i; what is lumped at the tip is `tip`.
    pub mass: V,
    pub tip: f64,
    /// First moment beside the axis, per length.
    pub beside: V,
    pub angle: V,
    pub rate: V,
    stores: Stores<V>,
    pub acceleration: V,
    scene: PhantomData<S>,
}

struct Stores<V> {
    arm: [V; 2],
    centripetal: [V; 2],
    per_acceleration: [V; 2],
    torque: V,
    force: [V; 2],
}

impl<S: Scene, V: Clone + AsRef<[f64]> + AsMut<[f64]>> Chain<S, V> {
    /// A chain of which `zero` says how many bodies it has.
    pub fn new(zero: &V) -> Self {
        let zero = || zero.clone();
        let stores = Stores {
            arm: [zero(), zero()],
            centripetal: [zero(), zero()],
            per_acceleration: [zero(), zero()],
            torque: zero(),
            force: [zero(), zero()],
        };
        Self {
            gravity: 0.0,
            damping: 0.0,
            length: zero(),
            inertia: zero(),
            mass: zero(),
            tip: 0.0,
            beside: zero(),
            angle: zero(),
            rate: zero(),
            stores,
            acceleration: zero(),
            scene: PhantomData,
        }
    }

    /// One sweep. Not inlined, as the library's is not.
    #[inline(never)]
    pub fn sweep(&mut self) {
        let Stores { arm: [x, y], centripetal: [p, q], per_acceleration: [wx, wy], torque, force: [fx, fy] } =
            &mut self.stores;
        let (angle, rate) = (self.angle.as_ref(), self.rate.as_ref());
        let (x, y, p, q) = (x.as_mut(), y.as_mut(), p.as_mut(), q.as_mut());
        directions::<S>(self.length.as_ref(), angle, rate, x, y, p, q);
        let (torque, fx, fy) = (torque.as_mut(), fx.as_mut(), fy.as_mut());
        if S::TORQUES {
            torques(self.damping, rate, torque);
        }
        if S::FORCES {
            forces(self.damping, rate, x, y, fx, fy);
        }
        let bodies = Bodies {
            inertia: self.inertia.as_ref(),
            mass: self.mass.as_ref(),
            beside: self.beside.as_ref(),
            x,
            y,
            p,
            q,
            torque,
            fx,
            fy,
        };
        walk::<S>(self.gravity, self.tip, bodies, wx.as_mut(), wy.as_mut(), self.acceleration.as_mut());
    }
}

/// a b + c, fused where the target can.
#[inline(always)]
fn fma(a: f64, b: f64, c: f64) -> f64 {
    if cfg!(target_feature = "fma") { a.mul_add(b, c) } else { a * b + c }
}

/// Leaves a function where slices differ in length, so that loops need no bounds checks.
macro_rules! same_length {
    ($n:ident: $($slice:expr),*) => {
        if false $(|| $slice.len() != $n)* {
            return;
        }
    };
}

/// Arms and centripetal accelerations. Slices are arguments, because of these alone the compiler knows that they do not
/// overlap.
#[inline(always)]
fn directions<S: Scene>(
    length: &[f64],
    angle: &[f64],
    rate: &[f64],
    x: &mut [f64],
    y: &mut [f64],
    p: &mut [f64],
    q: &mut [f64],
) {
    let n = angle.len();
    same_length!(n: length, rate, x, y, p, q);
    for i in 0..n {
        let (sine, cosine) = if S::SYSTEM_SINE { angle[i].sin_cos() } else { catena::Elementary::sin_cos(angle[i]) };
        let minus = -(rate[i] * rate[i]);
        x[i] = length[i] * cosine;
        y[i] = length[i] * sine;
        p[i] = minus * x[i];
        q[i] = minus * y[i];
    }
}

/// The sum of the torques that the joints at its ends exert on each body.
#[inline(always)]
fn torques(damping: f64, rate: &[f64], torque: &mut [f64]) {
    let n = rate.len();
    same_length!(n: torque);
    if n < 2 {
        return; // a single body has no walk
    }
    torque[0] = damping * (rate[1] - rate[0] - rate[0]);
    for i in 1..n - 1 {
        torque[i] = damping * ((rate[i + 1] - rate[i]) - (rate[i] - rate[i - 1]));
    }
    torque[n - 1] = damping * (rate[n - 2] - rate[n - 1]);
}

/// The forces at the outboard end of each body.
#[inline(always)]
fn forces(damping: f64, rate: &[f64], x: &[f64], y: &[f64], fx: &mut [f64], fy: &mut [f64]) {
    let n = rate.len();
    same_length!(n: x, y, fx, fy);
    let (mut vx, mut vy) = (0.0, 0.0);
    for i in 0..n {
        vx = fma(-rate[i], y[i], vx);
        vy = fma(rate[i], x[i], vy);
        fx[i] = -damping * vx;
        fy[i] = -damping * vy;
    }
}

/// What the walks read of the bodies.
#[derive(Clone, Copy)]
struct Bodies<'a> {
    inertia: &'a [f64],
    mass: &'a [f64],
    beside: &'a [f64],
    x: &'a [f64],
    y: &'a [f64],
    p: &'a [f64],
    q: &'a [f64],
    torque: &'a [f64],
    fx: &'a [f64],
    fy: &'a [f64],
}

impl Bodies<'_> {
    /// u, D and φ D of body i, and f with the body's own part in it, from n·u, u, n·f and f of what is outboard.
    #[inline(always)]
    fn reduce<S: Scene>(&self, i: usize, u: [f64; 2], f: [f64; 2]) -> ([f64; 2], f64, f64, [f64; 2]) {
        let Self { inertia, beside, x, y, p, q, torque, .. } = *self;
        let inertia = if S::INERTIA { inertia[i] } else { 0.0 };
        let pivot = match S::INERTIA {
            true => fma(-y[i], u[0], fma(x[i], u[1], inertia)),
            false => fma(-y[i], u[0], x[i] * u[1]),
        };
        let mut free = fma(y[i], f[0], -(x[i] * f[1]));
        if S::TORQUES {
            free += torque[i];
        }
        if S::OFF_AXIS {
            let r = beside[i];
            let u = [fma(-r, x[i], u[0]), fma(-r, y[i], u[1])];
            return (u, pivot, free, [fma(-r, q[i], f[0]), fma(r, p[i], f[1])]);
        }
        (u, pivot, free, f)
    }

    /// e with the force at the outboard end of body i.
    #[inline(always)]
    fn loaded<S: Scene>(&self, i: usize, e: [f64; 2]) -> [f64; 2] {
        if S::FORCES { [e[0] - self.fx[i], e[1] - self.fy[i]] } else { e }
    }
}

/// The walk inward and the walk outward.
#[inline(always)]
fn walk<S: Scene>(
    gravity: f64,
    tip: f64,
    bodies: Bodies<'_>,
    wx: &mut [f64],
    wy: &mut [f64],
    acceleration: &mut [f64],
) {
    let Bodies { inertia, mass, beside, x, y, p, q, torque, fx, fy } = bodies;
    let n = acceleration.len();
    same_length!(n: inertia, mass, beside, x, y, p, q, torque, fx, fy, wx, wy);
    if n < 2 {
        return; // a single body has no walk
    }
    let last = n - 1;

    // The tip: B = μ 1 and e = 0, or the force there. n·p = 0, so that its centripetal force turns nothing.
    let f = bodies.loaded::<S>(last, [tip * p[last], tip * q[last]]);
    let (u, pivot, free, f) = bodies.reduce::<S>(last, [-tip * y[last], tip * x[last]], f);
    let free = if S::FORCES || S::TORQUES { free } else { 0.0 };
    let inverse = 1.0 / pivot;
    let w = [u[0] * inverse, u[1] * inverse];
    let phi = free * inverse;
    (wx[last], wy[last], acceleration[last]) = (w[0], w[1], phi);
    let sum = tip + mass[last];
    let (mut xx, mut xy, mut yy) = (fma(-u[0], w[0], sum), -(u[0] * w[1]), fma(-u[1], w[1], sum));
    let mut e = if S::FORCES || S::TORQUES { [fma(phi, u[0], f[0]), fma(phi, u[1], f[1])] } else { f };

    // From last − 1 to 1, in a form in which the compiler sees that i < n.
    for i in (0..n - 2).rev().map(|i| i + 1) {
        let u = [fma(xy, x[i], -(xx * y[i])), fma(yy, x[i], -(xy * y[i]))];
        let g = bodies.loaded::<S>(i, e);
        let f = [fma(xx, p[i], fma(xy, q[i], g[0])), fma(xy, p[i], fma(yy, q[i], g[1]))];
        let (u, pivot, free, f) = bodies.reduce::<S>(i, u, f);
        let inverse = 1.0 / pivot;
        let w = [u[0] * inverse, u[1] * inverse];
        let phi = free * inverse;
        (wx[i], wy[i], acceleration[i]) = (w[0], w[1], phi);
        e = [fma(phi, u[0], f[0]), fma(phi, u[1], f[1])];
        (xx, xy, yy) = (fma(-u[0], w[0], xx + mass[i]), fma(-u[0], w[1], xy), fma(-u[1], w[1], yy + mass[i]));
    }

    // The root: nothing is handed on.
    let u = [fma(xy, x[0], -(xx * y[0])), fma(yy, x[0], -(xy * y[0]))];
    let g = bodies.loaded::<S>(0, e);
    let f = [fma(xx, p[0], fma(xy, q[0], g[0])), fma(xy, p[0], fma(yy, q[0], g[1]))];
    let (u, pivot, free, _) = bodies.reduce::<S>(0, u, f);
    acceleration[0] = fma(-u[1], gravity, free) / pivot;
    let mut a = [fma(-acceleration[0], y[0], p[0]), fma(acceleration[0], x[0], q[0] + gravity)];

    for i in 1..last {
        let angular = fma(-wx[i], a[0], fma(-wy[i], a[1], acceleration[i]));
        acceleration[i] = angular;
        a = [fma(-angular, y[i], a[0] + p[i]), fma(angular, x[i], a[1] + q[i])];
    }
    acceleration[last] = fma(-wx[last], a[0], fma(-wy[last], a[1], acceleration[last]));
}
