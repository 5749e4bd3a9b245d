//! One scene with every kind of number, and its derivatives against differences and closed forms. Derivative parts are
//! compared by themselves: `==` and `near` see only the value of a dual number.

use catena::loading::Unloaded;
use catena::planar::*;
use catena::{Error, Real, Scalar};
use catena_oracle::near;
use nalgebra::{Const, U1, Vector2};
use num_dual::{Dual64, DualSVec64, HyperDual64};

/// All that a scene is made of: a rigid body, a rod and a point mass, gravity, the root, the start, torques in the
/// joints.
const NAMES: [&str; 25] = [
    "mass of the body",
    "inertia of the body",
    "mass centre x",
    "mass centre y",
    "outboard end x",
    "outboard end y",
    "length of the rod",
    "mass of the rod",
    "mass centre of the rod",
    "inertia of the rod",
    "length of the link",
    "point mass",
    "gravity x",
    "gravity y",
    "root x",
    "root y",
    "angle 0",
    "angle 1",
    "angle 2",
    "rate 0",
    "rate 1",
    "rate 2",
    "torque 0",
    "torque 1",
    "torque 2",
];
const N: usize = NAMES.len();
const ROOT: usize = 14;

type Parameters<T> = [T; N];

/// Nothing is zero, nothing equal.
const GENERIC: Parameters<f64> = [
    1.3, 0.2, 0.4, 0.15, 0.9, -0.2, 0.7, 0.8, 0.3, 0.15, 0.6, 0.5, 1.1, -9.0, 0.3, -0.4, -0.8, 0.5, -1.9, 0.6, -0.9,
    1.4, 0.7, -0.4, 0.3,
];

/// Whatever may be zero is: derivatives with respect to zeros are no less there.
const ZEROS: Parameters<f64> = [
    1.3, 0.2, 0.4, 0.0, 0.9, 0.0, 0.7, 0.8, 0.0, 0.15, 0.6, 0.5, 0.0, -9.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0,
];

/// What is read from the end of a run: the tip, the force at the root, the energy.
const READINGS: [&str; 5] = ["tip x", "tip y", "root force x", "root force y", "energy"];

/// Half a second in steps of 10 ms: short enough for differences to be well behaved.
fn run<T: Scalar>(parameters: Parameters<T>) -> Result<[T; 5], Error> {
    let [m, j, cx, cy, ox, oy, l1, m1, c1, j1, l2, m2, gx, gy, x, y, rest @ ..] = parameters;
    let [a0, a1, a2, w0, w1, w2, torques @ ..] = rest;
    let chain = (RigidBody::new(m, j, [cx, cy], [ox, oy]), Pin, Rod::new(l1, m1, c1, j1), Pin, PointMass::new(l2, m2));
    let system = System::new(Pinned::at(x, y), chain, Free)?.with_gravity_vector(Vector2::new(gx, gy));
    let start = system.with_rates(system.at_rest(&[a0, a1, a2])?, &[w0, w1, w2])?;
    let loads = Loads::none().in_joints(|_, joint, _: &JointMotion<T>| torques[joint]);
    let of = <T::Real as Real>::of;
    let run = system.simulation(Rk4::step(of(0.01))).loads(&loads).run(start, of(0.5), |_| ())?;
    let stations = system.stations(&run.motion, &loads)?;
    let (tip, force) = (stations.tip().frame.place, stations.root().internal.force);
    let budget = system.budget(&run.motion)?;
    Ok([tip.x, tip.y, force.x, force.y, budget.kinetic + budget.potential])
}

/// Parameters as other numbers, one of which is seeded.
fn seeded<T: Scalar>(at: Parameters<f64>, seed: impl Fn(usize, T) -> T) -> Parameters<T> {
    core::array::from_fn(|i| seed(i, T::literal(at[i])))
}

/// First derivatives of all readings with respect to parameter `i`.
fn derivative(at: Parameters<f64>, i: usize) -> Result<[f64; 5], Error> {
    let parameters = seeded(at, |k, x: Dual64| if k == i { x.derivative() } else { x });
    Ok(run(parameters)?.map(|reading| reading.eps))
}

/// The derivative of `f` by central differences of fourth order: h⁴ leaves 2e-15 of the fifth derivative, and rounding
/// 1e-15/h = 5e-12 of the values.
fn difference(f: impl Fn(f64) -> Result<[f64; 5], Error>) -> Result<[f64; 5], Error> {
    let h = 2e-4;
    let [b, a, c, d] = [f(-2.0 * h)?, f(-h)?, f(h)?, f(2.0 * h)?];
    Ok(core::array::from_fn(|k| (8.0 * (c[k] - a[k]) - (d[k] - b[k])) / (12.0 * h)))
}

fn moved(mut at: Parameters<f64>, i: usize, by: f64) -> Parameters<f64> {
    at[i] += by;
    at
}

#[test]
fn every_parameter_has_the_derivative_that_differences_say() -> Result<(), Error> {
    let mut worst = 0.0_f64;
    for (scene, at) in [("generic", GENERIC), ("zeros", ZEROS)] {
        for (i, name) in NAMES.iter().enumerate() {
            let found = derivative(at, i)?;
            let expected = difference(|by| run(moved(at, i, by)))?;
            println!("{scene}, {name}: {found:.3?}");
            for k in 0..5 {
                // Relative; readings are of order 1 to 100, and so is what differences are rounded to.
                let error = (found[k] - expected[k]).abs() / found[k].abs().max(1e-2);
                worst = worst.max(error);
                assert!(error < 1e-7, "{scene}, {} by {name}: {} not {}", READINGS[k], found[k], expected[k]);
                let translation = (ROOT..ROOT + 2).contains(&i);
                assert!(
                    translation || found[k].abs() > 1e-6 || scene == "zeros",
                    "{name} must matter to {}",
                    READINGS[k]
                );
            }
        }
        // A scene moves as its root is moved. (Rounding: sums of a few metres.)
        for i in 0..2 {
            let found = derivative(at, ROOT + i)?;
            for (k, found) in found[..4].iter().enumerate() {
                near(*found, f64::from(u8::from(k == i)), 1e-14);
            }
        }
    }
    println!("largest relative difference {worst:.1e}");
    Ok(())
}

#[test]
fn gradients_are_the_single_derivatives() -> Result<(), Error> {
    let readings = run(GENERIC)?;
    for first in (0..N).step_by(4) {
        let seed =
            |k: usize, x: DualSVec64<4>| if (first..first + 4).contains(&k) { x.derivative(k - first) } else { x };
        let found = run(seeded(GENERIC, seed))?;
        for i in first..N.min(first + 4) {
            let expected = derivative(GENERIC, i)?;
            for k in 0..5 {
                let gradient = found[k].eps.unwrap_generic(Const::<4>, U1);
                // The same arithmetic in another order: some thousand roundings of quantities up to a hundred.
                near(gradient[i - first], expected[k], 1e-12 * expected[k].abs().max(1.0));
                near(found[k].re, readings[k], 1e-13 * readings[k].abs().max(1.0));
            }
        }
    }
    Ok(())
}

#[test]
fn second_derivatives_are_differences_of_first_ones() -> Result<(), Error> {
    let mut worst = 0.0_f64;
    for (i, name) in NAMES.iter().enumerate() {
        // Each with itself, and with another one.
        for j in [i, (7 * i + 3) % N] {
            let seed = |k: usize, x: HyperDual64| {
                let x = if k == i { x.derivative1() } else { x };
                if k == j { x.derivative2() } else { x }
            };
            let found = run(seeded(GENERIC, seed))?;
            let (by_i, by_j) = (derivative(GENERIC, i)?, derivative(GENERIC, j)?);
            let expected = difference(|by| derivative(moved(GENERIC, j, by), i))?;
            for k in 0..5 {
                let error = (found[k].eps1eps2 - expected[k]).abs() / expected[k].abs().max(1.0);
                worst = worst.max(error);
                assert!(error < 1e-7, "{} by {name} and {}: {:?}", READINGS[k], NAMES[j], found[k]);
                near(found[k].eps1, by_i[k], 1e-12 * by_i[k].abs().max(1.0));
                near(found[k].eps2, by_j[k], 1e-12 * by_j[k].abs().max(1.0));
            }
        }
    }
    println!("largest relative difference {worst:.1e}");
    Ok(())
}

/// A pendulum's angular acceleration and pivot force with their derivatives, by hand: J α = τ + m d × g with
/// J = J_C + m |c|², q = m (α ẑ × d − ω² d − g), d = R(θ) c.
#[test]
fn acceleration_and_force_of_a_pendulum_have_their_exact_derivatives() -> Result<(), Error> {
    const P: usize = 11; // m, J_C, c_x, c_y, g_x, g_y, x, y, θ, ω, τ
    let at = [1.7, 0.3, 0.5, -0.2, 1.2, -9.0, 0.4, 0.6, 0.7, -1.3, 0.9];
    let [m, j_c, cx, cy, gx, gy, _, _, theta, w, tau] = at;
    let (s, c) = f64::sin_cos(theta);
    let d = [c * cx - s * cy, s * cx + c * cy];
    let j = j_c + m * (cx * cx + cy * cy);
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let alpha = (tau + m * cross(d, [gx, gy])) / j;

    for i in 0..P {
        let one = |k: usize| f64::from(u8::from(k == i));
        let (m_i, w_i, g_i) = (one(0), one(9), [one(4), one(5)]);
        let j_i = one(1) + m_i * (cx * cx + cy * cy) + 2.0 * m * (cx * one(2) + cy * one(3));
        let turned = |x: f64, y: f64| [c * x - s * y, s * x + c * y];
        let d_i = if i == 8 { [-d[1], d[0]] } else { turned(one(2), one(3)) };
        let moment_i = one(10) + m_i * cross(d, [gx, gy]) + m * (cross(d_i, [gx, gy]) + cross(d, g_i));
        let alpha_i = moment_i / j - alpha * j_i / j;
        let force_i = |k: usize| {
            let (n, n_i) = ([-d[1], d[0]], [-d_i[1], d_i[0]]);
            let a = alpha * n[k] - w * w * d[k] - [gx, gy][k];
            m_i * a + m * (alpha_i * n[k] + alpha * n_i[k] - 2.0 * w * w_i * d[k] - w * w * d_i[k] - g_i[k])
        };

        let x: [Dual64; P] = core::array::from_fn(|k| Dual64::new(at[k], one(k)));
        let body = RigidBody::new(x[0], x[1], [x[2], x[3]], [Dual64::literal(1.0), Dual64::literal(0.0)]);
        let gravity = Vector2::new(x[4], x[5]);
        let system = System::new(Pinned::at(x[6], x[7]), body, Free)?.with_gravity_vector(gravity);
        let loads = Loads::none().in_joints(|_, _, _: &JointMotion<Dual64>| x[10]);
        let motion = system.with_rates(system.at_rest(&[x[8]])?, &[x[9]])?;
        let motion = system.with_accelerations(motion, &loads)?;
        let stations = system.stations(&motion, &loads)?;
        let root = stations.root();
        let found = [motion.acceleration().0, root.internal.force.x, root.internal.force.y].map(|x| [x.re, x.eps]);
        let [qx, qy] = [0, 1].map(|k| m * (alpha * [-d[1], d[0]][k] - w * w * d[k] - [gx, gy][k]));
        let expected = [[alpha, alpha_i], [qx, force_i(0)], [qy, force_i(1)]];
        println!("parameter {i}: {:?}", found.map(|x| x[1]));
        for (found, expected) in found.into_iter().zip(expected) {
            // Ten roundings of terms up to fifty.
            near(found[0], expected[0], 1e-13);
            near(found[1], expected[1], 1e-11 * expected[1].abs().max(1e-2));
            // The place of the pivot, and for the acceleration the rate, do not matter; all else does.
            assert!(found[1] != 0.0 || i == 6 || i == 7 || i == 9);
        }
    }
    Ok(())
}

/// All motions of the simple pendulum are one function of s = t √(g/l): released from the horizontal, it passes the
/// lowest point at s = K(1/√2) with the rate −√(2g/l) and no acceleration, so that derivatives there are exact.
#[test]
fn a_simple_pendulum_passes_its_lowest_point_with_exact_derivatives() -> Result<(), Error> {
    const QUARTER: f64 = 2.3678419475762374 / 4.0;
    let (l, g) = (1.0, 9.81);
    let scene = |length: HyperDual64, gravity: HyperDual64| -> Result<HyperDual64, Error> {
        let system = System::new(Pinned::origin(), PointMass::new(length, HyperDual64::literal(0.7)), Free)?;
        let system = system.with_gravity(gravity);
        let start = system.at_rest(&[HyperDual64::literal(0.0)])?;
        Ok(system.simulate(start, Dop853::step(QUARTER / 100.0), QUARTER, |_| ())?.motion.position().0)
    };
    let rate = -f64::sqrt(2.0 * g / l);
    let twice = scene(HyperDual64::literal(l).derivative1().derivative2(), HyperDual64::literal(g))?;
    let mixed = scene(HyperDual64::literal(l).derivative1(), HyperDual64::literal(g).derivative2())?;
    // dθ = Θ′ ds and Θ″ = 0, with s_l = −s/(2l), s_g = s/(2g), s_ll = 3s/(4l²), s_lg = −s/(4lg); Θ′ s = rate · t.
    let theta = rate * QUARTER;
    let exact = [
        (twice.re, -core::f64::consts::FRAC_PI_2),
        (twice.eps1, -theta / (2.0 * l)),
        (twice.eps2, -theta / (2.0 * l)),
        (twice.eps1eps2, 3.0 * theta / (4.0 * l * l)),
        (mixed.eps1, -theta / (2.0 * l)),
        (mixed.eps2, theta / (2.0 * g)),
        (mixed.eps1eps2, -theta / (4.0 * l * g)),
    ];
    for (found, expected) in exact {
        println!("{found:.13} {:.1e}", found - expected);
        // A hundred steps of 6 ms, whose own errors are below rounding.
        near(found, expected, 1e-11 * expected.abs());
    }
    Ok(())
}

#[test]
fn single_precision_runs_the_same_scene() -> Result<(), Error> {
    let (single, double) = (run(GENERIC.map(|x| x as f32))?, run(GENERIC)?);
    for k in 0..5 {
        println!("{}: {} {}", READINGS[k], single[k], double[k]);
        // Fifty steps, each rounded to 6e-8, of a motion that multiplies errors by about ten.
        near(f64::from(single[k]), double[k], 1e-4 * double[k].abs().max(1.0));
    }
    Ok(())
}

#[test]
fn values_of_dual_runs_are_those_of_plain_runs() -> Result<(), Error> {
    let plain = run(GENERIC)?;
    let dual = run(seeded(GENERIC, |_, x: Dual64| x))?;
    for k in 0..5 {
        // Quotients of dual numbers are products with reciprocals: an ulp each.
        near(dual[k].re, plain[k], 1e-13 * plain[k].abs().max(1.0));
        assert_eq!(dual[k].eps, 0.0, "{}", READINGS[k]);
    }
    Ok(())
}

/// Inverse dynamics and state vectors carry derivatives too: the torque for an acceleration, by that acceleration, is
/// the moment of inertia.
#[test]
fn inverse_dynamics_has_derivatives() -> Result<(), Error> {
    let [m, j, cx, cy] = [1.7, 0.3, 0.5, -0.2];
    let dual = Dual64::literal;
    let body = RigidBody::new(dual(m), dual(j), [dual(cx), dual(cy)], [dual(1.0), dual(0.0)]);
    let system = System::new(Pinned::origin(), body, Free)?.with_gravity(dual(9.81));
    let mut motion = system.at_rest(&[dual(0.4)])?;
    motion.acceleration_mut().0 = Dual64::new(2.0, 1.0);
    let stations = system.stations(&motion, &Unloaded)?;
    let torque = stations.root().state()[index::M];
    near(-torque.eps, j + m * (cx * cx + cy * cy), 1e-15); // two roundings
    Ok(())
}

#[test]
fn four_lanes_are_four_runs() -> Result<(), Error> {
    use simba::simd::WideF64x4;
    let sets: [Parameters<f64>; 4] =
        core::array::from_fn(|lane| core::array::from_fn(|i| GENERIC[i] * (1.0 + 0.01 * (lane * (i % 5)) as f64)));
    let found = run::<WideF64x4>(core::array::from_fn(|i| WideF64x4::from(sets.map(|set| set[i]))))?;
    let mut same_bits = 0;
    for (lane, set) in sets.into_iter().enumerate() {
        let expected = run(set)?;
        for k in 0..5 {
            let found = found[k].into_arr()[lane];
            same_bits += usize::from(found.to_bits() == expected[k].to_bits());
            // The same operations in the same order.
            near(found, expected[k], 1e-14 * expected[k].abs());
        }
    }
    println!("{same_bits} of 20 readings have the same bits");
    Ok(())
}

#[test]
fn equilibria_have_derivatives_to_third_order() -> Result<(), Error> {
    // 5 q + p cos q = 0, of which the derivatives follow by differentiating: 5 q′ + (p c)′ = 0 and so on.
    fn rest<T: Scalar<Real = f64>>(p: T, guess: f64) -> Result<T, Error> {
        let n = T::literal;
        let hinge = ElasticHinge::rotary(n(5.0));
        let bob = PointMass::new(T::one(), n(1.0));
        let scene = System::new(Clamped::at(n(0.0), n(0.0), n(0.0)), (hinge, bob), Free)?.with_gravity(p);
        let found = scene.equilibrium(scene.at_rest(&[n(guess)])?, &Unloaded)?;
        Ok(found.coordinates()[0])
    }
    let p = 9.81_f64;
    let q = rest(p, -1.0)?;
    assert!((5.0 * q + p * q.cos()).abs() < 1e-14);
    let (s, c) = q.sin_cos();
    let slope = 5.0 - p * s;
    let first = -c / slope;
    let second = (p * c * first * first + 2.0 * s * first) / slope;
    let third =
        (3.0 * p * c * first * second - p * s * first.powi(3) + 3.0 * c * first * first + 3.0 * s * second) / slope;
    for guess in [q, 1.05 * q, -0.7] {
        let found = rest(num_dual::Dual3_64::new(p, 1.0, 0.0, 0.0), guess)?;
        for (found, expected) in [(found.re, q), (found.v1, first), (found.v2, second), (found.v3, third)] {
            assert!((found - expected).abs() < 1e-12, "{found} instead of {expected} from {guess}");
        }
    }
    Ok(())
}
