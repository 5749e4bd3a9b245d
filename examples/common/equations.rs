//! The "ordinary method" of the paper's example 5, (41) with (42) corrected: all bodies of a row at once.
//!
//! Equal bodies hang one from the other on balls, the first from the ground; gravity along −y. The inertia is that about the inboard ball.

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

pub const GRAVITY: f64 = 9.81; // (m/s²)
pub const MASS: f64 = 1.0; // (kg)
pub const CENTRE: [f64; 3] = [0.5, 0.03, -0.02]; // (m)
pub const NEXT: [f64; 3] = [1.0, 0.0, 0.0]; // the next ball (m)
/// About the mass centre (kg·m²).
pub const INERTIA: [[f64; 3]; 3] = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];

/// Angular accelerations in body axes, of direction cosines and angular velocities, for any number of bodies. E₄₂ is printed with A₄ A₂ᵀ for
/// A₄ᵀ A₂, and F₄ with ω̃₄ J ω̃₄ for ω̃₄ J ω₄.
pub fn global(turned: &[Matrix3<f64>], omega: &[Vector3<f64>]) -> Option<Vec<Vector3<f64>>> {
    let n = turned.len();
    let [centre, next] = [CENTRE, NEXT].map(Vector3::from);
    let about_centre = Matrix3::from_fn(|i, k| INERTIA[i][k]);
    let j = about_centre + MASS * (Matrix3::identity() * centre.norm_squared() - centre * centre.transpose());
    let beyond = |k: usize| (n - 1 - k) as f64; // bodies outboard
    let first = |k: usize| centre + next * beyond(k);
    let tilde = |v: Vector3<f64>| v.cross_matrix();
    let spin = |k: usize, r: Vector3<f64>| omega[k].cross(&omega[k].cross(&r));
    let (mut e, mut f) = (DMatrix::zeros(3 * n, 3 * n), DVector::zeros(3 * n));
    for i in 0..n {
        let mut block = |k: usize, value: Matrix3<f64>| e.view_mut((3 * i, 3 * k), (3, 3)).copy_from(&value);
        block(i, j - tilde(next) * tilde(next) * (MASS * beyond(i)));
        let down = turned[i].transpose() * Vector3::y() * GRAVITY;
        let mut force = -omega[i].cross(&(j * omega[i]))
            - MASS * first(i).cross(&down)
            - MASS * beyond(i) * next.cross(&spin(i, next));
        for k in 0..n {
            let across = turned[i].transpose() * turned[k];
            if k > i {
                block(k, -tilde(next) * across * tilde(first(k)) * MASS);
                force -= MASS * next.cross(&(across * spin(k, first(k))));
            } else if k < i {
                block(k, -tilde(first(i)) * across * tilde(next) * MASS);
                force -= MASS * first(i).cross(&(across * spin(k, next)));
            }
        }
        f.fixed_rows_mut::<3>(3 * i).copy_from(&force);
    }
    let alpha = e.lu().solve(&f)?;
    Some((0..n).map(|k| alpha.fixed_rows::<3>(3 * k).into()).collect())
}
