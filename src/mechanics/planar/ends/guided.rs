//! Ends guided along a line.

use super::{Clamped, Compliance, Ground, GroundMotion};
use crate::ends::{Held, Loose, Root, Tip};
use crate::error::{Error, Fault, Place};
use crate::lift::Lift;
use crate::mechanics::planar::{BodyMotion, Frame, Internal, Planar, Slider, Turn};
use crate::relation::planar::algebra::dot;
use crate::relation::planar::{Full, FullColumn};
use crate::relation::{Cut, Cuts};
use crate::scalar::Scalar;
use nalgebra::Vector2;
use num_traits::Zero;

/// An end that slides along a straight line of the ground and does not turn against it. The ground may move as a given function
/// of time, like that of a [`Clamped`] end.
///
/// As a root it is a [`Slider`] on the ground; as a tip, two closure forces hold it: one normal to the line (N), and a
/// torque (N·m), both ON the last body.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0, 1.0);
/// // The tip slides along y = 0 and keeps its angle.
/// let chain = (rod, Pin, rod, Pin, rod);
/// let piston = System::new(Pinned::origin(), chain, Guided::at(2.0, 0.0, 0.0))?.with_gravity(9.81);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Guided<G, A, T> {
    ground: Clamped<G, A>,
    line: T,
}

impl<T: Scalar> Guided<[T; 2], T, T> {
    /// Along the x axis.
    pub fn origin() -> Self {
        Self::on(Clamped::origin(), T::zero())
    }
    /// Along the line through the point (x, y) (m) in the direction `angle` (rad); a body on it keeps this angle.
    pub fn at(x: T, y: T, angle: T) -> Self {
        Self::on(Clamped::at(x, y, angle), T::zero())
    }
}

impl<G, A, T: Scalar> Guided<G, A, T> {
    /// Along a line in the direction `line` (rad) of the axes of a ground that may move and turn; a body on it keeps the angle
    /// of the ground.
    pub fn on(ground: Clamped<G, A>, line: T) -> Self {
        Self { ground, line }
    }

    fn verify(&self) -> Result<(), Error>
    where
        G: Ground<T, GroundMotion<T>>,
        A: Ground<T, [T; 3]>,
    {
        self.ground.verify::<T>()?;
        let fault = Error::new(Fault::NotFinite { parameter: "direction of the line" });
        if self.line.is_finite() { Ok(()) } else { Err(fault) }
    }

    /// The ground, and the direction of the line against it (rad).
    pub(in crate::mechanics::planar) fn parts(&self) -> (Clamped<G, A>, T)
    where
        Clamped<G, A>: Copy,
    {
        (self.ground, self.line)
    }

    /// Normal to the line of a ground that does not move.
    pub(in crate::mechanics::planar) fn across(&self) -> Vector2<T>
    where
        G: Ground<T, GroundMotion<T>>,
        A: Ground<T, [T; 3]>,
    {
        self.normal(&self.ground.frame(T::Real::zero()))
    }

    /// Normal to the line.
    #[inline(always)]
    fn normal(&self, frame: &Frame<T>) -> Vector2<T> {
        let (sine, cosine) = (frame.turn.angle + self.line).sin_cos();
        Vector2::new(-sine, cosine)
    }
}

impl<T: Scalar, G: Ground<T, GroundMotion<T>>, A: Ground<T, [T; 3]>> Root<Planar<T>> for Guided<G, A, T> {
    type Pairs = (Loose, Held, Held); // along the line, across it, the angle
    type Joint = Slider<T>;

    const RESTS: bool = G::RESTS && A::RESTS;

    fn joint(&self) -> Slider<T> {
        Slider::along(self.line)
    }
    fn ground(&self, time: T::Real) -> Frame<T> {
        self.ground.frame(time)
    }
    fn check(&self) -> Result<(), Error> {
        self.verify().map_err(|error| error.at(Place::Root))
    }
}

/// The line of a tip may move but not turn: how a tip on a turning line has to accelerate depends on where on it it is.
impl<T: Scalar, G: Ground<T, GroundMotion<T>>> Tip<Planar<T>> for Guided<G, T, T> {
    type Pairs = (Loose, Held, Held);
    type Closures = Cut<2>;
    type Relation = Full<T, Cut<2>>;

    #[cfg_attr(optimised, inline(always))]
    fn relation(&self, time: T::Real, gravity: Vector2<T>, _: &Turn<T>) -> Self::Relation {
        let frame = self.ground.frame(time);
        let normal = self.normal(&frame);
        let (zero, one) = (T::zero(), T::one());
        // λ acts ON the last body, so F on the ground beyond the tip is −λ.
        let columns =
            [FullColumn { force: -normal, torque: zero }, FullColumn { force: Vector2::new(zero, zero), torque: -one }];
        let gap = [-dot(normal, frame.acceleration.linear - gravity), zero];
        Full::massless().cut(Cuts::at_tip(columns, gap))
    }
    fn internal(&self, time: T::Real, multipliers: &[T; 2]) -> Internal<T> {
        let [force, torque] = *multipliers;
        Internal { force: self.normal(&self.ground.frame(time)) * -force, torque }
    }
    fn residual(&self, time: T::Real, tip: &Frame<T>) -> [[T; 2]; 2] {
        let frame = self.ground.frame(time);
        let normal = self.normal(&frame);
        let (place, velocity) = (tip.place - frame.place, tip.velocity - frame.velocity);
        [
            [dot(normal, place), tip.turn.angle - frame.turn.angle],
            [dot(normal, velocity), tip.turn.rate - frame.turn.rate],
        ]
    }
    fn free_compliance(&self, time: T::Real, body: &BodyMotion<T>) -> [T; 2] {
        let compliance = Compliance::of(body);
        [compliance.along(self.normal(&self.ground.frame(time))), compliance.torque]
    }
    fn names(&self) -> [&'static str; 2] {
        ["place of the tip across its line", "angle of the tip"]
    }
    fn check(&self) -> Result<(), Error> {
        self.verify().map_err(|error| error.at(Place::Tip))
    }
}

impl<T: Scalar, U: Scalar> Lift<T, U> for Guided<[T; 2], T, T> {
    type Over = Guided<[U; 2], U, U>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Guided { ground: self.ground.lift(number), line: number(self.line) }
    }
}
