//! Equilibrium, frequencies and modes.

mod buckling;
mod mode_derivatives;
mod modes;
mod redundant_loops;
mod spatial_rest;
