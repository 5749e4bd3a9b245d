//! A run under way: steps 3 to 8.

use super::form::Grounds;
use super::{Scheme, Solver, run_to};
use crate::error::{Error, Fault};
use crate::paper::expansion::At;
use crate::paper::link::Link;
use crate::paper::orient::Expanded;
use crate::paper::parts::{Body, Part, Parts};
use crate::paper::product;
use crate::paper::riccati::{BLOCK, Room};
use crate::paper::rule::Rule;
use crate::paper::scene::{Scene, Slots};
use crate::scalar::{Real, Scalar};
use crate::state::{StateVector, TransferMatrix};
use alloc::vec::Vec;
use num_traits::Zero;

/// A run of the scheme. It stands at an instant and steps on from there.
#[derive(Clone, Debug)]
pub struct Run<'a, T, S, L, D, const N: usize, const H: usize, const P: usize, const A: usize>
where
    T: Scalar,
    S: Scene<T, L, N, H, P, A>,
    D: Rule<T>,
{
    pub(super) scheme: Scheme<D>,
    pub(super) scene: &'a S,
    pub(super) loads: &'a L,
    pub(super) dt: T::Real,
    pub(super) start: T::Real,
    pub(super) steps: usize,
    pub(super) guide: Option<[T; P]>,
    /// The torque applied in the root's joint.
    pub(super) drive: [T; A],
    pub(super) parts: Parts<T, D::Memory, S::Orient, N, P, A>,
    /// Links formed last: a block of them, or all.
    pub(super) links: Vec<Link<T, N, P, A>>,
    pub(super) room: Room<T, H, P, A>,
    pub(super) matrices: Vec<TransferMatrix<T, N>>,
    /// States as solved: absolute, or in increments.
    pub(super) states: Vec<StateVector<T, N>>,
    /// Absolute states.
    pub(super) stations: Vec<StateVector<T, N>>,
    pub(super) sweeps: usize,
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
    /// Boundary conditions stand for the joint of a root that is guided or free: there the first is the inboard end of the first element.
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
    /// As [`step`](Self::step); [`Fault::NotFinite`] for what is no time, [`Fault::OutOfRange`] for more steps than a run
    /// may have, and steps by which time no longer advances.
    pub fn run_to(&mut self, end: T::Real) -> Result<(), Error> {
        run_to(self, (self.dt, end), Self::time, Self::step)
    }

    /// Steps 3 to 8.
    ///
    /// # Errors
    /// [`Fault::NonFiniteLoad`] where a load is; else [`Fault::CentreOfPercussion`], [`Fault::SingularAngles`] or [`Fault::SingularJoint`]
    /// with the station, [`Fault::SingularTransfer`] with the end whose equations have no solution, [`Fault::NotConverged`], and
    /// [`Fault::NonFiniteMotion`] where a run breaks down. The run then stands where it stood.
    pub fn step(&mut self) -> Result<(), Error> {
        let span = T::Real::of(self.scheme.rule.balance()) * self.dt;
        let (past, time) = (self.time(), self.time() + span);
        let at_time = |error: Error| error.at_time(time.as_f64());
        let (before, now) = (self.scene.ground(past), self.scene.ground(time));
        let grounds = [&before, &now];
        let mut holds = false;
        for sweep in 0.. {
            self.solve(sweep, span, time, grounds).map_err(|error| at_time(self.failed(error, span, time, &now)))?;
            self.sweeps += 1;
            // A last sweep, once the equations hold, brings derivatives as far as values.
            if self.scheme.at != At::Iterated || holds {
                break;
            }
            holds = self.linearization_residual() <= T::Real::EPSILON.powf(T::Real::of(0.75));
            if !holds && sweep == 30 {
                return Err(at_time(Error::new(Fault::NotConverged { sweeps: 30 })));
            }
        }
        self.follow().map_err(at_time)?;
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

    /// Refuses increments that the coordinates of orientations do not follow.
    fn follow(&mut self) -> Result<(), Error> {
        if !S::Orient::SINGULAR || self.scheme.slots != Slots::Angles {
            return Ok(());
        }
        let absolute = self.scheme.solver == Solver::Product;
        let Parts { order, bodies, .. } = &mut self.parts;
        for (k, (part, z)) in order.iter().zip(&self.states).enumerate() {
            if let Part::Body(number) = *part {
                let body = &mut bodies[number];
                body.find(z, absolute);
                let past = body.angles.each_ref().map(|angle| angle.value);
                let at_station = |fault| Error::new(fault).at_station(k.saturating_sub(1));
                S::Orient::follow(&past, &body.found).map_err(at_station)?;
            }
        }
        Ok(())
    }

    /// The largest residual of a linearisation: by how much a body misses where it was taken (rad).
    fn linearization_residual(&mut self) -> T::Real {
        let absolute = self.scheme.solver == Solver::Product;
        let Parts { order, bodies, .. } = &mut self.parts;
        let mut worst = T::Real::zero();
        for (part, z) in order.iter().zip(&self.states) {
            if let Part::Body(number) = *part {
                let body = &mut bodies[number];
                body.find(z, absolute);
                let residual = body.expansion.residual(&core::array::from_fn(|i| body.angles[i].value + body.found[i]));
                worst = worst.max(residual);
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

    /// Angles, rates and angular accelerations (rad, s) of all bodies, root to tip.
    pub fn turns(&self) -> impl Iterator<Item = [T; 3]> {
        self.parts.bodies.iter().map(|Body { angles: [angle], .. }| [angle.value, angle.rate, angle.acceleration])
    }

    /// The angles of all bodies (rad), root to tip.
    pub fn angles(&self) -> impl Iterator<Item = T> {
        self.turns().map(|[angle, ..]| angle)
    }
}
