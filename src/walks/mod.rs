//! Walks over chains, one a file: a value that says what is done at a body and at a joint.
//!
//! The shortest of them shows how to write another: [`count`]. No composite, body or joint names a walk, so a new one is a file here and
//! a line below.

pub mod aim;
pub mod broken;
pub mod check;
pub mod count;
pub mod entries;
pub mod find;
pub mod fits;
pub mod gather;
pub mod independent;
pub mod look;
pub mod measure;
pub mod recover;
pub mod respond;
pub mod restore;
pub mod size;
pub mod spread;
pub mod travel;
