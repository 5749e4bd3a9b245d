//! Many scenes at once: in the lanes of a number, and on all threads.
//!
//! A scene over [`WideF64x4`](crate::scalar) is four scenes that differ in their numbers (feature `simd`), and
//! [`ensemble`](crate::simulate) hands parameters to all threads (feature `rayon`). Both together:
//!
//! ```
//! # #[cfg(all(feature = "simd", feature = "rayon"))] {
//! use catena::planar::*;
//! use catena::scalar::{Scalar, WideF64x4};
//! use catena::simulate::ensemble;
//!
//! /// Angles (rad) after a second, of four rods let go at four angles.
//! fn four(starts: [&f64; 4]) -> Result<[f64; 4], catena::Error> {
//!     let number = WideF64x4::literal;
//!     let rod = Rod::uniform(number(1.0), number(1.0));
//!     let rod = System::new(Pinned::origin(), rod, Free)?.with_gravity(number(9.81));
//!     let start = rod.at_rest(&[WideF64x4::from(starts.map(|start| *start))])?;
//!     let run = rod.simulate(start, Rk4::step(1e-2), 1.0, |_| ())?;
//!     Ok(run.motion.coordinates()[0].into_arr())
//! }
//! let starts: Vec<f64> = (0..10).map(|k| -0.1 * f64::from(k)).collect(); // any number of them
//! let ends = ensemble(&starts).run_in_lanes(four);
//! assert!(ends.len() == 10 && ends.iter().all(Result::is_ok));
//! # }
//! ```
//!
//! Lanes share their steps: with fixed steps each has the bits of a run by itself (loops to rounding; starts
//! that are assembled from afar may be others than alone), under error control the worst of
//! the four decides. An error in one ends all, and an ensemble then runs each anew. Events are refused: each lane would have its own. Lanes pay where vectors do:
//! build for the machine, `RUSTFLAGS="-C target-cpu=native"`.
