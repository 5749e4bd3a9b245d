//! Derivatives of runs beyond first gradients, and of many scenes at random.

mod at_random;
mod dense;
mod front;
mod held;
mod rows;
mod second;
