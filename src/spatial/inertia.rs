//! Mass, mass centre and moments of inertia of a body.

use crate::error::Fault;
use crate::lift::lift;
use crate::relation::space::algebra::{Columns, Symmetric3, dot};
use crate::scalar::{Real, Scalar};
use nalgebra::Vector3;
use num_traits::Zero;

/// Mass, mass centre and moments of inertia of a body in space.
#[derive(Clone, Copy, Debug, PartialEq)]
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

    /// Rejects values that no body has. A body without mass is allowed: its joint tells if it is needed.
    ///
    /// # Errors
    /// [`Fault::NotFinite`], [`Fault::Negative`], [`Fault::NotSymmetric`] or [`Fault::ImpossibleInertia`].
    pub fn check(&self) -> Result<(), Fault> {
        not_negative("mass", self.mass)?;
        finite("mass centre", &self.centre)?;
        self.about_centre.iter().try_for_each(|row| finite("inertia tensor", row))?;
        let j = self.about_centre.map(|row| row.map(|x| x.real().as_f64()));
        let size = j.iter().flatten().fold(0.0_f64, |size, x| size.max(if *x < 0.0 { -*x } else { *x }));
        let slack = size * T::Real::EPSILON.as_f64() * 16.0;
        let differs = |a: f64, b: f64| a - b > slack || b - a > slack;
        if differs(j[0][1], j[1][0]) || differs(j[0][2], j[2][0]) || differs(j[1][2], j[2][1]) {
            return Err(Fault::NotSymmetric { parameter: "inertia tensor" });
        }
        // The matrix of second moments ∫ x xᵀ dm = ½ tr J 1 − J must be positive semidefinite; then J is too, and every moment is
        // at most the sum of the others.
        let half = 0.5 * (j[0][0] + j[1][1] + j[2][2]);
        let s = |a: usize, b: usize| if a == b { half - j[a][b] } else { -j[a][b] };
        let minor = |a: usize, b: usize| s(a, a) * s(b, b) - s(a, b) * s(a, b);
        let cofactors = [minor(1, 2), s(1, 2) * s(0, 2) - s(0, 1) * s(2, 2), s(0, 1) * s(1, 2) - s(1, 1) * s(0, 2)];
        let determinant = s(0, 0) * cofactors[0] + s(0, 1) * cofactors[1] + s(0, 2) * cofactors[2];
        let possible = (0..3).all(|a| s(a, a) >= -slack)
            && [(0, 1), (0, 2), (1, 2)].iter().all(|(a, b)| minor(*a, *b) >= -slack * size)
            && determinant >= -slack * size * size;
        if possible { Ok(()) } else { Err(Fault::ImpossibleInertia) }
    }
}

/// Fails where a value is NaN or infinite.
pub(super) fn finite<T: Scalar>(parameter: &'static str, values: &[T]) -> Result<(), Fault> {
    if values.iter().all(|x| x.is_finite()) { Ok(()) } else { Err(Fault::NotFinite { parameter }) }
}

/// Fails where a value is NaN, infinite or negative.
pub(super) fn not_negative<T: Scalar>(parameter: &'static str, value: T) -> Result<(), Fault> {
    finite(parameter, &[value])?;
    if value.real() < T::Real::zero() {
        return Err(Fault::Negative { parameter, value: value.real().as_f64() });
    }
    Ok(())
}

/// Fails where a value is NaN, infinite, zero or negative.
pub(super) fn positive<T: Scalar>(parameter: &'static str, value: T) -> Result<(), Fault> {
    finite(parameter, &[value])?;
    if value.real() <= T::Real::zero() {
        return Err(Fault::NotPositive { parameter, value: value.real().as_f64() });
    }
    Ok(())
}

lift!(Inertia { mass, centre, about_centre });
