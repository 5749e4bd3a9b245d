//! Steps allocate nothing.

use super::counting::allocations;
use catena::Error;
use catena::Lift;
use catena::loading::{LoadLaw, Loading, Unloaded};
use catena::planar::*;
use catena::scalar::{Jet, Scalar};
use catena::sensitivity::ThroughGains;
use catena::simulate::{Method, Stepper};
use catena::system::Element;
use catena::system::Root;
use catena::system::{Dynamics, Runs};
use catena::time::Sdirk4;

/// What resists the mass centre of each body.
#[derive(Clone, Copy)]
struct Drag<T> {
    resistance: T,
}

catena::lift!(Drag<T> { resistance });

impl<T: Scalar> LoadLaw<BodyMotion<T>> for Drag<T> {
    type Value = Wrench<T>;
    fn at(&self, _: T::Real, _: usize, body: &BodyMotion<T>) -> Wrench<T> {
        body.force_at(body.inertia.centre, (body.centre().velocity * -self.resistance).into())
    }
}

/// Allocations in ten steps by `advance`, with error and dense output, in ten by `step`, and in ten sweeps on their
/// own.
fn in_steps<R, C, L, M>(root: R, chain: C, loads: &L, method: M) -> Result<[usize; 3], Error>
where
    R: Root<Planar<f64>>,
    C: Element<Planar<f64>>,
    L: Loading<Planar<f64>>,
    M: for<'s> Method<&'s System<f64, R, C, Free>, L>,
    System<f64, R, C, Free>: Runs<L, Planar<f64>, R, C, Free> + Runs<Unloaded, Planar<f64>, R, C, Free>,
{
    let system = System::new(root, chain, Free)?.with_gravity(9.81);
    let angles: Vec<f64> = (0..system.bodies()).map(|k| 0.3 * k as f64).collect();
    let mut past = system.with_accelerations(system.at_rest(&angles)?, loads)?;
    let (mut next, mut between) = (past.clone(), past.clone());
    let mut stepper = system.stepper(method);
    let mut workspace = Dynamics::<L>::workspace(&system);
    let ten = |what: &mut dyn FnMut() -> Result<(), Error>| -> Result<usize, Error> {
        let (count, outcome) = allocations(|| (0..10).try_for_each(|_| what()));
        outcome.map(|()| count)
    };
    let by_advance = ten(&mut || {
        stepper.propose(&past, loads, 1e-12);
        stepper.advance(&past, loads, 1e-3, &mut next)?;
        stepper.error(&past, 1e-3, &next, 1e-6);
        stepper.interpolate(&past, loads, 1e-3, &next, 0.5, &mut between);
        core::mem::swap(&mut past, &mut next);
        Ok(())
    })?;
    let by_step = ten(&mut || {
        stepper.step(&past, loads, 1e-3, &mut next)?;
        core::mem::swap(&mut past, &mut next);
        Ok(())
    })?;
    assert!((past.time() - 0.02).abs() < 1e-12);
    let by_sweep = ten(&mut || system.accelerate(&mut past, loads, &mut workspace))?;
    Ok([by_advance, by_step, by_sweep])
}

macro_rules! no_scene_allocates {
    ($method:expr) => {{
        let rod = Rod::uniform(0.5, 1.0);
        let plate = RigidBody::new(1.0, 0.1, [0.2, 0.1], [0.5, 0.1]);
        let loads = Loads::none()
            .on_bodies(|time: f64, _, motion: &BodyMotion<f64>| motion.force_at([0.1, 0.2], [time, 1.0]))
            .in_joints(|_, _, motion: &JointMotion<f64>| -0.1 * motion.rate());
        let root = Pinned::<[f64; 2]>::origin();
        assert_eq!(in_steps(root, (rod, Pin, plate, Pin, rod), &Unloaded, $method)?, [0; 3], "tuple");
        assert_eq!(in_steps(root, (rod, Pin, plate, Pin, rod), &loads, $method)?, [0; 3], "tuple under loads");
        assert_eq!(in_steps(root, (rod, [(Pin, plate); 5]), &Unloaded, $method)?, [0; 3], "array");
        assert_eq!(in_steps(root, (rod, [(Pin, plate); 5]), &loads, $method)?, [0; 3], "array under loads");
        assert_eq!(in_steps(root, (rod, vec![(Pin, plate); 5]), &Unloaded, $method)?, [0; 3], "vector");
        assert_eq!(in_steps(root, (rod, vec![(Pin, plate); 5]), &loads, $method)?, [0; 3], "vector under loads");
        let hinge = ElasticHinge::rotary(20.0);
        assert_eq!(in_steps(root, (rod, vec![(hinge, plate); 5]), &loads, $method)?, [0; 3], "hinges under loads");
        assert_eq!(in_steps(Free, (rod, vec![(Pin, plate); 5]), &Unloaded, $method)?, [0; 3], "floating vector");
        let tree = (rod, vec![(Branch(vec![(hinge, rod); 2]), Pin, plate); 2]);
        assert_eq!(in_steps(root, tree, &loads, $method)?, [0; 3], "tree under loads");
    }};
}

#[test]
fn steps_of_every_rule_allocate_nothing() -> Result<(), Error> {
    no_scene_allocates!(Rk4);
    no_scene_allocates!(Dopri5);
    no_scene_allocates!(Dop853);
    no_scene_allocates!(Adams);
    no_scene_allocates!(Vcabm::new().up_to(3));
    no_scene_allocates!(GeneralizedAlpha::new(0.8));
    no_scene_allocates!(Sdirk4::new());
    no_scene_allocates!(MoreauJean);
    Ok(())
}

#[test]
fn the_choice_of_a_rule_allocates_nothing() -> Result<(), Error> {
    let (rod, hinge) = (Rod::uniform(0.5, 1.0), ElasticHinge::rotary(1e5));
    let plate = RigidBody::new(1.0, 0.1, [0.2, 0.1], [0.5, 0.1]);
    let root = Pinned::<[f64; 2]>::origin();
    assert_eq!(in_steps(root, (rod, vec![(hinge, plate); 5]), &Unloaded, Auto)?, [0; 3]);
    let soft = ElasticHinge::rotary(20.0);
    assert_eq!(in_steps(root, (rod, vec![(soft, plate); 5]), &Unloaded, AutoTaylor::<24>)?, [0; 3]);
    Ok(())
}

/// Of scenes without vectors: in others accelerations are copied.
#[test]
fn couplings_and_stiff_struts_allocate_nothing() -> Result<(), Error> {
    let (rod, plate) = (Rod::uniform(0.5, 1.0), RigidBody::new(1.0, 0.1, [0.2, 0.1], [0.5, 0.1]));
    let (root, joint) = (Pinned::<[f64; 2]>::origin(), Revolute::smooth());
    let chain = (rod, [(joint, plate); 4]);
    let couplings = Couplings::of(&System::new(root, chain, Free)?, [Coupling::new(2, 1), Coupling::new(4, 1)])?;
    assert_eq!(in_steps(root, chain, &couplings, Dop853)?, [0; 3]);
    assert_eq!(in_steps(root, chain, &couplings, Sdirk4::new())?, [0; 3]);
    let strut = Strut::between((0, [0.1, 0.2]), (3, [0.3, 0.0])).with_stiffness(1e4).with_damping(1.0).with_length(1.0);
    let struts = Struts::of([strut]).and(Loads::none().torques([0.1; 5])).stiff();
    assert_eq!(in_steps(root, chain, &struts, Sdirk4::new())?, [0; 3]);
    assert_eq!(in_steps(root, chain, &struts, GeneralizedAlpha::new(0.8))?, [0; 3]);
    let rubs = (rod, [(Coulomb::new(joint, 0.1), plate); 4], HardStops::between(joint, [-0.1, 0.1]), rod);
    assert_eq!(in_steps(root, rubs, &Unloaded, MoreauJean)?, [0; 3]);
    Ok(())
}

#[test]
fn steps_by_series_allocate_nothing() -> Result<(), Error> {
    let (rod, plate) = (Rod::uniform(0.5, 1.0), RigidBody::new(1.0, 0.1, [0.2, 0.1], [0.5, 0.1]));
    let (root, hinge) = (Pinned::<[f64; 2]>::origin(), ElasticHinge::rotary(20.0));
    assert_eq!(in_steps(root, (rod, [(Pin, plate); 5]), &Unloaded, Taylor::<12>)?, [0; 3], "array");
    let tree = (rod, vec![(Branch(vec![(hinge, rod); 2]), Pin, plate); 2]);
    assert_eq!(in_steps(root, tree, &Unloaded, Taylor::<12>)?, [0; 3], "tree");
    let loads = Loads::none().on_bodies_over_time(Drag { resistance: 0.1 }).torques([0.1; 6]);
    assert_eq!(in_steps(root, (rod, [(Pin, plate); 5]), &loads, Taylor::<12>)?, [0; 3], "under loads");
    Ok(())
}

#[test]
fn steps_with_derivatives_through_gains_allocate_nothing() -> Result<(), Error> {
    type Number = Jet<f64, 6>;
    let (rod, hinge) =
        (Rod::uniform(Number::of(0.5), Number::seed(1.0, 0)), ElasticHinge::rotary(Number::seed(20.0, 1)));
    let plate = RigidBody::new(1.0, 0.1, [0.2, 0.1], [0.5, 0.1]);
    let plate = plate.lift(&mut |x: f64| Number::of(x));
    let chain = (rod, vec![(hinge, plate); 5], Branch(vec![(hinge, rod); 2]), [(hinge, rod); 2]);
    let system = System::new(Pinned::origin(), chain, Free)?.with_gravity(Number::of(9.81));
    let loads = Loads::none().in_joints(|_, _, motion: &JointMotion<Number>| motion.rate().scale(-0.1));
    let start = system.with_seeds(system.at_rest(&[Number::of(0.2); 10])?, 0);
    let mut past = system.with_accelerations(start, &loads)?;
    let (mut next, mut between) = (past.clone(), past.clone());
    let mut stepper = system.stepper(ThroughGains(Dop853));
    let (count, outcome) = allocations(|| {
        (0..10).try_for_each(|_| {
            stepper.advance(&past, &loads, 1e-3, &mut next)?;
            stepper.error(&past, 1e-3, &next, 1e-6);
            stepper.interpolate(&past, &loads, 1e-3, &next, 0.5, &mut between);
            core::mem::swap(&mut past, &mut next);
            stepper.step(&past, &loads, 1e-3, &mut next)
        })
    });
    outcome?;
    assert_eq!(count, 0);
    Ok(())
}

/// A vector's scene far from the origin, where coordinates are large that are no angles.
#[test]
fn steps_far_away_allocate_nothing() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 1.0);
    let system = System::new(Free, (rod, vec![(Pin, rod); 5]), Free)?;
    let mut past = system.at_rest(&[0.1; 6])?;
    past.position_mut().0.0 = 1e6;
    let mut next = past.clone();
    let mut stepper = system.stepper(Rk4);
    let (count, outcome) = allocations(|| stepper.step(&past, &Unloaded, 1e-3, &mut next));
    outcome?;
    assert_eq!(count, 0);
    Ok(())
}
