//! Equilibrium, frequencies and modes.

mod buckling;
mod modes;
mod redundant_loops;
mod spatial_rest;
