//! Trees: chains that arms leave. Accelerations of trees at random are compared in `trees_at_random`.

use catena::loading::{Loading, Unloaded};
use catena::planar::*;
use catena::simulate::Method;
use catena::system::Element;
use catena::system::Position;
use catena::system::Runs;
use catena::time::Rule;
use catena::{Error, Fault, Place, Scalar};
use catena_oracle::{has_order, near};
use core::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_6};
use num_dual::Dual64;

/// A scene that hangs from the origin.
type Hanging<T, C> = System<T, Pinned<[T; 2]>, C, Free>;
/// A rod, an arm that is a rod on a pin, and another such rod that goes on.
type Y<T> = (Rod<T>, Branch<(Pin, Rod<T>)>, Pin, Rod<T>);

/// Lengths (m) and masses (kg) of the three rods.
fn y<T: Scalar>([first, arm, last]: [[T; 2]; 3]) -> Result<Hanging<T, Y<T>>, Error> {
    let [first, arm, last] = [first, arm, last].map(|[length, mass]| Rod::uniform(length, mass));
    Ok(System::new(Pinned::origin(), (first, Branch((Pin, arm)), Pin, last), Free)?.with_gravity(T::literal(9.81)))
}

const RODS: [[f64; 2]; 3] = [[1.0, 1.0], [0.7, 0.8], [0.5, 0.6]];
const START: [f64; 3] = [-FRAC_PI_3, -FRAC_PI_6, -3.0 * FRAC_PI_2 / 2.0];

/// Time (s), angles (rad) and force of the ground (N): an integration of order 8 at 1e-13 of the equations of all bodies with
/// multipliers, which agrees with another formulation to 2e-11.
const TABLE: [(f64, [f64; 3], [f64; 2]); 5] = [
    (0.25, [-1.210972366541, -0.776052160015, -1.576208990310], [-9.839044932871, 28.646439576462]),
    (0.5, [-1.509224566940, -1.717479275554, -0.580992775814], [-1.670481097781, 28.779960884694]),
    (1.0, [-1.977453273945, -2.380881568883, -2.540627380958], [6.868095947694, 21.737150632422]),
    (1.5, [-1.861931759728, -1.342137683493, -2.235057030268], [7.477080164289, 26.909570495007]),
    (2.0, [-1.117158663104, -1.647557714950, -0.196107593415], [-7.562255601853, 18.156646042664]),
];

#[test]
fn the_y_pendulum_follows_its_table() -> Result<(), Error> {
    let y = y(RODS)?;
    let energy = y.budget(&y.at_rest(&START)?)?.energy();
    for (time, angles, force) in TABLE {
        let motion = y.simulate(y.at_rest(&START)?, Dop853::tolerance(1e-13), time, |_| ())?.motion;
        for (found, expected) in y.angles(&motion)?.iter().zip(angles) {
            near(*found, expected, 1e-9);
        }
        let stations = y.stations(&motion, &Unloaded)?;
        let found = stations.root().internal.force;
        near(found.x, force[0], 1e-9);
        near(found.y, force[1], 1e-9);
        near(y.budget(&motion)?.energy(), energy, 1e-11); // of 19 J
    }
    Ok(())
}

/// Accelerations of the joint coordinates, in the order of the type.
fn accelerations<C: Element<Planar<f64>>>(chain: C, angles: &[f64], rates: &[f64]) -> Result<Vec<f64>, Error>
where
    Hanging<f64, C>: Runs<Unloaded, Planar<f64>, Pinned<[f64; 2]>, C, Free>,
{
    let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
    let motion = scene.with_rates(scene.at_rest(angles)?, rates)?;
    let motion = scene.with_accelerations(motion, &Unloaded)?;
    let mut found = vec![];
    catena::system::Rate::visit(motion.acceleration(), &mut |x: f64| found.push(x));
    Ok(found)
}

#[test]
fn an_arm_where_nothing_follows_is_the_chain_itself() -> Result<(), Error> {
    let (rod, plate) = (Rod::uniform(0.7, 0.8), RigidBody::new(0.9, 0.05, [0.3, 0.1], [0.7, -0.2]));
    let (angles, rates) = ([-0.4, 0.3, -1.2], [0.5, -1.0, 2.0]);
    let chain = accelerations((rod, Pin, plate, Pin, rod), &angles, &rates)?;
    assert_eq!(accelerations((rod, Branch((Pin, plate, Pin, rod))), &angles, &rates)?, chain);
    assert_eq!(accelerations((rod, Pin, plate, Branch((Pin, rod))), &angles, &rates)?, chain);
    assert_eq!(accelerations((rod, Branch((Pin, plate, Branch((Pin, rod))))), &angles, &rates)?, chain);
    Ok(())
}

#[test]
fn arms_may_be_written_in_any_form_and_nest() -> Result<(), Error> {
    let rod = Rod::uniform(0.7, 0.8);
    let arm = Branch((Pin, rod));
    let (angles, rates) = ([-0.4, 0.3, -1.2, 0.8], [0.5, -1.0, 2.0, 0.3]);
    let found = accelerations((rod, arm, arm, Pin, rod), &angles, &rates)?;
    let same = [
        accelerations((rod, [arm; 2], Pin, rod), &angles, &rates)?,
        accelerations((rod, vec![arm; 2], Pin, rod), &angles, &rates)?,
        accelerations((rod, (arm, arm), (Pin, rod)), &angles, &rates)?,
        accelerations((rod, [arm; 3]), &angles, &rates)?,
        accelerations((rod, vec![arm; 3]), &angles, &rates)?,
        // An arm that begins with arms.
        accelerations((rod, Branch((arm, Pin, rod)), arm), &angles, &rates)?,
    ];
    for other in same {
        for (a, b) in found.iter().zip(&other) {
            near(*a, *b, 1e-12); // forces of arms add up in another order
        }
        assert_eq!(other.len(), 4);
    }
    Ok(())
}

#[test]
fn everything_is_numbered_as_it_is_written() -> Result<(), Error> {
    let rod = |length| Rod::uniform(length, 1.0);
    let chain = (rod(1.0), Branch((Pin, rod(2.0), Branch((Pin, rod(3.0))), Pin, rod(4.0))), Pin, rod(5.0));
    let scene = System::new(Pinned::origin(), chain, Free)?;
    let motion = scene.at_rest(&[0.1, 0.2, 0.3, 0.4, 0.5])?;
    assert_eq!((scene.bodies(), scene.joints()), (5, 5));
    assert_eq!(*motion.position(), (0.1, ((), (0.2, (), (0.3, ()), 0.4, ()), 0.5, ())));
    let bodies = scene.body_motions(&motion)?;
    for (k, body) in bodies.iter().enumerate() {
        let length: f64 = body.arm.norm();
        assert_eq!((body.angle(), length.round()), ([0.1, 0.2, 0.3, 0.4, 0.5][k], (k + 1) as f64));
    }
    assert_eq!(scene.angles(&motion)?.body::<4>(), Some(&0.5));
    let stations = scene.stations(&motion, &Unloaded)?;
    let place = |k: usize| stations.get(k).map(|station| station.frame.place);
    let end = |k: usize| bodies.get(k).map(|body| body.outboard().place);
    // The arm and what follows it begin at the end of the first rod, the arm's arm at the end of the second.
    for (station, body) in [(1, 0), (3, 1), (5, 1), (7, 0), (9, 4)] {
        assert_eq!(place(station), end(body), "{station}");
    }
    assert_eq!(stations.elements(), 9);
    assert_eq!(Some(stations.tip().frame.place), end(4));
    Ok(())
}

#[test]
fn forces_of_arms_add_up_where_they_leave() -> Result<(), Error> {
    // At rest, upright: the first rod carries all three.
    let y = y(RODS)?;
    let motion = y.with_accelerations(y.at_rest(&[-FRAC_PI_2; 3])?, &Unloaded)?;
    let stations = y.stations(&motion, &Unloaded)?;
    let force = |k: usize| stations.get(k).map_or(f64::NAN, |station| station.internal.force.y);
    near(stations.root().internal.force.y, 2.4 * 9.81, 1e-13);
    near(force(1), 0.8 * 9.81, 1e-13);
    near(force(3), 0.6 * 9.81, 1e-13);
    Ok(())
}

#[test]
fn bad_arms_are_refused_with_their_station() -> Result<(), Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let refused = |chain: (_, _, _, _)| System::new(Pinned::origin(), chain, Free).map(|_| ());
    let fault = Fault::Negative { parameter: "mass", value: -1.0 };
    let bad = PointMass::new(1.0, -1.0);
    assert_eq!(refused((rod, Branch((Pin, bad)), Pin, rod)), Err(Error::new(fault).at_station(2)));

    // A bob without mass: nothing resists the rotation of its pin, which is station 1.
    let scene = System::new(Pinned::origin(), (rod, Branch((Pin, PointMass::new(1.0, 0.0))), Pin, rod), Free)?;
    let error = scene.with_accelerations(scene.at_rest(&[0.0; 3])?, &Unloaded).unwrap_err();
    assert_eq!((error.fault, error.place), (Fault::SingularJoint, Some(Place::Station(1))));

    // A motion of a scene whose arm is longer.
    let scene = |n: usize| System::new(Pinned::origin(), (rod, Branch(vec![(Pin, rod); n]), Pin, rod), Free);
    let other = scene(3)?.at_rest(&[0.0; 5])?;
    assert_eq!(scene(2)?.with_accelerations(other, &Unloaded).unwrap_err().fault, Fault::Shape);
    Ok(())
}

#[test]
fn views_of_chains_as_products_refuse_arms() -> Result<(), Error> {
    let y = y(RODS)?;
    let motion = y.at_rest(&START)?;
    let expected = Error::new(Fault::Unsupported { what: "a chain that branches" });
    assert_eq!(y.transfer_matrix(&motion, &Unloaded, |_, _| ()).unwrap_err(), expected.at_station(1));
    assert_eq!(y.root_state(&motion, &Unloaded).unwrap_err(), expected.at_station(1));
    let scheme = catena::paper::Scheme::new(GeneralizedAlpha::new(0.8));
    let refused = scheme.start(&y, &motion, &Unloaded, 0.01).err().map(|error| error.fault);
    assert_eq!(refused, Some(expected.fault));
    Ok(())
}

/// First angle (rad), force of the ground (N).
fn reading<C, L, M>(scene: &Hanging<f64, C>, loads: &L, rule: Rule<M, f64>) -> Result<[f64; 3], Error>
where
    C: Element<Planar<f64>>,
    L: Loading<Planar<f64>>,
    M: for<'s> Method<&'s Hanging<f64, C>, L>,
    Hanging<f64, C>: Runs<L, Planar<f64>, Pinned<[f64; 2]>, C, Free>,
{
    let motion = scene.simulation(rule).loads(loads).run(scene.at_rest(&[-FRAC_PI_2; 11])?, 0.8, |_| ())?.motion;
    let force = scene.stations(&motion, loads).unwrap().root().internal.force;
    Ok([*scene.angles(&motion).unwrap().get(0).unwrap_or(&f64::NAN), force.x, force.y])
}

/// A rod with two flexible arms of five pieces each (EI = 1 N·m²), one of them on a pin, shaken out of rest.
#[test]
fn implicit_rules_keep_their_order_with_springs_in_arms() -> Result<(), Error> {
    let rod = Rod::uniform(0.1, 0.1);
    let links = [(ElasticHinge::rotary(10.0), rod); 4];
    let arm = Branch((ElasticHinge::rotary(10.0), rod, links));
    let scene = System::new(Pinned::origin(), (rod, arm, Pin, rod, links), Free)?.with_gravity(9.81);
    let loads = Loads::none().in_joints(
        |time: f64, joint, _: &JointMotion<f64>| {
            if joint == 0 { 2.0 * (-((time - 0.4) / 0.07).powi(2)).exp() } else { 0.0 }
        },
    );
    let exact = reading(&scene, &loads, Dop853::tolerance(1e-13))?;
    let errors = |found: [f64; 3]| ((found[0] - exact[0]).abs(), (found[1] - exact[1]).hypot(found[2] - exact[2]));
    macro_rules! order {
        ($name:literal, $order:literal, $steps:expr, $rule:expr) => {{
            let (mut angles, mut forces) = (vec![], vec![]);
            for h in $steps {
                let (angle, force) = errors(reading(&scene, &loads, $rule.step(h))?);
                angles.push((h, angle));
                forces.push((h, force));
            }
            has_order(concat!($name, ", angle"), $order, 1e-12, &angles);
            has_order(concat!($name, ", force"), $order, 1e-10, &forces);
        }};
    }
    order!("generalised alpha", 2.0, [0.002, 0.001, 0.0005, 0.00025], GeneralizedAlpha::new(0.8));
    order!("SDIRK4", 4.0, [0.005, 0.0025, 0.00125, 0.000625], Sdirk4::new());
    Ok(())
}

/// A four-bar whose coupler carries a pendulum: the forces that hold the rocker pass the arm.
#[test]
fn a_held_tip_stays_where_it_is_beside_an_arm() -> Result<(), Error> {
    let rod = |length| Rod::uniform(length, length);
    let chain = (rod(0.5), Pin, rod(1.2), Branch((Pin, rod(0.4), Pin, rod(0.3))), Pin, rod(0.9));
    let scene = System::new(Pinned::origin(), chain, Pinned::at(1.0, 0.0))?.with_gravity(9.81);
    let guess = scene.at_rest(&[FRAC_PI_3, 0.321105, -0.5, -0.2, -2.017339])?;
    let start = scene.assembled(guess, &Unloaded)?;
    let energy = scene.budget(&start)?.energy();
    let run = scene.simulate(start, Dop853::tolerance(1e-13), 2.0, |_| ())?;
    let stations = scene.stations(&run.motion, &Unloaded)?;
    near(stations.tip().frame.place.x, 1.0, 1e-14);
    near(stations.tip().frame.place.y, 0.0, 1e-14);
    near(scene.budget(&run.motion)?.energy(), energy, 1e-11);
    // The balance at the tip that is carried inward through the arm's station meets the pin of the root.
    near(stations.root().internal.torque, 0.0, 1e-11);
    near(stations.get(1).map_or(f64::NAN, |station| station.internal.torque), 0.0, 1e-11);

    // The same where only an arm follows the last body, which still is the one that is held.
    let chain = (rod(0.5), Pin, rod(1.2), Pin, rod(0.9), Branch((Pin, rod(0.4))));
    let scene = System::new(Pinned::origin(), chain, Pinned::at(1.0, 0.0))?.with_gravity(9.81);
    let start = scene.assembled(scene.at_rest(&[FRAC_PI_3, 0.321105, -2.017339, -0.5])?, &Unloaded)?;
    let (place, energy) = (scene.stations(&start, &Unloaded)?.tip().frame.place, scene.budget(&start)?.energy());
    near(place.x, 1.0, 1e-14);
    let run = scene.simulate(start, Dop853::tolerance(1e-13), 1.0, |_| ())?;
    near(scene.budget(&run.motion)?.energy(), energy, 1e-11);
    Ok(())
}

#[test]
fn duals_differentiate_a_tree() -> Result<(), Error> {
    fn outcome<T: Scalar<Real = f64>>(length: T, mass: T, angle: T) -> Result<[T; 4], Error> {
        let [first, arm, last] = RODS.map(|rod| rod.map(T::literal));
        let y = y([first, [length, arm[1]], [last[0], mass]])?;
        let start = y.at_rest(&[T::literal(START[0]), angle, T::literal(START[2])])?;
        let motion = y.simulate(start, Dop853::step(0.01), 0.5, |_| ()).map_err(|stop| stop.error)?.motion;
        let force = y.stations(&motion, &Unloaded)?.root().internal.force;
        let (first, ((), (arm, ()), _, ())) = *motion.position();
        Ok([first, arm, force.x, force.y])
    }
    const AT: [f64; 3] = [0.7, 0.6, START[1]];
    for k in 0..3 {
        let dual = |i: usize| Dual64::new(AT[i], if i == k { 1.0 } else { 0.0 });
        let found = outcome(dual(0), dual(1), dual(2))?;
        let h = 1e-5; // rounding 1e-13 / h, differences of order h²
        let moved = |by: f64| {
            let [length, mass, angle] = core::array::from_fn(|i| if i == k { AT[i] + by } else { AT[i] });
            outcome(length, mass, angle)
        };
        let (less, more) = (moved(-h)?, moved(h)?);
        for (found, (less, more)) in found.iter().zip(less.iter().zip(more)) {
            let expected = (more - less) / (2.0 * h);
            near(found.eps, expected, 1e-7 * (1.0 + expected.abs()));
        }
    }
    Ok(())
}

#[test]
fn trees_lift_settle_and_vibrate() -> Result<(), Error> {
    let scene = y(RODS)?;
    let single = scene.lift(|x| x as f32);
    let motion = single.with_accelerations(scene.at_rest(&START)?.lift(|x| x as f32), &Unloaded)?;
    let exact = scene.with_accelerations(scene.at_rest(&START)?, &Unloaded)?;
    near(f64::from(motion.acceleration().0), exact.acceleration().0, 1e-4);

    let rest = scene.equilibrium(scene.at_rest(&[-1.5, -1.4, -1.7])?, &Unloaded)?;
    rest.position().visit(&mut |angle: f64| near(angle, -FRAC_PI_2, 1e-13));
    // Two equal arms: one mode in which they swing against each other, as if their station did not move.
    let twins = y([[1.0, 1.0], [0.7, 0.8], [0.7, 0.8]])?;
    let modes = twins.modes(&twins.at_rest(&[-FRAC_PI_2; 3])?, &Unloaded)?;
    let alone = (1.5 * 9.81_f64 / 0.7).sqrt();
    assert!(modes.iter().any(|mode| (mode.frequency() - alone).abs() < 1e-9), "{alone}");
    Ok(())
}
