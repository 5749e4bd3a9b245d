//! The costate sweep in axes of bodies.
//!
//! What [`adjoint`](crate::mechanics::spatial::adjoint) carries are vectors of one instant, so its equations hold in any axes: between
//! [`BodyAxes`](super::BodyAxes) and [`Flange`](super::Flange) all that is carried and kept is in axes of the body that is met.

pub mod joints;
pub mod links;
pub mod mounts;
