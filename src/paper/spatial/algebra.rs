//! Three by three: products without tests for zero, which would lose derivatives.

use crate::mechanics::spatial::{Rotation, maps};
use crate::relation::spatial::algebra::Columns;
use crate::scalar::{Real, Scalar};
use nalgebra::Vector3;
use num_traits::Zero;

/// A column of three.
pub type Vector<T> = [T; 3];
/// Rows of three.
pub type Matrix<T> = [[T; 3]; 3];

pub fn from_fn<T>(entry: impl Fn(usize, usize) -> T) -> Matrix<T> {
    core::array::from_fn(|i| core::array::from_fn(|j| entry(i, j)))
}

pub fn columns<T: Copy>(columns: [Vector<T>; 3]) -> Matrix<T> {
    from_fn(|i, j| columns[j][i])
}

pub fn times<T: Scalar>(a: &Matrix<T>, b: &Matrix<T>) -> Matrix<T> {
    from_fn(|i, j| a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j])
}

pub fn apply<T: Scalar>(a: &Matrix<T>, x: Vector<T>) -> Vector<T> {
    a.map(|row| row[0] * x[0] + row[1] * x[1] + row[2] * x[2])
}

pub fn sum<T: Scalar>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn scaled<T: Scalar>(factor: T, a: Vector<T>) -> Vector<T> {
    a.map(|x| factor * x)
}

pub fn cross<T: Scalar>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// ã: the matrix of a × .
pub fn tilde<T: Scalar>([x, y, z]: Vector<T>) -> Matrix<T> {
    let zero = T::zero();
    [[zero, -z, y], [z, zero, -x], [-y, x, zero]]
}

/// The inverse by cofactors; `None` where it is singular but for rounding of terms of size `scale`: where the determinant is no more
/// than that times the largest cofactor.
pub fn inverse<T: Scalar>(a: &Matrix<T>, scale: T::Real) -> Option<Matrix<T>> {
    let [x, y, z] = *a;
    let cofactors = [cross(y, z), cross(z, x), cross(x, y)];
    let determinant = x[0] * cofactors[0][0] + x[1] * cofactors[0][1] + x[2] * cofactors[0][2];
    let rounding = T::Real::EPSILON * T::Real::of(64.0) * scale * size(&cofactors);
    (determinant.is_finite() && determinant.real().abs() > rounding).then(|| {
        let reciprocal = determinant.recip();
        from_fn(|i, j| cofactors[j][i] * reciprocal)
    })
}

/// The largest magnitude.
pub fn size<T: Scalar>(a: &Matrix<T>) -> T::Real {
    a.iter().flatten().fold(T::Real::zero(), |size, x| size.max(x.real().abs()))
}

pub fn identity<T: Scalar>() -> Matrix<T> {
    from_fn(|i, j| if i == j { T::one() } else { T::zero() })
}

pub fn transposed<T: Scalar>(a: &Matrix<T>) -> Matrix<T> {
    from_fn(|i, j| a[j][i])
}

pub fn difference<T: Scalar>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The rows of orthonormal columns.
pub fn rows<T: Scalar>(axes: &Columns<T>) -> Matrix<T> {
    columns([axes.x.into(), axes.y.into(), axes.z.into()])
}

pub fn axes<T: Scalar>(a: &Matrix<T>) -> Columns<T> {
    let column = |j: usize| Vector3::new(a[0][j], a[1][j], a[2][j]);
    Columns { x: column(0), y: column(1), z: column(2) }
}

/// exp ψ̃.
pub fn exponential<T: Scalar>(psi: Vector<T>) -> Matrix<T> {
    rows(&Rotation::exp(psi).matrix())
}

/// ψ of the least turn with exp ψ̃ = R.
pub fn logarithm<T: Scalar>(turn: &Matrix<T>) -> Vector<T> {
    Rotation::from_matrix(&axes(turn)).shortest().log()
}

/// T(ψ), ω = T ψ̇ in body axes.
pub fn tangent<T: Scalar>(psi: Vector<T>) -> Matrix<T> {
    columns(identity().map(|unit| maps::tangent(psi, unit)))
}

/// A rotation matrix brought back to one from which rounding led.
pub fn orthonormal<T: Scalar>(a: &Matrix<T>) -> Matrix<T> {
    let square = times(&transposed(a), a);
    let half = T::Real::of(0.5);
    times(a, &from_fn(|i, j| (if i == j { T::literal(3.0) } else { T::zero() } - square[i][j]).scale(half)))
}
