//! Second derivatives of runs: the costate sweep over jets of one derivative is a product of the Hessian with a vector, against
//! jets of jets through the same steps.

use catena::Scalar;
use catena::scalar::Jet;

/// What a cost reads of one coordinate and its rate at a step: neither linear nor quadratic.
fn share<T: Scalar<Real = f64>>(step: usize, last: usize, i: usize, q: T, v: T) -> T {
    let weight = 1.0 + 0.1 * i as f64;
    let now = if step == last { 1.0 } else { 0.1 / (1.0 + step as f64) };
    (q * q * v + q + v * v * v).scale(weight * now)
}

/// Checks a scene made of numbers (parameters, coordinates, rates, torques of each step): H d by the costate sweep over `Jet<f64, 1>`
/// against jets of jets.
macro_rules! hessian {
    ($name:literal, $numbers:expr, $n:expr, $joints:expr, $effort:expr, $method:expr, $steps:expr, |$x:ident| $scene:block, $reads:expr, $start:ident) => {{
        let numbers: Vec<f64> = $numbers;
        let direction: Vec<f64> = (0..numbers.len()).map(|k| (1.0 + k as f64).sin()).collect();
        let (steps, h, n, joints): (usize, f64, usize, usize) = ($steps, 0.02, $n, $joints);
        let parameters = numbers.len() - 2 * n - steps * joints;
        // Parts of a number: its value, and its change along the direction.
        let along = |k: usize| Jet::<f64, 1> { re: numbers[k], eps: [direction[k]] };
        let system = {
            type N = Jet<f64, 1>;
            let $x = |k: usize| -> N { along(k) };
            $scene
        };
        type One = Jet<f64, 1>;
        let list = |from: usize, count: usize| -> Vec<One> { (from..from + count).map(along).collect() };
        let start = $start!(system, &list(parameters, n), &list(parameters + n, n));
        let efforts: Vec<_> = list(parameters + 2 * n, steps * joints).into_iter().map($effort).collect();
        let (mut states, mut by_efforts) = (vec![start.clone(); steps + 1], efforts.clone());
        let mut backward = system.backward($method);
        backward.run(&start, h, steps, &efforts, &mut states).unwrap();
        let gradient = backward
            .gradient(&efforts, &states, &mut by_efforts, |step, state, by| {
                let (q, v) = (state.coordinates(), state.rates());
                let q = |i: usize| if $reads { q[i] } else { One::constant(0.0) };
                let parts = |k: usize| -> Vec<One> {
                    (0..n)
                        .map(|i| {
                            share(
                                step,
                                steps,
                                i,
                                Jet::<One, 2>::seed(q(i), if $reads { 0 } else { 2 }),
                                Jet::seed(v[i], 1),
                            )
                            .eps[k]
                        })
                        .collect()
                };
                by.add(&parts(0), &parts(1))
            })
            .unwrap();
        let (mut found, mut expected) = (vec![], vec![]);
        for first in (0..numbers.len()).step_by(8) {
            type J = Jet<One, 8>;
            let number = |k: usize| J::seed(along(k), usize::wrapping_sub(k, first));
            let system = {
                type N = J;
                let $x = |k: usize| -> N { number(k) };
                $scene
            };
            found.extend(gradient.along(&system).unwrap());
            let list = |from: usize, count: usize| -> Vec<J> { (from..from + count).map(number).collect() };
            let mut now = $start!(system, &list(parameters, n), &list(parameters + n, n));
            let (mut next, mut stepper, mut sum) = (now.clone(), system.stepper($method), J::constant(0.0));
            for step in 0..=steps {
                let (q, v) = (now.coordinates(), now.rates());
                let q = |i: usize| if $reads { q[i] } else { J::constant(0.0) };
                sum = (0..n).fold(sum, |sum, i| sum + share(step, steps, i, q(i), v[i]));
                if step < steps {
                    let efforts: Vec<_> =
                        list(parameters + 2 * n + step * joints, joints).into_iter().map($effort).collect();
                    stepper.step(&now, &Loads::none().efforts(efforts), h, &mut next).unwrap();
                    core::mem::swap(&mut now, &mut next);
                }
            }
            expected.extend(sum.eps);
        }
        expected.truncate(numbers.len());
        found.truncate(parameters);
        found.extend(gradient.by_position().into_iter().chain(gradient.by_rate()));
        found.extend(by_efforts.into_iter().flat_map(|effort| Flat::flat(&effort)));
        let kinds = [("parameters", parameters), ("coordinates", n), ("rates", n), ("torques", steps * joints)];
        let mut first = 0;
        for (kind, count) in kinds {
            for (what, part) in [("gradient", (|x: &One| x.re) as fn(&One) -> f64), ("Hessian", |x| x.eps[0])] {
                let of = |list: &[One]| -> Vec<f64> { list[first..first + count].iter().map(part).collect() };
                let (found, expected) = (of(&found), of(&expected));
                let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
                assert!(size > 0.0, "{}: {what} by {kind} is nothing", $name);
                let worst = found.iter().zip(&expected).map(|(f, e)| (f - e).abs() / size);
                let worst = worst.fold(0.0, |a: f64, b| if b.is_nan() { b } else { a.max(b) });
                println!("{}, {what} by {kind}: largest deviation {worst:.1e}", $name);
                assert!(worst < 1e-10, "{}, {what} by {kind}: {found:?} not {expected:?}", $name);
            }
            first += count;
        }
    }};
}

/// Numbers of an effort.
trait Flat<T> {
    fn flat(&self) -> Vec<T>;
}
impl Flat<Jet<f64, 1>> for Jet<f64, 1> {
    fn flat(&self) -> Vec<Self> {
        vec![*self]
    }
}
impl Flat<Jet<f64, 1>> for catena::spatial::Effort<Jet<f64, 1>> {
    fn flat(&self) -> Vec<Jet<f64, 1>> {
        vec![self.0[0] + self.0[1] + self.0[2]]
    }
}

/// What stands without seeds, and the seeds.
trait Split: Sized {
    fn split(self) -> [Self; 2];
}
impl Split for Jet<f64, 1> {
    fn split(self) -> [Self; 2] {
        [self, Self::constant(0.0)]
    }
}
impl Split for Jet<Jet<f64, 1>, 8> {
    fn split(self) -> [Self; 2] {
        [Self::of(self.re), Self { re: Jet::constant(0.0), eps: self.eps }]
    }
}

macro_rules! start_in_the_plane {
    ($system:expr, $q:expr, $v:expr) => {{
        let mut start = $system.motion();
        start.set_coordinates($q).unwrap();
        start.set_rates($v).unwrap();
        start
    }};
}

/// Displaced from angles that are all alike, first along the direction, then by seeds: as gradients take displacements.
macro_rules! start_in_space {
    ($system:expr, $q:expr, $v:expr) => {{
        let (q, v) = ($q, $v);
        let still = $system.at_rest(&vec![q[0].scale(0.0) + Scalar::constant(0.3); q.len()]).unwrap();
        let mut start = $system.with_rates(still, v).unwrap();
        for part in [0, 1] {
            let (mut step, mut list) = (start.rate().clone(), q.iter());
            Rate::replace(&mut step, &mut |_| list.next().unwrap().split()[part]);
            Position::displace(start.position_mut(), &step);
        }
        start
    }};
}

#[test]
fn in_the_plane() {
    use catena::planar::*;
    let mut numbers = vec![0.9, 1.1, 2.0, 0.3, 0.7, 0.9, 0.1, 0.2, 0.8, 0.8, 0.6, 9.7, 3.0, 0.1, 0.2];
    numbers.extend([-1.0, -0.4, 0.3, 0.5, 0.2, -0.3, 0.1, 0.4]);
    numbers.extend((0..5 * 5).map(|k| (0.7 * k as f64).cos()));
    hessian!(
        "a hinge with a spring and a slider, RK4",
        numbers,
        4,
        5,
        |x| x,
        Rk4,
        5,
        |x| {
            let rod = Rod::uniform(x(0), x(1));
            let body = RigidBody::new(x(2), x(3), [x(4), x(6)], [x(5), x(7)]);
            let spring = ElasticHinge::rotary(x(12)).damped(x(13)).resting_at(x(14));
            let chain = (spring, body, Pin, rod, Slider::along(x(8)), Rod::uniform(x(9), x(10)), Pin, rod);
            let root = Clamped::at(N::constant(0.0), N::constant(0.0), N::constant(0.0));
            System::new(root, chain, Free).unwrap().with_gravity(x(11))
        },
        true,
        start_in_the_plane
    );
}

/// Without optimisation too much for the stack of a test.
#[test]
fn in_space() {
    let thread = std::thread::Builder::new().stack_size(1 << 26).spawn(second_in_space).expect("a thread");
    thread.join().expect("a Hessian of jets");
}

fn second_in_space() {
    use catena::spatial::*;
    use catena::system::{Position, Rate};
    let mut numbers = vec![1.2, 0.2, 0.25, 0.3, 0.02, -0.03, 0.01, 0.3, 0.1, -0.05, 0.7, -0.2, 0.15]; // a body
    numbers.extend([0.5, -9.0, 1.0, 0.4, 0.3, 1.0, 3.0, 0.4, 0.2, 0.5, -0.4]); // gravity, an axis, a spring, a rod
    numbers.extend([0.1, -0.4, 0.3, 0.5, 0.2, -0.3, 0.1, 0.4, 0.7, -0.5, 0.6, -0.8, 0.9, 1.1]);
    numbers.extend((0..3 * 3).map(|k| (0.7 * k as f64).cos()));
    numbers[22] = 0.9;
    numbers[23] = 0.6;
    hessian!(
        "a ball, a revolute, a ball, RK4",
        numbers,
        7,
        3,
        |x| Effort([x; 3]),
        Rk4,
        3,
        |x| {
            let [m, xx, yy, zz, xy, xz, yz, a, b, c, d, e, f] = core::array::from_fn(&x);
            let body = RigidBody::new(m, [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], [a, b, c], [d, e, f]);
            let spring = Spring::new(x(19)).damped(x(20)).resting_at(x(21));
            let hinge = Revolute::about([16, 17, 18].map(&x)).with(spring);
            let rod = Rod::uniform(x(22), N::constant(0.05), x(23));
            let root = Pinned::on([0.0; 3].map(N::constant));
            System::new(root, (body, hinge, body, Ball, rod), Free).unwrap().with_gravity([13, 14, 15].map(&x))
        },
        false,
        start_in_space
    );
}
