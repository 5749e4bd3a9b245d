//! Steps 3 and 4: what each element is in this step.

use super::{Run, Solver};
use crate::error::Error;
use crate::paper::link::{End, Given, Law, Link};
use crate::paper::orient::{Orient, Side, each};
use crate::paper::parts::{Body, Joint, Part};
use crate::paper::rule::{Coordinate, Linearization, Rule};
use crate::paper::scene::Scene;
use crate::scalar::Scalar;

/// The ground at t_{i−1} and where forces balance.
pub(super) type Grounds<'g, T, E, const N: usize, const P: usize, const A: usize> =
    [&'g <E as Orient<T, N, P, A>>::Frame; 2];

impl<T, S, L, D, const N: usize, const H: usize, const P: usize, const A: usize> Run<'_, T, S, L, D, N, H, P, A>
where
    T: Scalar,
    S: Scene<T, L, N, H, P, A>,
    D: Rule<T>,
{
    /// Where each body is linearised first.
    pub(super) fn guess(&mut self, span: T::Real) {
        let (rule, dt, at) = (self.scheme.rule, self.dt, self.scheme.at);
        for part in &mut self.parts {
            let Part::Body(body) = part else { continue };
            let past = each(&body.angles, |angle| [angle.value, angle.rate, angle.acceleration]);
            let steps = each(&body.angles, |angle| rule.linearize(angle, dt));
            (body.expansion, body.found) = S::Orient::first(at, &body.base, &past, &steps, span);
        }
    }

    /// Where they are linearised next.
    pub(super) fn guess_again(&mut self) {
        let (rule, dt) = (self.scheme.rule, self.dt);
        for part in &mut self.parts {
            let Part::Body(body) = part else { continue };
            let steps = each(&body.angles, |angle| rule.linearize(angle, dt));
            body.expansion = S::Orient::again(&body.base, &steps, &body.found);
        }
    }

    /// Steps 3 and 4: χ₁ to χ₄, c̄ and s̄, and what each element is in this step.
    pub(super) fn form(
        &mut self,
        span: T::Real,
        time: T::Real,
        grounds: Grounds<T, S::Orient, N, P, A>,
    ) -> Result<(), Error> {
        let absolute = self.scheme.solver == Solver::Product;
        let (mut body_number, mut joint_number) = (0, 0);
        self.links.clear();
        self.drive = [T::zero(); A];
        for (k, part) in self.parts.iter().enumerate() {
            self.links.push(match part {
                Part::Body(body) => {
                    body.expansion.check().map_err(|fault| Error::new(fault).at_station(k.saturating_sub(1)))?;
                    let external = self.scene.external(self.loads, time, body_number, &body.guessed(span));
                    body_number += 1;
                    let step = self.chi(&body.angles[0]);
                    let given = if absolute { self.given_absolute(body) } else { self.given(body) };
                    Link::Body {
                        matrix: body.expansion.matrix(&body.rigid, &step, &given, &external),
                        inertia: S::Orient::inertia(&body.rigid) * step.chi1,
                        percussive: body.percussive,
                    }
                }
                Part::Joint(joint) => {
                    let number = joint_number;
                    joint_number += 1;
                    let torque = if joint.turns {
                        let sides =
                            [joint.inner, Some(joint.outer)].map(|k| self.body(k).map(|body| body.guessed(span)));
                        let [inner, outer] = &sides;
                        self.scene.effort(self.loads, time, number, [inner.as_ref(), outer.as_ref()], grounds[1])
                    } else {
                        [T::zero(); A]
                    };
                    if k == 0 {
                        // The boundary conditions speak for the root's joint.
                        self.drive = torque;
                        Link::nothing()
                    } else if joint.turns {
                        let mut law = self.law(joint, absolute, grounds);
                        (0..A).for_each(|i| law.offset[i] -= torque[i]);
                        Link::Turning { law, smooth: joint.is_smooth() }
                    } else {
                        let (turn, ahead) = S::Orient::rigid(&joint.ahead);
                        Link::Rigid { turn, ahead: if absolute { ahead } else { [T::zero(); A] } }
                    }
                }
            });
        }
        Ok(())
    }

    /// What is known at both ends.
    pub(super) fn ends(&self, time: T::Real, [before, ground]: Grounds<T, S::Orient, N, P, A>) -> [End<T, H>; 2] {
        let absolute = self.scheme.solver == Solver::Product;
        let [mut root, mut tip] = [self.scene.root(self.guide, ground), self.scene.tip(time)];
        let past = |body: &Body<T, D::Memory, S::Orient, N, P, A>, point: usize| -> [T; H] {
            let (place, angles) = (&body.points[point], &body.angles);
            core::array::from_fn(|i| if i < P { place[i].value } else { angles[i - P].value })
        };
        if let (true, Some(first)) = (S::HELD, self.bodies().next()) {
            let place = S::Orient::place(ground);
            let mut from = past(first, 0);
            let angles = match self.parts.as_slice() {
                [Part::Joint(joint), Part::Body(_), ..] => {
                    S::Orient::clamped(&first.base, &each(&first.angles, |angle| angle.value), &joint.ahead, ground)
                }
                // A hinge on the ground: what is held is its inboard side.
                _ => {
                    let [past, now] = S::Orient::grounded(&first.base, [before, ground]);
                    from[P..].copy_from_slice(&past);
                    now
                }
            };
            if absolute {
                from = [T::zero(); H];
            }
            for k in 0..H {
                let axis = root.axes[k];
                root.known[k] = if root.held[k] {
                    (0..H).fold(T::zero(), |sum, i| {
                        let target = if i < P { place[i] } else { angles[i - P] };
                        sum + axis[i] * (target - from[i])
                    })
                } else {
                    // The torque m of the root's joint, less what is applied.
                    (P..H).fold(T::zero(), |sum, i| sum - axis[i] * self.drive[i - P])
                };
            }
        }
        if let (false, true, Some(last)) = (absolute, tip.is_held(), self.bodies().last()) {
            let from = past(last, 2);
            for k in (0..H).filter(|k| tip.held[*k]) {
                tip.known[k] -= (0..H).fold(T::zero(), |sum, i| sum + tip.axes[k][i] * from[i]);
            }
        }
        [root, tip]
    }

    pub(super) fn chi(&self, coordinate: &Coordinate<T, D::Memory>) -> Linearization<T> {
        self.scheme.rule.linearize(coordinate, self.dt)
    }

    pub(super) fn body(&self, at: Option<usize>) -> Option<&Body<T, D::Memory, S::Orient, N, P, A>> {
        at.and_then(|k| self.parts.get(k)).and_then(Part::body)
    }

    /// The last column of (32) in absolute coordinates.
    fn given_absolute(&self, body: &Body<T, D::Memory, S::Orient, N, P, A>) -> Given<T, P, A> {
        let [inboard, centre, _] = body.points.each_ref().map(|point| each(point, |c| self.chi(c).chi2()));
        Given {
            inboard,
            centre,
            angles: each(&body.angles, |c| self.chi(c).chi2()),
            rates: each(&body.angles, |c| self.chi(c).chi4()),
            arms: S::Orient::arms(&body.rigid).map(|arm| body.expansion.phi(arm)),
        }
    }

    /// The same in increments, where r_O − r_I = (7) r_{2,O} of this step less that carried from the last one.
    fn given(&self, body: &Body<T, D::Memory, S::Orient, N, P, A>) -> Given<T, P, A> {
        let [inboard, centre, _] = body.points.each_ref().map(|point| each(point, |c| self.chi(c).acceleration));
        Given {
            inboard,
            centre,
            angles: each(&body.angles, |c| self.chi(c).acceleration),
            rates: each(&body.angles, |c| self.chi(c).rate),
            arms: self.changes(body),
        }
    }

    /// How the arms to mass centre and outboard end would change if no coordinate did.
    pub(super) fn changes(&self, body: &Body<T, D::Memory, S::Orient, N, P, A>) -> [[T; P]; 2] {
        let (arms, angles) = (S::Orient::arms(&body.rigid), each(&body.angles, |angle| angle.value));
        core::array::from_fn(|k| {
            let rest = body.expansion.remainder(&body.base, arms[k], &angles);
            core::array::from_fn(|i| rest[i] - body.defects[k][i])
        })
    }

    /// (34) of a joint in this step.
    fn law(
        &self,
        joint: &Joint<T, <S::Orient as Orient<T, N, P, A>>::Ahead, A>,
        absolute: bool,
        grounds: Grounds<T, S::Orient, N, P, A>,
    ) -> Law<T, A> {
        if joint.is_smooth() {
            return Law::smooth([T::zero(); A]);
        }
        let side = |at: Option<usize>| {
            self.body(at).map(|body| Side { expansion: body.expansion, step: each(&body.angles, |c| self.chi(c)) })
        };
        let outer = side(Some(joint.outer));
        // Where the ground is one side its motion is known.
        let outer_body = self.body(Some(joint.outer));
        match (outer, outer_body) {
            (Some(outer), Some(body)) => {
                let inner = side(joint.inner)
                    .unwrap_or_else(|| S::Orient::ground(&body.base, grounds, &self.chi(&body.angles[0])));
                S::Orient::law(&joint.spring, &joint.elastic, [&inner, &outer], absolute)
            }
            _ => Law::smooth([T::zero(); A]),
        }
    }
}
