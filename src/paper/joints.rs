//! Joint coordinates: only angles are integrated by (1) and (2), positions follow by exact kinematics, and Newton's method solves the
//! step in increments by the same transform.
//!
//! What dies of γ = ½ in the [scheme as printed](super::Scheme) are positions integrated beside the angles that determine them. Here
//! there are none: Newmark's rule with γ = ½ has order 2 in angles and forces and stays.

use super::body::{External, Rigid};
use super::hinge::Rotary;
use super::link::{Base, Link};
use super::parts::{Body, Joint, Part, parts};
use super::riccati::{self, Gain, Relation};
use super::rule::Rule;
use super::scene::{Scene, applied, external};
use super::scheme::positive_step;
use crate::element::Loading;
use crate::error::{Error, Fault};
use crate::planar::index::{M, ONE, QX, QY, THETA, X, Y};
use crate::planar::{BodyMotion, Frame, JointMotion, Planar, SpringState, Turn};
use crate::relation::Term;
use crate::scalar::{Real, Scalar};
use crate::state::{StateVector, TransferMatrix};
use alloc::{vec, vec::Vec};
use num_traits::Zero;

/// A rule in joint coordinates, its equations solved by Newton's method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointScheme<D> {
    rule: D,
    sweeps: Option<usize>,
}

impl<D> JointScheme<D> {
    /// Iterated from θ + θ̇ΔT until the step's equations hold.
    pub fn new(rule: D) -> Self {
        Self { rule, sweeps: None }
    }

    /// With a number of sweeps a step, from θ + θ̇ΔT + θ̈ΔT²/2. One is enough for order 2 where hinges are not stiff.
    #[must_use]
    pub fn with_sweeps(self, sweeps: usize) -> Self {
        Self { sweeps: Some(sweeps.max(1)), ..self }
    }

    /// Starts a run of a scene with steps of `dt` (s).
    ///
    /// # Errors
    /// As [`Scheme::start`](super::Scheme::start).
    pub fn start<'a, T: Scalar, S: Scene<T, L>, L>(
        self,
        scene: &'a S,
        motion: &S::Motion,
        loads: &'a L,
        dt: T::Real,
    ) -> Result<JointRun<'a, T, S, L, D>, Error>
    where
        D: Rule<T>,
    {
        self.rule.check().map_err(Error::new)?;
        positive_step(dt)?;
        let (time, items) = scene.items(motion, loads)?;
        let parts = parts(&self.rule, dt, &items);
        let n = parts.len();
        let blank = StateVector::new([T::zero(); 7]);
        let root = parts.iter().find_map(Part::body).map_or([T::zero(); 2], |body| {
            let [x, y] = body.points[0];
            [x.acceleration, y.acceleration]
        });
        Ok(JointRun {
            scheme: self,
            scene,
            loads,
            dt,
            start: time,
            steps: 0,
            sweeps: 0,
            root,
            motions: Vec::with_capacity(n),
            links: Vec::with_capacity(n),
            relations: vec![Relation::free(); n],
            gains: vec![Gain::blank(); n],
            states: vec![blank; n + 1],
            stations: vec![blank; n + 1],
            parts,
        })
    }
}

/// A run in joint coordinates. It stands at an instant and steps on from there.
#[derive(Clone, Debug)]
pub struct JointRun<'a, T: Scalar, S, L, D: Rule<T>> {
    scheme: JointScheme<D>,
    scene: &'a S,
    loads: &'a L,
    dt: T::Real,
    start: T::Real,
    steps: usize,
    sweeps: usize,
    parts: Vec<Part<T, D::Memory>>,
    /// Acceleration of the root, where nothing holds it.
    root: [T; 2],
    /// The iterate: bodies and their accelerations.
    motions: Vec<BodyMotion<T>>,
    links: Vec<Link<T>>,
    relations: Vec<Relation<T>>,
    gains: Vec<Gain<T>>,
    /// Increments of the iterate.
    states: Vec<StateVector<T, 7>>,
    stations: Vec<StateVector<T, 7>>,
}

impl<T, S, L, D> JointRun<'_, T, S, L, D>
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

    /// Sweeps so far.
    pub fn sweeps(&self) -> usize {
        self.sweeps
    }

    /// Angle, rate and angular acceleration (rad, s) of body `k`, counted from 0 at the root.
    pub fn turn(&self, k: usize) -> Option<[T; 3]> {
        let angle = self.parts.iter().filter_map(Part::body).nth(k)?.angle;
        Some([angle.value, angle.rate, angle.acceleration])
    }

    /// The angles of all bodies (rad), root to tip.
    pub fn angles(&self) -> impl Iterator<Item = T> {
        self.parts.iter().filter_map(Part::body).map(|body| body.angle.value)
    }

    /// States (14) of all stations after a step: the ground's side of the root's joint, the inboard end of each element, the tip. Forces
    /// come from the balance of bodies at the positions, rates and accelerations found.
    pub fn stations(&self) -> &[StateVector<T, 7>] {
        &self.stations
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

    /// One step.
    ///
    /// # Errors
    /// [`Fault::SingularJoint`] with the station, [`Fault::NotConverged`], [`Fault::NonFiniteMotion`]; the run then stands where it stood.
    pub fn step(&mut self) -> Result<(), Error> {
        let span = T::Real::of(self.scheme.rule.balance()) * self.dt;
        let (past, time) = (self.time(), self.time() + span);
        let at_time = |error: Error| error.at_time(time.as_f64());
        let (before, ground) = (self.scene.ground(past), self.scene.ground(time));
        let root = self.root;
        self.guess(span, ground.turn.angle - before.turn.angle);
        let limit = 30;
        for sweep in 1.. {
            self.travel(&ground);
            self.linearise(time, &before, &ground);
            let base = if S::HELD { Base::Held([T::zero(); 3]) } else { Base::Free(self.left()) };
            let change = riccati::solve(&self.links, base, &mut self.relations, &mut self.gains, &mut self.states)
                .map(|()| self.update());
            self.sweeps += 1;
            let refused = match change {
                Err(error) => Some(error),
                Ok(change) if !change.is_finite() => Some(Error::new(Fault::NonFiniteMotion)),
                Ok(change) => match self.scheme.sweeps {
                    Some(wanted) if sweep >= wanted => break,
                    None if change <= T::Real::EPSILON.powf(T::Real::of(2.0 / 3.0)) => break,
                    None if sweep == limit => Some(Error::new(Fault::NotConverged { sweeps: limit })),
                    _ => None,
                },
            };
            if let Some(error) = refused {
                self.root = root;
                return Err(at_time(error));
            }
        }
        self.travel(&ground);
        self.linearise(time, &before, &ground); // for the forces
        self.commit(&before);
        self.steps += 1;
        Ok(())
    }

    /// Where iterations start.
    fn guess(&mut self, span: T::Real, ground: T) {
        let half = if self.scheme.sweeps.is_some() { T::Real::of(0.5) } else { T::Real::zero() };
        let mut inner = ground;
        let mut rigid = true;
        for part in &mut self.parts {
            match part {
                // What is welded turns alike.
                Part::Body(body) => {
                    let angle = body.angle;
                    let free = angle.rate.scale(span).add_scaled(half * span * span, angle.acceleration);
                    body.found = if rigid && S::HELD { inner } else { free };
                    inner = body.found;
                    rigid = true;
                }
                Part::Joint(joint) => rigid &= !joint.turns,
            }
        }
    }

    /// Kinematics, root to tip.
    fn travel(&mut self, ground: &Frame<T>) {
        let (rule, dt) = (self.scheme.rule, self.dt);
        let mut frame = *ground;
        if !S::HELD
            && let Some(body) = self.parts.iter().find_map(Part::body)
        {
            for (i, point) in body.points[0].iter().enumerate() {
                let step = rule.linearize(point, dt);
                let change = (self.root[i] - step.acceleration).scale(step.chi1.recip());
                frame.place[i] = point.value + change;
                frame.velocity[i] = step.rate_at(change);
                frame.acceleration.linear[i] = self.root[i];
            }
        }
        self.motions.clear();
        let mut clamped = S::HELD;
        for part in &self.parts {
            let body = match part {
                Part::Body(body) => body,
                Part::Joint(joint) => {
                    clamped &= !joint.turns;
                    continue;
                }
            };
            let step = rule.linearize(&body.angle, dt);
            frame.turn = Turn { angle: body.angle.value + body.found, rate: step.rate_at(body.found) };
            frame.acceleration.angular = step.acceleration_at(body.found);
            if clamped {
                // A rule would make vibration of a turn that is given.
                (frame.turn.rate, frame.acceleration.angular) = (ground.turn.rate, ground.acceleration.angular);
            }
            let (s, c) = frame.turn.angle.sin_cos();
            let motion = body.rigid.moving(frame, [s, c]);
            self.motions.push(motion);
            frame = motion.outboard();
        }
    }

    /// Forces of the iterate, tip to root, and the links of its increments.
    fn linearise(&mut self, time: T::Real, before: &Frame<T>, ground: &Frame<T>) {
        let gravity = self.scene.gravity();
        let zero = T::zero();
        self.links.clear();
        self.links.resize(self.parts.len(), Link::Rigid(zero));
        let (mut body_number, mut joint_number) = (self.motions.len(), self.parts.len() - self.motions.len());
        let (mut m, mut q) = (zero, [zero; 2]);
        if let Some(last) = self.motions.last() {
            self.stations[self.parts.len()] = state(&last.outboard(), m, q);
        }
        for k in (0..self.parts.len()).rev() {
            match &self.parts[k] {
                Part::Body(body) => {
                    body_number -= 1;
                    let motion = self.motions[body_number];
                    let external = external::<T, L>(&motion, gravity, self.loads.on_body(time, body_number, &motion));
                    let chi = self.scheme.rule.linearize(&body.angle, self.dt);
                    let held = self.torque_inboard(k, joint_number, body_number, time, before, ground);
                    let step = Balance { motion, external, outer: (m, q), held };
                    let (matrix, inner) = step.linearise(&body.rigid, chi.chi1, chi.chi3);
                    (m, q) = inner;
                    self.links[k] = Link::Body { matrix, inertia: T::Real::zero(), percussive: false };
                    self.stations[k] = state(&motion.inboard, m, q);
                }
                Part::Joint(joint) => {
                    joint_number -= 1;
                    let outer = self.motions.get(body_number).map_or(*ground, |motion| motion.inboard);
                    let inner = body_number.checked_sub(1).and_then(|k| self.motions.get(k));
                    let turn = inner.map_or(ground.turn, |motion| motion.inboard.turn);
                    self.stations[k] = state(&Frame { turn, ..outer }, m, q);
                    if joint.turns && (S::HELD || k > 0) {
                        let chi3 = self.parts[joint.outer]
                            .body()
                            .map_or(T::Real::zero(), |body| self.scheme.rule.linearize(&body.angle, self.dt).chi3);
                        let slope = joint.spring.stiffness + joint.spring.damping.scale(chi3);
                        self.links[k] =
                            Link::Turning { law: Rotary { slope, offset: zero }, smooth: joint.is_smooth() };
                    }
                }
            }
        }
    }

    /// m at the inboard end of a body, by the law of the joint there if one turns.
    fn torque_inboard(
        &self,
        k: usize,
        joints: usize,
        bodies: usize,
        time: T::Real,
        before: &Frame<T>,
        ground: &Frame<T>,
    ) -> Option<T> {
        let mut number = joints;
        for part in self.parts[..k].iter().rev() {
            let Part::Joint(joint) = part else { return None };
            number = number.checked_sub(1)?;
            if joint.turns {
                let outer = self.motions.get(bodies)?.inboard;
                let inner = bodies.checked_sub(1).and_then(|k| self.motions.get(k));
                let turn = inner.map_or(ground.turn, |motion| motion.inboard.turn);
                let ahead = ground.turn.angle - before.turn.angle;
                let strain = self.found(Some(joint.outer), ahead) - self.found(joint.inner, ahead);
                let spring = SpringState { torque: T::zero(), energy: T::zero() };
                let motion = JointMotion { inboard: Frame { turn, ..outer }, outboard: outer, spring, turns: true };
                let torque = applied::<T, L>(self.loads.in_joint(time, number, &motion));
                let damping = joint.spring.damping * (outer.turn.rate - turn.rate);
                return Some(joint.elastic + joint.spring.stiffness * strain + damping - torque);
            }
        }
        None
    }

    /// What the iterate leaves at a root that nothing holds: m, q_x, q_y.
    fn left(&self) -> [T; 3] {
        let z = &self.stations[0];
        [z[M], z[QX], z[QY]]
    }

    /// Adds the increments; tells the largest relative one.
    fn update(&mut self) -> T::Real {
        let mut worst = T::Real::zero();
        if !S::HELD {
            self.root[0] += self.states[0][X];
            self.root[1] += self.states[0][Y];
        }
        for (part, z) in self.parts.iter_mut().zip(&self.states) {
            let Part::Body(body) = part else { continue };
            body.found += z[THETA];
            let size = T::Real::of(1.0).max(body.angle.value.real().abs());
            let change = z[THETA].real().abs() / size;
            // A comparison would lose NaN, and so would derivatives that are not finite.
            worst = if change <= worst { worst } else { change };
            if !z[THETA].is_finite() {
                worst = T::Real::INFINITY;
            }
        }
        worst
    }

    fn commit(&mut self, before: &Frame<T>) {
        let (rule, dt) = (self.scheme.rule, self.dt);
        let root = self.root;
        let ground = self.scene.ground(self.time() + dt);
        let (mut first, mut clamped) = (true, S::HELD);
        for part in &mut self.parts {
            let body = match part {
                Part::Body(body) => body,
                Part::Joint(joint) => {
                    clamped &= !joint.turns;
                    continue;
                }
            };
            let last = body.angle.value;
            rule.advance(&mut body.angle, dt, body.found);
            if rule.balance() != 1.0 {
                body.found = body.angle.value - last;
            }
            if clamped {
                (body.angle.rate, body.angle.acceleration) = (ground.turn.rate, ground.acceleration.angular);
            }
            if first && !S::HELD {
                for (point, acceleration) in body.points[0].iter_mut().zip(root) {
                    let step = rule.linearize(point, dt);
                    rule.advance(point, dt, (acceleration - step.acceleration).scale(step.chi1.recip()));
                }
            }
            first = false;
        }
        let ahead = ground.turn.angle - before.turn.angle;
        for k in 0..self.parts.len() {
            let Part::Joint(joint) = self.parts[k] else { continue };
            let strain = self.found(Some(joint.outer), ahead) - self.found(joint.inner, ahead);
            let elastic = joint.elastic + joint.spring.stiffness * strain;
            self.parts[k] = Part::Joint(Joint { elastic, ..joint });
        }
    }

    /// The increment of a body's angle; of the ground's, for no body.
    fn found(&self, at: Option<usize>, ground: T) -> T {
        at.and_then(|k| self.parts.get(k)).and_then(Part::body).map_or(ground, |body| body.found)
    }
}

impl<T, M> Part<T, M> {
    /// The body, if it is one.
    fn body(&self) -> Option<&Body<T, M>> {
        if let Self::Body(body) = self { Some(body) } else { None }
    }
}

fn state<T: Scalar>(frame: &Frame<T>, m: T, [qx, qy]: [T; 2]) -> StateVector<T, 7> {
    StateVector::new([frame.place.x, frame.place.y, frame.turn.angle, m, qx, qy, T::one()])
}

/// The balance of a body in an iterate.
struct Balance<T> {
    motion: BodyMotion<T>,
    external: External<T>,
    /// m and q at the outboard end.
    outer: (T, [T; 2]),
    /// m at the inboard end, where a joint's law gives it.
    held: Option<T>,
}

impl<T: Scalar> Balance<T> {
    /// The matrix of increments (δa_x, δa_y, δθ, δm, δq_x, δq_y, 1), of the same shape as (32), and m and q at the inboard end.
    #[allow(clippy::many_single_char_names)] // the symbols of (19) and (20)
    fn linearise(&self, body: &Rigid<T>, chi1: T::Real, chi3: T::Real) -> (TransferMatrix<T, 7>, (T, [T; 2])) {
        let mass = body.inertia.mass;
        let (o, c) = (self.motion.arm, self.motion.to_centre);
        let (at, centre) = (self.motion.inboard.acceleration, self.motion.centre().acceleration.linear);
        let (a, spin) = (at.linear, self.motion.rate());
        let External { force: [fx, fy], torque } = self.external;
        let (m_o, [qx, qy]) = self.outer;
        let about_inboard = body.about_inboard();

        // (19), (20)
        let q_i = [qx + mass * centre.x - fx, qy + mass * centre.y - fy];
        let balanced = m_o - (o.x * qy - o.y * qx) - mass * (c.x * a.y - c.y * a.x) + torque + (c.x * fy - c.y * fx)
            - about_inboard * at.angular;
        let m_i = self.held.unwrap_or(balanced);
        let residual = balanced - m_i;

        // How a point at d accelerates with δθ: (χ₁ − θ̇²) n − (2θ̇χ₃ + θ̈) d.
        let across = T::constant(chi1) - spin * spin;
        let along = (spin + spin).scale(chi3) + at.angular;
        let swing = |x: T, y: T| [-(across * y) - along * x, across * x - along * y];
        let (w_o, w_c) = (swing(o.x, o.y), swing(c.x, c.y));
        // ∂/∂θ of the torques of forces that stay.
        let geometric =
            o.x * qx + o.y * qy + mass * (c.x * a.x + c.y * a.y) - (c.x * fx + c.y * fy) - about_inboard.scale(chi1);

        let mut u = TransferMatrix::identity();
        (u[(X, THETA)], u[(Y, THETA)]) = (w_o[0], w_o[1]);
        (u[(QX, X)], u[(QY, Y)]) = (-mass, -mass);
        (u[(QX, THETA)], u[(QY, THETA)]) = (-(mass * w_c[0]), -(mass * w_c[1]));
        (u[(M, X)], u[(M, Y)]) = (mass * (o.y - c.y), mass * (c.x - o.x));
        u[(M, THETA)] = o.x * u[(QY, THETA)] - o.y * u[(QX, THETA)] - geometric;
        (u[(M, QX)], u[(M, QY)]) = (-o.y, o.x);
        u[(M, ONE)] = -residual;
        (u, (m_i, q_i))
    }
}
