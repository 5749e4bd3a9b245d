//! Fields: what a store holds for each body, each joint and each joint that closes a loop.

use super::closing::Closing;
use super::leaf::{Body, Joint};
use crate::relation::{Closures, LoopGain, Looped, Open, Own, Wrench, WrenchOf};
use crate::space::Space;
use core::marker::PhantomData;
use num_traits::Zero;

/// What a store holds for each body and each joint.
pub trait Field<S: Space>: 'static {
    /// What the store holds for a body.
    type InBody<B: Body<S>>: Clone;
    /// What the store holds for a joint.
    type InJoint<J: Joint<S>>: Clone;
    /// What the store holds for a joint that closes a loop.
    type InClosing<K: Closing<S>>: Clone;
    /// The field in an arm.
    type In<Y: Way>: Field<S>;
    /// What the store is filled with.
    type Fill: Copy;

    /// What the store holds for a body at first.
    fn in_body<B: Body<S>>(body: &B, fill: Self::Fill) -> Self::InBody<B>;
    /// What the store holds for a joint at first.
    fn in_joint<J: Joint<S>>(joint: &J, fill: Self::Fill) -> Self::InJoint<J>;
    /// What the store holds at first for a joint that closes a loop.
    fn in_closing<K: Closing<S>>(closing: &K, fill: Self::Fill) -> Self::InClosing<K>;
    /// What the field in an arm is filled with.
    fn fill_in<Y: Way>(fill: Self::Fill) -> <Self::In<Y> as Field<S>>::Fill;
}

/// How an arm hangs in a composite: which closure forces act in it, where `C` act on the composite.
pub trait Way: 'static {
    /// The closure forces that act in the arm.
    type Forces<C: Closures>: Closures;
}

/// An arm with a free tip: no closure forces reach into it.
#[derive(Clone, Copy, Debug)]
pub struct Arm;

/// The main arm of a loop with the closure forces `O`, from whose end the chain goes on.
#[derive(Clone, Copy, Debug)]
pub struct Main<O>(PhantomData<O>);

/// The side arm of a loop with the closure forces `O`.
#[derive(Clone, Copy, Debug)]
pub struct Side<O>(PhantomData<O>);

impl Way for Arm {
    type Forces<C: Closures> = Open;
}

impl<O: Own> Way for Main<O> {
    type Forces<C: Closures> = Looped<C, O>;
}

impl<O: Own> Way for Side<O> {
    type Forces<C: Closures> = O;
}

/// One field a paragraph: what it holds for a body `B`, a joint `J`, what closes a loop `K`; what it is filled with, and how;
/// what it is in an arm that hangs by `Y`.
macro_rules! fields {
    ($(
        $(#[$doc:meta])*
        $Field:ident $(<$X:ident: $bound:path>)? = |$B:ident, $J:ident, $K:ident, $fill:ident: $Fill:ty|
            { $InBody:ty = $body:expr } { $InJoint:ty = $joint:expr } { $InClosing:ty = $closing:expr } in $Y:ident: $In:ty;
    )*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $Field<$($X)?>(PhantomData<($($X,)?)>);

        impl<S: Space $(, $X: $bound + 'static)?> Field<S> for $Field<$($X)?> {
            type InBody<$B: Body<S>> = $InBody;
            type InJoint<$J: Joint<S>> = $InJoint;
            type InClosing<$K: Closing<S>> = $InClosing;
            type In<$Y: Way> = $In;
            type Fill = $Fill;

            #[inline]
            fn in_body<$B: Body<S>>(_: &$B, $fill: $Fill) -> $InBody {
                $body
            }
            #[inline]
            fn in_joint<$J: Joint<S>>(_: &$J, $fill: $Fill) -> $InJoint {
                $joint
            }
            #[inline]
            fn in_closing<$K: Closing<S>>(_: &$K, $fill: $Fill) -> $InClosing {
                $closing
            }
            #[inline]
            fn fill_in<$Y: Way>(fill: $Fill) -> $Fill {
                fill
            }
        }
    )*};
}
fields! {
    /// Positions of joint coordinates.
    Positions = |B, J, K, _fill: ()|
        { () = () } { J::Position = J::still().0 } { PhantomData<S::Numbers> = PhantomData } in Y: Self;
    /// Rates and accelerations of joint coordinates; with accelerations the forces that close loops.
    Rates = |B, J, K, _fill: ()|
        { () = () } { J::Rate = J::still().1 } { S::Numbers = S::numbers(Wrench::none()) } in Y: Self;
    /// What the outward walk needs of each elimination where `C` act.
    Kept<C: Closures> = |B, J, K, _fill: ()|
        { () = () } { J::Kept<C> = J::kept::<C>() }
        { (LoopGain<WrenchOf<S>, S::Scalar, C, K::Closures>, WrenchOf<S>) = (LoopGain::blank(Wrench::none(), K::Closures::measure(|| K::Closures::each(|_| S::Scalar::zero()))), Wrench::none()) }
        in Y: Kept<Y::Forces<C>>;
    /// A wrench for each of the closure forces `C` that acts on a body or a joint; the gain of a loop, and the wrench through what closes it.
    Columns<C: Closures> = |B, J, K, _fill: ()|
        { C::Each<WrenchOf<S>> = C::each(|_| Wrench::none()) } { C::Each<WrenchOf<S>> = C::each(|_| Wrench::none()) }
        { (LoopGain<WrenchOf<S>, S::Scalar, C, K::Closures>, WrenchOf<S>) = (LoopGain::blank(Wrench::none(), K::Closures::measure(|| K::Closures::each(|_| S::Scalar::zero()))), Wrench::none()) }
        in Y: Columns<Y::Forces<C>>;
    /// One `X` for each body.
    PerBody<X: Copy> = |B, J, K, fill: X| { X = fill } { () = _ = fill } { () = _ = fill } in Y: Self;
    /// One `X` for each joint, those that close loops among them.
    PerJoint<X: Copy> = |B, J, K, fill: X| { () = _ = fill } { X = fill } { X = fill } in Y: Self;
    /// One number for each force that closes a loop.
    PerClosure = |B, J, K, _fill: ()|
        { () = () } { () = () } { <K::Closures as Closures>::Each<S::Scalar> = K::Closures::each(|_| S::Scalar::zero()) } in Y: Self;
    /// One `X` for each loop.
    PerLoop<X: Copy> = |B, J, K, fill: X| { () = _ = fill } { () = _ = fill } { X = fill } in Y: Self;
    /// One `X` for each set of axes: those of bodies, and those of joints that keep some (in the plane where they push along the axes of
    /// a neighbour, in space all of them).
    PerAxes<X: Copy> = |B, J, K, fill: X| { X = fill } { J::Per<X> = J::per(fill) } { K::PerAxes<X> = K::per_axes(fill) } in Y: Self;
}
