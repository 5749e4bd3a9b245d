//! Dynamics of robots whose base floats: what moves, from forces, and how that changes.

use super::derivatives::one;
use super::snapshot::Floating;
use super::{Afloat, Blocks, MassMatrix, S, Snapshot, Tasks, finite};
use crate::element::Element;
use crate::ends::Tip;
use crate::error::Error;
use crate::mechanics::spatial::Free;
use crate::scalar::Scalar;
use crate::system::System;

/// Derivatives by the state of a robot whose base floats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByStateAfloat<T, const N: usize> {
    /// By positions: of the base its place in inertial axes and a small turn about its own, and of the joints.
    pub positions: Blocks<T, N>,
    /// By rates: of the base its velocity in inertial axes and its angular velocity in its own, and of the joints.
    pub rates: Blocks<T, N>,
}

impl<T: Scalar, const N: usize> Blocks<T, N> {
    /// `by` · M⁻¹ times this.
    fn solved(mut self, by: T, mass: &Floating<'_, T, N>) -> Result<Self, Error> {
        mass.solve(by, &mut self.base, &mut self.joints_by_base);
        mass.solve(by, &mut self.base_by_joints, &mut self.joints);
        let of_base = finite(self.base.as_flattened()).and(finite(self.base_by_joints.as_flattened()));
        let of_joints = finite(self.joints_by_base.as_flattened()).and(finite(self.joints.as_flattened()));
        of_base.and(of_joints).map(|()| self)
    }

    /// The identity.
    fn one() -> Self {
        Self { base: one(), joints: one(), ..Self::zero() }
    }
}

/// M⁻¹ times a wrench on the base and torques of the joints.
fn solved<T: Scalar, const N: usize>(
    now: &Snapshot<T, N>,
    wrench: &[T; 6],
    torques: &[T; N],
) -> Result<([T; 6], [T; N]), Error> {
    let (mut base, mut joints) = (wrench.map(|x| [x]), torques.map(|x| [x]));
    Floating::of(now.mass_matrix(), now.parents()).solve(T::one(), &mut base, &mut joints);
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
    /// As [`forward_dynamics`](Self::forward_dynamics).
    pub fn forward_dynamics_afloat<const N: usize>(
        &self,
        base: Afloat<T>,
        q: &[T; N],
        v: &[T; N],
        wrench: &[T; 6],
        torques: &[T; N],
    ) -> Result<([T; 6], [T; N]), Error>
    where
        C: Tasks<T, N>,
    {
        let now = self.snapshot_afloat(base, q, v)?;
        let (of_base, of_joints) = now.inverse_dynamics(&[T::zero(); 6], &[T::zero(); N]);
        let wrench = core::array::from_fn(|k| wrench[k] - of_base[k]);
        solved(&now, &wrench, &core::array::from_fn(|k| torques[k] - of_joints[k]))
    }

    /// M⁻¹ times six numbers of the base and one of each joint.
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics).
    pub fn mass_solved_afloat<const N: usize>(
        &self,
        base: Afloat<T>,
        q: &[T; N],
        wrench: &[T; 6],
        torques: &[T; N],
    ) -> Result<([T; 6], [T; N]), Error>
    where
        C: Tasks<T, N>,
    {
        solved(&self.snapshot_afloat(base, q, &[T::zero(); N])?, wrench, torques)
    }

    /// M⁻¹ of a robot whose base floats.
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics).
    pub fn mass_inverse_afloat<const N: usize>(&self, base: Afloat<T>, q: &[T; N]) -> Result<Blocks<T, N>, Error>
    where
        C: Tasks<T, N>,
    {
        let now = self.snapshot_afloat(base, q, &[T::zero(); N])?;
        Blocks::one().solved(T::one(), &Floating::of(now.mass_matrix(), now.parents()))
    }

    /// Derivatives of [inverse dynamics](Snapshot::inverse_dynamics) by positions and rates of base and joints, and the mass matrix, which is that
    /// by accelerations, from one kernel.
    fn derived<const N: usize>(
        &self,
        now: &Snapshot<T, N>,
        [q, v]: [&[T; N]; 2],
        base: &[T; 6],
        seconds: &[T; N],
    ) -> (ByStateAfloat<T, N>, MassMatrix<T, N>)
    where
        C: Tasks<T, N>,
    {
        let (partials, whole) = now.partials(base, seconds);
        let mut joints = now.pairs(&partials);
        self.stiffened(q, v, &mut joints);
        let ([positions, rates], mass) = now.blocks(base, &partials, &whole, joints);
        (ByStateAfloat { positions, rates }, mass)
    }

    /// Derivatives of [inverse dynamics](Snapshot::inverse_dynamics) of a robot whose base floats, by positions and rates of base and joints,
    /// at accelerations of both: of the force on the base (inertial axes) and the torque about its origin (its axes), and of the torques of
    /// the joints. None is by the place of the base or its velocity.
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics).
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
        Ok(self.derived(&self.snapshot_afloat(base, q, v)?, [q, v], of_base, seconds).0)
    }

    /// Derivatives of [`forward_dynamics_afloat`](Self::forward_dynamics_afloat) by positions and rates of base and joints, and by the wrench on
    /// the base and torques of the joints (the last one is M⁻¹), for a wrench that stays as it is: its force in inertial axes, its torque in
    /// those of the base.
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics).
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
        let (of_base, seconds) = self.forward_dynamics_afloat(base, q, v, wrench, torques)?;
        let now = self.snapshot_afloat(base, q, v)?;
        let (ByStateAfloat { positions, rates }, mass) = self.derived(&now, [q, v], &of_base, &seconds);
        let (mass, less) = (Floating::of(mass, now.parents()), -T::one());
        let (positions, rates) = (positions.solved(less, &mass)?, rates.solved(less, &mass)?);
        Ok((ByStateAfloat { positions, rates }, Blocks::one().solved(T::one(), &mass)?))
    }
}
