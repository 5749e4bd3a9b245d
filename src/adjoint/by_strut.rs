//! Derivatives of a cost by the numbers of a strut.

use super::laws::{NUMBERS, count};
use crate::error::Fault;
use crate::lift::Lift;
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use crate::struts::Strut;
use nalgebra::SVector;
use num_traits::Zero;

/// Derivatives of a cost by the numbers of a strut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByStrut<T, const D: usize> {
    /// By the coordinates (m) of its ends: of a body's point in axes of the body, or of a place of the ground.
    pub ends: [SVector<T, D>; 2],
    /// By its stiffness (N/m).
    pub stiffness: T,
    /// By its damping (N·s/m).
    pub damping: T,
    /// By its length (m) at which the spring does not pull.
    pub length: T,
    /// By the numbers of its law.
    law: [T; NUMBERS],
    /// How many these are.
    count: usize,
    /// Whether the strut acts at some time, and whether it hung slack before.
    acts: bool,
    set_in: bool,
}

impl<T: Scalar, const D: usize> ByStrut<T, D> {
    /// No derivatives by the numbers of a strut.
    pub(crate) fn none<W: Lift<T, T>>(strut: &Strut<T, D, W>) -> Self {
        let (zero, none) = (T::zero(), SVector::repeat(T::zero()));
        Self {
            ends: [none; 2],
            stiffness: zero,
            damping: zero,
            length: zero,
            law: [zero; NUMBERS],
            count: count(&strut.law),
            acts: false,
            set_in: false,
        }
    }

    /// By the numbers of its [law](Strut::with_law), in the order in which [`Lift`] meets them: six at most, for a run under a law of more has no
    /// gradient backward.
    pub fn law(&self) -> &[T] {
        self.law.get(..self.count).unwrap_or(&self.law)
    }

    /// Refuses a law of more numbers than there is room for, and a force that set in with a jump, whose instant no costate knows.
    pub(crate) fn known<W: SpringLaw<T>>(&self, strut: &Strut<T, D, W>) -> Result<(), Fault> {
        let jumps = |rate| !strut.tension(strut.length, rate).real().is_zero();
        if self.set_in && (jumps(T::one()) || jumps(-T::one())) {
            let what = "the gradient of a run in which a rope or buffer sets in with a force, as of a damper: it jumps there; take a law that does not";
            return Err(Fault::Unsupported { what });
        }
        let (expected, given) = (NUMBERS, self.count);
        if given <= expected {
            Ok(())
        } else {
            Err(Fault::Count { list: "numbers of a law of a strut", expected, given })
        }
    }

    /// Adds what a strut does at one time; what is met later was before.
    pub(super) fn add(
        &mut self,
        [by_stiffness, by_damping, by_length]: [T; 3],
        by_law: [T; NUMBERS],
        [acts, slack]: [bool; 2],
    ) {
        self.stiffness += by_stiffness;
        self.damping += by_damping;
        self.length += by_length;
        self.law.iter_mut().zip(by_law).for_each(|(sum, more)| *sum += more);
        (self.acts, self.set_in) = (self.acts || acts, self.set_in || (self.acts && slack));
    }

    /// All of them, in the order in which a strut is lifted.
    pub(crate) fn each_number(&mut self) -> impl Iterator<Item = &mut T> {
        let Self { ends: [from, to], stiffness, damping, length, law, count, .. } = self;
        from.iter_mut().chain(to).chain([stiffness, damping, length]).chain(law.iter_mut().take(*count))
    }
}
