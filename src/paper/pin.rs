//! The smooth pin, (36) to (40) in the plane.

use crate::error::{Error, Fault};
use crate::mechanics::planar::index::{M, ONE, QX, QY, THETA, X, Y};
use crate::scalar::{Real, Scalar};
use crate::state::TransferMatrix;

/// (40): the transfer matrix of a smooth pin.
///
/// A pin passes no torque, and what lies outboard of it up to the next pin or the free end, its *section* (sections 3.4.1 to 3.4.3),
/// says by how much it turns. Section 3.4.3 prints z_{j,j} for z_{j+1,j}, the section's inboard end.
///
/// The matrix has rank 6: nothing can be recovered inward through it. It does not exist where Ū₄₃ vanishes, that is where the outboard
/// end of the section is the centre of percussion of the pin, though mechanics is regular there: at a point mass at the end of a
/// massless rod, or two thirds down a uniform rod. The Riccati transform has the pivot −S_{mθ} > 0 instead and does not mind.
///
/// `section` is the matrix Ū of the section; `torques` are m known in this pin and at the outboard end of the section (zero unless
/// torques are applied there); `inertia` is Σ (J_I + m |d_C| |d_O|) χ₁ of the section, the size of the terms of Ū₄₃.
///
/// # Errors
/// [`Fault::CentreOfPercussion`] where Ū₄₃ vanishes, [`Fault::NonFiniteMotion`] where it is not finite.
pub fn smooth_pin<T: Scalar>(
    section: &TransferMatrix<T, 7>,
    torques: [T; 2],
    inertia: T::Real,
) -> Result<TransferMatrix<T, 7>, Error> {
    let pivot = section[(M, THETA)]; // Ū₄₃
    let rounding = T::Real::EPSILON * T::Real::of(64.0) * inertia;
    if !pivot.is_finite() {
        return Err(Error::new(Fault::NonFiniteMotion));
    }
    if pivot.real().abs() <= rounding {
        return Err(Error::new(Fault::CentreOfPercussion));
    }
    let [here, outer] = torques;
    let mut u = TransferMatrix::identity();
    for column in [X, Y, QX, QY] {
        u[(THETA, column)] = -(section[(M, column)] / pivot); // u31, u32, u35, u36
    }
    u[(THETA, THETA)] = T::zero(); // u33
    u[(THETA, M)] = T::zero(); // u34
    // u37, with the torques that the paper has not
    u[(THETA, ONE)] = -((section[(M, ONE)] + section[(M, M)] * here - outer) / pivot);
    Ok(u)
}

/// Whether the outboard end of a body is the centre of percussion of its inboard end, J_I = m d_C · d_O, so nearly that (40) is noise.
pub fn is_percussive<T: Scalar>(body: &super::body::Rigid<T>) -> bool {
    let [c, o] = [body.inertia.centre, body.outboard];
    let about_inboard = body.about_inboard();
    let pivot = about_inboard - body.inertia.mass * (c[0] * o[0] + c[1] * o[1]);
    // (32) mixes c̄ with c, so Ū₄₃ of such a body is not zero but (θ̇ΔT)²/2 of its terms: only the body itself can tell.
    pivot.real().abs() <= about_inboard.real().abs() * T::Real::EPSILON.powf(T::Real::of(0.5))
}
