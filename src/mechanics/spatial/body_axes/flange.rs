//! The way from axes of bodies back to inertial ones.

use super::relation::Local;
use crate::counts::Counted;
use crate::element::{Condense, Element, Given, Posture, Springs, Sweep};
use crate::error::Fault;
use crate::error::checks::finite;
use crate::lift::lift;
use crate::mechanics::spatial::{Acceleration, Frame, JointMotion, Spatial, Turn};
use crate::relation::Closures;
use crate::relation::spatial::Relation;
use crate::relation::spatial::algebra::{Columns, cross};
use crate::release::Release;
use crate::scalar::Scalar;
use crate::shape::{Joint, JointPosture};
use nalgebra::Vector3;
use typenum::U0;

/// A place on a [`Link`](super::Link) from which on outward relations and accelerations are in inertial axes again, as inboard of
/// [`BodyAxes`](super::BodyAxes): what holds the tip of a robot, closes a loop of robots, or hangs from one follows here.
///
/// ```
/// use catena::robot::*;
/// let link = Link::general(3.0, [0.2, 0.0, 0.0], [[0.02, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.05]]);
/// let (waist, shoulder) = (Hinge::level(), Hinge::level().turned(Quarter::<30>));
/// let elbow = Hinge::at::<1>([0.4, 0.0, 0.0]);
/// let chain = (waist, link, shoulder, link, elbow, link, elbow, link, Flange::at([0.4, 0.0, 0.0]));
/// // Where its flange is, a ball holds it.
/// let open = System::new(Base::origin(), chain, Free)?;
/// let mut start = open.motion();
/// start.set_coordinates(&[0.1, 0.5, -0.9, 0.7])?;
/// let place = open.stations(&start, &Unloaded)?.tip().frame.place;
/// let held = System::new(Base::origin(), chain, Pinned::at(place.into()))?.with_gravity([0.0, 0.0, -9.81]);
/// let mut start = held.motion();
/// start.set_coordinates(&[0.1, 0.5, -0.9, 0.7])?;
/// let end = held.simulate(held.assembled(start, &Unloaded)?, Dop853::tolerance(1e-9), 0.5, |_| ())?.motion;
/// let tip = held.stations(&end, &Unloaded)?.tip().frame.place;
/// assert!((tip - place).norm() < 1e-12);
/// # Ok::<(), catena::Error>(())
/// ```
///
/// It counts among joints as a weld does, but has no coordinate, so [`Torques`](super::Torques) have no number for it. Functions of lists know no flange.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "T: serde::Serialize", deserialize = "T: Scalar + serde::Deserialize<'de>"))
)]
pub struct Flange<T> {
    place: [T; 3],
    /// In a scene, the point mass that its outboard neighbour lumps there.
    #[cfg_attr(feature = "serde", serde(skip, default = "num_traits::zero"))]
    lumped: T,
}

impl<T: Scalar> Flange<T> {
    /// At a place of the link (m), in its axes.
    pub fn at(place: [T; 3]) -> Self {
        Self { place, lumped: T::zero() }
    }

    /// Where on the link it is (m), in axes of that.
    pub fn place(&self) -> [T; 3] {
        self.place
    }

    /// The point mass that its outboard neighbour lumps there.
    pub(super) fn lumped(&self) -> T {
        self.lumped
    }

    /// From the link's origin, in inertial axes.
    #[inline(always)]
    fn arm(&self, attitude: &Columns<T>) -> Vector3<T> {
        attitude.apply(Vector3::from(self.place))
    }
}

crate::shape::leaf!(flange [T: Scalar] Flange<T>: Spatial<T>);

impl<T: Scalar> Joint<Spatial<T>> for Flange<T> {
    type Position = ();
    type Rate = ();
    type Kept<C: Closures> = ();
    type Per<X: Copy> = X;

    const LINEAR: bool = true;

    #[inline(always)]
    fn set_attitude(&self, x: &mut Columns<T>, turn: &Turn<T>) {
        *x = turn.attitude;
    }
    fn still() -> ((), ()) {
        ((), ())
    }
    fn kept<C: Closures>() {}
    fn per<X: Copy>(fill: X) -> X {
        fill
    }
    fn is_finite<C: Closures>((): &()) -> bool {
        true
    }
    fn configure(&self, (): &mut (), inboard: Turn<T>, _: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
        inboard
    }
    #[cfg_attr(optimised, inline(always))]
    fn recover<C: Closures, By: Springs<T>>(
        &self,
        inboard: Acceleration<T>,
        (x, y, ..): JointPosture<'_, Spatial<T>, Self>,
        (): &mut (),
        _: &C::Each<T>,
        (): &mut (),
    ) -> Acceleration<T> {
        turned(inboard, x).shifted(y[0], y[1])
    }
    #[cfg_attr(optimised, inline(always))]
    fn respond<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        (x, y, ..): JointPosture<'_, Spatial<T>, Self>,
        (): &(),
        _: &C::Each<T>,
        (): &mut (),
    ) -> Acceleration<T> {
        turned(inboard, x).swung(y[0])
    }
    fn motion(&self, inboard: Frame<T>, (): &(), (): &(), (): &()) -> (JointMotion<T>, Frame<T>) {
        let outboard = inboard.shifted(self.arm(&inboard.turn.attitude));
        let (none, energy) = ([T::zero(); 3], T::zero());
        (JointMotion { inboard, outboard, position: none, rate: none, effort: none, energy, inertia: none }, outboard)
    }
    fn release(&self, motion: &JointMotion<T>, (): &(), (): &()) -> Release<Spatial<T>> {
        let turn = motion.inboard.turn;
        let arm = self.arm(&turn.attitude);
        Release { linear: cross(turn.spin, cross(turn.spin, arm)), ..Release::nothing() }
    }
    fn check(&self) -> Result<(), Fault> {
        finite("place of a flange", &self.place)
    }
}

/// An acceleration in inertial axes, from those of a body of an attitude.
#[inline(always)]
fn turned<T: Scalar>(Acceleration { linear, angular }: Acceleration<T>, attitude: &Columns<T>) -> Acceleration<T> {
    Acceleration { linear: attitude.apply(linear), angular: attitude.apply(angular) }
}

impl<T: Scalar> Element<Spatial<T>> for Flange<T> {
    type Position = ();
    type Rate = ();

    const ABSOLUTE: bool = false;

    fn lump(&mut self, mass: T) -> T {
        self.lumped = mass;
        T::zero()
    }
    #[cfg_attr(optimised, inline(always))]
    fn orient(
        &self,
        (): &(),
        (): &(),
        turn: Turn<T>,
        x: &mut Columns<T>,
        y: &mut [Vector3<T>; 2],
        _: &mut Vector3<T>,
        _: &mut Vector3<T>,
    ) -> Turn<T> {
        let (attitude, spin, arm) = (*x, x.apply(turn.spin), self.arm(x));
        *y = [arm, cross(spin, cross(spin, arm))];
        Turn { attitude, spin }
    }
    #[inline(always)]
    fn resolve((): &(), _: &mut Columns<T>, _: &mut [Vector3<T>; 2], _: &mut Vector3<T>, _: &mut Vector3<T>) {}
}

impl<T> Counted for Flange<T> {
    type Bodies = U0;
    type Freedoms = U0;
}

impl<T: Scalar, R: Relation<Spatial<T>>, W: Sweep<Spatial<T>>> Condense<Spatial<T>, R, W> for Flange<T> {
    type Out = Local<T, R::Closures>;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: R,
        Posture { x, y, .. }: Posture<'_, Spatial<T>, Self>,
        _: Given<'_, Spatial<T>, Self, W>,
        (): &mut (),
    ) -> Local<T, R::Closures> {
        Local::of(&outer.with_mass(self.lumped).carried(y[0], y[1]), x)
    }
}

lift!(Flange { place, lumped });
