//! Chains of rods with other joints and ends than those of the main table: beside the pin chain with a free tip.

use crate::held_by_hand::Held;
use crate::scenes::{Case, Evaluated, GRAVITY, Link, Row, state};
use catena::internals::element::{Implicit, Reading};
use catena::loading::Unloaded;
use catena::planar::*;
use catena::system::StiffDynamics;
use catena::system::{Position, Rate};
use std::hint::black_box;

/// Stiffness of the rotary springs (N·m/rad).
const STIFFNESS: f64 = 20.0;
/// Damping (N·m·s/rad) and rest angle (rad) of those that have them.
const DAMPING: f64 = 0.01;
const REST: f64 = 0.1;
/// How springs enter a linearly implicit sweep of a step of 0.01 s.
const SPRINGS: Implicit<f64> = Implicit { position: 2.5e-5, rate: 5e-3 };

/// A scene for implicit sweeps.
struct Stiff<D: StiffDynamics<Unloaded>> {
    scene: D,
    position: D::Position,
    rate: D::Rate,
    workspace: D::StiffWorkspace,
    acceleration: D::Rate,
}

impl<D: StiffDynamics<Unloaded, Scalar = f64>> Stiff<D> {
    fn new(scene: D) -> Self {
        let still = scene.still();
        let (mut position, mut rate) = (still.position().clone(), still.rate().clone());
        let mut bodies = 0..;
        position.replace(&mut |_| state(bodies.next().unwrap_or(0)).0);
        let mut bodies = 0..;
        rate.replace(&mut |_| state(bodies.next().unwrap_or(0)).1);
        let workspace = scene.stiff_workspace();
        Self { scene, position, acceleration: rate.clone(), rate, workspace }
    }
}

/// One implicit sweep. Not inlined, so that nothing is known about the arguments.
#[inline(never)]
fn sweep_once<D: StiffDynamics<Unloaded, Scalar = f64>>(
    scene: &D,
    position: &D::Position,
    rate: &D::Rate,
    springs: Implicit<f64>,
    workspace: &mut D::StiffWorkspace,
    acceleration: &mut D::Rate,
) {
    let at = (position, rate);
    let reading = Reading { position, rate, acceleration: rate };
    scene.implicit_accelerations(0.0, at, at, reading, springs, &Unloaded, workspace, acceleration);
}

impl<D: StiffDynamics<Unloaded, Scalar = f64>> Case for Stiff<D> {
    fn sweep(&mut self, times: usize) {
        for _ in 0..times {
            let Self { scene, position, rate, workspace, acceleration } = black_box(&mut *self);
            sweep_once(scene, position, rate, black_box(SPRINGS), workspace, acceleration);
        }
    }
    fn accelerations(&self) -> Vec<f64> {
        let mut all = Vec::new();
        self.acceleration.visit(&mut |x| all.push(x));
        all
    }
}

/// A row: a chain on a wall, up to its tip, swept explicitly or implicitly.
macro_rules! row {
    ($scene:literal $form:literal $n:literal, $tip:expr, $kind:ident, |$link:ident| $chain:expr) => {
        Row {
            scene: $scene,
            form: $form,
            bodies: $n,
            make: || {
                let $link = <Rod<f64> as Link<f64>>::link($n);
                let scene = System::new(Clamped::at(0.0, 0.0, 0.0), $chain, $tip).unwrap().with_gravity(GRAVITY);
                Box::new(row!($kind scene))
            },
        }
    };
    (explicit $scene:ident) => {
        Evaluated::new($scene, Unloaded)
    };
    (implicit $scene:ident) => {
        Stiff::new($scene)
    };
}

/// A hinge with all that a rotary spring may have.
fn damped() -> ElasticHinge<Spring<f64, f64, f64>> {
    ElasticHinge::rotary(STIFFNESS).damped(DAMPING).resting_at(REST)
}

/// All rows.
pub fn rows() -> Vec<Row> {
    vec![
        row!("rotary springs" "array" 20, Free, explicit, |b| [(ElasticHinge::rotary(STIFFNESS), b); 20]),
        row!("rotary springs" "Vec" 1000, Free, explicit, |b| vec![(ElasticHinge::rotary(STIFFNESS), b); 1000]),
        row!("rotary springs, dampers, rests" "array" 20, Free, explicit, |b| [(damped(), b); 20]),
        row!("rotary springs, dampers, rests" "Vec" 1000, Free, explicit, |b| vec![(damped(), b); 1000]),
        row!("rotary springs, implicit" "array" 20, Free, implicit, |b| [(ElasticHinge::rotary(STIFFNESS), b); 20]),
        row!("rotary springs, implicit" "Vec" 1000, Free, implicit, |b| vec![(ElasticHinge::rotary(STIFFNESS), b); 1000]),
        row!("pinned tip" "array" 20, Pinned::at(0.3, 0.2), explicit, |b| [(Pin, b); 20]),
        Row { scene: "pinned tip", form: "by hand, arrays", bodies: 20, make: || Box::new(Held::<20>::rods()) },
        row!("pinned tip" "Vec" 1000, Pinned::at(0.3, 0.2), explicit, |b| vec![(Pin, b); 1000]),
    ]
}
