//! Laws along coordinates whose forces have series.

use super::Order;
use crate::element::Springs;
use crate::lift::Lift;
use crate::relation::Coefficient;
use crate::scalar::{Powers, Scalar};
use crate::sealed::Sealed;
use crate::spring::SpringLaw;

/// A law that has a series of order `N`: one that is [analytic](SpringLaw::ANALYTIC), and can be written over power series.
#[diagnostic::on_unimplemented(
    message = "`Taylor` knows no series of the law `{Self}`",
    label = "a law without a series",
    note = "it knows laws that are written for any number, `impl<T: Scalar> SpringLaw<T> for Law<T>`, with `catena::lift!(Law<T> {{ .. }})`"
)]
pub trait ExpandLaw<T: Scalar, const N: usize>: SpringLaw<T> {
    /// Begins where a coordinate and its rate are.
    fn begin(&self, strain: &mut Strain<T, N>, position: T, rate: T);
    /// Goes on to the next order, after an acceleration of the coordinate.
    fn follow(&self, strain: &mut Strain<T, N>, order: &Order<T::Real>, acceleration: T);
}

/// What a law makes of a coordinate, order by order.
#[derive(Clone, Copy, Debug)]
pub struct Strain<T, const N: usize> {
    /// Coefficients of coordinate and rate of the present order.
    now: [T; 2],
    /// What the law makes of them.
    pub effort: T,
    /// Of a law that is not linear: where the coordinate sets out, and coefficients of its rate.
    place: T,
    rates: [T; N],
}

impl<T: Scalar, const N: usize> Strain<T, N> {
    /// None yet.
    pub fn none() -> Self {
        let zero = T::zero();
        Self { now: [zero; 2], effort: zero, place: zero, rates: [zero; N] }
    }

    /// Coordinate and rate up to a number.
    fn series(&self, number: usize) -> [Powers<T, N>; 2] {
        let rate = Powers::up_to(&self.rates[..N.min(number + 1)]);
        [Powers::integral(self.place, rate), rate]
    }
}

impl<T, L, const N: usize> ExpandLaw<T, N> for L
where
    T: Scalar,
    L: SpringLaw<T> + Lift<T, Powers<T, N>, Over: SpringLaw<Powers<T, N>>>,
{
    #[cfg_attr(optimised, inline(always))]
    fn begin(&self, strain: &mut Strain<T, N>, position: T, rate: T) {
        const {
            assert!(
                L::ANALYTIC,
                "a law with cases has no Taylor series: of others `SpringLaw::ANALYTIC` says that they are analytic"
            )
        }
        (strain.now, strain.effort) = ([position, rate], self.force(position, rate));
        if const { !L::LINEAR } {
            (strain.place, strain.rates[0]) = (position, rate);
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn follow(&self, strain: &mut Strain<T, N>, order: &Order<T::Real>, acceleration: T) {
        let [position, rate] = [strain.now[1].scale(order.once), acceleration.scale(order.once)];
        strain.now = [position, rate];
        if const { L::LINEAR } {
            strain.effort = -self.pivot(position, rate, Along([position, rate]));
            return;
        }
        let number = order.k + 1;
        if let Some(place) = strain.rates.get_mut(number) {
            *place = rate;
            let ([position, rate], law) = (strain.series(number), self.lift(&mut Powers::of));
            strain.effort = law.force(position, rate).terms()[number];
        }
    }
}

/// By how much less force there is after a step of coordinate and rate.
#[derive(Clone, Copy)]
struct Along<T>([T; 2]);

impl<T> Sealed for Along<T> {}

impl<T: Scalar> Springs<T> for Along<T> {
    const STIFF: bool = false;

    #[inline(always)]
    fn pivot(self, stiffness: impl Coefficient<T>, damping: impl Coefficient<T>) -> T {
        let Self([position, rate]) = self;
        damping.times_onto(rate, stiffness.times_onto(position, T::zero()))
    }
}
