//! Mass, mass centre and moments of inertia of a body.

use super::second_moments::SecondMoments;
use crate::error::Fault;
use crate::error::checks::{finite, largest, not_negative};
use crate::lift::lift;
use crate::relation::Symmetric;
use crate::relation::spatial::algebra::{Columns, Symmetric3, dot};
use crate::scalar::{Real, Scalar};
use nalgebra::Vector3;

/// Mass, mass centre and moments of inertia of a body in space.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Inertia<T> {
    /// Mass (kg).
    pub mass: T,
    /// Mass centre from the inboard end (m), body axes.
    pub centre: [T; 3],
    /// Inertia tensor about the mass centre (kg·m²), body axes: moments on the diagonal, minus the products beside it.
    pub about_centre: [[T; 3]; 3],
}

impl<T: Scalar> Inertia<T> {
    /// The tensor about the mass centre as columns.
    #[inline(always)]
    pub fn matrix(&self) -> Columns<T> {
        let [x, y, z] = self.about_centre.map(Vector3::from);
        Columns { x, y, z }
    }

    /// The tensor about the inboard end, J_I = J_C + m (|r|² 1 − r rᵀ): that of (20).
    pub fn about_inboard(&self) -> Symmetric3<T> {
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = self.about_centre;
        let r = Vector3::from(self.centre);
        let moment = r * self.mass;
        Symmetric3 { xx, xy, xz, yy, yz, zz }.plus_diagonal(dot(r, moment)).plus_outer(-r, moment)
    }

    /// Rejects values with which there is no mechanics: a negative mass, or a negative moment of inertia about some axis, so that a
    /// body would gain energy by being braked. A body without mass is allowed: its joint tells if it is needed.
    ///
    /// Moments of which one exceeds the sum of the others are allowed, too. No body has them, but published robot descriptions do, most
    /// of them identified from motions or rounded, and every pivot of a sweep is positive with them. [`doubt`](Self::doubt) says so,
    /// [`System::doubts`](crate::system::System::doubts) lists them, and [`repaired`](Self::repaired) finds the nearest that a body has,
    /// also where a moment is negative.
    ///
    /// # Errors
    /// [`Fault::NotFinite`], [`Fault::Negative`] or [`Fault::NotSymmetric`].
    pub fn check(&self) -> Result<(), Fault> {
        self.check_entries()?;
        let least = SecondMoments::of(self).least_moment();
        let below = (least + self.slack()).if_negative(least, T::zero()).real().as_f64();
        if below < 0.0 {
            return Err(Fault::Negative { parameter: "principal moment of inertia", value: below });
        }
        Ok(())
    }

    /// Rejects a negative mass, and a tensor that is not symmetric or not finite; its moments may be negative.
    pub(super) fn check_entries(&self) -> Result<(), Fault> {
        not_negative("mass", self.mass)?;
        finite("mass centre", &self.centre)?;
        self.about_centre.iter().try_for_each(|row| finite("inertia tensor", row))?;
        let (j, slack) = (self.about_centre, self.slack());
        let askew = largest([j[0][1] - j[1][0], j[0][2] - j[2][0], j[1][2] - j[2][1]]);
        if (slack - askew).if_negative(T::one(), T::zero()).real() > T::Real::of(0.0) {
            return Err(Fault::NotSymmetric { parameter: "inertia tensor" });
        }
        Ok(())
    }
}

lift!(Inertia { mass, centre, about_centre });
