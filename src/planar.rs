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
pub use crate::couplings::{Coupling, Couplings};
pub use crate::driven::Driven;
pub use crate::guarded::{BoundedCoulomb, Coulomb, HardStops};
pub use crate::mechanics::planar::{
    Beam, ClosedLoop, ElasticHinge, Inertia, Linear, Pin, PointMass, Revolute, RigidBody, Rod, Segments, Slider,
    Unbalanced, Weld,
};
pub use crate::relation::Absent;
pub use crate::relation::planar::Planar;
pub use crate::spring::{Custom, Spring};
pub use crate::stepper::Stepper;
pub use crate::struts::{StiffStruts, Strut, StrutReading, Struts};

// Named by users as if they stood here.
#[doc(hidden)]
pub use self::{ends::*, laws::*, loads::*, readings::*, rules::*};

/// Ends of a scene, on ground that rests or moves. All are in [`planar`](crate::planar), too.
pub mod ends {
    pub use crate::mechanics::planar::{
        Clamped, Floating, Free, Ground, GroundMotion, Guided, Moving, Pinned, Turning,
    };
}

/// Laws of joints: springs of one's own, friction, motors and stops, coordinates given as functions of time. All are in [`planar`](crate::planar), too.
pub mod laws {
    pub use crate::driven::MotionLaw;
    pub use crate::spring::{DryFriction, Motor, SpringLaw, Stops};
    pub use crate::sweep::Springs;
}

/// What acts on a scene. All are in [`planar`](crate::planar), too; [`loading`](crate::loading) says more.
pub mod loads {
    pub use crate::loading::{ForceElement, ForceLaw, InJoints, LoadLaw, Loads, OnBodies, Unloaded, Values};
}

/// What is read from a motion. All are in [`planar`](crate::planar), too.
pub mod readings {
    pub use crate::mechanics::planar::{
        Acceleration, BodyMotion, Frame, Internal, JointMotion, Station, Turn, Wrench, index,
    };
}

/// Rules of time. All are in [`planar`](crate::planar), too; [`guide`](crate::guide::choosing_a_rule) says which to choose.
pub mod rules {
    pub use crate::time::{
        Adams, Auto, AutoTaylor, Dop853, Dopri5, GeneralizedAlpha, MoreauJean, Rk4, Sdirk4, Taylor, Vcabm,
    };
}

/// A planar scene.
pub type System<T, R, C, P> = crate::system::System<Planar<T>, R, C, P>;
