//! Plain numbers: `f32` and `f64`.
//!
//! Square roots, arctangents, exponentials, logarithms and powers come from the standard library, or with feature `libm` alone from that; sine
//! and cosine are our own in either case (see `trig`). With neither feature the crate compiles, but no number of its
//! own implements [`Scalar`], and a number of the user's has to.
//!
//! With feature `reproducible` products are nowhere fused, and all these but square roots, which are rounded exactly everywhere, come
//! from `libm`: then bits do not depend on the machine.
#![cfg(any(feature = "std", feature = "libm"))]

use super::{Elementary, Real, Scalar, trig};
use num_traits::Float;

/// Whether a fused multiply-add is one instruction. Elsewhere it is a call many times slower than two operations.
///
/// With feature `reproducible` nothing is fused, so that machines without that instruction compute the same.
pub(super) const FUSED: bool =
    cfg!(all(feature = "std", not(feature = "reproducible"), any(target_feature = "fma", target_arch = "aarch64")));

/// A function of the platform, or with feature `reproducible` that of `libm`, which is the same on all.
macro_rules! elementary {
    ($name:ident, $libm:ident($x:expr $(, $y:expr)?)) => {{
        #[cfg(feature = "reproducible")]
        {
            libm::$libm($x $(, $y)?)
        }
        #[cfg(not(feature = "reproducible"))]
        {
            Float::$name($x $(, $y)?)
        }
    }};
}

/// One row per type: its sine and cosine, and what `libm` calls its elementary functions.
macro_rules! plain_numbers {
    ($($number:ident: $sin_cos:path, $atan2:ident $exp:ident $log:ident $tanh:ident $pow:ident;)*) => {$(
        impl Elementary for $number {
            #[inline(always)]
            fn sqrt(self) -> $number {
                Float::sqrt(self)
            }

            #[inline(always)]
            fn sin_cos(self) -> ($number, $number) {
                $sin_cos(self)
            }

            #[inline(always)]
            fn atan2(self, x: $number) -> $number {
                elementary!(atan2, $atan2(self, x))
            }

            #[inline(always)]
            fn exp(self) -> $number {
                elementary!(exp, $exp(self))
            }

            #[inline(always)]
            fn ln(self) -> $number {
                elementary!(ln, $log(self))
            }

            #[inline(always)]
            fn tanh(self) -> $number {
                elementary!(tanh, $tanh(self))
            }
        }

        impl Scalar for $number {
            type Real = $number;
            const ANGLE_RANGE: $number = trig::ANGLE_RANGE as $number;

            #[inline(always)]
            fn constant(value: $number) -> $number {
                value
            }

            #[inline(always)]
            fn real(self) -> $number {
                self
            }

            #[inline(always)]
            fn is_finite(self) -> bool {
                <$number>::is_finite(self)
            }

            #[inline(always)]
            fn scale(self, factor: $number) -> $number {
                self * factor
            }

            #[inline(always)]
            fn mul_add(self, factor: $number, addend: $number) -> $number {
                if FUSED { Float::mul_add(self, factor, addend) } else { self * factor + addend }
            }

            #[inline(always)]
            fn add_scaled(self, factor: $number, term: $number) -> $number {
                Scalar::mul_add(term, factor, self)
            }

            #[inline(always)]
            fn recip(self) -> $number {
                1.0 / self
            }

            #[inline(always)]
            fn abs(self) -> $number {
                <$number>::abs(self)
            }

            #[inline(always)]
            fn sign(self) -> $number {
                // Without branches, so that lanes of them are vectors.
                <$number>::from(i8::from(self > 0.0) - i8::from(self < 0.0))
            }
        }

        impl Real for $number {
            const EPSILON: $number = $number::EPSILON;
            const INFINITY: $number = $number::INFINITY;

            #[inline(always)]
            fn of(value: f64) -> $number {
                value as $number
            }

            #[inline(always)]
            fn as_f64(self) -> f64 {
                self.into()
            }

            #[inline(always)]
            fn max(self, other: $number) -> $number {
                <$number>::max(self, other)
            }

            #[inline(always)]
            fn min(self, other: $number) -> $number {
                <$number>::min(self, other)
            }

            #[inline(always)]
            fn powf(self, exponent: $number) -> $number {
                elementary!(powf, $pow(self, exponent))
            }
        }
    )*};
}

plain_numbers! {
    f32: trig::sin_cos_single, atan2f expf logf tanhf powf;
    f64: trig::sin_cos, atan2 exp log tanh pow;
}
