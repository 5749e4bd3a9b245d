//! Static equilibrium against independent solutions: dense Newton iterations on energies in absolute angles, the elastica, the
//! catenary.

use catena::loading::Unloaded;
use catena::planar::*;
use catena::{Error, Fault};
use catena_oracle::{Noise, has_order, near};
use core::cell::Cell;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_3};
use nalgebra::{DMatrix, DVector};

const G: f64 = 9.81;

/// A chain of uniform rods in absolute angles: length, mass, stiffness and rest angle of the hinge inboard of each. Its energy
/// V = Σ m g y_C + ½ k (θ_i − θ_{i−1} − φ₀)² is stationary, if need be under the condition that the tip be at a place.
struct Energy {
    links: Vec<[f64; 4]>,
    tip: Option<[f64; 2]>,
    /// Dead force at the tip.
    force: [f64; 2],
}

impl Energy {
    /// Newton's method on ∂V/∂θ − Jᵀ λ = 0, tip − place = 0: angles and λ, the force on the chain at its tip.
    fn solve(&self, start: &[f64]) -> (Vec<f64>, [f64; 2]) {
        let n = self.links.len();
        let conditions = if self.tip.is_some() { 2 } else { 0 };
        let (mut angles, mut lambda) = (start.to_vec(), [0.0; 2]);
        for _ in 0..100 {
            let size = n + conditions;
            let (mut k, mut right) = (DMatrix::zeros(size, size), DVector::zeros(size));
            let mut outboard: f64 = self.links.iter().map(|link| link[1] * G).sum();
            let mut place = [0.0; 2];
            for (i, [length, mass, stiffness, rest]) in self.links.iter().copied().enumerate() {
                outboard -= mass * G;
                let (s, c) = angles[i].sin_cos();
                let down = length * (outboard + 0.5 * mass * G);
                // Forces at the outboard end besides weight: the dead one and λ.
                let [x, y] = [self.force[0] + lambda[0], self.force[1] + lambda[1]];
                right[i] -= down * c - length * (y * c - x * s);
                k[(i, i)] += -down * s + length * (x * c + y * s);
                let strain = angles[i] - if i > 0 { angles[i - 1] } else { 0.0 } - rest;
                right[i] -= stiffness * strain;
                k[(i, i)] += stiffness;
                if i > 0 {
                    right[i - 1] += stiffness * strain;
                    k[(i - 1, i - 1)] += stiffness;
                    k[(i, i - 1)] -= stiffness;
                    k[(i - 1, i)] -= stiffness;
                }
                place = [place[0] + length * c, place[1] + length * s];
                if conditions > 0 {
                    for (row, lever) in [(n, -length * s), (n + 1, length * c)] {
                        k[(row, i)] = lever;
                        k[(i, row)] = -lever;
                    }
                }
            }
            if let Some(tip) = self.tip {
                right[n] = tip[0] - place[0];
                right[n + 1] = tip[1] - place[1];
            }
            let step = k.lu().solve(&right).expect("a regular equilibrium");
            (0..n).for_each(|i| angles[i] += step[i]);
            (0..conditions).for_each(|i| lambda[i] += step[n + i]);
            if step.rows(0, n).amax() < 1e-14 {
                break;
            }
        }
        (angles, lambda)
    }
}

/// The largest difference of two lists.
fn distance(a: impl IntoIterator<Item = f64>, b: &[f64]) -> f64 {
    a.into_iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

#[test]
fn hanging_chains_with_springs_agree_with_a_dense_solution() -> Result<(), Error> {
    for n in [1, 2, 5, 20, 100] {
        let mut noise = Noise::new(n as u64);
        let links: Vec<[f64; 4]> = (0..n)
            .map(|_| [noise.between(0.1, 0.4), noise.between(0.2, 1.0), noise.between(1.0, 40.0), 0.4 * noise.next()])
            .collect();
        let hinge = |link: &[f64; 4]| ElasticHinge::rotary(link[2]).resting_at(link[3]);
        let chain: Vec<_> = links.iter().map(|link| (hinge(link), Rod::uniform(link[0], link[1]))).collect();
        let scene = System::new(Clamped::at(0.0, 0.0, 0.0), chain, Free)?.with_gravity(G);
        let guess = scene.at_rest(&vec![-FRAC_PI_2; n])?;
        let rest = scene.equilibrium(guess, &Unloaded)?;
        let found: Vec<f64> = scene.angles(&rest)?.iter().copied().collect();
        let (expected, _) = Energy { links, tip: None, force: [0.0; 2] }.solve(&found);
        let error = distance(found, &expected);
        println!("{n} links: {error:.1e} rad off the dense solution");
        assert!(error < 1e-13 * n as f64); // rounding of the largest stiffness, as the softest mode of the chain sees it
        assert!(rest.rate().1.iter().all(|link| link.0 == 0.0));
    }
    Ok(())
}

#[test]
fn chains_of_pins_fall_to_where_they_hang() -> Result<(), Error> {
    let rod = Rod::uniform(0.3, 0.2);
    for n in [1, 2, 10, 40] {
        let chain = System::new(Pinned::origin(), (rod, vec![(Pin, rod); n - 1]), Free)?.with_gravity(G);
        // From the horizontal, where nothing resists, from a zigzag, and from a tilt above the horizontal.
        let mut noise = Noise::new(7);
        for guess in [vec![0.0; n], (0..n).map(|_| noise.next() - 0.5).collect(), vec![1.0; n]] {
            let rest = chain.equilibrium(chain.at_rest(&guess)?, &Unloaded)?;
            let down = distance(chain.angles(&rest).unwrap().iter().copied(), &vec![-FRAC_PI_2; n]);
            assert!(down < 1e-14, "{n} links: {down:e} from the vertical");
        }
    }
    Ok(())
}

#[test]
fn rest_is_reached_from_afar() -> Result<(), Error> {
    let mut noise = Noise::new(31);
    let mut guess = |n: usize, size: f64| (0..n).map(|_| size * noise.next()).collect::<Vec<_>>();
    for _ in 0..20 {
        // Crumpled chains between pins come to rest, and stably, although not always without loops.
        let rod = Rod::uniform(0.15, 0.15);
        let chain = System::new(Pinned::origin(), (rod, [(Pin, rod); 9]), Pinned::at(1.0, 0.2))?.with_gravity(G);
        let rest = chain.equilibrium(chain.at_rest(&guess(10, 3.0))?, &Unloaded)?;
        assert!(chain.modes(&rest, &Unloaded)?.frequencies().all(|frequency| frequency > 0.0));
        // Zigzag blades straighten out to the one equilibrium there is.
        let (rod, hinge) = (Rod::uniform(0.02, 0.02), ElasticHinge::rotary(25.0));
        let blade = System::new(Clamped::at(0.0, 0.0, 0.0), (hinge, rod, [(hinge, rod); 49]), Free)?.with_gravity(G);
        let rest = blade.equilibrium(blade.at_rest(&guess(50, 2.0))?, &Unloaded)?;
        let other = blade.equilibrium(blade.at_rest(&[0.0; 50])?, &Unloaded)?;
        let others: Vec<f64> = blade.angles(&other)?.iter().copied().collect();
        assert!(distance(blade.angles(&rest)?.iter().copied(), &others) < 1e-13);
    }
    Ok(())
}

#[test]
fn an_unstable_equilibrium_is_found_from_nearby() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 1.0);
    let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(G);
    let rest = pendulum.equilibrium(pendulum.at_rest(&[FRAC_PI_2 + 0.003, -FRAC_PI_2 - 0.002])?, &Unloaded)?;
    let off = distance(pendulum.angles(&rest)?.iter().copied(), &[FRAC_PI_2, -FRAC_PI_2]);
    assert!(off < 1e-15, "{off:e}");
    // Exactly there nothing moves at all.
    let top = pendulum.at_rest(&[FRAC_PI_2, FRAC_PI_2])?;
    assert!(
        distance(pendulum.angles(&pendulum.equilibrium(top, &Unloaded)?)?.iter().copied(), &[FRAC_PI_2; 2]) < 1e-15
    );
    Ok(())
}

/// Deflection (forward, downward, slope) of the tip of a clamped elastica of length and stiffness one under a dead force
/// downward, P: θ'' = P cos θ for the slope θ measured downward, with θ(0) = 0, θ'(1) = 0, by shooting with RK4.
fn elastica(p: f64) -> [f64; 3] {
    let end = |curvature: f64| {
        let n = 4000;
        let h = 1.0 / n as f64;
        let f = |z: [f64; 4]| [z[1], -p * z[0].cos(), z[0].cos(), z[0].sin()];
        let mut z = [0.0, curvature, 0.0, 0.0];
        let along = |z: [f64; 4], k: [f64; 4], h: f64| core::array::from_fn(|i| z[i] + h * k[i]);
        for _ in 0..n {
            let k1 = f(z);
            let k2 = f(along(z, k1, 0.5 * h));
            let k3 = f(along(z, k2, 0.5 * h));
            let k4 = f(along(z, k3, h));
            z = core::array::from_fn(|i| z[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
        }
        z
    };
    let (mut low, mut high) = (0.0, p);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if end(middle)[1] < 0.0 { low = middle } else { high = middle }
    }
    let [slope, _, forward, down] = end(0.5 * (low + high));
    [forward, down, slope]
}

/// Tip of a cantilever of n rods with springs EI / l between them and 2 EI / l at the clamp, EI = L = 1, under a dead force.
fn cantilever(n: usize, p: f64) -> Result<[f64; 3], Error> {
    let length = 1.0 / n as f64;
    let rod = Rod::uniform(length, length);
    let spring = |cells: f64| ElasticHinge::rotary(1.0 / (cells * length));
    let chain = (spring(0.5), rod, vec![(spring(1.0), rod); n - 1]);
    let beam = System::new(Clamped::at(0.0, 0.0, 0.0), chain, Free)?;
    let pull = Loads::none().on_bodies(|_: f64, body, motion: &BodyMotion<f64>| {
        if body + 1 == n { motion.force_at([length, 0.0], [0.0, -p]) } else { Wrench::default() }
    });
    let rest = beam.equilibrium(beam.at_rest(&vec![0.0; n])?, &pull)?;
    let tip = beam.stations(&rest, &pull)?.tip().frame;
    Ok([tip.place.x, -tip.place.y, -tip.turn.angle])
}

#[test]
fn elastica_agrees_with_the_literature() {
    // K. Mattiasson, Numerical results from large deflection beam and frame problems analysed by means of elliptic integrals,
    // Int. J. Numer. Meth. Engng 17 (1981): P L² / EI, 1 − forward, down, slope.
    for [p, shortening, down, slope] in
        [[1.0, 0.05643, 0.30172, 0.46135], [2.0, 0.16064, 0.49346, 0.78175], [10.0, 0.55500, 0.81061, 1.43029]]
    {
        let found = elastica(p);
        near(1.0 - found[0], shortening, 1e-5);
        near(found[1], down, 1e-5);
        near(found[2], slope, 1e-5);
    }
}

#[test]
fn rods_with_springs_bend_like_the_elastica_at_second_order() -> Result<(), Error> {
    for p in [1.0, 10.0] {
        let expected = elastica(p);
        let (mut forward, mut down) = (vec![], vec![]);
        for n in [10, 20, 40, 80] {
            let [x, y, _] = cantilever(n, p)?;
            forward.push((1.0 / n as f64, (x - expected[0]).abs()));
            down.push((1.0 / n as f64, (y - expected[1]).abs()));
        }
        has_order(&format!("P L² / EI = {p}, forward"), 2.0, 1e-10, &forward);
        has_order(&format!("P L² / EI = {p}, down"), 2.0, 1e-10, &down);
    }
    // Small forces: n rods deflect by P L³ / 3 EI (1 + 1 / 2 n²), by summation of the springs' moments.
    let (n, p) = (20, 1e-6);
    let exact = p / 3.0 * (1.0 + 0.5 / (n * n) as f64);
    near(cantilever(n, p)?[1], exact, 1e-9 * exact);
    Ok(())
}

/// A chain of n rods of the total length 1.5 m and mass 1.5 kg between pins 1 m apart, the second 0.2 m higher.
fn catenary(n: usize) -> (Energy, Vec<f64>) {
    let length = 1.5 / n as f64;
    let links = vec![[length, length, 0.0, 0.0]; n];
    let guess = (0..n).map(|i| -1.0 + 2.2 * (i as f64 + 0.5) / n as f64).collect();
    (Energy { links, tip: Some([1.0, 0.2]), force: [0.0; 2] }, guess)
}

#[test]
fn catenaries_agree_with_a_dense_solution() -> Result<(), Error> {
    for n in [3, 10, 50, 150] {
        let (energy, guess) = catenary(n);
        let rod = Rod::uniform(energy.links[0][0], energy.links[0][1]);
        let chain = System::new(Pinned::origin(), (rod, vec![(Pin, rod); n - 1]), Pinned::at(1.0, 0.2))?;
        let chain = chain.with_gravity(G);
        let rest = chain.equilibrium(chain.at_rest(&guess)?, &Unloaded)?;
        let found: Vec<f64> = chain.angles(&rest)?.iter().copied().collect();
        let (expected, force) = energy.solve(&found);
        let error = distance(found, &expected);
        let pull = distance(*rest.multipliers(), &force);
        println!("{n} links: {error:.1e} rad, {pull:.1e} N off the dense solution");
        assert!(error < 2e-14 * n as f64 && pull < 1e-12 * n as f64);
        let tip = chain.stations(&rest, &Unloaded)?.tip().frame.place;
        assert!((tip.x - 1.0).abs() < 1e-15 * n as f64 && (tip.y - 0.2).abs() < 1e-15 * n as f64);
    }
    Ok(())
}

#[test]
fn catenaries_approach_the_curve_at_second_order() -> Result<(), Error> {
    // Level pins 1 m apart, length 1.5: 2 a sinh(1 / 2 a) = 1.5; horizontal pull H = w a with the weight w of 9.81 N/m.
    let (mut low, mut high) = (0.05, 5.0);
    for _ in 0..200 {
        let a: f64 = 0.5 * (low + high);
        if 2.0 * a * (0.5 / a).sinh() > 1.5 { low = a } else { high = a }
    }
    let mut errors = vec![];
    for n in [8, 16, 32, 64] {
        let rod = Rod::uniform(1.5 / n as f64, 1.5 / n as f64);
        let chain = System::new(Pinned::origin(), (rod, vec![(Pin, rod); n - 1]), Pinned::at(1.0, 0.0))?;
        let chain = chain.with_gravity(G);
        let guess: Vec<f64> = (0..n).map(|i| -1.0 + 2.0 * (i as f64 + 0.5) / n as f64).collect();
        let rest = chain.equilibrium(chain.at_rest(&guess)?, &Unloaded)?;
        errors.push((1.0 / n as f64, (rest.multipliers()[0] - G * low).abs()));
    }
    has_order("catenary, pull", 2.0, 1e-11, &errors);
    Ok(())
}

#[test]
fn a_beam_clamped_at_both_ends_obeys_its_closure() -> Result<(), Error> {
    let rod = Rod::uniform(0.1, 0.1);
    let hinge = ElasticHinge::rotary(0.5);
    let bow = System::new(Clamped::at(0.0, 0.0, 0.3), (rod, [(hinge, rod); 9]), Clamped::at(0.9, 0.0, -0.4))?;
    let bow = bow.with_gravity(G);
    let guess = bow.at_rest(&[0.6, 0.5, 0.4, 0.2, 0.0, -0.2, -0.4, -0.5, -0.4])?;
    let rest = bow.equilibrium(guess, &Unloaded)?;
    let stations = bow.stations(&rest, &Unloaded)?;
    let tip = stations.tip().frame;
    near(tip.place.x, 0.9, 1e-15);
    near(tip.place.y, 0.0, 1e-15);
    near(tip.turn.angle, -0.4, 1e-15);
    // The balance of all forces and moments about the origin, and that of each hinge with its spring.
    let (root, [x, y, torque]) = (stations.root().internal, *rest.multipliers());
    near(root.force.x + x, 0.0, 1e-12);
    near(root.force.y + y, G, 1e-12);
    let weight: f64 = bow.body_motions(&rest)?.iter().map(|body| 0.1 * G * body.centre().place.x).sum();
    near(-root.torque - weight + 0.9 * y + torque, 0.0, 1e-12);
    for (k, angle) in rest.position().1.1.iter().map(|link| link.0).enumerate() {
        near(stations.get(2 * k + 1).unwrap().torque_outboard(), -0.5 * angle, 1e-12);
    }
    Ok(())
}

#[test]
fn loads_without_a_potential_have_an_equilibrium_too() -> Result<(), Error> {
    // A follower force across the tip of a rod on a spring, and a law that depends on places: (40 x) N up at the tip.
    let (k, p) = (2.0, 1.5);
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), (ElasticHinge::rotary(k), Rod::uniform(1.0, 1.0)), Free)?;
    let follow = Loads::none()
        .on_bodies(|_: f64, _, motion: &BodyMotion<f64>| motion.force_at([1.0, 0.0], motion.turned([0.0, p]).into()));
    let rest = scene.equilibrium(scene.at_rest(&[0.0])?, &follow)?;
    near(*scene.angles(&rest)?.get(0).unwrap(), p / k, 1e-15);

    let place = Loads::none().on_bodies(|_: f64, _, motion: &BodyMotion<f64>| {
        motion.force_at([1.0, 0.0], [0.0, 4.0 * motion.outboard().place.x])
    });
    let rest = scene.equilibrium(scene.at_rest(&[0.0])?, &place)?;
    let angle = *scene.angles(&rest)?.get(0).unwrap();
    near(4.0 * angle.cos() * angle.cos() - k * angle, 0.0, 1e-14);
    Ok(())
}

#[test]
fn newton_doubles_digits_near_the_solution() -> Result<(), Error> {
    let rod = Rod::uniform(0.1, 0.1);
    let chain = (ElasticHinge::rotary(5.0), rod, vec![(ElasticHinge::rotary(2.0), rod); 19]);
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), chain, Free)?.with_gravity(G);
    let sweeps = Cell::new(0);
    let count = Loads::none().on_bodies(|_: f64, body, _: &BodyMotion<f64>| {
        sweeps.set(sweeps.get() + usize::from(body == 0));
        Wrench::default()
    });
    let rest = scene.equilibrium(scene.at_rest(&[0.0; 20])?, &Unloaded)?;
    let nearby: Vec<f64> = scene.angles(&rest)?.iter().map(|angle| angle + 0.02).collect();
    let tilted = [FRAC_PI_3; 20];
    // Digits double: 1e-2, 1e-4, 1e-8, 1e-16, and one step to see that it is so.
    for (guess, most) in [(&nearby[..], 5), (&tilted, 40)] {
        sweeps.set(0);
        let found = scene.equilibrium(scene.at_rest(guess)?, &count)?;
        assert!(
            distance(scene.angles(&found)?.iter().copied(), &scene.angles(&rest)?.iter().copied().collect::<Vec<_>>())
                < 1e-14
        );
        // Sixteen sweeps for each of 20 coordinates, and one or two more for each step.
        let steps = sweeps.get() / 320;
        println!("from {:.2} rad: {} sweeps, {steps} steps", guess[0], sweeps.get());
        assert!(steps <= most);
    }
    Ok(())
}

#[test]
fn equilibria_have_derivatives() -> Result<(), Error> {
    use num_dual::Dual64;
    // k θ = −½ m g l cos θ: dθ/dg = −½ m l cos θ / (k − ½ m g l sin θ).
    let constant = Dual64::from_re;
    let rod = Rod::uniform(constant(1.2), constant(0.7));
    let chain = (ElasticHinge::rotary(constant(3.0)), rod, Pin, rod);
    let scene = System::new(Clamped::at(constant(0.0), constant(0.0), constant(0.0)), chain, Free)?;
    let scene = scene.with_gravity(Dual64::new(G, 1.0));
    for guess in [0.0, -0.9] {
        let rest = scene.equilibrium(scene.at_rest(&[constant(guess), constant(-1.0)])?, &Unloaded)?;
        let angles: Vec<Dual64> = scene.angles(&rest)?.iter().copied().collect();
        let (angle, moment) = (angles[0].re, (0.5 + 1.0) * 0.7 * 1.2);
        near(3.0 * angle + moment * G * angle.cos(), 0.0, 1e-14);
        let slope = -moment * angle.cos() / (3.0 - moment * G * angle.sin());
        near(angles[0].eps, slope, 1e-12);
        near(angles[1].re, -FRAC_PI_2, 1e-15);
        near(angles[1].eps, 0.0, 1e-12);
    }
    Ok(())
}

#[test]
fn single_precision_comes_to_rest_too() -> Result<(), Error> {
    let rod = Rod::uniform(0.3_f32, 0.2);
    let chain = System::new(Pinned::origin(), (rod, [(Pin, rod); 5]), Free)?.with_gravity(9.81);
    let rest = chain.equilibrium(chain.at_rest(&[-0.8; 6])?, &Unloaded)?;
    for angle in chain.angles(&rest)?.iter() {
        assert!((angle + core::f32::consts::FRAC_PI_2).abs() < 1e-6, "{angle}");
    }
    Ok(())
}

#[test]
fn neutral_scenes_come_to_rest_somewhere() -> Result<(), Error> {
    // Nothing holds this blade, and no weight pulls at it: three directions are indifferent.
    let rod = Rod::uniform(0.3, 0.2);
    let hinge = ElasticHinge::rotary(2.0).resting_at(0.2);
    let blade = System::new(Free, (rod, [(hinge, rod); 4]), Free)?;
    let rest = blade.equilibrium(blade.at_rest(&[0.0, 0.3, -0.2, 0.1, 0.4])?, &Unloaded)?;
    for link in rest.position().1.1 {
        near(link.0, 0.2, 1e-14);
    }
    // A pendulum without weight is at rest wherever it is.
    let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
    let rest = pendulum.equilibrium(pendulum.at_rest(&[0.7, -0.1])?, &Unloaded)?;
    assert_eq!(pendulum.angles(&rest)?.get(0), Some(&0.7));
    Ok(())
}

#[test]
fn what_has_no_equilibrium_says_so() -> Result<(), Error> {
    let rod = Rod::uniform(0.3, 0.2);
    let falling = System::new(Free, (rod, Pin, rod), Free)?.with_gravity(G);
    let error = falling.equilibrium(falling.at_rest(&[0.0, 0.5])?, &Unloaded).map(|_| ()).unwrap_err();
    println!("{error}");
    match error.fault {
        Fault::NoEquilibrium { residual } => near(residual, G, 1e-9),
        fault => panic!("{fault:?}"),
    }
    let short = System::new(Pinned::origin(), (rod, Pin, rod), Pinned::at(1.0, 0.0))?.with_gravity(G);
    let error = short.equilibrium(short.at_rest(&[0.5, -0.5])?, &Unloaded).map(|_| ()).unwrap_err();
    println!("{error}");
    assert!(matches!(error.fault, Fault::NotClosed { residual } if residual > 0.4 - 1e-9)); // 0.6 m of rods, 1 m away
    Ok(())
}
