//! The scenes: chains of one kind of body and pins, built with the library and by hand.

use crate::by_hand;
use crate::system_sine::SystemSine;
use catena::internals::planar::Body;
use catena::loading::Unloaded;
use catena::planar::*;
use catena::scalar::Scalar;
use catena::system::Dynamics;
use catena::system::{Position, Rate};
use num_traits::Zero;
use std::hint::black_box;

/// A scene in one form, ready to be swept.
pub trait Case {
    /// Sweeps again and again.
    fn sweep(&mut self, times: usize);
    /// The accelerations that the last sweep found.
    fn accelerations(&self) -> Vec<f64>;
    /// What they leave of the equations of motion by an independent reckoning, where nothing by hand compares: as a multiple of
    /// what a change of their last digits makes of it.
    fn residual(&self) -> Option<f64> {
        None
    }
}

/// A row of the table.
pub struct Row {
    pub scene: &'static str,
    pub form: &'static str,
    /// Number of bodies.
    pub bodies: usize,
    pub make: fn() -> Box<dyn Case>,
}

impl Row {
    /// Its name on the command line.
    pub fn name(&self) -> String {
        format!("{}/{}/{}", self.scene, self.form, self.bodies).replace(' ', "-")
    }
    /// Whether the library does not take part in it.
    pub fn is_by_hand(&self) -> bool {
        self.form.starts_with("by hand")
    }
    /// The row of rods, pins and a free tip in the same form.
    pub fn pins<'r>(&self, rows: &'r [Row]) -> Option<&'r Row> {
        rows.iter().find(|row| row.scene == "rods" && row.bodies == self.bodies && row.form == self.form)
    }
    /// The row by hand to which this one compares: lengths known to the compiler, or slices.
    pub fn yardstick<'r>(&self, rows: &'r [Row]) -> Option<&'r Row> {
        let form = if matches!(self.form, "Vec" | "by hand, slices") { "by hand, slices" } else { "by hand, arrays" };
        rows.iter().find(|row| row.scene == self.scene && row.bodies == self.bodies && row.form == form)
    }
}

pub const GRAVITY: f64 = 9.81;
const DAMPING: f64 = 0.02;

/// The state of body i: folded and turning, nothing special.
pub fn state(i: usize) -> (f64, f64) {
    let i = i as f64;
    (-0.3 + 0.5 * i.sin(), 0.5 * i.cos())
}

/// A scene at one motion, evaluated by the library.
pub struct Evaluated<D: Dynamics<L>, L> {
    scene: D,
    loads: L,
    pub position: D::Position,
    pub rate: D::Rate,
    workspace: D::Workspace,
    acceleration: D::Rate,
}

impl<T: Scalar<Real = f64>, L, D: Dynamics<L, Scalar = T>> Evaluated<D, L> {
    pub fn new(scene: D, loads: L) -> Self {
        Self::of(scene, loads, (0..).map(|i| state(i).0), (0..).map(|i| state(i).1))
    }

    /// With the numbers of all positions and rates, from the root on.
    pub fn at(scene: D, loads: L, positions: &[f64], rates: &[f64]) -> Self {
        Self::of(scene, loads, positions.iter().copied(), rates.iter().copied())
    }

    fn of(scene: D, loads: L, positions: impl Iterator<Item = f64>, rates: impl Iterator<Item = f64>) -> Self {
        let still = scene.still();
        let (mut position, mut rate) = (still.position().clone(), still.rate().clone());
        let (mut positions, mut rates) = (positions, rates);
        let number = |next: Option<f64>| T::constant(next.unwrap_or(f64::NAN));
        position.replace(&mut |_| number(positions.next()));
        rate.replace(&mut |_| number(rates.next()));
        let workspace = scene.workspace();
        Self { scene, loads, position, acceleration: rate.clone(), rate, workspace }
    }
}

/// One sweep. Not inlined, so that nothing is known about the arguments.
#[inline(never)]
fn sweep_once<D: Dynamics<L, Scalar: Scalar<Real = f64>>, L>(
    scene: &D,
    time: f64,
    position: &D::Position,
    rate: &D::Rate,
    loads: &L,
    workspace: &mut D::Workspace,
    acceleration: &mut D::Rate,
) {
    scene.accelerations(time, position, rate, loads, workspace, acceleration);
}

impl<T: Scalar<Real = f64>, L, D: Dynamics<L, Scalar = T>> Case for Evaluated<D, L> {
    fn sweep(&mut self, times: usize) {
        for _ in 0..times {
            let Self { scene, loads, position, rate, workspace, acceleration } = black_box(&mut *self);
            sweep_once(scene, black_box(0.0), position, rate, loads, workspace, acceleration);
        }
    }
    fn accelerations(&self) -> Vec<f64> {
        let mut all = Vec::new();
        self.acceleration.visit(&mut |x| all.push(x.real()));
        all
    }
}

impl<S: by_hand::Scene, V: Clone + AsRef<[f64]> + AsMut<[f64]>> Case for by_hand::Chain<S, V> {
    fn sweep(&mut self, times: usize) {
        for _ in 0..times {
            black_box(&mut *self).sweep();
        }
    }
    fn accelerations(&self) -> Vec<f64> {
        self.acceleration.as_ref().to_vec()
    }
}

/// A kind of body: link i of n, its share of a chain of length 1 m and mass 1 kg.
pub trait Link<T>: Sized {
    fn link(n: usize) -> Self;
}

impl<T: Scalar<Real = f64>> Link<T> for Rod<T> {
    fn link(n: usize) -> Self {
        let share = T::constant(1.0 / n as f64);
        Self::uniform(share, share)
    }
}

/// Mass centre and outboard end of the general body, as shares of 1/n.
const CENTRE: [f64; 2] = [0.4, 0.1];
const OUTBOARD: [f64; 2] = [0.8, -0.3];

impl<T: Scalar<Real = f64>> Link<T> for RigidBody<T> {
    fn link(n: usize) -> Self {
        let h = 1.0 / n as f64;
        let scaled = |v: [f64; 2]| v.map(|x| T::constant(x * h));
        Self::new(T::constant(h), T::constant(0.1 * h * h * h), scaled(CENTRE), scaled(OUTBOARD))
    }
}

impl<T: Scalar<Real = f64>> Link<T> for PointMass<T> {
    fn link(n: usize) -> Self {
        let share = T::constant(1.0 / n as f64);
        Self::new(share, share)
    }
}

/// The base parameters of a body: length and direction of its arm in its own axes, masses lumped at its ends, J′, and
/// the first moment beside the arm, per length.
struct Base {
    length: f64,
    direction: f64,
    inner: f64,
    outer: f64,
    inertia: f64,
    beside: f64,
}

impl Base {
    fn of(body: &impl Body<f64>) -> Self {
        let Inertia { mass, centre: [x, y], about_centre } = body.inertia();
        let [arm_x, arm_y] = body.outboard();
        let square = arm_x * arm_x + arm_y * arm_y;
        let along = mass * (x * arm_x + y * arm_y);
        let outer = along / square;
        let beside = mass * (y * arm_x - x * arm_y) / square;
        let inertia = about_centre + mass * (x * x + y * y) - along;
        Self { length: square.sqrt(), direction: arm_y.atan2(arm_x), inner: mass - outer, outer, inertia, beside }
    }
}

/// The chain of n equal bodies by hand. The angle of a body is that of its arm.
fn lumped<S: by_hand::Scene, V>(zero: &V, n: usize, body: &impl Body<f64>) -> by_hand::Chain<S, V>
where
    V: Clone + AsRef<[f64]> + AsMut<[f64]>,
{
    let base = Base::of(body);
    let mut chain = by_hand::Chain::new(zero);
    chain.gravity = GRAVITY;
    chain.damping = DAMPING / n as f64;
    chain.tip = base.outer;
    chain.length.as_mut().fill(base.length);
    chain.inertia.as_mut().fill(base.inertia);
    chain.mass.as_mut().fill(base.inner + base.outer);
    chain.beside.as_mut().fill(base.beside);
    for i in 0..n {
        chain.angle.as_mut()[i] = state(i).0 + base.direction;
        chain.rate.as_mut()[i] = state(i).1;
    }
    chain
}

/// What acts on the chains besides gravity.
macro_rules! loads {
    (none, $n:expr) => {
        Unloaded
    };
    (torques, $n:expr) => {{
        let damping = DAMPING / $n as f64;
        Loads::none().in_joints(move |_, _, motion: &JointMotion<f64>| -(damping * motion.rate()))
    }};
    (forces, $n:expr) => {{
        let (damping, end) = (DAMPING / $n as f64, [1.0 / $n as f64, 0.0]);
        Loads::none().on_bodies(move |_, _, motion: &BodyMotion<f64>| {
            let velocity = motion.point(end).velocity;
            motion.force_at(end, [-(damping * velocity.x), -(damping * velocity.y)])
        })
    }};
}

/// A row of the library: the chain is an expression in `link`, the body. A chain of links that start with their pin hangs from
/// a wall, any other one from a pin.
macro_rules! row {
    ($scene:literal $form:literal $n:literal, $T:ident $Body:ident $loads:ident, |$link:ident| $chain:expr) => {
        row!($scene $form $n, $T $Body $loads, Pinned::<[$T; 2]>::origin(), |$link| $chain)
    };
    ($scene:literal $form:literal $n:literal, $T:ident $Body:ident $loads:ident, wall, |$link:ident| $chain:expr) => {
        row!($scene $form $n, $T $Body $loads, Clamped::at($T::zero(), $T::zero(), $T::zero()), |$link| $chain)
    };
    ($scene:literal $form:literal $n:literal, $T:ident $Body:ident $loads:ident, $root:expr, |$link:ident| $chain:expr) => {
        Row {
            scene: $scene,
            form: $form,
            bodies: $n,
            make: || {
                let $link = <$Body<$T> as Link<$T>>::link($n);
                let scene = System::new($root, $chain, Free).unwrap();
                Box::new(Evaluated::new(scene.with_gravity($T::constant(GRAVITY)), loads!($loads, $n)))
            },
        }
    };
}

macro_rules! row_by_hand {
    ($scene:literal $form:literal $n:literal, $Body:ident $Scene:ident, $zero:expr) => {
        Row {
            scene: $scene,
            form: $form,
            bodies: $n,
            make: || Box::new(lumped::<$Scene, _>(&$zero, $n, &<$Body<f64> as Link<f64>>::link($n))),
        }
    };
}

/// All rows of a kind of scene.
macro_rules! scenes {
    ($($scene:literal: $T:ident $Body:ident $loads:ident $Scene:ident { $($flags:tt)* })*) => {
        $(
            struct $Scene;
            impl by_hand::Scene for $Scene { $($flags)* }
        )*

        /// All rows of the table.
        pub fn rows() -> Vec<Row> {
            vec![$(
                row!($scene "tuple" 2, $T $Body $loads, |b| (b, Pin, b)),
                row_by_hand!($scene "by hand, arrays" 2, $Body $Scene, [0.0; 2]),
                row!($scene "tuple" 20, $T $Body $loads, |b| {
                    let four = (Pin, b, Pin, b, Pin, b, Pin, b);
                    ((b, Pin, b, Pin, b, Pin, b), four, four, four, four)
                }),
                row!($scene "array" 20, $T $Body $loads, wall, |b| [(Pin, b); 20]),
                row_by_hand!($scene "by hand, arrays" 20, $Body $Scene, [0.0; 20]),
                row!($scene "Vec" 20, $T $Body $loads, wall, |b| vec![(Pin, b); 20]),
                row_by_hand!($scene "by hand, slices" 20, $Body $Scene, vec![0.0; 20]),
                row!($scene "Vec" 1000, $T $Body $loads, wall, |b| vec![(Pin, b); 1000]),
                row_by_hand!($scene "by hand, slices" 1000, $Body $Scene, vec![0.0; 1000]),
                row!($scene "Vec" 100_000, $T $Body $loads, wall, |b| vec![(Pin, b); 100_000]),
                row_by_hand!($scene "by hand, slices" 100_000, $Body $Scene, vec![0.0; 100_000]),
            )*]
        }
    };
}

scenes! {
    "rods": f64 Rod none Rods {}
    "rigid bodies": f64 RigidBody none RigidBodies { const OFF_AXIS: bool = true; }
    "point masses": f64 PointMass none PointMasses { const INERTIA: bool = false; }
    "rods, torques": f64 Rod torques RodsTorques { const TORQUES: bool = true; }
    "rods, forces": f64 Rod forces RodsForces { const FORCES: bool = true; }
    "rods, system sine": SystemSine Rod none RodsSystemSine { const SYSTEM_SINE: bool = true; }
}
