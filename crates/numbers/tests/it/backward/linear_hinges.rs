//! Gradients through hinges with linear springs, and of scenes in the plane that nothing holds.

use super::joints::Stiffening;
use super::loads::Medium;
use super::names::*;

/// Hinges with springs along both axes, along one, without a rotary one, with axes that are not balanced, in an arm and at the tip, under
/// loads. Rods lump masses at them.
macro_rules! hinges {
    ($method:expr, $steps:expr, $h:expr, $stiffness:expr) => {{
        let (steps, coordinates, joints, k) = ($steps, 14, 7, $stiffness);
        let mut noise = Noise::new(19);
        let mut list = vec![1.0, 0.8, 0.35, 0.07, 1.3, 0.2, 0.4, 0.1, 0.8, -0.2]; // a rod and a rigid body
        list.extend([k, 0.05 * k, 0.3, 2.0 * k, 0.1 * k, 0.2, 1.5 * k, 0.02 * k]); // springs, dampers, rest values
        list.extend([0.5 * k, 0.4, 0.1 * k]); // a law
        list.extend([0.1, 9.81, 0.2, 3.0, 0.5, 0.4, 0.1]); // the root, gravity, a medium
        assert_eq!(list.len(), 28);
        list.extend((0..coordinates).map(|_| 0.5 * noise.next()));
        list.extend((0..coordinates).map(|_| noise.next()));
        list.extend((0..steps * joints).map(|_| 0.5 * noise.next()));
        let kinds = [
            ("bodies", 10),
            ("springs", 8),
            ("law", 3),
            ("root and gravity", 2),
            ("medium", 5),
            ("coordinates", coordinates),
            ("rates", coordinates),
            ("torques", steps * joints),
        ];
        gradients!(
            &format!("hinges with linear springs, {:?}", $method),
            &kinds,
            list,
            [coordinates, joints],
            $method,
            steps,
            $h,
            |x| {
                let rod = Rod::<N>::new(x(0), x(1), x(2), x(3));
                let rigid = RigidBody::<N>::new(x(4), x(5), [x(6), x(7)], [x(8), x(9)]);
                let one = Spring::new(x(10)).damped(x(11)).resting_at(x(12));
                let other = Spring::new(x(13)).damped(x(14)).resting_at(x(15));
                let own = Custom(Stiffening { stiffness: x(18), growth: x(19), damping: x(20) });
                let full = ElasticHinge::rotary(x(16)).damped(x(17)).with_linear(one, other);
                let loose = ElasticHinge::linear(other, own);
                let half = ElasticHinge::rotary(x(16)).with_linear(one, Absent);
                let unbalanced = ElasticHinge::rotary(x(13)).with_linear(other, one).in_unbalanced_axes();
                let chain = (full, rod, Branch((loose, rod)), half, rigid, Pin, rod, unbalanced, rod);
                let chain = (chain, ElasticHinge::rotary(x(10)), rod);
                System::new(Clamped::at(N::constant(0.2), N::constant(0.1), x(21)), chain, Free)
                    .unwrap()
                    .with_gravity(x(22))
            },
            under(5, |x| { Medium { drag: x(23), stiffness: x(24), anchor: [x(25), x(26)], brake: x(27) } })
        );
    }};
}

#[test]
fn hinges_with_linear_springs_have_the_gradients_of_jets() {
    hinges!(Rk4, 6, 0.02, 12.0);
}

/// By rules whose pivots know springs.
#[test]
fn stiff_hinges_with_linear_springs_have_the_gradients_of_jets() {
    hinges!(Sdirk4::new(), 3, 0.005, 100.0);
}

/// Springs along axes that do not turn, behind bodies that do, in an arm, and one after the other.
#[test]
fn hinges_with_springs_along_fixed_axes_have_the_gradients_of_jets() {
    let (coordinates, joints) = (11, 6);
    let mut list = vec![1.0, 0.8, 0.35, 0.07, 1.3, 0.2, 0.4, 0.1, 0.8, -0.2]; // a rod and a rigid body
    list.extend([12.0, 0.6, 0.3, 24.0, 1.2, 0.2, 18.0, 0.24]); // springs, dampers, rest values
    list.extend([0.1, 9.81, 0.2, 3.0, 0.5, 0.4, 0.1]); // the root, gravity, a medium
    macro_rules! fixed {
        ($method:expr, $steps:expr) => {
            let steps = $steps;
            let mut list = list.clone();
            list.extend(moving(&mut Noise::new(23), coordinates, steps * joints));
            let kinds = [("bodies", 10), ("springs", 8), ("root and gravity", 2), ("medium", 5)];
            gradients!(
                &format!("springs along fixed axes, {:?}", $method),
                &with_motion(&kinds, coordinates, steps * joints),
                list,
                [coordinates, joints],
                $method,
                steps,
                0.02,
                |x| {
                    let rod = Rod::<N>::new(x(0), x(1), x(2), x(3));
                    let rigid = RigidBody::<N>::new(x(4), x(5), [x(6), x(7)], [x(8), x(9)]);
                    let one = Spring::new(x(10)).damped(x(11)).resting_at(x(12));
                    let other = Spring::new(x(13)).damped(x(14)).resting_at(x(15));
                    let full = ElasticHinge::rotary(x(16)).damped(x(17)).with_linear(one, other).in_fixed_axes();
                    let half = ElasticHinge::linear(other, Absent).in_fixed_axes();
                    let chain = (Pin, rigid, Branch((half, rod)), full, rigid, Revolute::smooth(), rod, full, rigid);
                    System::new(Clamped::at(N::constant(0.2), N::constant(0.1), x(18)), chain, Free)
                        .unwrap()
                        .with_gravity(x(19))
                },
                under(5, |x| { Medium { drag: x(20), stiffness: x(21), anchor: [x(22), x(23)], brake: x(24) } })
            );
        };
    }
    fixed!(Rk4, 6);
    fixed!(Dop853, 2);
}

/// A rod, whose mass at its inboard end is the root's, a body on a pin and one on a hinge, in a medium.
#[test]
fn chains_that_float_have_the_gradients_of_jets() {
    let (steps, coordinates, joints) = (6, 5, 3);
    let mut noise = Noise::new(20);
    let mut list = vec![1.0, 0.8, 0.35, 0.07, 1.3, 0.2, 0.4, 0.1, 0.8, -0.2]; // a rod and a rigid body
    list.extend([12.0, 0.3, 9.81, 0.2, 3.0, 0.5, 0.4, 0.1]); // a hinge, gravity, a medium
    list.extend(moving(&mut noise, coordinates, steps * joints));
    let kinds = [
        ("bodies", 10),
        ("hinge", 2),
        ("gravity", 1),
        ("medium", 5),
        ("coordinates", coordinates),
        ("rates", coordinates),
        ("torques", steps * joints),
    ];
    macro_rules! float {
        ($method:expr) => {
            gradients!(
                &format!("a chain that floats, {:?}", $method),
                &kinds,
                list.clone(),
                [coordinates, joints],
                $method,
                steps,
                0.02,
                |x| {
                    let rod = Rod::<N>::new(x(0), x(1), x(2), x(3));
                    let rigid = RigidBody::<N>::new(x(4), x(5), [x(6), x(7)], [x(8), x(9)]);
                    let hinge = ElasticHinge::rotary(x(10)).damped(x(11));
                    System::new(Free, (rod, Branch((Pin, rigid)), hinge, rigid), Free).unwrap().with_gravity(x(12))
                },
                under(5, |x| { Medium { drag: x(13), stiffness: x(14), anchor: [x(15), x(16)], brake: x(17) } })
            );
        };
    }
    float!(Rk4);
    float!(GeneralizedAlpha::new(0.8));
}

/// Ground that moves and turns, from a place and at an angle that are numbers, under loads: these are all that the gradient knows of it.
#[test]
fn chains_on_ground_that_moves_have_the_gradients_of_jets() {
    let (steps, coordinates, joints) = (6, 3, 4);
    let mut noise = Noise::new(21);
    let mut list = vec![1.0, 0.8, 0.35, 0.07, 1.3, 0.2, 0.4, 0.1, 0.8, -0.2]; // a rod and a rigid body
    list.extend([12.0, 0.3, 0.2, -0.1, 0.3, 9.81, 0.2, 3.0, 0.5, 0.4, 0.1]); // a hinge, the root, gravity, a medium
    list.extend(moving(&mut noise, coordinates, steps * joints));
    let kinds = [
        ("bodies", 10),
        ("hinge", 2),
        ("place of the root", 2),
        ("its angle", 1),
        ("gravity", 1),
        ("medium", 5),
        ("coordinates", coordinates),
        ("rates", coordinates),
        ("torques", steps * joints),
    ];
    macro_rules! shake {
        ($method:expr) => {
            gradients!(
                &format!("on ground that moves, {:?}", $method),
                &kinds,
                list.clone(),
                [coordinates, joints],
                $method,
                steps,
                0.02,
                |x| {
                    let rod = Rod::<N>::new(x(0), x(1), x(2), x(3));
                    let rigid = RigidBody::<N>::new(x(4), x(5), [x(6), x(7)], [x(8), x(9)]);
                    let hinge = ElasticHinge::rotary(x(10)).damped(x(11));
                    let (a, b, angle) = (x(12), x(13), x(14));
                    let shaken = move |t: f64| {
                        let (s, c) = (9.0 * t).sin_cos();
                        let of = |x: f64, y: f64| [N::constant(x), N::constant(y)];
                        let place = [a + N::constant(0.1 * s), b + N::constant(0.2 * c)];
                        GroundMotion { place, velocity: of(0.9 * c, -1.8 * s), acceleration: of(-8.1 * s, -16.2 * c) }
                    };
                    let turned = move |t: f64| {
                        let (s, c) = (5.0 * t).sin_cos();
                        [angle + N::constant(0.3 * s), N::constant(1.5 * c), N::constant(-7.5 * s)]
                    };
                    let chain = (rigid, hinge, rod, Branch((Pin, rigid)), hinge, rigid);
                    System::new(Clamped::on(Moving(shaken), Turning(turned)), chain, Free).unwrap().with_gravity(x(15))
                },
                under(5, |x| { Medium { drag: x(16), stiffness: x(17), anchor: [x(18), x(19)], brake: x(20) } })
            );
        };
    }
    shake!(Rk4);
    shake!(GeneralizedAlpha::new(0.8));
}

/// By an amplitude there is no gradient, nor where the tip is held.
#[test]
fn motions_of_the_ground_have_no_numbers() {
    macro_rules! scene {
        ($N:ty, $amplitude:expr, $tip:expr) => {{
            let (amplitude, rod) = ($amplitude, Rod::<$N>::uniform(<$N>::constant(1.0), <$N>::constant(1.0)));
            let shaken = move |t: f64| {
                let (s, c) = t.sin_cos();
                let of = |x: f64| [amplitude.scale(x), <$N>::constant(0.0)];
                GroundMotion { place: of(s), velocity: of(c), acceleration: of(-s) }
            };
            System::new(Pinned::on(Moving(shaken)), (rod, Pin, rod), $tip).unwrap()
        }};
    }
    let system = scene!(f64, 0.1, Free);
    let start = system.at_rest(&[-1.0, -0.5]).unwrap();
    let (mut backward, mut states) = (system.backward(Rk4), [start; 3]);
    backward.run(&start, 0.1, 2, &[], &mut states).unwrap();
    macro_rules! end {
        () => {
            |k: usize, _: &_, by: &mut catena::sensitivity::Costate<_>| match k {
                2 => by.add(&[1.0, 0.0], &[0.0; 2]),
                _ => Ok(()),
            }
        };
    }
    let gradient = backward.gradient(&[], &states, &mut [], end!()).unwrap();
    assert!(gradient.along(&scene!(Jet<f64, 1>, Jet::of(0.1), Free)).unwrap() == [0.0]);
    let refused = |found: Result<(), catena::Error>| {
        matches!(found.map_err(|error| error.fault), Err(catena::Fault::Unsupported { .. }))
    };
    assert!(refused(gradient.along(&scene!(Jet<f64, 1>, Jet::seed(0.1, 0), Free)).map(|_| ())));
    macro_rules! held {
        ($N:ty, $amplitude:expr) => {
            scene!($N, $amplitude, Pinned::at(<$N>::constant(1.5), <$N>::constant(-0.5)))
        };
    }
    let system = held!(f64, 0.1);
    let start = system.assembled(system.at_rest(&[-1.0, 0.5]).unwrap(), &Unloaded).unwrap();
    let (mut backward, mut states) = (system.backward(Rk4), [start; 3]);
    backward.run(&start, 0.1, 2, &[], &mut states).unwrap();
    let gradient = backward.gradient(&[], &states, &mut [], end!()).unwrap();
    assert!(gradient.along(&held!(Jet<f64, 1>, Jet::of(0.1))).unwrap() == [0.0]);
    assert!(refused(gradient.along(&held!(Jet<f64, 1>, Jet::seed(0.1, 0))).map(|_| ())));
}

/// A root that slides along a line of the ground: its place, angle and line, in a medium.
#[test]
fn chains_on_a_line_have_the_gradients_of_jets() {
    let (steps, coordinates, joints) = (6, 3, 3);
    let mut noise = Noise::new(22);
    let mut list = vec![1.0, 0.8, 0.35, 0.07, 1.3, 0.2, 0.4, 0.1, 0.8, -0.2]; // a rod and a rigid body
    list.extend([0.2, -0.1, 0.3, 0.6, 9.81, 0.2, 3.0, 0.5, 0.4, 0.1]); // the root, gravity, a medium
    list.extend(moving(&mut noise, coordinates, steps * joints));
    let kinds = [
        ("bodies", 10),
        ("place of the root", 2),
        ("its angle and line", 2),
        ("gravity", 1),
        ("medium", 5),
        ("coordinates", coordinates),
        ("rates", coordinates),
        ("torques", steps * joints),
    ];
    gradients!(
        "on a line",
        &kinds,
        list,
        [coordinates, joints],
        Rk4,
        steps,
        0.02,
        |x| {
            let rod = Rod::<N>::new(x(0), x(1), x(2), x(3));
            let rigid = RigidBody::<N>::new(x(4), x(5), [x(6), x(7)], [x(8), x(9)]);
            let root = Guided::on(Clamped::at(x(10), x(11), x(12)), x(13));
            System::new(root, (rod, Pin, rigid, Pin, rod), Free).unwrap().with_gravity(x(14))
        },
        under(5, |x| { Medium { drag: x(15), stiffness: x(16), anchor: [x(17), x(18)], brake: x(19) } })
    );
}
