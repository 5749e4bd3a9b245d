//! The method in three pages: transfer matrices, accelerations, a symmetric Riccati sweep.
//!
//! # Transfer matrices
//!
//! A state vector at a station holds its motion and the internal force and torque there: in the plane `z = (x, y, θ, m, q_x, q_y, 1)`. Over a
//! step of time a rule makes acceleration linear in position (for Newmark's, ẍ = χ₁ x + χ₂), so that each element
//! maps the state at its inboard end to that at its outboard end by a matrix:
//!
//! ```text
//!   z_O = U z_I            z_tip = U_n … U_2 U_1 z_root = U_all z_root
//! ```
//!
//! Of the six numbers at each end three are known (a pinned end has x, y and m = 0), so three equations of `U_all` give the three unknowns at the
//! root, and walking outward again gives all states: the discrete-time transfer matrix method of Rui, He, Lu, Lu and Wang (2005). The
//! matrix has seven rows however long the chain is. [`paper`](crate::paper) is this scheme as published.
//!
//! # Accelerations as unknowns
//!
//! Linearising in positions leaves an error of order two in the matrices and ties them to one rule. This library takes accelerations
//! instead: at given positions and rates the equations of motion *are* linear in accelerations and forces, so the matrices are exact, and any
//! rule may use what they give. For a rod with arm r from I to O, mass centre at r_C, angular velocity ω, under gravity g:
//!
//! ```text
//!   a_O = a_I + α ẑ × r − ω² r
//!   q_O = q_I − m (a_I + α ẑ × r_C − ω² r_C − g) + f
//!   m_O = m_I + moments about I
//! ```
//!
//! # Condensation
//!
//! A product of many matrices loses digits: what grows along the chain drowns what does not. So the walk inward carries no product but a
//! relation of force to acceleration at each station (the Riccati transform of the method):
//!
//! ```text
//!   F = S p + e            F = (q, −m): force and torque on all that lies outboard
//!                          p = (a, α):  acceleration of the station
//! ```
//!
//! S is symmetric and positive definite: the inertia felt there, the field's articulated-body inertia. A body adds its own inertia and moves
//! S along its arm. A joint takes a coordinate out: along its axis u the torque is known, τ = uᵀ (S p + e), so
//!
//! ```text
//!   φ̈ = (τ − uᵀ e − uᵀ S p) / (uᵀ S u)           the gains, kept
//!   S ← S − S u uᵀ S / (uᵀ S u)                  e ← e + S u (τ − uᵀ e) / (uᵀ S u)
//! ```
//!
//! At the root the end conditions give p; walking outward, each joint's kept gains give its acceleration. Two walks, some seventy
//! instructions a body in the plane, exact to rounding on chains of 100 000 bodies. Where a pin bears no torque S shrinks to 2 × 2: types
//! decide that, and a compiler removes the rest.
//!
//! By hand, beside the library's own, that is the example `two_walks`. Green is the inertia felt at a pin, S u for all directions u.
//!
#![doc = concat!("<div>\n", include_str!("../../docs/pictures/two_walks.svg"), "\n</div>")]
//!
//! # Loops and held tips
//!
//! Forces λ that close a loop ride inward as columns: F = S p + e + W λ, with −Wᵀ p + Λ λ + y₀ = 0. Where the loop begins they are eliminated
//! like a coordinate, so a loop costs nothing outside of it; those of a held tip are found at the root. Positions and rates are
//! projected back onto the closures through the same gains after each step.
//!
//! # Rules, derivatives
//!
//! Explicit rules only ask for accelerations. Implicit ones add what a step does to springs, K̂ = (χ) k, to the pivots uᵀ S u, and stay
//! linear. A derivative forward repeats the walks with the gains kept; one backward walks them in the opposite order with their transposes. Taylor
//! series of any order pass through the same gains, each coefficient by one pair of walks.
//!
//! # Literature
//!
//! - X. Rui, B. He, Y. Lu, W. Lu, G. Wang: *Discrete Time Transfer Matrix Method for Multibody System Dynamics*, Multibody System Dynamics
//!   14 (2005) 317–344.
//! - R. Featherstone: *Rigid Body Dynamics Algorithms*, Springer 2008: the articulated-body algorithm.
//! - E. Hairer, S. P. Nørsett, G. Wanner: *Solving Ordinary Differential Equations I*, Springer 1993: Dormand and Prince, error control.
//! - L. F. Shampine, M. K. Gordon: *Computer Solution of Ordinary Differential Equations*, Freeman 1975: variable order.
//! - J. Chung, G. M. Hulbert: *A Time Integration Algorithm for Structural Dynamics With Improved Numerical Dissipation: The
//!   Generalized-α Method*, Journal of Applied Mechanics 60 (1993) 371–375.
