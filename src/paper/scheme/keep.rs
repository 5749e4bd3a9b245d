//! Step 7: rates from what was found, and what a run keeps of it.

use super::{Run, Solver};
use crate::element::Loading;
use crate::paper::expansion::Expansion;
use crate::paper::link::Link;
use crate::paper::parts::{Joint, Part, Point};
use crate::paper::rule::Rule;
use crate::paper::scene::Scene;
use crate::planar::index::{M, QX, QY, THETA, X, Y};
use crate::planar::{Frame, Planar};
use crate::relation::Term;
use crate::scalar::{Real, Scalar};
use crate::state::StateVector;
use num_traits::Zero;

impl<T, S, L, D> Run<'_, T, S, L, D>
where
    T: Scalar,
    S: Scene<T, L>,
    L: Loading<Planar<T>, InJoint: Term<T>>,
    D: Rule<T>,
{
    /// Step 7.
    pub(super) fn commit(&mut self, before: &Frame<T>) {
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
