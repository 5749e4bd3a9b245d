//! Closed scenes through time and through singular configurations.

mod in_time;
mod windows;
