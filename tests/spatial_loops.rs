//! Closed loops in space: one mechanism, cut in different places. Accelerations of loops at random are compared in `loops_at_random`.

mod kit;

use catena::Error;
use catena::element::{Element, Unloaded};
use catena::ends::{Root, Tip};
use catena::spatial::{self, *};
use catena::system::MotionOf;
use kit::near;
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
    let first = chain.stations(&motion, &Unloaded).tip().frame.place;
    let chain = System::new(Clamped::at(FAR, Rotation::identity()), (Revolute::about(AXIS), rod(ROCKER)), Free)?;
    let motion = chain.at_rest(&[rocker])?;
    Ok([first, chain.stations(&motion, &Unloaded).tip().frame.place])
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
    let start = scene.with_tip_held(start, &Unloaded)?;
    let energy = scene.budget(&start).energy();
    let motion = scene.simulate(start, Dop853::tolerance(1e-12), 1.0, |_| ())?.motion;
    near(scene.budget(&motion).energy(), energy, 1e-10);
    let bodies = scene.body_motions(&motion);
    let axis = |k: usize| bodies.get(k).map_or(Vector3::zeros(), |body| body.turned([1.0, 0.0, 0.0]));
    let stations = scene.stations(&motion, &Unloaded);
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
