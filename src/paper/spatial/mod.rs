//! The paper's matrices in space, z = (r, θ, m, q, 1), (13): rigid body (31), lumped mass, elastic hinges (33) to (35), smooth ball (40).
//!
//! [`Scheme`](super::Scheme) runs scenes with them. Angles are the paper's space-three-angles 1-2-3, which are singular at θ₂ = ±90°, or, with
//! [`Slots::RotationVectors`](super::Slots), the rotation vector of the step:
//!
//! ```
//! use catena::loading::Unloaded;
//! use catena::paper::{At, GeneralizedAlpha, Scheme, Slots, Solver};
//! use catena::spatial::{Ball, Free, Pinned, Rod, System};
//!
//! let rod = Rod::uniform(1.0, 0.05, 1.0); // length, radius (m), mass (kg)
//! let chain = System::new(Pinned::origin(), (rod, Ball, rod), Free)?.with_gravity([0.0, -9.81, 0.0]);
//! let start = chain.at_rest(&[0.0, 0.0, -1.0, 0.0, 0.3, -0.5])?;
//! let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).linearized(At::Predictor).turning_by(Slots::RotationVectors);
//! let mut run = scheme.solved_by(Solver::Riccati).start(&chain, &start, &Unloaded, 0.01)?;
//! run.run_to(1.0)?;
//! let angles: Option<[f64; 3]> = run.attitude(1); // 1-2-3, not wrapped
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! Springs with angles are (34) as printed, along inertial axes and of differences of angles: good in a plane of the axes or for small
//! angles. With rotation vectors they are those of [`ElasticBall`](crate::spatial::ElasticBall), which turn with the bodies and conserve
//! energy. Linearise these at the predictor: at t_{i−1}, on springs and dampers stiff against the inertia of a thin rod about its axis, rounding
//! grows from step to step.
//!
//! | where | printed | holds |
//! |---|---|---|
//! | (8), last term | T̃₃T̃₂ θ̇₃θ̇₁ | T̃₃T̃₁ θ̇₃θ̇₁ + T̃₃T̃₂ θ̇₃θ̇₂ |
//! | (29) H₁, H₂ | T̄_j J T̄_k | T̄̃_j J T̄_k |
//! | (29) κ₅ | first derivatives in the products | second derivatives, as in (12) |
//! | (29) J | the inertia matrix | about I, for (20) is about I |
//! | (33)-(35) | m_O = m_I although r_O ≠ r_I | torques do not balance unless q points along r_O − r_I |
//! | (34) | springs of differences of angles | another torque in other axes, work in a loop of orientations: small angles only |
//! | (40) | for any body | none where its outboard end is the centre of percussion, or at θ₂ = ±90° |
//! | (35) | A_O, H_O, A_I, H_I | those of t_i, Ā H̄ |
//! | (42) E₄₂ | A₄A₂ᵀ | A₄ᵀA₂ |
//! | (42) F₄ | ω̃₄ J ω̃₄ | ω̃₄ J ω₄ |
//!
//! (Some of these may be losses of the text at hand.) Even corrected, q_O of (26) is right to first order in ΔT only, for χ₁ multiplies
//! what (7) leaves out.

#[cfg_attr(not(feature = "alloc"), allow(dead_code))] // runs read more of these
mod algebra;
#[cfg_attr(not(feature = "alloc"), allow(dead_code))]
mod attitude;
mod body;
#[cfg(feature = "alloc")]
mod ends;
#[cfg_attr(not(feature = "alloc"), allow(dead_code))]
mod increment;
mod joints;
#[cfg(feature = "alloc")]
mod objective;
#[cfg(feature = "alloc")]
mod orient;
#[cfg(feature = "alloc")]
mod scene;

pub use algebra::{Matrix, Vector};
pub use attitude::Attitude;
pub use body::{External, Rigid, Step, lumped_mass, rigid_body};
pub use increment::Increment;
pub use joints::{Rotary, linear_hinge, rotary_hinge, smooth_ball};
#[cfg(feature = "alloc")]
pub use orient::{Base, Slot, Solid};

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
