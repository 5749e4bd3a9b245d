//! Equilibrium, frequencies and modes.

mod beam;
mod modes;
mod spatial_beam;
mod spatial_rest;
mod statics;
