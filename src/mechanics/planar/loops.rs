//! Joints that close loops in the plane.

use super::ends::Compliance;
use super::{BodyMotion, Frame, Internal, JointMotion, Pin, Planar, RigidBody, SpringState, Turn, Weld};
use crate::chain::{Branch, CloseOff, Closing, Ends, LeastNorm, Network};
use crate::error::Fault;
use crate::relation::planar::algebra::Symmetric2;
use crate::relation::planar::{Full, FullColumn, Point};
use crate::relation::{Carry, Cut, Cuts, Forces, Own, Reacting, Shared, Symmetric, Term, Twisted, Wrenches};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// An arm that comes back to the body from which it leaves: a branch which is a loop. The chain goes on from the station where it stands.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(0.5, 1.0); // length (m), mass (kg)
/// let carriage = RigidBody::new(2.0, 0.1, [0.2, 0.0], [0.0, 0.0]); // it ends where it begins
/// // Three rods hang from the carriage, the last by a pin 0.8 m to the right of where the first hangs.
/// let swing = ClosedLoop::ending_at([0.8, 0.0], (Pin, rod, Pin, rod, Pin, rod), Pin);
/// let scene = System::new(Guided::at(0.0, 0.0, 0.0), (carriage, swing), Free)?.with_gravity(9.81);
/// # Ok::<(), catena::Error>(())
/// ```
pub type ClosedLoop<T, A, K> = Branch<Network<RigidBody<T>, A, K>>;

impl<T: Scalar, A, K> ClosedLoop<T, A, K> {
    /// An arm that leaves this station and ends at a point of the same body (m, from here, in axes of the body), by a joint.
    pub fn ending_at(place: [T; 2], arm: A, closing: K) -> Self {
        Branch(Network::new(RigidBody::massless(place), arm, closing))
    }
}

/// The joint from the side arm to the main one.
fn joint<T: Scalar>(side: &Frame<T>, main: &Frame<T>, turns: bool) -> JointMotion<T> {
    let none = T::zero();
    JointMotion {
        inboard: *side,
        outboard: *main,
        arm: Vector2::new(none, none),
        spring: SpringState { torque: none, force: [none; 2], energy: none },
        turns,
        slide: [none; 2],
        sliding: [none; 2],
        inertia: none,
    }
}

/// Forces of a pin: along x and y.
impl<T: Scalar> Closing<Planar<T>> for Pin {
    type Closures = Cut<2>;
    type PerAxes<X: Copy> = ();

    fn per_axes<X: Copy>(_: X) {}
    #[inline(always)]
    fn orient(&self, _: Turn<T>, _: Turn<T>, (): &mut (), (): &mut (), (): &mut (), (): &mut ()) {}
    fn joint(&self, side: &Frame<T>, main: &Frame<T>) -> JointMotion<T> {
        joint(side, main, true)
    }
    #[inline(always)]
    fn internal(&self, &[x, y]: &[T; 2], _: Ends<'_, Planar<T>, Self>) -> Internal<T> {
        Internal { force: Vector2::new(-x, -y), torque: T::zero() }
    }
    fn residual(&self, side: &Frame<T>, main: &Frame<T>) -> [[T; 2]; 2] {
        [(side.place - main.place).into(), (side.velocity - main.velocity).into()]
    }
    fn free_compliance(&self, body: &BodyMotion<T>) -> [T; 2] {
        let compliance = Compliance::of(body);
        let (zero, one) = (T::zero(), T::one());
        [compliance.along(Vector2::new(one, zero)), compliance.along(Vector2::new(zero, one))]
    }
    fn names(&self) -> [&'static str; 2] {
        ["x of the ends of a loop", "y of the ends of a loop"]
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

/// The pull of the forces of a pin on the side arm, and on the main one.
#[inline(always)]
pub(super) fn pulls<T: Scalar>(one: T) -> [Vector2<T>; 2] {
    [Vector2::new(one, T::zero()), Vector2::new(T::zero(), one)]
}

/// A pin that closes a loop with the forces `O`, two of them.
#[cfg_attr(optimised, inline(always))]
#[allow(clippy::type_complexity)] // what both arms meet, and what is passed on
fn close_pin<T, O, R, Q>(outer: R, torque: Q) -> (<R::Out as Twisted<Q::Reaction>>::Out, Point<T, Q, O>, Internal<T>)
where
    T: Scalar,
    O: Own,
    R: Carry<Planar<T>, O, Forces, Out: Twisted<Q::Reaction>>,
    Q: Reacting + Term<T>,
{
    // λ acts ON the side arm, so F on what lies outboard of it is −λ, and the opposite on what the main arm meets.
    let (pull, push) = (pulls(-T::one()), pulls(T::one()));
    let cuts = Cuts::at_tip(O::each(|k| pull[k]), O::each(|_| T::zero()));
    let offset = Vector2::new(T::zero(), T::zero());
    let side = Point { mass: Symmetric2::diagonal(T::zero()), offset, torque, cuts };
    // A torque τ ON the main arm's body is m = −τ.
    let passed = Internal { force: offset, torque: torque.take_from(T::zero()) };
    (outer.carry(O::each(|k| push[k])).twisted(torque.reaction()), side, passed)
}

/// A weld that does, three of them.
#[cfg_attr(optimised, inline(always))]
fn close_weld<T: Scalar, O: Own, R: Carry<Planar<T>, O, Wrenches>>(outer: R) -> (R::Out, Full<T, O>, Internal<T>) {
    let (pull, push) = (holds(-T::one()), holds(T::one()));
    let side = Full::massless().cut(Cuts::at_tip(O::each(|k| pull[k]), O::each(|_| T::zero())));
    (outer.carry(O::each(|k| push[k])), side, Internal::none())
}

macro_rules! close_off {
    ($Pin:ty, $Weld:ty, $Own:ident) => {
        impl<T, R, Q> CloseOff<Planar<T>, R, Q> for $Pin
        where
            T: Scalar,
            Q: Reacting + Term<T>,
            R: Carry<Planar<T>, $Own<2>, Forces, Out: Twisted<Q::Reaction>>,
        {
            type Main = <R::Out as Twisted<Q::Reaction>>::Out;
            type Side = Point<T, Q, $Own<2>>;

            #[cfg_attr(optimised, inline(always))]
            fn close_off(
                &self,
                outer: R,
                torque: Q,
                _: Ends<'_, Planar<T>, Self>,
            ) -> (Self::Main, Self::Side, Internal<T>) {
                close_pin(outer, torque)
            }
        }

        /// A torque in a weld does nothing.
        impl<T: Scalar, R: Carry<Planar<T>, $Own<3>, Wrenches>, Q> CloseOff<Planar<T>, R, Q> for $Weld {
            type Main = R::Out;
            type Side = Full<T, $Own<3>>;

            #[inline(always)]
            fn close_off(&self, outer: R, _: Q, _: Ends<'_, Planar<T>, Self>) -> (Self::Main, Self::Side, Internal<T>) {
                close_weld(outer)
            }
        }
    };
}
close_off!(Pin, Weld<T>, Cut);
close_off!(LeastNorm<Pin>, LeastNorm<Weld<T>>, Shared);

/// Forces of a weld: along x and y, and a torque. The main arm's last body stands at the angle of the weld to the side arm's.
impl<T: Scalar> Closing<Planar<T>> for Weld<T> {
    type Closures = Cut<3>;
    type PerAxes<X: Copy> = ();

    fn per_axes<X: Copy>(_: X) {}
    #[inline(always)]
    fn orient(&self, _: Turn<T>, _: Turn<T>, (): &mut (), (): &mut (), (): &mut (), (): &mut ()) {}
    fn joint(&self, side: &Frame<T>, main: &Frame<T>) -> JointMotion<T> {
        joint(side, main, false)
    }
    #[inline(always)]
    fn internal(&self, &[x, y, torque]: &[T; 3], _: Ends<'_, Planar<T>, Self>) -> Internal<T> {
        Internal { force: Vector2::new(-x, -y), torque }
    }
    fn residual(&self, side: &Frame<T>, main: &Frame<T>) -> [[T; 3]; 2] {
        let (place, velocity) = (side.place - main.place, side.velocity - main.velocity);
        let angle = side.turn.angle + self.angle() - main.turn.angle;
        [[place.x, place.y, angle], [velocity.x, velocity.y, side.turn.rate - main.turn.rate]]
    }
    fn free_compliance(&self, body: &BodyMotion<T>) -> [T; 3] {
        let [x, y] = Pin.free_compliance(body);
        [x, y, Compliance::of(body).torque]
    }
    fn names(&self) -> [&'static str; 3] {
        ["x of the ends of a loop", "y of the ends of a loop", "angle of the ends of a loop"]
    }
    fn check(&self) -> Result<(), Fault> {
        super::Joint::check(self)
    }
}

/// The pull of the forces of a weld.
#[cfg_attr(optimised, inline(always))]
pub(super) fn holds<T: Scalar>(one: T) -> [FullColumn<T>; 3] {
    let zero = Vector2::new(T::zero(), T::zero());
    let [x, y] = pulls(one);
    [FullColumn::of_force(x), FullColumn::of_force(y), FullColumn { force: zero, torque: one }]
}
