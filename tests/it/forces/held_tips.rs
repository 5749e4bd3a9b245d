//! Chains held at both ends.

mod redundant;
mod scales;

use catena::Error;
use catena::loading::Unloaded;
use catena::planar::*;
use catena_oracle::{has_order, near};

/// Time, angles, rate of the crank, pivot force, force of the ground on the rocker.
type Instant = (f64, [f64; 3], f64, [f64; 2], [f64; 2]);

/// A crank, a coupler and a rocker between (0, 0) and (1, 0), at rest at first: time, angles, rate of the crank, pivot force,
/// force of the ground on the rocker. An order-8 integration of a multiplier system at 1e-13, which agrees with an independent
/// crank-angle formulation to 5e-11.
const FOUR_BAR: [Instant; 5] = [
    (
        0.25,
        [0.642899885450, 0.371974374104, -2.184234809797],
        -4.067278017184,
        [-9.029701078803, -6.306329530730],
        [7.817492762157, 16.943805449834],
    ),
    (
        0.5,
        [-0.349374591229, 1.103023056185, -1.582878120419],
        -2.731049034656,
        [-5.096345286050, 4.088315081438],
        [-0.138885899542, 9.455696232755],
    ),
    (
        1.0,
        [-3.590096308564, 0.511477042136, -1.105123747538],
        -3.405863425829,
        [-0.847766680731, 1.899951476051],
        [-3.137126874598, 8.655746488811],
    ),
    (
        1.5,
        [-3.581264918447, 0.513732601042, -1.101109813606],
        3.459673708958,
        [-0.646346193936, 1.786774783624],
        [-3.099896833792, 8.542394236329],
    ),
    (
        2.0,
        [-0.342364504144, 1.096726672754, -1.591680988305],
        2.718641675613,
        [-5.124790931801, 4.072642240546],
        [-0.085338624530, 9.599715380709],
    ),
];

type FourBar = System<f64, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>, Pin, Rod<f64>), Pinned<[f64; 2]>>;

fn four_bar() -> Result<FourBar, Error> {
    let rod = |length| Rod::uniform(length, length);
    let chain = (rod(0.5), Pin, rod(1.2), Pin, rod(0.9));
    Ok(System::new(Pinned::origin(), chain, Pinned::at(1.0, 0.0))?.with_gravity(9.81))
}

const START: [f64; 3] = [core::f64::consts::FRAC_PI_3, 0.321105014831, -2.017338833372];

#[test]
fn four_bar_meets_the_reference() -> Result<(), Error> {
    let four_bar = four_bar()?;
    let mut motion = four_bar.at_rest(&START)?;
    for (time, angles, rate, root, tip) in FOUR_BAR {
        motion = four_bar.simulate(motion, Dop853::tolerance(1e-13), time, |_| ())?.motion;
        let found = four_bar.angles(&motion)?;
        // The reference has twelve decimals, starts from twelve, and passes a sharp transient at 0.4 s.
        for (found, angle) in found.iter().zip(angles) {
            near(*found, angle, 1e-10);
        }
        near(motion.rate().0, rate, 1e-9);
        let stations = four_bar.stations(&motion, &Unloaded)?;
        let force = stations.root().internal.force;
        for k in 0..2 {
            near(force[k], root[k], 1e-9);
            near(motion.multipliers()[k], tip[k], 1e-9);
        }
    }
    Ok(())
}

#[test]
fn closure_holds_over_twenty_seconds() -> Result<(), Error> {
    let four_bar = four_bar()?;
    // The start is given to twelve digits, so it does not count.
    let mut worst: f64 = 0.0;
    let mut look = |time: f64, place: [f64; 2]| {
        if time > 0.0 {
            worst = worst.max((place[0] - 1.0).abs()).max(place[1].abs());
        }
        worst
    };
    let start = || four_bar.at_rest(&START);
    four_bar.simulate(start()?, Dop853::tolerance(1e-10), 20.0, |now| {
        look(now.time(), now.stations().tip().frame.place.into());
    })?;
    let explicit = look(0.0, [1.0, 0.0]);
    four_bar.simulate(start()?, GeneralizedAlpha::new(0.8).step(0.002), 20.0, |now| {
        look(now.time(), now.stations().tip().frame.place.into());
    })?;
    println!("closure: DOP853 {explicit:.1e}, generalised-alpha {worst:.1e}");
    assert!(explicit < 1e-13 && worst < 1e-13); // round-off of three rods
    Ok(())
}

#[test]
fn projection_keeps_the_order_of_a_rule() -> Result<(), Error> {
    let four_bar = four_bar()?;
    let reference = FOUR_BAR[0];
    let crank = |motion: &_| (four_bar.angles(motion).unwrap().get(0).unwrap() - reference.1[0]).abs();
    let [mut angles, mut forces, mut stiff_angles, mut stiff_forces] = [vec![], vec![], vec![], vec![]];
    for h in [0.01, 0.005, 0.0025] {
        let motion = four_bar.simulate(four_bar.at_rest(&START)?, Rk4::step(h), 0.25, |_| ())?.motion;
        angles.push((h, crank(&motion)));
        forces.push((h, (motion.multipliers()[0] - reference.4[0]).abs()));
        let rule = GeneralizedAlpha::new(0.8).step(h);
        let motion = four_bar.simulate(four_bar.at_rest(&START)?, rule, 0.25, |_| ())?.motion;
        stiff_angles.push((h, crank(&motion)));
        stiff_forces.push((h, (motion.multipliers()[0] - reference.4[0]).abs()));
    }
    has_order("RK4, crank", 4.0, 1e-12, &angles);
    has_order("RK4, closure force", 4.0, 1e-10, &forces);
    has_order("generalised-alpha, crank", 2.0, 1e-12, &stiff_angles);
    has_order("generalised-alpha, closure force", 2.0, 1e-10, &stiff_forces);
    Ok(())
}
