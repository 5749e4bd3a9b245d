//! Equilibrium, frequencies and modes.

mod beam;
mod modes;
mod ropes_at_rest;
mod spatial_beam;
mod spatial_rest;
mod statics;
