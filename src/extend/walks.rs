//! Walks over chains of a user's own: values that say what is done at a body and at a joint.
//!
//! No composite, body or joint names a walk. A new one is a type of its own:
//!
//! ```
//! use catena::extend::walks::{AtBody, AtJoint, Body, Joint, Outward, Shape, Walk, Way};
//! use catena::planar::{Branch, Pin, Planar, Rod};
//! use catena::system::Space;
//!
//! /// Counts the bodies of the longest row that no joint interrupts.
//! #[derive(Default)]
//! struct Rows {
//!     row: usize,
//!     longest: usize,
//! }
//!
//! impl<S: Space> Walk<S> for Rows {
//!     type Carried = ();
//!     type Stores = (); // reads nothing, writes nothing
//! }
//!
//! impl<S: Space> Outward<S> for Rows {
//!     type In<Y: Way> = Self; // the same walk in arms
//!     fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self) -> X) -> X {
//!         let before = core::mem::take(&mut self.row);
//!         let out = go(self);
//!         self.row = before;
//!         out
//!     }
//!     fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {
//!         self.row += 1;
//!         self.longest = self.longest.max(self.row);
//!     }
//!     fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {
//!         self.row = 0;
//!     }
//! }
//!
//! let rod = Rod::uniform(1.0_f64, 1.0);
//! let mut rows = Rows::default();
//! Shape::<Planar<f64>>::outward(&(rod, rod, Branch((Pin, [rod; 3])), rod, Pin, rod), &mut rows, (), ());
//! assert_eq!(rows.longest, 3);
//! ```
//!
//! What is easily done wrong:
//!
//! * What a walk outward carries does not come back from an arm: totals and numbers of stations belong into the walk.
//! * A walk sees the entry of one element at a time. One that is to keep a reference to an entry reads its store as
//!   [`Held`].
//! * Stores in a bundle are not known to be apart: where sines are to vectorise, a walk takes its bundle apart in
//!   [`Outward::items`] and calls a function with one slice each, as poses of arrays do.

pub use crate::shape::{
    AtBody, AtClosing, AtJoint, Body, Closing, Field, Held, Inward, Joint, JointPosture, Member, Mut, Nth, Of, Outward,
    PerBody, PerJoint, Positions, Rates, Ref, Shape, Slot, Walk, Way,
};
