//! Arrays and vectors of mirrors. Mirrors of different lengths change as far as all of them go; motions are compared with
//! their scene before they come here.

use super::{Mode, Position, Rate, Retraction, Term, Told};
use crate::scalar::Scalar;

/// One implementation for everything that derefs to a slice of mirrors.
macro_rules! mirror_items {
    ([$($generics:tt)*] $container:ty, $rates:ty, $length:expr) => {
        impl<T: Scalar, A: Rate<T>, $($generics)*> Rate<T> for $container {
            const LENGTH: usize = $length;
            const FIELDS: usize = A::FIELDS;

            #[inline]
            fn set(&mut self, base: &Self) {
                self.iter_mut().zip(base).for_each(|(item, base)| item.set(base));
            }
            #[inline]
            fn mix_1(&mut self, base: &Self, (u, a): Term<'_, T, Self>) {
                for ((item, base), a) in self.iter_mut().zip(base).zip(a) {
                    item.mix_1(base, (u, a));
                }
            }
            #[inline]
            fn mix_2(&mut self, base: &Self, (u, a): Term<'_, T, Self>, (v, b): Term<'_, T, Self>) {
                for (((item, base), a), b) in self.iter_mut().zip(base).zip(a).zip(b) {
                    item.mix_2(base, (u, a), (v, b));
                }
            }
            #[inline]
            fn mix_3(
                &mut self,
                base: &Self,
                (u, a): Term<'_, T, Self>,
                (v, b): Term<'_, T, Self>,
                (w, c): Term<'_, T, Self>,
            ) {
                for ((((item, base), a), b), c) in self.iter_mut().zip(base).zip(a).zip(b).zip(c) {
                    item.mix_3(base, (u, a), (v, b), (w, c));
                }
            }
            #[inline]
            fn add_4(
                &mut self,
                (u, a): Term<'_, T, Self>,
                (v, b): Term<'_, T, Self>,
                (w, c): Term<'_, T, Self>,
                (x, d): Term<'_, T, Self>,
            ) {
                for ((((item, a), b), c), d) in self.iter_mut().zip(a).zip(b).zip(c).zip(d) {
                    item.add_4((u, a), (v, b), (w, c), (x, d));
                }
            }
            #[inline]
            fn add(&mut self, step: &Self) {
                self.iter_mut().zip(step).for_each(|(item, step)| item.add(step));
            }
            #[inline]
            fn scale_onto(&mut self, u: T::Real, base: &Self) {
                self.iter_mut().zip(base).for_each(|(item, base)| item.scale_onto(u, base));
            }
            #[inline]
            fn square_shares(&mut self, of: &Self, size: &Self) {
                self.iter_mut().zip(of).zip(size).for_each(|((item, of), size)| item.square_shares(of, size));
            }
            #[cfg_attr(optimised, inline(always))]
            fn visit(&self, visit: &mut impl FnMut(T)) {
                self.iter().for_each(|item| item.visit(visit));
            }
            #[inline]
            fn replace(&mut self, make: &mut impl FnMut(T) -> T) {
                self.iter_mut().for_each(|item| item.replace(make));
            }
            #[inline]
            fn join(&mut self, other: &Self, make: &mut impl FnMut(T, T) -> T) {
                self.iter_mut().zip(other).for_each(|(item, other)| item.join(other, make));
            }
            #[inline]
            fn all(&self, other: &Self, test: &mut impl FnMut(T, T) -> bool) -> bool {
                self.len() == other.len() && self.iter().zip(other).all(|(item, other)| item.all(other, test))
            }
        }

        impl<T: Scalar, A: Retraction<T>, $($generics)*> Retraction<T> for $container {
            type Rate = $rates;

            const CURVED: bool = A::CURVED;

            #[inline]
            fn each_turn(&self, rate: &Self::Rate, visit: &mut impl FnMut([T; 3])) {
                self.iter().zip(rate).for_each(|(item, rate)| item.each_turn(rate, visit));
            }
            #[inline]
            fn retract_rate(&self, from: &Self, rate: &mut Self::Rate) {
                self.iter().zip(from).zip(rate).for_each(|((item, from), rate)| item.retract_rate(from, rate));
            }
            #[inline]
            fn inverse_retract_acceleration(&self, from: &Self, rate: &Self::Rate, acceleration: &mut Self::Rate) {
                let items = self.iter().zip(from).zip(rate).zip(acceleration);
                items.for_each(|(((item, from), rate), acceleration)| item.inverse_retract_acceleration(from, rate, acceleration));
            }
            #[inline]
            fn transposed_acceleration(&self, from: &Self, costate: &mut Self::Rate) {
                let items = self.iter().zip(from).zip(costate);
                items.for_each(|((item, from), costate)| item.transposed_acceleration(from, costate));
            }
            #[inline]
            fn transposed_step(
                &self,
                from: &Self,
                (rate, acceleration): (&Self::Rate, &Self::Rate),
                of_second: &Self::Rate,
                (of_position, of_rate): (&mut Self::Rate, &mut Self::Rate),
                of_from: &mut Self::Rate,
            ) {
                let here = self.iter().zip(from).zip(rate.iter().zip(acceleration));
                let of_here = of_second.iter().zip(of_position).zip(of_rate.iter_mut().zip(of_from));
                for (((item, from), here), ((of_second, of_position), (of_rate, of_from))) in here.zip(of_here) {
                    item.transposed_step(from, here, of_second, (of_position, of_rate), of_from);
                }
            }
            #[inline]
            fn transposed_second(
                &self,
                from: &Self,
                (rate, acceleration): (&Self::Rate, &Self::Rate),
                of_second: &Self::Rate,
                (of_position, of_rate): (&mut Self::Rate, &mut Self::Rate),
                of_from: &mut Self::Rate,
            ) {
                let here = self.iter().zip(from).zip(rate.iter().zip(acceleration));
                let of_here = of_second.iter().zip(of_position).zip(of_rate.iter_mut().zip(of_from));
                for (((item, from), here), ((of_second, of_position), (of_rate, of_from))) in here.zip(of_here) {
                    item.transposed_second(from, here, of_second, (of_position, of_rate), of_from);
                }
            }
        }

        impl<T: Scalar, A: Position<T>, $($generics)*> Position<T> for $container {
            const CLOCKED: bool = A::CLOCKED;
            const MODES: bool = A::MODES;

            #[inline]
            fn drift_0(&mut self, from: &Self, (time, rate): Term<'_, T, Self::Rate>) {
                for ((item, from), rate) in self.iter_mut().zip(from).zip(rate) {
                    item.drift_0(from, (time, rate));
                }
            }
            #[inline]
            fn drift_1(&mut self, from: &Self, (time, rate): Term<'_, T, Self::Rate>, (u, a): Term<'_, T, Self::Rate>) {
                for (((item, from), rate), a) in self.iter_mut().zip(from).zip(rate).zip(a) {
                    item.drift_1(from, (time, rate), (u, a));
                }
            }
            #[inline]
            fn drift_2(
                &mut self,
                from: &Self,
                (time, rate): Term<'_, T, Self::Rate>,
                (u, a): Term<'_, T, Self::Rate>,
                (v, b): Term<'_, T, Self::Rate>,
            ) {
                for ((((item, from), rate), a), b) in self.iter_mut().zip(from).zip(rate).zip(a).zip(b) {
                    item.drift_2(from, (time, rate), (u, a), (v, b));
                }
            }
            #[inline]
            fn displace(&mut self, step: &Self::Rate) {
                self.iter_mut().zip(step).for_each(|(item, step)| item.displace(step));
            }
            #[inline]
            fn apart(&self, from: &Self, displacement: &mut Self::Rate) {
                let items = self.iter().zip(from).zip(displacement);
                items.for_each(|((item, from), displacement)| item.apart(from, displacement));
            }
            #[inline]
            fn measure(&self, displacement: &Self::Rate, note: &mut impl FnMut(T, T)) {
                self.iter().zip(displacement).for_each(|(item, displacement)| item.measure(displacement, note));
            }
            #[inline]
            fn square_shares(&self, displacement: &Self::Rate, squares: &mut Self::Rate) {
                for ((item, displacement), square) in self.iter().zip(displacement).zip(squares) {
                    item.square_shares(displacement, square);
                }
            }
            #[inline]
            fn visit(&self, visit: &mut impl FnMut(T)) {
                self.iter().for_each(|item| item.visit(visit));
            }
            #[inline]
            fn replace(&mut self, make: &mut impl FnMut(T) -> T) {
                self.iter_mut().for_each(|item| item.replace(make));
            }
            #[inline]
            fn all(&self, other: &Self, test: &mut impl FnMut(T, T) -> bool) -> bool {
                self.len() == other.len() && self.iter().zip(other).all(|(item, other)| item.all(other, test))
            }
            #[inline]
            fn normalise(&mut self) -> bool {
                self.iter_mut().fold(true, |good, item| item.normalise() && good)
            }
            fn each_mode(
                &mut self,
                rate: &mut Self::Rate,
                acceleration: &Self::Rate,
                visit: &mut impl FnMut(&mut Mode, &mut T, Told<T>),
            ) {
                for ((item, rate), acceleration) in self.iter_mut().zip(rate).zip(acceleration) {
                    item.each_mode(rate, acceleration, visit);
                }
            }
            #[inline]
            fn set_clocks(&mut self, time: T::Real) {
                self.iter_mut().for_each(|item| item.set_clocks(time));
            }
            fn stop_clocks(&mut self) {
                self.iter_mut().for_each(Position::stop_clocks);
            }
        }
    };
}

mirror_items!([const K: usize] [A; K], [A::Rate; K], A::LENGTH.saturating_mul(K));
#[cfg(feature = "alloc")]
mirror_items!([] alloc::vec::Vec<A>, alloc::vec::Vec<A::Rate>, usize::MAX);
