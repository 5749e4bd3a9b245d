//! Gradients of runs that go backward: against jets through the same steps, kind by kind, and against central differences.

use catena::planar::{SpringLaw, Springs};
use catena::scalar::Jet;
use catena::{Fault, Scalar};
use catena_oracle::Noise;

/// What the macro below names.
mod names {
    pub(super) use super::{OF_TREE, ROUNDING, Stiffening, TREE, agrees, alike, by_jets, moving, share, with_motion};
    pub(super) use catena::Scalar;
    pub(super) use catena::planar::*;
    pub(super) use catena::scalar::Jet;
    pub(super) use catena_oracle::{Noise, derivative, near};
}

/// Some thousand roundings.
const ROUNDING: f64 = 1e-12;

/// Those of samples that DOP853 interpolates between steps to a held tip: its weights cancel, and so do parts of a gradient by lengths, whose
/// deviations are 4e-13 to 5e-12 as one of the lengths goes from 0.9 to 0.915 m in sixteen steps.
const ROUNDING_BETWEEN: f64 = 1e-11;

/// Numbers of one kind: what they are called, and how many there are.
type Kinds<'k> = &'k [(&'k str, usize)];

/// Each number agrees to a share of the largest of its kind.
#[track_caller]
fn alike(name: &str, kinds: Kinds, found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), kinds.iter().map(|kind| kind.1).sum::<usize>());
    assert_eq!(found.len(), expected.len());
    assert!(found.iter().all(|x| x.is_finite()), "{name}: {found:?}"); // the largest of deviations would not say so
    let mut first = 0;
    for &(kind, count) in kinds {
        let (found, expected) = (&found[first..][..count], &expected[first..][..count]);
        let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        assert!(size > 0.0, "{name}: {kind} do nothing");
        let worst = found.iter().zip(expected).fold(0.0_f64, |worst, (f, e)| worst.max((f - e).abs() / size));
        println!("{name}, {kind}: largest deviation {worst:.1e}");
        assert!(worst <= tolerance, "{name}, {kind}: {found:?} not {expected:?}");
        first += count;
    }
}

/// Coordinates, rates, and torques of all steps, at random: what comes last among the numbers of a run.
fn moving(noise: &mut Noise, coordinates: usize, torques: usize) -> Vec<f64> {
    let mut list: Vec<f64> = (0..coordinates).map(|_| noise.between(-1.0, 0.5)).collect();
    list.extend((0..coordinates).map(|_| noise.next()));
    list.extend((0..torques).map(|_| 0.5 * noise.next()));
    list
}

/// Kinds of parameters, and those of the coordinates, rates and torques that come after them.
fn with_motion(parameters: &[(&'static str, usize)], coordinates: usize, torques: usize) -> Vec<(&'static str, usize)> {
    [parameters, &[("coordinates", coordinates), ("rates", coordinates), ("torques", torques)]].concat()
}

/// A number with eight derivatives.
type Eight = Jet<f64, 8>;

/// Derivatives by all numbers, eight at a time: of a cost over jets, and along the scene that its own constructor makes of these.
fn by_jets(numbers: &[f64], mut of: impl FnMut(&dyn Fn(usize) -> Eight) -> [[f64; 8]; 2]) -> [Vec<f64>; 2] {
    let mut both = [vec![], vec![]];
    for first in (0..numbers.len()).step_by(8) {
        let number = |k: usize| Eight::seed(numbers[k], usize::wrapping_sub(k, first));
        both.iter_mut().zip(of(&number)).for_each(|(list, more)| list.extend(more));
    }
    both
}

/// What was found agrees with what jets expect, and with central differences of order 4 by some of the numbers.
#[track_caller]
fn agrees(
    name: &str,
    kinds: Kinds,
    numbers: &[f64],
    ([expected, found], rounding): ([&[f64]; 2], f64),
    some: fn(&usize) -> bool,
    cost: impl Fn(&dyn Fn(usize) -> f64) -> f64,
) {
    alike(name, kinds, found, expected, rounding);
    let some: Vec<usize> = (0..numbers.len()).filter(some).collect();
    let difference = |&j: &usize| {
        let e = 2e-4 * numbers[j].abs().max(0.1);
        let at = |e: f64| cost(&|k: usize| numbers[k] + if k == j { e } else { 0.0 });
        catena_oracle::derivative(e, at)
    };
    let differences: Vec<f64> = some.iter().map(difference).collect();
    let found: Vec<f64> = some.iter().map(|j| found[*j]).collect();
    let (mut first, mut fewer) = (0, kinds.to_vec());
    for kind in &mut fewer {
        let next = first + kind.1;
        (kind.1, first) = (some.iter().filter(|j| (first..next).contains(*j)).count(), next);
    }
    fewer.retain(|kind| kind.1 > 0);
    alike(name, &fewer, &found, &differences, 1e-6);
}

/// What a cost reads of one coordinate and its rate at a step: it is quadratic, and unlike for each of them.
fn share<T: Scalar<Real = f64>>(step: usize, last: usize, i: usize, q: T, v: T) -> T {
    let weight = 1.0 + 0.1 * i as f64;
    if step == last { q.scale(weight) + (v * v).scale(0.5) } else { (q * v).scale(0.01 * weight / (1.0 + step as f64)) }
}

/// A spring and a damper that stiffen: −k (φ + φ³) − c (1 + φ²) φ̇.
#[derive(Clone, Copy, Debug)]
struct Stiffening<T> {
    stiffness: T,
    damping: T,
}
catena::lift!(Stiffening { stiffness, damping });

impl<T: Scalar> SpringLaw<T> for Stiffening<T> {
    fn force(&self, position: T, rate: T) -> T {
        let square = position * position + T::one();
        -(self.stiffness * position + self.damping * rate) * square
    }
    fn energy(&self, position: T) -> T {
        let square = position * position;
        self.stiffness * square * (T::literal(0.5) + T::literal(0.25) * square)
    }
    fn pivot(&self, position: T, rate: T, springs: impl Springs<T>) -> T {
        let (square, two) = (position * position, T::literal(2.0));
        let slope = self.stiffness * (T::one() + T::literal(3.0) * square) + two * self.damping * position * rate;
        springs.pivot(slope, self.damping * (T::one() + square))
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

/// Numbers of [`tree`]: a rod, a rigid body, a bob; hinge, direction and spring of a slider, a weld; the root, gravity.
const TREE: [f64; 22] = [
    1.0, 0.8, 0.35, 0.07, 1.3, 0.2, 0.4, 0.1, 0.8, -0.2, 0.6, 0.9, 12.0, 0.3, 0.4, -0.4, 40.0, 0.3, 0.2, 0.1, 0.3, 9.81,
];
/// What they are.
const OF_TREE: [(&str, usize); 5] =
    [("bodies", 12), ("joints", 6), ("place of the root", 2), ("its angle", 1), ("gravity", 1)];

/// All bodies and joints, an arm, a clamped root at a place.
macro_rules! tree {
    ($N:ty, $x:expr) => {{
        let x = $x;
        let rod = Rod::<$N>::new(x(0), x(1), x(2), x(3));
        let rigid = RigidBody::<$N>::new(x(4), x(5), [x(6), x(7)], [x(8), x(9)]);
        let bob = PointMass::<$N>::new(x(10), x(11));
        let hinge = ElasticHinge::rotary(x(12)).damped(x(13)).resting_at(x(14));
        let piston = Slider::along(x(15)).with(Spring::new(x(16)));
        let chain =
            (hinge, rigid, Branch((Pin, bob)), Pin, rod, piston, rigid, hinge, rod, Weld::at(x(17)), rod, Pin, bob);
        System::new(Clamped::at(x(18), x(19), x(20)), chain, Free).unwrap().with_gravity(x(21))
    }};
}

/// What acts: `under` a law on bodies, what is `pulled` by struts, or `coupled` joints of a scene, listed with a law beside them.
macro_rules! acting {
    (under, on_bodies: $law:expr, $scene:expr) => {
        $law
    };
    (under, beside: $efforts:expr, $law:expr, $scene:expr) => {
        $efforts.on_bodies_by($law)
    };
    (under, joined: $start:expr, $law:expr, $scene:expr) => {{
        let _ = $law;
        $start
    }};
    (under, by_numbers: $gradient:expr) => {
        $gradient.by_loads().unwrap().to_vec()
    };
    (pulled, on_bodies: $law:expr, $scene:expr) => {
        Struts::of($law.0).and(Loads::none().on_bodies_by($law.1))
    };
    (pulled, beside: $efforts:expr, $law:expr, $scene:expr) => {
        Struts::of($law.0).and($efforts.on_bodies_by($law.1))
    };
    (pulled, joined: $start:expr, $law:expr, $scene:expr) => {
        acting!(under, joined: $start, $law, $scene)
    };
    (pulled, by_numbers: $gradient:expr) => {{
        let mut list: Vec<f64> = vec![];
        for by in $gradient.by_struts() {
            list.extend(by.ends.iter().flatten().chain([&by.stiffness, &by.damping, &by.length]));
        }
        list.extend($gradient.by_struts().iter().flat_map(|by| by.law()));
        list.extend($gradient.by_loads().unwrap());
        list
    }};
    (coupled, on_bodies: $law:expr, $scene:expr) => {
        Couplings::of($scene, $law.0).unwrap().and(Loads::none().on_bodies_by($law.1))
    };
    (coupled, beside: $efforts:expr, $law:expr, $scene:expr) => {
        Couplings::of($scene, $law.0).unwrap().and($efforts.on_bodies_by($law.1))
    };
    (coupled, joined: $start:expr, $law:expr, $scene:expr) => {
        Couplings::of($scene, $law.0).unwrap().joined($start)
    };
    (coupled, by_numbers: $gradient:expr) => {{
        let mut list = $gradient.by_ratios().to_vec();
        list.extend($gradient.by_loads().unwrap());
        list
    }};
}

/// A scene from numbers, run by fixed steps, as plain numbers backward and over jets by the rule itself: the gradient of a cost by all
/// numbers. The scene's constructor takes each from `$number`, by its place in the list: parameters, the last of them those of a law of
/// loads if there is one, then coordinates, rates, and torques.
macro_rules! gradients {
    ($name:expr, $kinds:expr, $numbers:expr, [$angles:expr, $joints:expr], $method:expr, $steps:expr, $h:expr, |$x:ident| $scene:block) => {
        gradients!(
            $name,
            $kinds,
            $numbers,
            [$angles, $joints],
            $method,
            $steps,
            $h,
            |$x| $scene,
            under(0, |_none| { Absent })
        )
    };
    ($name:expr, $kinds:expr, $numbers:expr, [$angles:expr, $joints:expr], $method:expr, $steps:expr, $h:expr, |$x:ident| $scene:block,
     $act:ident ($of_law:expr, |$y:ident| $law:block)) => {{
        let (numbers, steps, h, n, joints): (Vec<f64>, usize, f64, usize, usize) =
            ($numbers, $steps, $h, $angles, $joints);
        let parameters = numbers.len() - 2 * n - steps * joints;
        // Over numbers: the cost of the run.
        macro_rules! cost {
            ($N:ty, $number:expr) => {{
                let $x = $number;
                let of: Vec<$N> = (0..numbers.len()).map(&$x).collect();
                let system = {
                    type N = $N;
                    $scene
                };
                let law = {
                    type N = $N;
                    let $y = |k: usize| -> N { of[k] };
                    $law
                };
                let mut now = system.motion();
                now.set_coordinates(&of[parameters..][..n]).unwrap();
                now.set_rates(&of[parameters + n..][..n]).unwrap();
                let (mut next, mut stepper, mut sum) = (now.clone(), system.stepper($method), <$N>::constant(0.0));
                for step in 0..=steps {
                    let (positions, rates) = (now.coordinates(), now.rates());
                    for i in 0..n {
                        sum += share(step, steps, i, positions[i], rates[i]);
                    }
                    if step < steps {
                        let torques = &of[parameters + 2 * n + step * joints..][..joints];
                        let torques = Loads::none().torques(torques.to_vec());
                        stepper.step(&now, &acting!($act, beside: torques, law, &system), h, &mut next).unwrap();
                        core::mem::swap(&mut now, &mut next);
                    }
                }
                sum
            }};
        }
        // Backward.
        let system = {
            type N = f64;
            let $x = |k: usize| -> N { numbers[k] };
            $scene
        };
        let mut start = system.motion();
        start.set_coordinates(&numbers[parameters..][..n]).unwrap();
        start.set_rates(&numbers[parameters + n..][..n]).unwrap();
        let (mut states, torques) = (vec![start.clone(); steps + 1], &numbers[parameters + 2 * n..]);
        let mut by_torques = vec![0.0; torques.len()];
        let law = {
            type N = f64;
            let $y = |k: usize| -> N { numbers[k] };
            $law
        };
        let mut backward = system.backward($method).under(acting!($act, on_bodies: law, &system));
        backward.run(&start, h, steps, torques, &mut states).unwrap();
        let mut total = 0.0;
        let gradient = backward
            .gradient(torques, &states, &mut by_torques, |step, state, by| {
                let (q, v) = (state.coordinates(), state.rates());
                let parts = |k: usize| -> Vec<f64> {
                    (0..n)
                        .map(|i| share(step, steps, i, Jet::<f64, 2>::seed(q[i], 0), Jet::seed(v[i], 1)).eps[k])
                        .collect()
                };
                total += (0..n).map(|i| share(step, steps, i, q[i], v[i])).sum::<f64>();
                by.add(&parts(0), &parts(1))
            })
            .unwrap();
        // The number itself is that of the rule, but for the order in which shares are added up.
        let plain = cost!(f64, |k: usize| -> f64 { numbers[k] });
        near(total, plain, 1e-12 * (1.0 + plain.abs()));
        let [mut expected, mut found] = by_jets(&numbers, |number| {
            let system = {
                type N = Jet<f64, 8>;
                let $x = number;
                $scene
            };
            [cost!(Jet<f64, 8>, number).eps, gradient.along(&system).unwrap()]
        });
        expected.truncate(numbers.len());
        found.truncate(parameters - $of_law);
        found.extend(acting!($act, by_numbers: gradient));
        found.extend(gradient.by_position().into_iter().chain(gradient.by_rate()).chain(by_torques));
        let cost = |number: &dyn Fn(usize) -> f64| cost!(f64, number);
        agrees($name, $kinds, &numbers, ([&expected, &found], ROUNDING), |_| true, cost);
    }};
}

// Behind the macro, which they use.
mod attitudes;
mod chains;
mod couplings;
mod driven;
mod events_over_time;
mod joints;
mod laws;
mod linear;
mod linear_hinges;
mod loads;
mod long;
mod loops;
mod misuse;
mod samples;
mod space;
mod starts;
mod struts;
mod times;
