//! Derivatives through kept gains: against dual numbers through the same steps, differences and closed forms. Derivative parts are
//! compared one by one.

use super::sensitivities::{FIXED, Parts, ROUNDING, alike, as_dual_numbers, parts};
use catena::planar::*;
use catena::scalar::Jet;
use catena::{Error, Scalar};
use nalgebra::Vector2;
use num_dual::DualSVec64;

#[test]
fn bodies_ends_gravity_state_and_torques_have_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("all parameters", 23 seeds, Rk4::step(0.01), 0.5, |x| {
        let plate = RigidBody::new(x(1.3, 0), x(0.2, 1), [x(0.4, 2), x(0.15, 3)], [x(0.9, 4), x(-0.2, 5)]);
        let rod = Rod::new(x(0.7, 6), x(0.8, 7), x(0.3, 8), x(0.15, 9));
        let chain = (plate, Pin, rod, Pin, PointMass::new(x(0.6, 10), x(0.5, 11)));
        let root = Pinned::at(x(0.3, FIXED), x(-0.4, FIXED));
        let system = System::new(root, chain, Free)?.with_gravity_vector(Vector2::new(x(1.1, 12), x(-9.0, 13)));
        let start = system.at_rest(&[x(-0.8, 16), x(0.5, 17), x(-1.9, 18)])?;
        let start = system.with_rates(start, &[x(0.6, 19), x(-0.9, 20), x(1.4, 21)])?;
        let torques = [x(0.7, 22), x(-0.4, 14), x(0.3, 15)];
        (system, start, Loads::none().torques(torques))
    });
    Ok(())
}

#[test]
fn springs_welds_and_clamps_have_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("springs", 20 seeds, Dop853::tolerance(1e-9), 0.7, |x| {
        let plate = RigidBody::new(x(1.3, 0), x(0.2, 1), [x(0.4, 2), x(0.15, 3)], [x(0.9, 4), x(-0.2, 5)]);
        let hinge = ElasticHinge::rotary(x(30.0, 6)).damped(x(0.3, 7)).resting_at(x(0.2, 8));
        let rod = Rod::uniform(x(0.7, 9), x(0.8, 10));
        let other = ElasticHinge::rotary(x(20.0, 11));
        let chain = (hinge, plate, other, rod, Weld::at(x(0.6, 12)), rod, Pin, PointMass::new(x(0.4, 13), x(0.3, 14)));
        let root = Clamped::at(x(0.0, FIXED), x(0.0, FIXED), x(0.3, 15));
        let system = System::new(root, chain, Free)?.with_gravity(x(9.81, 16));
        let start = system.at_rest(&[x(0.1, FIXED), x(0.5, 17), x(-0.4, FIXED)])?;
        let start = system.with_rates(start, &[x(0.6, FIXED), x(-0.9, 18), x(1.4, 19)])?;
        (system, start, Unloaded)
    });
    Ok(())
}

#[test]
fn chains_that_float_have_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("afloat", 30 seeds, Rk4::step(0.01), 0.5, |x| {
        let rod = Rod::new(x(0.7, 0), x(0.8, 1), x(0.3, 2), x(0.15, 3));
        let plate = RigidBody::new(x(1.3, 4), x(0.2, 5), [x(0.4, 6), x(0.15, 7)], [x(0.9, 8), x(-0.2, 9)]);
        let hinge = ElasticHinge::rotary(x(30.0, 10)).damped(x(0.3, 11)).resting_at(x(0.2, 12));
        let bob = PointMass::new(x(0.4, 13), x(0.3, 14));
        let chain = (rod, Branch((Pin, rod, Slider::along(x(0.5, 15)), bob)), hinge, plate, Pin, bob);
        let system = System::new(Free, chain, Free)?.with_gravity_vector(Vector2::new(x(1.1, 16), x(-9.0, 17)));
        let numbers = [0.2, -0.3, 0.6, 0.5, 0.1, -0.4, 0.9];
        let mut start = system.motion();
        start.set_coordinates(&core::array::from_fn::<_, 7, _>(|i| x(numbers[i], if i < 5 { 18 + i } else { FIXED })))?;
        let rates = [0.6, -0.9, 1.4, -0.3, 0.8, 0.7, -1.1];
        start.set_rates(&core::array::from_fn::<_, 7, _>(|i| x(rates[i], if i < 5 { 23 + i } else { FIXED })))?;
        let torques = [x(0.7, 28), x(-0.4, FIXED), x(0.0, FIXED), x(0.3, 29), x(0.2, FIXED)];
        (system, start, Loads::none().torques(torques))
    });
    // The mass of a single body does nothing.
    as_dual_numbers!("a falling rod", 7 seeds, Dop853::tolerance(1e-9), 0.7, |x| {
        let system = System::new(Free, Rod::uniform(x(0.7, 0), x(0.8, FIXED)), Free)?.with_gravity(x(9.81, 1));
        let mut start = system.motion();
        start.set_coordinates(&[x(0.1, 2), x(0.5, 3), x(-0.4, 4)])?;
        start.set_rates(&[x(0.6, FIXED), x(-0.9, 5), x(1.4, 6)])?;
        (system, start, Unloaded)
    });
    Ok(())
}

#[test]
fn sliders_have_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("sliders", 26 seeds, Rk4::step(0.01), 0.5, |x| {
        let plate = RigidBody::new(x(1.3, 0), x(0.2, 1), [x(0.4, 2), x(0.15, 3)], [x(0.9, 4), x(-0.2, 5)]);
        let rod = Rod::uniform(x(0.7, 6), x(0.8, 7));
        let track = Slider::along(x(0.3, 8)).with(Spring::new(x(30.0, 9)).damped(x(0.3, 10)).resting_at(x(0.2, 11)));
        let (spindle, bob) = (Slider::along(x(-0.7, 12)), PointMass::new(x(0.4, 13), x(0.3, 14)));
        let hinge = ElasticHinge::rotary(x(20.0, 15));
        // Of a point mass nothing but its mass at its inboard end is left to the slider; a hinge outboard turns what slides.
        let arm = Branch((Pin, rod, Slider::along(x(0.5, FIXED)), bob));
        let chain = (track, plate, Pin, rod, spindle, rod, arm, hinge, plate, Slider::along(x(1.1, FIXED)), rod, Pin, bob);
        let root = Clamped::at(x(0.0, FIXED), x(0.0, FIXED), x(0.2, 16));
        let system = System::new(root, chain, Free)?.with_gravity(x(9.81, 17));
        let mut start = system.motion();
        let numbers = [0.3, 0.5, -0.4, 0.2, 0.1, -0.6, 0.25, -0.9];
        let rates = [0.6, -0.9, 1.4, -0.3, 0.8, 0.7, -1.1, 0.4];
        start.set_coordinates(&core::array::from_fn::<_, 8, _>(|i| x(numbers[i], if i < 4 { 18 + i } else { FIXED })))?;
        start.set_rates(&core::array::from_fn::<_, 8, _>(|i| x(rates[i], if i > 4 { 18 + i - 1 } else { FIXED })))?;
        let torques: [N; 9] = core::array::from_fn(|i| x(0.2 * i as f64 - 0.5, if i == 5 { 25 } else { FIXED }));
        (system, start, Loads::none().torques(torques))
    });
    Ok(())
}

#[test]
fn arms_arrays_and_vectors_have_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("a tree", 7 seeds, Rk4::step(0.01), 0.5, |x| {
        let rod = |i: usize| Rod::uniform(x(0.5, i), x(1.0, FIXED));
        let arm = Branch(([(Pin, rod(0)); 2], Branch((Pin, rod(1))), Pin, rod(2), ElasticHinge::rotary(x(5.0, 3)), rod(FIXED)));
        let chain = (rod(4), [arm.clone(), arm], vec![(Pin, rod(5)); 3]);
        let system = System::new(Pinned::at(x(0.0, FIXED), x(0.0, FIXED)), chain, Free)?.with_gravity(x(9.81, 6));
        let angles: [N; 14] = core::array::from_fn(|i| x(-0.2 * i as f64, FIXED));
        let start = system.at_rest(&angles)?;
        (system, start, Unloaded)
    });
    Ok(())
}

#[test]
fn a_ground_that_moves_and_turns_has_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("moving ground", 4 seeds, Dopri5::step(0.01), 0.5, |x| {
        let rod = Rod::uniform(x(0.7, FIXED), x(0.8, FIXED));
        let [amplitude, lift, swing] = [x(0.3, 0), x(0.2, 1), x(0.4, 2)];
        let place = Moving(move |t: f64| {
            let (s, c) = t.sin_cos();
            let scaled = |s: f64| [amplitude.scale(s), lift.scale(-s)];
            GroundMotion { place: scaled(s), velocity: scaled(c), acceleration: scaled(-s) }
        });
        let attitude = Turning(move |t: f64| [t.cos(), -t.sin(), -t.cos()].map(|f| swing.scale(f)));
        let root = Clamped { place, attitude };
        let system = System::new(root, (rod, Pin, rod, ElasticHinge::rotary(x(9.0, 3)), rod), Free)?;
        let start = system.at_rest(&[x(0.5, FIXED), x(-0.4, FIXED)])?;
        (system, start, Unloaded)
    });
    Ok(())
}

#[test]
fn loads_that_depend_on_seeds_and_motion_have_the_derivatives_of_dual_numbers() -> Result<(), Error> {
    as_dual_numbers!("loads", 6 seeds, Rk4::step(0.01), 0.5, |x| {
        let rod = Rod::uniform(x(0.7, FIXED), x(0.8, FIXED));
        let system = System::new(Pinned::origin(), (rod, Pin, rod, ElasticHinge::rotary(x(3.0, 5)), rod), Free)?;
        let start = system.at_rest(&[x(0.5, FIXED), x(-0.4, 0), x(0.9, 1)])?;
        let (friction, thrust) = (x(0.2, 2), [x(0.7, 3), x(-0.3, 4)]);
        let loads = Loads::none()
            .in_joints(move |_, _, motion: &JointMotion<N>| -friction * motion.rate())
            .on_bodies(move |time: f64, _, motion: &BodyMotion<N>| {
                motion.force_at([x(0.3, FIXED), x(0.1, FIXED)], thrust.map(|x| x.scale(time)))
            });
        (system, start, loads)
    });
    Ok(())
}

/// A number over plain ones: no derivatives.
fn fixed<const K: usize>(value: f64) -> Jet<f64, K> {
    Jet::of(value)
}

/// Runs a test with room: without optimisation, numbers with forty derivatives need more of the stack than a thread of a test has.
fn with_room(test: fn() -> Result<(), Error>) -> Result<(), Error> {
    let thread = std::thread::Builder::new().stack_size(1 << 25).spawn(test).expect("a thread");
    thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
}

#[test]
fn all_initial_values_of_twenty_rods_have_the_derivatives_of_central_differences() -> Result<(), Error> {
    with_room(twenty_rods)
}

fn twenty_rods() -> Result<(), Error> {
    const N: usize = 20;
    let links = [(Pin, Rod::uniform(0.05, 0.05)); N - 1];
    let plain = System::new(Pinned::origin(), (Rod::uniform(0.05, 0.05), links), Free)?.with_gravity(9.81);
    let rule = Rk4::step(1e-3);
    let system = plain.lift(fixed::<40>);
    let start = system.with_seeds(system.at_rest(&core::array::from_fn::<_, N, _>(|i| fixed(-0.1 * i as f64)))?, 0);
    let found = parts(&system.simulate(start, rule.through_gains(), 0.1, |_| ())?.motion);
    let end = |seed: usize, by: f64| -> Result<Vec<f64>, Error> {
        let mut state = [0.0; 2 * N];
        (0..N).for_each(|i| state[i] = -0.1 * i as f64);
        state[seed] += by;
        let start = plain.with_rates(plain.at_rest(&state[..N])?, &state[N..])?;
        let motion = plain.simulate(start, rule, 0.1, |_| ())?.motion;
        let mut numbers = vec![];
        catena::system::Position::visit(motion.position(), &mut |x| numbers.push(x));
        catena::system::Rate::visit(motion.rate(), &mut |x| numbers.push(x));
        Ok(numbers)
    };
    // h² leaves 1e-8 of a third derivative, rounding 1e-15 / h of values up to a hundred.
    let h = 1e-4;
    for seed in 0..2 * N {
        let (more, less) = (end(seed, h)?, end(seed, -h)?);
        let size = found.iter().fold(0.0_f64, |size, x| size.max(x[seed + 1].abs()));
        for (i, (more, less)) in more.iter().zip(&less).enumerate() {
            let expected = (more - less) / (2.0 * h);
            let error = (found[i][seed + 1] - expected).abs() / size;
            assert!(error < 1e-6, "number {i} by seed {seed}: {} not {expected}", found[i][seed + 1]);
        }
    }
    Ok(())
}

#[test]
fn a_torsional_oscillator_has_the_derivatives_of_its_closed_form() -> Result<(), Error> {
    // θ'' = −(k/J) θ with J = m l²/3: θ = a cos wt + (b/w) sin wt, w = √(k/J). Seeds: k, m, l, a, b.
    let [k, m, l, a, b, t]: [f64; 6] = [7.0, 1.3, 0.8, 0.4, -0.9, 1.7];
    let seed = |value: f64, k: usize| Jet::<f64, 5>::seed(value, k);
    let rod = Rod::uniform(seed(l, 2), seed(m, 1));
    let root = Clamped::at(fixed(0.0), fixed(0.0), fixed(0.0));
    let hinge = ElasticHinge::rotary(seed(k, 0));
    // The hinge needs no body inboard: the ground is one.
    let system = System::new(root, (hinge, rod), Free)?;
    let start = system.with_rates(system.at_rest(&[seed(a, 3)])?, &[seed(b, 4)])?;
    let end = system.simulate(start, Dop853::tolerance(1e-13).through_gains(), t, |_| ())?.motion;
    let w = (3.0 * k / (m * l * l)).sqrt();
    let (s, c) = (w * t).sin_cos();
    let by_w = -a * t * s + b * (t * c / w - s / (w * w));
    let expected = [by_w * w / (2.0 * k), -by_w * w / (2.0 * m), -by_w * w / l, c, s / w];
    let ((), (angle, ())) = *end.position();
    assert!((angle.re - (a * c + b / w * s)).abs() < 1e-11, "{}", angle.re);
    for (found, expected) in angle.eps.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-10, "{found} not {expected}"); // a hundred times the tolerance, times t
    }
    Ok(())
}

#[test]
fn the_state_matrix_of_a_double_pendulum_has_its_frequencies() -> Result<(), Error> {
    // Two uniform rods of length l hanging at rest: w² = 3 (1 ± 2/√7) g/l.
    let (l, g) = (0.7, 9.81);
    let rod = Rod::uniform(l, 1.3);
    let system = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(g).lift(fixed::<4>);
    let down = fixed(-std::f64::consts::FRAC_PI_2);
    let mut motion = system.with_seeds(system.at_rest(&[down; 2])?, 0);
    let sensitivity = system.sensitivity();
    let mut workspace = catena::system::Dynamics::<Unloaded>::workspace(&sensitivity);
    sensitivity.accelerate(&mut motion, &Unloaded, &mut workspace)?;
    let mut rows = vec![];
    catena::system::Rate::visit(motion.acceleration(), &mut |x| rows.push(x.eps));
    let [[a, b, p, q], [c, d, r, s]] = rows[..] else { return Err(Error::new(catena::Fault::Shape)) };
    // Rates do nothing at rest.
    assert_eq!([p, q, r, s], [0.0; 4]);
    let (half_trace, determinant) = (-(a + d) / 2.0, a * d - b * c);
    let root = (half_trace * half_trace - determinant).sqrt();
    for (found, sign) in [(half_trace - root, -1.0), (half_trace + root, 1.0)] {
        let expected = 3.0 * (1.0 + sign * 2.0 / 7.0_f64.sqrt()) * g / l;
        assert!((found - expected).abs() < 1e-13 * expected * 10.0, "{found} not {expected}"); // some roundings
    }
    Ok(())
}

#[test]
fn values_are_those_of_the_plain_run() -> Result<(), Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let plain = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let system = plain.lift(fixed::<4>);
    let every = |angles: &mut Vec<f64>, more: &[f64]| angles.extend(more);
    let (mut expected, mut found) = (vec![], vec![]);
    let rule = Dop853::tolerance(1e-9);
    let start = plain.at_rest(&[-1.0, -0.5])?;
    let run = plain.simulation(rule).every(0.1).run(start, 2.0, |now| {
        every(&mut expected, &now.angles().iter().copied().collect::<Vec<_>>());
    })?;
    let start = system.with_seeds(system.at_rest(&[fixed(-1.0), fixed(-0.5)])?, 0);
    let through = system.simulation(rule.through_gains()).every(0.1).run(start, 2.0, |now| {
        every(&mut found, &now.angles().iter().map(|x| x.re).collect::<Vec<_>>());
    })?;
    assert_eq!((run.steps, run.rejected, run.sweeps), (through.steps, through.rejected, through.sweeps));
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found - expected).abs() < 1e-12, "{found} not {expected}"); // some thousand roundings
    }
    Ok(())
}
