//! A value with `K` first derivatives: dual numbers without an allocation, an option or a branch.

use super::made::of_numbers;
use super::{Elementary, Real, Scalar};
use core::array::from_fn;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A value and its derivatives with respect to `K` seeds.
///
/// It is a [`Scalar`] like any other: a scene of such numbers is differentiated wherever it is computed. Under a rule that goes
/// `through_gains` it is so for fewer operations.
///
/// Values are those of the plain number, bit for bit. Two jets are equal where all their parts are.
///
/// # What derivatives cost
///
/// Instructions of a step of RK4 over jets with `K` derivatives, in plain steps of the same scene (–: not counted):
///
/// | scene | target | K = 1 | 2 | 4 | 5 | 8 | 16 |
/// |---|---|---:|---:|---:|---:|---:|---:|
/// | 2 rods on pins | x86-64 | 3.1 | 3.5 | 5.1 | 6.2 | 8.0 | 15 |
/// | 20 rods on pins | x86-64 | 3.1 | 3.7 | 5.3 | 7.5 | 9.0 | 16 |
/// | a cart that slides, 2 rods on pins | x86-64 | 2.6 | 3.0 | 4.5 | 6.0 | 10 | 25 |
/// | 3 rods on balls in space | x86-64 | 3.6 | 4.3 | 7.7 | 11 | 14 | 35 |
/// | 2 rods on pins | x86-64-v3 | 2.7 | 3.1 | 3.3 | 4.5 | 4.5 | 7.3 |
/// | 20 rods on pins | x86-64-v3 | 3.8 | 4.5 | 4.9 | 8.2 | 7.6 | 12 |
/// | a cart that slides, 2 rods on pins | x86-64-v3 | 2.5 | 3.0 | 3.1 | 4.2 | 4.5 | 11 |
/// | 3 rods on balls in space | x86-64-v3 | 3.2 | 4.4 | 3.8 | – | – | 20 |
///
/// The default target takes two numbers an instruction, x86-64-v3 (`-C target-cpu=x86-64-v3`) takes four and fuses products with sums:
/// building for it halves the cost, and there multiples of 4 pay best. All registers together hold two jets of 16 on the former, four on
/// the latter; what a joint computes at once beyond that goes through memory. So two runs over 8 derivatives are cheaper than one over 16
/// where joints slide and, on the default target, in space; on pins they are dearer. Many derivatives of open chains and trees are cheapest
/// [through kept gains](crate::time::Rule::through_gains).
///
/// ```
/// use catena::scalar::{Jet, Scalar};
/// let [x, y] = [Jet::<f64, 2>::seed(0.5, 0), Jet::seed(2.0, 1)];
/// let square = x * x * y;
/// assert_eq!((square.re, square.eps), (0.5, [2.0, 0.25]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet<T, const K: usize> {
    /// The value.
    pub re: T,
    /// The derivatives.
    pub eps: [T; K],
}

impl<T: Scalar, const K: usize> Jet<T, K> {
    /// A value that does not change.
    #[inline(always)]
    pub fn of(re: T) -> Self {
        Self { re, eps: [T::zero(); K] }
    }

    /// The value of seed `k`: its derivative with respect to that one is 1. Beyond `K` it is a constant.
    pub fn seed(re: T, k: usize) -> Self {
        Self { re, eps: from_fn(|i| if i == k { T::one() } else { T::zero() }) }
    }

    /// `f(self)`, given f and f′ at the value.
    #[inline(always)]
    fn compose(self, value: T, slope: T) -> Self {
        Self { re: value, eps: each(|k| self.eps[k] * slope) }
    }
}

of_numbers!(Jet<T, K>);

impl<T: Scalar, const K: usize> Neg for Jet<T, K> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { re: -self.re, eps: each(|k| -self.eps[k]) }
    }
}

impl<T: Scalar, const K: usize> Add for Jet<T, K> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, eps: each(|k| self.eps[k] + other.eps[k]) }
    }
}

impl<T: Scalar, const K: usize> Sub for Jet<T, K> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, eps: each(|k| self.eps[k] - other.eps[k]) }
    }
}

impl<T: Scalar, const K: usize> Mul for Jet<T, K> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let eps = each(|k| self.eps[k].mul_add(other.re, other.eps[k] * self.re));
        Self { re: self.re * other.re, eps }
    }
}

impl<T: Scalar, const K: usize> Div for Jet<T, K> {
    type Output = Self;
    #[inline(always)]
    #[allow(clippy::suspicious_arithmetic_impl)] // times a reciprocal, which all derivatives share
    fn div(self, other: Self) -> Self {
        let (re, inverse) = (self.re / other.re, other.re.recip());
        Self { re, eps: each(|k| (-re).mul_add(other.eps[k], self.eps[k]) * inverse) }
    }
}

impl<T: Scalar, const K: usize> Elementary for Jet<T, K> {
    #[inline(always)]
    fn sqrt(self) -> Self {
        let value = self.re.sqrt();
        self.compose(value, value.recip().scale(T::Real::of(0.5)))
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.re.sin_cos();
        (self.compose(sine, cosine), self.compose(cosine, -sine))
    }
    #[cfg_attr(optimised, inline(always))]
    fn atan2(self, x: Self) -> Self {
        // Divided by the larger coordinate first: neither very long nor very short vectors overflow.
        let length = if T::LANES {
            let (x, y) = (x.re.abs(), self.re.abs());
            (x - y).if_negative(y, x)
        } else {
            T::constant(Real::max(Scalar::abs(x.re.real()), Scalar::abs(self.re.real())))
        };
        let (across, along) = (self.re / length, x.re / length);
        let inverse = (across.mul_add(across, along * along) * length).recip();
        let eps = each(|k| (along * self.eps[k] - across * x.eps[k]) * inverse);
        Self { re: self.re.atan2(x.re), eps }
    }
    #[inline(always)]
    fn exp(self) -> Self {
        let value = self.re.exp();
        self.compose(value, value)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        self.compose(self.re.ln(), self.re.recip())
    }
    #[inline(always)]
    fn tanh(self) -> Self {
        let value = self.re.tanh();
        self.compose(value, (T::one() - value) * (T::one() + value))
    }
}

impl<T: Scalar, const K: usize> Scalar for Jet<T, K> {
    type Real = T::Real;
    const ANGLE_RANGE: T::Real = T::ANGLE_RANGE;
    const LANES: bool = T::LANES;
    const LARGE: bool = true;

    #[inline(always)]
    fn constant(value: T::Real) -> Self {
        Self::of(T::constant(value))
    }
    #[inline(always)]
    fn real(self) -> T::Real {
        self.re.real()
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        // Without an early exit, so that it vectorises.
        self.eps.iter().fold(self.re.is_finite(), |finite, x| finite & x.is_finite())
    }
    #[inline(always)]
    fn scale(self, factor: T::Real) -> Self {
        Self { re: self.re.scale(factor), eps: each(|k| self.eps[k].scale(factor)) }
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        let eps = each(|k| self.eps[k].mul_add(factor.re, factor.eps[k].mul_add(self.re, addend.eps[k])));
        Self { re: self.re.mul_add(factor.re, addend.re), eps }
    }
    #[inline(always)]
    fn add_scaled(self, factor: T::Real, term: Self) -> Self {
        let eps = each(|k| self.eps[k].add_scaled(factor, term.eps[k]));
        Self { re: self.re.add_scaled(factor, term.re), eps }
    }
    // A function of its own: in the loop over the links of a chain, columns would be gathered from all of them.
    #[inline(never)]
    fn combine<const N: usize>(&mut self, base: &Self, terms: [(T::Real, &Self); N]) {
        self.re.combine(&base.re, terms.map(|(factor, term)| (factor, &term.re)));
        let (factors, terms) = (terms.map(|(factor, _)| factor), terms.map(|(_, term)| &term.eps));
        combine_columns(&mut self.eps, Some(&base.eps), factors, terms);
    }
    #[inline(never)]
    fn accumulate<const N: usize>(&mut self, terms: [(T::Real, &Self); N]) {
        self.re.accumulate(terms.map(|(factor, term)| (factor, &term.re)));
        let (factors, terms) = (terms.map(|(factor, _)| factor), terms.map(|(_, term)| &term.eps));
        combine_columns(&mut self.eps, None, factors, terms);
    }
    #[inline(always)]
    fn recip(self) -> Self {
        let value = self.re.recip();
        self.compose(value, -(value * value))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.compose(self.re.abs(), self.re.sign())
    }
    #[inline(always)]
    fn sign(self) -> Self {
        Self::of(self.re.sign())
    }
    fn if_negative(self, then: Self, otherwise: Self) -> Self {
        let eps = each(|k| self.re.if_negative(then.eps[k], otherwise.eps[k]));
        Self { re: self.re.if_negative(then.re, otherwise.re), eps }
    }
}

/// Columns of a sum that begins with a base, or with the columns as they are.
#[cfg_attr(optimised, inline(always))]
fn combine_columns<T: Scalar, const K: usize, const N: usize>(
    sum: &mut [T; K],
    base: Option<&[T; K]>,
    factors: [T::Real; N],
    terms: [&[T; K]; N],
) {
    let eights = terms.map(|term| term.as_chunks::<8>());
    let (sums, few) = sum.as_chunks_mut::<8>();
    let base = base.map(|base| base.as_chunks::<8>());
    for (block, sum) in sums.iter_mut().enumerate() {
        combine_block(sum, base.map(|base| &base.0[block]), factors, eights.map(|term| &term.0[block]));
    }
    let fours = eights.map(|term| term.1.as_chunks::<4>());
    let (sums, few) = few.as_chunks_mut::<4>();
    let base = base.map(|base| base.1.as_chunks::<4>());
    for (block, sum) in sums.iter_mut().enumerate() {
        combine_block(sum, base.map(|base| &base.0[block]), factors, fours.map(|term| &term.0[block]));
    }
    for (k, sum) in few.iter_mut().enumerate() {
        let start = base.map_or(*sum, |base| base.1[k]);
        *sum = (0..N).fold(start, |sum, i| sum.add_scaled(factors[i], fours[i].1[k]));
    }
}

#[cfg_attr(optimised, inline(always))]
fn combine_block<T: Scalar, const W: usize, const N: usize>(
    sum: &mut [T; W],
    base: Option<&[T; W]>,
    factors: [T::Real; N],
    terms: [&[T; W]; N],
) {
    let mut new = base.map_or(*sum, |base| *base);
    for (factor, term) in factors.into_iter().zip(terms) {
        for k in 0..W {
            new[k] = new[k].add_scaled(factor, term[k]);
        }
    }
    *sum = new;
}

/// Derivatives, one by one.
///
/// Of 16, `from_fn` and `map` are calls: the compiler does not inline them, and copies arrays into them and out of them, which doubled the
/// cost of a step. Kernels of their own that take references cost nearly as much. Up to 8 the loop is dearer in space, by a tenth.
#[cfg_attr(optimised, inline(always))]
fn each<T: Scalar, const K: usize>(make: impl Fn(usize) -> T) -> [T; K] {
    if K <= 8 {
        return from_fn(make);
    }
    let mut all = [T::zero(); K];
    for (k, x) in all.iter_mut().enumerate() {
        *x = make(k);
    }
    all
}
