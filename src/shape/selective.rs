//! Walks that not every element can take: they meet bodies and joints by their types.
//!
//! A walk of [`Outward`](super::Outward) or [`Inward`](super::Inward) meets any body and any joint, and asks of them what all have to
//! say. A selective walk asks more: what it does at a body or a joint is an implementation of [`Takes`] for that type, composites hand it
//! on, and a chain with an element that has none does not compile.

use super::closing::Closing;
use super::field::{Arm, Main, Side, Way};
use super::slot::Slot;
use super::walk::{AtClosing, Of, Walk};
use super::{Items, Shape};
use crate::space::Space;

/// A walk that meets elements by their types.
pub trait Selective<S: Space>: Walk<S> {
    /// Whether the walk goes from the root to the tips, or from them to the root.
    const OUTWARD: bool;
    /// Whether an inward walk meets the last item of an array or vector apart from the others: what it carries is of one kind for these
    /// then, which a compiler sees if the kind is a number.
    const LAST_APART: bool = false;

    /// The walk in an arm.
    type In<Y: Way>: Selective<S, Stores = <Self::Stores as Slot<S>>::In<Y>>;

    /// What goes on where an arm leaves the chain; `go` is the way through the arm. What an outward walk carries goes both ways; an inward
    /// one has to say how what comes from the arm joins the chain.
    fn branch(
        &mut self,
        carried: Self::Carried,
        go: impl FnOnce(&mut Self::In<Arm>, CarriedIn<S, Self, Arm>) -> CarriedIn<S, Self, Arm>,
    ) -> Self::Carried;
}

/// What a selective walk carries in an arm.
pub type CarriedIn<S, W, Y> = <<W as Selective<S>>::In<Y> as Walk<S>>::Carried;

/// An outward walk that is the same in arms.
macro_rules! alike_in_arms {
    () => {
        const OUTWARD: bool = true;
        type In<Y: $crate::shape::Way> = Self;

        #[cfg_attr(optimised, inline(always))]
        fn branch(
            &mut self,
            carried: Self::Carried,
            go: impl FnOnce(&mut Self, Self::Carried) -> Self::Carried,
        ) -> Self::Carried {
            go(self, carried);
            carried
        }
    };
}
pub(crate) use alike_in_arms;

/// A selective walk that goes around loops which a joint of type `K` closes.
#[diagnostic::on_unimplemented(
    message = "a loop that `{K}` closes takes no walk `{Self}`: no gradient of a run goes backward around it, or `Taylor` knows no series of its motion",
    label = "not a loop that this walk knows",
    note = "gradients know loops that a `Pin` or a `Weld` of the plane closes, or a `Ball`, a `Weld` or a `Revolute` of space; `Taylor` those but for the last",
    note = "gradients of all scenes go by jets or dual numbers; `Dop853` runs all scenes"
)]
pub trait Around<S: Space, K: Closing<S>>: Selective<S> {
    /// Meets arms in parallel: `main` and `side` are the ways through both.
    fn around(
        &mut self,
        closing: &K,
        carried: Self::Carried,
        at: AtClosing<'_, S, Self, K>,
        main: impl FnOnce(
            &mut Self::In<Main<K::Closures>>,
            CarriedIn<S, Self, Main<K::Closures>>,
        ) -> CarriedIn<S, Self, Main<K::Closures>>,
        side: impl FnOnce(
            &mut Self::In<Side<K::Closures>>,
            CarriedIn<S, Self, Side<K::Closures>>,
        ) -> CarriedIn<S, Self, Side<K::Closures>>,
    ) -> Self::Carried;
}

/// An element that takes a selective walk.
#[diagnostic::on_unimplemented(
    message = "`{Self}` takes no walk `{W}`: functions of lists do not know it, no gradient of a run goes backward through it, or `Taylor` knows no series of its motion",
    label = "not known to this walk",
    note = "gradients know `Rod`, `RigidBody`, `PointMass`, `Pin`, `Weld`, `Slider`, `ElasticHinge` and `Network` of the plane, and of space `Rod`, `RigidBody`, `PointMass`, `Ball`, `Weld`, `Revolute`, `Prismatic`, `Cylindrical`, `Universal` and `ElasticHinge`, and `Driven` joints whose law can be lifted, in tuples, arrays, vectors and branches, with names or without; `Taylor` knows those but for `Driven` joints and, in space, `Cylindrical`, `Universal` and `ElasticHinge`",
    note = "functions of lists know `BodyAxes`, `Hinge`, `Slide` and `Link`; joints that are driven or have modes they do not: accelerations of such scenes are those of `System::with_accelerations`",
    note = "gradients of all scenes go by jets or dual numbers; `Dop853` runs all scenes"
)]
pub trait Takes<S: Space, W: Walk<S>>: Shape<S> {
    /// Meets all bodies and joints inside.
    fn take(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried;
}

/// Items one after the other.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn take_items<S: Space, W: Selective<S>, E: Items<S>>(
    items: &[E::Item],
    walk: &mut W,
    carried: W::Carried,
    stores: Of<'_, S, W, E>,
) -> W::Carried
where
    E::Item: Takes<S, W>,
{
    let (n, mut slices, mut carried) = (items.len(), W::Stores::all::<E>(stores), carried);
    if !W::Stores::fit::<E::Item>(&slices, n) {
        return carried;
    }
    // Two loops, for a compiler knows of both that they stay within.
    if W::OUTWARD {
        #[allow(clippy::needless_range_loop)] // one counter for items and stores
        for i in 0..n {
            carried = items[i].take(walk, carried, W::Stores::at::<E::Item>(&mut slices, i));
        }
    } else {
        let mut others = n;
        if W::LAST_APART && n > 0 {
            others = n - 1;
            carried = items[others].take(walk, carried, W::Stores::at::<E::Item>(&mut slices, others));
        }
        for i in (0..others).rev() {
            carried = items[i].take(walk, carried, W::Stores::at::<E::Item>(&mut slices, i));
        }
    }
    carried
}
