//! The joint of a chain that floats.

use crate::element::{Condense, Given, Posture, Sweep};
use crate::planar::axes::Coincident;
use crate::planar::{Acceleration, Frame, Joint, Planar, Turn};
use crate::relation::plane::{Empty, Relation, Rigid};
use crate::relation::{Closures, Open};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// The joint of a chain that floats: coordinates x, y and the absolute angle of its first body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Floating<T> {
    /// Point mass that the first body lumps at its inboard end.
    lumped: T,
}

impl<T: Scalar> Floating<T> {
    pub(super) fn new() -> Self {
        Self { lumped: T::zero() }
    }
}

impl<T: Scalar> Joint<T> for Floating<T> {
    type Position = (T, T, T);
    type Rate = (T, T, T);
    type Kept<C: Closures> = Acceleration<T>;

    type Axes = Coincident;

    const TURNS: bool = true;
    const ABSOLUTE: bool = true;

    fn position() -> (T, T, T) {
        (T::zero(), T::zero(), T::zero())
    }
    fn rate() -> (T, T, T) {
        (T::zero(), T::zero(), T::zero())
    }
    fn kept<C: Closures>() -> Acceleration<T> {
        Acceleration { linear: Vector2::new(T::zero(), T::zero()), angular: T::zero() }
    }
    fn homogeneous<C: Closures>(_: &Acceleration<T>) -> Acceleration<T> {
        <Self as Joint<T>>::kept::<C>() // a chain without closures responds to none
    }
    fn is_finite<C: Closures>(kept: &Acceleration<T>) -> bool {
        kept.linear.x.is_finite() && kept.linear.y.is_finite() && kept.angular.is_finite()
    }
    fn lump(&mut self, mass: T) -> T {
        self.lumped = mass;
        T::zero()
    }
    fn aim(&self, position: &mut (T, T, T), _: Turn<T>, next: &mut impl FnMut() -> T) -> Turn<T> {
        position.2 = next();
        Turn { angle: position.2, rate: T::zero() }
    }
    #[inline(always)]
    fn turned(&self, position: &(T, T, T), rate: &(T, T, T), _: Turn<T>) -> Turn<T> {
        Turn { angle: position.2, rate: rate.2 }
    }
    #[inline(always)]
    fn moved(&self, inboard: Frame<T>, position: &(T, T, T), rate: &(T, T, T), acceleration: &(T, T, T)) -> Frame<T> {
        Frame {
            place: inboard.place + Vector2::new(position.0, position.1),
            velocity: inboard.velocity + Vector2::new(rate.0, rate.1),
            turn: Turn { angle: position.2, rate: rate.2 },
            acceleration: Acceleration {
                linear: inboard.acceleration.linear + Vector2::new(acceleration.0, acceleration.1),
                angular: acceleration.2,
            },
        }
    }
    #[inline(always)]
    fn recovered<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        (): (),
        kept: &Acceleration<T>,
        _: &C::Each<T>,
        rate: &mut (T, T, T),
    ) -> Acceleration<T> {
        // The sweep's ground falls upward by gravity; coordinates are relative to the ground.
        let relative = kept.linear - inboard.linear;
        *rate = (relative.x, relative.y, kept.angular);
        *kept
    }
}

impl<T: Scalar, R: Rigid<T, Closures = Open>, W: Sweep<Planar<T>, Closures = Open>> Condense<Planar<T>, R, W>
    for Floating<T>
{
    type Out = Empty;

    #[inline(always)]
    fn condense(
        &self,
        outer: R,
        _: Posture<'_, Planar<T>, Self>,
        _: Given<'_, Planar<T>, Self, W>,
        kept: &mut Acceleration<T>,
    ) -> Empty {
        let (linear, angular) = outer.full().with_mass(self.lumped).free();
        *kept = Acceleration { linear, angular };
        Empty
    }
}
