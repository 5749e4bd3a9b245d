//! Power series as numbers: what a function of time is made of around an instant.

mod functions;

use super::made::of_numbers;
use super::{Real, Scalar};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// As many coefficients as a series may have.
const ROOM: usize = 32;

/// 1 / k.
const SHARES: [f64; ROOM] = {
    let (mut shares, mut k) = ([0.0; ROOM], 1);
    while k < ROOM {
        shares[k] = 1.0 / k as f64;
        k += 1;
    }
    shares
};

/// The first `N` coefficients of a power series, up to 32: a number as any other, by the series of what is made of it. Decisions are made on the first.
///
/// A polynomial of the variable, as what stands inside a sine mostly is, has few coefficients, and whatever multiplies by it few products.
///
/// ```
/// use catena::scalar::{Elementary, Powers, Scalar};
/// let time = Powers::<f64, 4>::variable(0.0, 4);
/// let (sine, _) = (time * Powers::constant(2.0)).sin_cos();
/// assert_eq!(sine.terms(), [0.0, 2.0, 0.0, -8.0 / 6.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Powers<T, const N: usize> {
    terms: [T; N],
    /// How many of them there are; the others are zero, or nobody asks for them.
    count: usize,
    /// How many are asked for.
    asked: usize,
}

impl<T: Scalar, const N: usize> Powers<T, N> {
    /// What does not change.
    pub fn of(value: T) -> Self {
        Self::polynomial(1, N, |_| value)
    }

    /// The variable itself around a value, if as many coefficients are asked for of all that is made of it: fewer take less time.
    pub fn variable(value: T, asked: usize) -> Self {
        const { assert!(N <= ROOM) };
        Self::polynomial(2, asked.min(N), |k| if k == 0 { value } else { T::one() })
    }

    /// A series of which some coefficients are known, and no others asked for.
    pub(crate) fn up_to(known: &[T]) -> Self {
        Self::polynomial(known.len(), known.len(), |k| known[k])
    }

    /// The coefficients asked for, and zeros.
    pub fn terms(self) -> [T; N] {
        self.terms
    }

    /// A series of `count` coefficients, or of as many as are asked for.
    #[inline(always)]
    pub(crate) fn polynomial(count: usize, asked: usize, mut each: impl FnMut(usize) -> T) -> Self {
        let (mut terms, count) = ([T::zero(); N], count.min(asked));
        for (k, term) in terms[..count].iter_mut().enumerate() {
            *term = each(k);
        }
        Self { terms, count, asked }
    }

    fn first(&self) -> T {
        self.terms.first().copied().unwrap_or(T::zero())
    }

    /// The number of the last coefficient that is there.
    fn degree(&self) -> usize {
        self.count.saturating_sub(1)
    }

    /// How many coefficients a function of this one has.
    fn composed(&self) -> usize {
        if self.degree() == 0 { 1 } else { self.asked }
    }

    /// A series of which coefficient number k follows from those before it.
    fn solved(count: usize, asked: usize, first: T, mut next: impl FnMut(usize, &[T; N]) -> T) -> Self {
        let (mut terms, count) = ([T::zero(); N], count.min(asked));
        for k in 0..count {
            terms[k] = if k == 0 { first } else { next(k, &terms) };
        }
        Self { terms, count, asked }
    }

    /// Σ x_j y_{k−j}: coefficient number k of the product of this series and another.
    #[inline(always)]
    fn convolved(&self, y: &[T; N], k: usize) -> T {
        let most = k.min(self.degree());
        if most == 0 {
            return self.first() * y[k];
        }
        let products = self.terms[..=most].iter().zip(y[k - most..=k].iter().rev());
        products.fold(T::zero(), |sum, (x, y)| x.mul_add(*y, sum))
    }

    /// Coefficient number k of y where y′ = x′ y of another y, and x′ is this.
    #[inline(always)]
    fn chained(&self, y: &[T; N], k: usize) -> T {
        self.convolved(y, k - 1).scale(T::Real::of(SHARES[k]))
    }

    /// A function of a value and of a slope, which is known.
    pub(crate) fn integral(first: T, slope: Self) -> Self {
        let of = |k: usize| slope.terms[k - 1].scale(T::Real::of(SHARES[k]));
        Self::polynomial(slope.count + 1, slope.asked, |k| if k == 0 { first } else { of(k) })
    }

    /// The derivative; of the last coefficient nobody asks.
    fn derivative(self) -> Self {
        let of = |k: usize| self.terms.get(k + 1).map_or(T::zero(), |x| x.scale(T::Real::of((k + 1) as f64)));
        Self::polynomial(self.degree().max(1), self.asked, of)
    }

    /// Each coefficient alone.
    fn map(self, mut each: impl FnMut(T) -> T) -> Self {
        Self::polynomial(self.count, self.asked, |k| each(self.terms[k]))
    }

    /// Coefficients of two series in pairs.
    fn zip(self, other: Self, mut pair: impl FnMut(T, T) -> T) -> Self {
        Self::polynomial(self.count.max(other.count), self.asked.min(other.asked), |k| {
            pair(self.terms[k], other.terms[k])
        })
    }
}

of_numbers!(Powers<T, N>);

impl<T: Scalar, const N: usize> Neg for Powers<T, N> {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

impl<T: Scalar, const N: usize> Add for Powers<T, N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl<T: Scalar, const N: usize> Sub for Powers<T, N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl<T: Scalar, const N: usize> Mul for Powers<T, N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (few, many) = if self.count < other.count { (&self, &other) } else { (&other, &self) };
        let asked = self.asked.min(other.asked);
        let (mut terms, count) = ([T::zero(); N], (few.degree() + many.count).min(asked));
        // One loop for each of the few, which vectorises.
        for (j, x) in few.terms[..few.count.min(count)].iter().enumerate() {
            for (term, y) in terms[j..count].iter_mut().zip(&many.terms) {
                *term = x.mul_add(*y, *term);
            }
        }
        Self { terms, count, asked }
    }
}

impl<T: Scalar, const N: usize> Div for Powers<T, N> {
    type Output = Self;
    #[allow(clippy::suspicious_arithmetic_impl)] // a recursion
    fn div(self, other: Self) -> Self {
        let (count, asked) = (self.count.max(other.composed()), self.asked.min(other.asked));
        Self::solved(count, asked, self.first() / other.first(), |k, quotient| {
            let products = 1..=k.min(other.degree());
            products.fold(self.terms[k], |sum, j| sum - other.terms[j] * quotient[k - j]) / other.first()
        })
    }
}
