//! The ends closed: from relations and matrices to motion.

pub mod product;
pub mod riccati;
