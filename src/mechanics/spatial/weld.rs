//! The rigid joint.

use super::axial::orthonormal;
use super::release::{self, Release};
use super::{Acceleration, Frame, Joint, JointMotion, Rotation, Spatial, Turn, stored::One, stored::Stored};
use crate::element::{Condense, Given, Posture, Sweep};
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::spatial::algebra::{Columns, is_finite, zero};
use crate::relation::{Closures, Relation};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// Two bodies joined rigidly at an attitude. It also turns the axes that a joint beyond it refers to.
///
/// ```
/// use catena::spatial::*;
/// let rod = Rod::uniform(1.0, 0.1, 1.0);
/// let bent = Weld::at(Rotation::from_angles([0.0, 0.0, 0.5]));
/// let bracket = System::new(Pinned::origin(), (rod, bent, rod), Free)?;
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "Columns<T>: serde::Serialize", deserialize = "Columns<T>: serde::Deserialize<'de>"))
)]
pub struct Weld<T> {
    attitude: Columns<T>,
}

impl<T: Scalar> Weld<T> {
    /// The outboard body's attitude relative to the inboard one.
    pub fn at(attitude: Rotation<T>) -> Self {
        Self { attitude: attitude.matrix() }
    }

    /// Attitude of the outboard body relative to the inboard one: axes of the former in those of the latter.
    pub fn attitude(&self) -> &Columns<T> {
        &self.attitude
    }
}

impl<T: Scalar> Joint<T> for Weld<T> {
    type Position = ();
    type Rate = ();
    type Kept<C: Closures> = ();
    type Sets = One;

    fn still() -> ((), ()) {
        ((), ())
    }
    fn kept<C: Closures>() {}
    fn is_finite<C: Closures>((): &()) -> bool {
        true
    }
    fn configure(&self, (): &mut (), inboard: Turn<T>, _: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
        self.oriented(&(), &(), inboard).0
    }
    #[inline(always)]
    fn oriented(&self, (): &(), (): &(), inboard: Turn<T>) -> (Turn<T>, Stored<T>) {
        let attitude = inboard.attitude.times(&self.attitude);
        (Turn { attitude, ..inboard }, (attitude, [zero(); 2]))
    }
    #[inline(always)]
    fn release(&self, motion: &JointMotion<T>, position: &Self::Position, rate: &Self::Rate) -> Release<T> {
        release::weld(self, motion, position, rate)
    }
    #[cfg_attr(optimised, inline(always))]
    fn moved(&self, inboard: Frame<T>, (): &(), (): &(), (): &()) -> JointMotion<T> {
        let outboard = Frame { turn: self.oriented(&(), &(), inboard.turn).0, ..inboard };
        let none = [T::zero(); 3];
        JointMotion { inboard, outboard, position: none, rate: none, effort: none, energy: T::zero(), inertia: none }
    }
    fn check(&self) -> Result<(), Fault> {
        let Columns { x, y, z } = self.attitude;
        if !(is_finite(x) && is_finite(y) && is_finite(z)) {
            return Err(Fault::NotFinite { parameter: "attitude" });
        }
        let fault = Fault::NotZero { parameter: "what the axes of a weld miss to be orthonormal and right-handed" };
        if orthonormal(&self.attitude) { Ok(()) } else { Err(fault) }
    }
    #[cfg_attr(optimised, inline(always))]
    fn recovered<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        _: (&Columns<T>, &[Vector3<T>; 2]),
        (): &(),
        _: &C::Each<T>,
        (): &mut (),
    ) -> Acceleration<T> {
        inboard
    }
    #[cfg_attr(optimised, inline(always))]
    fn responded<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        _: (&Columns<T>, &[Vector3<T>; 2]),
        (): &(),
        _: &C::Each<T>,
        (): &mut (),
    ) -> Acceleration<T> {
        inboard
    }
}

/// What a weld hands on as it is: a relation in inertial axes, which bodies turned against each other do not change.
pub trait InertialAxes<T: Scalar>: Copy {}

impl<T: Scalar, R: Relation<Spatial<T>>> InertialAxes<T> for R {}

impl<T: Scalar, R: InertialAxes<T>, W: Sweep<Spatial<T>>> Condense<Spatial<T>, R, W> for Weld<T> {
    type Out = R;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: R,
        _: Posture<'_, Spatial<T>, Self>,
        _: Given<'_, Spatial<T>, Self, W>,
        (): &mut (),
    ) -> R {
        outer
    }
}

lift!(Weld { attitude });
