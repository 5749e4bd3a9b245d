//! The shape of a chain: which bodies and joints it has, in what order walks meet them, and what is stored beside them.
//!
//! A *field* ([`Field`]) says what a store holds for a body, for a joint and for what closes a loop; a composite says once how the
//! stores of its items are put together ([`Shape::Store`]). So gains, postures, loads and coordinates have one type for all.
//!
//! A *walk* ([`Outward`], [`Inward`]) says what is done at a body and at a joint; a composite says once in which order its items are met
//! ([`Shape::outward`], [`Shape::inward`]). So a walk is a file of its own, and neither a composite nor a body or joint knows of it:
//! [`walks`](crate::walks) has them all, and the shortest shows how to write another.

mod closing;
mod field;
mod leaf;
mod part;
mod selective;
mod slot;
mod walk;

pub use closing::{Closing, Ends};
pub use field::{
    Arm, Columns, Field, Kept, Main, PerAxes, PerBody, PerClosure, PerJoint, PerLoop, Positions, Rates, Side, Way,
};
pub(crate) use leaf::leaf;
pub use leaf::{AsBody, AsJoint, Body, Joint, JointPosture, Native, PostureOf};
pub use part::{Aside, ClosingEntry, Items, MainStore, Member, Nth, OwnOf, Parallel, SideStore};
pub use selective::{Around, CarriedIn, Selective, Takes};
pub(crate) use selective::{alike_in_arms, take_items};
pub use slot::{Held, Mut, Ref, Slot};
pub(crate) use walk::alike;
pub use walk::{
    AtBody, AtClosing, AtJoint, Inward, Of, Outward, Slices, Walk, arm_inward, arm_outward, items_outward,
    parallel_outward,
};

use crate::space::Space;

/// A body, a joint, or a chain of them, as far as it is the same in all spaces: what is stored beside it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not an element of the chain's space `{S}`",
    label = "not an element of `{S}`",
    note = "a chain consists of bodies and joints of one space and one scalar: tuples (to 16), arrays or vectors of them"
)]
pub trait Shape<S: Space>: Clone + 'static {
    /// What a field is of all bodies and joints inside.
    type Store<F: Field<S>>: Clone;

    /// Number of bodies inside, if the type decides it.
    const BODIES: Option<usize>;
    /// Number of joints inside, if the type decides it.
    const JOINTS: Option<usize>;
    /// How deep loops are nested inside.
    const LOOPS: usize = 0;
    /// Whether forces of a loop inside are shared out, because some of its closures may follow from others.
    const SHARES: bool = false;
    /// Angles inside whose sines are found before bodies are posed (more than any type says where a vector decides).
    const SINES: usize = 0;
    /// Whether a joint inside leads from axes of bodies back to inertial ones, and has to be told how its body is turned.
    const FLANGED: bool = false;
    /// Whether no law of a spring or damper inside has to be read where the last sweep of an implicit rule has led.
    const LINEAR: bool = true;
    /// Whether a law inside resists turns in space: linear ones are so in rotation vectors alone, so that rules read them where accelerations
    /// have led wherever positions are curved.
    const ROTARY: bool = false;
    /// Whether a body inside takes loads in its own axes.
    const OWN_AXES: bool = false;

    /// A store of a field.
    fn store<F: Field<S>>(&self, fill: F::Fill) -> Self::Store<F>;

    /// Meets all bodies and joints inside from root to tip.
    fn outward<W: Outward<S>>(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried;

    /// Meets all bodies and joints inside from tip to root.
    fn inward<W: Inward<S>>(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried;
}
