//! Bodies, joints and ends, and how they move: in the plane and in space.

pub mod planar;
pub mod spatial;
