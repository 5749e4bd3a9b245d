//! A spring and damper along one coordinate.

use super::body::not_negative;
use crate::element::{Reading, Springs};
use crate::error::Fault;
use crate::lift::Lift;
use crate::relation::{Absent, Coefficient, Part, Term};
use crate::scalar::{Real, Scalar};
use num_traits::Zero;

/// A linear spring, and damping and rest value where there are any: the force on the outboard side is −k (u − u₀) − c u̇ with the
/// coordinate u of the joint. For an angle the force is a torque (N·m) and the units are N·m/rad, N·m·s/rad and rad; for a
/// displacement they are N/m, N·s/m and m.
///
/// ```
/// use catena::planar::Spring;
/// let spring = Spring::new(200.0).damped(0.5).resting_at(0.1); // stiffness, damping, rest value
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring<T, D = Absent, P = Absent> {
    stiffness: T,
    damping: D,
    rest: P,
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

impl<T: Scalar, D> Spring<T, D, Absent> {
    /// At rest where the coordinate has this value.
    pub fn resting_at(self, rest: T) -> Spring<T, D, T> {
        Spring { stiffness: self.stiffness, damping: self.damping, rest }
    }
}

impl<T: Scalar, D: Coefficient<T>> Spring<T, D> {
    /// A spring and a damper in proportion to it, by a time (s).
    pub(super) fn proportional(stiffness: T, time: D) -> Self {
        Self { stiffness, damping: time.times(stiffness), rest: Absent }
    }
}

impl<T: Scalar, D: Copy, P> Spring<T, D, P> {
    /// The same with the rest value zero: how its force changes.
    #[inline(always)]
    pub(super) fn unstrained(&self) -> Spring<T, D> {
        Spring { stiffness: self.stiffness, damping: self.damping, rest: Absent }
    }
}

/// What acts along a coordinate of a joint: a [`Spring`], nothing, or a law of the user's own.
///
/// Explicit rules read its force. Implicit ones take it linearly implicitly, from its force and slopes where the last sweep has led: a
/// law that is not linear is met as well as one that is, and rules keep their order where it is smooth. Slopes should not be negative
/// by much: a step must resolve what they drive apart.
///
/// ```
/// use catena::element::Springs;
/// use catena::planar::*;
/// use catena::relation::Part;
/// use catena::{Fault, Scalar};
///
/// /// A stop that a coordinate meets at `at`: a stiff spring and a damper beyond, nothing before.
/// #[derive(Clone, Copy, Debug)]
/// struct Stop {
///     at: f64,
///     stiffness: f64,
///     damping: f64,
/// }
///
/// impl Part for Stop {
///     fn is_finite(self) -> bool {
///         [self.at, self.stiffness, self.damping].iter().all(|x| x.is_finite())
///     }
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
///         if self.is_finite() { Ok(()) } else { Err(Fault::NotFinite { parameter: "stop" }) }
///     }
/// }
///
/// let (rod, stop) = (Rod::uniform(0.5, 1.0), Stop { at: 0.5, stiffness: 1e5, damping: 20.0 });
/// let leg = System::new(Pinned::origin(), (rod, ElasticHinge::with(stop), rod), Free)?.with_gravity(9.81);
/// let start = leg.at_rest(&[0.0, 0.4])?; // the hinge by 0.4 rad, which is free
/// let run = leg.simulate(start, Sdirk4::new().tolerance(1e-6), 1.0, |_| ())?;
/// # Ok::<(), catena::Error>(())
/// ```
pub trait SpringLaw<T: Scalar>: Part {
    /// Whether force is affine in position and rate: then slopes are the same everywhere, and nothing has to be read twice.
    const LINEAR: bool = false;

    /// Force on the outboard side (N·m, N).
    fn force(&self, position: T, rate: T) -> T;
    /// Energy stored (J).
    fn energy(&self, position: T) -> T;
    /// What it adds to the pivot of its coordinate: `springs.pivot(k, c)`, for the slopes there, k = −∂force/∂position and
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
#[inline(always)]
pub(super) fn read<T: Scalar, L: SpringLaw<T>, K: Springs<T>>(
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

impl<T: Scalar, D: Coefficient<T>, P: Term<T>> Part for Spring<T, D, P> {
    fn is_finite(self) -> bool {
        Scalar::is_finite(self.stiffness) && self.damping.is_finite() && self.rest.is_finite()
    }
}

impl<T: Scalar, D: Coefficient<T>, P: Term<T>> SpringLaw<T> for Spring<T, D, P> {
    const LINEAR: bool = true;

    #[inline(always)]
    fn force(&self, position: T, rate: T) -> T {
        let strain = self.rest.take_from(position);
        self.damping.times_onto(-rate, -(self.stiffness * strain))
    }
    fn energy(&self, position: T) -> T {
        let strain = self.rest.take_from(position);
        (self.stiffness * strain * strain).scale(T::Real::of(0.5))
    }
    #[inline(always)]
    fn pivot(&self, _: T, _: T, springs: impl Springs<T>) -> T {
        springs.pivot(self.stiffness, self.damping)
    }
    fn check(&self) -> Result<(), Fault> {
        let none = T::Real::zero();
        not_negative("stiffness", self.stiffness, none)?;
        not_negative("damping", self.damping.times_onto(T::one(), T::zero()), none)?;
        if self.rest.is_finite() { Ok(()) } else { Err(Fault::NotFinite { parameter: "rest value" }) }
    }
}

impl<T: Scalar, U: Scalar, D: Lift<T, U>, P: Lift<T, U>> Lift<T, U> for Spring<T, D, P> {
    type Over = Spring<U, D::Over, P::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        let Self { stiffness, damping, rest } = self;
        Spring { stiffness: stiffness.lift(number), damping: damping.lift(number), rest: rest.lift(number) }
    }
}

/// A law of the user's own about the axis of a hinge: see [`ElasticHinge::with`](super::ElasticHinge::with).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Custom<L>(pub L);

impl<L: Part> Part for Custom<L> {
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
}

impl<T: Scalar, L: SpringLaw<T>> SpringLaw<T> for Custom<L> {
    const LINEAR: bool = L::LINEAR;

    #[inline(always)]
    fn force(&self, position: T, rate: T) -> T {
        self.0.force(position, rate)
    }
    fn energy(&self, position: T) -> T {
        self.0.energy(position)
    }
    #[inline(always)]
    fn pivot(&self, position: T, rate: T, springs: impl Springs<T>) -> T {
        self.0.pivot(position, rate, springs)
    }
    fn check(&self) -> Result<(), Fault> {
        self.0.check()
    }
}

impl<T: Scalar, U: Scalar, L: Lift<T, U>> Lift<T, U> for Custom<L> {
    type Over = Custom<L::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Custom(self.0.lift(number))
    }
}
