//! Discretisation, (1) and (2): what a time rule makes of one coordinate in one step.

use crate::error::Fault;
use crate::scalar::Scalar;
use core::fmt::Debug;

/// A coordinate ξ at t_{i−1}, its rates, and what a rule remembers of it besides.
#[derive(Clone, Copy, Debug)]
pub struct Coordinate<T, M> {
    /// ξ.
    pub value: T,
    /// ξ̇.
    pub rate: T,
    /// ξ̈.
    pub acceleration: T,
    /// What the rule remembers besides.
    pub memory: M,
}

/// (1) and (2): ξ̈ = χ₁ξ + χ₂ and ξ̇ = χ₃ξ + χ₄ at the instant at which forces balance.
///
/// It is kept in increments Δξ = ξ − ξ(t_{i−1}), ξ̈ = χ₁Δξ + `acceleration` and ξ̇ = χ₃Δξ + `rate`: in χ₂ = −χ₁ξ(t_{i−1}) + ..
/// the absolute coordinate costs digits, ε χ₁ |ξ| of every acceleration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearization<T: Scalar> {
    /// ξ(t_{i−1}).
    pub past: T,
    /// χ₁ (1/s²), common to all coordinates.
    pub chi1: T::Real,
    /// χ₃ (1/s), common to all coordinates.
    pub chi3: T::Real,
    /// ξ̈ if ξ did not change: χ₂ + χ₁ξ(t_{i−1}).
    pub acceleration: T,
    /// ξ̇ if ξ did not change: χ₄ + χ₃ξ(t_{i−1}).
    pub rate: T,
}

impl<T: Scalar> Linearization<T> {
    /// χ₂ of (1).
    pub fn chi2(&self) -> T {
        self.acceleration - self.past.scale(self.chi1)
    }

    /// χ₄ of (2).
    pub fn chi4(&self) -> T {
        self.rate - self.past.scale(self.chi3)
    }

    /// (1): ξ̈ for an increment.
    pub fn acceleration_at(&self, increment: T) -> T {
        self.acceleration.add_scaled(self.chi1, increment)
    }

    /// (2): ξ̇ for an increment.
    pub fn rate_at(&self, increment: T) -> T {
        self.rate.add_scaled(self.chi3, increment)
    }
}

/// A numerical integration procedure as the paper uses one: it expresses ξ̈ and ξ̇ by ξ. It has no sweeps and no stages.
pub trait Rule<T: Scalar>: Copy + Debug {
    /// What the rule remembers of a coordinate besides ξ, ξ̇ and ξ̈: of earlier values their differences, for rotation vectors are counted from
    /// another zero in each step.
    type Memory: Copy + Debug;

    /// Rejects parameters that make no rule.
    ///
    /// # Errors
    /// What is wrong with them.
    fn check(&self) -> Result<(), Fault>;

    /// Where forces balance, as a share of the step: 1 at t_i.
    fn balance(&self) -> f64 {
        1.0
    }

    /// Whether the rule keeps what it cannot resolve, an alternating error, for ever. On rigid joints, where every coordinate of a body
    /// is integrated by itself, that error grows, however small the step: see the [table](super#which-rule-survives-where).
    fn is_weak_on_rigid_joints(&self) -> bool {
        false
    }

    /// The memory of a coordinate that starts with these values, before its first step of size `dt` (s).
    fn remember(&self, value: T, rate: T, acceleration: T, dt: T::Real) -> Self::Memory;

    /// χ₁ to χ₄ of a step of size `dt` (s).
    fn linearize(&self, past: &Coordinate<T, Self::Memory>, dt: T::Real) -> Linearization<T>;

    /// Step 7: ξ, ξ̇ and ξ̈ at t_i from the increment found.
    fn advance(&self, coordinate: &mut Coordinate<T, Self::Memory>, dt: T::Real, increment: T);

    /// A coordinate that starts.
    fn start(&self, value: T, rate: T, acceleration: T, dt: T::Real) -> Coordinate<T, Self::Memory> {
        Coordinate { value, rate, acceleration, memory: self.remember(value, rate, acceleration, dt) }
    }
}
