//! Equilibrium, frequencies and modes.

mod modes;
mod spatial_rest;
