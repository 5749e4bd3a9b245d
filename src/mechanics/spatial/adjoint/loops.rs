//! The costate sweep in space: joints that close loops.
//!
//! With N = Σ ν c and L = Σ λ c the torques of both weights on the end s of the side arm, a torque τ in the joint on the end m of the main one
//! taken from L, and what N and L are turned by that end alone, virtual power has
//!
//! ```text
//! P = N · (α_s − α_m) + (ω_m × N) · (ω_s − ω_m) − L · (w_s − w_m)
//! ```
//!
//! whose second product, of a revolute joint, is how fast N turns. So both ends have
//!
//! ```text
//! H_s = N      Ω_s = ω_m × N      M_s = −L      Θ_s = −(α_s × H_s + ω_s × Ω_s + w_s × M_s)
//! H_m = −N     Ω_m = N × ω_s      M_m = L       Θ_m = Ξ − (α_m × H_m + ω_m × Ω_m + w_m × M_m)
//! Ξ = (α_s − α_m + (ω_s − ω_m) × ω_m) × N + L × (w_s − w_m)      of N and L that turn with the end m
//! ```

use super::ends::{aligned, pulls, twist};
use super::{Felt, Kind, OfJoint, Outboard, Pivot, Pulled, Stirred, Turning};
use crate::adjoint::{Costates, LoadCostates, ReversibleClosing, total};
use crate::element::Level;
use crate::mechanics::spatial::{Acceleration, Ball, Effort, Revolute, Spatial, Turn, Weld, Wrench};
use crate::relation::spatial::Full;
use crate::relation::spatial::algebra::{Columns, cross, cross_onto, dot, zero};
use crate::relation::{Closures, Cut, Cuts, Looped, Own};
use crate::scalar::Scalar;
use crate::shape::{Closing, Ends};
use nalgebra::Vector3;

/// What a loop is cut to, under a torque on the end of the main arm.
#[cfg_attr(optimised, inline(always))]
#[allow(clippy::type_complexity)] // three of them
fn cut<T: Scalar, C: Closures, O: Own>(
    outer: Outboard<T, C>,
    (kind, columns): (Kind, O::Each<Wrench<T>>),
    torque: Vector3<T>,
    pivot: &mut Pivot<T>,
) -> (Outboard<T, Looped<C, O>>, Outboard<T, O>, Wrench<T>) {
    pivot.torque = torque;
    let (mut main, mut side) = outer.closed(kind, columns);
    side.relation = Full { torque, ..side.relation };
    main.relation = Full { torque: main.relation.torque - torque, ..main.relation };
    (main, side, twist(-torque))
}

/// What both ends are weighed by.
struct Weighed<T> {
    weight: Wrench<T>,
    force: Wrench<T>,
    /// The parts of N and L that turn with the end of the main arm.
    turning: [Vector3<T>; 2],
}

impl<T: Scalar> Weighed<T> {
    /// By wrenches that do not turn, and the torque in the joint, which does.
    fn of<O: Closures>(
        columns: &O::Each<Wrench<T>>,
        (weights, forces): (&O::Each<T>, &O::Each<T>),
        pivot: Option<&Pivot<T>>,
    ) -> Self {
        let [weight, force] = [weights, forces].map(|each| total::<Spatial<T>, O>(columns, each));
        let torque = pivot.map_or(zero(), |pivot| -pivot.torque);
        Self { weight, force: force + twist(torque), turning: [zero(), torque] }
    }

    /// Ξ.
    fn turned(&self, [side, main]: &[Turning<T>; 2]) -> Vector3<T> {
        let [n, l] = self.turning;
        let spin = cross_onto(side.spin - main.spin, main.spin, side.acceleration - main.acceleration);
        cross_onto(spin, n, cross(l, side.stirring - main.stirring))
    }

    /// What is carried inward from both ends.
    fn pulled(&self, ends: &[Turning<T>; 2]) -> [Pulled<T>; 2] {
        let &Self { weight, force, turning: [n, _] } = self;
        let [side, main] = ends;
        let end = |met: &Turning<T>, weight, force, spin| {
            let (linear, angular) = (zero(), met.acceleration);
            let (a, w) = (Acceleration { linear, angular }, Acceleration { linear, angular: met.stirring });
            let pulled = Spatial::pulled((weight, &a), (force, &w));
            Pulled { spin, turn: cross_onto(spin, met.spin, pulled.turn), ..pulled }
        };
        let on_side = end(side, weight, force, cross(main.spin, n));
        let on_main = end(main, -weight, -force, cross(n, side.spin));
        [on_side, Pulled { turn: on_main.turn + self.turned(ends), ..on_main }]
    }
}

/// What both ends feel: of the side arm the sum of the columns and the costate of its turns, the opposite of the main one, whose turns have
/// another.
fn felt<T: Scalar>(
    sum: Wrench<T>,
    [turn_side, turn_main]: [Vector3<T>; 2],
    [side, main]: &[Turn<T>; 2],
    level: Level,
) -> [Felt<T>; 2] {
    let pair = |sum: Wrench<T>, torque, turn: &Turn<T>| match level {
        Level::Place => Spatial::felt(Wrench { torque, ..sum }, Wrench::none(), turn),
        Level::Velocity => Spatial::felt(twist(torque), sum, turn),
    };
    [pair(sum, turn_side, side), pair(-sum, turn_main, main)]
}

/// Forces along inertial axes; the torque turns with the end of the main arm.
impl<T: Scalar> ReversibleClosing<Spatial<T>> for Ball {
    #[cfg_attr(optimised, inline(always))]
    fn close_off<C: Closures>(
        &self,
        outer: Outboard<T, C>,
        effort: &Effort<T>,
        Ends { x: attitude, .. }: Ends<'_, Spatial<T>, Self>,
        pivot: &mut Pivot<T>,
    ) -> (Outboard<T, Looped<C, Cut<3>>>, Outboard<T, Cut<3>>, Wrench<T>) {
        cut(outer, (Kind::Point, pulls()), attitude.apply(Vector3::from(effort.0)), pivot)
    }
    fn columns(&self, _: Ends<'_, Spatial<T>, Self>) -> [Wrench<T>; 3] {
        pulls()
    }
    fn of_effort(&self, axes: Ends<'_, Spatial<T>, Self>, [side, main]: [&Stirred<T>; 2], sum: &mut Effort<T>) {
        let relative = main.turning.stirring - side.turning.stirring;
        sum.0 = axes.x.transposed_onto(relative, Vector3::from(sum.0)).into();
    }
    fn pulled(
        &self,
        _: Ends<'_, Spatial<T>, Self>,
        forces: (&[T; 3], &[T; 3]),
        pivot: Option<&Pivot<T>>,
        ends: &[Turning<T>; 2],
        _: &mut OfJoint<T>,
    ) -> [Pulled<T>; 2] {
        Weighed::of::<Cut<3>>(&pulls(), forces, pivot).pulled(ends)
    }
    fn felt(
        &self,
        _: Ends<'_, Spatial<T>, Self>,
        weights: &[T; 3],
        turns: &[Turn<T>; 2],
        level: Level,
        _: &mut OfJoint<T>,
    ) -> [Felt<T>; 2] {
        felt(total::<Spatial<T>, Cut<3>>(&pulls(), weights), [zero(); 2], turns, level)
    }
}

/// The wrenches of forces and torques along inertial axes.
fn holds<T: Scalar>() -> [Wrench<T>; 6] {
    let ([a, b, c], Columns { x, y, z }) = (pulls(), Columns::identity());
    [a, b, c, twist(x), twist(y), twist(z)]
}

/// A torque in a weld does nothing.
impl<T: Scalar> ReversibleClosing<Spatial<T>> for Weld<T> {
    #[cfg_attr(optimised, inline(always))]
    fn close_off<C: Closures>(
        &self,
        outer: Outboard<T, C>,
        _: &Effort<T>,
        _: Ends<'_, Spatial<T>, Self>,
        pivot: &mut Pivot<T>,
    ) -> (Outboard<T, Looped<C, Cut<6>>>, Outboard<T, Cut<6>>, Wrench<T>) {
        cut(outer, (Kind::Rigid, holds()), zero(), pivot)
    }
    fn columns(&self, _: Ends<'_, Spatial<T>, Self>) -> [Wrench<T>; 6] {
        holds()
    }
    fn of_effort(&self, _: Ends<'_, Spatial<T>, Self>, _: [&Stirred<T>; 2], _: &mut Effort<T>) {}
    fn pulled(
        &self,
        _: Ends<'_, Spatial<T>, Self>,
        forces: (&[T; 6], &[T; 6]),
        _: Option<&Pivot<T>>,
        ends: &[Turning<T>; 2],
        _: &mut OfJoint<T>,
    ) -> [Pulled<T>; 2] {
        Weighed::of::<Cut<6>>(&holds(), forces, None).pulled(ends)
    }
    /// The weld turns the end of the side arm.
    fn felt(
        &self,
        _: Ends<'_, Spatial<T>, Self>,
        weights: &[T; 6],
        turns: &[Turn<T>; 2],
        level: Level,
        sums: &mut OfJoint<T>,
    ) -> [Felt<T>; 2] {
        let sum = total::<Spatial<T>, Cut<6>>(&holds(), weights);
        let mut turned = [zero(); 2];
        if let Level::Place = level {
            let (own, held) = (turns[0].attitude.times(self.attitude()), turns[1].attitude);
            turned = [aligned(&own, &held, sum.torque), -aligned(&held, &own, sum.torque)];
            sums.turn = own.transposed_onto(turned[0], sums.turn);
        }
        felt(sum, turned, turns, level)
    }
}

/// Torques about two directions across the axis, which turn with the end of the main arm, as the torque about the axis does. A turn of them
/// about the axis changes nothing, and is left out.
impl<T: Scalar> ReversibleClosing<Spatial<T>> for Revolute<T> {
    /// Stores the axis, and the column that is not along it as either end turns it.
    #[cfg_attr(optimised, inline(always))]
    fn pose(
        &self,
        side: Turn<T>,
        main: Turn<T>,
        x: &mut Columns<T>,
        y: &mut [Vector3<T>; 2],
        p: &mut Vector3<T>,
        q: &mut Vector3<T>,
    ) {
        self.orient(side, main, x, y, p, q);
        let (from, to) = (&side.attitude, &main.attitude);
        let [y, z] = self.aside([from.x, to.x], [from.y, to.y]);
        *x = Columns { x: to.apply(self.axis()), y, z };
    }
    #[cfg_attr(optimised, inline(always))]
    fn close_off<C: Closures>(
        &self,
        outer: Outboard<T, C>,
        effort: &Effort<T>,
        axes: Ends<'_, Spatial<T>, Self>,
        pivot: &mut Pivot<T>,
    ) -> (Outboard<T, Looped<C, Cut<5>>>, Outboard<T, Cut<5>>, Wrench<T>) {
        let (demand, torque) = (*axes.p, axes.x.x * effort.0[0]);
        let (main, mut side, passed) = cut(outer, (Kind::Rigid, self.columns(axes)), torque, pivot);
        let Cuts { columns, .. } = side.relation.cuts;
        let none = T::zero();
        side.relation = Full { cuts: Cuts::at_tip(columns, [none, none, none, demand.x, demand.y]), ..side.relation };
        (main, side, passed)
    }
    #[inline(always)]
    fn columns(&self, Ends { y: &[first, second], .. }: Ends<'_, Spatial<T>, Self>) -> [Wrench<T>; 5] {
        let [a, b, c] = pulls();
        [a, b, c, twist(first), twist(second)]
    }
    fn of_effort(&self, axes: Ends<'_, Spatial<T>, Self>, [side, main]: [&Stirred<T>; 2], sum: &mut Effort<T>) {
        sum.0[0] += dot(axes.x.x, main.turning.stirring - side.turning.stirring);
    }
    fn pulled(
        &self,
        axes: Ends<'_, Spatial<T>, Self>,
        forces: (&[T; 5], &[T; 5]),
        pivot: Option<&Pivot<T>>,
        ends: &[Turning<T>; 2],
        sums: &mut OfJoint<T>,
    ) -> [Pulled<T>; 2] {
        let weighed = Weighed::of::<Cut<5>>(&self.columns(axes), forces, pivot);
        let weighed = Weighed { turning: [weighed.weight.torque, weighed.force.torque], ..weighed };
        of_axis(axes.x, [zero(), weighed.turned(ends)], &mut sums.turn);
        weighed.pulled(ends)
    }
    /// With o and h the axis as the side arm and the main one turn it, n · (h × o) is missed, and then n · (ω_s − ω_m).
    fn felt(
        &self,
        axes: Ends<'_, Spatial<T>, Self>,
        weights: &[T; 5],
        turns: &[Turn<T>; 2],
        level: Level,
        sums: &mut OfJoint<T>,
    ) -> [Felt<T>; 2] {
        let (sum, [side, main]) = (total::<Spatial<T>, Cut<5>>(&self.columns(axes), weights), turns);
        let n = sum.torque;
        let turned = match level {
            Level::Place => {
                let turn = cross(side.attitude.apply(self.axis()), cross(n, axes.x.x));
                [turn, -turn]
            }
            Level::Velocity => [zero(), cross(n, side.spin - main.spin)],
        };
        of_axis(axes.x, turned, &mut sums.turn);
        felt(sum, turned, turns, level)
    }
}

/// Adds what turns of the axis do in both bodies, as [`revolute`](super::revolute) sums them up: v · e and v · (s × e) of each costate v.
#[inline(always)]
fn of_axis<T: Scalar>(axes: &Columns<T>, [of_side, of_main]: [Vector3<T>; 2], sum: &mut Vector3<T>) {
    sum.x += dot(of_side, axes.y) + dot(of_main, axes.z);
    sum.y += dot(of_side, cross(axes.x, axes.y)) + dot(of_main, cross(axes.x, axes.z));
}
