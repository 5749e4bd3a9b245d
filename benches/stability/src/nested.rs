//! Loops within loops, one to eight deep: each network's first arm is the network before and one rod more.

use crate::table::Table;
use catena::loading::Unloaded;
use catena::planar::*;
use catena::system::{Element, Runs};

/// Where network `k` ends, and where the second arm's pin is (m).
fn end(k: usize) -> [f64; 2] {
    let k = k as f64;
    [0.3 + 0.25 * k, -0.2 + 0.15 * (1.3 * k).sin()]
}
fn side(k: usize) -> [f64; 2] {
    let [x, y] = end(k);
    [0.5 * x + 0.1, 0.5 * y - 0.3 - 0.1 * k as f64]
}

fn between([a, b]: [f64; 2], [c, d]: [f64; 2]) -> Rod<f64> {
    let length = (c - a).hypot(d - b);
    Rod::uniform(length, length) // 1 kg/m
}
fn angle([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    (d - b).atan2(c - a)
}

/// The angles of all bodies of `depth` networks, in the order of the chain.
fn angles(depth: usize) -> Vec<f64> {
    let foot = [0.2, 0.0];
    let mut list = vec![0.0];
    list.extend([angle(foot, end(0)), angle(end(0), end(1))]);
    for k in 1..=depth {
        if k > 1 {
            list.push(angle(end(k - 1), end(k)));
        }
        list.extend([angle(foot, side(k)), angle(side(k), end(k))]);
    }
    list
}

fn measure<C>(depth: usize, chain: C) -> Result<(f64, String), String>
where
    C: Element<Planar<f64>>,
    System<f64, Pinned<[f64; 2]>, C, Free>: Runs<Unloaded, Planar<f64>, Pinned<[f64; 2]>, C, Free>,
{
    let say = |error: catena::Error| error.to_string();
    let scene = System::new(Pinned::origin(), chain, Free).map_err(say)?.with_gravity(9.81);
    let start = scene.assembled(scene.at_rest(&angles(depth)).map_err(say)?, &Unloaded).map_err(say)?;
    let before = scene.budget(&start).map_err(say)?;
    let mut most = 0.0_f64; // kinetic energy
    let run = scene
        .simulation(Dop853::tolerance(1e-11))
        .run(start, 0.5, |now| most = most.max(now.budget().kinetic))
        .map_err(|stopped| say(stopped.error))?;
    let after = scene.budget(&run.motion).map_err(say)?;
    let closed = scene.assembled(run.motion.clone(), &Unloaded).map_err(say)?;
    let moved =
        closed.coordinates().iter().zip(run.motion.coordinates()).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
    let drift = (after.energy() - before.energy()).abs() / most;
    let note = format!("closure moves by {moved:.0e}; {} steps", run.steps);
    if drift.is_finite() { Ok((drift.max(moved), note)) } else { Err("not finite, and no error returned".to_owned()) }
}

/// Networks of a depth, as types.
macro_rules! networks {
    (1) => {{
        let foot = [0.2, 0.0];
        let main = (Pin, between(foot, end(0)), Pin, between(end(0), end(1)));
        Network::new(main, (Pin, between(foot, side(1)), Pin, between(side(1), end(1))), Pin)
    }};
    ($k:literal over $($inner:tt)+) => {{
        let foot = [0.2, 0.0];
        let main = (networks!($($inner)+), Pin, between(end($k - 1), end($k)));
        Network::new(main, (Pin, between(foot, side($k)), Pin, between(side($k), end($k))), Pin)
    }};
}

pub fn run(table: &mut Table, quick: bool) {
    let stem = || between([0.0, 0.0], [0.2, 0.0]);
    let mut add = |depth: usize, measure: &dyn Fn() -> Result<(f64, String), String>| {
        crate::progress(&format!("nested loops, {depth} deep"));
        let outcome = measure();
        let note = outcome.as_ref().map_or_else(Clone::clone, |(_, note)| note.clone());
        let outcome = outcome.map(|(error, _)| error);
        table.add("nested", "networks", "depth", depth as f64, "DOP853, 1e-11", "f64", outcome);
        table.note(note);
    };
    add(1, &|| measure(1, (stem(), networks!(1))));
    add(2, &|| measure(2, (stem(), networks!(2 over 1))));
    if quick {
        return;
    }
    add(3, &|| measure(3, (stem(), networks!(3 over 2 over 1))));
    add(4, &|| measure(4, (stem(), networks!(4 over 3 over 2 over 1))));
    add(5, &|| measure(5, (stem(), networks!(5 over 4 over 3 over 2 over 1))));
    add(6, &|| measure(6, (stem(), networks!(6 over 5 over 4 over 3 over 2 over 1))));
    add(7, &|| measure(7, (stem(), networks!(7 over 6 over 5 over 4 over 3 over 2 over 1))));
    add(8, &|| measure(8, (stem(), networks!(8 over 7 over 6 over 5 over 4 over 3 over 2 over 1))));
}
