//! Scenes whose motion is known from elsewhere to many digits, and one that is known exactly.

use catena::Error;
use catena::planar::*;
use catena_oracle::near;
use core::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};

const G: f64 = 9.81;

/// The absolute angle of the last link, and the tip, of `n` uniform rods after their release from rest.
fn hanging(n: usize, rod: Rod<f64>, time: f64) -> Result<(f64, [f64; 2]), Error> {
    let chain = System::new(Pinned::origin(), (rod, vec![(Pin, rod); n - 1]), Free)?.with_gravity(G);
    let start = chain.at_rest(&vec![0.0; n])?;
    let run = chain.simulate(start, Dop853::tolerance(1e-14), time, |_| ())?;
    let bodies = chain.body_motions(&run.motion)?;
    let last = bodies.get(n - 1).unwrap();
    Ok((last.angle(), last.outboard().place.into()))
}

#[test]
fn thin_rods_of_one_metre_in_all_swing_to_the_reference() -> Result<(), Error> {
    // All digits of an independent integration at 30 digits; the tolerance of ours is 1e-14 a step, and twenty short
    // rods multiply the errors of a step by a hundred.
    for (n, time, angle, tolerance) in [(2, 2.0, -0.9071302549910606, 1e-12), (20, 0.5, -3.0330002988365, 1e-10)] {
        let share = 1.0 / n as f64;
        let (found, _) = hanging(n, Rod::uniform(share, share), time)?;
        println!("{n} rods: angle {found:.16}, error {:.1e}", found - angle);
        near(found, angle, tolerance);
    }
    Ok(())
}

#[test]
fn rods_of_one_metre_each_have_their_tip_at_the_reference() -> Result<(), Error> {
    let tips = [
        [-0.9999665880719, -0.0081745177171],
        [-1.6621151358161, -1.0414666371932],
        [-1.7235510295121, -2.2995878854140],
        [-1.0012312139627, -3.6079615512700],
    ];
    for (k, tip) in tips.into_iter().enumerate() {
        let (_, found) = hanging(k + 1, Rod::uniform(1.0, 1.0), 1.0)?;
        println!("{} rods: tip {found:.13?}, error {:.1e} {:.1e}", k + 1, found[0] - tip[0], found[1] - tip[1]);
        // 13 decimals are given, and steps of some 1e-14 each leave as much.
        for i in 0..2 {
            near(found[i], tip[i], 1e-12);
        }
    }
    Ok(())
}

/// Where the bob of a pendulum of one metre is, released at rest from (−1, 0): with φ from the vertical and k = sin
/// 45°, sin(φ/2) = −k sn(K − √g t), by the arithmetic-geometric mean and descending amplitudes (Abramowitz and Stegun,
/// 16.4).
fn exact(time: f64) -> [f64; 2] {
    const LEVELS: usize = 6; // means agree to the last bit after five
    let (mut a, mut c) = ([1.0; LEVELS + 1], [FRAC_1_SQRT_2; LEVELS + 1]);
    let mut b = FRAC_1_SQRT_2;
    for i in 1..=LEVELS {
        a[i] = 0.5 * (a[i - 1] + b);
        c[i] = 0.5 * (a[i - 1] - b);
        b = (a[i - 1] * b).sqrt();
    }
    let quarter = FRAC_PI_2 / a[LEVELS];
    let mut amplitude = 2.0_f64.powi(LEVELS as i32) * a[LEVELS] * (quarter - G.sqrt() * time);
    for i in (1..=LEVELS).rev() {
        amplitude = 0.5 * (amplitude + (c[i] / a[i] * amplitude.sin()).asin());
    }
    let half = (-FRAC_1_SQRT_2 * amplitude.sin()).asin();
    [(2.0 * half).sin(), -(2.0 * half).cos()]
}

#[test]
fn a_bob_on_a_massless_link_follows_the_elliptic_functions() -> Result<(), Error> {
    let pendulum = System::new(Pinned::origin(), PointMass::new(1.0, 1.0), Free)?.with_gravity(G);
    let start = pendulum.at_rest(&[PI])?;
    let run = pendulum.simulation(Dop853::tolerance(1e-14)).every(0.5);
    let mut seen = 0;
    run.run(start, 10.0, |now| {
        let bob = now.bodies().get(0).unwrap().outboard().place;
        let exact = exact(now.time());
        // Samples are read between steps, by a polynomial that is ten times less accurate than the steps.
        for i in 0..2 {
            near(bob[i], exact[i], 1e-12);
        }
        // The rows of the table; samples are on time but for rounding.
        let table = match now.time().round() {
            _ if (now.time() - now.time().round()).abs() > 1e-12 => return,
            5.0 => [-0.942305435043757, -0.334754338414001],
            10.0 => [-0.275087462576117, -0.961419205099125],
            _ => return,
        };
        seen += 1;
        for i in 0..2 {
            println!("t = {}: error {:.1e}, of the series {:.1e}", now.time(), bob[i] - table[i], exact[i] - table[i]);
            near(bob[i], table[i], 1e-12);
            // The phase is 31 rad, of which one rounding is 4e-15, and fifteen decimals are given.
            near(exact[i], table[i], 1e-14);
        }
    })?;
    assert_eq!(seen, 2);
    Ok(())
}
