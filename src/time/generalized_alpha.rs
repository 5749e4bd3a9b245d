//! The Newmark family: generalised-α, Newmark and the trapezoidal rule, linearly implicit.

use super::{Control, Rule};

/// The generalised-α family in the form that balances forces at the end of the step (M. Arnold, O. Brüls 2007): second order,
/// stable on stiff hinges.
///
/// With an auxiliary acceleration A, (1 − α_m) A₁ + α_m A₀ = (1 − α_f) a₁ + α_f a₀, the step is
///
/// ```text
/// q₁ = q₀ + h v₀ + h² [(½ − β) A₀ + β A₁]        v₁ = v₀ + h [(1 − γ) A₀ + γ A₁]
/// ```
///
/// so that q₁ and v₁ are affine in a₁, which the pivots of stiff joints take into account exactly. Geometry and velocity terms
/// are taken at a prediction in the first sweep, and at its outcome in each further one. Two sweeps a step are the default: one is
/// second order too, but blows up on flexible chains; three conserve energy better.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(0.05, 0.05);
/// let chain = (rod, [(ElasticHinge::rotary(20.0), rod); 19]);
/// let pendulum = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
/// let start = pendulum.at_rest(&[-1.0; 20])?;
/// let run = pendulum.simulate(start, GeneralizedAlpha::new(0.8).step(0.01), 1.0, |_| ())?;
/// assert_eq!(run.sweeps, 200);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeneralizedAlpha {
    pub(crate) alpha_m: f64,
    pub(crate) alpha_f: f64,
    pub(crate) beta: f64,
    pub(crate) gamma: f64,
    pub(crate) sweeps: usize,
}

impl GeneralizedAlpha {
    /// The rule whose amplification of infinitely fast vibration is ρ∞, from 0 (annihilates it) to 1 (keeps it); 0.8 is a good
    /// choice.
    pub fn new(rho: f64) -> Self {
        let alpha_m = (2.0 * rho - 1.0) / (rho + 1.0);
        let alpha_f = rho / (rho + 1.0);
        let gamma = 0.5 + alpha_f - alpha_m;
        let beta = 0.25 * (gamma + 0.5) * (gamma + 0.5);
        Self { alpha_m, alpha_f, beta, gamma, sweeps: 2 }
    }

    /// Newmark's rule with β > 0 and γ ≥ ½: second order for γ = ½, first order with damping above.
    pub fn newmark(beta: f64, gamma: f64) -> Self {
        Self { alpha_m: 0.0, alpha_f: 0.0, beta, gamma, sweeps: 2 }
    }

    /// The trapezoidal rule, Newmark's with β = ¼ and γ = ½. It keeps fast vibration for ever: reactions at stiff hinges do not
    /// converge.
    pub fn trapezoidal() -> Self {
        Self::newmark(0.25, 0.5)
    }

    /// Another number of sweeps a step, at least one.
    #[must_use]
    pub fn with_sweeps(self, sweeps: usize) -> Self {
        Self { sweeps: sweeps.max(1), ..self }
    }

    /// Steps of a fixed size (s).
    pub fn step<R>(self, size: R) -> Rule<Self, R> {
        Rule { method: self, control: Control::Fixed(size) }
    }
}
