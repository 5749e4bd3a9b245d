//! Digits that the paper's two solvers keep: one step of the chain of its section 5.5, bent and moving at the start, against the same
//! step in double-double arithmetic.
//!
//! `cargo bench --bench paper_digits` prints errors of the increments Δθ of the step (rad). They are read as differences of angles near
//! 1 rad, which round to 5e-17 and 3e-8 by themselves.

use catena::element::Unloaded;
use catena::paper::*;
use catena::planar::{ElasticHinge, Free, Pinned, Rod, System};
use catena::{Real, Scalar};
use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{One, Zero};

/// A double-double number: a sum of two f64 that do not overlap, some 32 digits.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Twice(f64, f64);

fn two_sum(a: f64, b: f64) -> Twice {
    let sum = a + b;
    let part = sum - a;
    Twice(sum, (a - (sum - part)) + (b - part))
}

impl Add for Twice {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (two_sum(self.0, other.0), two_sum(self.1, other.1));
        let sum = two_sum(high.0, high.1 + low.0);
        two_sum(sum.0, sum.1 + low.1)
    }
}
impl Neg for Twice {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}
impl Sub for Twice {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
impl Mul for Twice {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = self.0 * other.0;
        let rest = f64::mul_add(self.0, other.0, -product);
        two_sum(product, rest + (self.0 * other.1 + self.1 * other.0))
    }
}
impl Div for Twice {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = Self(self.0 / other.0, 0.0);
        let left = self - first * other;
        let second = Self(left.0 / other.0, 0.0);
        let left = left - second * other;
        first + second + Self(left.0 / other.0, 0.0)
    }
}
impl AddAssign for Twice {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
impl SubAssign for Twice {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}
impl MulAssign for Twice {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}
impl Zero for Twice {
    fn zero() -> Self {
        Self(0.0, 0.0)
    }
    fn is_zero(&self) -> bool {
        self.0 == 0.0
    }
}
impl One for Twice {
    fn one() -> Self {
        Self(1.0, 0.0)
    }
}
impl PartialOrd for Twice {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        (*self - *other).0.partial_cmp(&0.0)
    }
}
impl fmt::Display for Twice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl Scalar for Twice {
    type Real = Self;
    const ANGLE_RANGE: Self = Self(10.0, 0.0);
    fn constant(value: Self) -> Self {
        value
    }
    fn real(self) -> Self {
        self
    }
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
    fn scale(self, factor: Self) -> Self {
        self * factor
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
    fn recip(self) -> Self {
        Self::one() / self
    }
    fn sqrt(self) -> Self {
        let root = Self(self.0.sqrt(), 0.0);
        root + (self - root * root) / (root + root)
    }
    /// Series at a quarter of the angle, doubled twice.
    fn sin_cos(self) -> (Self, Self) {
        let x = self * Self(0.25, 0.0);
        let (mut sine, mut cosine, mut term) = (Self::zero(), Self::zero(), Self::one());
        for k in 1..36 {
            match k % 4 {
                1 => cosine += term,
                2 => sine += term,
                3 => cosine -= term,
                _ => sine -= term,
            }
            term = term * x / Self(f64::from(k), 0.0);
        }
        for _ in 0..2 {
            let both = sine * cosine;
            cosine = Self::one() - (sine * sine + sine * sine);
            sine = both + both;
        }
        (sine, cosine)
    }
    fn atan2(self, x: Self) -> Self {
        Self(self.0.atan2(x.0), 0.0) // not used here
    }
}

impl Real for Twice {
    const EPSILON: Self = Self(1e-31, 0.0);
    const INFINITY: Self = Self(f64::INFINITY, 0.0);
    fn of(value: f64) -> Self {
        Self(value, 0.0)
    }
    fn as_f64(self) -> f64 {
        self.0
    }
    fn abs(self) -> Self {
        if self.0 < 0.0 { -self } else { self }
    }
    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
    fn powf(self, exponent: Self) -> Self {
        Self(self.0.powf(exponent.0), 0.0)
    }
}

/// The increments of all angles in a step, and the largest entry of the overall matrix (0 without a product).
macro_rules! step {
    ($T:ty, $n:expr, $dt:expr, $solver:expr) => {{
        let n: usize = $n;
        let number = |x: f64| <$T as Scalar>::literal(x);
        let size = number(1.0) / number(n as f64);
        let rod = Rod::uniform(size, size);
        let links = vec![(ElasticHinge::rotary(number(20.0)), rod); n - 1];
        let scene = System::new(Pinned::origin(), (rod, links), Free)?.with_gravity(number(9.81));
        // Numbers of f32, so that every number starts from the same motion.
        let single = |x: f64| number(f64::from(x as f32));
        let angles: Vec<$T> = (0..n).map(|k| single(-1.0 + 0.3 * k as f64 / n as f64)).collect();
        let mut rates = vec![single(1.0)];
        rates.extend((1..n).map(|k| single(0.5 / n as f64 * (k as f64).cos())));
        let start = scene.with_rates(scene.at_rest(&angles)?, &rates)?;
        let scheme = Scheme::new(Newmark::new(0.25, 0.5)).solved_by($solver);
        let mut run = scheme.start(&scene, &start, &Unloaded, <<$T as Scalar>::Real as Real>::of($dt))?;
        let outcome = run.step();
        let steps: Vec<Twice> = match outcome {
            Ok(()) => run.angles().zip(&angles).map(|(a, b)| Twice((a - *b).real().as_f64(), 0.0)).collect(),
            Err(_) => vec![Twice(f64::NAN, 0.0); n],
        };
        let mut whole = catena::TransferMatrix::<$T, 7>::identity();
        for matrix in run.matrices().iter().skip(1) {
            whole = whole.then(matrix);
        }
        let largest = whole.as_matrix().iter().fold(0.0_f64, |largest, x| largest.max(x.real().as_f64().abs()));
        Ok::<_, catena::Error>((steps, largest))
    }};
}

fn main() -> Result<(), catena::Error> {
    println!(
        "Errors (rad) of Δθ in one step of the printed scheme, chain of section 5.5; lost: no digit of the largest Δθ is left.\n"
    );
    println!("     step        n     max |U|   f64 product   f64 Riccati   f32 product   f32 Riccati   largest Δθ");
    for dt in [1e-2, 1e-3, 1e-4] {
        for n in [2, 5, 10, 20, 100, 1000, 100_000] {
            let (exact, _) = step!(Twice, n, dt, Solver::Riccati)?;
            let size = exact.iter().fold(0.0_f64, |size, x| size.max(x.0.abs()));
            let error = |found: &[Twice]| {
                let worst = found.iter().zip(&exact).fold(0.0_f64, |worst, (a, b)| worst.max((*a - *b).0.abs()));
                let finite = found.iter().all(|x| x.0.is_finite());
                if !finite {
                    "NaN".to_owned()
                } else if worst > size {
                    "lost".to_owned()
                } else {
                    format!("{worst:.0e}")
                }
            };
            let (product, largest) = step!(f64, n, dt, Solver::Product)?;
            let (riccati, _) = step!(f64, n, dt, Solver::Riccati)?;
            let (short_product, _) = step!(f32, n, dt, Solver::Product)?;
            let (short_riccati, _) = step!(f32, n, dt, Solver::Riccati)?;
            let [a, b, c, d] = [&product, &riccati, &short_product, &short_riccati].map(|found| error(found));
            println!("  {dt:7.0e} {n:8} {largest:11.0e} {a:>13} {b:>13} {c:>13} {d:>13} {size:12.0e}");
        }
    }
    Ok(())
}
