//! Ends on a hinge.

use super::{AttitudeMotion, Clamped, Compliance, Ground, GroundMotion};
use crate::ends::{Held, Loose, Root, Tip};
use crate::error::{Error, Fault, Place};
use crate::lift::Lift;
use crate::mechanics::spatial::away::{sine_of_tilt, tilted_away};
use crate::mechanics::spatial::axial::{aside, check_axis, orthonormal, unit};
use crate::mechanics::spatial::{BodyMotion, Frame, Internal, Revolute, Rotation, Spatial, Turn};
use crate::relation::spatial::algebra::{Columns, cross, dot, zero};
use crate::relation::spatial::{Full, FullColumn};
use crate::relation::{Cut, Cuts};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// An end held by a smooth revolute joint, at a place of the ground and about an axis of it. The ground may move and turn as given
/// functions of time, like that of a [`Clamped`] end.
///
/// Where the joint is not turned, the axes of the body on it are those of the ground; a [`Weld`](crate::spatial::Weld) beside it turns
/// them. As a root it is a [`Revolute`] on the ground; with a spring, start the chain with one on a [`Clamped`] root instead. As a tip,
/// five closure forces hold it: a force (N, inertial axes) and torques (N·m) about two directions across the axis, all ON the last body.
///
/// ```
/// use catena::loading::Unloaded;
/// use catena::spatial::*;
/// let rod = |length| Rod::uniform(length, 0.02, 1.0);
/// // A crank about z and a rocker about y, with a coupler between a ball and a universal joint.
/// let coupler = Universal::about([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
/// let chain = (rod(0.3), Ball, rod(1.0), coupler, rod(0.8));
/// let (crank, rocker) = (Hinged::at([0.0; 3], [0.0, 0.0, 1.0]), Hinged::at([0.9, 0.1, -0.2], [0.0, 1.0, 0.0]));
/// let linkage = System::new(crank, chain, rocker)?;
/// let guess = linkage.at_rest(&[1.2, 0.0, -0.64, -0.22, 2.2, 0.1])?;
/// let start = linkage.assembled(guess, &Unloaded)?;
/// let tip = linkage.stations(&start, &Unloaded)?.tip().frame;
/// assert!((tip.place.x - 0.9_f64).abs() < 1e-14 && (tip.turn.attitude.y.y - 1.0).abs() < 1e-14);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "Clamped<G, A>: serde::Serialize, Vector3<T>: serde::Serialize",
        deserialize = "Clamped<G, A>: serde::Deserialize<'de>, Vector3<T>: serde::Deserialize<'de>"
    ))
)]
pub struct Hinged<G, A, T> {
    ground: Clamped<G, A>,
    axis: Vector3<T>,
    /// Two directions at right angles to the axis and to each other, in axes of the ground.
    across: [Vector3<T>; 2],
}

impl<T: Scalar> Hinged<[T; 3], Rotation<T>, T> {
    /// Place of a ground that does not move (m).
    pub(in crate::mechanics::spatial) fn place(&self) -> [T; 3] {
        self.ground.place
    }
    /// Directions across the axis and the axis, inertial axes, of a ground that does not turn.
    pub(in crate::mechanics::spatial) fn directions(&self) -> [Vector3<T>; 3] {
        let ([first, second], ground) = (self.across, self.ground.attitude.matrix());
        [first, second, self.axis].map(|direction| ground.apply(direction))
    }
    /// Held at the origin, about an axis of any length.
    pub fn origin(axis: [T; 3]) -> Self {
        Self::at([T::zero(); 3], axis)
    }
    /// Held at a place (m), about an axis of any length.
    pub fn at(place: [T; 3], axis: [T; 3]) -> Self {
        Self::on(Clamped::at(place, Rotation::identity()), axis)
    }
}

impl<G, A, T: Scalar> Hinged<G, A, T> {
    /// Held where a ground that may move and turn would clamp it, but free to turn about an axis of that ground.
    pub fn on(ground: Clamped<G, A>, axis: [T; 3]) -> Self {
        let axis = unit(axis);
        let (o, i) = (T::zero(), T::one());
        let [other] = aside(axis, [Vector3::new(i, o, o)], [Vector3::new(o, i, o)]);
        let first = unit(cross(axis, other).into());
        Self { ground, axis, across: [first, cross(axis, first)] }
    }

    fn verify(&self) -> Result<(), Error>
    where
        G: Ground<T, GroundMotion<T>>,
        A: Ground<T, AttitudeMotion<T>>,
    {
        check_axis(self.axis).map_err(Error::new)?;
        let [first, second] = self.across;
        if !orthonormal(&Columns { x: first, y: second, z: self.axis }) {
            let parameter = "what the directions across an axis miss to be orthonormal and right-handed";
            return Err(Error::new(Fault::NotZero { parameter }));
        }
        self.ground.verify::<T>()
    }

    /// The axis, in axes of the ground, and of the body on it.
    pub(in crate::mechanics::spatial) fn axis(&self) -> Vector3<T> {
        self.axis
    }

    /// Directions across the axis, inertial axes.
    #[inline(always)]
    fn normals(&self, ground: &Turn<T>) -> [Vector3<T>; 2] {
        self.across.map(|normal| ground.attitude.apply(normal))
    }
}

impl<T: Scalar, G: Ground<T, GroundMotion<T>>, A: Ground<T, AttitudeMotion<T>>> Root<Spatial<T>> for Hinged<G, A, T> {
    /// Pairs in axes of the joint, its own the last.
    type Pairs = (Held, Held, Held, Held, Held, Loose);
    type Joint = Revolute<T>;

    const RESTS: bool = G::RESTS && A::RESTS;

    fn joint(&self) -> Revolute<T> {
        Revolute::about(self.axis.into())
    }
    fn ground(&self, time: T::Real) -> Frame<T> {
        self.ground.frame(time)
    }
    fn check(&self) -> Result<(), Error> {
        self.verify().map_err(|error| error.at(Place::Root))
    }
}

impl<T: Scalar, G: Ground<T, GroundMotion<T>>, A: Ground<T, AttitudeMotion<T>>> Tip<Spatial<T>> for Hinged<G, A, T> {
    type Pairs = (Held, Held, Held, Held, Held, Loose);
    type Closures = Cut<5>;
    type Relation = Full<T, Cut<5>>;

    #[cfg_attr(optimised, inline(always))]
    fn relation(&self, time: T::Real, gravity: Vector3<T>, turn: &Turn<T>) -> Self::Relation {
        let frame = self.ground.frame(time);
        let target = frame.acceleration.linear - gravity;
        let (o, i) = (T::zero(), T::one());
        let axes = [Vector3::new(i, o, o), Vector3::new(o, i, o), Vector3::new(o, o, i)];
        let [first, second] = self.normals(&frame.turn);
        // λ acts ON the last body, so F on the ground beyond the tip is −λ.
        let push = |axis: Vector3<T>| FullColumn { force: -axis, torque: zero() };
        let twist = |normal: Vector3<T>| FullColumn { force: zero(), torque: -normal };
        let columns = [push(axes[0]), push(axes[1]), push(axes[2]), twist(first), twist(second)];
        // t · (ω − ω_g) = 0 for t that turn with the ground: t · α = t · α_g − (ω_g × t) · (ω − ω_g).
        let relative = turn.spin - frame.turn.spin;
        let tilt = |normal: Vector3<T>| {
            dot(cross(frame.turn.spin, normal), relative) - dot(normal, frame.acceleration.angular)
        };
        let gap = [-target.x, -target.y, -target.z, tilt(first), tilt(second)];
        Full::massless().cut(Cuts::at_tip(columns, gap))
    }
    fn internal(&self, time: T::Real, multipliers: &[T; 5]) -> Internal<T> {
        let [x, y, z, one, two] = *multipliers;
        let [first, second] = self.normals(&self.ground.frame(time).turn);
        Internal { force: -Vector3::new(x, y, z), torque: first * one + second * two }
    }
    fn residual(&self, time: T::Real, tip: &Frame<T>) -> [[T; 5]; 2] {
        let frame = self.ground.frame(time);
        let [first, second] = self.normals(&frame.turn);
        let (place, velocity) = (tip.place - frame.place, tip.velocity - frame.velocity);
        let [held, own] = [&frame, tip].map(|end| end.turn.attitude.apply(self.axis));
        let [one, two] = tilted_away(held, own, [first, second]);
        let spin = tip.turn.spin - frame.turn.spin;
        [
            [place.x, place.y, place.z, one, two],
            [velocity.x, velocity.y, velocity.z, dot(first, spin), dot(second, spin)],
        ]
    }
    fn linear_residual(&self, time: T::Real, tip: &Frame<T>) -> [T; 5] {
        let frame = self.ground.frame(time);
        let [held, own] = [&frame, tip].map(|end| end.turn.attitude.apply(self.axis));
        let [one, two] = sine_of_tilt(held, own, self.normals(&frame.turn));
        let place = tip.place - frame.place;
        [place.x, place.y, place.z, one, two]
    }
    fn free_compliance(&self, _: T::Real, body: &BodyMotion<T>) -> [T; 5] {
        let compliance = Compliance::of(body);
        let ([x, y, z], turn) = (compliance.along_axes(), compliance.torque);
        [x, y, z, turn, turn]
    }
    fn names(&self) -> [&'static str; 5] {
        let tilts = ["turn of the tip across its axis", "second turn of the tip across its axis"];
        ["x of the tip", "y of the tip", "z of the tip", tilts[0], tilts[1]]
    }
    fn check(&self) -> Result<(), Error> {
        self.verify().map_err(|error| error.at(Place::Tip))
    }
}

impl<T: Scalar, U: Scalar> Lift<T, U> for Hinged<[T; 3], Rotation<T>, T> {
    type Over = Hinged<[U; 3], Rotation<U>, U>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        let ground = self.ground.lift(&mut *number);
        Hinged::on(ground, self.axis.map(number).into())
    }
}
