//! The numbers a scene is made of.
//!
//! One lean trait, [`Scalar`], stands for `f32` and `f64`, for dual numbers (feature `num-dual`) and for SIMD lanes
//! (feature `simd`: `WideF64x4`, `WideF64x8`, `WideF32x4`, `WideF32x8`, `WideF32x16`); a [`Jet`] carries first derivatives without a feature. A scene has one scalar; its time and step size are the scalar's [`Real`].
//!
//! A law written for any of them is differentiated by running it on dual numbers (of the `num-dual` that this crate brings):
//!
//! ```
//! # #[cfg(feature = "num-dual")]
//! # fn main() -> Result<(), catena::Error> {
//! use catena::Scalar;
//! use catena::num_dual::Dual64;
//! use catena::planar::*;
//!
//! /// Dry friction in a joint (N·m) at a rate (rad/s): a sign without a jump.
//! fn friction<T: Scalar>(torque: T, rate: T) -> T {
//!     -torque * (rate * T::literal(100.0)).tanh()
//! }
//!
//! // How much sooner a rod stands still with more friction in its pin: the rate after 1 s, and its derivative.
//! let torque = Dual64::from(0.3).derivative(); // (N·m)
//! let rod = Rod::uniform(Dual64::from(1.0), Dual64::from(1.0));
//! let wheel = System::new(Pinned::origin(), rod, Free)?;
//! let start = wheel.with_rates(wheel.motion(), &[Dual64::from(2.0)])?;
//! let brake = Loads::none().in_joints(|_, _, joint: &JointMotion<Dual64>| friction(torque, joint.rate()));
//! let end = wheel.simulation(Rk4::step(0.01)).loads(&brake).run(start, 1.0, |_| ())?.motion;
//! let [rate] = end.rates_of(wheel.joint(0)?)?;
//! assert!((rate.re - (2.0 - 0.3 * 3.0)).abs() < 1e-12); // J = m l² / 3
//! assert!((rate.eps - -3.0).abs() < 1e-12);
//! # Ok(())
//! # }
//! # #[cfg(not(feature = "num-dual"))]
//! # fn main() {}
//! ```

mod columns;
#[cfg(feature = "num-dual")]
mod dual;
mod float;
mod jet;
#[cfg(feature = "simd")]
mod lanes;
mod made;
mod pack;
mod powers;
mod trig;

pub(crate) use columns::{Block, columns};
pub use jet::Jet;
#[cfg(feature = "simd")]
pub use lanes::{WideF32x16, WideF64x8};
pub use pack::Pack;
pub use powers::Powers;
#[cfg(feature = "simd")]
pub use simba::simd::{WideF32x4, WideF32x8, WideF64x4};

use core::fmt::{Debug, Display};
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{One, Zero};

/// Elementary functions of a number.
pub trait Elementary: Sized {
    /// Whether numbers are rows of Jacobians by states and torques, so that costates need no sums by parameters.
    const ROWS: bool = false;

    /// Square root.
    fn sqrt(self) -> Self;

    /// Sine and cosine, without branches.
    fn sin_cos(self) -> (Self, Self);

    /// Sine alone, at the price of both.
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// Cosine alone, at the price of both.
    fn cos(self) -> Self {
        self.sin_cos().1
    }

    /// Angle of the point `(x, self)` from the positive x axis in rad, in (−π, π].
    fn atan2(self, x: Self) -> Self;

    /// eˣ.
    fn exp(self) -> Self;

    /// Natural logarithm. At zero it is −∞, with infinite derivatives; of negative numbers NaN.
    fn ln(self) -> Self;

    /// Hyperbolic tangent: a sign without a jump, as laws of friction need it.
    fn tanh(self) -> Self;
}

/// A number that kernels can compute with: real, dual or a bundle of lanes.
///
/// Kernels contain no comparison and no test for zero: a test would look at the real part of a dual number only and lose
/// derivatives, and lanes cannot branch. Decisions stand outside the kernels and look at [`real`](Scalar::real).
pub trait Scalar:
    Copy
    + PartialEq
    + Debug
    + 'static
    + Zero
    + One
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + Elementary
{
    /// The plain number behind it, in which time, step sizes and decisions are expressed.
    type Real: Real;

    /// Largest magnitude in rad for which [`sin_cos`](Elementary::sin_cos) keeps its stated accuracy.
    const ANGLE_RANGE: Self::Real;

    /// Whether a number is several of equal standing: lanes, of which none decides for the others.
    const LANES: bool = false;

    /// The constant `value`: no derivatives, the same in every lane.
    fn constant(value: Self::Real) -> Self;

    /// The number on which decisions are made: a dual's real part, the lane of largest magnitude (NaN if any lane is NaN), the
    /// first number of a [`Pack`].
    fn real(self) -> Self::Real;

    /// Whether the magnitude of its [`real`](Scalar::real) number exceeds a limit, of lanes that of any.
    #[inline(always)]
    fn exceeds(self, limit: Self::Real) -> bool {
        let real = self.real();
        real > limit || -real > limit
    }

    /// Whether every part is finite: derivative parts and all lanes included.
    fn is_finite(self) -> bool;

    /// Whether every part equals: derivative parts too, of which `==` may know nothing.
    #[inline(always)]
    fn is_identical(self, other: Self) -> bool {
        self == other
    }

    /// `self * factor`, cheaper than a product of two scalars where these are duals.
    fn scale(self, factor: Self::Real) -> Self;

    /// `self * factor + addend`, fused where the target does that in hardware, two operations elsewhere.
    fn mul_add(self, factor: Self, addend: Self) -> Self;

    /// `self + factor · term`, fused where the target does that in hardware.
    #[inline(always)]
    fn add_scaled(self, factor: Self::Real, term: Self) -> Self {
        self + term.scale(factor)
    }

    /// Whether copies of it count, so that sums are better left to [`combine`](Scalar::combine) and
    /// [`accumulate`](Scalar::accumulate).
    const LARGE: bool = false;

    /// `self = base` and more terms, one by one.
    #[inline(always)]
    fn combine<const N: usize>(&mut self, base: &Self, terms: [(Self::Real, &Self); N]) {
        *self = terms.into_iter().fold(*base, |sum, (factor, term)| sum.add_scaled(factor, *term));
    }

    /// `self = self` and more terms, one by one.
    #[inline(always)]
    fn accumulate<const N: usize>(&mut self, terms: [(Self::Real, &Self); N]) {
        *self = terms.into_iter().fold(*self, |sum, (factor, term)| sum.add_scaled(factor, *term));
    }

    /// `1 / self`.
    fn recip(self) -> Self;

    /// Magnitude. At zero its derivatives are taken as 0, halfway between those on either side.
    fn abs(self) -> Self;

    /// −1, 0 or 1, as it is negative, zero (or NaN) or positive: the derivative of [`abs`](Scalar::abs). It has none itself.
    fn sign(self) -> Self;

    /// `then` where it is below zero, `otherwise` where it is not (or NaN): of lanes each decides for itself. Whatever is not taken may
    /// be NaN. For input and output: kernels decide nothing.
    #[inline]
    fn if_negative(self, then: Self, otherwise: Self) -> Self {
        if self.real() < Self::Real::zero() { then } else { otherwise }
    }

    /// A whole power, by products: `powi(0)` is 1 everywhere, without derivatives, also at zero; negative powers are reciprocals.
    #[inline]
    fn powi(self, exponent: i32) -> Self {
        let (mut square, mut left) = (self, exponent.unsigned_abs());
        if left == 0 {
            return Self::one();
        }
        while left & 1 == 0 {
            square *= square;
            left >>= 1;
        }
        let mut power = square;
        while left > 1 {
            square *= square;
            left >>= 1;
            if left & 1 == 1 {
                power *= square;
            }
        }
        if exponent < 0 { power.recip() } else { power }
    }

    /// The constant nearest to `value`.
    #[inline(always)]
    fn literal(value: f64) -> Self {
        Self::constant(Self::Real::of(value))
    }
}

/// A plain real number, `f32` or `f64`: what time, step sizes and decisions are expressed in.
pub trait Real: Scalar<Real = Self> + PartialOrd + Display {
    /// Distance from one to the next larger number.
    const EPSILON: Self;
    /// Positive infinity.
    const INFINITY: Self;
    /// The nearest number to `value`.
    fn of(value: f64) -> Self;
    /// The number as `f64`, for reports.
    fn as_f64(self) -> f64;
    /// The larger of two; the other one if one is NaN.
    fn max(self, other: Self) -> Self;
    /// The smaller of two; the other one if one is NaN.
    fn min(self, other: Self) -> Self;
    /// `self` to the power `exponent`.
    fn powf(self, exponent: Self) -> Self;
}

/// Does something in a function of its own where numbers are large: what is inlined joint by joint takes a compiler a time that grows with
/// the square of the number of joints, three minutes for an arm of seven over numbers with eight derivatives.
#[inline(always)]
pub(crate) fn apart<T: Scalar, X>(does: impl FnOnce() -> X) -> X {
    if const { T::LARGE } { called(does) } else { does() }
}

/// Calls.
#[inline(never)]
fn called<X>(does: impl FnOnce() -> X) -> X {
    does()
}
