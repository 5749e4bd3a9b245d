//! Static shapes: where all accelerations vanish.

use super::sweeps::{accelerations, displaced, response};
use super::*;
use catena::loading::Loading;
use catena::system::Element;
use catena::system::{MotionOf, Runs};
use catena::system::{Root, Tip};
use core::f64::consts::FRAC_PI_2;
use nalgebra::{DVector, Vector3};

/// Equilibrium by Newton's iteration on accelerations, in steps of at most a fifth of a radian.
fn equilibrium<R, C, P, L>(scene: &System<f64, R, C, P>, loads: &L) -> Result<MotionOf<Spatial<f64>, R, C, P>, Error>
where
    R: Root<Spatial<f64>>,
    C: Element<Spatial<f64>>,
    P: Tip<Spatial<f64>>,
    L: Loading<Spatial<f64>>,
    System<f64, R, C, P>: Runs<L, Spatial<f64>, R, C, P>,
{
    let mut motion = scene.motion();
    for _ in 0..60 {
        let found = DVector::from_vec(accelerations(scene, motion.clone(), loads)?);
        let slope = response(scene, &motion, loads, 1e-3)?;
        let step = slope.lu().solve(&-found).expect("a stable equilibrium");
        let size = step.amax();
        let share = (0.2 / size).min(1.0);
        motion = displaced::<R, C, P>(&motion, (step * share).as_slice());
        if size < 1e-12 {
            return Ok(motion);
        }
    }
    panic!("no equilibrium");
}

/// A couple at the tip bends it to a quarter of a circle, in either plane.
#[test]
fn a_couple_bends_a_beam_to_a_quarter_circle() -> Result<(), Error> {
    for axis in [1, 2] {
        let radius = L / FRAC_PI_2;
        // About z it bends towards y, about y towards −z.
        let (side, sign) = if axis == 2 { (1, 1.0) } else { (2, -1.0) };
        let mut errors = vec![];
        for n in [4, 8, 16] {
            let scene = System::new(Clamped::origin(), beam().segments_in_vec(n), Free)?;
            let mut couple = [0.0; 3];
            couple[axis] = FRAC_PI_2 * EI[axis - 1] / L;
            let roll = Loads::none().on_bodies(move |_: f64, body, _: &BodyMotion<f64>| {
                Wrench::torque(if body == n { couple } else { [0.0; 3] })
            });
            let rest = equilibrium(&scene, &roll)?;
            let tip = scene.stations(&rest, &roll)?.tip().frame;
            let mut expected = Vector3::new(radius, 0.0, 0.0);
            expected[side] = sign * radius;
            errors.push((1.0 / n as f64, (tip.place - expected).norm()));
            // Its end is turned by a right angle with any number of segments.
            near(tip.turn.attitude.x[side], sign, 1e-11);
        }
        has_order("quarter circle", 2.0, 1e-11, &errors);
    }
    Ok(())
}

/// The elastica of a cantilever under a dead force P across it at its tip: slope and place of the tip, from EI θ″ = −P cos θ by
/// shooting with a rule of order 4 and as many steps as rounding allows.
fn elastica(ei: f64, p: f64) -> [f64; 3] {
    const N: usize = 4000;
    let h = L / N as f64;
    let shoot = |curvature: f64| {
        let slope = |[theta, kappa, _, _]: [f64; 4]| [kappa, -p / ei * theta.cos(), theta.cos(), theta.sin()];
        let plus = |a: [f64; 4], s: f64, b: [f64; 4]| core::array::from_fn(|i| a[i] + s * b[i]);
        let mut y = [0.0, curvature, 0.0, 0.0];
        for _ in 0..N {
            let a = slope(y);
            let b = slope(plus(y, 0.5 * h, a));
            let c = slope(plus(y, 0.5 * h, b));
            let d = slope(plus(y, h, c));
            y = core::array::from_fn(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        }
        y
    };
    // No moment at the tip; the curvature at the root lies below that of a straight beam.
    let (mut low, mut high) = (0.0, p * L / ei);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if shoot(middle)[1] > 0.0 { high = middle } else { low = middle }
    }
    let [theta, _, x, y] = shoot(0.5 * (low + high));
    [theta, x, y]
}

#[test]
fn a_dead_force_bends_a_beam_to_its_elastica() -> Result<(), Error> {
    for (ei, side) in [(EI[1], 1), (EI[0], 2)] {
        let p = 3.0 * ei / (L * L);
        let [theta, x, y] = elastica(ei, p);
        println!("elastica: {theta:.9} rad, ({x:.9}, {y:.9}) m");
        let mut errors = vec![];
        for n in [4, 8, 16] {
            let half = 0.5 * L / n as f64;
            let push = Loads::none().on_bodies(move |_: f64, body, motion: &BodyMotion<f64>| {
                let mut force = [0.0; 3];
                force[side] = if body == n { p } else { 0.0 };
                motion.force_at([half, 0.0, 0.0], force)
            });
            let scene = System::new(Clamped::origin(), beam().segments_in_vec(n), Free)?;
            let rest = equilibrium(&scene, &push)?;
            let place = scene.stations(&rest, &push)?.tip().frame.place;
            let expected = if side == 1 { Vector3::new(x, y, 0.0) } else { Vector3::new(x, 0.0, y) };
            errors.push((1.0 / n as f64, (place - expected).norm()));
        }
        has_order("elastica", 2.0, 1e-10, &errors);
    }
    Ok(())
}

/// Damped steps lead to the same place: bent in both planes and twisted by a force beside its axis.
#[test]
fn damped_steps_come_to_rest_where_accelerations_vanish() -> Result<(), Error> {
    let half = 0.5 * L / 6.0;
    let push = Loads::none().on_bodies(move |_: f64, body, motion: &BodyMotion<f64>| {
        let on = if body == 6 { 1.0 } else { 0.0 };
        motion.force_at([half, 0.1, 0.0], [0.0, 1.0 * on, 1.5 * on])
    });
    let thick = Beam::new(L, EI, GJ, RHO_A, 0.01).damped(0.2);
    let scene = System::new(Clamped::origin(), thick.segments_in_vec(6), Free)?;
    let rest = equilibrium(&scene, &push)?;
    let rule = Sdirk4::new().step(0.1);
    let run = scene.simulation(rule).loads(&push).run(scene.motion(), 60.0, |_| ()).map_err(|stop| stop.error)?;
    let [found, expected] = [&run.motion, &rest].map(|motion| scene.stations(motion, &push).unwrap().tip().frame);
    println!("tip at {:?} m, {:.1e} m off", expected.place, (found.place - expected.place).norm());
    assert!(expected.place.y > 0.2 && expected.place.z > 0.2 && expected.turn.attitude.y.z.abs() > 0.02);
    near((found.place - expected.place).norm(), 0.0, 1e-10);
    near((found.turn.attitude.y - expected.turn.attitude.y).norm(), 0.0, 1e-10);
    Ok(())
}

/// Small forces along and across a beam that stretches and shears: the lengths by which K springs of each kind give.
#[test]
fn beams_stretch_and_shear_by_their_stiffness() -> Result<(), Error> {
    const P: f64 = 1e-6; // (N): what is not linear is P of the deflection
    for n in [1, 3, 8] {
        let half = 0.5 * L / n as f64;
        let push = Loads::none().on_bodies(move |_: f64, body, motion: &BodyMotion<f64>| {
            motion.force_at([half, 0.0, 0.0], [if body == n { P } else { 0.0 }; 3])
        });
        let scene = System::new(Clamped::origin(), beam().with_extension_and_shear(EA, GA).segments_in_vec(n), Free)?;
        let rest = equilibrium(&scene, &push)?;
        let tip = scene.stations(&rest, &push)?.tip().frame.place;
        // Bending: sums of squares of odd numbers.
        let bend = |ei: f64| L.powi(3) / (3.0 * ei) * (1.0 - 0.25 / (n * n) as f64);
        near((tip.x - L) / P, L / EA, 1e-5);
        near(tip.y / P, L / GA[0] + bend(EI[1]), 1e-5);
        near(tip.z / P, L / GA[1] + bend(EI[0]), 1e-5);
    }
    Ok(())
}

/// Strongly bent, a beam that stretches and shears follows the rods inboard of its springs, not what is between them and their
/// neighbours: first order. (E. Reissner 1972: r′ = (1 + N/EA) t + Q/GA n, M′ = −r′ × (0, P).)
#[test]
fn strongly_bent_beams_that_stretch_and_shear_converge_at_first_order() -> Result<(), Error> {
    // So soft that first order shows beside the second of bending.
    let (ea, ga) = (8.0, 20.0);
    let p = 3.0 * EI[1] / (L * L);
    const N: usize = 4000;
    let h = L / N as f64;
    let shoot = |moment: f64| {
        let slope = |[theta, m, _, _]: [f64; 4]| {
            let (along, across) = (1.0 + p * theta.sin() / ea, p * theta.cos() / ga);
            let x = along * theta.cos() - across * theta.sin();
            let y = along * theta.sin() + across * theta.cos();
            [m / EI[1], -p * x, x, y]
        };
        let plus = |a: [f64; 4], s: f64, b: [f64; 4]| core::array::from_fn(|i| a[i] + s * b[i]);
        let mut y = [0.0, moment, 0.0, 0.0];
        for _ in 0..N {
            let a = slope(y);
            let b = slope(plus(y, 0.5 * h, a));
            let c = slope(plus(y, 0.5 * h, b));
            let d = slope(plus(y, h, c));
            y = core::array::from_fn(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        }
        y
    };
    let (mut low, mut high) = (0.0, 2.0 * p * L);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if shoot(middle)[1] > 0.0 { high = middle } else { low = middle }
    }
    let [_, _, x, y] = shoot(0.5 * (low + high));
    let mut errors = vec![];
    for n in [16, 32, 64] {
        let half = 0.5 * L / n as f64;
        let push = Loads::none().on_bodies(move |_: f64, body, motion: &BodyMotion<f64>| {
            motion.force_at([half, 0.0, 0.0], [0.0, if body == n { p } else { 0.0 }, 0.0])
        });
        let scene =
            System::new(Clamped::origin(), beam().with_extension_and_shear(ea, [ga; 2]).segments_in_vec(n), Free)?;
        let rest = equilibrium(&scene, &push)?;
        let place = scene.stations(&rest, &push)?.tip().frame.place;
        errors.push((1.0 / n as f64, (place - Vector3::new(x, y, 0.0)).norm()));
    }
    has_order("stretched, sheared and bent", 1.0, 1e-9, &errors);
    Ok(())
}
