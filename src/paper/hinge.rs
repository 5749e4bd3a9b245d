//! Elastic hinges and damper hinges in the plane, (33) to (35).

use crate::mechanics::planar::index::{M, ONE, QX, QY, THETA, X, Y};
use crate::scalar::Scalar;
use crate::state::TransferMatrix;

/// A rotary spring and damper in one step: m = κ (θ_O − θ_I) + μ, (34) with (2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotary<T> {
    /// κ = k′ + c′χ₃ (N·m/rad).
    pub slope: T,
    /// μ (N·m): in absolute angles c′(χ_{4,θO} − χ_{4,θI}) − k′φ₀, less a torque applied. The paper has no rest angle φ₀, without
    /// which a bent hinge or a loop at rest cannot be said.
    pub offset: T,
}

/// (35), rotary part: θ_O = θ_I + (m − μ) / κ. The translation is rigid: U₁₄ = U₁₅ = 0. In the plane U₂₂ is 1.
///
/// A hinge with κ = 0 turns freely and has no such matrix: it is a [pin](super::smooth_pin).
pub fn rotary_hinge<T: Scalar>(hinge: &Rotary<T>) -> TransferMatrix<T, 7> {
    let compliance = hinge.slope.recip();
    let mut u = TransferMatrix::identity();
    u[(THETA, M)] = compliance; // U23
    u[(THETA, ONE)] = -(compliance * hinge.offset); // U25
    u
}

/// A linear spring and damper along one axis in one step: q = −κ (r_O − r_I) − ν, (33) with (2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear<T> {
    /// κ = k + cχ₃ (N/m).
    pub slope: T,
    /// ν (N): in absolute coordinates c (χ_{4,O} − χ_{4,I}) − k d₀. The paper has no rest length d₀. χ_{4,I} is zero at a ground at rest.
    pub offset: T,
}

/// (33) and (35), linear part, for one pair of axes: r_O = r_I − (q + ν) / κ.
///
/// Springs and dampers act along inertial axes. An axis without give (`None`) is rigid; one with κ = 0 gives freely and has no such
/// matrix. The hinge hands on m as it is, although its points differ: torques do not balance unless q points from one to the other.
pub fn linear_hinge<T: Scalar>(axes: [Option<Linear<T>>; 2]) -> TransferMatrix<T, 7> {
    let mut u = TransferMatrix::identity();
    for (axis, (r, q)) in axes.into_iter().zip([(X, QX), (Y, QY)]) {
        if let Some(Linear { slope, offset }) = axis {
            let compliance = slope.recip();
            u[(r, q)] = -compliance; // U14
            u[(r, ONE)] = -(compliance * offset); // U15 = −U14 c (χ4I − χ4O)
        }
    }
    u
}
