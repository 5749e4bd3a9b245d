//! The costate sweep in the plane: joints that close loops.

use super::{Felt, Kind, NUMBERS_OF_JOINT, Outboard, Stirred};
use crate::adjoint::{LoadCostates, ReversibleClosing, total};
use crate::element::Level;
use crate::mechanics::planar::{Pin, Planar, Turn, Weld, Wrench};
use crate::relation::planar::Full;
use crate::relation::{Additive, Closures, Cut, Looped};
use crate::scalar::Scalar;
use crate::shape::Ends;
use nalgebra::Vector2;

/// The wrenches of forces along x and y.
fn forces<T: Scalar>() -> [Wrench<T>; 2] {
    let (zero, one) = (T::zero(), T::one());
    [Vector2::new(one, zero), Vector2::new(zero, one)].map(Wrench::of_force)
}

/// The wrenches of forces along x and y, and of a torque.
fn columns<T: Scalar>() -> [Wrench<T>; 3] {
    let [x, y] = forces();
    [x, y, Wrench { force: Vector2::null(), torque: T::one() }]
}

/// What both ends miss is linear in their places, angles and velocities.
fn felt<T: Scalar, C: Closures>(
    columns: &C::Each<Wrench<T>>,
    weights: &C::Each<T>,
    [side, main]: &[Turn<T>; 2],
    level: Level,
) -> [Felt<T>; 2] {
    let (sum, none) = (total::<Planar<T>, C>(columns, weights), Wrench::none());
    match level {
        Level::Place => [Planar::felt(sum, none, side), Planar::felt(-sum, none, main)],
        Level::Velocity => [Planar::felt(none, sum, side), Planar::felt(none, -sum, main)],
    }
}

impl<T: Scalar> ReversibleClosing<Planar<T>> for Pin {
    #[cfg_attr(optimised, inline(always))]
    fn close_off<C: Closures>(
        &self,
        outer: Outboard<T, C>,
        &effort: &T,
        _: Ends<'_, Planar<T>, Self>,
        _: &mut T,
    ) -> (Outboard<T, Looped<C, Cut<2>>>, Outboard<T, Cut<2>>, Wrench<T>) {
        let (mut main, mut side) = outer.closed(Kind::Point, forces());
        side.relation = Full { torque: effort, ..side.relation };
        main.relation = Full { torque: main.relation.torque - effort, ..main.relation };
        (main, side, Wrench { force: Vector2::null(), torque: -effort })
    }
    fn columns(&self, _: Ends<'_, Planar<T>, Self>) -> [Wrench<T>; 2] {
        forces()
    }
    fn of_effort(&self, _: Ends<'_, Planar<T>, Self>, [side, main]: [&Stirred<T>; 2], sum: &mut T) {
        *sum += main.velocity.angular - side.velocity.angular;
    }
    fn felt(
        &self,
        _: Ends<'_, Planar<T>, Self>,
        weights: &[T; 2],
        turns: &[Turn<T>; 2],
        level: Level,
        _: &mut [T; NUMBERS_OF_JOINT],
    ) -> [Felt<T>; 2] {
        felt::<T, Cut<2>>(&forces(), weights, turns, level)
    }
}

impl<T: Scalar> ReversibleClosing<Planar<T>> for Weld<T> {
    #[cfg_attr(optimised, inline(always))]
    fn close_off<C: Closures>(
        &self,
        outer: Outboard<T, C>,
        _: &T,
        _: Ends<'_, Planar<T>, Self>,
        _: &mut T,
    ) -> (Outboard<T, Looped<C, Cut<3>>>, Outboard<T, Cut<3>>, Wrench<T>) {
        let (main, side) = outer.closed(Kind::Rigid, columns());
        (main, side, Wrench::none())
    }
    fn columns(&self, _: Ends<'_, Planar<T>, Self>) -> [Wrench<T>; 3] {
        columns()
    }
    /// A torque in a weld does nothing.
    fn of_effort(&self, _: Ends<'_, Planar<T>, Self>, _: [&Stirred<T>; 2], _: &mut T) {}
    /// The weld turns the end of the side arm.
    fn felt(
        &self,
        _: Ends<'_, Planar<T>, Self>,
        weights: &[T; 3],
        turns: &[Turn<T>; 2],
        level: Level,
        sums: &mut [T; NUMBERS_OF_JOINT],
    ) -> [Felt<T>; 2] {
        if let Level::Place = level {
            sums[0] += weights[2];
        }
        felt::<T, Cut<3>>(&columns(), weights, turns, level)
    }
}
