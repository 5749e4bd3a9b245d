//! Hinges on every number, and derivatives by every parameter of theirs through implicit steps.

use catena::scalar::Scalar;
use catena::spatial::*;
use catena::{Error, Real};
use num_dual::Dual64;
use simba::simd::WideF64x4;

/// Stiffness, damping and rest value about and along three axes.
const AT: [f64; 18] = [
    5.0, 9.0, 7.0, 0.1, 0.2, 0.3, 0.2, -0.3, 0.1, // about
    60.0, 90.0, 120.0, 1.0, 2.0, 1.5, 0.02, -0.03, 0.04, // along
];

/// Where a chain with such a hinge ends after some steps of a rule: place of the tip, force and torque at the root.
macro_rules! outcome {
    ($name:ident, $rule:expr) => {
        fn $name<T: Scalar<Real: Real>>(at: [T; 18]) -> Result<[T; 9], Error> {
            let n = T::literal;
            let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]].map(|row| row.map(n));
            let body = RigidBody::new(n(1.0), tensor, [0.5, 0.03, -0.02].map(n), [1.0, 0.1, -0.05].map(n));
            let three = |k: usize| [at[k], at[k + 1], at[k + 2]];
            let along = |k: usize| Spring::stiffness(at[9 + k]).damped(at[12 + k]).resting_at(at[15 + k]);
            let hinge = ElasticHinge::rotary(three(0)).damped_about(three(3)).resting_at(three(6));
            let hinge = hinge.with_linear(along(0), along(1), along(2));
            let system =
                System::new(Clamped::origin(), (body, hinge, body), Free)?.with_gravity([0.0, -9.81, 0.0].map(n));
            let mut start = system.motion();
            start.rate_mut().1.1 = ([0.1, -0.2, 0.3].map(n), [1.0, -1.0, 0.5].map(n));
            let of = <T::Real as Real>::of;
            let motion = system.simulate(start, $rule(of(0.02)), of(0.3), |_| ()).map_err(|stop| stop.error)?.motion;
            let stations = system.stations(&motion, &Unloaded)?;
            let (tip, root) = (stations.tip().frame.place, stations.root().internal);
            let (force, torque) = (root.force, root.torque);
            Ok([tip.x, tip.y, tip.z, force.x, force.y, force.z, torque.x, torque.y, torque.z])
        }
    };
}
outcome!(explicitly, Dopri5::step);
outcome!(by_generalised_alpha, |h| GeneralizedAlpha::new(0.8).step(h));
outcome!(by_sdirk4, |h| Sdirk4::new().step(h));

fn near(found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs() / (1.0 + expected.abs());
    assert!(error < tolerance, "{found} instead of {expected}: {error:.1e}");
}

/// Central differences of order 4.
fn differences(outcome: fn([f64; 18]) -> Result<[f64; 9], Error>, k: usize) -> Result<[f64; 9], Error> {
    let h = 2e-3 * AT[k].abs();
    let at = |by: f64| outcome(core::array::from_fn(|i| if i == k { AT[i] + by } else { AT[i] }));
    let (a, b, c, d) = (at(-2.0 * h)?, at(-h)?, at(h)?, at(2.0 * h)?);
    Ok(core::array::from_fn(|i| (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * h)))
}

#[test]
fn implicit_steps_are_differentiated_by_every_parameter() -> Result<(), Error> {
    type Pair = (fn([f64; 18]) -> Result<[f64; 9], Error>, fn([Dual64; 18]) -> Result<[Dual64; 9], Error>);
    let rules: [Pair; 3] =
        [(explicitly, explicitly), (by_generalised_alpha, by_generalised_alpha), (by_sdirk4, by_sdirk4)];
    let mut worst = 0.0_f64;
    for (plain, dual) in rules {
        let values = plain(AT)?;
        for (k, at) in AT.into_iter().enumerate() {
            let found = dual(core::array::from_fn(|i| Dual64::new(AT[i], if i == k { 1.0 } else { 0.0 })))?;
            let expected = differences(plain, k)?;
            let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            assert!(size * at.abs() > 1e-5, "parameter {k} must matter");
            for i in 0..9 {
                near(found[i].re, values[i], 1e-12);
                worst = worst.max((found[i].eps - expected[i]).abs() / size);
            }
        }
    }
    println!("worst relative error of a derivative {worst:.1e}");
    assert!(worst < 1e-6);
    Ok(())
}

#[test]
fn single_precision_follows_double_precision() -> Result<(), Error> {
    let pairs = [
        (explicitly(AT.map(|x| x as f32))?, explicitly(AT)?),
        (by_generalised_alpha(AT.map(|x| x as f32))?, by_generalised_alpha(AT)?),
        (by_sdirk4(AT.map(|x| x as f32))?, by_sdirk4(AT)?),
    ];
    for (single, double) in pairs {
        for (single, double) in single.into_iter().zip(double) {
            near(f64::from(single), double, 2e-4);
        }
    }
    Ok(())
}

#[test]
fn lanes_do_not_see_each_other() -> Result<(), Error> {
    let cases: [[f64; 18]; 4] = core::array::from_fn(|lane| AT.map(|x| x * (1.0 + 0.1 * lane as f64)));
    let lanes = by_sdirk4(core::array::from_fn(|k| WideF64x4::from(cases.map(|case| case[k]))))?;
    for (lane, case) in cases.into_iter().enumerate() {
        for (found, expected) in lanes.iter().zip(by_sdirk4(case)?) {
            near(found.into_arr()[lane], expected, 1e-11);
        }
    }
    Ok(())
}

/// A hinge lifted to another number is the hinge built of it.
#[test]
fn lifted_hinges_are_the_same() {
    use catena::Lift;
    let make = |scale: f64| {
        let along = Spring::stiffness(10.0 * scale).damped(0.1 * scale).resting_at(0.2 * scale);
        let rotary = ElasticHinge::rotary([1.0, 2.0, 3.0].map(|x| x * scale)).resting_at([0.1 * scale; 3]);
        rotary.damped_about([scale; 3]).with_linear(along, Spring::none(), along)
    };
    assert_eq!(make(1.0).lift(&mut |x: f64| 2.0 * x), make(2.0));
}
