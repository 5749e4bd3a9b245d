//! Motions that steppers recognise: equal numbers with other derivatives are other motions.

use catena::Error;
use catena::num_dual::Dual64;
use catena::planar::*;
use catena::simulate::Stepper;

#[test]
fn motions_with_other_derivatives_are_other_motions() -> Result<(), Error> {
    let of = Dual64::from_re;
    let (rod, hinge) = (Rod::uniform(of(1.0), of(1.0)), ElasticHinge::rotary(of(40.0)).damped(of(0.5)));
    let scene = System::new(Pinned::origin(), (rod, hinge, rod), Free)?.with_gravity(of(9.81));
    let start = scene.at_rest(&[Dual64::new(-1.0, 1.0), of(0.3)])?;
    let mut stepper = scene.stepper(GeneralizedAlpha::new(0.8));
    let (mut now, mut found, mut expected) = (start, start, start);
    stepper.step(&start, &Unloaded, 0.01, &mut now)?;
    // Where it ended, with derivatives by something else.
    let mut other = now;
    other.set_coordinates(&now.coordinates().iter().map(|x| Dual64::new(x.re, 0.7)).collect::<Vec<_>>())?;
    stepper.step(&other, &Unloaded, 0.01, &mut found)?;
    scene.stepper(GeneralizedAlpha::new(0.8)).step(&other, &Unloaded, 0.01, &mut expected)?;
    let parts = |numbers: [Vec<Dual64>; 2]| numbers.concat().iter().map(|x| [x.re, x.eps]).collect::<Vec<_>>();
    let [found, expected] = [found, expected].map(|motion| parts([motion.coordinates(), motion.rates()]));
    assert_eq!(found, expected);
    Ok(())
}
