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
            ($rule:expr, $small:expr) => {{
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
                assert!(energies.windows(2).all(|pair| pair[1] <= pair[0] + 1e-9));
                assert!(run.motion.rates().iter().all(|rate| rate.abs() < 1e-12));
                run.motion.coordinates()
            }};
        }
        let exact = rests!(Dop853::tolerance(1e-11), 1e-7);
        for (found, small) in [
            (rests!(Rk4::step(2e-3), 1e-6), 1e-6),
            (rests!(Sdirk4::new().step(4e-3), 1e-4), 1e-5),
            (rests!(Vcabm::new().tolerance(1e-10), 1e-5), 1e-6),
            (rests!(MoreauJean::step(5e-4), 0.1), 1e-2),
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
