//! Gradients backward of scenes at random, seeded, every part against central differences: at rest, straight, folded, hanging, with axes and
//! attitudes that coincide, without gravity, with light bodies beside heavy ones.
//!
//! Twenty-five scenes of each family unless `CATENA_SCENES` says how many in all: `CATENA_SCENES=10000 cargo test --profile long -p catena-derivatives
//! at_random -- --nocapture`.

use catena::Scalar;
use catena::scalar::Jet;
use catena_oracle::Noise;

const STEPS: usize = 3;
const STEP: f64 = 0.01;
/// Of the largest of its kind; kinds that are smaller than this share of all are measured by that.
const TOLERANCE: f64 = 1e-6;
const SMALL: f64 = 1e-4;

/// Draws numbers of a scene, some of them special.
struct Draw(Noise);

impl Draw {
    /// One of so many.
    fn pick(&mut self, count: usize) -> usize {
        (self.0.between(0.0, count as f64) as usize).min(count - 1)
    }
    fn length(&mut self) -> f64 {
        self.0.between(0.3, 1.2)
    }
    /// Light ones beside heavy ones.
    fn mass(&mut self) -> f64 {
        10.0_f64.powf(self.0.between(-1.0, 1.0))
    }
    fn rods(&mut self, count: usize) -> Vec<f64> {
        let lengths: Vec<f64> = (0..count).map(|_| self.length()).collect();
        lengths.into_iter().chain((0..count).map(|_| self.mass()).collect::<Vec<_>>()).collect()
    }
    /// Mass, moment of inertia, mass centre and outboard end of a body in the plane.
    fn rigid(&mut self) -> [f64; 6] {
        let (m, l) = (self.mass(), self.length());
        [m, 0.1 * m * l * l, 0.5 * l, 0.2 * l * self.0.next(), l, 0.3 * l * self.0.next()]
    }
    fn spring(&mut self) -> [f64; 3] {
        [self.0.between(0.0, 20.0), self.0.between(0.0, 0.3), self.0.next()]
    }
    fn gravity(&mut self) -> f64 {
        [0.0, 9.81, 9.81][self.pick(3)]
    }
    /// Angles: any, straight, hanging, folded.
    fn angles(&mut self, count: usize) -> Vec<f64> {
        let kind = self.pick(5);
        let special = |i: usize| [0.0, -core::f64::consts::FRAC_PI_2, core::f64::consts::PI * (i % 2) as f64][kind - 2];
        (0..count).map(|i| if kind < 2 { self.0.between(-3.0, 3.0) } else { special(i) }).collect()
    }
    /// Rates: any, or none.
    fn rates(&mut self, count: usize) -> Vec<f64> {
        let size = [0.0, 1.0, 1.0][self.pick(3)];
        (0..count).map(|_| size * self.0.next()).collect()
    }
    /// An axis, any or one of the frame's.
    fn axis(&mut self) -> [f64; 3] {
        let any = [self.0.next(), self.0.next(), 1.2 + self.0.next()];
        [any, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]][self.pick(3)]
    }
    /// Mass, tensor, mass centre and outboard end of a body in space.
    fn body(&mut self) -> [f64; 13] {
        let (m, l) = (self.mass(), self.length());
        let j = 0.1 * m * l * l;
        let mut off = || 0.1 * self.0.next();
        let [xy, xz, yz, a, b, c, d] = core::array::from_fn(|_| off());
        [m, j, 1.3 * j, 1.5 * j, j * xy, j * xz, j * yz, 0.5 * l, l * a, l * b, l, l * c, l * d]
    }
}

/// What a cost reads of a coordinate and its rate.
fn share<T: Scalar<Real = f64>>(step: usize, i: usize, q: T, v: T) -> T {
    let weight = (1.0 + 0.3 * i as f64) * if step == STEPS { 1.0 } else { 0.1 };
    ((q * q).scale(0.5) + q + v + (v * v).scale(0.3)).scale(weight)
}

/// The largest deviation of all parts, by kind; nothing where a tip cannot be put where it is held.
macro_rules! worst {
    ($space:ident, $parameters:expr, $angles:expr, $rates:expr, $joints:expr, $per:literal, |$x:ident| $scene:expr) => {{
        use catena::$space::*;
        let (mut numbers, angles, rates): (Vec<f64>, Vec<f64>, Vec<f64>) = ($parameters, $angles, $rates);
        let (parameters, n, torques) = (numbers.len(), angles.len(), STEPS * $joints * $per);
        macro_rules! scene {
            ($N:ty, $number:expr) => {{
                type N = $N;
                let $x = $number;
                $scene.unwrap()
            }};
        }
        let of = |list: &[f64]| {
            let system = scene!(f64, |k: usize| -> f64 { list[k] });
            let start = start!($space, system, &angles, &list[parameters..][..n], &list[parameters + n..][..n]);
            let efforts = efforts!($space, &list[parameters + 2 * n..]);
            (system, start, efforts)
        };
        // Positions: displacements from those that are closed, or from the angles.
        let mut list = numbers.clone();
        list.extend((0..n).map(|_| 0.0).chain(rates).chain((0..torques).map(|k| 0.02 * (1.3 * k as f64).sin())));
        let (system, start, _) = of(&list);
        let Ok(closed) = system.assembled(start, &Unloaded) else { return None };
        let (at, rates) = (base!($space, closed, angles), closed.rates());
        let angles = at;
        numbers.extend((0..n).map(|_| 0.0).chain(rates).chain((0..torques).map(|k| 0.02 * (1.3 * k as f64).sin())));
        let of = |list: &[f64]| {
            let system = scene!(f64, |k: usize| -> f64 { list[k] });
            let start = start!($space, system, &angles, &list[parameters..][..n], &list[parameters + n..][..n]);
            let efforts = efforts!($space, &list[parameters + 2 * n..]);
            (system, start, efforts)
        };
        const READS: bool = $per == 1;
        let cost = |list: &[f64]| {
            let (system, mut now, efforts) = of(list);
            let (mut next, mut stepper, mut sum) = (now.clone(), system.stepper(Rk4), 0.0);
            for step in 0..=STEPS {
                let (q, v) = (now.coordinates(), now.rates());
                sum += (0..n).map(|i| share(step, i, if READS { q[i] } else { 0.0 }, v[i])).sum::<f64>();
                if step < STEPS {
                    let held = efforts[step * $joints..][..$joints].to_vec();
                    stepper.step(&now, &Loads::none().efforts(held), STEP, &mut next).unwrap();
                    core::mem::swap(&mut now, &mut next);
                }
            }
            sum
        };
        let (system, start, efforts) = of(&numbers);
        let (mut states, mut by_efforts) = (vec![start.clone(); STEPS + 1], efforts.clone());
        let mut backward = system.backward(Rk4);
        backward.run(&start, STEP, STEPS, &efforts, &mut states).unwrap();
        let gradient = backward
            .gradient(&efforts, &states, &mut by_efforts, |step, state, by| {
                let (q, v) = (state.coordinates(), state.rates());
                let parts = |k: usize| -> Vec<f64> {
                    let seeded = |i: usize| {
                        let q = if READS { Jet::<f64, 2>::seed(q[i], 0) } else { Jet::of(0.0) };
                        share(step, i, q, Jet::seed(v[i], 1)).eps[k]
                    };
                    (0..n).map(seeded).collect()
                };
                by.add(&parts(0), &parts(1))
            })
            .unwrap();
        let mut found = vec![];
        for first in (0..parameters).step_by(8) {
            type J = Jet<f64, 8>;
            let number = |k: usize| -> J { J::seed(numbers[k], usize::wrapping_sub(k, first)) };
            found.extend(gradient.along(&scene!(J, number)).unwrap());
        }
        found.truncate(parameters);
        found.extend(gradient.by_position().into_iter().chain(gradient.by_rate()));
        by_efforts.iter().for_each(|effort| flat!($space, effort, found));
        assert_eq!(found.len(), numbers.len());
        let expected: Vec<f64> = (0..numbers.len())
            .map(|k| {
                // Entries of tensors are small, and so have to be their differences.
                let least = if k < parameters && numbers[k] != 0.0 { 5e-3 } else { 0.1 };
                let e = 2e-4 * numbers[k].abs().max(least);
                let at = |e: f64| {
                    let mut list = numbers.clone();
                    list[k] += e;
                    cost(&list)
                };
                (8.0 * (at(e) - at(-e)) - (at(2.0 * e) - at(-2.0 * e))) / (12.0 * e)
            })
            .collect();
        let size = |list: &[f64]| list.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let (all, mut first, mut worst) = (size(&expected), 0, 0.0_f64);
        assert!(found.iter().all(|x| x.is_finite()), "{found:?}");
        for count in [parameters, n, n, torques] {
            let (found, expected) = (&found[first..][..count], &expected[first..][..count]);
            let size = size(expected).max(SMALL * all);
            worst = found.iter().zip(expected).fold(worst, |worst, (f, e)| worst.max((f - e).abs() / size));
            first += count;
        }
        Some(worst)
    }};
}

/// Begins displaced from coordinates (of the plane) or angles (of space).
macro_rules! start {
    (planar, $system:expr, $angles:expr, $displaced:expr, $rates:expr) => {{
        let mut start = $system.motion();
        let at: Vec<_> = $angles.iter().zip($displaced).map(|(a, d)| a + d).collect();
        start.set_coordinates(&at).unwrap();
        start.set_rates($rates).unwrap();
        start
    }};
    (spatial, $system:expr, $angles:expr, $displaced:expr, $rates:expr) => {{
        let mut start = $system.with_rates($system.at_rest($angles).unwrap(), $rates).unwrap();
        let (mut step, mut list) = (start.rate().clone(), $displaced.iter());
        catena::system::Rate::<f64>::replace(&mut step, &mut |_| *list.next().unwrap());
        catena::system::Position::<f64>::displace(start.position_mut(), &step);
        start
    }};
}
macro_rules! base {
    (planar, $closed:expr, $angles:expr) => {
        $closed.coordinates()
    };
    (spatial, $closed:expr, $angles:expr) => {
        $angles
    };
}
macro_rules! efforts {
    (planar, $list:expr) => {
        $list.to_vec()
    };
    (spatial, $list:expr) => {
        $list.chunks(3).map(|t| Effort([t[0], t[1], t[2]])).collect::<Vec<_>>()
    };
}
macro_rules! flat {
    (planar, $effort:expr, $list:ident) => {
        $list.push(*$effort)
    };
    (spatial, $effort:expr, $list:ident) => {
        $list.extend($effort.0)
    };
}

/// The largest deviation of a scene of a family.
type Family = fn(&mut Draw) -> Option<f64>;

const FAMILIES: [(&str, Family); 9] = [
    ("rods on pins", |draw| {
        let parameters = [draw.rods(3), vec![draw.gravity()]].concat();
        worst!(planar, parameters, draw.angles(3), draw.rates(3), 3, 1, |x| {
            let rod = |i: usize| Rod::<N>::uniform(x(i), x(3 + i));
            System::new(Pinned::origin(), (rod(0), Pin, rod(1), Pin, rod(2)), Free)
                .map(|scene| scene.with_gravity(x(6)))
        })
    }),
    ("bodies on hinges", |draw| {
        let parameters = [
            &draw.rigid()[..],
            &draw.rigid(),
            &draw.spring(),
            &draw.spring(),
            &[draw.gravity(), 0.1, 0.3, draw.0.next()],
        ];
        let parameters = parameters.concat();
        worst!(planar, parameters, draw.angles(3), draw.rates(3), 4, 1, |x| {
            let rigid = |i: usize| RigidBody::<N>::new(x(i), x(i + 1), [x(i + 2), x(i + 3)], [x(i + 4), x(i + 5)]);
            let hinge = |i: usize| ElasticHinge::rotary(x(i)).damped(x(i + 1)).resting_at(x(i + 2));
            let chain = (hinge(12), rigid(0), hinge(15), rigid(6), Pin, rigid(0));
            System::new(Clamped::at(x(19), x(20), x(21)), chain, Free).map(|scene| scene.with_gravity(x(18)))
        })
    }),
    ("sliders", |draw| {
        let parameters = [
            &draw.rigid()[..],
            &draw.rods(2),
            &[draw.0.next(), 3.0 * draw.0.next()],
            &draw.spring(),
            &[draw.gravity()],
        ];
        let parameters = parameters.concat();
        worst!(planar, parameters, draw.angles(4), draw.rates(4), 5, 1, |x| {
            let cart = RigidBody::<N>::new(x(0), x(1), [x(2), x(3)], [x(4), x(5)]);
            let track = Slider::along(x(10)).with(Spring::new(x(12)).damped(x(13)).resting_at(x(14)));
            let (rod, bob) = (Rod::uniform(x(6), x(8)), PointMass::new(x(7), x(9)));
            let chain = (track, cart, Pin, rod, Slider::along(x(11)), rod, Pin, bob);
            System::new(Clamped::origin(), chain, Free).map(|scene| scene.with_gravity(x(15)))
        })
    }),
    ("trees in the plane", |draw| {
        let parameters = [&draw.rods(3)[..], &draw.rigid(), &[draw.0.next(), draw.gravity()]].concat();
        worst!(planar, parameters, draw.angles(4), draw.rates(4), 5, 1, |x| {
            let rod = |i: usize| Rod::<N>::uniform(x(i), x(3 + i));
            let body = RigidBody::<N>::new(x(6), x(7), [x(8), x(9)], [x(10), x(11)]);
            let chain = (rod(0), Branch((Pin, rod(1), Weld::at(x(12)), body)), Pin, body, Branch((Pin, rod(2))));
            System::new(Pinned::origin(), chain, Free).map(|scene| scene.with_gravity(x(13)))
        })
    }),
    ("pinned tips", |draw| {
        let parameters = [draw.rods(4), vec![draw.0.between(0.3, 1.0), 0.3 * draw.0.next(), draw.gravity()]].concat();
        let angles = [1.0, 0.3, -0.4, -1.2].map(|angle| angle + 0.3 * draw.0.next()).to_vec();
        worst!(planar, parameters, angles, draw.rates(4), 4, 1, |x| {
            let rod = |i: usize| Rod::<N>::uniform(x(i), x(4 + i));
            let chain = (rod(0), Pin, rod(1), Pin, rod(2), Pin, rod(3));
            System::new(Pinned::origin(), chain, Pinned::at(x(8), x(9))).map(|scene| scene.with_gravity(x(10)))
        })
    }),
    ("guided tips", |draw| {
        let tip = vec![draw.0.between(0.3, 1.0), 0.3 * draw.0.next(), 0.5 * draw.0.next()];
        let parameters = [draw.rods(4), tip, vec![draw.gravity()]].concat();
        let angles = [1.0, 0.3, -0.4, -1.2].map(|angle| angle + 0.3 * draw.0.next()).to_vec();
        worst!(planar, parameters, angles, draw.rates(4), 4, 1, |x| {
            let rod = |i: usize| Rod::<N>::uniform(x(i), x(4 + i));
            let chain = (rod(0), Pin, rod(1), Pin, rod(2), Pin, rod(3));
            System::new(Pinned::origin(), chain, Guided::at(x(8), x(9), x(10))).map(|scene| scene.with_gravity(x(11)))
        })
    }),
    ("bodies on balls", |draw| {
        let parameters = [&draw.body()[..], &draw.body(), &[0.2, draw.gravity(), 0.1]].concat();
        worst!(spatial, parameters, draw.angles(6), draw.rates(6), 2, 3, |x| {
            let of = |i: usize| {
                let [m, xx, yy, zz, xy, xz, yz, a, b, c, d, e, f] = core::array::from_fn(|k| x(13 * i + k));
                RigidBody::<N>::new(m, [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], [a, b, c], [d, e, f])
            };
            let root = Pinned::on([0.0; 3].map(N::constant));
            System::new(root, (of(0), Ball, of(1)), Free).map(|scene| scene.with_gravity([26, 27, 28].map(&x)))
        })
    }),
    ("bodies on revolutes", |draw| {
        let parameters =
            [&draw.body()[..], &draw.axis(), &draw.axis(), &draw.spring(), &[0.2, draw.gravity(), 0.1]].concat();
        worst!(spatial, parameters, draw.angles(3), draw.rates(3), 4, 3, |x| {
            let [m, xx, yy, zz, xy, xz, yz, a, b, c, d, e, f] = core::array::from_fn(&x);
            let body = RigidBody::<N>::new(m, [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], [a, b, c], [d, e, f]);
            let hinge = Revolute::about([13, 14, 15].map(&x));
            let sprung = Revolute::about([16, 17, 18].map(&x)).with(Spring::new(x(19)).damped(x(20)).resting_at(x(21)));
            let root = Clamped::at([0.0; 3].map(N::constant), Rotation::from_angles([0.3, 0.1, -0.2].map(N::constant)));
            let chain = (hinge, body, sprung, body, hinge, body);
            System::new(root, chain, Free).map(|scene| scene.with_gravity([22, 23, 24].map(&x)))
        })
    }),
    ("balls, revolutes, welds and arms", |draw| {
        let parameters =
            [&draw.body()[..], &draw.axis(), &draw.rods(1), &draw.axis(), &[0.2, draw.gravity(), 0.1]].concat();
        worst!(spatial, parameters, draw.angles(8), draw.rates(8), 5, 3, |x| {
            let [m, xx, yy, zz, xy, xz, yz, a, b, c, d, e, f] = core::array::from_fn(&x);
            let body = RigidBody::<N>::new(m, [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], [a, b, c], [d, e, f]);
            let (hinge, weld) =
                (Revolute::about([13, 14, 15].map(&x)), Weld::at(Rotation::from_angles([18, 19, 20].map(&x))));
            let rod = Rod::uniform(x(16), N::constant(0.3), x(17));
            let chain = (body, Branch((hinge, body)), weld, rod, Ball, body, hinge, rod);
            let root = Pinned::on([0.0; 3].map(N::constant));
            System::new(root, chain, Free).map(|scene| scene.with_gravity([21, 22, 23].map(&x)))
        })
    }),
];

#[test]
fn every_part_is_that_of_central_differences() {
    let scenes = std::env::var("CATENA_SCENES").map_or(25 * FAMILIES.len(), |count| count.parse().unwrap());
    let mut worst = [(0.0_f64, 0, 0); FAMILIES.len()];
    for seed in 0..scenes {
        let (name, family) = FAMILIES[seed % FAMILIES.len()];
        let mut draw = Draw(Noise::new(seed as u64));
        let Some(found) = (0..50).find_map(|_| family(&mut draw)) else { panic!("{name}, {seed}: not assembled") };
        assert!(found < TOLERANCE, "{name}, {seed}: {found:.1e}");
        let (largest, at, count) = &mut worst[seed % FAMILIES.len()];
        (*count, *at) = (*count + 1, if found > *largest { seed } else { *at });
        *largest = largest.max(found);
    }
    for ((name, _), (largest, seed, count)) in FAMILIES.iter().zip(worst) {
        println!("{name}: {count} scenes, largest deviation {largest:.1e} (seed {seed})");
    }
}
