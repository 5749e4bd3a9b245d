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
use super::{MassMatrix, Moving, Snapshot, six};
use crate::relation::spatial::algebra::zero;
use crate::scalar::Scalar;
use core::ops::Add;
use nalgebra::Vector3;

/// How a joint moves what it carries. What is by positions and what is by rates stand side by side.
#[derive(Clone, Copy)]
pub struct Carrying<T> {
    /// S.
    unit: [T; 6],
    /// ψ″ and 2 ψ′.
    carried: [[T; 2]; 6],
    /// Angular velocities of ψ′ and of S.
    turned: [[T; 2]; 3],
}

/// Inertia and wrenches of a joint and all that is outboard, as its motion meets them.
pub struct Partial<T> {
    /// I S, what an acceleration of one takes.
    pub inertial: Pair<T>,
    /// 2 Bᵀ S.
    pub stirred: Vector3<T>,
    /// Wrenches by the position and by the rate.
    pub wrenches: [[T; 2]; 6],
}

/// A body, or all that is outboard of a joint or of the base: I, B, and the wrench f that its motion takes.
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

impl<T: Scalar> Outboard<T> {
    /// Outboard of a joint.
    #[cfg_attr(optimised, inline(always))]
    fn partial(&self, Carrying { unit, carried, turned }: &Carrying<T>) -> Partial<T> {
        let Self { inertial, stirred, wrench } = self;
        let pair = |six: [T; 6]| {
            let [x, y, z, a, b, c] = six;
            [Vector3::new(x, y, z), Vector3::new(a, b, c)]
        };
        let (unit, turning, doubled) = (pair(*unit), pair(carried.map(|two| two[0])), pair(carried.map(|two| two[1])));
        let changing = Vector3::from(turned.map(|two| two[0]));
        let half = stirred.transposed(unit);
        let position = sum(twice(stirred.apply(changing)), inertial.moved(turning));
        let position = six(sum(position, swept_wrench(unit, *wrench)));
        let rate = six(sum(twice(stirred.apply(unit[1])), inertial.moved(doubled)));
        Partial {
            inertial: inertial.moved(unit),
            stirred: half + half,
            wrenches: core::array::from_fn(|i| [position[i], rate[i]]),
        }
    }
}

/// 2 a.
#[inline(always)]
fn twice<T: Scalar>(pair: Pair<T>) -> Pair<T> {
    sum(pair, pair)
}

/// sum + factor · two.
#[inline(always)]
fn onto<T: Scalar>(sum: [T; 2], factor: T, two: [T; 2]) -> [T; 2] {
    [factor.mul_add(two[0], sum[0]), factor.mul_add(two[1], sum[1])]
}

/// What positions and rates say, whatever the accelerations.
pub struct Moved<T, const N: usize> {
    /// S, ψ′, and v of the body that carries the joint.
    joints: [[Pair<T>; 3]; N],
    /// Of each body alone, by its velocity: v ×* h.
    bodies: [Outboard<T>; N],
    base: Outboard<T>,
}

impl<T: Scalar, const N: usize> Snapshot<T, N> {
    /// Puts the origin where the joint of least inertia is, on a base that rests: what turns a wrist of little inertia at a great acceleration cancels
    /// about an origin far away, and with it five digits.
    pub(in crate::robot::functions) fn about_the_lightest(&mut self, inertia: impl Fn(usize) -> T) {
        let lighter = |a: usize, b: usize| if inertia(b).real() < inertia(a).real() { b } else { a };
        if let Some(lightest) = (0..N).reduce(lighter) {
            self.base.place.place = self.bodies[lightest].place.place;
        }
    }

    /// A body at a twist.
    #[cfg_attr(optimised, inline(always))]
    fn body_moved(&self, body: &Moving<T>, v: Pair<T>) -> Outboard<T> {
        let (inertial, second) = Inertial::of(body, body.place.place - self.base.place.place);
        let stirred = Stirred::of(&inertial, second, v);
        Outboard { inertial, stirred, wrench: swept_wrench(v, stirred.momenta()) }
    }

    /// What positions and rates say.
    #[cfg_attr(optimised, inline(always))]
    pub(in crate::robot::functions) fn moved(&self) -> Moved<T, N> {
        let ground = [zero(), self.base.spin]; // seen by one who moves with the base
        let base = self.body_moved(&self.base, ground);
        let (mut twists, mut joints, mut bodies) = ([ground; N], [[ground; 3]; N], [base; N]);
        for k in 0..N {
            let (v, unit) = (twists.get(self.parents[k]).copied().unwrap_or(ground), self.unit(k));
            twists[k] = more(v, self.rates[k], unit);
            joints[k] = [unit, swept(v, unit), v];
            bodies[k] = self.body_moved(&self.bodies[k], twists[k]);
        }
        Moved { joints, bodies, base }
    }

    /// Acceleration of the base, as felt by one who moves with its velocity.
    pub(super) fn ground(&self, base: &[T; 6]) -> Pair<T> {
        let [ax, ay, az, bx, by, bz] = *base;
        let angular = self.base.place.attitude.apply(Vector3::new(bx, by, bz));
        let [felt, carried] = self.carried;
        [Vector3::new(ax, ay, az) + felt, angular + carried]
    }

    /// Partial derivatives of each joint, from the tips on, with how all joints move what they carry; and what is outboard of the base, with the
    /// base.
    #[cfg_attr(optimised, inline(always))]
    pub(in crate::robot::functions) fn partials(
        &self,
        Moved { joints, bodies, base: whole }: &mut Moved<T, N>,
        (base, seconds): (&[T; 6], &[T; N]),
        mut each: impl FnMut(usize, &Partial<T>, &[Carrying<T>; N]),
    ) -> Outboard<T> {
        let ground = self.ground(base);
        let none = [T::zero(); 2];
        let mut carrying = [Carrying { unit: [T::zero(); 6], carried: [none; 6], turned: [none; 3] }; N];
        let mut accelerations = [ground; N];
        for (k, [unit, changing, v]) in joints.iter().enumerate() {
            let a = accelerations.get(self.parents[k]).copied().unwrap_or(ground);
            let a_own = more(more(a, seconds[k], *unit), self.rates[k], *changing);
            (accelerations[k], bodies[k].wrench) = (a_own, sum(bodies[k].wrench, bodies[k].inertial.moved(a_own)));
            let turned = sum(swept(a, *unit), swept(*v, *changing));
            let (first, second) = (six(turned), six(twice(*changing)));
            carrying[k] = Carrying {
                unit: six(*unit),
                carried: core::array::from_fn(|i| [first[i], second[i]]),
                turned: core::array::from_fn(|i| [changing[1][i], unit[1][i]]),
            };
        }
        whole.wrench = sum(whole.wrench, whole.inertial.moved(ground));
        for k in (0..N).rev() {
            let outboard = bodies[k];
            each(k, &outboard.partial(&carrying[k]), &carrying);
            let inboard = bodies.get_mut(self.parents[k]).unwrap_or(whole);
            *inboard = *inboard + outboard;
        }
        *whole
    }

    /// What joints take that do not accelerate, and what each one takes for an acceleration of one; and all as one body with what that takes, at the
    /// place of the base.
    #[cfg_attr(optimised, inline(always))]
    pub(in crate::robot::functions) fn bias(
        &self,
        Moved { joints, bodies, base: own }: &Moved<T, N>,
        mut each: impl FnMut(usize, Pair<T>),
    ) -> ([T; N], (Inertial<T>, Pair<T>)) {
        let ground = self.ground(&[T::zero(); 6]);
        let taken = |body: &Outboard<T>, a: Pair<T>| (body.inertial, sum(body.wrench, body.inertial.moved(a)));
        let mut whole = taken(own, ground);
        let (mut accelerations, mut all, mut bias) = ([ground; N], [whole; N], [T::zero(); N]);
        for (k, [_, changing, _]) in joints.iter().enumerate() {
            let a = accelerations.get(self.parents[k]).copied().unwrap_or(ground);
            accelerations[k] = more(a, self.rates[k], *changing);
            all[k] = taken(&bodies[k], accelerations[k]);
        }
        for k in (0..N).rev() {
            let ((inertial, wrench), [unit, ..]) = (all[k], joints[k]);
            bias[k] = along(unit, wrench) - self.laws[k];
            each(k, inertial.moved(unit));
            let inboard = all.get_mut(self.parents[k]).unwrap_or(&mut whole);
            *inboard = (inboard.0 + inertial, sum(inboard.1, wrench));
        }
        (bias, whole)
    }

    /// The mass matrix, its half below the diagonal of joints, and what base and joints take that do not accelerate.
    pub(in crate::robot::functions) fn bias_afloat(
        &self,
        moved: &Moved<T, N>,
        MassMatrix { base, coupling, joints }: &mut MassMatrix<T, N>,
    ) -> ([T; 6], [T; N]) {
        let (bias, (inertial, wrench)) = self.bias(moved, |k, taken| {
            self.inboard(k, |i| joints[k][i] = along(moved.joints[i][0], taken));
            joints[k][k] += self.inertias[k];
            coupling[k] = self.on_base(taken);
        });
        *base = self.inertia_of_base(&inertial);
        (self.on_base(wrench), bias)
    }

    /// Puts derivatives of the torque of a joint by the position and the rate of each inboard of it or the joint itself, and of theirs by its own.
    #[cfg_attr(optimised, inline(always))]
    pub(in crate::robot::functions) fn pairs(
        &self,
        i: usize,
        Partial { inertial, stirred, wrenches }: &Partial<T>,
        carrying: &[Carrying<T>; N],
        mut put: impl FnMut(usize, usize, [T; 2]),
    ) {
        let inertial = six(*inertial);
        let mut k = i;
        while let Some(Carrying { unit, carried, turned }) = carrying.get(k) {
            let (mut of_own, mut of_inboard) = ([T::zero(); 2], [T::zero(); 2]);
            for c in 0..6 {
                of_own = onto(of_own, inertial[c], carried[c]);
                of_inboard = onto(of_inboard, unit[c], wrenches[c]);
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
