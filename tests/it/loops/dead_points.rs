//! Loops that are held too often, next to their dead points: closures that are needed there hold, against one equation of the one
//! freedom, virtual work, and the same mechanism in the plane and with joints that leave nothing held twice.

use catena::loading::Unloaded;
use catena::spatial::*;
use catena::system::{Position, Rate};
use catena::{Error, planar};
use catena_oracle::{Noise, near};

/// Lengths of crank and rocker, and of coupler and ground (m).
const SHORT: f64 = 0.5;
const LONG: f64 = 1.0;
/// Masses of crank, coupler and rocker (kg), gravity (m/s²).
const MASSES: [f64; 3] = [0.5, 1.0, 2.0];
const GRAVITY: f64 = 9.81;
/// Distances from the dead point (rad).
const NEAR: [f64; 6] = [1e-1, 1e-2, 2.5e-3, 1e-3, 1e-4, 1e-5];

fn hinge() -> Revolute<f64> {
    Revolute::about([0.0, 0.0, 1.0])
}

fn rod(length: f64, mass: f64) -> Rod<f64> {
    Rod::new(length, mass, 0.5 * length, 1e-4, mass * length * length / 12.0)
}

/// The parallelogram, with this joint of the crank, these in the coupler and where it is closed.
macro_rules! parallelogram {
    ($crank:expr, $turn:expr, $closing:expr) => {{
        let [crank, coupler, rocker] = MASSES;
        let main = ($crank, rod(SHORT, crank), $turn, rod(LONG, coupler));
        let side = (RigidBody::massless([LONG, 0.0, 0.0]), hinge(), rod(SHORT, rocker));
        System::new(Clamped::origin(), Network::new(main, side, $closing), Free)?.with_gravity([0.0, -GRAVITY, 0.0])
    }};
}

/// The same in the plane.
macro_rules! planar_parallelogram {
    () => {{
        let rod = |length: f64, mass: f64| planar::Rod::new(length, mass, 0.5 * length, mass * length * length / 12.0);
        let [crank, coupler, rocker] = MASSES;
        let main = (planar::Pin, rod(SHORT, crank), planar::Pin, rod(LONG, coupler));
        let side = (planar::RigidBody::massless([LONG, 0.0]), planar::Pin, rod(SHORT, rocker));
        let net = planar::Network::new(main, side, planar::Pin);
        planar::System::new(planar::Clamped::at(0.0, 0.0, 0.0), net, planar::Free)?.with_gravity(GRAVITY)
    }};
}

/// The torque of gravity about the crank of a parallelogram of one freedom (N·m), and its inertia (kg·m²).
fn alone(angle: f64) -> [f64; 2] {
    let [crank, coupler, rocker] = MASSES;
    let torque = -(0.5 * crank + coupler + 0.5 * rocker) * GRAVITY * SHORT * angle.cos();
    [torque, (crank / 3.0 + coupler + rocker / 3.0) * SHORT * SHORT]
}

/// Angle and rate of the crank after a time (s), by the classical rule in many steps.
fn by_hand(start: [f64; 2], time: f64) -> [f64; 2] {
    let steps = 20_000;
    let h = time / f64::from(steps);
    let slope = |[angle, rate]: [f64; 2]| {
        let [torque, inertia] = alone(angle);
        [rate, torque / inertia]
    };
    let plus = |y: [f64; 2], h: f64, k: [f64; 2]| [y[0] + h * k[0], y[1] + h * k[1]];
    (0..steps).fold(start, |y, _| {
        let k = slope(y);
        let l = slope(plus(y, 0.5 * h, k));
        let m = slope(plus(y, 0.5 * h, l));
        let n = slope(plus(y, h, m));
        core::array::from_fn(|i| y[i] + h / 6.0 * (k[i] + 2.0 * (l[i] + m[i]) + n[i]))
    })
}

fn positions(position: &impl Position<f64>) -> Vec<f64> {
    let mut all = vec![];
    position.visit(&mut |x: f64| all.push(x));
    all
}

fn rates(rate: &impl Rate<f64>) -> Vec<f64> {
    let mut all = vec![];
    rate.visit(&mut |x: f64| all.push(x));
    all
}

/// A parallelogram whose crank is held has no freedom, and virtual work says what torque holds it.
#[test]
fn a_parallelogram_with_its_crank_held_stands_still() -> Result<(), Error> {
    for angle in NEAR.into_iter().flat_map(|x| [x, -x]) {
        let crank = Driven::new(hinge(), move |_: f64| [angle, 0.0, 0.0]);
        let scene = parallelogram!(crank, hinge(), LeastNorm(hinge()));
        let start = scene.assembled(scene.at_rest(&[-angle, angle])?, &Unloaded)?;
        let fall = start.accelerations().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let held = scene.stations(&start, &Unloaded)?.get(0).expect("the crank's joint").internal.torque.z;
        let end = scene.simulate(start, Dop853::tolerance(1e-9), 0.5, |_| ())?.motion;
        let rate = rates(end.rate()).into_iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        println!("{angle:e}: accelerations {fall:.1e}, rates {rate:.1e}, torque {held}");
        assert!(fall < 1e-9 && rate < 1e-12);
        near(held, alone(angle)[0], 1e-5);
    }
    Ok(())
}

/// Unlike bars, released.
#[test]
fn a_parallelogram_falls_as_its_one_freedom_does() -> Result<(), Error> {
    let scene = parallelogram!(hinge(), hinge(), LeastNorm(hinge()));
    let free = parallelogram!(hinge(), Universal::about([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]), Ball);
    let flat = planar_parallelogram!();
    for angle in NEAR.into_iter().chain([4e-3]).flat_map(|x| [x, -x]) {
        let start = scene.assembled(scene.at_rest(&[angle, -angle, angle])?, &Unloaded)?;
        let [torque, inertia] = alone(angle);
        let exact = torque / inertia;
        let found = start.accelerations();
        let off = [exact, -exact, exact].iter().zip(found.iter()).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        let twin = flat.with_accelerations(flat.at_rest(&[angle, 0.0, angle])?, &Unloaded)?;
        let twin = (rates(twin.acceleration())[0] - found[0]).abs();
        // As long as its own closures count as independent.
        let other = if angle.abs() > 1e-4 {
            let other = free.with_accelerations(free.at_rest(&[angle, -angle, 0.0, angle])?, &Unloaded)?;
            (rates(other.acceleration())[0] - found[0]).abs()
        } else {
            0.0
        };
        println!(
            "{angle:e}: off by {off:.1e}, from the plane by {twin:.1e}, without redundant closures by {other:.1e}"
        );
        assert!(off < 1e-10 && twin < 1e-5 && other < 1e-5);
        let energy = scene.budget(&start)?.energy();
        let end = scene.simulate(start, Dop853::tolerance(1e-9), 0.5, |_| ())?.motion;
        let missed = positions(end.position())[0] - by_hand([angle, 0.0], 0.5)[0];
        let lost = scene.budget(&end)?.energy() - energy;
        println!("  after 0.5 s by {missed:.1e} rad, {lost:.1e} J");
        // Nearer than that the first steps lead over the dead point.
        let most = if angle.abs() > 2e-5 { 1e-8 } else { 1e-4 };
        assert!(missed.abs() < most && lost.abs() < most);
    }
    Ok(())
}

/// In single precision, down to what its rounding leaves.
#[test]
fn a_parallelogram_of_single_precision_holds_to_a_hundredth_of_a_radian() -> Result<(), Error> {
    let hinge = Revolute::about([0.0_f32, 0.0, 1.0]);
    let rod = |length: f32, mass: f32| Rod::new(length, mass, 0.5 * length, 1e-4, mass * length * length / 12.0);
    let main = (hinge, rod(0.5, 0.5), hinge, rod(1.0, 1.0));
    let side = (RigidBody::massless([1.0_f32, 0.0, 0.0]), hinge, rod(0.5, 2.0));
    let net = Network::new(main, side, LeastNorm(hinge));
    let scene = System::new(Clamped::origin(), net, Free)?.with_gravity([0.0_f32, -9.81, 0.0]);
    for angle in [1e-1_f32, 3e-2, 1e-2] {
        let start = scene.with_accelerations(scene.at_rest(&[angle, -angle, angle])?, &Unloaded)?;
        let [torque, inertia] = alone(f64::from(angle));
        for (found, sign) in start.accelerations().iter().zip([1.0, -1.0, 1.0]) {
            println!("{angle}: {found} for {}", sign * torque / inertia);
            near(f64::from(*found), sign * torque / inertia, 1e-2);
        }
    }
    Ok(())
}

/// Through the dead point at one speed or another, wherever steps fall.
#[test]
fn a_parallelogram_goes_through_its_dead_points_as_in_the_plane() -> Result<(), Error> {
    let scene = parallelogram!(hinge(), hinge(), LeastNorm(hinge()));
    for k in 0..10 {
        let (angle, rate) = (0.3 + 0.15 * f64::from(k), -3.0 - 0.4 * f64::from(k));
        let start = scene.with_rates(scene.at_rest(&[angle, -angle, angle])?, &[rate, -rate, rate])?;
        let exact = by_hand([angle, rate], 2.0)[0];
        let coarse = scene.simulation(Rk4::step(1e-2)).run(start, 2.0, |_| ())?.motion;
        let fine = scene.simulation(Dop853::tolerance(1e-9)).run(start, 2.0, |_| ())?.motion;
        let missed = [coarse, fine].map(|end| (positions(end.position())[0] - exact).abs());
        println!("{angle:.2}, {rate:.1}: {:.1e} and {:.1e}", missed[0], missed[1]);
        assert!(missed[0] < 1e-5 && missed[1] < 1e-6);
    }
    Ok(())
}

/// What follows from other closures is shared out all the same: z of the ends, and both torques across the axis.
#[test]
fn what_is_held_twice_is_told_next_to_dead_points() -> Result<(), Error> {
    let scene = parallelogram!(hinge(), hinge(), LeastNorm(hinge()));
    for angle in NEAR {
        let start = scene.with_accelerations(scene.at_rest(&[angle, -angle, angle])?, &Unloaded)?;
        let mut shared = vec![];
        scene.shared_forces(&start, &Unloaded, |station, name| shared.push((station, name)))?;
        println!("{angle:e}: {shared:?}");
        assert_eq!(shared.len(), 3);
        assert!(
            shared.iter().all(|(station, name)| *station == 7 && (name.starts_with('z') || name.starts_with("tilt")))
        );
    }
    Ok(())
}

/// Linkages of any lengths with a + b = c + d, and of any masses, next to where all bars lie on one line: as in the plane, where that
/// takes closures for independent.
#[test]
fn linkages_that_become_flat_move_as_in_the_plane() -> Result<(), Error> {
    let mut noise = Noise::new(11);
    for angle in [1e-1_f64, 1e-2, 1e-3, 1e-4, 3e-5] {
        let (mut worst, mut count) = (0.0_f64, 0);
        while count < 100 {
            let [a, b, c] = [(); 3].map(|()| noise.between(0.2, 2.0));
            let masses = [(); 3].map(|()| noise.between(0.1, 5.0));
            let d = a + b - c;
            // The triangle of coupler and rocker, by half its angle.
            let [x, y] = [d - a * angle.cos(), -a * angle.sin()];
            let across = x.hypot(y);
            let square = (c * c - (b - across).powi(2)) / (4.0 * b * across);
            if d < 0.1 || !(0.0..1.0).contains(&square) {
                continue;
            }
            let coupler = y.atan2(x) + 2.0 * square.sqrt().asin();
            let end = [a * angle.cos() + b * coupler.cos(), a * angle.sin() + b * coupler.sin()];
            let rocker = end[1].atan2(end[0] - d);
            let twin = {
                let bar = |length: f64, mass: f64| {
                    planar::Rod::new(length, mass, 0.5 * length, mass * length * length / 12.0)
                };
                let main = (planar::Pin, bar(a, masses[0]), planar::Pin, bar(b, masses[1]));
                let side = (planar::RigidBody::massless([d, 0.0]), planar::Pin, bar(c, masses[2]));
                let net = planar::Network::new(main, side, planar::Pin);
                let scene = planar::System::new(planar::Clamped::at(0.0, 0.0, 0.0), net, planar::Free)?;
                let scene = scene.with_gravity(GRAVITY);
                let posture = scene.at_rest(&[angle, coupler, rocker])?;
                scene.with_accelerations(posture, &Unloaded).map(|found| rates(found.acceleration()))
            };
            let Ok(twin) = twin else { continue };
            let main = (hinge(), rod(a, masses[0]), hinge(), rod(b, masses[1]));
            let side = (RigidBody::massless([d, 0.0, 0.0]), hinge(), rod(c, masses[2]));
            let scene = System::new(Clamped::origin(), Network::new(main, side, LeastNorm(hinge())), Free)?;
            let scene = scene.with_gravity([0.0, -GRAVITY, 0.0]);
            let found = scene.with_accelerations(scene.at_rest(&[angle, coupler - angle, rocker])?, &Unloaded)?;
            let found = rates(found.acceleration());
            let size = twin.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
            for (found, twin) in [found[0], found[0] + found[1], found[2]].iter().zip(twin) {
                worst = worst.max((found - twin).abs() / size);
            }
            count += 1;
        }
        println!("{angle:e}: {worst:.1e}");
        assert!(worst < 1e-9);
    }
    Ok(())
}
