//! Ten million steps of six scenes: energy, momentum and closure, and the law by which they drift.
//!
//! Drift is the largest deviation up to a number of steps, and its law the power of the time that fits the last two decades: 1/2 is a
//! random walk, 1 a line, 0 a bound. Rules that err more than rounding are run with half the step as well, over the same time: the
//! logarithm of what that gains is the order that the energy shows.

use crate::table::Table;
use catena::loading::Unloaded;
use catena::simulate::{Method, Stepper};
use catena::system::{Element, MotionOf, Root, Runs, Space, System, Tip};
use catena::{planar, spatial};

/// Where the largest deviations so far are noted (steps).
const MARKS: [usize; 5] = [1_000, 10_000, 100_000, 1_000_000, 10_000_000];

/// The largest deviations of energy, momentum and closure up to each mark, as shares of their sizes.
type Drift = Vec<[f64; 3]>;

/// Steps a scene and reads it some thousand times between marks, which are `stretch` times as many steps apart.
#[allow(clippy::type_complexity)] // types are those of the scene
fn drift<S, R, C, P, M>(
    scene: &System<S, R, C, P>,
    start: &MotionOf<S, R, C, P>,
    method: M,
    dt: f64,
    (most, stretch): (usize, usize),
    read: &dyn Fn(&System<S, R, C, P>, &MotionOf<S, R, C, P>) -> Result<[f64; 3], catena::Error>,
) -> Result<Drift, String>
where
    S: Space<Scalar = f64>,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
    M: for<'s> Method<&'s System<S, R, C, P>, Unloaded>,
{
    let say = |error: catena::Error| error.to_string();
    let mut stepper = method.stepper(scene);
    let start = &scene.with_accelerations(start.clone(), &Unloaded).map_err(say)?;
    let marks = MARKS.map(|mark| stretch * mark);
    let (mut now, mut next) = (start.clone(), start.clone());
    let first = read(scene, start).map_err(say)?;
    let (mut worst, mut found) = ([0.0_f64; 3], vec![]);
    for step in 1..=most {
        stepper.advance(&now, &Unloaded, dt, &mut next).map_err(|error| format!("step {step}: {error}"))?;
        core::mem::swap(&mut now, &mut next);
        if step % (step / 2000).max(1) == 0 || marks.contains(&step) {
            let values = read(scene, &now).map_err(say)?;
            for (worst, (value, first)) in worst.iter_mut().zip(values.iter().zip(&first)) {
                let off = (value - first).abs();
                *worst = if off.is_nan() || off > *worst { off } else { *worst };
            }
        }
        if marks.contains(&step) {
            found.push(worst);
        }
    }
    Ok(found)
}

/// The power of the number of steps by which the last two decades grow.
fn law(drift: &Drift, k: usize) -> f64 {
    match drift.as_slice() {
        [.., early, _, late] if early[k] > 0.0 => (late[k] / early[k]).log10() / 2.0,
        _ => f64::NAN,
    }
}

/// Rows of a scene by a rule: energy, momentum where it is kept, closure where there is one.
fn rows(table: &mut Table, name: &str, way: &str, found: Result<Drift, String>, halved: Option<Result<Drift, String>>) {
    let quantities = ["energy drift", "momentum drift", "closure"];
    for (k, axis) in quantities.into_iter().enumerate() {
        match &found {
            Err(text) if k == 0 => table.add("long", name, axis, 1e7, way, "f64", Err(text.clone())),
            Err(_) => {}
            Ok(drift) => {
                let Some(last) = drift.last() else { continue };
                if last[k] == 0.0 {
                    continue; // there is none
                }
                let steps = MARKS[drift.len().min(MARKS.len()) - 1] as f64;
                table.add("long", name, axis, steps, way, "f64", Ok(last[k]));
                let marks: Vec<String> = drift.iter().map(|at| format!("{:.0e}", at[k])).collect();
                let mut note =
                    format!("{} after 1e3 and each ten times as many; power {:.2}", marks.join(" "), law(drift, k));
                if let (0, Some(Ok(half))) = (k, &halved)
                    && let (Some(coarse), Some(fine)) = (drift.get(half.len().saturating_sub(1)), half.last())
                {
                    let order = (coarse[0] / fine[0]).log2();
                    note += &format!(
                        "; half the step a tenth as long {:.0e} for {:.0e}: order {order:.1}",
                        fine[0], coarse[0]
                    );
                }
                table.note(note);
            }
        }
    }
}

/// Runs a scene by rules of fixed steps.
macro_rules! scene {
    ($table:ident, $most:ident, $name:literal, $scene:ident, $start:ident, $read:expr, [$($way:literal: $method:expr, $dt:expr);+ $(;)?]) => {$(
        crate::progress(&format!("long, {}, {}", $name, $way));
        let found = drift(&$scene, &$start, $method, $dt, ($most, 1), &$read);
        crate::progress(&format!("long, {}, {}, half the step", $name, $way));
        let halved = drift(&$scene, &$start, $method, 0.5 * $dt, ($most / 5, 2), &$read);
        rows($table, $name, $way, found, Some(halved));
    )+};
}

fn plane(table: &mut Table, most: usize) -> Result<(), catena::Error> {
    use planar::*;
    let rod = |length: f64| Rod::uniform(length, length);
    {
        let scene = System::new(Pinned::origin(), (rod(0.5), Pin, rod(0.5)), Free)?.with_gravity(9.81);
        let start = scene.at_rest(&[-1.0, -0.5])?;
        let size = 9.81 * 0.5;
        let read = |scene: &System<f64, _, _, _>, now: &_| Ok([scene.budget(now)?.energy() / size, 0.0, 0.0]);
        scene!(table, most, "2 rods on pins", scene, start, read, [
            "RK4 of 2 ms": Rk4, 2e-3;
            "DOP853 of 10 ms": Dop853, 1e-2;
            "Adams of 1 ms": Adams, 1e-3;
            "generalised-alpha of 1 ms": GeneralizedAlpha::new(1.0), 1e-3;
        ]);
    }
    {
        let chain = (rod(0.05), [(ElasticHinge::rotary(2.0), rod(0.05)); 19]);
        let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
        let start = scene.at_rest(&[-1.0; 20])?;
        let size = 9.81 * 0.5;
        let read = |scene: &System<f64, _, _, _>, now: &_| Ok([scene.budget(now)?.energy() / size, 0.0, 0.0]);
        scene!(table, most, "20 rods on springs", scene, start, read, [
            "RK4 of 0.1 ms": Rk4, 1e-4;
            "DOP853 of 0.2 ms": Dop853, 2e-4;
            "generalised-alpha of 0.1 ms": GeneralizedAlpha::new(1.0), 1e-4;
        ]);
    }
    {
        let chain = (rod(0.5), Pin, rod(1.2), Pin, rod(0.9));
        let scene = System::new(Pinned::origin(), chain, Pinned::at(1.0, 0.0))?.with_gravity(9.81);
        let start = scene.assembled(scene.at_rest(&[1.0, 0.3, -2.0])?, &Unloaded)?;
        let size = 9.81;
        let read = |scene: &System<f64, _, _, _>, now: &_| {
            let tip = scene.stations(now, &Unloaded)?.tip().frame.place;
            Ok([scene.budget(now)?.energy() / size, 0.0, (tip.x - 1.0).hypot(tip.y)])
        };
        scene!(table, most, "four-bar", scene, start, read, [
            "RK4 of 1 ms": Rk4, 1e-3;
            "DOP853 of 4 ms": Dop853, 4e-3;
            "generalised-alpha of 1 ms": GeneralizedAlpha::new(1.0), 1e-3;
        ]);
    }
    {
        let arm = || (Pin, rod(0.5), Pin, rod(0.5));
        let chain = (rod(0.4), Network::new(arm(), arm(), Pin), Pin, rod(0.4));
        let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
        let start = scene.assembled(scene.at_rest(&[-1.0, -0.6, -1.9, -1.9, -0.6, -1.0])?, &Unloaded)?;
        let size = 9.81;
        let read = |scene: &System<f64, _, _, _>, now: &_| {
            let bodies = scene.body_motions(now)?;
            let place = |k| bodies.get(k).map_or_else(Default::default, |body: &BodyMotion<f64>| body.outboard().place);
            Ok([scene.budget(now)?.energy() / size, 0.0, (place(2) - place(4)).norm()])
        };
        scene!(table, most, "network of pins", scene, start, read, [
            "RK4 of 1 ms": Rk4, 1e-3;
            "DOP853 of 2 ms": Dop853, 2e-3;
        ]);
    }
    Ok(())
}

fn space(table: &mut Table, most: usize) -> Result<(), catena::Error> {
    use spatial::*;
    let rod = Rod::uniform(0.5, 0.05, 0.5);
    {
        let scene = System::new(Pinned::origin(), (rod, [(Ball, rod); 2]), Free)?.with_gravity([0.0, 0.0, -9.81]);
        let start = scene.at_rest(&[0.0, 0.5, 0.0, 0.0, 0.8, 0.3, 0.0, 0.2, 0.9])?;
        let start = scene.with_rates(start, &[1.0, 2.0, 0.5, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0])?;
        let size = 9.81 * 1.5;
        // The angular momentum about the vertical through the root is kept.
        let read = |scene: &System<f64, _, _, _>, now: &_| {
            let budget = scene.budget(now)?;
            Ok([budget.energy() / size, budget.angular_momentum.z, 0.0])
        };
        scene!(table, most, "3 rods on balls", scene, start, read, [
            "RK4 of 1 ms": Rk4, 1e-3;
            "DOP853 of 4 ms": Dop853, 4e-3;
        ]);
    }
    {
        let scene = System::new(Free, (rod, [(Ball, rod); 3]), Free)?;
        let mut start = scene.motion();
        let rates: Vec<f64> =
            (0..start.rate_count()).map(|k| if k < 3 { 0.0 } else { (1.7 * k as f64).sin() }).collect();
        start.set_rates(&rates)?;
        let start = scene.with_accelerations(start, &Unloaded)?;
        let read = |scene: &System<f64, _, _, _>, now: &_| {
            let budget = scene.budget(now)?;
            Ok([budget.energy(), budget.angular_momentum.norm() + budget.momentum.norm(), 0.0])
        };
        scene!(table, most, "4 floating rods", scene, start, read, [
            "RK4 of 2 ms": Rk4, 2e-3;
            "DOP853 of 10 ms": Dop853, 1e-2;
        ]);
    }
    Ok(())
}

pub fn run(table: &mut Table, quick: bool) {
    let most = if quick { 10_000 } else { 10_000_000 };
    for outcome in [plane(table, most), space(table, most)] {
        if let Err(error) = outcome {
            table.add("long", "a scene", "start", 0.0, "none", "f64", Err(error.to_string()));
        }
    }
}
