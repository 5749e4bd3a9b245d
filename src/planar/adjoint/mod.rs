//! The costate sweep in the plane: what is carried and kept.

mod along;
mod bodies;
mod ends;
mod joints;

use super::body::Base;
use crate::adjoint::Reversed;
use crate::planar::{Acceleration, Frame, Planar};
use crate::relation::Additive;
use crate::scalar::Scalar;
use core::ops::Add;
use nalgebra::Vector2;

/// A station and the body on its inboard side, on the way outward.
#[derive(Clone, Copy, Debug)]
pub struct Stirred<T> {
    /// Acceleration, in a frame that falls freely.
    pub(super) acceleration: Acceleration<T>,
    /// Virtual velocity.
    pub(super) stirring: Acceleration<T>,
    /// Angular velocity (rad/s).
    pub(super) rate: T,
}

/// What is carried inward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulled<T> {
    /// G, the momentum of the virtual motion.
    pub(super) momentum: Vector2<T>,
    /// F, the force of inverse dynamics.
    pub(super) force: Vector2<T>,
    /// Costates of the angle and the angular velocity that turn what has been met since the last pin.
    pub(super) angle: T,
    pub(super) rate: T,
}

impl<T: Scalar> Add for Pulled<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            momentum: self.momentum + other.momentum,
            force: self.force + other.force,
            angle: self.angle + other.angle,
            rate: self.rate + other.rate,
        }
    }
}

impl<T: Scalar> Additive for Pulled<T> {
    #[inline(always)]
    fn null() -> Self {
        let (zero, none) = (T::zero(), Vector2::null());
        Self { momentum: none, force: none, angle: zero, rate: zero }
    }
}

impl<T: Scalar> Reversed for Planar<T> {
    type Pivot = T;
    type Stirred = Stirred<T>;
    /// Of its outboard end.
    type Met = Stirred<T>;
    type Pulled = Pulled<T>;
    type OfBody = Base<T>;
    /// By the angle of a weld.
    type OfJoint = T;

    fn no_pivot() -> T {
        T::zero()
    }
    #[inline(always)]
    fn at_ground(frame: &Frame<T>, gravity: Vector2<T>) -> Stirred<T> {
        let still = Acceleration { linear: Vector2::null(), angular: T::zero() };
        Stirred { acceleration: frame.falling(gravity), stirring: still, rate: frame.turn.rate }
    }
    fn unmet() -> Stirred<T> {
        let still = Acceleration { linear: Vector2::null(), angular: T::zero() };
        Stirred { acceleration: still, stirring: still, rate: T::zero() }
    }
    fn of_no_body() -> Base<T> {
        let zero = T::zero();
        Base { outboard: [zero; 2], moment: [zero; 2], inertia: zero, lumped: zero }
    }
    #[inline(always)]
    fn of_gravity(pulled: &Pulled<T>) -> Vector2<T> {
        pulled.momentum
    }
    #[inline(always)]
    fn of_ground(pulled: &Pulled<T>) -> T {
        pulled.angle
    }
    /// Links in the direction of their axes sum up d · d̄: their length l is constant, and d̄ along d is that over l.
    fn complete(size: &T, sums: &mut Base<T>) {
        if size.real() != num_traits::Zero::zero() {
            sums.outboard[0] = sums.outboard[0] * size.recip();
        }
    }
}
