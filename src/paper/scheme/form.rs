//! Steps 3 and 4: what each element is in this step.

use super::{Run, Solver};
use crate::error::Error;
use crate::paper::link::{Given, Law, Link};
use crate::paper::orient::{Bodies, Expanded, Joints, Side, each};
use crate::paper::parts::{Body, Joint, Part, Parts};
use crate::paper::rule::{Coordinate, Linearization, Rule};
use crate::paper::scene::Scene;
use crate::scalar::Scalar;
use core::ops::Range;

/// The ground at t_{i−1} and where forces balance.
pub(super) type Grounds<'g, T, E, const N: usize, const P: usize, const A: usize> =
    [&'g <E as Joints<T, P, A>>::Frame; 2];

impl<T, S, L, D, const N: usize, const H: usize, const P: usize, const A: usize> Run<'_, T, S, L, D, N, H, P, A>
where
    T: Scalar,
    S: Scene<T, L, N, H, P, A>,
    D: Rule<T>,
{
    /// Where the bodies that these parts ask for are linearised: all of them, and one more inboard of a joint.
    pub(super) fn guess(&mut self, parts: Range<usize>, sweep: usize, span: T::Real) {
        let Parts { order, bodies, joints, .. } = &mut self.parts;
        let number = |part: &Part, inner: bool| match *part {
            Part::Body(number) => number,
            Part::Joint(number) => joints[number].inner().filter(|_| inner).unwrap_or(joints[number].outer),
        };
        let [first, end] = [order.get(parts.start), order.get(parts.end)]
            .map(|part| part.map_or(bodies.len(), |part| number(part, true)));
        let (rule, dt, at) = (self.scheme.rule, self.dt, self.scheme.at);
        for body in &mut bodies[first..end] {
            let steps = each(&body.angles, |angle| rule.linearize(angle, dt));
            if sweep == 0 {
                let past = each(&body.angles, |angle| [angle.value, angle.rate, angle.acceleration]);
                (body.expansion, body.found) = S::Orient::first(at, &body.base, &past, &steps, span);
            } else {
                body.expansion = S::Orient::again(&body.base, &steps, &body.found);
            }
        }
    }

    /// Steps 3 and 4: χ₁ to χ₄, c̄ and s̄, and what each element of a block is in this step.
    pub(super) fn form(
        &mut self,
        parts: Range<usize>,
        span: T::Real,
        time: T::Real,
        grounds: Grounds<T, S::Orient, N, P, A>,
    ) -> Result<(), Error> {
        let absolute = self.scheme.solver == Solver::Product;
        self.links.clear();
        for k in parts {
            let link = match self.parts.order[k] {
                Part::Body(number) => {
                    let body = &self.parts.bodies[number];
                    body.expansion.check().map_err(|fault| Error::new(fault).at_station(k.saturating_sub(1)))?;
                    let external = self.scene.external(self.loads, time, number, &body.guessed(span));
                    let step = self.chi(&body.angles[0]);
                    let given = if absolute { self.given_absolute(body) } else { self.given(body) };
                    Link::Body {
                        matrix: body.expansion.matrix(&body.rigid, &step, &given, &external),
                        inertia: S::Orient::inertia(&body.rigid) * step.chi1,
                        percussive: body.percussive,
                    }
                }
                Part::Joint(number) => {
                    let joint = &self.parts.joints[number];
                    let torque = self.effort(number, joint, span, time, grounds[1]);
                    if k == 0 {
                        // The boundary conditions speak for the root's joint.
                        self.drive = torque;
                        Link::nothing()
                    } else if joint.turns {
                        let mut law = self.law(joint, absolute, grounds);
                        (0..A).for_each(|i| law.offset[i] -= torque[i]);
                        let smooth = joint.is_smooth();
                        if let Some(springs) = joint.springs {
                            self.part(springs, law, smooth);
                            continue;
                        }
                        Link::Turning { law, smooth }
                    } else {
                        let (turn, ahead) = S::Orient::rigid(&joint.ahead);
                        Link::Rigid { turn, ahead: if absolute { ahead } else { [T::zero(); A] } }
                    }
                }
            };
            self.links.push(link);
        }
        Ok(())
    }

    /// A joint with linear springs in this step. Most chains have none.
    #[cold]
    #[inline(never)]
    fn part(&mut self, springs: usize, law: Law<T, A>, smooth: bool) {
        let absolute = self.scheme.solver == Solver::Product;
        let linear = self.parts.springs[springs].law(absolute, |c| self.chi(c));
        self.links.push(Link::Parting { law, smooth, linear });
    }

    /// The torque applied in a joint; the force along the line of a root that is guided.
    pub(super) fn effort(
        &self,
        number: usize,
        joint: &Joint<T, <S::Orient as Joints<T, P, A>>::Ahead, A>,
        span: T::Real,
        time: T::Real,
        ground: &<S::Orient as Joints<T, P, A>>::Frame,
    ) -> [T; A] {
        // A root that is guided slides.
        if !joint.turns && (number > 0 || self.guide.is_none()) {
            return [T::zero(); A];
        }
        let sides = [joint.inner(), Some(joint.outer)].map(|k| self.body(k).map(|body| body.guessed(span)));
        let [inner, outer] = &sides;
        self.scene.effort(self.loads, time, number, [inner.as_ref(), outer.as_ref()], ground, self.guide)
    }

    pub(super) fn chi(&self, coordinate: &Coordinate<T, D::Memory>) -> Linearization<T> {
        self.scheme.rule.linearize(coordinate, self.dt)
    }

    pub(super) fn body(&self, at: Option<usize>) -> Option<&Body<T, D::Memory, S::Orient, N, P, A>> {
        at.and_then(|k| self.parts.bodies.get(k))
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

    /// The last column of (32) in increments, where r_O − r_I = (7) r_{2,O} of this step less that carried from the last one.
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
        joint: &Joint<T, <S::Orient as Joints<T, P, A>>::Ahead, A>,
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
                let inner = side(joint.inner())
                    .unwrap_or_else(|| S::Orient::ground(&body.base, grounds, &self.chi(&body.angles[0])));
                S::Orient::law(&joint.spring, &joint.elastic, [&inner, &outer], absolute)
            }
            _ => Law::smooth([T::zero(); A]),
        }
    }
}
