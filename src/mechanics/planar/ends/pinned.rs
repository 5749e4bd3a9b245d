//! Ends held by pins.

use super::{Compliance, Ground, GroundMotion};
use crate::ends::{Held, Loose, Root, Tip};
use crate::error::{Error, Place};
use crate::lift::lift;
use crate::mechanics::planar::{BodyMotion, Frame, Internal, Pin, Planar, Turn};
use crate::relation::planar::Point;
use crate::relation::planar::algebra::Symmetric2;
use crate::relation::{Absent, Cut, Cuts, Symmetric};
use crate::scalar::Scalar;
use nalgebra::Vector2;
use num_traits::Zero;

/// An end held by a smooth pin at a place of the ground.
///
/// ```
/// use catena::planar::{GroundMotion, Moving, Pinned};
/// let still = Pinned::at(0.0, 1.0);
/// let shaken = Pinned::on(Moving(|t: f64| GroundMotion {
///     place: [t.sin(), 0.0],
///     velocity: [t.cos(), 0.0],
///     acceleration: [-t.sin(), 0.0],
/// }));
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Pinned<G> {
    /// Where.
    pub place: G,
}

impl<T: Scalar> Pinned<[T; 2]> {
    /// Held at the origin.
    pub fn origin() -> Self {
        Self::on([T::zero(); 2])
    }
    /// Held at a place (m).
    pub fn at(x: T, y: T) -> Self {
        Self::on([x, y])
    }
}

impl<G> Pinned<G> {
    /// Held at a place of a ground that may move.
    pub fn on(place: G) -> Self {
        Self { place }
    }
}

impl<T: Scalar, G: Ground<T, GroundMotion<T>>> Root<Planar<T>> for Pinned<G> {
    type Pairs = (Held, Held, Loose);
    type Joint = Pin;

    const RESTS: bool = G::RESTS;

    fn joint(&self) -> Pin {
        Pin
    }
    fn ground(&self, time: T::Real) -> Frame<T> {
        self.place.at(time).frame::<Planar<T>>()
    }
    fn check(&self) -> Result<(), Error> {
        self.place.at(T::Real::zero()).check().map_err(|error| error.at(Place::Root))
    }
}

impl<T: Scalar, G: Ground<T, GroundMotion<T>>> Tip<Planar<T>> for Pinned<G> {
    type Pairs = (Held, Held, Loose);
    type Closures = Cut<2>;
    type Relation = Point<T, Absent, Cut<2>>;

    #[cfg_attr(optimised, inline(always))]
    fn relation(&self, time: T::Real, gravity: Vector2<T>, _: &Turn<T>) -> Self::Relation {
        let target = Vector2::from(self.place.at(time).acceleration) - gravity;
        let (zero, one) = (T::zero(), T::one());
        // λ acts ON the last body, so F on the ground beyond the tip is −λ.
        let columns = [Vector2::new(-one, zero), Vector2::new(zero, -one)];
        let cuts = Cuts::at_tip(columns, [-target.x, -target.y]);
        let mass = Symmetric2::diagonal(zero);
        Point { mass, offset: Vector2::new(zero, zero), torque: Absent, cuts }
    }
    fn internal(&self, _: T::Real, multipliers: &[T; 2]) -> Internal<T> {
        Internal { force: Vector2::new(-multipliers[0], -multipliers[1]), torque: T::zero() }
    }
    fn residual(&self, time: T::Real, frame: &Frame<T>) -> [[T; 2]; 2] {
        let GroundMotion { place, velocity, .. } = self.place.at(time);
        let place = frame.place - Vector2::from(place);
        let velocity = frame.velocity - Vector2::from(velocity);
        [[place.x, place.y], [velocity.x, velocity.y]]
    }
    fn free_compliance(&self, _: T::Real, body: &BodyMotion<T>) -> [T; 2] {
        let compliance = Compliance::of(body);
        let (zero, one) = (T::zero(), T::one());
        [compliance.along(Vector2::new(one, zero)), compliance.along(Vector2::new(zero, one))]
    }
    fn names(&self) -> [&'static str; 2] {
        ["x of the tip", "y of the tip"]
    }
    fn check(&self) -> Result<(), Error> {
        self.place.at(T::Real::zero()).check().map_err(|error| error.at(Place::Tip))
    }
}

lift!(Pinned<G> { place });
