//! The costate sweep in space: what is carried and kept.

mod ball;
mod bodies;
mod ends;
mod inertial;
mod loads;
mod revolute;
mod weld;

pub use inertial::{Base, Inertial};

use crate::adjoint::Reversed;
use crate::element::Element;
use crate::mechanics::spatial::{Acceleration, BodyMotion, Frame, Spatial, Turn, Wrench};
use crate::relation::spatial::algebra::{Columns, Factor3, cross, cross_onto, zero};
use crate::relation::spatial::{Couple, Full, Point};
use crate::relation::{Absent, Additive, Closures, Cuts, Join, LoopGain, Looped, Open, Own, Settle};
use crate::scalar::Scalar;
use crate::shape::{PerAxes, Takes};
use crate::walks::orient::Orient;
use core::ops::Add;
use nalgebra::Vector3;

/// What lies outboard of a station, with a kind: bodies save what a ball or a free tip leaves out.
#[derive(Clone, Copy)]
pub struct Outboard<T: Scalar, C: Closures = Open> {
    kind: Kind,
    relation: Full<T, C>,
}

/// What there is of a relation.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// A free tip: nothing.
    Nothing,
    /// A ball: the moment does not depend on the motion.
    Ball,
    /// All of it.
    Rigid,
}

impl Kind {
    /// What there is of a sum.
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Nothing, kind) | (kind, Self::Nothing) => kind,
            (Self::Ball, Self::Ball) => Self::Ball,
            _ => Self::Rigid,
        }
    }
}

impl<T: Scalar> Outboard<T> {
    /// Of a ball with a torque in it.
    #[inline(always)]
    fn of_ball(Point { mass, offset, torque, .. }: Point<T, Couple<T>>) -> Self {
        let relation = Full { linear: mass, force: offset, torque: torque.0, ..Full::massless() };
        Self { kind: Kind::Ball, relation }
    }
    /// The relation of a ball.
    #[inline(always)]
    fn ball(&self) -> Point<T, Couple<T>> {
        let Full { linear, force, torque, cuts, .. } = self.relation;
        Point { mass: linear, offset: force, torque: Couple(torque), cuts: cuts.mapped(|w| w.force) }
    }
    /// All of a relation.
    #[inline(always)]
    fn rigid(relation: Full<T>) -> Self {
        Self { kind: Kind::Rigid, relation }
    }
}

/// A virtual velocity on the way outward, and what turns the body on the inboard side.
#[derive(Clone, Copy, Debug)]
pub struct Stirred<T> {
    /// W, the virtual velocity of the station.
    velocity: Vector3<T>,
    turning: Turning<T>,
}

/// How a body turns, in inertial axes.
#[derive(Clone, Copy, Debug)]
pub struct Turning<T> {
    /// ω (rad/s).
    spin: Vector3<T>,
    /// α (rad/s²).
    acceleration: Vector3<T>,
    /// w.
    stirring: Vector3<T>,
}

impl<T: Scalar> Turning<T> {
    /// Nothing turns.
    fn none() -> Self {
        Self { spin: zero(), acceleration: zero(), stirring: zero() }
    }
}

/// What the outward walk keeps of a body.
#[derive(Clone, Copy, Debug)]
pub struct OnBody<T> {
    /// Virtual velocity of its outboard end.
    velocity: Vector3<T>,
    turning: Turning<T>,
}

/// What is carried inward: what P changes by with the motion of the station, and with attitudes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulled<T> {
    /// G = ∂P/∂A, the momentum of the virtual motion.
    momentum: Vector3<T>,
    /// F = ∂P/∂W, the force of inverse dynamics.
    force: Vector3<T>,
    /// Θ: −∂P for turns of all that has been met since the last balls, with its ω, α and w.
    turn: Vector3<T>,
    /// M = ∂P/∂w, the torque of inverse dynamics.
    torque: Vector3<T>,
    /// H = ∂P/∂α, the angular momentum of the virtual motion.
    angular: Vector3<T>,
    /// Ω = ∂P/∂ω.
    spin: Vector3<T>,
}

impl<T: Scalar> Pulled<T> {
    /// The costate of a turn of all that has been met since the last balls, where the body on the inboard side turns as it does: a
    /// rotation vector, inertial axes.
    #[inline(always)]
    fn turned(&self, Turning { spin, acceleration, stirring }: Turning<T>) -> Vector3<T> {
        let moving = cross_onto(acceleration, self.angular, cross(spin, self.spin));
        cross_onto(stirring, self.torque, moving + self.turn)
    }
}

impl<T: Scalar> Add for Pulled<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            momentum: self.momentum + other.momentum,
            force: self.force + other.force,
            turn: self.turn + other.turn,
            torque: self.torque + other.torque,
            angular: self.angular + other.angular,
            spin: self.spin + other.spin,
        }
    }
}

impl<T: Scalar> Additive for Pulled<T> {
    #[inline(always)]
    fn null() -> Self {
        let none = zero();
        Self { momentum: none, force: none, turn: none, torque: none, angular: none, spin: none }
    }
}

/// Most numbers of a spring and damper.
const LAW: usize = 3;

/// What a sweep keeps of an elimination for costates.
#[derive(Clone, Copy, Debug)]
pub struct Pivot<T> {
    /// The inverse of a ball's pivot; of a revolute joint's as a number.
    factor: Factor3<T>,
    /// The torque in a ball (N·m), inertial axes.
    torque: Vector3<T>,
}

/// Costates of the parameters of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OfJoint<T> {
    /// By turns of the joint's axes: of a weld the rotation vector in axes of the outboard body, of a revolute joint two numbers, see
    /// [`revolute`].
    pub(crate) turn: Vector3<T>,
    /// The numbers of a spring and damper.
    pub(crate) law: [T; LAW],
}

impl<T: Scalar> Reversed for Spatial<T> {
    type Outboard<C: Closures> = Outboard<T, C>;
    type Pivot = Pivot<T>;
    type Stirred = Stirred<T>;
    type OnBody = OnBody<T>;
    type InJoint = Turning<T>;
    type Pulled = Pulled<T>;
    type OfBody = Base<T>;
    type OfJoint = OfJoint<T>;
    /// Loads on bodies are not known.
    type Felt = Absent;
    type OfNumbers = ();
    type Poses = Orient;

    #[inline(always)]
    fn pose<E: Element<Self> + Takes<Self, Orient>>(
        elements: &E,
        position: &E::Position,
        rate: &E::Rate,
        turn: Turn<T>,
        _: &E::Store<PerAxes<()>>,
        x: &mut E::Store<PerAxes<Columns<T>>>,
        y: &mut E::Store<PerAxes<[Vector3<T>; 2]>>,
        p: &mut E::Store<PerAxes<Vector3<T>>>,
        q: &mut E::Store<PerAxes<Vector3<T>>>,
    ) {
        elements.take(&mut Orient, turn, (position, rate, x, y, p, q));
    }

    #[inline(always)]
    fn nothing() -> Outboard<T> {
        Outboard { kind: Kind::Nothing, relation: Full::massless() }
    }
    #[inline(always)]
    fn join<C: Closures>(chain: Outboard<T, C>, arm: Outboard<T>) -> Outboard<T, C> {
        Outboard { kind: chain.kind.and(arm.kind), relation: chain.relation.join(arm.relation) }
    }
    #[inline(always)]
    fn settle<C: Closures, O: Own>(
        main: Outboard<T, Looped<C, O>>,
        side: Outboard<T, O>,
        measure: O::Measure<T>,
    ) -> (Outboard<T, C>, LoopGain<Wrench<T>, T, C, O>) {
        let (relation, gain) = main.relation.settle(side.relation, measure);
        (Outboard { kind: main.kind.and(side.kind), relation }, gain)
    }
    #[inline(always)]
    fn cuts<C: Closures>(outboard: &Outboard<T, C>) -> Cuts<Wrench<T>, T, C> {
        outboard.relation.cuts
    }
    fn no_pivot() -> Pivot<T> {
        Pivot { factor: Factor3::of_number(T::one()), torque: zero() }
    }
    #[inline(always)]
    fn at_ground(frame: &Frame<T>) -> Stirred<T> {
        let Acceleration { angular, .. } = frame.acceleration;
        let turning = Turning { spin: frame.turn.spin, acceleration: angular, stirring: zero() };
        Stirred { velocity: zero(), turning }
    }
    fn untouched() -> (OnBody<T>, Turning<T>) {
        (OnBody { velocity: zero(), turning: Turning::none() }, Turning::none())
    }
    fn inboard(motion: &BodyMotion<T>) -> Frame<T> {
        motion.inboard
    }
    fn of_place(_: &Absent) -> (Vector3<T>, Vector3<T>) {
        (zero(), zero())
    }
    fn of_nothing() -> (Base<T>, (), OfJoint<T>) {
        (Base::null(), (), OfJoint { turn: zero(), law: [T::zero(); LAW] })
    }
    #[inline(always)]
    fn of_ground(pulled: &Pulled<T>, frame: &Frame<T>) -> (Vector3<T>, Vector3<T>) {
        let turn = pulled.turned(Self::at_ground(frame).turning);
        (pulled.momentum, frame.turn.attitude.transposed(turn))
    }
    /// Sums are complete.
    fn complete(_: &(), _: &mut Base<T>) {}
}
