//! Closed loops in space: one mechanism, cut in different places. Accelerations of loops at random are compared in `loops_at_random`.

use catena::loading::Unloaded;
use catena::spatial::{self, *};
use catena::system::Element;
use catena::system::MotionOf;
use catena::system::{Root, Tip};
use catena::{Error, Fault, Place};
use catena_oracle::near;
use nalgebra::Vector3;

/// Place of the rocker's hinge (m), its axis, and lengths (m).
const FAR: [f64; 3] = [0.7, 0.1, 0.3];
const AXIS: [f64; 3] = [0.3, 1.0, 0.2];
const CRANK: f64 = 0.3;
const ROCKER: f64 = 0.8;

fn rod(length: f64) -> Rod<f64> {
    Rod::uniform(length, 0.05, length)
}

/// Angles 1-2-3 of a rod that points from one place to another, and its length.
fn between(from: Vector3<f64>, to: Vector3<f64>) -> ([f64; 3], f64) {
    let d = to - from;
    let length = d.norm();
    ([0.0, -(d.z / length).asin(), d.y.atan2(d.x)], length)
}

/// Where crank and rocker end at these angles.
fn ends(crank: f64, rocker: f64) -> Result<[Vector3<f64>; 2], Error> {
    let chain = System::new(Clamped::origin(), (Revolute::about([0.0, 0.0, 1.0]), rod(CRANK)), Free)?;
    let motion = chain.at_rest(&[crank])?;
    let first = chain.stations(&motion, &Unloaded)?.tip().frame.place;
    let chain = System::new(Clamped::at(FAR, Rotation::identity()), (Revolute::about(AXIS), rod(ROCKER)), Free)?;
    let motion = chain.at_rest(&[rocker])?;
    Ok([first, chain.stations(&motion, &Unloaded)?.tip().frame.place])
}

/// What the linkage does: attitudes of the crank and of the rocker as directions of their x axes, forces at their hinges.
type Reading = [Vector3<f64>; 4];

/// Runs a scene that starts at rest; the numbers are those of the rocker's body and of its hinge's station.
fn run<R, C, P>(
    scene: spatial::System<f64, R, C, P>,
    start: &[f64],
    (body, station): (usize, usize),
) -> Result<Reading, Error>
where
    R: Root<Spatial<f64>>,
    C: Element<Spatial<f64>>,
    P: Tip<Spatial<f64>>,
    MotionOf<Spatial<f64>, R, C, P>: Clone,
    spatial::System<f64, R, C, P>: catena::system::Runs<Unloaded, Spatial<f64>, R, C, P>,
{
    let scene = scene.with_gravity_vector(Vector3::new(0.5, -2.0, -9.0));
    let start = scene.at_rest(start)?;
    let start = scene.assembled(start, &Unloaded)?;
    let energy = scene.budget(&start).unwrap().energy();
    let motion = scene.simulate(start, Dop853::tolerance(1e-12), 1.0, |_| ())?.motion;
    near(scene.budget(&motion).unwrap().energy(), energy, 1e-10);
    let bodies = scene.body_motions(&motion).unwrap();
    let axis = |k: usize| bodies.get(k).map_or(Vector3::zeros(), |body| body.turned([1.0, 0.0, 0.0]));
    let stations = scene.stations(&motion, &Unloaded).unwrap();
    let force = |k: usize| stations.get(k).map_or(Vector3::zeros(), |station| station.internal.force);
    Ok([axis(0), axis(body), force(0), force(station)])
}

#[test]
fn a_linkage_moves_alike_wherever_it_is_cut() -> Result<(), Error> {
    let (crank, rocker) = (0.4, -1.1);
    let [p, q] = ends(crank, rocker)?;
    let ([_, b, c], length) = between(p, q);
    let ([_, back_b, back_c], _) = between(q, p);
    let hinge = || Revolute::about([0.0, 0.0, 1.0]);
    let far = || (RigidBody::massless(FAR), Revolute::about(AXIS));
    let root = Clamped::origin();

    // At the ball between coupler and rocker.
    let main = (hinge(), rod(CRANK), Ball, rod(length));
    let (reach, far_hinge) = far();
    let net = Network::new(main, (reach, far_hinge, rod(ROCKER)), Ball);
    let at_ball = run(System::new(root, net, Free)?, &[crank, 0.0, b, c, rocker], (3, 5))?;

    // At the ball between crank and coupler.
    let net = Network::new((hinge(), rod(CRANK)), (reach, far_hinge, rod(ROCKER), Ball, rod(length)), Ball);
    let at_other = run(System::new(root, net, Free)?, &[crank, rocker, 0.0, back_b, back_c], (2, 3))?;

    // Through the coupler.
    let half = rod(length / 2.0);
    let of = |[a, b, c]: [f64; 3]| Rotation::from_angles([a, b, c]);
    let weld = Weld::at(of([0.0, b, c]).relative_to(&of([0.0, back_b, back_c])));
    let net = Network::new((hinge(), rod(CRANK), Ball, half), (reach, far_hinge, rod(ROCKER), Ball, half), weld);
    let at_middle = run(System::new(root, net, Free)?, &[crank, 0.0, b, c, rocker, 0.0, back_b, back_c], (3, 5))?;

    // At the far hinge: the rocker, from its other end, hangs from the coupler.
    let whole = rod(ROCKER).inertia();
    let back = RigidBody::new(whole.mass, whole.about_centre, [-ROCKER / 2.0, 0.0, 0.0], [-ROCKER, 0.0, 0.0]);
    let net = Network::new((hinge(), rod(CRANK), Ball, rod(length), Ball, back), reach, Revolute::about(AXIS));
    let scale = rocker / Vector3::from(AXIS).norm();
    let [d, e, f] = Rotation::exp(AXIS.map(|x| x * scale)).angles();
    let at_hinge = run(System::new(root, net, Free)?, &[crank, 0.0, b, c, d, e, f], (2, 7))?;

    for (name, other) in [("other ball", at_other), ("coupler", at_middle), ("hinge", at_hinge)] {
        let apart = |k: usize| (at_ball[k] - other[k]).norm();
        println!("{name}: crank {:.1e}, rocker {:.1e}, forces {:.1e} {:.1e} N", apart(0), apart(1), apart(2), apart(3));
        for k in 0..4 {
            assert!(apart(k) < 1e-9, "{name}: {:?} {:?}", at_ball[k], other[k]);
        }
    }
    Ok(())
}

/// The four-bar linkage of `loops`, of revolutes about z in space: four joints of which one would do without three of its closures.
#[test]
fn a_linkage_that_is_held_too_often_moves_as_in_the_plane() -> Result<(), Error> {
    let (hinge, rod) = (Revolute::about([0.0, 0.0, 1.0]), |length| Rod::uniform(length, 1e-3, length));
    let arms = (hinge, rod(0.5), hinge, rod(1.2));
    let net = |closing| Network::new(arms, (RigidBody::massless([1.0, 0.0, 0.0]), hinge, rod(0.9)), closing);
    let scene = System::new(Clamped::origin(), net(LeastNorm(hinge)), Free)?.with_gravity([0.0, -9.81, 0.0]);
    let (a, b, c) = (core::f64::consts::FRAC_PI_3, 0.321105014831, -2.017338833372);
    let start = scene.assembled(scene.at_rest(&[a, b - a, c + core::f64::consts::PI])?, &Unloaded)?;
    // Of the same rods, but for their moments across (a radius of 1 mm adds 2e-7 of them): what the plane finds at t = 0.5.
    let plane = {
        use catena::planar::{Clamped, Network, Pin, RigidBody, Rod, System};
        let rod = |length: f64| {
            let across = length * (3.0 * 1e-6 + length * length) / 12.0;
            Rod::new(length, length, length / 2.0, across)
        };
        let arms = (Pin, rod(0.5), Pin, rod(1.2));
        let net = Network::new(arms, (RigidBody::massless([1.0, 0.0]), Pin, rod(0.9)), Pin);
        let scene = System::new(Clamped::at(0.0, 0.0, 0.0), net, catena::planar::Free)?.with_gravity(9.81);
        let start = scene.assembled(scene.at_rest(&[a, b, c + core::f64::consts::PI])?, &Unloaded)?;
        let motion = scene.simulate(start, Dop853::tolerance(1e-12), 0.5, |_| ())?.motion;
        let angles = scene.angles(&motion)?;
        let force =
            scene.stations(&motion, &Unloaded)?.get(7).map(|station| station.internal.force).unwrap_or_default();
        ([0, 1, 3].map(|k| angles.get(k).copied().unwrap_or_default()), force)
    };
    let motion = scene.simulate(start, Dop853::tolerance(1e-12), 0.5, |_| ())?.motion;
    let bodies = scene.body_motions(&motion)?;
    for (k, angle) in [0, 1, 3].into_iter().zip(plane.0) {
        let axis = bodies.get(k).map(|body| body.turned([1.0, 0.0, 0.0])).unwrap_or_default();
        near(axis.x, angle.cos(), 1e-9);
        near(axis.y, angle.sin(), 1e-9);
        near(axis.z, 0.0, 1e-12);
    }
    let closing = scene.stations(&motion, &Unloaded)?.get(7).map(|station| station.internal);
    let closing = closing.expect("the joint that closes the loop");
    near(closing.force.x, plane.1.x, 1e-8);
    near(closing.force.y, plane.1.y, 1e-8);
    // Of least norm: nothing where nothing is needed.
    near(closing.force.z, 0.0, 1e-10);
    near(closing.torque.norm(), 0.0, 1e-10);
    let mut told = vec![];
    scene.shared_forces(&motion, &Unloaded, |station, name| told.push((station, name)))?;
    let tilt = "tilt of the ends of a loop";
    assert_eq!(told, [(7, "z of the ends of a loop"), (7, tilt), (7, tilt)]);

    Ok(())
}

/// Unless it is asked for, nobody decides how redundant closures share a load.
#[test]
fn redundant_closures_are_named() -> Result<(), Error> {
    let (hinge, rod) = (Revolute::about([0.0, 0.0, 1.0]), Rod::uniform(0.5, 0.02, 0.5));
    let arms = (hinge, rod, hinge, Rod::uniform(1.0, 0.02, 1.0));
    let net = Network::new(arms, (RigidBody::massless([1.0, 0.0, 0.0]), hinge, rod), hinge);
    let scene = System::new(Clamped::origin(), net, Free)?;
    let start = scene.at_rest(&[1.5, -1.5, 1.5])?;
    let error = scene.with_accelerations(start, &Unloaded).unwrap_err();
    assert!(matches!(error.fault, Fault::RedundantClosures { independent: 2, of: 5, .. }), "{error}");
    assert_eq!(error.place, Some(Place::Station(7)));
    Ok(())
}
