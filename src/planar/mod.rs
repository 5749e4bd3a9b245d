//! The plane: seven-state vectors `[x, y, θ, m, q_x, q_y, 1]`, rigid bodies, pins and ends.
//!
//! ```
//! use catena::planar::*;
//!
//! let rod = Rod::uniform(1.0, 1.0); // length (m), mass (kg)
//! let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
//! let start = pendulum.at_rest(&[-1.0, -0.5])?; // absolute angles (rad)
//! assert_eq!(start.time(), 0.0);
//! # Ok::<(), catena::Error>(())
//! ```

pub mod axes;
mod beam;
mod body;
mod elastic_hinge;
mod ends;
mod frame;
mod joint;
mod kinematics;
mod linear;
mod linear_hinge;
mod loads;
mod loops;
mod pin;
mod point_mass;
mod release;
mod rigid_body;
mod rod;
mod sensitive;
mod series;
mod slider;
mod spring;
mod station;
mod transfer;
mod turning;
mod weld;

pub use crate::chain::{Branch, LeastNorm, Name, Named, Network};
pub use crate::loading::{InJoints, LoadLaw, Loads, OnBodies, Unloaded, Values};
pub use crate::relation::Absent;
pub use crate::relation::plane::Planar;
pub use crate::spring::{Spring, SpringLaw};
pub use crate::stepper::Stepper;
pub use crate::struts::{Strut, Struts};
pub use crate::sweep::Springs;
pub use crate::time::{Adams, Dop853, Dopri5, GeneralizedAlpha, Rk4, Sdirk4, Taylor};
pub use beam::{Beam, Segments, Stretch};
pub use body::{Base, Body, Inertia, Pose};
pub use elastic_hinge::{ElasticHinge, HingeRule, Revolute};
pub use ends::{Attitude, Clamped, Floating, Free, Ground, GroundMotion, Guided, Moving, Pinned, Turning};
pub use frame::{Acceleration, BodyMotion, Frame, Internal, JointMotion, SpringState, Turn};
pub use joint::Joint;
pub use linear::{HingeAxes, Linear, Unbalanced};
pub use linear_hinge::{LinearGains, Rotation};
pub use loads::Wrench;
pub use loops::ClosedLoop;
pub use pin::Pin;
pub use point_mass::PointMass;
pub use rigid_body::RigidBody;
pub use rod::Rod;
pub use sensitive::{Answering, Passing, Pulling};
pub use series::Articulated;
pub use slider::Slider;
pub use spring::Custom;
pub use station::{Station, index};
pub use weld::Weld;

/// A planar scene.
pub type System<T, R, C, P> = crate::system::System<Planar<T>, R, C, P>;
