//! Spatial chains against a dense system of Newton-Euler equations.

mod hinges;
#[path = "../../../../../../tests/it/forces/space/twins.rs"]
pub mod twins;
