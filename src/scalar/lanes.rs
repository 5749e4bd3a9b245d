//! Bundles of lanes: the same computation on several numbers at once.
//!
//! Every lane gives the bits a plain number would give, for sine and cosine too.

mod wider;

use super::{Elementary, Scalar, trig};
use simba::simd::{SimdValue, WideF32x4, WideF32x8, WideF64x4};
use wide::{f64x4, f64x8, u64x4, u64x8};
pub use wider::{WideF32x16, WideF64x8};

/// One row per bundle of `f64`: what holds it and its bits.
macro_rules! quadrants {
    ($($lanes:ident: $wide:ident $bits:ident;)*) => {$(
        impl trig::Quadrant for $lanes {
            #[cfg_attr(optimised, inline(always))]
            fn turn(self, sine: Self, negative_sine: Self, cosine: Self) -> (Self, Self) {
                let bits = self.0.to_bits();
                let odd = $wide::from_bits($bits::ZERO - (bits & $bits::ONE));
                let sign = $wide::from_bits(bits << 62_u32) & $wide::splat(-0.0);
                let turned = (odd.select(cosine.0, sine.0), odd.select(negative_sine.0, cosine.0));
                (Self(turned.0 ^ sign), Self(turned.1 ^ sign))
            }
        }
    )*};
}
quadrants! {
    WideF64x4: f64x4 u64x4;
    WideF64x8: f64x8 u64x8;
}

/// `f32` has its sine computed in `f64`, lane by lane in a form that compilers turn into vectors of `f64`.
macro_rules! sin_cos_by_lane {
    ($lanes:expr) => {{
        let (mut sine, mut cosine) = ($lanes.into_arr(), $lanes.into_arr());
        for (sine, cosine) in sine.iter_mut().zip(&mut cosine) {
            (*sine, *cosine) = trig::sin_cos_single(*sine);
        }
        (sine.into(), cosine.into())
    }};
}

/// One row per bundle: the number in a lane, and sine and cosine.
macro_rules! lanes {
    ($($lanes:ident of $number:ident, $angle:ident => $sin_cos:expr;)*) => {$(
        impl Elementary for $lanes {
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(self.0.sqrt())
            }

            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                let $angle = self;
                $sin_cos
            }

            #[inline(always)]
            fn atan2(self, x: Self) -> Self {
                self.zip_map(x, <$number as Elementary>::atan2)
            }

            #[inline(always)]
            fn exp(self) -> Self {
                self.map_lanes(Elementary::exp)
            }

            #[inline(always)]
            fn ln(self) -> Self {
                self.map_lanes(Elementary::ln)
            }

            #[inline(always)]
            fn tanh(self) -> Self {
                self.map_lanes(Elementary::tanh)
            }
        }

        impl Scalar for $lanes {
            type Real = $number;
            const ANGLE_RANGE: $number = <$number as Scalar>::ANGLE_RANGE;
            const LANES: bool = true;

            #[inline(always)]
            fn constant(value: $number) -> Self {
                Self::splat(value)
            }

            #[cfg_attr(optimised, inline(always))]
            fn real(self) -> $number {
                let [first, others @ ..] = self.into_arr();
                let mut largest = first;
                for lane in others {
                    // A NaN stays: nothing compares larger than it.
                    if lane.is_nan() || lane.abs() > largest.abs() {
                        largest = lane;
                    }
                }
                largest
            }

            #[inline(always)]
            fn exceeds(self, limit: $number) -> bool {
                self.0.abs().simd_gt(Self::splat(limit).0).any()
            }

            #[inline(always)]
            fn is_finite(self) -> bool {
                (self.0 - self.0).simd_eq(Self::splat(0.0).0).all() // infinities leave NaN
            }

            #[inline(always)]
            fn scale(self, factor: $number) -> Self {
                self * Self::splat(factor)
            }

            #[cfg_attr(optimised, inline(always))]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                // Where numbers are not fused lanes are not either.
                if cfg!(feature = "reproducible") {
                    self * factor + addend
                } else {
                    Self(self.0.mul_add(factor.0, addend.0))
                }
            }

            #[inline(always)]
            fn add_scaled(self, factor: $number, term: Self) -> Self {
                Scalar::mul_add(term, Self::splat(factor), self)
            }

            #[inline(always)]
            fn recip(self) -> Self {
                Self::ONE / self
            }

            #[inline(always)]
            fn abs(self) -> Self {
                Self(self.0.abs())
            }

            #[inline(always)]
            fn sign(self) -> Self {
                self.map_lanes(Scalar::sign)
            }

            #[inline]
            fn if_negative(self, then: Self, otherwise: Self) -> Self {
                Self(self.0.simd_lt(Self::splat(0.0).0).select(then.0, otherwise.0))
            }
        }
    )*};
}

lanes! {
    WideF64x4 of f64, angle => trig::sin_cos(angle);
    WideF32x4 of f32, angle => sin_cos_by_lane!(angle);
    WideF32x8 of f32, angle => sin_cos_by_lane!(angle);
    WideF64x8 of f64, angle => trig::sin_cos(angle);
    WideF32x16 of f32, angle => sin_cos_by_lane!(angle);
}
