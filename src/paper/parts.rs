//! The bodies and joints of a run: parameters, histories, and who is next to whom.

use super::body::Rigid;
use super::expansion::Expansion;
use super::pin::is_percussive;
use super::rule::{Coordinate, Linearization, Rule};
use super::scene::{Item, Spring};
use crate::planar::{BodyMotion, Frame, Turn};
use crate::scalar::Scalar;
use alloc::vec::Vec;
use nalgebra::Vector2;
use num_traits::Zero;

/// A point of a body, its x and y.
pub type Point<T, M> = [Coordinate<T, M>; 2];

/// A body of a run. Every coordinate is integrated by itself: of x_I, y_I, x_C, y_C, x_O, y_O and θ.
#[derive(Clone, Copy, Debug)]
pub struct Body<T, M> {
    /// Mass and shape.
    pub rigid: Rigid<T>,
    /// Whether a pin at its inboard end has no matrix (40).
    pub percussive: bool,
    /// Inboard end, mass centre and outboard end.
    pub points: [Point<T, M>; 3],
    /// θ.
    pub angle: Coordinate<T, M>,
    /// By how much the arms to mass centre and outboard end, as carried, differ from the true ones: linearised geometry is kept as the
    /// step found it, for rates made of corrected positions would not be those of any motion.
    pub defects: [[T; 2]; 2],
    /// Where this step is linearised.
    pub expansion: Expansion<T>,
    /// The increment of θ found last.
    pub found: T,
}

/// A joint of a run.
#[derive(Clone, Copy, Debug)]
pub struct Joint<T> {
    /// Whether it turns.
    pub turns: bool,
    /// Its spring and damper.
    pub spring: Spring<T>,
    /// k′(φ − φ₀) (N·m) at t_{i−1}, carried by itself: differences of absolute angles lose digits where bodies are short.
    pub elastic: T,
    /// The angle (rad) of its outboard side ahead of its inboard one, if it does not turn.
    pub ahead: T,
    /// The body on its inboard side, by its place in the chain; none at the ground.
    pub inner: Option<usize>,
    /// The body on its outboard side.
    pub outer: usize,
}

impl<T: Scalar> Joint<T> {
    /// Whether nothing but applied torques resists rotation: a pin, or a hinge of no stiffness.
    pub fn is_smooth(&self) -> bool {
        let Spring { stiffness, damping, .. } = self.spring;
        stiffness.real() == T::Real::zero() && damping.real() == T::Real::zero()
    }
}

/// A body or a joint.
#[derive(Clone, Copy, Debug)]
pub enum Part<T, M> {
    /// A body.
    Body(Body<T, M>),
    /// A joint.
    Joint(Joint<T>),
}

impl<T: Scalar, M: Copy> Body<T, M> {
    fn new<D: Rule<T, Memory = M>>(rule: &D, dt: T::Real, body: &BodyMotion<T>) -> Self {
        let point = |frame: Frame<T>| {
            let (place, velocity, linear) = (frame.place, frame.velocity, frame.acceleration.linear);
            [rule.start(place.x, velocity.x, linear.x, dt), rule.start(place.y, velocity.y, linear.y, dt)]
        };
        let Turn { angle, rate } = body.inboard.turn;
        let rigid = Rigid::of(body);
        Self {
            rigid,
            percussive: is_percussive(&rigid),
            points: [body.inboard, body.centre(), body.outboard()].map(point),
            angle: rule.start(angle, rate, body.inboard.acceleration.angular, dt),
            defects: [[T::zero(); 2]; 2],
            expansion: Expansion::about(angle),
            found: T::zero(),
        }
    }

    /// This body where it is at `increment` of its angle, `span` (s) after t_{i−1}, for loads to be read there.
    pub fn guessed(&self, turn: Turn<T>, direction: [T; 2], span: T::Real) -> BodyMotion<T> {
        let later = |c: &Coordinate<T, M>| (c.value.add_scaled(span, c.rate), c.rate.add_scaled(span, c.acceleration));
        let [(x, u), (y, v)] = [later(&self.points[0][0]), later(&self.points[0][1])];
        let still = Frame::resting(Vector2::new(x, y));
        self.rigid.moving(Frame { velocity: Vector2::new(u, v), turn, ..still }, direction)
    }
}

/// The parts of a chain, from its root's joint on.
pub fn parts<T: Scalar, D: Rule<T>>(rule: &D, dt: T::Real, items: &[Item<T>]) -> Vec<Part<T, D::Memory>> {
    let mut inner = None;
    let mut parts: Vec<Part<T, D::Memory>> = Vec::with_capacity(items.len());
    for (k, item) in items.iter().enumerate() {
        parts.push(match item {
            Item::Body(body) => {
                inner = Some(k);
                Part::Body(Body::new(rule, dt, body))
            }
            Item::Joint(joint, spring) => {
                let beyond = &items[k..];
                let next = beyond.iter().position(|item| matches!(item, Item::Body(_)));
                Part::Joint(Joint {
                    turns: joint.turns,
                    spring: *spring,
                    // The torque of the spring alone, on the outboard body the other way round.
                    elastic: -(joint.spring.torque + spring.damping * joint.rate()),
                    ahead: joint.angle(),
                    inner,
                    outer: k + next.unwrap_or(0),
                })
            }
        });
    }
    parts
}

/// (1) and (2) of θ at one side of a joint. At the ground its motion is known: its angle (rad) at t_{i−1}, and how it turns where
/// forces balance.
pub fn side<T: Scalar, D: Rule<T>>(
    rule: &D,
    dt: T::Real,
    parts: &[Part<T, D::Memory>],
    at: Option<usize>,
    (past, ground): (T, Turn<T>),
) -> Linearization<T> {
    if let Some(Part::Body(body)) = at.and_then(|k| parts.get(k)) {
        return rule.linearize(&body.angle, dt);
    }
    let zero = T::zero();
    let still = Coordinate { value: zero, rate: zero, acceleration: zero, memory: rule.remember(zero, zero, zero, dt) };
    let Linearization { chi1, chi3, .. } = rule.linearize(&still, dt);
    let rate = ground.rate - (ground.angle - past).scale(chi3);
    Linearization { past, chi1, chi3, acceleration: zero, rate }
}
