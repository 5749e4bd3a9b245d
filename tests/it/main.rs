//! What the library promises, a folder for each promise. Scenes are compiled once for all of them.

mod allocation;
mod extend;
mod forces;
mod form;
mod input;
mod loops;
mod rest;
mod robots;
mod runs;
