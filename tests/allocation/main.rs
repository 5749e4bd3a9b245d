//! What allocates nothing, in a process of its own: its global allocator counts.

#![allow(unsafe_code)] // an allocator cannot be written otherwise

mod backward;
mod counting;
mod paper;
mod steps;
