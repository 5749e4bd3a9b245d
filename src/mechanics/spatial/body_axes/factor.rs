//! The mass matrix factored, M = L D Lᵀ, by eliminations of joints from the tips on: solutions for any forces take two walks through it.

use super::number::{Number, sum, triple, values};
use super::relation::{Gains, Local, Outboard};
use super::standing::{Stand, Standing};
use super::through::{Solid, Through, through};
use crate::relation::spatial::Empty;
use crate::relation::{Join, Promote};
use crate::scalar::Scalar;

/// What eliminations leave behind; free is 1 / D.
pub struct Factor<T, const N: usize> {
    pub stands: [Stand<T>; N],
    pub gains: [Gains<T>; N],
    pub next: usize,
}

through!([const N: usize] Factor<T, N>, Local<T>, inward, |walk, chain, go| {
    let arm = go(walk, Local::promote(Empty));
    chain.join(arm)
});

impl<T: Scalar, const N: usize> Through<T> for Factor<T, N> {
    #[cfg_attr(optimised, inline(always))]
    fn axis<A: Standing<T>>(&mut self, axis: &A, relation: Local<T>) -> Local<T> {
        self.next -= 1;
        let (stand, o) = (self.stands[self.next], T::zero());
        let mut relation = relation.sparse();
        let none = [Number::zero(); 3];
        (relation.force, relation.torque) = (none, none);
        let (relation, gains, _) = if const { A::TURNS } {
            relation.hinged(T::one(), axis.inertia(), [o; 2])
        } else {
            relation.slid(T::one(), axis.inertia(), [o; 3])
        };
        self.gains[self.next] = gains;
        let relation = relation.at_joint(A::TURNS, stand);
        relation.turned(&axis.offset()).shifted(axis.arm(), none).dense()
    }
    #[inline(always)]
    fn link<B: Solid<T>>(&mut self, link: &B, relation: Local<T>) -> Local<T> {
        relation.with_body(link.mass(), link.moment(), link.tensor())
    }
}

/// Forces of joints carried inward: what each is free to do.
pub struct Inward<T, const N: usize> {
    pub stands: [Stand<T>; N],
    pub gains: [Gains<T>; N],
    /// Forces, and then accelerations where inboard bodies rest.
    pub free: [T; N],
    pub next: usize,
}

through!([const N: usize] Inward<T, N>, [[T; 3]; 2], inward, |walk, chain, go| {
    let arm = go(walk, [[T::zero(); 3]; 2]);
    [values(sum(triple(chain[0]), triple(arm[0]))), values(sum(triple(chain[1]), triple(arm[1])))]
});

impl<T: Scalar, const N: usize> Through<T> for Inward<T, N> {
    #[cfg_attr(optimised, inline(always))]
    fn axis<A: Standing<T>>(&mut self, axis: &A, [force, torque]: [[T; 3]; 2]) -> [[T; 3]; 2] {
        self.next -= 1;
        let Gains { linear, angular, free: inverse } = self.gains[self.next];
        let mut whole = [triple(force), triple(torque)];
        // U free = G (τ − F along the axis), but along the axis itself τ − I free.
        let left = self.free[self.next] - axis.along(whole);
        let add = super::number::more;
        whole = [add(whole[0], Number::of(left), triple(linear)), add(whole[1], Number::of(left), triple(angular))];
        self.free[self.next] = left * inverse;
        let [force, torque] = axis.carried(self.stands[self.next], whole);
        [values(force), values(torque)]
    }
    #[inline(always)]
    fn link<B: Solid<T>>(&mut self, _: &B, carried: [[T; 3]; 2]) -> [[T; 3]; 2] {
        carried
    }
}

/// Accelerations from what joints are free to do.
pub struct Outward<T, const N: usize> {
    pub stands: [Stand<T>; N],
    pub gains: [Gains<T>; N],
    pub free: [T; N],
    pub next: usize,
}

through!([const N: usize] Outward<T, N>, [[T; 3]; 2], outward);

impl<T: Scalar, const N: usize> Through<T> for Outward<T, N> {
    #[cfg_attr(optimised, inline(always))]
    fn axis<A: Standing<T>>(&mut self, axis: &A, [linear, angular]: [[T; 3]; 2]) -> [[T; 3]; 2] {
        let own = self.next;
        self.next += 1;
        let gains = &self.gains[own];
        let none = [Number::zero(); 3];
        let p = axis.accelerated(self.stands[own], [none; 2], [triple(linear), triple(angular)]);
        let [a, b] = [values(p[0]), values(p[1])];
        let mut second = self.free[own];
        for k in 0..3 {
            second = (-gains.linear[k]).mul_add(a[k], (-gains.angular[k]).mul_add(b[k], second));
        }
        self.free[own] = second;
        let [linear, angular] = axis.moved(second, p);
        [values(linear), values(angular)]
    }
    #[inline(always)]
    fn link<B: Solid<T>>(&mut self, _: &B, carried: [[T; 3]; 2]) -> [[T; 3]; 2] {
        carried
    }
}
