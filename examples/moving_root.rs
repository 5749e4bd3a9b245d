//! A load on a rope under a trolley that drives off, brakes and stands: a root that moves, events, and a trace to a file of CSV.
//!
//! ```text
//! cargo run --release --example moving_root
//! ```

mod common;

use catena::planar::*;
use catena::simulate::Trace;
use common::{BLUE, Drawn, ORANGE, line};
use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

/// How long the trolley drives (s), how far (m), and how long is looked at (s).
const DRIVES: f64 = 3.0;
const WAY: f64 = 4.0;
const END: f64 = 8.0;

/// The trolley's place, velocity and acceleration along x (m, s): 10 s³ − 15 s⁴ + 6 s⁵ of its way, at rest at both ends.
fn trolley(time: f64) -> [f64; 3] {
    let s = (time / DRIVES).min(1.0);
    let (place, rate) = (s * s * s * (10.0 - 15.0 * s + 6.0 * s * s), 30.0 * s * s * (1.0 - s) * (1.0 - s));
    let second = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s);
    [WAY * place, WAY * rate / DRIVES, WAY * second / (DRIVES * DRIVES)]
}

fn main() -> Result<(), Box<dyn Error>> {
    let ground = |time: f64| {
        let [x, v, a] = trolley(time);
        GroundMotion { place: [x, 0.0], velocity: [v, 0.0], acceleration: [a, 0.0] }
    };
    // A light rope of 2 m, 1 kg, and 50 kg at its end that reach half a metre further.
    let chain = (Rod::uniform(2.0, 1.0).named("rope"), Pin.named("hook"), Rod::uniform(0.5, 50.0).named("load"));
    let root = Pinned::on(Moving(ground)).named("trolley");
    let crane = System::new(root, chain, Free)?.with_gravity(9.81);
    let start = crane.at_rest(&[-90_f64.to_radians(); 2])?;

    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target"); // not there where builds go elsewhere
    std::fs::create_dir_all(&folder)?;
    let file = folder.join("moving_root.csv");
    let mut trace = Trace::new(BufWriter::new(File::create(&file)?));
    let (mut swings, mut upright) = (vec![], vec![]);
    let rope = crane.joint("trolley")?;
    crane
        .simulation(Dop853::tolerance(1e-9))
        .every(0.02)
        // The rope passes the vertical.
        .event(move |now| now.motion().coordinates_of::<1>(rope).map_or(f64::NAN, |[angle]| angle.cos()))
        .run(start, END, |now| {
            let lean = now.motion().coordinates_of::<1>(rope).map_or(f64::NAN, |[angle]| angle.to_degrees() + 90.0);
            if now.is_event() {
                upright.push((now.time(), now.stations().root().internal.force.y));
            } else {
                swings.push((now.time(), lean));
                trace.observe(now);
            }
        })?;
    trace.finish()?;

    println!("A load of 50 kg on a rope of 2 m; its trolley drives {WAY} m in {DRIVES} s\n");
    common::heads(&[
        ("vertical at (s)", 15),
        ("trolley (m)", 11),
        ("speed (m/s)", 11),
        ("force at the trolley (N)", 24),
    ]);
    for (time, force) in &upright {
        let [x, v, _] = trolley(*time);
        println!("  {time:15.3}  {x:11.3}  {v:11.3}  {force:24.1}");
    }
    println!("\nMotion: {}\nPicture: {}", file.display(), draw(&swings)?.display());
    Ok(())
}

/// How far the rope leans, and where the trolley is.
fn draw(swings: &[(f64, f64)]) -> Drawn<PathBuf> {
    common::picture("moving_root", (860, 520), |area| {
        let area =
            common::heading(area, "A load under a trolley", "50 kg on a rope of 2 m; the trolley drives 4 m in 3 s.")?;
        let (upper, lower) = area.split_vertically(common::pixels(150.0));
        let mut drive = common::chart(&upper, "Trolley (m)", "time (s)", 0.0..END, -0.3..4.3)?;
        common::curve(&mut drive, swings.iter().map(|(time, _)| (*time, trolley(*time)[0])), line(BLUE, 1.8))?;
        let range = common::range(swings.iter().map(|(_, lean)| *lean), 0.1);
        let mut lean = common::chart(&lower, "Lean of the rope (degrees)", "time (s)", 0.0..END, range)?;
        common::curve(&mut lean, swings.iter().copied(), line(ORANGE, 1.8))
    })
}
