//! What joints know of the place of their outboard side.

use super::Turn;
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// What a joint keeps in the stores of postures, and what it reads there.
pub trait Axes {
    /// Room for what a joint keeps.
    type Per<X: Copy>: Clone;
    /// What the walks read.
    type Offset<T: Scalar>: Copy;

    /// `fill` in all of the room.
    fn per<X: Copy>(fill: X) -> Self::Per<X>;
    /// Turns what was stored into what the walks read.
    fn resolve<T: Scalar>(x: &mut Self::Per<T>, y: &mut Self::Per<T>, p: &mut Self::Per<T>, q: &mut Self::Per<T>);
    /// What the walks read.
    fn offset<T: Scalar>(x: &Self::Per<T>, y: &Self::Per<T>, p: &Self::Per<T>, q: &Self::Per<T>) -> Self::Offset<T>;
    /// `offset` without velocities.
    fn at_rest<T: Scalar>(offset: Self::Offset<T>) -> Self::Offset<T>;
}

/// The points of the joint coincide: nothing is kept.
#[derive(Clone, Copy, Debug)]
pub struct Coincident;

/// The outboard point moves along axes that turn with the inboard body.
#[derive(Clone, Copy, Debug)]
pub struct Inboard;

/// The outboard point moves along axes that do not turn.
#[derive(Clone, Copy, Debug)]
pub struct Fixed;

/// The outboard point of a joint, as seen from the inboard one.
#[derive(Clone, Copy, Debug)]
pub struct Offset<T> {
    /// Direction of the x axis along which displacements are measured.
    pub direction: Vector2<T>,
    /// d, from the inboard to the outboard point (m).
    pub arm: Vector2<T>,
    /// −ω² d + 2 ω ẑ × ḋ, with the rate ḋ in the axes (m/s²).
    pub acceleration: Vector2<T>,
}

impl Axes for Coincident {
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

impl Axes for Fixed {
    type Per<X: Copy> = X;
    type Offset<T: Scalar> = Vector2<T>;

    fn per<X: Copy>(fill: X) -> X {
        fill
    }
    #[inline(always)]
    fn resolve<T: Scalar>(_: &mut T, _: &mut T, _: &mut T, _: &mut T) {}
    #[inline(always)]
    fn offset<T: Scalar>(x: &T, y: &T, _: &T, _: &T) -> Vector2<T> {
        Vector2::new(*x, *y)
    }
    #[inline(always)]
    fn at_rest<T: Scalar>(offset: Vector2<T>) -> Vector2<T> {
        offset
    }
}

/// Stores angle and angular velocity of the axes, displacement and its rate; reads the direction of the axes, d and its
/// acceleration.
impl Axes for Inboard {
    type Per<X: Copy> = [X; 2];
    type Offset<T: Scalar> = Offset<T>;

    fn per<X: Copy>(fill: X) -> [X; 2] {
        [fill; 2]
    }
    #[cfg_attr(optimised, inline(always))]
    fn resolve<T: Scalar>(x: &mut [T; 2], y: &mut [T; 2], p: &mut [T; 2], q: &mut [T; 2]) {
        let (sine, cosine) = x[0].sin_cos();
        let direction = Vector2::new(cosine, sine);
        let spin = y[0];
        let (arm, rate) = (across(Vector2::new(x[1], y[1]), direction), across(Vector2::new(p[1], q[1]), direction));
        let (minus_spin2, twice) = (-(spin * spin), spin + spin);
        *x = [cosine, arm.x];
        *y = [sine, arm.y];
        p[1] = minus_spin2.mul_add(arm.x, -(twice * rate.y));
        q[1] = minus_spin2.mul_add(arm.y, twice * rate.x);
    }
    #[cfg_attr(optimised, inline(always))]
    fn offset<T: Scalar>(x: &[T; 2], y: &[T; 2], p: &[T; 2], q: &[T; 2]) -> Offset<T> {
        Offset {
            direction: Vector2::new(x[0], y[0]),
            arm: Vector2::new(x[1], y[1]),
            acceleration: Vector2::new(p[1], q[1]),
        }
    }
    #[inline(always)]
    fn at_rest<T: Scalar>(offset: Offset<T>) -> Offset<T> {
        Offset { acceleration: Vector2::new(T::zero(), T::zero()), ..offset }
    }
}

impl Inboard {
    /// Stores a displacement and its rate along axes in the direction of a turn.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn keep<T: Scalar>(
        turn: Turn<T>,
        [place, rate]: [[T; 2]; 2],
        x: &mut [T; 2],
        y: &mut [T; 2],
        p: &mut [T; 2],
        q: &mut [T; 2],
    ) {
        *x = [turn.angle, place[0]];
        *y = [turn.rate, place[1]];
        (p[1], q[1]) = (rate[0], rate[1]);
    }
}

/// A vector of axes in a direction, in inertial axes.
#[inline(always)]
pub(super) fn across<T: Scalar>(v: Vector2<T>, direction: Vector2<T>) -> Vector2<T> {
    let (c, s) = (direction.x, direction.y);
    Vector2::new(c.mul_add(v.x, -(s * v.y)), s.mul_add(v.x, c * v.y))
}
