//! The mirror of a loop: coordinates of its arms, and with accelerations the forces that close it.

use super::fieldwise::{fieldwise_position, fieldwise_rate, fieldwise_retraction};
use super::{Mode, Position, Rate, Retraction, Term, Told};
use crate::lift::{Lift, lift};
use crate::scalar::Scalar;
use core::marker::PhantomData;

/// What is stored of the arms of a loop and of the joint that closes it.
///
/// With rates and accelerations this is the force that closes it. It belongs to the accelerations and is no coordinate: it is carried
/// along in sums, but not counted, visited or replaced.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Tied<X, F> {
    /// Of the main arm and the side arm.
    pub arms: X,
    /// Of the joint that closes it: with rates, internal force and torque there (N, N·m).
    pub closing: F,
}

/// Positions of the coordinates of a loop.
pub type TiedPosition<X, F> = Tied<X, PhantomData<F>>;

impl<X, F> TiedPosition<X, F> {
    /// Positions of the arms.
    pub fn of(arms: X) -> Self {
        Self { arms, closing: PhantomData }
    }
}

impl<T: Scalar, X: Rate<T>, F: Rate<T>> Rate<T> for Tied<X, F> {
    const LENGTH: usize = X::LENGTH.saturating_add(F::LENGTH);

    fieldwise_rate!([arms closing] [arms closing] [arms]);
}

impl<T: Scalar, X: Retraction<T>, F: Rate<T>> Retraction<T> for TiedPosition<X, F> {
    type Rate = Tied<X::Rate, F>;

    const CURVED: bool = X::CURVED;

    fieldwise_retraction!(arms);
}

impl<T: Scalar, X: Position<T>, F: Rate<T>> Position<T> for TiedPosition<X, F> {
    const CLOCKED: bool = X::CLOCKED;
    const MODES: bool = X::MODES;

    fieldwise_position!(arms);
}

lift!(Tied<X, F> { arms, closing });

impl<T: Scalar, U: Scalar, F: Lift<T, U>> Lift<T, U> for PhantomData<F> {
    type Over = PhantomData<F::Over>;
    fn lift(&self, _: &mut impl FnMut(T) -> U) -> Self::Over {
        PhantomData
    }
}
