//! Gradients of runs allocate nothing.

use crate::counting::allocations;
use catena::Error;
use catena::planar::*;
use catena::scalar::Jet;

#[test]
fn gradients_allocate_nothing() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 1.0);
    let plate = RigidBody::new(1.0, 0.1, [0.2, 0.1], [0.5, 0.1]);
    let system = System::new(Pinned::origin(), (rod, Branch((Pin, plate)), [(Pin, rod); 3]), Free)?.with_gravity(9.81);
    let start = system.at_rest(&[-1.0, -0.5, 0.0, 0.5, 1.0])?;
    let (mut states, torques, mut by_torques) = ([start; 21], [0.1; 100], [0.0; 100]);
    let mut backward = system.backward(Dop853);
    let number = |x| Jet::<f64, 2>::of(x);
    let lifted = system.lift(number).with_gravity(Jet::seed(9.81, 0));
    let (count, outcome) = allocations(|| {
        backward.run(&start, 0.01, 20, &torques, &mut states)?;
        let end = |step: usize, _: &_, by: &mut catena::sensitivity::Costate<_>| match step {
            20 => by.add(&[1.0; 5], &[0.0; 5]),
            _ => Ok(()),
        };
        let gradient = backward.gradient(&torques, &states, &mut by_torques, end)?;
        gradient.along(&lifted)
    });
    let [by_gravity, by_nothing] = outcome?;
    assert!(count == 0 && by_gravity != 0.0 && by_nothing == 0.0, "{count} allocations, {by_gravity}, {by_nothing}");
    assert!(by_torques.iter().all(|x| *x != 0.0));
    Ok(())
}
