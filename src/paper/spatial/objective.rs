//! Rotary springs between rotation vectors, which (34) cannot say.

use super::algebra::{Vector, apply, axes, difference, from_fn, logarithm, rows, sum, tilde, times, transposed};
use super::increment::Increment;
use crate::mechanics::spatial::maps::{spring_couple, spring_slope};
use crate::paper::link::Law;
use crate::paper::orient::Spring;
use crate::paper::rule::Linearization;
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// A spring that stores V = ½ φᵀ K φ, φ̃ = log A_IᵀA_O, in axes of the inboard body, and a damper, linear in ψ_O and ψ_I. (34) is neither
/// objective nor conservative.
pub(super) fn objective<T: Scalar>(
    spring: &Spring<T, 3>,
    sides: [(&Increment<T>, &[Linearization<T>; 3]); 2],
) -> Law<T, 3> {
    let [inner, outer] = sides.map(|(at, _)| at);
    let chi3 = sides[1].1[0].chi3;
    let half = T::literal(0.5);
    let [damping, ..] = spring.damping;
    let phi = Vector3::from(logarithm(&times(&transposed(&inner.barred), &outer.barred)));
    let stiffness = Vector3::from(spring.stiffness);
    let force = phi.component_mul(&stiffness);
    let couple: Vector<T> = apply(&inner.barred, spring_couple(phi, force).into());
    let slope = spring_slope(phi, stiffness, force).turned(&axes(&inner.barred)).columns();
    let (slope, bend) = (rows(&slope), tilde(couple));
    // By (2), for the damper must know what its slope χ₃ adds to.
    let spins = sides.map(|(at, step)| apply(&at.barred, core::array::from_fn(|k| step[k].rate_at(at.psi[k]))));
    let torque = sum(couple, difference(spins[1], spins[0]).map(|x| damping * x));
    // Of turns in inertial axes, K ∓ ½ m̃; of A ω, A χ₃ − ω̃ A T.
    let side = |at: &Increment<T>, spin: Vector<T>, sign: T| {
        let turning = times(&at.barred, &at.tangent);
        let elastic = times(&from_fn(|i, j| slope[i][j] + sign * half * bend[i][j]), &turning);
        let bent = times(&tilde(spin), &turning);
        from_fn(|i, j| elastic[i][j] + damping * (at.barred[i][j].scale(chi3) - bent[i][j]))
    };
    let (of_inner, of_outer) = (side(inner, spins[0], T::one()), side(outer, spins[1], -T::one()));
    let offset = sum(difference(torque, apply(&of_outer, outer.psi)), apply(&of_inner, inner.psi));
    Law { outer: of_outer, inner: of_inner, offset }
}
