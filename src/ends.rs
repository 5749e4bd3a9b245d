//! The two ends of a chain, and the ground that holds them, which may move.
//!
//! An end fixes one of each conjugate pair of a state vector (a position or its force), so exactly half of its N − 1
//! entries are known: [`Root::Pairs`] and [`Tip::Pairs`] list one [`Choice`] for each pair, and an end that fixes both or
//! neither cannot be written.

use crate::element::{Element, RealOf, Space};
use crate::error::{Error, Fault};
use crate::relation::{Closures, Own, Solvable, WrenchOf};
use crate::scalar::Scalar;
use crate::space::{Frame, FrameOf};

/// Which of a conjugate pair an end makes known.
pub trait Choice {
    /// Whether the end makes known the motion (and the force is unknown), or the force (and the motion is unknown).
    const MOTION: bool;
}

/// The end prescribes the motion.
#[derive(Clone, Copy, Debug)]
pub struct Held;

/// The end prescribes the force.
#[derive(Clone, Copy, Debug)]
pub struct Loose;

impl Choice for Held {
    const MOTION: bool = true;
}
impl Choice for Loose {
    const MOTION: bool = false;
}

/// One choice for each conjugate pair of a space, in the order of its state vector.
pub trait Pairs {
    /// Whether the motion is known, pair by pair.
    const MOTION: &'static [bool];
}

impl<X: Choice, Y: Choice, R: Choice> Pairs for (X, Y, R) {
    const MOTION: &'static [bool] = &[X::MOTION, Y::MOTION, R::MOTION];
}

impl<X: Choice, Y: Choice, Z: Choice, A: Choice, B: Choice, C: Choice> Pairs for (X, Y, Z, A, B, C) {
    const MOTION: &'static [bool] = &[X::MOTION, Y::MOTION, Z::MOTION, A::MOTION, B::MOTION, C::MOTION];
}

/// The inboard end of a chain: a joint to the ground, and how that ground moves.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be the root of a chain in `{S}`",
    label = "not a root of this space",
    note = "the root is an end such as `Pinned` or `Free`, of the same space and scalar as the chain"
)]
pub trait Root<S: Space> {
    /// What is known of each conjugate pair.
    type Pairs: Pairs;
    /// The joint between the ground and the chain.
    type Joint: Element<S>;

    /// Whether the ground is known to rest.
    const RESTS: bool = false;

    /// The joint between the ground and the chain.
    fn joint(&self) -> Self::Joint;
    /// The motion of the ground where the joint sits.
    fn ground(&self, time: RealOf<S>) -> FrameOf<S>;
    /// Rejects parameters that make no mechanics.
    fn check(&self) -> Result<(), Error>;
}

/// The outboard end of a chain: what the last element meets.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be the tip of a chain in `{S}`",
    label = "not a tip of this space",
    note = "the tip is an end such as `Free`, of the same space and scalar as the chain"
)]
pub trait Tip<S: Space> {
    /// What is known of each conjugate pair.
    type Pairs: Pairs;
    /// Forces that hold the tip.
    type Closures: Solvable;
    /// The relation that the tip hands on.
    type Relation: Copy;

    /// The relation that the tip hands on, with the motion that it demands (in a frame that falls freely) of a body that turns like this.
    fn relation(&self, time: RealOf<S>, gravity: S::Vector, turn: &S::Turn) -> Self::Relation;
    /// Internal force and torque at the tip where it is held by these forces.
    fn internal(&self, time: RealOf<S>, multipliers: &<Self::Closures as Closures>::Each<S::Scalar>) -> WrenchOf<S>;
    /// Residual of the closure: by how much a tip that moves with `frame` misses the place demanded at a time, and the velocity.
    fn residual(&self, time: RealOf<S>, frame: &FrameOf<S>) -> [<Self::Closures as Closures>::Each<S::Scalar>; 2];
    /// The residual of the place as it is nearby: linear in the place and the axes of `frame`, which need not be a rotation's, for it is asked
    /// for derivatives of axes, too. Only what is not linear afar says more than [`residual`](Self::residual).
    fn linear_residual(&self, time: RealOf<S>, frame: &FrameOf<S>) -> <Self::Closures as Closures>::Each<S::Scalar> {
        let [place, _] = self.residual(time, frame);
        place
    }
    /// How much the last body would yield to each of the forces if it were free: the measure of Λ, which tells closures that
    /// say the same twice.
    fn free_compliance(&self, time: RealOf<S>, body: &S::BodyMotion) -> <Self::Closures as Closures>::Each<S::Scalar>;
    /// What each of the forces holds, for messages.
    fn names(&self) -> <Self::Closures as Closures>::Each<&'static str>;
    /// Rejects parameters that make no mechanics.
    fn check(&self) -> Result<(), Error>;
}

/// A root on ground that rests: that its motion has no derivatives is known by type.
#[diagnostic::on_unimplemented(
    message = "the root `{Self}` is not known to stand on ground that rests",
    label = "a ground that may move, or a root that floats",
    note = "`Taylor` knows `Pinned` and `Clamped`, and `Hinged` of space, at places and angles that are numbers",
    note = "gradients of all scenes go by jets or dual numbers; `Dop853` runs all scenes"
)]
pub trait Resting<S: Space>: Root<S> {}

/// A tip whose motion has a Taylor series: nothing holds it, or ground that rests does, by forces of directions that rest too.
#[diagnostic::on_unimplemented(
    message = "the tip `{Self}` is held as `Taylor` knows no series of",
    label = "not a tip that has a series",
    note = "`Taylor` knows `Free`, `Pinned` and `Clamped`, in the plane `Guided`, in space `Hinged`, at places and angles that are numbers",
    note = "`Dop853` runs all scenes"
)]
pub trait ExpandTip<S: Space>: Tip<S, Closures: Own> {
    /// W: the opposite of the wrench by which each unit force acts on the last body.
    fn columns(&self) -> <Self::Closures as Closures>::Each<WrenchOf<S>>;
}

/// Motion of a point of the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundMotion<T, const N: usize> {
    /// Place (m).
    pub place: [T; N],
    /// Velocity (m/s).
    pub velocity: [T; N],
    /// Acceleration (m/s²).
    pub acceleration: [T; N],
}

/// A motion of the ground that is given as a function of time: `M` is `GroundMotion<T>` for a place, and for an attitude `[T; 3]` in the plane
/// (angle (rad), rate (rad/s), angular acceleration (rad/s²)), `AttitudeMotion<T>` in space.
pub trait Ground<T: Scalar, M> {
    /// Whether the ground is known to rest.
    const RESTS: bool = false;

    /// The motion at a time (s).
    fn at(&self, time: T::Real) -> M;
}

impl<T: Scalar, const N: usize> Ground<T, GroundMotion<T, N>> for [T; N] {
    const RESTS: bool = true;

    fn at(&self, _: T::Real) -> GroundMotion<T, N> {
        let zero = [T::zero(); N];
        GroundMotion { place: *self, velocity: zero, acceleration: zero }
    }
}

/// A place given as a function of time.
#[derive(Clone, Copy, Debug)]
pub struct Moving<F>(pub F);

impl<T: Scalar, const N: usize, F: Fn(T::Real) -> GroundMotion<T, N>> Ground<T, GroundMotion<T, N>> for Moving<F> {
    fn at(&self, time: T::Real) -> GroundMotion<T, N> {
        (self.0)(time)
    }
}

/// An attitude given as a function of time.
#[derive(Clone, Copy, Debug)]
pub struct Turning<F>(pub F);

impl<T: Scalar, M, F: Fn(T::Real) -> M> Ground<T, M> for Turning<F> {
    fn at(&self, time: T::Real) -> M {
        (self.0)(time)
    }
}

impl<T: Scalar, const N: usize> GroundMotion<T, N> {
    /// The frame of the ground at the place, unturned.
    pub(crate) fn frame<S: Space<Vector: From<[T; N]>>>(self) -> FrameOf<S> {
        let mut frame = Frame::resting(self.place.into());
        frame.velocity = self.velocity.into();
        frame.acceleration.linear = self.acceleration.into();
        frame
    }

    /// Rejects a motion that is not finite.
    pub(crate) fn check(self) -> Result<(), Error> {
        let Self { place, velocity, acceleration } = self;
        let finite = [place, velocity, acceleration].iter().flatten().all(|x| x.is_finite());
        let fault = Error::new(Fault::NotFinite { parameter: "motion of the ground" });
        if finite { Ok(()) } else { Err(fault) }
    }
}
