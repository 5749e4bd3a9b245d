//! Derivatives of runs beyond first gradients, and of many scenes at random.

mod second;
