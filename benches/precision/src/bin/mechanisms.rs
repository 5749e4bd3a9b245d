//! A heavy top (x of its mass centre), a four-bar linkage (angle of the rocker), Andrews' squeezing mechanism (angle of the crank) and an arm
//! of seven joints under torques (its last angle).
//!
//! References: of Andrews' mechanism that of the literature, of the others two rules of this library, whose difference is printed.

#[path = "../../../../examples/common/squeezer.rs"]
mod squeezer;

use catena::{Real, planar, spatial};
use catena_precision::{Scene, is_wanted, reference, run_rules};
use std::error::Error;

/// The top of O. Brüls, A. Cardona and M. Arnold, over a number.
macro_rules! top {
    ($T:ident) => {{
        use spatial::*;
        let tensor = [[0.234375 as $T, 0.0, 0.0], [0.0, 0.46875, 0.0], [0.0, 0.0, 0.234375]];
        let body = RigidBody::new(15.0, tensor, [0.0, 1.0, 0.0], [0.0, 1.0, 0.0]);
        let system = System::new(Pinned::origin(), body, Free)?.with_gravity([0.0, 0.0, -9.81 as $T]);
        let start = system.with_rates(system.motion(), &[0.0, 150.0, -4.61538])?;
        (system, start, Unloaded)
    }};
}

/// Crank 0.5 m, coupler 1.2 m, rocker 0.9 m between pins 1 m apart, released at 60°, over a number.
macro_rules! bars {
    ($T:ident) => {{
        use planar::*;
        let rod = |length: $T| Rod::uniform(length, length);
        let chain = (rod(0.5), Pin, rod(1.2), Pin, rod(0.9));
        let system = System::new(Pinned::origin(), chain, Pinned::at(1.0 as $T, 0.0))?.with_gravity(9.81 as $T);
        let start = system.assembled(system.at_rest(&[std::f64::consts::FRAC_PI_3 as $T, 0.3, -2.0])?, &Unloaded)?;
        (system, start, Unloaded)
    }};
}

/// Seven joints about axes in turn, links of 0.3 m and falling masses, under torques, over a number.
macro_rules! arm {
    ($T:ident) => {{
        use spatial::*;
        let link = |k: usize| Rod::uniform(0.3 as $T, 0.05, 3.0 / (k as $T + 1.0));
        let (up, aside) = (Revolute::about([0.0 as $T, 0.0, 1.0]), Revolute::about([0.0 as $T, 1.0, 0.0]));
        let first = (up, link(0), aside, link(1), up, link(2), aside, link(3));
        let chain = (first, (up, link(4), aside, link(5), up, link(6)));
        let system = System::new(Clamped::origin(), chain, Free)?.with_gravity([0.0, 0.0, -9.81 as $T]);
        let start = system.at_rest(&[0.3 as $T, -0.5, 0.8, 1.0, -0.4, 0.6, 0.2])?;
        let torques = [0.0 as $T, 2.0, -15.0, 1.0, -6.0, 0.5, -1.0, 0.1];
        let along = |torque: $T| Effort([torque, 0.0, 0.0]);
        (system, start, Loads::none().torques(torques.map(along)))
    }};
}

macro_rules! both {
    ($name:literal, $bodies:literal, $end:literal, $make:ident, $unit:expr, $whose:literal, |$own:ident, $motion:ident| $read:expr $(, $taylor:ident)?) => {
        if is_wanted($name) {
            let (system, start, loads) = $make!(f64);
            let reference = reference!($name, $end, (system, start, loads), |$own, $motion| $read);
            let mut scene = Scene::new($name, $bodies, $end, reference, $whose);
            run_rules!(scene, f64, $unit, 1e-13, (system, start, loads), |$own, $motion| $read $(, $taylor)?);
            let (system, start, loads) = $make!(f32);
            run_rules!(scene, f32, $unit, 1e-7, (system, start, loads), |$own, $motion| $read $(, $taylor)?);
            scene.finish()?;
        }
    };
}

fn main() -> Result<(), Box<dyn Error>> {
    both!(
        "heavy top",
        1,
        1.0,
        top,
        0.002,
        "m",
        |system, motion| { system.body_motions(motion).ok()?.get(0).map(|body| body.centre().place.x.as_f64()) },
        taylor
    );
    both!(
        "four-bar",
        3,
        2.0,
        bars,
        0.02,
        "rad",
        |system, motion| { system.angles(motion).ok()?.get(2).map(|angle| angle.as_f64()) },
        taylor
    );
    both!("arm of seven joints", 7, 1.0, arm, 0.01, "rad", |system, motion| {
        let joint = system.joint(7).ok()?;
        motion.coordinates_of::<1>(joint).ok().map(|[angle]| angle.as_f64())
    });
    if is_wanted("Andrews") {
        use planar::{BodyMotion, Loads};
        use squeezer::{END, REFERENCE, START, absolute, wrench};
        let system = squeezer::squeezer()?;
        let loads = Loads::none().on_bodies(|_, k, body: &BodyMotion<f64>| wrench(k, body));
        let start = system.assembled(system.at_rest(&absolute(START))?, &loads)?;
        let mut scene = Scene::new("Andrews", 7, END, REFERENCE[0], "rad");
        run_rules!(scene, f64, 2e-4, 1e-13, (system, start, loads), |system, motion| {
            system.angles(motion).ok()?.get(0).copied()
        });
        scene.finish()?;
    }
    Ok(())
}
