//! A relation in space, ready to be solved for forces as often as one likes.

use super::Full;
use super::algebra::{Columns, Factor3, Symmetric3, zero};
use crate::relation::Absent;
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// S of a relation, of which the turn is solved first, then the acceleration of the station.
#[derive(Clone, Copy, Debug)]
pub struct Factor6<T> {
    angular: Factor3<T>,
    /// α for each acceleration of the station, where no torque acts.
    turn: Columns<T>,
    linear: Factor3<T>,
}

impl<T: Scalar> Factor6<T> {
    /// Of the identity.
    pub fn of_one() -> Self {
        let one = Symmetric3::of_diagonal(Vector3::new(T::one(), T::one(), T::one())).factor();
        let turn = Columns { x: zero(), y: zero(), z: zero() };
        Self { angular: one, turn, linear: one }
    }

    /// The acceleration (a, α) that a force and a torque cause.
    pub fn solve(&self, force: Vector3<T>, torque: Vector3<T>) -> (Vector3<T>, Vector3<T>) {
        let linear = self.linear.solve(force + self.turn.transposed(torque));
        (linear, self.turn.apply_onto(linear, self.angular.solve(torque)))
    }
}

impl<T: Scalar> Full<T> {
    /// S, ready to be solved.
    pub fn factor(&self) -> Factor6<T> {
        let (point, gain) = self.balled(Absent);
        Factor6 { angular: self.angular.factor(), turn: gain.per_acceleration, linear: point.mass.factor() }
    }
}
