//! Attitudes and places from nalgebra's types, and back: unit quaternions, rotation matrices, isometries.
//!
//! Places are arrays `[T; 3]` or `Vector3<T>`, between which and its points and translations nalgebra converts by itself.

use super::{BodyMotion, Clamped, Frame, Pinned, Rotation};
use crate::relation::spatial::algebra::Columns;
use crate::scalar::Scalar;
use nalgebra::{
    Isometry3, Matrix3, Point3, Quaternion, Rotation3, Translation3, Unit, UnitQuaternion, Vector3, Vector4,
};

impl<T: Scalar> From<UnitQuaternion<T>> for Rotation<T> {
    /// The quaternion's four numbers, bit by bit.
    fn from(attitude: UnitQuaternion<T>) -> Self {
        let [x, y, z, w]: [T; 4] = attitude.into_inner().coords.into();
        Self { w, v: Vector3::new(x, y, z) }
    }
}

impl<T: Scalar> From<Rotation<T>> for UnitQuaternion<T> {
    /// The rotation's four numbers, bit by bit.
    fn from(attitude: Rotation<T>) -> Self {
        let [w, x, y, z] = attitude.quaternion();
        Unit::new_unchecked(Quaternion::from_vector(Vector4::new(x, y, z, w)))
    }
}

impl<T: Scalar> From<Rotation3<T>> for Rotation<T> {
    fn from(attitude: Rotation3<T>) -> Self {
        Self::from_matrix(&attitude.into_inner().into())
    }
}

impl<T: Scalar> From<Rotation<T>> for Rotation3<T> {
    fn from(attitude: Rotation<T>) -> Self {
        Self::from_matrix_unchecked(attitude.matrix().into())
    }
}

impl<T: Scalar> From<Matrix3<T>> for Columns<T> {
    fn from(matrix: Matrix3<T>) -> Self {
        let [x, y, z]: [[T; 3]; 3] = matrix.into();
        Self { x: x.into(), y: y.into(), z: z.into() }
    }
}

impl<T: Scalar> From<Columns<T>> for Matrix3<T> {
    fn from(columns: Columns<T>) -> Self {
        let Columns { x, y, z } = columns;
        Self::from([x.into(), y.into(), z.into()])
    }
}

impl<T: Scalar> From<Isometry3<T>> for Frame<T> {
    /// At rest.
    fn from(place: Isometry3<T>) -> Self {
        let mut frame = Self::resting(place.translation.vector);
        frame.turn.attitude = Rotation::from(place.rotation).matrix();
        frame
    }
}

impl<T: Scalar> From<Frame<T>> for Isometry3<T> {
    /// Takes coordinates in axes of the body, from this point, to inertial ones.
    fn from(frame: Frame<T>) -> Self {
        let rotation = Rotation::from_matrix(&frame.turn.attitude).into();
        Self { rotation, translation: Translation3::from(frame.place) }
    }
}

impl<T: Scalar> From<BodyMotion<T>> for Isometry3<T> {
    /// Takes coordinates in axes of the body, from its inboard end, to inertial ones.
    fn from(body: BodyMotion<T>) -> Self {
        body.inboard.into()
    }
}

impl<T: Scalar> From<Isometry3<T>> for Clamped<[T; 3], Rotation<T>> {
    /// Held at this place and attitude.
    fn from(place: Isometry3<T>) -> Self {
        Self::at(place.translation.into(), place.rotation.into())
    }
}

impl<T: Scalar> From<Vector3<T>> for Pinned<[T; 3]> {
    /// Held at this place (m).
    fn from(place: Vector3<T>) -> Self {
        Self::on(place.into())
    }
}

impl<T: Scalar> From<Point3<T>> for Pinned<[T; 3]> {
    /// Held at this place (m).
    fn from(place: Point3<T>) -> Self {
        Self::on(place.into())
    }
}
