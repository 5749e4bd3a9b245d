//! Complex modes about steady motions, against characteristic polynomials of closed forms.

use catena::scalar::{Jet, Scalar};
use catena::{Error, Fault, planar::*, spatial};
use catena_oracle::{Noise, near};
use std::f64::consts::FRAC_PI_2;

const G: f64 = 9.81;

/// Growth and frequency of all modes.
fn eigenvalues<T: Scalar>(modes: &catena::modes::ComplexModes<T>) -> Vec<[f64; 2]> {
    modes.iter().map(|mode| [mode.growth(), mode.frequency()]).collect()
}

/// Roots of a z² + b z + c with complex b and c, as real and imaginary parts.
fn roots(a: f64, b: [f64; 2], c: [f64; 2]) -> [[f64; 2]; 2] {
    let times = |x: [f64; 2], y: [f64; 2]| [x[0] * y[0] - x[1] * y[1], x[0] * y[1] + x[1] * y[0]];
    let square = times(b, b);
    let d = [square[0] - 4.0 * a * c[0], square[1] - 4.0 * a * c[1]];
    let size = d[0].hypot(d[1]);
    let root = [((size + d[0]) * 0.5).sqrt(), ((size - d[0]) * 0.5).sqrt().copysign(d[1])];
    [1.0, -1.0].map(|sign| [0, 1].map(|k| (-b[k] + sign * root[k]) / (2.0 * a)))
}

fn light() -> RigidBody<f64> {
    RigidBody::new(1e-9, 1e-9, [0.0; 2], [0.0; 2])
}

#[test]
fn a_chain_with_dampers_has_roots_of_its_own_equations() -> Result<(), Error> {
    let mass = |m| RigidBody::new(m, 1.0, [0.0; 2], [0.0; 2]);
    let (m, k, c) = ([2.0, 0.7], [50.0, 30.0], [0.6, 3.0]);
    let track = |j: usize| Slider::along(0.0).with(Spring::new(k[j]).damped(c[j]));
    let scene = System::new(Clamped::origin(), (track(0), mass(m[0]), track(1), mass(m[1])), Free)?;
    let modes = scene.complex_modes(&scene.motion(), &Unloaded)?;
    assert_eq!(modes.len(), 2);
    for mode in modes.iter() {
        // Relative coordinates u, w: m₁ ü + k₁ u + c₁ u̇ = k₂ w + c₂ ẇ and m₂ (ü + ẅ) + k₂ w + c₂ ẇ = 0.
        let (s, w) = (mode.growth(), mode.frequency());
        let times = |[x, y]: [f64; 2], a: f64, b: f64| [a * x - b * y, a * y + b * x];
        let [u, v] = [mode.shape()[0], mode.shape()[1]];
        let (square, double) = (s * s - w * w, 2.0 * s * w);
        let force = |j: usize, x| times(x, k[j] + c[j] * s, c[j] * w);
        let [push, pull] = [force(0, u), force(1, v)];
        let [first, both] = [times(u, square, double), times([u[0] + v[0], u[1] + v[1]], square, double)];
        for part in [0, 1] {
            near(m[0] * first[part] + push[part] - pull[part], 0.0, 1e-11);
            near(m[1] * both[part] + pull[part], 0.0, 1e-11);
        }
        near(mode.damping_ratio(), -s / s.hypot(w), 1e-15);
    }
    Ok(())
}

#[test]
fn what_does_not_swing_comes_first() -> Result<(), Error> {
    let (inertia, damping, stiffness) = (2.0 / 3.0, 9.0, 1.5);
    let hinge = ElasticHinge::rotary(stiffness).damped(damping);
    let scene = System::new(Clamped::origin(), (hinge, Rod::uniform(1.0, 2.0)), Free)?;
    let found = eigenvalues(&scene.complex_modes(&scene.motion(), &Unloaded)?);
    let [slow, fast] = roots(inertia, [damping, 0.0], [stiffness, 0.0]);
    assert_eq!(found.len(), 2);
    for (found, expected) in found.iter().zip([fast, slow]) {
        near(found[0], expected[0], 1e-11);
        assert_eq!(found[1], 0.0);
    }
    Ok(())
}

/// A mass on springs along both axes of a platform that turns: with z = x + iy in its axes m (z̈ + 2iΩ ż − Ω² z) + c ż + k z = 0.
#[test]
fn modes_on_a_platform_that_turns_whirl() -> Result<(), Error> {
    let (m, k, c) = (2.0, 50.0, 0.3);
    let mass = RigidBody::new(m, 0.1, [0.0; 2], [0.0; 2]);
    let track = |angle| Slider::along(angle).with(Spring::new(k).damped(c));
    let frame = (light(), track(0.0), light(), track(FRAC_PI_2), mass);
    for rate in [0.0, 3.0, 7.0] {
        let turn = Driven::new(Revolute::smooth(), move |t: f64| [rate * t, rate, 0.0]);
        let driven = System::new(Clamped::origin(), (turn, frame), Free)?;
        let turning = Turning(move |t: f64| [rate * t, rate, 0.0]);
        let ground = System::new(Clamped::on([0.0; 2], turning), frame, Free)?;
        let both =
            [driven.complex_modes(&driven.motion(), &Unloaded)?, ground.complex_modes(&ground.motion(), &Unloaded)?];
        let mut expected = roots(m, [c, 2.0 * m * rate], [k - m * rate * rate, 0.0]).map(|x| [x[0], x[1].abs()]);
        expected.sort_by(|a, b| a[1].total_cmp(&b[1]));
        for modes in both {
            assert_eq!(modes.len(), 2);
            for (found, expected) in eigenvalues(&modes).iter().zip(expected) {
                // The bodies between are light, not without mass.
                near(found[0], expected[0], 1e-8);
                near(found[1], expected[1], 1e-8);
            }
            if rate > 0.0 {
                let [x, y] = [modes.get(1).unwrap().shape()[0], modes.get(1).unwrap().shape()[1]];
                // It circles: y leads or lags x by a quarter.
                near(x[0] * y[1] - x[1] * y[0], (x[0] * x[0] + x[1] * x[1]).copysign(x[0] * y[1] - x[1] * y[0]), 1e-6);
            }
        }
    }
    Ok(())
}

/// Two rods of length l with masses 2m and m at their ends, springs k, and a force along the second: flutter from P = (7/2 − √2) k/l.
#[test]
fn a_column_under_a_force_that_follows_it_flutters() -> Result<(), Error> {
    let column = |damping: f64| {
        let joint = ElasticHinge::rotary(1.0).damped(damping);
        let chain = (joint, PointMass::new(1.0, 2.0), joint, PointMass::new(1.0, 1.0));
        System::new(Clamped::origin(), chain, Free)
    };
    let growth = |damping: f64, push: f64| {
        let scene = column(damping)?;
        let follow = Loads::none().on_bodies(move |_: f64, body, motion: &BodyMotion<f64>| {
            let push = if body == 1 { [-push, 0.0] } else { [0.0; 2] };
            motion.force_at([1.0, 0.0], motion.turned(push).into())
        });
        Ok::<_, Error>(scene.complex_modes(&scene.motion(), &follow)?.largest_growth())
    };
    let critical = 3.5 - 2.0_f64.sqrt();
    assert!(growth(0.0, critical - 1e-4)?.abs() < 1e-8);
    assert!(growth(0.0, critical + 1e-4)? > 1e-3);
    // Slight damping destabilises it: alike in both joints, from 41/28 k/l on.
    let damped = 41.0 / 28.0;
    assert!(growth(1e-3, damped - 1e-2)? < -1e-7 && growth(1e-3, damped + 1e-2)? > 1e-7);
    Ok(())
}

/// With ζ the lean in inertial axes, J ζ̈ − i J₃ Ω ζ̇ − m g h ζ = 0; in axes of the top everything turns back at Ω.
#[test]
fn a_top_sleeps_or_does_not() -> Result<(), Error> {
    let (mass, height, across, along): (f64, f64, f64, f64) = (0.5, 0.1, 0.008, 0.002);
    let inertia =
        [[across - mass * height * height, 0.0, 0.0], [0.0, across - mass * height * height, 0.0], [0.0, 0.0, along]];
    let top = spatial::RigidBody::new(mass, inertia, [0.0, 0.0, height], [0.0, 0.0, height]);
    let scene = spatial::System::new(spatial::Pinned::origin(), top, spatial::Free)?.with_gravity([0.0, 0.0, -G]);
    for spin in [120.0, 60.0] {
        let start = scene.with_rates(scene.motion(), &[0.0, 0.0, spin])?;
        let found = eigenvalues(&scene.complex_modes(&start, &Unloaded)?);
        // μ of ζ = exp(iμt): J μ² − J₃ Ω μ + m g h = 0
        let both = roots(across, [-along * spin, 0.0], [mass * G * height, 0.0]);
        let mut expected: Vec<[f64; 2]> = both.iter().map(|mu| [-mu[1], (mu[0] - spin).abs()]).collect();
        expected.sort_by(|a, b| (a[1], a[0]).partial_cmp(&(b[1], b[0])).unwrap());
        // And spin itself, faster and ahead.
        let mut found: Vec<_> = found.into_iter().filter(|x| x[1] > 1.0).collect();
        assert_eq!(found.len(), 2);
        if spin < 100.0 {
            // Both have one frequency.
            found.sort_by(|a, b| a[0].total_cmp(&b[0]));
            expected.sort_by(|a, b| a[0].total_cmp(&b[0]));
        }
        for (found, expected) in found.iter().zip(&expected) {
            near(found[0], expected[0], 1e-8);
            near(found[1], expected[1], 1e-9);
        }
        assert_eq!(found.iter().any(|x| x[0] > 1.0), spin < 100.0);
    }
    Ok(())
}

/// A bob on a rod that circles freely at ψ̇ = Ω: what it nods by obeys ω² = Ω² (1 + 3 cos² θ).
#[test]
fn a_bob_nods_as_it_circles() -> Result<(), Error> {
    use spatial::{Clamped, Free, Revolute, RigidBody, System};
    let (length, rate): (f64, f64) = (0.7, 6.0);
    let cosine = G / (length * rate * rate);
    let thin = |m: f64| {
        RigidBody::new(m, [[1e-12, 0.0, 0.0], [0.0, 1e-12, 0.0], [0.0, 0.0, 1e-12]], [0.0, 0.0, -length], [0.0; 3])
    };
    let post = RigidBody::new(1e-12, [[1e-12, 0.0, 0.0], [0.0, 1e-12, 0.0], [0.0, 0.0, 1e-12]], [0.0; 3], [0.0; 3]);
    let chain = (Revolute::about([0.0, 0.0, 1.0]), post, Revolute::about([0.0, 1.0, 0.0]), thin(2.0));
    let scene = System::new(Clamped::origin(), chain, Free)?.with_gravity([0.0, 0.0, -G]);
    let mut start = scene.motion();
    start.set_coordinates(&[0.0, cosine.acos()])?;
    let start = scene.with_rates(start, &[rate, 0.0])?;
    let modes = scene.complex_modes(&start, &Unloaded)?;
    let last = modes.iter().last().unwrap();
    near(last.frequency(), rate * (1.0 + 3.0 * cosine * cosine).sqrt(), 1e-7);
    near(last.growth(), 0.0, 1e-7);
    // At another angle it does not go on.
    let mut off = scene.motion();
    off.set_coordinates(&[0.0, cosine.acos() + 0.01])?;
    let off = scene.with_rates(off, &[rate, 0.0])?;
    let error = scene.complex_modes(&off, &Unloaded).unwrap_err();
    println!("{error}");
    assert!(matches!(error.fault, Fault::NotSteady { acceleration } if (0.01..1.0).contains(&acceleration)));
    Ok(())
}

/// A top on three hinges that leans by θ and precesses steadily, slowly or fast, nods by the curvature of
/// V(θ) = (p_φ − p_ψ cos θ)² / (2 A sin² θ) + m g h cos θ.
#[test]
fn a_top_nods_as_it_precesses() -> Result<(), Error> {
    use spatial::{Clamped, Free, Revolute, RigidBody, System};
    let (mass, height, across, along): (f64, f64, f64, f64) = (0.5, 0.1, 0.008, 0.002);
    let centre = across - mass * height * height;
    let inertia = [[centre, 0.0, 0.0], [0.0, centre, 0.0], [0.0, 0.0, along]];
    let top = RigidBody::new(mass, inertia, [0.0, 0.0, height], [0.0, 0.0, height]);
    let ring = RigidBody::massless([0.0; 3]);
    let [upright, level] = [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]].map(Revolute::about);
    let scene = System::new(Clamped::origin(), (upright, ring, level, ring, upright, top), Free)?;
    let scene = scene.with_gravity([0.0, 0.0, -G]);
    let weight = mass * G * height;
    for lean in [0.4, 0.9, 1.4_f64] {
        for precession in [0.5, 1.0, 3.0, 10.0, 30.0, 100.0_f64] {
            let spin = (weight + across * precession * precession * lean.cos()) / (precession * along);
            let (about_axis, about_vertical) =
                (along * spin, along * spin * lean.cos() + across * precession * lean.sin().powi(2));
            let slope = |angle: f64| {
                let (sine, cosine) = angle.sin_cos();
                let left = about_vertical - about_axis * cosine;
                left * about_axis / (across * sine) - left * left * cosine / (across * sine.powi(3)) - weight * sine
            };
            let h = 1e-4;
            let curvature = (8.0 * (slope(lean + h) - slope(lean - h)) - slope(lean + 2.0 * h) + slope(lean - 2.0 * h))
                / (12.0 * h);
            let mut start = scene.motion();
            start.set_coordinates(&[0.3, lean, 0.7])?;
            let start = scene.with_rates(start, &[precession, 0.0, spin - precession * lean.cos()])?;
            let modes = scene.complex_modes(&start, &Unloaded)?;
            let found = modes.iter().last().map_or(f64::NAN, |mode| mode.frequency());
            near(found, (curvature / across).sqrt(), 1e-7 * (1.0 + found));
        }
    }
    Ok(())
}

/// Two cranks and a coupler on a table that turns, the cranks straight out: J λ² + c λ + k + Ω² e l (m + M) = 0, over any numbers.
macro_rules! parallelogram {
    ($length:expr, $number:expr) => {{
        let n = $number;
        let (crank, coupler) = (Rod::uniform($length, n(1.0)), Rod::uniform(n(0.3), n(2.0)));
        let foot = |y: f64| RigidBody::massless([n(0.2), n(y)]);
        let hinge = ElasticHinge::rotary(n(3.0)).damped(n(0.2));
        let turn = Driven::new(Revolute::smooth(), move |t: f64| [n(RATE * t), n(RATE), n(0.0)]);
        let table = RigidBody::new(n(1.0), n(1.0), [n(0.0); 2], [n(0.0); 2]);
        let main = (foot(-0.15), hinge, crank, Revolute::smooth(), coupler);
        let side = (foot(0.15), Revolute::smooth(), crank);
        let net = Network::new(main, side, Pin);
        System::new(Clamped::origin(), (turn, table, net), Free)?
    }};
}
const RATE: f64 = 5.0;

#[test]
fn a_parallelogram_on_a_table_has_the_root_of_its_one_equation() -> Result<(), Error> {
    let root = |length: f64| {
        let inertia = (2.0 / 3.0 + 2.0) * length * length;
        let [_, upper] = roots(inertia, [0.2, 0.0], [3.0 + RATE * RATE * 0.2 * length * 3.0, 0.0]);
        [upper[0], upper[1].abs()]
    };
    let scene = parallelogram!(Jet::<f64, 1>::seed(0.4, 0), Jet::of);
    let mut start = scene.motion();
    start.set_coordinates(&[Jet::of(0.0), Jet::of(FRAC_PI_2), Jet::of(0.0)])?;
    let start = scene.assembled(start, &Unloaded)?;
    let modes = scene.complex_modes(&start, &Unloaded)?;
    assert_eq!(modes.len(), 1);
    let mode = modes.get(0).unwrap();
    let (expected, [ahead, behind]) = (root(0.4), [1e-5, -1e-5].map(|step| root(0.4 + step)));
    for (k, found) in mode.with_derivatives().into_iter().enumerate() {
        near(found.re, expected[k], 1e-10);
        near(found.eps[0], (ahead[k] - behind[k]) / 2e-5, 1e-8);
    }
    // All turn alike against the table but the coupler, which does not turn.
    let shape: Vec<f64> = mode.shape().iter().map(|x| x[0]).collect();
    for (found, expected) in shape.iter().zip([1.0, -1.0, 1.0]) {
        near(found * shape[0].signum(), expected, 1e-9);
    }
    Ok(())
}

#[test]
fn derivatives_are_those_of_the_roots() -> Result<(), Error> {
    let of = Jet::<f64, 3>::of;
    // Stiffness, damping, and the rate of the platform.
    let (k, c, rate) = (Jet::seed(50.0, 0), Jet::seed(0.3, 1), Jet::<f64, 3>::seed(3.0, 2));
    let mass = RigidBody::new(of(2.0), of(0.1), [of(0.0); 2], [of(0.0); 2]);
    let light = RigidBody::new(of(1e-9), of(1e-9), [of(0.0); 2], [of(0.0); 2]);
    let track = |angle| Slider::along(of(angle)).with(Spring::new(k).damped(c));
    let turn = Driven::new(Revolute::smooth(), move |t: f64| [rate * of(t), rate, of(0.0)]);
    let chain = (turn, light, track(0.0), light, track(FRAC_PI_2), mass);
    let scene = System::new(Clamped::origin(), chain, Free)?;
    let modes = scene.complex_modes(&scene.motion(), &Unloaded)?;
    let roots = |k: f64, c: f64, rate: f64| {
        let mut all = roots(2.0, [c, 4.0 * rate], [k - 2.0 * rate * rate, 0.0]).map(|x| [x[0], x[1].abs()]);
        all.sort_by(|a, b| a[1].total_cmp(&b[1]));
        all
    };
    let h = 1e-5;
    let pairs = [0, 1, 2].map(|j| {
        [h, -h].map(|step| {
            let by = |other, at: f64| if other == j { at + step } else { at };
            roots(by(0, 50.0), by(1, 0.3), by(2, 3.0))
        })
    });
    for (number, mode) in modes.iter().enumerate() {
        for (part, found) in mode.with_derivatives().into_iter().enumerate() {
            for (j, [ahead, behind]) in pairs.iter().enumerate() {
                near(found.eps[j], (ahead[number][part] - behind[number][part]) / (2.0 * h), 1e-7);
            }
        }
    }
    Ok(())
}

#[test]
fn undamped_they_are_modes_at_rest() -> Result<(), Error> {
    use spatial::{Ball, Pinned, Rod, Rotation, System};
    let rod = Rod::uniform(0.4, 0.02, 0.8);
    let chain = System::new(Pinned::origin(), (rod, [(Ball, rod); 3]), Pinned::at([1.0, 0.3, 0.0]))?;
    let chain = chain.with_gravity([0.0, 0.0, -G]);
    let bent = [0.9, 0.4, -0.3, -0.8].into_iter().enumerate().try_fold(chain.motion(), |motion, (body, angle)| {
        chain.with_body_orientation(motion, body, Rotation::exp([0.0, angle, 0.0]))
    })?;
    let rest = chain.equilibrium(bent, &Unloaded)?;
    let expected: Vec<f64> = chain.modes(&rest, &Unloaded)?.frequencies().filter(|w| *w > 0.1).collect();
    let modes = chain.complex_modes(&rest, &Unloaded)?;
    let found: Vec<_> = modes.iter().filter(|mode| mode.frequency() > 0.1).collect();
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        near(found.frequency(), expected, 1e-7);
        near(found.growth(), 0.0, 1e-7);
    }
    Ok(())
}

/// Chains of four rods on balls, thick and thin, hanging from one end or both: real and complex modes are found in different ways.
#[test]
fn random_ropes_have_both_kinds_of_modes() -> Result<(), Error> {
    use spatial::{Ball, Free, Pinned, Rod, Rotation, System};
    let mut random = Noise::new(7);
    for k in 0..40 {
        let radius = 10f64.powf(random.between(-3.5, -1.0));
        let mut rod = || Rod::uniform(random.between(0.2, 1.2), radius, random.between(0.2, 1.2));
        let chain = (rod(), [(Ball, rod()), (Ball, rod()), (Ball, rod())]);
        macro_rules! check {
            ($tip:expr, $lean:expr) => {{
                let scene = System::new(Pinned::origin(), chain, $tip)?.with_gravity([0.0, 0.0, -G]);
                let bent = [0.9, 0.4, -0.3, -0.8].into_iter().enumerate().try_fold(
                    scene.motion(),
                    |motion, (body, angle)| {
                        scene.with_body_orientation(motion, body, Rotation::exp([0.0, angle + $lean, 0.0]))
                    },
                )?;
                let rest = scene.equilibrium(bent, &Unloaded)?;
                let expected: Vec<f64> = scene.modes(&rest, &Unloaded)?.frequencies().filter(|w| *w > 0.3).collect();
                let modes = scene.complex_modes(&rest, &Unloaded)?;
                let found: Vec<f64> = modes.iter().map(|mode| mode.frequency()).filter(|w| *w > 0.3).collect();
                assert_eq!(found.len(), expected.len(), "{k}");
                found.iter().zip(&expected).for_each(|(found, expected)| near(*found, *expected, 1e-10 * expected));
            }};
        }
        if k % 2 == 0 { check!(Pinned::at([0.9, 0.2, 0.0]), 0.0) } else { check!(Free, 1.5) }
    }
    Ok(())
}

#[test]
fn what_changes_with_time_has_none() -> Result<(), Error> {
    let mass = RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
    // A rotor with two blades on supports along one axis alone.
    let support = Slider::along(0.0).with(Spring::new(100.0));
    let turn = Driven::new(Revolute::smooth(), |t: f64| [4.0 * t, 4.0, 0.0]);
    let blade = Slider::along(0.0).with(Spring::new(50.0));
    let rotor = System::new(Clamped::origin(), (support, mass, turn, light(), blade, mass), Free)?;
    let error = rotor.complex_modes(&rotor.motion(), &Unloaded).unwrap_err();
    println!("{error}");
    assert!(matches!(error.fault, Fault::Unsupported { what } if what.contains("functions of time")));
    // A drive that speeds up.
    let turn = Driven::new(Revolute::smooth(), |t: f64| [2.0 * t * t, 4.0 * t, 4.0]);
    let rotor =
        System::new(Clamped::origin(), (turn, light(), Slider::along(0.0).with(Spring::new(50.0)), mass), Free)?;
    let error = rotor.complex_modes(&rotor.motion(), &Unloaded).unwrap_err();
    assert!(matches!(error.fault, Fault::Unsupported { .. } | Fault::NotSteady { .. }), "{error}");
    // A ball that precesses.
    let top =
        spatial::RigidBody::new(0.5, [[0.01, 0.0, 0.0], [0.0, 0.01, 0.0], [0.0, 0.0, 0.02]], [0.0, 0.0, 0.1], [0.0; 3]);
    let top = spatial::System::new(spatial::Pinned::origin(), top, spatial::Free)?;
    let start = top.with_rates(top.motion(), &[1.0, 0.0, 10.0])?;
    assert!(matches!(top.complex_modes(&start, &Unloaded).unwrap_err().fault, Fault::NotSteady { .. }));
    Ok(())
}

/// m λ² + c λ + k = 0 about critical damping, where both roots and their vectors become one.
#[test]
fn real_roots_are_found_however_near() -> Result<(), Error> {
    let mut random = Noise::new(11);
    for k in 0..600 {
        let (mass, rate) = (random.between(0.1, 5.0), random.between(0.5, 30.0));
        // One in three critical but for rounding.
        let more = if k % 3 == 0 { 0.0 } else { 10f64.powf(random.between(-9.0, 1.0)) };
        let damping = 2.0 * mass * rate * (1.0 + more);
        let body = RigidBody::new(mass, 1.0, [0.0; 2], [0.0; 2]);
        let track = Slider::along(0.0).with(Spring::new(mass * rate * rate).damped(damping));
        let scene = System::new(Clamped::origin(), (track, body), Free)?;
        let found = eigenvalues(&scene.complex_modes(&scene.motion(), &Unloaded)?);
        let half = 0.5 * damping / mass;
        let apart = (half * half - rate * rate).max(0.0).sqrt();
        // A double root is known to the root of rounding.
        let tolerance = 1e-12 * (1.0 + half) + (1e-11 * rate * rate / apart.max(1e-5 * rate)).min(1e-6 * rate);
        for (number, [growth, frequency]) in found.iter().enumerate() {
            let sign = if found.len() == 1 { 0.0 } else { 2.0 * number as f64 - 1.0 };
            near(*growth, -half + sign * apart, tolerance.max(if found.len() == 1 { 1e-6 * rate } else { 0.0 }));
            assert!(*frequency < 1e-6 * rate, "{growth} {frequency}");
        }
    }
    Ok(())
}

/// A shaft of two rods, elastic in the middle, that spins freely between balls: J z̈ − i J₃ Ω ż + 2 k z = 0, in axes that do not turn.
#[test]
fn a_shaft_between_balls_whirls() -> Result<(), Error> {
    use spatial::{ElasticHinge, Pinned, Prismatic, RigidBody, Rod, System};
    let small = RigidBody::new(1e-3, [[1e-12, 0.0, 0.0], [0.0, 1e-12, 0.0], [0.0, 0.0, 1e-12]], [0.0; 3], [0.0; 3]);
    let (length, radius, mass, stiffness) = (0.5, 0.05, 3.0, 60.0);
    let rod = Rod::uniform(length, radius, mass);
    let bend = ElasticHinge::rotary([40.0, stiffness, stiffness]);
    let chain = (rod, bend, rod, Prismatic::along([1.0, 0.0, 0.0]), small);
    let scene = System::new(Pinned::origin(), chain, Pinned::at([1.0, 0.0, 0.0]))?;
    for spin in [0.0, 30.0, 300.0] {
        let mut start = scene.motion();
        for body in 0..2 {
            start = scene.with_body_spin(start, body, catena::system::AngularVelocity::Inertial([spin, 0.0, 0.0]))?;
        }
        let start = scene.assembled(start, &Unloaded)?;
        let modes = scene.complex_modes(&start, &Unloaded)?;
        // Each rod turns by z about its ball, the hinge by 2 z: 4 k z on both together.
        let along = 0.5 * mass * radius * radius;
        let about = mass * (length * length / 3.0 + radius * radius / 4.0);
        let both = roots(about, [-along * spin, 0.0], [-2.0 * stiffness, 0.0]).map(|mu| (mu[0] - spin).abs());
        for expected in both {
            let nearest = modes.iter().map(|mode| (mode.frequency() - expected).abs()).fold(f64::INFINITY, f64::min);
            println!("{spin}: {expected} found but for {nearest:.1e}");
            assert!(nearest < 1e-6 * (1.0 + expected), "{spin}: {expected} {:?}", eigenvalues(&modes));
        }
        assert!(modes.largest_growth() < 1e-3, "{:?}", eigenvalues(&modes));
    }
    Ok(())
}

/// Beside something stiff, which makes all else look small.
#[test]
fn what_is_not_steady_is_refused_beside_what_is_stiff() -> Result<(), Error> {
    let (rod, mass) = (Rod::uniform(1.0, 1.0), RigidBody::new(1.0, 0.1, [0.0; 2], [0.0; 2]));
    for stiffness in [1e2, 1e4, 1e6, 1e8, 1e10] {
        let aside = || Branch((Slider::along(0.0).with(Spring::new(stiffness)), mass));
        // A pendulum aside, and one at rest.
        let scene = System::new(Clamped::origin(), (aside(), Revolute::smooth(), rod), Free)?.with_gravity(G);
        for (angle, rests) in [(-0.785, false), (-FRAC_PI_2, true)] {
            let found = scene.complex_modes(&scene.at_rest(&[angle])?, &Unloaded);
            match found {
                Ok(modes) if rests => {
                    assert!(modes.iter().any(|mode| (mode.frequency() - (1.5 * G).sqrt()).abs() < 1e-3))
                }
                Err(error) if !rests => assert!(matches!(error.fault, Fault::NotSteady { .. }), "{error}"),
                other => panic!("{stiffness} {angle}: {other:?}"),
            }
        }
        // A rotor with two blades on a support along one axis.
        let support = Slider::along(0.0).with(Spring::new(100.0));
        let turn = Driven::new(Revolute::smooth(), |t: f64| [4.0 * t, 4.0, 0.0]);
        let blade = Slider::along(0.0).with(Spring::new(50.0));
        let rotor = System::new(Clamped::origin(), (aside(), support, mass, turn, light(), blade, mass), Free)?;
        let error = rotor.complex_modes(&rotor.motion(), &Unloaded).expect_err("its coefficients change");
        assert!(matches!(error.fault, Fault::Unsupported { what } if what.contains("functions of time")), "{error}");
    }
    Ok(())
}

/// 1 kg on two springs of 100 N/m in a row, something light between them, and a spring that it touches on one side: right where it rests there are no
/// modes, and of a spring on both sides those of all.
#[test]
fn kinks_are_noticed_beside_light_bodies() -> Result<(), Error> {
    for (light, more) in [(1.0, 1e2), (0.1, 1e2), (1e-2, 1e3), (1e-4, 1e4), (1e-6, 1e5)] {
        let body = |mass| RigidBody::new(mass, mass, [0.0; 2], [0.0; 2]);
        let track = Slider::along(0.0).with(Spring::new(100.0));
        let scene = System::new(Clamped::origin(), (track, body(light), track, body(1.0)), Free)?;
        for both in [false, true] {
            let push = Loads::none().on_bodies(move |_: f64, number, motion: &BodyMotion<f64>| {
                let place = motion.inboard.place.x;
                let felt = if number == 1 && (both || place > 0.0) { place } else { 0.0 };
                motion.force_at([0.0; 2], [-more * felt, 0.0])
            });
            let (found, complex) = (scene.modes(&scene.motion(), &push), scene.complex_modes(&scene.motion(), &push));
            if both {
                // The light one follows: (2·100 − m ω²)(100 + k − ω²) = 100².
                let (a, b, c) = (light, -(200.0 + light * (100.0 + more)), 200.0 * (100.0 + more) - 1e4);
                let root = (b * b - 4.0 * a * c).sqrt();
                let expected = (2.0 * c / (-b + root)).sqrt();
                near(found?.frequencies().next().unwrap_or(f64::NAN), expected, 1e-6 * expected);
                near(complex?.get(0).map_or(f64::NAN, |mode| mode.frequency()), expected, 1e-6 * expected);
            } else {
                for error in [found.map(|_| ()), complex.map(|_| ())].map(Result::unwrap_err) {
                    assert!(
                        matches!(error.fault, Fault::Unsupported { what } if what.contains("kink")),
                        "{light}: {error}"
                    );
                }
            }
        }
    }
    Ok(())
}

#[test]
fn single_precision_has_them_too() -> Result<(), Error> {
    let hinge = ElasticHinge::rotary(2.0_f32).damped(0.1);
    let scene = System::new(Clamped::origin(), (hinge, Rod::uniform(1.0, 3.0)), Free)?;
    let modes = scene.complex_modes(&scene.motion(), &Unloaded)?;
    near(modes.get(0).unwrap().growth(), -0.05, 1e-5);
    near(modes.get(0).unwrap().frequency(), (2.0_f64 - 0.05 * 0.05).sqrt(), 1e-4);
    Ok(())
}
