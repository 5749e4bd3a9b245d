//! Chains of uniform rods on pins, 1 m and 1 kg in all, let go at rest from the horizontal, as other crates have them.

use nalgebra::{Cholesky, DMatrix, DVector};
use phyz::{Mat3, Model, ModelBuilder, SpatialInertia, SpatialTransform, State, Vec3};
use std::time::Instant;

pub const GRAVITY: f64 = 9.81;

/// As phyz has it: revolutes about z, relative angles.
pub fn phyz_chain(bodies: usize, step: f64) -> Model {
    let size = 1.0 / bodies as f64;
    // What its rods are about their own axis is not seen.
    let across = size * size * size / 12.0;
    let tensor = Mat3::from_diagonal(&Vec3::new(1e-3 * across, across, across));
    let inertia = SpatialInertia::new(size, Vec3::new(0.5 * size, 0.0, 0.0), tensor);
    let mut model = ModelBuilder::new().gravity(Vec3::new(0.0, -GRAVITY, 0.0)).dt(step);
    for k in 0..bodies {
        let place = Vec3::new(if k == 0 { 0.0 } else { size }, 0.0, 0.0);
        let place = SpatialTransform::from_translation(place);
        model = model.add_revolute_body(&format!("rod {k}"), k as i32 - 1, place, inertia);
    }
    model.build()
}

/// The absolute angle of the last rod (rad).
pub fn last_angle(state: &State) -> f64 {
    state.q.as_slice().iter().sum()
}

/// As a user writes it by hand for a solver of differential equations: absolute angles from the horizontal, then their rates, with the dense mass matrix
/// of the chain, M_ij = c_ij cos(θ_i − θ_j), and its Cholesky factors.
#[derive(Clone, Copy)]
pub struct ByHand {
    pub bodies: usize,
}

impl ByHand {
    fn coupling(self, i: usize, j: usize) -> f64 {
        let size = 1.0 / self.bodies as f64;
        let beyond = (self.bodies - 1 - i.max(j)) as f64;
        size * size * size * (beyond + if i == j { 1.0 / 3.0 } else { 0.5 })
    }
}

impl ode_solvers::System<f64, DVector<f64>> for ByHand {
    fn system(&self, _: f64, y: &DVector<f64>, dy: &mut DVector<f64>) {
        let n = self.bodies;
        let size = 1.0 / n as f64;
        let directions: Vec<(f64, f64)> = (0..n).map(|i| y[i].sin_cos()).collect();
        let mut mass = DMatrix::zeros(n, n);
        let mut force = DVector::zeros(n);
        for i in 0..n {
            let (si, ci) = directions[i];
            force[i] = -GRAVITY * size * size * ((n - 1 - i) as f64 + 0.5) * ci;
            for j in 0..n {
                let ((sj, cj), coupling) = (directions[j], self.coupling(i, j));
                mass[(i, j)] = coupling * (ci * cj + si * sj);
                force[i] -= coupling * (si * cj - ci * sj) * y[n + j] * y[n + j];
            }
        }
        let accelerations = Cholesky::new(mass).expect("a mass matrix is positive definite").solve(&force);
        for i in 0..n {
            dy[i] = y[n + i];
            dy[n + i] = accelerations[i];
        }
    }
}

/// The median time of a run (s), repeated for 30 ms and three times at least, and what it gives.
pub fn timed<X>(mut run: impl FnMut() -> X) -> (X, f64) {
    let (begun, mut seconds) = (Instant::now(), vec![]);
    loop {
        let start = Instant::now();
        let found = run();
        seconds.push(start.elapsed().as_secs_f64());
        if seconds.len() >= 3 && begun.elapsed().as_secs_f64() > 0.03 {
            seconds.sort_by(f64::total_cmp);
            return (found, seconds[seconds.len() / 2]);
        }
    }
}
