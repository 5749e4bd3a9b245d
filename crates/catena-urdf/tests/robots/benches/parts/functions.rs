//! Functions of lists of the shipped robots: calls of them, to be counted.

use catena::robot::{Afloat, Blocks, ByState, ByStateAfloat, Columns, MassMatrix, Place};
use catena_urdf_robots::{arm7_local, cart_local, humanoid_local, quadruped_fixed, quadruped_local};
use std::error::Error;
use std::hint::black_box;

pub const ROBOTS: [&str; 5] = ["arm7", "cart", "quadruped, fixed", "quadruped", "humanoid"];
/// Those that grow with the square of the number of joints, and both dynamics.
pub const FUNCTIONS: [&str; 6] = [
    "forward_dynamics",
    "inverse_dynamics",
    "mass_matrix",
    "mass_inverse",
    "inverse_dynamics_derivatives",
    "forward_dynamics_derivatives",
];

type Outcome = Result<(), Box<dyn Error>>;

/// A state of joints.
fn state<const N: usize>() -> [[f64; N]; 3] {
    let list = |from: f64, by: f64| std::array::from_fn(|k| from + by * (k % 7) as f64);
    [list(0.1, 0.1), list(-0.3, 0.1), list(0.5, 0.0)]
}

fn base() -> Afloat<f64> {
    // Columns of a turn whose entries have all their digits.
    let [x, y, z] = [[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]].map(Into::into);
    let place = Place { place: [0.1, -0.2, 0.7].into(), attitude: Columns { x, y, z } };
    Afloat { place, velocity: [0.3, 0.2, -0.1].into(), spin: [0.5, -0.4, 0.6].into() }
}

/// Calls of a function of a robot on the ground.
macro_rules! fixed {
    ($name:ident, $function:expr, $times:expr) => {{
        const N: usize = $name::JOINTS.len();
        let (scene, list) = ($name::scene::<f64>()?, state::<N>());
        // Large answers go into places that are kept.
        let (mut mass, mut found) = ([[0.0; N]; N], (ByState::zero(), [[0.0; N]; N]));
        for _ in 0..$times {
            let [q, v, x] = black_box(&list);
            match $function {
                "forward_dynamics" => _ = black_box(scene.forward_dynamics(q, v, x)?),
                "inverse_dynamics" => _ = black_box(scene.inverse_dynamics(q, v, x)?),
                "mass_matrix" => {
                    scene.mass_matrix_into(q, &mut mass)?;
                    black_box(&mass);
                }
                "mass_inverse" => _ = black_box(scene.mass_inverse(q)?),
                "inverse_dynamics_derivatives" => _ = black_box(scene.inverse_dynamics_derivatives(q, v, x)?),
                _ => {
                    scene.forward_dynamics_derivatives_into(q, v, x, &mut found)?;
                    black_box(&found);
                }
            }
        }
    }};
}

/// Calls of a function of a robot whose base floats.
macro_rules! afloat {
    ($name:ident, $function:expr, $times:expr) => {{
        const N: usize = $name::JOINTS.len();
        let (scene, list, base, wrench) = ($name::scene::<f64>()?, state::<N>(), base(), [0.3; 6]);
        // Large answers go into places that are kept.
        let (mut mass, mut found) = (MassMatrix::zero(), (ByStateAfloat::zero(), Blocks::zero()));
        for _ in 0..$times {
            let ([q, v, x], base) = black_box((&list, base));
            match $function {
                "forward_dynamics" => _ = black_box(scene.forward_dynamics_afloat(base, q, v, &wrench, x)?),
                "inverse_dynamics" => _ = black_box(scene.inverse_dynamics_afloat(base, q, v, &wrench, x)?),
                "mass_matrix" => {
                    scene.mass_matrix_afloat_into(base.place, q, &mut mass)?;
                    black_box(&mass);
                }
                "mass_inverse" => {
                    scene.mass_inverse_afloat_into(base.place, q, &mut found.1)?;
                    black_box(&found.1);
                }
                "inverse_dynamics_derivatives" => {
                    scene.inverse_dynamics_derivatives_afloat_into(base, q, v, &wrench, x, &mut found.0)?;
                    black_box(&found.0);
                }
                _ => {
                    scene.forward_dynamics_derivatives_afloat_into(base, q, v, &wrench, x, &mut found)?;
                    black_box(&found);
                }
            }
        }
    }};
}

/// Calls a function of a robot a number of times.
pub fn run(robot: &str, function: &str, times: usize) -> Outcome {
    match robot {
        "arm7" => fixed!(arm7_local, function, times),
        "cart" => fixed!(cart_local, function, times),
        "quadruped, fixed" => fixed!(quadruped_fixed, function, times),
        "quadruped" => afloat!(quadruped_local, function, times),
        _ => afloat!(humanoid_local, function, times),
    }
    Ok(())
}
