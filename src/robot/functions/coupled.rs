//! Forward dynamics of robots whose joints follow others.

use super::{FixedBase, S, Tasks, finite};
use crate::couplings::Couplings;
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::scalar::Scalar;
use crate::system::System;

impl<T: Scalar, R: Root<S<T>>, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, R, C, P> {
    /// Accelerations q̈ of the joints, as [`forward_dynamics`](Self::forward_dynamics) has them, where some follow others: C q̈ = 0 by forces λ of the
    /// couplings, q̈ = q̈₀ + M⁻¹ Cᵀ λ. Positions and rates are taken as they are: [`Couplings::joined`] makes those of motions such as couplings
    /// have them.
    ///
    /// M is factored once, and its factors serve each coupling: a coupling costs a solution, where in scenes it costs a sweep.
    ///
    /// ```
    /// use catena::robot::*;
    /// let link = Link::general(0.4, [0.0, 0.0, 0.1], [[6e-3, 0.0, 0.0], [0.0, 6e-3, 0.0], [0.0, 0.0, 1e-3]]);
    /// let finger = |x| Hinge::at::<0b111>([x, 0.0, 0.2]).turned(Quarter::<30>);
    /// let chain = (Hinge::level().grounded(), link, Branch((finger(0.1), link)), finger(-0.1), link);
    /// let hand = System::new(Base::origin(), chain, Free)?.with_gravity([0.0, 0.0, -9.81]);
    /// let couplings = Couplings::of(&hand, [Coupling::by_coordinate(2, 1).ratio(-1.0)])?;
    /// let accelerations = hand.forward_dynamics_coupled(&[0.1, 0.3, -0.3], &[0.0; 3], &[0.0, 0.2, 0.0], &couplings)?;
    /// assert!(f64::abs(accelerations[2] + accelerations[1]) < 1e-12);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics); [`Fault::Shape`](crate::Fault::Shape) for couplings of another one.
    pub fn forward_dynamics_coupled<const N: usize, const K: usize>(
        &self,
        q: &[T; N],
        v: &[T; N],
        torques: &[T; N],
        couplings: &Couplings<T, K>,
    ) -> Result<[T; N], Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        self.loadable(couplings)?;
        let mut seconds = self.forward_dynamics(q, v, torques)?;
        let factor = self.factored(q);
        let responses = couplings.rows().map(|row| self.solved(&factor, &row));
        let forces = couplings.balancing(&seconds, &responses);
        for (response, force) in responses.iter().zip(forces) {
            for (second, x) in seconds.iter_mut().zip(response) {
                *second += force * *x;
            }
        }
        finite(&seconds).map(|()| seconds)
    }
}
