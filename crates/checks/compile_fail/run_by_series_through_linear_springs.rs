//! A run by Taylor series through linear springs: the rule says what it knows, and who tells the culprit.
//@ `Taylor<12>` makes no steps of
//@ ElasticHinge<
//@ names what it does not know

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let mount = ElasticHinge::rotary(1.0).with_linear(Spring::new(1e4), Spring::new(1e4));
    let scene = System::new(Pinned::origin(), (rod, mount, rod), Free)?;
    scene.simulate(scene.at_rest(&[0.0; 2])?, Taylor::<12>::tolerance(1e-9), 1.0, |_| ())?;
    Ok(())
}
