//! A double pendulum behind a C interface: no std, no allocator, no operating system.
#![no_std]

use catena::Error;
use catena::planar::*;
use catena::simulate::Stepper;
use core::panic::PanicInfo;

/// Angles (rad) of two uniform rods (1 m, 1 kg) after `steps` steps of size `dt` (s), released at rest at `angle` (rad).
/// Zero if all went well.
///
/// # Safety
/// `angles` points to two numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn double_pendulum(angle: f64, dt: f64, steps: u32, angles: *mut [f64; 2]) -> i32 {
    match swing(angle, dt, steps) {
        Ok(found) => {
            // SAFETY: the caller's promise.
            unsafe { angles.write(found) };
            0
        }
        Err(_) => -1,
    }
}

fn swing(angle: f64, dt: f64, steps: u32) -> Result<[f64; 2], Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let mut past = pendulum.at_rest(&[angle; 2])?;
    let mut next = past.clone();
    let mut stepper = pendulum.stepper(Rk4);
    for _ in 0..steps {
        stepper.step(&past, &Loads::none(), dt, &mut next)?;
        core::mem::swap(&mut past, &mut next);
    }
    let (first, ((), second, ())) = *past.position();
    Ok([first, second])
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {}
}
