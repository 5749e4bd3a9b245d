//! How a rule chooses its steps.

use crate::sealed::Sealed;

/// A method and its choice of steps, for example `Dop853::tolerance(1e-12)` or `Rk4::step(1e-3)`: what a run is made by.
///
/// A method that does not estimate its errors, as `Rk4`, is refused under [`Control::Tolerance`] when its run makes the first step.
///
/// A [`Stepper`](crate::stepper::Stepper) takes the method alone, `Dop853` or `Rk4`: it is told the size of every step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Rule<M, R> {
    /// The method.
    pub method: M,
    /// The choice of steps.
    pub control: Control<R>,
}

/// What a run is made by: a method that says how long its steps are, which is a [`Rule`] and nothing else.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say how long the steps of a run are",
    label = "a method alone",
    note = "a run takes a rule: `Rk4::step(0.001)` for steps of one size (s), `Dop853::tolerance(1e-9)` for error control"
)]
pub trait IntoRule<R>: Sealed {
    /// The method.
    type Method;

    /// The rule.
    fn into_rule(self) -> Rule<Self::Method, R>;
}

impl<M, R> Sealed for Rule<M, R> {}

impl<M, R> IntoRule<R> for Rule<M, R> {
    type Method = M;

    fn into_rule(self) -> Self {
        self
    }
}

/// A choice of steps.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Control<R> {
    /// Steps of one size (s) (the last is shortened to end on time).
    Fixed(R),
    /// Steps as large as keep the error of a step within a tolerance, absolute and relative, no less than numbers are rounded by.
    ///
    /// A step over a place where closures become dependent of each other may err by a hundred tolerances, or by the root of rounding if
    /// that is more, where shorter steps are no better; tolerances from 1e-4 on (in `f64`) are kept there too.
    Tolerance(R),
}
