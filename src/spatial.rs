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

pub use crate::chain::{Branch, LeastNorm, Name, Named, Network};
pub use crate::couplings::{Coupling, Couplings};
pub use crate::driven::Driven;
pub use crate::guarded::{BoundedCoulomb, Coulomb, HardStops};
pub use crate::mechanics::spatial::{
    Ball, Beam, ClosedLoop, Cylindrical, ElasticBall, ElasticHinge, Inertia, Linear, PointMass, Prismatic, Revolute,
    RigidBody, Rod, RotarySpring, Rotation, Segments, Universal, Weld, maps,
};
pub use crate::relation::Absent;
pub use crate::relation::spatial::Spatial;
pub use crate::relation::spatial::algebra::{Columns, Symmetric3};
pub use crate::spring::{Custom, Spring};
pub use crate::stepper::Stepper;
pub use crate::struts::{StiffStruts, Strut, StrutReading, Struts};

// Named by users as if they stood here.
#[doc(hidden)]
pub use self::{ends::*, laws::*, loads::*, readings::*, rules::*};

/// Ends of a scene, on ground that rests or moves. All are in [`spatial`](crate::spatial), too.
pub mod ends {
    pub use crate::mechanics::spatial::{
        AttitudeMotion, Clamped, Floating, Free, Ground, GroundMotion, Hinged, Moving, Pinned, Turning,
    };
}

/// Laws of joints: springs of one's own, friction, motors and stops, coordinates given as functions of time. All are in [`spatial`](crate::spatial), too.
pub mod laws {
    pub use crate::driven::MotionLaw;
    pub use crate::mechanics::spatial::RotaryLaw;
    pub use crate::spring::{DryFriction, Motor, SpringLaw, Stops};
    pub use crate::sweep::Springs;
}

/// What acts on a scene. All are in [`spatial`](crate::spatial), too; [`loading`](crate::loading) says more.
pub mod loads {
    pub use crate::loading::{ForceElement, ForceLaw, InJoints, LoadLaw, Loads, OnBodies, Unloaded, Values};
    pub use crate::mechanics::spatial::{Contact, Contacts, Effort, Heights, PlainContacts, Plane, Surface};
}

/// What is read from a motion. All are in [`spatial`](crate::spatial), too.
pub mod readings {
    pub use crate::mechanics::spatial::{
        Acceleration, BodyMotion, Frame, Internal, JointMotion, Station, Turn, Wrench, index,
    };
}

/// Rules of time. All are in [`spatial`](crate::spatial), too; [`guide`](crate::guide::choosing_a_rule) says which to choose.
pub mod rules {
    pub use crate::time::{
        Adams, Auto, AutoTaylor, Dop853, Dopri5, GeneralizedAlpha, MoreauJean, Rk4, Sdirk4, Taylor, Vcabm,
    };
}

/// A spatial scene.
pub type System<T, R, C, P> = crate::system::System<Spatial<T>, R, C, P>;
