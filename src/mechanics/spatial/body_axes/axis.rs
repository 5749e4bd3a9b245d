//! Joints of one coordinate, about or along the z axis of the body that they carry: what they are.

use super::number::Number;
use super::relation::{Borne, Local};
use super::turns::{Ahead, Level, Offset};
use crate::counts::Counted;
use crate::error::Fault;
use crate::error::checks::not_negative;
use crate::lift::Lift;
use crate::mechanics::spatial::Spatial;
use crate::relation::{Absent, Closures};
use crate::scalar::Scalar;
use crate::spring::{Spring, SpringLaw};
use core::fmt::Debug;
use core::marker::PhantomData;
use typenum::{U0, U1};

/// How a coordinate moves a body.
pub trait Mode: Copy + Debug + 'static {
    /// Whether the coordinate turns the body; else the body slides.
    const TURNS: bool;
}

/// A coordinate that turns a body about its z axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AboutZ;

/// A coordinate that slides a body along its z axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AlongZ;

impl Mode for AboutZ {
    const TURNS: bool = true;
}
impl Mode for AlongZ {
    const TURNS: bool = false;
}

/// What a joint sits on.
pub trait Bearing: Copy + Debug + 'static {
    /// What the joint hands on of what lies outboard.
    type Relation<T: Scalar, C: Closures>: Copy;
    /// That, or nothing.
    fn relation<T: Scalar, C: Closures>(make: impl FnOnce() -> Local<T, C>) -> Self::Relation<T, C>;
}

/// A joint that sits on a body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OnBody;

/// A joint that sits on the ground.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OnGround;

impl Bearing for OnBody {
    type Relation<T: Scalar, C: Closures> = Local<T, C>;
    #[inline(always)]
    fn relation<T: Scalar, C: Closures>(make: impl FnOnce() -> Local<T, C>) -> Local<T, C> {
        make()
    }
}

impl Bearing for OnGround {
    type Relation<T: Scalar, C: Closures> = Borne<T, C>;
    #[inline(always)]
    fn relation<T: Scalar, C: Closures>(make: impl FnOnce() -> Local<T, C>) -> Borne<T, C> {
        Borne::of(make)
    }
}

/// A hinge about the z axis of the body that it carries; its coordinate is the angle (rad) relative to the parent.
///
/// Where it sits on its parent and how the body is turned while the coordinate is zero are parts of the joint: `PLACE` has a bit for each
/// of x, y, z (0 to 2) that the place has, and the [`Offset`] is [`Level`] (no turn), a [`Quarter`](super::Quarter), or any other. What
/// is not there costs nothing.
///
/// ```
/// use catena::robot::*;
/// let shoulder = Hinge::level(); // at the origin of its parent, not turned
/// let elbow = Hinge::at::<0b100>([0.0, 0.0, 0.4]).turned(Quarter::<30>).with(Spring::damping(0.5)).geared(0.1);
/// let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
/// let arm = System::new(Clamped::origin(), (BodyAxes, shoulder, link, elbow, link), Free)?.with_gravity([0.0, 0.0, -9.81]);
/// assert_eq!(arm.forward_dynamics(&[0.1, 0.2], &[0.0, 0.0], &[0.0, 0.0])?.len(), 2);
/// # Ok::<(), catena::Error>(())
/// ```
pub type Hinge<T, C = Level, const PLACE: u8 = 0, L = Spring, A = Absent, B = OnBody> =
    Axis<T, AboutZ, C, PLACE, L, A, B>;

/// A slide along the z axis of the body that it carries; its coordinate is the way (m) from where it sits on its parent. All else is as for
/// a [`Hinge`].
pub type Slide<T, C = Level, const PLACE: u8 = 0, L = Spring, A = Absent, B = OnBody> =
    Axis<T, AlongZ, C, PLACE, L, A, B>;

/// A joint of one coordinate about or along the z axis of the body that it carries: a [`Hinge`] or a [`Slide`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Axis<T, M, C = Level, const PLACE: u8 = 0, L = Spring, A = Absent, B = OnBody> {
    pub(super) place: [T; 3],
    pub(super) offset: C,
    pub(super) law: L,
    pub(super) armature: A,
    mode: PhantomData<(M, B)>,
}

impl<T: Scalar, M: Mode> Axis<T, M> {
    /// At the origin of the parent, not turned, without spring, damper and reflected inertia.
    pub fn level() -> Self {
        Axis::sitting([T::zero(); 3])
    }

    /// At a place of the parent (m), in its axes. What `PLACE` leaves out must be zero.
    pub fn at<const PLACE: u8>(place: [T; 3]) -> Axis<T, M, Level, PLACE> {
        Axis::sitting(place)
    }
}

impl<T: Scalar, M: Mode, const PLACE: u8> Axis<T, M, Level, PLACE> {
    fn sitting(place: [T; 3]) -> Self {
        Self { place, offset: Level, law: Spring::none(), armature: Absent, mode: PhantomData }
    }
}

impl<T: Scalar, M: Mode, C, const PLACE: u8, A, B> Axis<T, M, C, PLACE, Spring, A, B> {
    /// With a spring, a damper, or another law, or several as a tuple.
    pub fn with<N: SpringLaw<T>>(self, law: N) -> Axis<T, M, C, PLACE, N, A, B> {
        let Self { place, offset, armature, mode, .. } = self;
        Axis { place, offset, law, armature, mode }
    }
}

impl<T: Scalar, M: Mode, C, const PLACE: u8, L, A, B> Axis<T, M, C, PLACE, L, A, B> {
    /// With the body turned against its parent while the coordinate is zero.
    pub fn turned<N: Offset<T>>(self, offset: N) -> Axis<T, M, N, PLACE, L, A, B> {
        let Self { place, law, armature, mode, .. } = self;
        Axis { place, offset, law, armature, mode }
    }

    /// Between the ground and the first body of a chain: what lies outboard is then no matter to anything inboard, and is not reduced, a
    /// sixth of the sweep of an arm. The ground may move as its end says; a base that floats is none.
    pub fn grounded(self) -> Axis<T, M, C, PLACE, L, A, OnGround> {
        let Self { place, offset, law, armature, .. } = self;
        Axis { place, offset, law, armature, mode: PhantomData }
    }

    /// Where the joint sits on its parent (m), in axes of that.
    pub fn place(&self) -> [T; 3]
    where
        T: Copy,
    {
        self.place
    }
}

impl<T: Scalar, C: Offset<T>, const PLACE: u8, L, A, B> Axis<T, AboutZ, C, PLACE, L, A, B> {
    /// With the body turned about the hinge's own axis, by an angle (rad) more than its coordinate says: added to the coordinate before sine
    /// and cosine are taken, it lets axes of bodies be chosen as Denavit and Hartenberg do, who need no turn but by it and one about x.
    /// [`turned`](Self::turned) comes before: it puts another turn in the place of all that there is.
    ///
    /// ```
    /// use catena::robot::*;
    /// let link = Link::general(3.0, [0.1, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    /// let arm = |hinge| System::new(Clamped::origin(), (BodyAxes, hinge, link), Free);
    /// let (ahead, plain) = (arm(Hinge::level().ahead(0.3))?, System::new(Clamped::origin(), (BodyAxes, Hinge::level(), link), Free)?);
    /// let ([a], [b]) = (ahead.gravity_torques(&[0.5])?, plain.gravity_torques(&[0.8])?);
    /// assert_eq!(a, b);
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn ahead(self, angle: T) -> Axis<T, AboutZ, Ahead<T, C>, PLACE, L, A, B> {
        let Self { place, offset, law, armature, mode } = self;
        Axis { place, offset: Ahead::of(offset, angle), law, armature, mode }
    }
}

impl<T: Scalar, M: Mode, C, const PLACE: u8, L, B> Axis<T, M, C, PLACE, L, Absent, B> {
    /// With reflected inertia (kg·m², or kg of a slide): a rotor's times the square of its ratio. It counts along the coordinate alone; how a
    /// spinning rotor turns with its parent is left out, as usual. A [`Rotor`](super::Rotor) has it. A fifth of a sweep more: what lies outboard is
    /// then felt about the axis, too.
    pub fn geared(self, inertia: T) -> Axis<T, M, C, PLACE, L, T, B> {
        self.reflecting(inertia)
    }

    /// With reflected inertia of a kind.
    pub(super) fn reflecting<N>(self, armature: N) -> Axis<T, M, C, PLACE, L, N, B> {
        let Self { place, offset, law, mode, .. } = self;
        Axis { place, offset, law, armature, mode }
    }
}

/// Reflected inertia of a joint, that of a [`Rotor`](super::Rotor), or [`Absent`].
pub trait Armature<T: Scalar>: Copy + Debug + 'static {
    /// Whether there is any.
    const ON: bool;
    /// The inertia, known to be zero where there is none.
    fn number(self) -> Number<T>;
    /// Rejects numbers that make none.
    ///
    /// # Errors
    /// [`Fault::NotFinite`], [`Fault::Negative`].
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

impl<T: Scalar> Armature<T> for Absent {
    const ON: bool = false;
    #[inline(always)]
    fn number(self) -> Number<T> {
        Number::zero()
    }
}

impl<T: Scalar> Armature<T> for T {
    const ON: bool = true;
    #[inline(always)]
    fn number(self) -> Number<T> {
        Number::of(self)
    }
    fn check(&self) -> Result<(), Fault> {
        not_negative("reflected inertia", *self)
    }
}

crate::shape::leaf!(joint [T: Scalar, M: Mode, C: Offset<T>, L: SpringLaw<T>, A: Armature<T>, B: Bearing, const PLACE: u8] Axis<T, M, C, PLACE, L, A, B>: Spatial<T>);

impl<T, M, C, const PLACE: u8, L, A, B> Counted for Axis<T, M, C, PLACE, L, A, B> {
    type Bodies = U0;
    type Freedoms = U1;
}

impl<T, U, M, C, const PLACE: u8, L, A, B> Lift<T, U> for Axis<T, M, C, PLACE, L, A, B>
where
    T: Scalar,
    U: Scalar,
    C: Lift<T, U>,
    L: Lift<T, U>,
    A: Lift<T, U>,
{
    type Over = Axis<U, M, C::Over, PLACE, L::Over, A::Over, B>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Axis {
            place: self.place.lift(number),
            offset: self.offset.lift(number),
            law: self.law.lift(number),
            armature: self.armature.lift(number),
            mode: PhantomData,
        }
    }
}
