//! At length: scenes at random, each part of each spring, long chains and runs against second opinions. What takes longer to build and to
//! run than a change should wait for when it is first tried.

mod forces;
mod loops;
mod robots;
mod runs;
