//! Linear springs of an elastic hinge, and the axes along which they push.

use super::axes::{Axes, Fixed, Inboard, Offset, across};
use super::{Acceleration, ElasticHinge, Frame, Turn};
use crate::lift::Lift;
use crate::relation::planar::algebra::normal;
use crate::relation::planar::{Full, Slides, along, back};
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use core::fmt::Debug;
use core::marker::PhantomData;
use nalgebra::Vector2;

/// Springs and dampers between the two points of a hinge, along the axes `A`; [`Absent`](crate::relation::Absent) for a direction in which nothing acts.
///
/// The coordinates are the components (m) of the vector d from the inboard to the outboard point:
///
/// * `Inboard` (the default): along the axes of the inboard body, with m_O = m_I + d × q. Nothing depends on where the scene is
///   turned, and momentum and energy are conserved.
/// * `Fixed`: along inertial axes, with the same balance of moments.
/// * [`Unbalanced`]: along inertial axes and with m_O = m_I, as (33)-(35) of the paper have it. Angular momentum is not conserved.
///
/// An implicit rule takes inboard axes and unbalanced ones exactly into account. With fixed ones the inboard body's angular
/// acceleration moves the coordinates too; put into the relation it would make it unsymmetric, so that of the sweep before is
/// taken, which costs no order.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: serde::Serialize, X: serde::Serialize, Y: serde::Serialize",
        deserialize = "T: serde::Deserialize<'de>, X: serde::Deserialize<'de>, Y: serde::Deserialize<'de>, T: num_traits::Zero"
    ))
)]
pub struct Linear<T, X, Y, A = Inboard> {
    pub(super) x: X,
    pub(super) y: Y,
    /// Point mass (kg) that the outboard body lumps at its inboard end, in a scene.
    #[cfg_attr(feature = "serde", serde(skip, default = "num_traits::zero"))]
    pub(super) lumped: T,
    axes: PhantomData<A>,
}

impl<T: Scalar, X, Y> Linear<T, X, Y> {
    pub(super) fn new(x: X, y: Y) -> Self {
        Self { x, y, lumped: T::zero(), axes: PhantomData }
    }
}

/// Inertial axes and no balance of the moment d × q: those of the paper.
#[derive(Clone, Copy, Debug)]
pub struct Unbalanced;

impl<T: Scalar, R, X, Y> ElasticHinge<R, Linear<T, X, Y>> {
    /// The springs push along inertial axes.
    pub fn in_fixed_axes(self) -> ElasticHinge<R, Linear<T, X, Y, Fixed>> {
        let Linear { x, y, lumped, .. } = self.linear;
        ElasticHinge { rotary: self.rotary, linear: Linear { x, y, lumped, axes: PhantomData } }
    }

    /// The springs push along inertial axes, and their force has no moment about the inboard point: (33)-(35) as printed.
    pub fn in_unbalanced_axes(self) -> ElasticHinge<R, Linear<T, X, Y, Unbalanced>> {
        let Linear { x, y, lumped, .. } = self.linear;
        ElasticHinge { rotary: self.rotary, linear: Linear { x, y, lumped, axes: PhantomData } }
    }
}

impl<T: Scalar, X, Y, A> Linear<T, X, Y, A> {
    /// Forces along the axes.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn forces(&self, position: [T; 2], rate: [T; 2]) -> [T; 2]
    where
        X: SpringLaw<T>,
        Y: SpringLaw<T>,
    {
        [self.x.force(position[0], rate[0]), self.y.force(position[1], rate[1])]
    }
}

/// Axes along which the linear springs of a hinge push.
pub trait HingeAxes: Axes + Copy + Debug + 'static {
    /// Whether the force has a moment about the inboard point.
    const LEVER: bool;
    /// Whether the axes turn with the inboard body, and the outboard point with them.
    const SWINGS: bool = false;

    /// Stores displacement and rate.
    #[allow(clippy::too_many_arguments)] // one store each
    fn store<T: Scalar>(
        inboard: Turn<T>,
        moved: [[T; 2]; 2],
        x: &mut Self::Per<T>,
        y: &mut Self::Per<T>,
        p: &mut Self::Per<T>,
        q: &mut Self::Per<T>,
    );
    /// A relation with its vectors along the axes.
    fn enter<T: Scalar, R: Slides<T>>(relation: R, offset: Self::Offset<T>) -> R;
    /// The relation back in inertial axes, and at the inboard point.
    fn leave<T: Scalar, R: Slides<T>>(relation: R, offset: Self::Offset<T>) -> Full<T, R::Closures>;
    /// The acceleration of the outboard point if the displacement did not accelerate.
    fn carried<T: Scalar>(inboard: Acceleration<T>, offset: Self::Offset<T>) -> Acceleration<T>;
    /// A vector along the axes.
    fn components<T: Scalar>(v: Vector2<T>, offset: Self::Offset<T>) -> Vector2<T>;
    /// A vector of the axes in inertial ones.
    fn inertial<T: Scalar>(v: Vector2<T>, offset: Self::Offset<T>) -> Vector2<T>;
    /// What the inboard body's angular acceleration adds to the second derivatives of the coordinates.
    fn swing<T: Scalar>(inboard: Acceleration<T>, offset: Self::Offset<T>) -> Vector2<T>;
    /// Second derivatives of the coordinates: from the acceleration of the displacement relative to the carried point and that
    /// of the outboard point relative to the inboard one.
    fn coordinates<T: Scalar>(to_carried: Vector2<T>, to_inboard: Vector2<T>) -> Vector2<T>;
    /// The frame of the outboard point on the inboard body's side, for displacement, rate and acceleration of the coordinates.
    fn moved<T: Scalar>(inboard: Frame<T>, coordinates: [Vector2<T>; 3]) -> Frame<T>;
}

impl HingeAxes for Inboard {
    const LEVER: bool = true;
    const SWINGS: bool = true;

    #[cfg_attr(optimised, inline(always))]
    fn store<T: Scalar>(
        inboard: Turn<T>,
        moved: [[T; 2]; 2],
        x: &mut [T; 2],
        y: &mut [T; 2],
        p: &mut [T; 2],
        q: &mut [T; 2],
    ) {
        Self::keep(inboard, moved, x, y, p, q);
    }
    #[inline(always)]
    fn enter<T: Scalar, R: Slides<T>>(relation: R, offset: Offset<T>) -> R {
        relation.along(offset.direction)
    }
    #[inline(always)]
    fn leave<T: Scalar, R: Slides<T>>(relation: R, offset: Offset<T>) -> Full<T, R::Closures> {
        relation.along(back(offset.direction)).carried(offset.arm, offset.acceleration)
    }
    #[inline(always)]
    fn carried<T: Scalar>(inboard: Acceleration<T>, offset: Offset<T>) -> Acceleration<T> {
        inboard.shifted(offset.arm, offset.acceleration)
    }
    #[inline(always)]
    fn components<T: Scalar>(v: Vector2<T>, offset: Offset<T>) -> Vector2<T> {
        along(v, offset.direction)
    }
    #[inline(always)]
    fn inertial<T: Scalar>(v: Vector2<T>, offset: Offset<T>) -> Vector2<T> {
        across(v, offset.direction)
    }
    #[inline(always)]
    fn swing<T: Scalar>(_: Acceleration<T>, _: Offset<T>) -> Vector2<T> {
        Vector2::new(T::zero(), T::zero())
    }
    #[inline(always)]
    fn coordinates<T: Scalar>(to_carried: Vector2<T>, _: Vector2<T>) -> Vector2<T> {
        to_carried
    }
    #[inline(always)]
    fn moved<T: Scalar>(inboard: Frame<T>, coordinates: [Vector2<T>; 3]) -> Frame<T> {
        let (sine, cosine) = inboard.turn.angle.sin_cos();
        inboard.displaced(coordinates.map(|v| across(v, Vector2::new(cosine, sine))))
    }
}

/// The frame of a point at a displacement from another one, whatever turns there.
#[cfg_attr(optimised, inline(always))]
fn translated<T: Scalar>(inboard: Frame<T>, [d, rate, acceleration]: [Vector2<T>; 3]) -> Frame<T> {
    let linear = inboard.acceleration.linear + acceleration;
    Frame {
        place: inboard.place + d,
        velocity: inboard.velocity + rate,
        acceleration: Acceleration { linear, ..inboard.acceleration },
        ..inboard
    }
}

impl HingeAxes for Fixed {
    const LEVER: bool = true;

    #[inline(always)]
    fn store<T: Scalar>(_: Turn<T>, [place, _]: [[T; 2]; 2], x: &mut T, y: &mut T, _: &mut T, _: &mut T) {
        (*x, *y) = (place[0], place[1]);
    }
    #[inline(always)]
    fn enter<T: Scalar, R: Slides<T>>(relation: R, _: Vector2<T>) -> R {
        relation
    }
    #[inline(always)]
    fn leave<T: Scalar, R: Slides<T>>(relation: R, arm: Vector2<T>) -> Full<T, R::Closures> {
        relation.carried(arm, Vector2::new(T::zero(), T::zero()))
    }
    #[inline(always)]
    fn carried<T: Scalar>(inboard: Acceleration<T>, arm: Vector2<T>) -> Acceleration<T> {
        inboard.swung(arm)
    }
    #[inline(always)]
    fn components<T: Scalar>(v: Vector2<T>, _: Vector2<T>) -> Vector2<T> {
        v
    }
    #[inline(always)]
    fn inertial<T: Scalar>(v: Vector2<T>, _: Vector2<T>) -> Vector2<T> {
        v
    }
    #[inline(always)]
    fn swing<T: Scalar>(inboard: Acceleration<T>, arm: Vector2<T>) -> Vector2<T> {
        normal(arm) * inboard.angular
    }
    #[inline(always)]
    fn coordinates<T: Scalar>(_: Vector2<T>, to_inboard: Vector2<T>) -> Vector2<T> {
        to_inboard
    }
    #[inline(always)]
    fn moved<T: Scalar>(inboard: Frame<T>, coordinates: [Vector2<T>; 3]) -> Frame<T> {
        translated(inboard, coordinates)
    }
}

impl Axes for Unbalanced {
    type Per<X: Copy> = ();
    type Offset<T: Scalar> = ();

    fn per<X: Copy>(_: X) {}
    #[inline(always)]
    fn resolve<T: Scalar>((): &mut (), (): &mut (), (): &mut (), (): &mut ()) {}
    #[inline(always)]
    fn offset<T: Scalar>((): &(), (): &(), (): &(), (): &()) {}
    #[inline(always)]
    fn at_rest<T: Scalar>((): ()) {}
}

impl HingeAxes for Unbalanced {
    const LEVER: bool = false;

    #[inline(always)]
    fn store<T: Scalar>(_: Turn<T>, _: [[T; 2]; 2], (): &mut (), (): &mut (), (): &mut (), (): &mut ()) {}
    #[inline(always)]
    fn enter<T: Scalar, R: Slides<T>>(relation: R, (): ()) -> R {
        relation
    }
    #[inline(always)]
    fn leave<T: Scalar, R: Slides<T>>(relation: R, (): ()) -> Full<T, R::Closures> {
        relation.full()
    }
    #[inline(always)]
    fn carried<T: Scalar>(inboard: Acceleration<T>, (): ()) -> Acceleration<T> {
        inboard
    }
    #[inline(always)]
    fn components<T: Scalar>(v: Vector2<T>, (): ()) -> Vector2<T> {
        v
    }
    #[inline(always)]
    fn inertial<T: Scalar>(v: Vector2<T>, (): ()) -> Vector2<T> {
        v
    }
    #[inline(always)]
    fn swing<T: Scalar>(_: Acceleration<T>, _: ()) -> Vector2<T> {
        Vector2::new(T::zero(), T::zero())
    }
    #[inline(always)]
    fn coordinates<T: Scalar>(_: Vector2<T>, to_inboard: Vector2<T>) -> Vector2<T> {
        to_inboard
    }
    #[inline(always)]
    fn moved<T: Scalar>(inboard: Frame<T>, coordinates: [Vector2<T>; 3]) -> Frame<T> {
        translated(inboard, coordinates)
    }
}

impl<T: Scalar, U: Scalar, X: Lift<T, U>, Y: Lift<T, U>, A> Lift<T, U> for Linear<T, X, Y, A> {
    type Over = Linear<U, X::Over, Y::Over, A>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Linear { x: self.x.lift(number), y: self.y.lift(number), lumped: number(self.lumped), axes: PhantomData }
    }
}
