//! Draws all files of runs anew.

use catena_precision::Scene;
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    for entry in std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../results/precision"))? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "csv") {
            Scene::redraw(&path)?;
        }
    }
    Ok(())
}
