//! Numbers of closures are hidden: no gradient goes backward through a joint that one drives.
//@ the numbers in
//@ cannot be replaced by others
//@ closures cannot, for their numbers are hidden

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let crank = Driven::new(Revolute::smooth(), |time: f64| [3.0 * time, 3.0, 0.0]);
    let chain = System::new(Clamped::origin(), (crank, Rod::uniform(1.0, 1.0)), Free)?;
    let _ = chain.backward(Rk4);
    Ok(())
}
