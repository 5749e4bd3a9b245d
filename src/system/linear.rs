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
    /// By which share of them differences disagree: much, of a force that has a kink there.
    pub kink: R,
}

/// Central differences of eighth order, and of fourth: places (in steps) and weights.
const DIFFERENCES: [(f64, f64, f64); 4] =
    [(1.0, 0.8, 2.0 / 3.0), (2.0, -0.2, -1.0 / 12.0), (3.0, 4.0 / 105.0, 0.0), (4.0, -1.0 / 280.0, 0.0)];
/// How accelerations (m/s², rad/s²) change along a direction.
pub(crate) struct Change<T: Scalar> {
    /// By all but springs, and by these.
    pub by: [Vec<T>; 2],
    /// The largest of both.
    pub size: T::Real,
    /// By how much differences of fourth order are others.
    astray: T::Real,
    /// By how much more they change ahead than behind.
    bent: T::Real,
}

/// By so much smaller steps are beside a kink, down to this power of a rounding.
const SMALLER: f64 = 0.0625;
const LEAST: f64 = 0.55;
/// A force that changes by another such share ahead than behind, however near, has a kink.
const BENT: f64 = 0.2;
/// So many roundings are left of accelerations as large as those of unit displacements, or as gravity.
const ROUNDINGS: f64 = 16.0;
/// What gravity makes, about (m/s²).
pub(crate) const GRAVITY: f64 = 10.0;

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

    /// What differences that disagree, or bend, are where steps are ever smaller; and by which share of the largest they still do, beyond rounding of what is
    /// as large as the `largest` change by any direction: as a force that has a kink right there does.
    ///
    /// Differences disagree that reach beyond a kink, of a rope that is hardly taut say. They bend if they are others ahead than behind.
    #[allow(clippy::type_complexity)] // two in one argument
    pub(crate) fn beside_kinks<L: Loading<S>>(
        &self,
        (still, direction): (&MotionOf<S, R, C, P>, &RateOf<S, R, C>),
        narrow: bool,
        largest: RealOf<S>,
        first: Change<S::Scalar>,
        loads: &L,
        workspace: &mut <Self as StiffDynamics<L>>::StiffWorkspace,
    ) -> ([Vec<S::Scalar>; 2], RealOf<S>)
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        let [agree, bent, smaller, two] =
            [differenced(), RealOf::<S>::of(BENT), RealOf::<S>::of(SMALLER), RealOf::<S>::of(2.0)];
        let rounding = RealOf::<S>::EPSILON * RealOf::<S>::of(ROUNDINGS) * (largest + RealOf::<S>::of(GRAVITY));
        let shares = |change: &Change<S::Scalar>, step: RealOf<S>| {
            [(change.astray, agree), (change.bent, bent)]
                .map(|(x, limit)| x / change.size.max(rounding / (step * limit)))
        };
        let (mut step, least) = (step::<RealOf<S>>(), RealOf::<S>::EPSILON.powf(RealOf::<S>::of(LEAST)));
        let [mut disagree, mut bends] = shares(&first, step);
        let (mut best, mut before) = (first.by, first.bent);
        while (disagree > agree || bends > bent) && step > least {
            step *= smaller;
            let found = self.change(still, direction, (narrow, step), loads, workspace);
            let [other, still_bends] = shares(&found, step);
            // Where a force is smooth they bend in proportion to steps.
            if disagree <= agree && found.bent < before * smaller * two && found.bent * two > before * smaller {
                return (best, disagree);
            }
            before = found.bent;
            if other <= agree || other < disagree * smaller || (bends > bent && still_bends <= bent) {
                (best, disagree, bends) = (found.by, other, still_bends);
            }
        }
        (best, if bends > bent { RealOf::<S>::one() } else { disagree })
    }

    /// How accelerations change where a motion at rest is displaced along a direction, by central differences of a step. Where `narrow` displacements
    /// stay where loops are closed.
    pub(crate) fn change<L: Loading<S>>(
        &self,
        still: &MotionOf<S, R, C, P>,
        direction: &RateOf<S, R, C>,
        (narrow, step): (bool, RealOf<S>),
        loads: &L,
        workspace: &mut <Self as StiffDynamics<L>>::StiffWorkspace,
    ) -> Change<S::Scalar>
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        let none = RealOf::<S>::zero();
        // Springs as in an explicit sweep, but apart from the rest: they may be so stiff that the error of a difference in
        // which the inertia changes too would drown all else.
        let springs = Implicit { position: none, rate: none };
        let (mut place, mut acceleration) = (still.position.clone(), still.rate.clone());
        let freedoms = numbers(&still.rate).len();
        let mut by = [(); 2].map(|()| vec![S::Scalar::zero(); freedoms]);
        let mut doubts = vec![[none; 2]; freedoms];
        for (steps, weight, fewer) in DIFFERENCES {
            for sign in [1.0, -1.0] {
                let reach = step * RealOf::<S>::of(sign * steps);
                place.drift_0(&still.position, (reach, direction));
                place.set_clocks(still.time);
                if narrow {
                    self.lead_back(&mut place, still, loads);
                }
                let (here, there) = ((&still.position, &still.rate), (&place, &still.rate));
                let [weight, other] = [weight, weight - fewer].map(|weight| RealOf::<S>::of(sign * weight) / step);
                let next = if steps == 1.0 { step.recip() } else { none };
                for ((at, spring), change) in [(there, here), (here, there)].into_iter().zip(&mut by) {
                    let found = &mut acceleration;
                    // No acceleration: the rates are zero.
                    let reading = Reading { position: spring.0, rate: spring.1, acceleration: &still.rate };
                    self.implicit_accelerations(still.time, at, spring, reading, springs, loads, workspace, found);
                    let mut sums = change.iter_mut().zip(&mut doubts);
                    acceleration.all(&still.acceleration, &mut |x, here| {
                        if let Some((sum, [astray, bent])) = sums.next() {
                            *sum += x.scale(weight);
                            *astray += x.real() * other;
                            *bent += (x.real() - here.real()) * next;
                        }
                        true
                    });
                }
            }
        }
        let largest = |most: RealOf<S>, x: RealOf<S>| most.max(x.abs());
        let size = by.iter().flatten().map(|x| x.real()).fold(none, largest);
        let [astray, bent] = [0, 1].map(|k| doubts.iter().map(|doubt| doubt[k]).fold(none, largest));
        Change { by, size, astray, bent }
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
        let (mut root, mut kink) = (Matrix::zeros(0, freedoms), RealOf::<S>::zero());
        for j in 0..freedoms {
            set(&mut direction, unit(freedoms, j));
            let column = self.weighted(still, &direction);
            if j == 0 {
                root = Matrix::zeros(column.len(), freedoms);
            }
            root.set_column(j, &column);
        }
        let lead = |direction: &mut RateOf<S, R, C>, j| {
            let along: Vec<RealOf<S>> = unit(count, j).collect();
            let along = if narrow { tangent.vector(&along) } else { along };
            set(direction, along.into_iter().map(S::Scalar::constant));
        };
        let mut columns = vec![];
        for j in 0..count {
            lead(&mut direction, j);
            columns.push(self.change(still, &direction, (narrow, step()), loads, workspace));
        }
        let largest = columns.iter().fold(RealOf::<S>::zero(), |most, column| most.max(column.size));
        for (j, first) in columns.into_iter().enumerate() {
            lead(&mut direction, j);
            let at = (still, &direction);
            let (changes, disagree) = self.beside_kinks(at, narrow, largest, first, loads, workspace);
            kink = kink.max(disagree);
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
