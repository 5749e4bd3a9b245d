//! Chains between two ends against the dense system.

use super::chains::{DRIFT, End, Link, ON_LINE, between, held};
use catena::Error;
use catena::planar::*;
use catena_oracle::plane::{self as oracle, Coordinates};

/// The same scene for the oracle, and its state.
fn scene(links: &[Link], [root, tip]: [End; 2]) -> (oracle::Scene, oracle::State) {
    let axis = |angle: f64| [angle.cos(), angle.sin()];
    let mut scene = oracle::Scene::pinned(links.iter().map(|l| oracle::Body::rod(l.mass, l.length)).collect());
    scene.ground.angle = links[0].angle;
    let mut start = Coordinates::default();
    scene.joints[0] = match root {
        End::Pinned => oracle::Joint::Pin,
        End::Clamped => oracle::Joint::Weld,
        End::Guided(line) => {
            start = Coordinates::along(axis(line), ON_LINE[0], ON_LINE[1], 0.0);
            oracle::Joint::Slider { axis: axis(line), spring: [0.0; 3] }
        }
    };
    start.phi_rate = links[0].rate;
    let between = |pair: &[Link]| Coordinates::angle(pair[1].angle - pair[0].angle, pair[1].rate - pair[0].rate);
    let state = scene.place(&[&[start], &links.windows(2).map(between).collect::<Vec<_>>()[..]].concat());
    let [velocity, acceleration] = DRIFT;
    let angle = links[links.len() - 1].angle;
    let ground = oracle::Ground { velocity, acceleration, angle, ..oracle::Ground::default() };
    scene.tip = match tip {
        End::Pinned => oracle::Tip::pinned(ground),
        End::Clamped => oracle::Tip::clamped(ground),
        End::Guided(line) => oracle::Tip::guided(ground, axis(line)),
    };
    (scene, state)
}

/// The largest difference of accelerations, and of forces, as shares of the largest one.
fn differences(n: usize, ends: [End; 2]) -> Result<[f64; 2], Error> {
    let links = &held(n, ends)[..];
    let (dense, state) = scene(links, ends);
    let answer = dense.solve(&state, &[], &[]);
    let mut pairs = [vec![], vec![]];
    between!(ends, links, |scene, motion| {
        let (stations, bodies) = (scene.stations(&motion, &Unloaded).unwrap(), scene.body_motions(&motion).unwrap());
        for (k, body) in bodies.iter().enumerate() {
            let acceleration = body.inboard.acceleration;
            pairs[0].push((acceleration.linear.x, answer.acceleration[k][0]));
            pairs[0].push((acceleration.linear.y, answer.acceleration[k][1]));
            pairs[0].push((acceleration.angular, answer.angular_acceleration[k]));
            for (station, force, torque) in [
                (2 * k, answer.q_inboard[k], answer.m_inboard[k]),
                (2 * k + 1, answer.q_outboard[k], answer.m_outboard[k]),
            ] {
                let Some(Station { internal, .. }) = stations.get(station) else { continue };
                pairs[1].push((internal.force.x, force[0]));
                pairs[1].push((internal.force.y, force[1]));
                pairs[1].push((internal.torque, torque));
            }
        }
    });
    let largest = |pairs: &[(f64, f64)]| {
        let size = pairs.iter().fold(1.0_f64, |size, pair| size.max(pair.1.abs()));
        pairs.iter().fold(0.0_f64, |worst, (found, expected)| worst.max((found - expected).abs() / size))
    };
    Ok([largest(&pairs[0]), largest(&pairs[1])])
}

#[test]
fn chains_between_two_ends_agree_with_the_dense_system() -> Result<(), Error> {
    let ends = [End::Pinned, End::Clamped, End::Guided(0.0), End::Guided(0.7)];
    for root in ends {
        for tip in ends {
            // Clamps at both ends of three rods hold two angles in three ways.
            let fewest = if [root, tip] == [End::Clamped; 2] { 4 } else { 3 };
            let mut worst = [0.0_f64; 2];
            for n in [3, 4, 5, 8, 20, 60] {
                if n >= fewest {
                    let [accelerations, forces] = differences(n, [root, tip])?;
                    println!("{root:?} to {tip:?}, {n} rods: accelerations {accelerations:.1e}, forces {forces:.1e}");
                    worst = [worst[0].max(accelerations), worst[1].max(forces)];
                }
            }
            // Round-off, times the condition of Λ (up to some thousands).
            assert!(worst[0] < 1e-10 && worst[1] < 1e-10, "{root:?} to {tip:?}: {worst:?}");
        }
    }
    Ok(())
}
