//! What allocates nothing: the global allocator of all these tests counts, for each thread.

#![allow(unsafe_code)] // an allocator cannot be written otherwise

mod backward;
mod counting;
mod paper;
mod steps;
