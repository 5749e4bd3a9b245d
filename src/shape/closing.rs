//! Joints that close loops.

use crate::error::Fault;
use crate::relation::{Closures, Own, WrenchOf};
use crate::space::{FrameOf, Space};

/// A joint that can close a loop: it holds the ends of two arms together.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot close a loop in `{S}`",
    label = "not a joint that closes loops",
    note = "in the plane `Pin` and `Weld` do, in space `Ball`, `Revolute` and `Weld`: cut the loop at one of these"
)]
pub trait Closing<S: Space>: Clone + 'static {
    /// Closure forces of the joint, ON the last body of the side arm.
    type Closures: Own;
    /// What the joint keeps of the orientations of both ends.
    type PerAxes<X: Copy>: Clone;

    /// Room for what the joint keeps.
    fn per_axes<X: Copy>(fill: X) -> Self::PerAxes<X>;
    /// Keeps what the joint needs of the orientations of both ends.
    #[allow(clippy::too_many_arguments)] // one store each
    fn orient(
        &self,
        side: S::Turn,
        main: S::Turn,
        x: &mut Self::PerAxes<S::X>,
        y: &mut Self::PerAxes<S::Y>,
        p: &mut Self::PerAxes<S::P>,
        q: &mut Self::PerAxes<S::Q>,
    );

    /// The joint and its motion: from the side arm to the main one.
    fn joint(&self, side: &FrameOf<S>, main: &FrameOf<S>) -> S::JointMotion;
    /// The force and torque that closure forces are.
    fn internal(&self, forces: &<Self::Closures as Closures>::Each<S::Scalar>, axes: Ends<'_, S, Self>) -> WrenchOf<S>;
    /// Residual of the closure, in place and in velocity: by how much the end of the side arm misses that of the main one. Where they stand comes first,
    /// how they are turned after that.
    fn residual(&self, side: &FrameOf<S>, main: &FrameOf<S>) -> [<Self::Closures as Closures>::Each<S::Scalar>; 2];
    /// How much the outboard end of a free body would yield to each of the forces.
    fn free_compliance(&self, body: &S::BodyMotion) -> <Self::Closures as Closures>::Each<S::Scalar>;
    /// What each of the forces holds, for messages.
    fn names(&self) -> <Self::Closures as Closures>::Each<&'static str>;
    /// Rejects parameters that make no mechanics.
    ///
    /// # Errors
    /// What is wrong with them.
    fn check(&self) -> Result<(), Fault>;
    /// The name of the joint's type, and its own if it has one.
    fn label(&self) -> (&'static str, Option<&'static str>) {
        (core::any::type_name::<Self>(), None)
    }
}

impl<S: Space, K: Closing<S>> Clone for Ends<'_, S, K> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Space, K: Closing<S>> Copy for Ends<'_, S, K> {}

/// What a closing joint has kept of the orientations of both ends.
pub struct Ends<'a, S: Space, K: Closing<S>> {
    /// First values.
    pub x: &'a K::PerAxes<S::X>,
    /// Second values.
    pub y: &'a K::PerAxes<S::Y>,
    /// Third values.
    pub p: &'a K::PerAxes<S::P>,
    /// Fourth values.
    pub q: &'a K::PerAxes<S::Q>,
}
