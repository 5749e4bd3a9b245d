//! How far a Taylor series reaches: the order and the size of a step that keep a tolerance, and how far attitudes turn in it.

use super::TaylorStepper;
use super::sums::SHARES;
use crate::mirror::{Rate, Retraction};
use crate::scalar::{Elementary, Real, Scalar};
use crate::stepper::TimeIn;
use crate::stepper::roots::{exp2, log2};
use crate::system::SeriesDynamics;
use num_traits::{One, Zero};

/// How large coordinates of a step of an attitude may become under error control: they end at 2, half a turn, and lose digits before.
const TURNED: f64 = 1.7;

/// The order whose steps to a tolerance take the least time: measured for two rods on pins and for twenty, flat within three orders.
pub(super) fn order_for(tolerance: f64) -> usize {
    (3.5 - 0.48 * log2(tolerance.max(f64::MIN_POSITIVE))).max(8.0) as usize
}

impl<D: SeriesDynamics<L, P>, L, const P: usize> TaylorStepper<D, L, P> {
    /// Finds the largest of the coefficients of each order in the displacements of attitudes.
    pub(super) fn note_turns(&mut self) {
        let Self { origin, accelerations, turns, order, .. } = self;
        let largest = |rate: &D::Rate| {
            let mut largest = TimeIn::<D, L>::zero();
            origin.position.each_turn(rate, &mut |turn| {
                largest = largest.max(turn.iter().fold(TimeIn::<D, L>::zero(), |sum, x| sum + x.real() * x.real()));
            });
            largest.sqrt()
        };
        turns.0 = largest(&origin.rate);
        for (k, (turn, acceleration)) in turns.1[..*order].iter_mut().zip(&*accelerations).enumerate() {
            *turn = largest(acceleration) / TimeIn::<D, L>::of(((k + 1) * (k + 2)) as f64);
        }
    }

    /// How large coordinates of the step of an attitude are at most, from here to a time (s) after the origin of the series: the sum of
    /// the sizes of all terms.
    pub(super) fn turned(&self, time: TimeIn<D, L>) -> TimeIn<D, L> {
        let terms = self.turns.1[..self.order].iter().rev();
        let sum = terms.fold(TimeIn::<D, L>::zero(), |sum, turn| sum * time + *turn);
        (sum * time + self.turns.0) * time
    }

    /// A time (s) up to a size, at which they are at most this large.
    fn turned_less(&self, most: TimeIn<D, L>, size: TimeIn<D, L>) -> TimeIn<D, L> {
        let turned = self.turned(size);
        let too_far = turned > most;
        if !too_far {
            return size;
        }
        // They grow at least in proportion to the time.
        let (mut within, mut beyond) = (size * (most / turned), size);
        for _ in 0..5 {
            let middle = (within + beyond) * TimeIn::<D, L>::of(0.5);
            if self.turned(middle) > most { beyond = middle } else { within = middle }
        }
        within
    }

    /// How long a step may be (s): as far as the last term of the series is a tolerance, by the radius of convergence that two last terms
    /// tell. Where they tell a radius of more than twice that of the two before, all four are asked: a motion from rest may have only
    /// every fourth term.
    pub(super) fn reach(&mut self, tolerance: TimeIn<D, L>) -> TimeIn<D, L> {
        if let Some([known, size]) = self.reached
            && known == tolerance
        {
            return size;
        }
        // Four last coefficients of the rates, each by the size of its rate.
        let mut inverse = [0.0; 4];
        let Self { accelerations, origin, sums: (sizes, ..), order, .. } = self;
        sizes.set(&origin.rate);
        sizes.replace(&mut |rate| (rate.abs() + D::Scalar::one()).recip());
        for ((inverse, terms), [share, _]) in
            inverse.iter_mut().zip(&accelerations[*order - 4..*order]).zip(&SHARES[*order - 4..])
        {
            let mut most = TimeIn::<D, L>::zero();
            terms.all(sizes, &mut |term, size| {
                most = most.max((term * size).real().abs());
                true
            });
            *inverse = log2(most.as_f64() * share) * share;
        }
        let larger = |a: f64, b: f64| if a > b { a } else { b };
        let (before, newest) = (larger(inverse[0], inverse[1]), larger(inverse[2], inverse[3]));
        let inverse = if before > newest + 1.0 { before } else { newest };
        let mut size = TimeIn::<D, L>::of(exp2(log2(tolerance.as_f64()) * SHARES[self.order - 1][0] - inverse));
        if D::Position::CURVED {
            let finite = size.min(TimeIn::<D, L>::of(2.0) / self.turns.0); // a first term of two is beyond in any case
            size = self.turned_less(TimeIn::<D, L>::of(TURNED), finite);
        }
        self.reached = Some([tolerance, size]);
        size
    }
}
