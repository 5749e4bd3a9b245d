//! Runs that begin where an event has ended another, by a call of their own: the event is not met again.

use catena::planar::*;
use catena::{Error, Real, Scalar};
use catena_oracle::near;

/// A ball on a vertical line: its height is its coordinate.
type Ball<T> = System<T, Clamped<[T; 2], T>, (Slider<T>, RigidBody<T>), Free>;

fn ball<T: Scalar<Real = T> + Real>() -> Result<Ball<T>, Error> {
    let [o, tenth, one] = [0.0, 0.1, 1.0].map(T::of);
    let line = Slider::along(T::of(core::f64::consts::FRAC_PI_2));
    let scene = System::new(Clamped::at(o, o, o), (line, RigidBody::new(one, tenth, [o; 2], [o; 2])), Free)?;
    Ok(scene.with_gravity(T::of(9.81)))
}

/// Lets the ball fall from a height (m) to 3 s, its rate changed by a factor where it meets zero; gives the times, and its height at the end.
fn bounces<T: Scalar<Real = T> + Real>(height: f64, factor: f64, tolerance: f64) -> Result<(Vec<f64>, f64), Error> {
    let (scene, end, mut times) = (ball::<T>()?, T::of(3.0), vec![]);
    let mut now = scene.motion();
    now.set_coordinates(&[T::of(height)])?;
    loop {
        let rule = Dop853::tolerance(T::of(tolerance));
        let run = scene.simulation(rule).event(|now| now.motion().coordinates()[0]).stopping();
        now = run.run(now, end, |_| ())?.motion;
        let height = now.coordinates()[0].as_f64();
        if now.time() >= end || times.len() > 60 {
            return Ok((times, height));
        }
        times.push(now.time().as_f64());
        now.set_rates(&[now.rates()[0] * T::of(factor)])?;
    }
}

/// When a ball that loses this share of its speed meets the floor until 3 s, and its height then.
fn parabolas(height: f64, restitution: f64) -> (Vec<f64>, f64) {
    let (mut speed, mut time, mut times) = ((2.0 * 9.81 * height).sqrt(), (2.0 * height / 9.81).sqrt(), vec![]);
    loop {
        times.push(time);
        speed *= restitution;
        let (next, left) = (time + 2.0 * speed / 9.81, 3.0 - time);
        if next > 3.0 {
            return (times, left * (speed - 0.5 * 9.81 * left));
        }
        time = next;
    }
}

fn bounce_as_parabolas<T: Scalar<Real = T> + Real>(tolerance: f64, error: f64) -> Result<(), Error> {
    for (height, restitution) in
        [(0.3, 1.0), (0.3, 0.9), (0.123, 0.95), (0.777, 1.0), (1.1, 0.8), (0.05, 0.97), (0.9, 0.78)]
    {
        let (times, end) = parabolas(height, restitution);
        let (found, last) = bounces::<T>(height, -restitution, tolerance)?;
        println!("{height} m, {restitution}: {} impacts, {:.1e} m", times.len(), last - end);
        assert_eq!(found.len(), times.len(), "{found:?} instead of {times:?}");
        found.iter().zip(times).for_each(|(found, time)| near(*found, time, error));
        near(last, end, 10.0 * error);
    }
    Ok(())
}

#[test]
fn a_ball_bounces_by_runs_of_their_own() -> Result<(), Error> {
    bounce_as_parabolas::<f64>(1e-6, 1e-12)?;
    bounce_as_parabolas::<f64>(1e-12, 1e-12)
}

#[test]
fn in_single_precision_too() -> Result<(), Error> {
    bounce_as_parabolas::<f32>(1e-5, 2e-4)
}

/// Nothing happens at zero: it is passed once, whichever side of it the run has ended at.
#[test]
fn a_zero_that_is_passed_is_met_once() -> Result<(), Error> {
    for height in (1..40).map(|k| 0.1 * f64::from(k)) {
        let (times, _) = bounces::<f64>(height, 1.0, 1e-9)?;
        assert_eq!(times.len(), 1, "{times:?}");
        near(times[0], (2.0 * height / 9.81).sqrt(), 1e-12);
    }
    Ok(())
}

/// What is a zero to rounding is none where the function soon has another: a crossing near the start is an event.
#[test]
fn a_zero_soon_after_the_start_is_met() -> Result<(), Error> {
    let (times, _) = bounces::<f64>(1e-6, 1.0, 1e-9)?;
    assert_eq!(times.len(), 1);
    near(times[0], (2e-6_f64 / 9.81).sqrt(), 1e-12);
    Ok(())
}

/// A run whose gradient is sought is cut at the next event, too.
#[test]
fn states_are_cut_where_the_next_event_is() -> Result<(), Error> {
    let scene = ball::<f64>()?;
    for height in (1..20).map(|k| 0.05 * f64::from(k)) {
        let mut start = scene.motion();
        start.set_coordinates(&[height])?;
        for impact in 0..3 {
            let (mut backward, mut states) = (scene.backward(Rk4), vec![start; 201]);
            backward.run(&start, 0.01, 200, &[], &mut states)?;
            let Some(steps) = backward.cut(&[], &mut states, |state| state.position().1.0)? else { panic!("none") };
            let fall = (2.0 * height / 9.81).sqrt();
            near(states[steps].time(), if impact == 0 { fall } else { 2.0 * fall }, 1e-12);
            start = states[steps].at_time(0.0);
            start.set_rates(&[-start.rates()[0]])?;
        }
    }
    Ok(())
}

/// A run that is resumed after each impact, its rate turned round, meets the next one however short the flight, also by rules that propose their steps.
#[test]
fn a_ball_bounces_by_a_run_that_is_resumed() -> Result<(), Error> {
    macro_rules! bounce {
        ($rule:expr, $end:expr, $restitution:expr, $impacts:expr) => {{
            let (scene, end) = (ball::<f64>()?, $end);
            let simulation = || scene.simulation($rule).event(|now| now.motion().coordinates()[0]).stopping();
            let mut start = scene.motion();
            start.set_coordinates(&[1.0])?;
            let (mut speed, mut time) = (2.0_f64 * 9.81, (2.0_f64 / 9.81).sqrt());
            speed = speed.sqrt();
            let mut run = simulation().begin(start, end, |_| ())?;
            while run.step()? {}
            let mut saved = run.save();
            for impact in 0..$impacts {
                near(saved.motion.time(), time, 1e-9);
                speed *= $restitution;
                time += 2.0 * speed / 9.81;
                saved.motion.set_rates(&[-$restitution * saved.motion.rates()[0]])?;
                let mut run = simulation().resume(saved, end, |_| ())?;
                while run.step()? {}
                saved = run.save();
                assert!(saved.motion.time() < end, "impact {impact}");
            }
        }};
    }
    bounce!(Dop853::tolerance(1e-9), 100.0, 0.8, 40);
    bounce!(Dop853::tolerance(1e-9), 5.0, 0.3, 8);
    bounce!(Dopri5::tolerance(1e-9), 100.0, 0.8, 40);
    bounce!(Sdirk4::new().tolerance(1e-9), 100.0, 0.8, 40);
    bounce!(Vcabm::new().tolerance(1e-9), 100.0, 0.8, 30);
    bounce!(Auto::tolerance(1e-9), 100.0, 0.8, 40);
    Ok(())
}

/// A run says whether an event has ended it; times that are shown never go back.
#[test]
fn samples_and_events_are_shown_in_turn() -> Result<(), Error> {
    let scene = ball::<f64>()?;
    let mut start = scene.motion();
    start.set_rates(&[4.905])?; // up for half a second, back after one
    for (every, fraction) in [(0.5, 0.0), (0.3, 1e-10), (0.25, 3e-11)] {
        for stops in [false, true] {
            let mut times = vec![];
            let simulation = scene.simulation(Dop853::tolerance(1e-10)).every(every);
            let simulation = simulation.event(|now| {
                if every == 0.5 { now.motion().coordinates()[0] } else { now.time() - 3.0 * every + fraction }
            });
            let end = if stops {
                let run = simulation.stopping().run(start, 2.0, |now| times.push(now.time()))?;
                assert!(run.at_event);
                run.motion.time()
            } else {
                let run = simulation.run(start, 2.0, |now| times.push(now.time()))?;
                assert!(!run.at_event);
                2.0
            };
            assert!(times.windows(2).all(|pair| pair[0] <= pair[1]), "{times:?}");
            assert!(!stops || times.last() == Some(&end), "{times:?}");
        }
    }
    Ok(())
}
