//! The bodies and joints of a run: parameters, histories, and who is next to whom.

use super::orient::{Orient, Spring};
use super::rule::{Coordinate, Rule};
use crate::scalar::Scalar;
use alloc::vec::Vec;
use num_traits::Zero;

/// A body of a scene, and how it moves at the start: values, rates and accelerations.
#[derive(Clone, Copy, Debug)]
pub struct Start<T, R, B, const P: usize, const A: usize> {
    /// Mass and shape.
    pub rigid: R,
    /// Its orientation besides the coordinates.
    pub base: B,
    /// Of inboard end, mass centre and outboard end.
    pub points: [[[T; 3]; P]; 3],
    /// Of the angles.
    pub angles: [[T; 3]; A],
    /// The angles shown to a reader (rad).
    pub shown: [T; A],
}

/// A body or a joint of a scene.
#[derive(Clone, Copy, Debug)]
pub enum Item<T: Scalar, E: Orient<T, N, P, A>, const N: usize, const P: usize, const A: usize> {
    /// A body.
    Body(Start<T, E::Rigid, E::Base, P, A>),
    /// A joint.
    Joint {
        /// Whether it turns.
        turns: bool,
        /// The attitude of its outboard side to its inboard one.
        ahead: E::Ahead,
        /// Its spring and damper.
        spring: Spring<T, A>,
        /// k′(φ − φ₀) (N·m).
        elastic: [T; A],
    },
}

/// A body of a run. Every coordinate is integrated by itself: of r_I, r_C, r_O and θ.
#[derive(Clone, Copy, Debug)]
pub struct Body<T: Scalar, M, E: Orient<T, N, P, A>, const N: usize, const P: usize, const A: usize> {
    /// Mass and shape.
    pub rigid: E::Rigid,
    /// Its orientation besides the coordinates.
    pub base: E::Base,
    /// Whether a smooth joint at its inboard end has no matrix (40).
    pub percussive: bool,
    /// Inboard end, mass centre and outboard end.
    pub points: [[Coordinate<T, M>; P]; 3],
    /// θ.
    pub angles: [Coordinate<T, M>; A],
    /// θ as shown to a reader.
    pub shown: [T; A],
    /// By how much the arms to mass centre and outboard end, as carried, differ from the true ones: linearised geometry is kept as the
    /// step found it, for rates made of corrected positions would not be those of any motion.
    pub defects: [[T; P]; 2],
    /// Where this step is linearised.
    pub expansion: E,
    /// The increment of θ found last.
    pub found: [T; A],
}

/// A joint of a run.
#[derive(Clone, Copy, Debug)]
pub struct Joint<T, R, const A: usize> {
    /// Whether it turns.
    pub turns: bool,
    /// Its spring and damper.
    pub spring: Spring<T, A>,
    /// k′(φ − φ₀) (N·m) at t_{i−1}, carried by itself: differences of absolute angles lose digits where bodies are short.
    pub elastic: [T; A],
    /// The attitude of its outboard side to its inboard one, if it does not turn.
    pub ahead: R,
    /// The body on its inboard side, by its place in the chain; none at the ground.
    pub inner: Option<usize>,
    /// The body on its outboard side.
    pub outer: usize,
}

impl<T: Scalar, R, const A: usize> Joint<T, R, A> {
    /// Whether nothing but applied torques resists rotation: a pin, a ball, or a hinge of no stiffness.
    pub fn is_smooth(&self) -> bool {
        let Spring { stiffness, damping, .. } = &self.spring;
        stiffness.iter().chain(damping).all(|x| x.real() == T::Real::zero())
    }
}

/// A body or a joint.
#[derive(Clone, Copy, Debug)]
pub enum Part<T: Scalar, M, E: Orient<T, N, P, A>, const N: usize, const P: usize, const A: usize> {
    /// A body.
    Body(Body<T, M, E, N, P, A>),
    /// A joint.
    Joint(Joint<T, E::Ahead, A>),
}

impl<T: Scalar, M, E: Orient<T, N, P, A>, const N: usize, const P: usize, const A: usize> Part<T, M, E, N, P, A> {
    /// The body, if it is one.
    pub fn body(&self) -> Option<&Body<T, M, E, N, P, A>> {
        if let Self::Body(body) = self { Some(body) } else { None }
    }
}

impl<T: Scalar, M: Copy, E: Orient<T, N, P, A>, const N: usize, const P: usize, const A: usize> Body<T, M, E, N, P, A> {
    fn new<D: Rule<T, Memory = M>>(rule: &D, dt: T::Real, start: &Start<T, E::Rigid, E::Base, P, A>) -> Self {
        let begin = |[value, rate, acceleration]: [T; 3]| rule.start(value, rate, acceleration, dt);
        let zero = T::zero();
        let angles = start.angles.map(begin);
        let steps = angles.each_ref().map(|angle| rule.linearize(angle, dt));
        Self {
            rigid: start.rigid,
            base: start.base,
            percussive: E::is_percussive(&start.rigid),
            points: start.points.map(|point| point.map(begin)),
            expansion: E::again(&start.base, &steps, &[zero; A]),
            angles,
            shown: start.shown,
            defects: [[zero; P]; 2],
            found: [zero; A],
        }
    }

    /// This body where its linearisation is, `span` (s) after t_{i−1}, for loads to be read there.
    pub fn guessed(&self, span: T::Real) -> E::Motion {
        let later = |c: &Coordinate<T, M>| [c.value.add_scaled(span, c.rate), c.rate.add_scaled(span, c.acceleration)];
        let inboard = self.points[0].each_ref().map(later);
        let turn = core::array::from_fn(|k| {
            let angle = &self.angles[k];
            [angle.value + self.found[k], angle.rate.add_scaled(span, angle.acceleration)]
        });
        self.expansion.motion(&self.rigid, inboard.map(|[x, _]| x), inboard.map(|[_, v]| v), turn)
    }
}

/// The parts of a chain, from its root's joint on.
pub fn parts<T, D, E, const N: usize, const P: usize, const A: usize>(
    rule: &D,
    dt: T::Real,
    items: &[Item<T, E, N, P, A>],
) -> Vec<Part<T, D::Memory, E, N, P, A>>
where
    T: Scalar,
    D: Rule<T>,
    E: Orient<T, N, P, A>,
{
    let mut inner = None;
    let mut parts = Vec::with_capacity(items.len());
    for (k, item) in items.iter().enumerate() {
        parts.push(match item {
            Item::Body(body) => {
                inner = Some(k);
                Part::Body(Body::new(rule, dt, body))
            }
            Item::Joint { turns, ahead, spring, elastic } => {
                let next = items[k..].iter().position(|item| matches!(item, Item::Body(_)));
                let outer = k + next.unwrap_or(0);
                Part::Joint(Joint { turns: *turns, spring: *spring, elastic: *elastic, ahead: *ahead, inner, outer })
            }
        });
    }
    parts
}
