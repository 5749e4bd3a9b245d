//! Any bytes are a scene or a saved run that goes on soundly, or an error: as JSON, and in a format without names.
#![no_main]

#[path = "../scenes.rs"]
mod scenes;

use catena::planar::*;
use scenes::{ByAdams, ByVcabm, InSpace, Scene, in_plane};
use serde::de::DeserializeOwned;

/// Some steps of a run, each of which leads on to finite numbers.
macro_rules! steps {
    ($begun:expr) => {{
        let Ok(mut run) = $begun else { return };
        for _ in 0..3 {
            let time = run.motion().time();
            match run.step() {
                Ok(true) => assert!(run.motion().is_finite() && run.motion().time() > time),
                _ => return,
            }
        }
    }};
}

/// What both formats read.
fn read<X: DeserializeOwned>(bytes: &[u8], then: impl Fn(X)) {
    serde_json::from_slice(bytes).into_iter().for_each(&then);
    postcard::from_bytes(bytes).into_iter().for_each(&then);
}

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    read(bytes, |scene: Scene| steps!(scene.simulation(Dop853::tolerance(1e-6)).begin(scene.motion(), 1.0, |_| ())));
    read(bytes, |scene: InSpace| {
        steps!(scene.simulation(Dop853::tolerance(1e-6)).begin(scene.motion(), 1.0, |_| ()));
    });
    // Runs that were saved, or say so.
    let Ok(scene) = in_plane(2) else { return };
    read(bytes, |saved: ByAdams| steps!(scene.simulation(Adams::step(0.01)).every(0.1).resume(saved, 2.0, |_| ())));
    read(bytes, |saved: ByVcabm| {
        steps!(scene.simulation(Vcabm::new().tolerance(1e-6)).every(0.1).resume(saved, 2.0, |_| ()));
    });
});
