//! The elastic hinge with linear springs.

use super::linear::{HingeAxes, Linear};
use super::{
    Acceleration, ElasticHinge, Frame, HingeRule, Joint, JointMotion, Planar, Spring, SpringState, Turn, release,
};
use crate::element::{Condense, Given, InJoint, Posture, Reading, Springs, Sweep};
use crate::error::Fault;
use crate::relation::planar::{Full, Point, Relation, RelativeGain, Rigid, Slides};
use crate::relation::{Absent, Closures, Coefficient, Term};
use crate::release::Release;
use crate::scalar::Scalar;
use crate::spring::{Custom, SpringLaw, read};
use nalgebra::Vector2;

/// The rotation of a hinge in a sweep whose springs enter by `K`: against a spring, or free.
pub trait Rotation<T: Scalar, K: Springs<T>>: SpringLaw<T> {
    /// The relation with the rotation eliminated.
    type Out<C: Closures>: Slides<T, Closures = C>;
    /// Eliminates the rotation against a torque, and what a spring adds to the pivot.
    fn turn<C: Closures>(
        &self,
        springs: K,
        torque: T,
        pivot: T,
        outer: Full<T, C>,
        kept: &mut RelativeGain<T, C>,
    ) -> Self::Out<C>;
}

impl<T: Scalar, K: HingeRule<T>, D: Coefficient<T>, P: Term<T>> Rotation<T, K> for Spring<T, D, P> {
    type Out<C: Closures> = K::Out<C>;

    #[cfg_attr(optimised, inline(always))]
    fn turn<C: Closures>(
        &self,
        springs: K,
        torque: T,
        pivot: T,
        outer: Full<T, C>,
        kept: &mut RelativeGain<T, C>,
    ) -> K::Out<C> {
        springs.hinge(torque, pivot, outer, kept)
    }
}

impl<T: Scalar, K: HingeRule<T>, L: SpringLaw<T>> Rotation<T, K> for Custom<L> {
    type Out<C: Closures> = K::Out<C>;

    #[cfg_attr(optimised, inline(always))]
    fn turn<C: Closures>(
        &self,
        springs: K,
        torque: T,
        pivot: T,
        outer: Full<T, C>,
        kept: &mut RelativeGain<T, C>,
    ) -> K::Out<C> {
        springs.hinge(torque, pivot, outer, kept)
    }
}

impl<T: Scalar, K: Springs<T>> Rotation<T, K> for Absent {
    type Out<C: Closures> = Point<T, T, C>;

    #[cfg_attr(optimised, inline(always))]
    fn turn<C: Closures>(
        &self,
        _: K,
        torque: T,
        _: T,
        outer: Full<T, C>,
        kept: &mut RelativeGain<T, C>,
    ) -> Self::Out<C> {
        let (relation, gain) = outer.pinned(torque);
        kept.absolute(gain);
        relation
    }
}

/// What eliminating rotation, y and x (in this order) leaves behind.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "RelativeGain<T, C>: serde::Serialize, Vector2<T>: serde::Serialize, T: serde::Serialize",
        deserialize = "RelativeGain<T, C>: serde::Deserialize<'de>, Vector2<T>: serde::Deserialize<'de>, T: serde::Deserialize<'de>"
    ))
)]
pub struct LinearGains<T: Copy, C: Closures> {
    pub(super) rotation: RelativeGain<T, C>,
    pub(super) y: RelativeGain<T, C>,
    pub(super) x: RelativeGain<T, C>,
    /// Inverse pivots of x, y and rotation: what only costates ask for, and sweeps do not write.
    pub(super) pivots: [T; 3],
    /// What the inboard body's angular acceleration added to the second derivatives of the coordinates (m/s²), last time.
    swing: Vector2<T>,
}

impl<T: Scalar, R, X, Y, A> ElasticHinge<R, Linear<T, X, Y, A>> {
    /// Laws of the hinge, of its rotation and along both axes, and the point mass (kg) at its outboard point.
    pub(crate) fn parts(&self) -> ((&R, &X, &Y), T) {
        ((&self.rotary, &self.linear.x, &self.linear.y), self.linear.lumped)
    }
}

/// The coordinates are the displacement along the axes (m) and the relative angle (rad).
impl<T: Scalar, R: SpringLaw<T>, X: SpringLaw<T>, Y: SpringLaw<T>, A> Joint<T> for ElasticHinge<R, Linear<T, X, Y, A>>
where
    A: HingeAxes,
{
    type Position = (T, T, T);
    type Rate = (T, T, T);
    type Kept<C: Closures> = LinearGains<T, C>;
    type Axes = A;

    const LINEAR: bool = R::LINEAR && X::LINEAR && Y::LINEAR;

    fn still() -> ((T, T, T), (T, T, T)) {
        ((T::zero(), T::zero(), T::zero()), (T::zero(), T::zero(), T::zero()))
    }
    fn kept<C: Closures>() -> LinearGains<T, C> {
        let (swing, pivots) = (Vector2::new(T::zero(), T::zero()), [T::zero(); 3]);
        let blank = RelativeGain::blank;
        LinearGains { rotation: blank(), y: blank(), x: blank(), pivots, swing }
    }
    #[inline(always)]
    fn homogeneous<C: Closures>(kept: &LinearGains<T, C>) -> LinearGains<T, C> {
        let LinearGains { rotation, y, x, .. } = kept;
        LinearGains { rotation: rotation.homogeneous(), y: y.homogeneous(), x: x.homogeneous(), ..*kept }
    }
    fn is_finite<C: Closures>(kept: &LinearGains<T, C>) -> bool {
        kept.rotation.is_finite() && kept.y.is_finite() && kept.x.is_finite()
    }
    fn lump(&mut self, mass: T) -> T {
        self.linear.lumped = mass;
        T::zero()
    }
    fn configure(&self, position: &mut (T, T, T), inboard: Turn<T>, next: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
        let angle = next(inboard);
        position.2 = angle - inboard.angle;
        Turn { angle, rate: T::zero() }
    }
    #[inline(always)]
    fn turned(&self, position: &(T, T, T), rate: &(T, T, T), inboard: Turn<T>) -> Turn<T> {
        Turn { angle: inboard.angle + position.2, rate: inboard.rate + rate.2 }
    }
    #[cfg_attr(optimised, inline(always))]
    fn orient(
        &self,
        position: &(T, T, T),
        rate: &(T, T, T),
        inboard: Turn<T>,
        x: &mut A::Per<T>,
        y: &mut A::Per<T>,
        p: &mut A::Per<T>,
        q: &mut A::Per<T>,
    ) -> Turn<T> {
        A::store(inboard, [[position.0, position.1], [rate.0, rate.1]], x, y, p, q);
        self.turned(position, rate, inboard)
    }
    #[cfg_attr(optimised, inline(always))]
    fn moved(
        &self,
        inboard: Frame<T>,
        position: &(T, T, T),
        rate: &(T, T, T),
        acceleration: &(T, T, T),
    ) -> JointMotion<T> {
        let coordinates = [position, rate, acceleration].map(|c| Vector2::new(c.0, c.1));
        let frame = A::moved(inboard, coordinates);
        let angular = frame.acceleration.angular + acceleration.2;
        let outboard = Frame {
            turn: self.turned(position, rate, inboard.turn),
            acceleration: Acceleration { angular, ..frame.acceleration },
            ..frame
        };
        let (slide, sliding) = ([position.0, position.1], [rate.0, rate.1]);
        let linear = self.linear.x.energy(position.0) + self.linear.y.energy(position.1);
        let spring = SpringState {
            torque: self.rotary.force(position.2, rate.2),
            force: self.linear.forces(slide, sliding),
            energy: self.rotary.energy(position.2) + linear,
        };
        let motion = JointMotion { spring, slide, sliding, ..JointMotion::coincident(inboard, outboard, true) };
        if A::LEVER { JointMotion { arm: outboard.place - inboard.place, ..motion } } else { motion }
    }
    fn check(&self) -> Result<(), Fault> {
        self.rotary.check()?;
        self.linear.x.check()?;
        self.linear.y.check()
    }
    fn release(&self, motion: &JointMotion<T>, position: &(T, T, T), rate: &(T, T, T)) -> Release<Planar<T>> {
        release::elastic(self, motion, position, rate)
    }
    #[cfg_attr(optimised, inline(always))]
    fn recovered<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        offset: A::Offset<T>,
        kept: &LinearGains<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut (T, T, T),
    ) -> Acceleration<T> {
        let carried = A::carried(inboard, offset);
        let mut along = A::components(carried.linear, offset);
        let x = kept.x.relative(along, carried.angular, multipliers);
        along.x += x;
        let y = kept.y.relative(along, carried.angular, multipliers);
        let moved = Vector2::new(x, y);
        let linear = carried.linear + A::inertial(moved, offset);
        let angular = kept.rotation.relative(linear, carried.angular, multipliers);
        let coordinates = A::coordinates(moved, linear - inboard.linear);
        *rate = (coordinates.x, coordinates.y, angular);
        Acceleration { linear, angular: carried.angular + angular }
    }
    #[cfg_attr(optimised, inline(always))]
    fn recovered_after<C: Closures, By: Springs<T>>(
        &self,
        inboard: Acceleration<T>,
        offset: A::Offset<T>,
        kept: &mut LinearGains<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut (T, T, T),
    ) -> Acceleration<T> {
        kept.swing = A::swing(inboard, offset);
        self.recovered::<C>(inboard, offset, kept, multipliers, rate)
    }
}

impl<T, R, X, Y, A, O, W> Condense<Planar<T>, O, W> for ElasticHinge<R, Linear<T, X, Y, A>>
where
    T: Scalar,
    R: Rotation<T, W::Springs>,
    X: SpringLaw<T>,
    Y: SpringLaw<T>,
    A: HingeAxes,
    O: Rigid<T>,
    W: Sweep<Planar<T>, Closures = O::Closures>,
    InJoint<Planar<T>, W>: Term<T>,
{
    type Out = Full<T, W::Closures>;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: O,
        posture: Posture<'_, Planar<T>, Self>,
        given: Given<'_, Planar<T>, Self, W>,
        kept: &mut LinearGains<T, W::Closures>,
    ) -> Self::Out {
        let offset = super::joint::offset::<T, Self>(posture);
        let Given { in_joints, position, rate, reading, springs, .. } = given;
        // Of coordinate k.
        macro_rules! led {
            ($k:tt) => {
                Reading {
                    position: &reading.position.$k,
                    rate: &reading.rate.$k,
                    acceleration: &reading.acceleration.$k,
                }
            };
        }
        let [torque, pivot] = read(&self.rotary, (position.2, rate.2), led!(2), springs);
        let [fx, kx] = read(&self.linear.x, (position.0, rate.0), led!(0), springs);
        let [fy, ky] = read(&self.linear.y, (position.1, rate.1), led!(1), springs);
        let swing = kept.swing;
        let (fx, fy) = (kx.mul_add(-swing.x, fx), ky.mul_add(-swing.y, fy));
        let outer = outer.full().with_mass(self.linear.lumped);
        let relation = self.rotary.turn(springs, in_joints.add_to(torque), pivot, outer, &mut kept.rotation);
        let (relation, y) = A::enter(relation, offset).swapped().slid(fy, ky);
        let (relation, x) = relation.swapped().slid(fx, kx);
        (kept.y, kept.x) = (y.swapped(), x);
        A::leave(relation, offset)
    }
}
