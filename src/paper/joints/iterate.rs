//! An iterate: exact kinematics, forces, and the links of its increments.

use super::JointRun;
use super::balance::Balance;
use crate::error::Error;
use crate::mechanics::planar::{Frame, Turn};
use crate::paper::expansion::Expansion;
use crate::paper::hinge::Rotary;
use crate::paper::link::{End, Link};
use crate::paper::orient::Bodies;
use crate::paper::parts::Part;
use crate::paper::riccati::BLOCK;
use crate::paper::rule::Rule;
use crate::paper::scene::Scene;
use crate::paper::scheme::non_finite_load;
use crate::scalar::Scalar;
use crate::state::StateVector;
use num_traits::Zero;

impl<T, S, L, D> JointRun<'_, T, S, L, D>
where
    T: Scalar,
    S: Scene<T, L, 7, 3, 2, 1, Orient = Expansion<T>>,
    D: Rule<T>,
{
    /// Kinematics, root to tip.
    pub(super) fn travel(&mut self, ground: &Frame<T>) {
        let (rule, dt) = (self.scheme.rule, self.dt);
        let mut frame = *ground;
        if !S::HELD
            && let Some(body) = self.parts.bodies.first()
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
        for part in &self.parts.order {
            let body = match *part {
                Part::Body(number) => &self.parts.bodies[number],
                Part::Joint(number) => {
                    clamped &= !self.parts.joints[number].turns;
                    continue;
                }
            };
            let step = rule.linearize(&body.angles[0], dt);
            frame.turn = Turn { angle: body.angles[0].value + body.found[0], rate: step.rate_at(body.found[0]) };
            frame.acceleration.angular = step.acceleration_at(body.found[0]);
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

    /// Forces of the iterate and the links of its increments, tip to root, block by block. The transform follows where it is to solve.
    ///
    /// # Errors
    /// As [`Room::inward`](crate::paper::riccati::Room::inward).
    pub(super) fn linearize(
        &mut self,
        time: T::Real,
        before: &Frame<T>,
        ground: &Frame<T>,
        solve: bool,
    ) -> Result<(), Error> {
        let n = self.parts.len();
        let mut force = (T::zero(), [T::zero(); 2]);
        if let Some(last) = self.motions.last() {
            self.stations[n] = state(&last.outboard(), force);
        }
        self.room.begin(&End::free());
        let mut end = n;
        while end > 0 {
            let first = end.saturating_sub(BLOCK);
            self.links.clear();
            self.links.resize(end - first, Link::nothing());
            for k in (first..end).rev() {
                force = self.link(k, k - first, force, time, before, ground);
            }
            if solve {
                self.room.inward(first, &self.links)?;
            }
            end = first;
        }
        Ok(())
    }

    /// Why a step failed: the outermost load that is not finite at the iterate; where there is none, the error as it was.
    #[cold]
    pub(super) fn failed(&self, error: Error, time: T::Real, ground: &Frame<T>) -> Error {
        let finite = self.motions.iter().all(|motion| {
            let Frame { place, velocity, turn, .. } = motion.inboard;
            [place.x, place.y, velocity.x, velocity.y, turn.angle, turn.rate].iter().all(|x| x.is_finite())
        });
        if !finite {
            return error; // such a motion breaks loads that are sound
        }
        let broken = |part: &Part| match *part {
            Part::Body(number) => self.motions.get(number).is_some_and(|motion| {
                let external = self.scene.external(self.loads, time, number, motion);
                !<Expansion<T> as Bodies<T, 7, 2, 1>>::is_finite(&external)
            }),
            Part::Joint(number) => self.parts.joints.get(number).is_some_and(|joint| {
                let sides = [joint.inner(), Some(joint.outer)].map(|k| k.and_then(|k| self.motions.get(k)));
                joint.turns && !self.scene.effort(self.loads, time, number, sides, ground, None)[0].is_finite()
            }),
        };
        non_finite_load(&self.parts.order, broken).unwrap_or(error)
    }

    /// Writes part `k`, given m and q at its outboard end, as a link of the block; gives m and q at its inboard end.
    fn link(
        &mut self,
        k: usize,
        at: usize,
        force: (T, [T; 2]),
        time: T::Real,
        before: &Frame<T>,
        ground: &Frame<T>,
    ) -> (T, [T; 2]) {
        match self.parts.order[k] {
            Part::Body(number) => {
                let (body, motion) = (&self.parts.bodies[number], &self.motions[number]);
                let external = self.scene.external(self.loads, time, number, motion);
                let chi = self.scheme.rule.linearize(&body.angles[0], self.dt);
                let held = self.torque_inboard(k, number, time, before, ground);
                let step = Balance { motion: *motion, external, outer: force, held };
                let (matrix, inner) = step.linearize(&body.rigid, chi.chi1, chi.chi3);
                self.stations[k] = state(&motion.inboard, inner);
                self.links[at] = Link::Body { matrix, inertia: T::Real::zero(), percussive: false };
                inner
            }
            Part::Joint(number) => {
                let joint = &self.parts.joints[number];
                let outer = self.motions.get(joint.outer).map_or(*ground, |motion| motion.inboard);
                let inner = joint.inner().and_then(|k| self.motions.get(k));
                // What nothing holds has no other side: its own inboard end.
                let turn = inner.map_or(if S::HELD { ground.turn } else { outer.turn }, |motion| motion.inboard.turn);
                self.stations[k] = state(&Frame { turn, ..outer }, force);
                if joint.turns && (S::HELD || k > 0) {
                    let body = self.parts.bodies.get(joint.outer);
                    let chi3 =
                        body.map_or(T::Real::zero(), |body| self.scheme.rule.linearize(&body.angles[0], self.dt).chi3);
                    let slope = joint.spring.stiffness[0] + joint.spring.damping[0].scale(chi3);
                    let law = Rotary { slope, offset: T::zero() }.into();
                    self.links[at] = Link::Turning { law, smooth: joint.is_smooth() };
                }
                force
            }
        }
    }

    /// m at the inboard end of a body, by the law of the joint there if one turns.
    fn torque_inboard(&self, k: usize, body: usize, time: T::Real, before: &Frame<T>, ground: &Frame<T>) -> Option<T> {
        for part in self.parts.order[..k].iter().rev() {
            let Part::Joint(number) = *part else { return None };
            let joint = &self.parts.joints[number];
            if joint.turns {
                let outer = self.motions.get(body)?;
                let inner = joint.inner().and_then(|k| self.motions.get(k));
                let rate = inner.map_or(ground.turn, |motion| motion.inboard.turn).rate;
                let ahead = ground.turn.angle - before.turn.angle;
                let strain = self.found(Some(joint.outer), ahead) - self.found(joint.inner(), ahead);
                let [torque] = self.scene.effort(self.loads, time, number, [inner, Some(outer)], ground, None);
                let damping = joint.spring.damping[0] * (outer.rate() - rate);
                return Some(joint.elastic[0] + joint.spring.stiffness[0] * strain + damping - torque);
            }
        }
        None
    }
}

fn state<T: Scalar>(frame: &Frame<T>, (m, [qx, qy]): (T, [T; 2])) -> StateVector<T, 7> {
    StateVector::new([frame.place.x, frame.place.y, frame.turn.angle, m, qx, qy, T::one()])
}
