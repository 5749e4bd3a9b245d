//! Springs and dampers whose forces have series because they are affine in coordinate and rate.

use super::Order;
use crate::relation::{Absent, Coefficient, Term};
use crate::scalar::Scalar;
use crate::spring::{Spring, SpringLaw};

/// A law that is affine in coordinate and rate: that of its coefficients is the same without what is constant.
pub trait AffineLaw<T: Scalar>: SpringLaw<T> {
    /// What coefficients of order one and more cause.
    fn change(&self, position: T, rate: T) -> T;
}

impl<T: Scalar> AffineLaw<T> for Absent {
    #[inline(always)]
    fn change(&self, _: T, _: T) -> T {
        T::zero()
    }
}

impl<T: Scalar, K: Coefficient<T>, D: Coefficient<T>, P: Term<T>> AffineLaw<T> for Spring<K, D, P> {
    #[inline(always)]
    fn change(&self, position: T, rate: T) -> T {
        self.unstrained().force(position, rate)
    }
}

/// What such a law makes of a coordinate, order by order.
#[derive(Clone, Copy, Debug)]
pub struct Strain<T> {
    /// Coefficients of coordinate and rate of the present order.
    now: [T; 2],
    /// What the law makes of them.
    pub effort: T,
}

impl<T: Scalar> Strain<T> {
    /// None yet.
    pub fn none() -> Self {
        Self { now: [T::zero(); 2], effort: T::zero() }
    }

    /// Of coordinate and rate where a series begins.
    #[inline(always)]
    pub fn begin(now: [T; 2], law: &impl AffineLaw<T>) -> Self {
        Self { now, effort: law.force(now[0], now[1]) }
    }

    /// Goes on to the next order, after an acceleration of the coordinate.
    #[cfg_attr(optimised, inline(always))]
    pub fn follow(&mut self, order: &Order<T::Real>, acceleration: T, law: &impl AffineLaw<T>) {
        let [_, rate] = self.now;
        self.now = [rate.scale(order.once), acceleration.scale(order.once)];
        self.effort = law.change(self.now[0], self.now[1]);
    }
}
