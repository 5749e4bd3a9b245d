//! Second moments Σ = ∫ x xᵀ dm of a body about its mass centre, by which its inertia tensor is J = tr Σ 1 − Σ.
//!
//! Masses are positive, and so are second moments along all axes: these are the tensors that bodies have. Mechanics asks for less. What
//! a body resists a rotation with are the moments of inertia, J = Σ₂ + Σ₃ in axes in which Σ is diagonal, and so on: where none of
//! these is negative, kinetic energies are none and no pivot of a sweep is, even if one of the Σ should be.

use super::Inertia;
use crate::error::Fault;
use crate::error::checks::largest;
use crate::scalar::{Real, Scalar};

/// Sweeps of Jacobi's method, which converges quadratically: a matrix of three rows takes five at most.
const SWEEPS: usize = 8;

/// Principal second moments.
pub(super) struct SecondMoments<T> {
    /// Principal second moments (kg·m²).
    values: [T; 3],
    /// Principal axes, in columns.
    axes: [[T; 3]; 3],
}

impl<T: Scalar> SecondMoments<T> {
    /// Of an inertia tensor, whose upper triangle is read.
    pub fn of(inertia: &Inertia<T>) -> Self {
        let tensor = inertia.about_centre;
        let half = (tensor[0][0] + tensor[1][1] + tensor[2][2]) * T::literal(0.5);
        let entry = |i: usize, j: usize| if i == j { half - tensor[i][i] } else { -tensor[i.min(j)][i.max(j)] };
        let mut matrix: [[T; 3]; 3] = core::array::from_fn(|i| core::array::from_fn(|j| entry(i, j)));
        let mut axes = core::array::from_fn(|i| core::array::from_fn(|j| if i == j { T::one() } else { T::zero() }));
        for _ in 0..SWEEPS {
            turn::<T, 0, 1>(&mut matrix, &mut axes);
            turn::<T, 0, 2>(&mut matrix, &mut axes);
            turn::<T, 1, 2>(&mut matrix, &mut axes);
        }
        Self { values: core::array::from_fn(|k| matrix[k][k]), axes }
    }

    /// The least second moment (kg·m²).
    pub fn least(&self) -> T {
        let [x, y, z] = self.values;
        lesser(x, lesser(y, z))
    }

    /// The least principal moment of inertia (kg·m²): the sum of the two lesser ones.
    pub fn least_moment(&self) -> T {
        let [x, y, z] = self.values;
        lesser(x + y, lesser(x + z, y + z))
    }

    /// The inertia tensor (kg·m²) with those that are negative set to zero.
    pub fn nearest(&self) -> [[T; 3]; 3] {
        let values = self.values.map(|x| x.if_negative(T::zero(), x));
        let trace = values[0] + values[1] + values[2];
        let entry = |i: usize, j: usize| {
            let sum = (0..3).fold(T::zero(), |sum, k| sum + self.axes[i][k] * values[k] * self.axes[j][k]);
            if i == j { trace - sum } else { -sum }
        };
        core::array::from_fn(|i| core::array::from_fn(|j| entry(i.min(j), i.max(j))))
    }
}

fn lesser<T: Scalar>(a: T, b: T) -> T {
    (a - b).if_negative(a, b)
}

/// Turns axes `I` and `J` in their plane so that the entry between them vanishes, each lane by its own angle. They are constants, so that no
/// compiler, however small its code is to be, asks whether there are such axes.
fn turn<T: Scalar, const I: usize, const J: usize>(matrix: &mut [[T; 3]; 3], axes: &mut [[T; 3]; 3]) {
    let off = matrix[I][J];
    let there = -off.abs(); // negative unless there is nothing to turn
    // t = tan φ, the smaller root of t² + 2 t (m_jj − m_ii) / (2 m_ij) − 1 = 0.
    let ratio = (matrix[J][J] - matrix[I][I]) / there.if_negative(off + off, T::one());
    let tangent = (ratio.abs() + (ratio * ratio + T::one()).sqrt()).recip();
    let tangent = there.if_negative(ratio.if_negative(-tangent, tangent), T::zero());
    let cosine = (tangent * tangent + T::one()).sqrt().recip();
    let sine = tangent * cosine;
    for rows in [&mut *matrix, axes] {
        for row in rows {
            (row[I], row[J]) = (cosine * row[I] - sine * row[J], sine * row[I] + cosine * row[J]);
        }
    }
    let (a, b) = (matrix[I], matrix[J]);
    for k in 0..3 {
        (matrix[I][k], matrix[J][k]) = (cosine * a[k] - sine * b[k], sine * a[k] + cosine * b[k]);
    }
}

impl<T: Scalar> Inertia<T> {
    /// What may be wrong with an inertia that a sweep can do with: moments that no distribution of mass has.
    ///
    /// ```
    /// use catena::Fault;
    /// use catena::spatial::Inertia;
    /// let of = |x, y, z| Inertia { mass: 1.0, centre: [0.0; 3], about_centre: [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]] };
    /// assert_eq!(of(1.0, 2.0, 3.0).doubt(), None); // a plate
    /// assert!(matches!(of(1.0, 2.0, 3.5).doubt(), Some(Fault::ImpossibleInertia { excess }) if (excess - 0.5).abs() < 1e-15));
    /// ```
    pub fn doubt(&self) -> Option<Fault> {
        let least = SecondMoments::of(self).least();
        let beyond = (least + self.slack()).if_negative(least, T::zero()).real().as_f64();
        if beyond < 0.0 {
            return Some(Fault::ImpossibleInertia { excess: -(beyond + beyond) });
        }
        let idle = (-self.mass).if_negative(T::zero(), self.largest());
        let value = self.mass.if_negative(self.mass, T::zero()).real().as_f64();
        (idle.real() > T::Real::of(0.0)).then_some(Fault::NotPositive { parameter: "mass", value })
    }

    /// What rounding may do to moments (kg·m²).
    pub(super) fn slack(&self) -> T {
        self.largest().scale(T::Real::EPSILON * T::Real::of(16.0))
    }

    fn largest(&self) -> T {
        largest(self.about_centre.into_iter().flatten())
    }
}

impl<T: Real> Inertia<T> {
    /// The nearest inertia that a body has, of the same mass and mass centre: that whose second moments ∫ x xᵀ dm about the mass
    /// centre differ least, by the sum of squares of the differences of all nine. Negative principal ones become zero, in the same
    /// axes. An inertia that a body has is left as it is.
    ///
    /// ```
    /// use catena::spatial::Inertia;
    /// let file = Inertia { mass: 1.0, centre: [0.0; 3], about_centre: [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.5_f64]] };
    /// let [[x, ..], [_, y, _], [.., z]] = file.repaired().about_centre;
    /// assert_eq!([x, y, z], [1.25, 2.25, 3.5]); // second moments 2.25, 1.25 and −0.25: a plate
    /// assert_eq!(file.repaired().doubt(), None);
    /// ```
    #[must_use]
    pub fn repaired(&self) -> Self {
        let moments = SecondMoments::of(self);
        if moments.least() >= -self.slack() {
            return *self;
        }
        Self { about_centre: moments.nearest(), ..*self }
    }
}
