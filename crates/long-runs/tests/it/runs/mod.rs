//! Stiff and taut scenes over many seconds.

mod flexible_pendulum;
mod taut_ropes;
