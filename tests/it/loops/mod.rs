//! Loops, networks and trees.

mod andrews;
mod assembly;
mod assembly_held;
mod between_steps;
mod ladders;
mod plane;
mod shared_loops;
mod space;
mod struts;
mod trees;
