//! How a rule chooses its steps.

/// A method and its choice of steps, for example `Dop853::tolerance(1e-12)` or `Rk4::step(1e-3)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rule<M, R> {
    /// The method.
    pub method: M,
    /// The choice of steps.
    pub control: Control<R>,
}

/// A choice of steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Control<R> {
    /// All of one size (s) (the last is shortened to end on time).
    Fixed(R),
    /// As large as keeps the error of a step within a tolerance, absolute and relative, no less than numbers are rounded by.
    ///
    /// A step over a place where closures become dependent of each other may err by a hundred tolerances, or by the root of rounding if
    /// that is more, where shorter steps are no better; tolerances from 1e-4 on (in `f64`) are kept there too.
    Tolerance(R),
}
