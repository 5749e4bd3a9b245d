//! One step of an arm of seven joints by the classical Runge-Kutta rule: what a microcontroller would run in its cycle.
//!
//! A program without an operating system: whoever knows the board gives it a memory layout, and reads angles where this one lets the
//! optimiser believe that somebody does.
#![no_std]
#![no_main]

use catena::Error;
use catena::robot::{Base, Free, Hinge, Link, Rotation, System, Turned};
use core::hint::black_box;
use core::panic::PanicInfo;

include!(concat!(env!("OUT_DIR"), "/arm7.rs"));

type Joints = [f32; 7];
type Joint = Hinge<f32, Turned<f32>, 0b111>;
/// Elements of equal types in an array: one piece of code for all of them.
type Arm = System<f32, Base<f32>, [(Joint, Link<f32>); 7], Free>;

fn arm() -> Result<Arm, Error> {
    let (first, body, a, b, c, d, e, f, g, h, i, j, k, l) = arm7::chain::<f32>();
    // The first joint turns about the vertical, and is one of the others here.
    let first = Hinge::at::<0b111>(first.place()).turned(Turned::by(Rotation::identity()));
    let chain = [(first, body), (a, b), (c, d), (e, f), (g, h), (i, j), (k, l)];
    Ok(System::new(Base::origin(), chain, Free)?.with_gravity([0.0, 0.0, -9.81]))
}

/// a + h b.
fn moved(a: &Joints, h: f32, b: &Joints) -> Joints {
    core::array::from_fn(|k| a[k] + h * b[k])
}

/// One step (s) of positions and rates under torques (N·m).
#[inline(never)]
fn step(arm: &Arm, [q, v]: [Joints; 2], torques: &Joints, h: f32) -> Result<[Joints; 2], Error> {
    let mut sum = [[0.0; 7]; 2];
    let (mut speed, mut second) = (v, arm.forward_dynamics(&q, &v, torques)?);
    for (way, weight) in [(0.5, 1.0), (0.5, 2.0), (1.0, 2.0), (0.0, 1.0)] {
        sum = [moved(&sum[0], weight, &speed), moved(&sum[1], weight, &second)];
        if way > 0.0 {
            let place = moved(&q, way * h, &speed);
            speed = moved(&v, way * h, &second);
            second = arm.forward_dynamics(&place, &speed, torques)?;
        }
    }
    Ok([moved(&q, h / 6.0, &sum[0]), moved(&v, h / 6.0, &sum[1])])
}

/// Where the board begins.
#[unsafe(no_mangle)]
pub extern "C" fn _start() -> ! {
    if let Ok(arm) = arm() {
        let mut state = black_box([[0.1; 7], [0.0; 7]]);
        while let Ok(next) = step(&arm, state, &black_box([0.0; 7]), 1e-3) {
            state = black_box(next);
        }
    }
    loop {}
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {}
}
