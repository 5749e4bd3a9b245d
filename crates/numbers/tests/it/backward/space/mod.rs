//! Gradients of runs in space that go backward: against jets through the same steps, kind by kind, and against central differences.

use super::{Kinds, ROUNDING, ROUNDING_BETWEEN, Stiffening, agrees, alike, by_jets};
use catena::planar::Custom;
use catena::scalar::Jet;
use catena::spatial::*;
use catena::system::{Position, Rate};
use catena::{Fault, Scalar};
use catena_oracle::{Noise, near};

/// What a cost reads of coordinates and rates at a step: unlike for each of them.
fn share<T: Scalar<Real = f64>>(step: usize, last: usize, positions: &[T], rates: &[T]) -> T {
    let mut sum = T::constant(0.0);
    for (i, (&q, weight)) in positions.iter().zip(weights(step, last)).enumerate() {
        sum += (q + (q * q).scale(0.1 * i as f64)).scale(weight);
    }
    for (&v, weight) in rates.iter().zip(weights(step, last)) {
        sum += (v + (v * v).scale(0.5)).scale(weight);
    }
    sum
}

/// Its derivatives by displacements and rates: a ball's quaternion p changes by half of p ∘ (0, ψ) with a rotation vector in body axes.
fn slopes(step: usize, last: usize, balls: &[bool], positions: &[f64], rates: &[f64]) -> [Vec<f64>; 2] {
    let by = |i: usize, q: f64| (1.0 + 0.2 * i as f64 * q) * weights(step, last).nth(i).unwrap();
    let (mut i, mut by_position) = (0, vec![]);
    for &ball in balls {
        let own: Vec<f64> = (i..i + if ball { 4 } else { 1 }).map(|i| by(i, positions[i])).collect();
        if let ([a, b, c, d], [w, x, y, z, ..]) = (&own[..], &positions[i..]) {
            by_position.extend(
                [-a * x + b * w + c * z - d * y, -a * y - b * z + c * w + d * x, -a * z + b * y - c * x + d * w]
                    .map(|sum| 0.5 * sum),
            );
        } else {
            by_position.push(own[0]);
        }
        i += own.len();
    }
    [by_position, rates.iter().zip(weights(step, last)).map(|(v, weight)| (1.0 + v) * weight).collect()]
}

/// Weights of coordinates: all of them at the end, less on the way.
fn weights(step: usize, last: usize) -> impl Iterator<Item = f64> {
    let all = if step == last { 1.0 } else { 0.02 / (1.0 + step as f64) };
    (0..).map(move |i| all * (1.0 + 0.1 * i as f64))
}

/// Runs what, without optimisation, is too much for the stack of a test: scenes of many elements over jets.
fn with_room(test: fn()) {
    let thread = std::thread::Builder::new().stack_size(1 << 26).spawn(test).expect("a thread");
    thread.join().expect("gradients of jets");
}

/// A scene from numbers, run by fixed steps, as plain numbers backward and over jets by the rule itself: the gradient of a cost by all
/// numbers. The scene's constructor takes each from `$number`, by its place in the list: parameters, the last of them those of a law of
/// loads if there is one, then displacements from angles, rates, and torques, three a joint.
macro_rules! gradients {
    ($name:expr, $kinds:expr, $parameters:expr, $balls:expr, $joints:expr, $method:expr, $steps:expr, $h:expr, |$x:ident| $scene:block) => {
        gradients!(
            $name,
            $kinds,
            $parameters,
            $balls,
            $joints,
            $method,
            $steps,
            $h,
            |$x| $scene,
            under(0, |_none| { Absent })
        )
    };
    ($name:expr, $kinds:expr, $parameters:expr, $balls:expr, $joints:expr, $method:expr, $steps:expr, $h:expr, |$x:ident| $scene:block,
     $act:ident ($of_law:expr, |$y:ident| $law:block)) => {{
        let (mut numbers, steps, h, joints): (Vec<f64>, usize, f64, usize) = ($parameters, $steps, $h, $joints);
        let balls: &[bool] = &$balls;
        let (parameters, n) = (numbers.len(), balls.iter().map(|ball| if *ball { 3 } else { 1 }).sum::<usize>());
        let mut noise = Noise::new(5);
        let (angles, rates): (Vec<f64>, Vec<f64>) = (0..n).map(|_| [noise.next(), noise.next()].into()).unzip();
        // Closed, where there is something to be closed.
        let guess = {
            #[allow(dead_code)] // not each scene names it
            type N = f64;
            let $x = |k: usize| -> N { numbers[k] };
            let system = $scene;
            // Slides are no angles, and begin where they are put.
            let turns = (0..=n).rev().find_map(|turns| system.at_rest(&angles[..turns]).ok()).unwrap();
            let mut guess = system.with_rates(turns, &rates).unwrap();
            if system.at_rest(&angles).is_err() {
                let mut step = guess.rate().clone();
                Rate::<f64>::replace(&mut step, &mut |x| 0.3 * x);
                Position::<f64>::displace(guess.position_mut(), &step);
            }
            let law = {
                let $y = |k: usize| -> N { numbers[k] };
                $law
            };
            acting!($act, joined: system.assembled(guess, &Unloaded).unwrap(), law, &system)
        };
        numbers.extend((0..n).map(|_| 0.0));
        numbers.extend(guess.rates());
        numbers.extend((0..3 * steps * joints).map(|_| noise.next()));
        let mut kinds = $kinds.to_vec();
        kinds.extend([("attitudes", n), ("rates", n), ("torques", 3 * steps * joints)]);
        // The motion in which a run begins, and torques.
        macro_rules! start {
            ($N:ty, $system:expr, $of:expr) => {{
                let still = guess.clone().lift(<$N>::constant);
                let mut start = $system.with_rates(still, &$of[parameters + n..][..n]).unwrap();
                let (mut step, mut displacements) = (start.rate().clone(), $of[parameters..].iter());
                Rate::<$N>::replace(&mut step, &mut |_| *displacements.next().unwrap());
                Position::<$N>::displace(start.position_mut(), &step);
                let torques =
                    $of[parameters + 2 * n..].chunks(3).map(|t| Effort([t[0], t[1], t[2]])).collect::<Vec<_>>();
                (start, torques)
            }};
        }
        // Over numbers: the cost of the run.
        macro_rules! cost {
            ($N:ty, $number:expr) => {{
                let $x = $number;
                let of: Vec<$N> = (0..numbers.len()).map(&$x).collect();
                let system = {
                    #[allow(dead_code)] // not each scene names it
                    type N = $N;
                    $scene
                };
                let law = {
                    #[allow(dead_code)] // not each law names it
                    type N = $N;
                    let $y = |k: usize| -> N { of[k] };
                    $law
                };
                let (mut now, torques) = start!($N, system, of);
                let (mut next, mut stepper, mut sum) = (now.clone(), system.stepper($method), <$N>::constant(0.0));
                for step in 0..=steps {
                    sum += share(step, steps, &now.coordinates(), &now.rates());
                    if step < steps {
                        let efforts = Loads::none().efforts(torques[step * joints..][..joints].to_vec());
                        stepper.step(&now, &acting!($act, beside: efforts, law, &system), h, &mut next).unwrap();
                        core::mem::swap(&mut now, &mut next);
                    }
                }
                sum
            }};
        }
        // Backward.
        let system = {
            #[allow(dead_code)] // not each scene names it
            type N = f64;
            let $x = |k: usize| -> N { numbers[k] };
            $scene
        };
        let (start, torques) = start!(f64, system, numbers);
        let mut states = vec![start.clone(); steps + 1];
        let mut by_torques = vec![Effort([0.0; 3]); torques.len()];
        let law = {
            #[allow(dead_code)] // not each law names it
            type N = f64;
            let $y = |k: usize| -> N { numbers[k] };
            $law
        };
        let mut backward = system.backward($method).under(acting!($act, on_bodies: law, &system));
        backward.run(&start, h, steps, &torques, &mut states).unwrap();
        let mut total = 0.0;
        let gradient = backward
            .gradient(&torques, &states, &mut by_torques, |step, state, by| {
                let (q, v) = (state.coordinates(), state.rates());
                total += share(step, steps, &q, &v);
                let [by_position, by_rate] = slopes(step, steps, balls, &q, &v);
                by.add(&by_position, &by_rate)
            })
            .unwrap();
        // The number itself is that of the rule, but for the order in which shares are added up.
        let plain = cost!(f64, |k: usize| -> f64 { numbers[k] });
        near(total, plain, 1e-12 * (1.0 + plain.abs()));
        let [mut expected, mut found] = by_jets(&numbers, |number| {
            let system = {
                #[allow(dead_code)] // not each scene names it
                type N = Jet<f64, 8>;
                let $x = number;
                $scene
            };
            [cost!(Jet<f64, 8>, number).eps, gradient.along(&system).unwrap()]
        });
        expected.truncate(numbers.len());
        found.truncate(parameters - $of_law);
        if $of_law > 0 {
            found.extend(acting!($act, by_numbers: gradient));
        }
        found.extend(gradient.by_position().into_iter().chain(gradient.by_rate()));
        found.extend(by_torques.iter().flat_map(|torque| torque.0));
        // Differences by two numbers of five.
        let cost = |number: &dyn Fn(usize) -> f64| cost!(f64, number);
        agrees($name, &kinds, &numbers, ([&expected, &found], ROUNDING), |j| j % 5 < 2, cost);
    }};
}

/// A body with mass, tensor, mass centre and outboard end anywhere, from thirteen numbers.
fn body<N: Scalar>(of: [N; 13]) -> RigidBody<N> {
    let [m, xx, yy, zz, xy, xz, yz, a, b, c, d, e, f] = of;
    RigidBody::new(m, [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], [a, b, c], [d, e, f])
}

/// Numbers of bodies, and gravity.
fn bodies(n: usize) -> Vec<f64> {
    let mut noise = Noise::new(n as u64);
    let mut list = vec![];
    for _ in 0..n {
        let typical = [1.2, 0.2, 0.25, 0.3, 0.02, -0.03, 0.01, 0.3, 0.1, -0.05, 0.7, -0.2, 0.15];
        list.extend(typical.map(|x| x * (1.0 + 0.2 * noise.next())));
    }
    list.extend([0.5, -9.0, 1.0]);
    list
}

/// Numbers of [`closed`] beside those of two bodies and gravity, an axis and a tip; and what all are.
const CLOSED: [f64; 6] = [0.3, 1.0, -0.5, 1.4, 0.5, -0.3];
const OF_CLOSED: [(&str, usize); 4] = [("bodies", 26), ("gravity", 3), ("axis", 3), ("tip", 3)];

/// A window that a hinge closes, behind a body on a ball, and a tip that is held.
macro_rules! closed {
    ($N:ty, $x:expr) => {{
        let x = $x;
        let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
        let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
        let (main, side) = ((Ball, of(0), Ball, of(1)), (Ball, of(1), Ball, of(0)));
        let chain = (of(1), Network::new(main, side, Revolute::about(vector(29))), Ball, of(0));
        let root = Pinned::on([0.0; 3].map(<$N>::constant));
        System::new(root, chain, Pinned::at(vector(32))).unwrap().with_gravity(vector(26))
    }};
}

macro_rules! balls {
    ($n:expr, $method:expr, $steps:expr, $h:expr) => {{
        let n = $n;
        let kinds: Kinds = &[("bodies", 13 * n), ("gravity", 3)];
        let name = format!("{n} balls, {:?}", $method);
        gradients!(&name, kinds, bodies(n), vec![true; n], n, $method, $steps, $h, |x| {
            let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
            let others: Vec<(Ball, RigidBody<N>)> = (1..n).map(|i| (Ball, of(i))).collect();
            let root = Pinned::on([0.0; 3].map(N::constant));
            System::new(root, (of(0), others), Free).unwrap().with_gravity([0, 1, 2].map(|k| x(13 * n + k)))
        })
    }};
}

#[test]
fn chains_on_balls_have_the_gradients_of_jets() {
    balls!(1, Rk4, 6, 0.05);
    balls!(2, Rk4, 6, 0.05);
    balls!(2, Dop853, 3, 0.1);
}

macro_rules! revolutes {
    ($n:expr, $method:expr, $steps:expr, $h:expr) => {{
        let n = $n;
        let kinds: Kinds = &[("bodies", 13 * n), ("gravity", 3), ("axes", 3 * n), ("attitude of the root", 3)];
        let mut parameters = bodies(n);
        parameters.extend((0..n).flat_map(|i| [0.4, 0.3 * i as f64, 1.0]).chain([0.3, -0.5, 0.2]));
        let name = format!("{n} revolutes, {:?}", $method);
        gradients!(&name, kinds, parameters, vec![false; n], n + 1, $method, $steps, $h, |x| {
            let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
            let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
            let link = |i: usize| (Revolute::about(vector(13 * n + 3 + 3 * i)), of(i));
            let links: Vec<(Revolute<N>, RigidBody<N>)> = (0..n).map(link).collect();
            let root = Clamped::at([0.0; 3].map(N::constant), Rotation::from_angles(vector(16 * n + 3)));
            System::new(root, links, Free).unwrap().with_gravity(vector(13 * n))
        })
    }};
}

#[test]
fn chains_on_revolutes_have_the_gradients_of_jets() {
    revolutes!(1, Rk4, 6, 0.05);
    revolutes!(2, Rk4, 6, 0.05);
    revolutes!(2, Dop853, 3, 0.1);
}

/// A revolute between balls, with a rod, a bob, a weld and an arm.
#[test]
fn trees_have_the_gradients_of_jets() {
    let mut parameters = bodies(2);
    parameters.extend([0.3, 1.0, -0.5, 0.2, 0.1, -0.4]); // an axis, a weld
    parameters.extend([0.7, 0.8, 0.3, 0.02, 0.05, 0.4, 0.3]); // a rod, a bob
    parameters.extend([3.0, 0.4, 0.2, 0.5, 0.3, 0.8]); // a spring, dry friction
    let kinds: Kinds = &[
        ("bodies", 26),
        ("gravity", 3),
        ("axis", 3),
        ("weld", 3),
        ("rod", 5),
        ("bob", 2),
        ("springs", 3),
        ("friction", 3),
    ];
    let balls = [true, true, false, false, true];
    gradients!("a tree", kinds, parameters, balls, 6, Rk4, 3, 0.05, |x| {
        let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
        let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
        let spring = Spring::new(x(42)).damped(x(43)).resting_at(x(44));
        let (hinge, weld) = (Revolute::about(vector(29)).with(spring), Weld::at(Rotation::from_angles(vector(32))));
        let friction = DryFriction::new(x(45), x(46)).breaking_away(x(47));
        let rough = Revolute::about(vector(29)).with(Custom((spring, friction)));
        let rod = Rod::new(x(35), x(36), x(37), x(38), x(39));
        let bob = PointMass::new(x(40), x(41));
        let arm = (Ball, rod, rough, bob);
        let chain = (of(0), Branch(arm), weld, hinge, rod, Ball, of(1));
        System::new(Pinned::on([0.0; 3].map(N::constant)), chain, Free).unwrap().with_gravity(vector(26))
    });
}

/// Derivatives by numbers of a law beyond the sixth are not found: they are refused, and are not zero.
#[test]
fn laws_of_more_than_six_numbers_are_refused() {
    macro_rules! scene {
        ($number:expr) => {{
            let spring = Spring::new($number(3.0)).damped($number(0.4)).resting_at($number(0.2));
            let friction = DryFriction::new($number(0.5), $number(0.3)).breaking_away($number(0.8));
            let law = Custom((spring, friction, Spring::new($number(1.0))));
            let hinge = Revolute::about([0.0, 1.0, 0.0].map($number)).with(law);
            let bob = PointMass::new($number(0.4), $number(0.3));
            let ground = Clamped::at([0.0; 3].map($number), Rotation::from_angles([0.0; 3].map($number)));
            System::new(ground, (hinge, bob), Free).unwrap()
        }};
    }
    let scene = scene!(|x: f64| x);
    let start = scene.at_rest(&[0.1]).unwrap();
    let (mut backward, mut states) = (scene.backward(Rk4), [start; 2]);
    backward.run(&start, 0.01, 1, &[], &mut states).unwrap();
    let gradient = backward.gradient(&[], &states, &mut [], |_, _, by| by.add(&[1.0], &[0.0])).unwrap();
    let fault = gradient.along(&scene!(Jet::<f64, 8>::of)).unwrap_err().fault;
    assert!(matches!(fault, Fault::Count { expected: 6, given: 7, .. }), "{fault:?}");
}

/// Revolute, ball, revolute, revolute, on a hinge that is turned.
macro_rules! mixed {
    ($method:expr, $steps:expr, $h:expr) => {{
        let mut parameters = bodies(4);
        parameters.extend([0.3, 1.0, -0.5, 0.2, 0.1, -0.4, 0.0, 0.3, 0.9]);
        let kinds: Kinds = &[("bodies", 52), ("gravity", 3), ("axes", 9)];
        let name = format!("revolutes about a ball, {:?}", $method);
        gradients!(&name, kinds, parameters, [false, true, false, false], 4, $method, $steps, $h, |x| {
            let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
            let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
            let hinge = |i: usize| Revolute::about(vector(55 + 3 * i));
            let ground = Clamped::at([0.0; 3].map(N::constant), Rotation::from_angles(vector(55)));
            let root = Hinged::on(ground, vector(55));
            let chain = (of(0), Ball, of(1), [(hinge(1), of(2)), (hinge(2), of(3))]);
            System::new(root, chain, Free).unwrap().with_gravity(vector(52))
        })
    }};
}

#[test]
fn revolutes_about_a_ball_have_the_gradients_of_jets() {
    mixed!(Rk4, 3, 0.05);
    mixed!(Dop853, 2, 0.1);
}

// Behind the macro, which it uses.
mod couplings;
mod driven;
mod elastic;
mod floating;
mod held;
mod implicit;
mod joints;
mod lanes;
mod laws;
mod linear_hinges;
mod loads;
mod loops;
mod samples;
mod struts;
mod times;
