//! Derivatives of squared frequencies: ω² = −(φᵀ M a′) / (φᵀ M φ), with a′ the change of accelerations along a shape φ.

use crate::element::{Element, Loading};
use crate::ends::{Root, Tip};
use crate::mirror::Rate;
use crate::scalar::{Real, Scalar};
use crate::system::{Inertial, MotionOf, RateOf, Runs, StiffDynamics, System, set};
use nalgebra::DMatrix;
use std::vec::Vec;

/// Singular values below this share of the largest are those of conditions that follow from others.
const DEPENDENT: f64 = 1e-9;

impl<S: Inertial, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Squares of frequencies with the first derivatives of a scene's numbers, by their shapes, which need none: the quotient is stationary there, as
    /// long as shapes stay within what is held and closed.
    pub(super) fn squares<L: Loading<S>>(
        &self,
        still: &MotionOf<S, R, C, P>,
        shapes: &[&[f64]],
        narrow: bool,
        loads: &L,
    ) -> Vec<S::Scalar>
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        let constant = |x: &f64| S::Scalar::constant(Real::of(*x));
        let mut workspace = self.stiff_workspace();
        let rows = self.rate_conditions(still, loads);
        // Rates that undo what is missed, the smallest.
        let back = if rows.is_empty() {
            DMatrix::zeros(0, 0)
        } else {
            let list: Vec<f64> = rows.iter().flatten().map(|x| x.as_f64()).collect();
            let held = DMatrix::from_row_slice(rows.len(), list.len() / rows.len(), &list);
            let least = DEPENDENT * held.amax();
            held.pseudo_inverse(least).unwrap_or_default()
        };
        let missed = self.missed(still, loads);
        let of_shape = |shape: &&[f64]| {
            let mut moving = still.clone();
            set(&mut moving.rate, shape.iter().map(constant));
            // Where what is held changes with the numbers, a shape that is allowed does.
            let astray = self.missed(&moving, loads).into_iter().zip(&missed).map(|(with, without)| with - *without);
            let derivatives: Vec<S::Scalar> =
                astray.map(|missed| missed - S::Scalar::constant(missed.real())).collect();
            let mut undo = back.row_iter();
            moving.rate.replace(&mut |x| {
                let shares = undo.next();
                let shares = shares.iter().flat_map(|row| row.iter());
                derivatives.iter().zip(shares).fold(x, |sum, (missed, share)| sum - *missed * constant(share))
            });
            let [mut change, springs] = self.changes(still, &moving.rate, narrow, loads, &mut workspace);
            change.iter_mut().zip(springs).for_each(|(sum, more)| *sum += more);
            let mut pulled = moving.rate.clone();
            set(&mut pulled, change);
            let [along, of_rate] = [&pulled, &moving.rate].map(|other| self.paired(still, &moving.rate, other));
            -along * of_rate.recip()
        };
        shapes.iter().map(of_shape).collect()
    }

    /// vᵀ M w, by the kinetic energies of v, w and their sum, without what the ground has of them.
    fn paired(&self, still: &MotionOf<S, R, C, P>, v: &RateOf<S, R, C>, w: &RateOf<S, R, C>) -> S::Scalar {
        let energy = |rate: &RateOf<S, R, C>| {
            let mut moving = still.clone();
            moving.rate.set(rate);
            self.budget_of(&moving).kinetic
        };
        let mut sum = v.clone();
        sum.add(w);
        energy(&sum) - energy(v) - energy(w) + energy(&still.rate)
    }
}
