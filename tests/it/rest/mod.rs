//! Equilibrium, frequencies and modes.

mod modes;
mod redundant_loops;
mod spatial_rest;
