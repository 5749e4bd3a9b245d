//! Beams that buckle: which of their equilibria a guess leads to.

use catena::{Error, planar, spatial};
use core::f64::consts::{FRAC_PI_2, TAU};

/// A column of 40 rods under 1.518 times the load at which it buckles, as the elastica has it: S. P. Timoshenko, J. M. Gere, Theory of Elastic
/// Stability, 2nd ed., table 2-4: the tip at 0.349 and 0.792 of its length.
#[test]
fn a_column_that_is_bent_by_hand_buckles() -> Result<(), Error> {
    use planar::*;
    const K: usize = 40;
    let (length, stiffness) = (1.5, 2.0);
    let load = 1.518 * stiffness * (FRAC_PI_2 / length).powi(2);
    let scene = System::new(Clamped::origin(), Beam::new(length, stiffness, 0.7).segments::<K>(), Free)?;
    let loads = Loads::none().on_bodies(move |_: f64, body: usize, motion: &BodyMotion<f64>| {
        motion.force_at([0.5 * length / K as f64, 0.0], [if body == K { -load } else { 0.0 }, 0.0])
    });
    let bent = |tip: f64| scene.at_rest(&core::array::from_fn::<_, K, _>(|k| tip * (k + 1) as f64 / K as f64));
    let rest = scene.equilibrium(bent(0.3)?, &loads)?;
    let tip = scene.stations(&rest, &loads)?.tip().frame.place;
    assert!((tip.x / length - 0.349).abs() < 2e-3 && (tip.y / length - 0.792).abs() < 2e-3, "{tip}");
    assert!(scene.modes(&rest, &loads)?.frequencies().all(|frequency| frequency > 0.0));
    // From next to where it is straight that is what is meant.
    let straight = scene.equilibrium(bent(2e-4)?, &loads)?;
    assert!(straight.coordinates().iter().all(|angle| angle.abs() < 1e-12));
    assert!(scene.modes(&straight, &loads)?.frequencies().any(|frequency| frequency < 0.0));
    Ok(())
}

/// A strip on edge that a weight at its tip bends first downward, where it would buckle sideways.
#[test]
fn a_strip_on_edge_falls_to_one_of_its_sides() -> Result<(), Error> {
    use spatial::*;
    const K: usize = 5;
    let strip = Beam::new(1.0, [5.0, 0.5], 0.3, 0.5, 1e-3).segments::<K>();
    let scene = System::new(Clamped::origin(), strip, Free)?;
    let under = |weight: f64| {
        Loads::none().on_bodies(move |_: f64, body: usize, motion: &BodyMotion<f64>| {
            motion.force_at([0.5 / K as f64, 0.0, 0.0], [0.0, 0.0, if body == K { -weight } else { 0.0 }])
        })
    };
    for (weight, buckles) in [(1.7, false), (2.0, true), (3.0, true)] {
        let rest = scene.equilibrium(scene.motion(), &under(weight))?;
        let tip = scene.stations(&rest, &under(weight))?.tip().frame.place;
        assert_eq!(tip.y.abs() > 0.1, buckles, "{tip}");
        assert!(scene.modes(&rest, &under(weight))?.frequencies().all(|frequency| frequency > 0.0));
    }
    Ok(())
}

/// A moment about an axis that does not turn has no potential in space: a beam that it bends is at rest as an arc, be that stable or not.
#[test]
fn a_couple_bends_a_beam_of_space_to_an_arc() -> Result<(), Error> {
    use spatial::*;
    const K: usize = 6;
    let (stiffness, turn) = (2.0, 0.35 * TAU);
    let beam = Beam::new(1.0, [stiffness; 2], 1.0, 0.5, 1e-3).segments::<K>();
    let scene = System::new(Clamped::origin(), beam, Free)?;
    let loads = Loads::none().on_bodies(move |_: f64, body: usize, motion: &BodyMotion<f64>| {
        let mut couple = motion.force_at([0.0; 3], [0.0; 3]);
        couple.torque.z = if body == K { turn * stiffness } else { 0.0 };
        couple
    });
    let rest = scene.equilibrium(scene.motion(), &loads)?;
    let tip = scene.stations(&rest, &loads)?.tip().frame.place;
    // A polygon whose sides turn by equal angles, the first and the last of half a length.
    let side = |k: usize| if k == 0 || k == K { 0.5 / K as f64 } else { 1.0 / K as f64 };
    let sides = |along: fn(f64) -> f64| (0..=K).map(|k| side(k) * along(k as f64 * turn / K as f64)).sum::<f64>();
    for (found, expected) in [(tip.x, sides(f64::cos)), (tip.y, sides(f64::sin)), (tip.z, 0.0)] {
        assert!((found - expected).abs() < 1e-12, "{found} {expected}");
    }
    Ok(())
}
