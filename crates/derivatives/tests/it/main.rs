//! Derivatives of runs beyond first gradients, and of many scenes at random.

mod at_random;
mod dense;
mod front;
mod front_edges;
mod held;
mod held_runs;
mod recognised;
mod rows;
mod second;
