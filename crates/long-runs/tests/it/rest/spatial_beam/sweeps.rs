//! Stiffness and inertia of a scene as dense matrices, from its accelerations alone: differences of sweeps about a motion at rest.

use catena::loading::Loading;
use catena::spatial::*;
use catena::system::Element;
use catena::system::{MotionOf, Runs};
use catena::system::{Position, Rate};
use catena::system::{Root, Tip};
use catena::{Error, Scalar};
use nalgebra::DMatrix;

/// Accelerations of all coordinates.
pub fn accelerations<R, C, P, L>(
    scene: &System<f64, R, C, P>,
    motion: MotionOf<Spatial<f64>, R, C, P>,
    loads: &L,
) -> Result<Vec<f64>, Error>
where
    R: Root<Spatial<f64>>,
    C: Element<Spatial<f64>>,
    P: Tip<Spatial<f64>>,
    L: Loading<Spatial<f64>>,
    System<f64, R, C, P>: Runs<L, Spatial<f64>, R, C, P>,
{
    let mut all = vec![];
    scene.with_accelerations(motion, loads)?.acceleration().visit(&mut |x| all.push(x));
    Ok(all)
}

/// A motion displaced by a step of its coordinates.
pub fn displaced<R, C, P>(motion: &MotionOf<Spatial<f64>, R, C, P>, step: &[f64]) -> MotionOf<Spatial<f64>, R, C, P>
where
    R: Root<Spatial<f64>>,
    C: Element<Spatial<f64>>,
    P: Tip<Spatial<f64>>,
{
    let mut moved = motion.clone();
    let mut rate = motion.rate().clone();
    let mut steps = step.iter();
    rate.replace(&mut |_| *steps.next().unwrap());
    moved.position_mut().displace(&rate);
    moved
}

/// How accelerations change with coordinates, by differences of order 4.
pub fn response<R, C, P, L>(
    scene: &System<f64, R, C, P>,
    motion: &MotionOf<Spatial<f64>, R, C, P>,
    loads: &L,
    reach: f64,
) -> Result<DMatrix<f64>, Error>
where
    R: Root<Spatial<f64>>,
    C: Element<Spatial<f64>>,
    P: Tip<Spatial<f64>>,
    L: Loading<Spatial<f64>>,
    System<f64, R, C, P>: Runs<L, Spatial<f64>, R, C, P>,
{
    let mut n = 0;
    motion.rate().visit(&mut |_: f64| n += 1);
    let mut matrix = DMatrix::zeros(n, n);
    for j in 0..n {
        for (at, weight) in [(1.0, 2.0 / 3.0), (-1.0, -2.0 / 3.0), (2.0, -1.0 / 12.0), (-2.0, 1.0 / 12.0)] {
            let mut step = vec![0.0; n];
            step[j] = at * reach;
            let found = accelerations(scene, displaced::<R, C, P>(motion, &step), loads)?;
            for i in 0..n {
                matrix[(i, j)] += weight * found[i] / reach;
            }
        }
    }
    assert!(matrix.iter().all(|x: &f64| x.is_finite()));
    Ok(matrix)
}

/// Frequencies (rad/s), rising, and mode shapes (largest entry one) of a scene about a motion at rest: of q̈ = −M⁻¹K q, made symmetric
/// by the inertia M of the coordinates, which the energy of rates tells.
pub fn frequencies<R, C, P>(
    scene: &System<f64, R, C, P>,
    motion: &MotionOf<Spatial<f64>, R, C, P>,
) -> Result<Vec<(f64, Vec<f64>)>, Error>
where
    R: Root<Spatial<f64>>,
    C: Element<Spatial<f64>>,
    P: Tip<Spatial<f64>>,
    System<f64, R, C, P>: Runs<Unloaded, Spatial<f64>, R, C, P>,
{
    let response = -response(scene, motion, &Unloaded, 1e-3)?;
    let n = response.nrows();
    let kinetic = |rates: &[(usize, f64)]| {
        let mut moving = motion.clone();
        let mut k = 0;
        moving.rate_mut().replace(&mut |_| {
            k += 1;
            rates.iter().filter(|(i, _)| *i == k - 1).map(|(_, x)| x).sum::<f64>()
        });
        scene.budget(&moving).unwrap().kinetic
    };
    let own: Vec<f64> = (0..n).map(|i| kinetic(&[(i, 1.0)])).collect();
    let inertia =
        DMatrix::from_fn(
            n,
            n,
            |i, j| {
                if i == j { 2.0 * own[i] } else { kinetic(&[(i, 1.0), (j, 1.0)]) - own[i] - own[j] }
            },
        );
    let lower = inertia.cholesky().expect("inertia is positive definite").l();
    let inverse = lower.clone().try_inverse().expect("regular");
    // Lᵀ (M⁻¹K) L⁻ᵀ = L⁻¹ K L⁻ᵀ
    let symmetric = lower.transpose() * response * inverse.transpose();
    let symmetric = (&symmetric + symmetric.transpose()) * 0.5;
    let eigen = symmetric.symmetric_eigen();
    let mut modes: Vec<(f64, Vec<f64>)> = (0..n)
        .map(|k| {
            let shape = inverse.transpose() * eigen.eigenvectors.column(k);
            let size = shape.amax();
            (eigen.eigenvalues[k].sqrt(), shape.iter().map(|x| x / size).collect())
        })
        .collect();
    modes.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert!(modes.iter().all(|(frequency, _)| Scalar::is_finite(*frequency)));
    Ok(modes)
}
