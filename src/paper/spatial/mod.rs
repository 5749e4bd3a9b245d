//! The paper's matrices in space, z = (r, θ, m, q, 1), (13): rigid body (31), elastic hinge (35), smooth ball (40).
//!
//! These are matrices to look at and to multiply; `examples/paper_example_5.rs` runs the paper's chain of three bodies with them, step by
//! step as section 4 says. Angles are the paper's space-three-angles 1-2-3.
//!
//! | where | printed | holds |
//! |---|---|---|
//! | (8), last term | T̃₃T̃₂ θ̇₃θ̇₁ | T̃₃T̃₁ θ̇₃θ̇₁ + T̃₃T̃₂ θ̇₃θ̇₂ |
//! | (29) H₁, H₂ | T̄_j J T̄_k | T̄̃_j J T̄_k |
//! | (29) κ₅ | first derivatives in the products | second derivatives, as in (12) |
//! | (29) J | the inertia matrix | about I, for (20) is about I |
//! | (35) | A_O, H_O, A_I, H_I | those of t_i, Ā H̄ |
//! | (42) E₄₂ | A₄A₂ᵀ | A₄ᵀA₂ |
//! | (42) F₄ | ω̃₄ J ω̃₄ | ω̃₄ J ω₄ |
//!
//! (Some of these may be losses of the text at hand.) Even corrected, q_O of (26) is right to first order in ΔT only, for χ₁ multiplies
//! what (7) leaves out.

mod algebra;
mod attitude;
mod body;
mod joints;

pub use algebra::{Matrix, Vector};
pub use attitude::Attitude;
pub use body::{External, Rigid, Step, rigid_body};
pub use joints::{Rotary, rotary_hinge, smooth_ball};

/// The first of the three indices of r.
pub const PLACE: usize = 0;
/// The first of the three indices of θ.
pub const ANGLES: usize = 3;
/// The first of the three indices of m.
pub const TORQUE: usize = 6;
/// The first of the three indices of q.
pub const FORCE: usize = 9;
/// The index of the constant one.
pub const ONE: usize = 12;
