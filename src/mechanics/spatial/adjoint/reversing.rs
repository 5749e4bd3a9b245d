//! The costate sweep in space: what joints that slide, or turn about two axes, say of themselves.

use super::OfJoint;
use crate::adjoint::laws::{NUMBERS, ReversibleLaw, strain};
use crate::element::Springs;
use crate::mechanics::spatial::axial::{Axial, aside};
use crate::mechanics::spatial::maps::about;
use crate::mechanics::spatial::{Cylindrical, Prismatic, Universal};
use crate::relation::spatial::algebra::Columns;
use crate::scalar::Scalar;
use crate::walks::{Led, Strain};
use nalgebra::Vector3;

/// What a joint may store its columns in.
pub type Room<'s, T> = (&'s mut Columns<T>, &'s mut [Vector3<T>; 2], &'s mut Vector3<T>, &'s mut Vector3<T>);

/// What a joint has stored.
pub type Stored<'s, T> = (&'s Columns<T>, &'s [Vector3<T>; 2], &'s Vector3<T>, &'s Vector3<T>);

/// Position, rate and w, and where the last sweep has led.
pub type Read<T> = ([T; 3], Led<T>);

/// A joint through which costates go coordinate by coordinate.
pub trait Reversing<T: Scalar, const K: usize>: Axial<T, K> {
    /// Costates of position and rate of a coordinate, by what its law does over w; adds to those of the law's numbers.
    fn pull_law(&self, k: usize, at: [T; 3], sums: &mut [T; NUMBERS]) -> [T; 2];

    /// What the law of a coordinate does where it is read apart from the geometry.
    fn strain_law(&self, k: usize, walk: &mut Strain<T>, at: Read<T>, sums: &mut [T; NUMBERS]) -> ([T; 2], Led<T>);

    /// What the law of a coordinate adds to its pivot.
    fn stiffness(&self, k: usize, at: [T; 2], springs: impl Springs<T>) -> T;

    /// Stores columns of both bodies that are not along the axis, as revolute joints do.
    fn store_asides(&self, ends: [&Columns<T>; 2], position: &Self::Coordinates, room: Room<'_, T>);

    /// These columns for a coordinate, as the body on its inboard side turns them, and that on its outboard side.
    fn asides(k: usize, stored: Stored<'_, T>) -> [Vector3<T>; 2];

    /// Adds what turns of the axis of a coordinate do.
    fn add_axis(k: usize, by: Vector3<T>, sums: &mut OfJoint<T>) {
        let _ = k;
        sums.turn += by;
    }
}

impl<T: Scalar, L: ReversibleLaw<T>> Reversing<T, 1> for Prismatic<T, L> {
    fn pull_law(&self, _: usize, [position, rate, w]: [T; 3], sums: &mut [T; NUMBERS]) -> [T; 2] {
        self.law().pull_back(position, rate, w, sums)
    }
    fn strain_law(&self, _: usize, walk: &mut Strain<T>, at: Read<T>, sums: &mut [T; NUMBERS]) -> ([T; 2], Led<T>) {
        strain(const { !L::LINEAR }, self.law(), walk, at, sums)
    }
    fn stiffness(&self, _: usize, [position, rate]: [T; 2], springs: impl Springs<T>) -> T {
        self.law().pivot(position, rate, springs)
    }
    fn store_asides(&self, [inner, _]: [&Columns<T>; 2], _: &T, (_, _, p, _): Room<'_, T>) {
        [*p] = aside(self.axis(), [inner.x], [inner.y]);
    }
    fn asides(_: usize, (_, _, p, _): Stored<'_, T>) -> [Vector3<T>; 2] {
        [*p; 2]
    }
}

impl<T: Scalar, L: ReversibleLaw<T>, M: ReversibleLaw<T>> Reversing<T, 2> for Cylindrical<T, L, M> {
    fn pull_law(&self, k: usize, [position, rate, w]: [T; 3], sums: &mut [T; NUMBERS]) -> [T; 2] {
        let ((along, about), (one, other)) = (self.laws(), sums.split_at_mut(NUMBERS / 2));
        if k == 0 { along.pull_back(position, rate, w, one) } else { about.pull_back(position, rate, w, other) }
    }
    fn strain_law(&self, k: usize, walk: &mut Strain<T>, at: Read<T>, sums: &mut [T; NUMBERS]) -> ([T; 2], Led<T>) {
        let ((along, about), (one, other)) = (self.laws(), sums.split_at_mut(NUMBERS / 2));
        let follows = const { !<Self as Axial<T, 2>>::LINEAR };
        if k == 0 { strain(follows, along, walk, at, one) } else { strain(follows, about, walk, at, other) }
    }
    fn stiffness(&self, k: usize, [position, rate]: [T; 2], springs: impl Springs<T>) -> T {
        let (along, about) = self.laws();
        if k == 0 { along.pivot(position, rate, springs) } else { about.pivot(position, rate, springs) }
    }
    fn store_asides(&self, [inner, outer]: [&Columns<T>; 2], _: &[T; 2], (_, _, p, q): Room<'_, T>) {
        [*p, *q] = aside(self.axis(), [inner.x, outer.x], [inner.y, outer.y]);
    }
    fn asides(_: usize, (_, _, p, q): Stored<'_, T>) -> [Vector3<T>; 2] {
        [*p, *q]
    }
}

impl<T: Scalar, L: ReversibleLaw<T>, M: ReversibleLaw<T>> Reversing<T, 2> for Universal<T, L, M> {
    fn pull_law(&self, k: usize, [position, rate, w]: [T; 3], sums: &mut [T; NUMBERS]) -> [T; 2] {
        let ((first, second), (one, other)) = (self.laws(), sums.split_at_mut(NUMBERS / 2));
        if k == 0 { first.pull_back(position, rate, w, one) } else { second.pull_back(position, rate, w, other) }
    }
    fn strain_law(&self, k: usize, walk: &mut Strain<T>, at: Read<T>, sums: &mut [T; NUMBERS]) -> ([T; 2], Led<T>) {
        let ((first, second), (one, other)) = (self.laws(), sums.split_at_mut(NUMBERS / 2));
        let follows = const { !<Self as Axial<T, 2>>::LINEAR };
        if k == 0 { strain(follows, first, walk, at, one) } else { strain(follows, second, walk, at, other) }
    }
    fn stiffness(&self, k: usize, [position, rate]: [T; 2], springs: impl Springs<T>) -> T {
        let (first, second) = self.laws();
        if k == 0 { first.pivot(position, rate, springs) } else { second.pivot(position, rate, springs) }
    }
    /// Both points are one: there is room where others store their arm.
    fn store_asides(&self, [inner, outer]: [&Columns<T>; 2], &[one, _]: &[T; 2], (x, y, p, q): Room<'_, T>) {
        let [first, second] = self.axes();
        let between = inner.times(&about(first, one));
        [x.z, y[0]] = aside(first, [inner.x, between.x], [inner.y, between.y]);
        [*p, *q] = aside(second, [between.x, outer.x], [between.y, outer.y]);
    }
    fn asides(k: usize, (x, y, p, q): Stored<'_, T>) -> [Vector3<T>; 2] {
        if k == 0 { [x.z, y[0]] } else { [*p, *q] }
    }
    fn add_axis(k: usize, by: Vector3<T>, sums: &mut OfJoint<T>) {
        if k == 0 {
            sums.turn += by;
        } else {
            sums.more = [sums.more[0] + by.x, sums.more[1] + by.y];
        }
    }
}
