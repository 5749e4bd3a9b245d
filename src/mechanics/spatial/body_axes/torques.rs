//! Torques in joints, one number each.

use crate::element::Loading;
use crate::error::Fault;
use crate::mechanics::spatial::{BodyMotion, Drive, JointMotion, Spatial};
use crate::relation::Absent;
use crate::relation::spatial::algebra::Columns;
use crate::scalar::Scalar;

/// Torques (N·m) of hinges and forces (N) of slides, ON the outboard body: values handed in for all joints of one coordinate, in their
/// order.
///
/// ```
/// use catena::robot::*;
/// let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
/// let arm = System::new(Clamped::origin(), (BodyAxes, Hinge::level(), link, Hinge::at::<4>([0.0, 0.0, 0.4]), link), Free)?;
/// let moving = arm.with_accelerations(arm.motion(), &Torques([2.0, 0.5]))?;
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Torques<V>(pub V);

impl<T: Scalar> Drive<T> for T {
    type Couple = Absent;
    #[inline(always)]
    fn onto(self, k: usize, sum: T) -> T {
        if k == 0 { sum + self } else { sum }
    }
    #[inline(always)]
    fn couple(self, _: &Columns<T>) -> Absent {
        Absent
    }
}

impl<T: Scalar, V: AsRef<[T]>> Loading<Spatial<T>> for Torques<V> {
    type OnBody = Absent;
    type InJoint = T;
    type Seen = ();
    type Responses<X: Clone> = ();
    const ON: bool = true;
    const READS: bool = false;
    const BY_COORDINATE: bool = true;

    fn unseen(&self) {}
    fn nothing() -> (Absent, T) {
        (Absent, T::zero())
    }
    fn on_body(&self, (): &(), _: T::Real, _: usize, _: &BodyMotion<T>) -> Absent {
        Absent
    }
    fn in_joint(&self, _: T::Real, joint: usize, _: &JointMotion<T>) -> T {
        self.0.as_ref().get(joint).copied().unwrap_or(T::zero())
    }
    fn listed(&self) -> (&[Absent], &[T]) {
        (&[], self.0.as_ref())
    }
    fn check(&self, _: usize, joints: usize) -> Result<(), Fault> {
        let given = self.0.as_ref().len();
        if given == joints { Ok(()) } else { Err(Fault::Count { list: "torques", expected: joints, given }) }
    }
}
