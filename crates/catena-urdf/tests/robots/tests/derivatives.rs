//! Derivatives of the dynamics of shipped robots, against jets through inverse dynamics, which knows nothing of them.

use catena::robot::{Afloat, Blocks, ByState, Columns, MassMatrix, Place};
use catena::scalar::Jet;
use catena_urdf_robots::{arm7_local, cart_local, humanoid_local, quadruped_fixed, quadruped_local};
use std::error::Error;

/// Relative to the largest number: rounding, and that times the condition of the mass matrix, which takes −M⁻¹ times what accelerations take.
const DIRECT: f64 = 1e-12;
const INVERTED: f64 = 1e-11;

type Dual = Jet<f64, 1>;
type Outcome = Result<(), Box<dyn Error>>;

/// Numbers in (−1, 1), by the multiplier of L'Ecuyer for 64 bits.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(3_935_559_000_370_003_845).wrapping_add(2_691_343_689_449_507_681);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
    fn list<const N: usize>(&mut self, size: f64) -> [f64; N] {
        std::array::from_fn(|_| size * self.next())
    }
}

/// A column of a matrix against the one expected.
#[track_caller]
fn agrees(found: &[f64], expected: &[f64], size: f64, tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (x, y) in found.iter().zip(expected) {
        assert!((x - y).abs() <= tolerance * size, "{x} and {y} of {size}");
    }
}

fn largest(lists: &[Vec<f64>]) -> f64 {
    lists.iter().flatten().fold(f64::MIN_POSITIVE, |most, x| most.max(x.abs()))
}

/// A list of which number k changes.
fn seeded<const N: usize>(list: &[f64; N], k: usize) -> [Dual; N] {
    std::array::from_fn(|i| if i == k { Jet::seed(list[i], 0) } else { Jet::of(list[i]) })
}

/// Derivatives by jets, column by column, of positions or rates: those of inverse dynamics, against these and, times M, against those of
/// forward dynamics.
fn compare(jets: &[Vec<f64>], taken: impl Fn(usize) -> Vec<f64>, moved: impl Fn(usize) -> Vec<f64>, mass: &[Vec<f64>]) {
    let size = largest(jets);
    for (k, by) in jets.iter().enumerate() {
        agrees(&taken(k), by, size, DIRECT);
        let moved = moved(k);
        let back: Vec<f64> = mass.iter().map(|row| -row.iter().zip(&moved).map(|(a, b)| a * b).sum::<f64>()).collect();
        agrees(&back, by, size, INVERTED);
    }
}

/// A matrix times another one is one: relative to the largest sum of what is added up for a number of it.
fn inverts(inverse: &[Vec<f64>], mass: &[Vec<f64>]) {
    for (i, row) in inverse.iter().enumerate() {
        for k in 0..mass.len() {
            let terms = || row.iter().zip(mass).map(|(x, column)| x * column[k]);
            let (sum, size) = (terms().sum::<f64>(), terms().map(f64::abs).sum::<f64>().max(1.0));
            let right = f64::from(u8::from(i == k));
            assert!((sum - right).abs() <= INVERTED * size, "{i}, {k}: {sum}, not {right}");
        }
    }
}

macro_rules! fixed {
    ($($test:ident: $name:ident;)*) => {$(
        #[test]
        fn $test() -> Outcome {
            const N: usize = $name::JOINTS.len();
            let (scene, mut noise) = ($name::scene::<f64>()?, Noise(7));
            let over = scene.lift(Dual::of);
            let mut kept = (ByState::zero(), [[1.0; N]; N]);
            for _ in 0..10 {
                let [q, v, torques]: [[f64; N]; 3] = [noise.list(3.0), noise.list(3.0), noise.list(20.0)];
                let seconds = scene.forward_dynamics(&q, &v, &torques)?;
                let taken = scene.inverse_dynamics_derivatives(&q, &v, &seconds)?;
                let (moved, by_torques) = scene.forward_dynamics_derivatives(&q, &v, &torques)?;
                let mass = scene.mass_matrix(&q)?;
                // Places that still hold what was found before.
                scene.mass_matrix_into(&q, &mut kept.1)?;
                assert_eq!(kept.1, mass);
                scene.forward_dynamics_derivatives_into(&q, &v, &torques, &mut kept)?;
                assert_eq!(kept, (moved, by_torques));
                let mass = mass.map(|row| row.to_vec());
                inverts(&by_torques.map(|row| row.to_vec()), &mass);
                let plain = |list: &[f64; N]| list.map(Dual::of);
                let column = |matrix: &[[f64; N]; N], k: usize| matrix.iter().map(|row| row[k]).collect::<Vec<_>>();
                let (mut positions, mut rates) = (vec![], vec![]);
                for k in 0..N {
                    let eps = |list: [Dual; N]| list.iter().map(|x| x.eps[0]).collect::<Vec<_>>();
                    positions.push(eps(over.inverse_dynamics(&seeded(&q, k), &plain(&v), &plain(&seconds))?));
                    rates.push(eps(over.inverse_dynamics(&plain(&q), &seeded(&v, k), &plain(&seconds))?));
                }
                compare(&positions, |k| column(&taken.positions, k), |k| column(&moved.positions, k), &mass);
                compare(&rates, |k| column(&taken.rates, k), |k| column(&moved.rates, k), &mass);
            }
            Ok(())
        }
    )*};
}
fixed! {
    of_an_arm: arm7_local;
    of_a_cart: cart_local;
    of_a_quadruped_that_stands: quadruped_fixed;
}

fn columns(of: [[f64; 3]; 3]) -> Columns<f64> {
    let [x, y, z] = of.map(Into::into);
    Columns { x, y, z }
}

/// A base at random.
fn base(noise: &mut Noise) -> Afloat<f64> {
    let list = noise.list::<4>(1.0);
    let length = list.iter().map(|x| x * x).sum::<f64>().sqrt();
    let [w, x, y, z] = list.map(|number| number / length);
    let attitude = columns([
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)],
        [2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)],
        [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]);
    let [place, velocity, spin] = [noise.list::<3>(1.0), noise.list(2.0), noise.list(2.0)];
    Afloat { place: Place { place: place.into(), attitude }, velocity: velocity.into(), spin: spin.into() }
}

/// The base over jets, which turns about its own axis `turn`, or gains spin about axis `spin`.
fn nudged(base: &Afloat<f64>, turn: Option<usize>, spin: Option<usize>) -> Afloat<Dual> {
    let unit = |k: Option<usize>, i: usize| if k == Some(i) { 1.0 } else { 0.0 };
    let dual = |re: f64, eps: f64| Jet { re, eps: [eps] };
    let Columns { x, y, z } = base.place.attitude;
    let axes = [x, y, z];
    // R (1 + φ×): column j changes by R (φ × e_j).
    let column = |j: usize| {
        let (next, last) = ((j + 1) % 3, (j + 2) % 3);
        let change = axes[next] * unit(turn, last) - axes[last] * unit(turn, next);
        let entries: [Dual; 3] = std::array::from_fn(|i| dual(axes[j][i], change[i]));
        entries.into()
    };
    let attitude = Columns { x: column(0), y: column(1), z: column(2) };
    let over = |v: [f64; 3]| v.map(Dual::of).into();
    let turning: [Dual; 3] = std::array::from_fn(|i| dual(base.spin[i], unit(spin, i)));
    let place = Place { place: over(base.place.place.into()), attitude };
    Afloat { place, velocity: over(base.velocity.into()), spin: turning.into() }
}

macro_rules! floating {
    ($($test:ident: $name:ident;)*) => {$(
        #[test]
        fn $test() -> Outcome {
            const N: usize = $name::JOINTS.len();
            let (scene, mut noise) = ($name::scene::<f64>()?, Noise(8));
            let over = scene.lift(Dual::of);
            for _ in 0..3 {
                let [q, v, torques]: [[f64; N]; 3] = [noise.list(3.0), noise.list(3.0), noise.list(20.0)];
                let (at, wrench): (_, [f64; 6]) = (base(&mut noise), noise.list(50.0));
                let (of_base, seconds) = scene.forward_dynamics_afloat(at, &q, &v, &wrench, &torques)?;
                // Forces come back.
                let (force, effort) = scene.snapshot_afloat(at, &q, &v)?.inverse_dynamics(&of_base, &seconds);
                let [found, given] = [[&force[..], &effort].concat(), [&wrench[..], &torques].concat()];
                agrees(&found, &given, 50.0, INVERTED);
                let taken = scene.inverse_dynamics_derivatives_afloat(at, &q, &v, &of_base, &seconds)?;
                let (moved, by_torques) = scene.forward_dynamics_derivatives_afloat(at, &q, &v, &wrench, &torques)?;
                let MassMatrix { base, coupling, joints } = scene.mass_matrix_afloat(at.place, &q)?;
                let first = (0..6).map(|i| base[i].into_iter().chain(coupling.iter().map(|row| row[i])).collect());
                let mass: Vec<Vec<f64>> = first.chain((0..N).map(|i| [&coupling[i][..], &joints[i]].concat())).collect();
                for Blocks { base, base_by_joints, joints_by_base, joints } in
                    [by_torques, scene.mass_inverse_afloat(at.place, &q)?]
                {
                    let first = (0..6).map(|i| [&base[i][..], &base_by_joints[i]].concat());
                    let rows = first.chain((0..N).map(|i| [&joints_by_base[i][..], &joints[i]].concat()));
                    inverts(&rows.collect::<Vec<_>>(), &mass);
                }
                // Columns by turn or spin of the base, then by joints.
                let column = |blocks: &Blocks<f64, N>, k: usize| -> Vec<f64> {
                    let Blocks { base, base_by_joints, joints_by_base, joints } = blocks;
                    match k {
                        0..3 => base.iter().chain(joints_by_base).map(|row| row[3 + k]).collect(),
                        _ => base_by_joints.iter().chain(joints).map(|row| row[k - 3]).collect(),
                    }
                };
                for (rate, taken, moved) in [(false, taken.positions, moved.positions), (true, taken.rates, moved.rates)] {
                    let mut jets = vec![];
                    for k in 0..3 + N {
                        let axis = (k < 3).then_some(k);
                        let at = if rate { nudged(&at, None, axis) } else { nudged(&at, axis, None) };
                        let number = if k < 3 { N } else { k - 3 };
                        let [of_q, of_v] = if rate { [N, number] } else { [number, N] };
                        let now = over.snapshot_afloat(at, &seeded(&q, of_q), &seeded(&v, of_v))?;
                        let (a, b) = now.inverse_dynamics(&of_base.map(Dual::of), &seconds.map(Dual::of));
                        jets.push(a.iter().chain(&b).map(|x| x.eps[0]).collect());
                    }
                    compare(&jets, |k| column(&taken, k), |k| column(&moved, k), &mass);
                    assert!((0..3).all(|k| moved.base.iter().chain(&moved.joints_by_base).all(|row| row[k] == 0.0)));
                }
            }
            Ok(())
        }
    )*};
}
floating! {
    of_a_quadruped: quadruped_local;
    of_a_humanoid: humanoid_local;
}
