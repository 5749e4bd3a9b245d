//! A scene linearised about a steady motion: with ξ what coordinates are displaced by, along the directions that closures leave open, and η what
//! rates are,
//!
//! ```text
//! ξ′ = η − 2 ∂(D(ξ) v)/∂ξ ξ        η′ = ∂a/∂q ξ + ∂a/∂v η
//! ```
//!
//! where D is the differential of the retraction: of a ball that turns at v, ξ′ = η − v × ξ in axes of its body.

use super::dense;
use crate::dense::Tangent;
use crate::element::{Element, Level, Loading, RealOf};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate, Retraction};
use crate::scalar::{Elementary, Real, Scalar};
use crate::system::{
    Dynamics, GRAVITY, Inertial, Keeps, MotionOf, RateOf, Runs, StiffDynamics, System, Way, differenced, numbers, set,
    stencil, step, unit,
};
use nalgebra::DMatrix;
use num_traits::{One, Zero};
use std::vec::Vec;

/// Where the scene is asked again whether it is linearised alike: so much of the time in which the fastest mode turns by one.
const LATER: f64 = 0.61;
/// Entries below such a share of the largest by positions, or by rates, are compared with that share of it.
const SMALL: f64 = 1e-3;

/// So many roundings are left of accelerations where all coordinates are as heavy.
const ROUNDINGS: f64 = 16.0;

/// A scene linearised about a steady motion.
pub(super) struct Steady<T: Scalar> {
    /// Directions that closures and couplings leave open.
    pub tangent: Tangent<T::Real>,
    pub slopes: Slopes<T>,
    /// The root of the mass matrix.
    pub root: DMatrix<f64>,
}

/// How (ξ, η) change, a column for each of ξ and then of η.
pub(super) struct Slopes<T: Scalar> {
    /// (ξ′, η′) for unit displacements.
    pub columns: Vec<Vec<T>>,
    /// By how much displacements are others than they were to be, of jets: what closes a scene may change with its numbers.
    pub strays: Vec<Vec<T>>,
    /// By which share differences disagree.
    pub kink: T::Real,
}

impl<S: Inertial, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// The scene linearised about a motion, unless that accelerates, or the scene is linearised otherwise a while later.
    pub(super) fn steadily<L: Loading<S>>(
        &self,
        motion: &MotionOf<S, R, C, P>,
        loads: &L,
    ) -> Result<Steady<S::Scalar>, Error>
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        let (mut steady, mut rest) = (motion.clone(), motion.clone());
        rest.rate.replace(&mut |_| S::Scalar::zero());
        self.accelerate(&mut steady, loads, &mut self.workspace())?;
        let tangent = Tangent::of(numbers(&rest.rate).len(), self.rate_conditions(&rest, loads));
        let slopes = self.slopes(&steady, &tangent, loads);
        let root = dense(&tangent.restrict(&self.mass_root(&rest)));
        let unsteady = |motion: &MotionOf<S, R, C, P>| {
            let acceleration = pull(&tangent, &motion.acceleration);
            let fault = Fault::NotSteady { acceleration: acceleration.as_f64() };
            (acceleration > slopes.most_of(&motion.rate)).then(|| Error::new(fault).at_time(motion.time.as_f64()))
        };
        if let Some(error) = unsteady(&steady) {
            return Err(error);
        }
        let fastest = Elementary::sqrt(slopes.largest()[0]).max(slopes.largest()[1]);
        let fastest = if fastest > RealOf::<S>::zero() { fastest } else { RealOf::<S>::one() };
        let later = self.later(&steady, RealOf::<S>::of(LATER) / fastest, loads)?;
        if let Some(error) = unsteady(&later) {
            return Err(error);
        }
        if !slopes.are(&self.slopes(&later, &tangent, loads), rounding(&root)) {
            let what =
                "complex modes of what vibrates otherwise a while later, for its coefficients are functions of time";
            return Err(Error::new(Fault::Unsupported { what }).at_time(motion.time.as_f64()));
        }
        Ok(Steady { tangent, slopes, root })
    }

    /// The motion a while (s) later, if rates stay.
    fn later<L: Loading<S>>(
        &self,
        steady: &MotionOf<S, R, C, P>,
        after: RealOf<S>,
        loads: &L,
    ) -> Result<MotionOf<S, R, C, P>, Error>
    where
        Self: Runs<L, S, R, C, P>,
    {
        let mut later = steady.clone();
        later.time += after;
        later.position.drift_0(&steady.position, (after, &steady.rate));
        later.position.set_clocks(later.time);
        let mut closed = later.clone();
        self.hold(&mut closed, loads, &mut self.workspace())?;
        let [mut astray, mut slower] = [(); 2].map(|()| later.rate.clone());
        closed.position.apart(&later.position, &mut astray);
        slower.mix_2(&closed.rate, (-RealOf::<S>::one(), &later.rate), (RealOf::<S>::zero(), &later.rate));
        let off = differenced::<RealOf<S>>();
        let speed = RealOf::<S>::one() + largest(&numbers(&steady.rate));
        if largest(&numbers(&astray)) > off * speed || largest(&numbers(&slower)) > off * speed {
            let what = "complex modes of a motion that closures do not let go on steadily";
            return Err(Error::new(Fault::Unsupported { what }).at_time(steady.time.as_f64()));
        }
        Ok(closed)
    }

    /// Slopes along directions.
    fn slopes<L: Loading<S>>(
        &self,
        steady: &MotionOf<S, R, C, P>,
        tangent: &Tangent<RealOf<S>>,
        loads: &L,
    ) -> Slopes<S::Scalar>
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        let n = tangent.dimension();
        let mut workspace = self.stiff_workspace();
        let mut slopes: Slopes<S::Scalar> = Slopes { columns: Vec::new(), strays: Vec::new(), kink: Zero::zero() };
        let mut direction = steady.rate.clone();
        let mut lead = |j| {
            let along: Vec<RealOf<S>> = unit(n, j).collect();
            set(&mut direction, tangent.vector(&along).into_iter().map(S::Scalar::constant));
            direction.clone()
        };
        for level in [Level::Place, Level::Velocity] {
            let directions: Vec<_> = (0..n).map(&mut lead).collect();
            let ways: Vec<_> =
                directions.iter().map(|direction| Way { level, direction, keeps: Keeps::Motion }).collect();
            let changes: Vec<_> =
                ways.iter().map(|way| self.change(steady, way, step(), loads, &mut workspace)).collect();
            let largest = changes.iter().fold(RealOf::<S>::zero(), |most, change| most.max(change.size));
            for (j, (way, first)) in ways.iter().zip(changes).enumerate() {
                let ([mut change, springs], kink) =
                    self.beside_kinks(steady, way, largest, first, loads, &mut workspace);
                slopes.kink = slopes.kink.max(kink);
                change.iter_mut().zip(springs).for_each(|(sum, more)| *sum += more);
                let (stray, turned) = self.strays(steady, tangent, way, loads);
                let faster = |k| {
                    if matches!(level, Level::Velocity) && k == j { RealOf::<S>::one() } else { RealOf::<S>::zero() }
                };
                let mut column: Vec<S::Scalar> =
                    (0..n).map(|k| S::Scalar::constant(faster(k)) + stray[n + k] - turned[k] - turned[k]).collect();
                column.append(&mut tangent.components(&change));
                slopes.columns.push(column);
                slopes.strays.push(stray);
            }
        }
        slopes
    }

    /// By how much displacements are others than they were to be, but for real parts, and what the differential of the retraction makes of rates.
    fn strays<L: Loading<S>>(
        &self,
        steady: &MotionOf<S, R, C, P>,
        tangent: &Tangent<RealOf<S>>,
        way: &Way<'_, RateOf<S, R, C>>,
        loads: &L,
    ) -> (Vec<S::Scalar>, Vec<S::Scalar>)
    where
        Self: Runs<L, S, R, C, P>,
    {
        let (mut near, mut apart) = (steady.clone(), steady.rate.clone());
        let mut sums = [(); 3].map(|()| steady.rate.clone());
        sums.iter_mut().for_each(|sum| sum.replace(&mut |_| S::Scalar::zero()));
        for (reach, weight) in stencil(step()) {
            self.displaced(&mut near, steady, way, reach, loads);
            near.position.apart(&steady.position, &mut apart);
            let mut turned = steady.rate.clone();
            near.position.retract_rate(&steady.position, &mut turned);
            for (sum, more) in sums.iter_mut().zip([&apart, &near.rate, &turned]) {
                let mut next = sum.clone();
                next.mix_1(sum, (weight, more));
                *sum = next;
            }
        }
        let [displaced, faster, turned] = sums.map(|sum| tangent.components(&numbers(&sum)));
        let derivatives = |x: S::Scalar| x - S::Scalar::constant(x.real());
        (displaced.into_iter().chain(faster).map(derivatives).collect(), turned)
    }
}

impl<T: Scalar> Slopes<T> {
    /// The largest change of accelerations by positions, and by rates.
    fn largest(&self) -> [T::Real; 2] {
        let n = self.columns.len() / 2;
        [&self.columns[..n], &self.columns[n..]].map(|list| {
            list.iter().flat_map(|column| &column[n..]).fold(T::Real::zero(), |most, x| most.max(x.real().abs()))
        })
    }

    /// The largest acceleration that differences and rounding leave.
    fn most_of<V: Rate<T>>(&self, rate: &V) -> T::Real {
        let [by_position, by_rate] = self.largest();
        let speed = largest(&numbers(rate));
        let forces = by_position + by_rate * speed + speed * speed;
        let rounding = T::Real::EPSILON * T::Real::of(1e3 * GRAVITY);
        forces * differenced::<T::Real>() + rounding
    }

    /// Whether other slopes are these, but for what differences leave, and rounding, that of accelerations of light coordinates.
    fn are(&self, other: &Self, rounding: f64) -> bool {
        let n = self.columns.len() / 2;
        let largest = self.largest();
        let limit = differenced::<T::Real>();
        let rounded =
            (largest[0] + T::Real::of(GRAVITY)) * T::Real::EPSILON / step::<T::Real>() * T::Real::of(rounding);
        (0..2 * n).all(|i| {
            [0, 1].into_iter().all(|part| {
                let columns = part * n..(part + 1) * n;
                let mut most = if i < n { T::Real::one() } else { largest[part] } * T::Real::of(SMALL);
                columns.clone().for_each(|j| most = most.max(self.columns[j][i].real().abs()));
                let limit = (limit * most).max(if i < n { T::Real::zero() } else { rounded });
                columns.clone().all(|j| (self.columns[j][i] - other.columns[j][i]).real().abs() <= limit)
            })
        })
    }
}

/// How many roundings of the largest forces accelerations have: many, of light coordinates.
fn rounding(root: &DMatrix<f64>) -> f64 {
    let sizes = root.singular_values();
    let share = sizes.max() / sizes.min();
    if share.is_finite() { ROUNDINGS * share * share } else { ROUNDINGS }
}

/// The largest acceleration along the directions that closures leave open.
fn pull<T: Scalar, V: Rate<T>>(tangent: &Tangent<T::Real>, acceleration: &V) -> T::Real {
    largest(&tangent.components(&numbers(acceleration)))
}

fn largest<T: Scalar>(list: &[T]) -> T::Real {
    list.iter().fold(T::Real::zero(), |most, x| most.max(x.real().abs()))
}
