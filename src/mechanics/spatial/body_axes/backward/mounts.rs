//! The costate sweep in body axes: where they begin and end.

use super::super::flange::Flange;
use super::super::mount::{BodyAxes, Upright};
use super::super::relation::Local;
use crate::adjoint::BodyLaw;
use crate::adjoint::passes;
use crate::element::{Element, Springs};
use crate::mechanics::spatial::adjoint::{Felt, Outboard, Pulled, Stirred};
use crate::mechanics::spatial::{Acceleration, Spatial, Turn, Wrench};
use crate::relation::Closures;
use crate::relation::spatial::Relation;
use crate::relation::spatial::algebra::{add_scaled, cross_onto, dot};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes, Walk};
use crate::walks::{Burden, Factor, Meet, Orient, PullBack, PullLoads, Reach, Stir, Strain};
use nalgebra::Vector3;

/// What a joint that has no coordinate does in a walk.
macro_rules! takes {
    ($Joint:ty, [$($bounds:tt)*] $Walk:ty, |$joint:ident, $walk:ident, $carried:ident: $Carried:ty, $stores:pat_param| $does:expr) => {
        impl<T: Scalar, $($bounds)*> Takes<Spatial<T>, $Walk> for $Joint {
            #[cfg_attr(optimised, inline(always))]
            fn take(&self, $walk: &mut $Walk, $carried: $Carried, $stores: Of<'_, Spatial<T>, $Walk, Self>) -> $Carried {
                let $joint = self;
                $does
            }
        }
    };
}

/// Both of a pair in other axes.
fn wrench<T: Scalar>(Wrench { force, torque }: Wrench<T>, turn: impl Fn(Vector3<T>) -> Vector3<T>) -> Wrench<T> {
    Wrench { force: turn(force), torque: turn(torque) }
}

/// Orientation, and what has no law and bears no load.
macro_rules! joints {
    ($($Joint:ty),*) => {$(
        impl<T: Scalar> Takes<Spatial<T>, Strain<T>> for $Joint {
            fn take(&self, _: &mut Strain<T>, (): (), _: Of<'_, Spatial<T>, Strain<T>, Self>) {}
        }
        takes!($Joint, [C: Closures] Burden<T, C>, |joint, walk, outer: Wrench<T>, (x, y, p, q, (), kept, pivot)| {
            joint.take(&mut walk.0, outer, (x, y, p, q, &*kept, pivot, &mut (), &mut ()))
        });
    )*};
}
joints!(BodyAxes, Upright, Flange<T>);

takes!(BodyAxes, [] Orient, |joint, _walk, turn: Turn<T>, (position, rate, x, y, p, q)| {
    joint.orient(position, rate, turn, x, y, p, q)
});
takes!(Upright, [] Orient, |joint, _walk, turn: Turn<T>, (position, rate, x, y, p, q)| {
    joint.orient(position, rate, turn, x, y, p, q)
});
takes!(Flange<T>, [] Orient, |joint, _walk, turn: Turn<T>, (position, rate, x, y, p, q)| {
    joint.orient(position, rate, turn, x, y, p, q)
});

passes!(Spatial, Upright, Factor<C, By>, [By: Springs<T>]);
passes!(Spatial, Upright, Meet<T, C>, []);
takes!(Upright, [C: Closures] Reach<T, C>, |_joint, _walk, inner: Acceleration<T>, (.., (_, reached, _))| {
    *reached = inner.linear;
    inner
});
takes!(Upright, [C: Closures] Stir<T, C>, |_joint, _walk, inner: Stirred<T>, (.., ((), met, _), _)| {
    met.velocity = inner.velocity;
    inner
});
takes!(Upright, [] PullBack, |_joint, _walk, outer: Pulled<T>, (.., (_, a, _, met, ..), _, _)| {
    Pulled { turn: outer.of_place(met.velocity, *a), ..outer }
});
takes!(Upright, [L: BodyLaw<Spatial<T>>] PullLoads<L, Spatial<T>>, |_joint, _walk, outer: Felt<T>, _| outer);

takes!(BodyAxes, [C: Closures, By: Springs<T>] Factor<C, By>, |_joint, _walk, outer: Outboard<T, C>, (attitude, ..)| {
    Outboard::rigid(Local::of_own(&outer.relation).turned(attitude))
});
takes!(BodyAxes, [C: Closures] Reach<T, C>, |_joint, _walk, inner: Acceleration<T>, (attitude, .., (_, reached, _))| {
    *reached = inner.linear;
    Acceleration { linear: attitude.transposed(inner.linear), angular: attitude.transposed(inner.angular) }
});
takes!(BodyAxes, [C: Closures] Meet<T, C>, |_joint, _walk, outer: Wrench<T>, (attitude, ..)| {
    wrench(outer, |v| attitude.apply(v))
});
takes!(BodyAxes, [C: Closures] Stir<T, C>, |_joint, _walk, inner: Stirred<T>, (attitude, .., ((), met, _), _)| {
    met.velocity = inner.velocity;
    stirred(&inner, |v| attitude.transposed(v))
});
takes!(BodyAxes, [] PullBack, |_joint, _walk, outer: Pulled<T>, (attitude, .., (_, a, _, met, ..), _, _)| {
    let outer = outer.mapped(|v| attitude.apply(v));
    Pulled { turn: outer.of_place(met.velocity, *a), ..outer }
});
takes!(BodyAxes, [L: BodyLaw<Spatial<T>>] PullLoads<L, Spatial<T>>, |_joint, _walk, outer: Felt<T>, (attitude, ..)| {
    outer.mapped(|v| attitude.apply(v))
});

/// A virtual motion in other axes.
fn stirred<T: Scalar>(inner: &Stirred<T>, turn: impl Fn(Vector3<T>) -> Vector3<T>) -> Stirred<T> {
    Stirred { velocity: turn(inner.velocity), turning: inner.turning.mapped(turn) }
}

takes!(Flange<T>, [C: Closures, By: Springs<T>] Factor<C, By>, |joint, _walk, outer: Outboard<T, C>, (attitude, y, ..)| {
    let relation = outer.relation.with_mass(joint.lumped()).carried(y[0], y[1]);
    Outboard::rigid(Local::of(&relation, attitude).full())
});
takes!(Flange<T>, [C: Closures] Reach<T, C>, |_joint, _walk, inner: Acceleration<T>, (attitude, y, .., (_, reached, _))| {
    let (linear, angular) = (attitude.apply(inner.linear), attitude.apply(inner.angular));
    let outer = Acceleration { linear, angular }.shifted(y[0], y[1]);
    *reached = outer.linear;
    outer
});
takes!(Flange<T>, [C: Closures] Meet<T, C>, |_joint, _walk, outer: Wrench<T>, (attitude, y, ..)| {
    let torque = cross_onto(y[0], outer.force, outer.torque);
    wrench(Wrench { torque, ..outer }, |v| attitude.transposed(v))
});
takes!(Flange<T>, [C: Closures] Stir<T, C>, |_joint, _walk, inner: Stirred<T>, (attitude, y, .., ((), met, _), _)| {
    let inner = stirred(&inner, |v| attitude.apply(v));
    met.turning = inner.turning;
    met.velocity = cross_onto(inner.turning.stirring, y[0], inner.velocity);
    Stirred { velocity: met.velocity, ..inner }
});
takes!(Flange<T>, [] PullBack, |joint, _walk, outer: Pulled<T>, (attitude, y, _, _, _, (_, a, _, met, ..), (_, sums), _)| {
    sums.more[0] -= dot(*a, met.velocity);
    let force = add_scaled(outer.force, joint.lumped(), *a);
    let momentum = add_scaled(outer.momentum, joint.lumped(), met.velocity);
    let mut of_arm = attitude.apply(sums.place);
    let outer = Pulled { force, momentum, ..outer };
    // Θ − W × F − A × G.
    let turn = cross_onto(force, met.velocity, cross_onto(momentum, *a, outer.turn));
    let carried = Pulled { turn, ..outer.over(y[0], &met.turning, &mut of_arm) };
    sums.place = attitude.transposed(of_arm);
    carried.mapped(|v| attitude.transposed(v))
});
takes!(Flange<T>, [L: BodyLaw<Spatial<T>>] PullLoads<L, Spatial<T>>, |_joint, _walk, outer: Felt<T>,
    (attitude, y, _, _, _, (.., met, _), (_, sums), _)| {
    let mut of_arm = attitude.apply(sums.place);
    let felt = outer.over(y[0], &met.turning, &mut of_arm);
    sums.place = attitude.transposed(of_arm);
    felt.mapped(|v| attitude.transposed(v))
});

/// The place of a flange on its link, and the point mass that its outboard neighbour lumps there.
pub fn parts<T: Scalar>(flange: &Flange<T>) -> (Vector3<T>, T) {
    (Vector3::from(flange.place()), flange.lumped())
}
