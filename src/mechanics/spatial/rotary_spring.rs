//! Springs and dampers that resist relative rotation.

use super::Rotation;
use super::maps::{spring_couple, spring_slope};
use crate::element::Implicit;
use crate::error::Fault;
use crate::error::checks::{finite, not_negative};
use crate::lift::lift;
use crate::relation::spatial::algebra::{Columns, Symmetric3, dot, zero};
use crate::relation::{Absent, Part, Symmetric, Term};
use crate::scalar::{Real, Scalar};
use core::fmt::Debug;
use nalgebra::Vector3;

/// A rotary spring between two bodies in space, and a damper and a rest position where there are any.
///
/// The spring stores V = ½ (φ − φ₀)ᵀ K (φ − φ₀) for the rotation vector φ (rad) of the outboard body relative to the inboard one,
/// with stiffnesses K along axes of the inboard body; the damper exerts −C ω, for the relative angular velocity ω.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RotarySpring<T, D = Absent, P = Absent> {
    pub(super) stiffness: [T; 3],
    pub(super) damping: D,
    pub(super) rest: P,
}

/// What resists relative rotation in a joint: a [`RotarySpring`], nothing, or a law of the user's own.
///
/// ```
/// use catena::extend::Implicit;
/// use catena::spatial::*;
/// use catena::{Fault, nalgebra::Vector3};
///
/// /// A spring that turns a body back along the rotation vector, −k φ.
/// #[derive(Clone, Copy, Debug)]
/// struct Homing(f64);
///
/// impl RotaryLaw<f64> for Homing {
///     fn torque(&self, position: &Rotation<f64>, _: &[f64; 3]) -> Vector3<f64> {
///         Vector3::from(position.log()) * -self.0 // φ has the same numbers in the axes of both bodies
///     }
///     fn pivot(&self, _: &Rotation<f64>, _: &[f64; 3], springs: Implicit<f64>) -> Symmetric3<f64> {
///         let k = self.0 * springs.position; // near φ = 0
///         Symmetric3 { xx: k, xy: 0.0, xz: 0.0, yy: k, yz: 0.0, zz: k }
///     }
///     fn energy(&self, position: &Rotation<f64>) -> f64 {
///         0.5 * self.0 * position.log().map(|x| x * x).iter().sum::<f64>()
///     }
///     fn check(&self) -> Result<(), Fault> {
///         if self.0.is_finite() { Ok(()) } else { Err(Fault::NotFinite { parameter: "stiffness" }) }
///     }
/// }
///
/// let rod = Rod::uniform(0.5, 0.05, 1.0);
/// let own = System::new(Clamped::origin(), (ElasticHinge::with(Homing(20.0)), rod), Free)?.with_gravity([0.0, -9.81, 0.0]);
/// let same = System::new(Clamped::origin(), (ElasticHinge::rotary([20.0; 3]), rod), Free)?.with_gravity([0.0, -9.81, 0.0]);
/// let (rule, start) = (Dop853::tolerance(1e-12), [0.2, 0.3, -0.4]);
/// let one = own.simulate(own.at_rest(&start)?, rule, 1.0, |_| ())?.motion;
/// let other = same.simulate(same.at_rest(&start)?, rule, 1.0, |_| ())?.motion;
/// let apart = one.coordinates().iter().zip(other.coordinates()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
/// assert!(apart < 1e-10 && (own.budget(&one)?.potential - same.budget(&other)?.potential).abs() < 1e-9);
/// # Ok::<(), catena::Error>(())
/// ```
pub trait RotaryLaw<T: Scalar>: Copy + Debug + 'static {
    /// Whether reading it without the acceleration sought will do for rules of order two.
    const LINEAR: bool = false;

    /// Torque on the outboard body (N·m), in its axes, at a relative attitude and angular velocity (axes of that body).
    fn torque(&self, position: &Rotation<T>, rate: &[T; 3]) -> Vector3<T>;
    /// K̂ of an implicit sweep at a relative attitude and angular velocity, axes of the inboard body: stiffness times `springs.position` and
    /// damping times `springs.rate`, so that it vanishes where these do.
    fn pivot(&self, position: &Rotation<T>, rate: &[T; 3], springs: Implicit<T::Real>) -> Symmetric3<T>;
    /// Energy stored (J).
    fn energy(&self, position: &Rotation<T>) -> T;
    /// Rejects parameters that make no mechanics.
    ///
    /// # Errors
    /// What is wrong with them.
    fn check(&self) -> Result<(), Fault>;
}

impl<T: Scalar> RotaryLaw<T> for Absent {
    const LINEAR: bool = true;

    #[inline(always)]
    fn torque(&self, _: &Rotation<T>, _: &[T; 3]) -> Vector3<T> {
        zero()
    }
    #[inline(always)]
    fn pivot(&self, _: &Rotation<T>, _: &[T; 3], _: Implicit<T::Real>) -> Symmetric3<T> {
        Symmetric3::diagonal(T::zero())
    }
    fn energy(&self, _: &Rotation<T>) -> T {
        T::zero()
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

impl<T: Scalar, D: RotaryDamper<T>, P: Term<Vector3<T>>> RotarySpring<T, D, P> {
    /// φ and ∂V/∂φ.
    #[inline(always)]
    fn strained(&self, position: &Rotation<T>) -> (Vector3<T>, Vector3<T>) {
        let phi = Vector3::from(position.log());
        (phi, self.rest.take_from(phi).component_mul(&Vector3::from(self.stiffness)))
    }
}

impl<T: Scalar, D: RotaryDamper<T>, P: Term<Vector3<T>>> RotaryLaw<T> for RotarySpring<T, D, P> {
    const LINEAR: bool = true; // in the rotation vector

    #[inline(always)]
    fn torque(&self, position: &Rotation<T>, rate: &[T; 3]) -> Vector3<T> {
        let (phi, force) = self.strained(position);
        self.damping.resist(&position.matrix(), Vector3::from(*rate), spring_couple(phi, force))
    }
    #[cfg_attr(optimised, inline(always))]
    fn pivot(&self, position: &Rotation<T>, _: &[T; 3], springs: Implicit<T::Real>) -> Symmetric3<T> {
        let (phi, force) = self.strained(position);
        let slope = spring_slope(phi, Vector3::from(self.stiffness), force).scaled(springs.position);
        self.damping.pivot_onto(springs.rate, slope)
    }
    fn energy(&self, position: &Rotation<T>) -> T {
        let (phi, force) = self.strained(position);
        dot(self.rest.take_from(phi), force).scale(T::Real::of(0.5))
    }
    fn check(&self) -> Result<(), Fault> {
        self.stiffness.iter().try_for_each(|k| not_negative("stiffness", *k))?;
        self.damping.check()?;
        if self.rest.is_finite() { Ok(()) } else { Err(Fault::NotFinite { parameter: "rest value" }) }
    }
}

/// A rotary damper: [`Absent`], one coefficient for all axes, or one for each axis of the inboard body (N·m·s/rad).
pub trait RotaryDamper<T: Scalar>: Copy + Debug + 'static {
    /// −Rᵀ `couple` and the damper's torque, axes of the outboard body, whose relative attitude R and angular velocity (in its axes)
    /// are given.
    fn resist(&self, relative: &Columns<T>, rate: Vector3<T>, couple: Vector3<T>) -> Vector3<T>;
    /// Adds what it adds to K̂, axes of the inboard body.
    fn pivot_onto(&self, rate: T::Real, sum: Symmetric3<T>) -> Symmetric3<T>;
    /// Rejects coefficients that make no mechanics.
    ///
    /// # Errors
    /// What is wrong with them.
    fn check(&self) -> Result<(), Fault>;
}

impl<T: Scalar> RotaryDamper<T> for Absent {
    #[inline(always)]
    fn resist(&self, relative: &Columns<T>, _: Vector3<T>, couple: Vector3<T>) -> Vector3<T> {
        -relative.transposed(couple)
    }
    #[inline(always)]
    fn pivot_onto(&self, _: T::Real, sum: Symmetric3<T>) -> Symmetric3<T> {
        sum
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

impl<T: Scalar> RotaryDamper<T> for T {
    #[cfg_attr(optimised, inline(always))]
    fn resist(&self, relative: &Columns<T>, rate: Vector3<T>, couple: Vector3<T>) -> Vector3<T> {
        let own = relative.transposed(couple);
        let damped = |rate: T, own: T| self.mul_add(-rate, -own);
        Vector3::new(damped(rate.x, own.x), damped(rate.y, own.y), damped(rate.z, own.z))
    }
    #[inline(always)]
    fn pivot_onto(&self, rate: T::Real, sum: Symmetric3<T>) -> Symmetric3<T> {
        sum.plus_diagonal(self.scale(rate))
    }
    fn check(&self) -> Result<(), Fault> {
        not_negative("damping", *self)
    }
}

impl<T: Scalar> RotaryDamper<T> for [T; 3] {
    #[inline(always)]
    fn resist(&self, relative: &Columns<T>, rate: Vector3<T>, couple: Vector3<T>) -> Vector3<T> {
        let turning = relative.apply(rate);
        -relative.transposed(couple + turning.component_mul(&Vector3::from(*self)))
    }
    #[inline(always)]
    fn pivot_onto(&self, rate: T::Real, sum: Symmetric3<T>) -> Symmetric3<T> {
        sum + Symmetric3::of_diagonal(Vector3::from(*self)).scaled(rate)
    }
    fn check(&self) -> Result<(), Fault> {
        self.iter().try_for_each(|c| not_negative("damping", *c))
    }
}

/// Three numbers beside which a rotation vector is at rest.
impl<T: Scalar> Part for [T; 3] {
    fn is_finite(self) -> bool {
        finite("", &self).is_ok()
    }
}

impl<T: Scalar> Term<Vector3<T>> for [T; 3] {
    fn none() -> Self {
        [T::zero(); 3]
    }
    #[inline(always)]
    fn add_to(self, sum: Vector3<T>) -> Vector3<T> {
        sum + Vector3::from(self)
    }
    #[inline(always)]
    fn take_from(self, sum: Vector3<T>) -> Vector3<T> {
        sum - Vector3::from(self)
    }
}

lift!(RotarySpring<T, D, P> { stiffness, damping, rest });
