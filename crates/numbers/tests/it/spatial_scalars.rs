//! Spatial scenes on every number: single precision, dual numbers of all kinds, lanes.

use catena::scalar::Scalar;
use catena::spatial::*;
use catena::{Error, Real};
use num_dual::{Derivative, Dual64, DualSVec64, HyperDual64};
use num_traits::{One, Zero};
use simba::simd::WideF64x4;

/// Where a chain ends after some steps: place of the tip, angles of the last body, force at the root. Parameters are
/// a mass, a length, an angle at the start and a rate at the start.
fn outcome<T: Scalar<Real: Real>>([mass, length, angle, rate]: [T; 4], end: f64) -> Result<[T; 9], Error> {
    let n = T::literal;
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]].map(|row| row.map(n));
    let body = RigidBody::new(mass, tensor, [0.5, 0.03, -0.02].map(n), [length, T::zero(), T::zero()]);
    let rod = Rod::uniform(length, n(0.1), mass);
    let axis = [0.3, 1.0, -0.2].map(n);
    // One joint of each kind of elimination: compilers take long over such code for dual numbers.
    let sliding = Cylindrical::on(axis).with(Spring::stiffness(n(30.0)), Spring::damping(n(0.1)));
    let chain = (body, Ball, rod, sliding, body);
    let system = System::new(Pinned::origin(), chain, Free)?.with_gravity([0.0, -9.81, 0.0].map(n));
    let start = system.at_rest(&[angle, n(0.2), n(-0.4), n(0.5), n(-0.3), angle, n(0.4)])?;
    let mut rates = [n(0.5); 8];
    rates[1] = rate;
    let start = system.with_rates(start, &rates[..])?;
    let step = T::Real::of(0.01);
    let motion =
        system.simulate(start, Dopri5::step(step), T::Real::of(end), |_| ()).map_err(|stop| stop.error)?.motion;
    let stations = system.stations(&motion, &Unloaded)?;
    let (tip, force) = (stations.tip().frame.place, stations.root().internal.force);
    let angles = system.angles(&motion)?.iter().last().copied().unwrap_or([T::zero(); 3]);
    Ok([tip.x, tip.y, tip.z, angles[0], angles[1], angles[2], force.x, force.y, force.z])
}

const AT: [f64; 4] = [1.0, 0.9, 0.3, -1.0];
const END: f64 = 0.3;

fn shifted(k: usize, by: f64) -> [f64; 4] {
    core::array::from_fn(|i| if i == k { AT[i] + by } else { AT[i] })
}

/// Derivatives by central differences of order 4, with their own accuracy of about 1e-9.
fn differences(k: usize) -> Result<[f64; 9], Error> {
    let h = 1e-3;
    let at = |by| outcome(shifted(k, by), END);
    let (a, b, c, d) = (at(-2.0 * h)?, at(-h)?, at(h)?, at(2.0 * h)?);
    Ok(core::array::from_fn(|i| (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * h)))
}

fn near(found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs() / (1.0 + expected.abs());
    assert!(error < tolerance, "{found} instead of {expected}: {error:.1e}");
}

#[test]
fn single_precision_follows_double_precision() -> Result<(), Error> {
    let (single, double) = (outcome(AT.map(|x| x as f32), END)?, outcome(AT, END)?);
    for (single, double) in single.into_iter().zip(double) {
        near(f64::from(single), double, 2e-4);
    }
    Ok(())
}

#[test]
fn dual_numbers_differentiate_runs() -> Result<(), Error> {
    let all = outcome(
        core::array::from_fn(|k| {
            let mut x = DualSVec64::<4>::from_re(AT[k]);
            x.eps = Derivative::some(nalgebra::SVector::from_fn(|i, _| if i == k { 1.0 } else { 0.0 }));
            x
        }),
        END,
    )?;
    let plain = outcome(AT, END)?;
    for k in 0..4 {
        let one = outcome(core::array::from_fn(|i| Dual64::new(AT[i], if i == k { 1.0 } else { 0.0 })), END)?;
        let expected = differences(k)?;
        for i in 0..9 {
            near(one[i].re, plain[i], 1e-13);
            near(one[i].eps, expected[i], 1e-7);
            let part = all[i].eps.unwrap_generic(nalgebra::Const::<4>, nalgebra::Const::<1>)[k];
            near(part, one[i].eps, 1e-12);
        }
    }
    Ok(())
}

/// Second derivatives, by an angle and a rate at the start, against differences of first ones.
#[test]
fn hyper_dual_numbers_differentiate_runs_twice() -> Result<(), Error> {
    let o = 0.0;
    let of = |x: [f64; 4]| {
        core::array::from_fn(|i| HyperDual64::new(x[i], if i == 2 { 1.0 } else { o }, if i == 3 { 1.0 } else { o }, o))
    };
    let twice = outcome(of(AT), END)?;
    let first = |by: f64| {
        let x = shifted(3, by);
        outcome(core::array::from_fn(|i| Dual64::new(x[i], if i == 2 { 1.0 } else { o })), END)
    };
    let h = 1e-3;
    let (a, b, c, d) = (first(-2.0 * h)?, first(-h)?, first(h)?, first(2.0 * h)?);
    for i in 0..9 {
        let expected = (a[i].eps - 8.0 * b[i].eps + 8.0 * c[i].eps - d[i].eps) / (12.0 * h);
        near(twice[i].eps1eps2, expected, 1e-7);
    }
    Ok(())
}

#[test]
fn lanes_do_not_see_each_other() -> Result<(), Error> {
    let cases: [[f64; 4]; 4] = core::array::from_fn(|lane| shifted(lane, 0.1));
    let lanes = outcome(core::array::from_fn(|k| WideF64x4::from(cases.map(|case| case[k]))), END)?;
    for (lane, case) in cases.into_iter().enumerate() {
        for (found, expected) in lanes.iter().zip(outcome(case, END)?) {
            near(found.into_arr()[lane], expected, 1e-12);
        }
    }
    Ok(())
}

/// A scene lifted to another number is the scene built of it.
#[test]
fn lifted_scenes_move_alike() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 0.05, 1.0);
    let hinge = Revolute::about([0.0, 1.0, 0.0]).with(Spring::stiffness(2.0).resting_at(0.1));
    let chain =
        (rod, Ball, rod, hinge, rod, ElasticBall::rotary([1.0, 2.0, 3.0]).damped(0.1), PointMass::new(0.3, 0.2));
    let chain = (chain, Weld::at(Rotation::from_angles([0.1, 0.2, 0.3])), rod);
    let system = System::new(Pinned::at([0.1, 0.2, 0.3]), chain, Free)?.with_gravity([0.0, -9.81, 0.0]);
    let lifted = system.lift(|x| Dual64::new(x, 0.0));
    let angles = [0.3, 0.2, -0.4, 0.5, -0.3, 0.7, 0.4, 0.1, -0.2, 0.6];
    let start = system.with_accelerations(system.at_rest(&angles)?, &Unloaded)?;
    let dual = lifted.with_accelerations(start.lift(|x| Dual64::new(x, 0.0)), &Unloaded)?;
    let mut expected = vec![];
    catena::system::Rate::visit(start.acceleration(), &mut |x: f64| expected.push(x));
    let mut found = vec![];
    catena::system::Rate::visit(dual.acceleration(), &mut |x: Dual64| found.push(x.re));
    assert_eq!(found.len(), 10);
    assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-12 * (1.0 + b.abs())));
    Ok(())
}

/// Maps and their inverses, by duals too: the logarithm of an exponential is the vector it came from, with its derivatives, and
/// tangents are derivatives.
#[test]
fn maps_of_rotations_fit_each_other() {
    for size in [0.0, 1e-9, 1e-3, 0.7, 3.0, 3.1, 5.0] {
        let vector = [0.6 * size, -0.48 * size, 0.64 * size];
        let direction = [0.3, 0.9, -0.5];
        let moving: [Dual64; 3] = core::array::from_fn(|i| Dual64::new(vector[i], direction[i]));
        let turned = Rotation::exp(moving);
        let back = turned.log();
        let tolerance = 1e-14 * (1.0 + 1.0 / (6.5 - size));
        for i in 0..3 {
            near(back[i].re, vector[i], tolerance);
            near(back[i].eps, direction[i], 100.0 * tolerance);
        }
        // ω = 2 q⁻¹ q̇
        let spin = maps::tangent(vector, direction);
        let [w, x, y, z] = turned.quaternion();
        let still = [w, x, y, z].map(|part| Dual64::new(part.re, 0.0));
        let rate = Rotation::from_quaternion(still).map(|still| turned.relative_to(&still).quaternion());
        let rate = rate.unwrap_or([Dual64::zero(); 4]);
        for i in 0..3 {
            near(2.0 * rate[i + 1].eps, spin[i], 10.0 * tolerance);
        }
        let inverse = maps::inverse_tangent(vector, spin);
        for i in 0..3 {
            near(inverse[i], direction[i], 100.0 * tolerance);
        }
    }
    let far = Rotation::exp([100.0, 0.0, 0.0]).quaternion();
    near(far[0], f64::cos(50.0), 1e-13);
    near(far[1], f64::sin(50.0), 1e-13);
    assert_eq!(Rotation::exp([f64::zero(); 3]).quaternion(), [f64::one(), 0.0, 0.0, 0.0]);
}

/// Angles 1-2-3 go in and come out; near the singular attitude too, and follow a motion through it.
#[test]
fn angles_go_in_and_come_out() {
    for angles in [[0.3, 0.2, -0.4], [2.9, -1.2, -3.0], [-1.0, 1.57, 0.4], [0.1, -1.55, 3.0]] {
        let rotation = Rotation::from_angles(angles);
        for (found, expected) in rotation.angles_near(angles).into_iter().zip(angles) {
            near(found, expected, 1e-8); // ε / cos θ₂
        }
    }
    let quarter = core::f64::consts::FRAC_PI_2;
    for second in [quarter, -quarter] {
        let singular = Rotation::from_angles([0.3, second, 0.5]);
        let found = singular.angles_near([0.3, second, 0.5]);
        let back = Rotation::from_angles(found).relative_to(&singular);
        near(back.quaternion()[0].abs(), 1.0, 1e-15);
        near(found[2], 0.5, 1e-15);
    }
    // A body that tumbles about y: its angles go on beyond ±π/2 and beyond ±π.
    let mut angles = [0.0; 3];
    for k in 0..1000 {
        let turned = 0.01 * f64::from(k);
        angles = Rotation::from_angles([0.0, turned, 0.0]).angles_near(angles);
        near(angles[1], turned, 1e-7);
    }
}

/// Angles of numbers that round coarsely, where two of them turn about the same axis.
#[test]
fn angles_of_single_precision_give_the_attitude_back() {
    use core::f32::consts::FRAC_PI_2;
    for second in [FRAC_PI_2, -FRAC_PI_2, 1.5] {
        for (first, third) in [(0.3, 0.0), (2.0, -1.0), (0.3, 1.1_f32)] {
            let attitude = Rotation::from_angles([first, second, third]);
            for angles in [attitude.angles(), attitude.angles_near([first, second, third])] {
                let [_, miss @ ..] = attitude.relative_to(&Rotation::from_angles(angles)).shortest().quaternion();
                assert!(miss.iter().all(|x| x.abs() < 1e-5), "{first} {second} {third}: {angles:?}, {miss:?}");
            }
        }
    }
}
