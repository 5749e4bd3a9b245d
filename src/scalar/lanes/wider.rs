//! Bundles of eight `f64` and of sixteen `f32`, one register of 512 bits or two of 256.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{One, Zero};
use wide::{f32x16, f64x8};

/// One row per bundle: what holds the lanes, the number in a lane, and how many there are.
macro_rules! wider {
    ($($(#[$doc:meta])* $Lanes:ident($wide:ident) of $number:ident, $count:literal;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[repr(transparent)]
        pub struct $Lanes(pub $wide);

        impl $Lanes {
            pub(super) const ONE: Self = Self($wide::ONE);

            /// A bundle with one number in all lanes.
            #[inline(always)]
            pub fn splat(number: $number) -> Self {
                Self($wide::splat(number))
            }

            /// Numbers of the lanes, in order.
            #[inline(always)]
            pub fn into_arr(self) -> [$number; $count] {
                self.0.to_array()
            }

            #[inline(always)]
            pub(super) fn map_lanes(self, function: impl Fn($number) -> $number) -> Self {
                self.into_arr().map(function).into()
            }

            #[inline(always)]
            pub(super) fn zip_map(self, other: Self, function: impl Fn($number, $number) -> $number) -> Self {
                let (own, other) = (self.into_arr(), other.into_arr());
                core::array::from_fn(|lane| function(own[lane], other[lane])).into()
            }
        }

        impl From<[$number; $count]> for $Lanes {
            #[inline(always)]
            fn from(lanes: [$number; $count]) -> Self {
                Self($wide::from(lanes))
            }
        }

        impl Zero for $Lanes {
            #[inline(always)]
            fn zero() -> Self {
                Self($wide::ZERO)
            }
            fn is_zero(&self) -> bool {
                *self == Self::zero()
            }
        }

        impl One for $Lanes {
            #[inline(always)]
            fn one() -> Self {
                Self::ONE
            }
        }

        impl Neg for $Lanes {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        wider!(@ $Lanes, Add add AddAssign add_assign +);
        wider!(@ $Lanes, Sub sub SubAssign sub_assign -);
        wider!(@ $Lanes, Mul mul MulAssign mul_assign *);
        wider!(@ $Lanes, Div div DivAssign div_assign /);
    )*};
    (@ $Lanes:ident, $Of:ident $of:ident $Assign:ident $assign:ident $sign:tt) => {
        impl $Of for $Lanes {
            type Output = Self;
            #[inline(always)]
            fn $of(self, other: Self) -> Self {
                Self(self.0 $sign other.0)
            }
        }
        impl $Assign for $Lanes {
            #[inline(always)]
            fn $assign(&mut self, other: Self) {
                *self = *self $sign other;
            }
        }
    };
}

wider! {
    /// Eight `f64`: a register with AVX-512, else two of AVX, whose chains of products fill each other's gaps.
    WideF64x8(f64x8) of f64, 8;
    /// Sixteen `f32`: a register with AVX-512, else two of AVX.
    WideF32x16(f32x16) of f32, 16;
}
