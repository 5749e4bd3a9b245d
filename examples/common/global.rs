//! The "ordinary method": angular accelerations of a chain of n rods from global equations, formed and factorised anew in each step.
//!
//! Rods of 1/n m and 1/n kg, the first on a pin of the ground, with springs of 20 N·m/rad between them; gravity along −y.

use nalgebra::{DMatrix, DVector, Matrix2, Matrix5, Vector2, Vector5};

const STIFFNESS: f64 = 20.0;
const GRAVITY: f64 = 9.81;

/// Torque of the springs on rod `k` (N·m).
fn springs(angles: &[f64], k: usize) -> f64 {
    let from = |a: usize, b: usize| STIFFNESS * (angles[b] - angles[a]);
    let inner = if k > 0 { from(k - 1, k) } else { 0.0 };
    let outer = if k + 1 < angles.len() { from(k, k + 1) } else { 0.0 };
    outer - inner
}

/// In all angles: M θ̈ = f, with a mass matrix that has no zeros.
pub fn dense(angles: &[f64], rates: &[f64]) -> Option<Vec<f64>> {
    let n = angles.len();
    let size = 1.0 / n as f64;
    let beyond = |k: usize| (n - 1 - k) as f64 + 0.5; // masses outboard of a rod, and half its own
    let mass = DMatrix::from_fn(n, n, |i, j| {
        let first = if i == j { (n - 1 - i) as f64 + 1.0 / 3.0 } else { beyond(i.max(j)) };
        size * size * size * first * (angles[i] - angles[j]).cos()
    });
    let force = DVector::from_fn(n, |i, _| {
        let centrifugal: f64 = (0..n)
            .filter(|j| *j != i)
            .map(|j| size * size * size * beyond(i.max(j)) * (angles[i] - angles[j]).sin() * rates[j] * rates[j])
            .sum();
        springs(angles, i) - centrifugal - GRAVITY * size * size * beyond(i) * angles[i].cos()
    });
    mass.cholesky().map(|factors| factors.solve(&force).as_slice().to_vec())
}

/// In all coordinates and forces in the pins: for each rod the acceleration of its mass centre, its angular acceleration, and the force
/// in the pin at its inboard end, so that only neighbours meet: block by block by Gauss, from the root to the tip and back.
pub fn sparse(angles: &[f64], rates: &[f64]) -> Option<Vec<f64>> {
    let n = angles.len();
    let size = 1.0 / n as f64;
    let (mass, inertia) = (size, size * size * size / 12.0);
    let mut eliminated: Vec<(Matrix5<f64>, Vector5<f64>)> = Vec::with_capacity(n);
    let mut inner = (Vector2::zeros(), Vector2::zeros()); // n and −ω² d of the rod before
    for (k, (angle, rate)) in angles.iter().zip(rates).enumerate() {
        let (s, c) = angle.sin_cos();
        let (arm, across) = (0.5 * size * Vector2::new(c, s), 0.5 * size * Vector2::new(-s, c));
        let central = -rate * rate * arm;
        // Newton and Euler, and that the ends in the pin accelerate alike.
        let mut own = Matrix5::zeros();
        own.fixed_view_mut::<2, 2>(0, 0).copy_from(&(mass * Matrix2::identity()));
        own.fixed_view_mut::<2, 2>(0, 3).copy_from(&-Matrix2::identity());
        own[(2, 2)] = inertia;
        own.fixed_view_mut::<1, 2>(2, 3).copy_from(&across.transpose());
        own.fixed_view_mut::<2, 2>(3, 0).copy_from(&Matrix2::identity());
        own.fixed_view_mut::<2, 1>(3, 2).copy_from(&-across);
        let apart = central + inner.1;
        let mut right = Vector5::new(0.0, -mass * GRAVITY, springs(angles, k), apart.x, apart.y);
        let mut outer = Matrix5::zeros();
        outer.fixed_view_mut::<2, 2>(0, 3).copy_from(&Matrix2::identity());
        outer.fixed_view_mut::<1, 2>(2, 3).copy_from(&across.transpose());
        if let Some((gain, known)) = eliminated.last() {
            let mut before = Matrix5::zeros();
            before.fixed_view_mut::<2, 2>(3, 0).copy_from(&-Matrix2::identity());
            before.fixed_view_mut::<2, 1>(3, 2).copy_from(&-inner.0);
            own -= before * gain;
            right -= before * known;
        }
        let factors = own.lu();
        eliminated.push((factors.solve(&outer)?, factors.solve(&right)?));
        inner = (across, central);
    }
    let mut accelerations = vec![0.0; n];
    let mut beyond = Vector5::zeros();
    for ((gain, known), acceleration) in eliminated.iter().zip(&mut accelerations).rev() {
        beyond = known - gain * beyond;
        *acceleration = beyond[2];
    }
    Some(accelerations)
}
