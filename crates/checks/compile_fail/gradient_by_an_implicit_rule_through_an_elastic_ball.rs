//! The costate sweep knows rotary springs of space under explicit rules alone.
//@ no gradient of a run by an implicit rule goes backward through an `ElasticBall`
//@ explicit rules go backward through rotary springs

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let hinge = ElasticBall::rotary([1.0, 1.0, 1.0]);
    let chain = System::new(Pinned::origin(), (rod, hinge, rod), Free)?;
    let _ = chain.backward(Rk4);
    let _ = chain.backward(Sdirk4::new());
    Ok(())
}
