//! A double pendulum behind a few exported functions, for `docs/live.html`: a hand pulls its tip by a spring, and a gradient says which way
//! to pull for the tip to be higher a quarter of a second later.

use catena::Error;
use catena::planar::*;
use catena::scalar::{Jet, Scalar};
use catena::simulate::Stepper;
use std::cell::Cell;

/// Size of a step (s), and how far ahead the gradient looks (steps).
const STEP: f64 = 1.0 / 480.0;
const AHEAD: u32 = 120;

/// What the page sets, in the order of its numbers: lengths (m), masses (kg), gravity (m/s²), friction in the pins (N·m·s), how
/// strongly the hand pulls (N/m), and where it is (m).
type Settings = [f64; 9];
/// What the page draws: places of the joint and the tip (m), energy (J), gradient of the tip's height by force (m/N).
type Drawn = [f64; 7];

thread_local! {
    static SETTINGS: Cell<Settings> = const { Cell::new([1.0, 1.0, 1.0, 1.0, 9.81, 0.1, 0.0, 0.0, 0.0]) };
    /// Angles (rad) and rates (rad/s) of both rods.
    static STATE: Cell<[f64; 4]> = const { Cell::new([-0.6, 0.4, 0.0, 0.0]) };
    static DRAWN: Cell<Drawn> = const { Cell::new([0.0; 7]) };
}

/// What is left after some steps, under a force (N) held at the tip besides the hand: angles, rates, and what is drawn of them.
fn moved<T: Scalar<Real = f64>>(
    settings: Settings,
    state: [f64; 4],
    force: [T; 2],
    steps: u32,
) -> Result<([T; 4], [T; 5]), Error> {
    let number = T::literal;
    let [inner, outer, lighter, other, gravity, friction, pull, x, y] = settings.map(number);
    let rods = (Rod::uniform(inner, lighter), Pin, Rod::uniform(outer, other));
    let scene = System::new(Pinned::origin(), rods, Free)?.with_gravity(gravity);
    let end = [outer, number(0.0)];
    let loads = Loads::none().in_joints(|_: f64, _, joint: &JointMotion<T>| -friction * joint.rate()).on_bodies(
        |_: f64, body, rod: &BodyMotion<T>| {
            let tip = rod.point(end);
            let held = number(if body == 1 { 1.0 } else { 0.0 });
            let along = |hand: T, place: T, velocity: T, more: T| {
                held * (pull * (hand - place) - pull * number(0.05) * velocity + more)
            };
            let (place, velocity) = (tip.place, tip.velocity);
            rod.force_at(end, [along(x, place.x, velocity.x, force[0]), along(y, place.y, velocity.y, force[1])])
        },
    );
    let mut now = scene.at_rest(&[number(state[0]), number(state[1])])?;
    now = scene.with_rates(now, &[number(state[2]), number(state[3])])?;
    let mut next = now;
    let mut stepper = scene.stepper(Rk4);
    for _ in 0..steps {
        stepper.step(&now, &loads, STEP, &mut next)?;
        core::mem::swap(&mut now, &mut next);
    }
    let (first, ((), second, ())) = *now.position();
    let (spin, ((), other_spin, ())) = *now.rate();
    let arm = |length: T, angle: T| {
        let (sine, cosine) = angle.sin_cos();
        [length * cosine, length * sine]
    };
    let (joint, reach) = (arm(inner, first), arm(outer, second));
    let tip = [joint[0] + reach[0], joint[1] + reach[1]];
    let energy = scene.budget(&now)?.energy();
    Ok(([first, second, spin, other_spin], [joint[0], joint[1], tip[0], tip[1], energy]))
}

/// Makes steps of 1/480 s; whether all went well.
#[unsafe(no_mangle)]
pub extern "C" fn advance(steps: u32) -> bool {
    let settings = SETTINGS.get();
    let go = || -> Result<(), Error> {
        let (state, [a, b, c, d, energy]) = moved(settings, STATE.get(), [0.0; 2], steps.min(480))?;
        let seeds = [Jet::<f64, 2>::seed(0.0, 0), Jet::seed(0.0, 1)];
        let (_, [.., height, _]) = moved(settings, state, seeds, AHEAD)?;
        STATE.set(state);
        DRAWN.set([a, b, c, d, energy, height.eps[0], height.eps[1]]);
        Ok(())
    };
    go().is_ok()
}

/// Sets a number of the page; whether there is such a number, and it is one.
#[unsafe(no_mangle)]
pub extern "C" fn set(which: usize, value: f64) -> bool {
    let mut settings = SETTINGS.get();
    let Some(place) = settings.get_mut(which).filter(|_| value.is_finite()) else { return false };
    *place = value;
    SETTINGS.set(settings);
    true
}

/// Lets both rods go from rest at angles from +x (rad).
#[unsafe(no_mangle)]
pub extern "C" fn start(inner: f64, outer: f64) {
    STATE.set([inner, outer, 0.0, 0.0]);
}

/// A number to be drawn; zero where there is none.
#[unsafe(no_mangle)]
pub extern "C" fn drawn(which: usize) -> f64 {
    DRAWN.get().get(which).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The height of the tip ahead, under a force (N) at the tip.
    fn height(force: [f64; 2]) -> Result<f64, Error> {
        let (_, [.., height, _]) = moved(SETTINGS.get(), STATE.get(), force, AHEAD)?;
        Ok(height)
    }

    #[test]
    fn the_arrow_is_the_slope_of_differences() -> Result<(), Error> {
        assert!(set(6, 60.0) && set(7, 1.2) && set(8, 0.5) && !set(9, 0.0) && !set(0, f64::NAN));
        assert!(advance(100));
        let h = 1e-4;
        for (k, [x, y]) in [[h, 0.0], [0.0, h]].into_iter().enumerate() {
            let slope = (height([x, y])? - height([-x, -y])?) / (2.0 * h);
            assert!((drawn(5 + k) - slope).abs() < 1e-9, "{} and {slope}", drawn(5 + k));
        }
        Ok(())
    }
}
