//! Steps of the paper's scheme allocate nothing, and a run holds little.
#![cfg(feature = "std")]

use super::counting::{count, held};
use catena::Error;
use catena::loading::Unloaded;
use catena::paper::*;
use catena::planar::{ElasticHinge, Free, Pin, Pinned, Rod, Spring, System};

#[test]
fn steps_allocate_nothing() -> Result<(), Error> {
    let rod = Rod::uniform(0.2, 0.3);
    let chain = (rod, Pin, rod, ElasticHinge::rotary(5.0).damped(0.1), rod);
    let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[-1.0, -0.5, -0.2])?;
    macro_rules! steps {
        ($scheme:expr) => {{
            let before = count();
            let mut run = $scheme.start(&scene, &start, &Unloaded, 0.01)?;
            assert!(count() > before, "the allocator counts");
            let before = count();
            run.run_to(1.0)?;
            assert_eq!(count(), before, "{:?}", $scheme);
        }};
    }
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8));
    steps!(scheme);
    steps!(scheme.linearized(At::Iterated));
    steps!(scheme.solved_by(Solver::Riccati));
    steps!(JointScheme::new(Multistep::BDF2));

    // With linear springs.
    let spring = Spring::new(50.0).damped(0.1);
    let hinge = ElasticHinge::rotary(5.0).with_linear(spring, spring).in_unbalanced_axes();
    let soft = System::new(Pinned::origin(), (rod, hinge, rod), Free)?.with_gravity(9.81);
    for solver in [Solver::Product, Solver::Riccati] {
        let mut run = scheme.solved_by(solver).start(&soft, &soft.at_rest(&[-1.0, -0.5])?, &Unloaded, 1e-3)?;
        let before = count();
        run.run_to(0.1)?;
        assert_eq!(count(), before, "{solver:?}");
    }

    // In space, and with a tip that is held.
    use catena::spatial;
    let rod = spatial::Rod::uniform(0.2, 0.01, 0.3);
    let chain = (rod, spatial::Ball, rod, spatial::ElasticBall::rotary([5.0; 3]).damped(0.1), rod);
    let tip = spatial::Pinned::at([0.5, 0.0, 0.1]);
    let scene = spatial::System::new(spatial::Pinned::origin(), chain, tip)?.with_gravity([0.0, -9.81, 0.0]);
    let start = scene.assembled(scene.at_rest(&[0.1, 0.2, -0.5, 0.0, -0.1, 0.3, 0.1, 0.2, 0.4])?, &Unloaded)?;
    for slots in [Slots::Angles, Slots::RotationVectors] {
        let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).solved_by(Solver::Riccati).turning_by(slots);
        let mut run = scheme.start(&scene, &start, &Unloaded, 0.005)?;
        let before = count();
        run.run_to(0.1)?;
        assert_eq!(count(), before, "{slots:?}");
    }
    Ok(())
}

/// Time stays proportional to the number of bodies where a chain fits in the caches, so what a body holds counts: some 124 numbers, of
/// which 28 are states, 24 relations, and most of the rest histories. The matrices of a body and a joint, 49 numbers each, come on top.
#[test]
fn a_run_by_the_transform_holds_little() -> Result<(), Error> {
    let n = 1000;
    let rod = Rod::uniform(1.0 / n as f64, 1.0 / n as f64);
    let chain = (rod, vec![(ElasticHinge::rotary(20.0), rod); n - 1]);
    let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
    let start = scene.at_rest(&vec![-1.0; n])?;
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).solved_by(Solver::Riccati);
    let held_by = |scheme: Scheme<GeneralizedAlpha>| {
        let before = held();
        let mut run = scheme.start(&scene, &start, &Unloaded, 1e-3)?;
        run.run_to(0.01)?;
        Ok::<_, Error>((held() - before) / n)
    };
    let (lean, whole) = (held_by(scheme)?, held_by(scheme.keeping_matrices())?);
    println!("{lean} bytes a body, {whole} with matrices");
    assert!(lean < 8 * 130 && whole > lean + 2 * 8 * 49);
    Ok(())
}
