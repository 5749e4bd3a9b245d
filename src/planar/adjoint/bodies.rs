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
//! and at I G has w ẑ×σ more, F α ẑ×σ − ω² σ.

use super::{Pulled, Stirred};
use crate::adjoint::Takes;
use crate::planar::body::{Base, Pose};
use crate::planar::{Acceleration, Body, Planar, PointMass, RigidBody, Rod, Wrench};
use crate::relation::plane::Full;
use crate::relation::plane::algebra::{add_scaled, dot, normal, plus_dot};
use crate::scalar::Scalar;
use crate::shape::Of;
use crate::walks::factor::Factor;
use crate::walks::meet::Meet;
use crate::walks::pull_back::PullBack;
use crate::walks::stir::Stir;
use nalgebra::Vector2;

/// Carries both motions over a body.
#[inline(always)]
fn stir<T: Scalar>(body: &impl Body<T>, pose: Pose<T>, carried: Stirred<T>) -> Stirred<T> {
    let [d, centripetal] = body.arm(pose);
    let Stirred { acceleration, stirring, rate } = carried;
    Stirred { acceleration: acceleration.shifted(d, centripetal), stirring: stirring.swung(d), rate }
}

/// Carries G and F over a body.
#[inline(always)]
fn pull_back<T: Scalar, B: Body<T>>(
    body: &B,
    pose: Pose<T>,
    met: &Stirred<T>,
    carried: Pulled<T>,
    sums: &mut Base<T>,
) -> Pulled<T> {
    let [d, _] = body.arm(pose);
    let Base { moment, lumped, .. } = body.base();
    let Stirred { acceleration: Acceleration { linear: a, angular }, stirring, rate } = *met;
    let (v, w, minus_spin2, twice) = (stirring.linear, stirring.angular, -(rate * rate), rate + rate);
    let mut momentum = add_scaled(carried.momentum, lumped, v);
    let mut force = add_scaled(carried.force, lumped, a);
    sums.lumped = sums.lumped - dot(a, v);
    sums.inertia = (-angular).mul_add(w, sums.inertia);
    let n = normal(d);
    let (along, across) = (dot(d, momentum), dot(n, momentum));
    let mut angle = w.mul_add(dot(d, force), carried.angle);
    angle = angular.mul_add(along, (-minus_spin2).mul_add(across, angle));
    let mut rate = twice.mul_add(along, carried.rate);
    if B::MOMENT {
        let direction = body.direction(pose);
        let turned = |[x, y]: [T; 2]| add_scaled(direction * x, y, normal(direction));
        let back = |v: Vector2<T>, sum: &mut [T; 2]| {
            *sum = [plus_dot(sum[0], direction, v), plus_dot(sum[1], normal(direction), v)];
        };
        // What multiplies d̂ in P, and what multiplies ẑ×d̂.
        let per =
            |p: Vector2<T>, q: Vector2<T>| add_scaled(add_scaled(normal(p) * angular, -minus_spin2, p), w, normal(q));
        back(per(momentum, force), &mut sums.outboard);
        let (v, a) = (add_scaled(v, -w, n), add_scaled(add_scaled(a, -angular, n), -minus_spin2, d));
        back(per(v, a), &mut sums.moment);
        let moment = turned(moment);
        let beside = normal(moment);
        let (along, across) = (dot(moment, v), dot(beside, v));
        angle = w.mul_add(dot(moment, a), angle);
        angle = angular.mul_add(along, (-minus_spin2).mul_add(across, angle));
        rate = twice.mul_add(along, rate);
        momentum = add_scaled(momentum, w, beside);
        force = add_scaled(add_scaled(force, angular, beside), minus_spin2, moment);
    } else {
        // d · d̄: see `Reversed::complete`.
        let length = angular.mul_add(across, minus_spin2.mul_add(along, w * dot(n, force)));
        sums.outboard[0] = sums.outboard[0] - length;
    }
    Pulled { momentum, force, angle, rate }
}

macro_rules! bodies {
    ($($Body:ident),*) => {$(
        impl<T: Scalar> Takes<Planar<T>, Factor> for $Body<T> {
            #[inline(always)]
            fn take(
                &self,
                _: &mut Factor,
                outer: Full<T>,
                (&x, &y, &p, &q, ..): Of<'_, Planar<T>, Factor, Self>,
            ) -> Full<T> {
                Body::condense(self, outer, Pose { x, y, p, q })
            }
        }

        impl<T: Scalar> Takes<Planar<T>, Meet> for $Body<T> {
            #[inline(always)]
            fn take(
                &self,
                _: &mut Meet,
                outer: Wrench<T>,
                (&x, &y, &p, &q, ..): Of<'_, Planar<T>, Meet, Self>,
            ) -> Wrench<T> {
                let [d, _] = self.arm(Pose { x, y, p, q });
                Wrench { torque: plus_dot(outer.torque, normal(d), outer.force), ..outer }
            }
        }

        impl<T: Scalar> Takes<Planar<T>, Stir> for $Body<T> {
            #[inline(always)]
            fn take(
                &self,
                _: &mut Stir,
                inner: Stirred<T>,
                (&x, &y, &p, &q, .., met, _): Of<'_, Planar<T>, Stir, Self>,
            ) -> Stirred<T> {
                *met = stir(self, Pose { x, y, p, q }, inner);
                *met
            }
        }

        impl<T: Scalar> Takes<Planar<T>, PullBack> for $Body<T> {
            #[inline(always)]
            fn take(
                &self,
                _: &mut PullBack,
                outer: Pulled<T>,
                (&x, &y, &p, &q, met, sums, ..): Of<'_, Planar<T>, PullBack, Self>,
            ) -> Pulled<T> {
                pull_back(self, Pose { x, y, p, q }, met, outer, sums)
            }
        }
    )*};
}
bodies!(Rod, RigidBody, PointMass);
