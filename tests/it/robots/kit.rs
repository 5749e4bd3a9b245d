//! Robots with all kinds of joints, turns and zeros, as scenes and as plain lists.

use catena::robot::*;
use catena::spatial::Spatial;
use catena::system::MotionOf;
use catena_oracle::space::robot as plain;
use catena_oracle::space::{Matrix, Vector, about};
use catena_oracle::{Noise, near};

pub const GRAVITY: [f64; 3] = [0.7, -1.1, -9.6];

/// Mass, mass centre and tensor about it of body k; a bar along z with its masses in x, y or both planes where `centre` has zeros.
pub fn body(k: usize) -> (f64, [f64; 3], [[f64; 3]; 3]) {
    let x = k as f64;
    let (mass, centre) = (1.0 + 0.3 * x, [0.02 + 0.01 * x, -0.03, 0.1 + 0.02 * x]);
    let [a, b, c] = [0.05 + 0.01 * x, 0.04, 0.02 + 0.003 * x];
    (mass, centre, [[a, 0.004, -0.003], [0.004, b, 0.002], [-0.003, 0.002, c]])
}

/// A body symmetric about the yz plane, for masks 0b110 and 0b1111.
pub fn flat(k: usize) -> (f64, [f64; 3], [[f64; 3]; 3]) {
    let (mass, [_, y, z], [[a, ..], [_, b, d], [.., c]]) = body(k);
    (mass, [0.0, y, z], [[a, 0.0, 0.0], [0.0, b, d], [0.0, d, c]])
}

/// A body symmetric about its z axis, for masks 0b100 and 0b111.
pub fn round(k: usize) -> (f64, [f64; 3], [[f64; 3]; 3]) {
    let (mass, [_, _, z], [[a, ..], .., [.., c]]) = body(k);
    (mass, [0.0, 0.0, z], [[a, 0.0, 0.0], [0.0, a, 0.0], [0.0, 0.0, c]])
}

pub fn general((mass, centre, tensor): (f64, [f64; 3], [[f64; 3]; 3])) -> Link<f64> {
    Link::general(mass, centre, tensor)
}

pub fn lean() -> Rotation<f64> {
    Rotation::from_angles([0.4, -0.7, 1.1])
}

pub fn matrix(rotation: &Rotation<f64>) -> Matrix {
    let Columns { x, y, z } = rotation.matrix();
    Matrix::from_columns(&[x, y, z])
}

type Mid = Link<f64, 0b110, 0b1111>;
type Bar = Link<f64, 0b100, 0b111>;
type Side<L> = Branch<(Slide<f64, Quarter<8>, 0b010>, Link<f64>, Hinge<f64, Level, 0b111>, L)>;
type Tail = (
    Hinge<f64, Quarter<30>, 0b101, Spring<Absent, f64>, f64>,
    Mid,
    Hinge<f64, Leaning<f64>, 0b001>,
    Link<f64>,
    Slide<f64, Turned<f64>, 0b111, Spring<Absent, f64>, f64>,
    Bar,
);
/// Six joints: hinges and slides, all turns, an arm of two, damping and reflected inertia.
pub type Tree = (Link<f64>, Side<Bar>, Tail);
pub type Fixed = System<f64, Base<f64>, (Grounded, Tree), Free>;
type Grounded = Hinge<f64, Level, 0, Spring, Absent, OnGround>;
pub type Floating = System<f64, Free, (BodyAxes, Tree), Free>;

fn bar(k: usize) -> Bar {
    let (mass, centre, tensor) = round(k);
    Bar::new(mass, centre, tensor)
}

pub fn tree() -> Tree {
    let side = (
        Slide::at::<0b010>([0.0, 0.2, 0.0]).turned(Quarter::<8>),
        general(body(1)),
        Hinge::at::<0b111>([0.1, -0.2, 0.3]),
        bar(2),
    );
    let (mass, centre, tensor) = flat(3);
    let tail = (
        Hinge::at::<0b101>([0.3, 0.0, -0.1]).turned(Quarter::<30>).with(Spring::damping(0.3)).geared(0.2),
        Mid::new(mass, centre, tensor),
        Hinge::at::<0b001>([0.25, 0.0, 0.0]).turned(Leaning::by(0.6)),
        general(body(4)),
        Slide::at::<0b111>([0.1, 0.2, 0.15]).turned(Turned::by(lean())).with(Spring::damping(0.4)).geared(0.5),
        bar(5),
    );
    (general(body(0)), Branch(side), tail)
}

pub fn fixed() -> Result<Fixed, catena::Error> {
    Ok(System::new(Base::origin(), (Hinge::level().grounded(), tree()), Free)?.with_gravity(GRAVITY))
}

pub fn floating() -> Result<Floating, catena::Error> {
    Ok(System::new(Free, (BodyAxes, tree()), Free)?.with_gravity(GRAVITY))
}

/// The bodies beyond the first, whose number is `first`, as a list.
fn parts(first: Option<usize>) -> Vec<plain::Part> {
    let start = first.map_or(0, |first| first + 1);
    let part = |parent: Option<usize>, place: [f64; 3], turn: Matrix, (mass, centre, tensor): (f64, [f64; 3], _)| {
        plain::Part {
            parent,
            slides: false,
            place: Vector::from(place),
            turn,
            mass,
            centre: Vector::from(centre),
            tensor: Matrix::from_fn(|i, j| {
                let tensor: [[f64; 3]; 3] = tensor;
                tensor[i][j]
            }),
            armature: 0.0,
            damping: 0.0,
        }
    };
    // Quarter<8>: x along +z, y along +y, so that z points along −x... of 2 + 6·1. Quarter<30>: x along +x, y along −z, z along +y.
    let (x, y, z) = (Vector::x(), Vector::y(), Vector::z());
    let eight = Matrix::from_columns(&[z, y, -x]);
    let thirty = Matrix::from_columns(&[x, -z, y]);
    let one = Matrix::identity();
    vec![
        plain::Part { slides: true, ..part(first, [0.0, 0.2, 0.0], eight, body(1)) },
        part(Some(start), [0.1, -0.2, 0.3], one, round(2)),
        plain::Part { damping: 0.3, armature: 0.2, ..part(first, [0.3, 0.0, -0.1], thirty, flat(3)) },
        part(Some(start + 2), [0.25, 0.0, 0.0], about(x, 0.6), body(4)),
        plain::Part {
            slides: true,
            damping: 0.4,
            armature: 0.5,
            ..part(Some(start + 3), [0.1, 0.2, 0.15], matrix(&lean()), round(5))
        },
    ]
}

pub fn plain_fixed() -> plain::Robot {
    let (mass, centre, tensor) = body(0);
    let root = plain::Part {
        parent: None,
        slides: false,
        place: Vector::zeros(),
        turn: Matrix::identity(),
        mass,
        centre: Vector::from(centre),
        tensor: Matrix::from_fn(|i, j| tensor[i][j]),
        armature: 0.0,
        damping: 0.0,
    };
    let parts = std::iter::once(root).chain(parts(Some(0))).collect();
    plain::Robot { base: None, parts, gravity: Vector::from(GRAVITY) }
}

pub fn plain_floating(place: [f64; 3], attitude: &Rotation<f64>, [velocity, spin]: [[f64; 3]; 2]) -> plain::Robot {
    let (mass, centre, tensor) = body(0);
    let base = plain::Base {
        mass,
        centre: Vector::from(centre),
        tensor: Matrix::from_fn(|i, j| tensor[i][j]),
        place: Vector::from(place),
        attitude: matrix(attitude),
        velocity: Vector::from(velocity),
        spin: Vector::from(spin),
    };
    plain::Robot { base: Some(base), parts: parts(None), gravity: Vector::from(GRAVITY) }
}

/// The floating robot in a motion at random, and the dense robot in the same one.
pub struct Drift {
    pub start: MotionOf<Spatial<f64>, Free, (BodyAxes, Tree), Free>,
    pub plain: plain::Robot,
    /// Coordinates and rates of joints.
    pub q: [f64; 5],
    pub v: [f64; 5],
}

pub fn drift(scene: &Floating, noise: &mut Noise) -> Result<Drift, catena::Error> {
    let [q, v]: [[f64; 5]; 2] = std::array::from_fn(|_| list(noise, 2.0));
    let [place, velocity, spin, angles]: [[f64; 3]; 4] = std::array::from_fn(|_| list(noise, 1.0));
    let attitude = Rotation::from_angles(angles);
    let plain = plain_floating(place, &attitude, [velocity, spin]);
    let mut start = scene.motion();
    let coordinates: Vec<f64> = place.into_iter().chain(attitude.quaternion()).chain(q).collect();
    start.set_coordinates(&coordinates)?;
    let rates: Vec<f64> = velocity.into_iter().chain(spin).chain(v).collect();
    Ok(Drift { start: scene.with_rates(start, &rates)?, plain, q, v })
}

/// Numbers in −size .. size.
pub fn list<const N: usize>(noise: &mut Noise, size: f64) -> [f64; N] {
    std::array::from_fn(|_| size * noise.next())
}

/// Lists agree relative to their largest number.
#[track_caller]
pub fn agree(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    found.iter().zip(expected).for_each(|(x, y)| near(*x, *y, tolerance * size));
}
