#![forbid(unsafe_code)]
#![no_std]
//! Catena.
#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

mod tuples;

pub mod chain;
pub mod counts;
pub mod element;
pub mod ends;
mod error;
mod inspect;
pub mod mirror;
mod motion;
pub mod observe;
pub mod planar;
pub mod relation;
pub mod scalar;
pub mod simulate;
pub mod solve;
mod state;
pub mod stepper;
pub mod system;
pub mod time;
pub mod transfer;

pub use error::{Error, Fault, Place};
pub use motion::Motion;
pub use scalar::{Real, Scalar};
pub use state::{StateVector, TransferMatrix};
