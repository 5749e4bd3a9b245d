//! Any bytes are a scene or a saved run that goes on soundly, or an error: as JSON, and in a format without names.
#![no_main]

use catena::planar::*;
use catena::simulate::{AdamsMemory, Saved};
use catena::system::MotionOf;

type Chain = (Rod<f64>, Vec<(ElasticHinge<Spring<f64>>, RigidBody<f64>)>);
type Root = Pinned<[f64; 2]>;
type Scene = System<f64, Root, Chain, Free>;
type Moves = MotionOf<Planar<f64>, Root, Chain, Free>;
type Run = Saved<Moves, AdamsMemory<Moves>, f64>;

/// Some steps of a scene at rest.
fn falls(scene: &Scene) {
    let Ok(mut run) = scene.simulation(Dop853::tolerance(1e-6)).begin(scene.motion(), 1.0, |_| ()) else { return };
    for _ in 0..3 {
        let time = run.motion().time();
        match run.step() {
            Ok(true) => assert!(run.motion().is_finite() && run.motion().time() > time),
            _ => return,
        }
    }
}

/// Some steps of a run that was saved, or says so.
fn goes_on(saved: Run) {
    let body = RigidBody::new(1.0, 0.2, [0.5, 0.1], [1.0, 0.0]);
    let chain = (Rod::uniform(1.0, 1.0), vec![(ElasticHinge::rotary(5.0), body); 2]);
    let Ok(scene) = System::new(Pinned::origin(), chain, Free) else { return };
    let Ok(mut run) = scene.simulation(Adams::step(0.01)).every(0.1).resume(saved, 2.0, |_| ()) else { return };
    for _ in 0..3 {
        let time = run.motion().time();
        match run.step() {
            Ok(true) => assert!(run.motion().is_finite() && run.motion().time() > time),
            _ => return,
        }
    }
}

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    if let Ok(scene) = serde_json::from_slice::<Scene>(bytes) {
        falls(&scene);
    }
    if let Ok(scene) = postcard::from_bytes::<Scene>(bytes) {
        falls(&scene);
    }
    if let Ok(saved) = serde_json::from_slice::<Run>(bytes) {
        goes_on(saved);
    }
    if let Ok(saved) = postcard::from_bytes::<Run>(bytes) {
        goes_on(saved);
    }
});
