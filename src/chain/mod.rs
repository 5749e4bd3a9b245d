//! Composition: tuples (to 16), arrays and vectors of elements are elements, and so are arms that leave them ([`Branch`])
//! and arms that meet again ([`Network`]).
//!
//! Nothing here knows any physics, nor any walk but condensation and poses. A chain says of what stores its own stores consist
//! and in which order its items are met ([`Shape`](crate::shape::Shape)): outward from first to last, inward from last to first. In a
//! condensation it hands the relation from item to item. An array or a vector
//! that meets a lesser relation than its links hand on, such as a free tip, peels its last link: from then on the type of
//! the relation stays the same.

mod branch;
mod closing;
mod items;
mod least_norm;
mod named;
mod network;
mod parallel;
mod poses;
mod reversible;
mod selective;
mod sensitive;
mod tuple;

pub use crate::shape::{Closing, Ends};
pub use branch::Branch;
pub use closing::CloseOff;
pub use least_norm::LeastNorm;
pub use named::{Name, Named};
pub use network::Network;

/// `a + b` of counts that types may or may not decide.
const fn sum(a: Option<usize>, b: Option<usize>) -> Option<usize> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a + b),
        _ => None,
    }
}

/// The larger depth.
const fn deeper(a: usize, b: usize) -> usize {
    if a > b { a } else { b }
}

/// `a · b` of a count that types may or may not decide.
const fn product(a: Option<usize>, b: usize) -> Option<usize> {
    match a {
        Some(a) => Some(a * b),
        None => None,
    }
}
