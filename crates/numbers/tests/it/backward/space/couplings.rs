//! Gradients of runs in space whose joints are coupled, by all numbers of the scene and by the ratios.

use super::loads::{MEDIUM, Medium};
use super::*;

/// Ratios of an angle to an angle, and of a way to an angle (m).
const RATIOS: [f64; 2] = [-0.7, 0.4];

fn with_ratios(parameters: &mut Vec<f64>, kinds: &mut Vec<(&'static str, usize)>) {
    parameters.extend(RATIOS);
    parameters.extend(MEDIUM);
    kinds.extend([("ratios", 2), ("law", 6)]);
}

/// The first joint and the third follow the second.
fn couplings<T: Scalar<Real = f64>>([turning, sliding]: [T; 2]) -> [Coupling<'static, T>; 2] {
    let offset = T::constant(0.2);
    [Coupling::new(1, 2).ratio(turning).offset(offset), Coupling::new(3, 2).ratio(sliding)]
}

/// A hinge, an arm that turns against it, a slide that it winds, and balls.
#[test]
fn coupled_joints_have_the_gradients_of_jets() {
    with_room(|| {
        let mut parameters = bodies(2);
        parameters.extend([0.3, 1.0, -0.5, 0.2, -0.4, 0.9]); // axes
        parameters.extend([3.0, 0.4, 0.2]); // a spring
        let mut kinds = vec![("bodies", 26), ("gravity", 3), ("axes", 6), ("spring", 3)];
        with_ratios(&mut parameters, &mut kinds);
        macro_rules! by {
            ($name:expr, $method:expr, $steps:expr) => {
                gradients!(
                    $name,
                    kinds,
                    parameters.clone(),
                    [true, false, false, false, true],
                    5,
                    $method,
                    $steps,
                    0.05,
                    |x| {
                        let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
                        let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                        let spring = Spring::new(x(35)).damped(x(36)).resting_at(x(37));
                        let arm = (Revolute::about(vector(32)), of(1));
                        let (hinge, slide) = (Revolute::about(vector(29)), Prismatic::along(vector(32)).with(spring));
                        let chain = (of(0), Branch(arm), hinge, of(1), slide, of(0), Ball, of(1));
                        System::new(Pinned::on([N::constant(0.0); 3]), chain, Free).unwrap().with_gravity(vector(26))
                    },
                    coupled(8, |y| { (couplings([y(38), y(39)]), Medium::of(&y, 40)) })
                );
            };
        }
        by!("coupled in space, RK4", Rk4, 3);
        by!("coupled in space, Sdirk4", Sdirk4::new(), 2);
    });
}

/// A robot, in axes of its bodies.
#[test]
fn coupled_robots_have_the_gradients_of_jets() {
    use catena::robot::{Base, Hinge, Leaning, Link, Slide, Turned};
    with_room(|| {
        let mut parameters = vec![0.5, -9.0, 1.0, 0.3, 0.1, -0.2]; // gravity, places
        parameters.extend([1.3, 0.05, -0.03, 0.2, 0.11, 0.09, 0.05, 0.004, -0.003, 0.002, 0.3, -0.4, 0.5, 0.7]);
        let mut kinds = vec![("gravity", 3), ("place", 3), ("link", 10), ("offsets", 4)];
        with_ratios(&mut parameters, &mut kinds);
        gradients!(
            "a coupled robot",
            kinds,
            parameters,
            [false, false, false, false],
            5,
            Rk4,
            3,
            0.02,
            |x| {
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let [xx, yy, zz, yz, xz, xy] = [10, 11, 12, 13, 14, 15].map(&x);
                let link = Link::<N>::general(x(6), vector(7), [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]);
                let (turned, leaning) = (Turned::by(Rotation::from_angles(vector(16))), Leaning::by(x(19)));
                let at = vector(3);
                let chain = (
                    Hinge::level().grounded(),
                    link,
                    Branch((Hinge::at::<7>(at).turned(leaning), link)),
                    Hinge::at::<7>(at).turned(turned),
                    link,
                    Slide::at::<7>(at),
                    link,
                );
                System::new(Base::at([0.0, 0.1, 0.2].map(N::constant)), chain, Free).unwrap().with_gravity(vector(0))
            },
            coupled(8, |y| { (robot_couplings([y(20), y(21)]), Medium::of(&y, 22)) })
        );
    });
}

/// Joints by number among those of one coordinate: hinge, arm, hinge, slide.
fn robot_couplings<T: Scalar<Real = f64>>([turning, sliding]: [T; 2]) -> [Coupling<'static, T>; 2] {
    [Coupling::by_coordinate(1, 2).ratio(turning), Coupling::by_coordinate(3, 0).ratio(sliding)]
}
