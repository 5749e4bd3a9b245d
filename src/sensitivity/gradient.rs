//! The gradient of a run.

use crate::adjoint::Reversed;
use crate::element::Element;
use crate::error::{Error, Fault, counted};
use crate::mirror::Rate;
use crate::relation::Additive;
use crate::scalar::Scalar;
use crate::shape::{PerBody, PerJoint};
use crate::walks::pull_loads::LAW;
#[cfg(feature = "alloc")]
use alloc::vec::Vec;

/// Derivatives of a cost by the positions and rates of a motion, in the shape of the scene, and by its time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Costate<R, T = f64> {
    /// By displacements of positions.
    pub position: R,
    /// By rates.
    pub rate: R,
    /// By the time (s) that the cost itself reads, not by that which loads read: it matters where a run ends at an event.
    pub time: T,
}

impl<R, T: Scalar> Costate<R, T> {
    /// Adds derivatives by positions and rates, plain lists of all joints from the root on.
    ///
    /// # Errors
    /// [`Fault::Count`](crate::Fault::Count) for lists of another length.
    pub fn add(&mut self, by_position: &[T], by_rate: &[T]) -> Result<(), Error>
    where
        R: Rate<T>,
    {
        for (costate, list) in [(&mut self.position, by_position), (&mut self.rate, by_rate)] {
            let mut expected = 0;
            costate.visit(&mut |_| expected += 1);
            counted(expected, list.len())?;
            let mut list = list.iter();
            costate.replace(&mut |x| list.next().map_or(x, |more| x + *more));
        }
        Ok(())
    }
}

/// The gradient of a cost by all that a run depends on.
pub struct Gradient<S: Reversed, E: Element<S>> {
    /// By initial positions and rates; by the time of all motions at once.
    pub start: Costate<E::Rate, S::Scalar>,
    pub(crate) gravity: S::Vector,
    /// By the place and the orientation of the ground.
    pub(crate) place: S::Vector,
    pub(crate) ground: S::Angular,
    /// By base parameters of bodies.
    pub(crate) bodies: E::Store<PerBody<S::OfBody>>,
    /// By numbers of bodies that loads read.
    pub(crate) numbers: E::Store<PerBody<S::OfNumbers>>,
    /// By numbers of the law of loads, and how many it has.
    pub(crate) law: ([S::Scalar; LAW], usize),
    /// By parameters of joints.
    pub(crate) joints: E::Store<PerJoint<S::OfJoint>>,
    /// By numbers of the tip.
    pub(crate) tip: S::OfTip,
    /// Number of bodies and joints.
    pub(crate) entries: usize,
}

impl<S: Reversed, E: Element<S>> Gradient<S, E> {
    /// Nothing yet.
    pub(super) fn none(elements: &E, zero: &E::Rate) -> Self {
        let (of_body, of_number, of_joint) = S::of_nothing();
        Self {
            start: Costate { position: zero.clone(), rate: zero.clone(), time: Additive::null() },
            gravity: S::Vector::null(),
            place: S::Vector::null(),
            ground: S::Angular::null(),
            tip: S::no_tip(),
            law: ([Additive::null(); LAW], 0),
            bodies: elements.store::<PerBody<_>>(of_body),
            numbers: elements.store::<PerBody<_>>(of_number),
            joints: elements.store::<PerJoint<_>>(of_joint),
            entries: elements.bodies() + elements.joints(),
        }
    }

    /// By gravity (m/s²), component by component.
    pub fn by_gravity(&self) -> S::Vector {
        self.gravity
    }

    /// By the numbers of the law of loads on bodies, in the order in which [`Lift`](crate::Lift) meets them; none where the
    /// run has no step.
    ///
    /// # Errors
    /// [`Fault::Count`](crate::Fault::Count) for a law of more than six.
    pub fn by_loads(&self) -> Result<&[S::Scalar], Error> {
        let (list, given) = &self.law;
        list.get(..*given).ok_or(Error::new(Fault::Count { expected: LAW, given: *given }))
    }

    /// By the initial positions of all joints, root to tip, as a list.
    #[cfg(feature = "alloc")]
    pub fn by_position(&self) -> Vec<S::Scalar> {
        let mut list = Vec::new();
        self.start.position.visit(&mut |x| list.push(x));
        list
    }

    /// By their initial rates.
    #[cfg(feature = "alloc")]
    pub fn by_rate(&self) -> Vec<S::Scalar> {
        let mut list = Vec::new();
        self.start.rate.visit(&mut |x| list.push(x));
        list
    }
}
