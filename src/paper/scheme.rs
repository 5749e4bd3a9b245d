//! The eight steps of section 4: a run of the paper's scheme.

use super::body::{Known, Rigid, rigid_body};
use super::expansion::{At, Expansion};
use super::hinge::Rotary;
use super::link::{Base, Link};
use super::parts::{Body, Joint, Part, Point, parts, side};
use super::riccati::{Gain, Relation};
use super::rule::{Linearization, Rule};
use super::scene::{Scene, applied, external};
use super::{product, riccati};
use crate::element::Loading;
use crate::error::{Error, Fault};
use crate::planar::index::{M, QX, QY, THETA, X, Y};
use crate::planar::{Frame, JointMotion, Planar, SpringState, Turn};
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

    /// Where each body is linearised first.
    fn guess(&mut self, span: T::Real) {
        for part in &mut self.parts {
            let Part::Body(body) = part else { continue };
            let angle = body.angle;
            let ahead = angle.rate.scale(span).add_scaled(T::Real::of(0.5) * span * span, angle.acceleration);
            body.found = ahead;
            body.expansion = match self.scheme.at {
                At::Previous => Expansion::printed(angle.value, angle.rate, angle.acceleration, span),
                At::Predictor | At::Iterated => Expansion::about(angle.value + ahead),
            };
        }
    }

    /// Steps 3 and 4: χ₁ to χ₄, c̄ and s̄, and what each element is in this step.
    fn form(&mut self, span: T::Real, time: T::Real, before: &Frame<T>, ground: &Frame<T>) {
        let absolute = self.scheme.solver == Solver::Product;
        let gravity = self.scene.gravity();
        let (mut body_number, mut joint_number) = (0, 0);
        self.links.clear();
        for part in &self.parts {
            self.links.push(match part {
                Part::Body(body) => {
                    let moving = body.guessed(self.later(body, span), body.expansion.barred, span);
                    let load = self.loads.on_body(time, body_number, &moving);
                    body_number += 1;
                    let external = external::<T, L>(&moving, gravity, load);
                    let chi1 = self.chi(&body.angle).chi1;
                    let known = if absolute { self.known_absolute(body) } else { self.known(body) };
                    Link::Body {
                        matrix: rigid_body(&body.rigid, &body.expansion, chi1, &known, &external),
                        inertia: inertia_scale(&body.rigid) * chi1,
                        percussive: body.percussive,
                    }
                }
                Part::Joint(joint) => {
                    let number = joint_number;
                    joint_number += 1;
                    if !joint.turns || !(S::HELD || number > 0) {
                        Link::Rigid(if absolute && !joint.turns { joint.ahead } else { T::zero() })
                    } else {
                        let torque = self.torque_in(joint, number, span, time, ground);
                        Link::Turning {
                            law: self.law(joint, torque, absolute, before, ground),
                            smooth: joint.is_smooth(),
                        }
                    }
                }
            });
        }
    }

    fn chi(&self, coordinate: &super::rule::Coordinate<T, D::Memory>) -> Linearization<T> {
        self.scheme.rule.linearize(coordinate, self.dt)
    }

    /// How a body turns at the guess: for loads that depend on the motion.
    fn later(&self, body: &Body<T, D::Memory>, span: T::Real) -> Turn<T> {
        let rate = body.angle.rate.add_scaled(span, body.angle.acceleration);
        Turn { angle: body.angle.value + body.found, rate }
    }

    /// The last column of (32) in absolute coordinates.
    fn known_absolute(&self, body: &Body<T, D::Memory>) -> Known<T> {
        let [[xi, yi], [xc, yc], _] = body.points.map(|point| point.map(|c| self.chi(&c).chi2()));
        Known::absolute(&body.rigid, &body.expansion, [xi, yi, xc, yc, self.chi(&body.angle).chi2()])
    }

    /// The same in increments, where r_O − r_I = (7) r_{2,O} of this step less that carried from the last one.
    fn known(&self, body: &Body<T, D::Memory>) -> Known<T> {
        let [inboard, centre, _] = body.points.map(|point| point.map(|c| self.chi(&c).acceleration));
        let [to_centre, to_outboard] = self.changes(body);
        Known { inboard, centre, angle: self.chi(&body.angle).acceleration, to_outboard, to_centre }
    }

    /// How the arms to mass centre and outboard end would change if no coordinate did.
    fn changes(&self, body: &Body<T, D::Memory>) -> [[T; 2]; 2] {
        let arms = [body.rigid.inertia.centre, body.rigid.outboard];
        core::array::from_fn(|k| {
            let [x, y] = body.expansion.remainder(arms[k], body.angle.value);
            [x - body.defects[k][0], y - body.defects[k][1]]
        })
    }

    /// (34) of a joint in this step.
    fn law(&self, joint: &Joint<T>, torque: T, absolute: bool, before: &Frame<T>, ground: &Frame<T>) -> Rotary<T> {
        let known = (before.turn.angle, ground.turn);
        let sides = [joint.inner, Some(joint.outer)].map(|k| side(&self.scheme.rule, self.dt, &self.parts, k, known));
        let [inner, outer] = sides;
        let super::scene::Spring { stiffness, damping, preload } = joint.spring;
        let offset = if absolute {
            damping * (outer.chi4() - inner.chi4()) - preload
        } else {
            damping * (outer.rate - inner.rate) + joint.elastic
        };
        Rotary { slope: stiffness + damping.scale(outer.chi3), offset: offset - torque }
    }

    /// The torque applied in a joint, ON the outboard body.
    fn torque_in(&self, joint: &Joint<T>, number: usize, span: T::Real, time: T::Real, ground: &Frame<T>) -> T {
        if !L::ON {
            return T::zero();
        }
        let body = |k: usize| match self.parts.get(k) {
            Some(Part::Body(body)) => Some(body.guessed(self.later(body, span), body.expansion.barred, span)),
            _ => None,
        };
        let outboard = body(joint.outer).map_or(*ground, |body| body.inboard);
        let inner = joint.inner.and_then(body).map_or(ground.turn, |body| body.inboard.turn);
        let inboard = Frame { turn: inner, ..outboard };
        let spring = SpringState { torque: T::zero(), energy: T::zero() };
        let motion = JointMotion { inboard, outboard, spring, turns: true };
        applied::<T, L>(self.loads.in_joint(time, number, &motion))
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

    /// Step 7.
    fn commit(&mut self, before: &Frame<T>) {
        self.keep_stations(before);
        let absolute = self.scheme.solver == Solver::Product;
        let (rule, dt) = (self.scheme.rule, self.dt);
        let whole = rule.balance() == 1.0;
        for k in 0..self.parts.len() {
            let changes = match &self.parts[k] {
                Part::Body(body) => self.changes(body),
                Part::Joint(_) => continue,
            };
            let (inner, outer) = (self.states[k], self.states[k + 1]);
            let Part::Body(body) = &mut self.parts[k] else { continue };
            let steps = |z: &StateVector<T, 7>, [x, y]: &Point<T, D::Memory>| {
                if absolute { [z[X] - x.value, z[Y] - y.value] } else { [z[X], z[Y]] }
            };
            let inboard = steps(&inner, &body.points[0]);
            let outboard = steps(&outer, &body.points[2]);
            // (25) in increments
            let [cx, cy] = body.expansion.turned(body.rigid.inertia.centre);
            let centre = [inboard[0] - cy * body.found + changes[0][0], inboard[1] + cx * body.found + changes[0][1]];
            for (point, step) in body.points.iter_mut().zip([inboard, centre, outboard]) {
                for (coordinate, step) in point.iter_mut().zip(step) {
                    rule.advance(coordinate, dt, step);
                }
            }
            let last = body.angle.value;
            rule.advance(&mut body.angle, dt, body.found);
            let arms = [body.rigid.inertia.centre, body.rigid.outboard];
            body.defects = core::array::from_fn(|k| {
                if whole {
                    return body.expansion.remainder(arms[k], body.angle.value);
                }
                // The arm at t_i is what the rule makes of that where forces balance.
                let [x, y] = Expansion::about(body.angle.value).turned(arms[k]);
                let [[xi, yi], [xk, yk]] = [body.points[0], body.points[k + 1]].map(|point| point.map(|c| c.value));
                [xk - xi - x, yk - yi - y]
            });
            if !whole {
                body.found = body.angle.value - last;
            }
        }
        let turned = self.scene.ground(self.time() + dt).turn.angle - before.turn.angle;
        for k in 0..self.parts.len() {
            let Part::Joint(joint) = self.parts[k] else { continue };
            let strain = self.found(Some(joint.outer), turned) - self.found(joint.inner, turned);
            let elastic = joint.elastic + joint.spring.stiffness * strain;
            self.parts[k] = Part::Joint(Joint { elastic, ..joint });
        }
    }

    /// By how much a body turned in this step; the ground, for no body.
    fn found(&self, at: Option<usize>, ground: T) -> T {
        match at.and_then(|k| self.parts.get(k)) {
            Some(Part::Body(body)) => body.found,
            _ => ground,
        }
    }

    /// The states in absolute coordinates; those of t_{i−1} are still there to be added to.
    fn keep_stations(&mut self, before: &Frame<T>) {
        self.stations.copy_from_slice(&self.states);
        if self.scheme.solver == Solver::Product {
            return;
        }
        let place = |point: &Point<T, D::Memory>| [point[0].value, point[1].value];
        let body = |k: usize| if let Some(Part::Body(body)) = self.parts.get(k) { Some(body) } else { None };
        let last = self.parts.len() - 1;
        for (k, z) in self.stations.iter_mut().enumerate() {
            let ([x, y], angle) = match self.parts.get(k) {
                Some(Part::Body(body)) => (place(&body.points[0]), body.angle.value),
                Some(Part::Joint(joint)) => (
                    body(joint.outer).map_or([T::zero(); 2], |body| place(&body.points[0])),
                    joint.inner.and_then(body).map_or(before.turn.angle, |body| body.angle.value),
                ),
                None => match body(last) {
                    Some(body) => (place(&body.points[2]), body.angle.value),
                    None => continue,
                },
            };
            z[X] += x;
            z[Y] += y;
            z[THETA] += angle;
        }
    }

    /// By how much the forces at both ends of each body miss (32), the largest share of the terms that balance there: what rounding
    /// did to the last solution. It tells of the Riccati transform, in whose increments it is formed.
    pub fn residual(&self) -> T::Real {
        let mut worst = T::Real::zero();
        for (k, link) in self.links.iter().enumerate() {
            let Link::Body { matrix: u, .. } = link else { continue };
            for row in [M, QX, QY] {
                let (mut sum, mut scale) = (-self.states[k + 1][row], self.states[k + 1][row].real().abs());
                for column in 0..7 {
                    let term = u[(row, column)] * self.states[k][column];
                    sum += term;
                    scale += term.real().abs();
                }
                let share = sum.real().abs() / (scale + T::Real::EPSILON);
                worst = if share <= worst { worst } else { share };
            }
        }
        worst
    }
}

/// The size of the terms of u₄₃ / χ₁: J_I + m |d_C| |d_O|.
fn inertia_scale<T: Scalar>(body: &Rigid<T>) -> T::Real {
    let size = |[x, y]: [T; 2]| x.real().abs() + y.real().abs();
    body.about_inboard().real().abs() + body.inertia.mass.real().abs() * size(body.inertia.centre) * size(body.outboard)
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
