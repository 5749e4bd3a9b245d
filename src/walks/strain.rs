//! Costates of coordinates and of laws of springs and dampers, where these are read apart from the geometry of a sweep.

use crate::adjoint::{Reversed, ReversibleClosing};
use crate::element::Implicit;
use crate::scalar::Scalar;
use crate::shape::{Around, AtClosing, Mut, PerJoint, Positions, Rates, Ref, Selective, Walk, alike_in_arms};

/// Adds what laws do to costates of the positions and rates where they are read, and to those of their numbers.
///
/// Laws that are not linear are read where the last sweep has led, with q and v by an acceleration a′: force f + K̂ (a′ − a) for the
/// acceleration a sought.
pub struct Strain<T: Scalar> {
    /// K̂ is by these.
    pub springs: Implicit<T::Real>,
    /// And its derivative by the size of the step by these.
    pub by_size: Implicit<T::Real>,
    /// The costate of the size of the step by K̂.
    pub of_size: T,
}

impl<T: Scalar> Strain<T> {
    /// From weights of the acceleration sought in positions and rates, and their derivatives by the size of the step.
    pub fn by([[position, rate], by_size]: [[T::Real; 2]; 2]) -> Self {
        let by_size = Implicit { position: by_size[0], rate: by_size[1] };
        Self { springs: Implicit { position, rate }, by_size, of_size: T::zero() }
    }
}

/// Position and rate where the last sweep has led, and by how much its acceleration differs; or costates of these.
pub type Led<T> = [T; 3];

impl<S: Reversed> Walk<S> for Strain<S::Scalar> {
    type Carried = ();
    /// Positions and rates; w; costates of parameters, positions and rates; where the last sweep has led, a′ − a, and costates of both and a′.
    type Stores = (
        Ref<Positions>,
        Ref<Rates>,
        Ref<Rates>,
        Mut<PerJoint<S::OfJoint>>,
        Mut<Rates>,
        Mut<Rates>,
        (Ref<Positions>, Ref<Rates>, Ref<Rates>),
        (Mut<Rates>, Mut<Rates>, Mut<Rates>),
    );
}

impl<S: Reversed> Selective<S> for Strain<S::Scalar> {
    alike_in_arms!();
}

impl<S: Reversed, K: ReversibleClosing<S>> Around<S, K> for Strain<S::Scalar> {
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
