//! Runs of many seconds of simulated time, which take long where nothing is optimised.

mod flexible_pendulum;
mod in_time;
mod ropes_at_rest;
mod taut_ropes;
mod windows;
