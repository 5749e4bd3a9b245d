//! Ends held by balls.

use super::{Compliance, Ground, GroundMotion};
use crate::ends::{Held, Loose, Root, Tip};
use crate::error::{Error, Place};
use crate::lift::lift;
use crate::mechanics::spatial::{Ball, BodyMotion, Frame, Internal, Spatial, Turn};
use crate::relation::spatial::Point;
use crate::relation::spatial::algebra::{Symmetric3, zero};
use crate::relation::{Absent, Cut, Cuts, Symmetric};
use crate::scalar::Scalar;
use nalgebra::Vector3;
use num_traits::Zero;

/// An end held by a smooth ball joint at a place of the ground.
///
/// ```
/// use catena::spatial::{GroundMotion, Moving, Pinned};
/// let still = Pinned::at([0.0, 1.0, 0.0]);
/// let shaken = Pinned::on(Moving(|t: f64| GroundMotion {
///     place: [t.sin(), 0.0, 0.0],
///     velocity: [t.cos(), 0.0, 0.0],
///     acceleration: [-t.sin(), 0.0, 0.0],
/// }));
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Pinned<G> {
    /// Where.
    pub place: G,
}

impl<T: Scalar> Pinned<[T; 3]> {
    /// Held at the origin.
    pub fn origin() -> Self {
        Self::on([T::zero(); 3])
    }
    /// Held at a place (m).
    pub fn at(place: [T; 3]) -> Self {
        Self::on(place)
    }
}

impl<G> Pinned<G> {
    /// Held at a place of a ground that may move.
    pub fn on(place: G) -> Self {
        Self { place }
    }
}

impl<T: Scalar, G: Ground<T, GroundMotion<T>>> Root<Spatial<T>> for Pinned<G> {
    type Pairs = (Held, Held, Held, Loose, Loose, Loose);
    type Joint = Ball;

    const RESTS: bool = G::RESTS;

    fn joint(&self) -> Ball {
        Ball
    }
    fn ground(&self, time: T::Real) -> Frame<T> {
        self.place.at(time).frame::<Spatial<T>>()
    }
    fn check(&self) -> Result<(), Error> {
        self.place.at(T::Real::zero()).check().map_err(|error| error.at(Place::Root))
    }
}

impl<T: Scalar, G: Ground<T, GroundMotion<T>>> Tip<Spatial<T>> for Pinned<G> {
    type Pairs = (Held, Held, Held, Loose, Loose, Loose);
    type Closures = Cut<3>;
    type Relation = Point<T, Absent, Cut<3>>;

    #[cfg_attr(optimised, inline(always))]
    fn relation(&self, time: T::Real, gravity: Vector3<T>, _: &Turn<T>) -> Self::Relation {
        let target = Vector3::from(self.place.at(time).acceleration) - gravity;
        let (o, i) = (T::zero(), T::one());
        // λ acts ON the last body, so F on the ground beyond the tip is −λ.
        let columns = [Vector3::new(-i, o, o), Vector3::new(o, -i, o), Vector3::new(o, o, -i)];
        let cuts = Cuts::at_tip(columns, [-target.x, -target.y, -target.z]);
        Point { mass: Symmetric3::diagonal(o), offset: zero(), torque: Absent, cuts }
    }
    fn internal(&self, _: T::Real, multipliers: &[T; 3]) -> Internal<T> {
        Internal { force: -Vector3::from(*multipliers), torque: zero() }
    }
    fn residual(&self, time: T::Real, frame: &Frame<T>) -> [[T; 3]; 2] {
        let GroundMotion { place, velocity, .. } = self.place.at(time);
        [(frame.place - Vector3::from(place)).into(), (frame.velocity - Vector3::from(velocity)).into()]
    }
    fn free_compliance(&self, _: T::Real, body: &BodyMotion<T>) -> [T; 3] {
        Compliance::of(body).along_axes()
    }
    fn names(&self) -> [&'static str; 3] {
        ["x of the tip", "y of the tip", "z of the tip"]
    }
    fn check(&self) -> Result<(), Error> {
        self.place.at(T::Real::zero()).check().map_err(|error| error.at(Place::Tip))
    }
}

lift!(Pinned<G> { place });
