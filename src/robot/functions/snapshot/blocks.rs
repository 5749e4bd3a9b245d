//! Derivatives by coordinates of a base that floats, and of what acts on it.

use super::factor::Floating;
use super::partials::{Moved, Outboard};
use super::screws::sum;
use super::{Snapshot, finite};
use crate::error::Error;
use crate::relation::spatial::algebra::{cross, zero};
use crate::scalar::Scalar;
use nalgebra::Vector3;

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
    #[inline(always)]
    pub fn zero() -> Self {
        let o = T::zero();
        Self { base: [[o; 6]; 6], base_by_joints: [[o; N]; 6], joints_by_base: [[o; 6]; N], joints: [[o; N]; N] }
    }

    /// Becomes zeros.
    pub(in crate::robot::functions) fn clear(&mut self) {
        let o = T::zero();
        (self.base, self.base_by_joints) = ([[o; 6]; 6], [[o; N]; 6]);
        (self.joints_by_base, self.joints) = ([[o; 6]; N], [[o; N]; N]);
    }

    /// Derivatives of inverse dynamics become `by` · M⁻¹ times themselves. None is by the place of the base or its velocity, and none of a joint
    /// is by one of another limb.
    pub(in crate::robot::functions) fn solve(&mut self, by: T, mass: &Floating<'_, T, N>) {
        let turns = |[.., x, y, z]: [T; 6]| [x, y, z, T::zero()];
        let (mut of_base, mut of_joints) = (self.base.map(turns), self.joints_by_base.map(turns));
        mass.solve(by, &mut of_base, &mut of_joints);
        let rows = self.base.iter_mut().chain(&mut self.joints_by_base).zip(of_base.iter().chain(&of_joints));
        rows.for_each(|([.., a, b, c], [x, y, z, _])| (*a, *b, *c) = (*x, *y, *z));
        mass.solve_joints(by, &mut self.base_by_joints, &mut self.joints);
    }

    /// Refuses numbers that are not finite.
    pub(in crate::robot::functions) fn all_finite(&self) -> Result<(), Error> {
        let of_base = finite(self.base.as_flattened()).and(finite(self.base_by_joints.as_flattened()));
        of_base.and(finite(self.joints_by_base.as_flattened())).and(finite(self.joints.as_flattened()))
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
    /// Derivatives of inverse dynamics by positions and rates of base and joints: of the base by its place or velocity there are none.
    ///
    /// A base is a joint of three slides that rest and three turns about its own axes: its ψ′ is zero, seen by one who moves with its
    /// velocity, and its ψ″ is a × S, where a is the acceleration of its place.
    pub(in crate::robot::functions) fn derived(
        &self,
        moved: &mut Moved<T, N>,
        (base, seconds): (&[T; 6], &[T; N]),
        [positions, rates]: [&mut Blocks<T, N>; 2],
    ) {
        let (spin, [a, _]) = (self.base.spin, self.ground(base));
        let Outboard { inertial, stirred, wrench } = self.partials(moved, (base, seconds), |i, partial, carrying| {
            self.pairs(i, partial, carrying, |i, k, [position, rate]| {
                (positions.joints[i][k], rates.joints[i][k]) = (position, rate);
            });
            let [force, torque] = partial.inertial;
            let by_turns = [cross(force, a), partial.stirred + cross(torque, spin)];
            for (which, by) in [&mut *positions, &mut *rates].into_iter().enumerate() {
                let [x, y, z, a, b, c] = partial.wrenches.map(|two| two[which]);
                by.set_joint(i, self.on_base([Vector3::new(x, y, z), Vector3::new(a, b, c)]));
                by.joints_by_base[i] = self.on_base([zero(), by_turns[which]]);
            }
        });
        for (k, axis) in self.axes().into_iter().enumerate() {
            let felt = cross(axis, wrench[0] - a * inertial.mass);
            positions.set_base(3 + k, self.on_base([felt, cross(inertial.moment, cross(a, axis))]));
            let (stirring, turning) = (stirred.apply(axis), inertial.moved([zero(), cross(spin, axis)]));
            rates.set_base(3 + k, self.on_base(sum(sum(stirring, stirring), turning)));
        }
    }
}
