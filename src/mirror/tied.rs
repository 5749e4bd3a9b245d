//! The mirror of a loop: coordinates of its arms, and with accelerations the forces that close it.

use super::{Position, Rate, Term};
use crate::lift::Lift;
use crate::relation::Closures;
use crate::scalar::Scalar;
use core::marker::PhantomData;

/// Rates or accelerations of the coordinates of a loop. The forces that close it belong to its accelerations and are no coordinates:
/// they are carried along in sums, but not counted, visited or replaced.
pub struct Tied<X, T: Copy, O: Closures> {
    /// Rates or accelerations of the arms.
    pub arms: X,
    /// Closure forces (N, N·m).
    pub forces: O::Each<T>,
}

/// Positions of the coordinates of a loop.
pub struct TiedPosition<X, T, O> {
    /// Positions of the arms.
    pub arms: X,
    closing: PhantomData<(T, O)>,
}

impl<X: Clone, T: Copy, O: Closures> Clone for Tied<X, T, O> {
    #[inline(always)]
    fn clone(&self) -> Self {
        Self { arms: self.arms.clone(), forces: self.forces }
    }
}
impl<X: Copy, T: Copy, O: Closures> Copy for Tied<X, T, O> {}

impl<X: Clone, T, O> Clone for TiedPosition<X, T, O> {
    #[inline(always)]
    fn clone(&self) -> Self {
        Self::of(self.arms.clone())
    }
}
impl<X: Copy, T, O> Copy for TiedPosition<X, T, O> {}

impl<X, T, O> TiedPosition<X, T, O> {
    /// Positions of the arms.
    pub fn of(arms: X) -> Self {
        Self { arms, closing: PhantomData }
    }
}

impl<X: Rate<T>, T: Scalar, O: Closures> Tied<X, T, O> {
    /// Adds scaled forces.
    #[inline(always)]
    fn pull(&mut self, (weight, term): Term<'_, T, Self>) {
        self.forces = O::zip(&self.forces, &term.forces, |sum, x| sum.add_scaled(weight, x));
    }
}

impl<X: Rate<T>, T: Scalar, O: Closures> Rate<T> for Tied<X, T, O> {
    #[inline(always)]
    fn set(&mut self, base: &Self) {
        self.arms.set(&base.arms);
        self.forces = base.forces;
    }
    #[inline(always)]
    fn mix_1(&mut self, base: &Self, (u, a): Term<'_, T, Self>) {
        self.arms.mix_1(&base.arms, (u, &a.arms));
        self.forces = base.forces;
        self.pull((u, a));
    }
    #[inline(always)]
    fn mix_2(&mut self, base: &Self, (u, a): Term<'_, T, Self>, (v, b): Term<'_, T, Self>) {
        self.arms.mix_2(&base.arms, (u, &a.arms), (v, &b.arms));
        self.forces = base.forces;
        self.pull((u, a));
        self.pull((v, b));
    }
    #[inline(always)]
    fn mix_3(&mut self, base: &Self, (u, a): Term<'_, T, Self>, (v, b): Term<'_, T, Self>, (w, c): Term<'_, T, Self>) {
        self.arms.mix_3(&base.arms, (u, &a.arms), (v, &b.arms), (w, &c.arms));
        self.forces = base.forces;
        self.pull((u, a));
        self.pull((v, b));
        self.pull((w, c));
    }
    #[inline(always)]
    fn add_4(
        &mut self,
        (u, a): Term<'_, T, Self>,
        (v, b): Term<'_, T, Self>,
        (w, c): Term<'_, T, Self>,
        (x, d): Term<'_, T, Self>,
    ) {
        self.arms.add_4((u, &a.arms), (v, &b.arms), (w, &c.arms), (x, &d.arms));
        self.pull((u, a));
        self.pull((v, b));
        self.pull((w, c));
        self.pull((x, d));
    }
    #[inline(always)]
    fn add(&mut self, step: &Self) {
        self.arms.add(&step.arms);
        self.forces = O::zip(&self.forces, &step.forces, |a, b| a + b);
    }
    #[inline(always)]
    fn visit(&self, visit: &mut impl FnMut(T)) {
        self.arms.visit(visit);
    }
    #[inline(always)]
    fn replace(&mut self, make: &mut impl FnMut(T) -> T) {
        self.arms.replace(make);
    }
    #[inline(always)]
    fn all(&self, other: &Self, test: &mut impl FnMut(T, T) -> bool) -> bool {
        self.arms.all(&other.arms, test)
    }
}

impl<X: Position<T>, T: Scalar, O: Closures> Position<T> for TiedPosition<X, T, O> {
    type Rate = Tied<X::Rate, T, O>;

    const CURVED: bool = X::CURVED;

    #[inline(always)]
    fn drift_0(&mut self, from: &Self, (time, rate): Term<'_, T, Self::Rate>) {
        self.arms.drift_0(&from.arms, (time, &rate.arms));
    }
    #[inline(always)]
    fn drift_1(&mut self, from: &Self, (time, rate): Term<'_, T, Self::Rate>, (u, a): Term<'_, T, Self::Rate>) {
        self.arms.drift_1(&from.arms, (time, &rate.arms), (u, &a.arms));
    }
    #[inline(always)]
    fn drift_2(
        &mut self,
        from: &Self,
        (time, rate): Term<'_, T, Self::Rate>,
        (u, a): Term<'_, T, Self::Rate>,
        (v, b): Term<'_, T, Self::Rate>,
    ) {
        self.arms.drift_2(&from.arms, (time, &rate.arms), (u, &a.arms), (v, &b.arms));
    }
    #[inline(always)]
    fn displace(&mut self, step: &Self::Rate) {
        self.arms.displace(&step.arms);
    }
    #[inline(always)]
    fn measure(&self, displacement: &Self::Rate, note: &mut impl FnMut(T, T::Real)) {
        self.arms.measure(&displacement.arms, note);
    }
    #[inline(always)]
    fn visit(&self, visit: &mut impl FnMut(T)) {
        self.arms.visit(visit);
    }
    #[inline(always)]
    fn replace(&mut self, make: &mut impl FnMut(T) -> T) {
        self.arms.replace(make);
    }
    #[inline(always)]
    fn all(&self, other: &Self, test: &mut impl FnMut(T, T) -> bool) -> bool {
        self.arms.all(&other.arms, test)
    }
    #[inline(always)]
    fn land(&self, from: &Self, rate: &mut Self::Rate) {
        self.arms.land(&from.arms, &mut rate.arms);
    }
    #[inline(always)]
    fn unroll(&self, from: &Self, rate: &Self::Rate, acceleration: &mut Self::Rate) {
        self.arms.unroll(&from.arms, &rate.arms, &mut acceleration.arms);
    }
}

impl<X: Lift<T, U>, T: Scalar, U: Scalar, O: Closures> Lift<T, U> for Tied<X, T, O> {
    type Over = Tied<X::Over, U, O>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Tied { arms: self.arms.lift(number), forces: O::map(&self.forces, number) }
    }
}

impl<X: Lift<T, U>, T: Scalar, U: Scalar, O: Closures> Lift<T, U> for TiedPosition<X, T, O> {
    type Over = TiedPosition<X::Over, U, O>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        TiedPosition::of(self.arms.lift(number))
    }
}
