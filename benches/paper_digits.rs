//! Digits that the paper's solvers keep: one step of the chain of its section 5.5, bent and moving at the start, against the same step in
//! double-double arithmetic.
//!
//! `cargo bench --bench paper_digits` prints errors of the increments Δθ of the step, as shares of the largest: by the plain product, by the
//! Riccati transform of the same matrices in absolute coordinates, and by the transform in increments. Increments are read from rates,
//! θ̇ = χ₃Δθ + .., for differences of angles near 1 rad round to 1e-16 by themselves.
//!
//! Read like this the errors are those of another implementation to an order of magnitude (n = 2, 5, 10 at 1 ms, by the product: 9e-10, 4e-4,
//! 0.7 here, 5.5e-9, 2.4e-3, 0.07 there). What is left is of the bend and the rates at the start, which the paper does not say: they set by
//! how much entries of U grow, here 4 to 25 times more than there.

use catena::loading::Unloaded;
use catena::paper::*;
use catena::planar::{ElasticHinge, Free, Pinned, Rod, System};
use catena::{Real, Scalar, TransferMatrix};
use core::array::from_fn;
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
    fn exp(self) -> Self {
        Self(self.0.exp(), 0.0) // nor are these three
    }
    fn ln(self) -> Self {
        Self(self.0.ln(), 0.0)
    }
    fn tanh(self) -> Self {
        Self(self.0.tanh(), 0.0)
    }
    fn abs(self) -> Self {
        if self.0 < 0.0 { -self } else { self }
    }
    fn sign(self) -> Self {
        Self(Scalar::sign(self.0), 0.0)
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

/// Matrices of a chain, root to tip, solved by the Riccati transform as they are: f = S p + e with a general element
/// [A B a; C D d], from a root where x, y and m are known to a free tip. Gives θ at the inboard end of each.
fn transformed<T: Scalar>(matrices: &[TransferMatrix<T, 7>], [x, y]: [T; 2]) -> Vec<T> {
    let zero = T::zero();
    let (mut s, mut e) = ([[zero; 3]; 3], [zero; 3]);
    let mut relations = vec![(s, e)];
    for u in matrices.iter().rev() {
        // (D − S B) f_I = (S A − C) p_I + S a + e − d
        let entry = |i: usize, j: usize| u[(i, j)];
        let times = |i: usize, column: usize| (0..3).fold(zero, |sum, k| sum + s[i][k] * entry(k, column));
        let left: [[T; 3]; 3] = from_fn(|i| from_fn(|j| entry(3 + i, 3 + j) - times(i, 3 + j)));
        let right: [[T; 4]; 3] = from_fn(|i| {
            from_fn(|j| if j < 3 { times(i, j) - entry(3 + i, j) } else { times(i, 6) + e[i] - entry(3 + i, 6) })
        });
        let inverse = inverse(&left);
        let solved: [[T; 4]; 3] =
            from_fn(|i| from_fn(|j| (0..3).fold(zero, |sum, k| sum + inverse[i][k] * right[k][j])));
        (s, e) = (solved.map(|row| [row[0], row[1], row[2]]), solved.map(|row| row[3]));
        relations.push((s, e));
    }
    let mut p = [x, y, -((s[0][0] * x + s[0][1] * y + e[0]) / s[0][2])];
    let mut angles = vec![];
    for (u, (s, e)) in matrices.iter().zip(relations.iter().rev()) {
        angles.push(p[2]);
        let f: [T; 3] = from_fn(|i| (0..3).fold(e[i], |sum, k| sum + s[i][k] * p[k]));
        p = from_fn(|i| (0..3).fold(u[(i, 6)], |sum, k| sum + u[(i, k)] * p[k] + u[(i, 3 + k)] * f[k]));
    }
    angles
}

fn inverse<T: Scalar>(a: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    let minor = |i: usize, j: usize| {
        let (i1, i2, j1, j2) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1]
    };
    let determinant = (0..3).fold(T::zero(), |sum, j| sum + a[0][j] * minor(0, j));
    from_fn(|i| from_fn(|j| minor(j, i) / determinant))
}

/// The increments of all angles in a step, by a solver and by [`transformed`] of its matrices, and the largest entry of the overall
/// matrix (0 without a product).
macro_rules! step {
    ($T:ty, $n:expr, $dt:expr, $solver:expr) => {{
        let n: usize = $n;
        let number = |x: f64| <$T as Scalar>::literal(x);
        let real = |x: f64| <<$T as Scalar>::Real as Real>::of(x);
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
        let rule = Newmark::new(0.25, 0.5);
        let mut run = Scheme::new(rule).solved_by($solver).start(&scene, &start, &Unloaded, real($dt))?;
        let before: Vec<[$T; 3]> = run.turns().collect();
        let outcome = run.step();
        // (2) the other way round.
        let increment = |([value, rate, acceleration], [_, now, _]): ([$T; 3], [$T; 3])| {
            let linear = Rule::<$T>::linearize(&rule, &rule.start(value, rate, acceleration, real($dt)), real($dt));
            wide((now - linear.rate) / number(2.0) * number($dt))
        };
        let lost = vec![Twice(f64::NAN, 0.0); n];
        let steps = outcome.map_or(lost.clone(), |()| before.into_iter().zip(run.turns()).map(increment).collect());
        let matrices = run.matrices();
        let (mut whole, mut absolute) = (TransferMatrix::<$T, 7>::identity(), lost);
        for matrix in matrices.iter().skip(1) {
            whole = whole.then(matrix);
        }
        if matrices.len() > 1 {
            let found = transformed(&matrices[1..], [number(0.0); 2]);
            absolute = found.iter().step_by(2).zip(&angles).map(|(after, before)| wide(*after - *before)).collect();
        }
        // Where it overflows entries are infinite, or NaN.
        let sizes = whole.as_matrix().iter().map(|x| x.real().as_f64().abs());
        let largest = sizes.fold(0.0_f64, |largest, x| if x.is_nan() { f64::INFINITY } else { largest.max(x) });
        Ok::<_, catena::Error>((steps, absolute, largest))
    }};
}

fn wide<T: Scalar>(x: T) -> Twice {
    Twice(x.real().as_f64(), 0.0)
}

fn main() -> Result<(), catena::Error> {
    println!(
        "Errors of Δθ in one step of the printed scheme, chain of section 5.5, as shares of the largest Δθ (rad); lost: more than one.\n"
    );
    println!("                              f64                              f32");
    println!(
        "     step        n   max |U|  product  absolute increments     product  absolute increments   largest Δθ"
    );
    for dt in [1e-2, 1e-3, 1e-4] {
        for n in [2, 5, 10, 20, 100, 1000, 100_000] {
            let (exact, ..) = step!(Twice, n, dt, Solver::Riccati)?;
            let size = exact.iter().fold(0.0_f64, |size, x| size.max(x.0.abs()));
            let error = |found: &[Twice]| {
                let worst = found.iter().zip(&exact).fold(0.0_f64, |worst, (a, b)| worst.max((*a - *b).0.abs())) / size;
                let finite = found.iter().all(|x| x.0.is_finite());
                if !finite {
                    "NaN".to_owned()
                } else if worst > 1.0 {
                    "lost".to_owned()
                } else {
                    format!("{worst:.0e}")
                }
            };
            let (product, absolute, largest) = step!(f64, n, dt, Solver::Product)?;
            let (increments, ..) = step!(f64, n, dt, Solver::Riccati)?;
            let (short_product, short_absolute, _) = step!(f32, n, dt, Solver::Product)?;
            let (short_increments, ..) = step!(f32, n, dt, Solver::Riccati)?;
            let [a, b, c] = [&product, &absolute, &increments].map(|found| error(found));
            let [d, e, f] = [&short_product, &short_absolute, &short_increments].map(|found| error(found));
            println!("  {dt:7.0e} {n:8} {largest:9.0e} {a:>8} {b:>9} {c:>10}    {d:>8} {e:>9} {f:>10} {size:12.0e}");
        }
    }
    Ok(())
}
