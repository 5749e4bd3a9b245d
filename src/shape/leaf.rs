//! What stores and walks ask of bodies and joints, whatever their space.

use super::Shape;
use super::field::Field;
use crate::error::Fault;
use crate::mirror::{Position, Rate};
use crate::relation::{AccelerationOf, Closures};
use crate::release::Release;
use crate::space::{FrameOf, Space};
use crate::sweep::Springs;
use num_traits::Zero;

/// A body, as it is the same in all spaces. Each space says so of its own bodies (`planar::Body`, `spatial::Body`).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a body of the chain's space `{S}`",
    label = "not an element of `{S}`"
)]
pub trait Body<S: Space>: Copy + 'static {
    /// Whether the body's condensation takes loads in axes of the body.
    const OWN_AXES: bool = false;

    /// What resolving the body's posture reads of its shape.
    fn size(&self) -> S::Size;
    /// The acceleration of the body's outboard end, from that of its inboard end.
    fn shifted(&self, inboard: AccelerationOf<S>, posture: PostureOf<'_, S>) -> AccelerationOf<S>;
    /// What [`shifted`](Self::shifted) gives without velocities.
    fn swung(&self, inboard: AccelerationOf<S>, posture: PostureOf<'_, S>) -> AccelerationOf<S>;
    /// Motion of the body, if its inboard end moves like this, and motion of its outboard end.
    fn motion(&self, inboard: FrameOf<S>) -> (S::BodyMotion, FrameOf<S>);
    /// [`motion`](Self::motion) of a body that stands as a posture says, for those who find it sooner from that.
    #[inline(always)]
    fn posed(&self, inboard: FrameOf<S>, posture: PostureOf<'_, S>) -> (S::BodyMotion, FrameOf<S>) {
        let _ = posture;
        self.motion(inboard)
    }
    /// Rejects parameters that make no mechanics.
    ///
    /// # Errors
    /// What is wrong with them.
    fn check(&self) -> Result<(), Fault>;
}

/// The posture of a body.
pub type PostureOf<'a, S> = (&'a <S as Space>::X, &'a <S as Space>::Y, &'a <S as Space>::P, &'a <S as Space>::Q);

/// The posture of a joint.
pub type JointPosture<'a, S, J> = (
    &'a <J as Joint<S>>::Per<<S as Space>::X>,
    &'a <J as Joint<S>>::Per<<S as Space>::Y>,
    &'a <J as Joint<S>>::Per<<S as Space>::P>,
    &'a <J as Joint<S>>::Per<<S as Space>::Q>,
);

/// A joint, as it is the same in all spaces. Each space says so of its own joints (`planar::Joint`, `spatial::Joint`).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a joint of the chain's space `{S}`",
    label = "not an element of `{S}`"
)]
pub trait Joint<S: Space>: Copy + 'static {
    /// Coordinates of the joint.
    type Position: Position<S::Scalar, Rate = Self::Rate>;
    /// Rates and accelerations of the coordinates.
    type Rate: Rate<S::Scalar>;
    /// What the joint's elimination keeps for the outward walk.
    type Kept<C: Closures>: Clone;
    /// One `X` for each set of axes that the joint keeps.
    type Per<X: Copy>: Clone;

    /// Whether no law of the joint's springs and dampers has to be read where the last sweep of an implicit rule has led.
    const LINEAR: bool;

    /// Angles whose sines the joint wants before bodies are posed: one or none.
    const SINES: usize = 0;
    /// The angle whose sine the joint wants.
    #[inline(always)]
    fn angle(&self, position: &Self::Position) -> S::Scalar {
        let _ = position;
        S::Scalar::zero()
    }
    /// Stores sine and cosine of that.
    #[inline(always)]
    fn set_sine(&self, x: &mut Self::Per<S::X>, sine_cosine: [S::Scalar; 2]) {
        let _ = (x, sine_cosine);
    }

    /// Stores how the inboard body is turned, where poses inboard carry no attitude: in joints whose shape is [`FLANGED`](Shape::FLANGED).
    #[inline(always)]
    fn set_attitude(&self, x: &mut Self::Per<S::X>, turn: &S::Turn) {
        let _ = (x, turn);
    }

    /// The name of the joint's type.
    fn kind() -> &'static str {
        core::any::type_name::<Self>()
    }
    /// The position of an unturned joint, and the rates of one at rest.
    fn still() -> (Self::Position, Self::Rate);
    /// Room for the gains.
    fn kept<C: Closures>() -> Self::Kept<C>;
    /// `fill` for each set of axes.
    fn per<X: Copy>(fill: X) -> Self::Per<X>;

    /// Whether the joint's pivots resist, so that gains are finite but for what velocities, loads and springs contribute.
    fn is_finite<C: Closures>(kept: &Self::Kept<C>) -> bool;
    /// Sets the rotary coordinates of a configuration, and gives the orientation of the outboard body: one number of `next`, which is
    /// given the orientation of the inboard body, for each. It is an angle of the outboard body or of the joint, as
    /// [`at_rest`](crate::system::System::at_rest) takes them.
    fn configure(
        &self,
        position: &mut Self::Position,
        inboard: S::Turn,
        next: &mut impl FnMut(S::Turn) -> S::Scalar,
    ) -> S::Turn;
    /// The accelerations of the joint's coordinates and of its outboard side from that of its inboard side, after a sweep in which springs
    /// entered by `By`.
    fn recover<C: Closures, By: Springs<S::Scalar>>(
        &self,
        inboard: AccelerationOf<S>,
        posture: JointPosture<'_, S, Self>,
        kept: &mut Self::Kept<C>,
        multipliers: &C::Each<S::Scalar>,
        rate: &mut Self::Rate,
    ) -> AccelerationOf<S>;
    /// What [`recover`](Self::recover) gives without velocities, loads and springs.
    fn respond<C: Closures>(
        &self,
        inboard: AccelerationOf<S>,
        posture: JointPosture<'_, S, Self>,
        kept: &Self::Kept<C>,
        multipliers: &C::Each<S::Scalar>,
        rate: &mut Self::Rate,
    ) -> AccelerationOf<S>;
    /// Motion of the joint, if its inboard side moves like this, and motion of its outboard side.
    fn motion(
        &self,
        inboard: FrameOf<S>,
        position: &Self::Position,
        rate: &Self::Rate,
        acceleration: &Self::Rate,
    ) -> (S::JointMotion, FrameOf<S>);
    /// The coordinates that the joint lets move, and what resists them.
    fn release(&self, motion: &S::JointMotion, position: &Self::Position, rate: &Self::Rate) -> Release<S>;
    /// Rejects parameters that make no mechanics.
    ///
    /// # Errors
    /// What is wrong with them.
    fn check(&self) -> Result<(), Fault>;
}

/// A joint or body of this crate, which says of its space what all spaces ask of it. Types of other crates are none, and no crate can make them
/// one: a trait without parameters is what tells the compiler so.
pub trait Native {}

/// An element that is a body, with its entry of a store.
pub trait AsBody<S: Space>: Shape<S> + Body<S> {
    /// The entry in a store.
    fn entry<F: Field<S>>(store: &Self::Store<F>) -> &F::InBody<Self>;
    /// The entry in a store, to be written.
    fn entry_mut<F: Field<S>>(store: &mut Self::Store<F>) -> &mut F::InBody<Self>;
}

/// An element that is a joint, with its entry of a store.
pub trait AsJoint<S: Space>: Shape<S> + Joint<S> {
    /// The entry in a store.
    fn entry<F: Field<S>>(store: &Self::Store<F>) -> &F::InJoint<Self>;
    /// The entry in a store, to be written.
    fn entry_mut<F: Field<S>>(store: &mut Self::Store<F>) -> &mut F::InJoint<Self>;
}

/// Gives bodies or joints of a space their shape: `leaf!(body [T: Scalar] Rod<T>: Planar<T>)`. No walk is named here.
macro_rules! leaf {
    (body [$($generics:tt)*] $Leaf:ty: $S:ty) => {
        $crate::shape::leaf!(AsBody, InBody, body, in_body, 1, 0, true, false, <Self as $crate::shape::Body<$S>>::OWN_AXES, 0, false, [$($generics)*] $Leaf, $S);
    };
    (joint [$($generics:tt)*] $Leaf:ty: $S:ty) => {
        $crate::shape::leaf!(joint [$($generics)*] $Leaf: $S, rotary: false);
    };
    (joint [$($generics:tt)*] $Leaf:ty: $S:ty, rotary: $rotary:expr) => {
        $crate::shape::leaf!(AsJoint, InJoint, joint, in_joint, 0, 1, <Self as $crate::shape::Joint<$S>>::LINEAR, $rotary, false, <Self as $crate::shape::Joint<$S>>::SINES, false, [$($generics)*] $Leaf, $S);
    };
    (flange [$($generics:tt)*] $Leaf:ty: $S:ty) => {
        $crate::shape::leaf!(AsJoint, InJoint, joint, in_joint, 0, 1, true, false, false, 0, true, [$($generics)*] $Leaf, $S);
    };
    ($As:ident, $In:ident, $meet:ident, $in:ident, $bodies:literal, $joints:literal, $linear:expr, $rotary:expr, $own_axes:expr, $sines:expr, $flanged:expr, [$($generics:tt)*] $Leaf:ty, $S:ty) => {
        impl<$($generics)*> $crate::shape::Shape<$S> for $Leaf {
            type Store<Stored: $crate::shape::Field<$S>> = Stored::$In<Self>;

            const BODIES: Option<usize> = Some($bodies);
            const JOINTS: Option<usize> = Some($joints);
            const LINEAR: bool = $linear;
            const ROTARY: bool = $rotary;
            const OWN_AXES: bool = $own_axes;
            const SINES: usize = $sines;
            const FLANGED: bool = $flanged;

            fn store<Stored: $crate::shape::Field<$S>>(&self, fill: Stored::Fill) -> Stored::$In<Self> {
                Stored::$in(self, fill)
            }
            #[cfg_attr(optimised, inline(always))]
            fn outward<Walk: $crate::shape::Outward<$S>>(
                &self,
                walk: &mut Walk,
                carried: Walk::Carried,
                stores: $crate::shape::Of<'_, $S, Walk, Self>,
            ) -> Walk::Carried {
                walk.$meet(self, carried, <Walk::Stores as $crate::shape::Slot<$S>>::$meet::<Self>(stores))
            }
            #[cfg_attr(optimised, inline(always))]
            fn inward<Walk: $crate::shape::Inward<$S>>(
                &self,
                walk: &mut Walk,
                carried: Walk::Carried,
                stores: $crate::shape::Of<'_, $S, Walk, Self>,
            ) -> Walk::Carried {
                walk.$meet(self, carried, <Walk::Stores as $crate::shape::Slot<$S>>::$meet::<Self>(stores))
            }
        }

        impl<$($generics)*> $crate::shape::$As<$S> for $Leaf {
            #[inline(always)]
            fn entry<Stored: $crate::shape::Field<$S>>(store: &Stored::$In<Self>) -> &Stored::$In<Self> {
                store
            }
            #[inline(always)]
            fn entry_mut<Stored: $crate::shape::Field<$S>>(store: &mut Stored::$In<Self>) -> &mut Stored::$In<Self> {
                store
            }
        }
    };
}
pub(crate) use leaf;
