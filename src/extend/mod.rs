//! The builder's door: joints, bodies, laws and ends of other crates.

#[cfg(feature = "alloc")]
mod check;
mod compound;
mod leaf;

#[cfg(feature = "alloc")]
pub use check::{Disagreement, Doubt, check_element};

pub use crate::kinematics as model;
pub use crate::kinematics::{Acting, Driving, JointModel, Kinematics, Outboard, Resistance};
pub use crate::release::{Freedom, Release, Way};
pub use typenum::{U0 as None, U1 as One};
