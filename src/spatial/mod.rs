//! Space: thirteen-state vectors `[r, θ, m, q, 1]`, rigid bodies, joints and ends.
//!
//! Names are those of [`planar`](crate::planar). Attitudes are unit quaternions and have no singular place; the paper's angles 1-2-3
//! serve for input and output.
//!
//! ```
//! use catena::spatial::*;
//!
//! let rod = Rod::uniform(1.0, 0.05, 1.0); // length, radius (m), mass (kg)
//! let pendulum = System::new(Pinned::origin(), (rod, Ball, rod), Free)?.with_gravity([0.0, -9.81, 0.0]);
//! let start = pendulum.at_rest(&[0.0, 0.0, -1.0, 0.0, 0.3, -0.5])?; // absolute angles 1-2-3 of both bodies (rad)
//! let run = pendulum.simulate(start, Dop853::tolerance(1e-10), 1.0, |now| println!("{:?}", now.angles()))?;
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! Attitudes and places come from nalgebra and go there by `from` and `into`:
//!
//! ```
//! use catena::nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, Vector3};
//! use catena::spatial::*;
//!
//! // A wall bracket 2 m up, turned by 30 degrees about z, and on it a flap on a hinge.
//! let turned = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 30_f64.to_radians());
//! let wall = Isometry3::from_parts(Translation3::new(0.0, 0.0, 2.0), turned);
//! let flap = Rod::uniform(0.5, 0.02, 1.0);
//! let hinge = Revolute::about([0.0, 1.0, 0.0]);
//! let scene = System::new(Clamped::from(wall), (flap, hinge, flap), Free)?.with_gravity([0.0, 0.0, -9.81]);
//! let start = scene.motion();
//!
//! let bodies = scene.body_motions(&start)?;
//! if let Some(outer) = bodies.get(1) {
//!     let tip = Isometry3::from(*outer) * Point3::new(0.5, 0.0, 0.0); // from axes of the body to inertial ones
//!     assert!((tip - Point3::new(0.75_f64.sqrt(), 0.5, 2.0)).norm() < 1e-15);
//! }
//! # Ok::<(), catena::Error>(())
//! ```

mod angles;
mod axial;
mod axial_walks;
mod ball;
mod beam;
mod body;
mod cylindrical;
mod elastic_hinge;
mod ends;
mod frame;
mod inertia;
mod isometry;
mod joint;
mod kinematics;
mod linear_hinge;
mod loads;
mod loops;
pub mod maps;
mod point_mass;
mod prismatic;
mod release;
mod revolute;
mod rigid_body;
mod rod;
mod rotary_spring;
mod rotation;
mod second_moments;
mod sensitive;
mod spring;
mod station;
mod transfer;
mod turning;
mod universal;
mod weld;

pub use crate::chain::{Branch, LeastNorm, Name, Named, Network};
pub use crate::loading::{InJoints, LoadLaw, Loads, OnBodies, Unloaded, Values};
pub use crate::relation::Absent;
pub use crate::relation::space::Spatial;
pub use crate::spring::{Spring, SpringLaw};
pub use crate::stepper::Stepper;
pub use crate::struts::{Strut, Struts};
pub use crate::sweep::Springs;
pub use crate::time::{Adams, Dop853, Dopri5, GeneralizedAlpha, Rk4, Sdirk4};
pub use axial::{Axial, Listed, Relative};
pub use ball::Ball;
pub use beam::{Beam, Retardation, Segments, Stretch};
pub use body::{Body, Pose};
pub use cylindrical::Cylindrical;
pub use elastic_hinge::{BallRule, ElasticBall, ElasticHinge, Place};
pub use ends::{
    Attitude, AttitudeMotion, Clamped, Floating, Free, Ground, GroundMotion, Hinged, Moving, Pinned, Turning,
};
pub use frame::{Acceleration, BodyMotion, Frame, Internal, JointMotion, Turn};
pub use inertia::Inertia;
pub use joint::{Joint, Sets, Stored};
pub use linear_hinge::{Linear, RotaryElimination};
pub use loads::{Drive, Effort, Wrench};
pub use loops::ClosedLoop;
pub use point_mass::PointMass;
pub use prismatic::Prismatic;
pub use release::Release;
pub use revolute::Revolute;
pub use rigid_body::RigidBody;
pub use rod::Rod;
pub use rotary_spring::{RotaryDamper, RotaryLaw, RotarySpring};
pub use rotation::Rotation;
pub use spring::PivotRule;
pub use station::{Station, index};
pub use universal::Universal;
pub use weld::Weld;

/// A spatial scene.
pub type System<T, R, C, P> = crate::system::System<Spatial<T>, R, C, P>;
