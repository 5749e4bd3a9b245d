//! The eight steps of section 4: a run of the paper's scheme, in the plane and in space.

mod ends;
mod form;
mod keep;

use crate::error::{Error, Fault};
use crate::paper::expansion::At;
use crate::paper::link::Link;
use crate::paper::orient::Orient;
use crate::paper::parts::{Body, Part, Parts};
use crate::paper::product;
use crate::paper::riccati::{BLOCK, Room};
use crate::paper::rule::Rule;
use crate::paper::scene::{Chain, Scene, Slots};
use crate::scalar::{Real, Scalar};
use crate::state::{StateVector, TransferMatrix};
use alloc::{vec, vec::Vec};
use form::Grounds;
use num_traits::Zero;

/// How the overall equation is solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Solver {
    /// By the plain product of matrices in absolute coordinates, (16) and (17), as printed: for short chains.
    #[default]
    Product,
    /// By the Riccati transform of section 5.5, in increments: for chains of any length.
    ///
    /// S of f = S p + e is not symmetric at displacement level and is kept whole: in the plane (32) mixes c̄, s̄ with c, s; in space torques
    /// ω × Jω enter by χ₃, and 1-2-3 angles are not conjugate to torques about inertial axes.
    Riccati,
}

/// The scheme of the paper: a rule, where it is linearised, and how it is solved. As printed unless told otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scheme<D> {
    rule: D,
    at: At,
    solver: Solver,
    slots: Slots,
    keeps: bool,
}

impl<D> Scheme<D> {
    /// As printed: linearised at t_{i−1}, solved by the plain product, with angles 1-2-3 in space.
    pub fn new(rule: D) -> Self {
        Self { rule, at: At::Previous, solver: Solver::Product, slots: Slots::Angles, keeps: false }
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

    /// With other coordinates in the slot of the angles, which matters in space.
    #[must_use]
    pub fn turning_by(self, slots: Slots) -> Self {
        Self { slots, ..self }
    }

    /// Keeps all matrices of a step, from which [`Run::residual`] is formed. Else the transform forms each where it is needed, and a long
    /// chain takes half the memory.
    #[must_use]
    pub fn keeping_matrices(self) -> Self {
        Self { keeps: true, ..self }
    }

    /// Steps 1 and 2: starts a run of a scene with steps of `dt` (s).
    ///
    /// # Errors
    /// What is wrong with the rule or the step; what [`System::with_accelerations`](crate::system::System::with_accelerations)
    /// refuses, for a run starts from the accelerations of its motion; [`Fault::Unsupported`] for what the paper cannot say.
    pub fn start<'a, T, S, L, const N: usize, const H: usize, const P: usize, const A: usize>(
        self,
        scene: &'a S,
        motion: &S::Motion,
        loads: &'a L,
        dt: T::Real,
    ) -> Result<Run<'a, T, S, L, D, N, H, P, A>, Error>
    where
        T: Scalar,
        S: Scene<T, L, N, H, P, A>,
        D: Rule<T>,
    {
        self.rule.check().map_err(Error::new)?;
        positive_step(dt)?;
        let Chain { time, items, guide } = scene.chain(motion, loads, self.slots)?;
        let parts = Parts::new(&self.rule, dt, &items);
        let blank = StateVector::new([T::zero(); N]);
        let n = parts.len();
        Ok(Run {
            scheme: self,
            scene,
            loads,
            dt,
            start: time,
            steps: 0,
            guide,
            drive: [T::zero(); A],
            links: Vec::with_capacity(if self.keeps { n } else { n.min(BLOCK) }),
            room: if self.solver == Solver::Riccati {
                Room::new(n, parts.bodies.len(), parts.springs.len())
            } else {
                Room::new(0, 0, 0)
            },
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
pub struct Run<'a, T, S, L, D, const N: usize, const H: usize, const P: usize, const A: usize>
where
    T: Scalar,
    S: Scene<T, L, N, H, P, A>,
    D: Rule<T>,
{
    scheme: Scheme<D>,
    scene: &'a S,
    loads: &'a L,
    dt: T::Real,
    start: T::Real,
    steps: usize,
    guide: Option<[T; P]>,
    /// The torque applied in the root's joint.
    drive: [T; A],
    parts: Parts<T, D::Memory, S::Orient, N, P, A>,
    /// Those formed last: a block of them, or all.
    links: Vec<Link<T, N, P, A>>,
    room: Room<T, H, P, A>,
    matrices: Vec<TransferMatrix<T, N>>,
    /// As solved: absolute, or in increments.
    states: Vec<StateVector<T, N>>,
    /// Absolute.
    stations: Vec<StateVector<T, N>>,
    sweeps: usize,
}

impl<T, S, L, D, const N: usize, const H: usize, const P: usize, const A: usize> Run<'_, T, S, L, D, N, H, P, A>
where
    T: Scalar,
    S: Scene<T, L, N, H, P, A>,
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

    /// The angles (rad) of body `k`, counted from 0 at the root: one in the plane; in space those of section 2.1, followed from step to
    /// step and not wrapped.
    pub fn attitude(&self, k: usize) -> Option<[T; A]> {
        self.parts.bodies.get(k).map(|body| body.shown)
    }

    /// States (14), (13) of all stations after a step: the ground's side of the root's joint, the inboard end of each element, the tip.
    pub fn stations(&self) -> &[StateVector<T, N>] {
        &self.stations
    }

    /// The matrices of the last step, as multiplied: those of (17), root to tip, after one for the root's joint that is not used. Empty
    /// where no product is formed.
    pub fn matrices(&self) -> &[TransferMatrix<T, N>] {
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
    /// [`Fault::CentreOfPercussion`], [`Fault::SingularAngles`] or [`Fault::SingularJoint`] with the station, [`Fault::NotConverged`],
    /// [`Fault::NonFiniteMotion`] where a run breaks down; the run then stands where it stood.
    pub fn step(&mut self) -> Result<(), Error> {
        let span = T::Real::of(self.scheme.rule.balance()) * self.dt;
        let (past, time) = (self.time(), self.time() + span);
        let at_time = |error: Error| error.at_time(time.as_f64());
        let (before, now) = (self.scene.ground(past), self.scene.ground(time));
        let grounds = [&before, &now];
        let mut holds = false;
        for sweep in 0.. {
            self.solve(sweep, span, time, grounds).map_err(at_time)?;
            self.sweeps += 1;
            // A last sweep, once the equations hold, brings derivatives as far as values.
            if self.scheme.at != At::Iterated || holds {
                break;
            }
            holds = self.miss() <= T::Real::EPSILON.powf(T::Real::of(0.75));
            if !holds && sweep == 30 {
                return Err(at_time(Error::new(Fault::NotConverged { sweeps: 30 })));
            }
        }
        self.commit(grounds);
        self.steps += 1;
        Ok(())
    }

    /// Steps 3 to 6. The transform forms links on its way inward, block by block.
    fn solve(
        &mut self,
        sweep: usize,
        span: T::Real,
        time: T::Real,
        grounds: Grounds<T, S::Orient, N, P, A>,
    ) -> Result<(), Error> {
        let n = self.parts.len();
        let mut tip = self.tip_end(time);
        let product = self.scheme.solver == Solver::Product;
        let again = product || tip.is_held(); // links are read again
        let size = if again || self.scheme.keeps { n } else { BLOCK };
        self.room.begin(&tip);
        let mut end = n;
        while end > 0 {
            let first = end.saturating_sub(size);
            self.guess(first..end, sweep, span);
            self.form(first..end, span, time, grounds)?;
            if !again {
                self.room.inward(first, &self.links)?;
            }
            end = first;
        }
        if again && S::ATTITUDES[1] {
            tip = self.tip_end(time); // of where the last body is linearised
        }
        let root = self.root_end(grounds);
        let Self { links, room, matrices, states, .. } = self;
        match again {
            true if product => product::solve::<S::Orient, T, N, H, P, A>(links, [&root, &tip], matrices, states),
            true => room.solve(links, [&root, &tip], states),
            false => room.outward(&root, states).map(|_| ()),
        }
    }

    /// By how much the worst body misses where it was linearised (rad).
    fn miss(&mut self) -> T::Real {
        let absolute = self.scheme.solver == Solver::Product;
        let Parts { order, bodies, .. } = &mut self.parts;
        let mut worst = T::Real::zero();
        for (part, z) in order.iter().zip(&self.states) {
            if let Part::Body(number) = *part {
                let body = &mut bodies[number];
                body.find(z, absolute);
                let miss = body.expansion.miss(&core::array::from_fn(|i| body.angles[i].value + body.found[i]));
                worst = worst.max(miss);
            }
        }
        worst
    }
}

impl<T, S, L, D> Run<'_, T, S, L, D, 7, 3, 2, 1>
where
    T: Scalar,
    S: Scene<T, L, 7, 3, 2, 1>,
    D: Rule<T>,
{
    /// Angle, rate and angular acceleration (rad, s) of body `k`, counted from 0 at the root.
    pub fn turn(&self, k: usize) -> Option<[T; 3]> {
        self.turns().nth(k)
    }

    /// The same of all bodies, root to tip.
    pub fn turns(&self) -> impl Iterator<Item = [T; 3]> {
        self.parts.bodies.iter().map(|Body { angles: [angle], .. }| [angle.value, angle.rate, angle.acceleration])
    }

    /// The angles of all bodies (rad), root to tip.
    pub fn angles(&self) -> impl Iterator<Item = T> {
        self.turns().map(|[angle, ..]| angle)
    }
}
