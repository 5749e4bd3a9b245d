//! Robots in axes of their bodies, against mass matrices from Jacobians.

mod kit;
mod motion;
