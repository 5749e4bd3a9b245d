#![allow(unused, missing_docs)]
#[path = "it/form/docs.rs"]
mod docs;
#[path = "it/form/layers.rs"]
mod layers;
