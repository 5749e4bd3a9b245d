//! Scenes and saved runs from data that was spoilt: in a format with names, and in one without.

use crate::draws::cases;
use catena::planar::*;
use catena::simulate::{AdamsMemory, Saved, VcabmMemory};
use catena::system::{MotionOf, RateOf};
use catena::{Error, spatial};
use proptest::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::sync::LazyLock;

type Chain = (Rod<f64>, Vec<(ElasticHinge<Spring<f64>>, RigidBody<f64>)>);
type Root = Pinned<[f64; 2]>;
type Scene = System<f64, Root, Chain, Free>;
type Moves = MotionOf<Planar<f64>, Root, Chain, Free>;
type SavedAdams = Saved<Moves, AdamsMemory<Moves>, f64>;
type SavedVcabm = Saved<Moves, VcabmMemory<Moves, RateOf<Planar<f64>, Root, Chain>, f64>, f64>;
type Arm = (spatial::Rod<f64>, spatial::Ball, spatial::RigidBody<f64>, spatial::Revolute<f64>, spatial::Rod<f64>);
type InSpace =
    spatial::System<f64, spatial::Clamped<[f64; 3], spatial::Rotation<f64>>, (spatial::Weld<f64>, Arm), spatial::Free>;

/// Values in both formats.
struct Written {
    text: String,
    bytes: Vec<u8>,
}

impl Written {
    fn of(value: &impl Serialize) -> Self {
        Self { text: serde_json::to_string(value).unwrap(), bytes: postcard::to_allocvec(value).unwrap() }
    }
}

/// A scene, runs of it saved by Adams and Vcabm, and a scene in space.
static WRITTEN: LazyLock<[Written; 4]> = LazyLock::new(|| {
    let make = || -> Result<[Written; 4], Error> {
        let scene = scene()?;
        let start = || scene.at_rest(&[0.1, -0.3, 0.4]);
        let mut adams = scene.simulation(Adams::tolerance(1e-6)).every(0.1).begin(start()?, 2.0, |_| ())?;
        let mut vcabm = scene.simulation(Vcabm::new().tolerance(1e-6)).every(0.1).begin(start()?, 2.0, |_| ())?;
        adams.until(1.0)?;
        vcabm.until(1.0)?;
        let rod = spatial::Rod::uniform(1.0, 0.1, 1.0);
        let body =
            spatial::RigidBody::new(1.0, [[0.2, 0.0, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.4]], [0.1; 3], [0.5; 3]);
        let turned = spatial::Rotation::from_angles([0.1, 0.2, 0.3]);
        let arm = (rod, spatial::Ball, body, spatial::Revolute::about([1.0, 2.0, 3.0]), rod);
        let root = spatial::Clamped::on([0.0; 3], turned);
        let space = spatial::System::new(root, (spatial::Weld::at(turned), arm), spatial::Free)?;
        Ok([
            Written::of(&scene),
            Written::of(&adams.save()),
            Written::of(&vcabm.save()),
            Written::of(&space.with_gravity([0.0, -9.81, 0.0])),
        ])
    };
    make().unwrap()
});

fn scene() -> Result<Scene, Error> {
    let body = RigidBody::new(1.0, 0.2, [0.5, 0.1], [1.0, 0.0]);
    Ok(System::new(Pinned::origin(), (Rod::uniform(1.0, 1.0), vec![(ElasticHinge::rotary(5.0), body); 2]), Free)?
        .with_gravity(9.81))
}

/// What puts readers to the test.
const PIECES: [&str; 22] = [
    "null",
    "-1",
    "0",
    "1e308",
    "-1e308",
    "1e-320",
    "1e999",
    "18446744073709551615",
    "4294967296",
    "13",
    "2.5",
    "[]",
    "{}",
    "\"\"",
    "true",
    ",",
    "}",
    "[[[[",
    "-0.0",
    "1",
    "7",
    "\"Fixed\"",
];

/// A text whose numbers and signs are others.
fn spoilt(text: &str, changes: &[(prop::sample::Index, usize, usize)]) -> String {
    let mut text = text.to_owned();
    for (at, length, piece) in changes {
        let places: Vec<_> = text.match_indices([':', ',', '[']).map(|(at, _)| at + 1).collect();
        let Some(from) = places.get(at.index(places.len().max(1))).copied() else { break };
        // Mostly one number, whole.
        let end = match length {
            0..8 => text[from..].find([',', ']', '}']).map_or(text.len(), |end| from + end),
            more => text.len().min(from + more),
        };
        let end = (end..=text.len()).find(|end| text.is_char_boundary(*end)).unwrap_or(from);
        text.replace_range(from..end, PIECES[*piece]);
    }
    text
}

/// What is read from either format.
fn both<X: DeserializeOwned>(text: &str, bytes: &[u8]) -> Vec<X> {
    let (text, bytes) = (serde_json::from_str(text), postcard::from_bytes(bytes));
    if let Err(error) = &text {
        assert!(!error.to_string().is_empty());
    }
    text.into_iter().chain(bytes).collect()
}

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn spoilt_data_is_refused_or_runs(
        changes in prop::collection::vec((any::<prop::sample::Index>(), 0..24_usize, 0..PIECES.len()), 1..4),
        flips in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..4),
    ) {
        let unspoilt = scene().unwrap();
        for (which, Written { text, bytes }) in WRITTEN.iter().enumerate() {
            let text = spoilt(text, &changes);
            let mut bytes = bytes.clone();
            for (at, byte) in &flips {
                let at = at.index(bytes.len());
                bytes[at] = *byte;
            }
            match which {
                0 => for scene in both::<Scene>(&text, &bytes) {
                    run!(scene, Dop853::tolerance(1e-6), scene.motion(), 1.0, 0.1);
                },
                1 => for saved in both::<SavedAdams>(&text, &bytes) {
                    go_on!(unspoilt, Adams::tolerance(1e-6), saved.clone());
                    go_on!(unspoilt, Adams::step(0.01), saved);
                },
                2 => for saved in both::<SavedVcabm>(&text, &bytes) {
                    go_on!(unspoilt, Vcabm::new().tolerance(1e-6), saved.clone());
                    go_on!(unspoilt, Vcabm::new().step(0.01), saved);
                },
                _ => for scene in both::<InSpace>(&text, &bytes) {
                    run!(scene, Dop853::tolerance(1e-6), scene.motion(), 1.0, 0.1);
                },
            }
        }
    }
}
