//! The costate sweep in the plane: tips.

use super::Kind;
use crate::adjoint::ReversibleTip;
use crate::element::Level;
use crate::ends::Ground;
use crate::mechanics::planar::{Acceleration, Clamped, Frame, Free, GroundMotion, Guided, Pinned, Planar, Wrench};
use crate::relation::Additive;
use crate::relation::planar::algebra::{dot, normal};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// A force without a torque.
fn force<T: Scalar>(force: Vector2<T>) -> Wrench<T> {
    Wrench { force, torque: T::zero() }
}

/// The wrenches of forces along x and y.
fn pulls<T: Scalar>() -> [Wrench<T>; 2] {
    let (zero, one) = (T::zero(), T::one());
    [force(Vector2::new(one, zero)), force(Vector2::new(zero, one))]
}

/// Most numbers that a tip is made of.
pub(super) const TIP: usize = 4;

impl<T: Scalar> ReversibleTip<Planar<T>> for Free {
    const KIND: Kind = Kind::Nothing;

    fn columns(&self) {}
}

impl<T: Scalar, G: Ground<T, GroundMotion<T>>> ReversibleTip<Planar<T>> for Pinned<G> {
    const KIND: Kind = Kind::Point;
    const RESTS: bool = G::RESTS;

    fn ground(&self, time: T::Real) -> Frame<T> {
        self.place.at(time).frame::<Planar<T>>()
    }

    fn columns(&self) -> [Wrench<T>; 2] {
        pulls()
    }
    fn numbers(&self, time: T::Real) -> [T; TIP] {
        let [x, y] = self.place.at(time).place;
        [x, y, T::zero(), T::zero()]
    }
    fn of_residual(&self, weight: &[T; 2], _: &Frame<T>, level: Level) -> [T; TIP] {
        let zero = T::zero();
        match level {
            Level::Place => [-weight[0], -weight[1], zero, zero],
            Level::Velocity => [zero; TIP],
        }
    }
}

impl<T, G, A> ReversibleTip<Planar<T>> for Clamped<G, A>
where
    T: Scalar,
    G: Ground<T, GroundMotion<T>>,
    A: Ground<T, [T; 3]>,
{
    const KIND: Kind = Kind::Rigid;
    const RESTS: bool = G::RESTS && A::RESTS;

    fn ground(&self, time: T::Real) -> Frame<T> {
        self.frame(time)
    }

    fn columns(&self) -> [Wrench<T>; 3] {
        let [x, y] = pulls();
        [x, y, Wrench { force: Vector2::null(), torque: T::one() }]
    }
    fn numbers(&self, time: T::Real) -> [T; TIP] {
        let Frame { place, turn, .. } = self.frame(time);
        [place.x, place.y, turn.angle, T::zero()]
    }
    fn of_residual(&self, weight: &[T; 3], _: &Frame<T>, level: Level) -> [T; TIP] {
        match level {
            Level::Place => [-weight[0], -weight[1], -weight[2], T::zero()],
            Level::Velocity => [T::zero(); TIP],
        }
    }
}

/// Numbers of a guide are place, angle, and direction of the line against it, by which the normal n of the line turns: n′ = −ẑ×ᵀ n.
impl<T: Scalar> ReversibleTip<Planar<T>> for Guided<[T; 2], T, T> {
    const KIND: Kind = Kind::Rigid;

    fn columns(&self) -> [Wrench<T>; 2] {
        [force(self.across()), Wrench { force: Vector2::null(), torque: T::one() }]
    }
    fn numbers(&self, _: T::Real) -> [T; TIP] {
        let (Clamped { place: [x, y], attitude }, line) = self.parts();
        [x, y, attitude, line]
    }
    fn of_columns(
        &self,
        (weight, a): (&[T; 2], &Acceleration<T>),
        (force, w): (&[T; 2], &Acceleration<T>),
    ) -> [T; TIP] {
        let turned = normal(self.across());
        let by_angle = force[0] * dot(turned, w.linear) - weight[0] * dot(turned, a.linear);
        [T::zero(), T::zero(), by_angle, by_angle]
    }
    fn of_residual(&self, weight: &[T; 2], frame: &Frame<T>, level: Level) -> [T; TIP] {
        let (n, (Clamped { place, .. }, _)) = (self.across(), self.parts());
        let by_angle = |v: Vector2<T>| weight[0] * dot(normal(n), v);
        match level {
            Level::Place => {
                let turned = by_angle(frame.place - Vector2::from(place));
                [-(weight[0] * n.x), -(weight[0] * n.y), turned - weight[1], turned]
            }
            Level::Velocity => {
                let turned = by_angle(frame.velocity);
                [T::zero(), T::zero(), turned, turned]
            }
        }
    }
}
