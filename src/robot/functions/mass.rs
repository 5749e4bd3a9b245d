//! The mass matrix, and solutions with it.

use super::{FixedBase, MassMatrix, S, Tasks, checked, finite, resisting, stands};
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::mechanics::spatial::Free;
use crate::mechanics::spatial::body_axes::composite::{Composite, Whole};
use crate::mechanics::spatial::body_axes::factor::{Factor, Inward, Outward};
use crate::mechanics::spatial::body_axes::{Gains, Local, Place};
use crate::relation::Promote;
use crate::relation::spatial::Empty;
use crate::relation::spatial::algebra::{Columns, cross};
use crate::scalar::Scalar;
use crate::shape::Takes;
use crate::system::System;
use nalgebra::Vector3;

/// The walk that finds the mass matrix of the joints, what they take of the base, and all of the robot as one body, in axes of the base.
#[inline(always)]
fn composite<'m, T: Scalar, const N: usize, C: Tasks<T, N>>(
    chain: &C,
    q: &[T; N],
    matrix: &'m mut [[T; N]; N],
) -> Composite<'m, T, N> {
    Composite { positions: *q, sines: stands(chain, q), columns: [[[T::zero(); 3]; 2]; N], matrix, next: N }
}

impl<T: Scalar, R: Root<S<T>>, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, R, C, P> {
    /// The mass matrix M (kg·m², kg·m, kg), reflected inertias on its diagonal.
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics).
    pub fn mass_matrix<const N: usize>(&self, q: &[T; N]) -> Result<[[T; N]; N], Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        let mut found = [[T::zero(); N]; N];
        self.mass_matrix_into(q, &mut found).map(|()| found)
    }

    /// [`mass_matrix`](Self::mass_matrix) into a place that is kept from call to call. What the place holds is overwritten.
    ///
    /// ```
    /// use catena::robot::*;
    /// let link = Link::general(3.0_f64, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    /// let elbow = Hinge::at::<4>([0.0, 0.0, 0.4]).turned(Quarter::<30>);
    /// let arm = System::new(Base::origin(), (Hinge::level().grounded(), link, elbow, link), Free)?;
    /// let mut found = [[0.0; 2]; 2];
    /// for angle in [0.3, 0.4] {
    ///     arm.mass_matrix_into(&[0.1, angle], &mut found)?;
    ///     assert_eq!(found, arm.mass_matrix(&[0.1, angle])?);
    /// }
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics); the place is then as it was.
    pub fn mass_matrix_into<const N: usize>(&self, q: &[T; N], found: &mut [[T; N]; N]) -> Result<(), Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        finite(q)?;
        found.as_flattened_mut().fill(T::zero()); // joints of which neither carries the other
        Takes::<S<T>, Composite<T, N>>::take(
            self.chain(),
            &mut composite(self.chain(), q, found),
            Whole::nothing(N),
            (),
        );
        Ok(())
    }

    /// M factored.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn factored<const N: usize>(&self, q: &[T; N]) -> Factor<T, N>
    where
        C: Tasks<T, N>,
    {
        let stands = resisting(self.chain(), q, q).stands;
        let mut walk = Factor { stands, gains: [Gains::blank(); N], next: N };
        Takes::<S<T>, Factor<T, N>>::take(self.chain(), &mut walk, Local::promote(Empty), ());
        walk
    }

    /// A solution through the factors of M.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn solved<const N: usize>(&self, Factor { stands, gains, .. }: &Factor<T, N>, right: &[T; N]) -> [T; N]
    where
        C: Tasks<T, N>,
    {
        let rest = [[T::zero(); 3]; 2];
        let mut inward = Inward { stands: *stands, gains: *gains, free: *right, next: N };
        Takes::<S<T>, Inward<T, N>>::take(self.chain(), &mut inward, rest, ());
        let mut outward = Outward { stands: *stands, gains: *gains, free: inward.free, next: 0 };
        Takes::<S<T>, Outward<T, N>>::take(self.chain(), &mut outward, rest, ());
        outward.free
    }

    /// M⁻¹ times a list, without M: in time proportional to the number of joints.
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics).
    pub fn mass_solved<const N: usize>(&self, q: &[T; N], right: &[T; N]) -> Result<[T; N], Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        let solved = self.solved(&self.factored(q), right);
        finite(&solved).map(|()| solved)
    }

    /// M⁻¹, its columns through the same factors.
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics).
    pub fn mass_inverse<const N: usize>(&self, q: &[T; N]) -> Result<[[T; N]; N], Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        let factor = self.factored(q);
        let mut inverse = [[T::zero(); N]; N];
        for (k, row) in inverse.iter_mut().enumerate() {
            let mut unit = [T::zero(); N];
            unit[k] = T::one();
            *row = self.solved(&factor, &unit); // M⁻¹ is symmetric
        }
        finite(inverse.as_flattened()).map(|()| inverse)
    }
}

impl<T: Scalar, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, Free, C, P> {
    /// The mass matrix of a robot whose base floats, there: as a [`Snapshot`](super::Snapshot) has it, in less time.
    ///
    /// # Errors
    /// As [`forward_dynamics_afloat`](Self::forward_dynamics_afloat).
    pub fn mass_matrix_afloat<const N: usize>(&self, base: Place<T>, q: &[T; N]) -> Result<MassMatrix<T, N>, Error>
    where
        C: Tasks<T, N>,
    {
        let mut found = MassMatrix::zero();
        self.mass_matrix_afloat_into(base, q, &mut found).map(|()| found)
    }

    /// [`mass_matrix_afloat`](Self::mass_matrix_afloat) into a place that is kept from call to call, for it is large: copies take a third of a
    /// humanoid's time. What the place holds is overwritten.
    ///
    /// ```
    /// use catena::robot::*;
    /// let link = Link::general(3.0_f64, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    /// let robot = System::new(Free, (BodyAxes, link, Hinge::at::<7>([0.3, 0.2, -0.1]), link), Free)?;
    /// let base = Afloat::of(robot.body_motions(&robot.motion())?.get(0).unwrap()).place;
    /// let mut found = MassMatrix::zero();
    /// for angle in [0.3, 0.4] {
    ///     robot.mass_matrix_afloat_into(base, &[angle], &mut found)?;
    ///     assert_eq!(found, robot.mass_matrix_afloat(base, &[angle])?);
    /// }
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`forward_dynamics_afloat`](Self::forward_dynamics_afloat); the place is then as it was.
    pub fn mass_matrix_afloat_into<const N: usize>(
        &self,
        base: Place<T>,
        q: &[T; N],
        found: &mut MassMatrix<T, N>,
    ) -> Result<(), Error>
    where
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        checked(&base).and(finite(q))?;
        let attitude = &base.attitude;
        found.joints.as_flattened_mut().fill(T::zero()); // joints of which neither carries the other
        let mut walk = composite(self.chain(), q, &mut found.joints);
        let whole = Takes::<S<T>, Composite<T, N>>::take(self.chain(), &mut walk, Whole::nothing(N), ());
        let Whole { mass, moment, tensor: [xx, yy, zz, yz, xz, xy], .. } = whole;
        for (coupling, [force, torque]) in found.coupling.iter_mut().zip(walk.columns) {
            let force = attitude.apply(Vector3::from(force));
            let [x, y, z] = torque;
            *coupling = [force.x, force.y, force.z, x, y, z];
        }
        // Of a turn about an own axis: −R σ × , and J.
        let moment = Vector3::from(moment);
        let turning = |axis: Vector3<T>, [x, y, z]: [T; 3]| {
            let force = attitude.apply(cross(axis, moment));
            [force.x, force.y, force.z, x, y, z]
        };
        let Columns { x, y, z } = Columns::identity();
        let turns = [turning(x, [xx, xy, xz]), turning(y, [xy, yy, yz]), turning(z, [xz, yz, zz])];
        found.base = [[T::zero(); 6]; 6];
        for (k, turn) in turns.into_iter().enumerate() {
            found.base[k][k] = mass;
            found.base[3 + k] = turn;
            (0..3).for_each(|i| found.base[i][3 + k] = turn[i]);
        }
        Ok(())
    }
}
