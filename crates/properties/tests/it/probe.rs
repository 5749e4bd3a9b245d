//! What is tried with a scene that was made of anything.

use catena::Error;

/// So many steps of a run are made.
pub const STEPS: usize = 12;

/// An error says something, and is equal to itself where its numbers are.
pub fn told(error: &Error) {
    let text = error.to_string();
    assert!(text.len() > 10, "{text}");
}

/// An interval between samples that makes some thousand of them: a run may have up to 1e11, which take hours, as its limit says. What is beyond
/// that is left to be refused.
pub fn apart(every: f64, end: f64) -> f64 {
    if every > 0.0 && end / every < 2e11 { every.max(end / 2e3) } else { every }
}

/// Makes some steps of a run: each ends later, with finite numbers, or is refused.
macro_rules! run {
    ($scene:expr, $rule:expr, $start:expr, $end:expr, $every:expr) => {{
        let mut last = $start.time();
        let simulation = $scene.simulation($rule).every($crate::probe::apart($every, $end));
        match simulation.begin($start.clone(), $end, |now| assert!(now.motion().time().is_finite())) {
            Err(refused) => $crate::probe::told(&refused.error),
            Ok(mut run) => {
                for _ in 0..$crate::probe::STEPS {
                    match run.step() {
                        Ok(false) => break,
                        Ok(true) => {
                            let motion = run.motion();
                            assert!(motion.is_finite() && motion.time() > last && motion.time() <= $end);
                            last = motion.time();
                        }
                        Err(error) => {
                            $crate::probe::told(&error);
                            assert!(run.motion().is_finite(), "{error}");
                            break;
                        }
                    }
                }
            }
        }
    }};
}

/// Goes on with a run that may never have been one.
macro_rules! go_on {
    ($scene:expr, $rule:expr, $saved:expr) => {{
        let saved = $saved;
        let (mut last, mut shown) = (saved.motion.time(), 0);
        match $scene.simulation($rule).every(0.1).resume(saved, 2.0, |_| shown += 1) {
            Err(refused) => $crate::probe::told(&refused.error),
            Ok(mut run) => {
                for _ in 0..$crate::probe::STEPS {
                    match run.step() {
                        Ok(false) => break,
                        Ok(true) => {
                            let motion = run.motion();
                            assert!(motion.is_finite() && motion.time() > last && motion.time() <= 2.0);
                            last = motion.time();
                        }
                        Err(error) => {
                            $crate::probe::told(&error);
                            break;
                        }
                    }
                }
            }
        }
        assert!(shown <= 100, "{shown} samples of a tenth of a second");
    }};
}

/// Sets a scene in motion by anything, reads it, and runs it by some rules.
macro_rules! probe {
    ($made:expr, $numbers:expr, $gravity:expr, $end:expr, $every:expr, [$($rule:expr),*]) => {
        match $made {
            Err(error) => $crate::probe::told(&error),
            Ok(scene) => {
                let (scene, numbers) = (scene.with_gravity($gravity), $numbers);
                let mut motion = scene.motion();
                let places = motion.coordinates().len();
                let rates = motion.rates().len();
                let set = motion
                    .set_coordinates(&numbers[..places])
                    .and_then(|()| motion.set_rates(&numbers[places..places + rates]));
                if let Err(error) = set {
                    $crate::probe::told(&error);
                }
                scene.describe().to_string();
                scene.doubts(|doubt| $crate::probe::told(&doubt));
                match scene.with_accelerations(motion.clone(), &Unloaded) {
                    Err(error) => $crate::probe::told(&error),
                    Ok(moving) => {
                        assert!(moving.is_finite());
                        if let Err(error) = scene.stations(&moving, &Unloaded) {
                            $crate::probe::told(&error);
                        }
                        if let Err(error) = scene.budget(&moving) {
                            $crate::probe::told(&error);
                        }
                        $(run!(scene, $rule, motion, $end, $every);)*
                    }
                }
            }
        }
    };
}
