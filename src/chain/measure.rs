//! By what closures of a loop are measured, to tell those that follow from others.

use super::closing::Closing;
use super::network::{Network, OwnOf};
use crate::element::{Coordinates, Element, Space};
use crate::relation::Closures;
use crate::scalar::Scalar;
use crate::visit::last_body;
use num_traits::Zero;

impl<M, A, K> Network<M, A, K> {
    /// What the last bodies of both arms would yield to the forces that close the loop if they were free.
    pub(super) fn yields<S: Space>(
        &self,
        frame: S::Frame,
        main: Coordinates<'_, S, M>,
        side: Coordinates<'_, S, A>,
    ) -> <OwnOf<S, K> as Closures>::Each<S::Scalar>
    where
        M: Element<S>,
        A: Element<S>,
        K: Closing<S>,
    {
        let none = OwnOf::<S, K>::each(|_| Zero::zero());
        let bodies = [last_body(self.main(), frame, main), last_body(self.side(), frame, side)];
        // A body without extent does not say how it would turn.
        let add = |a: S::Scalar, b: S::Scalar| if b.is_finite() { a + b } else { a };
        bodies
            .iter()
            .flatten()
            .fold(none, |sum, body| OwnOf::<S, K>::zip(&sum, &self.closing.free_compliance(body), add))
    }
}
