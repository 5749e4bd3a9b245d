//! Derivatives of runs beyond first gradients, and of many scenes at random.

mod front;
mod held;
mod rows;
mod second;
