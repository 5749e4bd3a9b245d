//! A run by Taylor series of what slides: the rule says what it knows, and who tells the culprit.
//@ `Taylor<12>` makes no steps of
//@ Slider<
//@ names what it does not know

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Slider::along(0.2_f64), rod), Free)?;
    scene.simulate(scene.at_rest(&[0.0])?, Taylor::<12>::tolerance(1e-9), 1.0, |_| ())?;
    Ok(())
}
