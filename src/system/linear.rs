//! A scene linearised about a position: what statics and modes share.

use super::differences::{Keeps, Way};
use super::inertial::Inertial;
use super::lists::{numbers, set, unit};
use super::{MotionOf, RateOf, Runs, StiffDynamics, System, coordinates};
use crate::dense::{Matrix, Tangent};
use crate::element::{Element, Level, Loading, RealOf};
use crate::ends::{Root, Tip};
use crate::observe::{each_body, each_joint, each_residual};
use crate::relation::Closures;
use crate::scalar::Scalar;
use alloc::vec;
use alloc::vec::Vec;
use num_traits::One;

/// A scene near a position, in the directions that closures and couplings leave open. Linear maps are real; of dual numbers they hold the
/// real part.
pub(crate) struct Linear<R> {
    /// Directions that closures and couplings leave open.
    pub tangent: Tangent<R>,
    /// Root of the mass matrix: weighted velocities of bodies for unit rates, so that M = rootᵀ root.
    pub root: Matrix<R>,
    /// Accelerations for unit displacements, −M⁻¹ K at rest.
    pub response: Matrix<R>,
    /// By which share of them differences disagree: much, of a force that has a kink there.
    #[cfg_attr(not(feature = "std"), expect(dead_code))] // modes ask for it
    pub kink: R,
}

impl<S: Inertial, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Weighted velocities of all bodies, and of coordinates with reflected inertia, where the coordinates of a motion at rest move at a rate.
    pub(crate) fn weighted(&self, still: &MotionOf<S, R, C, P>, rate: &RateOf<S, R, C>) -> Vec<RealOf<S>> {
        let mut all = vec![];
        let moving = super::Coordinates { rate, ..coordinates(still) };
        each_body(self.elements(), self.ground(still.time), moving, |body| S::weighted(body, &mut |x| all.push(x)));
        let mut all = all.into_iter();
        let mut relative = vec![];
        // The ground may move: its part is not the work of the coordinates.
        each_body(self.elements(), self.ground(still.time), coordinates(still), |body| {
            S::weighted(body, &mut |x| relative.extend(all.next().map(|with| with - x)));
        });
        relative.append(&mut self.reflected(still, rate));
        relative
    }

    /// Rates of joint coordinates times the roots of their reflected inertias, √I q̇.
    pub(super) fn reflected(&self, still: &MotionOf<S, R, C, P>, rate: &RateOf<S, R, C>) -> Vec<RealOf<S>> {
        let mut all = vec![];
        let moving = super::Coordinates { rate, ..coordinates(still) };
        each_joint(self.elements(), self.ground(still.time), moving, |joint| {
            S::reflected(joint, &mut |x| all.push(x));
        });
        all
    }

    /// A root of the mass matrix at a motion at rest: weighted velocities of bodies for unit rates.
    pub(crate) fn mass_root(&self, still: &MotionOf<S, R, C, P>) -> Matrix<RealOf<S>> {
        let (mut direction, freedoms) = (still.rate.clone(), numbers(&still.rate).len());
        let mut root = Matrix::zeros(0, freedoms);
        for j in 0..freedoms {
            set(&mut direction, unit(freedoms, j));
            let column = self.weighted(still, &direction);
            if j == 0 {
                root = Matrix::zeros(column.len(), freedoms);
            }
            root.set_column(j, &column);
        }
        root
    }

    /// Residuals of velocity of all that is held: the tip, and ends of loops.
    pub(crate) fn drift(&self, motion: &MotionOf<S, R, C, P>) -> Vec<S::Scalar> {
        let mut drift = vec![];
        P::Closures::map(&self.residual(motion)[1], |x| drift.push(x));
        each_residual(self.elements(), self.ground(motion.time), coordinates(motion), |[_, x]| drift.push(x));
        drift
    }

    /// By how much rates miss what closures and couplings allow.
    pub(crate) fn missed<L: Loading<S>>(&self, motion: &MotionOf<S, R, C, P>, loads: &L) -> Vec<S::Scalar> {
        let mut all = self.drift(motion);
        loads.each_miss(&motion.position, &motion.rate, &mut |level, _, [missed, _]| {
            if let Level::Velocity = level {
                all.push(missed);
            }
        });
        all
    }

    /// What each rate by itself misses, in a row for each condition.
    pub(crate) fn rate_conditions<L: Loading<S>>(
        &self,
        still: &MotionOf<S, R, C, P>,
        loads: &L,
    ) -> Vec<Vec<RealOf<S>>> {
        let (drift, freedoms) = (self.missed(still, loads), numbers(&still.rate).len());
        let mut rows: Vec<Vec<RealOf<S>>> = vec![vec![]; drift.len()];
        let mut moving = still.clone();
        for j in 0..if rows.is_empty() { 0 } else { freedoms } {
            set(&mut moving.rate, unit(freedoms, j));
            for (row, (with, without)) in rows.iter_mut().zip(self.missed(&moving, loads).into_iter().zip(&drift)) {
                row.push(with.real() - without.real());
            }
        }
        rows
    }

    /// The scene linearised about a motion at rest (whose rates are zero) with its tip where it is held.
    pub(crate) fn linearise<L: Loading<S>>(
        &self,
        still: &MotionOf<S, R, C, P>,
        loads: &L,
        workspace: &mut <Self as StiffDynamics<L>>::StiffWorkspace,
    ) -> Linear<RealOf<S>>
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        let freedoms = numbers(&still.rate).len();
        let tangent = Tangent::of(freedoms, self.rate_conditions(still, loads));
        // Conditions that follow from others do so where all are met: there displacements have to stay, and go along the directions left open.
        let narrow = tangent.is_redundant();
        let count = if narrow { tangent.dimension() } else { freedoms };
        let mut responses = [(); 2].map(|()| Matrix::zeros(freedoms, count));
        let root = self.mass_root(still);
        let lead = |j| {
            let along: Vec<RealOf<S>> = unit(count, j).collect();
            let along = if narrow { tangent.vector(&along) } else { along };
            let mut direction = still.rate.clone();
            set(&mut direction, along.into_iter().map(S::Scalar::constant));
            direction
        };
        let keeps = if narrow { Keeps::Place } else { Keeps::Nothing };
        let directions: Vec<_> = (0..count).map(lead).collect();
        let way = |direction| Way { level: Level::Place, direction, keeps, root: &root };
        let ways: Vec<_> = directions.iter().map(way).collect();
        let (changes, kink) = self.changes(still, &ways, loads, workspace);
        for (j, changes) in changes.into_iter().enumerate() {
            for (response, change) in responses.iter_mut().zip(changes) {
                let change: Vec<_> = change.into_iter().map(|x| x.real()).collect();
                response.set_column(j, &change);
            }
        }
        let reduced = |response: Matrix<_>| match narrow {
            true => tangent.restrict(&response.transposed()).transposed(),
            false => tangent.reduce(&response),
        };
        let [others, springs] = responses.map(reduced);
        Linear { root: tangent.restrict(&root), response: others.plus(RealOf::<S>::one(), &springs), tangent, kink }
    }
}
