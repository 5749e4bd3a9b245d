//! What a spatial joint has to say of itself, and how that makes it an element.

use super::stored::{Axes, Biases, Sets, StoredIn};
use super::{
    Acceleration, Ball, Cylindrical, ElasticHinge, Floating, Frame, JointMotion, Linear, Prismatic, Revolute,
    RotaryLaw, Spatial, Turn,
};
use super::{Universal, Weld, release::Release};
use crate::counts::Counted;
use crate::element::{Element, Springs};
use crate::error::Fault;
use crate::mirror::{Position, Rate};
use crate::relation::Closures;
use crate::relation::spatial::algebra::Columns;
use crate::scalar::Scalar;
use crate::shape::{JointPosture, Native};
use crate::spring::SpringLaw;
use core::fmt::Debug;
use nalgebra::Vector3;
use typenum::{U0, U1, U2, U3, U6};

/// A massless joint in space.
///
/// With these methods and a [`Condense`](crate::element::Condense) for the relations it can take, a type is a joint; the
/// macro `joint!` in this file, which is not exported, makes it an element.
pub trait Joint<T: Scalar>: Copy + Debug + 'static {
    /// Coordinates of the joint.
    type Position: Position<T, Rate = Self::Rate>;
    /// Rates and accelerations of the coordinates.
    type Rate: Rate<T>;
    /// What the joint's elimination keeps for the outward walk.
    type Kept<C: Closures>: Clone;
    /// How many sets of axes the joint stores.
    type Sets: Sets;

    /// Whether no law of the joint's springs and dampers has to be read where the last sweep of an implicit rule has led.
    const LINEAR: bool = true;
    /// Whether one of its laws resists turns: [`ROTARY`](crate::shape::Shape::ROTARY).
    const ROTARY: bool = false;

    /// The position of an unturned joint, and the rates of one at rest.
    fn still() -> (Self::Position, Self::Rate);
    /// Room for the gains.
    fn kept<C: Closures>() -> Self::Kept<C>;
    /// Whether the joint's pivots resist, so that gains are finite but for what velocities, loads and springs contribute.
    fn is_finite<C: Closures>(kept: &Self::Kept<C>) -> bool;

    /// Sets the rotary coordinates from the numbers of [`System::at_rest`](crate::system::System::at_rest), and gives the orientation of the
    /// outboard body.
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

    /// The orientation of the outboard body, and what the other walks read.
    fn oriented(&self, position: &Self::Position, rate: &Self::Rate, inboard: Turn<T>) -> (Turn<T>, StoredIn<T, Self>);

    /// Stores what the other walks read; what they do not read stays as it is.
    #[inline(always)]
    fn store(stored: StoredIn<T, Self>, x: &mut Axes<T, Self>, y: &mut Biases<T, Self>) {
        (*x, *y) = stored;
    }

    /// The motion of the joint's outboard side.
    fn moved(
        &self,
        inboard: Frame<T>,
        position: &Self::Position,
        rate: &Self::Rate,
        acceleration: &Self::Rate,
    ) -> JointMotion<T>;

    /// The coordinates that the joint lets move, and what resists them.
    fn release(&self, motion: &JointMotion<T>, position: &Self::Position, rate: &Self::Rate) -> Release<T>;

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
        stored: (&Axes<T, Self>, &Biases<T, Self>),
        kept: &Self::Kept<C>,
        multipliers: &C::Each<T>,
        rate: &mut Self::Rate,
    ) -> Acceleration<T>;

    /// The accelerations without what velocities, loads and springs contribute.
    fn responded<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        stored: (&Axes<T, Self>, &Biases<T, Self>),
        kept: &Self::Kept<C>,
        multipliers: &C::Each<T>,
        rate: &mut Self::Rate,
    ) -> Acceleration<T>;
}

impl<T: Scalar, J: Joint<T> + Native> crate::shape::Joint<Spatial<T>> for J {
    type Position = <J as Joint<T>>::Position;
    type Rate = <J as Joint<T>>::Rate;
    type Kept<C: Closures> = <J as Joint<T>>::Kept<C>;
    type Per<X: Copy> = <J::Sets as Sets>::Per<X>;

    const LINEAR: bool = <J as Joint<T>>::LINEAR;

    fn still() -> (<J as Joint<T>>::Position, <J as Joint<T>>::Rate) {
        <J as Joint<T>>::still()
    }
    fn kept<C: Closures>() -> <J as Joint<T>>::Kept<C> {
        <J as Joint<T>>::kept::<C>()
    }
    fn per<X: Copy>(fill: X) -> <J::Sets as Sets>::Per<X> {
        J::Sets::per(fill)
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
        posture: JointPosture<'_, Spatial<T>, J>,
        kept: &mut <J as Joint<T>>::Kept<C>,
        multipliers: &C::Each<T>,
        rate: &mut <J as Joint<T>>::Rate,
    ) -> Acceleration<T> {
        self.recovered::<C>(inboard, (posture.0, posture.1), kept, multipliers, rate)
    }
    #[cfg_attr(optimised, inline(always))]
    fn respond<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        posture: JointPosture<'_, Spatial<T>, J>,
        kept: &<J as Joint<T>>::Kept<C>,
        multipliers: &C::Each<T>,
        rate: &mut <J as Joint<T>>::Rate,
    ) -> Acceleration<T> {
        self.responded::<C>(inboard, (posture.0, posture.1), kept, multipliers, rate)
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
    ) -> Release<T> {
        Joint::release(self, motion, position, rate)
    }
    fn check(&self) -> Result<(), Fault> {
        Joint::<T>::check(self)
    }
}

/// Makes spatial joints elements.
macro_rules! joint {
    ([$($generics:tt)*] $Joint:ty, $absolute:literal) => {
        crate::shape::leaf!(joint [$($generics)*] $Joint: Spatial<T>, rotary: <Self as Joint<T>>::ROTARY);

        impl<$($generics)*> Element<Spatial<T>> for $Joint {
            type Position = <Self as Joint<T>>::Position;
            type Rate = <Self as Joint<T>>::Rate;
            const ABSOLUTE: bool = $absolute;
            const TURNS_ANEW: bool = $absolute;

            fn lump(&mut self, mass: T) -> T {
                Joint::lump(self, mass)
            }
            #[inline(always)]
            fn turned(&self, position: &Self::Position, rate: &Self::Rate, turn: Turn<T>) -> Turn<T> {
                self.oriented(position, rate, turn).0
            }
            #[cfg_attr(optimised, inline(always))]
            fn orient(
                &self,
                position: &Self::Position,
                rate: &Self::Rate,
                turn: Turn<T>,
                x: &mut <<Self as Joint<T>>::Sets as Sets>::Per<Columns<T>>,
                y: &mut <<Self as Joint<T>>::Sets as Sets>::Per<[Vector3<T>; 2]>,
                _: &mut <<Self as Joint<T>>::Sets as Sets>::Per<Vector3<T>>,
                _: &mut <<Self as Joint<T>>::Sets as Sets>::Per<Vector3<T>>,
            ) -> Turn<T> {
                let (outboard, stored) = self.oriented(position, rate, turn);
                <Self as Joint<T>>::store(stored, x, y);
                outboard
            }
            #[cfg_attr(optimised, inline(always))]
            fn resolve(
                _: &<<Self as Joint<T>>::Sets as Sets>::Per<()>,
                _: &mut <<Self as Joint<T>>::Sets as Sets>::Per<Columns<T>>,
                _: &mut <<Self as Joint<T>>::Sets as Sets>::Per<[Vector3<T>; 2]>,
                _: &mut <<Self as Joint<T>>::Sets as Sets>::Per<Vector3<T>>,
                _: &mut <<Self as Joint<T>>::Sets as Sets>::Per<Vector3<T>>,
            ) {
            }
        }
    };
}
joint!([T: Scalar] Ball, true);
joint!([T: Scalar, R: RotaryLaw<T>] ElasticHinge<R>, false);
joint!([T: Scalar, R: RotaryLaw<T>, L: SpringLaw<T>, M: SpringLaw<T>, N: SpringLaw<T>] ElasticHinge<R, Linear<T, L, M, N>>, false);
joint!([T: Scalar] Floating<T>, true);
joint!([T: Scalar] Weld<T>, false);
joint!([T: Scalar, L: SpringLaw<T>] Revolute<T, L>, false);
joint!([T: Scalar, L: SpringLaw<T>] Prismatic<T, L>, false);
joint!([T: Scalar, L: SpringLaw<T>, M: SpringLaw<T>] Universal<T, L, M>, false);
joint!([T: Scalar, L: SpringLaw<T>, M: SpringLaw<T>] Cylindrical<T, L, M>, false);

/// Gives joints their counts, and says that they are of this crate.
macro_rules! count {
    ($([$($generics:tt)*] $Joint:ty: $Freedoms:ident;)*) => {$(
        impl<$($generics)*> Counted for $Joint {
            type Bodies = U0;
            type Freedoms = $Freedoms;
        }

        impl<$($generics)*> Native for $Joint {}
    )*};
}
count! {
    [] Ball: U3;
    [R] ElasticHinge<R>: U3;
    [R, T, X, Y, Z] ElasticHinge<R, Linear<T, X, Y, Z>>: U6;
    [T] Floating<T>: U6;
    [T] Weld<T>: U0;
    [T, L] Revolute<T, L>: U1;
    [T, L] Prismatic<T, L>: U1;
    [T, L, M] Universal<T, L, M>: U2;
    [T, L, M] Cylindrical<T, L, M>: U2;
}
