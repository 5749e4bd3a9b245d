//! Joints that rub between hard stops: closed forms by every rule, rests that friction holds as well, time stepping against a dense problem of
//! complementarity and against runs with events, energy, space, saved runs, what is refused.

use catena::planar::*;
use catena::{Error, Fault, spatial};
use catena_oracle::{Noise, complementarity, has_order, near};

const GRAVITY: f64 = 9.81; // (m/s²)
const MASS: f64 = 2.0; // (kg)
const SLIDING: f64 = 4.0; // (N)
const BREAKING: f64 = 7.0; // (N)

macro_rules! rail {
    ($range:expr, $restitution:expr) => {{
        let block = RigidBody::new(MASS, 0.1, [0.0; 2], [0.0; 2]);
        let rail = Coulomb::new(Slider::along(0.0), SLIDING).breaking_away(BREAKING);
        System::new(Clamped::origin(), (rail.between($range).rebounding($restitution), block), Free)?
    }};
}

/// Place and rate of a block between two stops after a time: pieces of constant deceleration.
fn thrown([mut place, mut rate]: [f64; 2], [lower, upper]: [f64; 2], restitution: f64, mut time: f64) -> [f64; 2] {
    let braking = SLIDING / MASS;
    while rate != 0.0 {
        let (sense, rests) = (rate.signum(), rate.abs() / braking);
        let gap = if sense > 0.0 { upper - place } else { place - lower };
        let left = rate * rate - 2.0 * braking * gap;
        let strikes = if left > 0.0 { (rate.abs() - left.sqrt()) / braking } else { f64::INFINITY };
        let piece = time.min(rests).min(strikes);
        place += sense * (rate.abs() * piece - 0.5 * braking * piece * piece);
        time -= piece;
        rate = match piece {
            _ if piece == strikes => -restitution * sense * left.sqrt(),
            _ if piece == rests => 0.0,
            _ => return [place, rate - sense * braking * piece],
        };
    }
    [place, rate]
}

#[test]
fn a_thrown_block_bounces_and_stays_as_its_closed_form() -> Result<(), Box<dyn std::error::Error>> {
    let (range, restitution) = ([-0.4, 0.6], 0.8);
    let scene = rail!(range, restitution);
    let mut start = scene.with_rates(scene.motion(), &[4.0])?;
    start.set_coordinates(&[0.1])?;
    macro_rules! places {
        ($tolerance:expr, $($rule:expr),*) => {$(
            for time in [0.1, 0.3, 0.55, 0.8, 1.2, 3.0] {
                let run = scene.simulation($rule).run(start, time, |_| ())?;
                let [place, rate] = thrown([0.1, 4.0], range, restitution, time);
                near(run.motion.coordinates()[0], place, $tolerance);
                near(run.motion.rates()[0], rate, 10.0 * $tolerance);
            }
        )*};
    }
    places!(
        1e-11,
        Dop853::tolerance(1e-11),
        Vcabm::new().tolerance(1e-11),
        Rk4::step(0.013),
        Sdirk4::new().tolerance(1e-11)
    );
    places!(
        1e-11,
        Adams::step(0.01),
        Auto::tolerance(1e-11),
        GeneralizedAlpha::new(0.8).step(0.01),
        Dopri5::step(0.02)
    );
    // An order is there where accelerations are not constant: on a spring.
    let law = Spring::new(50.0);
    let block = RigidBody::new(MASS, 0.1, [0.0; 2], [0.0; 2]);
    let joint = Coulomb::new(Slider::along(0.0), SLIDING).between([-0.2, 9.0]).rebounding(restitution).with(law);
    let scene = System::new(Clamped::origin(), (joint, block), Free)?;
    let mut start = scene.motion();
    start.set_coordinates(&[0.5])?;
    // About 0.08 where it slips back, to a wall on the way, and about −0.08 where it slips forward, to its turn and beyond.
    let (w, mean) = (5.0, SLIDING / 50.0);
    let first = ((-0.2 - mean) / (0.5 - mean)).acos() / w;
    let speed = restitution * w * ((0.5 - mean).powi(2) - (0.2 + mean).powi(2)).sqrt();
    let (a, b) = (-0.2 + mean, speed / w);
    let turns = b.atan2(a) / w;
    let top = a.hypot(b) - mean;
    let later = 0.3;
    let (time, expected) = (first + turns + later, mean + (top - mean) * (w * later).cos());
    assert!(top > mean + (BREAKING - SLIDING) / 50.0 && turns > 0.0);
    macro_rules! errors {
        ($name:expr, $order:expr, [$($count:expr),*], |$step:ident| $rule:expr) => {{
            let points = [$({
                let $step = time / $count;
                let end = scene.simulation($rule).run(start, time, |_| ())?.motion;
                ($step, (end.coordinates()[0] - expected).abs())
            }),*];
            has_order($name, $order, 1e-15, &points);
        }};
    }
    errors!("RK4", 4.0, [40.0, 80.0, 160.0, 320.0], |h| Rk4::step(h));
    errors!("DOP853", 8.0, [8.0, 12.0, 16.0], |h| Dop853::step(h));
    errors!("SDIRK4", 4.0, [40.0, 80.0, 160.0, 320.0], |h| Sdirk4::new().step(h));
    errors!("Moreau-Jean", 1.0, [1000.0, 4000.0, 16000.0], |h| MoreauJean::step(h));
    Ok(())
}

/// A block at its stop, pressed, then drawn away by a force that grows.
#[test]
fn friction_holds_what_rests_at_a_stop() -> Result<(), Box<dyn std::error::Error>> {
    let scene = rail!([0.0, 1.0], 0.5);
    let grows = |rate: f64, time: f64| rate * (time - 1.0);
    for (rate, place, away) in [(10.0, 0.0, 1.0), (-10.0, 1.0, -1.0)] {
        let draws =
            move |time: f64, joint: usize, _: &JointMotion<f64>| if joint == 1 { grows(rate, time) } else { 0.0 };
        let loads = Loads::none().in_joints(draws);
        let mut start = scene.motion();
        start.set_coordinates(&[place])?;
        // It leaves where the force has grown to that at which it breaks away.
        let (leaves, time) = (1.0 + BREAKING / 10.0, 1.0 + BREAKING / 10.0 + 0.25);
        let since: f64 = time - leaves;
        let gone = ((BREAKING - SLIDING) * since.powi(2) / 2.0 + 10.0 * since.powi(3) / 6.0) / MASS;
        let expected = place + away * gone;
        let simulation = scene.simulation(Dop853::tolerance(1e-11)).loads(&loads).longest_step(0.2);
        let mut still = 0.0;
        let run = simulation.run(start, time, |now| {
            if now.motion().rates()[0] == 0.0 {
                still = now.time();
            }
        })?;
        // It leaves where it would do so at 1e-6 m/s².
        near(run.motion.coordinates()[0], expected, 2e-7);
        near(still, leaves, 3e-7);
        let points = [500.0, 1000.0, 2000.0].map(|count| {
            let rule = MoreauJean::step(time / count);
            let found = scene.simulation(rule).loads(&loads).run(start, time, |_| ()).expect("a run").motion;
            (time / count, (found.coordinates()[0] - expected).abs())
        });
        // Steps end about the instant at which it leaves.
        assert!(points.iter().all(|(h, error)| *error < 0.8 * h), "{points:?}");
    }
    Ok(())
}

/// Two rods that rub between stops.
macro_rules! arm {
    ($friction:expr, $range:expr, $restitution:expr) => {{
        let rod = Rod::uniform(0.5, 1.0);
        let joint = |k: usize| {
            let (friction, range): ([f64; 2], [[f64; 2]; 2]) = ($friction, $range);
            Coulomb::new(Revolute::smooth(), friction[k])
                .between(range[k])
                .rebounding($restitution[k])
                .with(Spring::new(0.3))
        };
        System::new(Clamped::origin(), (joint(0), rod, joint(1), rod), Free)?.with_gravity(GRAVITY)
    }};
}

/// Against steps of the scene without friction and stops, whose impulses are what is missing.
#[test]
fn every_step_is_that_of_a_dense_complementarity_problem() -> Result<(), Box<dyn std::error::Error>> {
    let (mut random, h, rounding) = (Noise::new(17), 2e-3, 1e-9);
    let (mut seen, mut sweeps, mut steps) = ([0; 5], 0, 0);
    for _ in 0..120 {
        let mut any = |least: f64, most: f64| core::array::from_fn::<f64, 2, _>(|_| random.between(least, most));
        let (friction, lower, upper) = (any(0.1, 6.0), any(-1.0, -0.1), any(0.1, 1.0));
        let restitution = any(-0.5, 0.9).map(|e| e.max(0.0));
        let scene = arm!(friction, [0, 1].map(|k| [lower[k], upper[k]]), restitution);
        let (rod, smooth) = (Rod::uniform(0.5, 1.0), ElasticHinge::with(Spring::new(0.3)));
        let plain = System::new(Clamped::origin(), (smooth, rod, smooth, rod), Free)?.with_gravity(GRAVITY);
        let mut now = scene.with_rates(scene.motion(), &any(-6.0, 6.0))?;
        let (mut stepper, mut next) = (scene.stepper(MoreauJean), now);
        for _ in 0..400 {
            stepper.step(&now, &Unloaded, h, &mut next)?;
            steps += 1;
            let (q, v, after) = (now.coordinates(), now.rates(), next.rates());
            let mut same = plain.motion();
            same.set_coordinates(&q)?;
            same.set_rates(&v)?;
            let under = |torque: [f64; 2]| {
                let mut end = plain.motion();
                let loads = Loads::none()
                    .in_joints(|_, joint: usize, _: &JointMotion<f64>| if joint > 0 { torque[joint - 1] } else { 0.0 });
                plain.stepper(MoreauJean).step(&same, &loads, h, &mut end).expect("a step");
                [0, 1].map(|k| end.rates()[k])
            };
            let impulses = complementarity::impulses(under, &after, h);
            for k in 0..2 {
                near(next.coordinates()[k], q[k] + h * after[k], 1e-12);
                let (impulse, most, gap) = (impulses[k], friction[k] * h, [lower[k] - q[k], upper[k] - q[k]]);
                // The least rate at the lower stop, the most at the upper one.
                let due = complementarity::allowed(v[k], gap, restitution[k], h);
                // Friction may bring it to rest before it strikes.
                let halts = after[k] == 0.0 && impulse.abs() <= most + rounding;
                assert!(halts || after[k] >= due[0].0 - rounding && after[k] <= due[1].0 + rounding);
                let at_stop = (0..2).find(|end| (after[k] - due[*end].0).abs() < rounding);
                // What is not friction pushes away from the stop.
                let case = match at_stop {
                    Some(end) if !halts => {
                        let away = if end == 0 { impulse } else { -impulse };
                        assert!(away >= -most - rounding, "{impulse} at {end}");
                        if after[k].abs() < rounding { 2 } else { 3 + usize::from(due[end].1) }
                    }
                    _ if halts => 0,
                    _ => {
                        near(impulse, -most * after[k].signum(), rounding);
                        1
                    }
                };
                seen[case] += 1;
                if case == 3 {
                    // On the way there friction is all of its size.
                    let push = impulse + most * after[k].signum();
                    assert!(if at_stop == Some(0) { push >= -rounding } else { push <= rounding });
                }
            }
            now = next;
        }
        sweeps += stepper.sweeps();
    }
    let [sticks, slips, rests, lands, rebounds] = seen;
    println!("{sticks} stick, {slips} slip, {rests} rest, {lands} land, {rebounds} rebound");
    println!("{:.3} sweeps a step", sweeps as f64 / f64::from(steps));
    assert!(seen.iter().all(|count| *count > 50), "{seen:?}");
    Ok(())
}

#[test]
fn arms_take_no_energy_from_friction_or_stops_and_runs_agree() -> Result<(), Box<dyn std::error::Error>> {
    let mut random = Noise::new(23);
    let mut resting = 0;
    for case in 0..12 {
        let mut any = |least: f64, most: f64| core::array::from_fn::<f64, 2, _>(|_| random.between(least, most));
        let (friction, lower, upper) = (any(0.05, 1.0), any(-1.5, -0.2), any(0.2, 1.5));
        let restitution = if case % 3 == 0 { [0.0; 2] } else { any(0.1, 0.8) };
        let mut range = [0, 1].map(|k| [lower[k], upper[k]]);
        if case % 3 != 0 {
            // Of shocks at one instant runs with events make several, and steps one.
            range[0] = [f64::NEG_INFINITY, f64::INFINITY];
        }
        let scene = arm!(friction, range, restitution);
        let start = scene.with_rates(scene.motion(), &any(-5.0, 5.0))?;
        let (mut energies, mut farthest) = (vec![], 0.0_f64);
        let run = scene.simulation(Dop853::tolerance(1e-10)).run(start, 4.0, |now| {
            energies.push(now.energy());
            let q = now.motion().coordinates();
            (0..2).for_each(|k| farthest = farthest.max(range[k][0] - q[k]).max(q[k] - range[k][1]));
        })?;
        assert!(farthest < 1e-9, "{farthest}");
        let gain = energies.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::NEG_INFINITY, f64::max);
        assert!(gain < 1e-9, "{gain} J in case {case}");
        let q = run.motion.coordinates();
        resting += (0..2).filter(|k| range[*k].contains(&q[*k])).count();
        // Another rule, and small steps that look for no instants.
        let other = scene.simulation(Vcabm::new().tolerance(1e-10)).run(start, 4.0, |_| ())?.motion;
        let small = scene.simulation(MoreauJean::step(1e-4)).run(start, 4.0, |_| ())?.motion;
        for k in 0..2 {
            near(other.coordinates()[k], run.motion.coordinates()[k], 1e-6);
            // Of order one, after some shocks that each multiply errors.
            near(small.coordinates()[k], run.motion.coordinates()[k], 0.02);
        }
    }
    println!("{resting} rest against a stop");
    assert!(resting > 3);
    Ok(())
}

/// Nothing else than [`Coulomb`] where the ends are far, and than [`HardStops`] where friction is nothing.
#[test]
fn what_it_has_beside_changes_nothing() -> Result<(), Box<dyn std::error::Error>> {
    let rod = Rod::uniform(0.5, 1.0);
    let rubs = Coulomb::new(Revolute::smooth(), 0.4);
    let far = rubs.between([f64::NEG_INFINITY, f64::INFINITY]);
    let stops = HardStops::between(Revolute::smooth(), [-0.7, 0.9]).rebounding(0.4);
    let slick = Coulomb::new(Revolute::smooth(), 1e-13).between([-0.7, 0.9]).rebounding(0.4);
    macro_rules! end {
        ($joint:expr, $rule:expr) => {{
            let scene = System::new(Clamped::origin(), ($joint, rod, $joint, rod), Free)?.with_gravity(GRAVITY);
            let start = scene.with_rates(scene.motion(), &[3.0, -2.0])?;
            scene.simulation($rule).run(start, 2.0, |_| ())?.motion.coordinates()
        }};
    }
    for (x, y) in end!(rubs, Dop853::tolerance(1e-9)).iter().zip(end!(far, Dop853::tolerance(1e-9))) {
        near(*x, y, 1e-13);
    }
    for (x, y) in end!(rubs, MoreauJean::step(1e-3)).iter().zip(end!(far, MoreauJean::step(1e-3))) {
        near(*x, y, 1e-13);
    }
    for (x, y) in end!(stops, Dop853::tolerance(1e-10)).iter().zip(end!(slick, Dop853::tolerance(1e-10))) {
        near(*x, y, 1e-7);
    }
    for (x, y) in end!(stops, MoreauJean::step(1e-3)).iter().zip(end!(slick, MoreauJean::step(1e-3))) {
        near(*x, y, 1e-9);
    }
    Ok(())
}

#[test]
fn robots_have_them_and_runs_go_on_from_what_was_saved() -> Result<(), Box<dyn std::error::Error>> {
    use catena::robot::{Base, Hinge, Link};
    let link = || {
        Link::<f64, 0b111, 0b111111>::new(
            1.0,
            [0.1, 0.02, -0.03],
            [[0.02, 0.0, 0.0], [0.0, 0.03, 0.0], [0.0, 0.0, 0.04]],
        )
    };
    let joint = |friction: f64| Coulomb::new(Hinge::level(), friction).between([-0.4, 0.5]).rebounding(0.3);
    let scene = spatial::System::new(Base::origin(), (joint(0.3), link(), joint(0.2), link()), spatial::Free)?;
    let scene = scene.with_gravity([0.0, -GRAVITY, 0.0]);
    let start = scene.with_rates(scene.motion(), &[4.0, -3.0])?;
    let simulation = || scene.simulation(Dop853::tolerance(1e-10));
    let whole = simulation().run(start, 3.0, |_| ())?;
    let mut run = simulation().begin(start, 3.0, |_| ())?;
    run.until(0.31)?;
    let saved = run.save();
    let resumed = simulation().resume(saved, 3.0, |_| ())?.finish()?;
    for (x, y) in resumed.motion.coordinates().iter().zip(whole.motion.coordinates()) {
        near(*x, y, 1e-8);
    }
    let small = scene.simulation(MoreauJean::step(1e-4)).run(start, 3.0, |_| ())?.motion;
    for (x, y) in small.coordinates().iter().zip(whole.motion.coordinates()) {
        near(*x, y, 5e-3);
    }
    let single = scene.lift(|x| x as f32);
    let start = single.with_rates(single.motion(), &[4.0, -3.0])?;
    let found = single.simulation(Dop853::tolerance(1e-5)).run(start, 3.0, |_| ())?.motion;
    for (x, y) in found.coordinates().iter().zip(whole.motion.coordinates()) {
        near(f64::from(*x), y, 5e-3);
    }
    assert_eq!(scene.describe().to_string().matches("BoundedCoulomb").count(), 2);
    Ok(())
}

/// An arm from its description, without a controller: it falls against its limits and stays.
#[test]
fn an_arm_falls_within_its_limits_and_comes_to_rest() -> Result<(), Box<dyn std::error::Error>> {
    use catena_robots::bounded_arm7::{LOWER, UPPER, scene};
    let scene = scene::<f64>()?;
    let start = scene.with_rates(scene.motion(), &[0.5, 0.3, -0.2, 0.4, 0.3, -0.2, 0.1])?;
    let (mut beyond, mut touched) = (0.0_f64, [false; 7]);
    let mut look = |q: &[f64]| {
        for k in 0..7 {
            let most = (LOWER[k] - q[k]).max(q[k] - UPPER[k]);
            (beyond, touched[k]) = (beyond.max(most), touched[k] | (most > -1e-9));
        }
    };
    let small = scene.simulation(MoreauJean::step(1e-3)).run(start, 15.0, |now| look(&now.motion().coordinates()))?;
    let exact = scene.simulation(Dop853::tolerance(1e-7)).run(start, 15.0, |now| look(&now.motion().coordinates()))?;
    println!("{touched:?} touched, beyond {beyond:.1e} rad, {:?}", exact.motion.coordinates());
    assert!(beyond < 1e-9 && touched.iter().filter(|touched| **touched).count() > 1);
    for motion in [small.motion, exact.motion] {
        assert!(motion.rates().iter().all(|rate| *rate == 0.0), "{:?}", motion.rates());
    }
    Ok(())
}

#[test]
fn what_is_no_joint_is_refused() -> Result<(), Error> {
    let block = RigidBody::new(MASS, 0.1, [0.0; 2], [0.0; 2]);
    macro_rules! fault {
        ($friction:expr, $range:expr, $restitution:expr) => {{
            let joint = Coulomb::new(Slider::along(0.0), $friction).between($range).rebounding($restitution);
            System::new(Clamped::origin(), (joint, block), Free).err().map(|error| error.fault)
        }};
    }
    assert!(matches!(fault!(-1.0, [0.0, 1.0], 0.5), Some(Fault::NotPositive { .. })));
    assert!(matches!(
        fault!(1.0, [1.0, 1.0], 0.5),
        Some(Fault::NotPositive { parameter: "range between hard stops", .. })
    ));
    assert!(matches!(fault!(1.0, [0.0, 1.0], 1.5), Some(Fault::OutOfRange { parameter: "restitution", .. })));
    assert!(fault!(1.0, [0.0, 1.0], 0.5).is_none());
    // Beyond its stop at the start; against its mode or beyond its stop in a step that changes none.
    let scene = rail!([0.0, 1.0], 0.5);
    let mut start = scene.motion();
    start.set_coordinates(&[1.1])?;
    let refused = scene.simulation(Rk4::step(0.1)).run(start, 1.0, |_| ()).expect_err("beyond").error.fault;
    assert!(matches!(refused, Fault::OutOfRange { .. }));
    let mut next = start;
    let moving = scene.with_accelerations(scene.with_rates(start, &[1.0])?, &Unloaded)?;
    let refused = scene.stepper(Rk4).step(&moving, &Unloaded, 0.1, &mut next).expect_err("beyond").fault;
    assert!(matches!(refused, Fault::Unsupported { .. }));
    let stopped = System::new(Clamped::origin(), (HardStops::between(Slider::along(0.0), [-1.0, 1.0]), block), Free)?;
    let mut start_beyond = stopped.motion();
    start_beyond.set_coordinates(&[1.1])?;
    for rate in [0.0, 1.0, -0.5] {
        let from = stopped.with_accelerations(stopped.with_rates(start_beyond, &[rate])?, &Unloaded)?;
        let mut next = start_beyond;
        let refused = stopped.stepper(Rk4).step(&from, &Unloaded, 0.1, &mut next).expect_err("beyond").fault;
        assert!(matches!(refused, Fault::Unsupported { what } if what.contains("beyond its hard stop")), "{rate}");
    }
    // A step of the rule that finds modes throws it back, also from rest.
    for rate in [0.0, 1.0, -0.5] {
        let from = scene.with_rates(start, &[rate])?;
        scene.stepper(MoreauJean).step(&from, &Unloaded, 0.01, &mut next)?;
        if rate > 0.0 {
            near(next.rates()[0], -0.5 * rate, 1e-12); // it rebounds first
            let from = next;
            scene.stepper(MoreauJean).step(&from, &Unloaded, 0.01, &mut next)?;
        }
        near(next.coordinates()[0], 1.0, 1e-12);
    }
    Ok(())
}

/// A press whose drive goes on where its ram is at the stop: it is jammed, and its closures are not to blame.
#[test]
fn a_drive_against_a_stop_is_jammed() -> Result<(), Error> {
    let bar = |length| Rod::uniform(length, 1.0);
    let ram = HardStops::between(Slider::along(0.0), [0.1, 0.45]);
    let side = (ram, RigidBody::new(1.0, 0.1, [0.0; 2], [0.0; 2]));
    let crank = Driven::new(Revolute::smooth(), |t: f64| [2.0 - t, -1.0, 0.0]);
    // Beside it something sticks that is not to blame.
    let stuck = Branch((Coulomb::new(Revolute::smooth(), 1.0), bar(0.1)));
    let net = Network::new((crank, bar(0.2), Pin, bar(0.4)), side, Pin);
    let scene = System::new(Clamped::origin(), (stuck, net), Free)?;
    let mut guess = scene.motion();
    guess.set_coordinates(&[0.0, -0.4, 0.3])?;
    let start = scene.assembled(guess, &Unloaded)?;
    let error = scene.simulate(start, Dop853::tolerance(1e-9), 3.0, |_| ()).expect_err("a stop in the way").error;
    assert!(matches!(error.fault, Fault::Jammed { joint: 1 }), "{error}");
    // Crank and rod are 0.45 m long together: 0.2 cos θ + √(0.16 − 0.04 sin² θ).
    let angle = 2.0 - error.time.expect("a time");
    near(0.2 * angle.cos() + (0.16 - 0.04 * angle.sin().powi(2)).sqrt(), 0.45, 1e-8);
    Ok(())
}
