//! Springs and dampers of single coordinates.

use super::inertia::not_negative;
use crate::element::{Explicit, Implicit, Springs};
use crate::error::Fault;
use crate::lift::Lift;
use crate::relation::{Absent, Coefficient, Term};
use crate::scalar::{Real, Scalar};
use core::fmt::Debug;

/// A linear spring and damper on a coordinate of a joint: stiffness, damping and rest value, as far as there are any.
///
/// ```
/// use catena::spatial::{Revolute, Spring};
/// let hinge = Revolute::about([0.0, 0.0, 1.0]).with(Spring::stiffness(20.0).damped(0.1).resting_at(0.3));
/// assert_eq!(size_of_val(&Spring::none()), 0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spring<K = Absent, D = Absent, P = Absent> {
    stiffness: K,
    damping: D,
    rest: P,
}

impl Spring {
    /// Nothing.
    pub const fn none() -> Self {
        Self { stiffness: Absent, damping: Absent, rest: Absent }
    }
    /// A spring of a stiffness (N·m/rad, N/m).
    pub fn stiffness<T: Scalar>(stiffness: T) -> Spring<T> {
        Spring { stiffness, damping: Absent, rest: Absent }
    }
    /// A damper alone (N·m·s/rad, N·s/m).
    pub fn damping<T: Scalar>(damping: T) -> Spring<Absent, T> {
        Spring { stiffness: Absent, damping, rest: Absent }
    }
}

impl<K, P> Spring<K, Absent, P> {
    /// With a damper (N·m·s/rad, N·s/m).
    pub fn damped<T: Scalar>(self, damping: T) -> Spring<K, T, P> {
        Spring { stiffness: self.stiffness, damping, rest: self.rest }
    }
}

impl<K, D> Spring<K, D> {
    /// With a rest value of the coordinate (rad, m).
    pub fn resting_at<T: Scalar>(self, rest: T) -> Spring<K, D, T> {
        Spring { stiffness: self.stiffness, damping: self.damping, rest }
    }
}

/// What acts on a coordinate of a joint by itself: a [`Spring`], or a law of the user's own.
///
/// Explicit rules read its force. Implicit ones take it linearly implicitly, from its force and slopes where the last sweep has led: a
/// law that is not linear is met as well as one that is, and rules keep their order where it is smooth. Slopes should not be negative
/// by much: a step must resolve what they drive apart.
///
/// ```
/// use catena::element::{Implicit, Springs};
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
/// impl<T: Scalar> Law<T> for Stiffening<T> {
///     fn force_onto(&self, position: T, rate: T, sum: T) -> T {
///         sum - self.stiffness * (position + position * position * position) - self.damping * rate
///     }
///     fn energy(&self, position: T) -> T {
///         let square = position * position;
///         self.stiffness * square * (T::literal(0.5) + T::literal(0.25) * square)
///     }
///     fn pivot(&self, position: T, _: T, springs: Implicit<T::Real>) -> T {
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
pub trait Law<T: Scalar>: Copy + Debug + 'static {
    /// Whether its force is affine in position and rate: then slopes are the same everywhere, and nothing has to be read twice.
    const LINEAR: bool = false;

    /// Adds its generalised force (N·m, N) to a sum.
    fn force_onto(&self, position: T, rate: T, sum: T) -> T;
    /// Energy stored (J).
    fn energy(&self, position: T) -> T;
    /// K̂ of an implicit sweep: `springs.pivot(k, c)`, for the slopes there, k = −∂force/∂position and c = −∂force/∂rate.
    fn pivot(&self, position: T, rate: T, springs: Implicit<T::Real>) -> T;
    /// Rejects parameters that make no mechanics.
    ///
    /// # Errors
    /// What is wrong with them.
    fn check(&self) -> Result<(), Fault>;
}

impl<T: Scalar, K: Coefficient<T>, D: Coefficient<T>, P: Term<T>> Law<T> for Spring<K, D, P> {
    const LINEAR: bool = true;

    #[inline(always)]
    fn force_onto(&self, position: T, rate: T, sum: T) -> T {
        let strain = self.rest.take_from(position);
        self.damping.times_onto(-rate, self.stiffness.times_onto(-strain, sum))
    }
    fn energy(&self, position: T) -> T {
        let strain = self.rest.take_from(position);
        self.stiffness.times_onto((strain * strain).scale(T::Real::of(0.5)), T::zero())
    }
    #[inline(always)]
    fn pivot(&self, _: T, _: T, springs: Implicit<T::Real>) -> T {
        let stiff = self.stiffness.times_onto(T::constant(springs.position), T::zero());
        self.damping.times_onto(T::constant(springs.rate), stiff)
    }
    fn check(&self) -> Result<(), Fault> {
        not_negative("stiffness", self.stiffness.times_onto(T::one(), T::zero()))?;
        not_negative("damping", self.damping.times_onto(T::one(), T::zero()))?;
        if self.rest.is_finite() { Ok(()) } else { Err(Fault::NotFinite { parameter: "rest value" }) }
    }
}

/// What a law adds to a pivot in a sweep.
pub trait PivotRule<T: Scalar>: Springs<T> {
    /// Nothing in an explicit sweep.
    type Stiffness: Term<T> + Coefficient<T>;
    /// K̂.
    fn stiffness(self, law: impl FnOnce(Implicit<T::Real>) -> T) -> Self::Stiffness;
}

impl<T: Scalar> PivotRule<T> for Explicit {
    type Stiffness = Absent;
    #[inline(always)]
    fn stiffness(self, _: impl FnOnce(Implicit<T::Real>) -> T) -> Absent {
        Absent
    }
}

impl<T: Scalar> PivotRule<T> for Implicit<T::Real> {
    type Stiffness = T;
    #[inline(always)]
    fn stiffness(self, law: impl FnOnce(Implicit<T::Real>) -> T) -> T {
        law(self)
    }
}

impl<T: Scalar, U: Scalar, K: Lift<T, U>, D: Lift<T, U>, P: Lift<T, U>> Lift<T, U> for Spring<K, D, P> {
    type Over = Spring<K::Over, D::Over, P::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Spring {
            stiffness: self.stiffness.lift(number),
            damping: self.damping.lift(number),
            rest: self.rest.lift(number),
        }
    }
}
