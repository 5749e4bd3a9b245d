//! The builder's door: joints, bodies, laws and ends of other crates.

mod leaf;

pub use crate::kinematics as model;
pub use crate::kinematics::{Acting, Driving, JointModel, Jointed, Kinematics, Outboard, Resistance};
pub use typenum::{U0 as None, U1 as One};
