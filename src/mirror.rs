//! Motions have the shape of their scene: a joint's coordinates where the scene has the joint, nothing where it has a body.
//!
//! A chain `(rod, Pin, rod)` moves with coordinates of type `((), T, ())`, an array of links with an array of them. Time
//! rules need only two things of such a value: linear combinations of rates ([`Rate::combine`]) and positions displaced
//! by them ([`Position::drift`]). In the plane positions are numbers like rates; a rotation in space displaces by its
//! exponential map instead, and nothing else changes.

use crate::scalar::{Real, Scalar};
use crate::tuples::for_each_tuple;

/// Rates or accelerations of all joint coordinates: a linear space.
pub trait Rate<T: Scalar>: Clone {
    /// `self = base + Σ weights[j] · terms[j]`.
    fn combine<const M: usize>(&mut self, base: &Self, weights: &[T::Real; M], terms: [&Self; M]);

    /// `self = self + Σ weights[j] · terms[j]`.
    fn accumulate<const M: usize>(&mut self, weights: &[T::Real; M], terms: [&Self; M]);

    /// `self = self + step`.
    fn add(&mut self, step: &Self);

    /// Calls `visit` with each coordinate, root to tip.
    fn visit(&self, visit: &mut impl FnMut(T));

    /// Replaces each coordinate, root to tip.
    fn replace(&mut self, make: &mut impl FnMut(T) -> T);

    /// Whether `test` holds for each pair of numbers at the same place, and there are as many (only a `Vec` can differ).
    fn all(&self, other: &Self, test: &mut impl FnMut(T, T) -> bool) -> bool;
}

/// Positions of all joint coordinates, with rates of type `Rate`.
pub trait Position<T: Scalar>: Clone {
    /// The rates of these coordinates.
    type Rate: Rate<T>;

    /// `self = from ⊕ (time · rate + Σ weights[j] · terms[j])`: displaced by a rate that lasts and by accelerations,
    /// whose weights (s²) a time rule knows.
    fn drift<const M: usize>(
        &mut self,
        from: &Self,
        time: T::Real,
        rate: &Self::Rate,
        weights: &[T::Real; M],
        terms: [&Self::Rate; M],
    );

    /// `self = self ⊕ step`.
    fn displace(&mut self, step: &Self::Rate);

    /// Calls `note` with each number of a displacement from here, root to tip, and the size by which to measure it relatively
    /// (that of the coordinate).
    fn measure(&self, displacement: &Self::Rate, note: &mut impl FnMut(T, T::Real));

    /// Calls `visit` with each number stored, root to tip.
    fn visit(&self, visit: &mut impl FnMut(T));

    /// Replaces each number stored, root to tip.
    fn replace(&mut self, make: &mut impl FnMut(T) -> T);

    /// Whether `test` holds for each pair of numbers at the same place, and there are as many (only a `Vec` can differ).
    fn all(&self, other: &Self, test: &mut impl FnMut(T, T) -> bool) -> bool;
}

impl<T: Scalar> Rate<T> for T {
    #[inline(always)]
    fn combine<const M: usize>(&mut self, base: &Self, weights: &[T::Real; M], terms: [&Self; M]) {
        let mut sum = *base;
        for (weight, term) in weights.iter().zip(terms) {
            sum = sum.add_scaled(*weight, *term);
        }
        *self = sum;
    }
    #[inline(always)]
    fn accumulate<const M: usize>(&mut self, weights: &[T::Real; M], terms: [&Self; M]) {
        let base = *self;
        self.combine(&base, weights, terms);
    }
    #[inline(always)]
    fn add(&mut self, step: &Self) {
        *self += *step;
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
    fn all(&self, other: &Self, test: &mut impl FnMut(T, T) -> bool) -> bool {
        test(*self, *other)
    }
}

impl<T: Scalar> Position<T> for T {
    type Rate = T;

    #[inline(always)]
    fn drift<const M: usize>(&mut self, from: &Self, time: T::Real, rate: &T, weights: &[T::Real; M], terms: [&T; M]) {
        self.combine(&from.add_scaled(time, *rate), weights, terms);
    }
    #[inline(always)]
    fn measure(&self, displacement: &T, note: &mut impl FnMut(T, T::Real)) {
        note(*displacement, self.real().abs());
    }
    #[inline(always)]
    fn displace(&mut self, step: &Self) {
        *self += *step;
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
    fn all(&self, other: &Self, test: &mut impl FnMut(T, T) -> bool) -> bool {
        test(*self, *other)
    }
}

/// What arrays and vectors share: a mirror of equal items. Mirrors of different lengths are left as they are; motions are
/// compared with their scene before they come here.
mod items {
    use super::{Position, Rate, Scalar};

    #[inline(always)]
    fn nth<'a, X, const M: usize>(terms: &[&'a [X]; M], i: usize) -> [&'a X; M] {
        core::array::from_fn(|j| &terms[j][i])
    }

    #[inline(always)]
    pub fn combine<T: Scalar, A: Rate<T>, const M: usize>(
        items: &mut [A],
        base: &[A],
        weights: &[T::Real; M],
        terms: [&[A]; M],
    ) {
        let n = items.len();
        if base.len() != n || terms.iter().any(|term| term.len() != n) {
            return;
        }
        for i in 0..n {
            items[i].combine(&base[i], weights, nth(&terms, i));
        }
    }

    #[inline(always)]
    pub fn accumulate<T: Scalar, A: Rate<T>, const M: usize>(
        items: &mut [A],
        weights: &[T::Real; M],
        terms: [&[A]; M],
    ) {
        let n = items.len();
        if terms.iter().any(|term| term.len() != n) {
            return;
        }
        for (i, item) in items.iter_mut().enumerate() {
            item.accumulate(weights, nth(&terms, i));
        }
    }

    #[inline(always)]
    pub fn drift<T: Scalar, A: Position<T>, const M: usize>(
        items: &mut [A],
        from: &[A],
        time: T::Real,
        rate: &[A::Rate],
        weights: &[T::Real; M],
        terms: [&[A::Rate]; M],
    ) {
        let n = items.len();
        if from.len() != n || rate.len() != n || terms.iter().any(|term| term.len() != n) {
            return;
        }
        for i in 0..n {
            items[i].drift(&from[i], time, &rate[i], weights, nth(&terms, i));
        }
    }
}

/// One implementation for everything that derefs to a slice of mirrors.
macro_rules! mirror_items {
    ([$($generics:tt)*] $container:ty, $rates:ty) => {
        impl<T: Scalar, A: Rate<T>, $($generics)*> Rate<T> for $container {
            #[inline]
            fn combine<const M: usize>(&mut self, base: &Self, weights: &[T::Real; M], terms: [&Self; M]) {
                items::combine(self, base, weights, terms.map(|term| &term[..]));
            }
            #[inline]
            fn accumulate<const M: usize>(&mut self, weights: &[T::Real; M], terms: [&Self; M]) {
                items::accumulate(self, weights, terms.map(|term| &term[..]));
            }
            #[inline]
            fn add(&mut self, step: &Self) {
                self.iter_mut().zip(step).for_each(|(item, step)| item.add(step));
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
        }

        impl<T: Scalar, A: Position<T>, $($generics)*> Position<T> for $container {
            type Rate = $rates;

            #[inline]
            fn drift<const M: usize>(
                &mut self,
                from: &Self,
                time: T::Real,
                rate: &Self::Rate,
                weights: &[T::Real; M],
                terms: [&Self::Rate; M],
            ) {
                items::drift(self, from, time, rate, weights, terms.map(|term| &term[..]));
            }
            #[inline]
            fn measure(&self, displacement: &Self::Rate, note: &mut impl FnMut(T, T::Real)) {
                self.iter().zip(displacement).for_each(|(item, displacement)| item.measure(displacement, note));
            }
            #[inline]
            fn displace(&mut self, step: &Self::Rate) {
                self.iter_mut().zip(step).for_each(|(item, step)| item.displace(step));
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
        }
    };
}

mirror_items!([const K: usize] [A; K], [A::Rate; K]);
#[cfg(feature = "alloc")]
mirror_items!([] alloc::vec::Vec<A>, alloc::vec::Vec<A::Rate>);

/// Tuples of mirrors, for the arities that chains have.
macro_rules! mirror_tuple {
    ($($met:ident)?; $($A:ident $i:tt $out:ident $in:ident),*; $($rest:tt)*) => {
        impl<T: Scalar, $($A: Rate<T>),*> Rate<T> for ($($A,)*) {
            #[inline(always)]
            fn combine<const M: usize>(&mut self, _base: &Self, _weights: &[T::Real; M], _terms: [&Self; M]) {
                $(self.$i.combine(&_base.$i, _weights, _terms.map(|term| &term.$i));)*
            }
            #[inline(always)]
            fn accumulate<const M: usize>(&mut self, _weights: &[T::Real; M], _terms: [&Self; M]) {
                $(self.$i.accumulate(_weights, _terms.map(|term| &term.$i));)*
            }
            #[inline(always)]
            fn add(&mut self, _step: &Self) {
                $(self.$i.add(&_step.$i);)*
            }
            #[inline(always)]
            fn visit(&self, _visit: &mut impl FnMut(T)) {
                $(self.$i.visit(_visit);)*
            }
            #[inline(always)]
            fn replace(&mut self, _make: &mut impl FnMut(T) -> T) {
                $(self.$i.replace(_make);)*
            }
            #[inline(always)]
            fn all(&self, _other: &Self, _test: &mut impl FnMut(T, T) -> bool) -> bool {
                true $(&& self.$i.all(&_other.$i, _test))*
            }
        }

        impl<T: Scalar, $($A: Position<T>),*> Position<T> for ($($A,)*) {
            type Rate = ($($A::Rate,)*);

            #[inline(always)]
            fn drift<const M: usize>(
                &mut self,
                _from: &Self,
                _time: T::Real,
                _rate: &Self::Rate,
                _weights: &[T::Real; M],
                _terms: [&Self::Rate; M],
            ) {
                $(self.$i.drift(&_from.$i, _time, &_rate.$i, _weights, _terms.map(|term| &term.$i));)*
            }
            #[inline(always)]
            fn measure(&self, _displacement: &Self::Rate, _note: &mut impl FnMut(T, T::Real)) {
                $(self.$i.measure(&_displacement.$i, _note);)*
            }
            #[inline(always)]
            fn displace(&mut self, _step: &Self::Rate) {
                $(self.$i.displace(&_step.$i);)*
            }
            #[inline(always)]
            fn visit(&self, _visit: &mut impl FnMut(T)) {
                $(self.$i.visit(_visit);)*
            }
            #[inline(always)]
            fn replace(&mut self, _make: &mut impl FnMut(T) -> T) {
                $(self.$i.replace(_make);)*
            }
            #[inline(always)]
            fn all(&self, _other: &Self, _test: &mut impl FnMut(T, T) -> bool) -> bool {
                true $(&& self.$i.all(&_other.$i, _test))*
            }
        }
    };
}

mirror_tuple!(; ;);
for_each_tuple!(mirror_tuple);
