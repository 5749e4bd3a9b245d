//! Taylor series in space through kept gains: coefficients, runs, what is read within steps.
//!
//! Coefficients are those of `series_in_space.csv`, whose head says how they were found.

use super::by_series::{
    apart, are_coefficients_of, beside_dop853, ends_in_single_precision, errors_within_steps, expansion,
    hangs_at_odd_quarters, slope,
};
use catena::loading::TimeLaw;
use catena::scalar::{Jet, Scalar};
use catena::spatial::*;
use catena::{Error, Fault};
use catena_oracle::{has_order, near};

const G: [f64; 3] = [0.0, 0.0, -9.81];

fn rod() -> Rod<f64> {
    Rod::uniform(0.5, 0.05, 1.0)
}

fn body() -> RigidBody<f64> {
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
    RigidBody::new(1.0, tensor, [0.25, 0.03, -0.02], [0.5, 0.1, 0.05])
}

/// A scene of one body on a ball.
macro_rules! pendulum {
    ($body:expr, $angles:expr, $rates:expr) => {{
        let scene = System::new(Pinned::origin(), $body, Free)?.with_gravity(G);
        let start = scene.with_rates(scene.at_rest(&$angles)?, &$rates)?;
        (scene, start)
    }};
}

/// Two unlike rods on balls.
macro_rules! rods {
    () => {{
        let scene = System::new(Pinned::origin(), (rod(), Ball, Rod::uniform(0.3, 0.04, 0.4)), Free)?.with_gravity(G);
        let rates = [0.2, 0.3, -0.4, 3.0, -1.0, 1.0];
        let start = scene.with_rates(scene.at_rest(&[0.3, 0.2, 0.1, 0.0, 0.6, 0.4])?, &rates)?;
        (scene, start)
    }};
}

/// A tree with an arm, of all bodies and joints that have series.
macro_rules! tree {
    () => {{
        let spring = Spring::new(3.0).damped(0.1).resting_at(0.2);
        let hinge = Revolute::about([0.3, 1.0, 0.2]).with(spring);
        let arm = Branch((hinge, rod(), Weld::at(Rotation::from_angles([0.4, 0.1, 0.0])), body()));
        let (short, bob) = (Rod::uniform(0.3, 0.04, 0.4), PointMass::new(0.3, 0.2));
        let rest = (hinge.named("knee"), bob, Revolute::about([1.0, 0.0, 0.5]), rod(), [(Ball, body()); 1]);
        let scene = System::new(Hinged::origin([0.0, 1.0, 0.0]), (body(), arm, Ball, short, rest), Free)?;
        let scene = scene.with_gravity(G);
        let rates = [0.5, -0.4, 0.9, -0.3, 0.6, 0.7, -0.8, 0.4, 0.1, -0.5];
        let start = scene.with_rates(scene.at_rest(&[0.2; 10])?, &rates)?;
        (scene, start)
    }};
}

/// What acts in the tree: one for each joint from the root's on, none in the weld.
const EFFORTS: [Effort<f64>; 7] = [
    Effort([0.3, 0.0, 0.0]),
    Effort([-0.1, 0.0, 0.0]),
    Effort([0.0; 3]),
    Effort([0.1, 0.05, -0.03]),
    Effort([0.2, 0.0, 0.0]),
    Effort([0.05, 0.0, 0.0]),
    Effort([-0.02, 0.04, 0.06]),
];

/// Drives all joints of the tree, about axes of bodies that differ from one to the next.
struct Drive;

impl TimeLaw<f64> for Drive {
    fn at<X: Scalar<Real = f64>>(&self, time: X, joint: usize) -> X {
        self.in_space(time, joint)[0]
    }
    fn in_space<X: Scalar<Real = f64>>(&self, time: X, joint: usize) -> [X; 3] {
        let (sine, cosine) = (X::literal(3.0) * time + X::literal(joint as f64)).sin_cos();
        let decay = (X::literal(-0.5) * time).exp() / (X::one() + time * time);
        [sine * decay, X::literal(0.3) * cosine * decay, X::literal(0.2) * time * sine]
    }
}

/// By how much coefficients of each order miss those of the file, as a share of the largest of that order: the top, the rods, the rod, the
/// tree and the driven tree by up to 2e-13, 1e-14, 8e-13, 2e-13 and 3e-13. The program that found the file misses by 4e-14, 1e-13, 3e-12,
/// 6e-12 and 2e-11 if it counts in doubles: the spin of a thin rod and the accelerations of the tree are ill-conditioned.
macro_rules! misses {
    ($name:expr, $scene:expr, $start:expr, $order:literal, $loads:expr) => {{
        let (found, stepped) = expansion!($order, $scene, $start, $loads, 1e-3);
        stepped?;
        are_coefficients_of(include_str!("series_in_space.csv"), $name, &found, 1e-12);
    }};
}

#[test]
fn coefficients_are_those_of_dalemberts_principle() -> Result<(), Error> {
    let (scene, start) = pendulum!(body(), [0.3, -0.9, 0.1], [6.0, 0.5, -1.5]);
    misses!("top", scene, start, 24, Unloaded);
    let (scene, start) = rods!();
    misses!("rods", scene, start, 24, Unloaded);
    let (scene, start) = pendulum!(rod(), [0.3, 0.2, 0.1], [5.0, 0.3, -0.4]);
    misses!("rod", scene, start, 24, Unloaded);
    let (scene, start) = tree!();
    misses!("tree", scene, start, 20, Unloaded);
    misses!("driven", scene, start, 20, Loads::none().efforts(EFFORTS));
    Ok(())
}

/// A body of equal moments of inertia J turns by J ω̇ = ε(t) in its own axes, whatever its attitude: coefficients of its quaternion obey
/// 2 (k + 1) q_{k+1} = Σ q_j ∘ ω_{k−j}.
#[test]
fn a_sphere_on_a_ball_turns_as_its_torque_says() -> Result<(), Error> {
    /// ε = (3 + t², 1 − 2 t, sin 2 t) (N·m).
    struct Polynomial;
    impl TimeLaw<f64> for Polynomial {
        fn at<X: Scalar<Real = f64>>(&self, _: X, _: usize) -> X {
            X::zero()
        }
        fn in_space<X: Scalar<Real = f64>>(&self, t: X, _: usize) -> [X; 3] {
            let two = X::literal(2.0);
            [X::literal(3.0) + t * t, X::one() - two * t, (two * t).sin_cos().0]
        }
    }
    const ORDER: usize = 20;
    let inertia = 0.4;
    let sphere =
        RigidBody::new(1.0, [[inertia, 0.0, 0.0], [0.0, inertia, 0.0], [0.0, 0.0, inertia]], [0.0; 3], [0.0; 3]);
    let scene = System::new(Pinned::origin(), sphere, Free)?;
    let rates = [0.7, -0.4, 1.1];
    let start = scene.with_rates(scene.at_rest(&[0.0; 3])?, &rates)?;
    let loads = Loads::none().in_joints_over_time(Polynomial);
    let (found, stepped) = expansion!(20, scene, start, loads, 1e-3);
    stepped?;
    // ω = ω₀ + ∫ ε / J.
    let mut omega = [[0.0; 3]; ORDER + 1];
    omega[0] = rates;
    omega[1] = [3.0 / inertia, 1.0 / inertia, 0.0];
    omega[2][1] = -1.0 / inertia;
    omega[3][0] = 1.0 / 3.0 / inertia;
    let mut sine = 2.0; // (−1)^m 2^(2m+1) / (2m+1)!, that of t^(2m+1)
    for m in 0..ORDER / 2 {
        let k = 2 * m + 1;
        omega[k + 1][2] = sine / (k + 1) as f64 / inertia;
        sine *= -4.0 / ((k + 1) * (k + 2)) as f64;
    }
    let mut q = vec![[1.0, 0.0, 0.0, 0.0]];
    for k in 0..=ORDER {
        let mut sum = [0.0; 4];
        for (j, [w, x, y, z]) in q.iter().enumerate() {
            let [a, b, c] = omega[k - j];
            let product = [-x * a - y * b - z * c, w * a + y * c - z * b, w * b + z * a - x * c, w * c + x * b - y * a];
            sum.iter_mut().zip(product).for_each(|(sum, more)| *sum += more);
        }
        q.push(sum.map(|x| 0.5 * x / (k + 1) as f64));
    }
    for (k, row) in found.iter().enumerate() {
        // The rate is that of twice the vector part.
        let expected: Vec<f64> = q[k + 2][1..].iter().map(|x| 2.0 * (k + 2) as f64 * x).collect();
        let largest = expected.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        // In inertial axes the torque is a product of three series, those of attitudes twice among them, whose terms are up to 3^(k/2) times as
        // large as what is left. (The recurrence misses its value at 40 digits by 1e-15.)
        let rounding = (2.0 * f64::EPSILON * 3.0_f64.powf(0.5 * (k + 1) as f64)).max(1e-13);
        let miss = apart(row, &expected) / largest;
        println!("order {}: {largest:.2e}, miss {miss:.1e} of {rounding:.1e}", k + 1);
        assert!(miss < rounding, "order {}: {row:?}, {expected:?}", k + 1);
    }
    Ok(())
}

#[test]
fn scenes_move_as_under_dop853() -> Result<(), Error> {
    macro_rules! compare {
        ($scene:expr, $loads:expr) => {{
            let (scene, start) = $scene;
            let (series, other) = beside_dop853!(24, scene, $loads, start, 1.0);
            let (series_end, other_end) = (&series.motion, &other.motion);
            let miss = apart(&series_end.coordinates(), &other_end.coordinates());
            let miss = miss.max(1e-1 * apart(&series_end.rates(), &other_end.rates()));
            let miss = miss.max(1e-2 * apart(&series_end.accelerations(), &other_end.accelerations()));
            println!("{} steps, apart by {miss:.1e}", series.steps);
            assert!(miss < 1e-11 && series.rejected == 0);
        }};
    }
    compare!(pendulum!(rod(), [0.3, 0.2, 0.1], [5.0, 0.3, -0.4]), Unloaded);
    compare!(pendulum!(body(), [0.3, -0.9, 0.1], [6.0, 0.5, -1.5]), Unloaded);
    compare!(rods!(), Unloaded);
    compare!(tree!(), Unloaded);
    compare!(tree!(), Loads::none().efforts(EFFORTS));
    compare!(tree!(), Loads::none().in_joints_over_time(Drive));
    let tilted = Clamped::at([0.1, 0.2, 0.3], Rotation::from_angles([0.1, 0.2, 0.3]));
    let links = vec![(Revolute::about([0.0, 1.0, 0.0]), rod(), Revolute::about([1.0, 0.0, 0.0]), body()); 2];
    let arm = System::new(tilted, links, Free)?.with_gravity(G);
    let start = arm.with_rates(arm.at_rest(&[0.3, -0.2, 0.1, 0.4])?, &[1.0, -2.0, 0.5, 3.0])?;
    let (series, other) = beside_dop853!(24, arm, Unloaded, start, 1.0);
    assert!(apart(&series.motion.coordinates(), &other.motion.coordinates()) < 1e-11);
    Ok(())
}

#[test]
fn long_chains_move_as_under_dop853() -> Result<(), Error> {
    let rod = Rod::uniform(0.05, 0.005, 0.05);
    let chain = System::new(Pinned::origin(), (rod, vec![(Ball, rod); 19]), Free)?.with_gravity(G);
    let start = chain.at_rest(&[0.0; 60])?;
    let (series, other) = beside_dop853!(24, chain, Unloaded, start, 0.1);
    println!("twenty rods: {} steps", series.steps);
    assert!(apart(&series.motion.coordinates(), &other.motion.coordinates()) < 1e-11);
    Ok(())
}

/// Coordinates of a step end at half a turn: beyond, they would stand for another attitude. The series of a fast top reaches farther, and so
/// does that of a rod which a torque turns from rest.
#[test]
fn bodies_turn_less_than_half_in_a_step() -> Result<(), Error> {
    let wheel =
        RigidBody::new(1.0, [[0.05, 0.0, 0.0], [0.0, 0.03, 0.0], [0.0, 0.0, 0.03]], [0.3, 0.0, 0.0], [0.3, 0.0, 0.0]);
    let (scene, start) = pendulum!(wheel, [0.0, 0.5, 0.0], [200.0, 0.0, 0.0]);
    let exact = scene.simulate(start, Dop853::tolerance(1e-13), 0.5, |_| ())?.motion.coordinates();
    for (tolerance, most) in [(1e-3, 1e-2), (1e-6, 1e-5), (1e-12, 1e-10)] {
        let run = scene.simulate(start, Taylor::<30>::tolerance(tolerance), 0.5, |_| ())?;
        let miss = apart(&run.motion.coordinates(), &exact);
        println!("{tolerance:e}: {} steps, {} rejected, apart by {miss:.1e}", run.steps, run.rejected);
        assert!(miss < most && run.rejected == 0);
    }
    let scene = System::new(Pinned::origin(), rod(), Free)?;
    let loads = Loads::none().efforts([Effort([0.0, 3.0, 0.0])]);
    let run = scene.simulation(Taylor::<24>::tolerance(1e-12)).loads(&loads).run(scene.motion(), 1.0, |_| ())?;
    // By α t² / 2, α = τ / J with J = m l² / 3 + m r² / 4.
    let angle = 0.5 * 3.0_f64 / (0.25 / 3.0 + 0.0025 / 4.0);
    println!("from rest: {} steps, {} rejected", run.steps, run.rejected);
    near(run.motion.position().0.turned([1.0, 0.0, 0.0])[0], angle.cos(), 1e-11);
    near(run.motion.position().0.turned([1.0, 0.0, 0.0])[2], -angle.sin(), 1e-11);
    Ok(())
}

#[test]
fn energy_and_momentum_about_the_vertical_stay() -> Result<(), Error> {
    let (scene, start) = rods!();
    let (first, mut drift) = (scene.budget(&start)?, [0.0_f64; 2]);
    let run = scene.simulate(start, Taylor::<24>::tolerance(1e-15), 10.0, |now| {
        let now = now.budget();
        drift[0] = drift[0].max((now.energy() - first.energy()).abs());
        drift[1] = drift[1].max((now.angular_momentum.z - first.angular_momentum.z).abs());
    })?;
    println!("{} steps, {drift:?}", run.steps);
    assert!(drift.iter().all(|drift| *drift < 1e-12) && run.rejected == 0);
    Ok(())
}

#[test]
fn orders_are_those_of_the_series() -> Result<(), Error> {
    let (scene, start) = rods!();
    let [within, rates] = errors_within_steps!(scene, start, [0.08, 0.07, 0.06, 0.05]);
    has_order("position within a step", 10.0, 1e-15, &within);
    has_order("rate within a step", 9.0, 1e-15, &rates);
    let exact = scene.simulate(start, Taylor::<30>::tolerance(1e-15), 0.5, |_| ())?.motion;
    let mut whole = vec![];
    for dt in [0.0125, 0.01, 0.008, 0.00625] {
        let run = scene.simulate(start, Taylor::<8>::step(dt), 0.5, |_| ())?;
        whole.push((dt, apart(&run.motion.coordinates(), &exact.coordinates())));
    }
    has_order("a run of steps of one size", 8.0, 1e-14, &whole);
    Ok(())
}

#[test]
fn events_are_found_on_the_polynomial() -> Result<(), Error> {
    // A rod released from the horizontal hangs after K(sin 45°) / ω, K the complete elliptic integral (Abramowitz and Stegun, table 17.1),
    // ω² = m g l / 2 J with J = m l² / 3 + m r² / 4.
    let (scene, start) = pendulum!(Rod::uniform(1.0, 0.1, 1.0), [0.0; 3], [0.0; 3]);
    let quarter = 1.854_074_677_301_372 / (0.5 * 9.81 / (1.0_f64 / 3.0 + 0.0025)).sqrt();
    let mut found = vec![];
    let run = scene
        .simulation(Taylor::<20>::tolerance(1e-14))
        .event(|now| now.motion().position().0.turned([1.0, 0.0, 0.0])[0])
        .run(start, 7.5 * quarter, |now| {
            if now.is_event() {
                found.push(now.time());
            }
        })?;
    println!("{} steps, events at {found:?}, a quarter is {quarter}", run.steps);
    hangs_at_odd_quarters(&found, quarter);
    Ok(())
}

#[test]
fn samples_lie_on_the_motion() -> Result<(), Error> {
    let (scene, start) = tree!();
    let mut series = vec![];
    let rule = Taylor::<20>::tolerance(1e-12);
    scene
        .simulation(rule)
        .every(0.1)
        .run(start, 0.7, |now| series.push((now.motion().coordinates(), now.motion().rates())))?;
    let mut number = 0;
    scene.simulation(Dop853::tolerance(1e-13)).every(0.1).run(start, 0.7, |now| {
        let (coordinates, rates) = &series[number];
        assert!(apart(coordinates, &now.motion().coordinates()) < 1e-9 && apart(rates, &now.motion().rates()) < 1e-8);
        number += 1;
    })?;
    assert_eq!(number, series.len());
    Ok(())
}

#[test]
fn derivatives_go_through_series() -> Result<(), Error> {
    // By the length of the second rod and by a rate at the start.
    let run = |length: f64, rate: f64| {
        let scene =
            System::new(Pinned::origin(), (rod(), Ball, Rod::uniform(length, 0.04, 0.4)), Free)?.with_gravity(G);
        let start = scene.at_rest(&[0.3, 0.2, 0.1, 0.0, 0.6, 0.4])?;
        let start = scene.with_rates(start, &[0.2, 0.3, -0.4, rate, -1.0, 1.0])?;
        Ok::<_, Error>(scene.simulate(start, Taylor::<24>::tolerance(1e-14), 0.4, |_| ())?.motion.coordinates())
    };
    type Number = Jet<f64, 2>;
    let of = Number::of;
    let jets = |length: Number, rate: Number| {
        let rods = (Rod::uniform(of(0.5), of(0.05), of(1.0)), Ball, Rod::uniform(length, of(0.04), of(0.4)));
        let scene = System::new(Pinned::origin(), rods, Free)?.with_gravity(G.map(of));
        let start = scene.at_rest(&[0.3, 0.2, 0.1, 0.0, 0.6, 0.4].map(of))?;
        let start = scene.with_rates(start, &[of(0.2), of(0.3), of(-0.4), rate, of(-1.0), of(1.0)])?;
        Ok::<_, Error>(scene.simulate(start, Taylor::<24>::tolerance(1e-14), 0.4, |_| ())?.motion.coordinates())
    };
    let found = jets(Number::seed(0.3, 0), Number::seed(3.0, 1))?;
    let h = 1e-3;
    for (i, found) in found.iter().enumerate() {
        for (k, [dl, dr]) in [[1.0, 0.0], [0.0, 1.0]].into_iter().enumerate() {
            let slope = slope(h, |x| Ok(run(0.3 + x * dl, 3.0 + x * dr)?[i]))?;
            near(found.eps[k], slope, 1e-9);
        }
    }
    Ok(())
}

#[test]
fn single_precision_keeps_its_digits() -> Result<(), Error> {
    let (scene, start) = rods!();
    let exact = scene.simulate(start, Taylor::<20>::tolerance(1e-14), 1.0, |_| ())?.motion.coordinates();
    let single = scene.lift(|x| x as f32);
    let start = single.at_rest(&[0.3, 0.2, 0.1, 0.0, 0.6, 0.4])?;
    let start = single.with_rates(start, &[0.2, 0.3, -0.4, 3.0, -1.0, 1.0])?;
    let run = single.simulate(start, Taylor::<8>::tolerance(1e-6), 1.0, |_| ())?;
    ends_in_single_precision(run.steps, run.motion.coordinates(), &exact);
    assert_eq!(run.rejected, 0);
    Ok(())
}

/// Efforts that stay are known to stay: a step takes one expansion under them, as without.
#[test]
fn efforts_that_stay_expand_once_a_step() -> Result<(), Error> {
    let (scene, start) = tree!();
    let loads = Loads::none().efforts(EFFORTS);
    let run = scene.simulation(Taylor::<20>::tolerance(1e-10)).loads(&loads).run(start, 1.0, |_| ())?;
    println!("{} steps, {} rejected, {} expansions", run.steps, run.rejected, run.sweeps);
    assert_eq!(run.sweeps, run.steps);
    Ok(())
}

#[test]
fn faults_are_those_of_other_rules() -> Result<(), Error> {
    // Nothing resists the spin of a bob on a ball.
    let scene = System::new(Pinned::origin(), (rod(), Ball, PointMass::new(0.3, 0.2)), Free)?.with_gravity(G);
    let (start, mut next) = (scene.motion(), scene.motion());
    let by_series = scene.stepper(Taylor::<12>).step(&start, &Unloaded, 0.01, &mut next);
    let by_sweeps = scene.stepper(Dop853).step(&start, &Unloaded, 0.01, &mut next);
    assert!(by_series.is_err() && by_series == by_sweeps, "{by_series:?}, {by_sweeps:?}");
    // Steps of more than half a turn, also backward.
    let (scene, start) = pendulum!(rod(), [0.0; 3], [100.0, 0.0, 0.0]);
    let mut next = start;
    for dt in [0.04, -0.04] {
        let error = scene.stepper(Taylor::<12>).step(&start, &Unloaded, dt, &mut next).err();
        assert!(
            error.is_some_and(|error| error.fault == Fault::NonFiniteMotion && error.time == Some(dt)),
            "{error:?}"
        );
    }
    Ok(())
}
