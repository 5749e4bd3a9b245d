//! The Riccati transform of transfer matrices as they are, in absolute coordinates.

use catena::{Scalar, TransferMatrix};
use core::array::from_fn;

/// Matrices of a chain, root to tip, solved by the Riccati transform as they are: f = S p + e with a general element
/// [A B a; C D d], from a root at the origin to a free tip. Gives θ at the inboard end of each.
pub fn transformed<T: Scalar>(matrices: &[TransferMatrix<T, 7>]) -> Vec<T> {
    let zero = T::zero();
    let (mut s, mut e) = ([[zero; 3]; 3], [zero; 3]);
    let mut relations = vec![(s, e)];
    for u in matrices.iter().rev() {
        // (D − S B) f_I = (S A − C) p_I + S a + e − d
        let entry = |i: usize, j: usize| u[(i, j)];
        let times = |i: usize, column: usize| (0..3).fold(zero, |sum, k| sum + s[i][k] * entry(k, column));
        let left: [[T; 3]; 3] = from_fn(|i| from_fn(|j| entry(3 + i, 3 + j) - times(i, 3 + j)));
        let right: [[T; 4]; 3] = from_fn(|i| {
            from_fn(|j| if j < 3 { times(i, j) - entry(3 + i, j) } else { times(i, 6) + e[i] - entry(3 + i, 6) })
        });
        let inverse = inverse(&left);
        let solved: [[T; 4]; 3] =
            from_fn(|i| from_fn(|j| (0..3).fold(zero, |sum, k| sum + inverse[i][k] * right[k][j])));
        (s, e) = (solved.map(|row| [row[0], row[1], row[2]]), solved.map(|row| row[3]));
        relations.push((s, e));
    }
    let mut p = [zero, zero, -(e[0] / s[0][2])];
    let mut angles = vec![];
    for (u, (s, e)) in matrices.iter().zip(relations.iter().rev()) {
        angles.push(p[2]);
        let f: [T; 3] = from_fn(|i| (0..3).fold(e[i], |sum, k| sum + s[i][k] * p[k]));
        p = from_fn(|i| (0..3).fold(u[(i, 6)], |sum, k| sum + u[(i, k)] * p[k] + u[(i, 3 + k)] * f[k]));
    }
    angles
}

fn inverse<T: Scalar>(a: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    let minor = |i: usize, j: usize| {
        let (i1, i2, j1, j2) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1]
    };
    let determinant = (0..3).fold(T::zero(), |sum, j| sum + a[0][j] * minor(0, j));
    from_fn(|i| from_fn(|j| minor(j, i) / determinant))
}
