//! Costates of coordinates and of laws of springs and dampers, where these are read apart from the geometry of a sweep.

use crate::adjoint::{Reversed, ReversibleClosing};
use crate::shape::{Around, AtClosing, Mut, PerJoint, Positions, Rates, Ref, Selective, Walk, alike_in_arms};

/// Adds what laws do to costates of the positions and rates where they are read, and to those of their numbers.
pub struct Strain;

impl<S: Reversed> Walk<S> for Strain {
    type Carried = ();
    /// Positions and rates; w; costates of parameters, positions and rates.
    type Stores = (Ref<Positions>, Ref<Rates>, Ref<Rates>, Mut<PerJoint<S::OfJoint>>, Mut<Rates>, Mut<Rates>);
}

impl<S: Reversed> Selective<S> for Strain {
    alike_in_arms!();
}

impl<S: Reversed, K: ReversibleClosing<S>> Around<S, K> for Strain {
    fn around(
        &mut self,
        _: &K,
        (): (),
        _: AtClosing<'_, S, Self, K>,
        main: impl FnOnce(&mut Self, ()),
        side: impl FnOnce(&mut Self, ()),
    ) {
        main(self, ());
        side(self, ());
    }
}
