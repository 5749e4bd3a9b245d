//! Derivatives of runs beyond first gradients, and of many scenes at random.

#[macro_use]
mod over_jets;
mod at_random;
mod changes_of_mode;
mod coupled_closed;
mod dense;
mod drag;
mod force_elements;
mod front;
mod front_edges;
#[macro_use]
mod held;
mod driven;
mod held_runs;
mod implicit;
mod implicit_closed;
mod implicit_in_space;
mod implicit_runs;
mod loop_runs;
mod loops;
mod past_changes;
mod recognised;
#[macro_use]
mod robots;
mod driven_robots;
mod moving;
mod rows;
mod second;
mod stiffening;
