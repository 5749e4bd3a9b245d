//! Chains whose items are posed as they are condensed, as those of arrays are over lanes, against plain numbers, whose chains are posed before:
//! the same operations, so the same bits.

use catena::Error;
use catena::scalar::WideF64x4;
use catena_oracle::Noise;

/// Coordinates and rates at random, a list for each lane.
fn drawn(seed: u64) -> [Vec<f64>; 4] {
    let mut noise = Noise::new(seed);
    core::array::from_fn(|_| (0..200).map(|_| noise.next()).collect())
}

/// Accelerations at a motion, and where a run by RK4 leads from there: of plain numbers four times, and of four lanes.
macro_rules! compare {
    ($drawn:expr, |$number:ident| $scene:expr $(,)?) => {{
        macro_rules! ends {
            ($literal:expr, $draw:expr) => {{
                let ($number, draw) = ($literal, $draw);
                let scene = $scene;
                let count = scene.motion().rates().len();
                let angles: Vec<_> = (0..count).map(&draw).collect();
                let rates: Vec<_> = (count..2 * count).map(&draw).collect();
                let start = scene.with_rates(scene.at_rest(&angles)?, &rates)?;
                let start = scene.with_accelerations(start, &Unloaded)?;
                let end = scene.simulate(start.clone(), Rk4::step(0.01), 0.1, |_| ())?.motion;
                [start.accelerations(), end.coordinates(), end.rates(), end.accelerations()].concat()
            }};
        }
        let drawn: [Vec<f64>; 4] = $drawn;
        let lanes = ends!(|x: f64| WideF64x4::from([x; 4]), |k: usize| WideF64x4::from(
            [0, 1, 2, 3].map(|lane: usize| drawn[lane][k])
        ));
        for (lane, drawn) in drawn.iter().enumerate() {
            let plain = ends!(|x: f64| x, |k: usize| drawn[k]);
            assert_eq!(plain.len(), lanes.len());
            for (k, (found, expected)) in lanes.iter().zip(&plain).enumerate() {
                let found = found.into_arr()[lane];
                assert_eq!(
                    found.to_bits(),
                    expected.to_bits(),
                    "{found:e} for {expected:e}, number {k} of lane {lane}"
                );
            }
        }
    }};
}

#[test]
fn arrays_of_pins() -> Result<(), Error> {
    use catena::planar::*;
    compare!(drawn(81), |n| {
        // All of other lengths.
        let rod = |k: usize| Rod::uniform(n(0.3 + 0.05 * k as f64), n(0.2));
        let links: [_; 7] = core::array::from_fn(|k| (Pin, rod(k + 1)));
        System::new(Pinned::origin(), (rod(0), links), Free)?.with_gravity(n(9.81))
    });
    Ok(())
}

/// Items that turn anew and items that do not, beside each other and inside.
#[test]
fn arrays_of_everything() -> Result<(), Error> {
    use catena::planar::*;
    compare!(drawn(82), |n| {
        let rod = Rod::uniform(n(0.3), n(0.2));
        let body = RigidBody::new(n(0.4), n(0.01), [n(0.1), n(0.05)], [n(0.3), n(-0.1)]);
        let hinge = ElasticHinge::rotary(n(3.0)).damped(n(0.1));
        let cell = (Pin, rod, hinge, body);
        let chain = (
            rod,
            (hinge, body, Pin, rod),
            [cell; 3],
            Branch([(Pin, rod); 2]),
            [(hinge, rod); 2],
            (hinge, rod, [(Pin, rod, [(hinge, body); 2]); 2]),
            vec![(Pin, body); 2],
        );
        System::new(Pinned::origin(), chain, Free)?.with_gravity(n(9.81))
    },);
    Ok(())
}

/// Corrections of a closed scene read the postures that the sweep has left.
#[test]
fn a_held_tip() -> Result<(), Error> {
    use catena::planar::*;
    macro_rules! scene {
        ($n:ident) => {{
            let rod = Rod::uniform($n(0.5), $n(0.2));
            System::new(Pinned::origin(), (rod, [(Pin, rod); 4]), Pinned::at($n(1.0), $n(0.2)))?.with_gravity($n(9.81))
        }};
    }
    let (plain, mut starts) = (|x: f64| x, drawn(83));
    let scene = scene!(plain);
    for numbers in &mut starts {
        let start = scene.with_rates(scene.at_rest(&numbers[..5])?, &numbers[5..10])?;
        let start = scene.assembled(start, &Unloaded)?;
        *numbers = [start.coordinates(), start.rates()].concat();
    }
    compare!(starts, |n| scene!(n));
    Ok(())
}

#[test]
fn arrays_of_balls() -> Result<(), Error> {
    use catena::spatial::*;
    compare!(drawn(84), |n| {
        let rod = Rod::uniform(n(0.3), n(0.02), n(0.2));
        System::new(Pinned::origin(), (rod, [(Ball, rod); 4], Ball, rod), Free)?.with_gravity([
            n(0.0),
            n(-9.81),
            n(0.0),
        ])
    },);
    Ok(())
}
