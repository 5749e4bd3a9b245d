//! Accelerations and forces against dense and banded systems, and derivatives by all numbers of springs.

mod held_tips;
mod linear_springs;
pub mod space;
mod spatial_hinges;
mod spatial_product;
