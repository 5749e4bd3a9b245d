//! Taylor series through change points: parallelograms whose bars come into a line twice a turn, where they could go on as antiparallelograms.
//!
//! Cranks of mass 1 and length 0.2 and a coupler of mass 2, which keeps its direction: l (2 m / 3 + M) θ̈ = −(m + M) g cos θ. That equation is integrated here,
//! and shares nothing with the library.

use super::by_series::apart;
use catena::planar::*;
use catena::{Error, Fault};
use core::f64::consts::PI;

const G: f64 = 9.81;
const CRANK: f64 = 0.2;

/// The angle of the cranks after a time (s), by classical Runge-Kutta steps.
fn angle_after(time: f64, [mut angle, mut rate]: [f64; 2]) -> f64 {
    let slope = |angle: f64| -3.0 * G / (CRANK * (2.0 / 3.0 + 2.0)) * angle.cos();
    let steps = (time / 1e-4).round();
    let h = time / steps;
    for _ in 0..steps as usize {
        let (v1, a1) = (rate, slope(angle));
        let (v2, a2) = (rate + 0.5 * h * a1, slope(angle + 0.5 * h * v1));
        let (v3, a3) = (rate + 0.5 * h * a2, slope(angle + 0.5 * h * v2));
        let (v4, a4) = (rate + h * a3, slope(angle + h * v3));
        angle += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
        rate += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    }
    angle
}

/// Arms that meet.
macro_rules! network {
    () => {{
        let (crank, coupler) = (Rod::uniform(CRANK, 1.0), Rod::uniform(1.0, 2.0));
        let net = Network::new((Pin, crank, Pin, coupler), (RigidBody::massless([1.0, 0.0]), Pin, crank), Pin);
        System::new(Clamped::origin(), net, Free)?.with_gravity(G)
    }};
}

/// The same as a chain whose tip is held.
macro_rules! held {
    () => {{
        let (crank, coupler) = (Rod::uniform(CRANK, 1.0), Rod::uniform(1.0, 2.0));
        System::new(Pinned::origin(), (crank, Pin, coupler, Pin, crank), Pinned::at(1.0, 0.0))?.with_gravity(G)
    }};
}

/// A pendulum on the coupler.
macro_rules! laden {
    () => {{
        let (crank, coupler) = (Rod::uniform(CRANK, 1.0), Rod::uniform(1.0, 2.0));
        let main = (Pin, crank, Pin, coupler, Branch((Pin, Rod::uniform(0.3, 0.5))));
        let net = Network::new(main, (RigidBody::massless([1.0, 0.0]), Pin, crank), Pin);
        System::new(Clamped::origin(), net, Free)?.with_gravity(G)
    }};
}

/// A start from coordinates and rates.
macro_rules! start {
    ($scene:expr, $coordinates:expr, $rates:expr) => {{
        let mut start = $scene.motion();
        start.set_coordinates(&$coordinates)?;
        start.set_rates(&$rates)?;
        $scene.assembled(start, &Unloaded)?
    }};
}

/// Angles and rates of cranks at several starts.
fn starts() -> impl Iterator<Item = [f64; 2]> {
    (0..10).map(f64::from).map(|i| [0.3 + 0.24 * i, if i % 2.0 == 0.0 { 11.0 + 0.4 * i } else { -12.0 - 0.1 * i }])
}

/// Whether runs from several starts end where the equation says, with the energy that they began with; of what cannot be right, whether it is refused.
macro_rules! follows {
    ($name:literal, $scene:expr, $last:expr, $rule:expr, $within:expr, $refused:expr) => {{
        let scene = $scene;
        let (mut refused, mut off, mut drift) = (0, 0.0_f64, 0.0_f64);
        for [angle, rate] in starts() {
            let start = start!(scene, [angle, 0.0, angle + $last], [rate, 0.0, rate]);
            let energy = scene.budget(&start)?.energy();
            match scene.simulate(start, $rule, 2.0, |_| ()) {
                Ok(run) => {
                    off = off.max((run.motion.coordinates()[0] - angle_after(2.0, [angle, rate])).abs());
                    drift = drift.max((scene.budget(&run.motion)?.energy() - energy).abs());
                }
                Err(ended) => {
                    println!("{}: {}", $name, ended.error);
                    let fault = ended.error.fault;
                    assert!(matches!(fault, Fault::RedundantClosures { .. } | Fault::StepTooSmall { .. }));
                    refused += 1;
                }
            }
        }
        println!("{}: off by {off:.1e}, energy {drift:.1e}, {refused} refused", $name);
        assert!(off < $within && drift < $within && refused <= $refused);
    }};
}

#[test]
fn cranks_turn_as_one_equation_says() -> Result<(), Error> {
    let scene = network!();
    let start = start!(scene, [1.0, 0.0, 1.0], [12.0, 0.0, 12.0]);
    let energy = scene.budget(&start)?.energy();
    let exact = angle_after(5.0, [1.0, 12.0]);
    macro_rules! turns {
        ($rule:expr, $within:expr) => {{
            let run = scene.simulate(start, $rule, 5.0, |_| ())?;
            let off = run.motion.coordinates()[0] - exact;
            let drift = scene.budget(&run.motion)?.energy() - energy;
            println!("{} steps, {} sweeps, off by {off:.1e}, energy {drift:.1e}", run.steps, run.sweeps);
            assert!(off.abs() < $within && drift.abs() < $within);
        }};
    }
    turns!(Taylor::<24>::tolerance(1e-12), 1e-7);
    turns!(Taylor::<16>::tolerance(1e-10), 2e-7);
    turns!(Taylor::<16>::tolerance(1e-11), 1e-7);
    turns!(Taylor::<16>::tolerance(1e-13), 1e-7);
    turns!(AutoTaylor::<24>::tolerance(1e-12), 1e-7);
    turns!(Taylor::<10>::step(1e-2), 1e-6);
    turns!(Taylor::<10>::step(1e-3), 1e-6);
    Ok(())
}

#[test]
fn networks_go_on_as_they_are() -> Result<(), Error> {
    follows!("1e-12", network!(), 0.0, Taylor::<24>::tolerance(1e-12), 1e-7, 1);
    follows!("1e-10", network!(), 0.0, Taylor::<24>::tolerance(1e-10), 2e-7, 0);
    follows!("with stiff rules", network!(), 0.0, AutoTaylor::<24>::tolerance(1e-12), 1e-7, 1);
    Ok(())
}

#[test]
fn chains_to_a_held_tip_go_on_as_they_are() -> Result<(), Error> {
    follows!("1e-12", held!(), PI, Taylor::<24>::tolerance(1e-12), 1e-7, 1);
    follows!("1e-10", held!(), PI, Taylor::<24>::tolerance(1e-10), 2e-7, 0);
    follows!("with stiff rules", held!(), PI, AutoTaylor::<24>::tolerance(1e-12), 1e-7, 1);
    Ok(())
}

#[test]
fn fixed_steps_go_on_or_are_refused() -> Result<(), Error> {
    follows!("network, 5 ms", network!(), 0.0, Taylor::<10>::step(5e-3), 2e-6, 1);
    follows!("network, 1 ms", network!(), 0.0, Taylor::<10>::step(1e-3), 2e-6, 1);
    follows!("held, 10 ms", held!(), PI, Taylor::<10>::step(1e-2), 2e-6, 1);
    follows!("held, 1 ms", held!(), PI, Taylor::<10>::step(1e-3), 2e-6, 2);
    Ok(())
}

#[test]
fn a_pendulum_on_the_coupler_keeps_its_energy() -> Result<(), Error> {
    let scene = laden!();
    let start = start!(scene, [1.0, 0.0, -1.0, 1.0], [12.0, 0.0, 0.0, 12.0]);
    let energy = scene.budget(&start)?.energy();
    let other = scene.simulate(start, Dop853::tolerance(1e-13), 2.0, |_| ())?.motion;
    macro_rules! keeps {
        ($rule:expr) => {{
            let run = scene.simulate(start, $rule, 2.0, |_| ())?;
            let off = apart(&run.motion.coordinates(), &other.coordinates());
            let drift = scene.budget(&run.motion)?.energy() - energy;
            println!("{} steps, {} sweeps, apart by {off:.1e}, energy {drift:.1e}", run.steps, run.sweeps);
            assert!(off < 1e-5 && drift.abs() < 1e-7);
        }};
    }
    keeps!(Taylor::<24>::tolerance(1e-12));
    keeps!(Taylor::<24>::tolerance(1e-13));
    keeps!(Taylor::<10>::step(1e-3));
    Ok(())
}

#[test]
fn samples_and_saved_runs_lead_through_them() -> Result<(), Error> {
    let scene = held!();
    let start = start!(scene, [1.0, 0.0, 1.0 + PI], [12.0, 0.0, 12.0]);
    let energy = scene.budget(&start)?.energy();
    macro_rules! sampled {
        ($rule:expr, $within:expr) => {{
            let mut drift = 0.0_f64;
            scene
                .simulation($rule)
                .every(0.0037)
                .run(start, 1.0, |now| drift = drift.max((now.energy() - energy).abs()))?;
            println!("energy of samples {drift:.1e}");
            assert!(drift < $within);
        }};
    }
    sampled!(Taylor::<24>::tolerance(1e-12), 1e-6);
    sampled!(Taylor::<10>::step(1e-2), 1e-5);
    macro_rules! goes_on {
        ($rule:expr) => {{
            let whole = scene.simulate(start, $rule, 1.0, |_| ())?;
            let mut saved = scene.simulation($rule).begin(start, 1.0, |_| ())?.save();
            let resumed = loop {
                let mut run = scene.simulation($rule).resume(saved, 1.0, |_| ())?;
                if !run.step()? {
                    break run.finish()?;
                }
                saved = run.save();
            };
            assert_eq!((whole.motion, whole.steps, whole.rejected), (resumed.motion, resumed.steps, resumed.rejected));
        }};
    }
    goes_on!(Taylor::<24>::tolerance(1e-12));
    goes_on!(AutoTaylor::<24>::tolerance(1e-12));
    goes_on!(Taylor::<10>::step(1e-2));
    Ok(())
}
