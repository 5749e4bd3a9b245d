//! A scene linearised about a position: what statics and modes share.

use super::inertial::Inertial;
use super::lists::{numbers, set, unit};
use super::{Dynamics, MotionOf, PositionOf, RateOf, Runs, StiffDynamics, System, coordinates};
use crate::dense::{Matrix, Tangent};
use crate::element::{Element, Implicit, Level, Loading, Reading, RealOf};
use crate::ends::{Root, Tip};
use crate::mirror::{Position, Rate};
use crate::observe::{each_body, each_joint, each_residual};
use crate::relation::Closures;
use crate::scalar::{Real, Scalar};
use alloc::vec;
use alloc::vec::Vec;
use num_traits::{One, Zero};

/// A scene near a position, in the directions that closures and couplings leave open. Linear maps are real; of dual numbers they hold the
/// real part.
pub(crate) struct Linear<R> {
    /// Directions that closures and couplings leave open.
    pub tangent: Tangent<R>,
    /// Root of the mass matrix: weighted velocities of bodies for unit rates, so that M = rootᵀ root.
    pub root: Matrix<R>,
    /// Accelerations for unit displacements, −M⁻¹ K at rest.
    pub response: Matrix<R>,
}

/// Central differences of eighth order: places (in steps) and weights.
const DIFFERENCES: [(f64, f64); 4] = [(1.0, 0.8), (2.0, -0.2), (3.0, 4.0 / 105.0), (4.0, -1.0 / 280.0)];

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
        loads.each_miss(&motion.position, &motion.rate, &mut |level, missed, _| {
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

    /// How accelerations change where a motion at rest is displaced along a direction: by all but springs, and by these. Where `narrow` displacements
    /// stay where loops are closed.
    pub(crate) fn changes<L: Loading<S>>(
        &self,
        still: &MotionOf<S, R, C, P>,
        direction: &RateOf<S, R, C>,
        narrow: bool,
        loads: &L,
        workspace: &mut <Self as StiffDynamics<L>>::StiffWorkspace,
    ) -> [Vec<S::Scalar>; 2]
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        let (step, none) = (step::<RealOf<S>>(), RealOf::<S>::zero());
        // Springs as in an explicit sweep, but apart from the rest: they may be so stiff that the error of a difference in
        // which the inertia changes too would drown all else.
        let springs = Implicit { position: none, rate: none };
        let (mut place, mut acceleration) = (still.position.clone(), still.rate.clone());
        let mut changes = [(); 2].map(|()| vec![S::Scalar::zero(); numbers(&still.rate).len()]);
        for (steps, weight) in DIFFERENCES {
            for sign in [1.0, -1.0] {
                let reach = step * RealOf::<S>::of(sign * steps);
                place.drift_0(&still.position, (reach, direction));
                place.set_clocks(still.time);
                if narrow {
                    self.lead_back(&mut place, still, loads);
                }
                let (here, there) = ((&still.position, &still.rate), (&place, &still.rate));
                let weight = RealOf::<S>::of(sign * weight) / step;
                for ((at, spring), change) in [(there, here), (here, there)].into_iter().zip(&mut changes) {
                    let found = &mut acceleration;
                    // No acceleration: the rates are zero.
                    let reading = Reading { position: spring.0, rate: spring.1, acceleration: &still.rate };
                    self.implicit_accelerations(still.time, at, spring, reading, springs, loads, workspace, found);
                    let mut sums = change.iter_mut();
                    acceleration.visit(&mut |x| {
                        if let Some(sum) = sums.next() {
                            *sum += x.scale(weight);
                        }
                    });
                }
            }
        }
        changes
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
        let mut direction = still.rate.clone();
        // Conditions that follow from others do so where all are met: there displacements have to stay, and go along the directions left open.
        let narrow = tangent.is_redundant();
        let count = if narrow { tangent.dimension() } else { freedoms };
        let mut responses = [(); 2].map(|()| Matrix::zeros(freedoms, count));
        let mut root = Matrix::zeros(0, freedoms);
        for j in 0..freedoms {
            set(&mut direction, unit(freedoms, j));
            let column = self.weighted(still, &direction);
            if j == 0 {
                root = Matrix::zeros(column.len(), freedoms);
            }
            root.set_column(j, &column);
        }
        for j in 0..count {
            let along: Vec<RealOf<S>> = unit(count, j).collect();
            let along = if narrow { tangent.vector(&along) } else { along };
            set(&mut direction, along.into_iter().map(S::Scalar::constant));
            let changes = self.changes(still, &direction, narrow, loads, workspace);
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
        Linear { root: tangent.restrict(&root), response: others.plus(RealOf::<S>::one(), &springs), tangent }
    }

    /// Closes loops at a place near that of a motion at rest; where that fails it stays, and what is found there is no number or far off.
    fn lead_back<L: Loading<S>>(&self, place: &mut PositionOf<S, R, C>, still: &MotionOf<S, R, C, P>, loads: &L)
    where
        Self: Runs<L, S, R, C, P>,
    {
        let mut near = still.clone();
        near.position.clone_from(place);
        if self.hold(&mut near, loads, &mut self.workspace()).is_ok() {
            core::mem::swap(&mut near.position, place);
        }
    }
}

/// The step of the differences, 2⁻¹⁰ of `f64` and 2⁻⁷ of `f32`: where (25 h)⁸, what they leave of a rope of a hundred links by their order, is
/// about what rounding leaves, ε / h. A power of two adds to an angle without rounding.
pub(crate) fn step<R: Real>() -> R {
    let mut step = R::one();
    while step.powf(R::of(9.0)) > R::EPSILON * R::of(6.6e-12) {
        step *= R::of(0.5);
    }
    step
}

/// What differences and rounding leave, at most: of a position of rest (rad, m), and of a stiffness as asymmetry, as a share of it. 1e-6 of `f64`,
/// 2e-3 of `f32`; they leave far less.
pub(crate) fn differenced<R: Real>() -> R {
    R::EPSILON.powf(R::of(0.383))
}
