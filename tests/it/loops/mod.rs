//! Loops, networks and trees.

mod andrews;
mod arms_in_arrays;
mod assembly;
mod assembly_held;
mod between_steps;
mod dead_points;
mod force_elements;
mod half_turns;
mod ladders;
mod open_starts;
mod plane;
mod ropes_and_buffers;
mod shared_loops;
mod space;
mod stiff_struts;
mod struts;
mod struts_with_laws;
mod torn_loops;
mod trees;
