//! Coulomb friction with modes: a block that stick-slips against its closed form under every rule, the order of rules across changes of
//! mode, a block on a spring that comes to rest, pendulums whose energy never rises, what is refused.

use catena::planar::*;
use catena::{Error, Fault, spatial};
use catena_oracle::{has_order, near};
use std::cell::Cell;
use std::f64::consts::PI;

const MASS: f64 = 2.0; // (kg)
const STIFFNESS: f64 = 50.0; // (N/m)
const SLIDING: f64 = 4.0; // (N)
const BREAKING: f64 = 7.0; // (N)
const SPEED: f64 = 0.3; // of the end of the spring (m/s)

/// A block on a plane, drawn by a spring whose end moves at constant speed: time of slip, time of stick, and its place at a time.
fn drawn(time: f64) -> ([f64; 2], f64) {
    let w = (STIFFNESS / MASS).sqrt();
    let (mean, a) = (SLIDING / STIFFNESS, (BREAKING - SLIDING) / STIFFNESS);
    let (slips, sticks) = ((2.0 * PI - 2.0 * (a * w / SPEED).atan()) / w, 2.0 * a / SPEED);
    let first = BREAKING / STIFFNESS / SPEED; // it breaks away for the first time
    if time <= first {
        return ([slips, sticks], 0.0);
    }
    let phase = (time - first) % (slips + sticks);
    let stretch = if phase < slips {
        mean + a * (w * phase).cos() + SPEED / w * (w * phase).sin()
    } else {
        mean - a + SPEED * (phase - slips)
    };
    ([slips, sticks], SPEED * time - stretch)
}

macro_rules! block {
    () => {{
        let block = RigidBody::new(MASS, 0.1, [0.0; 2], [0.0; 2]);
        System::new(
            Clamped::origin(),
            (Coulomb::new(Slider::along(0.0), SLIDING).breaking_away(BREAKING), block),
            Free,
        )?
    }};
}

fn draws(time: f64, joint: usize, motion: &JointMotion<f64>) -> f64 {
    if joint == 1 { STIFFNESS * (SPEED * time - motion.slide[0]) } else { 0.0 }
}

/// The place of the block after some periods, at rest and slipping, by a rule; and how many steps it took.
macro_rules! place_at {
    ($rule:expr, $time:expr) => {{
        let scene = block!();
        let loads = Loads::none().in_joints(draws);
        let run = scene.simulation($rule).loads(&loads).run(scene.motion(), $time, |_| ())?;
        (run.motion.coordinates()[0], run.steps)
    }};
}

#[test]
fn a_drawn_block_sticks_and_slips_as_its_closed_form() -> Result<(), Box<dyn std::error::Error>> {
    let [slips, sticks] = drawn(0.0).0;
    let first = BREAKING / STIFFNESS / SPEED;
    // Slipping, and at rest, in the fourth period.
    for time in [first + 3.0 * (slips + sticks) + 0.4 * slips, first + 4.0 * (slips + sticks) - 0.3 * sticks] {
        let expected = drawn(time).1;
        let found = [
            place_at!(Dop853::tolerance(1e-11), time),
            place_at!(Vcabm::new().tolerance(1e-12), time),
            place_at!(Adams::step(2e-4), time),
            place_at!(Sdirk4::new().tolerance(1e-10), time),
            place_at!(Auto::tolerance(1e-10), time),
        ];
        for (place, steps) in found {
            println!("at {time:.3} s: {place:.12} m in {steps} steps, error {:.1e}", place - expected);
            near(place, expected, 1e-8);
        }
    }
    Ok(())
}

#[test]
fn rules_keep_their_order_across_changes_of_mode() -> Result<(), Box<dyn std::error::Error>> {
    let [slips, sticks] = drawn(0.0).0;
    let time = BREAKING / STIFFNESS / SPEED + 2.0 * (slips + sticks) + 0.4 * slips;
    let expected = drawn(time).1;
    macro_rules! errors {
        ($name:expr, $order:expr, $floor:expr, [$($count:expr),*], |$step:ident| $rule:expr) => {{
            let points = [$({
                let $step = time / $count;
                ($step, (place_at!($rule, time).0 - expected).abs())
            }),*];
            has_order($name, $order, $floor, &points);
        }};
    }
    errors!("RK4", 4.0, 1e-15, [80.0, 160.0, 320.0, 640.0], |h| Rk4::step(h));
    errors!("DOP853", 8.0, 1e-15, [40.0, 56.0, 80.0], |h| Dop853::step(h));
    errors!("SDIRK4", 4.0, 1e-15, [80.0, 160.0, 320.0, 640.0], |h| Sdirk4::new().step(h));
    errors!("generalised α", 2.0, 1e-15, [400.0, 800.0, 1600.0], |h| GeneralizedAlpha::new(0.8).step(h));
    Ok(())
}

#[test]
fn a_block_on_a_spring_loses_the_same_each_swing_and_stays() -> Result<(), Box<dyn std::error::Error>> {
    let (block, reach) = (RigidBody::new(MASS, 0.1, [0.0; 2], [0.0; 2]), 0.5);
    let joint = Coulomb::new(Slider::along(0.0), SLIDING).with(Spring::new(STIFFNESS));
    let scene = System::new(Clamped::origin(), (joint, block), Free)?;
    let mut start = scene.motion();
    start.set_coordinates(&[reach])?;
    let (mut energies, mut still) = (vec![], None);
    let run = scene.simulation(Dop853::tolerance(1e-11)).run(start, 5.0, |now| {
        energies.push(now.energy());
        if now.motion().rates()[0].abs() < 1e-12
            && now.time() > 0.0
            && still.is_none()
            && now.motion().coordinates()[0].abs() < SLIDING / STIFFNESS
        {
            still = Some(now.time());
        }
    })?;
    // Turns at 0.5, −0.34, 0.18, −0.02: there the spring holds less than friction does.
    let (loss, w) = (2.0 * SLIDING / STIFFNESS, (STIFFNESS / MASS).sqrt());
    near(run.motion.coordinates()[0], -(reach - 3.0 * loss), 1e-10);
    assert_eq!(run.motion.rates(), [0.0]);
    near(still.ok_or("it never rests")?, 3.0 * PI / w, 0.02);
    assert!(energies.windows(2).all(|pair| pair[1] <= pair[0] + 1e-12));
    near(energies[energies.len() - 1], 0.5 * STIFFNESS * (reach - 3.0 * loss).powi(2), 1e-9);
    Ok(())
}

/// Adds up how far coordinates go: turns are ends of steps.
fn add_way(ways: &mut [f64], last: &mut Vec<f64>, now: Vec<f64>) {
    ways.iter_mut().zip(last.iter().zip(&now)).for_each(|(way, (last, now))| *way += (now - last).abs());
    *last = now;
}

#[test]
fn energy_of_pendulums_falls_by_the_work_of_friction_until_they_rest() -> Result<(), Box<dyn std::error::Error>> {
    let rod = Rod::uniform(0.5, 1.0);
    let rubs = |friction| Coulomb::new(Revolute::smooth(), friction);
    let scene = System::new(Clamped::origin(), (rubs(0.6), rod, rubs(0.3), rod), Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[0.3, -0.4])?;
    let (mut ways, mut last, mut energies) = ([0.0; 2], start.coordinates(), vec![]);
    let run = scene.simulation(Dop853::tolerance(1e-10)).run(start, 12.0, |now| {
        add_way(&mut ways, &mut last, now.motion().coordinates());
        energies.push(now.energy());
    })?;
    assert!(energies.windows(2).all(|pair| pair[1] <= pair[0] + 1e-9));
    assert_eq!(run.motion.rates(), [0.0; 2]);
    near(energies[0] - energies[energies.len() - 1], 0.6 * ways[0] + 0.3 * ways[1], 1e-8);
    // What friction bears at rest is less than what it can.
    let end = scene.with_accelerations(run.motion, &Unloaded)?;
    let stations = scene.stations(&end, &Unloaded)?;
    for (k, most) in [(1, 0.6), (2, 0.3)] {
        let borne = stations.joint(scene.joint(k)?).map_or(f64::NAN, |station| f64::abs(station.internal.torque));
        println!("at rest after {} steps, friction bears {borne:.3} of {most} N·m", run.steps);
        assert!(borne <= most);
    }
    // Smooth laws of ever smaller speeds lead there.
    let smooth = |speed: f64| -> Result<Vec<f64>, Box<dyn std::error::Error>> {
        let rubs = |friction| ElasticHinge::with(DryFriction::new(friction, speed));
        let scene = System::new(Clamped::origin(), (rubs(0.6), rod, rubs(0.3), rod), Free)?.with_gravity(9.81);
        let start = scene.at_rest(&[0.3, -0.4])?;
        Ok(scene.simulation(Dop853::tolerance(1e-9)).run(start, 1.5, |_| ())?.motion.coordinates())
    };
    let sharp = scene.simulation(Dop853::tolerance(1e-10)).run(scene.at_rest(&[0.3, -0.4])?, 1.5, |_| ())?.motion;
    let (half, whole) = (smooth(0.005)?, smooth(0.01)?);
    for (k, sharp) in sharp.coordinates().into_iter().enumerate() {
        println!("at 1.5 s: {sharp:.6}, smooth {:.6}, {:.6}", half[k], whole[k]);
        near(2.0 * half[k] - whole[k], sharp, 2e-4);
    }
    Ok(())
}

#[test]
fn a_chain_with_friction_in_space_comes_to_rest() -> Result<(), Box<dyn std::error::Error>> {
    let bar = spatial::Rod::uniform(0.5, 0.05, 1.0);
    let hinge = |axis: [f64; 3], friction| Coulomb::new(spatial::Revolute::about(axis), friction);
    let chain = (hinge([0.0, 1.0, 0.0], 0.6), bar, hinge([0.3, 0.2, 1.0], 0.2), bar);
    let scene = spatial::System::new(spatial::Clamped::origin(), chain, spatial::Free)?;
    let scene = scene.with_gravity([0.0, 0.0, -9.81]);
    let start = scene.with_rates(scene.motion(), &[0.0, 5.0])?;
    let (mut ways, mut last, mut energies) = ([0.0; 2], start.coordinates(), vec![]);
    let run = scene.simulation(Vcabm::new().tolerance(1e-11)).run(start, 12.0, |now| {
        add_way(&mut ways, &mut last, now.motion().coordinates());
        energies.push(now.energy());
    })?;
    assert!(energies.windows(2).all(|pair| pair[1] <= pair[0] + 1e-9));
    assert_eq!(run.motion.rates(), [0.0; 2]);
    near(energies[0] - energies[energies.len() - 1], 0.6 * ways[0] + 0.2 * ways[1], 1e-8);
    Ok(())
}

#[test]
fn a_mechanism_locks_with_its_one_joint_and_runs_go_on_from_what_was_saved() -> Result<(), Box<dyn std::error::Error>> {
    let crank = Coulomb::new(Revolute::smooth(), 1.5).breaking_away(2.0);
    let piston = RigidBody::new(2.0, 0.02, [0.0; 2], [0.0; 2]);
    let chain = (crank, Rod::uniform(0.3, 1.0), Pin, Rod::uniform(0.8, 1.5), Pin, piston);
    let scene = System::new(Clamped::origin(), chain, Guided::at(0.0, 0.0, 0.0))?.with_gravity(9.81);
    let start = scene.with_rates(scene.at_rest(&[0.0; 3])?, &[9.0, -9.0 * 0.3 / 0.8, 0.0])?;
    let simulation = || scene.simulation(Dop853::tolerance(1e-11));
    let (mut ways, mut last, mut energies) = ([0.0; 1], vec![start.coordinates()[0]], vec![]);
    let whole = simulation().run(start, 5.0, |now| {
        add_way(&mut ways, &mut last, vec![now.motion().coordinates()[0]]);
        energies.push(now.energy());
    })?;
    near(energies[0] - energies[energies.len() - 1], 1.5 * ways[0], 1e-8);
    assert!(whole.motion.rates().iter().all(|rate| rate.abs() < 1e-12) && ways[0] > 1.0);
    let mut run = simulation().begin(start, 5.0, |_| ())?;
    run.until(0.9)?;
    let resumed = simulation().resume(run.save(), 5.0, |_| ())?.finish()?;
    assert_eq!((resumed.motion, resumed.steps), (whole.motion, whole.steps));
    Ok(())
}

#[test]
fn what_makes_no_run_is_refused() -> Result<(), Error> {
    let plain = RigidBody::new(1.0, 0.1, [0.0; 2], [0.0; 2]);
    let less = Coulomb::new(Slider::along(0.0), 2.0).breaking_away(1.0);
    let refused = System::new(Clamped::origin(), (less, plain), Free).map(|_| ()).map_err(|error| error.fault);
    assert!(matches!(refused, Err(Fault::OutOfRange { value: 1.0, least: 2.0, .. })));
    Ok(())
}

/// A block of 2 kg that slides under 10 N and breaks away at 12 N.
macro_rules! at_rest {
    () => {{
        let block = RigidBody::new(MASS, 0.1, [0.0; 2], [0.0; 2]);
        let track = Coulomb::new(Slider::along(0.0), 10.0).breaking_away(12.0);
        System::new(Clamped::origin(), (track, block), Free)?
    }};
}

#[test]
fn steps_of_what_rests_do_not_pass_over_its_breakaway() -> Result<(), Box<dyn std::error::Error>> {
    let scene = at_rest!();
    let away = (12.0_f64 / 15.0).asin() / PI;
    let pulls = |time: f64, joint: usize, _: &JointMotion<f64>| if joint == 1 { 15.0 * (PI * time).sin() } else { 0.0 };
    let loads = Loads::none().in_joints(pulls);
    // Slides from there to the end of the pulse.
    let rate = |t: f64| (15.0 / PI * ((PI * away).cos() - (PI * t).cos()) - 10.0 * (t - away)) / MASS;
    macro_rules! first {
        ($rule:expr) => {{
            let (mut last, mut steps) = (0.0, 0);
            let run = scene.simulation($rule).loads(&loads).run(scene.motion(), 1.0, |now| {
                steps += 1;
                if now.motion().rates()[0] == 0.0 {
                    last = now.time();
                }
            })?;
            println!("broke away at {last} s of {away}, {steps} steps");
            near(last, away, 1e-9);
            near(run.motion.rates()[0], rate(1.0), 1e-6);
        }};
    }
    first!(Dop853::tolerance(1e-9));
    first!(Vcabm::new().tolerance(1e-9));
    first!(Sdirk4::new().tolerance(1e-9));
    // Loads that jump come through too.
    let jumps = |time: f64, joint: usize, _: &JointMotion<f64>| {
        if joint != 1 {
            0.0
        } else if time < 0.7 {
            2.0
        } else {
            11.9
        }
    };
    let loads = Loads::none().in_joints(jumps);
    let run = scene.simulation(Dop853::tolerance(1e-9)).loads(&loads).run(scene.motion(), 3.0, |_| ())?;
    assert!(run.motion.coordinates() == [0.0] && run.steps < 60);
    Ok(())
}

#[test]
fn runs_that_go_on_find_the_modes_of_what_has_changed() -> Result<(), Box<dyn std::error::Error>> {
    let scene = at_rest!();
    let simulation = || scene.simulation(Dop853::tolerance(1e-9));
    let mut run = simulation().begin(scene.motion(), 0.5, |_| ())?;
    run.until(0.5)?;
    // Pushed.
    let mut pushed = run.save();
    pushed.motion.set_rates(&[3.0])?;
    let end = simulation().resume(pushed, 2.5, |_| ())?.finish()?.motion;
    near(end.coordinates()[0], 0.9, 1e-12);
    assert_eq!(end.rates(), [0.0]);
    // Drawn.
    let loads = Loads::none().in_joints(|_, joint, _: &JointMotion<f64>| if joint == 1 { 14.0 } else { 0.0 });
    let end = simulation().loads(&loads).resume(run.save(), 1.5, |_| ())?.finish()?.motion;
    near(end.rates()[0], 2.0, 1e-12);
    Ok(())
}

#[test]
fn a_joint_that_comes_to_rest_is_an_event_of_its_rate() -> Result<(), Box<dyn std::error::Error>> {
    let scene = at_rest!();
    for speed in [0.7, 0.9, 1.0, 1.3, -1.7, 1.9, 2.3, 2.9, -3.0, 3.1, 3.7, 4.3] {
        let start = scene.with_rates(scene.motion(), &[speed])?;
        let simulation = || scene.simulation(Dop853::tolerance(1e-9)).event(|now| now.motion().rates()[0]);
        let mut events = vec![];
        simulation().run(start, 2.0, |now| {
            if now.is_event() {
                events.push(now.time())
            }
        })?;
        assert_eq!(events.len(), 1, "at {speed} m/s");
        near(events[0], f64::abs(speed) / 5.0, 1e-12);
        let mut stopped = simulation().stopping().begin(start, 2.0, |_| ())?;
        while stopped.step()? {}
        near(stopped.motion().time(), f64::abs(speed) / 5.0, 1e-12);
        let end = simulation().resume(stopped.save(), 2.0, |_| ())?.finish()?.motion;
        assert_eq!(end.rates(), [0.0]);
        near(end.coordinates()[0], speed * f64::abs(speed) / 10.0, 1e-12);
    }
    Ok(())
}

#[test]
fn assembly_moves_joints_that_will_stick() -> Result<(), Box<dyn std::error::Error>> {
    let rod = |length| Rod::uniform(length, 1.0);
    let rubs = Coulomb::new(Revolute::smooth(), 1.0);
    let rubbing = System::new(Pinned::origin(), (rod(0.5), rubs, rod(1.2), Pin, rod(0.9)), Pinned::at(1.0, 0.0))?;
    let smooth =
        System::new(Pinned::origin(), (rod(0.5), Revolute::smooth(), rod(1.2), Pin, rod(0.9)), Pinned::at(1.0, 0.0))?;
    macro_rules! assembled {
        ($scene:expr) => {{
            let guess = $scene.with_rates($scene.at_rest(&[1.0, 0.3, -2.0])?, &[9.0, 0.0, 0.0])?;
            let start = $scene.assembled(guess, &Unloaded)?;
            [start.coordinates(), start.rates()].concat()
        }};
    }
    let (found, expected) = (assembled!(rubbing), assembled!(smooth));
    assert!(f64::abs(expected[3]) > 1.0);
    found.iter().zip(&expected).for_each(|(found, expected)| near(*found, *expected, 1e-12));
    Ok(())
}

#[test]
fn joints_that_stick_have_no_modes_of_vibration_and_no_one_equilibrium() -> Result<(), Error> {
    let scene = at_rest!();
    let modes = scene.modes(&scene.motion(), &Unloaded).map(|_| ()).map_err(|error| error.fault);
    let rest = scene.equilibrium(scene.motion(), &Unloaded).map(|_| ()).map_err(|error| error.fault);
    assert!([modes, rest].iter().all(|refused| matches!(refused, Err(Fault::Unsupported { .. }))));
    Ok(())
}

/// An event function that is no number after a change of mode: the step is not taken, and does not count when the run is tried again.
#[test]
fn a_step_whose_change_of_mode_fails_is_not_taken() -> Result<(), Box<dyn std::error::Error>> {
    let (scene, loads) = (block!(), Loads::none().in_joints(draws));
    let (last, due) = (Cell::new(f64::NAN), Cell::new(false));
    let simulation = || {
        scene.simulation(Rk4::step(0.01)).loads(&loads).event(|now| {
            let again = last.replace(now.time()) == now.time();
            if again && due.take() { f64::NAN } else { 1.0 }
        })
    };
    let whole = simulation().run(scene.motion(), 1.0, |_| ())?;
    due.set(true);
    let mut run = simulation().begin(scene.motion(), 1.0, |_| ())?;
    let failed = loop {
        if let Err(error) = run.step() {
            break error;
        }
    };
    assert!(matches!(failed.fault, Fault::NotFinite { parameter: "value of the event function" }), "{failed}");
    let found = run.finish()?;
    assert_eq!((found.steps, found.motion.coordinates()), (whole.steps, whole.motion.coordinates()));
    Ok(())
}
