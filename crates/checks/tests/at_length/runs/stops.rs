//! Runs under error control into one-sided stops: a trial step that leads nowhere is refused, and the run goes on.

use catena::simulate::Interrupted;
use catena::{Cause, Error, Fault, Place, planar, spatial};
use catena_oracle::near;

/// Length (m) and mass (kg) of both rods, the start (rad), and where the stop begins (rad).
const LENGTH: f64 = 0.5;
const MASS: f64 = 1.0;
const START: [f64; 2] = [0.0, 0.4];
const STOP: f64 = 0.5;
const STIFFNESSES: [f64; 5] = [1e3, 1e4, 1e5, 1e6, 1e8];
const TOLERANCES: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// Torque (N·m) of the stop for the relative angle (rad) and rate (rad/s).
fn stop(stiffness: f64, angle: f64, rate: f64) -> f64 {
    let over = angle.abs() - STOP;
    if over > 0.0 { -stiffness * over * angle.signum() - 20.0 * rate } else { 0.0 }
}

/// What came of a run: both absolute angles, or why not.
type Outcome = Result<[f64; 2], Error>;

/// The same runs with pins in the plane.
fn in_the_plane(stiffness: f64, tolerance: f64, fine: bool, end: f64) -> Outcome {
    use planar::*;
    let rod = Rod::uniform(LENGTH, MASS);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let loads = Loads::none().in_joints(
        move |_, joint, motion: &JointMotion<f64>| {
            if joint == 1 { stop(stiffness, motion.angle(), motion.rate()) } else { 0.0 }
        },
    );
    let start = scene.at_rest(&START)?;
    let motion = if fine {
        scene.simulation(Dop853::tolerance(tolerance)).loads(&loads).run(start, end, |_| ())?.motion
    } else {
        scene.simulation(Dopri5::tolerance(tolerance)).loads(&loads).run(start, end, |_| ())?.motion
    };
    let mut angles = vec![];
    catena::system::Position::visit(motion.position(), &mut |x| angles.push(x));
    Ok([angles[0], angles[1]])
}

/// And in space with revolutes about z.
fn in_space(stiffness: f64, tolerance: f64, fine: bool, end: f64) -> Outcome {
    use spatial::*;
    let rod = Rod::uniform(LENGTH, 1e-6, MASS);
    let hinge = Revolute::about([0.0, 0.0, 1.0]);
    let scene = System::new(Clamped::origin(), (hinge, rod, hinge, rod), Free)?.with_gravity([0.0, -9.81, 0.0]);
    let loads = Loads::none().in_joints(move |_, joint, motion: &JointMotion<f64>| {
        let torque = if joint == 2 { stop(stiffness, motion.position[0], motion.rate[0]) } else { 0.0 };
        Effort([torque, 0.0, 0.0])
    });
    let start = scene.at_rest(&[START[0], START[1] - START[0]])?;
    let motion = if fine {
        scene.simulation(Dop853::tolerance(tolerance)).loads(&loads).run(start, end, |_| ())?.motion
    } else {
        scene.simulation(Dopri5::tolerance(tolerance)).loads(&loads).run(start, end, |_| ())?.motion
    };
    let mut angles = vec![];
    catena::system::Position::visit(motion.position(), &mut |x| angles.push(x));
    Ok([angles[0], angles[0] + angles[1]])
}

/// All sixty runs go through, or say what kept them from it.
#[test]
fn runs_under_error_control_come_through_stops() {
    let mut failed = vec![];
    for (name, run) in [("plane", in_the_plane as fn(f64, f64, bool, f64) -> Outcome), ("space", in_space)] {
        for stiffness in STIFFNESSES {
            for tolerance in TOLERANCES {
                for fine in [false, true] {
                    let outcome = run(stiffness, tolerance, fine, 5.0);
                    if let Err(error) = outcome {
                        failed.push(format!("{name}, k {stiffness:e}, {tolerance:e}, {fine}: {error}"));
                    }
                }
            }
        }
    }
    println!("{}", failed.join("\n"));
    assert!(failed.is_empty(), "{} of 60 runs failed", failed.len());
}

/// Both angles of the double pendulum with its stop, by the equations of two rods and the classical rule in so many steps.
fn by_hand(stiffness: f64, end: f64, steps: usize) -> [f64; 2] {
    let (j, g) = (MASS * LENGTH * LENGTH, 9.81 / LENGTH);
    let slope = |[a, b, u, v]: [f64; 4]| {
        let torque = stop(stiffness, b - a, v - u);
        let (s, c) = (b - a).sin_cos();
        // (4/3) ä + (c/2) b̈ = (s/2) b' ² − (3/2) g cos a − T/J, (c/2) ä + (1/3) b̈ = −(s/2) a'² − (1/2) g cos b + T/J
        let p = 0.5 * s * v * v - 1.5 * g * a.cos() - torque / j;
        let q = -0.5 * s * u * u - 0.5 * g * b.cos() + torque / j;
        let det = 4.0 / 9.0 - 0.25 * c * c;
        [u, v, (p / 3.0 - 0.5 * c * q) / det, (4.0 / 3.0 * q - 0.5 * c * p) / det]
    };
    let plus = |y: [f64; 4], h: f64, k: [f64; 4]| core::array::from_fn(|i| y[i] + h * k[i]);
    let h = end / steps as f64;
    let mut y = [START[0], START[1], 0.0, 0.0];
    for _ in 0..steps {
        let k = slope(y);
        let l = slope(plus(y, 0.5 * h, k));
        let m = slope(plus(y, 0.5 * h, l));
        let n = slope(plus(y, h, m));
        y = core::array::from_fn(|i| y[i] + h / 6.0 * (k[i] + 2.0 * (l[i] + m[i]) + n[i]));
    }
    [y[0], y[1]]
}

/// The runs go where the equations of two rods lead.
#[test]
fn rods_rebound_from_stops_as_their_equations_say() -> Result<(), Error> {
    // Where torques jump, an estimate by smooth stages says less than the error: by so much in the stiffest.
    for (stiffness, end, most) in [(1e3, 1.0, 1e-6), (1e4, 1.0, 1e-6), (1e5, 0.3, 1e-5)] {
        let [coarse, expected] = [1_000_000, 4_000_000].map(|steps| by_hand(stiffness, end, steps));
        println!("by hand {stiffness:e}: {:.1e} {:.1e}", coarse[0] - expected[0], coarse[1] - expected[1]);
        for (name, run) in [("plane", in_the_plane as fn(f64, f64, bool, f64) -> Outcome), ("space", in_space)] {
            for fine in [false, true] {
                let found = run(stiffness, 1e-9, fine, end)?;
                println!("{name} {stiffness:e} {fine}: {:.1e} {:.1e}", found[0] - expected[0], found[1] - expected[1]);
                near(found[0], expected[0], most);
                near(found[1], expected[1], most);
            }
        }
    }
    Ok(())
}

/// A rod whose hinge law is not a number beyond an angle: it gets there, and no farther.
#[test]
fn a_load_that_stays_no_number_is_named() -> Result<(), Error> {
    use planar::*;
    let rod = Rod::uniform(LENGTH, MASS);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let loads = Loads::none().in_joints(
        |_, joint, motion: &JointMotion<f64>| {
            if joint == 1 && motion.angle() < -STOP { f64::NAN } else { 0.0 }
        },
    );
    let start = scene.at_rest(&START)?;
    macro_rules! named {
        ($($rule:expr),*) => {$(
            let run = scene.simulation($rule).loads(&loads).run(start, 5.0, |_| ());
            let Interrupted { error, last } = run.map(|run| run.steps).unwrap_err();
            println!("{error}");
            let Fault::StepTooSmall { step, cause } = error.fault else { panic!("{error}") };
            assert_eq!((cause, error.place), (Cause::NonFiniteLoad, Some(Place::Station(1))));
            assert!(step > 0.0 && step < 1e-15 && error.time == Some(last.time()));
            near(last.position().1.1 - last.position().0, -STOP, 1e-9);
        )*};
    }
    named!(Dop853::tolerance(1e-9), Dopri5::tolerance(1e-6), Adams::tolerance(1e-6), Vcabm::new().tolerance(1e-6));
    named!(Sdirk4::new().tolerance(1e-6), GeneralizedAlpha::new(0.8).tolerance(1e-3));
    Ok(())
}

/// Torques of 1e200 N·m are finite, and so are the accelerations they cause, but not the forces of the velocities after a step: no joint
/// is singular for that, in chains, trees and loops.
#[test]
fn motions_that_overflow_are_no_singular_joints() -> Result<(), Error> {
    macro_rules! overflow {
        ($scene:expr, $start:expr, $torques:expr, [$($rule:expr),*]) => {{
            let scene = $scene;
            let start = scene.assembled($start(&scene)?, &Unloaded)?;
            let loads = $torques;
            $(
                let run = scene.simulation($rule).loads(&loads).run(start.clone(), 1e3, |_| ());
                let error = run.map(|run| run.steps).unwrap_err().error;
                println!("{error}");
                assert_eq!((error.fault, error.place), (Fault::NonFiniteMotion, None));
            )*
        }};
    }
    {
        use planar::*;
        let rod = Rod::uniform(LENGTH, MASS);
        let torques = || Loads::none().in_joints(|_, _, _: &JointMotion<f64>| 1e200);
        overflow!(
            System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81),
            |scene: &System<_, _, _, _>| scene.at_rest(&START),
            torques(),
            [Rk4::step(0.1), Dopri5::step(0.1), Dop853::step(0.1), Adams::step(0.1), Sdirk4::new().step(0.1)]
        );
        overflow!(
            System::new(Free, (rod, Branch((Pin, rod)), Pin, rod), Free)?.with_gravity(9.81),
            |scene: &System<_, _, _, _>| scene
                .with_rates(scene.at_rest(&[0.0, 0.4, 1.0])?, &[0.0, 0.0, 1.0, 2.0, -3.0]),
            torques(),
            [Rk4::step(0.1), Dopri5::step(0.1)]
        );
        let net = Network::new((Pin, rod, Pin, rod), (Pin, rod, Pin, rod), Pin);
        overflow!(
            System::new(Pinned::origin(), (rod, net), Free)?.with_gravity(9.81),
            |scene: &System<_, _, _, _>| scene.at_rest(&[0.0, 0.5, -0.5, -0.5, 0.5]),
            torques(),
            [Rk4::step(0.1), Dopri5::step(0.1), GeneralizedAlpha::new(0.8).step(0.1)]
        );
    }
    {
        use spatial::*;
        let rod = Rod::uniform(LENGTH, 1e-6, MASS);
        let (y, z) = ([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
        let torques = || Loads::none().in_joints(|_, _, _: &JointMotion<f64>| Effort([1e200; 3]));
        overflow!(
            System::new(Clamped::origin(), (Revolute::about(z), rod, Universal::about(y, z), rod), Free)?
                .with_gravity([0.0, -9.81, 0.0]),
            |scene: &System<_, _, _, _>| scene.at_rest(&[0.0, 0.4, 0.1]),
            torques(),
            [Rk4::step(0.1), Dop853::step(0.1), Adams::step(0.1), Sdirk4::new().step(0.1)]
        );
        overflow!(
            System::new(Free, (rod, Ball, rod), Free)?,
            |scene: &System<_, _, _, _>| scene
                .with_rates(scene.motion(), &[0.0, 0.0, 0.0, 0.1, 0.2, 0.3, 1.0, 2.0, 3.0]),
            torques(),
            [Rk4::step(0.1), Dopri5::step(0.1)]
        );
    }
    Ok(())
}

/// Under a gravity a billion times as strong all goes as many times faster as the root of it says: the first step is far too long.
#[test]
fn strong_gravity_is_only_fast() -> Result<(), Error> {
    use planar::*;
    let rod = Rod::uniform(LENGTH, MASS);
    let fall = |gravity: f64, tolerance: f64, end: f64| -> Result<_, Error> {
        let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(gravity);
        let run = scene.simulate(scene.at_rest(&START)?, Dop853::tolerance(tolerance), end, |_| ())?;
        Ok([run.motion.position().0, run.motion.position().1.1])
    };
    let expected = fall(9.81, 1e-13, 2.0)?;
    for gravity in [1e6, 1e10, 1e14] {
        let found = fall(gravity, 1e-9, 2.0 * (9.81_f64 / gravity).sqrt())?;
        println!("{gravity:e}: {:.1e} {:.1e}", found[0] - expected[0], found[1] - expected[1]);
        near(found[0], expected[0], 1e-6);
        near(found[1], expected[1], 1e-6);
    }
    Ok(())
}
