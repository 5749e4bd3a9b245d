//! Double-double numbers, some 32 digits, as scalars of scenes: what rounding is measured against.

use catena::{Elementary, Real, Scalar};
use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{One, Zero};

/// A double-double number: a sum of two f64 that do not overlap, some 32 digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twice(pub f64, pub f64);

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

impl Elementary for Twice {
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
