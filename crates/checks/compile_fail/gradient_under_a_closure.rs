//! The numbers in a closure are hidden: a law under which costates go backward is a struct.
//@ the numbers in `
//@ cannot be replaced by others, with derivatives say
//@ closures cannot, for their numbers are hidden

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let pendulum = System::new(Pinned::origin(), (rod, Ball, rod), Free)?;
    let wind = |_: f64, _: usize, body: &BodyMotion<f64>| body.force_at([1.0, 0.0, 0.0], [0.3, 0.0, 0.0]);
    let _ = pendulum.backward(Rk4).under(*Loads::none().on_bodies(wind).bodies());
    Ok(())
}
