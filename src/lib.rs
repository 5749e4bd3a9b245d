#![forbid(unsafe_code)]
#![no_std]
//! Multibody dynamics by the discrete-time transfer matrix method: a generic, const-dimension, compile-time library.
//!
//! A program embeds a mechanical scene, steps it in time without allocating, asks for derivatives of anything with respect to
//! anything by running the same code on dual numbers, and reads internal forces at every connection for free: they are the
//! state.
//!
//! ```
//! use catena::planar::*;
//!
//! let length = 1.0_f64; // (m); all numbers of a scene are of the type that one of them names
//! let rod = Rod::uniform(length, 1.0); // length (m), mass (kg)
//! let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
//! let start = pendulum.at_rest(&[-1.0, -0.5])?; // absolute angles (rad)
//! let end = 6.0 * (length / 9.81).sqrt(); // (s); of `1.0` without `_f64` the compiler could not take a root (E0689)
//! pendulum.simulate(start, Dop853::tolerance(1e-12), end, |now| println!("{:.3} {:?}", now.time(), now.angles()))?;
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! # The method
//!
//! Each element of a chain maps the state at its inboard end (motion, internal torque and force) to that at its outboard end.
//! X. Rui, B. He, Y. Lu, W. Lu and G. Wang, *Discrete Time Transfer Matrix Method for Multibody System Dynamics*, Multibody
//! System Dynamics 14 (2005), multiply these matrices and solve for the unknowns of the two ends; numbers of equations in these
//! pages are theirs. This library takes accelerations as the unknowns, which makes the matrices exact, and condenses them by a
//! symmetric Riccati sweep, which keeps its digits on chains of any length.
//!
//! # Conventions
//!
//! SI units throughout. A planar angle is measured from +x, counter-clockwise, and never wrapped. Errors are values
//! that say when, where and what: [`Error`].
//!
//! On a body the force +q acts at its inboard end I and −q at its outboard end O, the torque −m at I and +m at O. A
//! massless joint passes q and, if its two points coincide, m. So q at the root is the force of the ground on the first
//! body. The relation uses F = (q, −m), the force and torque *on the outboard part*. A torque in a joint acts on the
//! outboard body, and its opposite on the inboard one.
//!
//! # Where things are
//!
//! | module | what a user finds there |
//! |---|---|
//! | [`planar`], [`spatial`] | all that a scene in the plane or in space is made of: bodies, joints, springs, ends, loads, rules of time |
//! | [`robot`] | arms and legged machines in space, in axes of their bodies: what a description has zeros of costs nothing; functions of arrays |
//! | [`system`] | a scene and what can be asked of it; bounds for functions over scenes of any kind |
//! | [`loading`] | what acts on a scene |
//! | [`time`] | rules that step it, their coefficients and tolerances |
//! | [`simulate`] | runs: output, events, observers, saved runs, single steps, ensembles |
//! | [`observe`] | what is read from a motion |
//! | [`modes`], [`sensitivity`] | frequencies and modes of vibration; derivatives of runs |
//! | [`scalar`] | the numbers: real, dual, lanes, jets |
//! | [`extend`] | elements, laws and walks of one's own |
//! | [`paper`] | the formulation of 2005, apart from all others |
//!
//! # Floors
//!
//! A file imports from its own floor or lower ones. Modules that are not public hold what users need not name.
//!
//! | floor | modules |
//! |---|---|
//! | 0 | `scalar`, errors, names and numbers, [`StateVector`] and [`TransferMatrix`] |
//! | 1 | [`Lift`], `mirror`, `relation` (the kernels), `time` (coefficients of the rules), dense algebra in the small |
//! | 2 | `space`, `loading`, `sweep`, laws of springs, `shape` (what a chain is), `walks` (what is done along it), `visit`, `element` (the contract: read this first), `ends`, `transfer`, turning, motions, `sensitive` and `adjoint` (the contracts of derivatives), `series`, `release` and `kinematics` (what a joint says of itself, and how it moves) |
//! | 3 | `chain` (composition: tuples, arrays, vectors, branches, networks), `counts`, `struts` |
//! | 4 | `mechanics` (bodies, joints and ends in the plane and in space) |
//! | 5 | `solve`, `observe` |
//! | 6 | `system` |
//! | 7 | `stepper`, `simulate`, `observers`, `modes`, `sensitivity`, `paper`, `extend` |
//! | 8 | `planar`, `spatial`, `robot`: front pages, which nothing below reads |
//!
//! # Features
//!
//! `std` (default, modes of vibration), `alloc` (vectors of elements, static equilibrium), `libm` (numbers without `std`), `num-dual` (dual numbers), `simd` (lanes), `rayon` (ensembles of runs on all threads), `reproducible` (below).
//! Without `std` and `libm` the crate compiles but brings no numbers: implement [`Scalar`] for yours.
//!
//! # The same bits everywhere
//!
//! With feature `reproducible` a run of plain numbers or lanes has the same bits on every machine whose arithmetic is that of IEEE 754, in
//! debug and release: no product is fused with a sum, sums have the order in which they are written, and elementary functions are those
//! of this crate (sine and cosine) or of the crate `libm`, never the platform's. Not promised: bits of a not-a-number; dual numbers of
//! `num-dual`; what a closure of yours computes by the platform's functions (take [`Scalar`]'s); frequencies and modes; x86 without SSE2.
//! A program pays with fused multiply-add: on x86-64-v3 it takes more instructions.

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

mod tuples;
mod turning;

mod adjoint;
mod chain;
mod counts;
#[cfg(feature = "alloc")]
mod dense;
mod element;
mod ends;
mod error;
pub mod extend;
#[doc(hidden)]
pub mod internals;
mod kinematics;
mod lift;
pub mod loading;
mod mechanics;
mod mirror;
#[cfg(feature = "std")]
pub mod modes;
mod motion;
mod names;
pub mod observe;
mod observers;
pub mod paper;
pub mod planar;
mod relation;
mod release;
pub mod scalar;
mod sealed;
mod sensitive;
pub mod sensitivity;
mod series;
mod shape;
pub mod simulate;
mod solve;
mod space;
pub mod spatial;
mod spring;
mod state;
mod stepper;
mod struts;
mod sweep;
pub mod system;
pub mod time;
mod transfer;
mod visit;
mod walks;

// After `spatial`, whose items it names once more: compilers say where an item is first found.
pub mod robot;

// Their types stand in this library's own: users take them from here rather than meet a second version of them.
pub use nalgebra;
#[cfg(feature = "num-dual")]
pub use num_dual;

pub use error::{Cause, Error, Fault, Place};
pub use lift::Lift;
pub use motion::Motion;
pub use names::{BodyNumbers, JointNumbers, Label, Which};
pub use scalar::{Real, Scalar};
pub use state::{StateVector, TransferMatrix};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadMe;
