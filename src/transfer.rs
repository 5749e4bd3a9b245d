//! What a space must say for its elements to have exact transfer matrices: the inspection view of a sweep.

use crate::element::{Load, Space};
use crate::error::Error;
use crate::scalar::Scalar;
use crate::state::{StateVector, TransferMatrix};

/// A space whose elements have exact transfer matrices for states with `N` entries.
pub trait Exact<const N: usize>: Space {
    /// The matrix of a body under a load, (32) at acceleration level.
    fn body_matrix(
        body: &Self::BodyMotion,
        gravity: Self::Vector,
        load: impl Load<Self>,
    ) -> TransferMatrix<Self::Scalar, N>;

    /// The matrix of a joint, (40), from that of everything outboard up to the next joint that turns, and the torques in both.
    ///
    /// # Errors
    /// [`SingularTransfer`](crate::Fault::SingularTransfer) at a centre of percussion.
    fn joint_matrix(
        joint: &Self::JointMotion,
        torque: Self::Scalar,
        section: &TransferMatrix<Self::Scalar, N>,
        outer_torque: Self::Scalar,
    ) -> Result<TransferMatrix<Self::Scalar, N>, Error>;

    /// The torque in a joint, for an applied one: that of its spring and damper added. `None` for a joint that does not turn.
    fn joint_torque(joint: &Self::JointMotion, applied: Self::Scalar) -> Option<Self::Scalar>;

    /// The acceleration state of a station with these forces.
    fn acceleration_state(frame: &Self::Frame) -> StateVector<Self::Scalar, N>;
}

/// Solves A x = b for a small dense system by elimination with row pivoting; `None` where it is singular.
///
/// For inspection only: pivoting compares values, which a sweep never does.
pub(crate) fn solve_dense<T: Scalar, const K: usize>(mut a: [[T; K]; K], mut b: [T; K]) -> Option<[T; K]> {
    use crate::scalar::Real;
    use num_traits::Zero;
    for i in 0..K {
        let magnitude = |row: &usize| a[*row][i].real().abs();
        let pivot = (i..K).max_by(|p, q| magnitude(p).as_f64().total_cmp(&magnitude(q).as_f64()))?;
        a.swap(i, pivot);
        b.swap(i, pivot);
        if a[i][i].real() == T::Real::zero() {
            return None;
        }
        let inverse = a[i][i].recip();
        for row in i + 1..K {
            let factor = a[row][i] * inverse;
            let above = a[i];
            for (entry, above) in a[row].iter_mut().zip(above) {
                *entry -= factor * above;
            }
            let above = b[i];
            b[row] -= factor * above;
        }
    }
    for i in (0..K).rev() {
        let sum = (i + 1..K).fold(b[i], |sum, j| sum - a[i][j] * b[j]);
        b[i] = sum / a[i][i];
    }
    Some(b)
}
