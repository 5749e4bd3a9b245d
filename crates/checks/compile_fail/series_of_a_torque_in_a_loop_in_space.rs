//! No Taylor series of a torque in a ball that closes a loop is known: the rule says what it knows.
//@ `Taylor<12>` makes no steps of
//@ names what it does not know

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let arms = Network::new((Ball, rod), (Ball, rod, Ball, rod), Ball);
    let scene = System::new(Pinned::origin(), (rod, arms), Free)?;
    let loads = Loads::none().efforts([Effort([0.1; 3]); 5]);
    scene.simulation(Taylor::<12>::step(0.01)).loads(&loads).run(scene.motion(), 1.0, |_| ())?;
    Ok(())
}
