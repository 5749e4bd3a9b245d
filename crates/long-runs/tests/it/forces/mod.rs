//! Accelerations and forces of very long chains, and of held ones over many seconds.

mod long_chains;
mod spatial_held_tips;
mod spatial_long;
