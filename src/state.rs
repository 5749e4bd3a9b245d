//! State vectors and transfer matrices.
//!
//! A state vector collects what passes through a station: N = 7 in the plane, `[x, y, θ, m, q_x, q_y, 1]` (14), N = 13 in
//! space. A transfer matrix maps the state at an element's inboard end to that at its outboard end (15); those of a chain
//! multiply, outboard factors on the left (17).

use crate::scalar::Scalar;
use approx::{AbsDiffEq, RelativeEq};
use core::ops::{Index, IndexMut, Mul};
use nalgebra::{SMatrix, SVector};

/// The state of a station. Index it by name, for example `z[index::QX]`.
///
/// ```
/// use catena::StateVector;
/// use catena::planar::index::QY;
/// let z = StateVector::new([0.0, 0.0, 0.5, 0.0, 0.0, 9.81, 1.0]);
/// assert_eq!(z[QY], 9.81);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateVector<T, const N: usize>(SVector<T, N>);

/// The matrix that transfers the state of one station to another: z_O = U z_I.
///
/// ```
/// use catena::{StateVector, TransferMatrix};
/// use catena::planar::index::{THETA, X};
/// let mut u = TransferMatrix::<f64, 7>::identity();
/// u[(X, THETA)] = -2.0;
/// let z = StateVector::new([0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 1.0]);
/// assert_eq!((u * z)[X], -1.0);
/// assert_eq!(u.then(&u)[(X, THETA)], -4.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransferMatrix<T, const N: usize>(SMatrix<T, N, N>);

impl<T: Scalar, const N: usize> StateVector<T, N> {
    /// The state with these entries.
    pub fn new(entries: [T; N]) -> Self {
        Self(SVector::from(entries))
    }

    /// The entries as a nalgebra vector.
    pub fn as_vector(&self) -> &SVector<T, N> {
        &self.0
    }
}

impl<T: Scalar, const N: usize> TransferMatrix<T, N> {
    /// The identity: an element that changes nothing.
    pub fn identity() -> Self {
        Self::from_fn(|row, column| if row == column { T::one() } else { T::zero() })
    }

    /// The matrix with these entries.
    pub fn from_fn(entry: impl FnMut(usize, usize) -> T) -> Self {
        Self(SMatrix::from_fn(entry))
    }

    /// The matrix of this element followed, outboard, by another: `outer · self`, (17).
    #[must_use]
    pub fn then(&self, outer: &Self) -> Self {
        // Written out: nalgebra's product tests entries for zero, which loses derivatives.
        Self::from_fn(|i, j| (0..N).fold(T::zero(), |sum, k| sum + outer[(i, k)] * self[(k, j)]))
    }

    /// The entries as a nalgebra matrix.
    pub fn as_matrix(&self) -> &SMatrix<T, N, N> {
        &self.0
    }
}

impl<T: Scalar, const N: usize> Mul for TransferMatrix<T, N> {
    type Output = Self;
    fn mul(self, inner: Self) -> Self {
        inner.then(&self)
    }
}

impl<T: Scalar, const N: usize> Mul<StateVector<T, N>> for TransferMatrix<T, N> {
    type Output = StateVector<T, N>;
    fn mul(self, z: StateVector<T, N>) -> StateVector<T, N> {
        StateVector(SVector::from_fn(|i, _| (0..N).fold(T::zero(), |sum, k| sum + self[(i, k)] * z[k])))
    }
}

impl<T, const N: usize> Index<usize> for StateVector<T, N> {
    type Output = T;
    fn index(&self, i: usize) -> &T {
        &self.0[i]
    }
}

impl<T, const N: usize> IndexMut<usize> for StateVector<T, N> {
    fn index_mut(&mut self, i: usize) -> &mut T {
        &mut self.0[i]
    }
}

impl<T, const N: usize> Index<(usize, usize)> for TransferMatrix<T, N> {
    type Output = T;
    fn index(&self, at: (usize, usize)) -> &T {
        &self.0[at]
    }
}

impl<T, const N: usize> IndexMut<(usize, usize)> for TransferMatrix<T, N> {
    fn index_mut(&mut self, at: (usize, usize)) -> &mut T {
        &mut self.0[at]
    }
}

macro_rules! approximate {
    ($Name:ident) => {
        impl<T: AbsDiffEq<Epsilon: Copy>, const N: usize> AbsDiffEq for $Name<T, N> {
            type Epsilon = T::Epsilon;
            fn default_epsilon() -> T::Epsilon {
                T::default_epsilon()
            }
            fn abs_diff_eq(&self, other: &Self, epsilon: T::Epsilon) -> bool {
                self.0.iter().zip(other.0.iter()).all(|(a, b)| a.abs_diff_eq(b, epsilon))
            }
        }

        impl<T: RelativeEq<Epsilon: Copy>, const N: usize> RelativeEq for $Name<T, N> {
            fn default_max_relative() -> T::Epsilon {
                T::default_max_relative()
            }
            fn relative_eq(&self, other: &Self, epsilon: T::Epsilon, max_relative: T::Epsilon) -> bool {
                self.0.iter().zip(other.0.iter()).all(|(a, b)| a.relative_eq(b, epsilon, max_relative))
            }
        }
    };
}
approximate!(StateVector);
approximate!(TransferMatrix);
