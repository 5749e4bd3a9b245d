//! The scenes in space: chains of one kind of body and one kind of joint, bent and moving. What checks them is inverse dynamics.

use crate::inverse::{self, Joint};
use crate::scenes::{Case, Evaluated, GRAVITY, Row};
use catena::internals::spatial::Body;
use catena::loading::Unloaded;
use catena::spatial::*;
use catena::system::Dynamics;
use catena::system::{Position, Rate};

/// A scene with its accelerations checked.
struct Checked<D: Dynamics<Unloaded>> {
    scene: Evaluated<D, Unloaded>,
    body: inverse::Body,
    joints: Vec<Joint>,
}

impl<D: Dynamics<Unloaded, Scalar = f64>> Case for Checked<D> {
    fn sweep(&mut self, times: usize) {
        self.scene.sweep(times);
    }
    fn accelerations(&self) -> Vec<f64> {
        self.scene.accelerations()
    }
    fn residual(&self) -> Option<f64> {
        let (mut position, mut rate) = (Vec::new(), Vec::new());
        self.scene.position.visit(&mut |x| position.push(x));
        self.scene.rate.visit(&mut |x| rate.push(x));
        let moments = |second: &[f64]| inverse::moments(&self.body, &self.joints, GRAVITY, &position, &rate, second);
        let found = self.scene.accelerations();
        let rounded = |(i, x): (usize, &f64)| x * (1.0 + f64::EPSILON * (12.9898 * i as f64).sin());
        let rounded: Vec<f64> = found.iter().enumerate().map(rounded).collect();
        let (left, rounded) = (moments(&found), moments(&rounded));
        let largest = |size: f64, x: f64| size.max(x.abs());
        let noise = left.iter().zip(&rounded).map(|(x, y)| x - y).fold(f64::MIN_POSITIVE, largest);
        let sum: f64 = left.iter().sum(); // not a number where one of them is not
        Some(left.iter().copied().fold(0.0, largest) / noise + 0.0 * sum)
    }
}

/// Coordinates of joint i.
fn position(joint: Joint, i: usize) -> Vec<f64> {
    let x = i as f64;
    match joint {
        Joint::Ball => {
            let angles = [0.7 * (1.3 * x).sin(), 0.6 * (0.7 * x).cos(), -0.3 + 0.5 * x.sin()];
            Rotation::from_angles(angles).quaternion().to_vec()
        }
        Joint::Revolute(_) => vec![-0.3 + 0.5 * x.sin()],
    }
}

/// Rates of joint i. Those of revolute joints add up along the chain, and come and go.
fn rate(joint: Joint, i: usize) -> Vec<f64> {
    let x = i as f64;
    match joint {
        Joint::Ball => vec![0.8 * (0.9 * x).cos(), 0.4 * (1.7 * x).sin(), 0.5 * x.cos()],
        Joint::Revolute(_) => vec![0.5 * (2.0 * x).cos()],
    }
}

/// The axis of revolute joint i: no two that follow each other are parallel.
fn axis(i: usize) -> [f64; 3] {
    let x = i as f64;
    [0.4 * (1.1 * x).sin(), 0.8 * (2.3 * x).cos(), 1.0]
}

fn revolute(i: usize) -> Revolute<f64> {
    Revolute::about(axis(i))
}

fn case<D: Dynamics<Unloaded, Scalar = f64> + 'static>(
    scene: D,
    body: &impl Body<f64>,
    joints: Vec<Joint>,
) -> Box<dyn Case> {
    let Inertia { mass, centre, about_centre } = body.inertia();
    let body = inverse::Body { mass, about_centre, centre, outboard: body.outboard() };
    let of = |state: fn(Joint, usize) -> Vec<f64>| {
        joints.iter().enumerate().flat_map(move |(i, joint)| state(*joint, i)).collect::<Vec<f64>>()
    };
    let scene = Evaluated::at(scene, Unloaded, &of(position), &of(rate));
    Box::new(Checked { scene, body, joints })
}

/// Link i of n, its share of a chain of length 1 m and mass 1 kg.
trait Link: Body<f64> {
    fn link(n: usize) -> Self;
}

impl Link for Rod<f64> {
    fn link(n: usize) -> Self {
        let h = 1.0 / n as f64;
        Self::uniform(h, 0.1 * h, h)
    }
}

impl Link for RigidBody<f64> {
    fn link(n: usize) -> Self {
        let h = 1.0 / n as f64;
        let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
        let scaled = |v: [f64; 3]| v.map(|x| x * h);
        Self::new(h, tensor.map(|row| row.map(|x| x * h * h * h)), scaled([0.4, 0.1, -0.05]), scaled([0.8, -0.3, 0.2]))
    }
}

macro_rules! row {
    ($scene:literal $form:literal $n:literal, $Body:ident $joint:expr, $root:expr, |$b:ident| $chain:expr) => {
        Row {
            scene: $scene,
            form: $form,
            bodies: $n,
            make: || {
                let $b = <$Body<f64> as Link>::link($n);
                let scene = System::new($root, $chain, Free).unwrap().with_gravity([0.0, -GRAVITY, 0.0]);
                case(scene, &$b, (0..$n).map($joint).collect())
            },
        }
    };
}

/// All rows of a kind of body.
macro_rules! scenes {
    ($($balls:literal $revolutes:literal: $Body:ident;)*) => {
        /// All rows of the table.
        pub fn rows() -> Vec<Row> {
            vec![$(
                row!($balls "tuple" 3, $Body |_| Joint::Ball, Pinned::<[f64; 3]>::origin(), |b| (b, Ball, b, Ball, b)),
                row!($balls "array" 20, $Body |_| Joint::Ball, Clamped::origin(), |b| [(Ball, b); 20]),
                row!($balls "Vec" 20, $Body |_| Joint::Ball, Clamped::origin(), |b| vec![(Ball, b); 20]),
                row!($balls "Vec" 1000, $Body |_| Joint::Ball, Clamped::origin(), |b| vec![(Ball, b); 1000]),
                row!($balls "Vec" 10_000, $Body |_| Joint::Ball, Clamped::origin(), |b| vec![(Ball, b); 10_000]),
                row!($revolutes "tuple" 3, $Body |i| Joint::Revolute(axis(i)), Clamped::origin(), |b| {
                    (revolute(0), b, revolute(1), b, revolute(2), b)
                }),
                row!($revolutes "array" 20, $Body |i| Joint::Revolute(axis(i)), Clamped::origin(), |b| {
                    std::array::from_fn::<_, 20, _>(|i| (revolute(i), b))
                }),
                row!($revolutes "Vec" 20, $Body |i| Joint::Revolute(axis(i)), Clamped::origin(), |b| links(20, b)),
                row!($revolutes "Vec" 1000, $Body |i| Joint::Revolute(axis(i)), Clamped::origin(), |b| links(1000, b)),
                row!($revolutes "Vec" 10_000, $Body |i| Joint::Revolute(axis(i)), Clamped::origin(), |b| links(10_000, b)),
            )*]
        }
    };
}

fn links<B: Copy>(n: usize, body: B) -> Vec<(Revolute<f64>, B)> {
    (0..n).map(|i| (revolute(i), body)).collect()
}

scenes! {
    "rods, balls" "rods, revolutes": Rod;
    "bodies, balls" "bodies, revolutes": RigidBody;
}
