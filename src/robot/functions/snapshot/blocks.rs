//! Derivatives by coordinates of a base that floats, and of what acts on it.

use super::partials::{Outboard, Pairs, Partial};
use super::screws::sum;
use super::{MassMatrix, Snapshot};
use crate::relation::spatial::algebra::{cross, zero};
use crate::scalar::Scalar;

/// A matrix over the coordinates of a base that floats and of joints: six rows and columns of the base, and one of each joint. A row is of what
/// is found, a column of what it is found from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blocks<T, const N: usize> {
    /// Of the base by the base.
    pub base: [[T; 6]; 6],
    /// Of the base by joints.
    pub base_by_joints: [[T; N]; 6],
    /// Of joints by the base.
    pub joints_by_base: [[T; 6]; N],
    /// Of joints by joints.
    pub joints: [[T; N]; N],
}

impl<T: Scalar, const N: usize> Blocks<T, N> {
    /// Zeros.
    pub(in crate::robot::functions) fn zero() -> Self {
        let o = T::zero();
        Self { base: [[o; 6]; 6], base_by_joints: [[o; N]; 6], joints_by_base: [[o; 6]; N], joints: [[o; N]; N] }
    }

    /// A column of the base.
    fn set_base(&mut self, column: usize, entries: [T; 6]) {
        self.base.iter_mut().zip(entries).for_each(|(row, entry)| row[column] = entry);
    }

    /// A column of a joint, as far as it is of the base.
    fn set_joint(&mut self, column: usize, entries: [T; 6]) {
        self.base_by_joints.iter_mut().zip(entries).for_each(|(row, entry)| row[column] = entry);
    }
}

impl<T: Scalar, const N: usize> Snapshot<T, N> {
    /// Derivatives of inverse dynamics by positions and rates of base and joints, and the mass matrix, the joints' own given: of the base by its
    /// place or velocity there are none.
    ///
    /// A base is a joint of three slides that rest and three turns about its own axes: its ψ′ is zero, seen by one who moves with its
    /// velocity, and its ψ″ is a × S, where a is the acceleration of its place.
    pub(in crate::robot::functions) fn blocks(
        &self,
        base: &[T; 6],
        partials: &[Partial<T>; N],
        whole: &Outboard<T>,
        joints: Pairs<T, N>,
    ) -> ([Blocks<T, N>; 2], MassMatrix<T, N>) {
        let [[_, spin], [a, _]] = self.ground(base);
        let Outboard { inertial, stirred, wrench } = whole;
        let [mut positions, mut rates] =
            [joints.positions, joints.rates].map(|joints| Blocks { joints, ..Blocks::zero() });
        let mut mass = MassMatrix { base: [[T::zero(); 6]; 6], coupling: [[T::zero(); 6]; N], joints: joints.mass };
        mass.base = self.units_of_base().map(|unit| self.on_base(inertial.moved(unit)));
        for (k, axis) in self.axes().into_iter().enumerate() {
            let felt = cross(axis, wrench[0] - a * inertial.mass);
            positions.set_base(3 + k, self.on_base([felt, cross(inertial.moment, cross(a, axis))]));
            let (stirring, turning) = (stirred.apply(axis), inertial.moved([zero(), cross(spin, axis)]));
            rates.set_base(3 + k, self.on_base(sum(sum(stirring, stirring), turning)));
        }
        for (k, of) in partials.iter().enumerate() {
            mass.coupling[k] = self.on_base(of.inertial);
            positions.set_joint(k, self.on_base(of.position));
            rates.set_joint(k, self.on_base(of.rate));
            let [force, torque] = of.inertial;
            positions.joints_by_base[k] = self.on_base([zero(), cross(force, a)]);
            rates.joints_by_base[k] = self.on_base([zero(), of.stirred + cross(torque, spin)]);
        }
        ([positions, rates], mass)
    }
}
