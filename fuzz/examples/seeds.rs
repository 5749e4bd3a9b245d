//! Writes the seeds of the target `data` into its corpus: each value in both formats, of which bytes alone never come near.

#[path = "../scenes.rs"]
mod scenes;

use catena::planar::*;
use catena::spatial;
use scenes::{ByAdams, ByVcabm, InSpace, in_plane};
use serde::Serialize;
use std::error::Error;
use std::{fs, path::Path};

fn seed(name: &str, value: &impl Serialize) -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus/data");
    fs::create_dir_all(&folder)?;
    let (text, bytes) = (serde_json::to_vec(value)?, postcard::to_allocvec(value)?);
    println!("{name}: {} bytes as JSON, {} in postcard", text.len(), bytes.len());
    fs::write(folder.join(format!("{name}.json")), text)?;
    fs::write(folder.join(format!("{name}.postcard")), bytes)?;
    Ok(())
}

fn in_space() -> Result<InSpace, catena::Error> {
    let rod = spatial::Rod::uniform(1.0, 0.1, 1.0);
    let tensor = [[0.2, 0.0, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.4]];
    let body = spatial::RigidBody::new(1.0, tensor, [0.1; 3], [0.5; 3]);
    let turned = spatial::Rotation::from_angles([0.1, 0.2, 0.3]);
    let arm = (rod, spatial::Ball, body, spatial::Revolute::about([1.0, 2.0, 3.0]), rod);
    let root = spatial::Clamped::on([0.0; 3], turned);
    Ok(spatial::System::new(root, (spatial::Weld::at(turned), arm), spatial::Free)?.with_gravity([0.0, -9.81, 0.0]))
}

fn main() -> Result<(), Box<dyn Error>> {
    let scene = in_plane(2)?;
    let start = || scene.at_rest(&[0.1, -0.3, 0.4]);
    let mut adams = scene.simulation(Adams::step(0.01)).every(0.1).begin(start()?, 2.0, |_| ())?;
    let mut vcabm = scene.simulation(Vcabm::new().tolerance(1e-6)).every(0.1).begin(start()?, 2.0, |_| ())?;
    // Before memories are full, and after.
    for (name, time) in [("early", 0.02), ("late", 1.0)] {
        adams.until(time)?;
        vcabm.until(time)?;
        let (adams, vcabm): (ByAdams, ByVcabm) = (adams.save(), vcabm.save());
        seed(&format!("adams_{name}"), &adams)?;
        seed(&format!("vcabm_{name}"), &vcabm)?;
    }
    seed("plane", &scene)?;
    seed("rod", &in_plane(0)?)?;
    seed("space", &in_space()?)
}
