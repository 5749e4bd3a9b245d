//! A point mass on a massless link.

use super::body::{not_negative, positive};
use super::{Body, Inertia};
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::plane::{Full, Relation};
use crate::scalar::Scalar;
use nalgebra::Vector2;
use num_traits::Zero;

/// A point mass at the outboard end of a massless rigid link along the x axis: the bob of a mathematical pendulum.
///
/// (40) of the paper cannot transfer such a body: its outboard end is the centre of percussion of its inboard end, where
/// the pivot Ū₄₃ vanishes. A condensed relation has the pivot n·S n > 0 instead.
///
/// ```
/// use catena::planar::{Body, PointMass};
/// let bob = PointMass::new(1.5, 0.2); // length (m), mass (kg)
/// assert_eq!(bob.inertia().centre, [1.5, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointMass<T> {
    length: T,
    mass: T,
}

impl<T: Scalar> PointMass<T> {
    /// A point mass (kg) at the end of a massless link with a length (m).
    pub fn new(length: T, mass: T) -> Self {
        Self { length, mass }
    }
}

impl<T: Scalar> Body<T> for PointMass<T> {
    fn inertia(&self) -> Inertia<T> {
        Inertia { mass: self.mass, centre: [self.length, T::zero()], about_centre: T::zero() }
    }

    #[inline(always)]
    fn arm(&self, cosine: T, sine: T) -> Vector2<T> {
        Vector2::new(self.length * cosine, self.length * sine)
    }

    #[inline(always)]
    fn condense<R: Relation<T>>(&self, outer: R, cosine: T, sine: T, spin2: T) -> Full<T, R::Closures> {
        outer.with_mass(self.mass).carried(self.arm(cosine, sine), spin2)
    }

    fn check(&self) -> Result<(), Fault> {
        positive("length", self.length)?;
        not_negative("mass", self.mass, T::Real::zero())
    }
}

lift!(PointMass { length, mass });
