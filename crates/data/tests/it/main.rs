//! Scenes, motions and saved runs as data.

/// Writes a scene, its rule and a run that stands in the middle, reads them, and compares how that run ends with how it would have.
macro_rules! golden {
    ($record:ident, $name:literal, $scene:expr, $start:expr, $rule:expr, $end:expr) => {
        golden!($record, $name, $scene, $start, $rule, $end, &Unloaded)
    };
    ($record:ident, $name:literal, $scene:expr, $start:expr, $rule:expr, $end:expr, $loads:expr) => {{
        let (scene, start, loads) = (&$scene, $start, $loads);
        for read in $crate::record::read(scene) {
            golden!(run $record, $name, scene, read, start.clone(), $rule, $end, loads);
        }
    }};
    (run $record:ident, $name:literal, $scene:expr, $read:expr, $start:expr, $rule:expr, $end:expr, $loads:expr) => {{
        let (start, rule) = ($start, $rule);
        let whole = $scene.simulation(rule).loads($loads).run(start.clone(), $end, |_| ())?.motion;
        for start in $crate::record::read(&start) {
            let mut run = $scene.simulation(rule).loads($loads).begin(start, $end, |_| ())?;
            run.until(0.5 * $end)?;
            for saved in $crate::record::read(&run.save()) {
                for rule in $crate::record::read(&rule) {
                    let resumed = $read.simulation(rule).loads($loads).resume(saved.clone(), $end, |_| ())?.finish()?;
                    $crate::record::same($name, &resumed.motion, &whole);
                    $record.resumed += 1;
                }
            }
        }
        $record.scenes.insert($name);
    }};
}

/// The same of a formulation whose runs are not saved: the scene and its start are read, and run from the beginning.
macro_rules! golden_states {
    ($record:ident, $name:literal, $made:expr, $began:expr, |$scene:ident, $start:ident| $states:block) => {{
        let ($scene, $start) = (&$made, &$began);
        let whole: Vec<f64> = $states;
        for read in $crate::record::read($scene) {
            for began in $crate::record::read($start) {
                let ($scene, $start) = (&read, &began);
                let states: Vec<f64> = $states;
                $crate::record::same($name, &states, &whole);
                $record.resumed += 1;
            }
        }
        $record.scenes.insert($name);
    }};
}

mod changed;
mod goes_on;
#[path = "../../../../tests/golden/plane.rs"]
mod plane;
mod record;
mod refused;
#[path = "../../../../tests/golden/space.rs"]
mod space;
mod words;

use std::collections::BTreeSet;

#[test]
fn runs_go_on_from_what_was_written_bit_by_bit() -> Result<(), catena::Error> {
    let mut record = record::Record::default();
    plane::record(&mut record)?;
    space::record(&mut record)?;
    println!("{} scenes, {} runs resumed", record.scenes.len(), record.resumed);
    // All of those whose bits are recorded.
    let recorded = include_str!("../../../../tests/golden/bits.txt").lines().filter_map(|line| line.rsplit_once(", "));
    let recorded: BTreeSet<_> = recorded.map(|(name, _)| name).collect();
    assert_eq!(record.scenes, recorded);
    Ok(())
}
