//! What a step in real time takes: a quadruped that stands on its feet, its motors holding a stance, by the rule for that.
//!
//! ```text
//! cargo bench -p catena-robots --bench real_time
//! ```
//!
//! It prints the microseconds of a step of 2 ms, the least of some blocks of a thousand, and the height of the trunk. `benches/rivals/real_time.py`
//! has the same beside MuJoCo.

use catena::robot::*;
use catena_robots::quadruped::{
    self,
    frame::{LF_FOOT, LH_FOOT, RF_FOOT, RH_FOOT},
};
use std::time::Instant;

const CYCLE: f64 = 2e-3; // (s)
/// Angles at which it stands: hip, thigh and knee of each leg; the last knee is written the other way around.
const STANCE: [f64; 12] = [0.0, 0.7, -1.4, 0.0, 0.7, -1.4, 0.0, 0.7, -1.4, 0.0, -0.7, -1.4];
const SPRING: f64 = 300.0; // (N·m/rad)
const DAMPER: f64 = 6.0; // (N·m·s/rad)
/// Steps of a block, and blocks: one to come to rest, and those that are timed.
const BLOCK: usize = 1000;
const BLOCKS: usize = 20;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = quadruped::scene::<f64>()?;
    let points = [LF_FOOT, RF_FOOT, LH_FOOT, RH_FOOT].map(|foot| (foot.body.unwrap_or(usize::MAX), foot.place));
    let law = Contact::new(1e5, 2e-4).damped(1.0).rubbing(0.8, 1e-4);
    let ground = Contacts::of(points, Plane::level(0.0), law);
    let mut now = scene.motion();
    let list: Vec<f64> = [0.0, 0.0, 0.42, 1.0, 0.0, 0.0, 0.0].into_iter().chain(STANCE).collect();
    now.set_coordinates(&list)?;
    let (mut next, mut stepper, mut least) = (now, scene.stepper(MoreauJean), f64::INFINITY);
    let (mut q, mut v) = ([0.0; 19], [0.0; 18]);
    for block in 0..=BLOCKS {
        let started = Instant::now();
        for _ in 0..BLOCK {
            now.coordinates_into(&mut q)?;
            now.rates_into(&mut v)?;
            let torques = core::array::from_fn(|k| -SPRING * (q[7 + k] - STANCE[k]) - DAMPER * v[6 + k]);
            let loads = Loads::none().on_bodies_by(ground).efforts(quadruped::efforts(torques));
            stepper.step(&now, &loads, CYCLE, &mut next)?;
            core::mem::swap(&mut now, &mut next);
        }
        if block > 0 {
            least = least.min(1e6 * started.elapsed().as_secs_f64() / BLOCK as f64);
        }
    }
    now.coordinates_into(&mut q)?;
    println!("step {least:.3}\nheight {:.4}", q[2]);
    Ok(())
}
