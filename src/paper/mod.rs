//! The formulation of 2005, equation by equation: the displacement-level method as X. Rui, B. He, Y. Lu, W. Lu and G. Wang print it
//! (*Discrete Time Transfer Matrix Method for Multibody System Dynamics*, Multibody System Dynamics 14, 2005), in the plane, and in
//! [space](spatial), with its corrections marked where they stand.
//!
//! It runs the same scenes as the rest of this crate, and nothing in the rest of this crate knows of it. It is here to be read beside the
//! paper, to be compared with, and to be warned of: see [what it is good for](#what-it-is-good-for).
//!
//! ```
//! use catena::loading::Unloaded;
//! use catena::paper::{At, GeneralizedAlpha, Newmark, Scheme};
//! use catena::planar::{Free, Pin, Pinned, Rod, System};
//!
//! let rod = Rod::uniform(1.0, 1.0); // length (m), mass (kg)
//! let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
//! let start = pendulum.at_rest(&[-1.0, -0.5])?;
//!
//! // As printed, but with γ = 0.6: order 1.
//! let mut printed = Scheme::new(Newmark::damped(0.6)).start(&pendulum, &start, &Unloaded, 0.01)?;
//! printed.run_to(2.0)?;
//! // The best that one sweep a step gives: order 2.
//! let better = Scheme::new(GeneralizedAlpha::new(0.8)).linearized(At::Predictor);
//! let mut better = better.start(&pendulum, &start, &Unloaded, 0.01)?;
//! better.run_to(2.0)?;
//! let tip = better.stations().last();
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! # The method
//!
//! A time rule makes ξ̈ and ξ̇ of every coordinate linear in ξ, direction cosines are made linear in θ, and so each element becomes a
//! matrix that maps the state z = (x, y, θ, m, q_x, q_y, 1) at its inboard end to that at its outboard end. The matrices multiply; the
//! ends give the unknowns; the states are recovered, rates follow, and the next step begins.
//!
//! | equations | where |
//! |---|---|
//! | (1), (2) | [`Linearization`], [`Rule`] |
//! | (3), (4) | [`Newmark`]; other rules: [`GeneralizedAlpha`], [`hht_alpha`], [`Multistep`], [`Wilson`], [`Midpoint`] |
//! | (5)-(10) | [`Expansion`], [`At`] |
//! | (11), (12) | not needed in the plane; in space in [`spatial::rigid_body`] |
//! | (13), (14) | [`StateVector`](crate::StateVector), [`index`](crate::planar::index) |
//! | (15)-(17) | [`TransferMatrix`](crate::TransferMatrix), [`Solver::Product`] |
//! | (18)-(32) | [`rigid_body`], [`lumped_mass`] |
//! | (33)-(35) | [`rotary_hinge`], [`linear_hinge`] |
//! | (36)-(40) | [`smooth_pin`] |
//! | section 4 | [`Scheme`], [`Run`], in the plane and in space |
//! | section 5.5 | [`Solver::Riccati`] |
//! | (5)-(12), (18)-(40) in space | [`spatial`]; [`Slots`] |
//! | (41)-(46) | `examples/paper_example_5.rs` |
//! | (47)-(60), loops, branches and networks | [`topology`]: equations of an instant |
//!
//! A beam is its segments, rods with hinges of EI/ℓ between them, and of 2EI/ℓ at a clamp.
//!
//! # Corrections
//!
//! | where | printed | holds |
//! |---|---|---|
//! | section 2.4 | ξ̈ and ξ̇ are "one order and two order derivative" | the other way round |
//! | (3) | χ₁ = I_k / (βΔT²), k = 2 in the plane | a number; θ has one component |
//! | (32) u₆₇ | m χ₁ (x G₂ + y **G₂**) | m χ₁ (x G₂ + y **G₁**) |
//! | (32) u₄₇ | ends with \[mχ₂ − f\]_y x_IC | goes on − \[mχ₂ − f\]_x y_IC |
//! | (20), (32) | G_I, J_I | about I, of the motion relative to I |
//! | below (31) | z_O and z_I at I and O | the other way round |
//! | (33)-(35) | no rest length, no rest angle | k(r_O − r_I − d₀), k′(θ_O − θ_I − φ₀) |
//! | (33)-(35) | m_O = m_I although r_O ≠ r_I | torques do not balance unless q points along r_O − r_I |
//! | section 3.4.3 | z_{j,j} | z_{j+1,j} |
//! | (40) | for any body | none where its outboard end is the centre of percussion |
//! | (49) | U₁ U_{l−1} .. | U_l U_{l−1} .. |
//! | (48) | for any loop | m = 0 for the row of m, which vanishes, where all joints are smooth pins |
//! | (50) | z_{l+1,l} | z_{l+1,j} |
//! | (55) | U_II⁻¹ | does not exist with a smooth pin inside II: z_{j+1,j} unknown instead |
//! | (60) | U_b1 (I − U_II); eight equations | U_b1 (U_II − I); nine, with U_b3 z_{j+1,j} = 0 |
//!
//! # Which rule survives where
//!
//! A double pendulum of two uniform rods (1 m, 1 kg each), at rest at −60°, steps of 10 ms: error of angles after 2 s (rad), of the force
//! at the root (N, of 24), and error of angles after 60 s or the time (s) at which an angle is 1 rad off or a step fails. Columns are
//! where the scheme is linearised, and joint coordinates. `examples/paper_example_1.rs` prints it.
//!
//! | rule | at t_{i−1}, as printed | at the predictor | iterated | [`JointScheme`] |
//! |---|---|---|---|---|
//! | Newmark γ = ½ | 6e-4, 51, **dies at 3.7** | 7e-4, 2e-2, **dies at 13** | 6e-4, 3e-2, **dies at 15** | 7e-4, 9e-3, 1.6e-2 |
//! | Newmark β = 1/6, γ = ½ | **dies at 0.14** | **dies at 0.15** | **dies at 0.13** | 4e-4, 4e-3, 8.6e-3 |
//! | Newmark γ = 0.6 | 8e-3, 2e-2, 0.4 | 8e-3, 2e-2, 0.4 | 8e-3, 2e-2, 0.4 | 8e-3, 2e-2, 0.4 |
//! | generalised-α (0.8) | 7e-4, 7e-3, 1.3e-2 | 7e-4, 7e-3, 1.3e-2 | 6e-4, 7e-3, 1.7e-2 | 8e-4, 9e-3, 1.7e-2 |
//! | HHT-α (0.1) | 8e-4, 8e-3, 1.5e-2 | 8e-4, 8e-3, 1.6e-2 | 8e-4, 8e-3, 2.0e-2 | 9e-4, 1e-2, 2.0e-2 |
//! | Wilson-θ (1.42) | 2e-3, 1e-2, 2.5e-2 | 2e-3, 1e-2, 2.6e-2 | 1e-3, 1e-2, 3.3e-2 | 2e-3, 2e-2, 3.3e-2 |
//! | Houbolt | 4e-3, 4e-2, 6.1e-2 | 4e-3, 4e-2, 6.2e-2 | 3e-3, 4e-2, 6.4e-2 | 4e-3, 5e-2, 5.7e-2 |
//! | Park | 1e-3, 1e-2, 2.6e-2 | 1e-3, 1e-2, 2.6e-2 | 1e-3, 1e-2, 3.1e-2 | 2e-3, 2e-2, 3.1e-2 |
//! | BDF2 | 3e-3, 3e-2, 4.5e-2 | 3e-3, 3e-2, 4.6e-2 | 3e-3, 3e-2, 5.2e-2 | 3e-3, 3e-2, 4.9e-2 |
//! | midpoint | 0.2, 3e3, **dies at 2.2** | 1e-4, 0.2, **dies at 14** | 6e-4, 0.8, **dies at 11** | 7e-4, 8e-3, 1.6e-2 |
//!
//! In space it is the same with either [slot](Slots): β = 1/6 dies within tenths of a second, with γ = ½ and by the midpoint rule forces
//! do not converge, all others have their orders. Multistep rules run with angles only. The predictor-corrector methods that the
//! paper names beside Houbolt's do not express ξ̈ by ξ: theirs is the acceleration level, [`Adams`](crate::planar::Adams).
//!
//! Where ground that moves clamps the root, errors of the midpoint rule alternate and do not fall with the step, or grow: angles of a rod that
//! is held fast by ground that turns as 0.4 sin 2t (rad), and of a second one on a pin, are 9e-4 rad off after 0.6 s with steps of 10 ms and
//! of 1.25 ms. Iterated, and in joint coordinates, the order is 2: 1.2e-4 and 1.5e-4 with steps of 10 ms.
//!
//! Orders in angles and forces are 1 for γ = 0.6 and 2 for all others that live, multistep rules from their first step on. Forces of
//! Wilson's and the midpoint rule belong to another instant, [`Run::balance_time`], and are compared there.
//!
//! What dies dies of γ = ½ on rigid joints, however small the step: 3.72, 4.48 and 5.62 s with steps of 10, 5 and 2 ms. Each position of a
//! body is integrated beside the angle that determines it, which makes the joints constraints of index 3; on these the rule's
//! amplification is −1, twice, and an alternating error grows. So the paper's "good agreement in over thirty periods" cannot be had with
//! β = ¼, γ = ½ as its section 4 reads. β = 1/6, and any β ≤ γ/2, dies within tenths of a second, the sooner the shorter the step: one
//! amplification is −1 or beyond. Such rules are allowed and say so: [`Rule::is_weak_on_rigid_joints`], and the
//! picture at [`Newmark`].
//!
//! # Loads in joints
//!
//! Laws in joints are told how the bodies on either side of a joint move, by which it turns and how fast; slides, springs and reflected
//! inertia of the [`JointMotion`](crate::planar::JointMotion) are zero, for at displacement level a joint has none of its own. A root that
//! is guided has its slide, and a load in joint 0 is a force along its line.
//!
//! # What it is good for
//!
//! For chains of moderate accuracy at a fixed cost: one sweep a step, linear, no iteration; with [`GeneralizedAlpha`] at the predictor it
//! is second order in forces too. It fails
//! * with γ = ½, above;
//! * solved by the product on long chains or at short steps: hardly a digit is left of 1000 bodies with steps of 10 ms, of 10 with 1 ms
//!   (`cargo bench --bench paper_digits`). [`Solver::Riccati`] works in increments and holds at 100 000 bodies;
//! * at the centre of percussion, by the product;
//! * where accuracy is wanted: to 1e-6 rad after 2 s of the pendulum above it takes 5100 sweeps, [`Dop853`](crate::planar::Dop853) 250.
//!
//! For anything but comparison use the crate's own [`simulate`](crate::simulate); for stiff hinges its
//! [`GeneralizedAlpha`] at acceleration level, which costs less a step.
//!
//! Runs ask for feature `alloc`; rules and matrices do not. Ends may be free, pinned, clamped or guided in the plane, and free, pinned, clamped
//! or hinged in space: boundary conditions of an overall equation ask for nothing else. Joints are pins, balls,
//! welds and hinges with rotary springs, in the plane also with linear ones, between two bodies or on ground that clamps the root. These
//! push along inertial axes and hand on m as it is, as (33) to (35) have it:
//! [`in_unbalanced_axes`](crate::planar::ElasticHinge::in_unbalanced_axes). Refused, with the place, are linear springs whose force has a
//! moment, and with them all of space's, laws that are not linear, joints that slide, joints about axes in space but at the ends, joints next to
//! ends that hold an attitude, and chains that branch; by the product also pins and balls where the tip holds an attitude, and linear springs
//! that leave an axis free. [`JointScheme`] runs
//! chains in the plane with free tips, without linear springs.

mod body;
mod collocation;
mod expansion;
mod hinge;
#[cfg(feature = "alloc")]
mod joints;
#[cfg_attr(not(feature = "alloc"), allow(dead_code))] // matrices read a part of it, runs all
mod link;
mod multistep;
mod newmark;
#[cfg(feature = "alloc")]
mod orient;
#[cfg(feature = "alloc")]
mod parts;
mod pin;
#[cfg(feature = "alloc")]
mod plane;
#[cfg(feature = "alloc")]
mod plane_scene;
#[cfg(feature = "alloc")]
mod product;
#[cfg(feature = "alloc")]
mod relation;
#[cfg(feature = "alloc")]
mod riccati;
mod rule;
#[cfg(feature = "alloc")]
mod scene;
#[cfg(feature = "alloc")]
mod scheme;
pub mod spatial;
pub mod topology;

pub use crate::time::GeneralizedAlpha;
pub use body::{External, Known, Rigid, lumped_mass, rigid_body};
pub use collocation::{Midpoint, Wilson};
pub use expansion::{At, Expansion};
pub use hinge::{Linear, Rotary, linear_hinge, rotary_hinge};
#[cfg(feature = "alloc")]
pub use joints::{JointRun, JointScheme};
pub use multistep::{Earlier, Multistep};
pub use newmark::{Newmark, hht_alpha};
pub use pin::{is_percussive, smooth_pin};
pub use rule::{Coordinate, Linearization, Rule};
#[cfg(feature = "alloc")]
pub use scene::{Scene, Slots};
#[cfg(feature = "alloc")]
pub use scheme::{Run, Scheme, Solver};
