//! The directions in which linear conditions let coordinates move, by Householder's reflections.

use super::Matrix;
use crate::scalar::{Real, Scalar};
use alloc::vec;
use alloc::vec::Vec;

/// How much of a row must be left, as a share of what it was, where it is a condition of its own.
const OWN: f64 = 1e-7;
/// How much of a condition must be its own, as a share of it: [`OWN`], or what a number's kind rounds by.
pub(crate) fn dependent<R: Real>() -> R {
    R::of(OWN).max(R::EPSILON.sqrt())
}

/// Rows shorter than so many roundings of the longest are rounding.
const ROUNDINGS: f64 = 1e3;

/// The directions in which a few linear conditions let coordinates move: an orthonormal basis of the null space of their rows,
/// kept as the reflections that lead to it, so that it costs nothing where there are no conditions.
#[derive(Debug)]
pub(crate) struct Tangent<R> {
    freedoms: usize,
    redundant: bool,
    /// Unit normals of Householder's reflections.
    normals: Vec<Vec<R>>,
}

impl<R: Real> Tangent<R> {
    /// The null space of rows over so many coordinates, of which some may follow from others.
    pub fn of(freedoms: usize, rows: Vec<Vec<R>>) -> Self {
        let mut tangent = Self { freedoms, redundant: false, normals: vec![] };
        let conditions = rows.len();
        let own = dependent::<R>();
        let longest = rows.iter().fold(R::zero(), |most, row| most.max(length(row)));
        let mut waiting: Vec<(R, Vec<R>)> = rows.into_iter().map(|row| (length(&row), row)).collect();
        // Linkages of the plane are held across it by conditions that say nothing, but for rounding.
        waiting.retain(|(whole, _)| *whole > longest * R::EPSILON * R::of(ROUNDINGS));
        loop {
            // Of which most is left, first.
            let k = tangent.normals.len();
            let left = waiting.iter().map(|(whole, row)| length(row.get(k..).unwrap_or(&[])) / *whole).enumerate();
            let most =
                left.filter(|(_, share)| *share > own).reduce(|most, next| if next.1 > most.1 { next } else { most });
            let Some((at, _)) = most else { break };
            let (_, mut normal) = waiting.remove(at);
            normal[..k].fill(R::zero());
            let whole = length(&normal);
            // Away from zero, so that no digits cancel.
            let sign = if normal[k] < R::zero() { -whole } else { whole };
            normal[k] += sign;
            let inverse = length(&normal).recip();
            normal.iter_mut().for_each(|x| *x *= inverse);
            waiting.iter_mut().for_each(|(_, row)| mirror(&normal, row));
            tangent.normals.push(normal);
        }
        tangent.redundant = tangent.normals.len() < conditions;
        tangent
    }

    /// Whether conditions follow from others.
    pub fn is_redundant(&self) -> bool {
        self.redundant
    }

    /// Number of coordinates.
    pub fn freedoms(&self) -> usize {
        self.freedoms
    }

    /// Number of directions.
    pub fn dimension(&self) -> usize {
        self.freedoms - self.normals.len()
    }

    /// Applies all reflections, in the order they were found or backward.
    fn reflect<T: Scalar<Real = R>>(&self, vector: &mut [T], backward: bool) {
        let n = self.normals.len();
        for k in 0..n {
            mirror(&self.normals[if backward { n - 1 - k } else { k }], vector);
        }
    }

    /// Components along the directions.
    pub fn components<T: Scalar<Real = R>>(&self, vector: &[T]) -> Vec<T> {
        let mut turned = vector.to_vec();
        self.reflect(&mut turned, false);
        turned.split_off(self.normals.len())
    }

    /// A N for the basis N: what a linear map of the coordinates does in the directions.
    pub fn restrict(&self, map: &Matrix<R>) -> Matrix<R> {
        if self.normals.is_empty() {
            return map.clone();
        }
        let mut restricted = Matrix::zeros(map.rows().count(), self.dimension());
        for (row, of) in restricted.rows_mut().zip(map.rows()) {
            row.copy_from_slice(&self.components(of));
        }
        restricted
    }

    /// Nᵀ A N.
    pub fn reduce(&self, map: &Matrix<R>) -> Matrix<R> {
        self.restrict(&self.restrict(map).transposed()).transposed()
    }

    /// The vector with these components.
    pub fn vector<T: Scalar<Real = R>>(&self, components: &[T]) -> Vec<T> {
        let mut vector = vec![T::zero(); self.normals.len()];
        vector.extend_from_slice(components);
        self.reflect(&mut vector, true);
        vector
    }
}

/// A vector mirrored at the plane across a unit normal.
fn mirror<T: Scalar>(normal: &[T::Real], vector: &mut [T]) {
    let along = normal.iter().zip(&*vector).fold(T::zero(), |sum, (a, x)| sum.add_scaled(*a, *x));
    for (x, a) in vector.iter_mut().zip(normal) {
        *x = x.add_scaled(-*a - *a, along);
    }
}

fn length<R: Real>(vector: &[R]) -> R {
    vector.iter().fold(R::zero(), |sum, x| sum + *x * *x).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tangents_meet_their_conditions() {
        let rows = vec![vec![1.0, 2.0, -1.0, 0.0, 0.5], vec![0.0, 1.0, 1.0, 3.0, 0.0]];
        let tangent = Tangent::of(5, rows.clone());
        assert_eq!(tangent.dimension(), 3);
        for k in 0..3 {
            let mut unit = [0.0; 3];
            unit[k] = 1.0;
            let vector = tangent.vector(&unit);
            for row in &rows {
                assert!(row.iter().zip(&vector).map(|(a, b)| a * b).sum::<f64>().abs() < 1e-14);
            }
            let back = tangent.components(&vector);
            assert!(back.iter().zip(unit).all(|(a, b)| (a - b).abs() < 1e-14), "{back:?}");
        }
    }

    #[test]
    fn conditions_that_follow_from_others_take_no_direction() {
        let [one, other] = [vec![1.0, 2.0, -1.0, 0.5], vec![0.0, 1.0, 1.0, 3.0]];
        let sum: Vec<f64> = one.iter().zip(&other).map(|(a, b)| 0.3 * a + 0.1 * b).collect();
        let rows = vec![vec![0.0; 4], one.clone(), vec![1e-17, -2e-17, 0.0, 1e-17], sum, other.clone()];
        let tangent = Tangent::of(4, rows);
        assert_eq!(tangent.dimension(), 2);
        for unit in [[1.0, 0.0], [0.0, 1.0]] {
            let vector = tangent.vector(&unit);
            for row in [&one, &other] {
                assert!(row.iter().zip(&vector).map(|(a, b)| a * b).sum::<f64>().abs() < 1e-14);
            }
        }
    }
}
