//! What an element of a chain is in one step: the links that a solver joins.

use super::hinge::Rotary;
use crate::scalar::Scalar;
use crate::state::TransferMatrix;

/// An element in one step.
#[derive(Clone, Copy, Debug)]
pub enum Link<T: Scalar> {
    /// A body.
    Body {
        /// (32).
        matrix: TransferMatrix<T, 7>,
        /// The size of the terms of u₄₃: (J_I + m |d_C| |d_O|) χ₁.
        inertia: T::Real,
        /// Whether a pin at its inboard end has no matrix (40).
        percussive: bool,
    },
    /// A joint that turns: an elastic hinge, or a pin where it is smooth.
    Turning {
        /// m = κ (θ_O − θ_I) + μ.
        law: Rotary<T>,
        /// Whether κ is zero by construction.
        smooth: bool,
    },
    /// A joint that does not turn: the angle (rad) by which its outboard side is ahead, none in increments.
    Rigid(T),
}

/// How the root of a chain is held.
#[derive(Clone, Copy, Debug)]
pub enum Base<T> {
    /// At x, y, θ; what the first joint does not hold is of no consequence.
    Held([T; 3]),
    /// Not at all; of a balance under iteration, m, q_x and q_y that are left there.
    Free([T; 3]),
}
