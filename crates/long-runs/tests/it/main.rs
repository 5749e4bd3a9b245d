//! Tests that take long where nothing is optimised: many seconds of simulated time, many segments, many scenes at random.

mod forces;
mod loops;
mod paper;
mod rest;
mod runs;
