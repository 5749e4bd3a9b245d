//! The costate sweep in space: what welds do.

use super::{Pulled, Stirred};
use crate::adjoint::passes;
use crate::element::{Element, Springs};
use crate::mechanics::spatial::{Spatial, Turn, Weld};
use crate::relation::Closures;
use crate::scalar::Scalar;
use crate::shape::{Of, Takes, Walk};
use crate::walks::{Factor, Meet, Orient, PullBack, Reach, Stir};

impl<T: Scalar> Takes<Spatial<T>, Orient> for Weld<T> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Orient,
        turn: Turn<T>,
        (position, rate, x, y, p, q): Of<'_, Spatial<T>, Orient, Self>,
    ) -> Turn<T> {
        self.orient(position, rate, turn, x, y, p, q)
    }
}

passes!(Spatial, Weld<T>);

impl<T: Scalar, C: Closures> Takes<Spatial<T>, Stir<T, C>> for Weld<T> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Stir<T, C>,
        inner: Stirred<T>,
        (.., ((), kept, _), _): Of<'_, Spatial<T>, Stir<T, C>, Self>,
    ) -> Stirred<T> {
        kept.turning = inner.turning;
        inner
    }
}

impl<T: Scalar> Takes<Spatial<T>, PullBack> for Weld<T> {
    /// The attitude of a weld turns all that has been met since the last balls, but not the motion of the body that it begins with.
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut PullBack,
        outer: Pulled<T>,
        (attitude, .., (.., kept, _, _), (_, sums), _): Of<'_, Spatial<T>, PullBack, Self>,
    ) -> Pulled<T> {
        sums.turn = attitude.transposed_onto(outer.turned(kept.turning), sums.turn);
        outer
    }
}
