//! Numbers side by side: what many costates of one motion are carried in.

use super::made::of_numbers;
use super::{Elementary, Scalar};
use core::array::from_fn;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// `N` numbers side by side, which a compiler puts into the lanes of registers.
///
/// It serves to carry several costates along one motion: what belongs to the motion is the same in all of them, and sines of such numbers are
/// found once. Decisions look at the first of them. Four at a time pay on x86-64-v3, two on the default target. Costates over them have no sums by
/// parameters: gradients of runs over packs do not compile.
///
/// ```
/// use catena::scalar::{Pack, Scalar};
/// let x = Pack::<f64, 4>::of(0.5) * Pack([0.0, 1.0, 2.0, 3.0]);
/// assert_eq!(x.0, [0.0, 0.5, 1.0, 1.5]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pack<T, const N: usize>(pub [T; N]);

impl<T: Scalar, const N: usize> Pack<T, N> {
    /// Whether all numbers are the same.
    pub(crate) fn is_even(&self) -> bool {
        self.0.iter().all(|x| x.is_identical(self.0[0]))
    }

    /// One number everywhere.
    #[inline(always)]
    pub fn of(number: T) -> Self {
        Self([number; N])
    }

    /// Each number, mapped.
    #[inline(always)]
    fn each(self, map: impl Fn(T) -> T) -> Self {
        Self(from_fn(|k| map(self.0[k])))
    }

    /// The first number, which decides.
    #[inline(always)]
    fn first(self) -> T {
        self.0.first().copied().unwrap_or_else(T::zero)
    }
}

of_numbers!(Pack<T, N>);

impl<T: Scalar, const N: usize> Neg for Pack<T, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(|x| -x)
    }
}

macro_rules! operators {
    ($($Trait:ident $method:ident $with:tt),*) => {$(
        impl<T: Scalar, const N: usize> $Trait for Pack<T, N> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(from_fn(|k| self.0[k] $with other.0[k]))
            }
        }
    )*};
}
operators!(Add add +, Sub sub -, Mul mul *, Div div /);

macro_rules! functions {
    ($($name:ident),*) => {$(
        #[inline(always)]
        fn $name(self) -> Self {
            self.each(T::$name)
        }
    )*};
}

impl<T: Scalar, const N: usize> Elementary for Pack<T, N> {
    const ROWS: bool = true;

    #[cfg_attr(optimised, inline(always))]
    fn sin_cos(self) -> (Self, Self) {
        let first = self.first();
        if self.0.iter().all(|x| x.is_identical(first)) {
            let (sine, cosine) = first.sin_cos();
            return (Self::of(sine), Self::of(cosine));
        }
        let both: [(T, T); N] = from_fn(|k| self.0[k].sin_cos());
        (Self(from_fn(|k| both[k].0)), Self(from_fn(|k| both[k].1)))
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        Self(from_fn(|k| self.0[k].atan2(x.0[k])))
    }
    functions!(sqrt, exp, ln, tanh);
}

impl<T: Scalar, const N: usize> Scalar for Pack<T, N> {
    type Real = T::Real;
    const ANGLE_RANGE: T::Real = T::ANGLE_RANGE;
    const LANES: bool = T::LANES;

    #[inline(always)]
    fn constant(value: T::Real) -> Self {
        Self::of(T::constant(value))
    }
    #[inline(always)]
    fn real(self) -> T::Real {
        self.first().real()
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.0.iter().fold(true, |finite, x| finite & x.is_finite())
    }
    #[inline(always)]
    fn is_identical(self, other: Self) -> bool {
        self.0.iter().zip(other.0).all(|(x, y)| x.is_identical(y))
    }
    #[inline(always)]
    fn scale(self, factor: T::Real) -> Self {
        self.each(|x| x.scale(factor))
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self(from_fn(|k| self.0[k].mul_add(factor.0[k], addend.0[k])))
    }
    #[inline(always)]
    fn add_scaled(self, factor: T::Real, term: Self) -> Self {
        Self(from_fn(|k| self.0[k].add_scaled(factor, term.0[k])))
    }
    fn if_negative(self, then: Self, otherwise: Self) -> Self {
        Self(from_fn(|k| self.first().if_negative(then.0[k], otherwise.0[k])))
    }
    functions!(recip, abs, sign);
}
