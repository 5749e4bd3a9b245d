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

pub use crate::chain::{Branch, LeastNorm, Name, Named, Network};
pub use crate::loading::{InJoints, LoadLaw, Loads, OnBodies, Unloaded, Values};
pub use crate::mechanics::planar::{
    Acceleration, Attitude, Beam, BodyMotion, Clamped, ClosedLoop, Custom, ElasticHinge, Floating, Frame, Free, Ground,
    GroundMotion, Guided, Inertia, Internal, JointMotion, Linear, Moving, Pin, Pinned, PointMass, Revolute, RigidBody,
    Rod, Segments, Slider, Station, Turn, Turning, Unbalanced, Weld, Wrench, index,
};
pub use crate::relation::Absent;
pub use crate::relation::planar::Planar;
pub use crate::spring::{Spring, SpringLaw};
pub use crate::stepper::Stepper;
pub use crate::struts::{Strut, Struts};
pub use crate::sweep::Springs;
pub use crate::time::{Adams, Auto, Dop853, Dopri5, GeneralizedAlpha, Rk4, Sdirk4, Taylor, Vcabm};

/// A planar scene.
pub type System<T, R, C, P> = crate::system::System<Planar<T>, R, C, P>;
