//! What stores and walks ask of bodies and joints, whatever their space.

use crate::mirror::{Position, Rate};
use crate::relation::Closures;
use crate::space::Space;

/// A body, as it is the same in all spaces. Each space says so of its own bodies (`planar::Body`, `spatial::Body`).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a body of the chain's space `{S}`",
    label = "not an element of `{S}`"
)]
pub trait Body<S: Space>: Copy + 'static {}

/// A joint, as it is the same in all spaces. Each space says so of its own joints (`planar::Joint`, `spatial::Joint`).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a joint of the chain's space `{S}`",
    label = "not an element of `{S}`"
)]
pub trait Joint<S: Space>: Copy + 'static {
    /// Its coordinates.
    type Position: Position<S::Scalar, Rate = Self::Rate>;
    /// Their rates and accelerations.
    type Rate: Rate<S::Scalar>;
    /// What its elimination keeps for the outward walk.
    type Kept<C: Closures>: Clone;
    /// One `X` for each set of axes that it keeps.
    type Per<X: Copy>: Clone;

    /// The position of an unturned joint.
    fn position() -> Self::Position;
    /// The rates of a joint at rest.
    fn rate() -> Self::Rate;
    /// Room for the gains.
    fn kept<C: Closures>() -> Self::Kept<C>;
    /// `fill` for each set of axes.
    fn per<X: Copy>(fill: X) -> Self::Per<X>;
}

/// Gives bodies or joints of a space their shape: `leaf!(body [T: Scalar] Rod<T>: Planar<T>)`.
macro_rules! leaf {
    (body [$($generics:tt)*] $Leaf:ty: $S:ty) => {
        $crate::shape::leaf!(InBody, in_body, 1, 0, [$($generics)*] $Leaf, $S);
    };
    (joint [$($generics:tt)*] $Leaf:ty: $S:ty) => {
        $crate::shape::leaf!(InJoint, in_joint, 0, 1, [$($generics)*] $Leaf, $S);
    };
    ($In:ident, $in:ident, $bodies:literal, $joints:literal, [$($generics:tt)*] $Leaf:ty, $S:ty) => {
        impl<$($generics)*> $crate::shape::Shape<$S> for $Leaf {
            type Store<Stored: $crate::shape::Field<$S>> = Stored::$In<Self>;

            const BODIES: Option<usize> = Some($bodies);
            const JOINTS: Option<usize> = Some($joints);

            fn store<Stored: $crate::shape::Field<$S>>(&self, fill: Stored::Fill) -> Stored::$In<Self> {
                Stored::$in(self, fill)
            }
        }
    };
}
pub(crate) use leaf;
