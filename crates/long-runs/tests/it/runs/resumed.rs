//! A run that is saved and resumed goes on bit by bit: what steppers carry from step to step, for every rule and kind of scene.

use catena::Error;
use catena::loading::Unloaded;
use catena::simulate::{Method, Now, Run, Stepper};
use catena::system::{Element, Space};
use catena::system::{MotionOf, Runs, System as Scene};
use catena::system::{Root, Tip};
use catena::time::Rule;
use std::fmt::Debug;
use std::mem::swap;
use std::ops::Range;

/// All numbers of a motion: `Debug` prints as many digits as tell each from all others, and the sign of zero.
fn bits(motion: &impl Debug) -> String {
    format!("{motion:?}")
}

/// Twelve steps and twelve more; the same with a stepper that the first one's memory is put into; and whether one that knows nothing
/// differs.
fn saved_and_resumed<S, R, C, P, M>(
    name: &str,
    scene: &Scene<S, R, C, P>,
    start: &MotionOf<S, R, C, P>,
    method: M,
    h: f64,
) -> Result<bool, Error>
where
    S: Space<Scalar = f64>,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    M: for<'s> Method<&'s Scene<S, R, C, P>, Unloaded> + Copy + Debug,
    Scene<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
{
    let steps = |stepper: &mut _, mut now: MotionOf<S, R, C, P>, range: Range<usize>| {
        let mut next = now.clone();
        for step in range {
            // Some steps are shorter, as a controller's may be.
            let h = if step % 5 == 4 { 0.7 * h } else { h };
            Stepper::<&Scene<S, R, C, P>, _>::advance(stepper, &now, &Unloaded, h, &mut next)?;
            swap(&mut now, &mut next);
        }
        Ok::<_, Error>(now)
    };
    let mut stepper = scene.stepper(method);
    let half = steps(&mut stepper, scene.with_accelerations(start.clone(), &Unloaded)?, 0..12)?;
    let memory = stepper.memory();
    let expected = bits(&steps(&mut stepper, half.clone(), 12..24)?);

    let mut other = scene.stepper(method);
    other.restore(&memory);
    assert_eq!(bits(&steps(&mut other, half.clone(), 12..24)?), expected, "{name}, {method:?}");

    let differs = bits(&steps(&mut scene.stepper(method), half, 12..24)?) != expected;
    println!("{name}, {method:?}: {}", if differs { "differs without memory" } else { "needs no memory" });
    Ok(differs)
}

/// The same by every rule: only those that remember motions differ without memory.
macro_rules! by_every_rule {
    ($name:expr, $scene:expr, $start:expr, $h:expr) => {
        assert!(!saved_and_resumed($name, &$scene, &$start, Rk4, $h)?);
        assert!(!saved_and_resumed($name, &$scene, &$start, Dopri5, $h)?);
        assert!(!saved_and_resumed($name, &$scene, &$start, Dop853, $h)?);
        assert!(saved_and_resumed($name, &$scene, &$start, Adams, $h)?);
        assert!(saved_and_resumed($name, &$scene, &$start, Vcabm::new().up_to(4), $h)?);
        assert!(saved_and_resumed($name, &$scene, &$start, GeneralizedAlpha::new(0.8), $h)?);
        assert!(!saved_and_resumed($name, &$scene, &$start, Sdirk4::new(), $h)?);
    };
}

/// A run, saved on its way and resumed by another one of the same rule, twice: the same end, samples, events and counters.
fn run_in_parts<S, R, C, P, M>(
    name: &str,
    scene: &Scene<S, R, C, P>,
    start: &MotionOf<S, R, C, P>,
    rule: Rule<M, f64>,
) -> Result<(), Error>
where
    S: Space<Scalar = f64>,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    M: for<'s> Method<&'s Scene<S, R, C, P>, Unloaded> + Copy + Debug,
    Scene<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
{
    const END: f64 = 0.5;
    type See<'a, S, R, C, P> = &'a mut dyn FnMut(&Now<'_, S, R, C, P, Unloaded>);
    let simulation = || {
        let half = scene.budget(start).unwrap().energy() - 0.1;
        let bound = move |now: &Now<'_, S, R, C, P, Unloaded>| now.budget().potential - half;
        scene.simulation(rule).every(0.03).event(bound)
    };
    let run = |see: See<'_, S, R, C, P>| simulation().run(start.clone(), END, see);
    let begin = |see: See<'_, S, R, C, P>| {
        let mut run = simulation().begin(start.clone(), END, see)?;
        run.until(0.4 * END)?;
        Ok::<_, Error>(run.save())
    };
    let (mut whole_seen, mut parts_seen) = (vec![], vec![]);
    let whole = run(&mut |now| whole_seen.push((now.is_event(), bits(now.motion()))))?;
    let mut note = |now: &Now<'_, S, R, C, P, Unloaded>| parts_seen.push((now.is_event(), bits(now.motion())));
    let saved = begin(&mut note)?;
    assert!(saved.motion.time() >= 0.4 * END && saved.motion.time() < END);
    let mut second = simulation().resume(saved, END, &mut note as See<'_, S, R, C, P>)?;
    second.until(0.7 * END)?;
    let saved = second.save();
    drop(second);
    let resumed = simulation().resume(saved, END, &mut note as See<'_, S, R, C, P>)?.finish()?;

    let Run { steps, rejected, sweeps, .. } = whole;
    println!("{name}, {rule:?}: {steps} steps, {rejected} rejected, {} instants", whole_seen.len());
    assert_eq!(bits(&resumed.motion), bits(&whole.motion), "{name}, {rule:?}");
    assert_eq!([resumed.steps, resumed.rejected, resumed.sweeps], [steps, rejected, sweeps], "{name}, {rule:?}");
    assert!(whole_seen == parts_seen && whole_seen.len() > 10, "{name}, {rule:?}");
    Ok(())
}

/// A run that is shown between its steps is the run that is not, and what is shown does not depend on what was shown before.
fn looked_at<S, R, C, P, M>(
    scene: &Scene<S, R, C, P>,
    start: &MotionOf<S, R, C, P>,
    rule: Rule<M, f64>,
) -> Result<(), Error>
where
    S: Space<Scalar = f64>,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    M: for<'s> Method<&'s Scene<S, R, C, P>, Unloaded> + Copy + Debug,
    Scene<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
{
    let shown = |every: f64| {
        let mut seen = vec![];
        let run = scene.simulation(rule).every(every).run(start.clone(), 0.5, |now| seen.push(bits(now.stepped())))?;
        Ok::<_, Error>((bits(&run.motion), seen))
    };
    let [(never, _), (often, all), (seldom, few)] = [shown(1.0)?, shown(0.00390625)?, shown(0.015625)?];
    assert!(often == never && seldom == never, "{rule:?}");
    assert!(all.iter().step_by(4).eq(&few) && few.len() == 33, "{rule:?}");
    Ok(())
}

/// By every rule, with fixed steps that no multiple of which is the end, and under error control.
macro_rules! parts_by_every_rule {
    ($name:expr, $scene:expr, $start:expr) => {
        run_in_parts($name, &$scene, &$start, Rk4::step(0.0023))?;
        run_in_parts($name, &$scene, &$start, Dopri5::step(0.0023))?;
        run_in_parts($name, &$scene, &$start, Dopri5::tolerance(1e-6))?;
        run_in_parts($name, &$scene, &$start, Dop853::step(0.0023))?;
        run_in_parts($name, &$scene, &$start, Dop853::tolerance(1e-9))?;
        run_in_parts($name, &$scene, &$start, Adams::step(0.0023))?;
        run_in_parts($name, &$scene, &$start, Adams::tolerance(1e-6))?;
        run_in_parts($name, &$scene, &$start, Vcabm::new().tolerance(1e-8))?;
        run_in_parts($name, &$scene, &$start, GeneralizedAlpha::new(0.8).step(0.0023))?;
        run_in_parts($name, &$scene, &$start, GeneralizedAlpha::new(0.8).tolerance(1e-4))?;
        run_in_parts($name, &$scene, &$start, Sdirk4::new().step(0.0023))?;
        run_in_parts($name, &$scene, &$start, Sdirk4::new().tolerance(1e-6))?;
    };
}

mod plane {
    use super::*;
    use catena::planar::*;

    #[test]
    fn series_go_on() -> Result<(), Error> {
        let rod = Rod::uniform(0.5, 1.0);
        let arm = Branch((ElasticHinge::rotary(20.0).damped(0.1), rod));
        let scene = System::new(Pinned::origin(), (rod, arm, Pin, rod), Free)?.with_gravity(9.81);
        let start = scene.at_rest(&[-1.0, 0.3, 0.2])?;
        assert!(!saved_and_resumed("series", &scene, &start, Taylor::<12>, 0.02)?);
        run_in_parts("series", &scene, &start, Taylor::<12>::step(0.02))?;
        run_in_parts("series", &scene, &start, Taylor::<12>::tolerance(1e-9))
    }

    #[test]
    fn steppers_go_on_in_open_chains() -> Result<(), Error> {
        let rod = Rod::uniform(0.5, 1.0);
        let hinge = ElasticHinge::rotary(20.0).damped(0.1);
        let slider = Slider::along(0.2).with(Spring::new(100.0));
        let scene = System::new(Pinned::origin(), (rod, Pin, rod, hinge, rod, slider, rod), Free)?.with_gravity(9.81);
        let start = scene.at_rest(&[-1.0, 0.3, 0.2])?;
        by_every_rule!("open, plane", scene, start, 0.005);
        parts_by_every_rule!("open, plane", scene, start);
        Ok(())
    }

    #[test]
    fn steppers_go_on_where_tips_are_held() -> Result<(), Error> {
        let rod = Rod::uniform(0.5, 1.0);
        let scene = System::new(Pinned::origin(), (rod, Pin, rod, Pin, rod), Pinned::at(1.0, 0.1))?.with_gravity(9.81);
        let start = scene.assembled(scene.at_rest(&[-1.0, 0.3, 1.2])?, &Unloaded)?;
        by_every_rule!("held, plane", scene, start, 0.005);
        parts_by_every_rule!("held, plane", scene, start);
        Ok(())
    }

    #[test]
    fn steppers_go_on_in_loops() -> Result<(), Error> {
        let rod = |length| Rod::uniform(length, length);
        let net = Network::new(
            (Pin, rod(0.5), Pin, rod(1.2)),
            (RigidBody::massless([1.0, 0.0]), Pin, rod(0.9)),
            LeastNorm(Pin),
        );
        let scene = System::new(Clamped::at(0.0, 0.0, 0.0), net, Free)?.with_gravity(9.81);
        let start = scene.assembled(scene.at_rest(&[1.0, 0.3, 1.1])?, &Unloaded)?;
        by_every_rule!("loop, plane", scene, start, 0.005);
        parts_by_every_rule!("loop, plane", scene, start);
        Ok(())
    }

    /// Under implicit rules these hinges read the inboard body's angular acceleration where the sweep before has found it.
    #[test]
    fn steppers_go_on_in_hinges_with_axes_that_do_not_turn() -> Result<(), Error> {
        let rod = Rod::uniform(0.5, 1.0);
        let spring = Spring::new(1e3).damped(1.0);
        let hinge = ElasticHinge::linear(spring, spring).in_fixed_axes();
        let scene = System::new(Pinned::origin(), (rod, hinge, rod), Free)?.with_gravity(9.81);
        let start = scene.at_rest(&[-1.0, 0.3])?;
        assert!(saved_and_resumed("fixed axes", &scene, &start, GeneralizedAlpha::new(0.8), 0.005)?);
        assert!(saved_and_resumed("fixed axes", &scene, &start, Sdirk4::new(), 0.005)?);
        assert!(!saved_and_resumed("fixed axes", &scene, &start, Dop853, 0.005)?);
        run_in_parts("fixed axes", &scene, &start, GeneralizedAlpha::new(0.8).step(0.007))?;
        run_in_parts("fixed axes", &scene, &start, Sdirk4::new().tolerance(1e-6))?;
        // Nor do looks between steps change these.
        looked_at(&scene, &start, GeneralizedAlpha::new(0.8).step(0.007))?;
        looked_at(&scene, &start, Sdirk4::new().tolerance(1e-6))
    }
}

mod space {
    use super::*;
    use catena::spatial::*;

    #[test]
    fn series_go_on() -> Result<(), Error> {
        let rod = Rod::uniform(0.5, 0.05, 1.0);
        let hinge = Revolute::about([0.1, 1.0, 0.2]).with(Spring::new(20.0).damped(0.1));
        let body = RigidBody::new(
            1.0,
            [[0.02, 0.0, 0.0], [0.0, 0.09, 0.01], [0.0, 0.01, 0.1]],
            [0.25, 0.03, 0.0],
            [0.5, 0.1, 0.0],
        );
        let scene = System::new(Pinned::origin(), (rod, Branch((hinge, body)), Ball, rod), Free)?;
        let scene = scene.with_gravity([0.0, 0.0, -9.81]);
        let start = scene.at_rest(&[0.1, -0.2, -1.0, 0.2, 0.3, 0.2, 0.2])?;
        assert!(!saved_and_resumed("series", &scene, &start, Taylor::<12>, 0.02)?);
        run_in_parts("series", &scene, &start, Taylor::<12>::step(0.02))?;
        run_in_parts("series", &scene, &start, Taylor::<12>::tolerance(1e-9))
    }

    #[test]
    fn steppers_go_on_in_open_chains() -> Result<(), Error> {
        let rod = Rod::uniform(0.5, 0.05, 1.0);
        let elastic = ElasticBall::rotary([20.0, 5.0, 20.0]).damped(0.01);
        let chain = (rod, Ball, rod, elastic, rod, Revolute::about([0.1, 1.0, 0.2]), rod);
        let scene = System::new(Free, chain, Free)?.with_gravity([0.0, 0.0, -9.81]);
        let start = scene.at_rest(&[0.1, -0.2, -1.0, 0.2, 0.3, 0.2, 0.2, 0.3, 0.25, 0.4])?;
        by_every_rule!("open, space", scene, start, 0.005);
        parts_by_every_rule!("open, space", scene, start);
        Ok(())
    }

    #[test]
    fn steppers_go_on_where_tips_are_held() -> Result<(), Error> {
        let rod = |length| Rod::uniform(length, 0.02, 1.0);
        let hinge = Hinged::at([0.0; 3], [0.0, 1.0, 0.2]);
        let scene = System::new(hinge, (rod(0.5), Ball, rod(0.8), Ball, rod(0.6)), Pinned::at([0.9, 0.1, -0.2]))?;
        let scene = scene.with_gravity([0.0, 0.0, -9.81]);
        let start = scene.assembled(scene.at_rest(&[1.2, 0.0, -0.64, -0.22, 2.2, 0.1, 0.2])?, &Unloaded)?;
        by_every_rule!("held, space", scene, start, 0.002);
        parts_by_every_rule!("held, space", scene, start);
        Ok(())
    }

    #[test]
    fn steppers_go_on_in_loops() -> Result<(), Error> {
        let rod = Rod::uniform(0.5, 0.01, 1.0);
        let swing = ClosedLoop::ending_at([0.8, 0.0, 0.0], (Ball, rod, Ball, rod, Ball, rod), Ball);
        let scene = System::new(Pinned::origin(), (rod, swing, Ball, rod), Free)?.with_gravity([0.0, -9.81, 0.0]);
        let mut angles = [0.1; 15];
        (angles[5], angles[8], angles[11]) = (-0.9, 0.0, 0.9);
        let start = scene.assembled(scene.at_rest(&angles)?, &Unloaded)?;
        by_every_rule!("loop, space", scene, start, 0.002);
        parts_by_every_rule!("loop, space", scene, start);
        Ok(())
    }
}
