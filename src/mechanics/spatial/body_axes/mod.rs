//! Bodies and joints whose relations and accelerations are in axes of the bodies, with zeros as types: robots.
//!
//! The axes of a body begin at its joint, z along the axis of that. A relation that a hinge hands on has 15 numbers of 21 before it turns
//! by the angle, which costs 8 operations for a symmetric pair; then comes a constant turn, mostly none or a permutation, then the shift to
//! the origin of the parent, along those axes that it has. This is the articulated-body recursion in successive axial screws (K. W. Lilly;
//! S. McMillan and D. E. Orin, *Efficient computation of articulated-body inertias using successive axial screws*, IEEE Transactions on
//! Robotics and Automation 11, 1995), with the zeros of a description taken out at compile time.

pub mod angles;
mod axis;
mod axis_inner;
mod axis_joint;
mod axis_sweep;
pub mod backward;
mod closures;
pub mod composite;
pub mod factor;
mod flange;
pub mod inverse;
mod link;
mod loaded;
mod mount;
mod number;
pub mod places;
mod relation;
mod rotor;
mod sensitive;
pub mod solids;
mod sparse;
mod standing;
mod through;
mod tilted;
mod torques;
mod turns;

pub use axis::{AboutZ, AlongZ, Armature, Axis, Bearing, Hinge, Mode, OnBody, OnGround, Slide};
pub use flange::Flange;
pub use link::Link;
pub use loaded::{Block, Yielding};
pub use mount::{Base, BodyAxes, Upright};
pub use places::Place;
pub use relation::{Gains, Local};
pub use rotor::{Rotor, Sharing};
pub use standing::Stand;
pub use torques::Torques;
pub use turns::{Ahead, Leaning, Level, Offset, Quarter, Turned};
