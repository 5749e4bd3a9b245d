//! The eight steps of section 4: a run of the paper's scheme.

mod form;
mod keep;

use crate::element::Loading;
use crate::error::{Error, Fault};
use crate::paper::expansion::{At, Expansion};
use crate::paper::link::{Base, Link};
use crate::paper::parts::{Body, Part, parts};
use crate::paper::riccati::{Gain, Relation};
use crate::paper::rule::Rule;
use crate::paper::scene::Scene;
use crate::paper::{product, riccati};
use crate::planar::index::THETA;
use crate::planar::{Frame, Planar};
use crate::relation::Term;
use crate::scalar::{Real, Scalar};
use crate::state::{StateVector, TransferMatrix};
use alloc::{vec, vec::Vec};
use num_traits::Zero;

/// How the overall equation is solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Solver {
    /// By the plain product of matrices in absolute coordinates, (16) and (17), as printed: for short chains.
    #[default]
    Product,
    /// By the Riccati transform of section 5.5, in increments: for chains of any length.
    Riccati,
}

/// The scheme of the paper: a rule, where it is linearised, and how it is solved. As printed unless told otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scheme<D> {
    rule: D,
    at: At,
    solver: Solver,
}

impl<D> Scheme<D> {
    /// As printed: linearised at t_{i−1}, solved by the plain product.
    pub fn new(rule: D) -> Self {
        Self { rule, at: At::Previous, solver: Solver::Product }
    }

    /// Linearised elsewhere.
    #[must_use]
    pub fn linearized(self, at: At) -> Self {
        Self { at, ..self }
    }

    /// Solved by other means.
    #[must_use]
    pub fn solved_by(self, solver: Solver) -> Self {
        Self { solver, ..self }
    }

    /// Steps 1 and 2: starts a run of a scene with steps of `dt` (s).
    ///
    /// # Errors
    /// What is wrong with the rule or the step; what [`System::with_accelerations`](crate::system::System::with_accelerations)
    /// refuses, for a run starts from the accelerations of its motion.
    pub fn start<'a, T: Scalar, S: Scene<T, L>, L>(
        self,
        scene: &'a S,
        motion: &S::Motion,
        loads: &'a L,
        dt: T::Real,
    ) -> Result<Run<'a, T, S, L, D>, Error>
    where
        D: Rule<T>,
    {
        self.rule.check().map_err(Error::new)?;
        positive_step(dt)?;
        let (time, items) = scene.items(motion, loads)?;
        let parts = parts(&self.rule, dt, &items);
        let blank = StateVector::new([T::zero(); 7]);
        let n = parts.len();
        Ok(Run {
            scheme: self,
            scene,
            loads,
            dt,
            start: time,
            steps: 0,
            links: Vec::with_capacity(n),
            relations: vec![Relation::free(); n],
            gains: vec![Gain::blank(); n],
            matrices: vec![TransferMatrix::identity(); if self.solver == Solver::Product { n } else { 0 }],
            states: vec![blank; n + 1],
            stations: vec![blank; n + 1],
            parts,
            sweeps: 0,
        })
    }
}

/// Refuses a step that is not positive and finite.
pub(super) fn positive_step<R: Real>(dt: R) -> Result<(), Error> {
    if !dt.is_finite() {
        return Err(Error::new(Fault::NotFinite { parameter: "step" }));
    }
    if dt <= R::zero() {
        return Err(Error::new(Fault::NotPositive { parameter: "step", value: dt.as_f64() }));
    }
    Ok(())
}

/// A run of the scheme. It stands at an instant and steps on from there.
#[derive(Clone, Debug)]
pub struct Run<'a, T: Scalar, S, L, D: Rule<T>> {
    scheme: Scheme<D>,
    scene: &'a S,
    loads: &'a L,
    dt: T::Real,
    start: T::Real,
    steps: usize,
    parts: Vec<Part<T, D::Memory>>,
    links: Vec<Link<T>>,
    relations: Vec<Relation<T>>,
    gains: Vec<Gain<T>>,
    matrices: Vec<TransferMatrix<T, 7>>,
    /// As solved: absolute, or in increments.
    states: Vec<StateVector<T, 7>>,
    /// Absolute.
    stations: Vec<StateVector<T, 7>>,
    sweeps: usize,
}

impl<T, S, L, D> Run<'_, T, S, L, D>
where
    T: Scalar,
    S: Scene<T, L>,
    L: Loading<Planar<T>, InJoint: Term<T>>,
    D: Rule<T>,
{
    /// Time (s) of angles and rates.
    pub fn time(&self) -> T::Real {
        self.start + T::Real::of(self.steps as f64) * self.dt
    }

    /// Time (s) of the stations, where forces balanced: that of the run, but for rules that balance elsewhere.
    pub fn balance_time(&self) -> T::Real {
        self.start + T::Real::of(self.steps as f64 - 1.0 + self.scheme.rule.balance()) * self.dt
    }

    /// Solutions of the overall equation so far: one each step unless iterated.
    pub fn sweeps(&self) -> usize {
        self.sweeps
    }

    /// Angle, rate and angular acceleration (rad, s) of body `k`, counted from 0 at the root.
    pub fn turn(&self, k: usize) -> Option<[T; 3]> {
        let body = bodies(&self.parts).nth(k)?;
        Some([body.angle.value, body.angle.rate, body.angle.acceleration])
    }

    /// The angles of all bodies (rad), root to tip.
    pub fn angles(&self) -> impl Iterator<Item = T> {
        bodies(&self.parts).map(|body| body.angle.value)
    }

    /// States (14) of all stations after a step: the ground's side of the root's joint, the inboard end of each element, the tip.
    pub fn stations(&self) -> &[StateVector<T, 7>] {
        &self.stations
    }

    /// The matrices of the last step, as multiplied: those of (17), root to tip, after one for the root's joint that is not used. Empty
    /// where no product is formed.
    pub fn matrices(&self) -> &[TransferMatrix<T, 7>] {
        &self.matrices
    }

    /// Steps on to a time (s): the nearest number of whole steps.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn run_to(&mut self, end: T::Real) -> Result<(), Error> {
        while self.time() + T::Real::of(0.5) * self.dt < end {
            self.step()?;
        }
        Ok(())
    }

    /// Steps 3 to 8.
    ///
    /// # Errors
    /// [`Fault::CentreOfPercussion`] or [`Fault::SingularJoint`] with the station, [`Fault::NotConverged`],
    /// [`Fault::NonFiniteMotion`] where a run breaks down; the run then stands where it stood.
    pub fn step(&mut self) -> Result<(), Error> {
        let span = T::Real::of(self.scheme.rule.balance()) * self.dt;
        let (past, time) = (self.time(), self.time() + span);
        let at_time = |error: Error| error.at_time(time.as_f64());
        let (before, ground) = (self.scene.ground(past), self.scene.ground(time));
        self.guess(span);
        let mut again = usize::MAX; // sweeps after that with which the equations held
        for sweep in 0.. {
            self.form(span, time, &before, &ground);
            self.solve(&before, &ground).map_err(at_time)?;
            self.sweeps += 1;
            let change = self.find();
            if !change.is_finite() {
                return Err(at_time(Error::new(Fault::NonFiniteMotion)));
            }
            // The last sweep brings derivatives as far as values.
            if self.scheme.at != At::Iterated || again == 0 {
                break;
            }
            if again < usize::MAX {
                again -= 1;
            } else if change <= T::Real::EPSILON.powf(T::Real::of(0.75)) {
                again = 0;
            } else if sweep == 30 {
                return Err(at_time(Error::new(Fault::NotConverged { sweeps: 30 })));
            }
            for part in &mut self.parts {
                if let Part::Body(body) = part {
                    body.expansion = Expansion::about(body.angle.value + body.found);
                }
            }
        }
        if !self.states.iter().all(|z| (0..7).all(|i| z[i].is_finite())) {
            return Err(at_time(Error::new(Fault::NonFiniteMotion)));
        }
        self.commit(&before);
        self.steps += 1;
        Ok(())
    }

    /// Steps 5 and 6.
    fn solve(&mut self, before: &Frame<T>, ground: &Frame<T>) -> Result<(), Error> {
        let zero = T::zero();
        let Self { links, relations, gains, matrices, states, parts, .. } = self;
        let place = [ground.place.x, ground.place.y, ground.turn.angle];
        match self.scheme.solver {
            Solver::Product => {
                let base = if S::HELD { Base::Held(place) } else { Base::Free([zero; 3]) };
                product::solve(links, base, matrices, states).map(|_| ())
            }
            Solver::Riccati => {
                let first = bodies(parts).next();
                let last = first.map_or(place, |body| {
                    let [x, y] = body.points[0];
                    [x.value, y.value, clamped_at(parts).unwrap_or(before.turn.angle)]
                });
                let step = core::array::from_fn(|i| place[i] - last[i]);
                let base = if S::HELD { Base::Held(step) } else { Base::Free([zero; 3]) };
                riccati::solve(links, base, relations, gains, states)
            }
        }
    }

    /// Reads the increments of the angles; tells by how much the worst of them misses where it was linearised.
    fn find(&mut self) -> T::Real {
        let absolute = self.scheme.solver == Solver::Product;
        let mut worst = T::Real::zero();
        for (part, z) in self.parts.iter_mut().zip(&self.states) {
            let Part::Body(body) = part else { continue };
            let past = body.angle.value;
            body.found = if absolute { z[THETA] - past } else { z[THETA] };
            let miss = (past + body.found - body.expansion.angle).real().abs();
            // A comparison would lose NaN.
            worst = if miss <= worst { worst } else { miss };
        }
        worst
    }
}

/// The angle at t_{i−1} of a ground that clamps a body, by what the rule made of the body.
fn clamped_at<T: Scalar, M>(parts: &[Part<T, M>]) -> Option<T> {
    match parts {
        [Part::Joint(joint), Part::Body(body), ..] if !joint.turns => Some(body.angle.value - joint.ahead),
        _ => None,
    }
}

fn bodies<T, M>(parts: &[Part<T, M>]) -> impl Iterator<Item = &Body<T, M>> {
    parts.iter().filter_map(|part| if let Part::Body(body) = part { Some(body) } else { None })
}
