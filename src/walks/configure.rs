//! The configuration of a chain from the orientations of its bodies.

use crate::shape::{AtBody, AtJoint, Body, Joint, Mut, Outward, Positions, Shape, Walk, alike};
use crate::space::Space;

/// Sets the rotary coordinates of each joint; `next` is given the orientation of the inboard body and yields one number for each of them,
/// root to tip.
pub fn configure<S: Space, E: Shape<S>>(
    chain: &E,
    position: &mut E::Store<Positions>,
    inboard: S::Turn,
    next: &mut impl FnMut(S::Turn) -> S::Scalar,
) {
    chain.outward(&mut Configure(next), inboard, (position,));
}

/// Yields the numbers.
struct Configure<'n, N>(&'n mut N);

impl<S: Space, N: FnMut(S::Turn) -> S::Scalar> Walk<S> for Configure<'_, N> {
    type Carried = S::Turn;
    type Stores = (Mut<Positions>,);
}

impl<S: Space, N: FnMut(S::Turn) -> S::Scalar> Outward<S> for Configure<'_, N> {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, turn: S::Turn, _: AtBody<'_, S, Self, B>) -> S::Turn {
        turn
    }
    fn joint<J: Joint<S>>(&mut self, joint: &J, turn: S::Turn, (position,): AtJoint<'_, S, Self, J>) -> S::Turn {
        joint.configure(position, turn, self.0)
    }
}
