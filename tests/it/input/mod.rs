//! What makes no mechanics is refused by name.

mod doubtful_bodies;
mod isometries;
mod lists_of_loads;
mod plane;
mod space;
