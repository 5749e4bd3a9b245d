//! Ropes and cables of many links between two points, from guesses far off.

use catena::Error;

/// Each link lies along the force that it carries.
#[test]
fn a_held_rope_with_a_payload_is_found_from_a_bent_guess() -> Result<(), Error> {
    use catena::planar::*;
    let (n, loaded) = (100, 59);
    let length = 1.5 / n as f64;
    let link = Rod::uniform(length, 0.4 * length);
    let rope = System::new(Pinned::origin(), (link, vec![(Pin, link); n - 1]), Pinned::at(1.0, 0.0))?;
    let rope = rope.with_gravity(9.81);
    let [right, up] = [3.0, -5.0]; // (N), where the rope weighs 5.9 N
    let payload = Loads::none().on_bodies(move |_, body, motion: &BodyMotion<f64>| {
        if body == loaded { motion.force_at([length, 0.0], [right, up]) } else { Wrench::default() }
    });
    let guess: Vec<f64> = (0..n).map(|k| if k < n / 2 { -0.8 } else { 0.9 }).collect();
    let rest = rope.equilibrium(rope.at_rest(&guess)?, &payload)?;
    // The force at the middle of each link, from that of the root.
    let held = rope.stations(&rest, &payload)?.root().internal.force;
    for (k, angle) in rope.angles(&rest)?.iter().enumerate() {
        let beyond = if k > loaded { [right, up] } else { [0.0; 2] };
        let weight = (k as f64 + 0.5) * 0.4 * length * 9.81;
        let [x, y] = [held.x + beyond[0], held.y - weight + beyond[1]];
        assert!((angle.sin() * x - angle.cos() * y).abs() < 1e-11 * x.hypot(y), "link {k}");
    }
    Ok(())
}

/// A cable in space whose links stretch, pressed together between its ends where it begins: they bear half of its weight each when it hangs.
#[test]
fn a_cable_that_stretches_hangs() -> Result<(), Error> {
    use catena::spatial::*;
    for n in [10, 20] {
        let length = 1.5 / n as f64;
        let half = Rod::uniform(0.5 * length, 0.005, 0.2 * length);
        let stretch = Prismatic::along([1.0, 0.0, 0.0]).with(Spring::new(1e5));
        let links = vec![(Ball, half, stretch, half); n - 1];
        let cable = System::new(Pinned::origin(), (half, stretch, half, links), Pinned::at([1.0, 0.0, 0.0]))?;
        let cable = cable.with_gravity([0.0, 0.0, -9.81]);
        let rest = cable.equilibrium(cable.assembled(cable.motion(), &Unloaded)?, &Unloaded)?;
        let [along, across, up] = rest.multipliers()[..] else { unreachable!() };
        println!("{n} links: {along} {across} {up}");
        assert!((up - 0.5 * 0.6 * 9.81).abs() < 1e-10 && across.abs() < 1e-10, "{up} {across}");
        assert!(along.abs() < 2.0, "it hangs through: {along}");
    }
    Ok(())
}
