//! Time stepping with friction and stops: orders against closed forms, complementarity of every step against a dense one, ranges and energy,
//! closed scenes, what is refused.

use catena::planar::*;
use catena::scalar::Jet;
use catena::{Error, Fault, spatial};
use catena_oracle::{Noise, complementarity, has_order, near};
use std::f64::consts::{FRAC_PI_2, PI};

const GRAVITY: f64 = 9.81; // (m/s²)

#[test]
fn smooth_motions_have_order_one_and_stiff_ones_are_stable() -> Result<(), Box<dyn std::error::Error>> {
    let rod = Rod::uniform(1.0, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(GRAVITY);
    let start = scene.at_rest(&[-1.0, -0.5])?;
    let exact = scene.simulation(Dop853::tolerance(1e-12)).run(start, 0.8, |_| ())?.motion;
    let points = [1e-3, 5e-4, 2.5e-4].map(|h| {
        let run = scene.simulation(MoreauJean::step(h)).run(start, 0.8, |_| ()).expect("a run");
        assert_eq!(run.sweeps, run.steps);
        (h, (run.motion.coordinates()[1] - exact.coordinates()[1]).abs())
    });
    has_order("double pendulum", 1.0, 1e-15, &points);
    // On balls, which turn by the composition of rotations.
    let bar = spatial::Rod::uniform(0.5, 0.05, 1.0);
    let rope = (spatial::Ball, bar, spatial::Ball, bar);
    let scene =
        spatial::System::new(spatial::Clamped::origin(), rope, spatial::Free)?.with_gravity([0.0, 0.0, -GRAVITY]);
    let start = scene.with_rates(scene.motion(), &[1.0, 2.0, -1.0, 0.5, -2.0, 3.0])?;
    let exact = scene.simulation(Dop853::tolerance(1e-12)).run(start, 0.5, |_| ())?.motion.rates();
    let points = [1e-3, 5e-4, 2.5e-4].map(|h| {
        let found = scene.simulation(MoreauJean::step(h)).run(start, 0.5, |_| ()).expect("a run").motion.rates();
        (h, found.iter().zip(&exact).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max))
    });
    has_order("rods on balls", 1.0, 1e-15, &points);
    // A hinge of 1e8 N·m/rad, strained: it is a weld after some steps.
    let stiff = (rod, ElasticHinge::rotary(1e8), rod);
    let stiff = System::new(Pinned::origin(), stiff, Free)?.with_gravity(GRAVITY);
    let start = stiff.at_rest(&[-1.0, 0.01])?;
    let end = stiff.simulation(MoreauJean::step(1e-3)).run(start, 1.0, |_| ())?.motion;
    near(end.coordinates()[1], 0.0, 1e-6);
    Ok(())
}

const MASS: f64 = 2.0; // (kg)
const STIFFNESS: f64 = 50.0; // (N/m)
const SLIDING: f64 = 4.0; // (N)
const BREAKING: f64 = 7.0; // (N)
const SPEED: f64 = 0.3; // of the end of the spring (m/s)

#[test]
fn a_drawn_block_sticks_and_slips_with_order_one() -> Result<(), Box<dyn std::error::Error>> {
    let block = RigidBody::new(MASS, 0.1, [0.0; 2], [0.0; 2]);
    let joint = Coulomb::new(Slider::along(0.0), SLIDING).breaking_away(BREAKING);
    let scene = System::new(Clamped::origin(), (joint, block), Free)?;
    let draws = |time: f64, joint: usize, motion: &JointMotion<f64>| {
        if joint == 1 { STIFFNESS * (SPEED * time - motion.slide[0]) } else { 0.0 }
    };
    let loads = Loads::none().in_joints(draws);
    // In its second slip: from a stretch a beyond the mean of slips, at rest.
    let (w, a) = ((STIFFNESS / MASS).sqrt(), (BREAKING - SLIDING) / STIFFNESS);
    let (slips, sticks) = ((2.0 * PI - 2.0 * (a * w / SPEED).atan()) / w, 2.0 * a / SPEED);
    let phase = 0.4 * slips;
    let time = BREAKING / STIFFNESS / SPEED + slips + sticks + phase;
    let stretch = SLIDING / STIFFNESS + a * (w * phase).cos() + SPEED / w * (w * phase).sin();
    let points = [500.0, 1000.0, 2000.0, 4000.0].map(|count| {
        let mut stuck = 0;
        let simulation = scene.simulation(MoreauJean::step(time / count)).loads(&loads);
        let run = simulation.run(scene.motion(), time, |now| stuck += usize::from(now.motion().rates()[0] == 0.0));
        let run = run.expect("a run");
        let share = stuck as f64 / count;
        near(share, (time - slips - phase) / time, 0.01);
        (time / count, (run.motion.coordinates()[0] - (SPEED * time - stretch)).abs())
    });
    has_order("stick and slip", 1.0, 1e-15, &points);
    Ok(())
}

#[test]
fn a_block_bounces_with_order_one_and_rests_on_its_stop() -> Result<(), Box<dyn std::error::Error>> {
    let scene = |restitution: f64| {
        let block = RigidBody::new(MASS, 0.1, [0.0; 2], [0.0; 2]);
        let fall = HardStops::between(Slider::along(FRAC_PI_2), [0.0, f64::INFINITY]).rebounding(restitution);
        Ok::<_, Error>(System::new(Clamped::origin(), (fall, block), Free)?.with_gravity(GRAVITY))
    };
    // From 1 m, in its second flight; the end of a step is anywhere about the shock, so that of many runs the mean is taken.
    let (e, first) = (0.7, (2.0 / GRAVITY).sqrt());
    let bouncing = scene(e)?;
    let mut start = bouncing.motion();
    start.set_coordinates(&[1.0])?;
    let later = 0.9 * e * first;
    let (time, expected) = (first + later, e * GRAVITY * first * later - 0.5 * GRAVITY * later * later);
    let points = [400, 800, 1600, 3200].map(|least| {
        let errors = (least..least + least / 5).step_by(least / 100).map(|count| {
            let rule = MoreauJean::step(time / count as f64);
            let end = bouncing.simulation(rule).run(start, time, |_| ()).expect("a run").motion;
            (end.coordinates()[0] - expected).abs()
        });
        (time / least as f64, errors.sum::<f64>() / 20.0)
    });
    has_order("bounce", 1.0, 1e-15, &points);
    // It comes to rest, there and at its stop, and never goes below it or rises again.
    for restitution in [0.0, e] {
        let scene = scene(restitution)?;
        let (mut lowest, mut energies) = (f64::INFINITY, vec![]);
        let end = scene
            .simulation(MoreauJean::step(1e-3))
            .run(start, 6.0, |now| {
                lowest = lowest.min(now.motion().coordinates()[0]);
                energies.push(now.energy());
            })?
            .motion;
        assert_eq!(end.rates(), [0.0], "e = {restitution}");
        near(end.coordinates()[0], 0.0, 1e-15);
        assert!(lowest > -1e-13, "{lowest}");
        // By what half a step falls.
        let gain = energies.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
        assert!(gain < MASS * (GRAVITY * 1e-3_f64).powi(2), "{gain} J");
        let end = scene.with_accelerations(end, &Unloaded)?;
        let force = scene.stations(&end, &Unloaded)?.joint(scene.joint(0)?).map_or(f64::NAN, |at| at.internal.force.y);
        near(f64::abs(force), MASS * GRAVITY, 1e-12);
    }
    Ok(())
}

/// What four joints have at random: friction, or stops at both ends with restitution.
#[derive(Clone, Copy)]
struct Furniture {
    friction: [f64; 4],
    lower: [f64; 4],
    upper: [f64; 4],
    restitution: [f64; 4],
}

/// Two joints with friction and two with stops, in turn.
macro_rules! arm {
    ($furniture:expr) => {{
        let (rod, Furniture { friction, lower, upper, restitution }) = (Rod::uniform(0.5, 1.0), $furniture);
        let rubs = |k: usize| Coulomb::new(Revolute::smooth(), friction[k]).with(Spring::damping(0.05));
        let stops = |k: usize| {
            HardStops::between(Revolute::smooth(), [lower[k], upper[k]])
                .rebounding(restitution[k])
                .with(Spring::new(0.3))
        };
        let chain = (rubs(0), rod, stops(1), rod, rubs(2), rod, stops(3), rod);
        System::new(Clamped::origin(), chain, Free)?.with_gravity(GRAVITY)
    }};
}

/// Every step against one of the same scene without friction and stops, whose rates change with impulses in joints by a matrix that steps under
/// unit torques show: impulses that make up the difference, and what they must be.
#[test]
fn every_step_is_that_of_a_dense_complementarity_problem() -> Result<(), Box<dyn std::error::Error>> {
    let (mut random, h) = (Noise::new(7), 2e-3);
    let (mut seen, mut sweeps, mut steps, mut worst) = ([0; 6], 0, 0, 0.0_f64);
    for _ in 0..60 {
        let mut any = |least: f64, most: f64| core::array::from_fn(|_| random.between(least, most));
        let furniture = Furniture {
            friction: any(0.2, 6.0),
            lower: any(-1.0, -0.1),
            upper: any(0.1, 1.0),
            restitution: any(-0.5, 0.9).map(|e: f64| e.max(0.0)),
        };
        let Furniture { friction, lower, upper, restitution } = furniture;
        let scene = arm!(furniture);
        let rod = Rod::uniform(0.5, 1.0);
        let (rubs, stops) = (ElasticHinge::with(Spring::damping(0.05)), ElasticHinge::with(Spring::new(0.3)));
        let plain = System::new(Clamped::origin(), (rubs, rod, stops, rod, rubs, rod, stops, rod), Free)?;
        let plain = plain.with_gravity(GRAVITY);
        let mut now = scene.with_rates(scene.motion(), &any(-4.0, 4.0))?;
        let (mut stepper, mut next) = (scene.stepper(MoreauJean), now);
        for _ in 0..400 {
            stepper.step(&now, &Unloaded, h, &mut next)?;
            steps += 1;
            let (q, v, after) = (now.coordinates(), now.rates(), next.rates());
            let mut same = plain.motion();
            same.set_coordinates(&q)?;
            same.set_rates(&v)?;
            let under = |torque: [f64; 4]| {
                let mut end = plain.motion();
                let loads = Loads::none()
                    .in_joints(|_, joint: usize, _: &JointMotion<f64>| if joint > 0 { torque[joint - 1] } else { 0.0 });
                plain.stepper(MoreauJean).step(&same, &loads, h, &mut end).expect("a step");
                [0, 1, 2, 3].map(|k| end.rates()[k])
            };
            let impulses = complementarity::impulses(under, &after, h);
            for k in 0..4 {
                let (impulse, gap) = (impulses[k], [lower[k] - q[k], upper[k] - q[k]]);
                let rounding = 1e-9;
                near(next.coordinates()[k], q[k] + h * after[k], 1e-12);
                let case = if k % 2 == 0 {
                    let most = friction[k] * h;
                    worst = worst.max(impulse.abs() - most);
                    if after[k] == 0.0 {
                        assert!(impulse.abs() <= most + rounding);
                        0
                    } else {
                        near(impulse, -most * after[k].signum(), rounding);
                        1
                    }
                } else {
                    // The least rate at the lower stop, the most at the upper one.
                    let due = complementarity::allowed(v[k], gap, restitution[k], h);
                    assert!(after[k] >= due[0].0 - rounding && after[k] <= due[1].0 + rounding);
                    if impulse.abs() < rounding {
                        2
                    } else {
                        let end = usize::from(impulse < 0.0);
                        near(after[k], due[end].0, rounding);
                        if due[end].1 { 5 } else { 3 + usize::from(gap[end].abs() < 1e-12) }
                    }
                };
                seen[case] += 1;
            }
            now = next;
        }
        sweeps += stepper.sweeps();
    }
    let [sticks, slips, swings, lands, rests, rebounds] = seen;
    println!("{sticks} sticks, {slips} slips, {swings} swings, {lands} lands, {rests} rests, {rebounds} rebounds");
    println!("{:.2} sweeps a step, friction exceeded by {worst:.1e} N·m·s", sweeps as f64 / f64::from(steps));
    assert!(seen.iter().all(|count| *count > 50));
    Ok(())
}

#[test]
fn mechanisms_rub_in_all_their_joints_and_runs_go_on_from_what_was_saved() -> Result<(), Box<dyn std::error::Error>> {
    // A crank whose piston is guided: it comes to rest where a run with events does.
    let crank = Coulomb::new(Revolute::smooth(), 1.5);
    let piston = RigidBody::new(2.0, 0.02, [0.0; 2], [0.0; 2]);
    let chain = (crank, Rod::uniform(0.3, 1.0), Pin, Rod::uniform(0.8, 1.5), Pin, piston);
    let scene = System::new(Clamped::origin(), chain, Guided::at(0.0, 0.0, 0.0))?.with_gravity(GRAVITY);
    let start = scene.with_rates(scene.at_rest(&[0.0; 3])?, &[9.0, -9.0 * 0.3 / 0.8, 0.0])?;
    let exact = scene.simulation(Dop853::tolerance(1e-10)).run(start, 5.0, |_| ())?.motion;
    let simulation = || scene.simulation(MoreauJean::step(5e-4));
    let whole = simulation().run(start, 5.0, |_| ())?;
    assert_eq!(whole.motion.rates(), [0.0; 3]);
    near(whole.motion.coordinates()[0], exact.coordinates()[0], 5e-3);
    let mut run = simulation().begin(start, 5.0, |_| ())?;
    run.until(0.9)?;
    let resumed = simulation().resume(run.save(), 5.0, |_| ())?.finish()?;
    assert_eq!((resumed.motion, resumed.steps), (whole.motion, whole.steps));

    // Of a four-bar one joint can stick, or several with friction of whatever shares: beside friction that is smooth.
    macro_rules! bar {
        ($rubs:expr) => {{
            let (rubs, bar) = ($rubs, |length| Rod::uniform(length, 1.5 * length));
            let chain = (rubs, bar(0.3), rubs, bar(0.8), Pin, bar(0.6));
            let scene = System::new(Clamped::origin(), chain, Pinned::at(0.9, 0.0))?.with_gravity(GRAVITY);
            let start = scene.with_rates(scene.at_rest(&[1.0, -0.7, -2.0])?, &[4.0, 0.0, 0.0])?;
            let start = scene.assembled(start, &Unloaded)?;
            (scene, start)
        }};
    }
    let (scene, start) = bar!(Coulomb::new(Revolute::smooth(), 0.5));
    let (smooth, same) = bar!(ElasticHinge::with(DryFriction::new(0.5, 1e-5)));
    let exact = |time| {
        let run = smooth.simulation(Sdirk4::new().tolerance(1e-8)).run(same, time, |_| ());
        run.expect("a run").motion.coordinates()[0]
    };
    let end = |time, h| scene.simulation(MoreauJean::step(h)).run(start, time, |_| ()).expect("a run").motion;
    let moving = exact(0.5);
    let points = [4e-4, 2e-4, 1e-4].map(|h| (h, (end(0.5, h).coordinates()[0] - moving).abs()));
    has_order("four-bar", 1.0, 1e-15, &points);
    // From rest, where any of them would hold it: nothing moves.
    let (held, start) = bar!(Coulomb::new(Revolute::smooth(), 5.0));
    let start = held.with_rates(start, &[0.0; 3])?;
    let stays = [
        held.simulation(MoreauJean::step(1e-3)).run(start, 0.1, |_| ())?,
        held.simulation(Rk4::step(1e-3)).run(start, 0.1, |_| ())?,
    ];
    for (x, y) in stays.iter().flat_map(|run| run.motion.coordinates().into_iter().zip(start.coordinates())) {
        near(x, y, 1e-12);
    }
    let rests = end(5.0, 1e-4);
    assert!(rests.rates().iter().all(|rate| rate.abs() < 1e-12), "{:?}", rests.rates());
    near(rests.coordinates()[0], exact(5.0), 2e-3);
    Ok(())
}

#[test]
fn steps_of_many_joints_take_few_passes() -> Result<(), Error> {
    let (mut random, rod) = (Noise::new(3), Rod::uniform(0.1, 0.1));
    for restitution in [0.0, 0.5] {
        let links: Vec<_> = (0..20)
            .map(|_| {
                let range = [random.between(-0.5, -0.05), random.between(0.05, 0.5)];
                let stops = HardStops::between(Revolute::smooth(), range).rebounding(restitution);
                (Coulomb::new(Revolute::smooth(), random.between(0.01, 0.3)), rod, stops, rod)
            })
            .collect();
        let scene = System::new(Clamped::origin(), links, Free)?.with_gravity(GRAVITY);
        let rates: Vec<f64> = (0..40).map(|_| random.between(-4.0, 4.0)).collect();
        let mut now = scene.with_rates(scene.motion(), &rates)?;
        let (mut stepper, mut next, mut most) = (scene.stepper(MoreauJean), now.clone(), 0);
        for _ in 0..1500 {
            let before = stepper.sweeps();
            stepper.step(&now, &Unloaded, 1e-3, &mut next)?;
            most = most.max(stepper.sweeps() - before);
            core::mem::swap(&mut now, &mut next);
        }
        let mean = stepper.sweeps() as f64 / 1500.0;
        println!("{mean:.2} sweeps a step, at most {most}");
        assert!(mean < 4.0 && most < 40);
    }
    Ok(())
}

/// Beside a run with events, in both precisions.
#[test]
fn arms_in_space_have_order_one_and_coupled_joints_come_to_rest() -> Result<(), Box<dyn std::error::Error>> {
    let bar = spatial::Rod::uniform(0.5, 0.05, 1.0);
    let rubs = Coulomb::new(spatial::Revolute::about([0.0, 1.0, 0.0]), 0.6);
    let stops = HardStops::between(spatial::Revolute::about([0.3, 0.2, 1.0]), [-0.4, 0.5]);
    let scene = spatial::System::new(spatial::Clamped::origin(), (rubs, bar, stops, bar), spatial::Free)?;
    let scene = scene.with_gravity([0.0, 0.0, -GRAVITY]);
    let start = scene.with_rates(scene.motion(), &[0.0, 5.0])?;
    let exact = scene.simulation(Dop853::tolerance(1e-11)).run(start, 0.7, |_| ())?.motion.coordinates();
    let points = [1e-3, 5e-4, 2.5e-4, 1.25e-4].map(|h| {
        let found = scene.simulation(MoreauJean::step(h)).run(start, 0.7, |_| ()).expect("a run").motion.coordinates();
        (h, found.iter().zip(&exact).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max))
    });
    has_order("space", 1.0, 1e-15, &points);
    let single = scene.lift(|x| x as f32);
    let start = single.with_rates(single.motion(), &[0.0, 5.0])?;
    let found = single.simulation(MoreauJean::step(1e-3)).run(start, 0.7, |_| ())?.motion.coordinates();
    for (x, y) in found.iter().zip(&exact) {
        near(f64::from(*x), *y, 1.5 * points[0].1);
    }
    // Two joints that rub and are geared to each other: one of them can stick.
    let (rod, rubs) = (Rod::uniform(0.5, 1.0), Coulomb::new(Revolute::smooth(), 0.4));
    let scene = System::new(Clamped::origin(), (rubs, rod, rubs, rod), Free)?.with_gravity(GRAVITY);
    let couplings = Couplings::of(&scene, [Coupling::new(2, 1).ratio(-0.5)])?;
    let start = couplings.joined(scene.with_rates(scene.motion(), &[2.0, 0.0])?);
    let found = scene.simulation(MoreauJean::step(5e-4)).loads(&couplings).run(start, 9.0, |_| ())?.motion;
    let [leader, follower] = found.coordinates()[..] else { unreachable!() };
    near(follower, -0.5 * leader, 1e-3);
    assert!(found.rates().iter().all(|rate| rate.abs() < 1e-12), "{:?}", found.rates());
    Ok(())
}

/// A robot from its description, whose joints have the friction written there, held by springs and dampers on four feet.
#[test]
fn a_quadruped_comes_to_stand_with_joints_that_stick() -> Result<(), Error> {
    use catena::robot::{Contact, Contacts, Plane};
    use catena_robots::sticking_quadruped::{self as quadruped, frame::*};
    const STANCE: [f64; 12] = [0.0, 0.7, -1.4, 0.0, 0.7, -1.4, 0.0, 0.7, -1.4, 0.0, -0.7, -1.4];
    let scene = quadruped::scene::<f64>()?;
    let feet = [LF_FOOT, RF_FOOT, LH_FOOT, RH_FOOT].map(|foot| (foot.body.unwrap_or(usize::MAX), foot.place));
    let ground = Contacts::of(feet, Plane::level(0.0), Contact::new(1e5, 2e-4).damped(1.0).rubbing(0.8, 1e-4));
    let mut now = scene.motion();
    let list: Vec<f64> = [0.0, 0.0, 0.45, 1.0, 0.0, 0.0, 0.0].into_iter().chain(STANCE).collect();
    now.set_coordinates(&list)?;
    let (mut next, mut stepper) = (now, scene.stepper(MoreauJean));
    for _ in 0..2000 {
        let (q, v) = (now.coordinates(), now.rates());
        let torques = core::array::from_fn(|k| -300.0 * (q[7 + k] - STANCE[k]) - 6.0 * v[6 + k]);
        let loads = spatial::Loads::none().on_bodies_by(ground).efforts(quadruped::efforts(torques));
        stepper.step(&now, &loads, 2e-3, &mut next)?;
        core::mem::swap(&mut now, &mut next);
    }
    let stuck = now.rates()[6..].iter().filter(|rate| **rate == 0.0).count();
    let bodies = scene.body_motions(&now)?;
    let weight: f64 = 9.81 * bodies.iter().map(|body| body.inertia.mass).sum::<f64>();
    let pushed: f64 = (0..4).map(|k| bodies.get(feet[k].0).map_or(f64::NAN, |body| ground.force(k, body)[2])).sum();
    println!("{stuck} of 12 joints stick; the ground pushes with {} of the weight", pushed / weight);
    println!("{:.3} sweeps a step; trunk at {:.4} m", stepper.sweeps() as f64 / 2000.0, now.coordinates()[2]);
    // Feet creep, by 1e-4 m/s at most, and with them what does not stick.
    let fastest = now.rates()[6..].iter().fold(0.0_f64, |most, rate| most.max(rate.abs()));
    assert!(stuck > 0 && fastest < 1e-3, "{fastest}");
    near(pushed / weight, 1.0, 1e-6);
    Ok(())
}

#[test]
fn what_makes_no_step_is_refused() -> Result<(), Error> {
    let body = RigidBody::new(Jet::<f64, 1>::seed(1.0, 0), Jet::of(0.1), [Jet::of(0.0); 2], [Jet::of(0.0); 2]);
    let stop = HardStops::between(Slider::along(Jet::of(0.0)), [Jet::of(-1.0), Jet::of(1.0)]);
    let scene = System::new(Clamped::origin(), (stop, body), Free)?;
    let (start, mut next) = (scene.motion(), scene.motion());
    let refused = scene.stepper(MoreauJean).step(&start, &Unloaded, 0.1, &mut next).expect_err("derivatives");
    assert!(matches!(refused.fault, Fault::Unsupported { what } if what.contains("derivatives")));
    let rod = Rod::uniform(0.5, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(GRAVITY);
    let rule = catena::time::Rule { method: MoreauJean, control: catena::time::Control::Tolerance(1e-6) };
    let refused = scene.simulation(rule).run(scene.motion(), 1.0, |_| ()).expect_err("a tolerance").error.fault;
    assert!(matches!(refused, Fault::Unsupported { what } if what.contains("estimate")));
    let (start, mut next) = (scene.motion(), scene.motion());
    for dt in [0.0, -1.0, f64::NAN] {
        let refused = scene.stepper(MoreauJean).step(&start, &Unloaded, dt, &mut next).expect_err("a size");
        assert!(matches!(refused.fault, Fault::NotPositive { .. }));
    }
    Ok(())
}
