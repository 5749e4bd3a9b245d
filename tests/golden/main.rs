//! Golden bits: positions, rates, accelerations and forces of scenes of every kind, after a run, bit by bit as they were recorded.
//!
//! A change of form must leave them as they are. A change of results is recorded anew, `GOLDEN=record cargo test --test golden`,
//! and the commit names the scenes that changed, and why. Bits are those of targets without fused multiply-add; on others nothing is
//! compared.

/// Runs a scene, and records how it ends. What is done with these scenes is said here, so that they serve other tests, too.
macro_rules! golden {
    ($record:ident, $name:literal, $scene:expr, $start:expr, $rule:expr, $end:expr) => {
        golden!($record, $name, $scene, $start, $rule, $end, &Unloaded)
    };
    ($record:ident, $name:literal, $scene:expr, $start:expr, $rule:expr, $end:expr, $loads:expr) => {{
        let (scene, loads) = (&$scene, $loads);
        let motion = scene.simulation($rule).loads(loads).run($start, $end, |_| ())?.motion;
        let stations = scene.stations(&motion, loads).unwrap();
        $record.add($name, &motion, stations.iter().flat_map($crate::record::Internal::numbers).collect());
    }};
}

/// States, which hold forces, of a formulation whose runs have no motion.
macro_rules! golden_states {
    ($record:ident, $name:literal, $made:expr, $began:expr, |$scene:ident, $start:ident| $states:block) => {{
        let ($scene, $start) = (&$made, &$began);
        $record.add_numbers($name, $states);
    }};
}

mod plane;
mod record;
mod space;

use record::Record;
use std::error::Error;
use std::path::Path;

#[test]
fn motions_and_forces_keep_their_bits() -> Result<(), Box<dyn Error>> {
    let mut record = Record::default();
    plane::record(&mut record)?;
    space::record(&mut record)?;
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/bits.txt");
    if std::env::var_os("GOLDEN").is_some_and(|wish| wish == "record") {
        std::fs::write(file, record.text())?;
        return Ok(());
    }
    if cfg!(target_feature = "fma") || !cfg!(all(target_arch = "x86_64", target_os = "linux")) {
        println!("not compared: bits are those of x86-64 without fused multiply-add");
        return Ok(());
    }
    let differences = record.differences(&std::fs::read_to_string(file)?);
    println!("{} scenes", record.len());
    assert!(record.len() >= 20 && differences.is_empty(), "{}", differences.join("\n"));
    Ok(())
}
