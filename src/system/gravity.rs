//! Gravity as users say it: a number along −y in the plane, a vector in space.

use super::System;
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::mechanics::planar::Planar;
use crate::mechanics::spatial::Spatial;
use crate::scalar::Scalar;
use crate::sealed::Sealed;
use nalgebra::{Vector2, Vector3};

impl<T: Scalar, R: Root<Planar<T>>, C: Element<Planar<T>>, P: Tip<Planar<T>>> System<Planar<T>, R, C, P> {
    /// This scene in a field of gravity of this magnitude (m/s²) along −y;
    /// [`with_gravity_vector`](Self::with_gravity_vector) points it anywhere else.
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let pendulum = System::new(Pinned::origin(), rod, Free)?.with_gravity(9.81);
    /// assert_eq!(pendulum.gravity().y, -9.81);
    /// # Ok::<(), catena::Error>(())
    /// ```
    #[must_use]
    pub fn with_gravity(self, g: T) -> Self {
        self.with_gravity_vector(Vector2::new(T::zero(), -g))
    }
}

/// A vector of gravity: `[x, y, z]`, or a `Vector3`.
#[diagnostic::on_unimplemented(
    message = "gravity in space is a vector, `{Self}` is not",
    label = "along which axis?",
    note = "write `[0.0, 0.0, -9.81]` where z points up"
)]
pub trait Gravity<T>: Sealed {
    /// Gravity as a vector (m/s²), inertial axes.
    fn vector(self) -> Vector3<T>;
}

impl<T> Sealed for [T; 3] {}

impl<T: Scalar> Gravity<T> for [T; 3] {
    fn vector(self) -> Vector3<T> {
        Vector3::from(self)
    }
}

impl<T> Sealed for Vector3<T> {}

impl<T: Scalar> Gravity<T> for Vector3<T> {
    fn vector(self) -> Self {
        self
    }
}

impl<T: Scalar, R: Root<Spatial<T>>, C: Element<Spatial<T>>, P: Tip<Spatial<T>>> System<Spatial<T>, R, C, P> {
    /// This scene in a uniform field of gravity (m/s², inertial axes): no axis is down by itself.
    ///
    /// ```
    /// use catena::spatial::*;
    /// let rod = Rod::uniform(1.0, 0.05, 1.0);
    /// let pendulum = System::new(Pinned::origin(), rod, Free)?.with_gravity([0.0, 0.0, -9.81]);
    /// assert_eq!(pendulum.gravity().z, -9.81);
    /// # Ok::<(), catena::Error>(())
    /// ```
    #[must_use]
    pub fn with_gravity(self, gravity: impl Gravity<T>) -> Self {
        self.with_gravity_vector(gravity.vector())
    }
}
