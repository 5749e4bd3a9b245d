//! Derivatives through kept gains in the plane: what is carried outward and inward.

mod bodies;
mod floating;
mod joints;
mod slider;

use crate::mechanics::planar::{Acceleration, Frame, Planar, Turn};
use crate::scalar::{Jet, Scalar, columns};
use crate::sensitive::{Derived, Effort, Varied};
use nalgebra::Vector2;

/// A motion on its way outward.
#[derive(Clone, Copy, Debug)]
pub struct Passing<T, const K: usize> {
    /// Acceleration of the station, in a frame that falls freely, and of the body on its inboard side.
    pub(super) acceleration: Acceleration<T>,
    /// Angular velocity of that body (rad/s).
    pub(super) rate: T,
    /// Columns of the body's angle.
    pub(super) angle: [T; K],
    /// Columns of the body's angular velocity.
    pub(super) spin: [T; K],
    /// Columns of the acceleration of the station.
    pub(super) x: [T; K],
    pub(super) y: [T; K],
    /// Columns of the angular acceleration of the body: those of the ground.
    pub(super) turn: [T; K],
    /// Whether there are any.
    pub(super) turning: bool,
}

/// A force on its way inward.
#[derive(Clone, Copy, Debug)]
pub struct Pulling<T, const K: usize> {
    /// Force on the outboard part (N).
    pub(super) force: Vector2<T>,
    /// Columns of the force on the outboard part.
    pub(super) x: [T; K],
    pub(super) y: [T; K],
    /// Columns of the torque on the outboard part.
    pub(super) torque: [T; K],
}

/// Columns of an acceleration on their way outward.
#[derive(Clone, Copy, Debug)]
pub struct Answering<T, const K: usize> {
    pub(super) x: [T; K],
    pub(super) y: [T; K],
    pub(super) angular: [T; K],
}

impl<T: Scalar, const K: usize> Varied for Planar<Jet<T, K>> {
    type Number = T;
    type Plain = Planar<T>;
    type Outward = Passing<T, K>;
    type Inward = Pulling<T, K>;
    type Response = Answering<T, K>;

    #[cfg_attr(optimised, inline(always))]
    fn ground(frame: &Frame<Jet<T, K>>, gravity: Vector2<Jet<T, K>>) -> Passing<T, K> {
        let Acceleration { linear, angular } = frame.falling(gravity);
        Passing {
            acceleration: Acceleration { linear: linear.map(|x| x.re), angular: angular.re },
            rate: frame.turn.rate.re,
            angle: frame.turn.angle.eps,
            spin: frame.turn.rate.eps,
            x: linear.x.eps,
            y: linear.y.eps,
            turn: angular.eps,
            turning: Self::ground_turns(frame),
        }
    }
    #[inline(always)]
    fn no_pull() -> Pulling<T, K> {
        let (zero, none) = (T::zero(), [T::zero(); K]);
        Pulling { force: Vector2::new(zero, zero), x: none, y: none, torque: none }
    }
    #[inline(always)]
    fn stillness() -> Answering<T, K> {
        let none = [T::zero(); K];
        Answering { x: none, y: none, angular: none }
    }
    #[inline(always)]
    fn plain_turn(frame: &Frame<Jet<T, K>>) -> Turn<T> {
        Turn { angle: frame.turn.angle.re, rate: frame.turn.rate.re }
    }
    fn ground_turns(frame: &Frame<Jet<T, K>>) -> bool {
        !frame.acceleration.angular.is_constant()
    }
    #[cfg_attr(optimised, inline(always))]
    fn pull(chain: &mut Pulling<T, K>, arm: &Pulling<T, K>) {
        chain.force += arm.force;
        columns!(K; a = arm.x, b = arm.y, c = arm.torque; k:
            mut x = chain.x => x[k] + a[k],
            mut y = chain.y => y[k] + b[k],
            mut torque = chain.torque => torque[k] + c[k]
        );
    }
}

impl<T: Scalar, const K: usize> Effort<Planar<Self>> for Jet<T, K> {
    fn effort(self) -> Self {
        self
    }
}
