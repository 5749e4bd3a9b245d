//! The predictor and corrector of Adams, Bashforth and Moulton: order, steps of any size, restarts, error control.

use catena::Error;
use catena::loading::Unloaded;
use catena::planar::*;
use catena::simulate::Stepper;
use catena_oracle::{Noise, has_order, near};
use core::f64::consts::FRAC_PI_3;
use num_dual::Dual64;

type Rods<T> = System<T, Pinned<[T; 2]>, (Rod<T>, Pin, Rod<T>), Free>;
type State = catena::system::MotionOf<Planar<f64>, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>), Free>;

/// The double pendulum of `runs/double_pendulum.rs` at two seconds: an integration of order 8, a Taylor series of 30 digits.
const ANGLES: [f64; 2] = [-1.3564198519106136, -1.1306522396578225];
const ROOT_FORCE: [f64; 2] = [-3.354922171594491, 20.855383568488572];
/// What very small steps leave.
const FLOORS: [f64; 2] = [2e-14, 2e-13];

fn rods() -> Result<Rods<f64>, Error> {
    let rod = Rod::uniform(1.0, 1.0);
    Ok(System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81))
}

/// Errors of angles and of the force at the root.
fn errors(scene: &Rods<f64>, motion: &State, [angles, force]: [[f64; 2]; 2]) -> [f64; 2] {
    let found = scene.angles(motion).unwrap();
    let internal = scene.stations(motion, &Unloaded).unwrap().root().internal.force;
    let largest = |of: &dyn Fn(usize) -> f64| of(0).abs().max(of(1).abs());
    [largest(&|k| found.get(k).unwrap_or(&f64::NAN) - angles[k]), largest(&|k| internal[k] - force[k])]
}

fn has_order_five(name: &str, numbers: &[u32], of: impl Fn(u32) -> Result<[f64; 2], Error>) -> Result<(), Error> {
    let [mut angles, mut forces] = [vec![], vec![]];
    for n in numbers {
        let [angle, force] = of(*n)?;
        angles.push((f64::from(*n).recip(), angle));
        forces.push((f64::from(*n).recip(), force));
    }
    has_order(&format!("{name}, angles"), 5.0, FLOORS[0], &angles);
    has_order(&format!("{name}, force"), 5.0, FLOORS[1], &forces);
    Ok(())
}

#[test]
fn steps_have_order_five_and_take_two_sweeps() -> Result<(), Error> {
    let scene = rods()?;
    has_order_five("equal steps", &[500, 1000, 2000], |n| {
        let run = scene.simulate(scene.at_rest(&[-FRAC_PI_3; 2])?, Adams::step(2.0 / f64::from(n)), 2.0, |_| ())?;
        assert_eq!(run.sweeps, 3 * 6 + (n as usize - 3) * 2);
        Ok(errors(&scene, &run.motion, [ANGLES, ROOT_FORCE]))
    })
}

/// Each up to four times as large as the one before, or as small.
#[test]
fn steps_of_random_size_have_order_five() -> Result<(), Error> {
    let scene = rods()?;
    has_order_five("random steps", &[500, 1000, 2000], |n| {
        let mut noise = Noise::new(7);
        let shares: Vec<f64> = (0..n).map(|_| noise.between(0.4, 1.6)).collect();
        let unit = 2.0 / shares.iter().sum::<f64>();
        let mut stepper = scene.stepper(Adams);
        let mut past = scene.at_rest(&[-FRAC_PI_3; 2])?;
        let mut next = past;
        for share in shares {
            stepper.step(&past, &Unloaded, share * unit, &mut next)?;
            core::mem::swap(&mut past, &mut next);
        }
        // One sweep at the start of each step, for loads may have changed; what was remembered was recognised.
        assert_eq!(stepper.sweeps(), 3 * 7 + (n as usize - 3) * 3);
        Ok(errors(&scene, &past, [ANGLES, ROOT_FORCE]))
    })
}

/// A step a share g as long as those after it, once and twice: read by them, its errors would be multiplied by 1/g, then by 1/g².
#[test]
fn very_short_steps_between_others_do_no_harm() -> Result<(), Error> {
    let scene = rods()?;
    let start = scene.at_rest(&[-FRAC_PI_3; 2])?;
    let error = |sizes: &[f64]| -> Result<f64, Error> {
        let (mut stepper, mut past, mut next) = (scene.stepper(Adams), start, start);
        for size in sizes {
            stepper.step(&past, &Unloaded, *size, &mut next)?;
            core::mem::swap(&mut past, &mut next);
        }
        let exact = scene.simulate(start, Dop853::tolerance(1e-13), past.time(), |_| ())?.motion;
        let pairs = scene.angles(&past).unwrap();
        Ok(pairs.iter().zip(scene.angles(&exact).unwrap().iter()).fold(0.0, |worst, (a, b)| worst.max((a - b).abs())))
    };
    let plain = error(&[0.01; 100])?;
    for exponent in 3..14 {
        for count in 1..=3 {
            let mut sizes = vec![0.01; 100];
            sizes.splice(50..50, vec![10_f64.powi(-exponent); count]);
            let found = error(&sizes)?;
            println!("{count} steps of 1e-{exponent} s: {found:.1e} rad, none {plain:.1e}");
            assert!(found < 2.0 * plain);
        }
    }
    Ok(())
}

/// Backwards, and not at all.
#[test]
fn steps_may_turn_round() -> Result<(), Error> {
    let scene = rods()?;
    let (mut stepper, mut past) = (scene.stepper(Adams), scene.at_rest(&[-FRAC_PI_3; 2])?);
    let mut next = past;
    let start = past;
    for _ in 0..10 {
        stepper.step(&past, &Unloaded, 0.01, &mut next)?;
        core::mem::swap(&mut past, &mut next);
    }
    stepper.step(&past, &Unloaded, 0.0, &mut next)?;
    assert_eq!(next.position(), past.position());
    for _ in 0..10 {
        stepper.step(&past, &Unloaded, -0.01, &mut next)?;
        core::mem::swap(&mut past, &mut next);
    }
    let pairs = scene.angles(&past)?;
    let off = pairs.iter().zip(scene.angles(&start)?.iter()).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
    println!("there and back: {off:.1e} rad");
    assert!(off < 2.6e-8); // what a hundred such steps leave
    Ok(())
}

/// Derivatives of one step from a motion in mid-run: what is remembered has other derivative parts, and is forgotten.
#[test]
fn derivative_parts_may_be_set_anew() -> Result<(), Error> {
    let rod = Rod::uniform(Dual64::from(1.0), Dual64::from(1.0));
    let scene: Rods<Dual64> = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(Dual64::from(9.81));
    let mut past = scene.at_rest(&[Dual64::from(-1.0); 2])?;
    let (mut adams, mut dopri5, mut next) = (scene.stepper(Adams), scene.stepper(Dopri5), past);
    for _ in 0..10 {
        adams.step(&past, &Unloaded, 0.02, &mut next)?;
        core::mem::swap(&mut past, &mut next);
    }
    let mut expected = past;
    // With respect to the first angle.
    past.position_mut().0 = past.position().0.derivative();
    adams.step(&past, &Unloaded, 0.02, &mut next)?;
    dopri5.step(&past, &Unloaded, 0.02, &mut expected)?;
    let [found, expected] = [next, expected].map(|motion| [motion.rate().0.eps, motion.rate().1.1.eps]);
    assert_eq!(found, expected);
    Ok(())
}

/// A step that is taken back does not stand in the way of the one made instead.
#[test]
fn a_step_may_be_repeated() -> Result<(), Error> {
    let scene = rods()?;
    let mut steppers = [scene.stepper(Adams), scene.stepper(Adams)];
    let mut ends = [scene.at_rest(&[-FRAC_PI_3; 2])?; 2];
    for (repeats, (stepper, end)) in steppers.iter_mut().zip(&mut ends).enumerate() {
        for _ in 0..40 {
            let past = *end;
            for size in [0.02, 0.005, 0.01].iter().skip(if repeats == 0 { 2 } else { 0 }) {
                stepper.step(&past, &Unloaded, *size, end)?;
            }
        }
    }
    assert_eq!(ends[0], ends[1]);
    assert!(steppers[1].sweeps() > 2 * steppers[0].sweeps());
    Ok(())
}

/// Two motions in turn share no memory: every step starts anew, and none takes the other's accelerations.
#[test]
fn several_motions_may_take_turns() -> Result<(), Error> {
    let scene = rods()?;
    let starts = [scene.at_rest(&[-FRAC_PI_3; 2])?, scene.at_rest(&[0.3, 1.0])?];
    let mut stepper = scene.stepper(Adams);
    let mut alone = scene.stepper(Dopri5);
    let (mut now, mut expected) = (starts, starts);
    for _ in 0..20 {
        for (motion, expected) in now.iter_mut().zip(&mut expected) {
            let (past, before) = (*motion, *expected);
            stepper.step(&past, &Unloaded, 0.01, motion)?;
            alone.step(&before, &Unloaded, 0.01, expected)?;
        }
    }
    assert_eq!(now, expected);
    Ok(())
}

/// A motor that is switched between steps. Memory of the time before would leave an error of the size of a step.
#[test]
fn torques_may_jump_between_steps() -> Result<(), Error> {
    let scene = rods()?;
    let torque = |time: f64| if time < 0.4999 { 3.0 } else { -5.0 };
    let loads =
        |torque: f64| Loads::none().in_joints(move |_, k, _: &JointMotion<f64>| if k == 1 { torque } else { 0.0 });
    let half = |start: State, torque: f64, end: f64| {
        scene
            .simulation(Dop853::tolerance(1e-13))
            .loads(&loads(torque))
            .run(start, end, |_| ())
            .map(|run| run.motion)
            .map_err(Error::from)
    };
    let exact = half(half(scene.at_rest(&[-FRAC_PI_3; 2])?, 3.0, 0.5)?, -5.0, 1.0)?;
    let angles = [0, 1].map(|k| *scene.angles(&exact).unwrap().get(k).unwrap_or(&f64::NAN));
    let force = scene.stations(&exact, &loads(-5.0))?.root().internal.force;
    has_order_five("torques that jump", &[400, 800, 1600], |n| {
        let mut stepper = scene.stepper(Adams);
        let mut past = scene.at_rest(&[-FRAC_PI_3; 2])?;
        let mut next = past;
        for _ in 0..n {
            stepper.step(&past, &loads(torque(past.time())), f64::from(n).recip(), &mut next)?;
            core::mem::swap(&mut past, &mut next);
        }
        let found = scene.angles(&past).unwrap();
        let internal = scene.stations(&past, &loads(-5.0)).unwrap().root().internal.force;
        let largest = |of: &dyn Fn(usize) -> f64| of(0).abs().max(of(1).abs());
        Ok([largest(&|k| found.get(k).unwrap_or(&f64::NAN) - angles[k]), largest(&|k| internal[k] - force[k])])
    })
}

#[test]
fn error_control_follows_its_tolerance_with_few_sweeps() -> Result<(), Error> {
    let scene = rods()?;
    let start = scene.at_rest(&[-FRAC_PI_3; 2])?;
    let mut points = vec![];
    for tolerance in [1e-5, 1e-6, 1e-7, 1e-8, 1e-9] {
        let run = scene.simulate(start, Adams::tolerance(tolerance), 2.0, |_| ())?;
        let [angle, force] = errors(&scene, &run.motion, [ANGLES, ROOT_FORCE]);
        let (steps, rejected, sweeps) = (run.steps, run.rejected, run.sweeps);
        println!(
            "{tolerance:.0e}: {angle:.1e} rad, {force:.1e} N, {steps} steps, {rejected} rejected, {sweeps} sweeps"
        );
        assert!(rejected < steps / 3);
        points.push((tolerance, angle));
    }
    // The error of a step, of order 5 as the estimate is, is held at the tolerance while steps of h ~ tolerance^(1/5) leave h⁵.
    has_order("angles against tolerance", 1.0, FLOORS[0], &points);
    let other = scene.simulate(start, Dopri5::tolerance(1e-8), 2.0, |_| ())?;
    let own = scene.simulate(start, Adams::tolerance(1e-8), 2.0, |_| ())?;
    let [there, here] = [&other, &own].map(|run| errors(&scene, &run.motion, [ANGLES, ROOT_FORCE])[0]);
    println!("{here:.1e} rad in {} sweeps, Dopri5 {there:.1e} rad in {}", own.sweeps, other.sweeps);
    assert!(here < there && own.sweeps < other.sweeps);
    Ok(())
}

/// Between steps as good as at their ends, and events are found there.
#[test]
fn samples_and_events_have_order_five() -> Result<(), Error> {
    let scene = rods()?;
    let start = scene.at_rest(&[-FRAC_PI_3; 2])?;
    let mut exact = vec![];
    scene.simulation(Dop853::tolerance(1e-13)).every(0.137).run(start, 1.0, |now| {
        exact.push([0, 1].map(|k| *now.angles().get(k).unwrap_or(&f64::NAN)));
    })?;
    let rest = |n: u32| {
        let (mut worst, mut seen, mut event) = (0.0_f64, 0, f64::NAN);
        scene
            .simulation(Adams::step(f64::from(n).recip()))
            .every(0.137)
            .event(|now| now.motion().rate().1.1)
            .run(start, 1.0, |now| {
                if now.is_event() {
                    event = now.time();
                    return;
                }
                for (found, expected) in now.angles().iter().zip(exact[seen]) {
                    worst = worst.max((found - expected).abs());
                }
                seen += 1;
            })
            .map(|_| (worst, event))
            .map_err(Error::from)
    };
    let (_, expected) = rest(3000)?;
    let mut samples = vec![];
    let mut events = vec![];
    for n in [80, 160, 320] {
        let (worst, event) = rest(n)?;
        samples.push((f64::from(n).recip(), worst));
        events.push((f64::from(n).recip(), (event - expected).abs()));
    }
    has_order("samples", 5.0, FLOORS[0], &samples);
    println!("event at {expected} s, errors {events:?}");
    assert!(events[2].1 < 1e-9 && events[2].1 < 0.1 * events[0].1);
    Ok(())
}

/// A crank, a coupler and a rocker on two pins of the ground.
#[test]
fn held_tips_stay_closed_and_keep_the_order() -> Result<(), Error> {
    let rod = |length: f64| Rod::uniform(length, length);
    let chain = (rod(0.5), Pin, rod(1.2), Pin, rod(0.9));
    let scene = System::new(Pinned::origin(), chain, Pinned::at(1.0_f64, 0.0))?.with_gravity(9.81);
    let start = scene.assembled(scene.at_rest(&[1.0, 0.3, -1.9])?, &Unloaded)?;
    let exact = scene.simulate(start, Dop853::tolerance(1e-13), 1.0, |_| ())?.motion;
    let (mut angles, mut forces) = (vec![], vec![]);
    for n in [800, 1600, 3200] {
        let run = scene.simulate(start, Adams::step(f64::from(n).recip()), 1.0, |_| ())?;
        let tip = scene.body_motions(&run.motion)?.iter().last().map(|body| body.outboard().place);
        assert!(tip.is_some_and(|tip| (tip.x - 1.0).abs() < 1e-14 && tip.y.abs() < 1e-14));
        let pairs = scene.angles(&run.motion)?;
        let angle =
            pairs.iter().zip(scene.angles(&exact)?.iter()).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
        let pull = run.motion.multipliers().iter().zip(exact.multipliers());
        forces.push((f64::from(n).recip(), pull.fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()))));
        angles.push((f64::from(n).recip(), angle));
    }
    has_order("held tip, angles", 5.0, FLOORS[0], &angles);
    has_order("held tip, force", 5.0, FLOORS[1], &forces);
    Ok(())
}

/// The amplification of a vibration without damping has the modulus 1 − 2e-5 at ω ΔT = 0.5 and 1.002 at 0.8 (eigenvalues of its step,
/// found apart).
#[test]
fn vibration_dies_away_up_to_a_half_and_grows_beyond() -> Result<(), Error> {
    let flywheel = RigidBody::new(1.0, 0.5, [0.0; 2], [0.0; 2]);
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), (ElasticHinge::rotary(50.0), flywheel), Free)?; // ω = 10 rad/s
    let left = |share: f64| {
        let start = scene.at_rest(&[0.01])?;
        let run = scene.simulate(start, Adams::step(share / 10.0), 1000.0 * share / 10.0, |_| ())?;
        let energy: f64 = scene.budget(&run.motion).unwrap().energy();
        Ok::<_, Error>((2.0 * energy / 50.0).sqrt() / 0.01)
    };
    let (small, large) = (left(0.5)?, left(0.8)?);
    println!("amplitude after a thousand steps: {small:.4}, {large:.4}");
    assert!((small - (-1.612e-5_f64 * 1000.0).exp()).abs() < 2e-3);
    assert!((large.ln() / (1000.0 * 2.1322e-3) - 1.0).abs() < 0.05);
    Ok(())
}

#[test]
fn derivatives_run_with_it() -> Result<(), Error> {
    fn end<T: catena::Scalar<Real = f64>>(length: T) -> Result<T, Error> {
        let rod = Rod::uniform(length, T::one());
        let scene = System::new(Pinned::<[T; 2]>::origin(), (rod, Pin, rod), Free)?.with_gravity(T::literal(9.81));
        let start = scene.at_rest(&[T::literal(-1.0); 2])?;
        let run = scene.simulate(start, Adams::step(0.005), 1.0, |_| ())?;
        Ok(run.motion.position().1.1)
    }
    let dual = end(Dual64::new(1.0, 1.0))?;
    assert_eq!(dual.re, end(1.0)?);
    let difference = (end(1.0 + 1e-5)? - end(1.0 - 1e-5)?) / 2e-5;
    println!("{} against {difference}", dual.eps);
    near(dual.eps, difference, 1e-8 * difference.abs().max(1.0));
    Ok(())
}

/// A step far too long says so, and the motion before it is as it was.
#[test]
fn steps_that_fail_are_told_and_lose_nothing() -> Result<(), Error> {
    let scene = rods()?;
    let mut stepper = scene.stepper(Adams);
    let mut past = scene.at_rest(&[-1.0, -0.5])?;
    let mut next = past;
    for _ in 0..6 {
        stepper.step(&past, &Unloaded, 0.01, &mut next)?;
        core::mem::swap(&mut past, &mut next);
    }
    let before = past;
    let error = stepper
        .step(&past, &Unloaded, 1e200, &mut next)
        .err()
        .ok_or("a step of 1e200 s")
        .map_err(|_| catena::Error::new(catena::Fault::Shape))?;
    println!("{error}");
    assert!(error.time.is_some() && past == before);
    stepper.step(&past, &Unloaded, 0.01, &mut next)?;
    assert!(next.is_finite());
    Ok(())
}
