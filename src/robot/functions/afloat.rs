//! Dynamics of robots whose base floats: what moves, from forces, and how that changes.

use super::snapshot::{Floating, six};
use super::{Afloat, Blocks, Driven, S, SixRows, Snapshot, Tasks, checked, finite};
use crate::element::{Condense, Element};
use crate::ends::Tip;
use crate::error::{Error, Fault};
use crate::mechanics::spatial::body_axes::Place;
use crate::mechanics::spatial::{Free, Turn};
use crate::relation::Open;
use crate::relation::spatial::algebra::{Columns, cross, zero};
use crate::relation::spatial::{Empty, Full, Rigid};
use crate::scalar::Scalar;
use crate::system::System;
use nalgebra::Vector3;

/// Derivatives by the state of a robot whose base floats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByStateAfloat<T, const N: usize> {
    /// By positions: of the base its place in inertial axes and a small turn about its own, and of the joints.
    pub positions: Blocks<T, N>,
    /// By rates: of the base its velocity in inertial axes and its angular velocity in its own, and of the joints.
    pub rates: Blocks<T, N>,
}

/// M⁻¹ times a wrench on the base and torques of the joints.
fn solved<T: Scalar, const N: usize>(
    mass: &Floating<'_, T, N>,
    wrench: &[T; 6],
    torques: &[T; N],
) -> Result<([T; 6], [T; N]), Error> {
    let (mut base, mut joints) = (wrench.map(|x| [x]), torques.map(|x| [x]));
    mass.solve(T::one(), &mut base, &mut joints);
    finite(base.as_flattened()).and(finite(joints.as_flattened()))?;
    Ok((base.map(|[x]| x), joints.map(|[x]| x)))
}

/// Accelerations of a robot at an instant, where its mass matrix is known.
fn accelerations<T: Scalar, const N: usize>(
    now: &Snapshot<T, N>,
    mass: &Floating<'_, T, N>,
    wrench: &[T; 6],
    torques: &[T; N],
) -> Result<([T; 6], [T; N]), Error> {
    let (of_base, of_joints) = now.inverse_dynamics(&[T::zero(); 6], &[T::zero(); N]);
    let wrench = core::array::from_fn(|k| wrench[k] - of_base[k]);
    solved(mass, &wrench, &core::array::from_fn(|k| torques[k] - of_joints[k]))
}

impl<T: Scalar, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, Free, C, P> {
    /// Accelerations of a base that floats and of the joints (rad/s², m/s²) from a force on the base (N, inertial axes) with a torque about its
    /// origin (N·m, its axes), and from torques of the joints (N·m, N): in gravity, with the springs and dampers of the joints. Those of
    /// the base are of its velocity in inertial axes and of its angular velocity in its own.
    ///
    /// ```
    /// use catena::robot::*;
    /// let link = Link::general(3.0_f64, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    /// let legs = [Branch((Hinge::at::<7>([0.3, 0.2, -0.1]), link)), Branch((Hinge::at::<7>([-0.3, 0.2, -0.1]), link))];
    /// let robot = System::new(Free, (BodyAxes, link, legs), Free)?.with_gravity([0.0, 0.0, -9.81]);
    /// let base = Afloat::of(robot.body_motions(&robot.motion())?.get(0).unwrap());
    /// // Nothing holds it.
    /// let (of_base, of_joints) = robot.forward_dynamics_afloat(base, &[0.3, -0.2], &[0.0; 2], &[0.0; 6], &[0.0; 2])?;
    /// assert!((of_base[2] + 9.81).abs() < 1e-12 && of_joints[0].abs() < 1e-12);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics); [`Fault::NotZero`] for a base whose axes are not orthonormal and right-handed.
    pub fn forward_dynamics_afloat<const N: usize>(
        &self,
        base: Afloat<T>,
        q: &[T; N],
        v: &[T; N],
        wrench: &[T; 6],
        torques: &[T; N],
    ) -> Result<([T; 6], [T; N]), Error>
    where
        C: Tasks<T, N> + Condense<S<T>, Empty, Driven<T, N>, Out: Rigid<T, Closures = Open>>,
    {
        self.has_joints(N)?;
        checked(&base.place)?;
        finite(base.velocity.as_slice()).and(finite(base.spin.as_slice()))?;
        let attitude = base.place.attitude;
        let [fx, fy, fz, mx, my, mz] = *wrench;
        let (force, torque) = (Vector3::new(fx, fy, fz), attitude.apply(Vector3::new(mx, my, mz)));
        let turn = Turn { attitude, spin: attitude.apply(base.spin) };
        let mut of_base = [zero(); 2];
        let seconds = self.swept(
            || turn,
            q,
            v,
            torques,
            |outer| {
                let outer = outer.full();
                let (moved, ..) = Full { force: outer.force - force, torque: outer.torque - torque, ..outer }.afloat();
                of_base = [moved.linear + self.gravity(), attitude.transposed(moved.angular)];
                moved
            },
        );
        let of_base = six(of_base);
        finite(&of_base).and(finite(&seconds)).map(|()| (of_base, seconds))
    }

    /// The Jacobian of a point (m, axes of its body) of the body on a joint, or of the base, as a [`Snapshot`] has it, from the joints on the way
    /// there alone.
    ///
    /// # Errors
    /// As [`jacobian`](Self::jacobian); [`Fault::NotZero`] for a base whose axes are not orthonormal and right-handed.
    pub fn jacobian_afloat<const N: usize>(
        &self,
        base: Place<T>,
        q: &[T; N],
        joint: Option<usize>,
        point: [T; 3],
    ) -> Result<SixRows<T, N>, Error>
    where
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        let Place { place, attitude } = base;
        let Columns { x, y, z } = attitude;
        checked(&base).and(finite(q)).and(finite(&point))?;
        if let Some(joint) = joint.filter(|joint| *joint >= N) {
            return Err(Error::new(Fault::NoSuchJoint { joint, joints: N }));
        }
        let (joints, point) = self.columns(base, q, joint.unwrap_or(usize::MAX), point);
        let (from, Columns { x: a, y: b, z: c }) = (point - place, Columns::identity());
        let turning = |axis| six([cross(axis, from), axis]);
        let [a, b, c] = [a, b, c].map(|axis| six([axis, zero()]));
        Ok(SixRows { base: [a, b, c, turning(x), turning(y), turning(z)], joints })
    }

    /// M⁻¹ times six numbers of the base and one of each joint.
    ///
    /// # Errors
    /// As [`forward_dynamics_afloat`](Self::forward_dynamics_afloat).
    pub fn mass_solved_afloat<const N: usize>(
        &self,
        base: Place<T>,
        q: &[T; N],
        wrench: &[T; 6],
        torques: &[T; N],
    ) -> Result<([T; 6], [T; N]), Error>
    where
        C: Tasks<T, N>,
    {
        solved(&Floating::of(self.mass_matrix_afloat(base, q)?, &self.parents()), wrench, torques)
    }

    /// M⁻¹ of a robot whose base floats.
    ///
    /// # Errors
    /// As [`forward_dynamics_afloat`](Self::forward_dynamics_afloat).
    pub fn mass_inverse_afloat<const N: usize>(&self, base: Place<T>, q: &[T; N]) -> Result<Blocks<T, N>, Error>
    where
        C: Tasks<T, N>,
    {
        let matrix = self.mass_matrix_afloat(base, q)?; // which refuses another number of joints
        let parents = self.parents();
        let mass = Floating::of(matrix, &parents);
        let mut one = Blocks::zero();
        one.set_diagonal(T::one());
        one.solved(T::one(), &mass).map(|()| one)
    }

    /// Derivatives of [inverse dynamics](Snapshot::inverse_dynamics) of a robot whose base floats, by positions and rates of base and joints,
    /// at accelerations of both: of the force on the base (inertial axes) and the torque about its origin (its axes), and of the torques of
    /// the joints. None is by the place of the base or its velocity.
    ///
    /// # Errors
    /// As [`forward_dynamics_afloat`](Self::forward_dynamics_afloat).
    pub fn inverse_dynamics_derivatives_afloat<const N: usize>(
        &self,
        base: Afloat<T>,
        q: &[T; N],
        v: &[T; N],
        of_base: &[T; 6],
        seconds: &[T; N],
    ) -> Result<ByStateAfloat<T, N>, Error>
    where
        C: Tasks<T, N>,
    {
        let now = self.snapshot_afloat(base, q, v)?;
        let mut by = ByStateAfloat { positions: Blocks::zero(), rates: Blocks::zero() };
        self.derived(&now, (q, v), (of_base, seconds), &mut by);
        by.positions.all_finite().and(by.rates.all_finite())?;
        Ok(by)
    }

    /// Derivatives of [`forward_dynamics_afloat`](Self::forward_dynamics_afloat) by positions and rates of base and joints, and by the wrench on
    /// the base and torques of the joints (the last one is M⁻¹), for a wrench that stays as it is: its force in inertial axes, its torque in
    /// those of the base.
    ///
    /// # Errors
    /// As [`forward_dynamics_afloat`](Self::forward_dynamics_afloat).
    pub fn forward_dynamics_derivatives_afloat<const N: usize>(
        &self,
        base: Afloat<T>,
        q: &[T; N],
        v: &[T; N],
        wrench: &[T; 6],
        torques: &[T; N],
    ) -> Result<(ByStateAfloat<T, N>, Blocks<T, N>), Error>
    where
        C: Tasks<T, N>,
    {
        let now = self.snapshot_afloat(base, q, v)?;
        let mass = Floating::of(self.mass_matrix_afloat(base.place, q)?, now.parents());
        let (of_base, seconds) = accelerations(&now, &mass, wrench, torques)?;
        let mut found = (ByStateAfloat { positions: Blocks::zero(), rates: Blocks::zero() }, Blocks::zero());
        let (by, by_forces) = (&mut found.0, &mut found.1);
        self.derived(&now, (q, v), (&of_base, &seconds), by);
        by_forces.set_diagonal(-T::one());
        for by in [&mut by.positions, &mut by.rates, by_forces] {
            by.solved(-T::one(), &mass)?;
        }
        Ok(found)
    }

    /// Derivatives of inverse dynamics at an instant, with laws of the joints.
    #[cfg_attr(optimised, inline(always))]
    fn derived<const N: usize>(
        &self,
        now: &Snapshot<T, N>,
        (q, v): (&[T; N], &[T; N]),
        (of_base, seconds): (&[T; 6], &[T; N]),
        by: &mut ByStateAfloat<T, N>,
    ) where
        C: Tasks<T, N>,
    {
        let ByStateAfloat { positions, rates } = by;
        now.derived(of_base, seconds, [&mut *positions, &mut *rates]);
        self.stiffened(q, v, |k, [stiffness, damping]| {
            positions.joints[k][k] += stiffness;
            rates.joints[k][k] += damping;
        });
    }
}
