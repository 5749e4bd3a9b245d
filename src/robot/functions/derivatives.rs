//! Derivatives of inverse and forward dynamics by positions, rates and torques.

use super::{FixedBase, S, Tasks};
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::lift::Lift;
use crate::scalar::{Jet, Scalar};
use crate::system::System;

/// Derivatives of a list by positions and by rates: entry `[i][k]` is that of number i by coordinate k.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByState<T, const N: usize> {
    /// By positions.
    pub positions: [[T; N]; N],
    /// By rates.
    pub rates: [[T; N]; N],
}

impl<T: Scalar, R: Root<S<T>>, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, R, C, P> {
    /// Derivatives of [`inverse_dynamics`](Self::inverse_dynamics) by positions and rates, with springs and dampers of the joints; those by
    /// accelerations are the mass matrix. Exact, by two passes over numbers with `N` derivatives each.
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics).
    #[allow(clippy::type_complexity)] // the scene over another number
    pub fn inverse_dynamics_derivatives<const N: usize>(
        &self,
        q: &[T; N],
        v: &[T; N],
        seconds: &[T; N],
    ) -> Result<ByState<T, N>, Error>
    where
        R: FixedBase<T> + Lift<T, Jet<T, N>, Over: FixedBase<Jet<T, N>>>,
        C: Lift<T, Jet<T, N>, Over: Tasks<Jet<T, N>, N>>,
        P: Lift<T, Jet<T, N>, Over: Tip<S<Jet<T, N>>>>,
    {
        self.has_joints(N)?;
        let over = self.lift(Jet::of);
        let plain = |list: &[T; N]| list.map(Jet::of);
        let seeded = |list: &[T; N]| core::array::from_fn(|k| Jet::seed(list[k], k));
        let by = |forces: [Jet<T, N>; N]| forces.map(|force| force.eps);
        let (seconds, positions) = (plain(seconds), over.inverse_dynamics(&seeded(q), &plain(v), &plain(seconds))?);
        let rates = over.inverse_dynamics(&plain(q), &seeded(v), &seconds)?;
        Ok(ByState { positions: by(positions), rates: by(rates) })
    }

    /// Derivatives of [`forward_dynamics`](Self::forward_dynamics) by positions and rates, and by torques (the last one is M⁻¹): those of inverse
    /// dynamics at the accelerations found, times −M⁻¹ (J. Carpentier and N. Mansard, *Analytical derivatives of rigid body dynamics
    /// algorithms*, Robotics: Science and Systems 2018).
    ///
    /// ```
    /// use catena::robot::*;
    /// let link = Link::general(3.0_f64, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    /// let elbow = Hinge::at::<4>([0.0, 0.0, 0.4]).turned(Quarter::<30>).with(Spring::damping(0.5));
    /// let arm = System::new(Base::origin(), (Hinge::level().grounded(), link, elbow, link), Free)?;
    /// let (q, v, torques) = ([0.3, -0.4], [1.0, 0.5], [2.0, -1.0]);
    /// let (state, by_torques) = arm.forward_dynamics_derivatives(&q, &v, &torques)?;
    /// let [one, two] = [-1e-6, 1e-6].map(|d| arm.forward_dynamics(&[0.3, -0.4 + d], &v, &torques).unwrap());
    /// assert!((state.positions[0][1] - (two[0] - one[0]) / 2e-6).abs() < 1e-6);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics).
    #[allow(clippy::type_complexity)] // the scene over another number
    pub fn forward_dynamics_derivatives<const N: usize>(
        &self,
        q: &[T; N],
        v: &[T; N],
        torques: &[T; N],
    ) -> Result<(ByState<T, N>, [[T; N]; N]), Error>
    where
        R: FixedBase<T> + Lift<T, Jet<T, N>, Over: FixedBase<Jet<T, N>>>,
        C: Tasks<T, N> + Lift<T, Jet<T, N>, Over: Tasks<Jet<T, N>, N>>,
        P: Lift<T, Jet<T, N>, Over: Tip<S<Jet<T, N>>>>,
    {
        let seconds = self.forward_dynamics(q, v, torques)?;
        let ByState { positions, rates } = self.inverse_dynamics_derivatives(q, v, &seconds)?;
        let inverse = self.mass_inverse(q)?;
        let times = |by: &[[T; N]; N]| {
            core::array::from_fn(|i| {
                core::array::from_fn(|k| (0..N).fold(T::zero(), |sum, j| (-inverse[i][j]).mul_add(by[j][k], sum)))
            })
        };
        Ok((ByState { positions: times(&positions), rates: times(&rates) }, inverse))
    }
}
