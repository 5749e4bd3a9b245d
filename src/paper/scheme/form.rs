//! Steps 3 and 4: what each element is in this step.

use super::{At, Run, Solver};
use crate::element::Loading;
use crate::paper::body::{Known, Rigid, rigid_body};
use crate::paper::expansion::Expansion;
use crate::paper::hinge::Rotary;
use crate::paper::link::Link;
use crate::paper::parts::{Body, Joint, Part, side};
use crate::paper::rule::{Coordinate, Linearization, Rule};
use crate::paper::scene::{Scene, Spring, applied, external};
use crate::planar::{Frame, JointMotion, Planar, SpringState, Turn};
use crate::relation::Term;
use crate::scalar::{Real, Scalar};
use nalgebra::Vector2;

impl<T, S, L, D> Run<'_, T, S, L, D>
where
    T: Scalar,
    S: Scene<T, L>,
    L: Loading<Planar<T>, InJoint: Term<T>>,
    D: Rule<T>,
{
    /// Where each body is linearised first.
    pub(super) fn guess(&mut self, span: T::Real) {
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
    pub(super) fn form(&mut self, span: T::Real, time: T::Real, before: &Frame<T>, ground: &Frame<T>) {
        let absolute = self.scheme.solver == Solver::Product;
        let gravity = self.scene.gravity();
        let (mut body_number, mut joint_number) = (0, 0);
        self.links.clear();
        for part in &self.parts {
            self.links.push(match part {
                Part::Body(body) => {
                    let moving = body.guessed(self.later(body, span), body.expansion.barred, span);
                    let load = self.loads.on_body(&L::unseen(), time, body_number, &moving);
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

    fn chi(&self, coordinate: &Coordinate<T, D::Memory>) -> Linearization<T> {
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
    pub(super) fn changes(&self, body: &Body<T, D::Memory>) -> [[T; 2]; 2] {
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
        let Spring { stiffness, damping, preload } = joint.spring;
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
        let arm = Vector2::new(T::zero(), T::zero());
        let motion = JointMotion { inboard, outboard, arm, spring, turns: true };
        applied::<T, L>(self.loads.in_joint(time, number, &motion))
    }
}

/// The size of the terms of u₄₃ / χ₁: J_I + m |d_C| |d_O|.
fn inertia_scale<T: Scalar>(body: &Rigid<T>) -> T::Real {
    let size = |[x, y]: [T; 2]| x.real().abs() + y.real().abs();
    body.about_inboard().real().abs() + body.inertia.mass.real().abs() * size(body.inertia.centre) * size(body.outboard)
}
