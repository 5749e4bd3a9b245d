//! Coordinates that turn bodies to absolute orientations.

use crate::shape::{AtBody, AtJoint, Body, Joint, Mut, Outward, Positions, Shape, Walk, alike};
use crate::space::Space;

/// Gives each joint the coordinates that turn its outboard body to an absolute orientation; `next` is told that of the inboard body and
/// yields one number for each rotary coordinate, root to tip.
pub fn aim<S: Space, E: Shape<S>>(
    chain: &E,
    position: &mut E::Store<Positions>,
    inboard: S::Turn,
    next: &mut impl FnMut(S::Turn) -> S::Scalar,
) {
    chain.outward(&mut Aim(next), inboard, (position,));
}

/// Yields the numbers.
struct Aim<'n, N>(&'n mut N);

impl<S: Space, N: FnMut(S::Turn) -> S::Scalar> Walk<S> for Aim<'_, N> {
    type Carried = S::Turn;
    type Stores = (Mut<Positions>,);
}

impl<S: Space, N: FnMut(S::Turn) -> S::Scalar> Outward<S> for Aim<'_, N> {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, turn: S::Turn, _: AtBody<'_, S, Self, B>) -> S::Turn {
        turn
    }
    fn joint<J: Joint<S>>(&mut self, joint: &J, turn: S::Turn, (position,): AtJoint<'_, S, Self, J>) -> S::Turn {
        joint.aim(position, turn, self.0)
    }
}
