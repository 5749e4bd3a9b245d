//! Gradients of runs in space under struts beside a law of loads.

use super::loads::{MEDIUM, Medium};
use super::*;

/// Numbers of a strut between bodies, of one to the ground, and of the laws of both.
const STRUTS: [f64; 22] = [
    0.3, 0.1, -0.2, 0.5, -0.2, 0.1, 9.0, 0.4, 0.6, 0.4, -0.1, 0.3, 1.5, 1.2, -0.7, 14.0, 0.3, 0.5, 0.7, 0.06, 1.1, 0.04,
];
/// What they are.
const KINDS: [(&str, usize); 6] = [
    ("ends on bodies", 6),
    ("a spring, damper and length", 3),
    ("an end on a body", 3),
    ("an end on the ground", 3),
    ("another spring, damper and length", 3),
    ("laws of struts", 4),
];

/// Struts between the numbered bodies, and a medium, from their numbers.
#[allow(clippy::type_complexity)] // two in one
fn struts<T: Scalar>(
    bodies: [usize; 3],
    number: impl Fn(usize) -> T,
) -> ([Strut<T, 3, Custom<Stiffening<T>>>; 2], Medium<T>) {
    let point = |k: usize| [0, 1, 2].map(|i| number(k + i));
    let with = |strut: Strut<T, 3>, k: usize, law: usize| {
        let strut = strut.with_stiffness(number(k)).with_damping(number(k + 1)).with_length(number(k + 2));
        strut.with_law(Custom(Stiffening { stiffness: number(law), damping: number(law + 1) }))
    };
    let inside = with(Strut::between((bodies[0], point(0)), (bodies[1], point(3))), 6, 18);
    let outside = with(Strut::to_ground((bodies[2], point(9)), point(12)), 15, 20);
    ([inside, outside], Medium::of(&number, 22))
}

/// Balls, a hinge, a slide and a weld, an arm, a root at a place.
#[test]
fn trees_under_struts_have_the_gradients_of_jets() {
    with_room(|| {
        let mut parameters = bodies(2);
        parameters.extend([0.3, 1.0, -0.5, 0.2, 0.1, -0.4]); // an axis, a weld
        parameters.extend([3.0, 0.4, 0.2, 0.3, -0.2, 0.1]); // a spring, the place of the root
        parameters.extend(STRUTS);
        parameters.extend(MEDIUM);
        let mut kinds =
            vec![("bodies", 26), ("gravity", 3), ("axis", 3), ("weld", 3), ("spring", 3), ("place of the root", 3)];
        kinds.extend(KINDS);
        kinds.push(("law", 6));
        let balls = [true, true, false, false, true];
        gradients!(
            "a tree under struts",
            kinds,
            parameters,
            balls,
            6,
            Rk4,
            3,
            0.05,
            |x| {
                let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let spring = Spring::new(x(35)).damped(x(36)).resting_at(x(37));
                let (hinge, slide) = (Revolute::about(vector(29)), Prismatic::along(vector(29)).with(spring));
                let weld = Weld::at(Rotation::from_angles(vector(32)));
                let chain = (of(0), Branch((Ball, of(1))), hinge, of(1), weld, of(0), slide, of(1), Ball, of(0));
                System::new(Pinned::on(vector(38)), chain, Free).unwrap().with_gravity(vector(26))
            },
            pulled(28, |y| { struts([1, 4, 3], |k| y(41 + k)) })
        );
    });
}

/// A window that a hinge closes, behind a body on a ball, and a tip that is held.
#[test]
fn closed_scenes_under_struts_have_the_gradients_of_jets() {
    with_room(|| {
        let mut parameters = bodies(2);
        parameters.extend(CLOSED);
        parameters.extend(STRUTS);
        parameters.extend(MEDIUM);
        let mut kinds = OF_CLOSED.to_vec();
        kinds.extend(KINDS);
        kinds.push(("law", 6));
        gradients!(
            "closed, under struts",
            kinds,
            parameters,
            [true; 6],
            7,
            Rk4,
            2,
            0.02,
            |x| { closed!(N, x) },
            pulled(28, |y| { struts([1, 4, 5], |k| y(35 + k)) })
        );
    });
}

/// A robot that floats, in axes of its bodies, with a flange that bears a rod.
#[test]
fn robots_under_struts_have_the_gradients_of_jets() {
    use catena::robot::{BodyAxes, Flange, Hinge, Leaning, Link, Slide, Turned};
    with_room(|| {
        let mut parameters = vec![0.5, -9.0, 1.0, 0.3, 0.1, -0.2, 0.8, 0.3, 0.02, 0.05, 0.4]; // gravity, places, a rod
        parameters.extend([1.3, 0.05, -0.03, 0.2, 0.11, 0.09, 0.05, 0.004, -0.003, 0.002, 0.3, -0.4, 0.5, 0.7, 0.2]);
        parameters.extend(STRUTS);
        parameters.extend(MEDIUM);
        let mut kinds = vec![("gravity", 3), ("place", 3), ("rod", 5), ("link", 10), ("offsets", 4), ("damper", 1)];
        kinds.extend(KINDS);
        kinds.push(("law", 6));
        let coordinates = [false, false, false, true, false, false, false];
        gradients!(
            "a robot under struts",
            kinds,
            parameters,
            coordinates,
            6,
            Rk4,
            3,
            0.02,
            |x| {
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let [xx, yy, zz, yz, xz, xy] = [15, 16, 17, 18, 19, 20].map(x);
                let link = Link::general(x(11), vector(12), [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]);
                let rod = Rod::new(x(6), x(7), x(8), x(9), x(10));
                let hip = Hinge::at::<7>(vector(3)).turned(Turned::by(Rotation::from_angles(vector(21))));
                let knee = Slide::at::<7>(vector(3)).turned(Leaning::by(x(24))).with(Spring::damping(x(25)));
                let chain = (BodyAxes, link, Branch((hip, link)), knee, link, hip, link, Flange::at(vector(3)), rod);
                System::new(Free, chain, Free).unwrap().with_gravity(vector(0))
            },
            pulled(28, |y| { struts([1, 4, 2], |k| y(26 + k)) })
        );
    });
}

/// Hinges with stiff springs, by rules whose pivots know these and not the struts.
#[test]
fn implicit_rules_under_struts_have_the_gradients_of_jets() {
    macro_rules! sprung {
        ($method:expr) => {{
            let mut parameters = bodies(2);
            parameters.extend([0.3, 1.0, -0.5, 1e3, 10.0, 0.2]); // an axis, a spring
            parameters.extend(STRUTS);
            parameters.extend(MEDIUM);
            let mut kinds = vec![("bodies", 26), ("gravity", 3), ("axis", 3), ("spring", 3)];
            kinds.extend(KINDS);
            kinds.push(("law", 6));
            gradients!(
                &format!("springs under struts, {:?}", $method),
                kinds,
                parameters,
                [false; 3],
                3,
                $method,
                2,
                0.03,
                |x| {
                    let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
                    let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                    let hinge = Revolute::about(vector(29));
                    let sprung = hinge.with(Spring::new(x(32)).damped(x(33)).resting_at(x(34)));
                    let ground = Clamped::at([0.0; 3].map(N::constant), Rotation::from_angles(vector(29)));
                    let chain = (of(0), sprung, of(1), hinge, of(0));
                    System::new(Hinged::on(ground, vector(29)), chain, Free).unwrap().with_gravity(vector(26))
                },
                pulled(28, |y| { struts([0, 2, 1], |k| y(35 + k)) })
            );
        }};
    }
    with_room(|| {
        sprung!(Sdirk4::new());
        sprung!(GeneralizedAlpha::new(0.8).with_sweeps(3));
    });
}
