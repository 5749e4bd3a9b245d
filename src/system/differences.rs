//! Differences by which a scene is linearised, of eighth order; where a force has a kink close by they are narrowed.

use super::inertial::Inertial;
use super::lists::numbers;
use super::{Dynamics, MotionOf, RateOf, Runs, StiffDynamics, System};
use crate::dense::Matrix;
use crate::element::{Element, Implicit, Level, Loading, Reading, RealOf};
use crate::ends::{Root, Tip};
use crate::mirror::{Position, Rate};
use crate::scalar::{Real, Scalar};
use alloc::vec;
use alloc::vec::Vec;
use num_traits::{One, Zero};

/// Central differences of eighth order, and of fourth: places (in steps) and weights.
const DIFFERENCES: [(f64, f64, f64); 4] =
    [(1.0, 0.8, 2.0 / 3.0), (2.0, -0.2, -1.0 / 12.0), (3.0, 4.0 / 105.0, 0.0), (4.0, -1.0 / 280.0, 0.0)];

/// The way along which accelerations are asked for.
pub(crate) struct Way<'a, V, R> {
    /// Whether positions or rates are displaced.
    pub level: Level,
    pub direction: &'a V,
    pub keeps: Keeps,
    /// The root of the mass matrix, which weighs accelerations: those of light bodies are large, and tell little of what the others do.
    pub root: &'a Matrix<R>,
}

/// What is put back where loops are closed after a displacement.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Keeps {
    Nothing,
    /// Positions, and rates stay.
    Place,
    /// Positions and rates.
    Motion,
}

/// How accelerations (m/s², rad/s²) change along a way.
struct Change<T: Scalar> {
    /// By all but springs, and by these.
    by: [Vec<T>; 2],
    /// The largest of both, weighed.
    size: T::Real,
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
/// What the shortest steps bend by is rounding if longer ones bend by no more than so many times as much would leave there.
const ROUNDED: f64 = 64.0;
/// So many roundings are left of accelerations as large as those of unit displacements, or as gravity.
const ROUNDINGS: f64 = 16.0;
/// What gravity makes, about (m/s²).
pub(crate) const GRAVITY: f64 = 10.0;

impl<S: Inertial, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// How accelerations change along each way, by all but springs and by these, and by which share differences disagree at most: much, of a force that
    /// has a kink there.
    #[allow(clippy::type_complexity)] // of two kinds of forces, for each way
    pub(crate) fn changes<L: Loading<S>>(
        &self,
        still: &MotionOf<S, R, C, P>,
        ways: &[Way<'_, RateOf<S, R, C>, RealOf<S>>],
        loads: &L,
        workspace: &mut <Self as StiffDynamics<L>>::StiffWorkspace,
    ) -> (Vec<[Vec<S::Scalar>; 2]>, RealOf<S>)
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        let first: Vec<_> = ways.iter().map(|way| self.change(still, way, step(), loads, workspace)).collect();
        let largest = first.iter().fold(RealOf::<S>::zero(), |most, change| most.max(change.size));
        let mut kink = RealOf::<S>::zero();
        let changes = ways.iter().zip(first).map(|(way, first)| {
            let (change, disagree) = self.beside_kinks(still, way, largest, first, loads, workspace);
            kink = kink.max(disagree);
            change
        });
        (changes.collect(), kink)
    }

    /// What differences that disagree, or bend, are where steps are ever smaller; and by which share of the largest they still do, beyond rounding of what is
    /// as large as the `largest` change by any direction: as a force that has a kink right there does.
    ///
    /// Differences disagree that reach beyond a kink, of a rope that is hardly taut say. They bend if they are others ahead than behind. Of light coordinates
    /// between large forces rounding is more than this allows for: what it bends goes with the inverse of steps, and the longest are best.
    fn beside_kinks<L: Loading<S>>(
        &self,
        still: &MotionOf<S, R, C, P>,
        way: &Way<'_, RateOf<S, R, C>, RealOf<S>>,
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
        let heaviest = way.root.rows().flatten().fold(RealOf::<S>::zero(), |most, x| most.max(x.abs()));
        let forces = largest + RealOf::<S>::of(GRAVITY) * heaviest;
        let rounding = RealOf::<S>::EPSILON * RealOf::<S>::of(ROUNDINGS) * forces;
        let shares = |change: &Change<S::Scalar>, step: RealOf<S>| {
            [(change.astray, agree), (change.bent, bent)]
                .map(|(x, limit)| x / change.size.max(rounding / (step * limit)))
        };
        let (mut step, least) = (step::<RealOf<S>>(), RealOf::<S>::EPSILON.powf(RealOf::<S>::of(LEAST)));
        let [mut disagree, mut bends] = shares(&first, step);
        let (longest, mut before) = (step, first.bent);
        let (mut least_bent, mut rounding_bends) = (first.bent, RealOf::<S>::zero());
        let mut narrower: Option<Change<S::Scalar>> = None;
        while (disagree > agree || bends > bent) && step > least {
            step *= smaller;
            let found = self.change(still, way, step, loads, workspace);
            let [other, still_bends] = shares(&found, step);
            let best = narrower.as_ref().unwrap_or(&first);
            // Where a force is smooth they bend in proportion to steps.
            if disagree <= agree && found.bent < before * smaller * two && found.bent * two > before * smaller {
                return (narrower.unwrap_or(first).by, disagree);
            }
            (before, least_bent) = (found.bent, least_bent.min(found.bent));
            if step < longest * smaller {
                rounding_bends = rounding_bends.max(found.bent * step);
            }
            let agrees = (other <= agree || other < disagree * smaller) && found.astray <= best.astray * smaller;
            if agrees {
                (narrower, disagree, bends) = (Some(found), other, still_bends);
            } else if still_bends <= bent && found.bent <= first.bent {
                bends = still_bends;
            }
        }
        let rounded = least_bent * longest <= rounding_bends * RealOf::<S>::of(ROUNDED);
        if rounded && (disagree > agree || bends > bent) {
            return (first.by, RealOf::<S>::zero());
        }
        (narrower.unwrap_or(first).by, if bends > bent { RealOf::<S>::one() } else { disagree })
    }

    /// How accelerations change where a motion whose joints do not accelerate is displaced along a way, by central differences of a step.
    fn change<L: Loading<S>>(
        &self,
        still: &MotionOf<S, R, C, P>,
        way: &Way<'_, RateOf<S, R, C>, RealOf<S>>,
        step: RealOf<S>,
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
        let (mut near, mut acceleration) = (still.clone(), still.rate.clone());
        // What joints do not accelerate by.
        let mut unmoved = still.rate.clone();
        unmoved.replace(&mut |_| S::Scalar::zero());
        let freedoms = numbers(&still.rate).len();
        let mut by = [(); 2].map(|()| vec![S::Scalar::zero(); freedoms]);
        let mut doubts = vec![[none; 2]; freedoms];
        for (steps, weight, fewer) in DIFFERENCES {
            for sign in [1.0, -1.0] {
                let reach = step * RealOf::<S>::of(sign * steps);
                self.displaced(&mut near, still, way, reach, loads);
                let (here, there) = ((&still.position, &still.rate), (&near.position, &near.rate));
                let [weight, other] = [weight, weight - fewer].map(|weight| RealOf::<S>::of(sign * weight) / step);
                let next = if steps == 1.0 { step.recip() } else { none };
                for ((at, spring), change) in [(there, here), (here, there)].into_iter().zip(&mut by) {
                    let found = &mut acceleration;
                    let reading = Reading { position: spring.0, rate: spring.1, acceleration: &unmoved };
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
        let weighed = |list: Vec<RealOf<S>>| {
            way.root.apply(&list).into_iter().fold(none, |most: RealOf<S>, x: RealOf<S>| most.max(x.abs()))
        };
        let [others, springs] = [0, 1].map(|k| weighed(by[k].iter().map(|x| x.real()).collect()));
        let [astray, bent] = [0, 1].map(|k| weighed(doubts.iter().map(|doubt| doubt[k]).collect()));
        let size = others.max(springs);
        Change { by, size, astray, bent }
    }

    /// Displaces a motion along a way. Where loops do not close again what is found is no number or far off.
    pub(crate) fn displaced<L: Loading<S>>(
        &self,
        near: &mut MotionOf<S, R, C, P>,
        still: &MotionOf<S, R, C, P>,
        &Way { level, direction, keeps, .. }: &Way<'_, RateOf<S, R, C>, RealOf<S>>,
        reach: RealOf<S>,
        loads: &L,
    ) where
        Self: Runs<L, S, R, C, P>,
    {
        near.copy_state(still);
        match level {
            Level::Place => {
                near.position.drift_0(&still.position, (reach, direction));
                near.position.set_clocks(still.time);
            }
            Level::Velocity => near.rate.mix_1(&still.rate, (reach, direction)),
        }
        if keeps == Keeps::Nothing {
            return;
        }
        let mut closed = near.clone();
        if self.hold(&mut closed, loads, &mut self.workspace()).is_ok() {
            core::mem::swap(&mut near.position, &mut closed.position);
            if keeps == Keeps::Motion {
                core::mem::swap(&mut near.rate, &mut closed.rate);
            }
        }
    }
}

/// By how much to displace for slopes of eighth order, by steps of a size, and the weights of what is found there.
#[cfg(feature = "std")]
pub(crate) fn stencil<R: Real>(step: R) -> impl Iterator<Item = (R, R)> {
    let side = move |sign| {
        let both = move |(steps, weight, _)| (step * R::of(sign * steps), R::of(sign * weight) / step);
        DIFFERENCES.into_iter().map(both)
    };
    side(1.0).chain(side(-1.0))
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
