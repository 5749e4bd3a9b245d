//! Loops with every kind of number, and their derivatives against differences.

use catena::loading::Unloaded;
use catena::planar::*;
use catena::{Error, Real, Scalar};
use catena_oracle::near;
use num_dual::Dual64;
use simba::simd::WideF64x4;

const NAMES: [&str; 7] = ["length", "mass", "stiffness", "rest angle", "angle of the stem", "angle of an arm", "rate"];
/// A length of the upper arm, a mass of the lower one, a spring, the start near where it closes: derivatives of a motion that is
/// closed from afar are those of the last corrections.
const AT: [f64; 7] = [0.6, 0.7, 3.0, 0.2, -1.0, -0.2, 0.8];

/// How a scene is stepped.
#[derive(Clone, Copy)]
enum Rules {
    Explicit,
    Alpha,
    Sdirk,
}

/// A stem and three arms that meet, closed by a pin and a weld, a spring in one of them. Two angles at the end, the force of the
/// ground, forces and torque at the weld.
fn outcome<T: Scalar>(
    [length, mass, stiffness, rest, stem, arm, rate]: [T; 7],
    rules: Rules,
    time: f64,
) -> Result<[T; 7], Error> {
    let literal = T::literal;
    let rod = |length: f64| Rod::uniform(literal(length), literal(length));
    let hinge = ElasticHinge::rotary(stiffness).resting_at(rest);
    let upper = (Pin, Rod::uniform(length, literal(0.6)), Pin, rod(0.5));
    let middle = (Pin, rod(0.45), hinge, rod(0.55));
    let lower = (Pin, rod(0.7), Pin, Rod::uniform(literal(0.45), mass), Pin, rod(0.3));
    let net = Network::new(Network::new(upper, middle, Pin), lower, Weld::at(literal(0.4)));
    let scene = System::new(Pinned::origin(), (rod(0.8), net, Pin, rod(0.3)), Free)?.with_gravity(literal(9.81));
    let [a, b, c, d, e, f, g] = [-2.175, -2.1, -0.263, 0.08, -1.89, -2.575, -1.254].map(literal);
    let guess = scene.at_rest(&[stem, arm, a, b, c, d, e, f, g])?;
    let rates = [rate, literal(0.3), -rate, rate, literal(0.1), rate, rate, rate, -rate];
    let start = scene.assembled(scene.with_rates(guess, &rates)?, &Unloaded)?;
    let (step, end) = (T::Real::of(0.005), T::Real::of(time));
    let run = match rules {
        Rules::Explicit => scene.simulate(start, Dop853::step(step), end, |_| ()),
        Rules::Alpha => scene.simulate(start, GeneralizedAlpha::new(0.8).step(step), end, |_| ()),
        Rules::Sdirk => scene.simulate(start, Sdirk4::new().step(step), end, |_| ()),
    };
    let motion = run.map_err(|stop| stop.error)?.motion;
    let (angles, stations) = (scene.angles(&motion)?, scene.stations(&motion, &Unloaded)?);
    let none = T::literal(f64::NAN);
    let (force, weld) = (stations.root().internal.force, stations.get(16).map(|station| station.internal));
    let [first, last] = [0, 3].map(|k| angles.get(k).copied().unwrap_or(none));
    let weld = weld.map_or([none; 3], |internal| [internal.force.x, internal.force.y, internal.torque]);
    Ok([first, last, force.x, force.y, weld[0], weld[1], weld[2]])
}

#[test]
fn duals_differentiate_loops() -> Result<(), Error> {
    for (rules, name) in [(Rules::Explicit, "DOP853"), (Rules::Alpha, "alpha"), (Rules::Sdirk, "SDIRK4")] {
        let mut worst = 0.0_f64;
        for (k, parameter) in NAMES.iter().enumerate() {
            let dual: [Dual64; 7] = core::array::from_fn(|i| Dual64::new(AT[i], if i == k { 1.0 } else { 0.0 }));
            let found = outcome(dual, rules, 0.1)?;
            let h = 1e-3; // rounding 1e-12 / h, differences of order h⁴
            let moved = |by: f64| {
                let at = core::array::from_fn(|i| if i == k { AT[i] + by * h } else { AT[i] });
                outcome::<f64>(at, rules, 0.1)
            };
            let [far_less, less, more, far_more] = [moved(-2.0)?, moved(-1.0)?, moved(1.0)?, moved(2.0)?];
            let mut size = 0.0_f64;
            for (j, found) in found.iter().enumerate() {
                let expected = (8.0 * (more[j] - less[j]) - (far_more[j] - far_less[j])) / (12.0 * h);
                let difference = (found.eps - expected).abs() / (1.0 + expected.abs());
                worst = worst.max(difference);
                size = size.max(expected.abs());
                assert!(difference < 1e-7, "{name}, {}, {j}: {} by {expected}", parameter, found.eps);
            }
            assert!(size > 1e-3, "{} does not matter", parameter);
        }
        println!("{name}: derivatives differ by {worst:.1e} at most");
    }
    Ok(())
}

#[test]
fn lanes_run_loops_side_by_side() -> Result<(), Error> {
    let shift = |lane: usize| core::array::from_fn::<f64, 7, _>(|i| AT[i] * (1.0 + 0.01 * lane as f64));
    let lanes = core::array::from_fn(|i| WideF64x4::from(core::array::from_fn::<f64, 4, _>(|lane| shift(lane)[i])));
    for rules in [Rules::Explicit, Rules::Alpha, Rules::Sdirk] {
        let together = outcome(lanes, rules, 0.1)?;
        for lane in 0..4 {
            for (found, alone) in together.iter().zip(outcome(shift(lane), rules, 0.1)?) {
                // Corrections go on until the worst lane is closed: lanes differ in their last digits.
                near(found.into_arr()[lane], alone, 1e-10 * (1.0 + alone.abs()));
            }
        }
    }
    Ok(())
}

#[test]
fn single_precision_runs_loops() -> Result<(), Error> {
    for rules in [Rules::Explicit, Rules::Alpha, Rules::Sdirk] {
        let single = outcome(AT.map(|x| x as f32), rules, 0.1)?;
        for (found, exact) in single.into_iter().zip(outcome(AT, rules, 0.1)?) {
            near(f64::from(found), exact, 1e-3 * (1.0 + exact.abs()));
        }
    }
    Ok(())
}

/// A scene lifted to another number is the scene built from it.
#[test]
fn networks_are_lifted() -> Result<(), Error> {
    let rod = |length| Rod::uniform(length, length);
    let net =
        Network::new((Pin, rod(0.6_f64), Pin, rod(0.5)), (Pin, rod(0.7), Pin, rod(0.45), Pin, rod(0.3)), Weld::at(0.4));
    let scene = System::new(Pinned::origin(), (rod(0.8), net), Free)?.with_gravity(9.81);
    let guess = [-1.0, -0.5, -2.1, 0.2, -2.5, -2.3];
    let exact = scene.assembled(scene.at_rest(&guess)?, &Unloaded)?;
    let single = scene.lift(|x| x as f32);
    let motion = single.assembled(single.at_rest(&guess.map(|x| x as f32))?, &Unloaded)?;
    let (found, expected) = (single.angles(&motion)?, scene.angles(&exact)?);
    for (found, expected) in found.iter().zip(expected.iter()) {
        near(f64::from(*found), *expected, 1e-5);
    }
    let lift = catena::Lift::<f64, Dual64>::lift;
    let dual = lift(exact.position(), &mut |x| Dual64::new(x, 1.0));
    let mut count = 0;
    catena::system::Position::visit(&dual, &mut |x: Dual64| count += usize::from(x.eps == 1.0));
    assert_eq!(count, 6);
    Ok(())
}
