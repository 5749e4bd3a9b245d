//! Power series as numbers: what a function of time is made of around an instant.

use super::made::of_numbers;
use super::{Elementary, Real, Scalar};
use core::array::from_fn;
use core::ops::{Add, Div, Mul, Neg, Sub};
use num_traits::One;

/// The first `N` coefficients of a power series. Decisions are made on the first.
///
/// Functions obey the differential equations that define them (R. E. Moore, Interval Analysis, 1966, chapter 11).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Powers<T, const N: usize>(pub [T; N]);

impl<T: Scalar, const N: usize> Powers<T, N> {
    /// What does not change.
    fn of(value: T) -> Self {
        Self(from_fn(|k| if k == 0 { value } else { T::zero() }))
    }

    /// The variable itself around a value.
    pub fn variable(value: T) -> Self {
        Self(from_fn(|k| match k {
            0 => value,
            1 => T::one(),
            _ => T::zero(),
        }))
    }

    fn first(&self) -> T {
        self.0.first().copied().unwrap_or(T::zero())
    }

    /// A series whose coefficient number k follows from those before it.
    fn solved(first: T, mut next: impl FnMut(usize, &[T; N]) -> T) -> Self {
        let mut all = [T::zero(); N];
        for k in 0..N {
            all[k] = if k == 0 { first } else { next(k, &all) };
        }
        Self(all)
    }

    /// Σ j x_j y_{k−j} / k, j from 1 on: coefficient number k of y where y′ = x′ y of another y.
    fn chained(&self, y: &[T; N], k: usize) -> T {
        let terms = (1..=k).fold(T::zero(), |sum, j| sum.add_scaled(T::Real::of(j as f64), self.0[j] * y[k - j]));
        terms.scale(T::Real::of(1.0 / k as f64))
    }

    /// A function of a value and of a slope, which is known.
    fn integral(first: T, slope: Self) -> Self {
        Self::solved(first, |k, _| slope.0[k - 1].scale(T::Real::of(1.0 / k as f64)))
    }

    /// The derivative; of the last coefficient nobody asks.
    fn derivative(self) -> Self {
        Self(from_fn(|k| self.0.get(k + 1).map_or(T::zero(), |x| x.scale(T::Real::of((k + 1) as f64)))))
    }
}

of_numbers!(Powers<T, N>);

impl<T: Scalar, const N: usize> Neg for Powers<T, N> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(|x| -x))
    }
}

impl<T: Scalar, const N: usize> Add for Powers<T, N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl<T: Scalar, const N: usize> Sub for Powers<T, N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl<T: Scalar, const N: usize> Mul for Powers<T, N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(from_fn(|k| (0..=k).fold(T::zero(), |sum, j| self.0[j].mul_add(other.0[k - j], sum))))
    }
}

impl<T: Scalar, const N: usize> Div for Powers<T, N> {
    type Output = Self;
    #[allow(clippy::suspicious_arithmetic_impl)] // a recursion
    fn div(self, other: Self) -> Self {
        Self::solved(self.first() / other.first(), |k, quotient| {
            let known = (1..=k).fold(self.0[k], |sum, j| sum - other.0[j] * quotient[k - j]);
            known / other.0[0]
        })
    }
}

impl<T: Scalar, const N: usize> Elementary for Powers<T, N> {
    fn sqrt(self) -> Self {
        let first = self.first().sqrt();
        let half = first.recip().scale(T::Real::of(0.5));
        Self::solved(first, |k, root| (1..k).fold(self.0[k], |sum, j| sum - root[j] * root[k - j]) * half)
    }
    fn sin_cos(self) -> (Self, Self) {
        let (mut sine, mut cosine) = ([T::zero(); N], [T::zero(); N]);
        for k in 0..N {
            (sine[k], cosine[k]) = match k {
                0 => self.0[0].sin_cos(),
                _ => (self.chained(&cosine, k), -self.chained(&sine, k)),
            };
        }
        (Self(sine), Self(cosine))
    }
    fn atan2(self, x: Self) -> Self {
        let slope = (x * self.derivative() - self * x.derivative()) / (x * x + self * self);
        Self::integral(self.first().atan2(x.first()), slope)
    }
    fn exp(self) -> Self {
        Self::solved(self.first().exp(), |k, all| self.chained(all, k))
    }
    fn ln(self) -> Self {
        Self::integral(self.first().ln(), self.derivative() / self)
    }
    fn tanh(self) -> Self {
        // y′ = x′ (1 − y²), whose coefficients up to k − 1 are known where y's are.
        let (mut all, mut rest) = ([T::zero(); N], [T::zero(); N]);
        for k in 0..N {
            all[k] = if k == 0 { self.0[0].tanh() } else { self.chained(&rest, k) };
            let square = (0..=k).fold(T::zero(), |sum, j| all[j].mul_add(all[k - j], sum));
            rest[k] = if k == 0 { (T::one() - all[0]) * (T::one() + all[0]) } else { -square };
        }
        Self(all)
    }
}

impl<T: Scalar, const N: usize> Scalar for Powers<T, N> {
    type Real = T::Real;
    const ANGLE_RANGE: T::Real = T::ANGLE_RANGE;
    const LANES: bool = T::LANES;

    fn constant(value: T::Real) -> Self {
        Self::of(T::constant(value))
    }
    fn real(self) -> T::Real {
        self.first().real()
    }
    fn is_finite(self) -> bool {
        self.0.iter().all(|x| x.is_finite())
    }
    fn scale(self, factor: T::Real) -> Self {
        Self(self.0.map(|x| x.scale(factor)))
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
    fn recip(self) -> Self {
        Self::one() / self
    }
    fn if_negative(self, then: Self, otherwise: Self) -> Self {
        Self(core::array::from_fn(|k| self.first().if_negative(then.0[k], otherwise.0[k])))
    }
    fn abs(self) -> Self {
        Self(self.0.map(|x| x * self.first().sign()))
    }
    fn sign(self) -> Self {
        Self::of(self.first().sign())
    }
}

#[cfg(test)]
mod tests {
    use super::{Elementary, Powers, Scalar};
    use num_traits::One;

    type Ten = Powers<f64, 10>;

    fn near(name: &str, a: Ten, b: Ten) {
        for (k, (a, b)) in a.0.iter().zip(b.0).enumerate() {
            assert!((a - b).abs() < 1e-13 * (1.0 + b.abs()), "{name}, {k}: {a} {b}");
        }
    }

    #[test]
    fn known_series_are_found() {
        let t = Ten::variable(0.0);
        let mut factorial = 1.0;
        for (k, coefficient) in t.exp().0.iter().enumerate() {
            factorial *= k.max(1) as f64;
            assert!((coefficient * factorial - 1.0).abs() < 1e-15);
        }
        near("geometric", (Ten::one() - t).recip(), Powers([1.0; 10]));
        let (sine, cosine) = t.sin_cos();
        near(
            "sine",
            sine,
            Powers([0.0, 1.0, 0.0, -1.0 / 6.0, 0.0, 1.0 / 120.0, 0.0, -1.0 / 5040.0, 0.0, 1.0 / 362_880.0]),
        );
        near("sine's slope", sine.derivative(), cosine.cut());
        let third = 1.0 / 3.0;
        near(
            "tangent",
            t.tanh(),
            Powers([0.0, 1.0, 0.0, -third, 0.0, 2.0 / 15.0, 0.0, -17.0 / 315.0, 0.0, 62.0 / 2835.0]),
        );
    }

    impl Ten {
        /// Without the last coefficient, which a derivative does not know.
        fn cut(mut self) -> Self {
            self.0[9] = 0.0;
            self
        }
    }

    #[test]
    fn inverse_functions_lead_back() {
        let x = Powers([0.7, -1.1, 0.4, 0.3, -0.2, 0.1, 0.5, -0.6, 0.2, 0.1]);
        near("root", x.sqrt() * x.sqrt(), x);
        near("logarithm", x.ln().exp(), x);
        near("quotient", x / (x + Ten::one()) * (x + Ten::one()), x);
        let (sine, cosine) = x.sin_cos();
        near("angle", sine.atan2(cosine), x);
        near("circle", sine * sine + cosine * cosine, Ten::one());
        let square = (x + x).exp();
        near("hyperbola", x.tanh(), (square - Ten::one()) / (square + Ten::one()));
        near("magnitude", (-x).abs(), x);
        near("power", x.powi(3), x * x * x);
    }
}
