//! Values over another scalar: the same parameters as dual numbers, as lanes, in single precision.

use crate::scalar::Scalar;
use crate::tuples::for_each_tuple;
use nalgebra::Vector3;

/// A value whose numbers can be replaced by numbers of type `U`.
#[diagnostic::on_unimplemented(
    message = "the numbers in `{Self}` cannot be replaced by others, with derivatives say",
    label = "a value that cannot be lifted",
    note = "a struct of the user's own can, once it says which its fields are: `catena::lift!(Name {{ field, other }})`",
    note = "closures cannot, for their numbers are hidden: write a struct that implements the law; `differentiable!(forward ..)` takes closures"
)]
pub trait Lift<T: Scalar, U: Scalar> {
    /// This value over `U`.
    type Over;

    /// Replaces each number.
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over;
}

impl<T: Scalar, U: Scalar> Lift<T, U> for T {
    type Over = U;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> U {
        number(*self)
    }
}

impl<T: Scalar, U: Scalar, A: Lift<T, U>, const K: usize> Lift<T, U> for [A; K] {
    type Over = [A::Over; K];
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        self.each_ref().map(|item| item.lift(number))
    }
}

/// Numbers of bodies and the like stay.
impl<T: Scalar, U: Scalar> Lift<T, U> for usize {
    type Over = Self;
    fn lift(&self, _: &mut impl FnMut(T) -> U) -> Self {
        *self
    }
}

impl<T: Scalar, U: Scalar> Lift<T, U> for Vector3<T> {
    type Over = Vector3<U>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Vector3::new(number(self.x), number(self.y), number(self.z))
    }
}

#[cfg(feature = "alloc")]
impl<T: Scalar, U: Scalar, A: Lift<T, U>> Lift<T, U> for alloc::vec::Vec<A> {
    type Over = alloc::vec::Vec<A::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        self.iter().map(|item| item.lift(number)).collect()
    }
}

macro_rules! lift_tuple {
    ($($met:ident)?; $($A:ident $i:tt $out:ident $in:ident),*; $($rest:tt)*) => {
        impl<Num: Scalar, Other: Scalar, $($A: Lift<Num, Other>),*> Lift<Num, Other> for ($($A,)*) {
            type Over = ($($A::Over,)*);
            fn lift(&self, _number: &mut impl FnMut(Num) -> Other) -> Self::Over {
                #[allow(clippy::unused_unit)] // the tuple of none
                ($(self.$i.lift(_number),)*)
            }
        }
    };
}
lift_tuple!(; ;);
for_each_tuple!(lift_tuple);

/// Lifts structs field by field, or as they are where they hold no number.
///
/// Fields are numbers `T`, or of types that can be lifted themselves; further parameters of the struct are types of fields. A struct whose
/// parameters are types of fields alone stands without `T`.
///
/// ```
/// /// A wheel on an axle of a kind to be chosen.
/// #[derive(Clone, Copy)]
/// struct Wheel<T, A> {
///     radius: T,
///     axle: A,
/// }
/// catena::lift!(Wheel<T, A> { radius, axle });
/// ```
#[macro_export]
#[doc(hidden)] // listed in `extend`
macro_rules! lift {
    ($($Name:ident<T $(, $Part:ident)*> { $($field:ident),* $(,)? }),*) => {$(
        impl<T, U, $($Part),*> $crate::Lift<T, U> for $Name<T, $($Part),*>
        where
            T: $crate::Scalar,
            U: $crate::Scalar,
            $($Part: $crate::Lift<T, U>),*
        {
            type Over = $Name<U, $($Part::Over),*>;
            fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
                $Name { $($field: $crate::Lift::lift(&self.$field, number)),* }
            }
        }
    )*};
    ($($Name:ident { $($field:ident),* }),*) => {
        $($crate::lift!($Name<T> { $($field),* });)*
    };
    ($Name:ident<$($Part:ident),*> { $($field:tt),* }) => {
        impl<T, U, $($Part),*> $crate::Lift<T, U> for $Name<$($Part),*>
        where
            T: $crate::Scalar,
            U: $crate::Scalar,
            $($Part: $crate::Lift<T, U>),*
        {
            type Over = $Name<$($Part::Over),*>;
            fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
                $Name { $($field: $crate::Lift::lift(&self.$field, number)),* }
            }
        }
    };
    ($($Name:ident),*) => {$(
        impl<T: $crate::Scalar, U: $crate::Scalar> $crate::Lift<T, U> for $Name {
            type Over = Self;
            fn lift(&self, _: &mut impl FnMut(T) -> U) -> Self {
                *self
            }
        }
    )*};
}
pub(crate) use lift;
