//! Elastic hinges and damper hinges in the plane, (33) to (35).

use crate::planar::index::{M, ONE, QX, QY, THETA, X, Y};
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

/// (33) and (35), linear part, for one pair of axes: r_O = r_I − q / (k + cχ₃) + c (χ_{4,I} − χ_{4,O}) / (k + cχ₃).
///
/// Springs and dampers act along inertial axes. An axis without give (`None`) is rigid. The hinge hands on m as it is, although
/// its points differ: torques do not balance unless q points from one to the other.
pub fn linear_hinge<T: Scalar>(axes: [Option<Linear<T>>; 2], chi3: T::Real) -> TransferMatrix<T, 7> {
    let mut u = TransferMatrix::identity();
    for (axis, (r, q)) in axes.into_iter().zip([(X, QX), (Y, QY)]) {
        if let Some(Linear { stiffness, damping, chi4: [inboard, outboard] }) = axis {
            let compliance = (stiffness + damping.scale(chi3)).recip();
            u[(r, q)] = -compliance; // U14
            u[(r, ONE)] = compliance * damping * (inboard - outboard); // U15 = −U14 c (χ4I − χ4O)
        }
    }
    u
}

/// A linear spring and damper along one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear<T> {
    /// k (N/m).
    pub stiffness: T,
    /// c (N·s/m).
    pub damping: T,
    /// χ₄ of the inboard and of the outboard end (m/s). That of the inboard end is zero at a ground at rest.
    pub chi4: [T; 2],
}
