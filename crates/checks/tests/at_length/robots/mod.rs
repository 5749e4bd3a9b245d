//! Robots in other forms and numbers, and functions of lists against mass matrices from Jacobians.

mod forms;
mod functions;
#[path = "../../../../../tests/it/robots/kit.rs"]
mod kit;
