//! The eight steps of section 4: the paper's scheme, in the plane and in space, and how its runs start.

mod ends;
mod failed;
mod form;
mod keep;
mod run;

pub(super) use failed::non_finite_load;
pub use run::Run;

use crate::error::{Error, Fault};
use crate::paper::expansion::At;
use crate::paper::parts::Parts;
use crate::paper::product;
use crate::paper::riccati::{BLOCK, Room};
use crate::paper::rule::Rule;
use crate::paper::scene::{Chain, Scene, Slots};
use crate::scalar::{Real, Scalar};
use crate::simulate::limits;
use crate::state::{StateVector, TransferMatrix};
use crate::time::Control;
use alloc::{vec, vec::Vec};

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
    /// The scheme as printed: linearised at t_{i−1}, solved by the plain product, with angles 1-2-3 in space.
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
    /// refuses, for a run starts from the accelerations of its motion; [`Fault::Unsupported`] for what the paper, or the
    /// [solver](Solver), cannot say.
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
        if self.solver == Solver::Product {
            product::check(&parts, &scene.tip(time, None))?;
        }
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

/// Takes the nearest number of whole steps (s) to a time (s), if that is a time and not too many.
pub(super) fn run_to<Run, R: Real>(
    run: &mut Run,
    (dt, end): (R, R),
    time: fn(&Run) -> R,
    step: fn(&mut Run) -> Result<(), Error>,
) -> Result<(), Error> {
    let start = time(run);
    if end.is_finite() && end <= start {
        return Ok(());
    }
    limits::check([start, end], Control::Fixed(dt), None, None)?;
    while time(run) + R::of(0.5) * dt < end {
        step(run)?;
    }
    Ok(())
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
