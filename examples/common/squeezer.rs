//! Andrews' squeezing mechanism, from the IVP test set (Mazzia and Magherini; Hairer and Wanner, Solving Ordinary Differential
//! Equations II, VI.9): seven bodies in the plane, a driven crank, a spring, no gravity. Facts and numbers are those of the problem;
//! units are m, kg, s, N.
//!
//! From the ground four arms lead to one point, E: the crank K1 with K2 from the origin, K3 from B, K5 with K4 and K7 with K6 from A.
//! A network is two arms, so three of them are nested.
#![allow(dead_code)] // each user has its share

use catena::Error;
use catena::planar::*;

/// Where arms are held: K5 and K7 at A, K3 at B, the spring at C.
pub const A: [f64; 2] = [-0.06934, -0.00227];
pub const B: [f64; 2] = [-0.03635, 0.03273];
pub const C: [f64; 2] = [0.014, 0.072];
/// Stiffness (N/m) and free length (m) of the spring, and where it holds K3 (body axes).
const SPRING: (f64, f64) = (4530.0, 0.07785);
pub const HOOK: [f64; 2] = [0.02, -0.018];
/// Moment that drives the crank (N·m).
const DRIVE: f64 = 0.033;
/// When the run ends (s).
pub const END: f64 = 0.03;

/// β, Θ, γ, Φ, δ, Ω, ε at the start (rad).
pub const START: [f64; 7] = [
    -0.06171389001427645,
    0.0,
    0.45527981916307037,
    0.22266839016588588,
    0.48736497954384256,
    -0.22266839016588588,
    1.2305474445498212,
];
/// The same at the end: converged by a rule of order 8 with projection on the multiplier equations of the test set (300 to 2400
/// steps agree); PSIDE's values, which the test set prints, differ by up to 2.7e-10 relative.
pub const REFERENCE: [f64; 7] = [
    15.810771195153796,
    -15.75637105841195,
    0.0408222401196467,
    -0.5347301163420779,
    0.5244099658799541,
    0.5347301163420779,
    1.048080741041938,
];
/// β̈ and Θ̈ at the start (rad/s²), from the test set.
pub const FIRST: [f64; 2] = [14222.4439199541, -10666.8329399656];

type Body = RigidBody<f64>;
/// An arm of two bodies from the origin.
type Near = (Pin, Body, Pin, Body);
/// Arms from another point of the ground.
type Single = (Body, Pin, Body);
type Double = (Body, Pin, Body, Pin, Body);
/// All arms.
pub type Arms = Network<Network<Network<Near, Single, Pin>, Double, Pin>, Double, Pin>;
/// The mechanism.
pub type Squeezer = System<f64, Clamped<[f64; 2], f64>, Arms, Free>;
/// Numbers of the bodies K1, K2, K3, K5, K4, K7, K6: the others reach from the origin to A and B.
pub const BODIES: [usize; 7] = [0, 1, 3, 5, 6, 8, 9];
/// Stations of the joints that close loops, from the inmost on.
pub const CLOSING: [usize; 3] = [7, 13, 19];

/// The mechanism.
pub fn squeezer() -> Result<Squeezer, Error> {
    // Mass, moment of inertia about the mass centre, mass centre and outboard end in axes of the body.
    let crank = RigidBody::new(0.04325, 2.194e-6, [0.00092, 0.0], [0.007, 0.0]);
    let k2 = RigidBody::new(0.00365, 4.410e-7, [-0.0115, 0.0], [-0.028, 0.0]);
    let k3 = RigidBody::new(0.02373, 5.255e-6, [0.01043, -0.01874], [0.0, -0.035]);
    let k4 = RigidBody::new(0.00706, 5.667e-7, [0.0, 0.01421 - 0.02], [0.0, -0.02]);
    let k5 = RigidBody::new(0.07050, 1.169e-5, [0.02308, 0.00916], [0.04, 0.0]);
    let k6 = RigidBody::new(0.00706, 5.667e-7, [0.02 - 0.01421, 0.0], [0.02, 0.0]);
    let k7 = RigidBody::new(0.05498, 1.912e-5, [-0.00449, -0.01228], [0.0, -0.04]);
    let [to_a, to_b] = [A, B].map(RigidBody::massless);
    let driven = Network::new((Pin, crank, Pin, k2), (to_b, Pin, k3), Pin);
    let pressed = Network::new(driven, (to_a, Pin, k5, Pin, k4), Pin);
    let arms = Network::new(pressed, (to_a, Pin, k7, Pin, k6), Pin);
    System::new(Clamped::at(0.0, 0.0, 0.0), arms, Free)
}

/// Absolute angles of the bodies in the order of the scene, from the mechanism's angles.
pub fn absolute([beta, theta, gamma, phi, delta, omega, epsilon]: [f64; 7]) -> [f64; 7] {
    [beta, beta + theta, gamma, delta, phi + delta, epsilon, omega + epsilon]
}

/// The mechanism's angles from absolute ones.
pub fn relative([k1, k2, k3, k5, k4, k7, k6]: [f64; 7]) -> [f64; 7] {
    [k1, k2 - k1, k3, k4 - k5, k5, k6 - k7, k7]
}

/// The drive and the spring.
pub fn wrench(body: usize, motion: &BodyMotion<f64>) -> Wrench<f64> {
    match body {
        0 => Wrench::torque(DRIVE),
        3 => {
            let reach = motion.point(HOOK).place - nalgebra::Vector2::from(C);
            let length = reach.norm();
            let force = reach * (-SPRING.0 * (length - SPRING.1) / length);
            motion.force_at(HOOK, force.into())
        }
        _ => Wrench::default(),
    }
}
