//! What the benchmarks share.

pub mod by_hand;
pub mod measure;
pub mod scenes;
pub mod system_sine;
