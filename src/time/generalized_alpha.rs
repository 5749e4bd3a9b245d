//! The Newmark family: generalised-α, Newmark and the trapezoidal rule, linearly implicit.

use super::{Control, MOST_SWEEPS, Rule};
use crate::error::Fault;

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
///
/// # Steps of other sizes
///
/// A leads the acceleration by a share of the step, and where the step changes, so does A. Where steps grow it is made anew, from how the acceleration
/// has changed over the last one: what is left in it of earlier ones, by (1 − α_m) A₁ = − α_m A₀, would outgrow all else.
///
/// # Stiff hinges
///
/// From a smooth start the rule has order two in angles and forces at any stiffness k (tested from 1 to 1e10 N·m/rad). Where a
/// start is not in equilibrium, stiff hinges vibrate by 1/k rad, with torques of order one. Four rods (0.3 m, 0.3 kg each) with
/// dampers of 0.02 √k N·m·s/rad, released unstrained 0.5 rad below the horizontal: errors of the pivot force (N, of 6 N) after a
/// second, with steps of 10, 5, 2.5 and 1.25 ms:
///
/// | k (N·m/rad) | `new(0.8)` | `trapezoidal()` |
/// |---|---|---|
/// | 1e6  | 8e-4 2e-4 5e-5 1e-5 | 0.8 0.2 2e-4 1e-5 |
/// | 1e8  | 8e-4 2e-4 5e-5 1e-5 | 1.5 0.8 0.3 0.1 |
/// | 1e10 | 8e-4 2e-4 5e-5 1e-5 | 1.8 1.8 1.1 0.3 |
///
/// Angles of both have order two throughout. Without dampers, vibration that steps do not resolve is part of the true motion, and
/// forces of no rule follow it: at 1e4 N·m/rad (up to 3500 rad/s) they are off by 0.44, 0.32, 0.16 and 0.06 N with `new(0.8)`,
/// by 2.0, 0.2, 2.1 and 1.9 N with `trapezoidal()`, by 0.4, 1.2, 0.8 and 0.3 N with [`Sdirk4`](super::Sdirk4).
///
/// # Accelerations
///
/// A step leaves the accelerations of its last sweep, whose geometry is the iterate before: with them three rods on smooth pins have a
/// torque of 8e-3 N·m in a pin at steps of 10 ms. The next step goes on with these. Readings of a run have the accelerations that
/// positions and rates cause, found by one more sweep where they are read ([`Now::motion`](crate::simulate::Now::motion)); beside them
/// [`Now::stepped`](crate::simulate::Now::stepped), the last motion of a run and those of steps by hand are as the rule left them, and
/// [`System::with_accelerations`](crate::system::System::with_accelerations) finds the others. Forces have order two with either;
/// where hinges are stiff, those of the rule tend to those of welds, and the others do so but for what two sweeps leave.
///
/// A stepper remembers more of the motions it wrote, its auxiliary acceleration, as long as they are handed back as they were: from a motion that
/// differs by a rounding, if only in time, it begins anew, and differs by what the first step of a run does.
///
/// # Tension
///
/// Pivots know the stiffness of springs, not that which a force has where joints turn: a taut rope or chain swings as fast as in an
/// explicit rule. Fixed steps h grow a vibration of frequency ω where h ω > 2 (with one sweep from 0.2 on, with three from 0.7, slowly),
/// and error control rejects a quarter of its steps there, at tolerances of 1e-5 and 1e-4 rad alike. A string of tension T (N) and mass ρA (kg/m) in
/// links of length l has ω up to 2 √(T / ρA) / l if they are beads, √3 times that if they are uniform rods. Measured on twelve links,
/// steps break at h ω = 2.06 and 2.10. Take longer links, or an explicit rule.
///
/// # Strained starts
///
/// A step uses the acceleration at its start. Where hinges of 1e6 N·m/rad start strained by 0.01 rad, steps of 10 and 5 ms break
/// down: such starts need error control, or [`Sdirk4`](super::Sdirk4).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(from = "Parameters", into = "Parameters"))]
pub struct GeneralizedAlpha {
    pub(crate) alpha_m: f64,
    pub(crate) alpha_f: f64,
    pub(crate) beta: f64,
    pub(crate) gamma: f64,
    pub(crate) sweeps: usize,
    /// What is wrong with the parameters: a step says so.
    pub(crate) fault: Option<Fault>,
}

/// The method as it is written. What is wrong with it is found anew.
#[cfg(feature = "serde")]
#[derive(serde::Serialize, serde::Deserialize)]
struct Parameters {
    alpha_m: f64,
    alpha_f: f64,
    beta: f64,
    gamma: f64,
    sweeps: usize,
}

#[cfg(feature = "serde")]
impl From<Parameters> for GeneralizedAlpha {
    fn from(Parameters { alpha_m, alpha_f, beta, gamma, sweeps }: Parameters) -> Self {
        let outside = "a rule of this family has αₘ ≤ αf ≤ ½";
        let alphas = (-1.0..=0.5).contains(&alpha_m) && (alpha_m..=0.5).contains(&alpha_f);
        let fault =
            Fault::OutOfRange { parameter: "alpha_m", value: alpha_m, least: -1.0, most: alpha_f.min(0.5), outside };
        let Self { fault: of_newmark, .. } = Self::newmark(beta, gamma);
        let fault = of_newmark.or((!alphas).then_some(fault));
        Self { alpha_m, alpha_f, beta, gamma, sweeps: sweeps.clamp(1, MOST_SWEEPS), fault }
    }
}

#[cfg(feature = "serde")]
impl From<GeneralizedAlpha> for Parameters {
    fn from(GeneralizedAlpha { alpha_m, alpha_f, beta, gamma, sweeps, .. }: GeneralizedAlpha) -> Self {
        Self { alpha_m, alpha_f, beta, gamma, sweeps }
    }
}

/// The fault of γ below ½.
pub(crate) fn feeding(gamma: f64) -> Option<Fault> {
    let inside = gamma.is_finite() && gamma >= 0.5;
    let outside = "below, every vibration grows";
    (!inside).then_some(Fault::OutOfRange {
        parameter: "gamma",
        value: gamma,
        least: 0.5,
        most: f64::INFINITY,
        outside,
    })
}

impl GeneralizedAlpha {
    /// The rule whose amplification of infinitely fast vibration is ρ∞, from 0 (annihilates it) to 1 (keeps it); 0.8 is a good
    /// choice. A step with another value is refused with [`Fault::OutOfRange`].
    pub fn new(rho: f64) -> Self {
        let alpha_m = (2.0 * rho - 1.0) / (rho + 1.0);
        let alpha_f = rho / (rho + 1.0);
        let gamma = 0.5 + alpha_f - alpha_m;
        let beta = 0.25 * (gamma + 0.5) * (gamma + 0.5);
        let inside = rho.is_finite() && (0.0..=1.0).contains(&rho);
        let outside = "it is the share that a step leaves of fast vibration";
        let fault = Fault::OutOfRange { parameter: "rho", value: rho, least: 0.0, most: 1.0, outside };
        Self { alpha_m, alpha_f, beta, gamma, sweeps: 2, fault: (!inside).then_some(fault) }
    }

    /// Newmark's rule with β > 0 and γ ≥ ½: second order for γ = ½, first order with damping above. A step with other values is
    /// refused with [`Fault::NotPositive`] or [`Fault::OutOfRange`].
    pub fn newmark(beta: f64, gamma: f64) -> Self {
        let valid = beta.is_finite() && beta > 0.0;
        let beta_fault = (!valid).then_some(Fault::NotPositive { parameter: "beta", value: beta });
        let fault = beta_fault.or(feeding(gamma));
        Self { alpha_m: 0.0, alpha_f: 0.0, beta, gamma, sweeps: 2, fault }
    }

    /// The trapezoidal rule, Newmark's with β = ¼ and γ = ½. It keeps fast vibration for ever: once that is excited, reactions at
    /// stiff hinges do not converge (numbers above). From a smooth start they do, with order two.
    pub fn trapezoidal() -> Self {
        Self::newmark(0.25, 0.5)
    }

    /// Another number of sweeps a step, from one to a thousand.
    #[must_use]
    pub fn with_sweeps(self, sweeps: usize) -> Self {
        Self { sweeps: sweeps.clamp(1, MOST_SWEEPS), ..self }
    }

    /// Steps of a fixed size (s).
    pub fn step<R>(self, size: R) -> Rule<Self, R> {
        Rule { method: self, control: Control::Fixed(size) }
    }

    /// Steps that keep the error of each in positions within a tolerance, absolute (rad, m) and relative.
    ///
    /// The estimate is the difference of the last two sweeps (what the geometry was off by) plus what a changing acceleration makes
    /// the rule miss; the first one alone is zero wherever the equations are linear. Where the step changes, A changes with it, so
    /// that the rule keeps its order.
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(0.3, 0.3);
    /// let hinge = ElasticHinge::rotary(1e8).damped(200.0);
    /// let chain = System::new(Pinned::origin(), (rod, hinge, rod), Free)?.with_gravity(9.81);
    /// let strained = chain.at_rest(&[-0.5, -0.49])?; // a torque of 1e6 N·m
    /// let run = chain.simulate(strained, GeneralizedAlpha::new(0.8).tolerance(1e-6), 0.1, |_| ())?;
    /// assert!(run.steps < 1000);
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn tolerance<R>(self, tolerance: R) -> Rule<Self, R> {
        Rule { method: self, control: Control::Tolerance(tolerance) }
    }

    /// κ and the weights of a₀ and A₀ in A₁ = κ a₁ + (α_f a₀ − α_m A₀) / (1 − α_m).
    pub(crate) fn recurrence(&self) -> [f64; 3] {
        let Self { alpha_m, alpha_f, .. } = *self;
        [1.0 - alpha_f, alpha_f, -alpha_m].map(|share| share / (1.0 - alpha_m))
    }

    /// Distance of A from the time of the true acceleration, as a share of the step: A(t) ≈ a(t + lead · h).
    pub(crate) fn lead(&self) -> f64 {
        self.alpha_m - self.alpha_f
    }

    /// Errors of a step in position and rate, in units of h² and h times the change of the true acceleration in it.
    ///
    /// With a linear acceleration the step misses the position by h² (β − 1/6 + lead/2) of the change, and the rate by
    /// h (γ − ½ + lead), which is zero for a rule of second order. Where the first one vanishes too, that of the trapezoidal rule
    /// stands for what is left.
    pub(crate) fn truncation(&self) -> [f64; 2] {
        let position = self.beta - 1.0 / 6.0 + 0.5 * self.lead();
        let rate = self.gamma - 0.5 + self.lead();
        [if position.abs() < 1.0 / 12.0 { 1.0 / 12.0 } else { position }, if rate.abs() < 1e-12 { 0.0 } else { rate }]
    }
}
