//! What functions of lists cost that are quadratic in the number of joints: instructions a call, counted by callgrind (valgrind), of the
//! shipped robots.
//!
//! `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench -p catena-urdf-robots --bench functions` prints a table.

use catena::robot::{Afloat, Columns, Place};
use catena_urdf_robots::{arm7_local, cart_local, humanoid_local, quadruped_fixed, quadruped_local};
use std::error::Error;
use std::hint::black_box;
use std::process::Command;

/// Calls of each of two counts, whose difference is shared out.
const CALLS: [usize; 2] = [100, 600];
const ROBOTS: [&str; 5] = ["arm7", "cart", "quadruped, fixed", "quadruped", "humanoid"];
const FUNCTIONS: [&str; 4] =
    ["mass_matrix", "mass_inverse", "inverse_dynamics_derivatives", "forward_dynamics_derivatives"];

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
        for _ in 0..$times {
            let [q, v, x] = black_box(&list);
            match $function {
                "mass_matrix" => _ = black_box(scene.mass_matrix(q)?),
                "mass_inverse" => _ = black_box(scene.mass_inverse(q)?),
                "inverse_dynamics_derivatives" => _ = black_box(scene.inverse_dynamics_derivatives(q, v, x)?),
                _ => _ = black_box(scene.forward_dynamics_derivatives(q, v, x)?),
            }
        }
    }};
}

/// Calls of a function of a robot whose base floats.
macro_rules! afloat {
    ($name:ident, $function:expr, $times:expr) => {{
        const N: usize = $name::JOINTS.len();
        let (scene, list, base, wrench) = ($name::scene::<f64>()?, state::<N>(), base(), [0.3; 6]);
        for _ in 0..$times {
            let ([q, v, x], base) = black_box((&list, base));
            match $function {
                "mass_matrix" => _ = black_box(scene.mass_matrix_afloat(base.place, q)?),
                "mass_inverse" => _ = black_box(scene.mass_inverse_afloat(base.place, q)?),
                "inverse_dynamics_derivatives" => {
                    _ = black_box(scene.inverse_dynamics_derivatives_afloat(base, q, v, &wrench, x)?);
                }
                _ => _ = black_box(scene.forward_dynamics_derivatives_afloat(base, q, v, &wrench, x)?),
            }
        }
    }};
}

fn run(robot: &str, function: &str, times: usize) -> Outcome {
    match robot {
        "arm7" => fixed!(arm7_local, function, times),
        "cart" => fixed!(cart_local, function, times),
        "quadruped, fixed" => fixed!(quadruped_fixed, function, times),
        "quadruped" => afloat!(quadruped_local, function, times),
        _ => afloat!(humanoid_local, function, times),
    }
    Ok(())
}

/// Instructions of a call, where valgrind knows them all.
fn instructions(robot: &str, function: &str) -> Result<Option<usize>, Box<dyn Error>> {
    let mut counts = [0; 2];
    for (count, calls) in counts.iter_mut().zip(CALLS) {
        let output = Command::new("valgrind")
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg(std::env::current_exe()?)
            .args(["repeat", robot, function, &calls.to_string()])
            .output()?;
        if !output.status.success() {
            return Ok(None);
        }
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        let counted = text.lines().find_map(|line| line.split("Collected : ").nth(1));
        *count = counted.ok_or("valgrind counted nothing")?.trim().parse()?;
    }
    Ok(Some((counts[1] - counts[0]) / (CALLS[1] - CALLS[0])))
}

fn main() -> Outcome {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let ["repeat", robot, function, times] = arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        return run(robot, function, times.parse()?);
    }
    println!("| function | {} |\n|---|{}", ROBOTS.join(" | "), "---:|".repeat(ROBOTS.len()));
    for function in FUNCTIONS {
        let counts: Result<Vec<_>, _> = ROBOTS.iter().map(|robot| instructions(robot, function)).collect();
        let cells: Vec<_> =
            counts?.iter().map(|count| count.map_or("–".to_owned(), |count| count.to_string())).collect();
        println!("| `{function}` | {} |", cells.join(" | "));
    }
    Ok(())
}
