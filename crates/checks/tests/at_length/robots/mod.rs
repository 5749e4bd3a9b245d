//! Robots in other forms and numbers, and functions of lists against mass matrices from Jacobians.

mod forms;
mod functions;
#[allow(dead_code)] // a robot that floats is for others
#[path = "../../../../../tests/it/robots/kit.rs"]
mod kit;
