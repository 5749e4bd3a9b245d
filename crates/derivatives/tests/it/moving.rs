//! Gradients of runs on ground that moves and turns, where something is held or closed, backward: against jets through the same steps, projection
//! included, and central differences.

use super::drag::Drag;
use super::held::share;
use super::robots::on_a_large_stack;
use catena::planar::*;
use catena::scalar::Jet;
use catena::sensitivity::Costate;
use catena::{Fault, Scalar, spatial};

/// Where the ground of the plane is, about a place.
fn place<T: Scalar<Real = f64>>(at: [T; 2], time: f64) -> GroundMotion<T> {
    let (s, c) = (9.0 * time).sin_cos();
    let of = |x: f64, y: f64| [x, y].map(T::literal);
    let [x, y] = of(0.1 * s, 0.2 * c);
    GroundMotion {
        place: [at[0] + x, at[1] + y],
        velocity: of(0.9 * c, -1.8 * s),
        acceleration: of(-8.1 * s, -16.2 * c),
    }
}

/// The same at half the pace.
fn place_slowly<T: Scalar<Real = f64>>(at: [T; 2], time: f64) -> GroundMotion<T> {
    let GroundMotion { place, velocity, acceleration } = place(at, 0.5 * time);
    let [half, quarter] = [0.5, 0.25].map(T::literal);
    GroundMotion { place, velocity: velocity.map(|v| half * v), acceleration: acceleration.map(|a| quarter * a) }
}

/// How it is turned.
fn turn<T: Scalar<Real = f64>>(time: f64) -> [T; 3] {
    let (s, c) = (5.0 * time).sin_cos();
    [0.3 * s, 1.5 * c, -7.5 * s].map(T::literal)
}

/// Where the ground of space is, and how it is turned about y.
fn place_in_space<T: Scalar<Real = f64>>(at: [T; 3], time: f64) -> spatial::GroundMotion<T> {
    let GroundMotion { place: [x, y], velocity: [u, v], acceleration: [a, b] } = place([at[0], at[1]], time);
    let zero = T::zero();
    spatial::GroundMotion { place: [x, y, at[2]], velocity: [u, v, zero], acceleration: [a, b, zero] }
}

fn turn_in_space<T: Scalar<Real = f64>>(time: f64) -> spatial::AttitudeMotion<T> {
    let [angle, spin, acceleration] = turn::<T>(time).map(|x| [T::zero(), x, T::zero()]);
    spatial::AttitudeMotion { attitude: spatial::Rotation::from_angles(angle), spin, acceleration }
}

/// A four-bar linkage with a spring in its crank.
#[test]
fn four_bar() {
    let kinds = [("lengths", 3), ("masses", 3), ("reach", 2), ("spring", 3), ("gravity", 1)];
    let parameters = vec![0.5, 1.2, 0.9, 0.6, 1.1, 0.8, 1.0, 0.1, 8.0, 0.2, 0.4, 9.81];
    macro_rules! of {
        ($name:literal, $method:expr, $steps:expr, $h:expr $(, $law:expr)?) => {
            gradients!($name, kinds, parameters.clone(), vec![1.0, -0.3, 1.1], 5, $method, $steps, $h, |x| {
                let rod = |i: usize| Rod::<N>::uniform(x(i), x(3 + i));
                let reach = RigidBody::<N>::massless([x(6), x(7)]);
                let knee = ElasticHinge::rotary(x(8)).damped(x(9)).resting_at(x(10));
                let net = Network::new((Revolute::smooth(), rod(0), knee, rod(1)), (reach, Pin, rod(2)), Pin);
                let root = Clamped::on(Moving(|time| place([N::constant(0.0); 2], time)), Turning(turn));
                System::new(root, net, Free).unwrap().with_gravity(x(11))
            } $(, under $law)?)
        };
    }
    of!("four-bar", Rk4, 6, 0.02);
    of!("four-bar, 8(5,3)", Dop853, 3, 0.05);
    of!("four-bar, generalised-α", GeneralizedAlpha::new(0.8), 6, 0.02);
    of!("four-bar, SDIRK4", Sdirk4::new(), 4, 0.02);
    of!("four-bar, under a drag", Rk4, 5, 0.02, Drag { drag: Scalar::literal(0.7) });
}

/// Rods from ground that moves to a pin that rests.
#[test]
fn held() {
    let kinds = [("lengths", 3), ("masses", 3), ("ground", 2), ("tip", 2), ("gravity", 1)];
    let parameters = vec![0.5, 1.2, 0.9, 0.6, 1.1, 0.8, 0.1, -0.2, 1.5, 0.1, 9.81];
    macro_rules! of {
        ($name:literal, $method:expr, $steps:expr, $h:expr) => {
            gradients!($name, kinds, parameters.clone(), vec![1.0, -0.3, -1.0], 4, $method, $steps, $h, |x| {
                let (rod, at) = (|i: usize| Rod::<N>::uniform(x(i), x(3 + i)), [x(6), x(7)]);
                let root = Clamped::on(Moving(move |time| place(at, time)), Turning(turn));
                let chain = (Revolute::smooth(), rod(0), Pin, rod(1), Revolute::smooth(), rod(2));
                System::new(root, chain, Pinned::at(x(8), x(9))).unwrap().with_gravity(x(10))
            })
        };
    }
    of!("held", Rk4, 6, 0.02);
    of!("held, generalised-α", GeneralizedAlpha::new(0.8), 6, 0.02);
    of!("held, SDIRK4", Sdirk4::new(), 4, 0.02);
}

/// A chain between two grounds that move, to a pin and to a clamp.
#[test]
fn held_by_ground_that_moves() {
    let kinds = [("lengths", 3), ("masses", 3), ("ground", 2), ("tip", 2), ("gravity", 1)];
    let parameters = vec![0.5, 1.2, 0.9, 0.6, 1.1, 0.8, 0.1, -0.2, 1.5, 0.1, 9.81];
    macro_rules! of {
        ($name:literal, $method:expr, |$at:ident| $tip:expr) => {
            gradients!($name, kinds, parameters.clone(), vec![1.0, -0.3, -1.0, 0.8], 5, $method, 5, 0.02, |x| {
                let (rod, at) = (|i: usize| Rod::<N>::uniform(x(i), x(3 + i)), [x(6), x(7)]);
                let root = Clamped::on(Moving(move |time| place(at, time)), Turning(turn));
                let chain = (Revolute::smooth(), rod(0), Pin, rod(1), Revolute::smooth(), rod(2), Pin, rod(0));
                let $at = [x(8), x(9)];
                System::new(root, chain, $tip).unwrap().with_gravity(x(10))
            })
        };
    }
    // The tip moves by half the frequency.
    of!("pinned", Rk4, |at| Pinned::on(Moving(move |time: f64| place_slowly(at, time))));
    of!("pinned, generalised-α", GeneralizedAlpha::new(0.8), |at| {
        Pinned::on(Moving(move |time: f64| place_slowly(at, time)))
    });
    of!("clamped", Rk4, |at| Clamped::on(Moving(move |time: f64| place_slowly(at, time)), Turning(turn)));
    of!("clamped, SDIRK4", Sdirk4::new(), |at| {
        Clamped::on(Moving(move |time: f64| place_slowly(at, time)), Turning(turn))
    });
}

/// When a crank passes the vertical, by gravity, against central differences of the same steps.
#[test]
fn when_a_crank_passes_the_vertical() {
    let scene = |gravity: f64| {
        let rod = |length: f64| Rod::uniform(length, length);
        let reach = RigidBody::massless([1.0, 0.1]);
        let net = Network::new((Revolute::smooth(), rod(0.5), Pin, rod(1.2)), (reach, Pin, rod(0.9)), Pin);
        let root = Clamped::on(Moving(|time| place([0.0; 2], time)), Turning(turn::<f64>));
        System::new(root, net, Free).unwrap().with_gravity(gravity)
    };
    let still = scene(9.81);
    let start = still.assembled(still.at_rest(&[1.0, -0.3, 1.1]).unwrap(), &Unloaded).unwrap();
    let passed = |gravity: f64| {
        let scene = scene(gravity);
        let (mut backward, mut states) = (scene.backward(Rk4), vec![start; 101]);
        backward.run(&start, 0.01, 100, &[], &mut states).unwrap();
        let steps = backward.cut(&[], &mut states, |state| state.coordinates()[0]).unwrap().unwrap();
        (steps, states)
    };
    let (steps, states) = passed(9.81);
    let gradient = still
        .backward(Rk4)
        .gradient_to_event(
            &[],
            &states[..=steps],
            &mut [],
            |step, _, by| {
                by.time += if step == steps { 1.0 } else { 0.0 };
                Ok(())
            },
            |_, by| by.add(&[1.0, 0.0, 0.0], &[0.0; 3]),
        )
        .unwrap();
    let time = |gravity: f64| {
        let (steps, states) = passed(gravity);
        states[steps].time()
    };
    let (found, expected) = (-gradient.by_gravity().y, (time(9.81 + 1e-4) - time(9.81 - 1e-4)) / 2e-4);
    println!("at {} s: {found} {expected}", states[steps].time());
    assert!((found - expected).abs() < 1e-8 * expected.abs().max(1.0));
}

/// What only seeds of the motion of a tip's ground do is refused.
#[test]
fn what_moves_a_tip_is_refused() {
    macro_rules! scene {
        ($pace:expr, $T:ty) => {{
            let (rod, pace) = (Rod::<$T>::uniform(<$T>::constant(1.0), <$T>::constant(1.0)), $pace);
            let ground = move |time: f64| {
                let velocity = [pace, <$T>::constant(0.0)];
                let place = [<$T>::constant(1.5) + pace.scale(time), <$T>::constant(0.0)];
                GroundMotion { place, velocity, acceleration: [<$T>::constant(0.0); 2] }
            };
            System::new(
                Pinned::at(<$T>::constant(0.0), <$T>::constant(0.0)),
                (rod, Pin, rod),
                Pinned::on(Moving(ground)),
            )
            .unwrap()
        }};
    }
    let scene = scene!(0.2, f64);
    let start = scene.assembled(scene.at_rest(&[0.7, -0.7]).unwrap(), &Unloaded).unwrap();
    let (mut backward, mut states) = (scene.backward(Rk4), vec![start; 11]);
    backward.run(&start, 0.01, 10, &[], &mut states).unwrap();
    let cost = |step: usize, _: &_, by: &mut Costate<_, f64>| {
        if step == 10 { by.add(&[1.0, 0.0], &[0.0; 2]) } else { Ok(()) }
    };
    let gradient = backward.gradient(&[], &states, &mut [], cost).unwrap();
    let refused = gradient.along(&scene!(Jet::<f64, 1>::seed(0.2, 0), Jet<f64, 1>)).unwrap_err();
    assert!(matches!(refused.fault, Fault::Unsupported { .. }), "{refused}");
}

/// Revolutes between ground that moves and a ball that rests, and two arms that meet in a ball.
#[test]
fn in_space() {
    on_a_large_stack(held_and_closed_in_space);
}

fn held_and_closed_in_space() {
    use spatial::{Ball, Clamped, Free, Moving, Network, Pinned, Revolute, Rod, System, Turning};
    let kinds = [("lengths", 3), ("masses", 3), ("axes", 9), ("gravity", 3), ("tip", 3)];
    let mut parameters = vec![0.5, 0.4, 0.6, 1.2, 0.7, 0.9, 0.1, 0.3, 1.0, 0.4, 1.0, -0.2, 0.2, -0.6, 0.8];
    parameters.extend([0.5, 0.1, -9.81, 1.2, 0.9, 0.6]);
    macro_rules! of {
        ($name:expr, $kinds:expr, $method:expr, $angles:expr, $joints:expr, |$rod:ident, $joint:ident| $chain:expr, $tip:ident) => {
            let count: usize = $kinds.iter().map(|(_, count)| count).sum();
            let (numbers, angles) = (parameters[..count].to_vec(), $angles);
            gradients!(super::robots::efforts, $name, $kinds, numbers, angles, $joints, $method, 3, 0.01, |x| {
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let $rod = |i: usize| Rod::<N>::uniform(x(i), <N as Scalar>::literal(0.05), x(3 + i));
                let $joint = |i: usize| Revolute::about(vector(6 + 3 * i));
                let root =
                    Clamped::on(Moving(|time| place_in_space([N::constant(0.0); 3], time)), Turning(turn_in_space));
                System::new(root, $chain, $tip!(vector)).unwrap().with_gravity(vector(15))
            });
        };
    }
    macro_rules! pinned {
        ($vector:expr) => {
            Pinned::on($vector(18))
        };
    }
    macro_rules! free {
        ($vector:expr) => {
            Free
        };
    }
    macro_rules! by {
        ($rule:literal, $method:expr) => {
            let angles = vec![0.3, -0.4, 0.5, 0.8, -0.6, 0.4];
            of!(
                concat!("held in space, ", $rule),
                kinds,
                $method,
                angles,
                7,
                |rod, joint| {
                    let three = |i: usize, j: usize, k: usize| (joint(i), rod(i), joint(j), rod(j), joint(k), rod(k));
                    (three(0, 1, 2), three(0, 1, 2))
                },
                pinned
            );
            let angles = vec![0.2, 0.6, -0.4, 0.3, -0.5, 0.4, -0.6];
            of!(
                concat!("closed in space, ", $rule),
                kinds[..4],
                $method,
                angles,
                9,
                |rod, joint| {
                    let three = |i: usize, j: usize, k: usize| (joint(i), rod(0), joint(j), rod(1), joint(k), rod(2));
                    (joint(1), rod(0), Network::new(three(0, 1, 2), three(2, 0, 1), Ball))
                },
                free
            );
        };
    }
    by!("RK4", Rk4);
    by!("SDIRK4", Sdirk4::new());
}
