//! Electric motors: what torque they can give.

use super::above;
use crate::error::Fault;
use crate::error::checks::{not_negative, positive};
use crate::lift::lift;
use crate::scalar::Scalar;

/// An electric motor behind a gear: how much of a torque asked for it gives at a speed. All numbers but the ratio are those of the motor's
/// own shaft.
///
/// The torque is at most `peak`, and where it drives at most `stall` (1 − v/`free`), which falls to zero at the free speed: beyond that
/// the motor can only brake, by its peak torque or less.
///
/// It is no law of a joint: a law knows position and rate, not what is asked for. Give what comes of it as a load (a value for each
/// joint, [`Loads::efforts`](crate::loading::Loads::efforts), or a function of the motion,
/// [`Loads::in_joints`](crate::loading::Loads::in_joints)), so that derivatives and readings know it as they know any load; and the
/// [reflected inertia](Self::reflected_inertia) to the joint. A joint in [body axes](crate::robot) takes it as `geared`.
///
/// Implicit rules read it at the motion predicted, as any load. The torque is continuous, its slope is not at the limits: rules of any
/// order meet these with order two, as steps of a controller do, unless a run ends steps at the [`kinks`](Self::kinks).
///
/// ```
/// use catena::planar::Motor;
/// let motor = Motor::new(2.0, 300.0).stalling_at(3.0).geared(50.0).with_rotor(1e-4); // (N·m), (rad/s), (kg·m²)
/// assert_eq!(motor.torque(70.0, 1.0), 70.0); // 1.4 of 2 N·m
/// assert_eq!(motor.torque(400.0, 1.0), 100.0); // its peak
/// assert_eq!(motor.torque(400.0, 5.0), 25.0); // 250 rad/s leave a sixth of 3 N·m
/// assert_eq!(motor.torque(-400.0, 5.0), -100.0); // it brakes as well as ever
/// assert_eq!(motor.reflected_inertia(), 0.25);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Motor<T> {
    peak: T,
    stall: T,
    free: T,
    ratio: T,
    rotor: T,
}

impl<T: Scalar> Motor<T> {
    /// Of a peak torque (N·m) and a free speed (rad/s), without gear; it stalls at its peak torque.
    pub fn new(peak: T, free: T) -> Self {
        Self { peak, stall: peak, free, ratio: T::one(), rotor: T::zero() }
    }

    /// With a torque (N·m) that it would give at rest without the limit of its peak.
    #[must_use]
    pub fn stalling_at(self, torque: T) -> Self {
        Self { stall: torque, ..self }
    }

    /// With a gear: turns of the motor a turn of the joint; for a slide rad/m.
    #[must_use]
    pub fn geared(self, ratio: T) -> Self {
        Self { ratio, ..self }
    }

    /// With the inertia of a rotor (kg·m²).
    #[must_use]
    pub fn with_rotor(self, inertia: T) -> Self {
        Self { rotor: inertia, ..self }
    }

    /// Torque in the joint (N·m, N) that the motor gives of the one that is wanted there, at a rate of the joint (rad/s, m/s). Both must
    /// be finite, and [`check`](Self::check) is the caller's to ask: no scene knows the motor.
    pub fn torque(&self, wanted: T, rate: T) -> T {
        let [forward, backward] = self.limits(rate * self.ratio / self.free);
        least(forward, -least(backward, -wanted))
    }

    /// Functions that are zero where the torque has a kink, for [`Simulation::kinks`](crate::simulate::Simulation::kinks): where the limit of
    /// either sign is reached or left, where that limit begins to fall with speed, and where it is nothing.
    ///
    /// ```
    /// use catena::planar::*;
    /// // A wheel (kg·m²) under a torque that grows (N·m/s): limited from 1 s on, and from 2 s on as its speed allows.
    /// let motor = Motor::new(2.0, 6.0).stalling_at(4.0);
    /// let wanted = |time: f64| 2.0 * time;
    /// let wheel = System::new(Pinned::origin(), RigidBody::new(1.0, 1.0, [0.0; 2], [0.0; 2]), Free)?;
    /// let loads = Loads::none().in_joints(|time, _, motion: &JointMotion<f64>| motor.torque(wanted(time), motion.rate()));
    /// let run = wheel.simulation(Dop853::step(0.3)).loads(&loads).kinks(|now| {
    ///     let (rate, ()) = *now.stepped().rate();
    ///     motor.kinks(wanted(now.time()), rate)
    /// });
    /// let end = run.run(wheel.motion(), 3.0, |_| ())?.motion;
    /// let exact = 6.0 - 3.0 * (-2.0 / 3.0 * 1.0_f64).exp(); // (rad/s)
    /// assert!((end.rate().0 - exact).abs() < 1e-9);
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn kinks(&self, wanted: T, rate: T) -> [T; 6] {
        let share = rate * self.ratio / self.free;
        let ([forward, backward], one) = (self.limits(share), T::one());
        let falling = one - self.peak / self.stall;
        [wanted - forward, wanted + backward, share - falling, share + falling, share - one, share + one]
    }

    /// How much torque in the joint (N·m, N) it gives at most, forward and backward, at a share of the free speed.
    fn limits(&self, share: T) -> [T; 2] {
        let bound = |left: T| above(least(self.peak, self.stall * left)) * self.ratio;
        [bound(T::one() - share), bound(T::one() + share)]
    }

    /// Inertia of the rotor as the joint feels it (kg·m², kg): times the square of the ratio.
    pub fn reflected_inertia(&self) -> T {
        self.rotor * self.ratio * self.ratio
    }

    /// Rejects numbers that make no motor.
    ///
    /// # Errors
    /// [`Fault::NotPositive`], [`Fault::NotFinite`], [`Fault::Negative`].
    pub fn check(&self) -> Result<(), Fault> {
        positive("peak torque of a motor", self.peak)?;
        positive("stall torque of a motor", self.stall)?;
        positive("free speed of a motor", self.free)?;
        positive("ratio of a gear", self.ratio)?;
        not_negative("inertia of a rotor", self.rotor)
    }
}

/// A limit or what is less, without a branch: the limit itself, to a rounding, however large the other one is.
#[inline(always)]
fn least<T: Scalar>(limit: T, other: T) -> T {
    limit - above(limit - other)
}

lift!(Motor { peak, stall, free, ratio, rotor });
