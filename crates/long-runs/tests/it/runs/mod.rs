//! Stiff and taut scenes: over many seconds, and at any stiffness; runs that are saved and resumed, by every rule.

mod flexible_pendulum;
mod held_beam;
mod resumed;
mod spatial_stiff;
mod stiff_rules;
mod taut_ropes;
