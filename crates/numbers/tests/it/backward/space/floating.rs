//! Gradients of scenes that nothing holds: a root that floats.

use super::loads::{MEDIUM, Medium};
use super::*;

/// Numbers of two bodies, gravity, an axis, a rod and a medium.
fn numbers() -> Vec<f64> {
    let mut parameters = bodies(2);
    parameters.extend([0.3, 1.0, -0.5, 0.7, 0.8, 0.3, 0.02, 0.05]);
    parameters.extend(MEDIUM);
    parameters
}

/// What they are.
const KINDS: Kinds = &[("bodies", 26), ("gravity", 3), ("axis", 3), ("rod", 5), ("law", 6)];
/// The place of the first body, and its attitude.
const BASE: [bool; 4] = [false, false, false, true];

/// A rod, whose mass at its inboard end is the root's, with an arm on a hinge and a body on a ball, in a medium.
#[test]
fn trees_that_float_have_the_gradients_of_jets() {
    macro_rules! tree {
        ($method:expr, $steps:expr, $h:expr) => {
            gradients!(
                &format!("a tree that floats, {:?}", $method),
                KINDS,
                numbers(),
                [&BASE[..], &[false, true]].concat(),
                3,
                $method,
                $steps,
                $h,
                |x| {
                    let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
                    let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                    let rod = Rod::new(x(32), x(33), x(34), x(35), x(36));
                    let chain = (rod, Branch((Revolute::about(vector(29)), of(0))), Ball, of(1));
                    System::new(Free, chain, Free).unwrap().with_gravity(vector(26))
                },
                under(6, |y| { Medium::of(y, 37) })
            );
        };
    }
    with_room(|| {
        tree!(Rk4, 4, 0.05);
        tree!(Dop853, 2, 0.1);
    });
}

/// A loop that floats, without loads.
#[test]
fn loops_that_float_have_the_gradients_of_jets() {
    with_room(|| {
        let parameters = numbers()[..37].to_vec();
        let coordinates = [&BASE[..], &[true, false, true, true]].concat();
        gradients!("a loop that floats", &KINDS[..4], parameters, coordinates, 6, Rk4, 2, 0.02, |x| {
            let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
            let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
            let rod = Rod::new(x(32), x(33), x(34), x(35), x(36));
            let main = (Ball, of(0), Revolute::about(vector(29)), of(1));
            let chain = (rod, Network::new(main, (Ball, of(1), Ball, rod), Ball));
            System::new(Free, chain, Free).unwrap().with_gravity(vector(26))
        });
    });
}

/// Ground that moves and turns, from a place and behind a turn that are numbers, in a medium.
#[test]
fn trees_on_ground_that_moves_have_the_gradients_of_jets() {
    with_room(|| {
        let mut parameters = numbers();
        parameters.extend([0.3, -0.2, 0.1, 0.4, 0.2, -0.6]);
        parameters.rotate_right(6); // the law is last
        let kinds: Kinds = &[
            ("place of the root", 3),
            ("its turn", 3),
            ("bodies", 26),
            ("gravity", 3),
            ("axis", 3),
            ("rod", 5),
            ("law", 6),
        ];
        gradients!(
            "on ground that moves",
            kinds,
            parameters,
            [false, false, true],
            4,
            Rk4,
            4,
            0.03,
            |x| {
                let of = |i: usize| body(core::array::from_fn(|k| x(6 + 13 * i + k)));
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let (at, number) = (vector(0), N::constant);
                let moved = move |t: f64| {
                    let (s, c) = (9.0 * t).sin_cos();
                    GroundMotion {
                        place: [at[0] + number(0.1 * s), at[1] + number(0.2 * c), at[2]],
                        velocity: [number(0.9 * c), number(-1.8 * s), number(0.0)],
                        acceleration: [number(-8.1 * s), number(-16.2 * c), number(0.0)],
                    }
                };
                let turn = Rotation::from_angles(vector(3));
                let turned = move |t: f64| {
                    // About y, by 0.3 sin 5 t.
                    let (s, c) = (5.0 * t).sin_cos();
                    let about = |x: f64| [number(0.0), number(x), number(0.0)];
                    let attitude = turn.relative_to(&Rotation::from_angles(about(-0.3 * s)));
                    AttitudeMotion { attitude, spin: about(1.5 * c), acceleration: about(-7.5 * s) }
                };
                let rod = Rod::new(x(38), x(39), x(40), x(41), x(42));
                let hinge = Revolute::about(vector(35));
                let chain = (of(0), hinge, rod, Branch((hinge, of(0))), Ball, of(1));
                System::new(Clamped::on(Moving(moved), Turning(turned)), chain, Free).unwrap().with_gravity(vector(32))
            },
            under(6, |y| { Medium::of(y, 43) })
        );
    });
}

/// A robot in axes of its bodies: a base with two legs, one of which ends at a flange with a rod on a ball, in a medium.
#[test]
fn robots_that_float_have_the_gradients_of_jets() {
    use catena::robot::{BodyAxes, Flange, Hinge, Leaning, Link, Quarter, Slide, Turned};
    with_room(|| {
        let mut parameters = numbers()[26..37].to_vec(); // gravity, places, a rod
        parameters
            .extend([1.3, 0.05, -0.03, 0.2, 0.11, 0.09, 0.05, 0.004, -0.003, 0.002, 0.3, -0.4, 0.5, 0.7, 0.08, 0.2]);
        parameters.extend(MEDIUM);
        let kinds: Kinds = &[
            ("gravity", 3),
            ("place", 3),
            ("rod", 5),
            ("link", 10),
            ("offsets", 4),
            ("rotor", 1),
            ("damper", 1),
            ("law", 6),
        ];
        let coordinates = [&BASE[..], &[false, false, false, false, true]].concat();
        gradients!(
            "a robot that floats",
            kinds,
            parameters,
            coordinates,
            8,
            Rk4,
            3,
            0.02,
            |x| {
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let [xx, yy, zz, yz, xz, xy] = [15, 16, 17, 18, 19, 20].map(x);
                let link = Link::general(x(11), vector(12), [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]);
                let rod = Rod::new(x(6), x(7), x(8), x(9), x(10));
                let hip = Hinge::at::<7>(vector(3)).turned(Turned::by(Rotation::from_angles(vector(21))));
                let knee = Slide::at::<7>(vector(3)).turned(Leaning::by(x(24))).with(Spring::damping(x(26)));
                let foot = Hinge::at::<7>(vector(3)).turned(Quarter::<30>).geared(x(25));
                let chain = (
                    BodyAxes,
                    link,
                    Branch((hip, link, knee, link)),
                    foot,
                    link,
                    hip,
                    link,
                    Flange::at(vector(3)),
                    rod,
                    Ball,
                    rod,
                );
                System::new(Free, chain, Free).unwrap().with_gravity(vector(0))
            },
            under(6, |y| { Medium::of(y, 27) })
        );
    });
}
