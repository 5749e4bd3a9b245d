//! Rules that balance forces elsewhere than at t_i: Wilson-θ and the implicit midpoint rule.

use super::rule::{Coordinate, Linearization, Rule};
use crate::error::Fault;
use crate::scalar::{Real, Scalar};

/// Wilson-θ: the acceleration is linear to t_{i−1} + ϑΔT, where forces balance. Order 2; stable for ϑ ≥ 1.366.
///
/// States are those of that instant. At t_i the balance is violated by O(ΔT²).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wilson {
    theta: f64,
}

impl Wilson {
    /// The rule with ϑ from 1.366 to 2; a run with another is refused with [`Fault::OutOfRange`].
    pub const fn new(theta: f64) -> Self {
        Self { theta }
    }
}

impl<T: Scalar> Rule<T> for Wilson {
    type Memory = ();

    fn check(&self) -> Result<(), Fault> {
        let (value, least, most) = (self.theta, 1.366, 2.0);
        let inside = value.is_finite() && value >= least && value <= most;
        let outside = "below, the rule is unstable at large steps; above, it errs by far";
        if inside { Ok(()) } else { Err(Fault::OutOfRange { parameter: "theta", value, least, most, outside }) }
    }

    fn balance(&self) -> f64 {
        self.theta
    }

    fn remember(&self, _: T, _: T, _: T, _: T::Real) {}

    fn linearize(&self, past: &Coordinate<T, ()>, dt: T::Real) -> Linearization<T> {
        let number = T::Real::of;
        let span = number(self.theta) * dt;
        let per_span = span.recip();
        Linearization {
            past: past.value,
            chi1: number(6.0) * per_span * per_span,
            chi3: number(3.0) * per_span,
            acceleration: -(past.acceleration.scale(number(2.0)).add_scaled(number(6.0) * per_span, past.rate)),
            rate: -(past.rate.scale(number(2.0)).add_scaled(number(0.5) * span, past.acceleration)),
        }
    }

    fn advance(&self, coordinate: &mut Coordinate<T, ()>, dt: T::Real, increment: T) {
        let number = T::Real::of;
        let Coordinate { value, rate, acceleration: last, .. } = *coordinate;
        let beyond = self.linearize(coordinate, dt).acceleration_at(increment);
        let acceleration = last.add_scaled(number(1.0 / self.theta), beyond - last);
        let twice = acceleration.add_scaled(number(2.0), last);
        *coordinate = Coordinate {
            value: value.add_scaled(dt, rate).add_scaled(dt * dt * number(1.0 / 6.0), twice),
            rate: rate.add_scaled(number(0.5) * dt, acceleration + last),
            acceleration,
            memory: (),
        };
    }
}

/// The implicit midpoint rule (Gauss, one stage): forces balance in the middle of the step, to which states belong. Order 2; it
/// keeps quadratic invariants.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Midpoint;

impl<T: Scalar> Rule<T> for Midpoint {
    type Memory = ();

    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }

    fn balance(&self) -> f64 {
        0.5
    }

    fn is_weak_on_rigid_joints(&self) -> bool {
        true
    }

    fn remember(&self, _: T, _: T, _: T, _: T::Real) {}

    fn linearize(&self, past: &Coordinate<T, ()>, dt: T::Real) -> Linearization<T> {
        let twice = T::Real::of(2.0) * dt.recip();
        Linearization {
            past: past.value,
            chi1: twice * twice,
            chi3: twice,
            acceleration: -past.rate.scale(twice),
            rate: T::zero(),
        }
    }

    fn advance(&self, coordinate: &mut Coordinate<T, ()>, dt: T::Real, increment: T) {
        let step = self.linearize(coordinate, dt);
        let two = T::Real::of(2.0);
        *coordinate = Coordinate {
            value: coordinate.value.add_scaled(two, increment),
            rate: step.rate_at(increment).scale(two) - coordinate.rate,
            acceleration: step.acceleration_at(increment),
            memory: (),
        };
    }
}
