//! How a coordinate of a joint moves.

/// Whether a coordinate turns about its axis or slides along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Φ = (0, n).
    Turn,
    /// Φ = (n, 0).
    Slide,
}
