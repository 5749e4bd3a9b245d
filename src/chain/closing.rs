//! The condensation of joints that close loops.

use crate::relation::WrenchOf;
use crate::shape::{Closing, Ends};
use crate::space::Space;

/// A joint that closes a loop where the chain hands on `R`, and a torque of type `Q` acts in it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot close a loop where the chain hands on `{R}`",
    label = "this joint does not hold the two arms together here",
    note = "in the plane `Pin` and `Weld` close loops, in space `Ball`, `Revolute` and `Weld`: cut the loop at one of these"
)]
pub trait CloseOff<S: Space, R, Q>: Closing<S> {
    /// What the main arm meets.
    type Main: Copy;
    /// What the side arm meets.
    type Side: Copy;
    /// Cuts the loop; the torque too is passed on.
    fn close_off(&self, outer: R, torque: Q, axes: Ends<'_, S, Self>) -> (Self::Main, Self::Side, WrenchOf<S>);
}
