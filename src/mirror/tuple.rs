//! Tuples of mirrors, for the arities that chains have, and the mirror of a body: `()`.

use super::fieldwise::{fieldwise_position, fieldwise_rate, fieldwise_retraction};
use super::{Mode, Position, Rate, Retraction, Term, Told};
use crate::scalar::Scalar;
use crate::tuples::for_each_tuple;

macro_rules! mirror_tuple {
    ($($met:ident)?; $($A:ident $i:tt $out:ident $in:ident),*; $($rest:tt)*) => {
        impl<T: Scalar, $($A: Rate<T>),*> Rate<T> for ($($A,)*) {
            const LENGTH: usize = 0_usize$(.saturating_add($A::LENGTH))*;
            const FIELDS: usize = 0_usize$(.saturating_add($A::FIELDS))*;

            fieldwise_rate!([$($i)*] [$($i)*] [$($i)*]);
        }

        impl<T: Scalar, $($A: Retraction<T>),*> Retraction<T> for ($($A,)*) {
            type Rate = ($($A::Rate,)*);

            const CURVED: bool = false $(|| $A::CURVED)*;

            fieldwise_retraction!($($i)*);
        }

        impl<T: Scalar, $($A: Position<T>),*> Position<T> for ($($A,)*) {
            const CLOCKED: bool = false $(|| $A::CLOCKED)*;
            const MODES: bool = false $(|| $A::MODES)*;

            fieldwise_position!($($i)*);
        }
    };
}

mirror_tuple!(; ;);
for_each_tuple!(mirror_tuple);
