//! What a planar joint has to say of itself, and how that makes it an element.

use super::axes::Axes;
use super::linear::{HingeAxes, Linear};
use super::{Acceleration, ElasticHinge, Frame, JointMotion, Pin, Planar, Slider, Turn, Weld};
use crate::counts::Counted;
use crate::element::{Element, Posture, Springs};
use crate::error::Fault;
use crate::mirror::{Position, Rate};
use crate::relation::Closures;
use crate::release::Release;
use crate::scalar::Scalar;
use crate::shape::{JointPosture, Native, PerAxes, Shape};
use crate::spring::SpringLaw;
use core::fmt::Debug;
use typenum::{U0, U1, U3};

/// A massless joint in the plane.
///
/// With these methods and a [`Condense`](crate::element::Condense) for the relations it can take, a type is a joint; the
/// macro `joint!` in this file, which is not exported, makes it an element.
pub trait Joint<T: Scalar>: Counted + Copy + Debug + 'static {
    /// Coordinates of the joint.
    type Position: Position<T, Rate = Self::Rate>;
    /// Rates and accelerations of the coordinates.
    type Rate: Rate<T>;
    /// What the joint's elimination keeps for the outward walk.
    type Kept<C: Closures>: Clone;

    /// What the joint stores of the place of its outboard side.
    type Axes: Axes;

    /// Whether no law of the joint's springs and dampers has to be read where the last sweep of an implicit rule has led.
    const LINEAR: bool = true;

    /// Whether the orientation of the outboard body does not depend on that of the inboard one.
    const ABSOLUTE: bool = false;

    /// The name of the joint's type.
    fn kind() -> &'static str {
        core::any::type_name::<Self>()
    }
    /// The position of an unturned joint, and the rates of one at rest.
    fn still() -> (Self::Position, Self::Rate);
    /// Room for the gains.
    fn kept<C: Closures>() -> Self::Kept<C>;
    /// Whether the joint's pivots resist, so that gains are finite but for what velocities, loads and springs contribute.
    fn is_finite<C: Closures>(kept: &Self::Kept<C>) -> bool;

    /// The gains without what velocities, loads and springs contribute.
    fn homogeneous<C: Closures>(kept: &Self::Kept<C>) -> Self::Kept<C>;

    /// Sets the rotary coordinate so that the outboard body has the angle (rad) that `next` gives, and gives that orientation.
    fn configure(
        &self,
        position: &mut Self::Position,
        inboard: Turn<T>,
        next: &mut impl FnMut(Turn<T>) -> T,
    ) -> Turn<T>;

    /// Takes the point mass (kg) that its outboard neighbour lumps at the joint. Where the points of a joint coincide, that is
    /// as good on the other side.
    fn lump(&mut self, mass: T) -> T {
        mass
    }

    /// The orientation of the outboard body.
    fn turned(&self, position: &Self::Position, rate: &Self::Rate, inboard: Turn<T>) -> Turn<T>;

    /// The orientation of the outboard body, and what the joint stores of the place of its outboard side.
    #[cfg_attr(optimised, inline(always))]
    #[allow(clippy::too_many_arguments)] // one store each
    fn orient(
        &self,
        position: &Self::Position,
        rate: &Self::Rate,
        inboard: Turn<T>,
        _x: &mut <Self::Axes as Axes>::Per<T>,
        _y: &mut <Self::Axes as Axes>::Per<T>,
        _p: &mut <Self::Axes as Axes>::Per<T>,
        _q: &mut <Self::Axes as Axes>::Per<T>,
    ) -> Turn<T> {
        self.turned(position, rate, inboard)
    }

    /// The motion of the joint, if its inboard side moves like this.
    fn moved(
        &self,
        inboard: Frame<T>,
        position: &Self::Position,
        rate: &Self::Rate,
        acceleration: &Self::Rate,
    ) -> JointMotion<T>;

    /// The coordinates that the joint lets move, and what resists them.
    fn release(&self, motion: &JointMotion<T>, position: &Self::Position, rate: &Self::Rate) -> Release<Planar<T>>;

    /// Rejects parameters that make no mechanics.
    ///
    /// # Errors
    /// What is wrong with them.
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }

    /// The accelerations of the coordinates, and of the outboard side, from that of the inboard side.
    fn recovered<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        offset: <Self::Axes as Axes>::Offset<T>,
        kept: &Self::Kept<C>,
        multipliers: &C::Each<T>,
        rate: &mut Self::Rate,
    ) -> Acceleration<T>;

    /// The accelerations as [`recovered`](Self::recovered) finds them, after a sweep in which springs entered by `By`: for a joint
    /// that can do with less then, or remembers for the next sweep what it needs of the inboard side.
    #[cfg_attr(optimised, inline(always))]
    fn recovered_after<C: Closures, By: Springs<T>>(
        &self,
        inboard: Acceleration<T>,
        offset: <Self::Axes as Axes>::Offset<T>,
        kept: &mut Self::Kept<C>,
        multipliers: &C::Each<T>,
        rate: &mut Self::Rate,
    ) -> Acceleration<T> {
        self.recovered::<C>(inboard, offset, kept, multipliers, rate)
    }
}

/// What the walks read of the outboard side of a joint.
#[cfg_attr(optimised, inline(always))]
pub(super) fn offset<T: Scalar, J>(posture: Posture<'_, Planar<T>, J>) -> <<J as Joint<T>>::Axes as Axes>::Offset<T>
where
    J: Joint<T> + Shape<Planar<T>, Store<PerAxes<T>> = <<J as Joint<T>>::Axes as Axes>::Per<T>>,
{
    <J as Joint<T>>::Axes::offset(posture.x, posture.y, posture.p, posture.q)
}

impl<T: Scalar, J: Joint<T> + Native> crate::shape::Joint<Planar<T>> for J {
    type Position = <J as Joint<T>>::Position;
    type Rate = <J as Joint<T>>::Rate;
    type Kept<C: Closures> = <J as Joint<T>>::Kept<C>;
    type Per<X: Copy> = <J::Axes as Axes>::Per<X>;

    const LINEAR: bool = <J as Joint<T>>::LINEAR;

    fn kind() -> &'static str {
        <J as Joint<T>>::kind()
    }
    fn still() -> (<J as Joint<T>>::Position, <J as Joint<T>>::Rate) {
        <J as Joint<T>>::still()
    }
    fn kept<C: Closures>() -> <J as Joint<T>>::Kept<C> {
        <J as Joint<T>>::kept::<C>()
    }
    fn per<X: Copy>(fill: X) -> <J::Axes as Axes>::Per<X> {
        J::Axes::per(fill)
    }
    fn is_finite<C: Closures>(kept: &<J as Joint<T>>::Kept<C>) -> bool {
        <J as Joint<T>>::is_finite::<C>(kept)
    }
    fn configure(
        &self,
        position: &mut <J as Joint<T>>::Position,
        inboard: Turn<T>,
        next: &mut impl FnMut(Turn<T>) -> T,
    ) -> Turn<T> {
        Joint::configure(self, position, inboard, next)
    }
    #[cfg_attr(optimised, inline(always))]
    fn recover<C: Closures, By: Springs<T>>(
        &self,
        inboard: Acceleration<T>,
        posture: JointPosture<'_, Planar<T>, J>,
        kept: &mut <J as Joint<T>>::Kept<C>,
        multipliers: &C::Each<T>,
        rate: &mut <J as Joint<T>>::Rate,
    ) -> Acceleration<T> {
        let (x, y, p, q) = posture;
        let offset = J::Axes::offset(x, y, p, q);
        self.recovered_after::<C, By>(inboard, offset, kept, multipliers, rate)
    }
    #[cfg_attr(optimised, inline(always))]
    fn respond<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        posture: JointPosture<'_, Planar<T>, J>,
        kept: &<J as Joint<T>>::Kept<C>,
        multipliers: &C::Each<T>,
        rate: &mut <J as Joint<T>>::Rate,
    ) -> Acceleration<T> {
        let (x, y, p, q) = posture;
        let offset = J::Axes::at_rest::<T>(J::Axes::offset(x, y, p, q));
        self.recovered::<C>(inboard, offset, &J::homogeneous::<C>(kept), multipliers, rate)
    }
    #[cfg_attr(optimised, inline(always))]
    fn motion(
        &self,
        inboard: Frame<T>,
        position: &<J as Joint<T>>::Position,
        rate: &<J as Joint<T>>::Rate,
        acceleration: &<J as Joint<T>>::Rate,
    ) -> (JointMotion<T>, Frame<T>) {
        let motion = self.moved(inboard, position, rate, acceleration);
        (motion, motion.outboard)
    }
    #[cfg_attr(optimised, inline(always))]
    fn release(
        &self,
        motion: &JointMotion<T>,
        position: &<J as Joint<T>>::Position,
        rate: &<J as Joint<T>>::Rate,
    ) -> Release<Planar<T>> {
        Joint::release(self, motion, position, rate)
    }
    fn check(&self) -> Result<(), Fault> {
        Joint::<T>::check(self)
    }
}

/// Makes planar joints elements.
macro_rules! joint {
    ([$($generics:tt)*] $Joint:ty) => {
        crate::shape::leaf!(joint [$($generics)*] $Joint: Planar<T>);

        impl<$($generics)*> Element<Planar<T>> for $Joint {
            type Position = <Self as Joint<T>>::Position;
            type Rate = <Self as Joint<T>>::Rate;
            const ABSOLUTE: bool = <Self as Joint<T>>::ABSOLUTE;
            const TURNS_ANEW: bool = <Self as Joint<T>>::ABSOLUTE;

            fn lump(&mut self, mass: T) -> T {
                Joint::lump(self, mass)
            }
            #[inline(always)]
            fn turned(&self, position: &Self::Position, rate: &Self::Rate, turn: Turn<T>) -> Turn<T> {
                Joint::turned(self, position, rate, turn)
            }
            #[cfg_attr(optimised, inline(always))]
            fn orient(
                &self,
                position: &Self::Position,
                rate: &Self::Rate,
                turn: Turn<T>,
                x: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
                y: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
                p: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
                q: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
            ) -> Turn<T> {
                Joint::orient(self, position, rate, turn, x, y, p, q)
            }
            #[cfg_attr(optimised, inline(always))]
            fn resolve(
                _: &<<Self as Joint<T>>::Axes as Axes>::Per<T>,
                x: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
                y: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
                p: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
                q: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
            ) {
                <Self as Joint<T>>::Axes::resolve::<T>(x, y, p, q);
            }
        }
    };
}
joint!([T: Scalar] Pin);
joint!([T: Scalar] Weld<T>);
joint!([T: Scalar, S: SpringLaw<T>] Slider<T, S>);
joint!([T: Scalar, L: SpringLaw<T>] ElasticHinge<L>);
joint!([T: Scalar, R: SpringLaw<T>, F: SpringLaw<T>, G: SpringLaw<T>, A: HingeAxes]
    ElasticHinge<R, Linear<T, F, G, A>>);

/// Gives joints their counts, and says that they are of this crate.
macro_rules! count {
    ([$($generics:tt)*] $Joint:ty: $Freedoms:ident) => {
        impl<$($generics)*> Counted for $Joint {
            type Bodies = U0;
            type Freedoms = $Freedoms;
        }

        impl<$($generics)*> Native for $Joint {}
    };
}
count!([] Pin: U1);
count!([T] Weld<T>: U0);
count!([T, S] Slider<T, S>: U1);
count!([R] ElasticHinge<R>: U1);
count!([R, T, X, Y, A] ElasticHinge<R, Linear<T, X, Y, A>>: U3);
