//! A number is the coordinate of a joint with one degree of freedom.

use super::{Position, Rate, Retraction, Term};
use crate::scalar::Scalar;

impl<T: Scalar> Rate<T> for T {
    const LENGTH: usize = 1;

    #[inline(always)]
    fn set(&mut self, base: &T) {
        *self = *base;
    }
    #[cfg_attr(optimised, inline(always))]
    fn mix_1(&mut self, base: &T, (u, a): Term<'_, T, T>) {
        match T::LARGE {
            true => self.combine(base, [(u, a)]),
            false => *self = base.add_scaled(u, *a),
        }
    }
    #[cfg_attr(optimised, inline(always))]
    fn mix_2(&mut self, base: &T, (u, a): Term<'_, T, T>, (v, b): Term<'_, T, T>) {
        match T::LARGE {
            true => self.combine(base, [(u, a), (v, b)]),
            false => *self = base.add_scaled(u, *a).add_scaled(v, *b),
        }
    }
    #[cfg_attr(optimised, inline(always))]
    fn mix_3(&mut self, base: &T, (u, a): Term<'_, T, T>, (v, b): Term<'_, T, T>, (w, c): Term<'_, T, T>) {
        match T::LARGE {
            true => self.combine(base, [(u, a), (v, b), (w, c)]),
            false => *self = base.add_scaled(u, *a).add_scaled(v, *b).add_scaled(w, *c),
        }
    }
    #[cfg_attr(optimised, inline(always))]
    fn add_4(
        &mut self,
        (u, a): Term<'_, T, T>,
        (v, b): Term<'_, T, T>,
        (w, c): Term<'_, T, T>,
        (x, d): Term<'_, T, T>,
    ) {
        match T::LARGE {
            true => self.accumulate([(u, a), (v, b), (w, c), (x, d)]),
            false => *self = self.add_scaled(u, *a).add_scaled(v, *b).add_scaled(w, *c).add_scaled(x, *d),
        }
    }
    #[inline(always)]
    fn add(&mut self, step: &T) {
        *self += *step;
    }
    #[inline(always)]
    fn scale_onto(&mut self, u: T::Real, base: &T) {
        let a = *self;
        self.mix_1(base, (u, &a));
    }
    #[inline(always)]
    fn square_shares(&mut self, of: &T, size: &T) {
        let share = *of / (Scalar::abs(*size) + T::one());
        *self = share * share;
    }
    #[inline(always)]
    fn visit(&self, visit: &mut impl FnMut(T)) {
        visit(*self);
    }
    #[inline(always)]
    fn replace(&mut self, make: &mut impl FnMut(T) -> T) {
        *self = make(*self);
    }
    #[inline(always)]
    fn join(&mut self, other: &T, make: &mut impl FnMut(T, T) -> T) {
        *self = make(*self, *other);
    }
    #[inline(always)]
    fn all(&self, other: &T, test: &mut impl FnMut(T, T) -> bool) -> bool {
        test(*self, *other)
    }
}

impl<T: Scalar> Retraction<T> for T {
    type Rate = T;
}

impl<T: Scalar> Position<T> for T {
    #[inline(always)]
    fn drift_0(&mut self, from: &T, rate: Term<'_, T, T>) {
        self.mix_1(from, rate);
    }
    #[inline(always)]
    fn drift_1(&mut self, from: &T, rate: Term<'_, T, T>, a: Term<'_, T, T>) {
        self.mix_2(from, rate, a);
    }
    #[inline(always)]
    fn drift_2(&mut self, from: &T, rate: Term<'_, T, T>, a: Term<'_, T, T>, b: Term<'_, T, T>) {
        self.mix_3(from, rate, a, b);
    }
    #[inline(always)]
    fn displace(&mut self, step: &T) {
        *self += *step;
    }
    #[inline(always)]
    fn apart(&self, from: &T, displacement: &mut T) {
        *displacement = *self - *from;
    }
    #[inline(always)]
    fn measure(&self, displacement: &T, note: &mut impl FnMut(T, T)) {
        note(*displacement, Scalar::abs(*self));
    }
    #[inline(always)]
    fn square_shares(&self, displacement: &T, squares: &mut T) {
        Rate::square_shares(squares, displacement, self);
    }
    #[inline(always)]
    fn visit(&self, visit: &mut impl FnMut(T)) {
        visit(*self);
    }
    #[inline(always)]
    fn replace(&mut self, make: &mut impl FnMut(T) -> T) {
        *self = make(*self);
    }
    #[inline(always)]
    fn all(&self, other: &T, test: &mut impl FnMut(T, T) -> bool) -> bool {
        test(*self, *other)
    }
}
