//! The elimination of three displacements at once, along any axes.

use super::algebra::{Columns, Symmetric3, zero};
use super::pivots::turned_out;
use super::{BallGain, Full, FullColumn, Gain, Point, Relation, Spatial};
use crate::relation::{Additive, Closures, Symmetric, Term};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// A relation whose station can be let move under a force: what a sliding joint must find on its outboard side.
#[diagnostic::on_unimplemented(
    message = "a sliding joint needs a body on its outboard side, but meets `{Self}`",
    label = "no body outboard of a joint",
    note = "end a chain with a body; a ball may lie between the two"
)]
pub trait Slides<T: Scalar>: Relation<Spatial<T>> {
    /// The relation in full.
    fn whole(self) -> Full<T, Self::Closures>;
    /// Lets the station move under a force (N): none but that passes.
    fn loosed(self, force: Vector3<T>) -> (Self, BallGain<T, Self::Closures>);
    /// Lets it move against a stiff force f̂ − K̂ ü, with ü relative to the inboard body: only the pivot L + K̂ knows of it.
    fn slid(self, force: Vector3<T>, stiffness: Symmetric3<T>) -> (Self, BallGain<T, Self::Closures>);
}

/// The rows of a matrix that is given by its columns.
#[cfg_attr(optimised, inline(always))]
fn rows<T: Scalar>(m: &Columns<T>) -> Columns<T> {
    Columns {
        x: Vector3::new(m.x.x, m.y.x, m.z.x),
        y: Vector3::new(m.x.y, m.y.y, m.z.y),
        z: Vector3::new(m.x.z, m.y.z, m.z.z),
    }
}

/// The lower triangle of a matrix known to be symmetric.
#[inline(always)]
fn symmetric<T: Scalar>(m: &Columns<T>) -> Symmetric3<T> {
    Symmetric3 { xx: m.x.x, xy: m.x.y, xz: m.x.z, yy: m.y.y, yz: m.y.z, zz: m.z.z }
}

#[inline(always)]
fn each_column<T: Scalar>(m: &Columns<T>, map: impl Fn(Vector3<T>) -> Vector3<T>) -> Columns<T> {
    Columns { x: map(m.x), y: map(m.y), z: map(m.z) }
}

impl<T: Scalar, M: Term<Vector3<T>>, C: Closures> Slides<T> for Point<T, M, C> {
    #[inline(always)]
    fn whole(self) -> Full<T, C> {
        self.whole()
    }

    #[cfg_attr(optimised, inline(always))]
    fn loosed(self, force: Vector3<T>) -> (Self, BallGain<T, C>) {
        let factor = self.mass.factor();
        let free = factor.solve(force - self.offset);
        let (cuts, per_closure) = turned_out(&self.cuts, |w| w, free, |w| -factor.solve(w), |_, _| zero());
        let per_acceleration = each_column(&Columns::identity(), |e| -e);
        let gain = BallGain { absolute: Gain { per_acceleration, free, per_closure }, per_angular: Columns::null() };
        (Self { mass: Symmetric3::diagonal(T::zero()), offset: force, cuts, ..self }, gain)
    }

    #[cfg_attr(optimised, inline(always))]
    fn slid(self, force: Vector3<T>, stiffness: Symmetric3<T>) -> (Self, BallGain<T, C>) {
        let own = self.mass;
        let factor = (own + stiffness).factor();
        let free = factor.solve(force - self.offset);
        // S' = S Δ⁻¹ K̂: no difference of large numbers.
        let left = each_column(&stiffness.columns(), |k| factor.solve(k));
        let reduce = |_, row: Vector3<T>| -stiffness.apply(row);
        let (cuts, per_closure) = turned_out(&self.cuts, |w| w, free, |w| -factor.solve(w), reduce);
        let per_acceleration = each_column(&own.columns(), |k| -factor.solve(k));
        let relation = Self {
            mass: symmetric(&own.columns().times(&left)),
            offset: own.apply_onto(free, self.offset),
            torque: self.torque,
            cuts,
        };
        let gain = BallGain { absolute: Gain { per_acceleration, free, per_closure }, per_angular: Columns::null() };
        (relation, gain)
    }
}

impl<T: Scalar, C: Closures> Slides<T> for Full<T, C> {
    #[inline(always)]
    fn whole(self) -> Self {
        self
    }

    #[inline(always)]
    fn loosed(self, force: Vector3<T>) -> (Self, BallGain<T, C>) {
        self.slid(force, Symmetric3::diagonal(T::zero()))
    }

    #[cfg_attr(optimised, inline(always))]
    fn slid(self, force: Vector3<T>, stiffness: Symmetric3<T>) -> (Self, BallGain<T, C>) {
        let (own, k) = (self.linear, self.coupling);
        let factor = (own + stiffness).factor();
        let free = factor.solve(force - self.force);
        let left = each_column(&stiffness.columns(), |k| factor.solve(k)); // Δ⁻¹ K̂
        let per_acceleration = each_column(&own.columns(), |k| -factor.solve(k));
        let per_angular = each_column(&k, |k| -factor.solve(k));
        let reduce = |w: FullColumn<T>, row: Vector3<T>| FullColumn {
            force: -stiffness.apply(row),
            torque: k.transposed_onto(row, w.torque),
        };
        let (cuts, per_closure) = turned_out(&self.cuts, |w| w.force, free, |w| -factor.solve(w), reduce);
        let turned = rows(&per_angular);
        let relation = Self {
            linear: symmetric(&own.columns().times(&left)),
            coupling: each_column(&k, |k| left.transposed(k)),
            // H − Kᵀ Δ⁻¹ K
            angular: self.angular.plus_product(&rows(&k), &turned),
            force: own.apply_onto(free, self.force),
            torque: k.transposed_onto(free, self.torque),
            cuts,
        };
        (relation, BallGain { absolute: Gain { per_acceleration, free, per_closure }, per_angular })
    }
}
