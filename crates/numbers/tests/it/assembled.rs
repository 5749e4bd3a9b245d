//! Closed scenes over every kind of number: assembled, and through time by Taylor's series.

use catena::Error;
use catena::loading::Unloaded;
use catena::planar::*;
use catena::scalar::{Jet, Scalar, WideF64x4};
use catena::system::{Holding, Rate};
use catena_oracle::{four_bar, near};
use core::f64::consts::PI;
use num_dual::Dual64;

/// Crank, coupler, rocker, and the distance of their ground pins (m).
const LENGTHS: [f64; 4] = [0.5, 1.2, 0.9, 1.0];
/// The crank: angle (rad) and rate (rad/s).
const CRANK: [f64; 2] = [PI / 3.0, 5.0];

/// A rod of one kilogram a metre.
fn rod<T: Scalar>(length: T) -> Rod<T> {
    Rod::uniform(length, length)
}

/// The slope of a function at zero, by central differences of order four.
fn slope(h: f64, at: impl Fn(f64) -> Result<f64, Error>) -> Result<f64, Error> {
    Ok((8.0 * (at(h)? - at(-h)?) - (at(2.0 * h)? - at(-2.0 * h)?)) / (12.0 * h))
}

/// The angles (rad) and rates (rad/s) of a four-bar linkage whose far end the ground holds, for those of its crank.
fn assembled<T: Scalar>(crank: T, rate: T) -> Result<[Vec<T>; 2], Error> {
    let n = T::literal;
    let [a, b, c, d] = LENGTHS.map(n);
    let chain = (rod(a), Pin, rod(b), Pin, rod(c));
    let scene = System::new(Pinned::origin(), chain, Pinned::at(d, n(0.0)))?.with_gravity(n(9.81));
    let guess = scene.with_rates(scene.at_rest(&[crank, n(0.3), n(-2.0)])?, &[rate, n(0.0), n(0.0)])?;
    let start = scene.assembled_holding(guess, Holding::both(&[0]), &Unloaded)?;
    let mut rates = vec![];
    start.motion.rate().visit(&mut |rate| rates.push(rate));
    Ok([scene.angles(&start.motion)?.iter().copied().collect(), rates])
}

/// From afar corrections are cut short: derivatives of where they lead are those of all of them, by lengths and by the guess.
#[test]
fn derivatives_and_lanes_lead_from_afar() -> Result<(), Error> {
    /// The crank's length 0.3 m and its angle in the guess are more by two numbers.
    fn held<T: Scalar<Real = f64>>([length, angle]: [T; 2], guess: [f64; 3]) -> Result<Vec<T>, Error> {
        let n = T::literal;
        let chain = (rod(n(0.3) + length), Pin, rod(n(0.9)), Pin, rod(n(0.6)));
        let scene = System::new(Pinned::origin(), chain, Pinned::at(n(0.8), n(0.0)))?.with_gravity(n(9.81));
        let [a, b, c] = guess.map(n);
        Ok(scene.assembled(scene.at_rest(&[a + angle, b, c])?, &Unloaded)?.coordinates())
    }
    fn looped<T: Scalar<Real = f64>>([length, angle]: [T; 2], guess: [f64; 3]) -> Result<Vec<T>, Error> {
        let n = T::literal;
        let side = (RigidBody::massless([n(0.8), n(0.0)]), Pin, rod(n(0.6)));
        let net = Network::new((Pin, rod(n(0.3) + length), Pin, rod(n(0.9))), side, Pin);
        let scene = System::new(Clamped::at(n(0.0), n(0.0), n(0.0)), net, Free)?.with_gravity(n(9.81));
        let [a, b, c] = guess.map(n);
        Ok(scene.assembled(scene.at_rest(&[a + angle, b, c])?, &Unloaded)?.coordinates())
    }
    fn with_one_held<T: Scalar<Real = f64>>([length, angle]: [T; 2], guess: [f64; 3]) -> Result<Vec<T>, Error> {
        let n = T::literal;
        let chain = (rod(n(0.3) + length), Pin, rod(n(0.9)), Pin, rod(n(0.6)));
        let scene = System::new(Pinned::origin(), chain, Pinned::at(n(0.8), n(0.0)))?.with_gravity(n(9.81));
        let [a, b, c] = guess.map(n);
        let start = scene.assembled_holding(scene.at_rest(&[a + angle, b, c])?, Holding::both(&[0]), &Unloaded)?;
        Ok(start.motion.coordinates())
    }
    macro_rules! compare {
        ($ends:ident, $($guess:expr),*) => {$({
            let [length, angle] = [Jet::<f64, 2>::seed(0.0, 0), Jet::seed(0.0, 1)];
            let jets = $ends([length, angle], $guess)?;
            for (k, jet) in jets.iter().enumerate() {
                let slopes = [
                    slope(1e-4, |by| Ok($ends([by, 0.0], $guess)?[k]))?,
                    slope(1e-4, |by| Ok($ends([0.0, by], $guess)?[k]))?,
                ];
                println!("{} from {:?}, coordinate {k}: {:?} by {slopes:?}", stringify!($ends), $guess, jet.eps);
                near(jet.eps[0], slopes[0], 1e-7);
                near(jet.eps[1], slopes[1], 1e-7);
            }
            // Each lane goes its own way, if all of them begin as far.
            let by = [0.0, 1e-3, 2e-3, 3e-3];
            let lanes = $ends([WideF64x4::from(by), WideF64x4::literal(0.0)], $guess)?;
            for (lane, by) in by.into_iter().enumerate() {
                let alone = $ends([by, 0.0], $guess)?;
                for (found, alone) in lanes.iter().zip(alone) {
                    near(found.into_arr()[lane], alone, 1e-12);
                }
            }
        })*};
    }
    compare!(held, [1.0, 0.2, -1.5], [0.7, 0.4, -0.9], [1.3, 0.2, -2.6], [1.1, 0.3, -1.8]);
    compare!(looped, [1.0, 0.2, 2.9], [0.7, 0.4, 2.2], [1.0, 0.4, 1.3]);
    compare!(with_one_held, [1.0, 0.2, -1.2], [0.9, 1.2, -0.9]);
    Ok(())
}

/// The rocker's angle by the crank's is the ratio of their rates, and lanes assemble side by side.
#[test]
fn every_number_is_assembled() -> Result<(), Error> {
    let [angles, rates] = assembled(Dual64::new(CRANK[0], 1.0), Dual64::from(CRANK[1]))?;
    let [[_, rocker], [_, of_rocker]] = four_bar(LENGTHS, CRANK);
    near(angles[2].re, rocker, 1e-14);
    near(angles[2].eps, of_rocker / CRANK[1], 1e-13);
    // The rate by the crank's angle, against differences of the closed form.
    let by_angle = slope(1e-4, |by| Ok(four_bar(LENGTHS, [CRANK[0] + by, CRANK[1]])[1][1]))?;
    near(rates[2].eps, by_angle, 1e-9);

    let cranks = [0.9, 1.0, 1.1, 1.2];
    let [angles, _] = assembled(WideF64x4::from(cranks), WideF64x4::literal(CRANK[1]))?;
    for (found, crank) in angles[2].into_arr().into_iter().zip(cranks) {
        near(found, four_bar(LENGTHS, [crank, 0.0])[0][1], 1e-14);
    }
    // Single precision, to its own rounding.
    let [angles, _] = assembled(1.0_f32, 0.0)?;
    near(f64::from(angles[2]), four_bar(LENGTHS, [1.0, 0.0])[0][1], 1e-6);
    Ok(())
}

#[test]
fn derivatives_and_lanes_go_through_loops() -> Result<(), Error> {
    /// Where the linkage is, for a length of its coupler and a crank's angle at the start.
    fn end<T: Scalar<Real = f64>>(coupler: T, angle: T) -> Result<Vec<T>, Error> {
        let n = T::literal;
        let (crank, follower) = ((Pin, rod(n(0.5)), Pin, rod(coupler)), (Pin, rod(n(0.9))));
        let rocker = (RigidBody::massless([n(1.0), n(0.0)]), follower.0, follower.1);
        let net = Network::new(crank, rocker, Pin);
        let scene = System::new(Clamped::at(n(0.0), n(0.0), n(0.0)), net, Free)?.with_gravity(n(9.81));
        let start = scene.assembled(scene.at_rest(&[angle, n(0.32), n(1.12)])?, &Unloaded)?;
        let motion =
            scene.simulate(start, Taylor::<24>::tolerance(1e-13), 0.4, |_| ()).map_err(|stop| stop.error)?.motion;
        let mut all = motion.coordinates();
        all.extend(motion.accelerations());
        Ok(all)
    }
    let (h, plain) = (3e-4, end(1.2, 1.05)?);
    let jets = end(Jet::<f64, 2>::seed(1.2, 0), Jet::seed(1.05, 1))?;
    for (i, jet) in jets.iter().enumerate() {
        near(jet.re, plain[i], 1e-11);
        for (k, [dl, da]) in [[1.0, 0.0], [0.0, 1.0]].into_iter().enumerate() {
            let slope = slope(h, |x| Ok(end(1.2 + x * dl, 1.05 + x * da)?[i]))?;
            near(jet.eps[k] / (1.0 + slope.abs()), slope / (1.0 + slope.abs()), 1e-8);
        }
    }
    let (lengths, angles) = ([1.2, 1.15, 1.25, 1.2], [1.05, 1.05, 1.1, 0.9]);
    let lanes = end(WideF64x4::from(lengths), WideF64x4::from(angles))?;
    for lane in 0..4 {
        for (lanes, one) in lanes.iter().zip(end(lengths[lane], angles[lane])?) {
            near(<[f64; 4]>::from(*lanes)[lane], one, 1e-8);
        }
    }
    Ok(())
}

/// Lanes rest elsewhere each, so that they have no common modes.
#[test]
fn lanes_have_no_modes() -> Result<(), Error> {
    let rod = rod(1.0);
    let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let lanes = pendulum.lift(WideF64x4::literal);
    let rest = lanes.at_rest(&[WideF64x4::literal(-0.5 * PI); 2])?;
    let fault = lanes.modes(&rest, &Unloaded).unwrap_err().fault;
    assert!(matches!(fault, catena::Fault::Unsupported { what } if what.contains("lanes")));
    Ok(())
}
