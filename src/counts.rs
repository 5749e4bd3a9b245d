//! Counts that types know: bodies and degrees of freedom of a scene, as typenum numbers.
//!
//! Stable const generics cannot add; typenum can. A chain of tuples and arrays knows its counts ([`Counted`]), one with a
//! vector does not and is asked at run time instead.

use core::ops::{Add, Mul};
use typenum::{B1, Const, IsGreater, Sum, ToUInt, U, Unsigned};

/// A chain whose type decides how many bodies and degrees of freedom it has.
///
/// ```
/// use catena::system::Counted;
/// use catena::planar::{Pin, Rod};
/// use typenum::Unsigned;
/// type Chain = (Rod<f64>, [(Pin, Rod<f64>); 4]);
/// assert_eq!(<Chain as Counted>::Bodies::USIZE, 5);
/// assert_eq!(<Chain as Counted>::Freedoms::USIZE, 4);
/// ```
#[diagnostic::on_unimplemented(
    message = "the number of bodies of `{Self}` is not known at compile time",
    label = "its length is a run-time value",
    note = "vectors have a length at run time: ask for a body by number instead"
)]
pub trait Counted {
    /// Number of bodies.
    type Bodies: Unsigned;
    /// Number of degrees of freedom.
    type Freedoms: Unsigned;
}

/// A chain with a body number `K`.
#[diagnostic::on_unimplemented(
    message = "this chain has no body number {K}: `{Self}`",
    label = "bodies are numbered from 0 at the root"
)]
pub trait HasBody<const K: usize> {}

impl<E: Counted, const K: usize> HasBody<K> for E
where
    Const<K>: ToUInt,
    E::Bodies: IsGreater<U<K>, Output: Exists<K>>,
{
}

/// Whether there is a body number `K`: typenum's answer yes, and not its no, so that the compiler can put it in words.
#[diagnostic::on_unimplemented(
    message = "this chain has no body number {K}",
    label = "it has fewer bodies",
    note = "bodies are numbered from 0 at the root"
)]
pub trait Exists<const K: usize> {}

impl<const K: usize> Exists<K> for B1 {}

impl<A: Counted, const K: usize> Counted for [A; K]
where
    Const<K>: ToUInt,
    A::Bodies: Mul<U<K>, Output: Unsigned>,
    A::Freedoms: Mul<U<K>, Output: Unsigned>,
{
    type Bodies = <A::Bodies as Mul<U<K>>>::Output;
    type Freedoms = <A::Freedoms as Mul<U<K>>>::Output;
}

impl<A: Counted> Counted for (A,) {
    type Bodies = A::Bodies;
    type Freedoms = A::Freedoms;
}

/// A tuple counts its first item and the tuple of the others.
macro_rules! count_tuple {
    ($First:ident $($Other:ident)+) => {
        impl<$First: Counted, $($Other),+> Counted for ($First, $($Other),+)
        where
            ($($Other,)+): Counted,
            $First::Bodies: Add<<($($Other,)+) as Counted>::Bodies, Output: Unsigned>,
            $First::Freedoms: Add<<($($Other,)+) as Counted>::Freedoms, Output: Unsigned>,
        {
            type Bodies = Sum<$First::Bodies, <($($Other,)+) as Counted>::Bodies>;
            type Freedoms = Sum<$First::Freedoms, <($($Other,)+) as Counted>::Freedoms>;
        }
        count_tuple!($($Other)+);
    };
    ($Last:ident) => {};
}
count_tuple!(A B C D E F G H I J K N O P Q V);
