//! Ends held fast.

use super::{Compliance, Ground, GroundMotion};
use crate::ends::{Held, Root, Tip};
use crate::error::{Error, Fault, Place};
use crate::lift::lift;
use crate::mechanics::planar::{BodyMotion, Frame, Internal, Planar, Turn, Weld};
use crate::relation::planar::{Full, FullColumn};
use crate::relation::{Cut, Cuts};
use crate::scalar::Scalar;
use nalgebra::Vector2;
use num_traits::Zero;

impl<T: Scalar> Ground<T, [T; 3]> for T {
    const RESTS: bool = true;

    fn at(&self, _: T::Real) -> [T; 3] {
        [*self, T::zero(), T::zero()]
    }
}

/// An end held fast: at a place of the ground, its body at an absolute angle; both may move as given functions of time.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(0.5, 1.0);
/// let blade = System::new(Clamped::at(0.0, 0.0, 0.2), (rod, ElasticHinge::rotary(20.0), rod), Free)?;
/// let shaken = Clamped::on([0.0, 0.0], Turning(|t: f64| [t.sin(), t.cos(), -t.sin()]));
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Clamped<G, A> {
    /// Place of the end (m).
    pub place: G,
    /// Angle of the end (rad).
    pub attitude: A,
}

impl<T: Scalar> Clamped<[T; 2], T> {
    /// Held at the origin, unturned.
    pub fn origin() -> Self {
        Self::at(T::zero(), T::zero(), T::zero())
    }
    /// Held at a place (m) and an angle (rad).
    pub fn at(x: T, y: T, angle: T) -> Self {
        Self { place: [x, y], attitude: angle }
    }
}

impl<G, A> Clamped<G, A> {
    /// Held at a place and an angle of a ground that may move.
    pub fn on(place: G, attitude: A) -> Self {
        Self { place, attitude }
    }

    /// The motion of the ground where it holds the end.
    pub(in crate::mechanics::planar) fn frame<T: Scalar>(&self, time: T::Real) -> Frame<T>
    where
        G: Ground<T, GroundMotion<T>>,
        A: Ground<T, [T; 3]>,
    {
        let [angle, rate, angular] = self.attitude.at(time);
        let mut frame = self.place.at(time).frame::<Planar<T>>();
        frame.turn = Turn { angle, rate };
        frame.acceleration.angular = angular;
        frame
    }

    pub(super) fn verify<T: Scalar>(&self) -> Result<(), Error>
    where
        G: Ground<T, GroundMotion<T>>,
        A: Ground<T, [T; 3]>,
    {
        self.place.at(T::Real::zero()).check()?;
        let finite = self.attitude.at(T::Real::zero()).iter().all(|x| x.is_finite());
        let fault = Error::new(Fault::NotFinite { parameter: "angle of the ground" });
        if finite { Ok(()) } else { Err(fault) }
    }
}

impl<T: Scalar, G: Ground<T, GroundMotion<T>>, A: Ground<T, [T; 3]>> Root<Planar<T>> for Clamped<G, A> {
    type Pairs = (Held, Held, Held);
    type Joint = Weld<T>;

    const RESTS: bool = G::RESTS && A::RESTS;

    fn joint(&self) -> Weld<T> {
        Weld::at(T::zero())
    }
    fn ground(&self, time: T::Real) -> Frame<T> {
        self.frame(time)
    }
    fn check(&self) -> Result<(), Error> {
        self.verify::<T>().map_err(|error| error.at(Place::Root))
    }
}

impl<T: Scalar, G: Ground<T, GroundMotion<T>>, A: Ground<T, [T; 3]>> Tip<Planar<T>> for Clamped<G, A> {
    type Pairs = (Held, Held, Held);
    type Closures = Cut<3>;
    type Relation = Full<T, Cut<3>>;

    #[cfg_attr(optimised, inline(always))]
    fn relation(&self, time: T::Real, gravity: Vector2<T>, _: &Turn<T>) -> Self::Relation {
        let frame = self.frame(time);
        let target = frame.acceleration.linear - gravity;
        let (zero, one) = (T::zero(), T::one());
        // λ acts ON the last body, so F on the ground beyond the tip is −λ.
        let columns = [
            FullColumn { force: Vector2::new(-one, zero), torque: zero },
            FullColumn { force: Vector2::new(zero, -one), torque: zero },
            FullColumn { force: Vector2::new(zero, zero), torque: -one },
        ];
        let gap = [-target.x, -target.y, -frame.acceleration.angular];
        Full::massless().cut(Cuts::at_tip(columns, gap))
    }
    fn internal(&self, _: T::Real, multipliers: &[T; 3]) -> Internal<T> {
        let [x, y, torque] = *multipliers;
        Internal { force: Vector2::new(-x, -y), torque }
    }
    fn residual(&self, time: T::Real, tip: &Frame<T>) -> [[T; 3]; 2] {
        let frame = self.frame(time);
        let (place, velocity) = (tip.place - frame.place, tip.velocity - frame.velocity);
        let (angle, rate) = (tip.turn.angle - frame.turn.angle, tip.turn.rate - frame.turn.rate);
        [[place.x, place.y, angle], [velocity.x, velocity.y, rate]]
    }
    fn free_compliance(&self, _: T::Real, body: &BodyMotion<T>) -> [T; 3] {
        let compliance = Compliance::of(body);
        let (zero, one) = (T::zero(), T::one());
        let along = |x, y| compliance.along(Vector2::new(x, y));
        [along(one, zero), along(zero, one), compliance.torque]
    }
    fn names(&self) -> [&'static str; 3] {
        ["x of the tip", "y of the tip", "angle of the tip"]
    }
    fn check(&self) -> Result<(), Error> {
        self.verify::<T>().map_err(|error| error.at(Place::Tip))
    }
}

lift!(Clamped<G, A> { place, attitude });
