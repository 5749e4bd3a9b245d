//! A scene linearised about a steady motion: with ξ what coordinates are displaced by, along the directions that closures leave open, and η what
//! rates are,
//!
//! ```text
//! ξ′ = η − 2 ∂(D(ξ) v)/∂ξ ξ        η′ = ∂a/∂q ξ + ∂a/∂v η
//! ```
//!
//! where D is the differential of the retraction: of a ball that turns at v, ξ′ = η − v × ξ in axes of its body.

use super::{Limits, dense, similar};
use crate::dense::{Matrix, Tangent};
use crate::element::{Element, Level, Loading, RealOf};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::loading::couples;
use crate::mirror::{Position, Rate, Retraction};
use crate::observe::each_body;
use crate::scalar::{Elementary, Real, Scalar};
use crate::system::{
    Dynamics, GRAVITY, Inertial, Keeps, MotionOf, PositionOf, RateOf, Runs, StiffDynamics, System, Way, coordinates,
    differenced, numbers, set, stencil, step, unit,
};
use nalgebra::{DMatrix, DVector, SVD};
use num_traits::{One, Zero};
use std::vec::Vec;

/// Where the scene is asked again whether it is linearised alike: bodies have turned by so much (rad), or so long later (s).
const LATER: f64 = 0.61;
/// Entries of a row are compared with the largest of it by positions, or by rates, or with this share of the largest of both.
const SMALL: f64 = 1e-3;
/// So many roundings are left of accelerations where all coordinates are as heavy.
const ROUNDINGS: f64 = 16.0;

/// A scene linearised about a steady motion.
pub(super) struct Steady<T: Scalar> {
    /// Directions that closures and couplings leave open.
    pub tangent: Tangent<T::Real>,
    pub slopes: Slopes<T>,
    /// The root of the mass matrix, an upper triangle.
    pub root: DMatrix<f64>,
}

/// How (ξ, η) change: (ξ′, η′) for units of ξ and then of η, a column for each.
pub(super) struct Slopes<T: Scalar> {
    pub columns: Vec<Vec<T>>,
    /// By which share differences disagree.
    pub kink: T::Real,
}

/// What a displacement is in truth, by its size.
struct Moved<T> {
    /// Displacements ξ and η along directions: where closures put it back they are others than they were to be.
    displaced: Vec<T>,
    /// ∂(D(ξ) v).
    turned: Vec<T>,
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
        let mass = self.mass_root(&rest);
        let root = dense(&tangent.restrict(&mass)).qr().r();
        let (slopes, speed) = (self.slopes(&steady, (&tangent, &mass), loads), largest(&numbers(&steady.rate)));
        if !slopes.columns.iter().flatten().all(|x| x.is_finite()) {
            return Err(self.diagnose(&steady, loads, &mut self.workspace()));
        }
        let unsteady = |motion: &MotionOf<S, R, C, P>| {
            let pull = tangent.components(&numbers(&motion.acceleration));
            let fault = Fault::NotSteady { acceleration: largest(&pull).as_f64() };
            if slopes.stands(&root, &pull, speed) {
                Ok(())
            } else {
                Err(Error::new(fault).at_time(motion.time.as_f64()))
            }
        };
        unsteady(&steady)?;
        let later = self.later(&steady, loads)?;
        unsteady(&later)?;
        if !slopes.are(&self.slopes(&later, (&tangent, &mass), loads), speed, rounding(&root)) {
            let what =
                "complex modes of what vibrates otherwise a while later, for its coefficients are functions of time";
            return Err(Error::new(Fault::Unsupported { what }).at_time(motion.time.as_f64()));
        }
        Ok(Steady { tangent, slopes, root })
    }

    /// The fastest that a body turns (rad/s).
    fn fastest_spin(&self, motion: &MotionOf<S, R, C, P>) -> RealOf<S> {
        let mut fastest = RealOf::<S>::zero();
        each_body(self.elements(), self.ground(motion.time), coordinates(motion), |body| {
            let spin = S::carried(body).spin;
            fastest = fastest.max(spin.dot(&spin).sqrt());
        });
        fastest
    }

    /// The motion a while later, if rates stay.
    fn later<L: Loading<S>>(&self, steady: &MotionOf<S, R, C, P>, loads: &L) -> Result<MotionOf<S, R, C, P>, Error>
    where
        Self: Runs<L, S, R, C, P>,
    {
        let after = RealOf::<S>::of(LATER) / self.fastest_spin(steady).max(RealOf::<S>::of(LATER));
        let mut later = steady.clone();
        later.time += after;
        later.position.drift_0(&steady.position, (after, &steady.rate));
        later.position.set_clocks(later.time);
        let mut closed = later.clone();
        self.hold(&mut closed, loads, &mut self.workspace())?;
        let [mut astray, mut slower] = [(); 2].map(|()| later.rate.clone());
        closed.position.apart(&later.position, &mut astray);
        slower.mix_1(&closed.rate, (-RealOf::<S>::one(), &later.rate));
        let off = differenced::<RealOf<S>>();
        let speed = RealOf::<S>::one() + largest(&numbers(&steady.rate));
        if largest(&numbers(&astray)) > off * speed || largest(&numbers(&slower)) > off * speed {
            let what = "complex modes of a motion that closures do not let go on steadily";
            return Err(Error::new(Fault::Unsupported { what }).at_time(steady.time.as_f64()));
        }
        Ok(closed)
    }

    /// Slopes along directions; the root of the mass matrix weighs them.
    fn slopes<L: Loading<S>>(
        &self,
        steady: &MotionOf<S, R, C, P>,
        (tangent, root): (&Tangent<RealOf<S>>, &Matrix<RealOf<S>>),
        loads: &L,
    ) -> Slopes<S::Scalar>
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        let n = tangent.dimension();
        let mut workspace = self.stiff_workspace();
        let (mut columns, mut displacements, mut kinks) = (Vec::new(), Vec::new(), RealOf::<S>::zero());
        let mut direction = steady.rate.clone();
        let mut lead = |j| {
            let along: Vec<RealOf<S>> = unit(n, j).collect();
            set(&mut direction, tangent.vector(&along).into_iter().map(S::Scalar::constant));
            direction.clone()
        };
        let closes = const { Self::CLOSED > 0 || couples::<S, L>() };
        let keeps = if closes { Keeps::Motion } else { Keeps::Nothing };
        for level in [Level::Place, Level::Velocity] {
            let directions: Vec<_> = (0..n).map(&mut lead).collect();
            let ways: Vec<_> = directions.iter().map(|direction| Way { level, direction, keeps, root }).collect();
            let (changes, kink) = self.changes(steady, &ways, loads, &mut workspace);
            kinks = kinks.max(kink);
            for (way, [mut change, springs]) in ways.iter().zip(changes) {
                change.iter_mut().zip(springs).for_each(|(sum, more)| *sum += more);
                let number = displacements.len();
                let Moved { displaced, turned } = if closes || PositionOf::<S, R, C>::CURVED {
                    self.displacement(steady, tangent, way, loads)
                } else {
                    Moved { displaced: Vec::new(), turned: std::vec![S::Scalar::zero(); n] }
                };
                let displaced = if closes { displaced } else { unit(2 * n, number).collect() };
                let mut column: Vec<S::Scalar> =
                    displaced[n..].iter().zip(turned).map(|(faster, turned)| *faster - turned - turned).collect();
                column.append(&mut tangent.components(&change));
                columns.push(column);
                displacements.push(displaced);
            }
        }
        if closes {
            by_units(&mut columns, displacements);
        }
        Slopes { columns, kink: kinks }
    }

    /// What a displacement along a way is.
    fn displacement<L: Loading<S>>(
        &self,
        steady: &MotionOf<S, R, C, P>,
        tangent: &Tangent<RealOf<S>>,
        way: &Way<'_, RateOf<S, R, C>, RealOf<S>>,
        loads: &L,
    ) -> Moved<S::Scalar>
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
        Moved { displaced: displaced.into_iter().chain(faster).collect(), turned }
    }
}

impl<T: Scalar> Slopes<T> {
    /// Whether accelerations are next to nothing: where the motion would not accelerate is not far (rad, m), and nothing pulls where nothing drives back.
    fn stands(&self, root: &DMatrix<f64>, pull: &[T], speed: T::Real) -> bool {
        let n = pull.len();
        if n == 0 {
            return true;
        }
        let by_position = DMatrix::from_fn(n, n, |i, j| self.columns[j][n + i].real().as_f64());
        // What has no inertia at all is refused by what follows.
        let weighted = similar(root, &by_position).filter(|matrix| matrix.iter().all(|x| x.is_finite()));
        let Some(weighted) = weighted else { return true };
        let pull = root * DVector::from_iterator(n, pull.iter().map(|x| x.real().as_f64()));
        let Some(SVD { u: Some(left), v_t: Some(right), singular_values }) =
            SVD::try_new(weighted, true, true, f64::EPSILON, 1000 * n)
        else {
            return false;
        };
        let (limits, stiffest, mut way) = (Limits::of::<T::Real>(), singular_values.max(), DVector::zeros(n));
        for (k, size) in singular_values.iter().enumerate() {
            let (part, right) = (left.column(k).dot(&pull), right.row(k).transpose());
            let Some(along) = root.solve_upper_triangular(&right) else { return true };
            let share = limits.share(root, &along, stiffest.max(speed.as_f64().powi(2)));
            if *size > (limits.flat * stiffest).max(limits.noise * share) {
                way.axpy(part / size, &right, 1.0);
            } else if (part * along.amax()).abs() > limits.pull * share {
                return false;
            }
        }
        root.solve_upper_triangular(&way).is_none_or(|way| way.amax() <= limits.off)
    }

    /// Whether other slopes are these, but for what differences leave, and rounding, that of accelerations of light coordinates.
    fn are(&self, other: &Self, speed: T::Real, rounding: f64) -> bool {
        let n = self.columns.len() / 2;
        let limit = differenced::<T::Real>();
        (0..2 * n).all(|i| {
            let parts = [0..n, n..2 * n];
            let most = parts
                .clone()
                .map(|columns| columns.fold(T::Real::zero(), |most, j| most.max(self.columns[j][i].real().abs())));
            let forces = most[0] + most[1] * speed + speed * speed + T::Real::of(GRAVITY);
            let rounded = forces * T::Real::EPSILON / step::<T::Real>() * T::Real::of(rounding);
            let small = if i < n { T::Real::one() } else { most[0].max(most[1]) } * T::Real::of(SMALL);
            parts.into_iter().zip(most).all(|(mut columns, most)| {
                let limit = (limit * most.max(small)).max(rounded);
                columns.all(|j| (self.columns[j][i] - other.columns[j][i]).real().abs() <= limit)
            })
        })
    }
}

/// Makes of slopes along displacements, which are units but for what closures have put back, those along units.
fn by_units<T: Scalar>(columns: &mut [Vec<T>], mut displacements: Vec<Vec<T>>) {
    let size = columns.len();
    for p in 0..size {
        let inverse = displacements[p][p].recip();
        let (own, of_own): (Vec<T>, Vec<T>) = (
            displacements[p].iter().map(|x| *x * inverse).collect(),
            columns[p].iter().map(|x| *x * inverse).collect(),
        );
        for j in (0..size).filter(|j| *j != p) {
            let share = displacements[j][p];
            displacements[j].iter_mut().zip(&own).for_each(|(x, own)| *x -= share * *own);
            columns[j].iter_mut().zip(&of_own).for_each(|(x, own)| *x -= share * *own);
        }
        (displacements[p], columns[p]) = (own, of_own);
    }
}

/// How many roundings of the largest forces accelerations have: many, of light coordinates.
fn rounding(root: &DMatrix<f64>) -> f64 {
    let sizes = root.singular_values();
    let share = sizes.max() / sizes.min();
    if share.is_finite() { ROUNDINGS * share * share } else { ROUNDINGS }
}

fn largest<T: Scalar>(list: &[T]) -> T::Real {
    list.iter().fold(T::Real::zero(), |most, x| most.max(x.real().abs()))
}
