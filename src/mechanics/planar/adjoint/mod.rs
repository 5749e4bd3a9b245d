//! The costate sweep in the plane: what is carried and kept.

mod bodies;
mod driven;
mod ends;
mod force_elements;
mod guarded;
mod hinge_axes;
mod joints;
mod linear_hinge;
mod loads;
mod loops;
mod slider;
mod struts;

use ends::TIP;
use loads::Felt;
pub(crate) use loads::{BODY, numbers};

use super::body::Base;
use crate::adjoint::laws::NUMBERS;
use crate::adjoint::{self, Costates, Kind, LoadCostates, Reversed, VirtualMotion};
use crate::element::Element;
use crate::mechanics::planar::{Acceleration, BodyMotion, Frame, Planar, Turn, Wrench};
use crate::relation::planar::{Full, Point};
use crate::relation::{Additive, Closures, Open};
use crate::scalar::Scalar;
use crate::shape::PerAxes;
use crate::walks::factor::Factor;
use core::ops::Add;
use nalgebra::Vector2;

/// Most numbers of each law of a joint that has several.
pub(crate) const LAW_NUMBERS: usize = NUMBERS / 2;
/// Most numbers that are kept of a joint: three laws, and a mass.
pub(crate) const NUMBERS_OF_JOINT: usize = 3 * LAW_NUMBERS + 1;

/// What lies outboard of a station.
type Outboard<T, C = Open> = adjoint::Outboard<Planar<T>, C>;

impl<T: Scalar, C: Closures> Outboard<T, C> {
    /// Of a pin with a torque in it.
    #[inline(always)]
    fn of_pin(Point { mass, offset, torque, cuts }: Point<T, T, C>) -> Self {
        let massless = Full::massless().cut(cuts.mapped(Wrench::of_force));
        Self { kind: Kind::Point, relation: Full { linear: mass, force: offset, torque, ..massless } }
    }
    /// The relation of a pin.
    #[inline(always)]
    fn pin(&self) -> Point<T, T, C> {
        let Full { linear, force, torque, cuts, .. } = self.relation;
        Point { mass: linear, offset: force, torque, cuts: cuts.mapped(|w| w.force) }
    }
}

/// A virtual velocity on the way outward, and what turns the body on the inboard side.
#[derive(Clone, Copy, Debug)]
pub struct Stirred<T> {
    /// W and w.
    velocity: Acceleration<T>,
    turning: Turning<T>,
}

/// How a body turns.
#[derive(Clone, Copy, Debug)]
pub struct Turning<T> {
    /// ω (rad/s).
    rate: T,
    /// α (rad/s²).
    acceleration: T,
    /// w.
    stirring: T,
}

/// What the outward walk keeps of a joint that has no angle of its own, or one against the inboard body.
#[derive(Clone, Copy, Debug)]
pub struct AtJoint<T> {
    /// Of the outboard side.
    turning: Turning<T>,
    /// Virtual velocity of the outboard side, of a joint that slides.
    velocity: Vector2<T>,
}

/// What the outward walk keeps of a body.
#[derive(Clone, Copy, Debug)]
pub struct OnBody<T> {
    /// Virtual velocity of its outboard end.
    velocity: Vector2<T>,
    /// α and w.
    acceleration: T,
    stirring: T,
}

/// What is carried inward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulled<T> {
    /// G, the momentum of the virtual motion.
    momentum: Vector2<T>,
    /// F, the force of inverse dynamics.
    force: Vector2<T>,
    /// What α, ω² and w multiply in the costate of the angle of all that has been met since the last pin.
    along: T,
    across: T,
    lever: T,
    /// H = ∂P/∂α, the angular momentum of the virtual motion, where [`PullBack`](crate::walks::pull_back::PullBack) is to carry it.
    angular: T,
    /// Costates of angle and angular velocity of all that turns along and is not in these sums: beyond a hinge, and on a line that turns.
    /// Nothing, rather than zeros, where there are no such joints.
    beyond: Option<[T; 2]>,
}

impl<T: Scalar> Pulled<T> {
    /// The costates of the angle and the angular velocity that turn what has been met.
    #[cfg_attr(optimised, inline(always))]
    fn turned(&self, Turning { rate, acceleration, stirring }: Turning<T>) -> [T; 2] {
        let angle = acceleration.mul_add(self.along, (rate * rate).mul_add(self.across, stirring * self.lever));
        let spin = (rate + rate) * self.along;
        match self.beyond {
            Some([of_angle, of_rate]) => [angle + of_angle, spin + of_rate],
            None => [angle, spin],
        }
    }
    /// Without G and F.
    #[inline(always)]
    fn turning_alone(self) -> Self {
        Self { momentum: Vector2::null(), force: Vector2::null(), ..self }
    }
    /// Where what lies outboard turns with another angle: `beyond` is what of its costates goes on.
    #[inline(always)]
    fn summed(self, beyond: Option<[T; 2]>) -> Self {
        Self { along: T::zero(), across: T::zero(), lever: T::zero(), beyond, ..self }
    }
}

/// Sums of what there is.
#[cfg_attr(optimised, inline(always))]
fn sum<T: Scalar>(a: Option<[T; 2]>, b: Option<[T; 2]>) -> Option<[T; 2]> {
    match (a, b) {
        (Some(a), Some(b)) => Some([a[0] + b[0], a[1] + b[1]]),
        (one, None) | (None, one) => one,
    }
}

impl<T: Scalar> Add for Pulled<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn add(self, other: Self) -> Self {
        Self {
            momentum: self.momentum + other.momentum,
            force: self.force + other.force,
            along: self.along + other.along,
            across: self.across + other.across,
            lever: self.lever + other.lever,
            angular: self.angular + other.angular,
            beyond: sum(self.beyond, other.beyond),
        }
    }
}

impl<T: Scalar> Additive for Pulled<T> {
    #[inline(always)]
    fn null() -> Self {
        let (zero, none) = (T::zero(), Vector2::null());
        Self { momentum: none, force: none, along: zero, across: zero, lever: zero, angular: zero, beyond: None }
    }
}

impl<T: Scalar> Reversed for Planar<T> {
    type Pivot = T;
    /// None of its own: costates read what sweeps do.
    type Poses = Factor;

    #[cfg_attr(optimised, inline(always))]
    fn pose<E: Element<Self>>(
        elements: &E,
        position: &E::Position,
        rate: &E::Rate,
        turn: Turn<T>,
        sizes: &E::Store<PerAxes<T>>,
        x: &mut E::Store<PerAxes<T>>,
        y: &mut E::Store<PerAxes<T>>,
        p: &mut E::Store<PerAxes<T>>,
        q: &mut E::Store<PerAxes<T>>,
    ) {
        elements.pose(position, rate, turn, sizes, x, y, p, q);
    }
    fn no_pivot() -> T {
        T::zero()
    }
    fn of_nothing() -> (Base<T>, [T; BODY], [T; NUMBERS_OF_JOINT]) {
        let zero = T::zero();
        (
            Base { outboard: [zero; 2], moment: [zero; 2], inertia: zero, lumped: zero },
            [zero; BODY],
            [zero; NUMBERS_OF_JOINT],
        )
    }
}

impl<T: Scalar> VirtualMotion for Planar<T> {
    type Stirred = Stirred<T>;
    type OnBody = OnBody<T>;
    type InJoint = AtJoint<T>;
    type AtEnds = ();

    #[cfg_attr(optimised, inline(always))]
    fn at_ground(frame: &Frame<T>) -> Stirred<T> {
        let zero = T::zero();
        let turning = Turning { rate: frame.turn.rate, acceleration: frame.acceleration.angular, stirring: zero };
        Stirred { velocity: Acceleration { linear: Vector2::null(), angular: zero }, turning }
    }
    fn untouched() -> (OnBody<T>, AtJoint<T>, ()) {
        let (zero, velocity) = (T::zero(), Vector2::null());
        let turning = Turning { rate: zero, acceleration: zero, stirring: zero };
        (OnBody { velocity, acceleration: zero, stirring: zero }, AtJoint { turning, velocity }, ())
    }
    fn at_ends(_: &Stirred<T>, _: &Stirred<T>) {}
    fn stirred(stirred: &Stirred<T>) -> Acceleration<T> {
        stirred.velocity
    }
    fn of_body(kept: &OnBody<T>) -> Vector2<T> {
        kept.velocity
    }
    fn of_joint(kept: &AtJoint<T>) -> Vector2<T> {
        kept.velocity
    }
}

impl<T: Scalar> Costates for Planar<T> {
    type Pulled = Pulled<T>;
    type OfBody = Base<T>;
    type OfJoint = [T; NUMBERS_OF_JOINT];

    /// Torques do not turn with the body.
    fn pulled((weight, _): (Wrench<T>, &Acceleration<T>), (force, _): (Wrench<T>, &Acceleration<T>)) -> Pulled<T> {
        Pulled { momentum: weight.force, force: -force.force, angular: weight.torque, ..Pulled::null() }
    }
    #[inline(always)]
    fn of_ground(pulled: &Pulled<T>, frame: &Frame<T>) -> (Vector2<T>, T) {
        (pulled.momentum, pulled.turned(Self::at_ground(frame).turning)[0])
    }
    /// Links in the direction of their axes sum up d · d̄: their length l is constant, and d̄ along d is that over l.
    fn complete(size: &T, sums: &mut Base<T>) {
        if size.real() != num_traits::Zero::zero() {
            sums.outboard[0] *= size.recip();
        }
    }
}

impl<T: Scalar> LoadCostates for Planar<T> {
    type Felt = Felt<T>;
    type OfNumbers = [T; BODY];
    type OfTip = [T; TIP];

    fn no_tip() -> [T; TIP] {
        [T::zero(); TIP]
    }
    fn inboard(motion: &BodyMotion<T>) -> Frame<T> {
        motion.inboard
    }
    fn felt(of_place: Wrench<T>, of_velocity: Wrench<T>, _: &Turn<T>) -> Felt<T> {
        let turn = [of_place.torque, of_velocity.torque];
        Felt { place: of_place.force, velocity: of_velocity.force, turn, ..Felt::null() }
    }
    fn of_place(felt: &Felt<T>, _: &Frame<T>) -> (Vector2<T>, T) {
        (felt.place, felt.turn[0])
    }
}
