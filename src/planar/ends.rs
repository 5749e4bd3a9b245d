//! The ends of planar chains.

use super::{Acceleration, Frame, Internal, Joint, Pin, Planar, Turn};
use crate::element::{Condense, Given, Posture, Sweep};
use crate::ends::{Held, Loose, Root, Tip};
use crate::error::{Error, Fault, Place};
use crate::lift::{Lift, lift};
use crate::relation::plane::algebra::Symmetric2;
use crate::relation::plane::{Empty, Point, Rigid};
use crate::relation::{Absent, Closures, Cut, Cuts, Open};
use crate::scalar::Scalar;
use crate::space::Space;
use nalgebra::Vector2;

/// Motion of a point of the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundMotion<T> {
    /// Place (m).
    pub place: [T; 2],
    /// Velocity (m/s).
    pub velocity: [T; 2],
    /// Acceleration (m/s²).
    pub acceleration: [T; 2],
}

/// A place that may move as a given function of time.
pub trait Ground<T: Scalar> {
    /// Its motion at a time (s).
    fn at(&self, time: T::Real) -> GroundMotion<T>;
}

impl<T: Scalar> Ground<T> for [T; 2] {
    fn at(&self, _: T::Real) -> GroundMotion<T> {
        let zero = [T::zero(); 2];
        GroundMotion { place: *self, velocity: zero, acceleration: zero }
    }
}

/// A place given as a function of time.
#[derive(Clone, Copy, Debug)]
pub struct Moving<F>(pub F);

impl<T: Scalar, F: Fn(T::Real) -> GroundMotion<T>> Ground<T> for Moving<F> {
    fn at(&self, time: T::Real) -> GroundMotion<T> {
        (self.0)(time)
    }
}

/// An end held by a smooth pin at a place of the ground.
///
/// ```
/// use catena::planar::{GroundMotion, Moving, Pinned};
/// let still = Pinned::at(0.0, 1.0);
/// let shaken = Pinned(Moving(|t: f64| GroundMotion {
///     place: [t.sin(), 0.0],
///     velocity: [t.cos(), 0.0],
///     acceleration: [-t.sin(), 0.0],
/// }));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Pinned<G>(pub G);

impl<T: Scalar> Pinned<[T; 2]> {
    /// Held at the origin.
    pub fn origin() -> Self {
        Self([T::zero(); 2])
    }
    /// Held at a place (m).
    pub fn at(x: T, y: T) -> Self {
        Self([x, y])
    }
}

/// An end on which nothing acts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Free;

impl<T: Scalar, G: Ground<T>> Root<Planar<T>> for Pinned<G> {
    type Pairs = (Held, Held, Loose);
    type Joint = Pin;

    fn joint(&self) -> Pin {
        Pin
    }
    fn ground(&self, time: T::Real) -> Frame<T> {
        let GroundMotion { place, velocity, acceleration } = self.0.at(time);
        let still = Frame::resting(Vector2::from(place));
        let acceleration = Acceleration { linear: Vector2::from(acceleration), ..still.acceleration };
        Frame { velocity: Vector2::from(velocity), acceleration, ..still }
    }
    fn check(&self) -> Result<(), Error> {
        let GroundMotion { place, velocity, acceleration } = self.0.at(num_traits::Zero::zero());
        let finite = [place, velocity, acceleration].iter().flatten().all(|x| x.is_finite());
        let fault = Error::new(Fault::NotFinite { parameter: "motion of the ground" }).at(Place::Root);
        if finite { Ok(()) } else { Err(fault) }
    }
}

impl<T: Scalar> Root<Planar<T>> for Free {
    type Pairs = (Loose, Loose, Loose);
    type Joint = Floating;

    fn joint(&self) -> Floating {
        Floating
    }
    fn ground(&self, _: T::Real) -> Frame<T> {
        Frame::resting(Vector2::new(T::zero(), T::zero()))
    }
    fn check(&self) -> Result<(), Error> {
        Ok(())
    }
}

impl<T: Scalar> Tip<Planar<T>> for Free {
    type Pairs = (Loose, Loose, Loose);
    type Closures = Open;
    type Relation = Empty;

    #[inline(always)]
    fn relation(&self, _: T::Real, _: Vector2<T>) -> Empty {
        Empty
    }
    fn internal(&self, (): &()) -> Internal<T> {
        Planar::no_force()
    }
    fn miss(&self, _: T::Real, _: &Frame<T>) -> [(); 2] {
        [(), ()]
    }
    fn check(&self) -> Result<(), Error> {
        Ok(())
    }
}

impl<T: Scalar, G: Ground<T>> Tip<Planar<T>> for Pinned<G> {
    type Pairs = (Held, Held, Loose);
    type Closures = Cut<2>;
    type Relation = Point<T, Absent, Cut<2>>;

    #[inline(always)]
    fn relation(&self, time: T::Real, gravity: Vector2<T>) -> Self::Relation {
        let target = Vector2::from(self.0.at(time).acceleration) - gravity;
        let (zero, one) = (T::zero(), T::one());
        // λ acts ON the last body, so F on the ground beyond the tip is −λ.
        let columns = [Vector2::new(-one, zero), Vector2::new(zero, -one)];
        let cuts = Cuts::at_tip(columns, [-target.x, -target.y]);
        let stiffness = Symmetric2::diagonal(zero);
        Point { stiffness, offset: Vector2::new(zero, zero), torque: Absent, cuts }
    }
    fn internal(&self, multipliers: &[T; 2]) -> Internal<T> {
        Internal { force: Vector2::new(-multipliers[0], -multipliers[1]), torque: T::zero() }
    }
    fn miss(&self, time: T::Real, frame: &Frame<T>) -> [[T; 2]; 2] {
        let GroundMotion { place, velocity, .. } = self.0.at(time);
        let place = frame.place - Vector2::from(place);
        let velocity = frame.velocity - Vector2::from(velocity);
        [[place.x, place.y], [velocity.x, velocity.y]]
    }
    fn check(&self) -> Result<(), Error> {
        Root::<Planar<T>>::check(self).map_err(|error| error.at(Place::Tip))
    }
}

/// The joint of a chain that floats: coordinates x, y and the absolute angle of its first body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Floating;

impl<T: Scalar> Joint<T> for Floating {
    type Position = (T, T, T);
    type Rate = (T, T, T);
    type Kept<C: Closures> = Acceleration<T>;

    const TURNS: bool = true;

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
    for Floating
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
        let (linear, angular) = outer.full().free();
        *kept = Acceleration { linear, angular };
        Empty
    }
}

lift!(Free, Floating);

impl<T: Scalar, U: Scalar> Lift<T, U> for Pinned<[T; 2]> {
    type Over = Pinned<[U; 2]>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Pinned(self.0.lift(number))
    }
}
