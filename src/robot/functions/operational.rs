//! Operational-space inertia: how a body resists a force and a torque at a point, Λ⁻¹ = J M⁻¹ Jᵀ (O. Khatib, *A unified approach for motion
//! and force control of robot manipulators: the operational space formulation*, IEEE Journal of Robotics and Automation 3, 1987).

use super::snapshot::{Factor, Floating, inverted};
use super::{FixedBase, MassMatrix, S, SixRows, Tasks, finite};
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mechanics::spatial::Free;
use crate::mechanics::spatial::body_axes::Place;
use crate::scalar::Scalar;
use crate::system::System;

/// More of Aᵀ B, of columns side by side.
fn add_products<T: Scalar, const N: usize>(sum: &mut [[T; 6]; 6], a: &[[T; 6]; N], b: &[[T; 6]; N]) {
    for (a, b) in a.iter().zip(b) {
        for (row, a) in sum.iter_mut().zip(a) {
            row.iter_mut().zip(b).for_each(|(sum, b)| *sum = a.mul_add(*b, *sum));
        }
    }
}

/// Λ of Λ⁻¹.
fn inertia<T: Scalar>(compliance: [[T; 6]; 6]) -> Result<[[T; 6]; 6], Error> {
    let what = "an operational-space inertia where joints move the body in fewer than six ways: take the compliance";
    inverted(compliance).ok_or(Error::new(Fault::Unsupported { what }))
}

impl<T: Scalar, R: Root<S<T>>, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, R, C, P> {
    /// How a body on joint `joint` yields at a point (m, its axes): Λ⁻¹ = J M⁻¹ Jᵀ, the acceleration of the point (m/s²) and the angular one
    /// (rad/s²), inertial axes, for each unit of a force (N) there and of a torque (N·m). With less than six joints on the way it has no inverse.
    ///
    /// ```
    /// use catena::robot::*;
    /// let link = Link::general(3.0, [0.2, 0.0, 0.0], [[0.01, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.2]]);
    /// let arm = System::new(Base::origin(), (Hinge::level(), link), Free)?;
    /// // About its hinge the link has 0.32 kg·m²: half a metre out a force across it finds 1.28 kg.
    /// let compliance = arm.operational_compliance(&[0.0], 0, [0.5, 0.0, 0.0])?;
    /// assert!((1.0_f64 / compliance[1][1] - 1.28).abs() < 1e-14);
    /// assert!(arm.operational_inertia(&[0.0], 0, [0.5, 0.0, 0.0]).is_err());
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`jacobian`](Self::jacobian).
    pub fn operational_compliance<const N: usize>(
        &self,
        q: &[T; N],
        joint: usize,
        point: [T; 3],
    ) -> Result<[[T; 6]; 6], Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        let (columns, mut matrix) = (self.jacobian(q, joint, point)?, [[T::zero(); N]; N]);
        self.mass_matrix_into(q, &mut matrix)?;
        let (mut solved, mut sum) = (columns, [[T::zero(); 6]; 6]);
        Factor::of(&mut matrix, &self.parents()).solve(T::one(), &mut solved);
        add_products(&mut sum, &columns, &solved);
        finite(sum.as_flattened()).map(|()| sum)
    }

    /// What a body resists an acceleration of a point with, Λ, the inverse of its [compliance](Self::operational_compliance): a force (N) there and a
    /// torque (N·m), inertial axes, for each unit of acceleration (m/s²) and angular acceleration (rad/s²), where all joints give way.
    ///
    /// # Errors
    /// As [`jacobian`](Self::jacobian); [`Fault::Unsupported`] where joints move the body in fewer than six ways: a pivot keeps less than
    /// ε^0.7 of what was there.
    pub fn operational_inertia<const N: usize>(
        &self,
        q: &[T; N],
        joint: usize,
        point: [T; 3],
    ) -> Result<[[T; 6]; 6], Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        inertia(self.operational_compliance(q, joint, point)?)
    }
}

impl<T: Scalar, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, Free, C, P> {
    /// How a body on a joint, or the base, of a robot that floats yields at a point, as [`operational_compliance`](Self::operational_compliance) has it.
    ///
    /// # Errors
    /// As [`jacobian_afloat`](Self::jacobian_afloat).
    pub fn operational_compliance_afloat<const N: usize>(
        &self,
        base: Place<T>,
        q: &[T; N],
        joint: Option<usize>,
        point: [T; 3],
    ) -> Result<[[T; 6]; 6], Error>
    where
        C: Tasks<T, N>,
    {
        let SixRows { base: of_base, joints } = self.jacobian_afloat(base, q, joint, point)?;
        let mut matrix = MassMatrix::zero();
        self.mass_matrix_afloat_into(base, q, &mut matrix)?;
        let (mut by_base, mut by_joints, mut sum) = (of_base, joints, [[T::zero(); 6]; 6]);
        Floating::of(&mut matrix, &self.parents()).solve(T::one(), &mut by_base, &mut by_joints);
        add_products(&mut sum, &of_base, &by_base);
        add_products(&mut sum, &joints, &by_joints);
        finite(sum.as_flattened()).map(|()| sum)
    }

    /// What a body on a joint, or the base, of a robot that floats resists an acceleration of a point with, as
    /// [`operational_inertia`](Self::operational_inertia) has it.
    ///
    /// # Errors
    /// As [`jacobian_afloat`](Self::jacobian_afloat).
    pub fn operational_inertia_afloat<const N: usize>(
        &self,
        base: Place<T>,
        q: &[T; N],
        joint: Option<usize>,
        point: [T; 3],
    ) -> Result<[[T; 6]; 6], Error>
    where
        C: Tasks<T, N>,
    {
        inertia(self.operational_compliance_afloat(base, q, joint, point)?)
    }
}
