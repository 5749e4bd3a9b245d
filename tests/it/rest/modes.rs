//! Natural frequencies and modes against closed forms, polynomials, beams and dense solutions in absolute angles.

use catena::loading::Unloaded;
use catena::planar::*;
use catena::{Error, Fault};
use catena_oracle::{Noise, has_order, near};
use core::f64::consts::{FRAC_PI_2, PI};
use nalgebra::{DMatrix, DVector, SymmetricEigen};

const G: f64 = 9.81;

#[test]
fn double_pendulum_of_rods_swings_as_by_hand() -> Result<(), Error> {
    // Uniform rods of length and mass one in absolute angles: M = [[4/3, 1/2], [1/2, 1/3]], K = g diag(3/2, 1/2):
    // 7/36 x² − 7/6 x + 3/4 = 0 for x = ω² / g, so x = 3 ∓ 6 / √7.
    let rod = Rod::uniform(1.0, 1.0);
    let expected = [3.0 - 6.0 / 7f64.sqrt(), 3.0 + 6.0 / 7f64.sqrt()];
    // With pins (absolute angles) and with hinges of no stiffness (relative ones).
    let pins = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(G);
    let hinges = System::new(Pinned::origin(), (rod, ElasticHinge::rotary(0.0), rod), Free)?.with_gravity(G);
    let found = [
        pins.modes(&pins.at_rest(&[-FRAC_PI_2; 2])?, &Unloaded)?,
        hinges.modes(&hinges.at_rest(&[-FRAC_PI_2; 2])?, &Unloaded)?,
    ];
    for (k, x) in expected.into_iter().enumerate() {
        for modes in &found {
            near(modes.get(k).unwrap().frequency(), (G * x).sqrt(), 1e-13 * (G * x).sqrt());
        }
        // K φ = ω² M φ: (3/2 − 4/3 x) φ₀ = ½ x φ₁, and the kinetic energy of the shape as rates is ½ J.
        let mode = found[0].get(k).unwrap();
        let ratio = (1.5 - 4.0 / 3.0 * x) / (0.5 * x);
        near(mode.shape()[1] / mode.shape()[0], ratio, 1e-12 * ratio.abs());
        let moving = pins.with_rates(pins.at_rest(&[-FRAC_PI_2; 2])?, mode.shape())?;
        near(pins.budget(&moving)?.kinetic, 0.5, 1e-13);
        let relative = found[1].get(k).unwrap().shape();
        near(relative[1] / relative[0], ratio - 1.0, 1e-11 * ratio.abs());
    }
    Ok(())
}

/// Laguerre's polynomial L_n at x.
fn laguerre(n: usize, x: f64) -> f64 {
    let (mut before, mut now) = (1.0, 1.0 - x);
    for k in 1..n {
        (before, now) = (now, ((2.0 * k as f64 + 1.0 - x) * now - k as f64 * before) / (k as f64 + 1.0));
    }
    now
}

/// Its roots, ascending: sign changes on a fine grid in √x, along which they are nearly even, bisected.
fn laguerre_roots(n: usize) -> Vec<f64> {
    let steps = 20_000;
    let at = |i: usize| (i as f64 / steps as f64).powi(2) * 4.0 * n as f64;
    let mut roots = vec![];
    for i in 0..steps {
        let (mut low, mut high) = (at(i), at(i + 1));
        if laguerre(n, low) * laguerre(n, high) < 0.0 {
            for _ in 0..200 {
                let middle = 0.5 * (low + high);
                if laguerre(n, low) * laguerre(n, middle) <= 0.0 { high = middle } else { low = middle }
            }
            roots.push(0.5 * (low + high));
        }
    }
    roots
}

#[test]
fn hanging_chains_of_point_masses_meet_the_roots_of_laguerre_polynomials() -> Result<(), Error> {
    for n in [2, 5, 10, 20, 40] {
        let roots = laguerre_roots(n);
        assert_eq!(roots.len(), n);
        let bob = PointMass::new(0.7, 0.3);
        let chain = System::new(Pinned::origin(), (bob, vec![(Pin, bob); n - 1]), Free)?.with_gravity(G);
        let modes = chain.modes(&chain.at_rest(&vec![-FRAC_PI_2; n])?, &Unloaded)?;
        let mut worst: f64 = 0.0;
        for (found, root) in modes.frequencies().zip(&roots) {
            let expected = (root * G / 0.7).sqrt();
            worst = worst.max((found / expected - 1.0).abs());
        }
        println!("{n} point masses: frequencies within {worst:.1e}");
        // ω² is off by rounding of the largest, 4 n / x₁ of the least, which is about 1.4 / n: n² more.
        assert!(worst < 1e-15 * (n * n) as f64 + 1e-14);
    }
    Ok(())
}

/// Angular frequencies of a beam of n rods, EI = ρA = L = 1, hinges EI / l, and whether it is clamped or pinned.
fn beam(n: usize, clamped: bool) -> Result<Vec<f64>, Error> {
    let length = 1.0 / n as f64;
    let rod = Rod::uniform(length, length);
    let links = vec![(ElasticHinge::rotary(1.0 / length), rod); n - 1];
    let modes = if clamped {
        let clamp = ElasticHinge::rotary(2.0 / length);
        let beam = System::new(Clamped::at(0.0, 0.0, 0.3), (clamp, rod, links), Free)?;
        beam.modes(&beam.at_rest(&vec![0.3; n])?, &Unloaded)?
    } else {
        let beam = System::new(Pinned::origin(), (rod, links), Free)?;
        beam.modes(&beam.at_rest(&vec![0.3; n])?, &Unloaded)?
    };
    Ok(modes.frequencies().collect())
}

#[test]
fn rods_with_springs_vibrate_like_a_clamped_beam_at_second_order() -> Result<(), Error> {
    // Euler-Bernoulli, clamped-free: cos βL cosh βL = −1.
    let exact = [1.8751040687, 4.6940911330, 7.8547574382].map(|x: f64| x * x);
    let mut errors = [const { vec![] }; 3];
    for n in [10, 20, 40, 80] {
        let found = beam(n, true)?;
        if n == 20 {
            near(found[0], 3.511987, 5e-7); // an eigenvalue analysis of the same chain, to its digits
        }
        for ((errors, found), exact) in errors.iter_mut().zip(found).zip(exact) {
            errors.push((1.0 / n as f64, (found - exact).abs()));
        }
    }
    for (k, errors) in errors.iter().enumerate() {
        // The higher ones are not yet in their order with ten rods.
        has_order(&format!("clamped-free, mode {k}"), 2.0, 1e-9, &errors[usize::from(k > 0)..]);
    }
    Ok(())
}

#[test]
fn rods_with_springs_vibrate_like_a_pinned_beam_at_fourth_order() -> Result<(), Error> {
    // Euler-Bernoulli, pinned-free: tan βL = tanh βL; and the rotation as a whole, which nothing drives back.
    let exact = [3.9266023120, 7.0685827456].map(|x: f64| x * x);
    let mut errors = [const { vec![] }; 2];
    for n in [10, 20, 40, 80] {
        let found = beam(n, false)?;
        println!("{n} rods: {:.1e} rad/s for the rotation, the largest {:.1e}", found[0], found[n - 1]);
        near(found[0], 0.0, 1e-7 * found[n - 1]); // the root of rounding in ω²
        for ((errors, found), exact) in errors.iter_mut().zip(&found[1..]).zip(exact) {
            println!("{n} rods: {found:.10} for {exact:.10}");
            errors.push((1.0 / n as f64, (found - exact).abs()));
        }
    }
    for (k, errors) in errors.iter().enumerate() {
        // 80 rods are at the ten digits of the reference.
        has_order(&format!("pinned-free, mode {k}"), 4.0, 1e-8, &errors[..3]);
    }
    Ok(())
}

#[test]
fn catenaries_swing_as_a_dense_solution_has_it() -> Result<(), Error> {
    for n in [3, 8, 30] {
        let mut noise = Noise::new(n as u64);
        let rods: Vec<[f64; 2]> =
            (0..n).map(|_| [noise.between(0.7, 1.3) * 1.5 / n as f64, noise.between(0.1, 0.4)]).collect();
        let make = |[length, mass]: &[f64; 2]| Rod::uniform(*length, *mass);
        let chain = (make(&rods[0]), rods[1..].iter().map(|rod| (Pin, make(rod))).collect::<Vec<_>>());
        let scene = System::new(Pinned::origin(), chain, Pinned::at(1.0, 0.2))?.with_gravity(G);
        let guess: Vec<f64> = (0..n).map(|i| -1.0 + 2.2 * (i as f64 + 0.5) / n as f64).collect();
        let rest = scene.equilibrium(scene.at_rest(&guess)?, &Unloaded)?;
        let modes = scene.modes(&rest, &Unloaded)?;
        assert_eq!(modes.len(), n - 2);

        // M, K of the Lagrangian with λ as a dead force at the tip, in absolute angles, on the null space of the closure.
        let angles: Vec<f64> = scene.angles(&rest)?.iter().copied().collect();
        let [fx, fy] = *rest.multipliers();
        let total: f64 = rods.iter().map(|rod| rod[1]).sum();
        let outboard: Vec<f64> = (0..n).map(|i| total - rods[..=i].iter().map(|rod| rod[1]).sum::<f64>()).collect();
        let (mut m, mut k, mut j) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n), DMatrix::zeros(2, n));
        for a in 0..n {
            let (length, mass) = (rods[a][0], rods[a][1]);
            let (s, c) = angles[a].sin_cos();
            m[(a, a)] = length * length * (mass / 3.0 + outboard[a]);
            for b in 0..a {
                let arm = length * (0.5 * mass + outboard[a]);
                m[(a, b)] = rods[b][0] * arm * (angles[a] - angles[b]).cos();
                m[(b, a)] = m[(a, b)];
            }
            k[(a, a)] = length * (-(0.5 * mass + outboard[a]) * G * s + fx * c + fy * s);
            j[(0, a)] = -length * s;
            j[(1, a)] = length * c;
        }
        // Projections commute with a basis of the null space: eigenvectors of I − J⁺ J with eigenvalue one.
        let projector = DMatrix::identity(n, n) - j.clone().pseudo_inverse(1e-12).expect("a bent chain") * &j;
        let spectrum = SymmetricEigen::new(projector);
        let columns: Vec<DVector<f64>> =
            (0..n).filter(|i| spectrum.eigenvalues[*i] > 0.5).map(|i| spectrum.eigenvectors.column(i).into()).collect();
        let basis = DMatrix::from_columns(&columns);
        let (m, k) = (basis.transpose() * m * &basis, basis.transpose() * k * &basis);
        let inverse = m.cholesky().expect("inertia").l().try_inverse().expect("inertia");
        let mut expected: Vec<f64> =
            (&inverse * k * inverse.transpose()).symmetric_eigenvalues().iter().map(|square| square.sqrt()).collect();
        expected.sort_by(f64::total_cmp);
        let worst = modes.frequencies().zip(&expected).fold(0.0, |worst: f64, (a, b)| worst.max((a / b - 1.0).abs()));
        println!("{n} rods: frequencies within {worst:.1e}");
        assert!(worst < 1e-14 * (n * n) as f64 + 1e-13);
    }
    Ok(())
}

#[test]
fn modes_of_a_free_blade_leave_three_rigid_ones() -> Result<(), Error> {
    let rod = Rod::uniform(0.1, 0.1);
    let blade = System::new(Free, (rod, [(ElasticHinge::rotary(10.0), rod); 9]), Free)?;
    let modes = blade.modes(&blade.at_rest(&[0.4; 10])?, &Unloaded)?;
    let found: Vec<f64> = modes.frequencies().collect();
    assert_eq!(found.len(), 12);
    for rigid in &found[..3] {
        near(*rigid, 0.0, 1e-7 * found[11]);
    }
    // A free-free beam of EI = ρA = L = 1: 4.7300407449² = 22.373, from which ten rods are off by some percent.
    near(found[3], 4.7300407449_f64.powi(2), 0.5);
    Ok(())
}

#[test]
fn an_upright_pendulum_departs() -> Result<(), Error> {
    let bob = PointMass::new(1.0, 2.0);
    let pendulum = System::new(Pinned::origin(), (bob,), Free)?.with_gravity(G);
    let modes = pendulum.modes(&pendulum.at_rest(&[FRAC_PI_2])?, &Unloaded)?;
    near(modes.get(0).unwrap().frequency(), -G.sqrt(), 1e-14);
    near(modes.get(0).unwrap().square(), -G, 1e-13);
    Ok(())
}

#[test]
fn loads_stiffen_and_soften() -> Result<(), Error> {
    // A rod on a spring with a dead force along it: k + p l against m l² / 3; it buckles at p l = −k.
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), (ElasticHinge::rotary(2.0), Rod::uniform(1.0, 3.0)), Free)?;
    for p in [0.0, 3.0, -1.5, -2.5] {
        let pull = Loads::none().on_bodies(|_: f64, _, motion: &BodyMotion<f64>| motion.force_at([1.0, 0.0], [p, 0.0]));
        let modes = scene.modes(&scene.at_rest(&[0.0])?, &pull)?;
        near(modes.get(0).unwrap().square(), 2.0 + p, 1e-13);
    }
    Ok(())
}

#[test]
fn what_is_not_at_rest_or_has_no_potential_is_named() -> Result<(), Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(G);
    let error = pendulum.modes(&pendulum.at_rest(&[-FRAC_PI_2 + 0.01, -FRAC_PI_2])?, &Unloaded).unwrap_err();
    println!("{error}");
    match error.fault {
        Fault::NotAtRest { distance } => near(distance, 0.01, 1e-5),
        fault => panic!("{fault:?}"),
    }
    // A force that follows the last of two rods (Ziegler's column).
    let hinge = ElasticHinge::rotary(1.0);
    let column = System::new(Clamped::at(0.0, 0.0, 0.0), (hinge, rod, hinge, rod), Free)?;
    let follow = Loads::none().on_bodies(|_: f64, body, motion: &BodyMotion<f64>| {
        let push = if body == 1 { [-1.0, 0.0] } else { [0.0; 2] };
        motion.force_at([1.0, 0.0], motion.turned(push).into())
    });
    let error = column.modes(&column.at_rest(&[0.0; 2])?, &follow).unwrap_err();
    println!("{error}");
    assert!(matches!(error.fault, Fault::NotConservative { .. }));
    Ok(())
}

#[test]
fn a_mode_swings_with_its_frequency() -> Result<(), Error> {
    let rod = Rod::uniform(0.3, 0.2);
    let chain = System::new(Pinned::origin(), (rod, [(Pin, rod); 3]), Free)?.with_gravity(G);
    let rest = chain.at_rest(&[-FRAC_PI_2; 4])?;
    let modes = chain.modes(&rest, &Unloaded)?;
    for mode in modes.iter() {
        // A quarter of a period from the largest displacement, of some 1e-6 rad, the mode passes through rest.
        let size = 1e-6 / mode.shape().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let angles: Vec<f64> = mode.shape().iter().map(|x| -FRAC_PI_2 + size * x).collect();
        let quarter = 0.5 * PI / mode.frequency();
        let run = chain.simulate(chain.at_rest(&angles)?, Dop853::tolerance(1e-13), quarter, |_| ())?;
        for angle in chain.angles(&run.motion)?.iter() {
            near(*angle, -FRAC_PI_2, 1e-12); // third order in the displacement, and the error of the run
        }
    }
    Ok(())
}

/// Over `f32` differences take another step: a hanging rope of a hundred rods.
#[test]
fn of_a_long_rope_in_single_precision() -> Result<(), Error> {
    macro_rules! frequencies {
        ($T:ty) => {{
            let rod = Rod::uniform(0.03 as $T, 0.03);
            let rope = System::new(Pinned::origin(), (rod, vec![(Pin, rod); 99]), Free)?.with_gravity(9.81);
            let rest = rope.at_rest(&[-FRAC_PI_2 as $T; 100])?;
            rope.modes(&rest, &Unloaded)?.frequencies().collect::<Vec<f64>>()
        }};
    }
    let (found, expected) = (frequencies!(f32), frequencies!(f64));
    // The rope itself: half of the first zero of the Bessel function J₀, times √(g / l).
    near(expected[0], 0.5 * 2.404_825_557_695_773 * (9.81_f64 / 3.0).sqrt(), 1e-4);
    let largest = expected[99] * expected[99];
    for (found, expected) in found.iter().zip(&expected) {
        near(found * found, expected * expected, 1e-3 * largest);
    }
    near(found[0], expected[0], 5e-3);
    Ok(())
}

/// A block at rest on a rope, a buffer or a stop that is strained by next to nothing: √(k/m), however near the kink; where it stands at one there is no mode.
#[test]
fn modes_beside_a_kink_are_those_of_the_side_it_stands_on() -> Result<(), Error> {
    use catena::scalar::Jet;
    const MASS: f64 = 2.0;
    type T = Jet<f64, 1>;
    let line = Slider::along(core::f64::consts::FRAC_PI_2);
    let block = RigidBody::new(MASS, 0.1, [0.0; 2], [0.0; 2]);
    let scene = System::new(Clamped::origin(), (line, block), Free)?.with_gravity(9.81);
    for stiffness in [1e3, 1e4, 1e5, 1e6, 1e8, 5e8, 1e9] {
        let exact = (stiffness / MASS).sqrt();
        let strut =
            |place, length| Strut::to_ground((0, [0.0; 2]), [0.0, place]).with_stiffness(stiffness).with_length(length);
        let mut guess = scene.motion();
        guess.set_coordinates(&[-1.0 - 1.3 * MASS * 9.81 / stiffness])?;
        for strut in [strut(1.0, 2.0).pulling(), strut(-3.0, 2.0).pushing()] {
            let loads = Struts::of([strut]);
            let rest = scene.equilibrium(guess, &loads)?;
            let found = scene.modes(&rest, &loads)?.frequencies().next().expect("one");
            near(found, exact, 1e-12 * exact);
        }
        // How the rest hangs on the stiffness: m g / k².
        let (other, k) = (scene.lift(T::of), T::seed(stiffness, 0));
        let rope = Strut::to_ground((0, [T::of(0.0); 2]), [0.0, 1.0].map(T::of)).with_stiffness(k);
        let rope = Struts::of([rope.with_length(T::of(2.0)).pulling()]);
        let rest = other.equilibrium(guess.lift(T::of), &rope)?;
        let expected = MASS * 9.81 / (stiffness * stiffness);
        near(rest.coordinates()[0].eps[0], expected, 1e-6 * expected);
    }
    let stops = Stops::between([-1.0, 9.0], 1e6, 1e-6);
    let stopped = System::new(Clamped::origin(), (line.with(stops), block), Free)?.with_gravity(9.81);
    let mut guess = stopped.motion();
    guess.set_coordinates(&[-1.0 - MASS * 9.81 / 1e6])?;
    let found = stopped.modes(&stopped.equilibrium(guess, &Unloaded)?, &Unloaded)?.frequencies().next().expect("one");
    near(found, (1e6_f64 / MASS).sqrt(), 1e-9 * found);
    // In single precision.
    let light = System::new(
        Clamped::at(0.0_f32, 0.0, 0.0),
        (Slider::along(PI as f32 / 2.0), RigidBody::new(2.0_f32, 0.1, [0.0; 2], [0.0; 2])),
        Free,
    )?;
    let light = light.with_gravity(9.81);
    for stiffness in [1e4_f32, 2e4, 5e4] {
        let rope = Strut::to_ground((0, [0.0; 2]), [0.0, 1.0]).with_stiffness(stiffness).with_length(2.0).pulling();
        let mut guess = light.motion();
        guess.set_coordinates(&[-1.0 - 1.3 * 19.62 / stiffness])?;
        let rest = light.equilibrium(guess, &Struts::of([rope]))?;
        let found = light.modes(&rest, &Struts::of([rope]))?.frequencies().next().expect("one");
        let exact = f64::from(stiffness / 2.0).sqrt();
        near(found, exact, 2e-3 * exact);
    }
    // Taut, and without weight, however slow.
    for (mass, stiffness) in [(2.0, 1e4), (1000.0, 1.0)] {
        let idle = System::new(Clamped::origin(), (line, RigidBody::new(mass, 0.1, [0.0; 2], [0.0; 2])), Free)?;
        let rope = Strut::to_ground((0, [0.0; 2]), [0.0, 1.0]).with_stiffness(stiffness).with_length(1.0).pulling();
        let refused = idle.modes(&idle.motion(), &Struts::of([rope])).unwrap_err().fault;
        assert!(matches!(refused, Fault::Unsupported { what } if what.contains("kink")), "{refused:?}");
    }
    Ok(())
}
