//! The costate sweep in space: what bodies do.
//!
//! A body that turns with ω and α carries the point O at d from I. From O to I, with G and F those of the point mass μ at O included, P
//! is F·(w × d) + G·(α × d + ω × (ω × d)) more, so that
//!
//! ```text
//! Θ ← Θ + F × (w × d) + G × (α × d + ω × (ω × d))        M ← M + d × F        H ← H + d × G
//! Ω ← Ω + d (ω·G) + G (ω·d) − 2 ω (d·G)        μ̄ = −A_O·W_O        d̄ = −[G × α + ω (ω·G) − ω² G + F × w]
//! ```

use super::inertial::{Arm, Base, Inertial, swept};
use super::{Kind, OnBody, Outboard, Pulled, Stirred};
use crate::adjoint::{Reversed, unless_rows};
use crate::element::{Element, Springs};
use crate::mechanics::spatial::body::{Body, Pose};
use crate::mechanics::spatial::{Acceleration, PointMass, RigidBody, Rod, Spatial, Turn, Wrench};
use crate::relation::spatial::algebra::{add_scaled, cross, cross_onto, dot};
use crate::relation::{Closures, Empty};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Factor, Meet, Orient, PullBack, Reach, Stir};
use nalgebra::Vector3;

/// Condenses what lies outboard of a body.
#[cfg_attr(optimised, inline(always))]
fn factor<T: Scalar, C: Closures>(body: &impl Body<T>, pose: &Pose<T>, outer: Outboard<T, C>) -> Outboard<T, C> {
    Outboard::rigid(match outer.kind {
        Kind::Nothing => body.condense(Empty, pose).cut(outer.relation.cuts),
        Kind::Point => body.condense(outer.ball(), pose),
        Kind::Rigid => body.condense(outer.relation, pose),
    })
}

/// Carries derivatives of P over a body whose outboard end accelerates by `a`.
#[cfg_attr(optimised, inline(always))]
fn pull_back<T: Scalar>(
    body: &impl Inertial<T>,
    pose: &Pose<T>,
    (a, met): (Vector3<T>, &OnBody<T>),
    outer: Pulled<T>,
    sums: &mut Base<T>,
) -> Pulled<T> {
    let (d, lumped) = (pose.arm, body.lumped());
    let OnBody { velocity, turning } = met;
    sums.lumped -= dot(a, *velocity);
    let arm = Arm {
        stirred: cross(turning.stirring, d),
        moved: cross_onto(turning.acceleration, d, pose.centripetal),
        force: add_scaled(outer.force, lumped, a),
        momentum: add_scaled(outer.momentum, lumped, *velocity),
        acceleration: a,
    };
    let carried = Pulled {
        momentum: arm.momentum,
        force: arm.force,
        turn: cross_onto(arm.force, arm.stirred, cross_onto(arm.momentum, arm.moved, outer.turn)),
        torque: cross_onto(d, arm.force, outer.torque),
        angular: cross_onto(d, arm.momentum, outer.angular),
        spin: swept(turning.spin, d, arm.momentum, outer.spin),
    };
    body.pull_back(pose, arm, met, carried, sums)
}

macro_rules! bodies {
    ($($Body:ident),*) => {$(
        impl<T: Scalar> Takes<Spatial<T>, Orient> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                _: &mut Orient,
                turn: Turn<T>,
                (position, rate, x, y, p, q): Of<'_, Spatial<T>, Orient, Self>,
            ) -> Turn<T> {
                self.orient(position, rate, turn, x, y, p, q)
            }
        }

        impl<T: Scalar, C: Closures, By: Springs<T>> Takes<Spatial<T>, Factor<C, By>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                _: &mut Factor<C, By>,
                outer: Outboard<T, C>,
                (&attitude, &[turning, _], &arm, &centripetal, ..): Of<'_, Spatial<T>, Factor<C, By>, Self>,
            ) -> Outboard<T, C> {
                factor(self, &Pose { attitude, turning, arm, centripetal }, outer)
            }
        }

        impl<T: Scalar, C: Closures> Takes<Spatial<T>, Reach<T, C>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                _: &mut Reach<T, C>,
                inner: Acceleration<T>,
                (_, _, &arm, &centripetal, .., (reached, (), ())): Of<'_, Spatial<T>, Reach<T, C>, Self>,
            ) -> Acceleration<T> {
                let outer = inner.shifted(arm, centripetal);
                *reached = outer.linear;
                outer
            }
        }

        impl<T: Scalar, C: Closures> Takes<Spatial<T>, Meet<T, C>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                _: &mut Meet<T, C>,
                outer: Wrench<T>,
                (_, _, &arm, ..): Of<'_, Spatial<T>, Meet<T, C>, Self>,
            ) -> Wrench<T> {
                Wrench { torque: cross_onto(arm, outer.force, outer.torque), ..outer }
            }
        }

        impl<T: Scalar, C: Closures> Takes<Spatial<T>, Stir<T, C>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                _: &mut Stir<T, C>,
                inner: Stirred<T>,
                (_, _, &arm, .., (met, (), _), _): Of<'_, Spatial<T>, Stir<T, C>, Self>,
            ) -> Stirred<T> {
                let turning = inner.turning;
                let velocity = cross_onto(turning.stirring, arm, inner.velocity);
                *met = OnBody { velocity, turning };
                Stirred { velocity, ..inner }
            }
        }

        impl<T: Scalar> Takes<Spatial<T>, PullBack> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                _: &mut PullBack,
                outer: Pulled<T>,
                (&attitude, &[turning, _], &arm, &centripetal, _, (a, (), met, ..), (sums, ()), _):
                    Of<'_, Spatial<T>, PullBack, Self>,
            ) -> Pulled<T> {
                let (mut unread, ..) = Spatial::of_nothing();
                let sums = unless_rows::<T, _>(sums, &mut unread);
                pull_back(self, &Pose { attitude, turning, arm, centripetal }, (*a, met), outer, sums)
            }
        }
    )*};
}
bodies!(Rod, RigidBody, PointMass);
