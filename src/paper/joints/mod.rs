//! Joint coordinates: only angles are integrated by (1) and (2), positions follow by exact kinematics, and Newton's method solves the
//! step in increments by the same transform.
//!
//! What dies of γ = ½ in the [scheme as printed](super::Scheme) are positions integrated beside the angles that determine them. Here
//! there are none: Newmark's rule with γ = ½ has order 2 in angles and forces and stays.

mod balance;
mod iterate;

use crate::error::{Error, Fault, Place};
use crate::mechanics::planar::index::{QX, QY, THETA, X, Y};
use crate::mechanics::planar::{BodyMotion, Frame};
use crate::paper::expansion::Expansion;
use crate::paper::link::{End, Link};
use crate::paper::parts::{Part, Parts};
use crate::paper::riccati::{BLOCK, Room};
use crate::paper::rule::Rule;
use crate::paper::scene::{Chain, Scene, Slots};
use crate::paper::scheme::{positive_step, run_to};
use crate::scalar::{Real, Scalar};
use crate::state::StateVector;
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
    pub fn start<'a, T: Scalar, S: Scene<T, L, 7, 3, 2, 1, Orient = Expansion<T>>, L>(
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
        let Chain { time, items, guide } = scene.chain(motion, loads, Slots::Angles)?;
        if guide.is_some() {
            return Err(
                Error::new(Fault::Unsupported { what: "a root that is guided, in joint coordinates" }).at(Place::Root)
            );
        }
        if scene.tip(time, None).is_held() {
            return Err(
                Error::new(Fault::Unsupported { what: "a tip that is held, in joint coordinates" }).at(Place::Tip)
            );
        }
        let parts = Parts::new(&self.rule, dt, &items);
        if !parts.springs.is_empty() {
            return Err(Error::new(Fault::Unsupported { what: "linear springs, in joint coordinates: take `Scheme`" }));
        }
        let n = parts.len();
        let blank = StateVector::new([T::zero(); 7]);
        let root = parts.bodies.first().map_or([T::zero(); 2], |body| {
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
            links: Vec::with_capacity(n.min(BLOCK)),
            room: Room::new(n, parts.bodies.len(), 0),
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
    parts: Parts<T, D::Memory, Expansion<T>, 7, 2, 1>,
    /// Acceleration of the root, where nothing holds it.
    root: [T; 2],
    /// The iterate: bodies and their accelerations.
    motions: Vec<BodyMotion<T>>,
    links: Vec<Link<T, 7, 2, 1>>,
    room: Room<T, 3, 2, 1>,
    /// Increments of the iterate.
    states: Vec<StateVector<T, 7>>,
    stations: Vec<StateVector<T, 7>>,
}

impl<T, S, L, D> JointRun<'_, T, S, L, D>
where
    T: Scalar,
    S: Scene<T, L, 7, 3, 2, 1, Orient = Expansion<T>>,
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
        let angle = self.parts.bodies.get(k)?.angles[0];
        Some([angle.value, angle.rate, angle.acceleration])
    }

    /// The angles of all bodies (rad), root to tip.
    pub fn angles(&self) -> impl Iterator<Item = T> {
        self.parts.bodies.iter().map(|body| body.angles[0].value)
    }

    /// States (14) of all stations after a step: the ground's side of the root's joint (of a free root the inboard end of the first body),
    /// the inboard end of each element, the tip. Forces come from the balance of bodies at the positions, rates and accelerations found.
    pub fn stations(&self) -> &[StateVector<T, 7>] {
        &self.stations
    }

    /// Steps on to a time (s): the nearest number of whole steps.
    ///
    /// # Errors
    /// As [`step`](Self::step); [`Fault::NotFinite`] for what is no time, [`Fault::OutOfRange`] for more steps than a run
    /// may have, and steps by which time no longer advances.
    pub fn run_to(&mut self, end: T::Real) -> Result<(), Error> {
        run_to(self, (self.dt, end), Self::time, Self::step)
    }

    /// One step.
    ///
    /// # Errors
    /// [`Fault::NonFiniteLoad`] where a load is; else [`Fault::SingularJoint`] with the station, [`Fault::NotConverged`],
    /// [`Fault::NonFiniteMotion`]. The run then stands where it stood.
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
            let change = self.linearize(time, &before, &ground, true).and_then(|()| {
                self.room.outward(&self.root_end(), &mut self.states)?;
                Ok(self.update())
            });
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
                return Err(at_time(self.failed(error, time, &ground)));
            }
        }
        self.travel(&ground);
        self.linearize(time, &before, &ground, false).map_err(at_time)?; // for the forces
        self.commit(&before);
        self.steps += 1;
        Ok(())
    }

    /// Sets the increments with which iterations start.
    fn guess(&mut self, span: T::Real, ground: T) {
        let half = if self.scheme.sweeps.is_some() { T::Real::of(0.5) } else { T::Real::zero() };
        let mut inner = ground;
        let mut rigid = true;
        let Parts { order, bodies, joints, .. } = &mut self.parts;
        for part in order {
            match *part {
                // What is welded turns alike.
                Part::Body(number) => {
                    let body = &mut bodies[number];
                    let angle = body.angles[0];
                    let free = angle.rate.scale(span).add_scaled(half * span * span, angle.acceleration);
                    body.found[0] = if rigid && S::HELD { inner } else { free };
                    inner = body.found[0];
                    rigid = true;
                }
                Part::Joint(number) => rigid &= !joints[number].turns,
            }
        }
    }

    /// What is known of increments at the root. One that nothing holds takes back the force that the iterate leaves there; its torque is
    /// that applied in joint 0 already, for the joint's law says it.
    fn root_end(&self) -> End<T, 3> {
        if S::HELD {
            return End::along_axes([true; 3], [T::zero(); 3]);
        }
        let z = &self.stations[0];
        End::along_axes([false; 3], [-z[QX], -z[QY], T::zero()])
    }

    /// Adds the increments; tells the largest relative one.
    fn update(&mut self) -> T::Real {
        let mut worst = T::Real::zero();
        if !S::HELD {
            self.root[0] += self.states[0][X];
            self.root[1] += self.states[0][Y];
        }
        let Parts { order, bodies, .. } = &mut self.parts;
        for (part, z) in order.iter().zip(&self.states) {
            let Part::Body(number) = *part else { continue };
            let body = &mut bodies[number];
            body.found[0] += z[THETA];
            let size = T::Real::of(1.0).max(body.angles[0].value.real().abs());
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
        let ahead = ground.turn.angle - before.turn.angle;
        let (mut first, mut clamped) = (true, S::HELD);
        let Parts { order, bodies, joints, .. } = &mut self.parts;
        for part in order {
            let body = match *part {
                Part::Body(number) => &mut bodies[number],
                Part::Joint(number) => {
                    clamped &= !joints[number].turns;
                    continue;
                }
            };
            let last = body.angles[0].value;
            rule.advance(&mut body.angles[0], dt, body.found[0]);
            if rule.balance() != 1.0 {
                if clamped {
                    // What the ground holds ends with it, not where the rule leads from the instant of balance.
                    body.angles[0].value = last + ahead;
                }
                body.found[0] = body.angles[0].value - last;
            }
            if clamped {
                (body.angles[0].rate, body.angles[0].acceleration) = (ground.turn.rate, ground.acceleration.angular);
            }
            if first && !S::HELD {
                for (point, acceleration) in body.points[0].iter_mut().zip(root) {
                    let step = rule.linearize(point, dt);
                    rule.advance(point, dt, (acceleration - step.acceleration).scale(step.chi1.recip()));
                }
            }
            first = false;
        }
        for k in 0..self.parts.joints.len() {
            let joint = &self.parts.joints[k];
            let strain = self.found(Some(joint.outer), ahead) - self.found(joint.inner(), ahead);
            let elastic = joint.spring.stiffness[0] * strain;
            self.parts.joints[k].elastic[0] += elastic;
        }
    }

    /// The increment of a body's angle; of the ground's, for no body.
    fn found(&self, at: Option<usize>, ground: T) -> T {
        at.and_then(|k| self.parts.bodies.get(k)).map_or(ground, |body| body.found[0])
    }
}
