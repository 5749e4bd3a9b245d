//! An iterate: exact kinematics, forces, and the links of its increments.

use super::JointRun;
use super::balance::Balance;
use crate::paper::expansion::Expansion;
use crate::paper::hinge::Rotary;
use crate::paper::link::Link;
use crate::paper::parts::Part;
use crate::paper::rule::Rule;
use crate::paper::scene::Scene;
use crate::planar::{Frame, Turn};
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

    /// Forces of the iterate, tip to root, and the links of its increments.
    pub(super) fn linearize(&mut self, time: T::Real, before: &Frame<T>, ground: &Frame<T>) {
        let zero = T::zero();
        self.links.clear();
        self.links.resize(self.parts.len(), Link::nothing());
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
                    let external = self.scene.external(self.loads, time, body_number, &motion);
                    let chi = self.scheme.rule.linearize(&body.angles[0], self.dt);
                    let held = self.torque_inboard(k, joint_number, body_number, time, before, ground);
                    let step = Balance { motion, external, outer: (m, q), held };
                    let (matrix, inner) = step.linearize(&body.rigid, chi.chi1, chi.chi3);
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
                            .map_or(T::Real::zero(), |body| self.scheme.rule.linearize(&body.angles[0], self.dt).chi3);
                        let slope = joint.spring.stiffness[0] + joint.spring.damping[0].scale(chi3);
                        self.links[k] =
                            Link::Turning { law: Rotary { slope, offset: zero }.into(), smooth: joint.is_smooth() };
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
                let outer = self.motions.get(bodies)?;
                let inner = bodies.checked_sub(1).and_then(|k| self.motions.get(k));
                let rate = inner.map_or(ground.turn, |motion| motion.inboard.turn).rate;
                let ahead = ground.turn.angle - before.turn.angle;
                let strain = self.found(Some(joint.outer), ahead) - self.found(joint.inner, ahead);
                let [torque] = self.scene.effort(self.loads, time, number, [inner, Some(outer)], ground);
                let damping = joint.spring.damping[0] * (outer.rate() - rate);
                return Some(joint.elastic[0] + joint.spring.stiffness[0] * strain + damping - torque);
            }
        }
        None
    }
}

fn state<T: Scalar>(frame: &Frame<T>, m: T, [qx, qy]: [T; 2]) -> StateVector<T, 7> {
    StateVector::new([frame.place.x, frame.place.y, frame.turn.angle, m, qx, qy, T::one()])
}
