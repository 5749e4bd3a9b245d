//! A spring and damper along one coordinate.

use super::body::not_negative;
use crate::element::Springs;
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

/// What acts along a coordinate of a joint: a [`Spring`], or nothing.
pub trait SpringLaw<T: Scalar>: Part {
    /// Force on the outboard side.
    fn force(&self, position: T, rate: T) -> T;
    /// Energy stored (J).
    fn energy(&self, position: T) -> T;
    /// What it adds to the pivot of its coordinate.
    fn pivot(&self, springs: impl Springs<T>) -> T;
    /// Rejects parameters that make no mechanics.
    ///
    /// # Errors
    /// What is wrong with them.
    fn check(&self) -> Result<(), Fault>;
}

impl<T: Scalar> SpringLaw<T> for Absent {
    #[inline(always)]
    fn force(&self, _: T, _: T) -> T {
        T::zero()
    }
    fn energy(&self, _: T) -> T {
        T::zero()
    }
    #[inline(always)]
    fn pivot(&self, _: impl Springs<T>) -> T {
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
    fn pivot(&self, springs: impl Springs<T>) -> T {
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
