//! Links that begin with an arm, in arrays and vectors: against the same links written out.

use catena::{Error, planar, spatial};
use catena_oracle::near;

/// Accelerations of a scene that hangs from the origin, its joints at these angles (as many as it takes of them) and rates.
macro_rules! accelerations {
    ($space:ident, $chain:expr, $gravity:expr, $angles:expr, $rates:expr) => {{
        use $space::*;
        let scene = System::new(Pinned::origin(), $chain, Free)?.with_gravity($gravity);
        let (mut counted, mut found) = (vec![], vec![]);
        catena::system::Rate::visit(scene.motion().rate(), &mut |_: f64| counted.push(()));
        let motion = scene.at_rest(&$angles)?;
        let motion = scene.with_rates(motion, &$rates[..counted.len()])?;
        let motion = scene.with_accelerations(motion, &Unloaded)?;
        catena::system::Rate::visit(motion.acceleration(), &mut |x: f64| found.push(x));
        found
    }};
}

/// The same links as a tuple, an array and a vector.
macro_rules! same_in_all_forms {
    ($space:ident, $rod:expr, $link:expr, $gravity:expr, $angles:expr) => {{
        let (rod, link) = ($rod, $link);
        let rates: [f64; 24] = core::array::from_fn(|k| 0.3 + 0.2 * k as f64);
        let expected = accelerations!($space, (rod, link, link, link), $gravity, $angles, rates);
        let array = accelerations!($space, (rod, [link; 3]), $gravity, $angles, rates);
        let vector = accelerations!($space, (rod, vec![link; 3]), $gravity, $angles, rates);
        assert_eq!((array.len(), vector.len()), (expected.len(), expected.len()));
        for (expected, (array, vector)) in expected.iter().zip(array.iter().zip(&vector)) {
            near(*array, *expected, 1e-11 * expected.abs().max(1.0));
            near(*vector, *expected, 1e-11 * expected.abs().max(1.0));
        }
    }};
}

#[test]
fn an_arm_of_the_plane_turns_nothing_that_follows_it() -> Result<(), Error> {
    use planar::{Branch, ElasticHinge, Pin, Rod, Weld};
    let rod = Rod::uniform(0.7, 0.8);
    let (arm, angles) = (Branch((Pin, rod)), [-0.4, -1.5, 0.5, 0.9, 1.3, -2.0, 0.2]);
    same_in_all_forms!(planar, rod, (arm, ElasticHinge::rotary(5.0), rod), 9.81, angles);
    same_in_all_forms!(planar, rod, (arm, Weld::at(0.4), rod), 9.81, angles[..4]);
    // None before the hinge turn nothing either.
    let none = (Vec::<(Pin, Rod<f64>)>::new(), ElasticHinge::rotary(5.0), rod);
    let rates = [0.3, 0.5, 0.7];
    let expected = accelerations!(planar, (rod, none.clone(), none.clone()), 9.81, angles[..3], rates);
    let vector = accelerations!(planar, (rod, vec![none; 2]), 9.81, angles[..3], rates);
    for (expected, vector) in expected.iter().zip(&vector) {
        near(*vector, *expected, 1e-11 * expected.abs().max(1.0));
    }
    Ok(())
}

#[test]
fn an_arm_in_space_turns_nothing_that_follows_it() -> Result<(), Error> {
    use spatial::{Ball, Branch, Revolute, Rod};
    let rod = Rod::uniform(0.7, 0.05, 0.8);
    let link = (Branch((Ball, rod)), Revolute::about([0.3, 1.0, 0.2]), rod);
    let angles: [f64; 15] = core::array::from_fn(|k| (1.7 * k as f64).sin());
    same_in_all_forms!(spatial, rod, link, [0.0, -9.81, 0.0], angles);
    Ok(())
}
