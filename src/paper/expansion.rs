//! Linearisation in the plane, (5) to (12): direction cosines as linear functions of the angle sought.
//!
//! In the plane (7) with (8) reads, with c and s at the angle where it is taken,
//!
//! ```text
//! cos θ(t_i) ≈ −s θ(t_i) + G₁      G₁ = c + θ s − c (θ̇ΔT)²/2
//! sin θ(t_i) ≈  c θ(t_i) + G₂      G₂ = s − θ c − s (θ̇ΔT)²/2
//! ```
//!
//! and (11) and (12) are not needed: a planar body has no products of rates left, for r_C is differenced by (1).

use crate::scalar::{Real, Scalar};

/// Where a step is linearised.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum At {
    /// At t_{i−1}, with (7) to (10) as printed.
    #[default]
    Previous,
    /// At a prediction θ + θ̇ΔT + θ̈ΔT²/2: what is left out is smaller by orders, at the same cost.
    Predictor,
    /// There, and again at what was found, until the step's equations hold.
    Iterated,
}

/// The expansion of a body's direction cosines for one step.
#[derive(Clone, Copy, Debug)]
pub struct Expansion<T> {
    /// The angle where (7) is taken (rad).
    pub angle: T,
    /// sin and cos there.
    pub direction: [T; 2],
    /// The curvature (θ̇ΔT)²/2 that (8) keeps; none where (7) is not taken at t_{i−1}.
    pub curvature: T,
    /// s̄ and c̄, (9) and (10): in products with other unknowns.
    pub barred: [T; 2],
}

impl<T: Scalar> Expansion<T> {
    /// (7) to (10) as printed, at t_{i−1}, for an instant `dt` (s) later.
    pub fn printed(angle: T, rate: T, acceleration: T, dt: T::Real) -> Self {
        let (s, c) = angle.sin_cos();
        let turn = rate.scale(dt);
        let half = T::Real::of(0.5);
        let curvature = (turn * turn).scale(half);
        let first = turn.add_scaled(half * dt * dt, acceleration);
        let kept = T::one() - curvature;
        // (9), (10)
        Self { angle, direction: [s, c], curvature, barred: [s * kept + c * first, c * kept - s * first] }
    }

    /// About an angle near that sought.
    pub fn about(angle: T) -> Self {
        let (s, c) = angle.sin_cos();
        Self { angle, direction: [s, c], curvature: T::zero(), barred: [s, c] }
    }

    /// G₁ and G₂ of (32).
    pub fn constants(&self) -> [T; 2] {
        let [s, c] = self.direction;
        let kept = T::one() - self.curvature;
        [c * kept + self.angle * s, s * kept - self.angle * c]
    }

    /// A vector of body axes in inertial axes, by c and s.
    pub fn turned(&self, [x, y]: [T; 2]) -> [T; 2] {
        let [s, c] = self.direction;
        [x * c - y * s, x * s + y * c]
    }

    /// A vector of body axes in inertial axes, by c̄ and s̄.
    pub fn turned_barred(&self, [x, y]: [T; 2]) -> [T; 2] {
        let [s, c] = self.barred;
        [x * c - y * s, x * s + y * c]
    }

    /// By how much a vector of body axes, expanded at `angle`, differs from the true one there: (7) less A(θ).
    ///
    /// Formed from the difference ε of the angles, as 1 − cos ε less the curvature and ε − sin ε, it keeps its digits.
    #[cfg_attr(optimised, inline(always))]
    pub fn remainder(&self, vector: [T; 2], angle: T) -> [T; 2] {
        let step = angle - self.angle;
        let (sine, _) = step.sin_cos();
        let (half, _) = step.scale(T::Real::of(0.5)).sin_cos();
        let along = (half * half).scale(T::Real::of(2.0)) - self.curvature;
        let across = step - sine;
        let [x, y] = self.turned(vector);
        [along * x - across * y, along * y + across * x]
    }
}
