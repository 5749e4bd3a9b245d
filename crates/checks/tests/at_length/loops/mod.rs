//! Loops and trees of random shape and parameters, on every number, and a linkage that is held three times over.

mod bennett;
mod numbers;
mod plane_at_random;
mod space_at_random;
mod trees_at_random;
