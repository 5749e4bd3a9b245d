//! The form of scenes, and of the sources.

mod docs;
mod layers;
mod macros;
mod names;
mod of_scenes;
mod readings;
mod traits;
