//! Derivatives of inverse and forward dynamics by positions, rates and torques.

use super::snapshot::Factor;
use super::{FixedBase, S, Tasks, finite};
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::mechanics::spatial::body_axes::inverse::Slopes;
use crate::scalar::Scalar;
use crate::shape::Takes;
use crate::system::System;

/// Derivatives of a list by positions and by rates: entry `[i][k]` is that of number i by coordinate k.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByState<T, const N: usize> {
    /// By positions.
    pub positions: [[T; N]; N],
    /// By rates.
    pub rates: [[T; N]; N],
}

impl<T: Scalar, const N: usize> ByState<T, N> {
    /// Zeros.
    pub fn zero() -> Self {
        Self { positions: [[T::zero(); N]; N], rates: [[T::zero(); N]; N] }
    }

    /// Puts derivatives of a number by a position and a rate.
    #[inline(always)]
    fn putting(&mut self) -> impl FnMut(usize, usize, [T; 2]) {
        |i, k, [position, rate]| (self.positions[i][k], self.rates[i][k]) = (position, rate)
    }

    /// Adds stiffnesses and dampings of laws.
    #[inline(always)]
    fn adding(&mut self) -> impl FnMut(usize, [T; 2]) {
        |k, [stiffness, damping]| {
            self.positions[k][k] += stiffness;
            self.rates[k][k] += damping;
        }
    }

    /// Refuses numbers that are not finite.
    fn all_finite(&self) -> Result<(), Error> {
        finite(self.positions.as_flattened()).and(finite(self.rates.as_flattened()))
    }
}

impl<T: Scalar, R: Root<S<T>>, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, R, C, P> {
    /// What laws of the joints add to derivatives of torques, by positions and rates.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn stiffened<const N: usize>(&self, q: &[T; N], v: &[T; N], mut add: impl FnMut(usize, [T; 2]))
    where
        C: Tasks<T, N>,
    {
        let mut walk = Slopes { positions: *q, rates: *v, slopes: [[T::zero(); 2]; N], next: 0 };
        Takes::<S<T>, Slopes<T, N>>::take(self.chain(), &mut walk, (), ());
        walk.slopes.into_iter().enumerate().for_each(|(k, slopes)| add(k, slopes));
    }

    /// Derivatives of [`inverse_dynamics`](Self::inverse_dynamics) by positions and rates, with springs and dampers of the joints, by the
    /// slopes that their laws [say](crate::robot::SpringLaw::pivot); those by accelerations are the mass matrix. Exact, in one pass outward and
    /// one inward, and a few products for each pair of joints of which one carries the other.
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics).
    pub fn inverse_dynamics_derivatives<const N: usize>(
        &self,
        q: &[T; N],
        v: &[T; N],
        seconds: &[T; N],
    ) -> Result<ByState<T, N>, Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        let now = self.snapshot(q, v)?;
        let mut by = ByState::zero();
        now.partials(&mut now.moved(), (&[T::zero(); 6], seconds), |i, partial, carrying| {
            now.pairs(i, partial, carrying, by.putting());
        });
        self.stiffened(q, v, by.adding());
        by.all_finite()?;
        Ok(by)
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
    pub fn forward_dynamics_derivatives<const N: usize>(
        &self,
        q: &[T; N],
        v: &[T; N],
        torques: &[T; N],
    ) -> Result<(ByState<T, N>, [[T; N]; N]), Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        let mut found = (ByState::zero(), [[T::zero(); N]; N]);
        self.forward_dynamics_derivatives_into(q, v, torques, &mut found).map(|()| found)
    }

    /// [`forward_dynamics_derivatives`](Self::forward_dynamics_derivatives) into a place that is kept from call to call. What the place holds is
    /// overwritten.
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics); what is in the place then is of no use.
    pub fn forward_dynamics_derivatives_into<const N: usize>(
        &self,
        q: &[T; N],
        v: &[T; N],
        torques: &[T; N],
        (by, by_torques): &mut (ByState<T, N>, [[T; N]; N]),
    ) -> Result<(), Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        let (mut now, mut matrix) = (self.snapshot(q, v)?, [[T::zero(); N]; N]);
        // In axes of bodies M has all digits where a last link has little inertia; about the origin of screws these cancel.
        self.mass_matrix_into(q, &mut matrix)?;
        if const { R::RESTS } {
            now.about_the_lightest(|k| matrix[k][k]);
        }
        let mut moved = now.moved();
        // Joints of which neither carries the other.
        for rows in [&mut by.positions, &mut by.rates, &mut *by_torques] {
            rows.as_flattened_mut().fill(T::zero());
        }
        let (bias, _) = now.bias(&moved, |_, _| ());
        let mass = Factor::of(&mut matrix, now.parents());
        let mut seconds: [_; N] = core::array::from_fn(|k| [torques[k] - bias[k]]);
        mass.solve(T::one(), &mut seconds);
        now.partials(&mut moved, (&[T::zero(); 6], &seconds.map(|[x]| x)), |i, partial, carrying| {
            now.pairs(i, partial, carrying, by.putting());
        });
        self.stiffened(q, v, by.adding());
        mass.solve_joints(-T::one(), &mut by.positions);
        mass.solve_joints(-T::one(), &mut by.rates);
        mass.inverse(by_torques);
        by.all_finite().and(finite(by_torques.as_flattened()))
    }
}
