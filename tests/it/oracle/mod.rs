//! Second opinions: dense systems that share no code with the crate.

mod against_itself;
pub mod extrapolation;
pub mod plane;
pub mod space;
