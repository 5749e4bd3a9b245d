//! Surfaces that points of bodies may touch: planes and heights.

use crate::error::Fault;
use crate::error::checks::finite;
use crate::lift::lift;
use crate::relation::spatial::algebra::dot;
use crate::scalar::{Real, Scalar};
use nalgebra::Vector3;

/// A surface that bodies may touch.
pub trait Surface<T: Scalar> {
    /// How far a place (m, inertial axes) is below the surface (m, negative above it), and the unit normal out of the surface there.
    fn below(&self, place: [T; 3]) -> (T, [T; 3]);
    /// Rejects a surface whose normals are known not to be unit vectors.
    ///
    /// # Errors
    /// What is wrong with it.
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

/// A plane as a surface.
///
/// ```
/// use catena::spatial::{Plane, Surface};
/// assert_eq!(Plane::level(0.5_f64).below([3.0, 4.0, 0.0]), (0.5, [0.0, 0.0, 1.0]));
/// let slope = Plane::through([0.0_f64; 3], [-0.6, 0.0, 0.8]); // a point (m), a unit normal
/// assert!((slope.below([1.0, 0.0, 0.75]).0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Plane<T> {
    normal: [T; 3],
    offset: T,
}

impl<T: Scalar> Plane<T> {
    /// Across z at a height (m).
    pub fn level(height: T) -> Self {
        Self { normal: [T::zero(), T::zero(), T::one()], offset: height }
    }

    /// Through a point (m), with a unit normal.
    pub fn through(point: [T; 3], normal: [T; 3]) -> Self {
        let offset = dot(Vector3::from(normal), Vector3::from(point));
        Self { normal, offset }
    }
}

impl<T: Scalar> Surface<T> for Plane<T> {
    #[inline(always)]
    fn below(&self, place: [T; 3]) -> (T, [T; 3]) {
        (self.offset - dot(Vector3::from(self.normal), Vector3::from(place)), self.normal)
    }
    fn check(&self) -> Result<(), Fault> {
        finite("height of a plane", &[self.offset])?;
        finite("normal of a plane", &self.normal)?;
        let normal = Vector3::from(self.normal);
        let (over, rounding) = ((dot(normal, normal).sqrt() - T::one()).real(), 1e-6); // of lanes the worst
        let value = 1.0 + over.as_f64();
        if (value - 1.0).abs() <= rounding {
            return Ok(());
        }
        let (least, most, outside) = (1.0 - rounding, 1.0 + rounding, "friction would not be along the plane");
        Err(Fault::OutOfRange { parameter: "length of the normal of a plane", value, least, most, outside })
    }
}

lift!(Plane { normal, offset });

/// A height function as a surface: of x and y (m) it gives the height (m) and its slopes along x and y. Depths are those of the tangent
/// plane, which the surface leaves by its curvature times their square.
///
/// ```
/// use catena::spatial::{Heights, Surface};
/// let waves = Heights(|x: f64, _y: f64| [0.1 * x.sin(), 0.1 * x.cos(), 0.0]);
/// let (below, normal) = waves.below([0.0, 2.0, -0.01]);
/// assert!((below - 0.01 * normal[2]).abs() < 1e-15 && normal[0] < 0.0);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Heights<F>(pub F);

impl<T: Scalar, F: Fn(T, T) -> [T; 3]> Surface<T> for Heights<F> {
    #[cfg_attr(optimised, inline(always))]
    fn below(&self, [x, y, z]: [T; 3]) -> (T, [T; 3]) {
        let [height, by_x, by_y] = (self.0)(x, y);
        let up = (by_x * by_x + by_y * by_y + T::one()).sqrt().recip();
        ((height - z) * up, [-by_x * up, -by_y * up, up])
    }
}
