//! Step 7: rates from what was found, and what a run keeps of it.

use super::form::Grounds;
use super::{Run, Solver};
use crate::paper::link::Link;
use crate::paper::orient::{Bodies, Expanded, Joints, each};
use crate::paper::parts::{Part, Parts};
use crate::paper::rule::{Coordinate, Rule};
use crate::paper::scene::Scene;
use crate::scalar::{Real, Scalar};
use crate::state::StateVector;
use num_traits::Zero;

impl<T, S, L, D, const N: usize, const H: usize, const P: usize, const A: usize> Run<'_, T, S, L, D, N, H, P, A>
where
    T: Scalar,
    S: Scene<T, L, N, H, P, A>,
    D: Rule<T>,
{
    /// Step 7, in one walk: a body goes on once the stations that read its past are kept.
    pub(super) fn commit(&mut self, grounds: Grounds<T, S::Orient, N, P, A>) {
        let turned = self.ground_turned(grounds[0]);
        let (mut behind, mut joint) = (None, 0);
        for k in 0..=self.parts.len() {
            self.keep_station(k, grounds);
            let ahead = match self.parts.order.get(k) {
                Some(Part::Joint(_)) => continue,
                Some(Part::Body(number)) => Some((k, *number)),
                None => None,
            };
            let Some((k, body)) = core::mem::replace(&mut behind, ahead) else { continue };
            self.advance(k, body);
            // The joints between this body and the one before.
            while self.parts.joints.get(joint).is_some_and(|joint| joint.outer == body) {
                self.strain(joint, turned);
                joint += 1;
            }
        }
    }

    /// Rates and coordinates of a body, part `k` of the chain.
    fn advance(&mut self, k: usize, body: usize) {
        let absolute = self.scheme.solver == Solver::Product;
        let (rule, dt) = (self.scheme.rule, self.dt);
        let whole = rule.balance() == 1.0;
        let changes = self.changes(&self.parts.bodies[body]);
        let (inner, outer) = (&self.states[k], &self.states[k + 1]);
        let body = &mut self.parts.bodies[body];
        body.find(inner, absolute);
        let steps = |z: &StateVector<T, N>, point: &[Coordinate<T, D::Memory>; P]| -> [T; P] {
            core::array::from_fn(|i| if absolute { z[i] - point[i].value } else { z[i] })
        };
        let inboard = steps(inner, &body.points[0]);
        let outboard = steps(outer, &body.points[2]);
        let arms = S::Orient::arms(&body.rigid);
        // (25) in increments
        let psi = body.expansion.psi(arms[0]);
        let centre =
            core::array::from_fn(|i| (0..A).fold(inboard[i], |sum, j| sum + psi[i][j] * body.found[j]) + changes[0][i]);
        for (point, step) in body.points.iter_mut().zip([inboard, centre, outboard]) {
            for (coordinate, step) in point.iter_mut().zip(step) {
                rule.advance(coordinate, dt, step);
            }
        }
        let last = each(&body.angles, |angle| angle.value);
        for (angle, found) in body.angles.iter_mut().zip(body.found) {
            rule.advance(angle, dt, found);
        }
        let angles = each(&body.angles, |angle| angle.value);
        body.defects = core::array::from_fn(|k| {
            if whole {
                return body.expansion.remainder(&body.base, arms[k], &angles);
            }
            // The arm at t_i is what the rule makes of that where forces balance.
            let turned = S::Orient::turned(&body.base, arms[k], &angles);
            core::array::from_fn(|i| body.points[k + 1][i].value - body.points[0][i].value - turned[i])
        });
        if !whole {
            body.found = core::array::from_fn(|i| angles[i] - last[i]);
        }
        body.shown = S::Orient::shown(&body.base, &angles, &body.shown);
        S::Orient::retract(&mut body.base, &mut body.angles);
    }

    /// Strains a joint between two bodies that have gone on.
    fn strain(&mut self, number: usize, ground_turned: [T; A]) {
        let Parts { bodies, joints, .. } = &mut self.parts;
        let joint = &mut joints[number];
        let found = |at: Option<usize>| at.and_then(|k| bodies.get(k)).map_or(ground_turned, |body| body.found);
        let (outer, inner) = (found(Some(joint.outer)), found(joint.inner()));
        for (i, elastic) in joint.elastic.iter_mut().enumerate() {
            *elastic += joint.spring.stiffness[i] * (outer[i] - inner[i]);
        }
        let outer = joint.outer;
        if let Some(springs) = joint.springs {
            // So many joints and bodies come before it.
            self.part_points(springs, number + outer);
        }
    }

    /// Parts the points of joint `k` of the chain by what its linear springs gave.
    #[cold]
    #[inline(never)]
    fn part_points(&mut self, springs: usize, k: usize) {
        let absolute = self.scheme.solver == Solver::Product;
        let (rule, dt) = (self.scheme.rule, self.dt);
        let (inner, outer) = (&self.states[k], &self.states[k + 1]);
        for (i, apart) in self.parts.springs[springs].apart.iter_mut().enumerate() {
            let found = outer[i] - inner[i];
            rule.advance(apart, dt, if absolute { found - apart.value } else { found });
        }
    }

    /// From the outboard point of a joint that begins at station `k` to its inboard one.
    #[cold]
    #[inline(never)]
    fn draw_back(&mut self, k: usize) {
        if let Some(springs) = self.parts.springs_beyond(k) {
            (0..P).for_each(|i| self.stations[k][i] -= springs.apart[i].value);
        }
    }

    /// By how much the ground turns in the step, where angles say it: to t_i, as bodies that have gone on did, wherever forces balance.
    fn ground_turned(&self, before: &<S::Orient as Joints<T, P, A>>::Frame) -> [T; A] {
        let past = S::Orient::angles(before, &[T::zero(); A]);
        let angles = S::Orient::angles(&self.scene.ground(self.time() + self.dt), &past);
        core::array::from_fn(|i| angles[i] - past[i])
    }

    /// A state in absolute coordinates, with angles for a reader; those of t_{i−1} are still there to be added to.
    fn keep_station(&mut self, k: usize, [before, now]: Grounds<T, S::Orient, N, P, A>) {
        let absolute = self.scheme.solver == Solver::Product;
        let Parts { order, bodies, joints, .. } = &self.parts;
        // The body whose angles the station has, and the point that it is.
        let (of, point, at) = match order.get(k) {
            Some(Part::Body(body)) => (Some(*body), *body, 0),
            // What nothing holds has no other side: its own inboard end.
            Some(Part::Joint(0)) if !S::HELD => (Some(joints[0].outer), joints[0].outer, 0),
            Some(Part::Joint(joint)) => (joints[*joint].inner(), joints[*joint].outer, 0),
            None => (bodies.len().checked_sub(1), bodies.len().saturating_sub(1), 2),
        };
        let mut z = self.states[k];
        if let (false, Some(body)) = (absolute, bodies.get(point)) {
            (0..P).for_each(|i| z[i] += body.points[at][i].value);
        }
        let found: [T; A] = core::array::from_fn(|i| z[P + i]);
        let angles = match self.body(of) {
            Some(body) => {
                let past = each(&body.angles, |angle| angle.value);
                let coordinates = if absolute { found } else { core::array::from_fn(|i| past[i] + found[i]) };
                S::Orient::shown(&body.base, &coordinates, &body.shown)
            }
            None if S::HELD => S::Orient::angles(now, &S::Orient::angles(before, &[T::zero(); A])),
            None => found,
        };
        (0..A).for_each(|i| z[P + i] = angles[i]);
        self.stations[k] = z;
        if !absolute && !self.parts.springs.is_empty() {
            self.draw_back(k);
        }
    }

    /// Residual of (32) in the forces at both ends of each body, the largest share of the terms that balance there: what rounding
    /// did to the last solution. It tells of the Riccati transform, in whose increments it is formed. Nothing, where matrices are not
    /// [kept](super::Scheme::keeping_matrices).
    pub fn residual(&self) -> Option<T::Real> {
        if self.links.len() < self.parts.len() {
            return None;
        }
        let mut worst = T::Real::zero();
        for (k, link) in self.links.iter().enumerate() {
            let Link::Body { matrix: u, .. } = link else { continue };
            for row in H..2 * H {
                let (mut sum, mut scale) = (-self.states[k + 1][row], self.states[k + 1][row].real().abs());
                for column in 0..N {
                    let term = u[(row, column)] * self.states[k][column];
                    sum += term;
                    scale += term.real().abs();
                }
                let share = sum.real().abs() / (scale + T::Real::EPSILON);
                worst = if share <= worst { worst } else { share };
            }
        }
        Some(worst)
    }
}
