//! Friction, stops and motors: their numbers against plain formulas, the order of rules through them, and energy.

use catena::extend::Implicit;
use catena::{Error, Fault, planar, robot};
use catena_oracle::{Noise, has_order, near};
use planar::{Dop853, DryFriction, GeneralizedAlpha, Motor, Rk4, Sdirk4, Spring, SpringLaw, Stops};

const SLIDING: f64 = 0.4; // (N·m)
const BREAKING: f64 = 0.6; // (N·m)
const SPEED: f64 = 0.5; // (rad/s)
const RANGE: [f64; 2] = [-2.2, 0.3]; // (rad)
const STIFFNESS: f64 = 300.0; // (N·m/rad)
const DEPTH: f64 = 0.3; // (rad)
const DAMPING: f64 = 0.2; // of the stops (s/rad)
const VISCOUS: f64 = 0.05; // (N·m·s/rad)

type Laws = (Spring<planar::Absent, f64>, DryFriction<f64, f64>, Stops<f64, f64>);

fn laws() -> Laws {
    let friction = DryFriction::new(SLIDING, SPEED).breaking_away(BREAKING);
    (Spring::damping(VISCOUS), friction, Stops::between(RANGE, STIFFNESS, DEPTH).damped(DAMPING))
}

/// The friction, by branches and powers.
fn friction(rate: f64) -> f64 {
    let w = rate / (4.0 * SPEED);
    -SLIDING * (rate / SPEED).tanh() - (BREAKING - SLIDING) * w / (0.25 * w * w + 0.75).powi(2)
}

/// How far stops are compressed, as the integral of the slope by Simpson's rule, which is exact for a cubic.
fn compressed(over: f64) -> f64 {
    if over <= 0.0 {
        return 0.0;
    }
    let rise = |x: f64| 3.0 * (x / DEPTH).powi(2) - 2.0 * (x / DEPTH).powi(3);
    let within = over.min(DEPTH);
    within / 6.0 * (4.0 * rise(0.5 * within) + rise(within)) + (over - within)
}

/// The stops, side by side.
fn stops(angle: f64, rate: f64) -> f64 {
    let push = |over: f64, speed: f64| STIFFNESS * compressed(over) * (1.0 + DAMPING * speed).max(0.0);
    push(RANGE[0] - angle, -rate) - push(angle - RANGE[1], rate)
}

fn torque(angle: f64, rate: f64) -> f64 {
    -VISCOUS * rate + friction(rate) + stops(angle, rate)
}

#[test]
fn forces_slopes_and_energies() {
    let (laws, mut noise) = (laws(), Noise::new(5));
    for _ in 0..2000 {
        let (angle, rate) = (noise.between(-3.0, 1.0), noise.between(-8.0, 8.0));
        near(laws.force(angle, rate), torque(angle, rate), 1e-12 * (1.0 + torque(angle, rate).abs()));
        // A force of stored energy is its slope, and slopes of forces are those of the pivot.
        let h = 1e-5;
        let slope = |f: &dyn Fn(f64) -> f64| (f(h) - f(-h)) / (2.0 * h);
        near(-slope(&|x| laws.energy(angle + x)), stops(angle, 0.0), 1e-5);
        let by_angle = -slope(&|x| torque(angle + x, rate));
        // Where the damper just lets go, differences see both sides.
        if (1.0 - DAMPING * rate.abs()).abs() > 1e-4 {
            let by_rate = -slope(&|x| torque(angle, rate + x));
            near(laws.pivot(angle, rate, shares(1.0, 0.0)), by_angle, 2e-5 * (1.0 + by_angle.abs()));
            near(laws.pivot(angle, rate, shares(0.0, 1.0)), by_rate, 2e-5 * (1.0 + by_rate.abs()));
        }
        // Nothing feeds on the rate, and what stops give back is no more than they took.
        assert!(rate * (torque(angle, rate) - stops(angle, 0.0)) <= 1e-12);
    }
    assert_eq!(laws.2.force(-1.0, 3.0), 0.0);
    const { assert!(!<Laws as SpringLaw<f64>>::LINEAR) };
}

/// The steepest fall of the force of breaking away, as the documentation has it.
#[test]
fn friction_falls_by_no_more_than_said() {
    let law = DryFriction::new(SLIDING, SPEED).breaking_away(BREAKING);
    let slope = |rate: f64| law.pivot(0.0, rate, shares(0.0, 1.0));
    let (most, at) = ((BREAKING - SLIDING) / (9.0 * SPEED), 4.0 * 3.0_f64.sqrt() * SPEED);
    near(slope(at), -most, 1e-4 * most);
    (0..2000).for_each(|k| assert!(slope(0.01 * f64::from(k)) > -1.001 * most));
}

/// The paper's schemes have one slope for a whole run, read at its start.
#[test]
fn the_paper_refuses_laws_that_are_not_linear() -> Result<(), Error> {
    use catena::{Place, loading::Unloaded, paper};
    let scheme = paper::Scheme::new(paper::GeneralizedAlpha::new(0.8));
    let refused = Some((Fault::Unsupported { what: "a law that is not linear" }, Some(Place::Station(1))));
    let told = |error: Error| (error.fault, error.place);
    let (rod, stops) = (planar::Rod::uniform(0.5, 1.0), Stops::between(RANGE, STIFFNESS, DEPTH));
    let chain = (rod, planar::ElasticHinge::with(stops), rod);
    let scene = planar::System::new(planar::Pinned::origin(), chain, planar::Free)?;
    let start = scene.motion();
    assert_eq!(scheme.start(&scene, &start, &Unloaded, 0.01).map_err(told).err(), refused);
    let joints = paper::JointScheme::new(paper::GeneralizedAlpha::new(0.8));
    assert_eq!(joints.start(&scene, &start, &Unloaded, 0.01).map_err(told).err(), refused);
    let chain = (rod, planar::ElasticHinge::with(Spring::damping(VISCOUS)), rod);
    let scene = planar::System::new(planar::Pinned::origin(), chain, planar::Free)?;
    assert!(scheme.start(&scene, &scene.motion(), &Unloaded, 0.01).is_ok());
    let rod = catena::spatial::Rod::uniform(0.5, 0.05, 1.0);
    let chain = (rod, catena::spatial::Revolute::about([0.0, 0.0, 1.0]).with(stops), rod);
    let scene = catena::spatial::System::new(catena::spatial::Pinned::origin(), chain, catena::spatial::Free)?;
    assert_eq!(scheme.start(&scene, &scene.motion(), &Unloaded, 0.01).map_err(told).err(), refused);
    Ok(())
}

/// Shares of stiffness and damping in a pivot.
fn shares(position: f64, rate: f64) -> Implicit<f64> {
    Implicit { position, rate }
}

/// The least torque of several limits, by branches.
#[test]
fn motors_give_what_they_can() {
    let motor = Motor::new(2.0, 300.0).stalling_at(3.0).geared(50.0).with_rotor(1e-4);
    let mut noise = Noise::new(6);
    for _ in 0..1000 {
        let (wanted, rate) = (noise.between(-250.0, 250.0), noise.between(-9.0, 9.0));
        let share = 50.0 * rate / 300.0;
        let most = 50.0 * f64::min(2.0, 3.0 * (1.0 - share)).max(0.0);
        let least = -50.0 * f64::min(2.0, 3.0 * (1.0 + share)).max(0.0);
        near(motor.torque(wanted, rate), wanted.clamp(least, most), 1e-12);
        // However much is asked for.
        for huge in [1e18, 1e20, 1e300] {
            near(motor.torque(huge, rate), most, 1e-12);
            near(motor.torque(-huge, rate), least, 1e-12);
        }
    }
    assert_eq!(
        Motor::new(0.0, 1.0).check(),
        Err(Fault::NotPositive { parameter: "peak torque of a motor", value: 0.0 })
    );
    assert_eq!(motor.check(), Ok(()));
}

const LENGTH: f64 = 1.0; // of a uniform rod (m)
const MASS: f64 = 1.0; // (kg)
const GRAVITY: f64 = 9.81; // along −y (m/s²)
const END: f64 = 1.5; // (s)

/// Angle and rate of a rod on a hinge with these laws, released from the horizontal: it swings over to the lower stop and back.
fn truth(steps: usize) -> [f64; 2] {
    let slope = |[a, v]: [f64; 2]| {
        [v, (torque(a, v) - 0.5 * MASS * GRAVITY * LENGTH * a.cos()) * 3.0 / (MASS * LENGTH * LENGTH)]
    };
    let h = END / steps as f64;
    let moved = |s: [f64; 2], k: [f64; 2], h: f64| [s[0] + h * k[0], s[1] + h * k[1]];
    (0..steps).fold([0.0, 0.0], |s, _| {
        let a = slope(s);
        let b = slope(moved(s, a, 0.5 * h));
        let c = slope(moved(s, b, 0.5 * h));
        let d = slope(moved(s, c, h));
        core::array::from_fn(|i| s[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]))
    })
}

type Flat = planar::System<
    f64,
    planar::Clamped<[f64; 2], f64>,
    (planar::ElasticHinge<planar::Custom<Laws>>, planar::Rod<f64>),
    planar::Free,
>;
type Turning =
    robot::System<f64, robot::Base<f64>, (robot::Hinge<f64, robot::Level, 0, Laws>, robot::Link<f64>), robot::Free>;

fn flat() -> Result<Flat, Error> {
    let chain = (planar::ElasticHinge::with(laws()), planar::Rod::uniform(LENGTH, MASS));
    Ok(planar::System::new(planar::Clamped::at(0.0, 0.0, 0.0), chain, planar::Free)?.with_gravity(GRAVITY))
}

fn turning() -> Result<Turning, Error> {
    let across = MASS * LENGTH * LENGTH / 12.0;
    let tensor = [[1e-3, 0.0, 0.0], [0.0, across, 0.0], [0.0, 0.0, across]];
    let chain = (robot::Hinge::level().with(laws()), robot::Link::general(MASS, [0.5 * LENGTH, 0.0, 0.0], tensor));
    Ok(robot::System::new(robot::Base::origin(), chain, robot::Free)?.with_gravity([0.0, -GRAVITY, 0.0]))
}

/// Errors at steps of several sizes.
macro_rules! ladder {
    ($name:literal, $order:literal, $scene:expr, $rule:expr, $counts:expr, $truth:expr) => {{
        let scene = $scene;
        let mut points = vec![];
        for n in $counts {
            let run = scene.simulate(scene.motion(), $rule.step(END / n as f64), END, |_| ())?;
            let (position, mut rate) = (run.motion.coordinates(), vec![]);
            catena::system::Rate::visit(run.motion.rate(), &mut |x: f64| rate.push(x));
            let error = (position[0] - $truth[0]).abs().max((rate[0] - $truth[1]).abs());
            points.push((END / n as f64, error));
        }
        has_order($name, $order, 1e-13, &points);
    }};
}

#[test]
fn rules_keep_their_order_in_the_plane_and_in_body_axes() -> Result<(), Error> {
    let truth = truth(100_000);
    println!("truth: {truth:?}");
    ladder!("RK4, plane", 4.0, flat()?, RK4, [200, 400, 800, 1600, 3200, 6400], truth);
    ladder!("SDIRK4, plane", 4.0, flat()?, Sdirk4::new(), [200, 400, 800, 1600, 3200, 6400], truth);
    ladder!("generalised alpha, plane", 2.0, flat()?, GeneralizedAlpha::new(0.8), [400, 800, 1600, 3200], truth);
    ladder!("RK4, body axes", 4.0, turning()?, RK4, [200, 400, 800, 1600, 3200, 6400], truth);
    ladder!("SDIRK4, body axes", 4.0, turning()?, Sdirk4::new(), [200, 400, 800, 1600, 3200, 6400], truth);
    ladder!("generalised alpha, body axes", 2.0, turning()?, GeneralizedAlpha::new(0.8), [400, 800, 1600, 3200], truth);
    Ok(())
}

/// A rule whose steps are made like those of the others.
struct Steps;
const RK4: Steps = Steps;
impl Steps {
    fn step(&self, size: f64) -> catena::time::Rule<Rk4, f64> {
        Rk4::step(size)
    }
}

#[test]
fn energy_never_rises() -> Result<(), Error> {
    macro_rules! falls {
        ($scene:expr, $rule:expr, $slack:literal) => {{
            let scene = $scene;
            let (mut last, mut rise) = (f64::INFINITY, 0.0_f64);
            scene.simulate(scene.motion(), $rule, 4.0, |now| {
                let energy = now.energy();
                rise = rise.max(energy - last);
                last = energy;
            })?;
            println!("energy rises by {rise:e} J at most, ends at {last}");
            assert!(rise <= $slack && last < -1.0, "{rise:e}");
        }};
    }
    falls!(flat()?, Dop853::tolerance(1e-10), 1e-9);
    falls!(turning()?, Dop853::tolerance(1e-10), 1e-9);
    falls!(flat()?, Sdirk4::new().tolerance(1e-8), 1e-7);
    falls!(turning()?, Sdirk4::new().tolerance(1e-8), 1e-7);
    Ok(())
}

/// Stops push where their end is, however far away the other one: `lower="0" upper="1e16"` is how some write a slide without an upper end.
#[test]
fn stops_know_each_end_to_its_own_rounding() {
    for far in [1e3, 1e16, 1e300, f64::MAX] {
        for (range, side) in [([0.1, far], 1.0), ([-far, -0.1], -1.0)] {
            let stops = Stops::between(range, 1e3, 0.02);
            assert_eq!(stops.check(), Ok(()));
            let at = side * -0.2; // by 0.3 beyond, of which the depth takes half of itself
            near(stops.force(at, 0.0), side * 1e3 * (0.3 - 0.01), 1e-12 * 290.0);
            near(stops.pivot(at, 0.0, shares(1.0, 0.0)), 1e3, 1e-12 * 1e3);
            assert_eq!([stops.force(side * 5.0, 1.0), stops.energy(side * 5.0)], [0.0, 0.0]);
        }
    }
    let all = Stops::between([-f64::MAX, f64::MAX], 1e3, 0.02);
    assert_eq!((all.check(), all.force(1e9, 1.0), all.energy(-1e9)), (Ok(()), 0.0, 0.0));
}

/// What is absent takes no room, and laws of furniture those of their numbers alone.
#[test]
fn what_is_absent_takes_no_room() {
    let number = size_of::<f64>();
    assert_eq!(size_of::<robot::Hinge<f64>>(), 3 * number);
    assert_eq!(size_of_val(&robot::Hinge::<f64>::level().with((Spring::none(), Spring::none()))), 3 * number);
    assert_eq!(size_of_val(&DryFriction::new(1.0, 1.0)), 2 * number);
    assert_eq!(size_of_val(&Stops::between(RANGE, 1.0, 1.0)), 4 * number);
}

#[test]
fn numbers_that_make_no_law_are_refused() {
    let refused = |law: &dyn Fn() -> Result<(), Fault>| assert!(law().is_err());
    refused(&|| DryFriction::new(-1.0, 1.0).check());
    refused(&|| DryFriction::new(1.0, 0.0).check());
    refused(&|| DryFriction::new(1.0, 1.0).breaking_away(0.5).check());
    refused(&|| Stops::between([1.0, -1.0], 1.0, 0.1).check());
    refused(&|| Stops::between([-1.0, f64::INFINITY], 1.0, 0.1).check());
    refused(&|| Stops::between(RANGE, 1.0, 0.0).check());
    refused(&|| (Spring::damping(1.0), Stops::between(RANGE, -1.0, 0.1)).check());
    assert_eq!(laws().check(), Ok(()));
}
