//! Derivatives by coordinates of a base that floats, and of what acts on it.

use super::partials::{By, Outboard};
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

/// Rows of derivatives over the coordinates of base and joints, those by positions, rates and torques side by side.
pub struct Derived<T, const N: usize> {
    pub base: [By<T, 6>; 6],
    pub base_by_joints: [By<T, N>; 6],
    pub joints_by_base: [By<T, 6>; N],
    pub joints: [By<T, N>; N],
}

impl<T: Scalar, const N: usize> Derived<T, N> {
    /// Zeros.
    pub fn zero() -> Self {
        let (of_six, of_joints) = ([[T::zero(); 6]; 3], [[T::zero(); N]; 3]);
        Self { base: [of_six; 6], base_by_joints: [of_joints; 6], joints_by_base: [of_six; N], joints: [of_joints; N] }
    }

    /// Refuses numbers that are not finite.
    pub fn all_finite(&self) -> Result<(), Error> {
        let all =
            [self.base.as_flattened(), self.joints_by_base.as_flattened()].map(|rows| finite(rows.as_flattened()));
        let wide = [self.base_by_joints.as_flattened(), self.joints.as_flattened()];
        all.into_iter().chain(wide.map(|rows| finite(rows.as_flattened()))).collect()
    }

    /// Derivatives by positions, rates or torques.
    pub fn of(&self, which: usize) -> Blocks<T, N> {
        Blocks {
            base: self.base.each_ref().map(|by| by[which]),
            base_by_joints: self.base_by_joints.each_ref().map(|by| by[which]),
            joints_by_base: self.joints_by_base.each_ref().map(|by| by[which]),
            joints: self.joints.each_ref().map(|by| by[which]),
        }
    }

    /// A column of the base.
    fn set_base(&mut self, column: usize, which: usize, entries: [T; 6]) {
        self.base.iter_mut().zip(entries).for_each(|(row, entry)| row[which][column] = entry);
    }

    /// A column of a joint, as far as it is of the base.
    fn set_joint(&mut self, column: usize, which: usize, entries: [T; 6]) {
        self.base_by_joints.iter_mut().zip(entries).for_each(|(row, entry)| row[which][column] = entry);
    }
}

impl<T: Scalar, const N: usize> Snapshot<T, N> {
    /// Derivatives of inverse dynamics by positions and rates of base and joints: of the base by its place or velocity there are none.
    ///
    /// A base is a joint of three slides that rest and three turns about its own axes: its ψ′ is zero, seen by one who moves with its
    /// velocity, and its ψ″ is a × S, where a is the acceleration of its place.
    pub(in crate::robot::functions) fn derived(&self, base: &[T; 6], seconds: &[T; N]) -> Derived<T, N> {
        let (partials, Outboard { inertial, stirred, wrench }) = self.partials(base, seconds);
        let ([[_, spin], [a, _]], mut by) = (self.ground(base), Derived::zero());
        self.pairs(&partials, &mut by.joints);
        for (k, axis) in self.axes().into_iter().enumerate() {
            let felt = cross(axis, wrench[0] - a * inertial.mass);
            by.set_base(3 + k, 0, self.on_base([felt, cross(inertial.moment, cross(a, axis))]));
            let (stirring, turning) = (stirred.apply(axis), inertial.moved([zero(), cross(spin, axis)]));
            by.set_base(3 + k, 1, self.on_base(sum(sum(stirring, stirring), turning)));
        }
        for (k, of) in partials.iter().enumerate() {
            for which in 0..2 {
                let [x, y, z, a, b, c] = of.wrenches.map(|two| two[which]);
                by.set_joint(k, which, self.on_base([Vector3::new(x, y, z), Vector3::new(a, b, c)]));
            }
            let [force, torque] = of.inertial;
            let by_turns = [cross(force, a), of.stirred + cross(torque, spin)];
            (0..2).for_each(|which| by.joints_by_base[k][which] = self.on_base([zero(), by_turns[which]]));
        }
        by
    }
}
