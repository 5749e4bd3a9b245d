//! Ends held fast.

use super::{Compliance, Ground, GroundMotion};
use crate::ends::{Held, Root, Tip};
use crate::error::{Error, Fault, Place};
use crate::lift::lift;
use crate::mechanics::spatial::away::{sine_of_turn, turned_away};
use crate::mechanics::spatial::{BodyMotion, Frame, Internal, Rotation, Spatial, Turn, Weld};
use crate::relation::spatial::algebra::zero;
use crate::relation::spatial::{Full, FullColumn};
use crate::relation::{Cut, Cuts};
use crate::scalar::Scalar;
use nalgebra::Vector3;
use num_traits::Zero;

/// Attitude, angular velocity and angular acceleration of the ground where it clamps an end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AttitudeMotion<T> {
    /// Attitude.
    pub attitude: Rotation<T>,
    /// Angular velocity (rad/s), inertial axes.
    pub spin: [T; 3],
    /// Angular acceleration (rad/s²), inertial axes.
    pub acceleration: [T; 3],
}

impl<T: Scalar> Ground<T, AttitudeMotion<T>> for Rotation<T> {
    const RESTS: bool = true;

    fn at(&self, _: T::Real) -> AttitudeMotion<T> {
        let zero = [T::zero(); 3];
        AttitudeMotion { attitude: *self, spin: zero, acceleration: zero }
    }
}

/// An end held fast: at a place of the ground, its body at an attitude; both may move as given functions of time.
///
/// ```
/// use catena::spatial::*;
/// let rod = Rod::uniform(0.5, 0.05, 1.0);
/// let blade = System::new(Clamped::origin(), (rod, Revolute::about([0.0, 0.0, 1.0]), rod), Free)?;
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Clamped<G, A> {
    /// Place of the end (m).
    pub place: G,
    /// Attitude of the end.
    pub attitude: A,
}

impl<T: Scalar> Clamped<[T; 3], Rotation<T>> {
    /// Held at the origin, unturned.
    pub fn origin() -> Self {
        Self::at([T::zero(); 3], Rotation::identity())
    }
    /// Held at a place (m) and an attitude.
    pub fn at(place: [T; 3], attitude: Rotation<T>) -> Self {
        Self { place, attitude }
    }
}

impl<G, A> Clamped<G, A> {
    /// Held at a place and an attitude of a ground that may move.
    pub fn on(place: G, attitude: A) -> Self {
        Self { place, attitude }
    }

    /// The motion of the ground where it holds the end.
    pub(super) fn frame<T: Scalar>(&self, time: T::Real) -> Frame<T>
    where
        G: Ground<T, GroundMotion<T>>,
        A: Ground<T, AttitudeMotion<T>>,
    {
        let AttitudeMotion { attitude, spin, acceleration } = self.attitude.at(time);
        let mut frame = self.place.at(time).frame::<Spatial<T>>();
        frame.turn = Turn { attitude: attitude.matrix(), spin: Vector3::from(spin) };
        frame.acceleration.angular = Vector3::from(acceleration);
        frame
    }

    pub(super) fn verify<T: Scalar>(&self) -> Result<(), Error>
    where
        G: Ground<T, GroundMotion<T>>,
        A: Ground<T, AttitudeMotion<T>>,
    {
        self.place.at(T::Real::zero()).check()?;
        let AttitudeMotion { attitude, spin, acceleration } = self.attitude.at(T::Real::zero());
        let mut numbers = attitude.quaternion().into_iter().chain(spin).chain(acceleration);
        let fault = Error::new(Fault::NotFinite { parameter: "attitude of the ground" });
        if numbers.all(Scalar::is_finite) { attitude.check().map_err(Error::new) } else { Err(fault) }
    }
}

impl<T: Scalar, G: Ground<T, GroundMotion<T>>, A: Ground<T, AttitudeMotion<T>>> Root<Spatial<T>> for Clamped<G, A> {
    type Pairs = (Held, Held, Held, Held, Held, Held);
    type Joint = Weld<T>;

    const RESTS: bool = G::RESTS && A::RESTS;

    fn joint(&self) -> Weld<T> {
        Weld::at(Rotation::identity())
    }
    fn ground(&self, time: T::Real) -> Frame<T> {
        self.frame(time)
    }
    fn check(&self) -> Result<(), Error> {
        self.verify::<T>().map_err(|error| error.at(Place::Root))
    }
}

impl<T: Scalar, G: Ground<T, GroundMotion<T>>, A: Ground<T, AttitudeMotion<T>>> Tip<Spatial<T>> for Clamped<G, A> {
    type Pairs = (Held, Held, Held, Held, Held, Held);
    type Closures = Cut<6>;
    type Relation = Full<T, Cut<6>>;

    #[cfg_attr(optimised, inline(always))]
    fn relation(&self, time: T::Real, gravity: Vector3<T>, _: &Turn<T>) -> Self::Relation {
        let frame = self.frame(time);
        let (target, angular) = (frame.acceleration.linear - gravity, frame.acceleration.angular);
        let unit = |k: usize| Vector3::from_fn(|i, _| if i == k { -T::one() } else { T::zero() });
        // λ acts ON the last body, so F on the ground beyond the tip is −λ.
        let column = |k: usize| {
            if k < 3 {
                FullColumn { force: unit(k), torque: zero() }
            } else {
                FullColumn { force: zero(), torque: unit(k - 3) }
            }
        };
        let gap = [-target.x, -target.y, -target.z, -angular.x, -angular.y, -angular.z];
        Full::massless().cut(Cuts::at_tip(core::array::from_fn(column), gap))
    }
    fn internal(&self, _: T::Real, multipliers: &[T; 6]) -> Internal<T> {
        let [a, b, c, d, e, f] = *multipliers;
        Internal { force: -Vector3::new(a, b, c), torque: Vector3::new(d, e, f) }
    }
    fn residual(&self, time: T::Real, tip: &Frame<T>) -> [[T; 6]; 2] {
        let frame = self.frame(time);
        let (place, velocity) = (tip.place - frame.place, tip.velocity - frame.velocity);
        let (own, held) = (tip.turn.attitude, frame.turn.attitude);
        let (turn, spin) = (turned_away(&held, &own), tip.turn.spin - frame.turn.spin);
        [
            [place.x, place.y, place.z, turn.x, turn.y, turn.z],
            [velocity.x, velocity.y, velocity.z, spin.x, spin.y, spin.z],
        ]
    }
    fn linear_residual(&self, time: T::Real, tip: &Frame<T>) -> [T; 6] {
        let frame = self.frame(time);
        let (place, turn) = (tip.place - frame.place, sine_of_turn(&frame.turn.attitude, &tip.turn.attitude));
        [place.x, place.y, place.z, turn.x, turn.y, turn.z]
    }
    fn free_compliance(&self, _: T::Real, body: &BodyMotion<T>) -> [T; 6] {
        let compliance = Compliance::of(body);
        let ([x, y, z], turn) = (compliance.along_axes(), compliance.torque);
        [x, y, z, turn, turn, turn]
    }
    fn names(&self) -> [&'static str; 6] {
        let turns = ["turn of the tip about x", "turn of the tip about y", "turn of the tip about z"];
        ["x of the tip", "y of the tip", "z of the tip", turns[0], turns[1], turns[2]]
    }
    fn check(&self) -> Result<(), Error> {
        self.verify::<T>().map_err(|error| error.at(Place::Tip))
    }
}

lift!(Clamped<G, A> { place, attitude });
