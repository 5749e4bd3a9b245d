//! A published robot: `states` writes random states and what functions answer there, `time` what they take (ns), as the bench `times` of
//! catena-urdf-robots does for shipped ones, and `sweeps N` sweeps N times under torques, to be counted.

#[macro_use]
#[path = "../../../../crates/catena-urdf/tests/robots/benches/parts/states.rs"]
mod states;

include!(concat!(env!("OUT_DIR"), "/robot.rs"));

use catena::robot::{SixRows, Snapshot, Torques};
use catena::system::{Dynamics, Rate};
use states::{Noise, Outcome, STATES, State, Work, write};
use std::hint::black_box;

/// The last joint, and where the description's link stands in axes of its body.
mod link {
    pub const LAST: usize = super::robot::JOINTS.len() - 1;
    pub const PLACE: [f64; 3] = super::LAST_LINK;
}

/// A point of its body (m).
const POINT: [f64; 3] = [0.1, -0.2, 0.3];

fn rows<const N: usize>(rows: &SixRows<f64, N>, floats: bool) -> Vec<f64> {
    let base = if floats { &rows.base[..] } else { &[] };
    base.iter().chain(&rows.joints).flatten().copied().collect()
}

/// Answers that no other program times.
fn answers<const N: usize>(now: &Snapshot<f64, N>, state: &State<N>, floats: bool) -> Outcome {
    let (last, seconds) = (Some(link::LAST), if floats { state.base_seconds } else { [0.0; 6] });
    let [place, velocity] = now.point(last, POINT)?;
    write("point", &[place.x, place.y, place.z, velocity.x, velocity.y, velocity.z]);
    let [a, angular] = now.point_acceleration(last, POINT, &seconds, &state.seconds)?;
    write("point_acceleration", &[a.x, a.y, a.z, angular.x, angular.y, angular.z]);
    write("snapshot_jacobian", &rows(&now.jacobian(last, POINT)?, floats));
    write("jacobian_rate", &rows(&now.jacobian_rate(last, POINT)?, floats));
    write("momentum_matrix", &rows(&now.momentum_matrix(), floats));
    let [p, l] = now.centroidal_momentum();
    write("centroidal_momentum", &[p.x, p.y, p.z, l.x, l.y, l.z]);
    let (centre, mass) = now.mass_centre();
    write("mass_centre", &[centre.x, centre.y, centre.z, mass]);
    let (base, joints) = now.mass_centre_jacobian();
    let base = if floats { &base[..] } else { &[] };
    write("mass_centre_jacobian", &base.iter().chain(&joints).flatten().copied().collect::<Vec<_>>());
    let (wrench, torques) = now.inverse_dynamics(&seconds, &state.seconds);
    let wrench = if floats { &wrench[..] } else { &[] };
    write("snapshot_inverse_dynamics", &[wrench, &torques].concat());
    // The regressor times its parameters.
    let (regressor, (of_base, of_bodies)) = (now.regressor(&seconds, &state.seconds), now.parameters());
    let times = |row: &[f64; 10], by: &[f64; 10]| row.iter().zip(by).map(|(a, b)| a * b).sum::<f64>();
    let sum = |row: &[[f64; 10]; N]| row.iter().zip(&of_bodies).map(|(row, by)| times(row, by)).sum::<f64>();
    let on_base = (0..6).map(|i| times(&regressor.base[i], &of_base) + sum(&regressor.on_base[i]));
    let on_base = on_base.take(if floats { 6 } else { 0 });
    write("regressor", &on_base.chain(regressor.joints.iter().map(sum)).collect::<Vec<_>>());
    Ok(())
}

#[cfg(not(floats))]
fn more() -> Outcome {
    let (scene, mut noise) = (robot::scene::<f64>()?, Noise(5));
    for _ in 0..STATES {
        let state = State::<{ robot::JOINTS.len() }>::random(&mut noise);
        let (q, v) = (&state.q, &state.v);
        answers(&scene.snapshot(q, v)?, &state, false)?;
        write("bias", &scene.bias(q, v)?);
        write("gravity_torques", &scene.gravity_torques(q)?);
        write("mass_inverse", scene.mass_inverse(q)?.as_flattened());
        write("mass_solved", &scene.mass_solved(q, &state.torques)?);
        write("energy", &scene.joint_energy(q, v)?);
        write("compliance", scene.operational_compliance(q, link::LAST, POINT)?.as_flattened());
        let by = scene.inverse_dynamics_derivatives(q, v, &state.seconds)?;
        write("inverse_dynamics_derivatives", &[by.positions.as_flattened(), by.rates.as_flattened()].concat());
        let place = scene.places(q)?[link::LAST].point(link::PLACE);
        write("place", &[place.x, place.y, place.z]);
    }
    Ok(())
}

#[cfg(floats)]
fn more() -> Outcome {
    let (scene, mut noise) = (robot::scene::<f64>()?, Noise(5));
    for _ in 0..STATES {
        let state = State::<{ robot::JOINTS.len() }>::random(&mut noise);
        let (base, q, v) = (state.base(), &state.q, &state.v);
        answers(&scene.snapshot_afloat(base, q, v)?, &state, true)?;
        let blocks = |of: &catena::robot::Blocks<f64, { robot::JOINTS.len() }>| {
            let mut list = vec![];
            of.base.iter().zip(&of.base_by_joints).for_each(|(a, b)| list.extend(a.iter().chain(b).copied()));
            of.joints_by_base.iter().zip(&of.joints).for_each(|(a, b)| list.extend(a.iter().chain(b).copied()));
            list
        };
        write("mass_inverse", &blocks(&scene.mass_inverse_afloat(base.place, q)?));
        let (of_base, of_joints) = scene.mass_solved_afloat(base.place, q, &[0.0; 6], &state.torques)?;
        write("mass_solved", &[&of_base[..], &of_joints].concat());
        write("energy", &scene.joint_energy_afloat(base, q, v)?);
        let compliance = scene.operational_compliance_afloat(base.place, q, Some(link::LAST), POINT)?;
        write("compliance", compliance.as_flattened());
    }
    Ok(())
}

/// Sweeps of the scene, all joints under torques.
fn sweeps(times: usize) -> Outcome {
    let scene = robot::scene::<f64>()?;
    let (mut motion, mut noise) = (scene.motion(), Noise(5));
    let mut list = motion.coordinates();
    let first = list.len() - robot::JOINTS.len();
    list[first..].iter_mut().for_each(|x| *x = noise.next());
    motion.set_coordinates(&list)?;
    let rates: Vec<f64> = (0..motion.rate_count()).map(|_| noise.next()).collect();
    motion.set_rates(&rates)?;
    let (loads, mut workspace) = (Torques([0.5; robot::JOINTS.len()]), scene.workspace());
    let mut found = motion.acceleration().clone();
    for _ in 0..times {
        let (position, rate) = black_box((motion.position(), motion.rate()));
        scene.accelerations(0.0, position, rate, black_box(&loads), &mut workspace, &mut found);
        black_box(&found);
    }
    Ok(())
}

fn main() -> Outcome {
    let words: Vec<String> = std::env::args().skip(1).collect();
    if let [mode, times] = &words[..]
        && mode == "sweeps"
    {
        return sweeps(times.parse()?);
    }
    let work = Work(words.first().is_some_and(|mode| mode == "time"));
    #[cfg(not(floats))]
    robot!(work, robot, (link::LAST, link::PLACE), fixed);
    #[cfg(floats)]
    robot!(work, robot, (link::LAST, link::PLACE), floating);
    if !work.0 {
        more()?;
    }
    Ok(())
}
