//! Stiff and taut scenes: over many seconds, and at any stiffness.

mod flexible_pendulum;
mod spatial_stiff;
mod stiff_rules;
mod taut_ropes;
