//! Walks over chains, one a file: a value that says what is done at a body and at a joint.
//!
//! No composite, body or joint names a walk. So a new one is a file here, a line below and a call where it is used; or, in a crate that
//! uses this one, a type of its own:
//!
//! ```
//! use catena::element::Space;
//! use catena::planar::{Branch, Pin, Planar, Rod};
//! use catena::shape::{AtBody, AtJoint, Body, Joint, Outward, Shape, Walk, Way};
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
//! * A walk in which closure forces act is another one in each arm of a loop. It overrides
//!   [`Outward::parallel`](crate::shape::Outward::parallel), finds the forces there, and sends walks of its own into both arms
//!   ([`respond`], [`restore`], [`recover`]).
//! * A walk sees the entry of one element at a time. One that is to keep a reference to an entry reads its store as
//!   [`Held`](crate::shape::Held) ([`find`]).
//! * Stores in a bundle are not known to be apart: where sines are to vectorise, a walk takes its bundle apart in
//!   [`Outward::items`](crate::shape::Outward::items) and calls a function with one slice each, as poses of arrays do.
//!
//! Not yet walks: the condensation, whose arguments could be a bundle once it is known why chains in space would then cost more on
//! targets without wide registers; poses; lumping of point masses, which changes elements; and the walks of derivatives
//! ([`Sensitive`](crate::sensitive::Sensitive)), for which the plain element has to become a store.

pub mod broken;
pub mod carrier;
pub mod check;
pub mod configure;
pub mod count;
pub mod entries;
pub mod find;
pub mod fits;
pub mod gather;
pub mod independent;
pub mod look;
pub mod measure;
pub mod parts;
pub mod recover;
pub mod respond;
pub mod restore;
pub mod size;
pub mod spread;
pub mod steer;
pub mod travel;
