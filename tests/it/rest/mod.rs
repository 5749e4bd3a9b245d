//! Equilibrium, frequencies and modes.

mod buckling;
mod complex_modes;
mod mode_derivatives;
mod modes;
mod redundant_loops;
mod spatial_rest;
