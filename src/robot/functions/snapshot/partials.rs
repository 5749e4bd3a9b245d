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
use super::screws::{Pair, more, sum, swept, swept_wrench};
use super::{Moving, Snapshot, six};
use crate::relation::spatial::algebra::zero;
use crate::scalar::Scalar;
use core::ops::Add;
use nalgebra::Vector3;

/// A joint: how it moves what it carries, and what that takes. What is by positions and what is by rates stand side by side.
#[derive(Clone, Copy)]
pub struct Partial<T> {
    /// S.
    unit: [T; 6],
    /// ψ″ and 2 ψ′.
    carried: [[T; 2]; 6],
    /// Angular velocities of ψ′ and of S.
    turned: [[T; 2]; 3],
    /// I S, what an acceleration of one takes.
    pub inertial: Pair<T>,
    /// 2 Bᵀ S.
    pub stirred: Vector3<T>,
    /// Wrenches by the position and by the rate.
    pub wrenches: [[T; 2]; 6],
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

/// A row of derivatives of one number: by positions, by rates, and by torques, each by as many coordinates.
pub type By<T, const W: usize> = [[T; W]; 3];

/// sum + factor · two.
#[inline(always)]
fn onto<T: Scalar>(sum: [T; 2], factor: T, two: [T; 2]) -> [T; 2] {
    [factor.mul_add(two[0], sum[0]), factor.mul_add(two[1], sum[1])]
}

impl<T: Scalar, const N: usize> Snapshot<T, N> {
    /// A body at a twist and its acceleration.
    #[cfg_attr(optimised, inline(always))]
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
            let half = stirred.transposed(unit);
            let position = sum(twice(stirred.apply(changing[1])), inertial.moved(turned));
            let position = six(sum(position, swept_wrench(unit, *wrench)));
            let rate = six(twice(sum(stirred.apply(unit[1]), inertial.moved(changing))));
            let (first, second) = (six(turned), six(twice(changing)));
            Partial {
                unit: six(unit),
                carried: core::array::from_fn(|i| [first[i], second[i]]),
                turned: core::array::from_fn(|i| [changing[1][i], unit[1][i]]),
                inertial: inertial.moved(unit),
                stirred: half + half,
                wrenches: core::array::from_fn(|i| [position[i], rate[i]]),
            }
        };
        (core::array::from_fn(partial), whole)
    }

    /// Puts derivatives of the torque of a joint by the position and the rate of another one, one pair of joints after the other.
    #[cfg_attr(optimised, inline(always))]
    pub(in crate::robot::functions) fn pairs(
        &self,
        partials: &[Partial<T>; N],
        mut put: impl FnMut(usize, usize, [T; 2]),
    ) {
        for (i, own) in partials.iter().enumerate() {
            let (inertial, stirred) = (six(own.inertial), own.stirred);
            let mut k = i;
            while let Some(inboard) = partials.get(k) {
                let Partial { unit, carried, turned, .. } = inboard;
                let (mut of_own, mut of_inboard) = ([T::zero(); 2], [T::zero(); 2]);
                for c in 0..6 {
                    of_own = onto(of_own, inertial[c], carried[c]);
                    of_inboard = onto(of_inboard, unit[c], own.wrenches[c]);
                }
                for c in 0..3 {
                    of_own = onto(of_own, stirred[c], turned[c]);
                }
                put(k, i, of_inboard);
                put(i, k, of_own);
                k = self.parents[k];
            }
        }
    }

    /// The lower half of the mass matrix, as far as joints are related.
    pub(in crate::robot::functions) fn lower(&self, partials: &[Partial<T>; N]) -> [[T; N]; N] {
        let mut mass = [[T::zero(); N]; N];
        for (i, own) in partials.iter().enumerate() {
            let (inertial, mut k) = (six(own.inertial), i);
            while let Some(Partial { unit, .. }) = partials.get(k) {
                mass[i][k] = unit.iter().zip(inertial).fold(T::zero(), |sum, (x, y)| x.mul_add(y, sum));
                k = self.parents[k];
            }
            mass[i][i] += self.inertias[i];
        }
        mass
    }
}
