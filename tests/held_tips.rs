//! Chains held at both ends.

use catena::Error;
use catena::element::Unloaded;
use catena::planar::*;

/// A crank, a coupler and a rocker between (0, 0) and (1, 0), at rest at first: time, angles, rate of the crank, pivot force,
/// force of the ground on the rocker. An order-8 integration of a multiplier system at 1e-13, which agrees with an independent
/// crank-angle formulation to 5e-11.
const FOUR_BAR: [(f64, [f64; 3], f64, [f64; 2], [f64; 2]); 5] = [
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

#[test]
fn four_bar_meets_the_reference() -> Result<(), Error> {
    let rod = |length| Rod::uniform(length, length);
    let chain = (rod(0.5), Pin, rod(1.2), Pin, rod(0.9));
    let four_bar = System::new(Pinned::origin(), chain, Pinned::at(1.0, 0.0))?.with_gravity(9.81);
    let mut motion = four_bar.at_rest(&[1.047197551197, 0.321105014831, -2.017338833372])?;
    for (time, angles, rate, root, tip) in FOUR_BAR {
        motion = four_bar.simulate(motion, Dop853::tolerance(1e-13), time, |_| ())?.motion;
        let found = four_bar.angles(&motion);
        let stations = four_bar.stations(&motion, &Unloaded);
        let force = stations.root().unwrap().internal.force;
        let end = stations.tip().frame.place;
        println!("{time} closure {:e} {:e}", end.x - 1.0, end.y);
        for k in 0..3 {
            print!("{:e} ", found.get(k).unwrap() - angles[k]);
        }
        println!("{:e}", motion.rate().0 - rate);
        println!(
            "{:e} {:e} | {:e} {:e}",
            force.x - root[0],
            force.y - root[1],
            motion.multipliers()[0] - tip[0],
            motion.multipliers()[1] - tip[1]
        );
    }
    Ok(())
}
