//! Derivatives of squared frequencies: ω² = −(φᵀ M a′) / (φᵀ M φ), with a′ the change of accelerations along a shape φ.

use crate::dense::dependent;
use crate::element::{Element, Level, Loading, RealOf};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mirror::Rate;
use crate::scalar::{Real, Scalar};
use crate::system::{Inertial, Keeps, MotionOf, RateOf, Runs, StiffDynamics, System, Way, numbers, set};
use nalgebra::{DMatrix, SVD};
use num_traits::{One, Zero};
use std::vec::Vec;

impl<S: Inertial, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Squares of frequencies with the first derivatives of a scene's numbers, by their shapes, which need none: the quotient is stationary there, as
    /// long as shapes stay within what is held and closed.
    pub(super) fn squares<L: Loading<S>>(
        &self,
        still: &MotionOf<S, R, C, P>,
        shapes: &[&[f64]],
        narrow: bool,
        loads: &L,
    ) -> Result<Vec<S::Scalar>, Error>
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        let constant = |x: &f64| S::Scalar::constant(Real::of(*x));
        let (mut workspace, root) = (self.stiff_workspace(), self.mass_root(still));
        let rows = self.rate_conditions(still, loads);
        // Rates that undo what is missed, the smallest.
        let back = if rows.is_empty() {
            DMatrix::zeros(0, 0)
        } else {
            let list: Vec<f64> = rows.iter().flatten().map(|x| x.as_f64()).collect();
            let held = DMatrix::from_row_slice(rows.len(), list.len() / rows.len(), &list);
            let least = dependent::<RealOf<S>>().as_f64() * held.norm();
            let rounds = 1000 * held.nrows().max(held.ncols());
            let parts = SVD::try_new(held, true, true, f64::EPSILON, rounds);
            parts.and_then(|parts| parts.pseudo_inverse(least).ok()).ok_or(Error::new(Fault::NonFiniteMotion))?
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
            let keeps = if narrow { Keeps::Place } else { Keeps::Nothing };
            let way = Way { level: Level::Place, direction: &moving.rate, keeps, root: &root };
            let [mut change, springs] = self.changes(still, &[way], loads, &mut workspace).0.pop().unwrap_or_default();
            change.iter_mut().zip(springs).for_each(|(sum, more)| *sum += more);
            // As large as the shape, for what pairs them loses what one exceeds the other by.
            let largest =
                |list: &[S::Scalar]| list.iter().fold(RealOf::<S>::zero(), |most, x| most.max(x.real().abs()));
            let size = largest(&change) / largest(&numbers(&moving.rate));
            let size = if size > RealOf::<S>::zero() { size } else { RealOf::<S>::one() };
            let mut pulled = moving.rate.clone();
            set(&mut pulled, change.into_iter().map(|x| x.scale(size.recip())));
            let [along, of_rate] = [&pulled, &moving.rate].map(|other| self.paired(still, &moving.rate, other));
            -along.scale(size) * of_rate.recip()
        };
        Ok(shapes.iter().map(of_shape).collect())
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
