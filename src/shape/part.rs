//! Parts of composites: where the stores of an item are in those of the whole.

use super::Shape;
use super::closing::Closing;
use super::field::{Arm, Field, Main, Side};
use crate::space::Space;

/// Where a member of a composite is.
pub trait Member<S: Space, E: Shape<S>> {
    /// The member.
    type Item: Shape<S>;
    /// The store of the member.
    fn get<F: Field<S>>(store: &E::Store<F>) -> &<Self::Item as Shape<S>>::Store<F>;
    /// The store of the member, to be written.
    fn get_mut<F: Field<S>>(store: &mut E::Store<F>) -> &mut <Self::Item as Shape<S>>::Store<F>;
}

/// The item of a tuple with a number.
#[derive(Clone, Copy, Debug)]
pub struct Nth<const I: usize>;

/// A composite of equal items.
pub trait Items<S: Space>: Shape<S> {
    /// An item.
    type Item: Shape<S>;
    /// The stores of the items.
    fn slice<F: Field<S>>(store: &Self::Store<F>) -> &[<Self::Item as Shape<S>>::Store<F>];
    /// The stores of the items, to be written.
    fn slice_mut<F: Field<S>>(store: &mut Self::Store<F>) -> &mut [<Self::Item as Shape<S>>::Store<F>];
}

/// An arm that leaves the chain.
pub trait Aside<S: Space>: Shape<S> {
    /// The arm.
    type Arm: Shape<S>;
    /// The store of the arm.
    fn arm<F: Field<S>>(store: &Self::Store<F>) -> &<Self::Arm as Shape<S>>::Store<F::In<Arm>>;
    /// The store of the arm, to be written.
    fn arm_mut<F: Field<S>>(store: &mut Self::Store<F>) -> &mut <Self::Arm as Shape<S>>::Store<F::In<Arm>>;
}

/// The closure forces of a loop `N`.
pub type OwnOf<S, N> = <<N as Parallel<S>>::Closing as Closing<S>>::Closures;
/// The store of the main arm of a loop `N`.
pub type MainStore<S, N, F> = <<N as Parallel<S>>::Main as Shape<S>>::Store<<F as Field<S>>::In<Main<OwnOf<S, N>>>>;
/// The store of the side arm of a loop `N`.
pub type SideStore<S, N, F> = <<N as Parallel<S>>::Side as Shape<S>>::Store<<F as Field<S>>::In<Side<OwnOf<S, N>>>>;
/// The entry of the joint that closes a loop `N`.
pub type ClosingEntry<S, N, F> = <F as Field<S>>::InClosing<<N as Parallel<S>>::Closing>;

/// Two arms in parallel, and the joint that closes their loop.
pub trait Parallel<S: Space>: Shape<S> {
    /// The arm from whose end the chain goes on.
    type Main: Shape<S>;
    /// The other arm.
    type Side: Shape<S>;
    /// The joint that holds the end of the side arm to that of the main arm.
    type Closing: Closing<S>;

    /// The main arm.
    fn main_arm(&self) -> &Self::Main;
    /// The side arm.
    fn side_arm(&self) -> &Self::Side;
    /// The closing joint.
    fn closing_joint(&self) -> &Self::Closing;
    /// The stores of both arms, and the entry of the closing joint.
    #[allow(clippy::type_complexity)] // three of them
    fn fork<F: Field<S>>(
        store: &Self::Store<F>,
    ) -> (&MainStore<S, Self, F>, &SideStore<S, Self, F>, &ClosingEntry<S, Self, F>);
    /// The stores of both arms and the entry of the closing joint, to be written.
    #[allow(clippy::type_complexity)] // three of them
    fn fork_mut<F: Field<S>>(
        store: &mut Self::Store<F>,
    ) -> (&mut MainStore<S, Self, F>, &mut SideStore<S, Self, F>, &mut ClosingEntry<S, Self, F>);
}
