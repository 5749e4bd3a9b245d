//! Error control past loads that set in at once, or as good as, and past stops: of rules that see nothing between their stages, or remember accelerations.

use catena::Error;
use catena::planar::*;

/// A body of 1 kg that is free to slide along a line.
fn body() -> RigidBody<f64> {
    RigidBody::new(1.0, 1.0, [0.0; 2], [0.0; 2])
}

/// From rest a force of 50 N sets in at 0.55 s: at 1 s the body is at 25 · 0.45² m, which rules meet as tolerances say.
#[test]
fn a_force_that_sets_in_is_met() -> Result<(), Error> {
    let cart = System::new(Clamped::origin(), (Slider::along(0.0), body()), Free)?;
    let push = Loads::none()
        .in_joints(|time: f64, joint: usize, _: &JointMotion<f64>| if joint == 1 && time >= 0.55 { 50.0 } else { 0.0 });
    macro_rules! misses {
        ($([$rule:expr, $most:expr]),* $(,)?) => {$(
            let run = cart.simulation($rule).loads(&push).run(cart.motion(), 1.0, |_| ())?;
            let missed = run.motion.coordinates()[0] - 5.0625;
            println!("{}: {missed:.1e} m, {} steps, {} rejected", stringify!($rule), run.steps, run.rejected);
            assert!(missed.abs() < $most && run.steps + run.rejected < 150, "{}: {missed}", stringify!($rule));
        )*};
    }
    misses!(
        [Sdirk4::new().tolerance(1e-3), 2e-3],
        [Sdirk4::new().tolerance(1e-6), 1e-5],
        [Sdirk4::new().tolerance(1e-9), 1e-8],
        [Auto::tolerance(1e-6), 1e-5],
        [Dop853::tolerance(1e-6), 1e-5],
        [GeneralizedAlpha::new(0.8).tolerance(1e-6), 2e-3],
        [GeneralizedAlpha::new(0.8).tolerance(1e-9), 2e-4],
        [GeneralizedAlpha::new(0.8).tolerance(1e-12), 2e-5],
        [GeneralizedAlpha::new(0.0).tolerance(1e-6), 2e-3],
        [GeneralizedAlpha::new(0.0).tolerance(1e-9), 2e-4],
        [GeneralizedAlpha::trapezoidal().tolerance(1e-9), 2e-4],
    );
    Ok(())
}

/// The same smoothly within a few milliseconds: F = 25 (1 + tanh s) N, s = (t − 0.55 s) / 1 ms, whose second integral is 25 (t²/2 + ∬ tanh).
#[test]
fn a_force_that_grows_within_milliseconds_is_met() -> Result<(), Error> {
    let cart = System::new(Clamped::origin(), (Slider::along(0.0), body()), Free)?;
    let push = Loads::none().in_joints(
        |time: f64, joint: usize, _: &JointMotion<f64>| {
            if joint == 1 { 25.0 * (1.0 + ((time - 0.55) / 1e-3).tanh()) } else { 0.0 }
        },
    );
    // By Simpson's rule, v' = F in steps of 5 µs, and x' = v by Hermite's cubic of it.
    let (h, force) = (5e-6, |time: f64| 25.0 * (1.0 + ((time - 0.55) / 1e-3).tanh()));
    let (mut place, mut rate) = (0.0, 0.0);
    for k in 0..300_000 {
        let [a, b, c] = [0.0, 0.5, 1.0].map(|share| force((f64::from(k) + share) * h));
        place += h * (rate + h / 6.0 * (a + 2.0 * b));
        rate += h / 6.0 * (a + 4.0 * b + c);
    }
    macro_rules! misses {
        ($([$rule:expr, $most:expr]),* $(,)?) => {$(
            let run = cart.simulation($rule).loads(&push).run(cart.motion(), 1.5, |_| ())?;
            let missed = run.motion.coordinates()[0] - place;
            println!("{}: {missed:.1e} m, {} steps", stringify!($rule), run.steps);
            assert!(missed.abs() < $most, "{}: {missed}", stringify!($rule));
        )*};
    }
    misses!(
        [Sdirk4::new().tolerance(1e-5), 1e-4],
        [Sdirk4::new().tolerance(1e-9), 1e-8],
        [GeneralizedAlpha::new(0.8).tolerance(1e-5), 1e-2],
        [GeneralizedAlpha::new(0.0).tolerance(1e-9), 1e-3],
    );
    Ok(())
}

/// A body that a stiff stop without damping throws back as fast as it came.
#[test]
fn a_stop_gives_back_what_it_takes() -> Result<(), Error> {
    let stop = Slider::along(0.0).with(Stops::between([-1.0, 1.0], 1e5, 1e-3));
    let block = System::new(Clamped::origin(), (stop, body()), Free)?;
    let mut start = block.motion();
    start.set_rates(&[3.0])?;
    macro_rules! misses {
        ($([$rule:expr, $most:expr]),* $(,)?) => {$(
            let run = block.simulate(start, $rule, 0.6, |_| ())?;
            let missed = run.motion.rates()[0] + 3.0;
            println!("{}: {missed:.1e} m/s, {} steps", stringify!($rule), run.steps);
            assert!(missed.abs() < $most, "{}: {missed}", stringify!($rule));
        )*};
    }
    misses!(
        [GeneralizedAlpha::new(0.8).tolerance(1e-5), 3e-2],
        [GeneralizedAlpha::new(0.8).tolerance(1e-7), 3e-3],
        [GeneralizedAlpha::new(0.0).tolerance(1e-7), 1e-2],
        [Sdirk4::new().tolerance(1e-7), 1e-5],
    );
    Ok(())
}

/// Steps are as long as the clock says that they are: a pendulum that is released at the time of a computer's clock swings as at zero.
#[test]
fn when_a_run_begins_changes_nothing() -> Result<(), Error> {
    let pendulum = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Free)?.with_gravity(9.81);
    let start = pendulum.at_rest(&[-0.5])?;
    macro_rules! alike {
        ($($rule:expr),*) => {$(
            let end = |from: f64| {
                let run = pendulum.simulate(start.at_time(from), $rule, from + 20.0, |_| ());
                run.map(|run| run.motion.coordinates()[0]).map_err(|stopped| stopped.error)
            };
            let [now, later, today]: [f64; 3] = [end(0.0)?, end(1e6)?, end(1.7e9)?];
            println!("{}: {:.1e} {:.1e}", stringify!($rule), later - now, today - now);
            assert!((later - now).abs() < 1e-11 && (today - now).abs() < 1e-11, "{}", stringify!($rule));
        )*};
    }
    alike!(Dop853::tolerance(1e-12), Dopri5::tolerance(1e-11), Taylor::<16>::tolerance(1e-13));
    Ok(())
}
