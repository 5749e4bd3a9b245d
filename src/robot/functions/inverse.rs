//! Inverse dynamics of lists: torques of joints from accelerations, or from none.

use super::{FixedBase, S, Tasks, finite, resisting};
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::mechanics::spatial::Frame;
use crate::mechanics::spatial::body_axes::Stand;
use crate::mechanics::spatial::body_axes::inverse::{Carried, Carrying as Load, Loaded};
use crate::scalar::Scalar;
use crate::shape::Takes;
use crate::system::System;
use nalgebra::Vector3;
use num_traits::Zero;

impl<T: Scalar, R: Root<S<T>>, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, R, C, P> {
    /// The ground in axes of the robot's base, as it is felt: what gravity takes, if only that is asked for, or acceleration less gravity,
    /// angular velocity and acceleration.
    fn felt(&self, resting: bool) -> Carried<T> {
        let Frame { turn, acceleration, .. } = self.ground(T::Real::zero());
        let of = |vector: Vector3<T>| turn.attitude.transposed(vector).into();
        let still = [T::zero(); 3];
        let (linear, spin, angular) = match resting {
            true => (of(-self.gravity()), still, still),
            false => (of(acceleration.linear - self.gravity()), of(turn.spin), of(acceleration.angular)),
        };
        Carried { spin, linear, angular, own: usize::MAX }
    }

    /// Forces of joints on a ground.
    #[cfg_attr(optimised, inline(always))]
    fn forces<const N: usize, const RATES: bool, const SECONDS: bool>(
        &self,
        ground: Carried<T>,
        stands: &[Stand<T>; N],
        rates: &[T; N],
        seconds: &[T; N],
    ) -> [T; N]
    where
        C: Tasks<T, N> + Takes<S<T>, Loaded<T, N, RATES, SECONDS>>,
    {
        let still = [T::zero(); 3];
        let mut out = Loaded::<T, N, RATES, SECONDS> {
            stands: *stands,
            rates: *rates,
            seconds: *seconds,
            loads: [[still; 2]; N],
            next: 0,
        };
        Takes::<S<T>, Loaded<T, N, RATES, SECONDS>>::take(self.chain(), &mut out, ground, ());
        let mut inward = Load { stands: *stands, loads: out.loads, forces: [T::zero(); N], next: N };
        Takes::<S<T>, Load<T, N>>::take(self.chain(), &mut inward, [still; 2], ());
        inward.forces
    }

    /// Torques (N·m, N) of the joints that cause accelerations q̈ at positions and rates: with gravity, less what springs and dampers of
    /// the joints do, with reflected inertias.
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics).
    pub fn inverse_dynamics<const N: usize>(&self, q: &[T; N], v: &[T; N], seconds: &[T; N]) -> Result<[T; N], Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        let own = resisting(self.chain(), q, v);
        let mut forces = self.forces::<N, true, true>(self.felt(false), &own.stands, v, seconds);
        for (k, force) in forces.iter_mut().enumerate() {
            *force = own.inertias[k].mul_add(seconds[k], *force) - own.laws[k];
        }
        finite(&forces).map(|()| forces)
    }

    /// Torques (N·m, N) that keep all joints from accelerating at positions and rates: C q̇ + g, less what springs and dampers do. So
    /// M q̈ = τ − bias.
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics).
    pub fn bias<const N: usize>(&self, q: &[T; N], v: &[T; N]) -> Result<[T; N], Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        let own = resisting(self.chain(), q, v);
        let mut forces = self.forces::<N, true, false>(self.felt(false), &own.stands, v, v);
        forces.iter_mut().zip(own.laws).for_each(|(force, law)| *force -= law);
        finite(&forces).map(|()| forces)
    }

    /// Torques (N·m, N) that hold the robot at rest against gravity, without springs, on a ground that rests.
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics).
    pub fn gravity_torques<const N: usize>(&self, q: &[T; N]) -> Result<[T; N], Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        let own = resisting(self.chain(), q, q);
        let forces = self.forces::<N, false, false>(self.felt(true), &own.stands, q, q);
        finite(&forces).map(|()| forces)
    }
}
