//! What is known at both ends in a step: step 5 of section 4.

use super::form::Grounds;
use super::{Run, Solver};
use crate::paper::link::End;
use crate::paper::orient::{Axes, Expanded, Joints, Orient, each};
use crate::paper::parts::{Body, Part};
use crate::paper::rule::Rule;
use crate::paper::scene::Scene;
use crate::scalar::Scalar;

impl<T, S, L, D, const N: usize, const H: usize, const P: usize, const A: usize> Run<'_, T, S, L, D, N, H, P, A>
where
    T: Scalar,
    S: Scene<T, L, N, H, P, A>,
    D: Rule<T>,
{
    /// What is known at the root, once its joint is formed.
    pub(super) fn root_end(&self, [before, ground]: Grounds<T, S::Orient, N, P, A>) -> End<T, H> {
        let absolute = self.scheme.solver == Solver::Product;
        let axes = if S::ATTITUDES[0] { self.parts.bodies.first().map(|body| self.axes(body)) } else { None };
        let mut root = self.scene.root(self.guide, ground, axes.as_ref(), self.drive);
        if let (true, Some(first)) = (S::HELD, self.parts.bodies.first()) {
            let place = S::Orient::place(ground);
            let mut from: [T; H] = past(first, 0);
            let angles = match self.parts.order.as_slice() {
                [Part::Joint(joint), Part::Body(_), ..] => {
                    let ahead = &self.parts.joints[*joint].ahead;
                    S::Orient::clamped(&first.base, &each(&first.angles, |angle| angle.value), ahead, ground)
                }
                // A hinge on the ground: what is held is its inboard side.
                _ => {
                    let [past, now] = S::Orient::grounded(&first.base, [before, ground]);
                    from[P..].copy_from_slice(&past);
                    if let Some(springs) = self.parts.springs_beyond(0) {
                        (0..P).for_each(|i| from[i] -= springs.apart[i].value);
                    }
                    now
                }
            };
            if absolute {
                from = [T::zero(); H];
            }
            if S::ATTITUDES[0] {
                from[P..].copy_from_slice(&angles); // axes say all
            }
            for k in (0..H).filter(|k| root.held[*k]) {
                root.known[k] += (0..H).fold(T::zero(), |sum, i| {
                    let target = if i < P { place[i] } else { angles[i - P] };
                    sum + root.axes[k][i] * (target - from[i])
                });
            }
        }
        root
    }

    /// The axes of a body where it is linearised.
    fn axes(&self, body: &Body<T, D::Memory, S::Orient, N, P, A>) -> Axes<T, P, A> {
        let absolute = self.scheme.solver == Solver::Product;
        let angles = each(&body.angles, |angle| angle.value);
        let unit = |k: usize| core::array::from_fn(|i| if i == k { T::one() } else { T::zero() });
        let point = |k: usize| {
            if absolute {
                return body.expansion.phi(unit(k));
            }
            let turned = S::Orient::turned(&body.base, unit(k), &angles);
            let rest = body.expansion.remainder(&body.base, unit(k), &angles);
            core::array::from_fn(|i| turned[i] + rest[i])
        };
        Axes { points: core::array::from_fn(point), slopes: core::array::from_fn(|k| body.expansion.psi(unit(k))) }
    }

    /// What is known at the tip.
    pub(super) fn tip_end(&self, time: T::Real) -> End<T, H> {
        let absolute = self.scheme.solver == Solver::Product;
        let axes = if S::ATTITUDES[1] { self.parts.bodies.last().map(|body| self.axes(body)) } else { None };
        let mut tip = self.scene.tip(time, axes.as_ref());
        if let (false, true, Some(last)) = (absolute, tip.is_held(), self.parts.bodies.last()) {
            let mut from: [T; H] = past(last, 2);
            if S::ATTITUDES[1] {
                from[P..].fill(T::zero());
            }
            for k in (0..H).filter(|k| tip.held[*k]) {
                tip.known[k] -= (0..H).fold(T::zero(), |sum, i| sum + tip.axes[k][i] * from[i]);
            }
        }
        tip
    }
}

/// p of a point of a body at t_{i−1}.
fn past<T, M, E, const N: usize, const H: usize, const P: usize, const A: usize>(
    body: &Body<T, M, E, N, P, A>,
    point: usize,
) -> [T; H]
where
    T: Scalar,
    M: Copy,
    E: Orient<T, N, P, A>,
{
    core::array::from_fn(|i| if i < P { body.points[point][i].value } else { body.angles[i - P].value })
}
