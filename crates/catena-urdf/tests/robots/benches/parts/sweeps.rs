//! Forward dynamics of the shipped robots under torques, in inertial axes, in axes of their bodies, and in these with no zero known by
//! type; functions of lists of the arm: calls of them, to be counted.

use catena::robot::{Loads, Torques};
use catena::system::Dynamics;
use catena_urdf_robots::{
    arm7, arm7_general, arm7_local, cart, cart_general, cart_local, humanoid, humanoid_general, humanoid_local,
    quadruped, quadruped_general, quadruped_local,
};
use std::error::Error;
use std::hint::black_box;

/// Of the arm, what the table of all robots does not have.
pub const OF_THE_ARM: [&str; 12] = [
    "bias",
    "gravity_torques",
    "mass_solved",
    "places",
    "jacobian",
    "mass_centre",
    "joint_energy",
    "snapshot",
    "snapshot: inverse_dynamics",
    "snapshot: mass_matrix",
    "snapshot: centroidal_momentum",
    "snapshot: regressor",
];

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
pub fn function(name: &str, times: usize) -> Outcome {
    let arm = arm7_local::scene::<f64>()?;
    let (q, v, x) = ([0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7], [0.3, -0.1, 0.2, 0.5, -0.4, 0.1, 0.2], [0.5; 7]);
    for _ in 0..times {
        let (q, v, x) = black_box((&q, &v, &x));
        match name {
            "bias" => _ = black_box(arm.bias(q, v)?),
            "gravity_torques" => _ = black_box(arm.gravity_torques(q)?),
            "mass_solved" => _ = black_box(arm.mass_solved(q, x)?),
            "places" => _ = black_box(arm.places(q)?),
            "jacobian" => _ = black_box(arm.jacobian(q, 6, [0.0, 0.0, 0.1])?),
            "mass_centre" => _ = black_box(arm.mass_centre(q)?),
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

/// Sweeps of a robot in one of three ways.
pub fn run(robot: &str, form: &str, times: usize) -> Outcome {
    match robot {
        "arm7" => robot!(times, form, arm7 arm7_local arm7_general),
        "quadruped" => robot!(times, form, quadruped quadruped_local quadruped_general),
        "humanoid" => robot!(times, form, humanoid humanoid_local humanoid_general),
        "cart" => robot!(times, form, cart cart_local cart_general),
        robot => return Err(robot.into()),
    }
    Ok(())
}
