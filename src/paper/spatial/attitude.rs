//! Orientation by the space-three-angles 1-2-3, and its linearisation: (5) to (12).

use super::algebra::{Matrix, Vector, apply, columns, sum, times};
use crate::scalar::{Real, Scalar};

/// (5): direction cosines of angles with these sines and cosines.
fn direction_cosines<T: Scalar>([s1, s2, s3]: Vector<T>, [c1, c2, c3]: Vector<T>) -> Matrix<T> {
    [
        [c2 * c3, s1 * s2 * c3 - c1 * s3, c1 * s2 * c3 + s1 * s3],
        [c2 * s3, s1 * s2 * s3 + c1 * c3, c1 * s2 * s3 - s1 * c3],
        [-s2, s1 * c2, c1 * c2],
    ]
}

/// T₁, T₂, T₃ of (8): ω = Σ T_k θ̇_k in body axes, and ∂A/∂θ_k = A T̃_k.
fn tangents<T: Scalar>([s1, s2, _]: Vector<T>, [c1, c2, _]: Vector<T>) -> [Vector<T>; 3] {
    let (zero, one) = (T::zero(), T::one());
    [[one, zero, zero], [zero, c1, -s1], [-s2, s1 * c2, c1 * c2]]
}

/// The expansion of a body's orientation for one step.
///
/// The angles are singular at θ₂ = ±π/2, where θ₁ and θ₃ turn about the same axis.
#[derive(Clone, Copy, Debug)]
pub struct Attitude<T> {
    /// θ where (7) is taken (rad).
    pub angles: Vector<T>,
    /// θ̇ where (12) is taken (rad/s).
    pub rates: Vector<T>,
    /// θ̇ΔT of the second order in (8); zero where (7) is not taken at t_{i−1}.
    advance: Vector<T>,
    /// θ̈ΔT of (12); zero likewise.
    pub(super) change: Vector<T>,
    matrix: Matrix<T>,
    tangents: [Vector<T>; 3],
    /// Ā of (29).
    pub(super) barred: Matrix<T>,
    /// T̄ of (29).
    pub(super) barred_tangents: [Vector<T>; 3],
    /// T̄₁₂, T̄₂₃, T̄₃₁ of (29).
    pub(super) barred_bends: [Vector<T>; 3],
}

impl<T: Scalar> Attitude<T> {
    /// (7) to (12) as printed, at t_{i−1}, for an instant `dt` (s) later.
    pub fn printed(angles: Vector<T>, rates: Vector<T>, accelerations: Vector<T>, dt: T::Real) -> Self {
        let half = T::Real::of(0.5);
        let barred = core::array::from_fn(|k| {
            let (s, c) = angles[k].sin_cos();
            let turn = rates[k].scale(dt);
            let first = turn.add_scaled(half * dt * dt, accelerations[k]);
            let kept = T::one() - (turn * turn).scale(half);
            [s * kept + c * first, c * kept - s * first] // (9), (10)
        });
        let scaled = |x: Vector<T>| x.map(|x| x.scale(dt));
        Self::new(angles, rates, scaled(rates), scaled(accelerations), barred)
    }

    /// About angles and rates near those sought.
    pub fn about(angles: Vector<T>, rates: Vector<T>) -> Self {
        let none = [T::zero(); 3];
        let barred = angles.map(|angle| {
            let (s, c) = angle.sin_cos();
            [s, c]
        });
        Self::new(angles, rates, none, none, barred)
    }

    fn new(angles: Vector<T>, rates: Vector<T>, advance: Vector<T>, change: Vector<T>, barred: [[T; 2]; 3]) -> Self {
        let (s, c) = (angles.map(|x| x.sin_cos().0), angles.map(|x| x.sin_cos().1));
        let (s_bar, c_bar) = (barred.map(|[s, _]| s), barred.map(|[_, c]| c));
        let ([s1, s2, _], [c1, c2, _], zero) = (s_bar, c_bar, T::zero());
        Self {
            angles,
            rates,
            advance,
            change,
            matrix: direction_cosines(s, c),
            tangents: tangents(s, c),
            barred: direction_cosines(s_bar, c_bar),
            barred_tangents: tangents(s_bar, c_bar),
            barred_bends: [[zero, -s1, -c1], [-c2, -(s1 * s2), -(c1 * s2)], [zero, c1 * c2, -(s1 * c2)]],
        }
    }

    /// (22): Ψ for a point of the body, by which its place depends on the angles.
    pub fn psi(&self, point: Vector<T>) -> Matrix<T> {
        columns(self.tangents.map(|t| apply(&self.matrix, super::algebra::cross(t, point))))
    }

    /// Φ r of (21) and (25), (8): what its place is at θ = 0.
    pub fn phi(&self, point: Vector<T>) -> Vector<T> {
        use super::algebra::{cross, scaled};
        let back = (0..3).fold(point, |sum_of, k| sum(sum_of, scaled(-self.angles[k], cross(self.tangents[k], point))));
        sum(apply(&self.matrix, back), self.curvature(point))
    }

    /// The terms of second order in (8).
    fn curvature(&self, point: Vector<T>) -> Vector<T> {
        use super::algebra::{cross, scaled};
        let [t1, t2, t3] = self.tangents;
        let [a1, a2, a3] = self.advance;
        let half = T::literal(0.5);
        let twice = |t: Vector<T>, u: Vector<T>| cross(t, cross(u, point));
        // (8) prints T̃₃T̃₂ θ̇₃θ̇₁ where two terms stand: T̃₃T̃₁ θ̇₃θ̇₁ and T̃₃T̃₂ θ̇₃θ̇₂.
        let terms = [
            (half * a1 * a1, twice(t1, t1)),
            (half * a2 * a2, twice(t2, t2)),
            (half * a3 * a3, twice(t3, t3)),
            (a2 * a1, twice(t2, t1)),
            (a3 * a1, twice(t3, t1)),
            (a3 * a2, twice(t3, t2)),
        ];
        let body = terms.into_iter().fold([T::zero(); 3], |sum_of, (weight, term)| sum(sum_of, scaled(weight, term)));
        apply(&self.matrix, body)
    }

    /// By how much (7) of a vector differs from the true A(θ) r, to all its digits: formed by turning about x, y and z in turn, each time
    /// of what is linear in the differences of the angles, and of the rest.
    pub(super) fn remainder(&self, point: Vector<T>, angles: Vector<T>) -> Vector<T> {
        use super::algebra::{cross, difference, scaled};
        let half = T::literal(0.5);
        let (zero, one) = (T::zero(), T::one());
        let units = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
        // So far turned by the angles of (7), by them linearly, and all the rest.
        let (mut base, mut linear, mut rest) = (point, [zero; 3], [zero; 3]);
        for k in 0..3 {
            let step = angles[k] - self.angles[k];
            let (sine, _) = step.sin_cos();
            let (quarter, _) = (half * step).sin_cos();
            let (sag, axis) = ((quarter * quarter) + quarter * quarter, units[k]); // 1 − cos
            let small = sum(linear, rest);
            let whole = sum(base, small);
            let bent = sum(scaled(sine, cross(axis, small)), scaled(sag, cross(axis, cross(axis, whole))));
            let cubic = scaled(sine - step, cross(axis, base));
            rest = sum(rest, sum(bent, cubic));
            linear = sum(linear, scaled(step, cross(axis, base)));
            let (s, c) = self.angles[k].sin_cos();
            let turned = |v: Vector<T>| {
                let across = cross(axis, v);
                sum(v, sum(scaled(s, across), scaled(one - c, cross(axis, across))))
            };
            (base, linear, rest) = (turned(base), turned(linear), turned(rest));
        }
        difference(self.curvature(point), rest)
    }

    /// θ̇ of an angular velocity in body axes, H̄⁻¹ω: not finite at θ₂ = ±π/2.
    pub(super) fn rates_of(&self, spin: Vector<T>) -> Vector<T> {
        apply(&crate::paper::link::inverse(&columns(self.barred_tangents)), spin)
    }

    /// Ā H̄: from θ̇ to the angular velocity in inertial axes.
    pub fn spin(&self) -> Matrix<T> {
        times(&self.barred, &columns(self.barred_tangents))
    }
}
