//! The singly diagonally implicit Runge-Kutta method of Hairer and Wanner, order 4.

use super::tableau::{ErrorWeights, Tableau};
use super::{Control, MOST_SWEEPS, Rule};

/// SDIRK4 (E. Hairer, G. Wanner, *Solving Ordinary Differential Equations II*, table IV.6.5): order 4 in positions, rates and
/// forces, five implicit stages, L-stable, with an embedded method of order 3 for error control. For stiff hinges where accuracy
/// matters, or that start far from equilibrium.
///
/// Each stage is linearly implicit: the pivots of stiff joints take its acceleration into account exactly, and sweeps repeat for
/// geometry and velocity terms. One sweep a stage has order 2, two have order 3, three (the default) order 4. The first stage,
/// which knows no accelerations to predict its geometry with, makes one more. The last stage ends where the step does, so its
/// balance of forces is that of the end of the step. Accelerations at the start are not used, but for error control: a load that sets in
/// before the first stage, at a quarter of the step, is seen by these alone.
///
/// ```
/// use catena::planar::*;
/// use catena::time::Sdirk4;
/// let rod = Rod::uniform(0.05, 0.05);
/// let chain = (rod, [(ElasticHinge::rotary(20.0), rod); 19]);
/// let pendulum = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
/// let start = pendulum.at_rest(&[-1.0; 20])?;
/// let run = pendulum.simulate(start, Sdirk4::new().step(0.01), 1.0, |_| ())?;
/// assert_eq!(run.sweeps, 1600);
/// # Ok::<(), catena::Error>(())
/// ```
///
/// # Stiff hinges
///
/// Four rods (0.3 m, 0.3 kg each) joined by hinges of a stiffness k with dampers of 0.02 √k N·m·s/rad, released unstrained 0.5 rad
/// below the horizontal, are welded rods but for 1/k: after a second the pivot force differs from theirs by 5e-7 N at
/// k = 1e6 N·m/rad, 5e-9 N at 1e8 and 4e-9 N at 1e10, already with steps of 10 ms. Strained by 0.01 rad at the start, they survive
/// at any k up to 1e10.
///
/// Undamped vibration that steps do not resolve is part of the true motion, and no rule follows it. At 100 N·m/rad (up to
/// 350 rad/s) errors of the force are 0.4, 0.07, 0.006 and 0.0004 N with steps of 10, 5, 2.5 and 1.25 ms; at 1e4 N·m/rad (up to
/// 3500 rad/s) 0.4, 1.2, 0.8 and 0.3 N, and order 4 returns from 0.1 ms on.
///
/// # Tension
///
/// As in [`GeneralizedAlpha`](super::GeneralizedAlpha), pivots know the stiffness of springs and not that of tension: on a taut string
/// whose highest frequency is ω (2 √(T / ρA) / l for beads l apart, √3 times that for uniform rods) fixed steps break from
/// h ω = 1.1 on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(from = "Sweeps", into = "Sweeps"))]
pub struct Sdirk4 {
    pub(crate) sweeps: usize,
}

/// The method as it is written.
#[cfg(feature = "serde")]
#[derive(serde::Serialize, serde::Deserialize)]
struct Sweeps {
    sweeps: usize,
}

#[cfg(feature = "serde")]
impl From<Sweeps> for Sdirk4 {
    fn from(Sweeps { sweeps }: Sweeps) -> Self {
        Self::new().with_sweeps(sweeps)
    }
}

#[cfg(feature = "serde")]
impl From<Sdirk4> for Sweeps {
    fn from(method: Sdirk4) -> Self {
        Self { sweeps: method.sweeps }
    }
}

impl Sdirk4 {
    /// Three sweeps a stage, four in the first: sixteen a step.
    pub fn new() -> Self {
        Self { sweeps: 3 }
    }

    /// Another number of sweeps a stage, from one to a thousand; the first stage makes one more.
    #[must_use]
    pub fn with_sweeps(self, sweeps: usize) -> Self {
        Self { sweeps: sweeps.clamp(1, MOST_SWEEPS) }
    }

    /// Steps of a fixed size (s).
    pub fn step<R>(self, size: R) -> Rule<Self, R> {
        Rule { method: self, control: Control::Fixed(size) }
    }

    /// Steps that keep the error of each within a tolerance, absolute (rad, m) and relative.
    ///
    /// Where the error of rates would reject a step, it counts as far as springs and dampers let it last: that of a vibration too fast for the
    /// step divided by some 1 + γ h δ + (γ h ω)², which a sweep more finds (E. Hairer, G. Wanner, IV.8). Errors of positions count in full, so
    /// that vibration is damped away only where it moves nothing by more than the tolerance.
    pub fn tolerance<R>(self, tolerance: R) -> Rule<Self, R> {
        Rule { method: self, control: Control::Tolerance(tolerance) }
    }
}

impl Default for Sdirk4 {
    fn default() -> Self {
        Self::new()
    }
}

/// Stages of a step. The last one is the step itself (stiffly accurate): its accelerations belong to the end of the step.
pub(crate) const STAGES: usize = 5;

/// γ, the weight of a stage's own acceleration.
pub(crate) const GAMMA: f64 = 0.25;

pub(crate) static TABLE: Tableau<STAGES> = Tableau::new(
    [1.0 / 4.0, 3.0 / 4.0, 11.0 / 20.0, 1.0 / 2.0, 1.0],
    [
        [GAMMA, 0.0, 0.0, 0.0, 0.0],
        [1.0 / 2.0, GAMMA, 0.0, 0.0, 0.0],
        [17.0 / 50.0, -1.0 / 25.0, GAMMA, 0.0, 0.0],
        [371.0 / 1360.0, -137.0 / 2720.0, 15.0 / 544.0, GAMMA, 0.0],
        [25.0 / 24.0, -49.0 / 48.0, 125.0 / 16.0, -85.0 / 12.0, GAMMA],
    ],
);

/// The last row minus the weights of order 3, (59/48, −17/96, 225/32, −85/12, 0).
pub(crate) static ERROR: ErrorWeights<STAGES> =
    ErrorWeights::new([-3.0 / 16.0, -27.0 / 32.0, 25.0 / 32.0, 0.0, GAMMA], &TABLE.rate);

#[cfg(test)]
mod tests {
    use super::{ERROR, STAGES, TABLE};

    fn sum(term: impl Fn(usize) -> f64) -> f64 {
        (0..STAGES).map(term).sum()
    }

    #[test]
    fn the_eight_conditions_of_order_four_hold_and_four_of_the_embedded_method() {
        let (a, c, b) = (&TABLE.rate, &TABLE.nodes, &TABLE.rate[STAGES - 1]);
        let after = |x: &dyn Fn(usize) -> f64, i: usize| sum(|j| a[i][j] * x(j));
        let ac = |i: usize| after(&|j| c[j], i);
        let conditions: [(&dyn Fn(usize) -> f64, f64); 8] = [
            (&|_| 1.0, 1.0),
            (&|i| c[i], 1.0 / 2.0),
            (&|i| c[i] * c[i], 1.0 / 3.0),
            (&ac, 1.0 / 6.0),
            (&|i| c[i].powi(3), 1.0 / 4.0),
            (&|i| c[i] * ac(i), 1.0 / 8.0),
            (&|i| after(&|j| c[j] * c[j], i), 1.0 / 12.0),
            (&|i| after(&ac, i), 1.0 / 24.0),
        ];
        for (k, (of, exact)) in conditions.into_iter().enumerate() {
            // Rounding of weights up to eight.
            assert!((sum(|i| b[i] * of(i)) - exact).abs() < 1e-14, "condition {k}");
            let embedded = sum(|i| ERROR.rate[i] * of(i)).abs();
            assert!((embedded < 1e-14) == (k < 4), "embedded, condition {k}: {embedded}");
        }
        for i in 0..STAGES {
            assert!((sum(|j| a[i][j]) - c[i]).abs() < 1e-14, "row {i}");
        }
    }
}
