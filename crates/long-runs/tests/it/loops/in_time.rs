//! Closed loops and networks in time: what is conserved, what stays closed, and orders of rules with projection.

use catena::Error;
use catena::loading::Unloaded;
use catena::planar::*;
use catena::simulate::Method;
use catena::system::Element;
use catena::system::{MotionOf, Runs};
use catena::system::{Root, Tip};
use catena::time::Rule;
use catena_oracle::slope;

type Scene<R, C> = System<f64, R, C, Free>;
type Motion<R, C> = MotionOf<Planar<f64>, R, C, Free>;
type Ground = Clamped<[f64; 2], f64>;

fn rod(length: f64) -> Rod<f64> {
    Rod::uniform(length, length)
}

/// A crank, a coupler and a rocker that begins at the ground.
type Linkage<J> = Network<(Pin, Rod<f64>, J, Rod<f64>), (RigidBody<f64>, Pin, Rod<f64>), Pin>;

fn linkage<J>(joint: J) -> Result<Scene<Ground, Linkage<J>>, Error>
where
    Linkage<J>: Element<Planar<f64>>,
    Scene<Ground, Linkage<J>>: Runs<Unloaded, Planar<f64>, Ground, Linkage<J>, Free>,
{
    let crank = (Pin, rod(0.5), joint, rod(1.2));
    let rocker = (RigidBody::massless([1.0, 0.0]), Pin, rod(0.9));
    Ok(System::new(Clamped::at(0.0, 0.0, 0.0), Network::new(crank, rocker, Pin), Free)?.with_gravity(9.81))
}

/// At rest, closed.
const AT_START: [f64; 3] = [core::f64::consts::FRAC_PI_3, 0.321105014831, 1.124253820218];

/// Two links of one arm.
type Links<J> = (Pin, Rod<f64>, J, Rod<f64>);
/// A rod, from its end three arms that meet, and a rod from there.
type Net<J> = (Rod<f64>, Network<Network<Links<J>, Links<Pin>, Pin>, Links<J>, Pin>, Pin, Rod<f64>);

fn net<J: Copy>(joint: J) -> Net<J> {
    let arm = |a, b| (Pin, rod(a), joint, rod(b));
    let middle = (Pin, rod(0.45), Pin, rod(0.55));
    (rod(0.8), Network::new(Network::new(arm(0.6, 0.5), middle, Pin), arm(0.7, 0.45), Pin), Pin, rod(0.3))
}

/// Angles near which the loops close.
const NEAR: [f64; 8] = [-1.0, -0.5, -2.1, -2.0, -0.6, 0.2, -2.5, -1.5];

#[allow(clippy::type_complexity)] // a scene and its motion
fn hanging<J: Copy>(joint: J) -> Result<(Scene<Pinned<[f64; 2]>, Net<J>>, Motion<Pinned<[f64; 2]>, Net<J>>), Error>
where
    Net<J>: Element<Planar<f64>>,
    Scene<Pinned<[f64; 2]>, Net<J>>: Runs<Unloaded, Planar<f64>, Pinned<[f64; 2]>, Net<J>, Free>,
{
    let scene = System::new(Pinned::origin(), net(joint), Free)?.with_gravity(9.81);
    let mut guess = scene.at_rest(&[0.0; 8])?;
    let mut angles = NEAR.iter().copied();
    // A hinge has the angle relative to the body inboard of it: all near enough to be closed.
    catena::system::Position::replace(guess.position_mut(), &mut |_| angles.next().unwrap_or(0.0));
    let start = scene.assembled(guess, &Unloaded)?;
    Ok((scene, start))
}

/// By how much the ends of loops miss each other in place: stations of the closing joints, and the last bodies of the main arms.
fn open<R, C>(scene: &Scene<R, C>, motion: &Motion<R, C>, loops: &[(usize, usize)]) -> f64
where
    R: Root<Planar<f64>>,
    C: Element<Planar<f64>>,
    Free: Tip<Planar<f64>>,
{
    let (stations, bodies) = (scene.stations(motion, &Unloaded).unwrap(), scene.body_motions(motion).unwrap());
    loops.iter().fold(0.0, |worst: f64, (station, body)| {
        let (Some(side), Some(main)) = (stations.get(*station), bodies.get(*body)) else { return f64::NAN };
        worst.max((side.frame.place - main.inboard.place - main.arm).norm())
    })
}

const OF_LINKAGE: [(usize, usize); 1] = [(7, 1)];
const OF_NET: [(usize, usize); 2] = [(9, 2), (14, 2)];

/// The angles of bodies and the forces at the root and at closing joints.
fn read<R, C>(scene: &Scene<R, C>, motion: &Motion<R, C>, loops: &[(usize, usize)]) -> [Vec<f64>; 2]
where
    R: Root<Planar<f64>>,
    C: Element<Planar<f64>>,
{
    let stations = scene.stations(motion, &Unloaded).unwrap();
    let closing = loops.iter().filter_map(|(station, _)| stations.get(*station));
    let forces = closing.chain([stations.root()]).flat_map(|station| <[f64; 2]>::from(station.internal.force));
    [scene.angles(motion).unwrap().iter().copied().collect(), forces.collect()]
}

fn distance(found: &[Vec<f64>; 2], expected: &[Vec<f64>; 2]) -> [f64; 2] {
    core::array::from_fn(|k| {
        assert_eq!(found[k].len(), expected[k].len());
        found[k].iter().zip(&expected[k]).fold(0.0, |worst: f64, (a, b)| worst.max((a - b).abs()))
    })
}

/// The worst misses of loops after every step of a run, and its change of energy.
fn run<R, C, M>(
    scene: &Scene<R, C>,
    start: &Motion<R, C>,
    loops: &[(usize, usize)],
    rule: Rule<M, f64>,
) -> Result<[f64; 2], Error>
where
    R: Root<Planar<f64>>,
    C: Element<Planar<f64>>,
    M: for<'s> Method<&'s Scene<R, C>, Unloaded>,
    Scene<R, C>: Runs<Unloaded, Planar<f64>, R, C, Free>,
{
    let (mut worst, mut change) = (0.0_f64, 0.0_f64);
    let energy = scene.budget(start).unwrap().energy();
    scene.simulate(start.clone(), rule, 20.0, |now| {
        worst = worst.max(open(scene, now.motion(), loops));
        change = change.max((now.energy() - energy).abs());
    })?;
    Ok([worst, change])
}

#[test]
fn loops_stay_closed_under_every_rule() -> Result<(), Error> {
    let mut worst = 0.0_f64;
    macro_rules! rules {
        ($name:literal, $scene:expr, $start:expr, $loops:expr) => {
            for (rule, outcome) in [
                ("RK4", run($scene, $start, $loops, Rk4::step(2e-3))?),
                ("DOPRI5, fixed", run($scene, $start, $loops, Dopri5::step(2e-3))?),
                ("DOPRI5", run($scene, $start, $loops, Dopri5::tolerance(1e-9))?),
                ("Adams", run($scene, $start, $loops, Adams::step(2e-3))?),
                ("DOP853, fixed", run($scene, $start, $loops, Dop853::step(4e-3))?),
                ("DOP853", run($scene, $start, $loops, Dop853::tolerance(1e-12))?),
                ("generalised-alpha", run($scene, $start, $loops, GeneralizedAlpha::new(0.8).step(2e-3))?),
                ("SDIRK4", run($scene, $start, $loops, Sdirk4::new().step(2e-3))?),
            ] {
                let [miss, energy] = outcome;
                println!("{}, {rule}: loops miss by {miss:.1e} m, energy by {energy:.1e} J", $name);
                worst = worst.max(miss);
                if rule == "DOP853" {
                    assert!(energy < 1e-9, "{energy:.1e}");
                }
            }
        };
    }
    let scene = linkage(Pin)?;
    let start = scene.assembled(scene.at_rest(&AT_START)?, &Unloaded)?;
    rules!("linkage", &scene, &start, &OF_LINKAGE);
    let scene = linkage(ElasticHinge::rotary(5.0))?;
    let start = scene.assembled(scene.at_rest(&AT_START)?, &Unloaded)?;
    rules!("linkage with a spring", &scene, &start, &OF_LINKAGE);
    let (scene, start) = hanging(Pin)?;
    rules!("three arms", &scene, &start, &OF_NET);
    let (scene, start) = hanging(ElasticHinge::rotary(5.0))?;
    rules!("three arms with springs", &scene, &start, &OF_NET);
    assert!(worst < 1e-13, "{worst:.1e}");
    Ok(())
}

/// Samples lie between steps as a rule.
#[test]
fn loops_are_closed_between_steps() -> Result<(), Error> {
    fn worst<M>(name: &str, rule: Rule<M, f64>) -> Result<(), Error>
    where
        M: for<'s> Method<&'s Scene<Pinned<[f64; 2]>, Net<Pin>>, Unloaded>,
    {
        let (scene, start) = hanging(Pin)?;
        let mut worst = 0.0_f64;
        scene
            .simulation(rule)
            .every(0.0137)
            .run(start, 1.0, |now| worst = worst.max(open(&scene, now.motion(), &OF_NET)))?;
        println!("{name}: loops miss by {worst:.1e} m");
        assert!(worst < 1e-13, "{name}: {worst:.1e}"); // as at the ends of steps
        Ok(())
    }
    worst("DOPRI5", Dopri5::step(0.01))?;
    worst("Adams", Adams::step(0.005))?;
    worst("DOP853", Dop853::tolerance(1e-8))?;
    worst("generalised-alpha", GeneralizedAlpha::new(0.8).step(0.005))?;
    worst("SDIRK4", Sdirk4::new().step(0.005))
}

/// Three arms afloat, without gravity.
#[test]
fn momentum_of_networks_is_conserved() -> Result<(), Error> {
    let scene = System::new(Free, net(ElasticHinge::rotary(5.0)), Free)?;
    let mut guess = scene.motion();
    let numbers = |head: [f64; 2]| head.into_iter().chain(NEAR);
    let mut places = numbers([0.3, -0.2]);
    catena::system::Position::replace(guess.position_mut(), &mut |_| places.next().unwrap_or(0.0));
    let rates: Vec<f64> = numbers([0.4, 0.1]).map(|x| 1.3 * x + 0.2).collect();
    let start = scene.assembled(scene.with_rates(guess, &rates)?, &Unloaded)?;
    let first = scene.budget(&start)?;
    assert!(first.momentum.norm() > 0.1 && first.angular_momentum.abs() > 0.1 && first.kinetic > 0.1);
    let mut worst = [0.0_f64; 3];
    scene.simulate(start, Dop853::tolerance(1e-13), 20.0, |now| {
        let budget = now.budget();
        worst[0] = worst[0].max((budget.momentum - first.momentum).norm());
        worst[1] = worst[1].max((budget.angular_momentum - first.angular_momentum).abs());
        worst[2] = worst[2].max((budget.energy() - first.energy()).abs());
    })?;
    println!("momentum {:.1e}, angular momentum {:.1e}, energy {:.1e}", worst[0], worst[1], worst[2]);
    assert!(worst.iter().all(|x| *x < 1e-10), "{worst:?}");
    Ok(())
}

/// Errors in angles and in forces fall at least with the order of a rule: on some linkages the leading term is small.
#[track_caller]
fn at_least(name: &str, order: f64, floors: [f64; 2], points: &[(f64, [f64; 2])]) {
    for (k, (what, floor)) in ["angles", "forces"].into_iter().zip(floors).enumerate() {
        let errors: Vec<_> = points.iter().map(|(h, errors)| (*h, errors[k])).collect();
        let found = slope(&errors);
        println!("{name}, {what}: {:.1e} to {:.1e}, order {found:.2}", errors[0].1, errors[errors.len() - 1].1);
        assert!(errors.len() >= 3 && errors.iter().all(|(_, error)| *error > 10.0 * floor), "{name}: lost in rounding");
        assert!(found > order - 0.25, "{name}, {what}: order {found:.2} instead of {order}");
    }
}

macro_rules! rule {
    (Alpha, $h:expr) => {
        GeneralizedAlpha::new(0.8).step($h)
    };
    (Sdirk4, $h:expr) => {
        Sdirk4::new().step($h)
    };
    ($rule:ident, $h:expr) => {
        $rule::step($h)
    };
}

/// Orders of rules over these times (s), each in these numbers of steps.
macro_rules! orders {
    ($name:literal, $scene:expr, $start:expr, $loops:expr, $floors:expr;
     $($rule:ident, $order:literal, $time:literal, $steps:expr;)+) => {$({
        let (scene, start): (&_, &_) = ($scene, $start);
        let exact = scene.simulate(start.clone(), Dop853::step($time / 1200.0), $time, |_| ())?.motion;
        let exact = read(scene, &exact, $loops);
        let mut points = vec![];
        for steps in $steps {
            let h = $time / f64::from(steps);
            let motion = scene.simulate(start.clone(), rule!($rule, h), $time, |_| ())?.motion;
            points.push((h, distance(&read(scene, &motion, $loops), &exact)));
        }
        at_least(concat!($name, ", ", stringify!($rule)), $order, $floors, &points);
    })+};
}

#[test]
fn rules_keep_their_order_on_a_linkage() -> Result<(), Error> {
    let scene = linkage(Pin)?;
    let start = scene.assembled(scene.at_rest(&AT_START)?, &Unloaded)?;
    orders! {
        "linkage", &scene, &start, &OF_LINKAGE, [1e-14, 5e-13];
        Rk4, 4.0, 0.24, [40_u32, 80, 160];
        Dopri5, 5.0, 0.24, [20_u32, 30, 40];
        Dop853, 8.0, 1.0, [120_u32, 160, 240];
        Alpha, 2.0, 0.24, [120_u32, 240, 480];
        Sdirk4, 4.0, 0.24, [40_u32, 80, 160];
    }
    Ok(())
}

#[test]
fn rules_keep_their_order_on_a_linkage_with_a_spring() -> Result<(), Error> {
    let scene = linkage(ElasticHinge::rotary(1.0))?;
    let start = scene.assembled(scene.at_rest(&AT_START)?, &Unloaded)?;
    orders! {
        "linkage with a spring", &scene, &start, &OF_LINKAGE, [1e-14, 5e-13];
        Rk4, 4.0, 0.24, [40_u32, 80, 160];
        Dopri5, 5.0, 0.24, [20_u32, 40, 80];
        Dop853, 8.0, 1.0, [120_u32, 160, 240];
        Alpha, 2.0, 0.24, [120_u32, 240, 480];
        Sdirk4, 4.0, 0.24, [40_u32, 80, 160];
    }
    Ok(())
}

#[test]
fn rules_keep_their_order_on_three_arms() -> Result<(), Error> {
    let (scene, start) = hanging(Pin)?;
    orders! {
        "three arms", &scene, &start, &OF_NET, [1e-14, 1e-12];
        Rk4, 4.0, 0.24, [40_u32, 80, 160];
        Dopri5, 5.0, 0.6, [240_u32, 480, 960];
        Dop853, 8.0, 0.6, [160_u32, 200, 240];
        Alpha, 2.0, 0.24, [120_u32, 240, 480];
        Sdirk4, 4.0, 0.24, [40_u32, 80, 160];
    }
    Ok(())
}

#[test]
fn rules_keep_their_order_on_three_arms_with_springs() -> Result<(), Error> {
    let (scene, start) = hanging(ElasticHinge::rotary(1.0))?;
    orders! {
        "three arms with springs", &scene, &start, &OF_NET, [1e-14, 1e-12];
        Rk4, 4.0, 0.24, [160_u32, 320, 640];
        Dopri5, 5.0, 0.24, [120_u32, 240, 480];
        Dop853, 8.0, 0.24, [60_u32, 80, 100];
        Alpha, 2.0, 0.24, [240_u32, 480, 960];
        Sdirk4, 4.0, 0.24, [160_u32, 320, 640];
    }
    Ok(())
}
