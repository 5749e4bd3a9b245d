//! The mirror of a loop: coordinates of its arms, and with accelerations the forces that close it.

use super::{Mode, Position, Rate, Term};
use crate::lift::Lift;
use crate::scalar::Scalar;
use core::marker::PhantomData;

/// What is stored of the arms of a loop and of the joint that closes it.
///
/// With rates and accelerations this is the force that closes it. It belongs to the accelerations and is no coordinate: it is carried
/// along in sums, but not counted, visited or replaced.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Tied<X, F> {
    /// Of the main arm and the side arm.
    pub arms: X,
    /// Of the joint that closes it: with rates, internal force and torque there (N, N·m).
    pub closing: F,
}

/// Positions of the coordinates of a loop.
pub type TiedPosition<X, F> = Tied<X, PhantomData<F>>;

impl<X, F> TiedPosition<X, F> {
    /// Positions of the arms.
    pub fn of(arms: X) -> Self {
        Self { arms, closing: PhantomData }
    }
}

impl<T: Scalar, X: Rate<T>, F: Rate<T>> Rate<T> for Tied<X, F> {
    const LENGTH: usize = X::LENGTH.saturating_add(F::LENGTH);

    #[inline(always)]
    fn set(&mut self, base: &Self) {
        self.arms.set(&base.arms);
        self.closing.set(&base.closing);
    }
    #[inline(always)]
    fn mix_1(&mut self, base: &Self, (u, a): Term<'_, T, Self>) {
        self.arms.mix_1(&base.arms, (u, &a.arms));
        self.closing.mix_1(&base.closing, (u, &a.closing));
    }
    #[inline(always)]
    fn mix_2(&mut self, base: &Self, (u, a): Term<'_, T, Self>, (v, b): Term<'_, T, Self>) {
        self.arms.mix_2(&base.arms, (u, &a.arms), (v, &b.arms));
        self.closing.mix_2(&base.closing, (u, &a.closing), (v, &b.closing));
    }
    #[inline(always)]
    fn mix_3(&mut self, base: &Self, (u, a): Term<'_, T, Self>, (v, b): Term<'_, T, Self>, (w, c): Term<'_, T, Self>) {
        self.arms.mix_3(&base.arms, (u, &a.arms), (v, &b.arms), (w, &c.arms));
        self.closing.mix_3(&base.closing, (u, &a.closing), (v, &b.closing), (w, &c.closing));
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
        self.closing.add_4((u, &a.closing), (v, &b.closing), (w, &c.closing), (x, &d.closing));
    }
    #[inline(always)]
    fn add(&mut self, step: &Self) {
        self.arms.add(&step.arms);
        self.closing.add(&step.closing);
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

impl<T: Scalar, X: Position<T>, F: Rate<T>> Position<T> for TiedPosition<X, F> {
    type Rate = Tied<X::Rate, F>;

    const CURVED: bool = X::CURVED;
    const STICKS: bool = X::STICKS;

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
    fn apart(&self, from: &Self, displacement: &mut Self::Rate) {
        self.arms.apart(&from.arms, &mut displacement.arms);
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
    fn normalise(&mut self) -> bool {
        self.arms.normalise()
    }
    fn each_mode(
        &mut self,
        rate: &mut Self::Rate,
        acceleration: &Self::Rate,
        visit: &mut impl FnMut(&mut Mode, &mut T, [T; 2]),
    ) {
        self.arms.each_mode(&mut rate.arms, &acceleration.arms, visit);
    }
    #[inline(always)]
    fn set_clocks(&mut self, time: T::Real) {
        self.arms.set_clocks(time);
    }
    #[inline(always)]
    fn retract_rate(&self, from: &Self, rate: &mut Self::Rate) {
        self.arms.retract_rate(&from.arms, &mut rate.arms);
    }
    #[inline(always)]
    fn inverse_retract_acceleration(&self, from: &Self, rate: &Self::Rate, acceleration: &mut Self::Rate) {
        self.arms.inverse_retract_acceleration(&from.arms, &rate.arms, &mut acceleration.arms);
    }
    #[inline(always)]
    fn transposed_acceleration(&self, from: &Self, costate: &mut Self::Rate) {
        self.arms.transposed_acceleration(&from.arms, &mut costate.arms);
    }
    #[inline(always)]
    fn transposed_step(
        &self,
        from: &Self,
        (rate, acceleration): (&Self::Rate, &Self::Rate),
        of_second: &Self::Rate,
        (of_position, of_rate): (&mut Self::Rate, &mut Self::Rate),
        of_from: &mut Self::Rate,
    ) {
        let (here, of_here) = ((&rate.arms, &acceleration.arms), (&mut of_position.arms, &mut of_rate.arms));
        self.arms.transposed_step(&from.arms, here, &of_second.arms, of_here, &mut of_from.arms);
    }
}

impl<T: Scalar, U: Scalar, X: Lift<T, U>, F: Lift<T, U>> Lift<T, U> for Tied<X, F> {
    type Over = Tied<X::Over, F::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Tied { arms: self.arms.lift(number), closing: self.closing.lift(number) }
    }
}

impl<T: Scalar, U: Scalar, F: Lift<T, U>> Lift<T, U> for PhantomData<F> {
    type Over = PhantomData<F::Over>;
    fn lift(&self, _: &mut impl FnMut(T) -> U) -> Self::Over {
        PhantomData
    }
}
