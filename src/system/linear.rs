//! A scene linearised about a position: what statics and modes share.

use super::{Dynamics, MotionOf, PositionOf, RateOf, Runs, StiffDynamics, System, coordinates};
use crate::dense::{Matrix, Tangent};
use crate::element::{Element, Implicit, Level, Loading, Reading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::mechanics::planar::{self, Planar};
use crate::mechanics::spatial::{self, Spatial};
use crate::mirror::{Position, Rate};
use crate::observe::{each_body, each_joint, each_residual};
use crate::relation::Closures;
use crate::scalar::{Elementary, Real, Scalar};
use crate::space::FrameOf;
use alloc::vec;
use alloc::vec::Vec;
use nalgebra::Vector3;
use num_traits::{One, Zero};

/// A space in which the kinetic energy of a body is half a sum of squares.
pub trait Inertial: Space {
    /// Notes velocities of a body times the roots of what resists them, so that their squares add up to twice its kinetic
    /// energy.
    fn weighted(body: &Self::BodyMotion, note: &mut impl FnMut(RealOf<Self>));
    /// Notes rates of a joint's coordinates times the roots of their reflected inertias, √I q̇, where there are any.
    fn reflected(joint: &Self::JointMotion, note: &mut impl FnMut(RealOf<Self>));
    /// The motion of the inboard end of a body.
    fn inboard(body: &Self::BodyMotion) -> FrameOf<Self>;
    /// Velocity and momentum of a body.
    fn carried(body: &Self::BodyMotion) -> Carried<RealOf<Self>>;
}

/// Velocity and momentum of a body, inertial axes (in the plane with z across it).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carried<R> {
    /// Velocity of the mass centre (m/s).
    pub velocity: Vector3<R>,
    /// Angular velocity (rad/s).
    pub spin: Vector3<R>,
    /// Momentum (N·s).
    pub momentum: Vector3<R>,
    /// Angular momentum about the mass centre (N·m·s).
    pub angular: Vector3<R>,
}

impl<R: Real> Carried<R> {
    /// Takes away what another one is.
    pub(crate) fn less(&mut self, other: Self) {
        self.velocity -= other.velocity;
        self.spin -= other.spin;
        self.momentum -= other.momentum;
        self.angular -= other.angular;
    }
}

impl<T: Scalar> Inertial for Planar<T> {
    fn weighted(body: &planar::BodyMotion<T>, note: &mut impl FnMut(T::Real)) {
        // A moment of inertia may be negative by rounding.
        let root = |x: T| x.real().max(T::Real::zero()).sqrt();
        let (mass, about_centre) = (root(body.inertia.mass), root(body.inertia.about_centre));
        let velocity = body.centre().velocity;
        note(mass * velocity.x.real());
        note(mass * velocity.y.real());
        note(about_centre * body.rate().real());
    }

    fn reflected(joint: &planar::JointMotion<T>, note: &mut impl FnMut(T::Real)) {
        let inertia = joint.inertia.real();
        if inertia > T::Real::zero() {
            note(inertia.sqrt() * joint.driven_rate().real());
        }
    }

    fn inboard(body: &planar::BodyMotion<T>) -> planar::Frame<T> {
        body.inboard
    }

    fn carried(body: &planar::BodyMotion<T>) -> Carried<T::Real> {
        let zero = T::Real::zero();
        let centre = body.centre().velocity;
        let (velocity, spin) =
            (Vector3::new(centre.x.real(), centre.y.real(), zero), Vector3::new(zero, zero, body.rate().real()));
        let [mass, about_centre] = [body.inertia.mass, body.inertia.about_centre].map(|x| x.real());
        Carried { velocity, spin, momentum: velocity * mass, angular: spin * about_centre }
    }
}

impl<T: Scalar> Inertial for Spatial<T> {
    fn weighted(body: &spatial::BodyMotion<T>, note: &mut impl FnMut(T::Real)) {
        let mass = body.inertia.mass.real().max(T::Real::zero()).sqrt();
        body.centre().velocity.iter().for_each(|v| note(mass * v.real()));
        // J = L Lᵀ, column by column; what has no moment about an axis (or less than none, by rounding) has no column.
        let mut rest = body.inertia.about_centre.map(|row| row.map(|x| x.real()));
        let spin = body.rate().map(|x| x.real());
        for k in 0..3 {
            let mut column = [T::Real::zero(); 3];
            if rest[k][k] > T::Real::zero() {
                let inverse = rest[k][k].sqrt().recip();
                (k..3).for_each(|i| column[i] = rest[i][k] * inverse);
            }
            for i in k..3 {
                (k..3).for_each(|j| rest[i][j] -= column[i] * column[j]);
            }
            note((k..3).fold(T::Real::zero(), |sum, i| sum + column[i] * spin[i]));
        }
    }

    fn reflected(joint: &spatial::JointMotion<T>, note: &mut impl FnMut(T::Real)) {
        for (inertia, rate) in joint.inertia.iter().zip(joint.rate).map(|(inertia, rate)| (inertia.real(), rate.real()))
        {
            if inertia > T::Real::zero() {
                note(inertia.sqrt() * rate);
            }
        }
    }

    fn inboard(body: &spatial::BodyMotion<T>) -> spatial::Frame<T> {
        body.inboard
    }

    fn carried(body: &spatial::BodyMotion<T>) -> Carried<T::Real> {
        let rate = body.rate();
        let own = body.inertia.about_centre.map(|row| (0..3).fold(T::zero(), |sum, i| sum + row[i] * rate[i]));
        let [spin, angular] = [rate, own].map(|of_body| body.turned(of_body).map(|x| x.real()));
        let velocity = body.centre().velocity.map(|x| x.real());
        Carried { velocity, spin, momentum: velocity * body.inertia.mass.real(), angular }
    }
}

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

/// The numbers of a rate, root to tip.
pub(crate) fn numbers<T: Scalar, V: Rate<T>>(rate: &V) -> Vec<T> {
    let mut numbers = vec![];
    rate.visit(&mut |x| numbers.push(x));
    numbers
}

/// Sets the numbers of a rate, root to tip.
pub(crate) fn set<T: Scalar, V: Rate<T>>(rate: &mut V, numbers: impl IntoIterator<Item = T>) {
    let mut numbers = numbers.into_iter();
    rate.replace(&mut |_| numbers.next().unwrap_or(T::zero()));
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
    pub(crate) fn drift(&self, motion: &MotionOf<S, R, C, P>) -> Vec<RealOf<S>> {
        let mut drift = vec![];
        P::Closures::map(&self.residual(motion)[1], |x| drift.push(x.real()));
        each_residual(self.elements(), self.ground(motion.time), coordinates(motion), |[_, x]| drift.push(x.real()));
        drift
    }

    /// The directions that closures and couplings leave open.
    fn tangent<L: Loading<S>>(&self, still: &MotionOf<S, R, C, P>, loads: &L, freedoms: usize) -> Tangent<RealOf<S>> {
        let missed = |motion: &MotionOf<S, R, C, P>| {
            let mut all = self.drift(motion);
            loads.each_miss(&motion.position, &motion.rate, &mut |level, missed, _| {
                if let Level::Velocity = level {
                    all.push(missed.real());
                }
            });
            all
        };
        let drift = missed(still);
        let mut rows: Vec<Vec<RealOf<S>>> = vec![vec![]; drift.len()];
        let mut moving = still.clone();
        for j in 0..if rows.is_empty() { 0 } else { freedoms } {
            set(&mut moving.rate, unit(freedoms, j));
            for (row, (with, without)) in rows.iter_mut().zip(missed(&moving).into_iter().zip(&drift)) {
                row.push(with - *without);
            }
        }
        Tangent::of(freedoms, rows)
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
        let none = RealOf::<S>::zero();
        let step = step::<RealOf<S>>();
        let freedoms = numbers(&still.rate).len();
        let tangent = self.tangent(still, loads, freedoms);
        let (mut direction, mut acceleration) = (still.rate.clone(), still.rate.clone());
        let mut place: PositionOf<S, R, C> = still.position.clone();
        // Conditions that follow from others do so where all are met: there displacements have to stay, and go along the directions left open.
        let narrow = tangent.is_redundant();
        let count = if narrow { tangent.dimension() } else { freedoms };
        let mut responses = [(); 2].map(|()| Matrix::zeros(freedoms, count));
        let mut root = Matrix::zeros(0, freedoms);
        let mut changes = [(); 2].map(|()| vec![none; freedoms]);
        // Springs as in an explicit sweep, but apart from the rest: they may be so stiff that the error of a difference in
        // which the inertia changes too would drown all else.
        let springs = Implicit { position: none, rate: none };
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
            changes.iter_mut().for_each(|change| change.fill(none));
            for (steps, weight) in DIFFERENCES {
                for sign in [1.0, -1.0] {
                    let reach = step * RealOf::<S>::of(sign * steps);
                    place.drift_0(&still.position, (reach, &direction));
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
                                *sum += weight * x.real();
                            }
                        });
                    }
                }
            }
            for (response, change) in responses.iter_mut().zip(&changes) {
                response.set_column(j, change);
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

/// The step of the differences. The scale of angles is a radian, and it loses about as much by their order as by rounding. A power
/// of two adds to an angle without rounding.
pub(crate) fn step<R: Real>() -> R {
    let mut step = R::one();
    while step * step * step * step * step * step > R::EPSILON * R::of(1.0 / 64.0) {
        step *= R::of(0.5);
    }
    step
}

/// What differences and rounding leave, at most: of a position of rest (rad, m), and of a stiffness as asymmetry, as a share of it. 1e-6 of `f64`,
/// 2e-3 of `f32`; they leave far less.
pub(crate) fn differenced<R: Real>() -> R {
    R::EPSILON.powf(R::of(0.383))
}

/// Unit vector `j` of `n`.
pub(crate) fn unit<T: Scalar>(n: usize, j: usize) -> impl Iterator<Item = T> {
    (0..n).map(move |i| if i == j { T::one() } else { T::zero() })
}
