//! Lanes that share their steps: each is as exact as its own size asks, whatever sizes the others have.

use catena::Error;
use catena::planar::*;
use catena::scalar::{Scalar, WideF64x4};
use catena_oracle::near;

const TOLERANCE: f64 = 1e-9;
const TIME: f64 = 3.0;

/// A mass on a slider, drawn by a spring whose end stands still in one lane and moves at a thousand kilometres a second in the next: about that
/// end it swings by a metre.
macro_rules! errors {
    ($rule:expr) => {{
        let number = WideF64x4::literal;
        let speed = WideF64x4::from([0.0, 1e6, 0.0, 1e6]);
        let body = RigidBody::new(number(1.0), number(0.1), [number(0.0); 2], [number(0.0); 2]);
        let scene = System::new(Clamped::origin(), (Slider::along(number(0.0)), body), Free)?;
        let loads = Loads::none().in_joints(|time, joint, motion: &JointMotion<WideF64x4>| {
            if joint == 1 { (speed * number(time) - motion.slide[0]) * number(4.0) } else { number(0.0) }
        });
        let mut start = scene.motion();
        start.set_coordinates(&[number(1.0)])?;
        let start = scene.with_rates(start, &[speed])?;
        let run = scene.simulation($rule).loads(&loads).run(start, TIME, |_| ())?;
        let errors = (run.motion.coordinates()[0] - speed * number(TIME)).into_arr().map(|x| x - (2.0 * TIME).cos());
        println!("{} steps, errors {errors:?}", run.steps);
        errors
    }};
}

#[test]
fn a_lane_is_as_exact_as_its_own_size_asks() -> Result<(), Error> {
    let all = [
        errors!(Dop853::tolerance(TOLERANCE)),
        errors!(Vcabm::new().tolerance(TOLERANCE)),
        errors!(Sdirk4::new().tolerance(TOLERANCE)),
    ];
    for [small, large, ..] in all {
        near(small, 0.0, 100.0 * TOLERANCE); // of some twenty to a thousand steps
        near(large, 0.0, 100.0 * TOLERANCE * 1e6);
    }
    Ok(())
}
