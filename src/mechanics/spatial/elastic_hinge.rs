//! The elastic hinge: a joint with springs and dampers.

use super::loads::Drive;
use super::release::{self, Release};
use super::rotary_spring::{RotaryLaw, RotarySpring};
use super::stored::{One, Stored};
use super::{Acceleration, Frame, Joint, JointMotion, Linear, Rotation, Spatial, Turn};
use crate::element::{Condense, Explicit, Given, Implicit, InJoint, Posture, Reading, Springs, Sweep};
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::spatial::algebra::{Columns, Symmetric3, cross, zero};
use crate::relation::spatial::{BallGain, Couple, Full, Point, Rigid, Slides};
use crate::relation::{Absent, Closures, Symmetric, Term};
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use nalgebra::Vector3;

/// A joint with springs and dampers: rotary ones, and linear ones where there are any (see [`Linear`]). Without linear springs its
/// points coincide: it is an [`ElasticBall`].
///
/// The rotary spring stores V = ½ (φ − φ₀)ᵀ K (φ − φ₀) for the rotation vector φ of the outboard body relative to the inboard one, with
/// stiffnesses K along axes of the inboard body. (33)-(35) of the paper multiply differences of angles along inertial axes instead,
/// which is neither conservative nor the same in all inertial axes, and balance no moment of the force. The spring follows relative
/// turns of up to one whole turn: so quaternions with w < 0 have turned by more than half a turn. One that is set by hand, from a source
/// that does not care for its sign, is to be the [`shortest`](Rotation::shortest): −1 has turned by a whole turn about no axis,
/// where the torque is not a number. A stiffness may have any finite value; an infinite one is a [`Weld`](super::Weld).
///
/// Its coordinates are the attitude relative to the inboard body, with the relative angular velocity in axes of the outboard body as its
/// rate; before them, where there are linear springs, the displacement along axes of the inboard body (m). Loads in the joint are
/// torques in axes of the outboard body.
///
/// All rules keep their order on it. [`GeneralizedAlpha`](crate::time::GeneralizedAlpha) takes the law of the rotary spring at the attitude
/// without the acceleration sought, [`Sdirk4`](crate::time::Sdirk4) at that of the sweep before.
///
/// ```
/// use catena::spatial::*;
/// let rod = Rod::uniform(0.5, 0.05, 1.0);
/// let rubber = Spring::stiffness(1e4).damped(20.0); // (N/m), (N·s/m)
/// let hinge = ElasticHinge::rotary([20.0, 5.0, 20.0]) // (N·m/rad)
///     .damped(0.01) // (N·m·s/rad)
///     .resting_at([0.0, 0.0, 0.3]) // rotation vector (rad)
///     .with_linear(rubber, rubber, Spring::none());
/// let mount = System::new(Clamped::origin(), (rod, hinge, rod), Free)?.with_gravity([0.0, -9.81, 0.0]);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ElasticHinge<R, L = Absent> {
    pub(super) rotary: R,
    pub(super) linear: L,
}

/// A ball joint with a rotary spring: an [`ElasticHinge`] whose points coincide.
///
/// ```
/// use catena::spatial::*;
/// let rod = Rod::uniform(0.5, 0.05, 1.0);
/// let joint = ElasticBall::rotary([20.0, 5.0, 20.0]).damped(0.01); // (N·m/rad), (N·m·s/rad)
/// let blade = System::new(Clamped::origin(), (rod, joint, rod), Free)?.with_gravity([0.0, -9.81, 0.0]);
/// # Ok::<(), catena::Error>(())
/// ```
pub type ElasticBall<T, D = Absent, P = Absent> = ElasticHinge<RotarySpring<T, D, P>>;

impl<T: Scalar> ElasticHinge<RotarySpring<T>> {
    /// With stiffnesses (N·m/rad) about the axes of the inboard body.
    pub fn rotary(stiffness: [T; 3]) -> Self {
        Self { rotary: RotarySpring { stiffness, damping: Absent, rest: Absent }, linear: Absent }
    }
}

impl<T: Scalar, X: SpringLaw<T>, Y: SpringLaw<T>, Z: SpringLaw<T>> ElasticHinge<Absent, Linear<T, X, Y, Z>> {
    /// Springs along the axes of the inboard body, between bodies that turn freely.
    pub fn linear(x: X, y: Y, z: Z) -> Self {
        Self { rotary: Absent, linear: Linear::new(x, y, z) }
    }
}

impl<T: Scalar, P, L> ElasticHinge<RotarySpring<T, Absent, P>, L> {
    /// With a rotary damper (N·m·s/rad), alike about all axes.
    pub fn damped(self, damping: T) -> ElasticHinge<RotarySpring<T, T, P>, L> {
        let RotarySpring { stiffness, rest, .. } = self.rotary;
        ElasticHinge { rotary: RotarySpring { stiffness, damping, rest }, linear: self.linear }
    }

    /// With rotary dampers (N·m·s/rad) about the axes of the inboard body.
    pub fn damped_about(self, damping: [T; 3]) -> ElasticHinge<RotarySpring<T, [T; 3], P>, L> {
        let RotarySpring { stiffness, rest, .. } = self.rotary;
        ElasticHinge { rotary: RotarySpring { stiffness, damping, rest }, linear: self.linear }
    }
}

impl<T: Scalar, D, L> ElasticHinge<RotarySpring<T, D>, L> {
    /// At rest where the rotation vector (rad) of the outboard body relative to the inboard one is this.
    pub fn resting_at(self, rest: [T; 3]) -> ElasticHinge<RotarySpring<T, D, [T; 3]>, L> {
        let RotarySpring { stiffness, damping, .. } = self.rotary;
        ElasticHinge { rotary: RotarySpring { stiffness, damping, rest }, linear: self.linear }
    }
}

impl<R, L> ElasticHinge<R, L> {
    /// What resists relative rotation, and displacements.
    pub(crate) fn parts(&self) -> (&R, &L) {
        (&self.rotary, &self.linear)
    }
}

impl<R> ElasticHinge<R> {
    /// With a law of the user's own between points that coincide, see [`RotaryLaw`].
    pub fn with(law: R) -> Self {
        Self { rotary: law, linear: Absent }
    }

    /// What resists relative rotation.
    pub(crate) fn law(&self) -> &R {
        &self.rotary
    }

    /// With springs along the axes of the inboard body.
    pub fn with_linear<T: Scalar, X: SpringLaw<T>, Y: SpringLaw<T>, Z: SpringLaw<T>>(
        self,
        x: X,
        y: Y,
        z: Z,
    ) -> ElasticHinge<R, Linear<T, X, Y, Z>> {
        ElasticHinge { rotary: self.rotary, linear: Linear::new(x, y, z) }
    }
}

/// Where a rotary spring is read: the attitude of the outboard body, and relative attitude and angular velocity, from a reading
/// where there is one.
pub struct Place<'a, T> {
    /// Attitude of the outboard body.
    pub attitude: Columns<T>,
    /// Where laws are read in an explicit sweep.
    pub state: (&'a Rotation<T>, &'a [T; 3]),
    /// Where laws are read in an implicit sweep.
    pub reading: Reading<'a, Rotation<T>, [T; 3]>,
}

impl<T: Scalar> Place<'_, T> {
    /// K̂ of a law, inertial axes.
    #[inline(always)]
    pub fn stiffness(&self, law: &impl RotaryLaw<T>, springs: Implicit<T::Real>) -> Symmetric3<T> {
        let Reading { position, rate, .. } = self.reading;
        law.pivot(position, rate, springs).turned(&self.attitude.times(&position.inverse().matrix()))
    }
}

/// How the rule of a sweep treats the spring of a ball.
pub trait BallRule<T: Scalar>: Springs<T> {
    /// The relation handed on.
    type Out<C: Closures>: Slides<T, Closures = C>;
    /// Eliminates the rotation against a law and the torque of a drive; `bias` is the angular acceleration that rates alone cause.
    fn ball<C: Closures>(
        self,
        outer: Full<T, C>,
        law: &impl RotaryLaw<T>,
        drive: impl Term<Vector3<T>>,
        place: Place<'_, T>,
        bias: Vector3<T>,
    ) -> (Self::Out<C>, BallGain<T, C>);
}

impl<T: Scalar> BallRule<T> for Explicit {
    type Out<C: Closures> = Point<T, Couple<T>, C>;

    #[cfg_attr(optimised, inline(always))]
    fn ball<C: Closures>(
        self,
        outer: Full<T, C>,
        law: &impl RotaryLaw<T>,
        drive: impl Term<Vector3<T>>,
        place: Place<'_, T>,
        _: Vector3<T>,
    ) -> (Self::Out<C>, BallGain<T, C>) {
        let torque = drive.add_to(place.attitude.apply(law.torque(place.state.0, place.state.1)));
        let (relation, gain) = outer.balled(Couple(torque));
        (relation, BallGain::absolute(gain))
    }
}

impl<T: Scalar> BallRule<T> for Implicit<T::Real> {
    type Out<C: Closures> = Full<T, C>;

    #[cfg_attr(optimised, inline(always))]
    fn ball<C: Closures>(
        self,
        outer: Full<T, C>,
        law: &impl RotaryLaw<T>,
        drive: impl Term<Vector3<T>>,
        place: Place<'_, T>,
        bias: Vector3<T>,
    ) -> (Full<T, C>, BallGain<T, C>) {
        let (pivot, Place { attitude, reading, .. }) = (place.stiffness(law, self), place);
        let torque = drive.add_to(attitude.apply(law.torque(reading.position, reading.rate)));
        let led = attitude.apply(Vector3::from(*reading.acceleration));
        let (relation, gain) = outer.sprung(pivot.apply_onto(led, torque), pivot);
        (relation.turning(bias), gain)
    }
}

impl<T: Scalar, R: RotaryLaw<T>> Joint<T> for ElasticHinge<R> {
    type Position = Rotation<T>;
    type Rate = [T; 3];
    type Kept<C: Closures> = BallGain<T, C>;
    type Sets = One;

    const LINEAR: bool = R::LINEAR;
    const ROTARY: bool = true;

    fn still() -> (Rotation<T>, [T; 3]) {
        (Rotation::identity(), [T::zero(); 3])
    }
    fn kept<C: Closures>() -> BallGain<T, C> {
        BallGain::blank()
    }
    fn is_finite<C: Closures>(kept: &BallGain<T, C>) -> bool {
        kept.is_finite()
    }
    /// Three absolute angles 1-2-3.
    fn configure(&self, position: &mut Rotation<T>, inboard: Turn<T>, next: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
        let absolute = Rotation::from_angles([(); 3].map(|()| next(inboard)));
        *position = absolute.relative_to(&Rotation::from_matrix(&inboard.attitude)).shortest();
        Turn { attitude: absolute.matrix(), spin: zero() }
    }
    #[cfg_attr(optimised, inline(always))]
    fn oriented(&self, position: &Rotation<T>, rate: &[T; 3], inboard: Turn<T>) -> (Turn<T>, Stored<T>) {
        let attitude = inboard.attitude.times(&position.matrix());
        let relative = attitude.apply(Vector3::from(*rate));
        let bias = cross(inboard.spin, relative);
        (Turn { attitude, spin: inboard.spin + relative }, (attitude, [zero(), bias]))
    }
    #[inline(always)]
    fn release(&self, motion: &JointMotion<T>, position: &Self::Position, rate: &Self::Rate) -> Release<T> {
        release::rotary(self, motion, position, rate)
    }
    #[cfg_attr(optimised, inline(always))]
    fn moved(&self, inboard: Frame<T>, position: &Rotation<T>, rate: &[T; 3], acceleration: &[T; 3]) -> JointMotion<T> {
        let (turn, (attitude, [_, bias])) = self.oriented(position, rate, inboard.turn);
        let angular = attitude.apply_onto(Vector3::from(*acceleration), inboard.acceleration.angular + bias);
        let outboard = Frame { turn, acceleration: Acceleration { angular, ..inboard.acceleration }, ..inboard };
        let (effort, energy) = (self.rotary.torque(position, rate).into(), self.rotary.energy(position));
        JointMotion {
            inboard,
            outboard,
            position: position.log(),
            rate: *rate,
            effort,
            energy,
            inertia: [T::zero(); 3],
        }
    }
    fn check(&self) -> Result<(), Fault> {
        self.rotary.check()
    }
    #[cfg_attr(optimised, inline(always))]
    fn recovered<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        (attitude, [_, bias]): (&Columns<T>, &[Vector3<T>; 2]),
        kept: &BallGain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut [T; 3],
    ) -> Acceleration<T> {
        let carried = inboard.angular + bias;
        let relative = kept.relative(inboard.linear, carried, multipliers);
        *rate = attitude.transposed(relative).into();
        Acceleration { angular: carried + relative, ..inboard }
    }
    #[cfg_attr(optimised, inline(always))]
    fn responded<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        (attitude, _): (&Columns<T>, &[Vector3<T>; 2]),
        kept: &BallGain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut [T; 3],
    ) -> Acceleration<T> {
        let homogeneous = kept.homogeneous();
        self.recovered::<C>(inboard, (attitude, &[zero(); 2]), &homogeneous, multipliers, rate)
    }
}

impl<T: Scalar, S: RotaryLaw<T>, R: Rigid<T>, W> Condense<Spatial<T>, R, W> for ElasticHinge<S>
where
    W: Sweep<Spatial<T>, Springs: BallRule<T>, Closures = R::Closures>,
    InJoint<Spatial<T>, W>: Drive<T>,
{
    type Out = <W::Springs as BallRule<T>>::Out<W::Closures>;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: R,
        posture: Posture<'_, Spatial<T>, Self>,
        given: Given<'_, Spatial<T>, Self, W>,
        kept: &mut BallGain<T, W::Closures>,
    ) -> Self::Out {
        let Given { in_joints, position, rate, reading, springs, .. } = given;
        let place = Place { attitude: *posture.x, state: (position, rate), reading };
        let drive = in_joints.couple(posture.x);
        let (relation, gain) = springs.ball(outer.full(), &self.rotary, drive, place, posture.y[1]);
        *kept = gain;
        relation
    }
}

lift!(ElasticHinge<R, L> { rotary, linear });
