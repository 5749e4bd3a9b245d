//! Dual numbers of `num-dual`: derivatives to first, second or third order alongside the value.
//!
//! All kinds that can be copied, over `f32`, `f64` or another dual number. `num-dual` has no public chain rule, so that
//! functions are composed here; their values are those of the plain number, bit for bit. Quotients are `num-dual`'s,
//! which multiplies by a reciprocal: their values may differ by an ulp from those of plain numbers. A vector of
//! derivatives may be absent (`None`), which stands for zeros. `==` looks at the value only.
//!
//! At the origin [`atan2`](Elementary::atan2) has no derivatives, they come out as NaN. At zero those of
//! [`sqrt`](Elementary::sqrt) and [`ln`](Elementary::ln) are infinite, or NaN where the argument's own are zero.

use super::{Elementary, Real, Scalar};
use nalgebra::Const;
use num_dual::{Derivative, Dual, Dual2, Dual2Vec, Dual3, DualNum, DualVec, HyperDual, HyperDualVec, HyperHyperDual};

/// The plain number behind `T`; a bare `T::Real` could be that of `num-dual`.
type Plain<T> = <T as Scalar>::Real;

/// A derivative part: one number, or an array of them.
trait Part<T: Scalar>: Copy {
    /// Every entry times the plain number `factor`.
    fn scale(self, factor: T::Real) -> Self;
    /// `self + part * factor`.
    fn plus(self, part: Self, factor: T) -> Self;
    /// Whether every entry is finite.
    fn is_finite(self) -> bool;
    /// Whether every entry equals.
    fn is_identical(self, other: Self) -> bool;
}

impl<T: Scalar> Part<T> for T {
    #[inline(always)]
    fn scale(self, factor: T::Real) -> T {
        Scalar::scale(self, factor)
    }

    #[inline(always)]
    fn plus(self, part: T, factor: T) -> T {
        Scalar::mul_add(part, factor, self)
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        Scalar::is_finite(self)
    }

    #[inline(always)]
    fn is_identical(self, other: Self) -> bool {
        Scalar::is_identical(self, other)
    }
}

impl<T: Scalar + DualNum, const R: usize, const C: usize> Part<T> for Derivative<T, Const<R>, Const<C>> {
    #[inline(always)]
    fn scale(self, factor: Plain<T>) -> Self {
        Self(self.0.map(|entries| entries.map(|entry| Scalar::scale(entry, factor))))
    }

    #[cfg_attr(optimised, inline(always))]
    fn plus(self, part: Self, factor: T) -> Self {
        Self(match (self.0, part.0) {
            (sum, None) => sum,
            (None, Some(part)) => Some(part.map(|entry| entry * factor)),
            (Some(sum), Some(part)) => Some(sum.zip_map(&part, |sum, entry| Scalar::mul_add(entry, factor, sum))),
        })
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        self.0.is_none_or(|entries| entries.iter().all(|entry| Scalar::is_finite(*entry)))
    }

    #[cfg_attr(optimised, inline(always))]
    fn is_identical(self, other: Self) -> bool {
        match (self.0, other.0) {
            (None, None) => true,
            (Some(a), Some(b)) => a.iter().zip(&b).all(|(a, b)| Scalar::is_identical(*a, *b)),
            (Some(some), None) | (None, Some(some)) => some.iter().all(|x| Scalar::is_identical(*x, T::zero())),
        }
    }
}

/// A function's value and its first three derivatives at a number's value. Those beyond the order of the dual number
/// are not used, and not computed once inlined.
type Jet<T> = [T; 4];

#[cfg_attr(optimised, inline(always))]
fn recip<T: Scalar>(x: T) -> Jet<T> {
    let value = Scalar::recip(x);
    let first = -(value * value);
    let second = Scalar::scale(first * value, Plain::<T>::of(-2.0));
    [value, first, second, Scalar::scale(second * value, Plain::<T>::of(-3.0))]
}

#[cfg_attr(optimised, inline(always))]
fn sqrt<T: Scalar>(x: T) -> Jet<T> {
    let value = Elementary::sqrt(x);
    let first = T::literal(0.5) / value;
    // With h = 1/(2√x) the derivatives are h, -2h³ and 12h⁵.
    let square = first * first;
    let second = Scalar::scale(first * square, Plain::<T>::of(-2.0));
    [value, first, second, Scalar::scale(second * square, Plain::<T>::of(-6.0))]
}

#[inline(always)]
fn sin_cos<T: Scalar>(x: T) -> (Jet<T>, Jet<T>) {
    let (sine, cosine) = Elementary::sin_cos(x);
    ([sine, cosine, -sine, -cosine], [cosine, -sine, -cosine, sine])
}

#[inline(always)]
fn exp<T: Scalar>(x: T) -> Jet<T> {
    [Elementary::exp(x); 4]
}

#[inline(always)]
fn ln<T: Scalar>(x: T) -> Jet<T> {
    let [first, second, third, _] = recip(x);
    [Elementary::ln(x), first, second, third]
}

#[cfg_attr(optimised, inline(always))]
fn tanh<T: Scalar>(x: T) -> Jet<T> {
    let value = Elementary::tanh(x);
    let first = (T::one() - value) * (T::one() + value);
    let second = Scalar::scale(first * value, Plain::<T>::of(-2.0));
    let third = first * Scalar::scale(thrice(value * value) - T::one(), Plain::<T>::of(2.0));
    [value, first, second, third]
}

#[inline(always)]
fn abs<T: Scalar>(x: T) -> Jet<T> {
    [Scalar::abs(x), Scalar::sign(x), T::zero(), T::zero()]
}

/// The direction of the point (x, y): its cosine and sine, both times a number between 1 and √2. Neither very long nor
/// very short ones overflow.
#[inline(always)]
fn direction<T: Scalar>(x: T, y: T) -> (T, T) {
    let length = T::constant(Real::max(Scalar::abs(x.real()), Scalar::abs(y.real())));
    (x / length, y / length)
}

#[inline(always)]
fn twice<T: Scalar>(x: T) -> T {
    x + x
}

#[inline(always)]
fn thrice<T: Scalar>(x: T) -> T {
    Scalar::scale(x, Plain::<T>::of(3.0))
}

/// The chain rule.
trait Compose<T: Scalar> {
    /// `f(self)`, where `jet` is `f` at the value of `self`.
    fn compose(self, jet: Jet<T>) -> Self;
}

/// One row per kind: its numbers of derivatives, and its parts. Where first derivatives contribute to a part, there
/// follow what they add to a product `x y` and what they add to `f(x)`, given f″ and f‴.
macro_rules! dual_numbers {
    ($($dual:ty, [$($count:ident)*] {
        $($part:ident $(: |$x:ident, $y:ident| $product:expr, |$second:ident, $third:ident| $composed:expr)?;)*
    })*) => {$(
        impl<T: Scalar + DualNum $(, const $count: usize)*> Compose<T> for $dual {
            #[cfg_attr(optimised, inline(always))]
            fn compose(self, jet: Jet<T>) -> Self {
                let mut result = self;
                result.re = jet[0];
                $(
                    result.$part = self.$part * jet[1];
                    $(
                        let ($x, $second, $third) = (self, jet[2], jet[3]);
                        result.$part += $composed;
                    )?
                )*
                result
            }
        }

        impl<T: Scalar + DualNum $(, const $count: usize)*> Elementary for $dual {
            #[inline(always)]
            fn sqrt(self) -> Self {
                self.compose(sqrt(self.re))
            }

            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                let (sine, cosine) = sin_cos(self.re);
                (self.compose(sine), self.compose(cosine))
            }

            #[cfg_attr(optimised, inline(always))]
            fn atan2(self, x: Self) -> Self {
                // In axes turned to the point, it lies at a distance `along` and, rounding apart, 0 `across`. Its angle
                // there is atan(across / along), whose derivatives at 0 are 1, 0 and -2.
                let (cosine, sine) = direction(x.re, self.re);
                let along = DualNum::scale(x, &cosine) + DualNum::scale(self, &sine);
                let across = DualNum::scale(self, &cosine) - DualNum::scale(x, &sine);
                let angle = Elementary::atan2(self.re, x.re);
                (across / along).compose([angle, T::one(), T::zero(), T::literal(-2.0)])
            }

            #[inline(always)]
            fn exp(self) -> Self {
                self.compose(exp(self.re))
            }

            #[inline(always)]
            fn ln(self) -> Self {
                self.compose(ln(self.re))
            }

            #[inline(always)]
            fn tanh(self) -> Self {
                self.compose(tanh(self.re))
            }
        }

        impl<T: Scalar + DualNum $(, const $count: usize)*> Scalar for $dual {
            type Real = Plain<T>;
            const ANGLE_RANGE: Plain<T> = <T as Scalar>::ANGLE_RANGE;
            const LANES: bool = T::LANES;

            #[inline(always)]
            fn constant(value: Plain<T>) -> Self {
                Self::from_re(T::constant(value))
            }

            #[inline(always)]
            fn real(self) -> Plain<T> {
                self.re.real()
            }

            #[inline(always)]
            fn is_finite(self) -> bool {
                Scalar::is_finite(self.re) $(&& Part::<T>::is_finite(self.$part))*
            }

            #[inline(always)]
            fn is_identical(self, other: Self) -> bool {
                Scalar::is_identical(self.re, other.re) $(&& Part::<T>::is_identical(self.$part, other.$part))*
            }

            #[cfg_attr(optimised, inline(always))]
            fn scale(self, factor: Plain<T>) -> Self {
                let mut result = self;
                result.re = Scalar::scale(self.re, factor);
                $(result.$part = Part::<T>::scale(self.$part, factor);)*
                result
            }

            #[cfg_attr(optimised, inline(always))]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                let mut result = addend;
                result.re = Scalar::mul_add(self.re, factor.re, addend.re);
                $(
                    result.$part = addend.$part.plus(self.$part, factor.re).plus(factor.$part, self.re);
                    $(
                        let ($x, $y) = (self, factor);
                        result.$part += $product;
                    )?
                )*
                result
            }

            #[cfg_attr(optimised, inline(always))]
            fn add_scaled(self, factor: Plain<T>, term: Self) -> Self {
                let mut result = self + Scalar::scale(term, factor);
                result.re = Scalar::add_scaled(self.re, factor, term.re); // as of plain numbers, bit by bit
                result
            }

            #[inline(always)]
            fn recip(self) -> Self {
                self.compose(recip(self.re))
            }

            #[inline(always)]
            fn abs(self) -> Self {
                self.compose(abs(self.re))
            }

            #[inline(always)]
            fn sign(self) -> Self {
                Self::from_re(Scalar::sign(self.re))
            }
        }
    )*};
}

dual_numbers! {
    Dual<T>, [] {
        eps;
    }
    DualVec<T, Const<N>>, [N] {
        eps;
    }
    Dual2<T>, [] {
        v1;
        v2: |x, y| twice(x.v1 * y.v1), |second, _third| x.v1 * x.v1 * second;
    }
    Dual2Vec<T, Const<N>>, [N] {
        v1;
        v2: |x, y| x.v1.tr_mul(&y.v1) + y.v1.tr_mul(&x.v1), |second, _third| x.v1.tr_mul(&x.v1) * second;
    }
    HyperDual<T>, [] {
        eps1;
        eps2;
        eps1eps2: |x, y| x.eps1 * y.eps2 + y.eps1 * x.eps2, |second, _third| x.eps1 * x.eps2 * second;
    }
    HyperDualVec<T, Const<M>, Const<N>>, [M N] {
        eps1;
        eps2;
        eps1eps2: |x, y| &x.eps1 * &y.eps2 + &y.eps1 * &x.eps2, |second, _third| &x.eps1 * &x.eps2 * second;
    }
    Dual3<T>, [] {
        v1;
        v2: |x, y| twice(x.v1 * y.v1), |second, _third| x.v1 * x.v1 * second;
        v3: |x, y| thrice(x.v1 * y.v2 + y.v1 * x.v2),
            |second, third| x.v1 * (thrice(x.v2 * second) + x.v1 * x.v1 * third);
    }
    HyperHyperDual<T>, [] {
        eps1;
        eps2;
        eps3;
        eps1eps2: |x, y| x.eps1 * y.eps2 + y.eps1 * x.eps2, |second, _third| x.eps1 * x.eps2 * second;
        eps1eps3: |x, y| x.eps1 * y.eps3 + y.eps1 * x.eps3, |second, _third| x.eps1 * x.eps3 * second;
        eps2eps3: |x, y| x.eps2 * y.eps3 + y.eps2 * x.eps3, |second, _third| x.eps2 * x.eps3 * second;
        eps1eps2eps3: |x, y| x.eps1 * y.eps2eps3 + x.eps2 * y.eps1eps3 + x.eps3 * y.eps1eps2
                + y.eps1 * x.eps2eps3 + y.eps2 * x.eps1eps3 + y.eps3 * x.eps1eps2,
            |second, third| (x.eps1 * x.eps2eps3 + x.eps2 * x.eps1eps3 + x.eps3 * x.eps1eps2) * second
                + x.eps1 * x.eps2 * x.eps3 * third;
    }
}
