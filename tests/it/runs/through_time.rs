//! Runs through time: samples, events, step control, steps on their own, energy and momentum.

use catena::loading::Unloaded;
use catena::planar::Absent;
use catena::planar::*;
use catena::simulate::{Method, Stepper};
use catena::system::MotionOf;
use catena::system::{Position, Rate};
use catena::time::{Explicit, Rule, Sdirk4};
use catena::{Error, Motion, Real};
use catena_oracle::plane as oracle;
use catena_oracle::{Noise, has_order, near};
use core::f64::consts::{FRAC_PI_3, PI};

type Chain = (Rod<f64>, Pin, Rod<f64>);
type Pendulum = System<f64, Pinned<[f64; 2]>, Chain, Free>;
type Torques = Loads<Absent, Values<[f64; 2]>>;
type Start = MotionOf<Planar<f64>, Pinned<[f64; 2]>, Chain, Free>;

/// A double pendulum that starts with some speed.
fn pendulum() -> Result<(Pendulum, Start), Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let system = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let start = system.with_rates(system.at_rest(&[-0.4, 0.3])?, &[1.0, -1.5])?;
    let start = system.with_accelerations(start, &Unloaded)?;
    Ok((system, start))
}

/// Positions and rates, one after the other.
fn numbers<P: Position<f64>>(motion: &Motion<f64, P>) -> Vec<f64> {
    let mut numbers = vec![];
    Position::visit(motion.position(), &mut |x| numbers.push(x));
    Rate::visit(motion.rate(), &mut |x| numbers.push(x));
    numbers
}

/// The largest difference of two motions in positions and rates.
fn distance<P: Position<f64>>(a: &Motion<f64, P>, b: &Motion<f64, P>) -> f64 {
    numbers(a).iter().zip(numbers(b)).fold(0.0, |largest, (a, b)| largest.max((a - b).abs()))
}

/// The pendulum's motion at a time, exact to rounding: forty steps of order 8.
fn exact(time: f64) -> Result<Start, Error> {
    let (system, start) = pendulum()?;
    Ok(system.simulate(start, Dop853::step(time / 40.0), time, |_| ())?.motion)
}

/// The error of the dense output inside of one step from the start.
fn dense_error<M: Explicit>(method: M, step: f64) -> Result<f64, Error> {
    let (system, start) = pendulum()?;
    let (mut next, mut between) = (start, start);
    let mut stepper = system.stepper(method);
    stepper.advance(&start, &Unloaded, step, &mut next)?;
    let mut worst = 0.0_f64;
    for theta in [0.2, 0.4, 0.6, 0.8] {
        stepper.interpolate(&start, &Unloaded, step, &next, theta, &mut between);
        assert_eq!(between.time(), theta * step);
        worst = worst.max(distance(&between, &exact(theta * step)?));
    }
    // It passes through both ends, but for rounding.
    for (theta, end) in [(0.0, &start), (1.0, &next)] {
        stepper.interpolate(&start, &Unloaded, step, &next, theta, &mut between);
        assert!(distance(&between, end) < 1e-14);
    }
    Ok(worst)
}

#[test]
fn dense_output_has_its_order_within_a_step() -> Result<(), Error> {
    // A polynomial of order q errs by the power q + 1 of the step. One step is rounded to 1e-16 of a few units.
    let errors = |of: &dyn Fn(f64) -> Result<f64, Error>, steps: [f64; 4]| -> Result<Vec<(f64, f64)>, Error> {
        steps.into_iter().map(|step| Ok((step, of(step)?))).collect()
    };
    has_order("RK4, cubic", 4.0, 1e-15, &errors(&|step| dense_error(Rk4, step), [0.02, 0.01, 0.005, 0.0025])?);
    has_order("DOPRI5, quartic", 5.0, 1e-15, &errors(&|step| dense_error(Dopri5, step), [0.04, 0.02, 0.01, 0.005])?);
    has_order("DOP853, order 7", 8.0, 1e-15, &errors(&|step| dense_error(Dop853, step), [0.05, 0.04, 0.03, 0.025])?);
    Ok(())
}

/// The largest error of samples that are not on steps.
fn sampled<M: for<'s> Method<&'s Pendulum, Unloaded>>(rule: Rule<M, f64>) -> Result<f64, Error> {
    let (system, start) = pendulum()?;
    let mut worst = 0.0_f64;
    system.simulation(rule).every(0.07).run(start, 0.6, |now| {
        if now.time() > 0.0 {
            worst = worst.max(distance(now.motion(), &exact(now.time()).unwrap()));
        }
    })?;
    Ok(worst)
}

#[test]
fn samples_between_steps_converge_with_the_order_of_the_steps() -> Result<(), Error> {
    let errors = |of: &dyn Fn(f64) -> Result<f64, Error>, steps: [f64; 4]| -> Result<Vec<(f64, f64)>, Error> {
        steps.into_iter().map(|step| Ok((step, of(step)?))).collect()
    };
    // Floors: rounding in sixty to a few hundred steps.
    has_order("RK4", 4.0, 1e-15, &errors(&|h| sampled(Rk4::step(h)), [0.02, 0.01, 0.005, 0.0025])?);
    has_order("DOPRI5", 5.0, 1e-15, &errors(&|h| sampled(Dopri5::step(h)), [0.02, 0.01, 0.005, 0.0025])?);
    has_order("DOP853", 8.0, 1e-15, &errors(&|h| sampled(Dop853::step(h)), [0.1, 0.075, 0.06, 0.05])?);
    has_order("SDIRK4", 4.0, 1e-15, &errors(&|h| sampled(Sdirk4::new().step(h)), [0.02, 0.01, 0.005, 0.0025])?);
    let alpha = errors(&|h| sampled(GeneralizedAlpha::new(0.8).step(h)), [0.02, 0.01, 0.005, 0.0025])?;
    has_order("generalised-α", 2.0, 1e-15, &alpha);
    Ok(())
}

/// Times at which a run is shown.
fn shown<T: Real, M: Explicit>(rule: Rule<M, T>, start: f64, every: f64, end: f64) -> Result<Vec<T>, Error> {
    let rod = Rod::uniform(T::of(1.0), T::of(1.0));
    let system = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(T::of(9.81));
    let start = system.at_rest(&[T::of(-0.4), T::of(0.3)])?.at_time(T::of(start));
    let mut times = vec![];
    let run = system.simulation(rule).every(T::of(every)).run(start, T::of(end), |now| {
        assert!(!now.is_event());
        // Forces belong to the motion shown.
        let motion = system.with_accelerations(*now.motion(), &Unloaded).unwrap();
        assert!(motion == *now.motion());
        times.push(now.time());
    })?;
    assert_eq!(run.motion.time(), T::of(end));
    Ok(times)
}

/// Samples are at the multiples of the interval from the start, but for the rounding of a hundred steps, and none is
/// missing.
fn on_time<T: Real>(name: &str, times: &[T], start: f64, every: f64, count: usize) {
    assert_eq!(times.len(), count, "{name}, every {every} s: {times:?}");
    for (k, time) in times.iter().enumerate() {
        let expected = start + every * k as f64;
        let off = (time.as_f64() - expected).abs();
        assert!(off <= 10.0 * T::EPSILON.as_f64() * expected, "{name}: {time} instead of {expected}");
    }
}

/// Start, interval and end, and the number of samples. Intervals are below, at and above the step; ends are on a
/// sample, but for rounding, and between two.
const SAMPLES: [(f64, f64, f64, usize); 11] = [
    (0.25, 0.1, 0.75, 6),
    (0.25, 0.1, 0.95, 8),
    (0.25, 0.1, 1.0, 8),
    (0.25, 0.003, 0.4, 51),
    (0.25, 0.01, 0.55, 31),
    (0.0, 0.1, 0.3, 4),
    (0.0, 0.1, 0.6, 7),
    (0.0, 0.1, 0.7, 8),
    (0.0, 0.01, 0.57, 58),
    (0.0, 0.1, 0.9, 10),
    (0.0, 0.07, 0.63, 10),
];

#[test]
fn samples_are_at_the_multiples_of_the_interval() -> Result<(), Error> {
    for (start, every, end, count) in SAMPLES {
        on_time("RK4", &shown::<f64, _>(Rk4::step(0.01), start, every, end)?, start, every, count);
        on_time("RK4, coarse", &shown::<f64, _>(Rk4::step(0.037), start, every, end)?, start, every, count);
        on_time("DOPRI5", &shown::<f64, _>(Dopri5::tolerance(1e-8), start, every, end)?, start, every, count);
        on_time("DOP853", &shown::<f64, _>(Dop853::tolerance(1e-12), start, every, end)?, start, every, count);
    }
    Ok(())
}

#[test]
fn samples_in_single_precision_are_as_many() -> Result<(), Error> {
    for (start, every, end, count) in SAMPLES {
        on_time("RK4", &shown::<f32, _>(Rk4::step(0.01), start, every, end)?, start, every, count);
        on_time("RK4, coarse", &shown::<f32, _>(Rk4::step(0.037), start, every, end)?, start, every, count);
        on_time("DOPRI5", &shown::<f32, _>(Dopri5::tolerance(1e-4), start, every, end)?, start, every, count);
    }
    Ok(())
}

/// Of a bob released from the horizontal on a link of one metre: 4 K(1/√2) √(l/g).
const PERIOD: f64 = 2.3678419475762374;

#[test]
fn events_are_located_where_the_exact_solution_has_them() -> Result<(), Error> {
    let system = System::new(Pinned::origin(), PointMass::new(1.0, 1.0), Free)?.with_gravity(9.81);
    let start = system.at_rest(&[PI])?;
    let mut found = vec![];
    let run = system
        .simulation(Dop853::tolerance(1e-14))
        .event(|now| now.bodies().get(0).unwrap().outboard().place.x)
        .run(start, 3.0 * PERIOD, |now| {
            if now.is_event() {
                found.push(now.time());
                let bob = now.bodies().get(0).unwrap().outboard();
                // As far as the event's own time is off.
                assert!(bob.place.x.abs() < 1e-14 && (bob.place.y + 1.0).abs() < 1e-12);
            }
        })?;
    assert_eq!((found.len(), run.motion.time()), (6, 3.0 * PERIOD));
    for (k, time) in found.into_iter().enumerate() {
        let expected = (0.25 + 0.5 * k as f64) * PERIOD;
        println!("event at {time:.15}, error {:.1e}", time - expected);
        // Steps of 1e-14, whose errors grow with the phase, and a polynomial within a step of 50 ms.
        near(time, expected, 1e-12);
    }
    Ok(())
}

#[test]
fn runs_stop_at_events() -> Result<(), Error> {
    let system = System::new(Pinned::origin(), PointMass::new(1.0, 1.0), Free)?.with_gravity(9.81);
    let start = system.at_rest(&[PI])?;
    let (mut shown, mut samples) = (None, vec![]);
    let run = system
        .simulation(Dop853::tolerance(1e-14))
        .every(0.25)
        .event(|now| now.bodies().get(0).unwrap().outboard().place.x)
        .stopping()
        .run(start, 10.0, |now| {
            assert!(shown.is_none(), "nothing is shown after the event");
            if now.is_event() { shown = Some(now.time()) } else { samples.push(now.time()) }
        })?;
    assert_eq!(samples, [0.0, 0.25, 0.5]);
    assert_eq!(shown, Some(run.motion.time()));
    println!("stopped at {:.15}, error {:.1e}", run.motion.time(), run.motion.time() - PERIOD / 4.0);
    near(run.motion.time(), PERIOD / 4.0, 1e-12);
    // All of the potential energy, 9.81 J, has become kinetic; the accelerations belong to the motion.
    near(system.budget(&run.motion)?.kinetic, 9.81, 1e-11);
    assert!(system.with_accelerations(run.motion, &Unloaded)? == run.motion);
    Ok(())
}

#[test]
fn error_control_meets_its_tolerance() -> Result<(), Error> {
    fn error<M: Explicit>(name: &str, rule: Rule<M, f64>, tolerance: f64) -> Result<f64, Error> {
        let rod = Rod::uniform(1.0, 1.0);
        let system = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
        let run = system.simulate(system.at_rest(&[-FRAC_PI_3; 2])?, rule, 2.0, |_| ())?;
        let angles = system.angles(&run.motion)?;
        let reference = [-1.3564198519106136, -1.1306522396578225];
        let error = (0..2).fold(0.0, |largest: f64, k| largest.max((angles.get(k).unwrap() - reference[k]).abs()));
        println!("{name} {tolerance:.0e}: error {error:.1e}, {} steps, {} rejected", run.steps, run.rejected);
        // Errors of a step are kept; those of some twenty to a hundred steps add up, and the motion carries them along.
        assert!(error < 20.0 * tolerance && error > 1e-4 * tolerance);
        // Steps are tried in vain now and then, not as a rule.
        assert!(run.rejected * 2 < run.steps);
        Ok(error)
    }
    let (mut last, mut points) = ([f64::INFINITY; 2], vec![]);
    for tolerance in [1e-5, 1e-7, 1e-9, 1e-11] {
        let errors = [
            error("DOPRI5", Dopri5::tolerance(tolerance), tolerance)?,
            error("DOP853", Dop853::tolerance(tolerance), tolerance)?,
        ];
        assert!(errors[0] < last[0] && errors[1] < last[1]);
        points.push((tolerance, errors[0]));
        last = errors;
    }
    // Errors are proportional to tolerances: an estimate that takes rates for positions, an order off, leaves powers of 5/4.
    has_order("DOPRI5 against tolerance", 1.0, 1e-14, &points);
    Ok(())
}

/// A pulse of a twentieth of a second, which a pendulum at rest would step over.
#[test]
fn no_step_is_longer_than_the_longest() -> Result<(), Error> {
    let system = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Free)?;
    let pulse = |time: f64| if (2.0..2.05).contains(&time) { 4.0 } else { 0.0 };
    let loads = Loads::none().in_joints(move |time, _, _: &JointMotion<f64>| pulse(time));
    let end = |longest: f64| {
        let (mut last, mut most) = (0.0, 0.0_f64);
        let run = system.simulation(Dop853::tolerance(1e-9)).loads(&loads).longest_step(longest);
        let run = run.run(system.motion(), 10.0, |now| {
            most = most.max(now.time() - last);
            last = now.time();
        });
        run.map(|run| (run.motion.rate().0, most)).map_err(Error::from)
    };
    let (missed, _) = end(10.0)?;
    let (found, most) = end(0.04)?;
    println!("rate {found} rad/s, steps up to {most} s; with steps as long as they like {missed} rad/s");
    assert!(missed == 0.0 && most <= 0.04 * (1.0 + 1e-12));
    near(found, 3.0 * 4.0 * 0.05, 1e-6); // m l²/3 of inertia; the pulse begins and ends within steps
    let refused = system.simulation(Rk4::step(0.1)).longest_step(0.0).run(system.motion(), 1.0, |_| ());
    assert!(
        matches!(refused, Err(failed) if matches!(failed.error.fault, catena::Fault::NotPositive { parameter: "longest step", .. }))
    );
    Ok(())
}

#[test]
fn fixed_steps_end_on_time() -> Result<(), Error> {
    let (system, start) = pendulum()?;
    for (step, end, count) in [(0.1, 1.0, 10), (0.01, 3.0, 300), (0.3, 1.0, 4), (5.0, 1.0, 1), (0.1, 0.0, 0)] {
        let mut times = vec![];
        let run = system.simulate(start, Rk4::step(step), end, |now| times.push(now.time()))?;
        assert_eq!((run.motion.time(), run.steps, run.rejected), (end, count, 0));
        assert_eq!((times.len(), times[0], times[count]), (count + 1, 0.0, end));
        for (k, time) in times[..count].iter().enumerate() {
            near(*time, k as f64 * step, 1e-13 * end);
        }
    }
    Ok(())
}

#[test]
fn many_fixed_steps_are_not_one_too_many() -> Result<(), Error> {
    let system = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Free)?.with_gravity(9.81);
    let start = system.at_rest(&[-1.0])?;
    let mut shortest = f64::INFINITY;
    let mut last = None;
    let run = system.simulate(start, Rk4::step(0.01), 60.0, |now| {
        shortest = shortest.min(now.time() - last.unwrap_or(f64::NEG_INFINITY));
        last = Some(now.time());
    })?;
    println!("{} steps, the shortest {shortest:e} s", run.steps);
    assert_eq!((run.motion.time(), run.steps), (60.0, 6000));
    assert!(shortest > 0.0099);
    Ok(())
}

#[test]
fn every_rule_makes_the_sweeps_it_says() -> Result<(), Error> {
    let (system, start) = pendulum()?;
    let run = system.simulate(start, Rk4::step(0.01), 1.0, |_| ())?;
    assert_eq!((run.steps, run.sweeps), (100, 400));
    let run = system.simulate(start, Dopri5::tolerance(1e-9), 1.0, |_| ())?;
    assert_eq!(run.sweeps, 6 * (run.steps + run.rejected));
    let run = system.simulate(start, Dop853::tolerance(1e-12), 1.0, |_| ())?;
    assert_eq!(run.sweeps, 12 * (run.steps + run.rejected));
    Ok(())
}

/// Torques that a digital controller holds for a tenth of a second each.
fn held(interval: usize) -> [f64; 2] {
    [1.0 - 2.5 * (interval % 2) as f64, [0.6, -0.4, 0.2][interval % 3]]
}

const HOLD: f64 = 0.1;

/// The motion after six intervals, each of them in so many steps by one stepper: from accelerations found anew, or from
/// those that the last step left.
fn controlled<M>(method: M, steps: usize, anew: bool) -> Result<Start, Error>
where
    M: for<'s> Method<&'s Pendulum, Torques>,
{
    let (system, mut past) = pendulum()?;
    let mut next = past;
    let mut stepper = system.stepper(method);
    let dt = HOLD / steps as f64;
    for interval in 0..6 {
        let loads = Loads::none().torques(held(interval));
        for _ in 0..steps {
            if anew {
                stepper.step(&past, &loads, dt, &mut next)?;
            } else {
                stepper.advance(&past, &loads, dt, &mut next)?;
            }
            core::mem::swap(&mut past, &mut next);
        }
    }
    Ok(past)
}

#[test]
fn a_step_keeps_its_order_where_torques_jump() -> Result<(), Error> {
    let expected = controlled(Dop853, 40, true)?;
    let errors = |of: &dyn Fn(usize) -> Result<Start, Error>, steps: [usize; 4]| -> Result<Vec<(f64, f64)>, Error> {
        steps.into_iter().map(|n| Ok((HOLD / n as f64, distance(&of(n)?, &expected)))).collect()
    };
    // Rounding in some hundred steps.
    has_order("RK4", 4.0, 1e-14, &errors(&|n| controlled(Rk4, n, true), [10, 20, 40, 80])?);
    has_order("DOPRI5", 5.0, 1e-14, &errors(&|n| controlled(Dopri5, n, true), [16, 24, 32, 48])?);
    has_order("DOP853", 8.0, 1e-14, &errors(&|n| controlled(Dop853, n, true), [2, 3, 4, 5])?);
    let implicit = errors(&|n| controlled(GeneralizedAlpha::new(0.8), n, true), [20, 40, 80, 160])?;
    has_order("generalised-α", 2.0, 1e-14, &implicit);
    let implicit = errors(&|n| controlled(Sdirk4::new(), n, true), [10, 20, 40, 80])?;
    has_order("SDIRK4", 4.0, 1e-14, &implicit);
    // Accelerations of the torques before the jump spoil it: what is left is the first order of a single wrong stage.
    let stale = errors(&|n| controlled(Rk4, n, false), [5, 10, 20, 40])?;
    has_order("RK4 with stale accelerations", 1.0, 1e-14, &stale);
    Ok(())
}

#[test]
fn dense_output_and_error_of_such_a_step_are_those_of_its_torques() -> Result<(), Error> {
    fn same<M: for<'s> Method<&'s Pendulum, Torques> + Copy>(method: M) -> Result<(), Error> {
        let (system, stale) = pendulum()?;
        let loads = Loads::none().torques([30.0, -20.0]);
        let fresh = system.with_accelerations(stale, &loads)?;
        let (mut next, dt) = (stale, 0.01);
        let readings = [&fresh, &stale].map(|past| {
            let mut stepper = system.stepper(method);
            let mut between = *past;
            stepper.step(past, &loads, dt, &mut next).unwrap();
            stepper.interpolate(past, &loads, dt, &next, 0.5, &mut between);
            (numbers(&next), numbers(&between), stepper.error(past, dt, &next, 1e-9))
        });
        println!("{:?}", readings[0].2);
        // The same step, bit by bit, whatever accelerations the past motion holds: the step finds its own.
        assert_eq!(readings[0], readings[1]);
        Ok(())
    }
    same(Rk4)?;
    same(Dopri5)?;
    same(Dop853)?;
    same(GeneralizedAlpha::new(0.8))?;
    same(Sdirk4::new())
}

/// A stepper may serve several motions of its scene in turn, also at the same times: an explicit rule makes the same steps
/// bit by bit, and one that remembers something of its last step makes steps as good as with a stepper for each.
#[test]
fn a_stepper_serves_several_motions_in_turn() -> Result<(), Error> {
    fn serves<M>(method: M, remembers: bool) -> Result<(), Error>
    where
        M: for<'s> Method<&'s Pendulum, Unloaded> + Copy,
    {
        let (system, one) = pendulum()?;
        let other = system.with_rates(system.at_rest(&[0.9, -2.0])?, &[-2.0, 3.0])?;
        let mut together = [one, other];
        let mut next = one;
        let mut stepper = system.stepper(method);
        for _ in 0..20 {
            for past in &mut together {
                stepper.step(past, &Unloaded, 0.01, &mut next)?;
                core::mem::swap(past, &mut next);
            }
        }
        for (together, start) in together.iter().zip([one, other]) {
            let exact = system.simulate(start, Dop853::step(0.01), together.time(), |_| ())?.motion;
            let (mut alone, mut stepper) = (start, system.stepper(method));
            for _ in 0..20 {
                stepper.step(&alone, &Unloaded, 0.01, &mut next)?;
                core::mem::swap(&mut alone, &mut next);
            }
            println!("errors {:.1e} alone, {:.1e} in turn", distance(&alone, &exact), distance(together, &exact));
            assert!(remembers || numbers(together) == numbers(&alone));
            assert!(distance(together, &exact) <= 3.0 * distance(&alone, &exact));
        }
        Ok(())
    }
    serves(Rk4, false)?;
    serves(Dopri5, false)?;
    serves(Dop853, false)?;
    serves(GeneralizedAlpha::new(0.8), true)?;
    serves(Sdirk4::new(), false)
}

/// Energy, momentum and angular momentum against the oracle's, of random moving chains.
#[test]
fn energy_and_momentum_are_those_of_the_oracle() -> Result<(), Error> {
    for seed in 0..5 {
        let noise = &mut Noise::new(400 + seed);
        let make = |noise: &mut Noise| oracle::Body {
            mass: noise.between(0.3, 3.0),
            inertia_c: noise.between(0.05, 0.6),
            centre: noise.pair(),
            outboard: noise.pair(),
        };
        let bodies: Vec<oracle::Body> = (0..5).map(|_| make(noise)).collect();
        let rigid = |k: usize| {
            let oracle::Body { mass, inertia_c, centre, outboard } = bodies[k];
            RigidBody::new(mass, inertia_c, centre, outboard)
        };
        let place = noise.pair();
        let gravity = [3.0, -8.0];
        let chain = (rigid(0), (1..5).map(|k| (Pin, rigid(k))).collect::<Vec<_>>());
        let system = System::new(Pinned::on(place), chain, Free)?.with_gravity_vector(gravity.into());
        let angles: Vec<f64> = (0..5).map(|_| noise.between(-3.0, 3.0)).collect();
        let rates: Vec<f64> = (0..5).map(|_| noise.between(-2.0, 2.0)).collect();
        let budget = system.budget(&system.with_rates(system.at_rest(&angles)?, &rates)?)?;

        let mut scene = oracle::Scene::pinned(bodies.clone());
        scene.gravity = gravity;
        scene.ground = oracle::Ground::at(place);
        let state = scene.assemble(&angles, &rates);
        // Sums of ten terms, each below a hundred.
        near(budget.kinetic, scene.kinetic_energy(&state), 1e-13 * 10.0);
        near(budget.potential, scene.potential_energy(&state), 1e-13 * 10.0);
        near(budget.momentum.x, scene.linear_momentum(&state)[0], 1e-13 * 10.0);
        near(budget.momentum.y, scene.linear_momentum(&state)[1], 1e-13 * 10.0);
        near(budget.angular_momentum, scene.angular_momentum(&state), 1e-13 * 10.0);
    }
    Ok(())
}

/// The work of torques and moving ground is what the energy gains; so is the impulse of all forces the momentum.
#[test]
fn work_becomes_energy_and_impulse_momentum() -> Result<(), Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let shaken = |t: f64| {
        let (s, c) = (5.0 * t).sin_cos();
        GroundMotion { place: [0.2 * s, 0.1 * c], velocity: [c, -0.5 * s], acceleration: [-5.0 * s, -2.5 * c] }
    };
    let torque = |t: f64, joint: usize| (3.0 * t + joint as f64).sin();
    let system = System::new(Pinned::on(Moving(shaken)), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let start = system.at_rest(&[-1.0, -0.5])?;
    let loads = Loads::none().in_joints(|t, joint, _: &JointMotion<f64>| torque(t, joint));
    let before = system.budget(&start)?;
    let (mut points, h) = (vec![], 1e-3);
    let run = system.simulation(Dop853::step(h)).loads(&loads).run(start, 1.0, |now| {
        let (t, stations, bodies) = (now.time(), now.stations(), now.bodies());
        let force = stations.root().internal.force;
        let rates: Vec<f64> = bodies.iter().map(BodyMotion::rate).collect();
        let ground = shaken(t).velocity;
        let driven = torque(t, 0) * rates[0] + torque(t, 1) * (rates[1] - rates[0]);
        points.push([driven + force.x * ground[0] + force.y * ground[1], force.x, force.y - 2.0 * 9.81]);
    })?;
    let after = system.budget(&run.motion)?;
    // Simpson's rule with steps of 1 ms: 1e-12 times fourth derivatives of some 5⁴ · 100 leaves 1e-9 of the whole.
    let n = points.len() - 1;
    let integral = |i: usize| {
        let weight = |k: usize| if k == 0 || k == n { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
        (0..=n).map(|k| weight(k) * points[k][i]).sum::<f64>() * h / 3.0
    };
    let gained = [
        after.kinetic + after.potential - before.kinetic - before.potential,
        after.momentum.x - before.momentum.x,
        after.momentum.y - before.momentum.y,
    ];
    for (i, gained) in gained.into_iter().enumerate() {
        println!("{gained:.10} {:.1e}", integral(i) - gained);
        near(integral(i), gained, 1e-9);
    }
    Ok(())
}
