//! Inverse dynamics: forces of joints for given accelerations, in one walk outward and one inward.

use super::number::{Number, Triple, sum, triple, values};
use super::standing::{Stand, Standing};
use super::through::{Solid, Through, through};
use crate::scalar::Scalar;

/// A motion, and the load (force, and torque about the origin) of all links on each joint, and on the base.
pub struct Loaded<T, const N: usize, const RATES: bool, const SECONDS: bool> {
    pub stands: [Stand<T>; N],
    pub rates: [T; N],
    pub seconds: [T; N],
    pub loads: [[[T; 3]; 2]; N],
    pub base: [[T; 3]; 2],
    pub next: usize,
}

/// Motion of a body in its own axes, and the number of its joint.
#[derive(Clone, Copy)]
pub struct Carried<T> {
    pub spin: [T; 3],
    pub linear: [T; 3],
    pub angular: [T; 3],
    pub own: usize,
}

through!([const N: usize, const RATES: bool, const SECONDS: bool] Loaded<T, N, RATES, SECONDS>, Carried<T>, outward);

impl<T: Scalar, const N: usize, const RATES: bool, const SECONDS: bool> Loaded<T, N, RATES, SECONDS> {
    /// An angular acceleration, known to be zero where nothing turns.
    #[inline(always)]
    fn angular(angular: [T; 3]) -> Triple<T> {
        if const { RATES || SECONDS } { triple(angular) } else { [Number::zero(); 3] }
    }
}

impl<T: Scalar, const N: usize, const RATES: bool, const SECONDS: bool> Through<T> for Loaded<T, N, RATES, SECONDS> {
    #[cfg_attr(optimised, inline(always))]
    fn axis<A: Standing<T>>(&mut self, axis: &A, Carried { spin, linear, angular, .. }: Carried<T>) -> Carried<T> {
        let own = self.next;
        self.next += 1;
        let (stand, rate) = (self.stands[own], self.rates[own]);
        let none = [Number::zero(); 3];
        let turning = if const { RATES } { axis.spun(stand, rate, spin) } else { spin };
        let besides =
            if const { RATES } { [axis.swung(spin), triple(axis.bias(stand, rate, turning))] } else { [none; 2] };
        let mut p = axis.accelerated(stand, besides, [triple(linear), Self::angular(angular)]);
        if const { SECONDS } {
            p = axis.moved(self.seconds[own], p);
        }
        Carried { spin: turning, linear: values(p[0]), angular: values(p[1]), own }
    }
    #[cfg_attr(optimised, inline(always))]
    fn link<B: Solid<T>>(&mut self, link: &B, carried: Carried<T>) -> Carried<T> {
        let still = if const { RATES } { link.gyroscopic(carried.spin) } else { [[Number::zero(); 3]; 2] };
        let [force, torque] = link.resisted([triple(carried.linear), Self::angular(carried.angular)], still);
        // Links of the base, or on the ground, are of no joint.
        let load = self.loads.get_mut(carried.own).unwrap_or(&mut self.base);
        *load = [values(sum(triple(load[0]), force)), values(sum(triple(load[1]), torque))];
        carried
    }
}

/// Forces of joints from the loads of links.
pub struct Carrying<T, const N: usize> {
    pub stands: [Stand<T>; N],
    pub loads: [[[T; 3]; 2]; N],
    pub forces: [T; N],
    pub next: usize,
}

through!([const N: usize] Carrying<T, N>, [[T; 3]; 2], inward, |walk, chain, go| {
    let arm = go(walk, [[T::zero(); 3]; 2]);
    [values(sum(triple(chain[0]), triple(arm[0]))), values(sum(triple(chain[1]), triple(arm[1])))]
});

impl<T: Scalar, const N: usize> Through<T> for Carrying<T, N> {
    #[cfg_attr(optimised, inline(always))]
    fn axis<A: Standing<T>>(&mut self, axis: &A, [force, torque]: [[T; 3]; 2]) -> [[T; 3]; 2] {
        self.next -= 1;
        let [own_force, own_torque] = self.loads[self.next];
        let whole = [sum(triple(force), triple(own_force)), sum(triple(torque), triple(own_torque))];
        self.forces[self.next] = axis.along(whole);
        let [force, torque] = axis.carried(self.stands[self.next], whole);
        [values(force), values(torque)]
    }
    #[inline(always)]
    fn link<B: Solid<T>>(&mut self, _: &B, carried: [[T; 3]; 2]) -> [[T; 3]; 2] {
        carried
    }
}

/// What the joints' own laws and reflected inertias say: their forces, and inertias.
pub struct Resisting<T, const N: usize> {
    pub positions: [T; N],
    pub rates: [T; N],
    pub stands: [Stand<T>; N],
    pub laws: [T; N],
    pub inertias: [T; N],
    pub energies: [T; N],
    pub next: usize,
}

through!([const N: usize] Resisting<T, N>, (), outward);

impl<T: Scalar, const N: usize> Through<T> for Resisting<T, N> {
    #[cfg_attr(optimised, inline(always))]
    fn axis<A: Standing<T>>(&mut self, axis: &A, (): ()) {
        let own = self.next;
        self.next += 1;
        let (position, rate) = (self.positions[own], self.rates[own]);
        if const { !A::TURNS } {
            self.stands[own] = [T::zero(), position];
        }
        self.laws[own] = axis.law(position, rate);
        self.energies[own] = axis.energy(position);
        self.inertias[own] = axis.inertia().value();
    }
    #[inline(always)]
    fn link<B: Solid<T>>(&mut self, _: &B, (): ()) {}
}

/// How the joints' own laws change: stiffness and damping, −∂force/∂position and −∂force/∂rate.
pub struct Slopes<T, const N: usize> {
    pub positions: [T; N],
    pub rates: [T; N],
    pub slopes: [[T; 2]; N],
    pub next: usize,
}

through!([const N: usize] Slopes<T, N>, (), outward);

impl<T: Scalar, const N: usize> Through<T> for Slopes<T, N> {
    #[cfg_attr(optimised, inline(always))]
    fn axis<A: Standing<T>>(&mut self, axis: &A, (): ()) {
        let own = self.next;
        self.next += 1;
        self.slopes[own] = axis.slopes(self.positions[own], self.rates[own]);
    }
    #[inline(always)]
    fn link<B: Solid<T>>(&mut self, _: &B, (): ()) {}
}
