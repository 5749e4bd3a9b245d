//! Accelerations and forces of open chains and held ones, against systems of equations that share nothing with the crate.

mod held_tips;
mod hinges;
mod plane;
mod product;
mod space;
