//! The elastic hinge with linear springs.

use super::elastic_hinge::{BallRule, Place};
use super::hinge_elimination::{RotaryElimination, SlideRule};
use super::loads::Drive;
use super::release::{self, Release};
use super::rotary_spring::RotaryLaw;
use super::stored::{StoredIn, Two};
use super::{Acceleration, ElasticHinge, Frame, Joint, JointMotion, Rotation, Spatial, Turn};
use crate::element::{Condense, Given, Implicit, InJoint, Posture, Reading, Springs, Sweep};
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::spatial::algebra::{Columns, Factor3, centripetal, cross, cross_onto, zero};
use crate::relation::spatial::{BallGain, Full, Relation, Rigid};
use crate::relation::{Absent, Closures};
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use nalgebra::Vector3;

/// Springs and dampers between the two points of a hinge, along the axes of the inboard body; [`Spring::none`](super::Spring::none) for
/// a direction in which nothing acts.
///
/// The coordinates are the components (m) of the vector d from the inboard to the outboard point. The force acts at the outboard
/// point, so m_O = m_I + d × q: (33)-(35) of the paper have m_O = m_I, which creates angular momentum. Momentum and energy are
/// conserved, and nothing depends on where the scene is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "X: serde::Serialize, Y: serde::Serialize, Z: serde::Serialize",
        deserialize = "X: serde::Deserialize<'de>, Y: serde::Deserialize<'de>, Z: serde::Deserialize<'de>, T: num_traits::Zero"
    ))
)]
pub struct Linear<T, X, Y, Z> {
    pub(super) x: X,
    pub(super) y: Y,
    pub(super) z: Z,
    /// Point mass (kg) that the outboard body lumps at its inboard end, in a scene.
    #[cfg_attr(feature = "serde", serde(skip, default = "num_traits::zero"))]
    lumped: T,
}

impl<T: Scalar, X: SpringLaw<T>, Y: SpringLaw<T>, Z: SpringLaw<T>> Linear<T, X, Y, Z> {
    pub(super) fn new(x: X, y: Y, z: Z) -> Self {
        Self { x, y, z, lumped: T::zero() }
    }

    /// Forces along the axes.
    #[inline(always)]
    pub(super) fn force(&self, [x, y, z]: [T; 3], [u, v, w]: [T; 3]) -> Vector3<T> {
        Vector3::new(self.x.force(x, u), self.y.force(y, v), self.z.force(z, w))
    }

    /// K̂ along the axes.
    #[inline(always)]
    pub(super) fn pivots(&self, [x, y, z]: [T; 3], [u, v, w]: [T; 3], springs: Implicit<T::Real>) -> Vector3<T> {
        Vector3::new(self.x.pivot(x, u, springs), self.y.pivot(y, v, springs), self.z.pivot(z, w, springs))
    }

    /// Point mass (kg) at the outboard point.
    #[inline(always)]
    pub(crate) fn lumped(&self) -> T {
        self.lumped
    }

    /// The laws along the axes.
    pub(crate) fn laws(&self) -> (&X, &Y, &Z) {
        (&self.x, &self.y, &self.z)
    }

    fn energy(&self, [x, y, z]: [T; 3]) -> T {
        self.x.energy(x) + self.y.energy(y) + self.z.energy(z)
    }
}

/// What eliminating rotation and displacement (in this order) leaves behind.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "BallGain<T, C>: serde::Serialize",
        deserialize = "BallGain<T, C>: serde::Deserialize<'de>, T: Scalar"
    ))
)]
pub struct LinearGains<T: Copy, C: Closures> {
    pub(super) rotation: BallGain<T, C>,
    pub(super) displacement: BallGain<T, C>,
    /// The pivot of the displacement, where costates ask for it.
    #[cfg_attr(feature = "serde", serde(skip, default = "no_factor"))]
    pub(super) factor: Factor3<T>,
}

/// No pivot yet.
fn no_factor<T: Scalar>() -> Factor3<T> {
    Factor3::of_number(T::zero())
}

impl<T, R, X, Y, Z> ElasticHinge<R, Linear<T, X, Y, Z>>
where
    T: Scalar,
    R: RotaryLaw<T>,
    X: SpringLaw<T>,
    Y: SpringLaw<T>,
    Z: SpringLaw<T>,
{
    /// The accelerations of the coordinates and of the outboard side, from those of the inboard one and of what is carried with it.
    #[cfg_attr(optimised, inline(always))]
    fn outward<C: Closures>(
        (inboard, carried, bias): (Vector3<T>, Acceleration<T>, Vector3<T>),
        [outer, inner]: &[Columns<T>; 2],
        (rotation, displacement): (&BallGain<T, C>, &BallGain<T, C>),
        multipliers: &C::Each<T>,
        rate: &mut ([T; 3], [T; 3]),
    ) -> Acceleration<T> {
        let moved = displacement.relative(carried.linear, inboard, multipliers);
        let linear = carried.linear + moved;
        let angular = inboard + bias;
        let turned = rotation.relative(linear, angular, multipliers);
        *rate = (inner.transposed(moved).into(), outer.transposed(turned).into());
        Acceleration { linear, angular: angular + turned }
    }
}

impl<T, R, X, Y, Z> Joint<T> for ElasticHinge<R, Linear<T, X, Y, Z>>
where
    T: Scalar,
    R: RotaryLaw<T>,
    X: SpringLaw<T>,
    Y: SpringLaw<T>,
    Z: SpringLaw<T>,
{
    type Position = ([T; 3], Rotation<T>);
    type Rate = ([T; 3], [T; 3]);
    type Kept<C: Closures> = LinearGains<T, C>;
    type Sets = Two;

    const LINEAR: bool = R::LINEAR && X::LINEAR && Y::LINEAR && Z::LINEAR;
    const ROTARY: bool = true;

    fn still() -> (Self::Position, Self::Rate) {
        (([T::zero(); 3], Rotation::identity()), ([T::zero(); 3], [T::zero(); 3]))
    }
    fn kept<C: Closures>() -> LinearGains<T, C> {
        LinearGains { rotation: BallGain::blank(), displacement: BallGain::blank(), factor: no_factor() }
    }
    fn is_finite<C: Closures>(kept: &LinearGains<T, C>) -> bool {
        kept.rotation.is_finite() && kept.displacement.is_finite()
    }
    fn lump(&mut self, mass: T) -> T {
        self.linear.lumped = mass;
        T::zero()
    }
    /// Three absolute angles 1-2-3; the displacement stays.
    fn configure(
        &self,
        position: &mut Self::Position,
        inboard: Turn<T>,
        next: &mut impl FnMut(Turn<T>) -> T,
    ) -> Turn<T> {
        ElasticHinge { rotary: self.rotary, linear: Absent }.configure(&mut position.1, inboard, next)
    }
    #[cfg_attr(optimised, inline(always))]
    fn oriented(&self, position: &Self::Position, rate: &Self::Rate, inboard: Turn<T>) -> (Turn<T>, StoredIn<T, Self>) {
        let (inner, spin) = (inboard.attitude, inboard.spin);
        let outer = inner.times(&position.1.matrix());
        let relative = outer.apply(Vector3::from(rate.1));
        let (arm, sliding) = (inner.apply(Vector3::from(position.0)), inner.apply(Vector3::from(rate.0)));
        let linear = cross_onto(spin, sliding + sliding, centripetal(spin, arm));
        let biases = [[linear, cross(spin, relative)], [arm, sliding]];
        (Turn { attitude: outer, spin: spin + relative }, ([outer, inner], biases))
    }
    #[inline(always)]
    fn release(&self, motion: &JointMotion<T>, position: &Self::Position, rate: &Self::Rate) -> Release<T> {
        release::elastic(self, motion, position, rate)
    }
    #[cfg_attr(optimised, inline(always))]
    fn moved(
        &self,
        inboard: Frame<T>,
        position: &Self::Position,
        rate: &Self::Rate,
        acceleration: &Self::Rate,
    ) -> JointMotion<T> {
        let (turn, ([outer, inner], [[linear, bias], [arm, sliding]])) = self.oriented(position, rate, inboard.turn);
        let carried = inboard.acceleration.shifted(arm, linear);
        let acceleration = Acceleration {
            linear: inner.apply_onto(Vector3::from(acceleration.0), carried.linear),
            angular: outer.apply_onto(Vector3::from(acceleration.1), carried.angular + bias),
        };
        let place = inboard.place + arm;
        let velocity = cross_onto(inboard.turn.spin, arm, inboard.velocity + sliding);
        let energy = self.rotary.energy(&position.1) + self.linear.energy(position.0);
        let outboard = Frame { place, velocity, turn, acceleration };
        let effort = self.rotary.torque(&position.1, &rate.1).into();
        JointMotion {
            inboard,
            outboard,
            position: position.1.log(),
            rate: rate.1,
            effort,
            energy,
            inertia: [T::zero(); 3],
        }
    }
    fn check(&self) -> Result<(), Fault> {
        self.rotary.check()?;
        self.linear.x.check()?;
        self.linear.y.check()?;
        self.linear.z.check()
    }
    #[cfg_attr(optimised, inline(always))]
    fn recovered<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        (axes, [[linear, bias], [arm, _]]): (&[Columns<T>; 2], &[[Vector3<T>; 2]; 2]),
        kept: &LinearGains<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut Self::Rate,
    ) -> Acceleration<T> {
        let carried = inboard.shifted(*arm, *linear);
        let gains = (&kept.rotation, &kept.displacement);
        Self::outward::<C>((inboard.angular, carried, *bias), axes, gains, multipliers, rate)
    }
    #[cfg_attr(optimised, inline(always))]
    fn responded<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        (axes, [_, [arm, _]]): (&[Columns<T>; 2], &[[Vector3<T>; 2]; 2]),
        kept: &LinearGains<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut Self::Rate,
    ) -> Acceleration<T> {
        let carried = inboard.swung(*arm);
        let gains = (&kept.rotation.homogeneous(), &kept.displacement.homogeneous());
        Self::outward::<C>((inboard.angular, carried, zero()), axes, gains, multipliers, rate)
    }
}

impl<T, S, X, Y, Z, R, W> Condense<Spatial<T>, R, W> for ElasticHinge<S, Linear<T, X, Y, Z>>
where
    T: Scalar,
    S: RotaryElimination<T, W::Springs>,
    X: SpringLaw<T>,
    Y: SpringLaw<T>,
    Z: SpringLaw<T>,
    R: Rigid<T>,
    W: Sweep<Spatial<T>, Springs: BallRule<T> + SlideRule<T>, Closures = R::Closures>,
    InJoint<Spatial<T>, W>: Drive<T>,
{
    type Out = Full<T, W::Closures>;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: R,
        posture: Posture<'_, Spatial<T>, Self>,
        given: Given<'_, Spatial<T>, Self, W>,
        kept: &mut LinearGains<T, W::Closures>,
    ) -> Self::Out {
        let Given { in_joints, position, rate, reading, springs, .. } = given;
        let ([outboard, inboard], [[linear, bias], [arm, _]]) = (posture.x, posture.y);
        let Reading { position: there, rate: moving, acceleration: led } = reading;
        let reading = Reading { position: &there.1, rate: &moving.1, acceleration: &led.1 };
        let place = Place { attitude: *outboard, state: (&position.1, &rate.1), reading };
        let outer = outer.full().with_mass(self.linear.lumped);
        let (relation, rotation) = self.rotary.turn(springs, outer, in_joints.couple(outboard), place, *bias);
        // Laws that are not linear are read where the last sweep has led.
        let follows = const { !(X::LINEAR && Y::LINEAR && Z::LINEAR) && <W::Springs as Springs<T>>::STIFF };
        let (place, sliding) = if follows { (there.0, moving.0) } else { (position.0, rate.0) };
        let (force, led) = (self.linear.force(place, sliding), follows.then(|| Vector3::from(led.0)));
        let pivots = |springs| self.linear.pivots(place, sliding, springs);
        let (relation, displacement) = springs.slide(relation, inboard, force, led, pivots);
        (kept.rotation, kept.displacement) = (rotation, displacement);
        relation.carried(*arm, *linear)
    }
}

lift!(Linear<T, X, Y, Z> { x, y, z, lumped });
