//! Closed loops and networks in the plane. Accelerations of loops at random are compared in `loops_at_random`.

use catena::Error;
use catena::loading::Unloaded;
use catena::planar::*;
use catena_oracle::near;
use core::f64::consts::{FRAC_PI_3, FRAC_PI_6, PI};

/// Time (s), angles (rad), force of the ground (N): an integration of order 8 at 1e-13 of the equations of all bodies with
/// multipliers, which agrees with another formulation to 2e-11 (with a crank of one coordinate to 5e-11).
type Row<const N: usize> = (f64, [f64; N], [f64; 2]);

const FOUR_BAR: [Row<3>; 5] = [
    (0.25, [0.642899885450, 0.371974374104, -2.184234809797], [-9.029701078803, -6.306329530730]),
    (0.5, [-0.349374591229, 1.103023056185, -1.582878120419], [-5.096345286050, 4.088315081438]),
    (1.0, [-3.590096308564, 0.511477042136, -1.105123747538], [-0.847766680731, 1.899951476051]),
    (1.5, [-3.581264918447, 0.513732601042, -1.101109813606], [-0.646346193936, 1.786774783624]),
    (2.0, [-0.342364504144, 1.096726672754, -1.591680988305], [-5.124790931801, 4.072642240546]),
];
/// Force (N) of the ground on the rocker.
const ON_ROCKER: [[f64; 2]; 5] = [
    [7.817492762157, 16.943805449834],
    [-0.138885899542, 9.455696232755],
    [-3.137126874598, 8.655746488811],
    [-3.099896833792, 8.542394236329],
    [-0.085338624530, 9.599715380709],
];
/// Angles (rad) at the start.
const START: [f64; 3] = [core::f64::consts::FRAC_PI_3, 0.321105014831, -2.017338833372];

const NETWORK: [Row<5>; 4] = [
    (
        0.25,
        [-1.277033067478, -0.790862764780, -1.655715037027, -1.151103250461, -1.206102335816],
        [-30.542272486708, 105.418028720086],
    ),
    (
        0.5,
        [-1.445261097093, -1.243967555270, -2.699760199828, -1.215880364598, -2.427810861233],
        [-2.506564879098, 30.731989118176],
    ),
    (
        1.0,
        [-2.216366003022, -1.459826526347, -2.562310831990, -1.563939535260, -2.272576990841],
        [7.060748748379, 10.303237654743],
    ),
    (
        2.0,
        [-1.263955149935, -0.769814426963, -1.812466841596, -1.572240409451, -0.968022549700],
        [-13.346652854334, 44.056027264111],
    ),
];

/// A four-bar linkage whose rocker begins at the ground.
type FourBar = Network<(Pin, Rod<f64>, Pin, Rod<f64>), (RigidBody<f64>, Pin, Rod<f64>), Pin>;

#[allow(clippy::type_complexity)] // a scene
fn four_bar() -> Result<System<f64, Clamped<[f64; 2], f64>, FourBar, Free>, Error> {
    let rod = |length| Rod::uniform(length, length);
    let crank = (Pin, rod(0.5), Pin, rod(1.2));
    let rocker = (RigidBody::massless([1.0, 0.0]), Pin, rod(0.9));
    Ok(System::new(Clamped::at(0.0, 0.0, 0.0), Network::new(crank, rocker, Pin), Free)?.with_gravity(9.81))
}

#[test]
fn a_four_bar_follows_its_table() -> Result<(), Error> {
    let scene = four_bar()?;
    let start = scene.at_rest(&[START[0], START[1], START[2] + PI])?;
    let start = scene.assembled(start, &Unloaded)?;
    for ((time, angles, force), on_rocker) in FOUR_BAR.into_iter().zip(ON_ROCKER) {
        let motion = scene.simulate(start, Dop853::tolerance(1e-13), time, |_| ())?.motion;
        let found = scene.angles(&motion)?;
        // Bodies: crank, coupler, what reaches from the root to the rocker's pin, rocker.
        let found = [0, 1, 3].map(|k| found.get(k).copied().unwrap_or(f64::NAN));
        let stations = scene.stations(&motion, &Unloaded)?;
        let at = |k| stations.get(k).map_or([f64::NAN; 2], |station| station.internal.force.into());
        println!("{time}: {:?} {:?} {:?}", found, at(0), at(5));
        near(found[0], angles[0], 1e-9);
        near(found[1], angles[1], 1e-9);
        near(found[2], angles[2] + PI, 1e-9);
        for k in 0..2 {
            near(at(0)[k], force[k], 1e-9);
            near(at(5)[k], on_rocker[k], 1e-9);
        }
    }
    Ok(())
}

#[test]
fn a_network_follows_its_table() -> Result<(), Error> {
    let rod = |length| Rod::uniform(length, length);
    let (upper, lower) = ((Pin, rod(0.6), Pin, rod(0.5)), (Pin, rod(0.45), Pin, rod(0.55)));
    let chain = (rod(0.8), Network::new(upper, lower, Pin));
    let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[-FRAC_PI_3, -FRAC_PI_6, -2.094395102393, -1.977311259432, -0.620259990849])?;
    let start = scene.assembled(start, &Unloaded)?;
    for (time, angles, force) in NETWORK {
        let motion = scene.simulate(start, Dop853::tolerance(1e-13), time, |_| ())?.motion;
        println!("{time}: {:?}", scene.angles(&motion)?);
        for (found, expected) in scene.angles(&motion)?.iter().zip(angles) {
            near(*found, expected, 1e-9);
        }
        let stations = scene.stations(&motion, &Unloaded)?;
        let found = stations.root().internal.force;
        near(found.x, force[0], 1e-9);
        near(found.y, force[1], 1e-9);
    }
    Ok(())
}

/// Three parallel cranks carry a platform: any two of them would hold it.
#[test]
fn a_third_crank_shares_the_load_in_the_least_way() -> Result<(), Error> {
    let (crank, half) = (Rod::uniform(1.0, 0.3), Rod::uniform(1.0, 0.5));
    let reach = |x| RigidBody::massless([x, 0.0]);
    // The platform is the main arm's; the second and the third crank meet it at its middle and at its end.
    let inner = Network::new((Pin, crank, Pin, half), (reach(1.0), Pin, crank), Pin);
    let net = Network::new((inner, half), (reach(2.0), Pin, crank), LeastNorm(Pin));
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), net, Free)?.with_gravity(9.81);
    let angle = 1.1_f64;
    let start = scene.with_accelerations(scene.at_rest(&[angle, 0.0, angle, angle])?, &Unloaded)?;
    // By Lagrange: all cranks turn alike, the platform only moves. (3 m_c/3 + m_p) α = −(3 m_c/2 + m_p) g cos θ.
    let expected = -(3.0 * 0.3 / 2.0 + 1.0) * 9.81 * angle.cos() / (0.3 + 1.0);
    let bodies = scene.body_motions(&start)?;
    for k in [0, 3, 6] {
        near(bodies.get(k).map_or(f64::NAN, |body| body.inboard.acceleration.angular), expected, 1e-12);
    }
    // A tension along the third crank does nothing but strain the platform: the least closing force has no part along it.
    let mut told = vec![];
    scene.shared_forces(&start, &Unloaded, |station, name| told.push((station, name)))?;
    assert_eq!(told, [(12, "x of the ends of a loop"), (12, "y of the ends of a loop")]);
    let stations = scene.stations(&start, &Unloaded)?;
    let force = stations.get(12).map(|station| station.internal.force).unwrap_or_default();
    near(force.x * angle.cos() + force.y * angle.sin(), 0.0, 1e-12);
    // It does not stay at rest, and what it does keeps its energy.
    let energy = scene.budget(&start)?.energy();
    let end = scene.simulate(start, Dop853::tolerance(1e-11), 1.0, |_| ())?.motion;
    near(scene.budget(&end)?.energy(), energy, 1e-9);
    Ok(())
}

/// A linkage with a torsion spring rests and swings alike as a loop and as a chain between two pins.
#[test]
fn a_linkage_rests_and_swings_as_a_chain_between_two_pins_does() -> Result<(), Error> {
    let rod = |length| Rod::uniform(length, length);
    let knee = ElasticHinge::rotary(3.0).resting_at(-0.7);
    let chain = System::new(Pinned::origin(), (rod(0.5), knee, rod(1.2), Pin, rod(0.9)), Pinned::at(1.0, 0.0))?;
    let chain = chain.with_gravity(9.81);
    let at_rest = chain.equilibrium(chain.at_rest(&START)?, &Unloaded)?;
    let net = Network::new((Pin, rod(0.5), knee, rod(1.2)), (RigidBody::massless([1.0, 0.0]), Pin, rod(0.9)), Pin);
    let looped = System::new(Clamped::at(0.0, 0.0, 0.0), net, Free)?.with_gravity(9.81);
    let rest = looped.equilibrium(looped.at_rest(&[START[0], START[1], START[2] + PI])?, &Unloaded)?;
    let (one, other) = (chain.angles(&at_rest)?, looped.angles(&rest)?);
    let angle = |of: Option<&f64>| of.copied().unwrap_or(f64::NAN);
    near(angle(one.get(0)), angle(other.get(0)), 1e-12);
    near(angle(one.get(1)), angle(other.get(1)), 1e-12);
    // Rods that point the other way, some turns apart.
    near((angle(one.get(2)) - angle(other.get(3))).cos(), -1.0, 1e-15);
    let (one, other) = (chain.modes(&at_rest, &Unloaded)?, looped.modes(&rest, &Unloaded)?);
    assert_eq!((one.len(), other.len()), (1, 1));
    for (one, other) in one.frequencies().zip(other.frequencies()) {
        println!("{one} {other} rad/s");
        near(other, one, 1e-9 * one);
    }
    Ok(())
}
