//! Mechanisms with dry friction in more joints than they have freedoms: what rests, when it breaks away, what friction takes, derivatives.

use catena::planar::*;
use catena::scalar::{Jet, Scalar};
use catena_oracle::{Noise, near};

type Ends = Result<(), Box<dyn std::error::Error>>;

/// A parallelogram of links of 0.4 m whose crank is driven by a torque that grows: it breaks away where that is what all four pins hold, and
/// then turns as one inertia.
#[test]
fn a_parallelogram_breaks_away_from_the_friction_of_all_its_pins() -> Ends {
    const LENGTH: f64 = 0.4; // of crank and rocker (m)
    const GROWTH: f64 = 3.0; // of the torque (N·m/s)
    let limits = [0.5, 0.2, 0.7]; // (N·m)
    let pin = |k: usize| Coulomb::new(Revolute::smooth(), limits[k]);
    let (crank, coupler, rocker) = (Rod::uniform(LENGTH, 1.0), Rod::uniform(1.1, 2.0), Rod::uniform(LENGTH, 0.5));
    let main = (pin(0).named("crank"), crank, pin(1), coupler);
    let side = (RigidBody::massless([1.1, 0.0]), pin(2), rocker);
    let scene = System::new(Clamped::origin(), Network::new(main, side, Pin), Free)?;
    let start = scene.at_rest(&[1.0, 0.0, 1.0])?;
    let loads = Loads::none()
        .in_joints(|time: f64, joint: usize, _: &JointMotion<f64>| if joint == 1 { GROWTH * time } else { 0.0 });
    let inertia = LENGTH * LENGTH * (1.0 / 3.0 + 2.0 + 0.5 / 3.0);
    let breaks = limits.iter().sum::<f64>() / GROWTH;
    macro_rules! goes {
        ($rule:expr, $small:expr) => {{
            for end in [0.9 * breaks, breaks + 0.4] {
                let run = scene.simulation($rule).loads(&loads).run(start, end, |_| ())?;
                let slip = (end - breaks).max(0.0);
                let turned = GROWTH * slip.powi(3) / (6.0 * inertia);
                let found = run.motion.coordinates();
                println!("{}: {} steps, {found:?}, {turned}", stringify!($rule), run.steps);
                for (found, expected) in found.iter().zip([1.0 + turned, -1.0 - turned, 1.0 + turned]) {
                    near(*found, expected, $small);
                }
            }
        }};
    }
    goes!(Dop853::tolerance(1e-11), 1e-10);
    goes!(Rk4::step(1e-3), 1e-10);
    goes!(Vcabm::new().tolerance(1e-10), 1e-8);
    goes!(Sdirk4::new().tolerance(1e-9), 1e-7);
    goes!(MoreauJean::step(1e-4), 1e-3);
    Ok(())
}

/// A four-bar with friction in all its pins but the one that closes it: where it comes to rest, and what friction took until then.
#[test]
fn a_mechanism_with_friction_in_its_pins_comes_to_rest() -> Ends {
    for friction in [0.4, 0.6, 1.0, 20.0] {
        let (bar, pin) = (|length: f64| Rod::uniform(length, length), Coulomb::new(Revolute::smooth(), friction));
        let side = (RigidBody::massless([1.0, 0.0]), pin, bar(0.9));
        let scene = System::new(Clamped::origin(), Network::new((pin, bar(0.5), pin, bar(1.2)), side, Pin), Free)?;
        let scene = scene.with_gravity(9.81);
        let start = scene.assembled(scene.at_rest(&[1.0, 0.3, 1.2])?, &Unloaded)?;
        macro_rules! rests {
            ($rule:expr, $small:expr, $rises:expr) => {{
                let (mut ways, mut last, mut energies) = (0.0, start.coordinates(), vec![]);
                let run = scene.simulation($rule).run(start, 5.0, |now| {
                    let next = now.motion().coordinates();
                    ways += last.iter().zip(&next).map(|(a, b)| (a - b).abs()).sum::<f64>();
                    last = next;
                    energies.push(now.energy());
                })?;
                let lost = energies[0] - energies[energies.len() - 1];
                println!("{friction}, {}: {} steps, lost {lost}, {}", stringify!($rule), run.steps, friction * ways);
                near(lost, friction * ways, $small);
                let rise = energies.windows(2).fold(0.0_f64, |most, pair| most.max(pair[1] - pair[0]));
                assert!(rise < $rises, "{rise}");
                assert!(run.motion.rates().iter().all(|rate| rate.abs() < 1e-12));
                run.motion.coordinates()
            }};
        }
        let exact = rests!(Dop853::tolerance(1e-11), 1e-7, 1e-9);
        for (found, small) in [
            (rests!(Rk4::step(2e-3), 1e-6, 1e-9), 1e-6),
            (rests!(Sdirk4::new().step(4e-3), 1e-4, 1e-9), 1e-5),
            (rests!(Vcabm::new().tolerance(1e-10), 1e-5, 1e-9), 1e-6),
            // Of order one: a step errs by more, and where it comes to rest friction is that of joints that still creep.
            (rests!(MoreauJean::step(5e-4), 0.1, 1e-7), 1e-2),
        ] {
            found.iter().zip(&exact).for_each(|(found, exact)| near(*found, *exact, small));
        }
    }
    Ok(())
}

/// Chains whose tips are held, of one to four freedoms, with friction in all joints but one, stops in some: they come to rest, and lose energy
/// until they do.
#[test]
fn random_mechanisms_come_to_rest() -> Ends {
    let mut random = Noise::new(20);
    for case in 0..40 {
        let mut next = || {
            let friction = Coulomb::new(Revolute::smooth(), random.between(0.05, 0.6));
            (friction, Rod::uniform(random.between(0.3, 0.5), random.between(0.3, 1.0)))
        };
        let links = [next(), next(), next(), next()];
        let stops = Coulomb::new(Revolute::smooth(), 0.2).between([-2.5, 2.5]).rebounding(0.3);
        let last = (stops, Rod::uniform(0.4, 0.5));
        let scene = System::new(Clamped::origin(), (links, last), Pinned::at(random.between(0.5, 1.2), 0.3))?;
        let scene = scene.with_gravity(9.81);
        let guess = scene.at_rest(&[1.2, -0.6, -0.7, -0.5, -0.4])?;
        let start = scene.assembled(guess, &Unloaded)?;
        let (mut last, mut rise) = (f64::INFINITY, 0.0_f64);
        let run = scene.simulation(Dop853::tolerance(1e-8)).run(start, 12.0, |now| {
            rise = rise.max(now.energy() - last);
            last = now.energy();
        });
        let run = run.map_err(|end| format!("case {case}: {end}"))?;
        assert!(run.motion.rates().iter().all(|rate| rate.abs() < 1e-10), "case {case}: {:?}", run.motion.rates());
        assert!(rise < 1e-7, "case {case}: {rise}");
    }
    Ok(())
}

/// Where a mechanism comes to rest, by the friction of its pins and by gravity: against differences.
#[test]
fn where_a_mechanism_rests_has_derivatives() -> Ends {
    fn rests<T: Scalar<Real = f64>>(
        [friction, gravity]: [T; 2],
        time: f64,
    ) -> Result<Vec<T>, Box<dyn std::error::Error>> {
        let (bar, pin) = (
            |length: f64| Rod::uniform(T::constant(length), T::constant(length)),
            Coulomb::new(Revolute::smooth(), friction),
        );
        let side = (RigidBody::massless([T::one(), T::zero()]), pin, bar(0.9));
        let scene = System::new(Clamped::origin(), Network::new((pin, bar(0.5), pin, bar(1.2)), side, Pin), Free)?;
        let scene = scene.with_gravity(gravity);
        let start = scene.assembled(scene.at_rest(&[1.0, 0.3, 1.2].map(T::constant))?, &Unloaded)?;
        Ok(scene.simulation(Dop853::tolerance(1e-12)).run(start, time, |_| ())?.motion.coordinates())
    }
    for friction in [0.3, 0.4, 1.0] {
        for time in [0.5, 5.0] {
            let jets = rests([Jet::<f64, 2>::seed(friction, 0), Jet::seed(9.81, 1)], time)?;
            for k in 0..2 {
                let h = 1e-5;
                let at = |by: f64| {
                    let mut numbers = [friction, 9.81];
                    numbers[k] += by;
                    rests(numbers, time)
                };
                let (more, less) = (at(h)?, at(-h)?);
                for ((jet, more), less) in jets.iter().zip(&more).zip(&less) {
                    let slope = (more - less) / (2.0 * h);
                    println!("{friction}, {time} s, {k}: {} {slope}", jet.eps[k]);
                    near(jet.eps[k], slope, 1e-5 * (1.0 + slope.abs()));
                }
            }
        }
    }
    Ok(())
}

/// Gears between two shafts that rub, of which the first is driven to and fro: they break away where that overcomes both, and turn as one.
#[test]
fn gears_break_away_from_the_friction_of_both_shafts() -> Ends {
    const RATIO: f64 = -2.0;
    let (inertia, limits, amplitude) = (0.2, [0.3, 0.2], 1.5);
    let shaft = |k: usize| Coulomb::new(Revolute::smooth(), limits[k]);
    let wheel = RigidBody::new(1.0, inertia, [0.0; 2], [0.0; 2]);
    let shafts = (Branch((shaft(0).named("in"), wheel)), Branch((shaft(1).named("out"), wheel)));
    let scene = System::new(Clamped::origin(), shafts, Free)?;
    let gears = Couplings::of(&scene, [Coupling::new("out", "in").ratio(RATIO)])?;
    let torque = Loads::none().in_joints(
        move |time: f64, joint: usize, _: &JointMotion<f64>| {
            if joint == 1 { amplitude * (2.0 * time).sin() } else { 0.0 }
        },
    );
    let loads = gears.and(torque);
    // Both bear f = 0.3 + 2 · 0.2: I φ'' = a sin 2 t − f from where that is zero.
    let (whole, held) = (inertia * (1.0 + RATIO * RATIO), limits[0] + RATIO.abs() * limits[1]);
    let begins = 0.5 * (held / amplitude).asin();
    let place = |end: f64| {
        let t = end - begins;
        let [from, to] = [begins, end].map(|time| 2.0 * time);
        (amplitude * (0.5 * from.cos() * t - 0.25 * (to.sin() - from.sin())) - 0.5 * held * t * t) / whole
    };
    macro_rules! turns {
        ($rule:expr, $small:expr) => {
            for end in [0.9 * begins, 1.0] {
                let run = scene.simulation($rule).loads(&loads).run(scene.motion(), end, |_| ())?;
                let (found, exact) = (run.motion.coordinates(), if end < begins { 0.0 } else { place(end) });
                println!("{}: {} steps, {found:?}, {exact}", stringify!($rule), run.steps);
                near(found[0], exact, $small);
                near(found[1], RATIO * exact, 2.0 * $small);
            }
        };
    }
    turns!(Dop853::tolerance(1e-10), 1e-9);
    turns!(Rk4::step(0.02), 1e-6);
    turns!(Rk4::step(0.012), 1e-6);
    turns!(Sdirk4::new().step(0.015), 1e-6);
    turns!(GeneralizedAlpha::new(0.8).step(0.017), 1e-3);
    turns!(MoreauJean::step(1e-3), 3e-3);
    Ok(())
}

/// Four-bars and slider-cranks with friction in three joints, at rest, and then driven to and fro: they break away and come to rest many times, and two
/// rules agree on where they go.
#[test]
fn random_mechanisms_break_away() -> Ends {
    let mut random = Noise::new(7);
    // What tolerances of 1e-8 have grown to where cranks have turned many times: up to 1e-5 where looked at. Other modes would end elsewhere altogether.
    let close = |one: &[f64], other: &[f64], case: usize| {
        let size = one.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
        for (a, b) in one.iter().zip(other) {
            assert!((a - b).abs() < 1e-3 * size, "case {case}: {one:?} {other:?}");
        }
    };
    for case in 0..24 {
        let mut between = |low: f64, high: f64| random.between(low, high);
        let (amplitude, frequency) = (between(0.2, 2.0), between(1.0, 5.0));
        let loads = Loads::none().in_joints(
            move |time: f64, joint: usize, _: &JointMotion<f64>| {
                if joint == 1 { amplitude * (frequency * time).sin() } else { 0.0 }
            },
        );
        macro_rules! agree {
            ($scene:expr, $start:expr) => {{
                let (scene, start) = ($scene, $start);
                let end = 2.5;
                let one = scene.simulation(Dop853::tolerance(1e-9)).loads(&loads).run(start, end, |_| ());
                let other = scene.simulation(Vcabm::new().tolerance(1e-8)).loads(&loads).run(start, end, |_| ());
                let coarse = scene.simulation(Rk4::step(2e-3)).loads(&loads).run(start, end, |_| ());
                let one = one.map_err(|stopped| format!("case {case}: {stopped}"))?.motion.coordinates();
                close(&one, &other.map_err(|stopped| format!("case {case}: {stopped}"))?.motion.coordinates(), case);
                coarse.map_err(|stopped| format!("case {case}: {stopped}"))?;
            }};
        }
        let hold = catena::system::Holding::both(&[0]);
        let rubs = Coulomb::new(Revolute::smooth(), between(0.02, 0.3));
        let crank = Coulomb::new(Revolute::smooth(), between(0.02, 0.4));
        if case % 2 == 0 {
            let other = Coulomb::new(Revolute::smooth(), between(0.02, 0.3));
            let side = (RigidBody::massless([0.6, 0.0]), other, Rod::uniform(between(0.45, 0.55), 0.9));
            let main = (crank, Rod::uniform(between(0.15, 0.3), 0.6), rubs, Rod::uniform(between(0.5, 0.7), 1.0));
            let scene = System::new(Clamped::origin(), Network::new(main, side, Pin), Free)?;
            let scene = scene.with_gravity(if case % 4 == 0 { 0.0 } else { 9.81 });
            let mut guess = scene.motion();
            guess.set_coordinates(&[between(0.3, 2.8), -0.9, 1.6])?;
            let Ok(start) = scene.assembled_holding(guess, hold, &Unloaded) else { continue };
            agree!(scene, start.motion);
        } else {
            let (r, l, turn) = (between(0.1, 0.2), between(0.4, 0.6), between(0.3, 2.8));
            let slide = Coulomb::new(Slider::along(0.0), between(0.5, 5.0));
            let piston = RigidBody::new(0.7, 0.01, [0.0; 2], [0.0; 2]);
            let main = (crank, Rod::uniform(r, 0.6), rubs, Rod::uniform(l, 1.0));
            let scene = System::new(Clamped::origin(), Network::new(main, (slide, piston), Pin), Free)?;
            let (mut guess, rod) = (scene.motion(), -(r * turn.sin() / l).asin());
            guess.set_coordinates(&[turn, rod - turn, r * turn.cos() + l * rod.cos()])?;
            agree!(&scene, scene.assembled_holding(guess, hold, &Unloaded)?.motion);
        }
    }
    Ok(())
}

/// Five-bars whose joints all rub, and strike stops, and rest at these, under two torques to and fro: runs go on to their ends.
#[test]
fn mechanisms_of_two_freedoms_that_rub_and_strike_go_on() -> Ends {
    let mut random = Noise::new(31);
    for case in 0..24 {
        let mut between = |low: f64, high: f64| random.between(low, high);
        let (of_first, of_second) = ([between(0.2, 4.0), between(1.0, 5.0)], [between(0.2, 4.0), between(1.0, 5.0)]);
        let loads = Loads::none().in_joints(move |time: f64, joint: usize, _: &JointMotion<f64>| match joint {
            1 => of_first[0] * (of_first[1] * time).sin(),
            2 => of_second[0] * (of_second[1] * time).cos(),
            _ => 0.0,
        });
        let mut link = || {
            let range = [between(-3.0, -2.6), between(2.6, 3.0)];
            let joint =
                Coulomb::new(Revolute::smooth(), between(0.02, 0.5)).between(range).rebounding(between(0.0, 0.6));
            (joint, Rod::uniform(between(0.3, 0.5), between(0.3, 1.0)))
        };
        let links = [link(), link(), link(), link()];
        let tip = Pinned::at(between(0.5, 1.0), between(-0.2, 0.5));
        let scene = System::new(Clamped::origin(), links, tip)?.with_gravity(if case % 2 == 0 { 0.0 } else { 9.81 });
        let start = scene.assembled(scene.at_rest(&[1.2, 0.3, -0.7, -1.0])?, &Unloaded)?;
        macro_rules! goes_on {
            ($rule:expr) => {{
                let run = scene.simulation($rule).loads(&loads).run(start, 3.0, |_| ());
                let end = run.map_err(|stopped| format!("case {case}: {stopped}"))?.motion;
                assert!(end.rates().iter().all(|rate| rate.is_finite()), "case {case}");
            }};
        }
        goes_on!(Dop853::tolerance(1e-8));
        goes_on!(Vcabm::new().tolerance(1e-7));
        goes_on!(MoreauJean::step(1e-3));
    }
    Ok(())
}
