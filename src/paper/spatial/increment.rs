//! Orientation by the rotation vector ψ of a step: A(t_i) = A(t_{i−1}) exp ψ̃, singular nowhere.
//!
//! ω = χ₃ψ + χ₄ and ω̇ = χ₁ψ + χ₂ in body axes, with (3) and (4) as printed for ψ(t_{i−1}) = 0, ψ̇ = ω, ψ̈ = ω̇ there: Newmark's rule on
//! the group of rotations (O. Brüls, A. Cardona 2010). δA = A (T δψ)~ with T = 1 − (1 − cos φ)/φ² ψ̃ + (φ − sin φ)/φ³ ψ̃².

use super::algebra::{
    Matrix, Vector, apply, columns, cross, difference, exponential, from_fn, identity, scaled, sum, tangent, tilde,
    times,
};
use super::body::{External, Rigid, Shape, Step};
use crate::mechanics::spatial::maps::alternating;
use crate::paper::link::Given;
use crate::scalar::{Real, Scalar};
use crate::state::TransferMatrix;
use num_traits::Zero;

/// The expansion of a body's orientation for one step.
#[derive(Clone, Copy, Debug)]
pub struct Increment<T: Scalar> {
    /// ψ where A is taken, for what it multiplies: Ā.
    pub(super) psi: Vector<T>,
    /// Ā.
    pub(super) barred: Matrix<T>,
    /// T(ψ).
    pub(super) tangent: Matrix<T>,
    /// ω there, body axes.
    pub(super) spin: Vector<T>,
    /// ω̇ there.
    angular: Vector<T>,
    /// A where arms are expanded, and by which ψ.
    arms: (Matrix<T>, Vector<T>, Matrix<T>),
    /// ωΔT of the second order, where arms are expanded at t_{i−1}.
    advance: Vector<T>,
    /// Whether Ā varies with ψ: (29) takes it at c̄ and s̄ as it is.
    about: bool,
}

impl<T: Scalar> Increment<T> {
    /// The increment as (7) to (12) are taken for angles: at t_{i−1}, to second order in ΔT.
    pub fn printed(base: &Matrix<T>, spin: Vector<T>, angular: Vector<T>, dt: T::Real) -> Self {
        let half = T::Real::of(0.5);
        let advance = spin.map(|x| x.scale(dt));
        let psi: Vector<T> = core::array::from_fn(|k| advance[k].add_scaled(half * dt * dt, angular[k]));
        Self {
            psi,
            // A rotation, not its expansion: springs read angles from it.
            barred: times(base, &exponential(psi)),
            tangent: tangent(psi),
            spin: core::array::from_fn(|k| spin[k].add_scaled(dt, angular[k])),
            angular,
            arms: (*base, [T::zero(); 3], identity()),
            advance,
            about: false,
        }
    }

    /// About a rotation vector, and ω and ω̇ there.
    pub fn about(base: &Matrix<T>, psi: Vector<T>, spin: Vector<T>, angular: Vector<T>) -> Self {
        let (barred, tangent) = (times(base, &exponential(psi)), tangent(psi));
        Self { psi, barred, tangent, spin, angular, arms: (barred, psi, tangent), advance: [T::zero(); 3], about: true }
    }

    /// (22) for ψ: Ψ = −A r̃ T.
    pub fn psi_of(&self, point: Vector<T>) -> Matrix<T> {
        let (matrix, _, tangent) = &self.arms;
        let turning = |j: usize| cross([tangent[0][j], tangent[1][j], tangent[2][j]], point);
        columns([0, 1, 2].map(|j| apply(matrix, turning(j))))
    }

    /// The place of a point at ψ = 0, by the expansion. Tψ = ψ.
    pub fn phi(&self, point: Vector<T>) -> Vector<T> {
        let (matrix, psi, _) = &self.arms;
        let curved = scaled(T::literal(0.5), cross(self.advance, cross(self.advance, point)));
        apply(matrix, sum(difference(point, cross(*psi, point)), curved))
    }

    /// By how much a vector as expanded differs from the true one at ψ. Differences of numbers near each other are those of small ones.
    pub fn remainder(&self, base: &Matrix<T>, point: Vector<T>, psi: Vector<T>) -> Vector<T> {
        let (_, at, tangent) = &self.arms;
        let step = difference(psi, *at);
        let square = |v: Vector<T>| v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        let half = T::Real::of(0.5);
        // exp ψ̃ = 1 + a ψ̃ + b ψ̃², a = sin φ / φ, b = (1 − cos φ) / φ².
        let both = |v: Vector<T>| {
            let (whole, quarter) = (square(v), square(v).scale(T::Real::of(0.25)));
            let sinc = alternating(quarter, 1);
            (alternating(whole, 1), (sinc * sinc).scale(half))
        };
        let ((a, b), (a0, b0)) = (both(psi), both(*at));
        let twice = |u: Vector<T>, v: Vector<T>| cross(u, cross(v, point));
        // exp ψ̃ r − exp ψ̃* r
        let mixed = sum(sum(twice(*at, step), twice(step, *at)), twice(step, step));
        let moved = sum(
            sum(scaled(a - a0, cross(*at, point)), scaled(b - b0, twice(*at, *at))),
            sum(scaled(a, cross(step, point)), scaled(b, mixed)),
        );
        let turned = apply(&exponential(*at), cross(apply(tangent, step), point));
        let curved = scaled(T::literal(0.5), twice(self.advance, self.advance));
        apply(base, sum(difference(turned, moved), curved))
    }

    /// κ₄ and κ₅: Ġ_I = A (J ω̇ + ω × Jω), linear in ψ.
    pub(super) fn gyration(
        &self,
        body: &Rigid<T>,
        [chi1, chi3]: [T::Real; 2],
        known: &Given<T, 3, 3>,
    ) -> (Matrix<T>, Vector<T>) {
        let inertia = &body.about_inboard;
        let spin = self.spin;
        let momentum = apply(inertia, spin);
        // ω × Jω about ω*: (ω̃*J − (Jω*)~) ω − ω* × Jω*.
        let (left, right) = (times(&tilde(spin), inertia), tilde(momentum));
        let gyroscopic = from_fn(|i, j| left[i][j] - right[i][j]);
        let constant =
            difference(sum(apply(inertia, known.angles), apply(&gyroscopic, known.rates)), cross(spin, momentum));
        let slope = from_fn(|i, j| inertia[i][j].scale(chi1) + gyroscopic[i][j].scale(chi3));
        if !self.about {
            return (times(&self.barred, &slope), apply(&self.barred, constant));
        }
        // That A turns with ψ.
        let rate = sum(apply(inertia, self.angular), cross(spin, momentum));
        let turning = times(&tilde(rate), &self.tangent);
        let whole = from_fn(|i, j| slope[i][j] - turning[i][j]);
        (times(&self.barred, &whole), apply(&self.barred, sum(constant, cross(rate, self.psi))))
    }

    /// (31) with ψ in the slot of the angles: `angles` and `angle_rates` of a step are then χ₂ and χ₄ of ψ.
    pub fn rigid_body(&self, body: &Rigid<T>, step: &Step<T>, external: &External<T>) -> TransferMatrix<T, 13> {
        let arms = [body.centre, body.outboard];
        let known = Given {
            inboard: step.inboard,
            centre: step.centre,
            angles: step.angles,
            rates: step.angle_rates,
            arms: arms.map(|arm| self.phi(arm)),
        };
        let gyration = self.gyration(body, [step.chi1, step.chi3], &known);
        let shape = Shape { psi: arms.map(|arm| self.psi_of(arm)), barred: self.barred, gyration };
        shape.matrix(body, step.chi1, &known, external)
    }

    /// Residual of the linearisation: the largest component by which ψ misses where arms are expanded (rad).
    pub(super) fn residual(&self, psi: &Vector<T>) -> T::Real {
        let at = self.arms.1;
        (0..3).fold(T::Real::zero(), |worst, k| {
            let residual = (psi[k] - at[k]).real().abs();
            if residual <= worst { worst } else { residual }
        })
    }
}
