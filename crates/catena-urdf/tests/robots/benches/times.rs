//! What functions of the shipped robots take, in nanoseconds, at random states, and what they say there: `benches/rivals/robots.py` times
//! them beside another library and compares the numbers.
//!
//! ```text
//! cargo bench -p catena-urdf-robots --bench times -- states ROBOT   # states and answers, a list of numbers a line
//! cargo bench -p catena-urdf-robots --bench times -- time ROBOT     # nanoseconds a call, a function a line
//! ```

#[macro_use]
#[path = "parts/states.rs"]
mod states;

use catena::system::{Dynamics, Rate};
use catena_urdf_robots::{arm7_local, cart_local, humanoid_local, quadruped_fixed, quadruped_local};
use states::{Noise, Outcome, STATES, State, Work, write};
use std::hint::black_box;

fn main() -> Outcome {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with("--")).collect();
    let [what, robot] = words.iter().map(String::as_str).collect::<Vec<_>>()[..] else {
        return Err("states ROBOT or time ROBOT".into());
    };
    let work = Work(what == "time");
    match robot {
        "arm7" => robot!(work, arm7_local, (arm7_local::joint::TOOL_ROLL, arm7_local::frame::FLANGE.place), fixed),
        "cart" => {
            robot!(work, cart_local, (cart_local::joint::RIGHT_GRIP, cart_local::frame::RIGHT_FINGER.place), fixed)
        }
        "quadruped, fixed" => robot!(
            work,
            quadruped_fixed,
            (quadruped_fixed::joint::RH_KFE, quadruped_fixed::frame::RH_SHANK.place),
            fixed
        ),
        "quadruped" => robot!(
            work,
            quadruped_local,
            (quadruped_local::joint::RH_KFE, quadruped_local::frame::RH_SHANK.place),
            floating
        ),
        "humanoid" => robot!(
            work,
            humanoid_local,
            (humanoid_local::joint::LEFT_GRIP, humanoid_local::frame::LEFT_FINGER.place),
            floating
        ),
        _ => return Err(robot.into()),
    }
    Ok(())
}
