//! The rule that chooses among rules: what it chooses, what that costs, and that runs go on as they were saved.

use catena::planar::*;
use catena::simulate::Chosen;
use std::error::Error;

#[test]
fn what_is_not_stiff_runs_by_one_rule() -> Result<(), Box<dyn Error>> {
    let rod = Rod::uniform(0.5, 0.5);
    let two = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let start = two.at_rest(&[0.0; 2])?;
    let (auto, alone) = (
        two.simulate(start, Auto::tolerance(1e-8), 2.0, |_| ())?,
        two.simulate(start, Dop853::tolerance(1e-8), 2.0, |_| ())?,
    );
    assert_eq!((auto.motion.coordinates(), auto.sweeps), (alone.motion.coordinates(), alone.sweeps));
    let rod = Rod::uniform(0.1, 0.1);
    let many = System::new(Pinned::origin(), (rod, [(Pin, rod); 9]), Free)?.with_gravity(9.81);
    let start = many.at_rest(&[0.0; 10])?;
    let (auto, alone) = (
        many.simulate(start, Auto::tolerance(1e-8), 0.5, |_| ())?,
        many.simulate(start, Vcabm::new().tolerance(1e-8), 0.5, |_| ())?,
    );
    assert_eq!((auto.motion.coordinates(), auto.sweeps), (alone.motion.coordinates(), alone.sweeps));
    Ok(())
}

/// Four rods on damped hinges of a stiffness (N·m/rad).
macro_rules! stiff {
    ($stiffness:expr) => {{
        let (rod, hinge) =
            (Rod::uniform(0.3, 0.3), ElasticHinge::rotary($stiffness).damped(0.02 * f64::sqrt($stiffness)));
        System::new(Pinned::origin(), (rod, [(hinge, rod); 3]), Free)?.with_gravity(9.81)
    }};
}

#[test]
fn what_is_stiff_takes_little_more_than_by_an_implicit_rule() -> Result<(), Box<dyn Error>> {
    let scene = stiff!(1e5);
    let start = scene.at_rest(&[-0.5; 4])?;
    let mut run = scene.simulation(Auto::tolerance(1e-5)).begin(start, 1.0, |_| ())?;
    assert_eq!(run.stepper().chosen(), Chosen::Dop853);
    run.until(0.7)?;
    assert_eq!(run.stepper().chosen(), Chosen::Sdirk4);
    let auto = run.finish()?;
    let alone = scene.simulate(start, Sdirk4::new().tolerance(1e-5), 1.0, |_| ())?;
    let finer = scene.simulate(start, Sdirk4::new().tolerance(1e-7), 1.0, |_| ())?;
    println!("{} sweeps, {} by Sdirk4", auto.sweeps, alone.sweeps);
    assert!(10 * auto.sweeps < 14 * alone.sweeps);
    for (a, b) in auto.motion.coordinates().iter().zip(finer.motion.coordinates()) {
        assert!((a - b).abs() < 1e-6, "{a} {b}");
    }
    Ok(())
}

#[test]
fn runs_that_are_saved_go_on_bit_by_bit() -> Result<(), Box<dyn Error>> {
    let scene = stiff!(1e5);
    let start = scene.at_rest(&[-0.5; 4])?;
    let simulation = || scene.simulation(Auto::tolerance(1e-5));
    for time in [0.002, 0.02, 0.3] {
        let mut run = simulation().begin(start, 0.6, |_| ())?;
        run.until(time)?;
        let saved = run.save();
        let whole = run.finish()?;
        let resumed = simulation().resume(saved, 0.6, |_| ())?.finish()?;
        assert_eq!((resumed.motion, resumed.sweeps), (whole.motion, whole.sweeps), "{time}");
    }
    Ok(())
}
