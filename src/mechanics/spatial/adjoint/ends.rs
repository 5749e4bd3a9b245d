//! The costate sweep in space: tips.
//!
//! Numbers of a tip are its place and the directions that hold it: an attitude is its columns, and has the costates of these.

use super::Kind;
use crate::adjoint::{LoadCostates, ReversibleTip};
use crate::element::Level;
use crate::ends::Ground;
use crate::mechanics::spatial::{
    Acceleration, Clamped, Frame, Free, GroundMotion, Hinged, Pinned, Rotation, Spatial, Wrench,
};
use crate::relation::spatial::algebra::{Columns, add_scaled, cross, cross_onto, zero};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// Most numbers that a tip is made of: a place and four directions.
pub(super) const TIP: usize = 15;

/// A list of a place and directions, zeros beyond.
fn list<T: Scalar>(place: [T; 3], directions: &[Vector3<T>]) -> [T; TIP] {
    let mut list = Spatial::<T>::no_tip();
    let numbers = place.into_iter().chain(directions.iter().flat_map(|v| [v.x, v.y, v.z]));
    list.iter_mut().zip(numbers).for_each(|(entry, number)| *entry = number);
    list
}

/// The wrenches of forces along x, y and z.
pub(super) fn pulls<T: Scalar>() -> [Wrench<T>; 3] {
    let Columns { x, y, z } = Columns::identity();
    [x, y, z].map(Wrench::of_force)
}

/// A torque without a force.
pub(super) fn twist<T: Scalar>(torque: Vector3<T>) -> Wrench<T> {
    Wrench { force: zero(), torque }
}

/// The derivative of ν · ½ Σ d_k × e_k by a turn of the axes e: ½ Σ e_k × (ν × d_k). By that of d it is the opposite with both exchanged.
pub(super) fn aligned<T: Scalar>(e: &Columns<T>, d: &Columns<T>, weight: Vector3<T>) -> Vector3<T> {
    let part = |e: Vector3<T>, d: Vector3<T>, sum: Vector3<T>| cross_onto(e, cross(weight, d), sum);
    part(e.x, d.x, part(e.y, d.y, part(e.z, d.z, zero()))) * T::literal(0.5)
}

impl<T: Scalar> ReversibleTip<Spatial<T>> for Free {
    const KIND: Kind = Kind::Nothing;

    fn columns(&self) {}
}

impl<T: Scalar, G: Ground<T, GroundMotion<T>>> ReversibleTip<Spatial<T>> for Pinned<G> {
    const KIND: Kind = Kind::Point;
    const RESTS: bool = G::RESTS;

    fn ground(&self, time: T::Real) -> Frame<T> {
        self.place.at(time).frame::<Spatial<T>>()
    }

    fn columns(&self) -> [Wrench<T>; 3] {
        pulls()
    }
    fn numbers(&self, time: T::Real) -> [T; TIP] {
        list(self.place.at(time).place, &[])
    }
    fn of_residual(&self, weight: &[T; 3], _: &Frame<T>, level: Level) -> [T; TIP] {
        match level {
            Level::Place => list(weight.map(|x| -x), &[]),
            Level::Velocity => Spatial::<T>::no_tip(),
        }
    }
}

impl<T: Scalar, G: Ground<T, GroundMotion<T>>> ReversibleTip<Spatial<T>> for Clamped<G, Rotation<T>> {
    const KIND: Kind = Kind::Rigid;
    const RESTS: bool = G::RESTS;

    fn ground(&self, time: T::Real) -> Frame<T> {
        self.place.at(time).frame::<Spatial<T>>()
    }

    fn columns(&self) -> [Wrench<T>; 6] {
        let ([a, b, c], Columns { x, y, z }) = (pulls(), Columns::identity());
        [a, b, c, twist(x), twist(y), twist(z)]
    }
    fn numbers(&self, time: T::Real) -> [T; TIP] {
        let Columns { x, y, z } = self.attitude.matrix();
        list(self.place.at(time).place, &[x, y, z])
    }
    fn of_residual(&self, &[a, b, c, d, e, f]: &[T; 6], frame: &Frame<T>, level: Level) -> [T; TIP] {
        let (Columns { x, y, z }, half) = (frame.turn.attitude, Vector3::new(d, e, f) * T::literal(0.5));
        match level {
            Level::Place => list([-a, -b, -c], &[x, y, z].map(|own| cross(own, half))),
            Level::Velocity => Spatial::<T>::no_tip(),
        }
    }
    fn of_turn(&self, &[.., x, y, z]: &[T; 6], frame: &Frame<T>) -> Vector3<T> {
        aligned(&frame.turn.attitude, &self.attitude.matrix(), Vector3::new(x, y, z))
    }
}

/// The axis a of the ground and b of the tip, and the sum n of directions across them, so that ν · y = n · (a × b).
fn tilted<T: Scalar>(
    tip: &Hinged<[T; 3], Rotation<T>, T>,
    &[.., one, other]: &[T; 5],
    frame: &Frame<T>,
) -> [Vector3<T>; 3] {
    let [first, second, axis] = tip.directions();
    [axis, frame.turn.attitude.apply(tip.axis()), add_scaled(first * one, other, second)]
}

/// Directions are those across the axis and the axis, inertial axes, and the axis in axes of the body.
impl<T: Scalar> ReversibleTip<Spatial<T>> for Hinged<[T; 3], Rotation<T>, T> {
    const KIND: Kind = Kind::Rigid;

    fn columns(&self) -> [Wrench<T>; 5] {
        let ([a, b, c], [first, second, _]) = (pulls(), self.directions());
        [a, b, c, twist(first), twist(second)]
    }
    fn numbers(&self, _: T::Real) -> [T; TIP] {
        let (place, [first, second, axis]) = (self.place(), self.directions());
        list(place, &[first, second, axis, self.axis()])
    }
    fn of_columns(
        &self,
        (weight, a): (&[T; 5], &Acceleration<T>),
        (force, w): (&[T; 5], &Acceleration<T>),
    ) -> [T; TIP] {
        let of = |k: usize| add_scaled(w.angular * force[k], -weight[k], a.angular);
        list([T::zero(); 3], &[of(3), of(4)])
    }
    fn of_residual(&self, weight: &[T; 5], frame: &Frame<T>, level: Level) -> [T; TIP] {
        let &[x, y, z, first, second] = weight;
        match level {
            Level::Place => {
                let [axis, own, across] = tilted(self, weight, frame);
                let tilt = cross(axis, own);
                let of_body = frame.turn.attitude.transposed(cross(across, axis));
                list([-x, -y, -z], &[tilt * first, tilt * second, cross(own, across), of_body])
            }
            Level::Velocity => list([T::zero(); 3], &[frame.turn.spin * first, frame.turn.spin * second]),
        }
    }
    fn of_turn(&self, weight: &[T; 5], frame: &Frame<T>) -> Vector3<T> {
        let [axis, own, across] = tilted(self, weight, frame);
        cross(own, cross(across, axis))
    }
}
