//! The costate sweep in the plane: joints that close loops.

use super::{Kind, NUMBERS, Outboard, Stirred};
use crate::adjoint::ReversibleClosing;
use crate::chain::Named;
use crate::element::Level;
use crate::mechanics::planar::{Pin, Planar, Weld, Wrench};
use crate::relation::planar::Full;
use crate::relation::{Additive, Carry, Closures, Cut, Looped, Own, Wrenches};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// The wrenches of forces along x and y.
fn forces<T: Scalar>() -> [Wrench<T>; 2] {
    let (zero, one) = (T::zero(), T::one());
    [Vector2::new(one, zero), Vector2::new(zero, one)].map(Wrench::of_force)
}

/// What lies beyond the ends of both arms. λ acts ON the side arm, so F on what lies outboard of it is −λ, and the opposite on what the main
/// arm meets.
#[inline(always)]
fn cut<T: Scalar, C: Closures, O: Own>(
    outer: Outboard<T, C>,
    kind: Kind,
    columns: O::Each<Wrench<T>>,
) -> (Outboard<T, Looped<C, O>>, Outboard<T, O>) {
    let relation = Carry::<Planar<T>, O, Wrenches>::carry(outer.relation, columns);
    let side = Outboard::cut(kind, O::map(&columns, |column| -column), O::each(|_| T::zero()));
    (Outboard { kind: outer.kind.and(kind), relation }, side)
}

impl<T: Scalar> ReversibleClosing<Planar<T>> for Pin {
    #[inline(always)]
    fn close_off<C: Closures>(
        &self,
        outer: Outboard<T, C>,
        &effort: &T,
    ) -> (Outboard<T, Looped<C, Cut<2>>>, Outboard<T, Cut<2>>, Wrench<T>) {
        let (mut main, mut side) = cut(outer, Kind::Point, forces());
        side.relation = Full { torque: effort, ..side.relation };
        main.relation = Full { torque: main.relation.torque - effort, ..main.relation };
        (main, side, Wrench { force: Vector2::null(), torque: -effort })
    }
    fn columns(&self) -> [Wrench<T>; 2] {
        forces()
    }
    fn of_effort(&self, side: &Stirred<T>, main: &Stirred<T>, sum: &mut T) {
        *sum += main.velocity.angular - side.velocity.angular;
    }
    fn of_residual(&self, _: &[T; 2], _: Level, _: &mut [T; NUMBERS]) {}
}

impl<T: Scalar> ReversibleClosing<Planar<T>> for Weld<T> {
    #[inline(always)]
    fn close_off<C: Closures>(
        &self,
        outer: Outboard<T, C>,
        _: &T,
    ) -> (Outboard<T, Looped<C, Cut<3>>>, Outboard<T, Cut<3>>, Wrench<T>) {
        let (main, side) = cut(outer, Kind::Rigid, self.columns());
        (main, side, Wrench::none())
    }
    fn columns(&self) -> [Wrench<T>; 3] {
        let [x, y] = forces();
        [x, y, Wrench { force: Vector2::null(), torque: T::one() }]
    }
    /// A torque in a weld does nothing.
    fn of_effort(&self, _: &Stirred<T>, _: &Stirred<T>, _: &mut T) {}
    /// The weld turns the end of the side arm.
    fn of_residual(&self, weights: &[T; 3], level: Level, sums: &mut [T; NUMBERS]) {
        if let Level::Place = level {
            sums[0] -= weights[2];
        }
    }
}

impl<T: Scalar, K: ReversibleClosing<Planar<T>>> ReversibleClosing<Planar<T>> for Named<K> {
    #[inline(always)]
    fn close_off<C: Closures>(
        &self,
        outer: Outboard<T, C>,
        effort: &T,
    ) -> (Outboard<T, Looped<C, K::Closures>>, Outboard<T, K::Closures>, Wrench<T>) {
        self.item.close_off(outer, effort)
    }
    fn columns(&self) -> <K::Closures as Closures>::Each<Wrench<T>> {
        self.item.columns()
    }
    fn of_effort(&self, side: &Stirred<T>, main: &Stirred<T>, sum: &mut T) {
        self.item.of_effort(side, main, sum);
    }
    fn of_residual(&self, weights: &<K::Closures as Closures>::Each<T>, level: Level, sums: &mut [T; NUMBERS]) {
        self.item.of_residual(weights, level, sums);
    }
}
