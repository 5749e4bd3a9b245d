//! Explicit rules keep their order on rotations: in attitudes, in rates and in forces, at the end of a step and within it.

use catena::simulate::Method;
use catena::spatial::*;
use catena::time::Rule;
use catena::{Error, Motion};
use catena_oracle::slope;
use nalgebra::Vector3;

type Chain = (RigidBody<f64>, Ball, RigidBody<f64>);
type Scene = System<f64, Pinned<[f64; 3]>, Chain, Free>;
type State = Motion<f64, (Rotation<f64>, ((), Rotation<f64>, ()))>;

fn scene() -> Result<(Scene, State), Error> {
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
    let body = RigidBody::new(1.0, tensor, [0.5, 0.03, -0.02], [1.0, 0.0, 0.0]);
    let system = System::new(Pinned::origin(), (body, Ball, body), Free)?.with_gravity([0.0, -3.0, 0.0]);
    let start = system.at_rest(&[0.3, 0.2, -0.4, 1.0, -0.6, 0.5])?;
    let start = system.with_rates(start, &[1.0, -1.0, 0.5, 2.0, 1.0, -1.0])?;
    Ok((system, start))
}

/// Angle between attitudes (worst body), difference of rates, and of the force at the root.
fn errors(system: &Scene, found: &State, exact: &State) -> [f64; 3] {
    let forces = [found, exact].map(|motion| system.stations(motion, &Unloaded).unwrap().root().internal.force);
    let pairs = [
        (found.position().0, exact.position().0, found.rate().0, exact.rate().0),
        (found.position().1.1, exact.position().1.1, found.rate().1.1, exact.rate().1.1),
    ];
    let (mut angle, mut rate) = (0.0_f64, 0.0_f64);
    for (a, b, v, w) in pairs {
        angle = angle.max(Vector3::from(a.relative_to(&b).shortest().log()).norm());
        rate = rate.max((Vector3::from(v) - Vector3::from(w)).norm());
    }
    [angle, rate, (forces[0] - forces[1]).norm()]
}

const END: f64 = 2.0;

fn order_of<'s, M>(
    name: &str,
    order: f64,
    steps: &[usize],
    rule: impl Fn(f64) -> Rule<M, f64>,
    end: f64,
    scene: &'s (Scene, State),
    exact: &State,
) -> Result<(), Error>
where
    M: Method<&'s Scene, Unloaded>,
{
    let (system, start) = scene;
    let mut points: [Vec<(f64, f64)>; 3] = Default::default();
    for n in steps {
        let h = end / *n as f64;
        let run = system.simulate(*start, rule(h), end, |_| ())?;
        for (points, error) in points.iter_mut().zip(errors(system, &run.motion, exact)) {
            points.push((h, error));
        }
    }
    for (what, points) in ["attitude", "rate", "force"].iter().zip(&points) {
        for (step, error) in points {
            println!("{name}, {what}: step {step:.6e} error {error:.3e}");
            assert!(*error > 1e-13, "{name}, {what}: lost in rounding");
        }
        let found = slope(points);
        println!("{name}, {what}: order {found:.3}");
        // At steps whose errors stand above rounding, the next order still shows in an order of 8.
        let slack = if order > 5.0 { 0.4 } else { 0.2 };
        assert!((found - order).abs() <= slack, "{name}, {what}: order {found:.3}");
    }
    Ok(())
}

#[test]
fn explicit_rules_have_their_orders_on_attitudes_rates_and_forces() -> Result<(), Error> {
    let scene = scene()?;
    let exact = scene.0.simulate(scene.1, Dop853::tolerance(1e-14), END, |_| ())?.motion;
    order_of("RK4", 4.0, &[400, 600, 900], Rk4::step, END, &scene, &exact)?;
    order_of("DOPRI5", 5.0, &[200, 280, 400], Dopri5::step, END, &scene, &exact)?;
    order_of("Adams", 5.0, &[400, 600, 900], Adams::step, END, &scene, &exact)?;
    order_of("variable order", 5.0, &[400, 600, 900], |h| Vcabm::new().up_to(4).step(h), END, &scene, &exact)?;
    order_of("DOP853", 8.0, &[90, 100, 110, 120], Dop853::step, END, &scene, &exact)
}

const LATER: f64 = 1.4;

/// A motion that passes the place where the angles 1-2-3 are singular, two degrees off and less: both bodies come to θ₂ near 90°.
/// Found from a state there, by running backward.
fn passage() -> Result<(Scene, State), Error> {
    let (system, _) = scene()?;
    let there = system.at_rest(&[0.3, 1.560, -0.4, 1.0, -1.566, 0.5])?;
    let rates = [0.7, -1.3, 0.2, 0.9, 1.2, -0.4];
    let there = system.with_rates(there, &rates.map(|rate| -rate))?;
    let back = system.simulate(there, Dop853::tolerance(1e-14), LATER / 2.0, |_| ())?.motion;
    let mut start = system.motion();
    *start.position_mut() = *back.position();
    start.rate_mut().0 = back.rate().0.map(|rate| -rate);
    start.rate_mut().1.1 = back.rate().1.1.map(|rate| -rate);
    Ok((system, start))
}

#[test]
fn rules_keep_their_orders_where_angles_are_singular() -> Result<(), Error> {
    let scene = passage()?;
    let (system, start) = &scene;
    println!("start: attitudes {:?}, {:?}", start.position().0.quaternion(), start.position().1.1.quaternion());
    println!("       rates {:?}, {:?} rad/s", start.rate().0, start.rate().1.1);
    let mut steepest = [(0.0_f64, 0.0); 2];
    let mut ends = vec![];
    system.simulation(Dop853::tolerance(1e-12)).every(0.001).run(*start, LATER, |now| {
        for (most, angles) in steepest.iter_mut().zip(now.angles().iter()) {
            if angles[1].abs() > most.0 {
                *most = (angles[1].abs(), now.time());
            }
        }
        if now.time() == 0.0 || now.time() == LATER {
            ends.extend(now.angles().iter().map(|angles| angles[1].to_degrees()));
        }
    })?;
    for (most, time) in steepest {
        println!("|θ₂| comes to {:.2}° at {time:.3} s", most.to_degrees());
        assert!(most.to_degrees() > 88.0 && time > 0.2 && time < LATER - 0.2);
    }
    println!("θ₂ at the start and at the end: {ends:.1?}°");
    let exact = system.simulate(*start, Dop853::tolerance(1e-14), LATER, |_| ())?.motion;
    order_of("RK4", 4.0, &[400, 600, 900], Rk4::step, LATER, &scene, &exact)?;
    order_of("DOPRI5", 5.0, &[160, 224, 320], Dopri5::step, LATER, &scene, &exact)?;
    order_of("Adams", 5.0, &[400, 600, 900], Adams::step, LATER, &scene, &exact)?;
    order_of("DOP853", 8.0, &[36, 40, 44, 48], Dop853::step, LATER, &scene, &exact)?;
    order_of("SDIRK4", 4.0, &[800, 1200, 1800], |h| Sdirk4::new().step(h), LATER, &scene, &exact)?;
    order_of(
        "generalised-alpha",
        2.0,
        &[800, 1600, 3200],
        |h| GeneralizedAlpha::new(0.8).step(h),
        LATER,
        &scene,
        &exact,
    )
}

/// A stepper that remembers motions knows rotations again: after three steps by another rule two sweeps each.
#[test]
fn attitudes_are_recognised() -> Result<(), Error> {
    let (system, start) = scene()?;
    let run = system.simulate(start, Adams::step(0.01), 1.0, |_| ())?;
    assert_eq!(run.sweeps, 3 * 6 + 97 * 2);
    Ok(())
}

/// Attitudes between steps come from the coordinates of the step too.
#[test]
fn dense_output_is_as_good_as_the_steps() -> Result<(), Error> {
    let (system, start) = scene()?;
    let mut worst = 0.0_f64;
    let mut seen = 0;
    system.simulation(Dop853::tolerance(1e-11)).every(0.137).run(start, END, |now| {
        let exact = system.simulate(start, Dop853::tolerance(1e-14), now.time(), |_| ()).map(|run| run.motion);
        if let Ok(exact) = exact {
            seen += 1;
            worst = errors(&system, now.motion(), &exact).into_iter().fold(worst, f64::max);
        }
    })?;
    println!("{seen} samples, largest error {worst:.1e}");
    assert!(seen == 15 && worst < 1e-9);
    Ok(())
}

/// Quaternions of accepted steps have length one, however long the run.
#[test]
fn attitudes_stay_normalised() -> Result<(), Error> {
    let (system, start) = scene()?;
    let run = system.simulate(start, Rk4::step(1e-3), 20.0, |_| ())?;
    for rotation in [run.motion.position().0, run.motion.position().1.1] {
        let square: f64 = rotation.quaternion().iter().map(|x| x * x).sum();
        assert!((square - 1.0).abs() < 4.0 * f64::EPSILON, "{:.1e}", square - 1.0);
    }
    Ok(())
}
