//! Rules for stiff hinges: their orders, at any stiffness, in positions and in forces.

mod numbers;
mod steps;

use catena::Error;
use catena::loading::{Loading, Unloaded};
use catena::planar::*;
use catena::simulate::Method;
use catena::system::Runs;
use catena::time::{Rule, Sdirk4};
use catena_oracle::{has_order, near};
use core::f64::consts::FRAC_PI_2;

/// A first angle (rad) and a pivot force (N).
type Reading = (f64, [f64; 2]);

/// Distance of two readings, in angle and in force.
fn distance(a: Reading, b: Reading) -> [f64; 2] {
    [(a.0 - b.0).abs(), (a.1[0] - b.1[0]).hypot(a.1[1] - b.1[1])]
}

/// What a scene that starts at rest reads at the end of a run.
fn reading<C, L, M>(scene: &Scene<C>, loads: &L, angles: &[f64], rule: Rule<M, f64>, end: f64) -> Result<Reading, Error>
where
    C: catena::system::Element<Planar<f64>>,
    L: Loading<Planar<f64>>,
    M: for<'s> Method<&'s Scene<C>, L>,
    Scene<C>: Runs<L, Planar<f64>, Pinned<[f64; 2]>, C, Free>,
{
    let motion = scene.simulation(rule).loads(loads).run(scene.at_rest(angles)?, end, |_| ())?.motion;
    let force = scene.stations(&motion, loads).unwrap().root().internal.force;
    Ok((*scene.angles(&motion).unwrap().get(0).unwrap_or(&f64::NAN), force.into()))
}

type Scene<C> = System<f64, Pinned<[f64; 2]>, C, Free>;

/// A torque that comes and goes smoothly at the root (N·m): nothing vibrates that it does not shake.
fn pulse(time: f64, joint: usize, _: &JointMotion<f64>) -> f64 {
    if joint == 0 { 2.0 * (-((time - 0.4) / 0.07).powi(2)).exp() } else { 0.0 }
}

/// Errors in angle and in force, for each step.
fn errors(
    steps: &[f64],
    expected: Reading,
    run: impl Fn(f64) -> Result<Reading, Error>,
) -> Result<[Vec<(f64, f64)>; 2], Error> {
    let [mut angles, mut forces] = [vec![], vec![]];
    for &h in steps {
        let [angle, force] = distance(run(h)?, expected);
        println!("    step {h:.5}: angle {angle:.1e} rad, force {force:.1e} N");
        angles.push((h, angle));
        forces.push((h, force));
    }
    Ok([angles, forces])
}

/// A metre of flexible rod (1 kg, EI = 1 N·m²) in twenty pieces, shaken out of rest.
#[test]
fn sdirk4_has_order_four_on_a_flexible_chain() -> Result<(), Error> {
    let rod = Rod::uniform(0.05, 0.05);
    let scene = System::new(Pinned::origin(), (rod, [(ElasticHinge::rotary(20.0), rod); 19]), Free)?;
    let (scene, loads, hanging) = (scene.with_gravity(9.81), Loads::none().in_joints(pulse), [-FRAC_PI_2; 20]);
    let expected = reading(&scene, &loads, &hanging, Dop853::tolerance(1e-13), 0.8)?;
    let run = |h| reading(&scene, &loads, &hanging, Sdirk4::new().step(h), 0.8);
    let [angles, forces] = errors(&[0.005, 0.0025, 0.00125, 0.000625], expected, run)?;
    has_order("SDIRK4, angle", 4.0, 1e-12, &angles);
    has_order("SDIRK4, force", 4.0, 1e-10, &forces);
    Ok(())
}

/// One sweep a stage has order 2, two have order 3. The torque at the root pin, which should be none, is what the balance misses.
#[test]
fn each_sweep_of_a_stage_adds_an_order_up_to_four() -> Result<(), Error> {
    let (plate, rod) = (RigidBody::new(0.9_f64, 0.05, [0.3, 0.1], [0.7, -0.2]), Rod::new(0.8, 1.3, 0.3, 0.07));
    let damped = ElasticHinge::rotary(7.0).damped(0.3).resting_at(0.2);
    let chain = (plate, damped, rod, ElasticHinge::rotary(4.0), (plate, Weld::at(-0.7), rod), Pin, rod);
    let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
    let start = || scene.with_rates(scene.at_rest(&[-0.4, -0.2, -0.2, -0.5])?, &[1.0, 0.3, -0.2, 1.0]);
    let exact = scene.simulate(start()?, Dop853::tolerance(1e-13), 0.5, |_| ())?.motion;
    for (sweeps, order) in [(1, 2.0), (2, 3.0), (3, 4.0), (4, 4.0)] {
        let [mut rates, mut forces, mut torques]: [Vec<(f64, f64)>; 3] = Default::default();
        for h in [0.01, 0.005, 0.0025, 0.00125] {
            let rule = Sdirk4::new().with_sweeps(sweeps).step(h);
            let run = scene.simulate(start()?, rule, 0.5, |_| ())?;
            assert_eq!(run.sweeps, (5 * sweeps + 1) * run.steps);
            let internal = |motion: &_| scene.stations(motion, &Unloaded).unwrap().root().internal;
            let (found, expected) = (internal(&run.motion), internal(&exact));
            rates.push((h, (run.motion.rate().0 - exact.rate().0).abs()));
            forces.push((h, (found.force - expected.force).norm()));
            torques.push((h, found.torque.abs()));
        }
        has_order(&format!("{sweeps} sweeps, rate"), order, 1e-12, &rates);
        has_order(&format!("{sweeps} sweeps, force"), order, 1e-11, &forces);
        if sweeps < 4 {
            has_order(&format!("{sweeps} sweeps, torque at the pin"), order, 1e-13, &torques);
        }
    }
    Ok(())
}

/// A four-bar with a spring between crank and coupler: the tip is put back after every step, and nothing of the order is lost.
#[test]
fn sdirk4_holds_a_tip_with_order_four() -> Result<(), Error> {
    let rod = |length| Rod::uniform(length, length);
    let hinge = ElasticHinge::rotary(5.0).damped(0.02);
    let scene = System::new(Pinned::origin(), (rod(0.5), hinge, rod(1.2), Pin, rod(0.9)), Pinned::at(1.0, 0.0))?;
    let scene = scene.with_gravity(9.81);
    let start = || scene.at_rest(&[core::f64::consts::FRAC_PI_3, 0.321105014831, -2.017338833372]);
    let read = |rule| {
        let motion = scene.simulate(start()?, rule, 0.3, |_| ())?.motion;
        let miss: [f64; 2] = scene.stations(&motion, &Unloaded).unwrap().tip().frame.place.into();
        Ok::<_, Error>(((*scene.angles(&motion).unwrap().get(0).unwrap_or(&f64::NAN), *motion.multipliers()), miss))
    };
    let exact = scene.simulate(start()?, Dop853::tolerance(1e-13), 0.3, |_| ())?.motion;
    let expected = (*scene.angles(&exact)?.get(0).unwrap_or(&f64::NAN), *exact.multipliers());
    let run = |h| {
        let (found, [x, y]) = read(Sdirk4::new().step(h))?;
        assert!((x - 1.0).hypot(y) < 1e-14, "the tip is off by {:.1e} m", (x - 1.0).hypot(y)); // rounding of three rods
        Ok(found)
    };
    let [angles, forces] = errors(&[0.01, 0.005, 0.0025, 0.00125], expected, run)?;
    // The start is given to twelve digits; how that is mended differs between the two rules.
    has_order("SDIRK4, crank", 4.0, 1e-12, &angles);
    has_order("SDIRK4, closure force", 4.0, 1e-11, &forces);
    Ok(())
}

/// Four rods with hinges of a stiffness k (N·m/rad) and a damping of so many √k (N·m·s/rad).
type Rods = (Rod<f64>, [(ElasticHinge<Spring<f64, f64>>, Rod<f64>); 3]);
fn rods(stiffness: f64, damping: f64) -> Result<Scene<Rods>, Error> {
    let rod = Rod::uniform(0.3, 0.3);
    let hinge = ElasticHinge::rotary(stiffness).damped(damping * stiffness.sqrt());
    Ok(System::new(Pinned::origin(), (rod, [(hinge, rod); 3]), Free)?.with_gravity(9.81))
}

/// The same rods welded together, at rest at first at an angle: the limit of high stiffness.
fn welded(angle: f64) -> Result<Reading, Error> {
    let rod = Rod::uniform(0.3, 0.3);
    let scene = System::new(Pinned::origin(), (rod, [(Weld::at(0.0), rod); 3]), Free)?.with_gravity(9.81);
    if angle == -FRAC_PI_2 {
        reading(&scene, &Loads::none().in_joints(pulse), &[angle], Dop853::tolerance(1e-13), 1.0)
    } else {
        reading(&scene, &Unloaded, &[angle], Dop853::tolerance(1e-13), 1.0)
    }
}

const STEPS: [f64; 4] = [0.01, 0.005, 0.0025, 0.00125];
/// Steps that resolve the vibration of hinges of 100 N·m/rad (up to 350 rad/s).
const FINE: [f64; 4] = [0.0025, 0.00125, 0.000625, 0.0003125];

/// Out of equilibrium by a smooth torque: nothing excites vibration faster than steps resolve.
#[test]
fn every_rule_converges_in_forces_at_any_stiffness_from_a_smooth_start() -> Result<(), Error> {
    let (loads, hanging) = (Loads::none().in_joints(pulse), [-FRAC_PI_2; 4]);
    for stiffness in [1.0, 1e2, 1e4, 1e6, 1e8, 1e10] {
        let scene = rods(stiffness, 0.02)?;
        println!("stiffness {stiffness:e}");
        // From 1e8 on the explicit rule drowns in rounding, and the weld is as near as 0.5/k.
        let expected = if stiffness < 1e7 {
            reading(&scene, &loads, &hanging, Dop853::tolerance(1e-13), 1.0)?
        } else {
            welded(-FRAC_PI_2)?
        };
        for (name, rule) in [("alpha", GeneralizedAlpha::new(0.8)), ("trapezoidal", GeneralizedAlpha::trapezoidal())] {
            let steps = if stiffness == 1e2 { &FINE } else { &STEPS };
            let [angles, forces] = errors(steps, expected, |h| reading(&scene, &loads, &hanging, rule.step(h), 1.0))?;
            has_order(&format!("{name}, angle"), 2.0, 1e-10, &angles);
            has_order(&format!("{name}, force"), 2.0, 1e-8, &forces);
        }
        let run = |h| reading(&scene, &loads, &hanging, Sdirk4::new().step(h), 1.0);
        let [angles, forces] = errors(&STEPS, expected, run)?;
        if stiffness < 1e3 {
            has_order("SDIRK4, angle", 4.0, 1e-12, &angles);
            has_order("SDIRK4, force", 4.0, 1e-10, &forces);
        } else {
            // What is left is the rounding of both (strains of 1e-16 times stiffness), or the distance to the weld.
            assert!(angles.iter().all(|(_, error)| *error < 1e-9) && forces.iter().all(|(_, error)| *error < 1e-8));
        }
    }
    Ok(())
}

/// Released without strain where gravity asks for some: every hinge vibrates a little, 1/k rad, with torques of order one, and
/// comes to rest by its damper (c = 0.02 √k).
#[test]
fn vibration_that_is_damped_leaves_forces_of_dissipative_rules_alone() -> Result<(), Error> {
    let (limit, slanted) = (welded(-0.5)?, [-0.5; 4]);
    for stiffness in [1e6, 1e8, 1e10] {
        let scene = rods(stiffness, 0.02)?;
        println!("stiffness {stiffness:e}");
        let run = |h| reading(&scene, &Unloaded, &slanted, GeneralizedAlpha::new(0.8).step(h), 1.0);
        let [angles, forces] = errors(&STEPS, limit, run)?;
        if stiffness > 1e7 {
            has_order("generalised-alpha, angle", 2.0, 5e-9, &angles); // the distance to the weld at 1e8
        }
        has_order("generalised-alpha, force", 2.0, 5e-7, &forces); // the same at 1e6
        let run = |h| reading(&scene, &Unloaded, &slanted, Sdirk4::new().step(h), 1.0);
        let [angles, forces] = errors(&STEPS, limit, run)?;
        let weld = 1.0 / stiffness + 1e-8;
        assert!(angles.iter().chain(&forces).all(|(_, error)| *error < weld));

        // The trapezoidal rule damps by dampers only, and those of unresolved vibration hardly act: its angles have order 2, and
        // its forces are wrong by as much as there is.
        let run = |h| reading(&scene, &Unloaded, &slanted, GeneralizedAlpha::trapezoidal().step(h), 1.0);
        let [angles, forces] = errors(&STEPS, limit, run)?;
        if stiffness > 1e7 {
            has_order("trapezoidal, angle", 2.0, 5e-9, &angles);
            assert!(forces.iter().all(|(_, error)| *error > 0.1));
        }
    }
    Ok(())
}

/// The same without dampers, at a stiffness whose vibration (up to 3500 rad/s) takes a few steps or a few to the step: it is
/// part of the true motion, and no rule follows it.
#[test]
fn undamped_vibration_that_steps_do_not_resolve_spoils_forces_of_every_rule() -> Result<(), Error> {
    let (scene, slanted) = (rods(1e4, 0.0)?, [-0.5; 4]);
    let expected = reading(&scene, &Unloaded, &slanted, Dop853::tolerance(1e-12), 1.0)?;
    let alpha =
        errors(&STEPS, expected, |h| reading(&scene, &Unloaded, &slanted, GeneralizedAlpha::new(0.8).step(h), 1.0))?;
    let sdirk = errors(&STEPS, expected, |h| reading(&scene, &Unloaded, &slanted, Sdirk4::new().step(h), 1.0))?;
    let trapezoidal = errors(&STEPS, expected, |h| {
        reading(&scene, &Unloaded, &slanted, GeneralizedAlpha::trapezoidal().step(h), 1.0)
    })?;
    for [angles, forces] in [alpha, sdirk, trapezoidal] {
        assert!(angles.iter().all(|(_, error)| *error < 1e-4)); // as small as the vibration
        assert!(forces.iter().all(|(_, error)| *error > 0.05));
    }
    // Steps that resolve it restore the order.
    let run = |h| reading(&scene, &Unloaded, &slanted, Sdirk4::new().step(h), 1.0);
    let [angles, forces] = errors(&[1e-4, 5e-5, 2.5e-5], expected, run)?;
    has_order("SDIRK4, angle", 4.0, 1e-12, &angles);
    has_order("SDIRK4, force", 4.0, 1e-8, &forces);
    Ok(())
}

/// Strained by a hundredth of a radian at a stiffness that makes the first accelerations 1e10 rad/s²: L-stability of a rule that
/// does not need them is what survives that.
#[test]
fn sdirk4_starts_far_from_the_equilibrium_of_stiff_hinges() -> Result<(), Error> {
    for stiffness in [1e4, 1e6, 1e8, 1e10] {
        let scene = rods(stiffness, 0.0)?;
        let strained = [-0.5, -0.49, -0.5, -0.49];
        let run = |h| reading(&scene, &Unloaded, &strained, Sdirk4::new().step(h), 1.0);
        let (coarse, fine) = (run(0.01)?, run(0.005)?);
        println!("stiffness {stiffness:e}: {coarse:?}, {fine:?}");
        near(coarse.0, fine.0, 1e-3);
    }
    Ok(())
}
