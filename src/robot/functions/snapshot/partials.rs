//! Partial derivatives of inverse dynamics, and the mass matrix with them, about the origin of [screws](super::screws).
//!
//! With the twist S of a joint for a rate of one, v and a of the body that carries it, ψ′ = v × S and ψ″ = a × S + v × ψ′, and I, B and f
//! of all that is outboard of joint i, for j inboard of i or i itself:
//!
//! | | by j | of j by i |
//! |---|---|---|
//! | position | Sᵢ·(2 B ψ′ⱼ + I ψ″ⱼ) | Sⱼ·(2 B ψ′ᵢ + I ψ″ᵢ + Sᵢ ×* f) |
//! | rate | 2 Sᵢ·(B Sⱼ + I ψ′ⱼ) | 2 Sⱼ·(B Sᵢ + I ψ′ᵢ) |
//! | acceleration | Sᵢ·I Sⱼ | the same |
//!
//! (S. Singh, R. P. Russell and P. M. Wensing, *Efficient analytical derivatives of rigid-body dynamics using spatial vector algebra*, IEEE
//! Robotics and Automation Letters 7, 2022.) What depends on i alone is found once, so that a pair takes 36 products.

use super::massive::{Inertial, Stirred};
use super::screws::{Pair, along, more, sum, swept, swept_wrench};
use super::{Moving, Snapshot};
use crate::relation::spatial::algebra::{dot_onto, zero};
use crate::scalar::Scalar;
use core::ops::Add;
use nalgebra::Vector3;

/// A joint: how it moves what it carries, and what that takes.
#[derive(Clone, Copy)]
pub struct Partial<T> {
    /// S.
    unit: Pair<T>,
    /// ψ′.
    swept: Pair<T>,
    /// ψ″.
    turned: Pair<T>,
    /// I S, what an acceleration of one takes.
    pub inertial: Pair<T>,
    /// 2 Bᵀ S.
    pub stirred: Vector3<T>,
    /// Wrench by the position.
    pub position: Pair<T>,
    /// Wrench by the rate.
    pub rate: Pair<T>,
}

/// All that is outboard of a joint, or of the base: I, B, and the wrench f that its motion takes.
#[derive(Clone, Copy)]
pub struct Outboard<T> {
    pub inertial: Inertial<T>,
    pub stirred: Stirred<T>,
    pub wrench: Pair<T>,
}

impl<T: Scalar> Add for Outboard<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (inertial, stirred) = (self.inertial + other.inertial, self.stirred + other.stirred);
        Self { inertial, stirred, wrench: sum(self.wrench, other.wrench) }
    }
}

/// Derivatives of the torques of joints by positions and by rates, and the lower half of the mass matrix, as far as joints are
/// related, where joint i is outboard of k.
pub struct Pairs<T, const N: usize> {
    pub positions: [[T; N]; N],
    pub rates: [[T; N]; N],
    pub mass: [[T; N]; N],
}

impl<T: Scalar, const N: usize> Snapshot<T, N> {
    /// A body at a twist and its acceleration.
    #[inline(always)]
    fn outboard(&self, body: &Moving<T>, v: Pair<T>, a: Pair<T>) -> Outboard<T> {
        let (inertial, second) = Inertial::of(body, body.place.place - self.base.place.place);
        let stirred = Stirred::of(&inertial, second, v);
        let wrench = sum(inertial.moved(a), swept_wrench(v, stirred.momenta()));
        Outboard { inertial, stirred, wrench }
    }

    /// The base alone: its twist, seen by one who moves with its velocity, and its acceleration as felt.
    pub(super) fn ground(&self, base: &[T; 6]) -> [Pair<T>; 2] {
        let [ax, ay, az, bx, by, bz] = *base;
        let angular = self.base.place.attitude.apply(Vector3::new(bx, by, bz));
        let [felt, carried] = self.carried;
        [[zero(), self.base.spin], [Vector3::new(ax, ay, az) + felt, angular + carried]]
    }

    /// Partial derivatives of all joints, and what is outboard of the base, with the base.
    pub(in crate::robot::functions) fn partials(
        &self,
        base: &[T; 6],
        seconds: &[T; N],
    ) -> ([Partial<T>; N], Outboard<T>) {
        let ground = self.ground(base);
        let none = [zero(); 2];
        let mut moving = [[none; 4]; N]; // v, a, ψ′, ψ″
        for k in 0..N {
            let [v, a] = moving.get(self.parents[k]).map_or(ground, |[v, a, ..]| [*v, *a]);
            let (unit, rate) = (self.unit(k), self.rates[k]);
            let changing = swept(v, unit);
            let turned = sum(swept(a, unit), swept(v, changing));
            let (v, a) = (more(v, rate, unit), more(more(a, seconds[k], unit), rate, changing));
            moving[k] = [v, a, changing, turned];
        }
        let mut all: [_; N] = core::array::from_fn(|k| self.outboard(&self.bodies[k], moving[k][0], moving[k][1]));
        let mut whole = self.outboard(&self.base, ground[0], ground[1]);
        for k in (0..N).rev() {
            let outboard = all[k];
            let inboard = all.get_mut(self.parents[k]).unwrap_or(&mut whole);
            *inboard = *inboard + outboard;
        }
        let partial = |k: usize| {
            let Outboard { inertial, stirred, wrench } = &all[k];
            let (unit, [.., changing, turned]) = (self.unit(k), moving[k]);
            let twice = |pair: Pair<T>| sum(pair, pair);
            let (position, half) = (twice(stirred.apply(changing[1])), stirred.transposed(unit));
            Partial {
                unit,
                swept: changing,
                turned,
                inertial: inertial.moved(unit),
                stirred: half + half,
                position: sum(sum(position, inertial.moved(turned)), swept_wrench(unit, *wrench)),
                rate: twice(sum(stirred.apply(unit[1]), inertial.moved(changing))),
            }
        };
        (core::array::from_fn(partial), whole)
    }

    /// What each pair of joints makes of that.
    pub(in crate::robot::functions) fn pairs(&self, partials: &[Partial<T>; N]) -> Pairs<T, N> {
        let none = [[T::zero(); N]; N];
        let mut pairs = Pairs { positions: none, rates: none, mass: none };
        for (i, own) in partials.iter().enumerate() {
            let twice = sum(own.inertial, own.inertial);
            let mut k = i;
            while let Some(inboard) = partials.get(k) {
                let Partial { unit, swept, turned, .. } = *inboard;
                (pairs.positions[k][i], pairs.rates[k][i]) = (along(unit, own.position), along(unit, own.rate));
                pairs.positions[i][k] = dot_onto(own.stirred, swept[1], along(turned, own.inertial));
                pairs.rates[i][k] = dot_onto(own.stirred, unit[1], along(swept, twice));
                pairs.mass[i][k] = along(unit, own.inertial);
                k = self.parents[k];
            }
            pairs.mass[i][i] += self.inertias[i];
        }
        pairs
    }
}
