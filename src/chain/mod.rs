//! Composition: tuples (to 16), arrays and vectors of elements are elements, and so are arms that leave them ([`Branch`])
//! and arms that meet again ([`Network`]).
//!
//! Nothing here knows any physics. A chain hands what it carries from item to item, outward from first to last or inward
//! from last to first, and its stores (gains, directions, loads, coordinates) have its own shape. An array or a vector
//! that meets a lesser relation than its links hand on, such as a free tip, peels its last link: from then on the type of
//! the relation stays the same.

mod branch;
mod closing;
mod items;
mod least_norm;
mod measure;
mod network;
mod parallel;
mod poses;
mod sensitive;
mod tuple;

pub use branch::Branch;
pub use closing::{CloseOff, Closing, Ends};
pub use least_norm::LeastNorm;
pub use network::Network;

use crate::element::{Element, Space};

/// `a + b` of counts that types may or may not decide.
const fn sum(a: Option<usize>, b: Option<usize>) -> Option<usize> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a + b),
        _ => None,
    }
}

/// Number of bodies and joints in an element: counted only where its type does not decide it.
fn entries<S: Space, E: Element<S>>(element: &E) -> usize {
    sum(E::BODIES, E::JOINTS).unwrap_or_else(|| element.bodies() + element.joints())
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
