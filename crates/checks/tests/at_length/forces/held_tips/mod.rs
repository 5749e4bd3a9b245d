//! Chains held at both ends in every way.

mod banded;
mod chains;
mod dense;
mod long;
