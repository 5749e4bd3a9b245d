//! Vectors and matrices of three, written plainly: arrays of numbers, matrices as rows.

/// Three numbers.
pub type Vector = [f64; 3];
/// Three rows.
pub type Matrix = [[f64; 3]; 3];

pub const ZERO: Vector = [0.0; 3];
pub const IDENTITY: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

pub fn vector(entry: impl Fn(usize) -> f64) -> Vector {
    std::array::from_fn(entry)
}

pub fn matrix(entry: impl Fn(usize, usize) -> f64) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|k| entry(i, k)))
}

pub fn add(a: Vector, b: Vector) -> Vector {
    vector(|i| a[i] + b[i])
}

pub fn subtract(a: Vector, b: Vector) -> Vector {
    vector(|i| a[i] - b[i])
}

pub fn scale(factor: f64, a: Vector) -> Vector {
    a.map(|x| factor * x)
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The direction of a vector; none for zero. Lengths whose squares overflow or vanish are no exception.
pub fn unit(a: Vector) -> Option<Vector> {
    let largest = a.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    if largest == 0.0 || !largest.is_finite() {
        return None;
    }
    let a = a.map(|x| x / largest);
    Some(a.map(|x| x / dot(a, a).sqrt()))
}

pub fn transpose(a: &Matrix) -> Matrix {
    matrix(|i, k| a[k][i])
}

pub fn apply(a: &Matrix, x: Vector) -> Vector {
    a.map(|row| dot(row, x))
}

pub fn times(a: &Matrix, b: &Matrix) -> Matrix {
    let columns = transpose(b);
    matrix(|i, k| dot(a[i], columns[k]))
}

pub fn plus(a: &Matrix, b: &Matrix) -> Matrix {
    matrix(|i, k| a[i][k] + b[i][k])
}

pub fn trace(a: &Matrix) -> f64 {
    a[0][0] + a[1][1] + a[2][2]
}

/// R J Rᵀ, symmetric to the last bit.
pub fn turned(turn: &Matrix, tensor: &Matrix) -> Matrix {
    let full = times(&times(turn, tensor), &transpose(turn));
    matrix(|i, k| full[i.min(k)][i.max(k)])
}

/// The turn by an angle (rad) about a unit vector: cos 1 + sin ñ + (1 − cos) n nᵀ.
pub fn about(axis: Vector, angle: f64) -> Matrix {
    let (sine, cosine) = angle.sin_cos();
    let [x, y, z] = axis;
    let tilde = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    matrix(|i, k| {
        let one = if i == k { cosine } else { 0.0 };
        one + sine * tilde[i][k] + (1.0 - cosine) * axis[i] * axis[k]
    })
}

/// The least turn that brings one unit vector onto another, which must not be opposite.
pub fn least_turn(from: Vector, to: Vector) -> Matrix {
    let (axis, cosine) = (cross(from, to), dot(from, to));
    let factor = 1.0 / (1.0 + cosine);
    let [x, y, z] = axis;
    let tilde = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    matrix(|i, k| {
        let one = if i == k { cosine } else { 0.0 };
        one + tilde[i][k] + factor * axis[i] * axis[k]
    })
}

/// The unit quaternion `[w, x, y, z]` of a turn.
pub fn quaternion(a: &Matrix) -> [f64; 4] {
    // Four times the squares of its entries; the largest is the one to divide by.
    let squares = [
        1.0 + a[0][0] + a[1][1] + a[2][2],
        1.0 + a[0][0] - a[1][1] - a[2][2],
        1.0 - a[0][0] + a[1][1] - a[2][2],
        1.0 - a[0][0] - a[1][1] + a[2][2],
    ];
    let largest = (0..4).fold(0, |best, i| if squares[i] > squares[best] { i } else { best });
    let double = squares[largest].sqrt();
    let sum = |i: usize, k: usize| (a[i][k] + a[k][i]) / (2.0 * double);
    let difference = |i: usize, k: usize| (a[i][k] - a[k][i]) / (2.0 * double);
    let own = 0.5 * double;
    match largest {
        0 => [own, difference(2, 1), difference(0, 2), difference(1, 0)],
        1 => [difference(2, 1), own, sum(0, 1), sum(0, 2)],
        2 => [difference(0, 2), sum(0, 1), own, sum(1, 2)],
        _ => [difference(1, 0), sum(0, 2), sum(1, 2), own],
    }
}

/// Eigenvalues of a symmetric matrix and a turn whose columns are its eigenvectors, by Jacobi's method.
pub fn eigen(a: &Matrix) -> (Vector, Matrix) {
    let (mut a, mut vectors) = (*a, IDENTITY);
    // Convergence is quadratic: some six rounds suffice for any matrix.
    for _ in 0..16 {
        for (i, k) in [(0, 1), (0, 2), (1, 2)] {
            if a[i][k] == 0.0 {
                continue;
            }
            let slope = (a[k][k] - a[i][i]) / (2.0 * a[i][k]);
            let tangent = slope.signum() / (slope.abs() + slope.hypot(1.0));
            let cosine = 1.0 / tangent.hypot(1.0);
            let sine = tangent * cosine;
            let mut turn = IDENTITY;
            (turn[i][i], turn[k][k], turn[i][k], turn[k][i]) = (cosine, cosine, sine, -sine);
            a = turned(&transpose(&turn), &a);
            (a[i][k], a[k][i]) = (0.0, 0.0);
            vectors = times(&vectors, &turn);
        }
    }
    ([a[0][0], a[1][1], a[2][2]], vectors)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn off(a: &Matrix, b: &Matrix) -> f64 {
        (0..9).fold(0.0, |most, i| f64::max(most, (a[i / 3][i % 3] - b[i / 3][i % 3]).abs()))
    }

    #[test]
    fn eigenvectors_diagonalise() {
        let a = [[2.0, -0.3, 0.7], [-0.3, 1.0, 0.2], [0.7, 0.2, -0.4]];
        let (values, vectors) = eigen(&a);
        let diagonal = matrix(|i, k| if i == k { values[i] } else { 0.0 });
        // Some tens of roundings of entries up to two.
        assert!(off(&turned(&vectors, &diagonal), &a) < 1e-14);
        assert!(off(&times(&vectors, &transpose(&vectors)), &IDENTITY) < 1e-15);
    }

    #[test]
    fn quaternions_turn_as_their_matrices_do() {
        for axis in [[0.6, 0.0, 0.8], [-0.6, 0.8, 0.0], [0.0, -0.6, -0.8]] {
            for angle in [0.1, 1.5, 3.1, std::f64::consts::PI - 4e-9] {
                let turn = about(axis, angle);
                let [w, v @ ..] = quaternion(&turn);
                let x = [0.3, -0.7, 1.1];
                let by_quaternion = add(x, scale(2.0, cross(v, add(cross(v, x), scale(w, x)))));
                let difference = subtract(apply(&turn, x), by_quaternion);
                assert!(dot(difference, difference).sqrt() < 1e-15, "{axis:?} {angle}");
            }
        }
    }

    #[test]
    fn the_least_turn_brings_one_vector_onto_the_other() {
        let from = [0.6, 0.0, 0.8];
        let turn = least_turn(from, [0.0, 0.0, 1.0]);
        let difference = subtract(apply(&turn, from), [0.0, 0.0, 1.0]);
        assert!(dot(difference, difference).sqrt() < 1e-15);
        assert!(off(&times(&turn, &transpose(&turn)), &IDENTITY) < 1e-15);
    }
}
