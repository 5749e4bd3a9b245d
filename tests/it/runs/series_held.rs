//! Taylor series of chains whose tips are held: runs, closures and what holds them, beside rules that know no series.

use catena::Error;
use catena::planar::*;

const G: f64 = 9.81;

/// By how much two lists are apart.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

/// Three unlike rods between pins.
macro_rules! bridge {
    () => {{
        let chain = (Rod::uniform(1.0, 1.0), Pin, Rod::uniform(0.7, 0.4), Pin, Rod::uniform(0.9, 0.6));
        let scene = System::new(Pinned::origin(), chain, Pinned::at(1.5, 0.2))?.with_gravity(G);
        let start = scene.assembled(scene.at_rest(&[-0.9, 0.1, 0.8])?, &Unloaded)?;
        (scene, start)
    }};
}

/// All bodies and joints that have series, with an arm, on a tip that is clamped.
macro_rules! clamped {
    () => {{
        let (rod, body) = (Rod::uniform(0.5, 0.5), RigidBody::new(0.8, 0.05, [0.2, 0.1], [0.4, -0.1]));
        let hinge = ElasticHinge::rotary(3.0).damped(0.1).resting_at(0.2);
        let arm = Branch((hinge, rod, Weld::at(0.4), body));
        let track = Slider::along(0.3).with(Spring::new(50.0).damped(0.5).resting_at(0.1));
        let chain = (body, arm, Pin, rod, track, PointMass::new(0.3, 0.2), hinge, body, Pin, rod);
        let scene = System::new(Pinned::origin(), chain, Clamped::at(1.2, 0.1, -0.4))?.with_gravity(G);
        let start = scene.assembled(scene.at_rest(&[0.3, -0.2, 0.5, 0.1, 0.7])?, &Unloaded)?;
        (scene, start)
    }};
}

/// A slider-crank whose piston keeps its angle.
macro_rules! crank {
    () => {{
        let chain = (
            Rod::uniform(0.4, 0.5),
            Pin,
            Rod::uniform(1.1, 0.8),
            Pin,
            RigidBody::new(0.6, 0.02, [0.0, 0.0], [0.0, 0.0]),
        );
        let scene = System::new(Pinned::origin(), chain, Guided::at(1.0, 0.1, 0.2))?.with_gravity(G);
        let start = scene.assembled(scene.at_rest(&[0.9, -0.2, 0.2])?, &Unloaded)?;
        (scene, start)
    }};
}

macro_rules! compare {
    ($name:literal, $scene:expr) => {{
        let (scene, start) = $scene;
        let series = scene.simulate(start, Taylor::<20>::tolerance(1e-13), 1.0, |_| ())?;
        let other = scene.simulate(start, Dop853::tolerance(1e-13), 1.0, |_| ())?;
        let (a, b) = (&series.motion, &other.motion);
        let (of_place, of_acceleration) =
            (apart(&a.coordinates(), &b.coordinates()), apart(&a.accelerations(), &b.accelerations()));
        let of_force = apart(a.multipliers(), b.multipliers());
        println!(
            "{}: {} steps for {}, apart by {of_place:.1e}, {of_acceleration:.1e}, {of_force:.1e}",
            $name, series.steps, other.steps
        );
        assert!(of_place < 1e-11 && of_acceleration < 1e-9 && of_force < 1e-9);
    }};
}

#[test]
fn held_chains_move_as_under_dop853() -> Result<(), Error> {
    compare!("bridge", bridge!());
    compare!("clamped", clamped!());
    compare!("crank", crank!());
    Ok(())
}
