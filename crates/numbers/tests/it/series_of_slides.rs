//! Taylor series through prismatic joints: coefficients against a sweep on the series themselves, runs against another rule.

use catena::Error;
use catena::loading::TimeLaw;
use catena::scalar::{Powers, Scalar};
use catena::simulate::Stepper;
use catena::spatial::*;

const P: usize = 24;
const G: [f64; 3] = [0.0, 0.0, -9.81];

fn rod() -> Rod<f64> {
    Rod::uniform(0.5, 0.05, 1.0)
}

fn body() -> RigidBody<f64> {
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
    RigidBody::new(1.0, tensor, [0.25, 0.03, -0.02], [0.5, 0.1, 0.05])
}

fn stiff() -> Prismatic<f64, Spring<f64, f64, f64>> {
    Prismatic::along([0.2, 0.9, 0.5]).with(Spring::new(30.0).damped(0.3).resting_at(0.2))
}

fn hinge() -> Revolute<f64> {
    Revolute::about([0.3, 1.0, 0.2])
}

/// A tree whose joints slide and turn, between bodies of all kinds: a rod's point mass is lumped where it slides.
macro_rules! tree {
    () => {{
        let arm = Branch((Prismatic::along([1.0, 0.3, 0.0]), rod(), hinge(), body()));
        let up = Prismatic::along([0.0, 0.0, 1.0]);
        let rest = (stiff(), body(), up, PointMass::new(0.3, 0.2), hinge(), rod(), stiff(), rod());
        let scene = System::new(Hinged::origin([0.0, 1.0, 0.0]), (body(), arm, rest), Free)?.with_gravity(G);
        let mut start = scene.at_rest(&[0.2, 0.3, -0.4])?;
        start.set_coordinates(&[0.3, 0.17, 0.54, 0.31, 0.38, 0.05, 0.52])?;
        start.set_rates(&[0.8, 0.5, 0.2, -0.1, -0.4, -0.7, -1.0])?;
        (scene, start)
    }};
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

#[test]
fn coefficients_are_those_of_accelerations_of_the_series() -> Result<(), Error> {
    let (scene, start) = tree!();
    let (mut stepper, mut end) = (scene.stepper(Taylor::<P>), start);
    stepper.step(&start, &Unloaded, 0.01, &mut end)?;
    let lifted = scene.lift(Powers::<f64, P>::constant);
    let motion = lifted.with_accelerations(stepper.motion_series(), &Unloaded)?;
    let right: Vec<[f64; P]> = motion.accelerations().iter().map(|series| series.terms()).collect();
    for k in 0..P - 1 {
        let (mut found, mut right) = (vec![], right.iter().map(|terms| terms[k]).collect::<Vec<_>>());
        stepper.coefficients(k, |x| found.push(x));
        let largest = right.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        right.iter_mut().chain(&mut found).for_each(|x| *x /= largest);
        println!("order {k}: {largest:.1e}, miss {:.1e}", apart(&found, &right)); // 3e-15 at most: rounding
        assert!(apart(&found, &right) < 3e-14);
    }
    Ok(())
}

/// Whether a run ends in the same places and accelerations as one by order eight: that one errs by some tolerances of 1e-13 in places, and springs,
/// gravity and spins make of these some hundred times as much.
fn alike([place, acceleration]: [f64; 2]) {
    assert!(place < 1e-12 && acceleration < 1e-10, "{place:e}, {acceleration:e}");
}

/// By how much places and accelerations of a run differ from those of one by order eight.
macro_rules! beside_dop853 {
    ($scene:expr, $start:expr, $loads:expr, $end:expr) => {{
        let (scene, start, loads) = (&$scene, $start, &$loads);
        let series = scene.simulation(Taylor::<P>::tolerance(1e-13)).loads(loads).run(start, $end, |_| ())?;
        let other = scene.simulation(Dop853::tolerance(1e-13)).loads(loads).run(start, $end, |_| ())?;
        let off = [
            apart(&series.motion.coordinates(), &other.motion.coordinates()),
            apart(&series.motion.accelerations(), &other.motion.accelerations()),
        ];
        println!("{} steps for {}, apart by {:.1e}, {:.1e}", series.steps, other.steps, off[0], off[1]);
        assert!(series.rejected == 0 && series.steps < other.steps);
        off
    }};
}

struct Drive;

impl TimeLaw<f64> for Drive {
    fn at<X: Scalar<Real = f64>>(&self, time: X, joint: usize) -> X {
        (X::literal(3.0) * time + X::literal(joint as f64)).sin_cos().0 * X::literal(2.0)
    }
}

#[test]
fn trees_move_as_under_dop853() -> Result<(), Error> {
    let (scene, start) = tree!();
    let free = beside_dop853!(scene, start, Unloaded, 1.0);
    let driven = beside_dop853!(scene, start, Loads::none().in_joints_over_time(Drive), 1.0);
    [free, driven].into_iter().for_each(alike);
    Ok(())
}

#[test]
fn chains_to_a_tip_that_is_held_move_as_under_dop853() -> Result<(), Error> {
    let last = Prismatic::along([1.0, 0.2, 0.0]);
    let chain = (rod(), stiff(), body(), Ball, rod(), hinge(), rod(), last, body());
    let scene = System::new(Hinged::origin([0.0, 1.0, 0.0]), chain, Pinned::at([0.6, 0.5, 0.3]))?.with_gravity(G);
    let start = scene.assembled(scene.at_rest(&[0.2, 0.3, -0.4, 0.3, 0.2])?, &Unloaded)?;
    alike(beside_dop853!(scene, start, Unloaded, 0.5));
    Ok(())
}

#[test]
fn loops_move_as_under_dop853() -> Result<(), Error> {
    let side = (Prismatic::along([1.0, 0.1, 0.0]), rod(), hinge(), rod());
    let net = Network::new((Ball, rod(), stiff(), rod()), side, Ball);
    let scene = System::new(Pinned::origin(), (rod(), net, Ball, rod()), Free)?.with_gravity(G);
    let start = scene.at_rest(&[0.1, 0.9, 0.2, 0.3, -0.1, 0.1, 0.2, 0.8, 0.4, 0.3])?;
    let start = scene.assembled(start, &Unloaded)?;
    alike(beside_dop853!(scene, start, Unloaded, 0.5));
    Ok(())
}
