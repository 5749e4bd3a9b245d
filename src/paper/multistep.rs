//! Multistep rules as tables of coefficients: Houbolt, Park, BDF2.

use super::rule::{Coordinate, Linearization, Rule};
use crate::error::Fault;
use crate::scalar::{Real, Scalar};

/// A multistep rule of order 2. It starts from a Taylor series backwards, which keeps that order.
///
/// With d₁ = ξ_{i−1} − ξ_{i−2} and d₂ = ξ_{i−2} − ξ_{i−3},
///
/// ```text
/// ΔT ξ̇ = lead Δξ + rate · (d₁, d₂)
/// ΔT ξ̈ = lead ξ̇ + of_rates · (ξ̇_{i−1}, ξ̇_{i−2}, ξ̇_{i−3})     the same difference once more, or
/// ΔT² ξ̈ = second Δξ + of_steps · (d₁, d₂)                     a second difference
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multistep {
    lead: f64,
    rate: [f64; 2],
    acceleration: Difference,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Difference {
    OfRates([f64; 3]),
    OfSteps(f64, [f64; 2]),
}

impl Multistep {
    /// Backward differences of second order, for ξ̇ and for ξ̈.
    pub const BDF2: Self = Self { lead: 1.5, rate: [-0.5, 0.0], acceleration: Difference::OfRates([-2.0, 0.5, 0.0]) };

    /// Park's rule, the mean of the backward differences of second and third order.
    pub const PARK: Self = Self {
        lead: 5.0 / 3.0,
        rate: [-5.0 / 6.0, 1.0 / 6.0],
        acceleration: Difference::OfRates([-2.5, 1.0, -1.0 / 6.0]),
    };

    /// Houbolt's rule, (ξ̇, ξ̈) of the cubic through four instants.
    pub const HOUBOLT: Self =
        Self { lead: 11.0 / 6.0, rate: [-7.0 / 6.0, 1.0 / 3.0], acceleration: Difference::OfSteps(2.0, [-3.0, 1.0]) };
}

/// The last two steps and the rates before the last one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Earlier<T> {
    steps: [T; 2],
    rates: [T; 2],
}

impl<T: Scalar> Rule<T> for Multistep {
    type Memory = Earlier<T>;

    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }

    fn remember(&self, _: T, rate: T, acceleration: T, dt: T::Real) -> Earlier<T> {
        let back = |share: f64| -(T::Real::of(share) * dt);
        let step = |share| rate.add_scaled(back(share), acceleration).scale(dt);
        Earlier {
            steps: [step(0.5), step(1.5)],
            rates: [1.0, 2.0].map(|share| rate.add_scaled(back(share), acceleration)),
        }
    }

    fn linearize(&self, past: &Coordinate<T, Earlier<T>>, dt: T::Real) -> Linearization<T> {
        let number = T::Real::of;
        let per_step = dt.recip();
        let Earlier { steps, rates } = past.memory;
        let sum = |weights: [f64; 2]| steps[0].scale(number(weights[0])).add_scaled(number(weights[1]), steps[1]);
        let chi3 = number(self.lead) * per_step;
        let rate = sum(self.rate).scale(per_step);
        let (chi1, acceleration) = match self.acceleration {
            Difference::OfRates(weights) => {
                let [last, second, third] = weights.map(number);
                let others = past.rate.scale(last).add_scaled(second, rates[0]).add_scaled(third, rates[1]);
                (chi3 * chi3, rate.scale(chi3).add_scaled(per_step, others))
            }
            Difference::OfSteps(second, weights) => {
                let squared = per_step * per_step;
                (number(second) * squared, sum(weights).scale(squared))
            }
        };
        Linearization { past: past.value, chi1, chi3, acceleration, rate }
    }

    fn advance(&self, coordinate: &mut Coordinate<T, Earlier<T>>, dt: T::Real, increment: T) {
        let step = self.linearize(coordinate, dt);
        let Earlier { steps, rates } = coordinate.memory;
        let memory = Earlier { steps: [increment, steps[0]], rates: [coordinate.rate, rates[0]] };
        *coordinate = Coordinate {
            value: coordinate.value + increment,
            rate: step.rate_at(increment),
            acceleration: step.acceleration_at(increment),
            memory,
        };
    }
}
