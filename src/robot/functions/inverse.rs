//! Inverse dynamics of lists: torques of joints from accelerations, or from none.

use super::snapshot::six;
use super::{Afloat, FixedBase, S, Tasks, checked, finite, resisting};
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::mechanics::spatial::body_axes::Stand;
use crate::mechanics::spatial::body_axes::inverse::{Carried, Carrying as Load, Loaded, Resisting};
use crate::mechanics::spatial::{Frame, Free};
use crate::scalar::Scalar;
use crate::shape::Takes;
use crate::system::System;
use nalgebra::Vector3;
use num_traits::Zero;

/// Adds what reflected inertias take, less what laws exert.
#[inline(always)]
fn besides<T: Scalar, const N: usize>(own: &Resisting<T, N>, seconds: &[T; N], forces: &mut [T; N]) {
    for (k, force) in forces.iter_mut().enumerate() {
        *force = own.inertias[k].mul_add(seconds[k], *force) - own.laws[k];
    }
}

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

    /// Forces of joints on a ground or a base, and what all that is on it takes of that (force, and torque about its origin), in its axes.
    #[cfg_attr(optimised, inline(always))]
    fn forces<const N: usize, const RATES: bool, const SECONDS: bool>(
        &self,
        ground: Carried<T>,
        stands: &[Stand<T>; N],
        rates: &[T; N],
        seconds: &[T; N],
    ) -> ([T; N], [[T; 3]; 2])
    where
        C: Tasks<T, N> + Takes<S<T>, Loaded<T, N, RATES, SECONDS>>,
    {
        let still = [T::zero(); 3];
        let mut out = Loaded::<T, N, RATES, SECONDS> {
            stands: *stands,
            rates: *rates,
            seconds: *seconds,
            loads: [[still; 2]; N],
            base: [still; 2],
            next: 0,
        };
        Takes::<S<T>, Loaded<T, N, RATES, SECONDS>>::take(self.chain(), &mut out, ground, ());
        let mut inward = Load { stands: *stands, loads: out.loads, forces: [T::zero(); N], next: N };
        let [force, torque] = Takes::<S<T>, Load<T, N>>::take(self.chain(), &mut inward, [still; 2], ());
        let with = |sum: [T; 3], more: [T; 3]| core::array::from_fn(|k| sum[k] + more[k]);
        (inward.forces, [with(out.base[0], force), with(out.base[1], torque)])
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
        let (mut forces, _) = self.forces::<N, true, true>(self.felt(false), &own.stands, v, seconds);
        besides(&own, seconds, &mut forces);
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
        let (mut forces, _) = self.forces::<N, true, false>(self.felt(false), &own.stands, v, v);
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
        let (forces, _) = self.forces::<N, false, false>(self.felt(true), &own.stands, q, q);
        finite(&forces).map(|()| forces)
    }
}

impl<T: Scalar, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, Free, C, P> {
    /// What accelerations take of a robot whose base floats, with gravity: a force on the base (N, inertial axes) with a torque about its
    /// origin (N·m, its axes), and torques (N·m, N) of the joints, less what their laws exert, with reflected inertias. Accelerations of the
    /// base are those of its velocity in inertial axes and of its angular velocity in its own.
    ///
    /// ```
    /// use catena::robot::*;
    /// let link = Link::general(3.0_f64, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    /// let legs = [Branch((Hinge::at::<7>([0.3, 0.2, -0.1]), link)), Branch((Hinge::at::<7>([-0.3, 0.2, -0.1]), link))];
    /// let robot = System::new(Free, (BodyAxes, link, legs), Free)?.with_gravity([0.0, 0.0, -9.81]);
    /// let base = Afloat::of(robot.body_motions(&robot.motion())?.get(0).unwrap());
    /// // What holds it at rest is its weight.
    /// let (of_base, _) = robot.inverse_dynamics_afloat(base, &[0.3, -0.2], &[0.0; 2], &[0.0; 6], &[0.0; 2])?;
    /// assert!((of_base[2] - 3.0 * 3.0 * 9.81).abs() < 1e-12);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics); [`Fault::NotZero`](crate::Fault::NotZero) for a base whose axes are not orthonormal and
    /// right-handed.
    pub fn inverse_dynamics_afloat<const N: usize>(
        &self,
        base: Afloat<T>,
        q: &[T; N],
        v: &[T; N],
        of_base: &[T; 6],
        seconds: &[T; N],
    ) -> Result<([T; 6], [T; N]), Error>
    where
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        checked(&base.place)?;
        finite(base.velocity.as_slice())?;
        let attitude = base.place.attitude;
        let [ax, ay, az, angular @ ..] = *of_base;
        let felt = attitude.transposed(Vector3::new(ax, ay, az) - self.gravity());
        let carried = Carried { spin: base.spin.into(), linear: felt.into(), angular, own: usize::MAX };
        let own = resisting(self.chain(), q, v);
        let (mut torques, [force, torque]) = self.forces::<N, true, true>(carried, &own.stands, v, seconds);
        besides(&own, seconds, &mut torques);
        let wrench = six([attitude.apply(force.into()), torque.into()]);
        finite(&wrench).and(finite(&torques)).map(|()| (wrench, torques))
    }
}
