//! The formulation of 2005 on runs for orders, for minutes, and on many bodies.

mod chains;
mod motion;
mod orders;
mod space;
