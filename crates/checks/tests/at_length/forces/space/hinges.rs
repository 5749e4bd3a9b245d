//! Elastic hinges, each part alone and all together, in chains with other joints, on ground that moves and with tips held.

use super::twins::{TOLERANCE, body, difference, vector};
use catena::Error;
use catena::spatial::*;
use catena_oracle::Noise;
use catena_oracle::space as oracle;
use catena_oracle::space::Vector;
use catena_oracle::space::elastic::Law;

/// Coordinates of a hinge, with and without linear ones.
trait Coordinates {
    fn of(place: Vector, turned: Rotation<f64>) -> Self;
}
impl Coordinates for Rotation<f64> {
    fn of(_: Vector, turned: Rotation<f64>) -> Self {
        turned
    }
}
impl Coordinates for ([f64; 3], Rotation<f64>) {
    fn of(place: Vector, turned: Rotation<f64>) -> Self {
        (place.into(), turned)
    }
}

trait Rates {
    fn of(place: Vector, spin: Vector) -> Self;
}
impl Rates for [f64; 3] {
    fn of(_: Vector, spin: Vector) -> Self {
        spin.into()
    }
}
impl Rates for ([f64; 3], [f64; 3]) {
    fn of(place: Vector, spin: Vector) -> Self {
        (place.into(), spin.into())
    }
}

/// All of a spring's numbers.
type All = Spring<f64, f64, f64>;

fn spring([k, c, rest]: [f64; 3]) -> All {
    Spring::stiffness(k).damped(c).resting_at(rest)
}

/// Whether the points of a hinge may part.
fn parted(on: bool, v: Vector) -> Vector {
    if on { v } else { Vector::zeros() }
}

#[test]
fn every_part_of_a_hinge_alone_and_together() -> Result<(), Error> {
    let mut worst = [0.0_f64; 11];
    for seed in 0..8 {
        let mut noise = Noise::new(seed);
        let pairs: [_; 4] = core::array::from_fn(|_| body(&mut noise));
        let [b0, b1, b2, b3] = pairs.map(|pair| pair.0);
        let twins = pairs.map(|pair| pair.1);
        let gravity = Vector::new(0.3, -9.81, 0.7);
        let (velocity, linear, turning, angular) =
            (vector(&mut noise), vector(&mut noise), vector(&mut noise), vector(&mut noise));
        let tilted = [noise.next(), noise.next(), noise.next()];
        let still = oracle::Frame::still();
        let ground =
            oracle::Frame { velocity, linear, attitude: oracle::angles(tilted), spin: turning, angular, ..still };
        let moving = Moving(move |_: f64| GroundMotion {
            place: [0.0; 3],
            velocity: velocity.into(),
            acceleration: linear.into(),
        });
        let attitude = Turning(move |_: f64| AttitudeMotion {
            attitude: Rotation::from_angles(tilted),
            spin: turning.into(),
            acceleration: angular.into(),
        });
        let clamp = Clamped { place: moving, attitude };
        let weld = oracle::Joint::Weld { attitude: oracle::Matrix::identity() };
        let efforts: [[f64; 3]; 4] = core::array::from_fn(|_| core::array::from_fn(|_| noise.next()));
        let loads = Loads::none().efforts(efforts.map(Effort));
        // Bent far: up to two radians.
        let states: [_; 2] = core::array::from_fn(|_| {
            let turned = vector(&mut noise) * 1.2;
            (vector(&mut noise) * 0.3, vector(&mut noise), turned, vector(&mut noise) * 2.0)
        });
        let (q, v): ([f64; 2], [f64; 2]) = ([noise.next(), noise.next()], [noise.next(), noise.next()]);
        let k: [f64; 3] = core::array::from_fn(|_| noise.between(2.0, 9.0));
        let c: [f64; 3] = core::array::from_fn(|_| noise.between(0.1, 0.5));
        let rest: [f64; 3] = core::array::from_fn(|_| noise.next());
        let along: [[f64; 3]; 3] =
            core::array::from_fn(|_| [noise.between(20.0, 90.0), noise.between(0.5, 2.0), 0.2 * noise.next()]);
        let [x, y, z] = along;
        let cardan = Universal::about([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]).with(Spring::stiffness(3.0), Spring::none());
        let universal = oracle::Joint::Universal {
            axes: [Vector::y(), Vector::z()],
            angles: q,
            rates: v,
            torques: [efforts[2][0] - 3.0 * q[0], efforts[2][1]],
        };
        let none = Law::default();

        macro_rules! case {
            ($case:literal, $hinge:expr, $parts:literal, $law:expr) => {{
                let (hinge, law) = ($hinge, Law { together: !$parts, ..$law });
                let joint = |k: usize, effort: [f64; 3]| {
                    let (place, rate, turned, spin) = states[k];
                    law.joint(parted($parts, place), parted($parts, rate), turned, spin, effort.into())
                };
                let elastic = [joint(0, efforts[1]), joint(1, efforts[3])];
                let joints = [weld, elastic[0], universal, elastic[1]];
                macro_rules! compare {
                    ($tip:expr, $twin:expr) => {{
                        let chain = (b0, hinge, (b1, cardan, b2), hinge, b3);
                        let system = System::new(clamp, chain, $tip)?.with_gravity_vector(gravity);
                        let mut motion = system.motion();
                        let (_, position) = motion.position_mut();
                        let turned = |k: usize| Rotation::exp(states[k].2.into());
                        position.1 = Coordinates::of(states[0].0, turned(0));
                        position.3 = Coordinates::of(states[1].0, turned(1));
                        position.2.1 = q;
                        let (_, rate) = motion.rate_mut();
                        rate.1 = Rates::of(states[0].1, states[0].3);
                        rate.3 = Rates::of(states[1].1, states[1].3);
                        rate.2.1 = v;
                        let motion = system.with_accelerations(motion, &loads)?;
                        let answer = oracle::solve(ground, gravity, &twins, &joints, $twin);
                        worst[$case] = worst[$case].max(difference(&system, &motion, &loads, &answer));
                        // What the springs store.
                        let stored: f64 = system.budget(&motion).unwrap().potential + {
                            let mut weight = 0.0;
                            for (body, twin) in system.body_motions(&motion).unwrap().iter().zip(&twins) {
                                weight += twin.mass * gravity.dot(&body.centre().place);
                            }
                            weight
                        };
                        let place = |k: usize| parted($parts, states[k].0);
                        let expected =
                            law.energy(place(0), states[0].2) + law.energy(place(1), states[1].2) + 1.5 * q[0] * q[0];
                        assert!((stored - expected).abs() < 1e-11 * (1.0 + expected), "{stored} J, not {expected}");
                    }};
                }
                compare!(Free, oracle::Tip::Free);
                compare!(Pinned::on(moving), oracle::Tip::Pinned(linear));
                compare!(clamp, oracle::Tip::Clamped(linear, angular));
            }};
        }
        let rotary = ElasticHinge::rotary(k);
        case!(0, rotary, false, Law { rotary: k, ..none });
        case!(1, rotary.damped(c[0]), false, Law { rotary: k, damping: [c[0]; 3], ..none });
        case!(2, rotary.damped_about(c), false, Law { rotary: k, damping: c, ..none });
        case!(3, rotary.resting_at(rest), false, Law { rotary: k, rest, ..none });
        case!(4, ElasticHinge::rotary([0.0; 3]), false, none);
        let free = Spring::none();
        case!(5, ElasticHinge::linear(spring(x), free, free), true, Law { linear: [x, [0.0; 3], [0.0; 3]], ..none });
        case!(6, ElasticHinge::linear(free, spring(y), free), true, Law { linear: [[0.0; 3], y, [0.0; 3]], ..none });
        case!(7, ElasticHinge::linear(free, free, spring(z)), true, Law { linear: [[0.0; 3], [0.0; 3], z], ..none });
        case!(8, ElasticHinge::linear(free, free, free), true, none);
        let both = rotary.with_linear(Spring::stiffness(x[0]), Spring::damping(y[1]), free);
        let law = Law { rotary: k, linear: [[x[0], 0.0, 0.0], [0.0, y[1], 0.0], [0.0; 3]], ..none };
        case!(9, both, true, law);
        let all = rotary.with_linear(spring(x), spring(y), spring(z)).damped_about(c).resting_at(rest);
        case!(10, all, true, Law { rotary: k, damping: c, rest, linear: along, together: false });
    }
    println!("largest relative differences {worst:?}");
    assert!(worst.iter().all(|worst| *worst < TOLERANCE), "{worst:?}");
    Ok(())
}
