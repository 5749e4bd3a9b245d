//! The bodies and joints of a run: parameters, histories, and who is next to whom.

use super::hinge::Linear;
use super::orient::{Orient, Spring};
use super::rule::{Coordinate, Linearization, Rule};
use crate::scalar::Scalar;
use crate::state::StateVector;
use alloc::vec::Vec;
use num_traits::Zero;

/// A body of a scene, and how it moves at the start: values, rates and accelerations.
#[derive(Clone, Copy, Debug)]
pub struct Start<T, R, B, const P: usize, const A: usize> {
    /// Mass and shape.
    pub rigid: R,
    /// Orientation of the body besides the coordinates.
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
        /// Whether the joint turns.
        turns: bool,
        /// The attitude of the joint's outboard side to its inboard one.
        ahead: E::Ahead,
        /// Spring and damper of the joint.
        spring: Spring<T, A>,
        /// k′(φ − φ₀) (N·m).
        elastic: [T; A],
        /// Linear springs of the joint, and values, rates and accelerations of r_O − r_I, if it has any.
        linear: Option<(Spring<T, P>, [[T; 3]; P])>,
    },
}

/// A body of a run. Every coordinate is integrated by itself: of r_I, r_C, r_O and θ.
#[derive(Clone, Copy, Debug)]
pub struct Body<T: Scalar, M, E: Orient<T, N, P, A>, const N: usize, const P: usize, const A: usize> {
    /// Mass and shape.
    pub rigid: E::Rigid,
    /// Orientation of the body besides the coordinates.
    pub base: E::Base,
    /// Whether a smooth joint at the body's inboard end has no matrix (40).
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
    /// Whether the joint turns.
    pub turns: bool,
    /// Spring and damper of the joint.
    pub spring: Spring<T, A>,
    /// k′(φ − φ₀) (N·m) at t_{i−1}, carried by itself: differences of absolute angles lose digits where bodies are short.
    pub elastic: [T; A],
    /// The attitude of the joint's outboard side to its inboard one, if it does not turn.
    pub ahead: R,
    /// The number of the body on the joint's outboard side.
    pub outer: usize,
    /// The number of the joint's linear springs, if it has any.
    pub springs: Option<usize>,
}

/// Linear springs and dampers along the axes of the ground.
#[derive(Clone, Copy, Debug)]
pub struct Springs<T, M, const P: usize> {
    /// k (N/m), c (N·s/m), kd₀ (N).
    pub law: Spring<T, P>,
    /// d = r_O − r_I, integrated by itself as the angles' differences are: those of absolute places lose digits.
    pub apart: [Coordinate<T, M>; P],
}

impl<T: Scalar, R, const A: usize> Joint<T, R, A> {
    /// The number of the body on the joint's inboard side; none at the ground.
    pub fn inner(&self) -> Option<usize> {
        self.outer.checked_sub(1)
    }

    /// Whether nothing but applied torques resists rotation: a pin, a ball, or a hinge of no stiffness.
    pub fn is_smooth(&self) -> bool {
        let Spring { stiffness, damping, .. } = &self.spring;
        stiffness.iter().chain(damping).all(|x| x.real() == T::Real::zero())
    }
}

impl<T: Scalar, M, const P: usize> Springs<T, M, P> {
    /// Whether nothing pushes along one of the axes.
    pub fn leave_free(&self) -> bool {
        let none = |x: T| x.real() == T::Real::zero();
        let Spring { stiffness, damping, .. } = &self.law;
        stiffness.iter().zip(damping).any(|(stiffness, damping)| none(*stiffness) && none(*damping))
    }

    /// (33) with (2), axis by axis.
    pub fn law(&self, absolute: bool, chi: impl Fn(&Coordinate<T, M>) -> Linearization<T>) -> [Linear<T>; P] {
        let Spring { stiffness, damping, preload } = &self.law;
        core::array::from_fn(|i| {
            let step = chi(&self.apart[i]);
            let rate = if absolute { step.chi4() } else { step.rate };
            let elastic = if absolute { T::zero() } else { stiffness[i] * step.past };
            Linear {
                slope: stiffness[i] + damping[i].scale(step.chi3),
                offset: damping[i] * rate + elastic - preload[i],
            }
        })
    }
}

/// A body or a joint, by its number among its like, counted from the root.
#[derive(Clone, Copy, Debug)]
pub enum Part {
    /// A body.
    Body(usize),
    /// A joint.
    Joint(usize),
}

/// The bodies and joints of a chain, from its root's joint on. Each kind has a store of its own, for a long chain lives in memory: what
/// a step walks through must be small.
#[derive(Clone, Debug)]
pub struct Parts<T: Scalar, M, E: Orient<T, N, P, A>, const N: usize, const P: usize, const A: usize> {
    /// In which order bodies and joints follow each other.
    pub order: Vec<Part>,
    /// The bodies.
    pub bodies: Vec<Body<T, M, E, N, P, A>>,
    /// The joints.
    pub joints: Vec<Joint<T, E::Ahead, A>>,
    /// The linear springs of those that have any.
    pub springs: Vec<Springs<T, M, P>>,
}

impl<T, M, E, const N: usize, const P: usize, const A: usize> Parts<T, M, E, N, P, A>
where
    T: Scalar,
    M: Copy,
    E: Orient<T, N, P, A>,
{
    /// The parts of a chain that starts.
    pub fn new<D: Rule<T, Memory = M>>(rule: &D, dt: T::Real, items: &[Item<T, E, N, P, A>]) -> Self {
        let (mut order, mut bodies, mut joints) = (Vec::with_capacity(items.len()), Vec::new(), Vec::new());
        let mut springs = Vec::new();
        for item in items {
            match item {
                Item::Body(body) => {
                    order.push(Part::Body(bodies.len()));
                    bodies.push(Body::new(rule, dt, body));
                }
                Item::Joint { turns, ahead, spring, elastic, linear } => {
                    order.push(Part::Joint(joints.len()));
                    joints.push(Joint {
                        turns: *turns,
                        spring: *spring,
                        elastic: *elastic,
                        ahead: *ahead,
                        outer: bodies.len(),
                        springs: linear.map(|_| springs.len()),
                    });
                    springs.extend(linear.map(|(law, apart)| {
                        let begin = |[value, rate, acceleration]: [T; 3]| rule.start(value, rate, acceleration, dt);
                        Springs { law, apart: apart.map(begin) }
                    }));
                }
            }
        }
        Self { order, bodies, joints, springs }
    }

    /// The linear springs between station `k`, if a joint begins there, and the body outboard of it.
    pub fn springs_beyond(&self, k: usize) -> Option<&Springs<T, M, P>> {
        // The root's joint has none; a hinge on the ground comes next.
        let joint = |k: usize| match *self.order.get(k)? {
            Part::Joint(number) => Some(&self.joints[number]),
            Part::Body(_) => None,
        };
        let springs = joint(k)?.springs.or_else(|| joint(k + 1).and_then(|joint| joint.springs));
        springs.and_then(|springs| self.springs.get(springs))
    }

    /// Number of parts.
    pub fn len(&self) -> usize {
        self.order.len()
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

    /// Reads the increments of the body's angles from the state at its inboard end.
    pub fn find(&mut self, z: &StateVector<T, N>, absolute: bool) {
        self.found = core::array::from_fn(|i| if absolute { z[P + i] - self.angles[i].value } else { z[P + i] });
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
