//! Laws along single coordinates of joints, in the plane and in space: springs, dampers, friction, stops, motors.

mod compression;
mod custom;
mod friction;
mod motor;
mod several;
mod stops;

pub(crate) use compression::{Compression, above};
pub use custom::Custom;
pub use friction::DryFriction;
pub use motor::Motor;
pub use stops::Stops;

use crate::element::{Reading, Springs};
use crate::error::Fault;
use crate::error::checks::not_negative;
use crate::lift::lift;
use crate::relation::{Absent, Coefficient, Term};
use crate::scalar::{Real, Scalar};
use core::fmt::Debug;

/// A linear spring and damper: stiffness, damping and rest value, as far as there are any. The force on the outboard side is
/// −k (u − u₀) − c u̇ with the coordinate u of the joint. For an angle the force is a torque (N·m) and the units are N·m/rad, N·m·s/rad
/// and rad; for a displacement they are N/m, N·s/m and m.
///
/// ```
/// use catena::spatial::{Revolute, Spring};
/// let spring = Spring::new(200.0).damped(0.5).resting_at(0.1); // stiffness, damping, rest value
/// let hinge = Revolute::about([0.0, 0.0, 1.0]).with(spring);
/// assert_eq!(size_of_val(&Spring::none()), 0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spring<K = Absent, D = Absent, P = Absent> {
    pub(crate) stiffness: K,
    pub(crate) damping: D,
    pub(crate) rest: P,
}

impl Spring {
    /// Nothing.
    pub const fn none() -> Self {
        Self { stiffness: Absent, damping: Absent, rest: Absent }
    }
    /// A spring of a stiffness: [`Spring::new`] by another name.
    pub fn stiffness<T: Scalar>(stiffness: T) -> Spring<T> {
        Spring::new(stiffness)
    }
    /// A damper alone.
    pub fn damping<T: Scalar>(damping: T) -> Spring<Absent, T> {
        Spring { stiffness: Absent, damping, rest: Absent }
    }
}

impl<T: Scalar> Spring<T> {
    /// A spring of a stiffness, zero or more.
    pub fn new(stiffness: T) -> Self {
        Self { stiffness, damping: Absent, rest: Absent }
    }
}

impl<T: Scalar, P> Spring<T, Absent, P> {
    /// With a damper.
    pub fn damped(self, damping: T) -> Spring<T, T, P> {
        Spring { stiffness: self.stiffness, damping, rest: self.rest }
    }
}

impl<T: Scalar, D> Spring<T, D> {
    /// At rest where the coordinate has this value.
    pub fn resting_at(self, rest: T) -> Spring<T, D, T> {
        Spring { stiffness: self.stiffness, damping: self.damping, rest }
    }
}

impl<T: Scalar, D: Coefficient<T>> Spring<T, D> {
    /// A spring and a damper in proportion to it, by a time (s).
    pub(crate) fn proportional(stiffness: T, time: D) -> Self {
        Self { stiffness, damping: time.times(stiffness), rest: Absent }
    }
}

/// What acts along a coordinate of a joint: a [`Spring`], [`DryFriction`], [`Stops`], nothing, a law of the user's own, or several of
/// them as a tuple.
///
/// Explicit rules read its force. Implicit ones take it linearly implicitly, from its force and slopes where the last sweep has led: a
/// law that is not linear is met as well as one that is, and rules keep their order where it is smooth. Slopes should not be negative
/// by much: a step must resolve what they drive apart.
///
/// ```
/// use catena::planar::*;
/// use catena::Fault;
///
/// /// A stop that a coordinate meets at `at`: a stiff spring and a damper beyond, nothing before.
/// #[derive(Clone, Copy, Debug)]
/// struct Stop {
///     at: f64,
///     stiffness: f64,
///     damping: f64,
/// }
///
/// impl SpringLaw<f64> for Stop {
///     fn force(&self, position: f64, rate: f64) -> f64 {
///         if position > self.at { -self.stiffness * (position - self.at) - self.damping * rate } else { 0.0 }
///     }
///     fn energy(&self, position: f64) -> f64 {
///         0.5 * self.stiffness * (position - self.at).max(0.0).powi(2)
///     }
///     fn pivot(&self, position: f64, _: f64, springs: impl Springs<f64>) -> f64 {
///         if position > self.at { springs.pivot(self.stiffness, self.damping) } else { 0.0 }
///     }
///     fn check(&self) -> Result<(), Fault> {
///         let finite = [self.at, self.stiffness, self.damping].iter().all(|x| x.is_finite());
///         if finite { Ok(()) } else { Err(Fault::NotFinite { parameter: "stop" }) }
///     }
/// }
///
/// let (rod, stop) = (Rod::uniform(0.5, 1.0), Stop { at: 0.5, stiffness: 1e5, damping: 20.0 });
/// let leg = System::new(Pinned::origin(), (rod, ElasticHinge::with(stop), rod), Free)?.with_gravity(9.81);
/// let start = leg.at_rest(&[0.0, 0.4])?; // the hinge by 0.4 rad, which is free
/// let run = leg.simulate(start, Sdirk4::new().tolerance(1e-6), 1.0, |_| ())?;
/// # Ok::<(), catena::Error>(())
/// ```
///
/// And in space, for numbers of any type:
///
/// ```
/// use catena::spatial::*;
/// use catena::{Fault, Scalar};
///
/// /// A spring that stiffens: −k (φ + φ³), with a damper.
/// #[derive(Clone, Copy, Debug)]
/// struct Stiffening<T> {
///     stiffness: T,
///     damping: T,
/// }
///
/// impl<T: Scalar> SpringLaw<T> for Stiffening<T> {
///     fn force(&self, position: T, rate: T) -> T {
///         -self.stiffness * (position + position * position * position) - self.damping * rate
///     }
///     fn energy(&self, position: T) -> T {
///         let square = position * position;
///         self.stiffness * square * (T::literal(0.5) + T::literal(0.25) * square)
///     }
///     fn pivot(&self, position: T, _: T, springs: impl Springs<T>) -> T {
///         let slope = self.stiffness * (T::one() + T::literal(3.0) * position * position);
///         springs.pivot(slope, self.damping)
///     }
///     fn check(&self) -> Result<(), Fault> {
///         if self.stiffness.is_finite() { Ok(()) } else { Err(Fault::NotFinite { parameter: "stiffness" }) }
///     }
/// }
///
/// let rod = Rod::uniform(0.5, 0.05, 1.0);
/// let hinge = Revolute::about([0.0, 0.0, 1.0]).with(Stiffening { stiffness: 200.0, damping: 0.5 });
/// let arm = System::new(Clamped::origin(), (hinge, rod, hinge, rod), Free)?.with_gravity([0.0, 0.0, -9.81]);
/// let run = arm.simulate(arm.at_rest(&[0.3, -0.2])?, Sdirk4::new().step(0.01), 0.5, |_| ())?;
/// # Ok::<(), catena::Error>(())
/// ```
pub trait SpringLaw<T: Scalar>: Copy + Debug + 'static {
    /// Whether there is a law at all: one that is [`Absent`] is asked nothing.
    #[doc(hidden)]
    const ON: bool = true;
    /// Whether force is affine in position and rate: then slopes are the same everywhere, and nothing has to be read twice.
    const LINEAR: bool = false;
    /// Whether force is one analytic function of position and rate, made of products, powers, sines and the like, without cases: then
    /// [`Taylor`](crate::time::Taylor) knows its series.
    const ANALYTIC: bool = Self::LINEAR;

    /// Force on the outboard side (N·m, N).
    fn force(&self, position: T, rate: T) -> T;
    /// Energy stored (J).
    fn energy(&self, position: T) -> T;
    /// What the law adds to the pivot of its coordinate: `springs.pivot(k, c)`, for the slopes there, k = −∂force/∂position and
    /// c = −∂force/∂rate.
    fn pivot(&self, position: T, rate: T, springs: impl Springs<T>) -> T;
    /// Rejects parameters that make no mechanics.
    ///
    /// # Errors
    /// What is wrong with them.
    fn check(&self) -> Result<(), Fault>;
}

/// The force of a law and what it adds to the pivot in a sweep: force plus pivot times the acceleration that led there, less which
/// times the one sought. A law that is not linear is read where the last sweep has led, any other at position and rate without the
/// acceleration sought.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn read<T: Scalar, L: SpringLaw<T>, K: Springs<T>>(
    law: &L,
    (position, rate): (T, T),
    led: Reading<'_, T, T>,
    springs: K,
) -> [T; 2] {
    if const { L::LINEAR || !K::STIFF } {
        return [law.force(position, rate), law.pivot(position, rate, springs)];
    }
    let (position, rate) = (*led.position, *led.rate);
    let pivot = law.pivot(position, rate, springs);
    [pivot.mul_add(*led.acceleration, law.force(position, rate)), pivot]
}

impl<T: Scalar> SpringLaw<T> for Absent {
    const ON: bool = false;
    const LINEAR: bool = true;

    #[inline(always)]
    fn force(&self, _: T, _: T) -> T {
        T::zero()
    }
    fn energy(&self, _: T) -> T {
        T::zero()
    }
    #[inline(always)]
    fn pivot(&self, _: T, _: T, _: impl Springs<T>) -> T {
        T::zero()
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

impl<T: Scalar, K: Coefficient<T>, D: Coefficient<T>, P: Term<T>> SpringLaw<T> for Spring<K, D, P> {
    const LINEAR: bool = true;

    #[inline(always)]
    fn force(&self, position: T, rate: T) -> T {
        self.damping.times_onto(-rate, self.stiffness.against(self.rest.take_from(position)))
    }
    fn energy(&self, position: T) -> T {
        let strain = self.rest.take_from(position);
        (self.stiffness.times_onto(strain, T::zero()) * strain).scale(T::Real::of(0.5))
    }
    #[inline(always)]
    fn pivot(&self, _: T, _: T, springs: impl Springs<T>) -> T {
        springs.pivot(self.stiffness, self.damping)
    }
    fn check(&self) -> Result<(), Fault> {
        not_negative("stiffness", self.stiffness.times_onto(T::one(), T::zero()))?;
        not_negative("damping", self.damping.times_onto(T::one(), T::zero()))?;
        if self.rest.is_finite() { Ok(()) } else { Err(Fault::NotFinite { parameter: "rest value" }) }
    }
}

lift!(Spring<K, D, P> { stiffness, damping, rest });
