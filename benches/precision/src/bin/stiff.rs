//! What is stiff: 20 rods on springs of 20 N·m/rad, the same on springs of 2000, both released straight at −60°, and a slender rod of 40
//! segments that is clamped and falls under its weight. Errors are those of the last angle.
//!
//! References: two rules of this library, whose difference is printed.

use catena::Real;
use catena::planar::{Beam, Clamped, ElasticHinge, Free, Pinned, Rod, System, Unloaded};
use catena_precision::{Scene, is_wanted, reference, run_rules};
use std::error::Error;

/// Twenty rods on springs, over a number.
macro_rules! springs {
    ($T:ident, $stiffness:expr) => {{
        let rod = Rod::uniform(0.05 as $T, 0.05);
        let link = (ElasticHinge::rotary($stiffness as $T), rod);
        let system = System::new(Pinned::origin(), (rod, [link; 19]), Free)?.with_gravity(9.81 as $T);
        let start = system.at_rest(&[-std::f64::consts::FRAC_PI_3 as $T; 20])?;
        (system, start)
    }};
}

/// A clamped rod, 1 m and 1 kg, E I = 1 N·m², over a number.
macro_rules! slender {
    ($T:ident) => {{
        let rod = Beam::new(1.0 as $T, 1.0, 1.0).segments::<40>();
        let system = System::new(Clamped::at(0.0 as $T, 0.0, 0.0), rod, Free)?.with_gravity(1.0 as $T);
        let start = system.motion();
        (system, start)
    }};
}

macro_rules! both {
    ($name:literal, $bodies:literal, $end:literal, $make:ident($($more:expr)?), $unit:expr) => {
        if is_wanted($name) {
            let (system, start) = $make!(f64 $(, $more)?);
            let reference = reference!($name, $end, (system, start, Unloaded), |system, motion| {
                system.angles(motion).ok()?.iter().last().copied()
            });
            let mut scene = Scene::new($name, $bodies, $end, reference, "rad");
            run_rules!(scene, f64, $unit, 1e-13, (system, start, Unloaded), |system, motion| {
                system.angles(motion).ok()?.iter().last().copied()
            }, taylor);
            let (system, start) = $make!(f32 $(, $more)?);
            run_rules!(scene, f32, $unit, 1e-7, (system, start, Unloaded), |system, motion| {
                system.angles(motion).ok()?.iter().last().map(|angle| angle.as_f64())
            }, taylor);
            scene.finish()?;
        }
    };
}

fn main() -> Result<(), Box<dyn Error>> {
    both!("20 rods on springs", 20, 0.5, springs(20.0), 0.01);
    both!("stiff pendulum", 20, 0.5, springs(2000.0), 0.01);
    both!("slender rod", 41, 0.25, slender(), 0.01);
    Ok(())
}
