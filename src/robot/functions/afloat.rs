//! Dynamics of robots whose base floats: what moves, from forces, and how that changes.

use super::snapshot::{Floating, Moved, six};
use super::{Afloat, Blocks, Driven, MassMatrix, S, SixRows, Snapshot, Tasks, checked, finite};
use crate::element::{Condense, Element};
use crate::ends::Tip;
use crate::error::{Error, Fault};
use crate::mechanics::spatial::body_axes::Place;
use crate::mechanics::spatial::{Free, Turn};
use crate::relation::Open;
use crate::relation::spatial::algebra::{Columns, cross, zero};
use crate::relation::spatial::{Empty, Rigid};
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

impl<T: Scalar, const N: usize> ByStateAfloat<T, N> {
    /// Zeros.
    pub fn zero() -> Self {
        Self { positions: Blocks::zero(), rates: Blocks::zero() }
    }

    /// Refuses numbers that are not finite.
    fn all_finite(&self) -> Result<(), Error> {
        self.positions.all_finite().and(self.rates.all_finite())
    }
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
                let moved = outer.afloat_under(force, torque);
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
        let mut matrix = MassMatrix::zero();
        self.mass_matrix_afloat_into(base, q, &mut matrix)?; // which refuses another number of joints
        solved(&Floating::of(&mut matrix, &self.parents()), wrench, torques)
    }

    /// M⁻¹ of a robot whose base floats.
    ///
    /// # Errors
    /// As [`forward_dynamics_afloat`](Self::forward_dynamics_afloat).
    pub fn mass_inverse_afloat<const N: usize>(&self, base: Place<T>, q: &[T; N]) -> Result<Blocks<T, N>, Error>
    where
        C: Tasks<T, N>,
    {
        let mut found = Blocks::zero();
        self.mass_inverse_afloat_into(base, q, &mut found).map(|()| found)
    }

    /// [`mass_inverse_afloat`](Self::mass_inverse_afloat) into a place that is kept from call to call. What the place holds is overwritten.
    ///
    /// # Errors
    /// As [`forward_dynamics_afloat`](Self::forward_dynamics_afloat); what is in the place then is of no use.
    pub fn mass_inverse_afloat_into<const N: usize>(
        &self,
        base: Place<T>,
        q: &[T; N],
        found: &mut Blocks<T, N>,
    ) -> Result<(), Error>
    where
        C: Tasks<T, N>,
    {
        let mut matrix = MassMatrix::zero();
        self.mass_matrix_afloat_into(base, q, &mut matrix)?; // which refuses another number of joints
        Floating::of(&mut matrix, &self.parents()).inverse(found);
        found.all_finite()
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
        let mut found = ByStateAfloat::zero();
        self.inverse_dynamics_derivatives_afloat_into(base, q, v, of_base, seconds, &mut found).map(|()| found)
    }

    /// [`inverse_dynamics_derivatives_afloat`](Self::inverse_dynamics_derivatives_afloat) into a place that is kept from call to call. What the place
    /// holds is overwritten.
    ///
    /// # Errors
    /// As [`forward_dynamics_afloat`](Self::forward_dynamics_afloat); what is in the place then is of no use.
    pub fn inverse_dynamics_derivatives_afloat_into<const N: usize>(
        &self,
        base: Afloat<T>,
        q: &[T; N],
        v: &[T; N],
        of_base: &[T; 6],
        seconds: &[T; N],
        found: &mut ByStateAfloat<T, N>,
    ) -> Result<(), Error>
    where
        C: Tasks<T, N>,
    {
        let now = self.snapshot_afloat(base, q, v)?;
        [&mut found.positions, &mut found.rates].into_iter().for_each(Blocks::clear);
        self.derived(&now, &mut now.moved(), (q, v), (of_base, seconds), found);
        found.all_finite()
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
        let mut found = (ByStateAfloat::zero(), Blocks::zero());
        self.forward_dynamics_derivatives_afloat_into(base, q, v, wrench, torques, &mut found).map(|()| found)
    }

    /// [`forward_dynamics_derivatives_afloat`](Self::forward_dynamics_derivatives_afloat) into a place that is kept from call to call, for they are
    /// large: copies take a sixth of a humanoid's time. What the place holds is overwritten.
    ///
    /// ```
    /// use catena::robot::*;
    /// let link = Link::general(3.0_f64, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    /// let robot = System::new(Free, (BodyAxes, link, Hinge::at::<7>([0.3, 0.2, -0.1]), link), Free)?;
    /// let base = Afloat::of(robot.body_motions(&robot.motion())?.get(0).unwrap());
    /// let mut found = (ByStateAfloat::zero(), Blocks::zero());
    /// for torque in [1.0, 2.0] {
    ///     robot.forward_dynamics_derivatives_afloat_into(base, &[0.3], &[0.1], &[0.0; 6], &[torque], &mut found)?;
    ///     let (by_state, by_forces) = &found;
    ///     assert!(by_forces.joints[0][0] > 0.0 && by_state.rates.joints[0][0].is_finite());
    /// }
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`forward_dynamics_afloat`](Self::forward_dynamics_afloat); what is in the place then is of no use.
    pub fn forward_dynamics_derivatives_afloat_into<const N: usize>(
        &self,
        base: Afloat<T>,
        q: &[T; N],
        v: &[T; N],
        wrench: &[T; 6],
        torques: &[T; N],
        (by, by_forces): &mut (ByStateAfloat<T, N>, Blocks<T, N>),
    ) -> Result<(), Error>
    where
        C: Tasks<T, N>,
    {
        let now = self.snapshot_afloat(base, q, v)?;
        let (mut moved, mut matrix) = (now.moved(), MassMatrix::zero());
        let (of_base, of_joints) = now.bias_afloat(&moved, &mut matrix);
        let mass = Floating::of(&mut matrix, now.parents());
        let wrench = core::array::from_fn(|k| wrench[k] - of_base[k]);
        let (of_base, seconds) = solved(&mass, &wrench, &core::array::from_fn(|k| torques[k] - of_joints[k]))?;
        [&mut by.positions, &mut by.rates].into_iter().for_each(Blocks::clear);
        self.derived(&now, &mut moved, (q, v), (&of_base, &seconds), by);
        by.positions.solve(-T::one(), &mass);
        by.rates.solve(-T::one(), &mass);
        mass.inverse(by_forces);
        by.all_finite().and(by_forces.all_finite())
    }

    /// Derivatives of inverse dynamics at an instant, with laws of the joints.
    #[cfg_attr(optimised, inline(always))]
    fn derived<const N: usize>(
        &self,
        now: &Snapshot<T, N>,
        moved: &mut Moved<T, N>,
        (q, v): (&[T; N], &[T; N]),
        (of_base, seconds): (&[T; 6], &[T; N]),
        by: &mut ByStateAfloat<T, N>,
    ) where
        C: Tasks<T, N>,
    {
        let ByStateAfloat { positions, rates } = by;
        now.derived(moved, (of_base, seconds), [&mut *positions, &mut *rates]);
        self.stiffened(q, v, |k, [stiffness, damping]| {
            positions.joints[k][k] += stiffness;
            rates.joints[k][k] += damping;
        });
    }
}
