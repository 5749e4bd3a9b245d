//! Edges of the front door, the same both ways: outputs left at each step, no steps, torques that fit nothing, accelerations, times.

use catena::planar::*;
use catena::sensitivity::{Derivatives, Plan, Way};
use catena::{Error, Fault};

/// What the output reads.
#[derive(Clone, Copy, PartialEq)]
enum Read {
    /// The second angle, assigned whatever the step.
    Angle,
    /// That, from one second on.
    Late,
    /// An acceleration.
    Acceleration,
}

/// Two rods by their first angles and torques: forward and backward.
fn both(steps: usize, torques: usize, read: Read, x: &[f64]) -> [Result<Derivatives, Error>; 2] {
    let plan = Plan { method: Rk4, step: 0.1, steps, torques, outputs: 1 };
    let run = catena::differentiable!(
        Number,
        plan,
        |x| {
            let rod = Rod::uniform(Number::literal(1.0), Number::literal(1.0));
            let arm = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(Number::literal(9.81));
            let start = arm.at_rest(&x[..2])?;
            (arm, start)
        },
        |_, _, now, y| match read {
            Read::Angle => y[0] = now.coordinates()[1],
            Read::Late if now.time() >= 1.0 => y[0] = now.coordinates()[1],
            Read::Late => {}
            Read::Acceleration => y[0] = now.acceleration().0,
        }
    );
    [Way::Forward, Way::Backward].map(|way| run.jacobian_by(x, way))
}

/// Both ways agree; gives one of them.
fn agreed(steps: usize, torques: usize, read: Read, x: &[f64]) -> Derivatives {
    let [forward, backward] = both(steps, torques, read, x).map(Result::unwrap);
    let numbers = |of: &Derivatives| [&of.values[..], &of.rows[0][..]].concat();
    let (a, b) = (numbers(&forward), numbers(&backward));
    assert!(a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-11), "{a:?} not {b:?}");
    backward
}

/// Second angles after steps of a plain run.
fn angles(steps: usize) -> Vec<f64> {
    let rod = Rod::uniform(1.0, 1.0);
    let arm = System::new(Pinned::origin(), (rod, Pin, rod), Free).unwrap().with_gravity(9.81);
    let (mut now, mut stepper) = (arm.at_rest(&[-1.0, -0.5]).unwrap(), arm.stepper(Rk4));
    let mut list = vec![now.coordinates()[1]];
    for _ in 0..steps {
        let past = now;
        stepper.step(&past, &Unloaded, 0.1, &mut now).unwrap();
        list.push(now.coordinates()[1]);
    }
    list
}

#[test]
fn outputs_are_sums_of_what_is_left_at_each_step() {
    let found = agreed(3, 0, Read::Angle, &[-1.0, -0.5]);
    let sum: f64 = angles(3).iter().sum();
    assert!((found.values[0] - sum).abs() < 1e-12, "{} not {sum}", found.values[0]);
}

#[test]
fn times_are_the_same_both_ways() {
    let found = agreed(10, 0, Read::Late, &[-1.0, -0.5]);
    assert!((found.values[0] - angles(10)[10]).abs() < 1e-12);
}

#[test]
fn no_steps_know_no_torques() {
    for torques in [0, 2] {
        let found = agreed(0, torques, Read::Angle, &[-1.0, -0.5, 0.3, 0.4][..2 + torques]);
        assert_eq!(found.rows[0], [0.0, 1.0, 0.0, 0.0][..2 + torques]);
    }
}

#[test]
fn torques_fit_a_step_or_all() {
    for (torques, count) in [(5, (6, 5)), (1, (6, 1)), (9, (9, 7))] {
        for found in both(3, torques, Read::Angle, &[0.1; 7]) {
            let fault = found.unwrap_err().fault;
            assert!(matches!(fault, Fault::Count { expected, given, .. } if (expected, given) == count), "{fault:?}");
        }
    }
    assert!(both(3, 2, Read::Angle, &[0.1; 4]).iter().all(Result::is_ok));
}

#[test]
fn accelerations_are_no_outputs() {
    for found in both(2, 0, Read::Acceleration, &[-1.0, -0.5]) {
        assert!(matches!(found.unwrap_err().fault, Fault::NotFinite { .. }));
    }
}

#[test]
fn scenes_without_coordinates_have_values() {
    let plan = Plan { method: Rk4, step: 0.1, steps: 2, torques: 0, outputs: 1 };
    let run = catena::differentiable!(
        Number,
        plan,
        |x| {
            let zero = Number::literal(0.0);
            let beam = System::new(Clamped::at(zero, zero, zero), Rod::uniform(x[0], x[0]), Free)?;
            let start = beam.motion();
            (beam, start)
        },
        |step, beam, now, y| if step == 2 {
            y[0] = beam.stations(now, &Unloaded).unwrap().tip().frame.place.x;
        }
    );
    for way in [Way::Forward, Way::Backward] {
        let found = run.jacobian_by(&[0.7], way).unwrap();
        assert!((found.values[0] - 0.7).abs() < 1e-15 && (found.rows[0][0] - 1.0).abs() < 1e-15, "{found:?}");
    }
}

#[test]
fn what_goes_forward_alone() {
    // A block that slides to a stop, by steps that change its mode; nothing goes back through such a rule.
    let plan = Plan { method: MoreauJean, step: 1e-3, steps: 1000, torques: 0, outputs: 2 };
    let slides = catena::differentiable!(
        forward Number,
        plan,
        |x| {
            let [zero, one] = [0.0, 1.0].map(Number::literal);
            let track = Coulomb::new(Slider::along(zero), x[1]);
            let block = System::new(Clamped::origin(), (track, RigidBody::new(x[2], one, [zero; 2], [zero; 2])), Free)?;
            let start = block.with_rates(block.motion(), &x[..1])?;
            (block, start)
        },
        |step, _, now, y| if step == 1000 {
            y.copy_from_slice(&[now.coordinates(), now.rates()].concat());
        }
    );
    let [speed, friction, mass] = [1.5, 6.0, 2.0];
    let found = slides.jacobian(&[speed, friction, mass]).unwrap();
    let way = 0.5 * mass * speed * speed / friction;
    for (found, expected) in found.rows[0].iter().zip([2.0 * way / speed, -way / friction, way / mass]) {
        assert!((found - expected).abs() < 2e-3, "{found} {expected}");
    }
    assert_eq!((found.way, &found.rows[1]), (Way::Forward, &vec![0.0; 3]));
    let fault = slides.jacobian_by(&[speed, friction, mass], Way::Backward).unwrap_err().fault;
    assert!(matches!(fault, Fault::Unsupported { what } if what.contains("forward")), "{fault}");
    // However few the outputs, and many the inputs.
    let many: Vec<f64> = [speed, friction, mass].into_iter().chain([0.0; 60]).collect();
    assert_eq!(slides.gradient(&many).unwrap().1.way, Way::Forward);
}

#[test]
fn modes_that_steps_do_not_change_are_refused() {
    let plan = Plan { method: Rk4, step: 0.1, steps: 2, torques: 0, outputs: 1 };
    let falls = catena::differentiable!(
        Number,
        plan,
        |x| {
            let [zero, one, up] = [0.0, 1.0, 1.5].map(Number::literal);
            let fall = HardStops::between(Slider::along(up), [zero, one + one]);
            let scene = System::new(Clamped::origin(), (fall, RigidBody::new(x[0], one, [zero; 2], [zero; 2])), Free)?;
            let start = scene.with_rates(scene.motion(), &[one])?;
            (scene, start)
        },
        |_, _, now, y| y[0] = now.coordinates()[0]
    );
    for way in [Way::Forward, Way::Backward] {
        let fault = falls.jacobian_by(&[1.0], way).unwrap_err().fault;
        assert!(matches!(fault, Fault::Unsupported { what } if what.contains("course")), "{fault}");
    }
}

#[test]
fn steps_that_do_not_go_on_are_refused_both_ways() {
    for step in [0.0, -0.01, f64::NAN] {
        let plan = Plan { method: Rk4, step, steps: 10, torques: 0, outputs: 1 };
        let swing = catena::differentiable!(
            Number,
            plan,
            |x| {
                let scene = System::new(Pinned::origin(), Rod::uniform(x[0], Number::literal(1.0)), Free)?;
                let start = scene.with_rates(scene.motion(), &[Number::literal(1.0)])?;
                (scene, start)
            },
            |_, _, now, y| y[0] = now.coordinates()[0]
        );
        for way in [Way::Forward, Way::Backward] {
            let fault = swing.jacobian_by(&[1.0], way).unwrap_err().fault;
            assert!(matches!(fault, Fault::NotPositive { .. }), "{step}: {fault}");
        }
    }
}
