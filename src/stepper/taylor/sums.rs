//! Sums of a Taylor series: positions and rates within a step.

use super::TaylorStepper;
use crate::mirror::{Position, Rate, Retraction};
use crate::scalar::Real;
use crate::stepper::{MotionIn, TimeIn};
use crate::system::SeriesDynamics;
use num_traits::One;

/// 1 / (k + 1), and that divided by k + 2: what a coefficient of an acceleration is of a rate, and of a position.
pub(super) const SHARES: [[f64; 2]; 32] = {
    let (mut shares, mut k) = ([[0.0; 2]; 32], 0);
    while k < 32 {
        let (next, second) = ((k + 1) as f64, (k + 2) as f64);
        shares[k] = [1.0 / next, 1.0 / (next * second)];
        k += 1;
    }
    shares
};

impl<D: SeriesDynamics<L, P>, L, const P: usize> TaylorStepper<D, L, P> {
    /// Positions and rates at a time (s) after the origin of the series, by Horner's rule, four coefficients at a time.
    pub(super) fn sum(&mut self, time: TimeIn<D, L>, to: &mut MotionIn<D, L>) {
        let Self { origin, accelerations, order, zero, sums: (position, rate, room), .. } = self;
        let (square, real) = (time * time, TimeIn::<D, L>::of);
        let powers = [TimeIn::<D, L>::one(), time, square, square * time];
        let fourth = square * square;
        position.set(zero);
        rate.set(zero);
        let (fours, few) = accelerations[..*order].as_chunks::<4>();
        let (shares, others) = SHARES.as_chunks::<4>().0.split_at(fours.len());
        for (i, (coefficients, [once, twice])) in few.iter().zip(others.iter().flatten()).enumerate() {
            let power = powers[i];
            room.mix_1(position, (power * real(*twice), coefficients));
            position.set(room);
            room.mix_1(rate, (power * real(*once), coefficients));
            rate.set(room);
        }
        for ([a, b, c, d], shares) in fours.iter().zip(shares).rev() {
            let of = |i: usize| powers[i] * real(shares[i][1]);
            room.mix_3(zero, (fourth, position), (of(3), d), (of(2), c));
            position.mix_2(room, (of(1), b), (of(0), a));
            let of = |i: usize| powers[i] * real(shares[i][0]);
            room.mix_3(zero, (fourth, rate), (of(3), d), (of(2), c));
            rate.mix_2(room, (of(1), b), (of(0), a));
        }
        to.position.drift_1(&origin.position, (time, &origin.rate), (square, position));
        to.rate.mix_1(&origin.rate, (time, rate));
        if D::Position::CURVED {
            to.position.retract_rate(&origin.position, &mut to.rate);
        }
    }
}
