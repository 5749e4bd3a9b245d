//! No Taylor series of what slides is known.
//@ `Slider<f64>` takes no walk
//@ knows no series of its motion

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Slider::along(0.2_f64), rod), Free)?;
    Taylor::<12>::knows(&scene);
    Ok(())
}
