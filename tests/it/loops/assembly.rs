//! Loops brought to closure, and those that cannot be: what does not hold independently is named.

use catena::loading::Unloaded;
use catena::planar::*;
use catena::system::Element;
use catena::system::Root;
use catena::system::{MotionOf, Runs};
use catena::system::{Position, Rate};
use catena::{Error, Fault, Place};
use core::f64::consts::{FRAC_PI_3, PI};

type Ground = Clamped<[f64; 2], f64>;
type Linkage = Network<(Pin, Rod<f64>, Pin, Rod<f64>), (RigidBody<f64>, Pin, Rod<f64>), Pin>;
/// The station of the pin that closes a linkage, and the number of the last body of its main arm.
const CLOSING: (usize, usize) = (7, 1);

fn rod(length: f64) -> Rod<f64> {
    Rod::uniform(length, length)
}

fn linkage([crank, coupler, rocker, base]: [f64; 4]) -> Result<System<f64, Ground, Linkage, Free>, Error> {
    let main = (Pin, rod(crank), Pin, rod(coupler));
    let side = (RigidBody::massless([base, 0.0]), Pin, rod(rocker));
    Ok(System::new(Clamped::at(0.0, 0.0, 0.0), Network::new(main, side, Pin), Free)?.with_gravity(9.81))
}

const FOUR_BAR: [f64; 4] = [0.5, 1.2, 0.9, 1.0];
/// Angles of crank, coupler and rocker where it is closed.
const CLOSED: [f64; 3] = [FRAC_PI_3, 0.321105014831, PI - 2.017338833372];

/// By how much the ends of a loop miss each other, in place and velocity.
fn miss<R, C>(
    scene: &System<f64, R, C, Free>,
    motion: &MotionOf<Planar<f64>, R, C, Free>,
    (station, body): (usize, usize),
) -> [f64; 2]
where
    R: Root<Planar<f64>>,
    C: Element<Planar<f64>>,
{
    let (stations, bodies) = (scene.stations(motion, &Unloaded).unwrap(), scene.body_motions(motion).unwrap());
    let (Some(side), Some(main)) = (stations.get(station), bodies.get(body)) else { return [f64::NAN; 2] };
    let main = main.outboard();
    [(side.frame.place - main.place).norm(), (side.frame.velocity - main.velocity).norm()]
}

#[test]
fn linkages_close_from_half_a_radian_away() -> Result<(), Error> {
    let scene = linkage(FOUR_BAR)?;
    for signs in 0..27_i32 {
        let off = |k: u32| 0.5 * f64::from(signs / 3_i32.pow(k) % 3 - 1);
        let guess = scene.at_rest(&core::array::from_fn::<_, 3, _>(|k| CLOSED[k] + off(k as u32)))?;
        let guess = scene.with_rates(guess, &[1.0, -0.3, 0.7])?;
        let start = scene.assembled(guess, &Unloaded)?;
        let [place, velocity] = miss(&scene, &start, CLOSING);
        assert!(place < 5e-16 && velocity < 1e-15, "{signs}: {place:.1e} m, {velocity:.1e} m/s");
        // The same branch of the linkage: the coupler above the line of the ground's pins.
        let angles = scene.angles(&start)?;
        assert!(angles.iter().zip([CLOSED[0], CLOSED[1], 0.0, CLOSED[2]]).all(|(a, b)| (a - b).abs() < 1.0));
    }
    // What is closed stays as it is, but for the digits that are not given.
    let start = scene.assembled(scene.at_rest(&CLOSED)?, &Unloaded)?;
    let found: Vec<f64> = scene.angles(&start)?.iter().copied().collect();
    assert!([found[0] - CLOSED[0], found[1] - CLOSED[1], found[3] - CLOSED[2]].iter().all(|x| x.abs() < 1e-11));
    let again = scene.assembled(start, &Unloaded)?;
    assert!(again.position().all(start.position(), &mut |a: f64, b: f64| (a - b).abs() < 1e-15));
    Ok(())
}

/// From anywhere: most guesses lead somewhere, and those that do not say so.
#[test]
fn linkages_close_from_afar_or_say_that_they_do_not() -> Result<(), Error> {
    let scene = linkage(FOUR_BAR)?;
    let (mut closed, mut tried) = (0, 0);
    for a in 0..8 {
        for b in 0..8 {
            for c in 0..8 {
                let guess = scene.at_rest(&[a, b, c].map(|k| 0.1 + 0.785 * f64::from(k)))?;
                tried += 1;
                match scene.assembled(guess, &Unloaded) {
                    Ok(start) => {
                        assert!(miss(&scene, &start, CLOSING)[0] < 2e-15);
                        closed += 1;
                    }
                    Err(error) => assert!(
                        matches!(error.fault, Fault::NotClosed { .. } | Fault::RedundantClosures { .. }),
                        "{error}"
                    ),
                }
            }
        }
    }
    println!("{closed} of {tried} closed");
    assert!(10 * closed > 9 * tried, "{closed} of {tried}");
    Ok(())
}

#[test]
fn loops_that_cannot_close_say_by_how_much_they_miss() -> Result<(), Error> {
    // Rods of 0.5 m and 0.6 m towards one of 0.9 m that stands 3 m away: 1 m is missing.
    let scene = linkage([0.5, 0.6, 0.9, 3.0])?;
    let error = scene.assembled(scene.at_rest(&[0.4, -0.3, 2.9])?, &Unloaded).unwrap_err();
    println!("{error}");
    let Fault::NotClosed { residual } = error.fault else { panic!("{error}") };
    assert!((1.0 - 1e-9..4.2).contains(&residual), "{residual}");
    assert_eq!((error.place, error.time), (Some(Place::Station(CLOSING.0)), Some(0.0)));

    // The same beside a tip that can be held: it is the loop that misses most.
    let main = (Pin, rod(0.5), Pin, rod(0.6));
    let side = (RigidBody::massless([3.0, 0.0]), Pin, rod(0.9));
    let chain = (Branch(Network::new(main, side, Pin)), Pin, rod(0.5), Pin, rod(0.6));
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), chain, Pinned::at(0.8, 0.1))?;
    let error = scene.assembled(scene.at_rest(&[0.4, -0.3, 2.9, 0.7, -0.4])?, &Unloaded).unwrap_err();
    assert!(matches!(error.fault, Fault::NotClosed { residual } if residual > 1.0 - 1e-9), "{error}");
    assert_eq!(error.place, Some(Place::Station(CLOSING.0)));

    // And where it is the tip that is out of reach.
    let main = (Pin, rod(0.5), Pin, rod(0.6));
    let side = (RigidBody::massless([0.5, 0.0]), Pin, rod(0.9));
    let chain = (Branch(Network::new(main, side, Pin)), Pin, rod(0.5), Pin, rod(0.6));
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), chain, Pinned::at(2.8, 0.1))?;
    let error = scene.assembled(scene.at_rest(&[0.9, 0.2, 1.0, 0.7, -0.4])?, &Unloaded).unwrap_err();
    assert!(matches!(error.fault, Fault::NotClosed { residual } if residual > 1.7 - 1e-9), "{error}");
    assert_eq!(error.place, Some(Place::Tip));
    Ok(())
}

/// Tips and loops at once.
#[test]
fn tips_are_held_beyond_loops() -> Result<(), Error> {
    let arm = |a, b| (Pin, rod(a), Pin, rod(b));
    let net = Network::new(Network::new(arm(0.6, 0.5), arm(0.45, 0.55), Pin), arm(0.7, 0.45), Pin);
    let scene = System::new(Pinned::origin(), (rod(0.8), net, Pin, rod(0.5)), Pinned::at(1.3, -0.9))?;
    let scene = scene.with_gravity(9.81);
    let guess = scene.at_rest(&[-1.0, -0.5, -2.1, -2.0, -0.6, 0.2, -2.5, -0.5])?;
    let start = scene.assembled(guess, &Unloaded)?;
    let tip = scene.stations(&start, &Unloaded)?.tip().frame.place;
    assert!((tip.x - 1.3).hypot(tip.y + 0.9) < 1e-15);
    let stations = scene.stations(&start, &Unloaded)?;
    let end = scene.body_motions(&start)?.get(2).map(|body| body.outboard().place);
    for closing in [9, 14] {
        let side = stations.get(closing).map(|station| station.frame.place);
        let (Some(side), Some(end)) = (side, end) else { panic!("no such station") };
        assert!((side - end).norm() < 1e-15, "{closing}");
    }
    Ok(())
}

/// The fault of a scene at rest at these angles. Positions and rates are left as they are.
fn refused<R, C>(scene: System<f64, R, C, Free>, angles: &[f64]) -> Result<Error, Error>
where
    R: Root<Planar<f64>>,
    C: Element<Planar<f64>>,
    System<f64, R, C, Free>: Runs<Unloaded, Planar<f64>, R, C, Free>,
{
    let scene = scene.with_gravity(9.81);
    let start = scene.at_rest(angles)?.at_time(0.25);
    let mut motion = start.clone();
    let mut workspace = catena::system::Dynamics::<Unloaded>::workspace(&scene);
    let error = scene.accelerate(&mut motion, &Unloaded, &mut workspace).expect_err("it is redundant");
    let same = |a, b| a == b;
    assert!(motion.position().all(start.position(), &mut { same }) && motion.time() == 0.25);
    assert!(motion.rate().all(start.rate(), &mut { same }));
    let stopped = scene.simulate(start.clone(), Rk4::step(1e-3), 0.3, |_| ()).expect_err("it does not start");
    assert_eq!(stopped.error, error);
    assert!(stopped.last.position().all(start.position(), &mut { same }) && stopped.last.time() == 0.25);
    println!("{error}");
    Ok(error)
}

#[track_caller]
fn redundant(error: Error, closure: &'static str, (independent, of): (usize, usize), station: usize) {
    assert_eq!(error.fault, Fault::RedundantClosures { closure, independent, of });
    assert_eq!((error.place, error.time), (Some(Place::Station(station)), Some(0.25)));
}

const X: &str = "x of the ends of a loop";
const Y: &str = "y of the ends of a loop";
const ANGLE: &str = "angle of the ends of a loop";

/// A beam on four parallel rods: two of them already make it move in parallel.
#[test]
fn parallel_rods_are_redundant() -> Result<(), Error> {
    let prop = |at| (RigidBody::massless([at, 0.0]), Pin, rod(0.6));
    let ground = Clamped::at(0.0, 0.0, 0.0);
    // The beam in two pieces, a rod at either end.
    let beam = (Network::new((Pin, rod(0.6), Pin, rod(0.4)), prop(0.4), Pin), rod(0.4));
    let three = Network::new(beam, prop(0.8), Pin);
    let error = refused(System::new(ground, three, Free)?, &[1.1, 0.0, 1.1, 1.1])?;
    redundant(error, Y, (1, 2), 12);
    // Rods of which one is not parallel hold as they should, and leave no freedom: that is a structure.
    let askew = (RigidBody::massless([0.7, 0.0]), Pin, rod((0.1_f64 + 0.6 * 1.1_f64.cos()).hypot(0.6 * 1.1_f64.sin())));
    let beam = (Network::new((Pin, rod(0.6), Pin, rod(0.4)), prop(0.4), Pin), rod(0.4));
    let scene = System::new(ground, Network::new(beam, askew, Pin), Free)?;
    let angle = (0.6 * 1.1_f64.sin()).atan2(0.1 + 0.6 * 1.1_f64.cos());
    let start = scene.assembled(scene.at_rest(&[1.1, 0.0, 1.1, angle])?, &Unloaded)?;
    assert!(scene.angles(&start)?.iter().all(|x| x.is_finite()));
    // A fourth one: the same again, further out.
    let beam = (Network::new((Pin, rod(0.6), Pin, rod(0.4)), prop(0.4), Pin), rod(0.4));
    let four = Network::new((Network::new(beam, prop(0.8), Pin), rod(0.3)), prop(1.1), Pin);
    let error = refused(System::new(ground, four, Free)?, &[1.1, 0.0, 1.1, 1.1, 1.1])?;
    assert!(matches!(error.fault, Fault::RedundantClosures { independent: 1, of: 2, .. }), "{error}");
    Ok(())
}

/// A weld holds three coordinates of arms that have only two.
#[test]
fn welds_on_arms_with_too_few_freedoms_are_redundant() -> Result<(), Error> {
    let arms = Network::new((Pin, rod(0.6)), (Pin, rod(0.6)), Weld::at(0.0));
    let error = refused(System::new(Pinned::origin(), (rod(0.5), arms), Free)?, &[0.3, 0.8, 0.8])?;
    assert!(matches!(error.fault, Fault::RedundantClosures { of: 3, independent: 1, .. }), "{error}");
    assert_eq!(error.place, Some(Place::Station(5)));

    let side = (RigidBody::massless([1.0, 0.0]), Pin, rod(0.6));
    let arms = Network::new((Pin, rod(0.6)), side, Weld::at(-1.2));
    let error = refused(System::new(Clamped::at(0.0, 0.0, 0.0), arms, Free)?, &[0.58, PI - 0.62])?;
    assert!(matches!(error.fault, Fault::RedundantClosures { of: 3, independent: 2, .. }), "{error}");
    let Fault::RedundantClosures { closure, .. } = error.fault else { panic!("{error}") };
    assert!([X, Y, ANGLE].contains(&closure));
    assert_eq!(error.place, Some(Place::Station(5)));
    Ok(())
}

/// A linkage that is straight cannot tell where to move.
#[test]
fn straight_linkages_are_singular() -> Result<(), Error> {
    // Crank and coupler reach exactly to the end of the rocker, all along x.
    let scene = linkage([0.5, 1.2, 0.7, 1.0])?;
    redundant(refused(scene, &[0.0, 0.0, 0.0])?, X, (1, 2), CLOSING.0);
    // Along y.
    let main = (Pin, rod(0.5), Pin, rod(1.2));
    let side = (RigidBody::massless([0.0, 1.0]), Pin, rod(0.7));
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), Network::new(main, side, Pin), Free)?;
    redundant(refused(scene, &[PI / 2.0; 3])?, Y, (1, 2), CLOSING.0);
    // A thousandth of a radian beside it.
    let scene = linkage([0.5, 1.2, 0.7, 1.0])?;
    assert!(scene.with_accelerations(scene.at_rest(&[1e-3, -2e-3, 1.5e-3])?, &Unloaded).is_ok());
    Ok(())
}
