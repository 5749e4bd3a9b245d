#![forbid(unsafe_code)]
//! Reads a robot's description (URDF) in a build script, and writes it as a Rust module: its type as a scene of `catena`, its
//! numbers as literals generic over the scalar, names of joints and frames as constants, and a test.
//!
//! A build script:
//!
//! ```no_run
//! use catena_urdf::{Error, Options};
//!
//! fn main() -> Result<(), Error> {
//!     // Says what is left out, as warnings with lines; and what was snapped and repaired.
//!     Options::new().snap(1e-6).repair().build("robots/arm.urdf")?;
//!     Ok(())
//! }
//! ```
//!
//! The program:
//!
//! ```ignore
//! use catena::spatial::*;
//!
//! include!(concat!(env!("OUT_DIR"), "/arm.rs")); // a module `arm`
//!
//! fn main() -> Result<(), catena::Error> {
//!     let robot = arm::scene::<f64>()?; // or f32, dual numbers, lanes
//!     let mut torques = [0.0; arm::JOINTS.len()];
//!     torques[arm::joint::ELBOW] = 12.0; // (N·m)
//!     let moving = robot.with_accelerations(robot.motion(), &Loads::none().efforts(arm::efforts(torques)))?;
//!     println!("{:?}", moving.acceleration());
//!     Ok(())
//! }
//! ```
//!
//! # What it does
//!
//! Fixed links become part of what carries them ([`Robot`]), and stay as frames. Axes of bodies are chosen so that zeros show
//! ([`Frames`]). Angles near a right one are snapped on request ([`Options::snap`]), moments of inertia that no body has are repaired
//! on request ([`Options::repair`]). All that is left out or changed is noted with its lines ([`Note`]); what makes no mechanics is an
//! [`Error`] with its line. No text makes it panic or run away.
//!
//! The test in a module compares the scene's forward dynamics with mass matrix and torques that this crate computed
//! ([`Robot::inverse_dynamics`]), by code of its own.
//!
//! # Conventions
//!
//! SI units. Coordinates of joints are zero where the description says so and grow as it says, whatever the axes of bodies. The origin
//! of a body is at its joint, in [`Elements::Local`] anywhere on its axis: [`Frame`]s say where links stand. A floating base comes first, with velocity in axes of the ground and angular velocity in its own.

mod algebra;
mod build;
mod dynamics;
mod emit;
mod error;
mod frames;
mod inertia;
mod laws;
mod lump;
mod model;
mod note;
mod options;
mod read;
mod robot;
mod tree;
mod zeros;

pub use dynamics::{State, solve};
pub use emit::module;
pub use error::{Error, Fault};
pub use frames::Frames;
pub use inertia::Inertia;
pub use laws::Laws;
pub use model::{Furniture, Mimic, Pose};
pub use note::{Note, Remark};
pub use options::{Base, Elements, Options};
pub use robot::{Body, Carrier, Frame, Robot};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadMe;
