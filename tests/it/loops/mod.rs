//! Loops, networks and trees.

mod andrews;
mod arms_in_arrays;
mod assembly;
mod assembly_held;
mod bennett;
mod between_steps;
mod half_turns;
mod ladders;
mod numbers;
mod plane;
mod plane_at_random;
mod shared_loops;
mod space;
mod space_at_random;
mod struts;
mod trees;
mod trees_at_random;
