//! What forward dynamics under torques and functions of lists cost: instructions a call, counted by callgrind (valgrind), of the shipped
//! robots in inertial axes, in axes of their bodies, and in these with no zero known by type.
//!
//! `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench -p catena-urdf-robots --bench robots` prints a table.

use catena::robot::{Loads, Torques};
use catena::system::Dynamics;
use catena_urdf_robots::{
    arm7, arm7_general, arm7_local, cart, cart_general, cart_local, humanoid, humanoid_general, humanoid_local,
    quadruped, quadruped_general, quadruped_local,
};
use std::error::Error;
use std::hint::black_box;
use std::process::Command;

/// Calls of each of two counts, whose difference is shared out.
const CALLS: [usize; 2] = [100, 600];

type Outcome = Result<(), Box<dyn Error>>;

/// Sweeps of a scene under loads.
macro_rules! sweeps {
    ($name:ident, $times:expr, $loads:expr) => {{
        let scene = $name::scene::<f64>()?;
        let mut motion = scene.motion();
        let mut list = motion.coordinates();
        let first = list.len() - $name::JOINTS.len();
        list[first..].iter_mut().enumerate().for_each(|(k, x)| *x = 0.1 * (k + 1) as f64);
        motion.set_coordinates(&list)?;
        let count = $name::JOINTS.len() + if first > 0 { 6 } else { 0 };
        let rates: Vec<f64> = (0..count).map(|k| 0.1 * k as f64 - 0.3).collect();
        let motion = scene.with_rates(motion, &rates)?;
        let (loads, mut workspace) = ($loads, scene.workspace());
        let mut found = motion.acceleration().clone();
        for _ in 0..$times {
            let (position, rate) = black_box((motion.position(), motion.rate()));
            scene.accelerations(0.0, position, rate, black_box(&loads), &mut workspace, &mut found);
            black_box(&found);
        }
    }};
}

/// A robot in three ways.
macro_rules! robot {
    ($times:expr, $form:expr, $inertial:ident $local:ident $general:ident) => {
        match $form {
            "inertial" => {
                sweeps!($inertial, $times, Loads::none().efforts($inertial::efforts([0.5; $inertial::JOINTS.len()])))
            }
            "local" => sweeps!($local, $times, Torques([0.5; $local::JOINTS.len()])),
            "general" => sweeps!($general, $times, Torques([0.5; $general::JOINTS.len()])),
            form => return Err(form.into()),
        }
    };
}

/// Functions of lists, of the arm.
fn function(name: &str, times: usize) -> Outcome {
    let arm = arm7_local::scene::<f64>()?;
    let (q, v, x) = ([0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7], [0.3, -0.1, 0.2, 0.5, -0.4, 0.1, 0.2], [0.5; 7]);
    for _ in 0..times {
        let (q, v, x) = black_box((&q, &v, &x));
        match name {
            "forward_dynamics" => _ = black_box(arm.forward_dynamics(q, v, x)?),
            "inverse_dynamics" => _ = black_box(arm.inverse_dynamics(q, v, x)?),
            "bias" => _ = black_box(arm.bias(q, v)?),
            "gravity_torques" => _ = black_box(arm.gravity_torques(q)?),
            "mass_matrix" => _ = black_box(arm.mass_matrix(q)?),
            "mass_solved" => _ = black_box(arm.mass_solved(q, x)?),
            "mass_inverse" => _ = black_box(arm.mass_inverse(q)?),
            "places" => _ = black_box(arm.places(q)?),
            "jacobian" => _ = black_box(arm.jacobian(q, 6, [0.0, 0.0, 0.1])?),
            "mass_centre" => _ = black_box(arm.mass_centre(q)?),
            "inverse_dynamics_derivatives" => _ = black_box(arm.inverse_dynamics_derivatives(q, v, x)?),
            "forward_dynamics_derivatives" => _ = black_box(arm.forward_dynamics_derivatives(q, v, x)?),
            "snapshot" => _ = black_box(arm.snapshot(q, v)?),
            "snapshot: inverse_dynamics" => _ = black_box(arm.snapshot(q, v)?.inverse_dynamics(&[0.0; 6], x)),
            "snapshot: mass_matrix" => _ = black_box(arm.snapshot(q, v)?.mass_matrix()),
            "snapshot: centroidal_momentum" => _ = black_box(arm.snapshot(q, v)?.centroidal_momentum()),
            "snapshot: regressor" => _ = black_box(arm.snapshot(q, v)?.regressor(&[0.0; 6], x)),
            "joint_energy" => _ = black_box(arm.joint_energy(q, v)?),
            name => return Err(name.into()),
        }
    }
    Ok(())
}

fn run(what: &str, form: &str, times: usize) -> Outcome {
    match what {
        "arm7" => robot!(times, form, arm7 arm7_local arm7_general),
        "quadruped" => robot!(times, form, quadruped quadruped_local quadruped_general),
        "humanoid" => robot!(times, form, humanoid humanoid_local humanoid_general),
        "cart" => robot!(times, form, cart cart_local cart_general),
        _ => function(form, times)?,
    }
    Ok(())
}

/// Instructions of a call.
fn instructions(what: &str, form: &str) -> Result<usize, Box<dyn Error>> {
    let mut counts = [0; 2];
    for (count, calls) in counts.iter_mut().zip(CALLS) {
        let program = std::env::current_exe()?;
        let output = Command::new("valgrind")
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg(program)
            .args(["repeat", what, form, &calls.to_string()])
            .output()?;
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        let counted = text.lines().find_map(|line| line.split("Collected : ").nth(1));
        *count = counted.ok_or("valgrind counted nothing")?.trim().parse()?;
    }
    Ok((counts[1] - counts[0]) / (CALLS[1] - CALLS[0]))
}

fn main() -> Outcome {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let ["repeat", what, form, times] = arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        return run(what, form, times.parse()?);
    }
    println!("| forward dynamics | inertial axes | body axes | no zeros known |\n|---|---:|---:|---:|");
    for robot in ["arm7", "cart", "quadruped", "humanoid"] {
        let [a, b, c] = ["inertial", "local", "general"].map(|form| instructions(robot, form));
        println!("| {robot} | {} | {} | {} |", a?, b?, c?);
    }
    println!("\n| function of lists, arm7 | instructions |\n|---|---:|");
    let lists = ["forward_dynamics", "inverse_dynamics", "bias", "gravity_torques", "mass_matrix", "mass_solved"];
    let others = ["mass_inverse", "places", "jacobian", "mass_centre", "joint_energy"];
    let derivatives = ["inverse_dynamics_derivatives", "forward_dynamics_derivatives", "snapshot"];
    let of_snapshots = ["inverse_dynamics", "mass_matrix", "centroidal_momentum", "regressor"];
    let of_snapshots = of_snapshots.map(|name| format!("snapshot: {name}"));
    let names = lists.into_iter().chain(others).chain(derivatives).chain(of_snapshots.iter().map(String::as_str));
    for name in names {
        println!("| {name} | {} |", instructions("functions", name)?);
    }
    Ok(())
}
