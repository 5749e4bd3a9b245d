//! Newmark's family of rules: (3) and (4), and generalised-α.

use super::rule::{Coordinate, Linearization, Rule};
use crate::error::Fault;
use crate::scalar::{Real, Scalar};
use crate::time::{GeneralizedAlpha, feeding};

/// Newmark-β, (3) and (4): the rule of the paper.
///
/// Order 2 for γ = ½, order 1 with damping of what steps do not resolve for γ > ½.
///
/// **With γ = ½ a scene with rigid joints dies** after a few periods at any step ([why](super#which-rule-survives-where);
/// [`is_weak_on_rigid_joints`](Rule::is_weak_on_rigid_joints)), and with β ≤ γ/2, the linear acceleration of β = 1/6 among it, at once. By how much the angles of a double pendulum are off, drawn by
/// `examples/paper_weak_instability.rs`:
///
#[doc = include_str!("../../docs/weak_instability.svg")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Newmark {
    beta: f64,
    gamma: f64,
}

impl Newmark {
    /// The rule with parameters β > 0 and γ ≥ ½ (β > γ/2 on rigid joints); a run with others, of which γ < ½ feeds every
    /// oscillation, is refused with
    /// [`Fault::NotPositive`] or [`Fault::OutOfRange`].
    pub const fn new(beta: f64, gamma: f64) -> Self {
        Self { beta, gamma }
    }

    /// The rule with γ ≥ ½ and β = ¼ (γ + ½)², which damps most.
    pub const fn damped(gamma: f64) -> Self {
        Self::new(0.25 * (gamma + 0.5) * (gamma + 0.5), gamma)
    }
}

impl<T: Scalar> Rule<T> for Newmark {
    type Memory = ();

    fn check(&self) -> Result<(), Fault> {
        let Self { beta, gamma } = *self;
        if !(beta.is_finite() && beta > 0.0) {
            return Err(Fault::NotPositive { parameter: "beta", value: beta });
        }
        feeding(gamma).map_or(Ok(()), Err)
    }

    fn is_weak_on_rigid_joints(&self) -> bool {
        // The product of both amplifications of infinitely fast vibration is 1 for γ = ½; one is −1 for 2β = γ and beyond it below.
        !(self.gamma > 0.5 && 2.0 * self.beta > self.gamma)
    }

    fn remember(&self, _: T, _: T, _: T, _: T::Real) {}

    fn linearize(&self, past: &Coordinate<T, ()>, dt: T::Real) -> Linearization<T> {
        let [beta, gamma, early] = [self.beta, self.gamma, 0.5 - self.beta].map(T::Real::of);
        let chi1 = (beta * dt * dt).recip(); // (3)
        // (3) without ξ(t_{i−1}), which increments leave out.
        let acceleration = -(past.rate.scale(dt).add_scaled(early * dt * dt, past.acceleration)).scale(chi1);
        let chi3 = gamma * chi1 * dt; // (4)
        let rate =
            acceleration.scale(gamma * dt) + past.rate.add_scaled((T::Real::of(1.0) - gamma) * dt, past.acceleration);
        Linearization { past: past.value, chi1, chi3, acceleration, rate }
    }

    fn advance(&self, coordinate: &mut Coordinate<T, ()>, dt: T::Real, increment: T) {
        let step = self.linearize(coordinate, dt);
        *coordinate = Coordinate {
            value: coordinate.value + increment,
            rate: step.rate_at(increment),
            acceleration: step.acceleration_at(increment),
            memory: (),
        };
    }
}

/// HHT-α for α in 0 .. ⅓, in the form that balances forces at t_i. (The form of Hilber, Hughes and Taylor balances a mean of two
/// instants; its q belongs to neither.)
pub fn hht_alpha(alpha: f64) -> GeneralizedAlpha {
    let gamma = 0.5 + alpha;
    let inside = alpha.is_finite() && (0.0..=1.0 / 3.0).contains(&alpha);
    let outside = "below, every vibration grows; above, the rule is unstable at large steps";
    let fault = Fault::OutOfRange { parameter: "alpha", value: alpha, least: 0.0, most: 1.0 / 3.0, outside };
    GeneralizedAlpha {
        alpha_m: 0.0,
        alpha_f: alpha,
        beta: 0.25 * (gamma + 0.5) * (gamma + 0.5),
        gamma,
        fault: (!inside).then_some(fault),
        ..GeneralizedAlpha::new(0.0)
    }
}

/// Generalised-α (M. Arnold, O. Brüls 2007): Newmark's rule for an auxiliary acceleration a with
/// (1 − α_m) a_i + α_m a_{i−1} = (1 − α_f) ξ̈_i + α_f ξ̈_{i−1}. Order 2; the memory is a.
impl<T: Scalar> Rule<T> for GeneralizedAlpha {
    type Memory = T;

    fn check(&self) -> Result<(), Fault> {
        self.fault.map_or(Ok(()), Err)
    }

    fn is_weak_on_rigid_joints(&self) -> bool {
        // The amplification of infinitely fast vibration is −1 without any damping.
        self.gamma == 0.5
    }

    fn remember(&self, _: T, _: T, acceleration: T, _: T::Real) -> T {
        acceleration
    }

    fn linearize(&self, past: &Coordinate<T, T>, dt: T::Real) -> Linearization<T> {
        let [beta, gamma] = [self.beta, self.gamma].map(T::Real::of);
        let stiff = (beta * dt * dt).recip();
        // a_i = Δξ / (βΔT²) + free
        let free = self.free(past, dt);
        let share = 1.0 - self.alpha_f;
        let [gain, auxiliary, last] =
            [(1.0 - self.alpha_m) / share, self.alpha_m / share, -self.alpha_f / share].map(T::Real::of);
        let acceleration = free.scale(gain).add_scaled(auxiliary, past.memory).add_scaled(last, past.acceleration);
        let rate = past.rate.add_scaled((T::Real::of(1.0) - gamma) * dt, past.memory).add_scaled(gamma * dt, free);
        Linearization { past: past.value, chi1: gain * stiff, chi3: gamma * stiff * dt, acceleration, rate }
    }

    fn advance(&self, coordinate: &mut Coordinate<T, T>, dt: T::Real, increment: T) {
        let step = self.linearize(coordinate, dt);
        let stiff = (T::Real::of(self.beta) * dt * dt).recip();
        *coordinate = Coordinate {
            value: coordinate.value + increment,
            rate: step.rate_at(increment),
            acceleration: step.acceleration_at(increment),
            memory: self.free(coordinate, dt).add_scaled(stiff, increment),
        };
    }
}

impl GeneralizedAlpha {
    /// The auxiliary acceleration a_i if ξ did not change.
    fn free<T: Scalar>(&self, past: &Coordinate<T, T>, dt: T::Real) -> T {
        let [beta, early] = [self.beta, 0.5 - self.beta].map(T::Real::of);
        -(past.rate.scale(dt).add_scaled(early * dt * dt, past.memory)).scale((beta * dt * dt).recip())
    }
}
