//! A root on a revolute joint.

use super::Ground;
use crate::ends::{Held, Loose, Root};
use crate::error::{Error, Place};
use crate::lift::Lift;
use crate::scalar::Scalar;
use crate::spatial::{Frame, Joint, Revolute, Spatial};
use num_traits::Zero;

/// A root held by a smooth revolute joint at a place of the ground, about an axis of the ground. With a spring, or on turned ground,
/// start the chain with a [`Revolute`] on a [`Clamped`](super::Clamped) root instead.
#[derive(Clone, Copy, Debug)]
pub struct Hinged<G, A> {
    /// Where.
    pub place: G,
    /// The joint.
    pub joint: A,
}

impl<T: Scalar> Hinged<[T; 3], Revolute<T>> {
    /// Held at a place (m), about an axis.
    pub fn at(place: [T; 3], axis: [T; 3]) -> Self {
        Self { place, joint: Revolute::about(axis) }
    }
}

impl<T: Scalar, G: Ground<T>> Root<Spatial<T>> for Hinged<G, Revolute<T>> {
    /// In axes of the joint, its own the last.
    type Pairs = (Held, Held, Held, Held, Held, Loose);
    type Joint = Revolute<T>;

    fn joint(&self) -> Revolute<T> {
        self.joint
    }
    fn ground(&self, time: T::Real) -> Frame<T> {
        self.place.at(time).frame()
    }
    fn check(&self) -> Result<(), Error> {
        let root = |error: Error| error.at(Place::Root);
        self.place.at(T::Real::zero()).check().map_err(root)?;
        Joint::check(&self.joint).map_err(|fault| root(Error::new(fault)))
    }
}

impl<T: Scalar, U: Scalar> Lift<T, U> for Hinged<[T; 3], Revolute<T>> {
    type Over = Hinged<[U; 3], Revolute<U>>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Hinged { place: self.place.lift(number), joint: self.joint.lift(number) }
    }
}
