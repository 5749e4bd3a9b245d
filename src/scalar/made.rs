//! What numbers that are made of numbers have in common.

/// Zero and one of a number that is made of numbers `T`, sums, differences and products in place: `of_numbers!(Jet<T, K>)`.
macro_rules! of_numbers {
    ($Number:ident<T, $K:ident>) => {
        impl<T: Scalar, const $K: usize> num_traits::Zero for $Number<T, $K> {
            #[inline(always)]
            fn zero() -> Self {
                Self::of(T::zero())
            }
            fn is_zero(&self) -> bool {
                *self == Self::zero()
            }
        }

        impl<T: Scalar, const $K: usize> num_traits::One for $Number<T, $K> {
            #[inline(always)]
            fn one() -> Self {
                Self::of(T::one())
            }
        }

        $crate::scalar::made::of_numbers!(AddAssign add_assign +, $Number<T, $K>);
        $crate::scalar::made::of_numbers!(SubAssign sub_assign -, $Number<T, $K>);
        $crate::scalar::made::of_numbers!(MulAssign mul_assign *, $Number<T, $K>);
    };
    ($Assign:ident $assign:ident $with:tt, $Number:ident<T, $K:ident>) => {
        impl<T: Scalar, const $K: usize> core::ops::$Assign for $Number<T, $K> {
            #[inline(always)]
            fn $assign(&mut self, other: Self) {
                *self = *self $with other;
            }
        }
    };
}
pub(crate) use of_numbers;
