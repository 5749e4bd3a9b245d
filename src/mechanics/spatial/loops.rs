//! Joints that close loops in space.

use super::away::{tilted_away, turned_away};
use super::ends::Compliance;
use super::{Ball, BodyMotion, Drive, Frame, Internal, Joint, JointMotion, Revolute, RigidBody, Spatial, Turn, Weld};
use crate::chain::{Branch, CloseOff, Closing, Ends, LeastNorm, Network};
use crate::error::Fault;
use crate::relation::spatial::algebra::{Columns, Symmetric3, cross, dot, zero};
use crate::relation::spatial::{Couple, Full, FullColumn, Point};
use crate::relation::{Carry, Cut, Cuts, Forces, Reacting, Shared, Symmetric, Term, Twisted, Wrenches};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// An arm that comes back to the body from which it leaves: a branch which is a loop. The chain goes on from the station where it stands.
///
/// ```
/// use catena::spatial::*;
/// let rod = Rod::uniform(0.5, 0.01, 1.0); // length, radius (m), mass (kg)
/// // Three rods between two balls of the body that carries them, 0.8 m apart.
/// let swing = ClosedLoop::ending_at([0.8, 0.0, 0.0], (Ball, rod, Ball, rod, Ball, rod), Ball);
/// let scene = System::new(Pinned::origin(), (rod, swing, Ball, rod), Free)?.with_gravity([0.0, -9.81, 0.0]);
/// # Ok::<(), catena::Error>(())
/// ```
pub type ClosedLoop<T, A, K> = Branch<Network<RigidBody<T>, A, K>>;

impl<T: Scalar, A, K> ClosedLoop<T, A, K> {
    /// An arm that leaves this station and ends at a point of the same body (m, from here, in axes of the body), by a joint.
    pub fn ending_at(place: [T; 3], arm: A, closing: K) -> Self {
        Branch(Network::new(RigidBody::massless(place), arm, closing))
    }
}

fn joint<T: Scalar>(side: &Frame<T>, main: &Frame<T>) -> JointMotion<T> {
    let relative = main.turn.attitude.transposed(main.turn.spin - side.turn.spin);
    let none = [T::zero(); 3];
    JointMotion {
        inboard: *side,
        outboard: *main,
        position: none,
        rate: relative.into(),
        effort: none,
        energy: T::zero(),
        inertia: none,
    }
}

/// The pull of forces along x, y and z.
#[inline(always)]
pub(super) fn pulls<T: Scalar>(i: T) -> [Vector3<T>; 3] {
    let o = T::zero();
    [Vector3::new(i, o, o), Vector3::new(o, i, o), Vector3::new(o, o, i)]
}

/// The attitude of the end of the main arm, for a torque in the ball.
impl<T: Scalar> Closing<Spatial<T>> for Ball {
    type Closures = Cut<3>;
    type PerAxes<X: Copy> = X;

    fn per_axes<X: Copy>(fill: X) -> X {
        fill
    }
    #[cfg_attr(optimised, inline(always))]
    fn orient(
        &self,
        _: Turn<T>,
        main: Turn<T>,
        x: &mut Columns<T>,
        _: &mut [Vector3<T>; 2],
        _: &mut Vector3<T>,
        _: &mut Vector3<T>,
    ) {
        *x = main.attitude;
    }
    fn joint(&self, side: &Frame<T>, main: &Frame<T>) -> JointMotion<T> {
        joint(side, main)
    }
    #[inline(always)]
    fn internal(&self, forces: &[T; 3], _: Ends<'_, Spatial<T>, Self>) -> Internal<T> {
        Internal { force: -Vector3::from(*forces), torque: zero() }
    }
    fn residual(&self, side: &Frame<T>, main: &Frame<T>) -> [[T; 3]; 2] {
        [(side.place - main.place).into(), (side.velocity - main.velocity).into()]
    }
    fn free_compliance(&self, body: &BodyMotion<T>) -> [T; 3] {
        Compliance::of(body).along_axes()
    }
    fn names(&self) -> [&'static str; 3] {
        PLACES
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

const PLACES: [&str; 3] = ["x of the ends of a loop", "y of the ends of a loop", "z of the ends of a loop"];

/// Columns of forces along x, y and z, and of torques.
#[cfg_attr(optimised, inline(always))]
pub(super) fn holds<T: Scalar, const L: usize>(one: T, torques: impl Fn(usize) -> Vector3<T>) -> [FullColumn<T>; L] {
    let pulls = pulls(one);
    core::array::from_fn(|k| match pulls.get(k) {
        Some(force) => FullColumn::of_force(*force),
        None => FullColumn { force: zero(), torque: torques(k - 3) * one },
    })
}

/// The main arm's last body stands at the attitude of the weld to the side arm's.
impl<T: Scalar> Closing<Spatial<T>> for Weld<T> {
    type Closures = Cut<6>;
    type PerAxes<X: Copy> = ();

    fn per_axes<X: Copy>(_: X) {}
    #[inline(always)]
    fn orient(&self, _: Turn<T>, _: Turn<T>, (): &mut (), (): &mut (), (): &mut (), (): &mut ()) {}
    fn joint(&self, side: &Frame<T>, main: &Frame<T>) -> JointMotion<T> {
        JointMotion { rate: [T::zero(); 3], ..joint(side, main) }
    }
    #[inline(always)]
    fn internal(&self, &[a, b, c, d, e, f]: &[T; 6], _: Ends<'_, Spatial<T>, Self>) -> Internal<T> {
        Internal { force: -Vector3::new(a, b, c), torque: Vector3::new(d, e, f) }
    }
    fn residual(&self, side: &Frame<T>, main: &Frame<T>) -> [[T; 6]; 2] {
        let (place, velocity) = (side.place - main.place, side.velocity - main.velocity);
        let (own, held) = (side.turn.attitude.times(self.attitude()), main.turn.attitude);
        let (turn, spin) = (turned_away(&held, &own), side.turn.spin - main.turn.spin);
        [
            [place.x, place.y, place.z, turn.x, turn.y, turn.z],
            [velocity.x, velocity.y, velocity.z, spin.x, spin.y, spin.z],
        ]
    }
    fn free_compliance(&self, body: &BodyMotion<T>) -> [T; 6] {
        let compliance = Compliance::of(body);
        let ([x, y, z], turn) = (compliance.along_axes(), compliance.torque);
        [x, y, z, turn, turn, turn]
    }
    fn names(&self) -> [&'static str; 6] {
        let [x, y, z] = PLACES;
        [
            x,
            y,
            z,
            "turn of the ends of a loop about x",
            "turn of the ends of a loop about y",
            "turn of the ends of a loop about z",
        ]
    }
    fn check(&self) -> Result<(), Fault> {
        Joint::check(self)
    }
}

/// Two directions normal to a unit vector and to each other, so that the three are right-handed (Duff et al. 2017).
fn normals<T: Scalar>(u: Vector3<T>) -> [Vector3<T>; 2] {
    let one = T::one();
    let sign = u.z.if_negative(-one, one);
    let a = -(sign + u.z).recip();
    let b = u.x * u.y * a;
    let first = Vector3::new(one + sign * u.x * u.x * a, sign * b, -(sign * u.x));
    [first, Vector3::new(b, sign + u.y * u.y * a, -u.y)]
}

/// Forces of a revolute: along x, y and z, and torques about two directions normal to its axis in the main arm's last body. The axis has
/// the same components in axes of both bodies.
impl<T: Scalar> Closing<Spatial<T>> for Revolute<T> {
    type Closures = Cut<5>;
    /// The normals, and the accelerations that turning with the main arm demands about them.
    type PerAxes<X: Copy> = X;

    fn per_axes<X: Copy>(fill: X) -> X {
        fill
    }
    #[cfg_attr(optimised, inline(always))]
    fn orient(
        &self,
        side: Turn<T>,
        main: Turn<T>,
        _: &mut Columns<T>,
        normal: &mut [Vector3<T>; 2],
        demand: &mut Vector3<T>,
        _: &mut Vector3<T>,
    ) {
        *normal = normals(self.axis()).map(|e| main.attitude.apply(e));
        let relative = side.spin - main.spin;
        // The derivative of e · (ω_s − ω_m) = 0, with e' = ω_m × e.
        let turning = normal.map(|e| dot(cross(main.spin, e), relative));
        *demand = Vector3::new(turning[0], turning[1], T::zero());
    }
    fn joint(&self, side: &Frame<T>, main: &Frame<T>) -> JointMotion<T> {
        let (zero, u) = (T::zero(), main.turn.attitude.apply(self.axis()));
        let rate = dot(u, main.turn.spin - side.turn.spin);
        let [e, _] = normals(self.axis());
        let (from, to) = (side.turn.attitude.apply(e), main.turn.attitude.apply(e));
        let angle = dot(u, cross(from, to)).atan2(dot(from, to));
        JointMotion { position: [angle, zero, zero], rate: [rate, zero, zero], ..joint(side, main) }
    }
    #[inline(always)]
    fn internal(&self, &[x, y, z, e, f]: &[T; 5], axes: Ends<'_, Spatial<T>, Self>) -> Internal<T> {
        Internal { force: -Vector3::new(x, y, z), torque: axes.y[0] * e + axes.y[1] * f }
    }
    fn residual(&self, side: &Frame<T>, main: &Frame<T>) -> [[T; 5]; 2] {
        let (place, velocity) = (side.place - main.place, side.velocity - main.velocity);
        let [e, f] = normals(self.axis()).map(|e| main.turn.attitude.apply(e));
        let (own, held) = (side.turn.attitude.apply(self.axis()), main.turn.attitude.apply(self.axis()));
        let ([one, two], spin) = (tilted_away(held, own, [e, f]), side.turn.spin - main.turn.spin);
        [[place.x, place.y, place.z, one, two], [velocity.x, velocity.y, velocity.z, dot(e, spin), dot(f, spin)]]
    }
    fn free_compliance(&self, body: &BodyMotion<T>) -> [T; 5] {
        let compliance = Compliance::of(body);
        let ([x, y, z], turn) = (compliance.along_axes(), compliance.torque);
        [x, y, z, turn, turn]
    }
    fn names(&self) -> [&'static str; 5] {
        let [x, y, z] = PLACES;
        [x, y, z, "tilt of the ends of a loop", "tilt of the ends of a loop"]
    }
    fn check(&self) -> Result<(), Fault> {
        Joint::check(self)
    }
}

macro_rules! close_off {
    ($Ball:ty, $Weld:ty, $Revolute:ty, $Own:ident) => {
        impl<T, R, Q> CloseOff<Spatial<T>, R, Q> for $Ball
        where
            T: Scalar,
            Q: Drive<T, Couple: Reacting>,
            R: Carry<Spatial<T>, $Own<3>, Forces, Out: Twisted<<Q::Couple as Reacting>::Reaction>>,
        {
            type Main = <R::Out as Twisted<<Q::Couple as Reacting>::Reaction>>::Out;
            type Side = Point<T, Q::Couple, $Own<3>>;

            #[cfg_attr(optimised, inline(always))]
            fn close_off(
                &self,
                outer: R,
                torque: Q,
                axes: Ends<'_, Spatial<T>, Self>,
            ) -> (Self::Main, Self::Side, Internal<T>) {
                // λ acts ON the side arm, so F on what lies outboard of it is −λ, and the opposite on what the main arm meets.
                let cuts = Cuts::at_tip(pulls(-T::one()), [T::zero(); 3]);
                let torque = torque.couple(axes.x);
                let side = Point { mass: Symmetric3::diagonal(T::zero()), offset: zero(), torque, cuts };
                // A torque τ ON the main arm's body is m = −τ.
                let passed = Internal { force: zero(), torque: torque.take_from(zero()) };
                (outer.carry(pulls(T::one())).twisted(torque.reaction()), side, passed)
            }
        }

        /// Efforts in a weld do nothing.
        impl<T: Scalar, R: Carry<Spatial<T>, $Own<6>, Wrenches>, Q> CloseOff<Spatial<T>, R, Q> for $Weld {
            type Main = R::Out;
            type Side = Full<T, $Own<6>>;

            #[cfg_attr(optimised, inline(always))]
            fn close_off(
                &self,
                outer: R,
                _: Q,
                _: Ends<'_, Spatial<T>, Self>,
            ) -> (Self::Main, Self::Side, Internal<T>) {
                let axes = pulls(T::one());
                let cuts = Cuts::at_tip(holds(-T::one(), |k| axes[k]), [T::zero(); 6]);
                (outer.carry(holds(T::one(), |k| axes[k])), Full::massless().cut(cuts), Internal::none())
            }
        }

        impl<T, R, Q> CloseOff<Spatial<T>, R, Q> for $Revolute
        where
            T: Scalar,
            Q: Drive<T>,
            R: Carry<Spatial<T>, $Own<5>, Wrenches, Out: Twisted<Couple<T>>>,
        {
            type Main = <R::Out as Twisted<Couple<T>>>::Out;
            type Side = Full<T, $Own<5>>;

            #[cfg_attr(optimised, inline(always))]
            fn close_off(
                &self,
                outer: R,
                effort: Q,
                Ends { y: normal, p: demand, .. }: Ends<'_, Spatial<T>, Self>,
            ) -> (Self::Main, Self::Side, Internal<T>) {
                let none = T::zero();
                let gap = [none, none, none, demand.x, demand.y];
                let cuts = Cuts::at_tip(holds(-T::one(), |k| normal[k]), gap);
                let torque = cross(normal[0], normal[1]) * effort.onto(0, none);
                let side = Full { torque, ..Full::massless().cut(cuts) };
                let passed = Internal { force: zero(), torque: -torque };
                (outer.carry(holds(T::one(), |k| normal[k])).twisted(Couple(-torque)), side, passed)
            }
        }
    };
}
close_off!(Ball, Weld<T>, Revolute<T>, Cut);
close_off!(LeastNorm<Ball>, LeastNorm<Weld<T>>, LeastNorm<Revolute<T>>, Shared);
