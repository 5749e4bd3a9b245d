//! Trees, loops and networks of rods: beside the pin chain with a free tip. What a sweep costs does not depend on whether loops are
//! closed where it takes place.

use crate::scenes::{Evaluated, GRAVITY, Link, Row};
use catena::loading::Unloaded;
use catena::planar::*;

/// A row: a chain on a wall with a free tip.
macro_rules! row {
    ($scene:literal $form:literal $n:literal, |$link:ident| $chain:expr) => {
        Row {
            scene: $scene,
            form: $form,
            bodies: $n,
            make: || {
                let $link = <Rod<f64> as Link<f64>>::link($n);
                let scene = System::new(Clamped::at(0.0, 0.0, 0.0), $chain, Free).unwrap().with_gravity(GRAVITY);
                Box::new(Evaluated::new(scene, Unloaded))
            },
        }
    };
}

/// Two rods beside one.
fn mesh<B: Copy>(b: B) -> Network<(Pin, B, Pin, B), (Pin, B), Pin> {
    Network::new((Pin, b, Pin, b), (Pin, b), Pin)
}

/// All rows.
pub fn rows() -> Vec<Row> {
    vec![
        // Nine rods in three arms on each tenth.
        row!("tree" "array" 20, |b| [(Pin, b, [Branch([(Pin, b); 3]); 3]); 2]),
        row!("tree" "Vec" 1000, |b| vec![(Pin, b, [Branch([(Pin, b); 3]); 3]); 100]),
        // Nineteen rods in an arm on each twentieth.
        row!("tree, long arms" "Vec" 1000, |b| vec![(Pin, b, Branch([(Pin, b); 19])); 50]),
        // An arm of eighty rods on each 125 of the trunk.
        row!("tree, longer arms" "Vec" 1025, |b| vec![(vec![(Pin, b); 125], Branch(vec![(Pin, b); 80])); 5]),
        row!("loops of three" "tuple" 3, |b| mesh(b)),
        row!("loops of three" "array" 30, |b| [mesh(b); 10]),
        row!("loops of three" "Vec" 30, |b| vec![mesh(b); 10]),
        row!("loops of three" "Vec" 300, |b| vec![mesh(b); 100]),
        row!("loops of three" "Vec" 3000, |b| vec![mesh(b); 1000]),
        row!("loops of three" "Vec" 30000, |b| vec![mesh(b); 10_000]),
        row!("loops closed by welds" "Vec" 3000, |b| {
            vec![Network::new((Pin, b, Pin, b), (Pin, b), Weld::at(0.1)); 1000]
        }),
        row!("four arms" "tuple" 8, |b| {
            let arm = (Pin, b, Pin, b);
            Network::new(Network::new(Network::new(arm, arm, Pin), arm, Pin), arm, Pin)
        }),
    ]
}
