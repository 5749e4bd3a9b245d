//! What spatial loads are made of: values, functions, and laws of the user's own.

use super::{BodyMotion, Drive, Effort, JointMotion, Spatial, Wrench};
use crate::element::Load;
use crate::error::Fault;
use crate::loading::count;
use crate::relation::Absent;
use crate::scalar::Scalar;

/// Loads given as values: an array, a slice, a vector.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Values<V>(pub V);

/// A function as the law of what acts on bodies: with a function pointer or a boxed function inside, a type that has a name.
#[derive(Clone, Copy, Debug)]
pub struct OnBodies<F>(pub(super) F);

/// A function as the law of efforts in joints.
///
/// Named by a function pointer or a boxed function, it is one type for many laws, which one stepper can take in turn.
#[derive(Clone, Copy, Debug)]
pub struct InJoints<F>(pub(super) F);

/// The part of a loading that acts on bodies. Implement it for a type that has a name.
pub trait BodyLaw<T: Scalar> {
    /// `Wrench` or `Absent`.
    type Value: Load<Spatial<T>>;
    /// No load.
    fn nothing() -> Self::Value;
    /// Whether there is one.
    const ON: bool = true;
    /// Whether it depends on time or motion, or is a [`list`](Self::list).
    const READS: bool = true;
    /// The load on a body.
    fn at(&self, time: T::Real, body: usize, motion: &BodyMotion<T>) -> Self::Value;
    /// Loads on bodies where they are a list.
    fn list(&self) -> &[Self::Value] {
        &[]
    }
    /// Refuses a list that is not as long as the scene has bodies.
    ///
    /// # Errors
    /// [`Fault::Count`].
    fn check(&self, bodies: usize) -> Result<(), Fault> {
        let _ = bodies;
        Ok(())
    }
}

impl<T: Scalar> BodyLaw<T> for Absent {
    type Value = Absent;
    fn nothing() -> Absent {
        Absent
    }
    const ON: bool = false;
    const READS: bool = false;
    fn at(&self, _: T::Real, _: usize, _: &BodyMotion<T>) -> Absent {
        Absent
    }
}

impl<T: Scalar, F: Fn(T::Real, usize, &BodyMotion<T>) -> Wrench<T>> BodyLaw<T> for OnBodies<F> {
    type Value = Wrench<T>;
    fn nothing() -> Wrench<T> {
        Wrench::default()
    }
    const ON: bool = true;
    fn at(&self, time: T::Real, body: usize, motion: &BodyMotion<T>) -> Wrench<T> {
        (self.0)(time, body, motion)
    }
}

impl<T: Scalar, V: AsRef<[Wrench<T>]>> BodyLaw<T> for Values<V> {
    type Value = Wrench<T>;
    fn nothing() -> Wrench<T> {
        Wrench::default()
    }
    const ON: bool = true;
    const READS: bool = false;
    #[inline(always)]
    fn at(&self, _: T::Real, body: usize, _: &BodyMotion<T>) -> Wrench<T> {
        self.0.as_ref().get(body).copied().unwrap_or_default()
    }
    #[inline(always)]
    fn list(&self) -> &[Wrench<T>] {
        self.0.as_ref()
    }
    fn check(&self, bodies: usize) -> Result<(), Fault> {
        count(bodies, self.0.as_ref().len())
    }
}

/// The part of a loading that acts in joints. Implement it for a type that has a name, as in [the plane](crate::planar::Loads).
pub trait JointLaw<T: Scalar> {
    /// `Effort` or `Absent`.
    type Value: Drive<T>;
    /// Whether there is one.
    const ON: bool = true;
    /// Whether it depends on time or motion, or is a [`list`](Self::list).
    const READS: bool = true;
    /// The effort in a joint.
    fn at(&self, time: T::Real, joint: usize, motion: &JointMotion<T>) -> Self::Value;
    /// The efforts where they are a list.
    fn list(&self) -> &[Self::Value] {
        &[]
    }
    /// Refuses a list that is not as long as the scene has joints.
    ///
    /// # Errors
    /// [`Fault::Count`].
    fn check(&self, joints: usize) -> Result<(), Fault> {
        let _ = joints;
        Ok(())
    }
}

impl<T: Scalar> JointLaw<T> for Absent {
    type Value = Absent;
    const ON: bool = false;
    const READS: bool = false;
    fn at(&self, _: T::Real, _: usize, _: &JointMotion<T>) -> Absent {
        Absent
    }
}

impl<T: Scalar, F: Fn(T::Real, usize, &JointMotion<T>) -> Effort<T>> JointLaw<T> for InJoints<F> {
    type Value = Effort<T>;
    const ON: bool = true;
    fn at(&self, time: T::Real, joint: usize, motion: &JointMotion<T>) -> Effort<T> {
        (self.0)(time, joint, motion)
    }
}

impl<T: Scalar, V: AsRef<[Effort<T>]>> JointLaw<T> for Values<V> {
    type Value = Effort<T>;
    const ON: bool = true;
    const READS: bool = false;
    #[inline(always)]
    fn at(&self, _: T::Real, joint: usize, _: &JointMotion<T>) -> Effort<T> {
        self.0.as_ref().get(joint).copied().unwrap_or_default()
    }
    #[inline(always)]
    fn list(&self) -> &[Effort<T>] {
        self.0.as_ref()
    }
    fn check(&self, joints: usize) -> Result<(), Fault> {
        count(joints, self.0.as_ref().len())
    }
}
