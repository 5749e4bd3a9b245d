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

use super::Snapshot;
use super::massive::{Inertial, Stirred};
use super::screws::{Pair, along, more, sum, swept, swept_wrench};
use crate::relation::spatial::algebra::{dot_onto, zero};
use crate::scalar::Scalar;
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

/// Derivatives of the torques of joints by positions and by rates, and the lower half of the mass matrix, as far as joints are
/// related, where joint i is outboard of k.
pub struct Pairs<T, const N: usize> {
    pub positions: [[T; N]; N],
    pub rates: [[T; N]; N],
    pub mass: [[T; N]; N],
}

impl<T: Scalar, const N: usize> Snapshot<T, N> {
    /// The body on a joint, or the base, at a twist and its acceleration.
    #[inline(always)]
    fn outboard(&self, joint: usize, v: Pair<T>, a: Pair<T>) -> Outboard<T> {
        let body = self.bodies.get(joint).unwrap_or(&self.base);
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
        let [v, a] = self.ground(base);
        let (none, whole) = ([zero(), zero()], self.outboard(usize::MAX, v, a));
        let (stirred, rest) = (zero(), none);
        let blank =
            Partial { unit: none, swept: none, turned: none, inertial: none, stirred, position: rest, rate: rest };
        let (mut partials, mut all, mut motions) = ([blank; N], [whole; N], [[v, a]; N]);
        for k in 0..N {
            let [v, a] = motions.get(self.parents[k]).copied().unwrap_or([v, a]);
            let unit = self.unit(k);
            let changing = swept(v, unit);
            partials[k] = Partial { unit, swept: changing, turned: sum(swept(a, unit), swept(v, changing)), ..blank };
            let (v, a) = (more(v, self.rates[k], unit), more(more(a, seconds[k], unit), self.rates[k], changing));
            motions[k] = [v, a];
            all[k] = self.outboard(k, v, a);
        }
        let mut sum_of_all = whole;
        for k in (0..N).rev() {
            let own = all[k];
            let Outboard { inertial, stirred, wrench } = own;
            let Partial { unit, swept: changing, turned, .. } = partials[k];
            let twice = |pair: Pair<T>| sum(pair, pair);
            let position = sum(twice(stirred.apply(changing[1])), inertial.moved(turned));
            let half = stirred.transposed(unit);
            partials[k] = Partial {
                inertial: inertial.moved(unit),
                stirred: half + half,
                position: sum(position, swept_wrench(unit, wrench)),
                rate: twice(sum(stirred.apply(unit[1]), inertial.moved(changing))),
                ..partials[k]
            };
            let inboard = all.get_mut(self.parents[k]).unwrap_or(&mut sum_of_all);
            *inboard = Outboard {
                inertial: inboard.inertial + inertial,
                stirred: inboard.stirred + stirred,
                wrench: sum(inboard.wrench, wrench),
            };
        }
        (partials, sum_of_all)
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
