//! The costate sweep in the plane: what bodies do.
//!
//! A body turned by θ, turning with ω and α, carries the point O at d from I, n = ẑ × d, with the point mass μ, the first moment σ and
//! the moment of inertia J about I. Its virtual power over (W, w) is
//!
//! ```text
//! P = W_O · (F_O + μ A_O) + W_I · (α ẑ×σ − ω² σ) + w (J α + (ẑ×σ) · A_I)
//! ```
//!
//! With G and F at O, those of μ included, and ẑ×ᵀ x = −ẑ×x,
//!
//! ```text
//! θ̄ = (α d + ω² n)·G + w d·F + W_I·(α σ + ω² ẑ×σ) + w σ·A_I         ω̄ = 2 ω (d·G + W_I·σ)
//! d̄ = −[α ẑ×ᵀG − ω² G + w ẑ×ᵀF]        σ̄ = −[α ẑ×ᵀW_I − ω² W_I + w ẑ×ᵀA_I]        μ̄ = −A_O·W_O        J̄ = −α w
//! ```
//!
//! and at I G has w ẑ×σ more, F α ẑ×σ − ω² σ. What α, ω² and w multiply in θ̄ is summed up for all bodies that a pin turns.

use super::{Kind, OnBody, Outboard, Pulled, Stirred};
use crate::adjoint::{Reversed, unless_rows};
use crate::element::Springs;
use crate::mechanics::planar::body::{Base, Pose};
use crate::mechanics::planar::{Acceleration, Body, Planar, PointMass, RigidBody, Rod, Wrench};
use crate::relation::planar::algebra::{add_scaled, dot, normal, plus_dot};
use crate::relation::{Closures, Empty};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Factor, Meet, PullBack, Reach, Stir};
use nalgebra::Vector2;

/// Condenses what lies outboard of a body.
#[cfg_attr(optimised, inline(always))]
fn factor<T: Scalar, C: Closures>(body: &impl Body<T>, pose: Pose<T>, outer: Outboard<T, C>) -> Outboard<T, C> {
    Outboard::rigid(match outer.kind {
        Kind::Nothing => body.condense(Empty, pose).cut(outer.relation.cuts),
        Kind::Point => body.condense(outer.pin(), pose),
        Kind::Rigid => body.condense(outer.relation, pose),
    })
}

/// Carries G and F over a body whose outboard end accelerates by `a`.
#[cfg_attr(optimised, inline(always))]
fn pull_back<T: Scalar, B: Body<T>>(
    walk: &PullBack,
    body: &B,
    pose: Pose<T>,
    (a, met): (Vector2<T>, OnBody<T>),
    carried: Pulled<T>,
    sums: &mut Base<T>,
) -> Pulled<T> {
    let [d, centripetal] = body.arm(pose);
    let Base { moment, inertia, lumped, .. } = body.base();
    let OnBody { velocity: v, acceleration: turning, stirring: w } = met;
    let mut momentum = add_scaled(carried.momentum, lumped, v);
    let mut force = add_scaled(carried.force, lumped, a);
    sums.lumped = (-a.x).mul_add(v.x, (-a.y).mul_add(v.y, sums.lumped));
    sums.inertia = (-turning).mul_add(w, sums.inertia);
    let n = normal(d);
    let turned_across = dot(n, momentum);
    let mut along = plus_dot(carried.along, d, momentum);
    let mut across = carried.across + turned_across;
    let mut angular = carried.angular;
    if walk.angular {
        angular = inertia.mul_add(w, angular + turned_across);
    }
    let mut lever = plus_dot(carried.lever, d, force);
    if B::MOMENT {
        let (direction, minus_spin2) = (body.direction(pose), pose.p);
        let turned = |[x, y]: [T; 2]| add_scaled(direction * x, y, normal(direction));
        let back = |v: Vector2<T>, sum: &mut [T; 2]| {
            *sum = [plus_dot(sum[0], direction, v), plus_dot(sum[1], normal(direction), v)];
        };
        // The costate of a vector whose own acceleration meets p in P, and whose virtual velocity meets q.
        let per =
            |p: Vector2<T>, q: Vector2<T>| add_scaled(add_scaled(normal(p) * turning, -minus_spin2, p), w, normal(q));
        back(per(momentum, force), &mut sums.outboard);
        let (v, a) = (add_scaled(v, -w, n), add_scaled(a, -turning, n) - centripetal);
        back(per(v, a), &mut sums.moment);
        let moment = turned(moment);
        let beside = normal(moment);
        if walk.angular {
            angular = plus_dot(angular, beside, v);
        }
        (along, across, lever) = (plus_dot(along, moment, v), plus_dot(across, beside, v), plus_dot(lever, moment, a));
        momentum = add_scaled(momentum, w, beside);
        force = add_scaled(add_scaled(force, turning, beside), minus_spin2, moment);
    } else {
        // d · d̄: see `Costates::complete`.
        let length = plus_dot(turning.mul_add(turned_across, w * dot(n, force)), centripetal, momentum);
        sums.outboard[0] -= length;
    }
    Pulled { momentum, force, along, across, lever, angular, ..carried }
}

macro_rules! bodies {
    ($($Body:ident),*) => {$(
        impl<T: Scalar, C: Closures, By: Springs<T>> Takes<Planar<T>, Factor<C, By>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                _: &mut Factor<C, By>,
                outer: Outboard<T, C>,
                (&x, &y, &p, &q, ..): Of<'_, Planar<T>, Factor<C, By>, Self>,
            ) -> Outboard<T, C> {
                factor(self, Pose { x, y, p, q }, outer)
            }
        }

        impl<T: Scalar, C: Closures> Takes<Planar<T>, Reach<T, C>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                _: &mut Reach<T, C>,
                inner: Acceleration<T>,
                (&x, &y, &p, &q, .., (reached, (), ())): Of<'_, Planar<T>, Reach<T, C>, Self>,
            ) -> Acceleration<T> {
                let [d, centripetal] = self.arm(Pose { x, y, p, q });
                let outer = inner.shifted(d, centripetal);
                *reached = outer.linear;
                outer
            }
        }

        impl<T: Scalar, C: Closures> Takes<Planar<T>, Meet<T, C>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                _: &mut Meet<T, C>,
                outer: Wrench<T>,
                (&x, &y, &p, &q, ..): Of<'_, Planar<T>, Meet<T, C>, Self>,
            ) -> Wrench<T> {
                let [d, _] = self.arm(Pose { x, y, p, q });
                Wrench { torque: plus_dot(outer.torque, normal(d), outer.force), ..outer }
            }
        }

        impl<T: Scalar, C: Closures> Takes<Planar<T>, Stir<T, C>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                _: &mut Stir<T, C>,
                inner: Stirred<T>,
                (&x, &y, &p, &q, .., (met, (), _), _): Of<'_, Planar<T>, Stir<T, C>, Self>,
            ) -> Stirred<T> {
                let [d, _] = self.arm(Pose { x, y, p, q });
                let (velocity, turning) = (inner.velocity.swung(d), inner.turning);
                *met = OnBody {
                    velocity: velocity.linear,
                    acceleration: turning.acceleration,
                    stirring: turning.stirring,
                };
                Stirred { velocity, turning }
            }
        }

        impl<T: Scalar> Takes<Planar<T>, PullBack> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                walk: &mut PullBack,
                outer: Pulled<T>,
                (&x, &y, &p, &q, _, (a, (), met, ..), (sums, ()), _): Of<'_, Planar<T>, PullBack, Self>,
            ) -> Pulled<T> {
                let (mut unread, ..) = Planar::of_nothing();
                let sums = unless_rows::<T, _>(sums, &mut unread);
                pull_back(walk, self, Pose { x, y, p, q }, (*a, *met), outer, sums)
            }
        }
    )*};
}
bodies!(Rod, RigidBody, PointMass);
