#![forbid(unsafe_code)]
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))] // labels of features, where documentation is built for all of them
//! Multibody dynamics to embed in a program: a mechanical scene is a type, a step allocates nothing, and everything has derivatives.
//!
#![doc = concat!("<div>\n", include_str!("../docs/pictures/double_pendulum.svg"), "\n</div>")]
//!
//! ```
//! use catena::planar::*;
//!
//! let length = 1.0_f64; // (m); all numbers of a scene are of the type that one of them names
//! let rod = Rod::uniform(length, 1.0); // length (m), mass (kg)
//! let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
//! let start = pendulum.at_rest(&[-1.0, -0.5])?; // absolute angles (rad)
//! let end = 6.0 * (length / 9.81).sqrt(); // (s); without `_f64` there is no root (E0689)
//! pendulum.simulate(start, Dop853::tolerance(1e-12), end, |now| {
//!     println!("{:.3} {:?}", now.time(), now.angles());
//! })?;
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! # What do you want to do?
//!
//! | to | see |
//! |---|---|
//! | build a scene | [`planar`], [`spatial`]: bodies, joints, springs, ends; [`robot`]: arms and legged machines in axes of their bodies |
//! | find out which number is whose | [`guide::numbering`], [`System::describe`](system::System::describe) |
//! | close loops, hold tips | [`guide::loops`] |
//! | let forces and torques act | [`guide::loads`], [`loading`] |
//! | run it | [`simulate`]: output, events, saved runs, single steps, ensembles; [`guide::choosing_a_rule`], [`time`] |
//! | set and read motions | [`guide::coordinates`], [`observe`], [`Motion`] |
//! | find its rest, its vibrations, whether a steady motion lasts | [`equilibrium`](system::System::equilibrium), [`modes`], [`complex_modes`](system::System::complex_modes) |
//! | differentiate it | [`guide::derivatives`], [`sensitivity`] |
//! | run many at once | [`guide::lanes_and_threads`], [`scalar`] |
//! | run it on a microcontroller, on time | [`guide::no_std`] |
//! | add an element or a law | [`guide::own_elements`], [`extend`] |
//! | write functions over scenes of any kind | [`system`] |
//! | know how it works | [`guide::method`]; [`paper`], the formulation of 2005, apart from all others |
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
//! # Features
//!
//! | feature | brings |
//! |---|---|
//! | `std` (default) | modes of vibration, traces, and what `alloc` brings |
//! | `alloc` | vectors of elements, static equilibrium |
//! | `libm` | numbers without `std` |
//! | `num-dual` | dual numbers |
//! | `simd` | lanes: several scenes at once |
//! | `rayon` | ensembles of runs on all threads |
//! | `reproducible` | the same bits everywhere, below |
//! | `serde` | scenes, motions and saved runs as data |
//!
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
mod couplings;
#[cfg(feature = "serde")]
mod data;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod dense;
mod driven;
mod element;
mod ends;
mod error;
pub mod extend;
mod guarded;
#[cfg(any(doc, doctest))]
pub mod guide;
mod inner;
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
#[doc(hidden)] // listed in `extend`
pub use lift::Lift;
pub use motion::Motion;
#[doc(hidden)] // listed in `system`
pub use names::{BodyNumbers, JointNumbers, Label, Which};
pub use scalar::{Elementary, Real, Scalar};
#[doc(hidden)] // listed in `observe`
pub use state::{StateVector, TransferMatrix};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadMe;
