//! Where fixed steps of implicit rules break on a taut string: they know the stiffness of springs, not that of tension.
//!
//! Beads of mass ρA l on links of length l under a tension T swing with up to 2 √(T / ρA) / l, uniform rods with √3 as much.

use catena::loading::Unloaded;
use catena::planar::*;
use catena::simulate::{Method, Stepper};
use catena::time::Sdirk4;
use core::f64::consts::FRAC_PI_2;

const G: f64 = 9.81;
const LINKS: usize = 12;
const LENGTH: f64 = 0.1;
const DENSITY: f64 = 1.0;
const LOAD: f64 = 2000.0;

type String = System<f64, Pinned<[f64; 2]>, (Rod<f64>, [(Pin, Rod<f64>); LINKS - 1], RigidBody<f64>), Free>;

/// A load of two tons on a string of links: its tension is even within the weight of the string, 6e-4 of it.
fn string(link: Rod<f64>) -> String {
    System::new(
        Pinned::origin(),
        (link, [(Pin, link); LINKS - 1], RigidBody::new(LOAD, 0.0, [0.0; 2], [0.1, 0.0])),
        Free,
    )
    .expect("a scene")
    .with_gravity(G)
}

/// Whether a zigzag of a microradian becomes a milliradian in so many steps, or no motion at all.
fn breaks<M>(scene: &String, method: M, step: f64) -> bool
where
    M: for<'s> Method<&'s String, Unloaded>,
{
    let zigzag: Vec<f64> = (0..LINKS).map(|k| -FRAC_PI_2 + if k % 2 == 0 { 1e-6 } else { -1e-6 }).collect();
    let mut past = scene.with_accelerations(scene.at_rest(&zigzag).expect("angles"), &Unloaded).expect("a motion");
    let mut next = past;
    let mut stepper = scene.stepper(method);
    for _ in 0..20_000 {
        if stepper.advance(&past, &Unloaded, step, &mut next).is_err() {
            return true;
        }
        core::mem::swap(&mut past, &mut next);
        if scene.angles(&past).unwrap().iter().any(|angle| (angle + FRAC_PI_2).abs() > 1e-3) {
            return true;
        }
    }
    false
}

/// The step at which it begins to break, times a frequency: by bisection.
fn limit(frequency: f64, breaks: impl Fn(f64) -> bool) -> f64 {
    let [mut low, mut high] = [0.1, 10.0];
    assert!(!breaks(low / frequency) && breaks(high / frequency));
    while high - low > 5e-3 {
        let middle = 0.5 * (low + high);
        if breaks(middle / frequency) { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

/// The rule of generalised α for ẍ = −ω² x with h = 1, where all the force is taken at the last iterate: as its formulas stand in
/// Arnold and Brüls (2007).
fn scalar(rho: f64, sweeps: usize, frequency: f64) -> bool {
    let (am, af) = ((2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0));
    let gamma = 0.5 + af - am;
    let beta = 0.25 * (gamma + 0.5) * (gamma + 0.5);
    let square = frequency * frequency;
    let (mut q, mut v, mut a) = (1.0_f64, 0.0, -square);
    let mut auxiliary = a;
    for _ in 0..20_000 {
        let (mut place, mut found, mut next) = (q + v, a, auxiliary);
        for sweep in 0..sweeps {
            if sweep > 0 {
                place = q + v + (0.5 - beta) * auxiliary + beta * next;
            }
            found = -square * place;
            next = ((1.0 - af) * found + af * a - am * auxiliary) / (1.0 - am);
        }
        q += v + (0.5 - beta) * auxiliary + beta * next;
        v += (1.0 - gamma) * auxiliary + gamma * next;
        (a, auxiliary) = (found, next);
        if q.abs() > 1e3 {
            return true;
        }
    }
    false
}

fn beads() -> String {
    let none = 1e-9 * DENSITY * LENGTH * LENGTH * LENGTH;
    string(Rod::new(LENGTH, DENSITY * LENGTH, LENGTH, none))
}

/// 2 √(T / ρA) / l.
fn highest() -> f64 {
    2.0 * (LOAD * G / DENSITY).sqrt() / LENGTH
}

#[test]
fn steps_of_generalised_alpha_break_where_the_highest_frequency_says() {
    let rule = GeneralizedAlpha::new(0.8);
    let expected = limit(1.0, |frequency| scalar(0.8, 2, frequency));
    for (scene, factor) in [(beads(), 1.0), (string(Rod::uniform(LENGTH, DENSITY * LENGTH)), 3.0_f64.sqrt())] {
        let found = limit(factor * highest(), |step| breaks(&scene, rule, step));
        println!("breaks at h omega = {found:.3}, a single oscillator at {expected:.3}");
        // The highest mode of twelve links is slower than the bound by 1 - sin(11 π / 24), 1 %, and grows slowly at first.
        assert!((1.95..2.15).contains(&found) && (1.95..2.15).contains(&expected));
    }
}

#[test]
fn steps_of_sdirk4_break_too() {
    let found = limit(highest(), |step| breaks(&beads(), Sdirk4::new(), step));
    println!("SDIRK4 breaks at h omega = {found:.3}");
    assert!((1.0..1.2).contains(&found));
}

/// Error control finds the bound by rejections: ten times the tolerance wins next to nothing, where a rule of order two would take steps
/// twice as long.
#[test]
fn error_control_steps_no_further() {
    let scene = beads();
    let zigzag: Vec<f64> = (0..LINKS).map(|k| -FRAC_PI_2 + if k % 2 == 0 { 1e-6 } else { -1e-6 }).collect();
    let mean = |tolerance: f64| {
        let start = scene.at_rest(&zigzag).expect("angles");
        let rule = GeneralizedAlpha::new(0.8).tolerance(tolerance);
        let run = scene.simulate(start, rule, 1.0, |_| ()).expect("a run");
        let mean = highest() / run.steps as f64;
        println!("tolerance {tolerance:e}: {} steps, {} rejected, h omega {mean:.2}", run.steps, run.rejected);
        assert!(10 * run.rejected > run.steps);
        mean
    };
    let [narrow, wide] = [1e-5, 1e-4].map(mean);
    assert!(wide < 2.2 && wide < 1.4 * narrow);
}
