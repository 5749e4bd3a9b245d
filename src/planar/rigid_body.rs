//! A rigid body with its mass centre and its outboard end anywhere.

use super::{Body, Inertia};
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::plane::{Full, Relation};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// A rigid body. Its axes start at the inboard end; mass centre and outboard end may be anywhere, also at the inboard end
/// (a flywheel). A body whose mass centre lies on the line between its ends is cheaper as a [`Rod`](super::Rod).
///
/// ```
/// use catena::planar::{Body, RigidBody};
/// // A plate: mass (kg), moment of inertia about the mass centre (kg·m²), mass centre and outboard end (m).
/// let plate = RigidBody::new(2.0, 0.3, [0.4, 0.1], [0.8, -0.2]);
/// assert_eq!(plate.inertia().mass, 2.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidBody<T> {
    inertia: Inertia<T>,
    outboard: [T; 2],
    /// J_I = J_C + m |d_C|².
    about_inboard: T,
}

impl<T: Scalar> RigidBody<T> {
    /// A body with mass (kg), moment of inertia about its mass centre (kg·m²), mass centre and outboard end (m, body axes).
    pub fn new(mass: T, about_centre: T, centre: [T; 2], outboard: [T; 2]) -> Self {
        let [x, y] = centre;
        Self {
            inertia: Inertia { mass, centre, about_centre },
            outboard,
            about_inboard: about_centre + mass * (x * x + y * y),
        }
    }
}

/// A vector of body axes in inertial axes.
#[inline(always)]
fn turned<T: Scalar>([x, y]: [T; 2], cosine: T, sine: T) -> Vector2<T> {
    Vector2::new(cosine.mul_add(x, -(sine * y)), sine.mul_add(x, cosine * y))
}

impl<T: Scalar> Body<T> for RigidBody<T> {
    fn inertia(&self) -> Inertia<T> {
        self.inertia
    }

    #[inline(always)]
    fn arm(&self, cosine: T, sine: T) -> Vector2<T> {
        turned(self.outboard, cosine, sine)
    }

    #[inline(always)]
    fn condense<R: Relation<T>>(&self, outer: R, cosine: T, sine: T, spin2: T) -> Full<T, R::Closures> {
        let Inertia { mass, centre, .. } = self.inertia;
        outer
            .carried(self.arm(cosine, sine), spin2)
            .with_mass(mass)
            .with_first_moment(turned(centre, cosine, sine) * mass, spin2)
            .with_inertia(self.about_inboard)
    }

    fn check(&self) -> Result<(), Fault> {
        if !(self.outboard[0].is_finite() && self.outboard[1].is_finite()) {
            return Err(Fault::NotFinite { parameter: "outboard end" });
        }
        self.inertia.check()
    }
}

lift!(RigidBody { inertia, outboard, about_inboard });
