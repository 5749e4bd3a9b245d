//! Joints that are at the limits of their friction at once: stacks on shaking tables, and storeys whose friction goes with the mass above.

use catena::planar::*;
use catena_oracle::{Noise, near};
use std::f64::consts::TAU;

const G: f64 = 9.81;
const MU: f64 = 0.3;
/// How the table shakes: 6 sin τt (m/s²).
const SHAKE: f64 = 6.0;

/// How far a block has slipped on the table after `end` (s), from where it breaks away to where it comes to rest, in closed form.
fn slip(end: f64) -> f64 {
    let (mut time, mut place) = (0.0, 0.0);
    let pull = |t: f64| SHAKE * (TAU * t).sin();
    while time < end {
        if pull(time).abs() <= MU * G {
            // It sticks until the next instant at which it is pulled by more.
            let step = 1e-5;
            while time < end && pull(time + step).abs() <= MU * G {
                time += step;
            }
            let (mut low, mut high) = (time, time + step);
            for _ in 0..60 {
                let mid = 0.5 * (low + high);
                if pull(mid).abs() <= MU * G { low = mid } else { high = mid }
            }
            time = high;
            continue;
        }
        let (began, sign) = (time, -pull(time).signum());
        let rate = |t: f64| -sign * MU * G * (t - began) + SHAKE / TAU * ((TAU * t).cos() - (TAU * began).cos());
        let mut stops = began + 1e-6;
        while rate(stops) * sign > 0.0 && stops < end {
            stops += 1e-5;
        }
        if stops < end {
            let (mut low, mut high) = (stops - 1e-5, stops);
            for _ in 0..60 {
                let mid = 0.5 * (low + high);
                if rate(mid) * sign > 0.0 { low = mid } else { high = mid }
            }
            stops = high;
        }
        let (stops, past) = (stops.min(end), stops.min(end) - began);
        place += -0.5 * sign * MU * G * past * past
            + SHAKE / TAU * (((TAU * stops).sin() - (TAU * began).sin()) / TAU - (TAU * began).cos() * past);
        time = stops;
    }
    place
}

/// A storey by hand: mass (kg), stiffness (N/m), damping (N·s/m) and friction (N) below it.
type Storey = [f64; 4];

/// Slips of storeys on a ground that accelerates, by time stepping of order one: impulses of friction by projected Gauss-Seidel, which knows no modes.
fn stepped<const N: usize>(storeys: [Storey; N], ground: impl Fn(f64) -> f64, (end, steps): (f64, usize)) -> [f64; N] {
    let h = end / steps as f64;
    let inverse = |i: usize| 1.0 / storeys[i][0] + if i > 0 { 1.0 / storeys[i - 1][0] } else { 0.0 };
    let (mut slips, mut speeds, mut rubs) = ([0.0; N], [0.0; N], [0.0; N]); // speeds against the ground
    let slip = |speeds: &[f64; N], i: usize| speeds[i] - if i > 0 { speeds[i - 1] } else { 0.0 };
    let push = |speeds: &mut [f64; N], i: usize, impulse: f64| {
        speeds[i] += impulse / storeys[i][0];
        if i > 0 {
            speeds[i - 1] -= impulse / storeys[i - 1][0];
        }
    };
    for step in 0..steps {
        let pull = ground((step as f64 + 0.5) * h);
        let forces: [f64; N] = core::array::from_fn(|i| -storeys[i][1] * slips[i] - storeys[i][2] * slip(&speeds, i));
        speeds.iter_mut().for_each(|speed| *speed -= h * pull);
        (0..N).for_each(|i| push(&mut speeds, i, h * (forces[i] + rubs[i])));
        for _ in 0..200 {
            let mut most = 0.0_f64;
            for i in 0..N {
                let wanted: f64 = rubs[i] - slip(&speeds, i) / (h * inverse(i));
                let found = wanted.clamp(-storeys[i][3], storeys[i][3]);
                push(&mut speeds, i, h * (found - rubs[i]));
                most = most.max((found - rubs[i]).abs());
                rubs[i] = found;
            }
            if most < 1e-12 {
                break;
            }
        }
        (0..N).for_each(|i| slips[i] += h * slip(&speeds, i));
    }
    slips
}

#[test]
fn a_stack_slides_as_one_block() -> Result<(), Box<dyn std::error::Error>> {
    let expected = slip(3.0);
    for masses in [[1.0, 1.0], [2.0, 1.0], [1.3, 0.7], [3.0, 1.1]] {
        let block = |i: usize| {
            let friction = MU * G * masses[i..].iter().sum::<f64>();
            (Coulomb::new(Slider::along(0.0), friction), RigidBody::new(masses[i], 1.0, [0.0; 2], [0.0; 2]))
        };
        let table = |t: f64| {
            let (sine, cosine) = (TAU * t).sin_cos();
            GroundMotion {
                place: [-SHAKE * sine / (TAU * TAU), 0.0],
                velocity: [-SHAKE * cosine / TAU, 0.0],
                acceleration: [SHAKE * sine, 0.0],
            }
        };
        let scene = System::new(Clamped::on(Moving(table), 0.0), (block(0), block(1)), Free)?.with_gravity(G);
        macro_rules! check {
            ($rule:expr, $tolerance:expr) => {{
                let end = scene.simulation($rule).run(scene.motion(), 3.0, |_| ())?.motion;
                near(end.coordinates()[0], expected, $tolerance);
                near(end.coordinates()[1], 0.0, $tolerance);
            }};
        }
        check!(Dop853::tolerance(1e-9), 1e-9);
        check!(Dopri5::tolerance(1e-8), 1e-7);
        check!(Rk4::step(1e-3), 1e-10);
        check!(Sdirk4::new().step(1e-3), 1e-9);
        check!(Vcabm::new().tolerance(1e-9), 1e-7);
        check!(GeneralizedAlpha::new(0.8).step(1e-3), 1e-5); // order two
        check!(MoreauJean::step(1e-3), 1e-3); // order one
    }
    Ok(())
}

/// Friction in proportion to the mass above, a ground that pulls ever more: all storeys break away as one, and springs part them by little.
#[test]
fn storeys_break_away_at_once() -> Result<(), Box<dyn std::error::Error>> {
    let ground =
        |t: f64| GroundMotion { place: [t * t * t / 6.0, 0.0], velocity: [0.5 * t * t, 0.0], acceleration: [t, 0.0] };
    let mut random = Noise::new(3);
    for scene in 0..40 {
        let mu = random.between(0.3, 1.0);
        let masses: [f64; 3] = core::array::from_fn(|_| random.between(0.5, 3.0));
        let damping = if scene % 2 == 0 { 1.0 } else { 0.1 };
        let storey = |i: usize| {
            let friction = mu * masses[i..].iter().sum::<f64>();
            let joint = Coulomb::new(Slider::along(0.0), friction).with(Spring::new(50.0).damped(damping));
            (joint, RigidBody::new(masses[i], 1.0, [0.0; 2], [0.0; 2]))
        };
        let tower = System::new(Clamped::on(Moving(ground), 0.0), (storey(0), storey(1), storey(2)), Free)?;
        let run = tower.simulation(Dop853::tolerance(1e-9)).run(tower.motion(), 3.0, |_| ())?;
        assert!(run.steps < 400, "{scene}: {}", run.steps);
        let (fine, coarse) = (
            tower.simulation(Rk4::step(1e-3)).run(tower.motion(), 3.0, |_| ())?.motion,
            tower.simulation(MoreauJean::step(1e-3)).run(tower.motion(), 3.0, |_| ())?.motion,
        );
        for ((found, fine), coarse) in run.motion.coordinates().iter().zip(fine.coordinates()).zip(coarse.coordinates())
        {
            near(*found, fine, 1e-6);
            near(*found, coarse, 3e-3); // order one, in steps of 1 ms
        }
        let by_hand = core::array::from_fn(|i| [masses[i], 50.0, damping, mu * masses[i..].iter().sum::<f64>()]);
        let by_hand = stepped::<3>(by_hand, |t| t, (3.0, 30_000));
        for (found, expected) in run.motion.coordinates().iter().zip(by_hand) {
            near(*found, expected, 3e-4); // order one, in steps of 0.1 ms
        }
    }
    Ok(())
}

/// A table of accelerations, each 20 ms, and a rule whose steps leave other accelerations than those of the motion: runs end.
#[test]
fn generalised_alpha_ends_under_a_record() -> Result<(), Box<dyn std::error::Error>> {
    fn record(t: f64) -> f64 {
        let knot = (t / 0.02).floor();
        let at = |k: f64| 4.0 * (k * k).sin() * (-0.004 * k).exp();
        let share = t / 0.02 - knot;
        at(knot) * (1.0 - share) + at(knot + 1.0) * share
    }
    let ground = |t: f64| GroundMotion { place: [0.0; 2], velocity: [0.0; 2], acceleration: [record(t), 0.0] };
    let floor = |mass: f64, stiffness: f64, friction: f64| {
        let joint = Coulomb::new(Slider::along(0.0), friction).with(Spring::new(stiffness).damped(0.4));
        (joint, RigidBody::new(mass, 1.0, [0.0; 2], [0.0; 2]))
    };
    let scene = System::new(Clamped::on(Moving(ground), 0.0), (floor(2.0, 900.0, 3.0), floor(1.5, 800.0, 2.1)), Free)?;
    let expected = scene.simulation(Dop853::tolerance(1e-9)).run(scene.motion(), 9.0, |_| ())?.motion.coordinates();
    let by_hand = stepped([[2.0, 900.0, 0.4, 3.0], [1.5, 800.0, 0.4, 2.1]], record, (9.0, 180_000));
    expected.iter().zip(by_hand).for_each(|(found, expected)| near(*found, expected, 3e-5));
    let mut runs = 0;
    macro_rules! check {
        ($rule:expr) => {{
            let mut run = scene.simulation($rule).begin(scene.motion(), 9.0, |_| ())?;
            let mut steps = 0;
            while run.step()? {
                steps += 1;
                assert!(steps < 30_000, "at {} s", run.motion().time());
            }
            for (found, expected) in run.motion().coordinates().iter().zip(&expected) {
                near(*found, *expected, 3e-3); // 1.3e-3 was seen
            }
            runs += 1;
        }};
    }
    for step in [0.005, 0.0064, 0.01, 0.0128, 0.02] {
        check!(GeneralizedAlpha::new(0.8).step(step));
        check!(GeneralizedAlpha::trapezoidal().step(step));
    }
    for tolerance in [1e-3, 2e-4, 1e-4, 1e-5] {
        check!(GeneralizedAlpha::new(0.8).tolerance(tolerance));
    }
    assert_eq!(runs, 14);
    Ok(())
}
