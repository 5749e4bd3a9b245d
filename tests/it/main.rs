//! What the library promises, a folder for each promise. Scenes are compiled once for all of them.

mod extend;
mod forces;
mod form;
mod input;
mod kit;
mod loops;
mod numbers;
mod oracle;
mod rest;
mod runs;
