//! The ends closed: from relations and matrices to motion.

pub mod riccati;
