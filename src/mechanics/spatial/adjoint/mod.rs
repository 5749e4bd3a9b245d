//! The costate sweep in space: what is carried and kept.

mod axial;
mod ball;
mod bodies;
pub(crate) mod driven;
mod elastic_ball;
mod ends;
mod felt;
mod floating;
mod force_elements;
pub(crate) mod guarded;
mod inertial;
mod linear_hinge;
mod loads;
mod loops;
mod read;
mod reversing;
mod revolute;
mod rotary;
mod steps;
mod struts;
mod weld;

pub use inertial::{Base, Inertial};

use ends::TIP;
pub(crate) use felt::Felt;
pub use inertial::{per_vector, swept};
use linear_hinge::ALONG;
pub use read::{BODY, numbers};
pub use steps::Step;

use crate::adjoint::laws::NUMBERS;
use crate::adjoint::{self, Costates, Kind, LoadCostates, Reversed, VirtualMotion};
use crate::element::Element;
use crate::mechanics::spatial::{Acceleration, BodyMotion, Frame, Spatial, Turn, Wrench};
use crate::relation::spatial::algebra::{Columns, Factor3, centripetal, cross, cross_onto, zero};
use crate::relation::spatial::{Couple, Full, Point};
use crate::relation::{Additive, Closures, Open};
use crate::scalar::Scalar;
use crate::shape::{PerAxes, Takes};
use crate::walks::faced::faced;
use crate::walks::orient::Orient;
use crate::walks::sines::sines;
use core::ops::Add;
use nalgebra::Vector3;

/// What lies outboard of a station.
pub type Outboard<T, C = Open> = adjoint::Outboard<Spatial<T>, C>;

impl<T: Scalar, C: Closures> Outboard<T, C> {
    /// Of a ball with a torque in it.
    #[inline(always)]
    fn of_ball(Point { mass, offset, torque, cuts }: Point<T, Couple<T>, C>) -> Self {
        let massless = Full::massless().cut(cuts.mapped(Wrench::of_force));
        Self { kind: Kind::Point, relation: Full { linear: mass, force: offset, torque: torque.0, ..massless } }
    }
    /// The relation of a ball.
    #[inline(always)]
    fn ball(&self) -> Point<T, Couple<T>, C> {
        let Full { linear, force, torque, cuts, .. } = self.relation;
        Point { mass: linear, offset: force, torque: Couple(torque), cuts: cuts.mapped(|w| w.force) }
    }
}

/// A virtual velocity on the way outward, and what turns the body on the inboard side.
#[derive(Clone, Copy, Debug)]
pub struct Stirred<T> {
    /// W, the virtual velocity of the station.
    pub velocity: Vector3<T>,
    pub turning: Turning<T>,
}

/// How a body turns, in inertial axes.
#[derive(Clone, Copy, Debug)]
pub struct Turning<T> {
    /// ω (rad/s).
    pub spin: Vector3<T>,
    /// α (rad/s²).
    pub acceleration: Vector3<T>,
    /// w.
    pub stirring: Vector3<T>,
}

impl<T: Scalar> Turning<T> {
    /// In other axes.
    #[inline(always)]
    pub fn mapped(&self, turn: impl Fn(Vector3<T>) -> Vector3<T>) -> Self {
        let Self { spin, acceleration, stirring } = *self;
        Self { spin: turn(spin), acceleration: turn(acceleration), stirring: turn(stirring) }
    }
    /// Nothing turns.
    fn none() -> Self {
        Self { spin: zero(), acceleration: zero(), stirring: zero() }
    }
}

/// What the outward walk keeps of a body.
#[derive(Clone, Copy, Debug)]
pub struct OnBody<T> {
    /// Virtual velocity of its outboard end.
    pub velocity: Vector3<T>,
    pub turning: Turning<T>,
}

/// What the outward walk keeps of a joint.
#[derive(Clone, Copy, Debug)]
pub struct InJoint<T> {
    /// Virtual velocity of its outboard point, where points slide apart.
    pub velocity: Vector3<T>,
    /// Of the outboard body; of a ball, with a spring or without, that of the inboard one.
    pub turning: Turning<T>,
}

/// What is carried inward: what P changes by with the motion of the station, and with attitudes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulled<T> {
    /// G = ∂P/∂A, the momentum of the virtual motion.
    pub momentum: Vector3<T>,
    /// F = ∂P/∂W, the force of inverse dynamics.
    pub force: Vector3<T>,
    /// Θ: −∂P for turns of all that has been met since the last balls, with its ω, α and w.
    pub turn: Vector3<T>,
    /// M = ∂P/∂w, the torque of inverse dynamics.
    pub torque: Vector3<T>,
    /// H = ∂P/∂α, the angular momentum of the virtual motion.
    pub angular: Vector3<T>,
    /// Ω = ∂P/∂ω.
    pub spin: Vector3<T>,
}

impl<T: Scalar> Pulled<T> {
    /// The costate of a turn of all that has been met since the last balls, where the body on the inboard side turns as it does: a
    /// rotation vector, inertial axes.
    #[inline(always)]
    pub fn turned(&self, Turning { spin, acceleration, stirring }: Turning<T>) -> Vector3<T> {
        let moving = cross_onto(acceleration, self.angular, cross(spin, self.spin));
        cross_onto(stirring, self.torque, moving + self.turn)
    }
}

impl<T: Scalar> Pulled<T> {
    /// In other axes.
    #[inline(always)]
    pub fn mapped(&self, axes: impl Fn(Vector3<T>) -> Vector3<T>) -> Self {
        let Self { momentum, force, turn, torque, angular, spin } = *self;
        let (momentum, force, turn) = (axes(momentum), axes(force), axes(turn));
        Self { momentum, force, turn, torque: axes(torque), angular: axes(angular), spin: axes(spin) }
    }

    /// Carried inward over an arm d of a body that turns so, in whose costate ∂P/∂d goes.
    #[cfg_attr(optimised, inline(always))]
    pub fn over(&self, d: Vector3<T>, turning: &Turning<T>, of_arm: &mut Vector3<T>) -> Self {
        let Self { momentum, force, .. } = *self;
        let Turning { spin, acceleration, stirring } = *turning;
        *of_arm -= per_vector(turning, momentum, force);
        let (stirred, moved) = (cross(stirring, d), cross_onto(acceleration, d, centripetal(spin, d)));
        Self {
            momentum,
            force,
            turn: cross_onto(force, stirred, cross_onto(momentum, moved, self.turn)),
            torque: cross_onto(d, force, self.torque),
            angular: cross_onto(d, momentum, self.angular),
            spin: swept(spin, d, momentum, self.spin),
        }
    }
}

impl<T: Scalar> Add for Pulled<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
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

/// What a sweep keeps of an elimination for costates.
#[derive(Clone, Copy, Debug)]
pub struct Pivot<T> {
    /// The inverse of a ball's pivot; of a joint's first coordinate as a number.
    pub factor: Factor3<T>,
    /// The torque in a ball, or in a joint that closes a loop (N·m), inertial axes; of a joint's second coordinate the inverse, as its x.
    pub torque: Vector3<T>,
}

/// Costates of the parameters of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OfJoint<T> {
    /// By turns of the joint's axes: of a weld the rotation vector in axes of the outboard body, of joints in body axes that of their offset,
    /// of all others two numbers, see [`revolute`].
    pub(crate) turn: Vector3<T>,
    /// By turns of a second axis; where points slide apart by the mass at the outboard one; by reflected inertia.
    pub(crate) more: [T; 2],
    /// The numbers of its law; of two laws three each.
    pub(crate) law: [T; NUMBERS],
    /// By the place on the inboard body, of joints that have one, in axes of that; of a rotary law by what numbers it has beyond those.
    pub(crate) place: Vector3<T>,
    /// The numbers of laws along three axes, three each.
    linear: [T; 3 * ALONG],
}

impl<T: Scalar> Reversed for Spatial<T> {
    type Pivot = Pivot<T>;
    type Poses = Orient;

    #[cfg_attr(optimised, inline(always))]
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
        sines(elements, position, x);
        faced(elements, Frame { turn, ..Frame::resting(zero()) }, position, rate, x);
        elements.take(&mut Orient, turn, (position, rate, x, y, p, q));
    }
    fn no_pivot() -> Pivot<T> {
        Pivot { factor: Factor3::of_number(T::one()), torque: zero() }
    }
    fn of_nothing() -> (Base<T>, [T; BODY], OfJoint<T>) {
        let (turn, place) = (zero(), zero());
        let of_joint =
            OfJoint { turn, more: [T::zero(); 2], law: [T::zero(); NUMBERS], place, linear: [T::zero(); 3 * ALONG] };
        (Base::null(), [T::zero(); BODY], of_joint)
    }
}

impl<T: Scalar> VirtualMotion for Spatial<T> {
    type Stirred = Stirred<T>;
    type OnBody = OnBody<T>;
    type InJoint = InJoint<T>;
    type AtEnds = [Turning<T>; 2];

    #[cfg_attr(optimised, inline(always))]
    fn at_ground(frame: &Frame<T>) -> Stirred<T> {
        let Acceleration { angular, .. } = frame.acceleration;
        let turning = Turning { spin: frame.turn.spin, acceleration: angular, stirring: zero() };
        Stirred { velocity: zero(), turning }
    }
    fn untouched() -> (OnBody<T>, InJoint<T>, [Turning<T>; 2]) {
        let turning = Turning::none();
        (OnBody { velocity: zero(), turning }, InJoint { velocity: zero(), turning }, [turning; 2])
    }
    fn at_ends(side: &Stirred<T>, main: &Stirred<T>) -> [Turning<T>; 2] {
        [side.turning, main.turning]
    }
    fn stirred(stirred: &Stirred<T>) -> Acceleration<T> {
        Acceleration { linear: stirred.velocity, angular: stirred.turning.stirring }
    }
    fn of_body(kept: &OnBody<T>) -> Vector3<T> {
        kept.velocity
    }
    fn of_joint(kept: &InJoint<T>) -> Vector3<T> {
        kept.velocity
    }
}

impl<T: Scalar> Costates for Spatial<T> {
    type Pulled = Pulled<T>;
    type OfBody = Base<T>;
    type OfJoint = OfJoint<T>;

    /// ν · A − λ · W does not turn with the body: Θ takes away what α × H + w × M would be of it.
    fn pulled((weight, a): (Wrench<T>, &Acceleration<T>), (force, w): (Wrench<T>, &Acceleration<T>)) -> Pulled<T> {
        let turn = cross_onto(weight.torque, a.angular, cross(w.angular, force.torque));
        let (torque, angular) = (-force.torque, weight.torque);
        Pulled { momentum: weight.force, force: -force.force, turn, torque, angular, spin: zero() }
    }
    #[inline(always)]
    fn of_ground(pulled: &Pulled<T>, frame: &Frame<T>) -> (Vector3<T>, Vector3<T>) {
        let turn = pulled.turned(Self::at_ground(frame).turning);
        (pulled.momentum, frame.turn.attitude.transposed(turn))
    }
    /// Sums are complete.
    fn complete(_: &(), _: &mut Base<T>) {}
}

impl<T: Scalar> LoadCostates for Spatial<T> {
    type Felt = Felt<T>;
    type OfNumbers = [T; BODY];
    type OfTip = [T; TIP];

    fn no_tip() -> [T; TIP] {
        [T::zero(); TIP]
    }
    fn inboard(motion: &BodyMotion<T>) -> Frame<T> {
        motion.inboard
    }
    fn felt(of_place: Wrench<T>, of_velocity: Wrench<T>, turn: &Turn<T>) -> Felt<T> {
        Felt::at(of_place, of_velocity, turn.spin)
    }
    fn of_place(felt: &Felt<T>, frame: &Frame<T>) -> (Vector3<T>, Vector3<T>) {
        (felt.place, frame.turn.attitude.transposed(felt.turned(frame.turn.spin)))
    }
}
