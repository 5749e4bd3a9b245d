//! Robots in axes of their bodies, against mass matrices from Jacobians.

mod forms;
mod functions;
mod kit;
mod motion;
