//! Torques in pins, where links without one stand for links with one.

use super::Point;
use crate::relation::{Absent, Closures, Meet, Minus, Promote, Term};
use crate::scalar::Scalar;

impl<T: Scalar, C: Closures> Promote<Point<T, Absent, C>> for Point<T, Minus<T>, C> {
    fn promote(lesser: Point<T, Absent, C>) -> Self {
        let Point { mass, offset, cuts, .. } = lesser;
        Self { mass, offset, torque: Minus::none(), cuts }
    }
}

impl<T: Scalar, C: Closures> Promote<Point<T, Absent, C>> for Point<T, T, C> {
    fn promote(lesser: Point<T, Absent, C>) -> Self {
        let Point { mass, offset, cuts, .. } = lesser;
        Self { mass, offset, torque: T::zero(), cuts }
    }
}

impl<T: Scalar, C: Closures> Promote<Point<T, Minus<T>, C>> for Point<T, T, C> {
    fn promote(other: Point<T, Minus<T>, C>) -> Self {
        let Point { mass, offset, torque: Minus(torque), cuts } = other;
        Self { mass, offset, torque: -torque, cuts }
    }
}

impl<T: Scalar, C: Closures> Promote<Point<T, T, C>> for Point<T, Minus<T>, C> {
    fn promote(other: Point<T, T, C>) -> Self {
        let Point { mass, offset, torque, cuts } = other;
        Self { mass, offset, torque: Minus(-torque), cuts }
    }
}

/// Links that end with a pin, inboard of a joint with a spring or a torque.
macro_rules! meet {
    ($($Torque:ty),*) => {$(
        impl<T: Scalar, C: Closures> Meet<Point<T, $Torque, C>> for Point<T, Absent, C> {
            type Both = Point<T, $Torque, C>;
            #[inline(always)]
            fn of_links(own: Self) -> Self::Both {
                Promote::promote(own)
            }
            #[inline(always)]
            fn of_none(outer: Self::Both) -> Self::Both {
                outer
            }
        }
    )*};
}
meet!(T, Minus<T>);
