//! Derivatives of inverse and forward dynamics, against jets through inverse dynamics and against central differences.

#[path = "../../../tests/it/robots/kit.rs"]
#[allow(dead_code)] // each test needs some of it
mod kit;

use catena::Error;
use catena::robot::*;
use catena::scalar::Jet;
use catena::system::Rate;
use catena_oracle::Noise;
use catena_oracle::space::Vector;
use kit::{agree, list};
use nalgebra::{DMatrix, DVector, Vector3};

/// Relative to the largest number of each list: some tens of roundings, times the condition of the mass matrix where it is inverted.
const DIRECT: f64 = 1e-13;
const INVERTED: f64 = 1e-12;

type Dual = Jet<f64, 1>;

/// A list of which number k changes.
fn seeded<const N: usize>(list: &[f64; N], k: usize) -> [Dual; N] {
    let mut moved = list.map(Jet::of);
    moved[k] = Jet::seed(list[k], 0);
    moved
}

/// −M⁻¹ times a matrix.
fn solved<const N: usize>(inverse: &[[f64; N]; N], by: &[[f64; N]; N]) -> [[f64; N]; N] {
    std::array::from_fn(|i| std::array::from_fn(|k| -(0..N).map(|j| inverse[i][j] * by[j][k]).sum::<f64>()))
}

/// All derivatives of a scene against jets through inverse dynamics, which knows nothing of them.
macro_rules! against_jets {
    ($scene:expr, $joints:literal, $seed:literal) => {{
        const N: usize = $joints;
        let (scene, mut noise) = ($scene, Noise::new($seed));
        let over = scene.lift(Dual::of);
        for _ in 0..50 {
            let [q, v, x]: [[f64; N]; 3] = std::array::from_fn(|_| list(&mut noise, 2.0));
            let plain = |list: &[f64; N]| list.map(Dual::of);
            let by = |seconds: &[f64; N]| -> Result<[[[f64; N]; N]; 2], Error> {
                let mut found = [[[0.0; N]; N]; 2];
                for k in 0..N {
                    let by_position = over.inverse_dynamics(&seeded(&q, k), &plain(&v), &plain(seconds))?;
                    let by_rate = over.inverse_dynamics(&plain(&q), &seeded(&v, k), &plain(seconds))?;
                    for i in 0..N {
                        (found[0][i][k], found[1][i][k]) = (by_position[i].eps[0], by_rate[i].eps[0]);
                    }
                }
                Ok(found)
            };
            let [positions, rates] = by(&x)?;
            let found = scene.inverse_dynamics_derivatives(&q, &v, &x)?;
            agree(found.positions.as_flattened(), positions.as_flattened(), DIRECT);
            agree(found.rates.as_flattened(), rates.as_flattened(), DIRECT);
            let [positions, rates] = by(&scene.forward_dynamics(&q, &v, &x)?)?;
            let (found, by_torques) = scene.forward_dynamics_derivatives(&q, &v, &x)?;
            let inverse = scene.mass_inverse(&q)?;
            agree(by_torques.as_flattened(), inverse.as_flattened(), INVERTED);
            agree(found.positions.as_flattened(), solved(&inverse, &positions).as_flattened(), INVERTED);
            agree(found.rates.as_flattened(), solved(&inverse, &rates).as_flattened(), INVERTED);
        }
    }};
}

/// Hinges and slides, all turns, an arm of two, dampers and reflected inertias.
#[test]
fn of_a_tree() -> Result<(), Error> {
    against_jets!(kit::fixed()?, 6, 41);
    Ok(())
}

/// Springs, and laws that are not linear: dry friction and stops, within and beyond their range.
#[test]
fn of_joints_with_laws() -> Result<(), Error> {
    let laws = (Spring::new(3.0).damped(0.4).resting_at(0.3), DryFriction::new(1.5, 0.2).breaking_away(2.0));
    let stops = Stops::between([-0.5, 0.7], 40.0, 0.2).damped(0.3);
    let link = |k| kit::general(kit::body(k));
    let chain = (
        Hinge::level().with(laws).grounded(),
        link(1),
        Branch((Slide::at::<7>([0.1, 0.2, 0.3]).turned(Quarter::<8>).with(stops), link(2))),
        Hinge::at::<4>([0.0, 0.0, 0.4]).turned(Quarter::<30>).with(stops).geared(0.2),
        link(3),
    );
    against_jets!(System::new(Base::at([0.3, -0.2, 0.5]), chain, Free)?.with_gravity(kit::GRAVITY), 3, 42);
    Ok(())
}

/// On ground that turns and accelerates, by central differences: h² of the third derivative, and rounding over h.
#[test]
fn on_ground_that_moves() -> Result<(), Error> {
    const STEP: f64 = 1e-5;
    let place = Moving(|t: f64| GroundMotion {
        place: [0.1, 0.2, 0.3],
        velocity: [0.4, -0.3, 0.2],
        acceleration: [1.5 + t, -2.0, 0.7],
    });
    let attitude = Turning(|t: f64| AttitudeMotion {
        attitude: Rotation::from_angles([0.3, 0.2, -0.4]),
        spin: [0.5, -0.8, 1.2],
        acceleration: [2.0 + t, 1.0, -3.0],
    });
    let link = |k| kit::general(kit::body(k));
    let slide = Slide::at::<7>([0.2, 0.1, 0.3]).turned(Quarter::<8>);
    let chain =
        (BodyAxes, Hinge::at::<3>([0.3, 0.4, 0.0]), link(1), slide, link(2), Hinge::at::<1>([0.3, 0.0, 0.0]), link(3));
    let scene = System::new(Clamped::on(place, attitude), chain, Free)?.with_gravity(kit::GRAVITY);
    let mut noise = Noise::new(43);
    for _ in 0..10 {
        let [q, v, x]: [[f64; 3]; 3] = std::array::from_fn(|_| list(&mut noise, 2.0));
        let found = scene.inverse_dynamics_derivatives(&q, &v, &x)?;
        for k in 0..3 {
            let moved = |list: [f64; 3], by: f64| std::array::from_fn(|i| if i == k { list[i] + by } else { list[i] });
            let difference = |at: &dyn Fn(f64) -> Result<[f64; 3], Error>| -> Result<[f64; 3], Error> {
                let [one, two] = [at(-STEP)?, at(STEP)?];
                Ok(std::array::from_fn(|i| (two[i] - one[i]) / (2.0 * STEP)))
            };
            let positions = difference(&|h| scene.inverse_dynamics(&moved(q, h), &v, &x))?;
            let rates = difference(&|h| scene.inverse_dynamics(&q, &moved(v, h), &x))?;
            agree(&found.positions.map(|row| row[k]), &positions, 1e-8);
            agree(&found.rates.map(|row| row[k]), &rates, 1e-8);
        }
    }
    Ok(())
}

/// What is no number is refused; the robot falls over itself, but not silently.
#[test]
fn of_what_is_not_finite() -> Result<(), Error> {
    let scene = kit::fixed()?;
    let (mut q, x) = ([0.1; 6], [0.2; 6]);
    q[2] = f64::NAN;
    let refused = scene.forward_dynamics_derivatives(&q, &x, &x).unwrap_err().fault;
    assert!(matches!(refused, catena::Fault::NonFiniteMotion), "{refused:?}");
    assert!(scene.inverse_dynamics_derivatives(&[0.0; 5], &[0.0; 5], &[0.0; 5]).is_err());
    Ok(())
}

/// Rows and columns of base and joints as one matrix.
fn dense<const N: usize>(blocks: &Blocks<f64, N>) -> DMatrix<f64> {
    DMatrix::from_fn(6 + N, 6 + N, |i, k| match (i < 6, k < 6) {
        (true, true) => blocks.base[i][k],
        (true, false) => blocks.base_by_joints[i][k - 6],
        (false, true) => blocks.joints_by_base[i - 6][k],
        (false, false) => blocks.joints[i - 6][k - 6],
    })
}

/// What changes: place or turn, velocity or spin of the base, position or rate of a joint.
fn nudged<const N: usize>(base: &Afloat<f64>, q: &[f64; N], k: usize, rate: bool) -> (Afloat<Dual>, [Dual; N]) {
    let over = |v: Vector| Vector3::new(Dual::of(v.x), Dual::of(v.y), Dual::of(v.z));
    let (plain, mut unit) = (q.map(Dual::of), Vector::zeros());
    if k < 6 {
        unit[k % 3] = 1.0;
    }
    let along = |v: Vector, by: Vector| {
        let of = |i: usize| Jet { re: v[i], eps: [by[i]] };
        Vector3::new(of(0), of(1), of(2))
    };
    let Columns { x, y, z } = base.place.attitude;
    let attitude = Columns { x: over(x), y: over(y), z: over(z) };
    let place = Place { place: over(base.place.place), attitude };
    let still = Afloat { place, velocity: over(base.velocity), spin: over(base.spin) };
    match (k, rate) {
        (0..3, false) => (Afloat { place: Place { place: along(base.place.place, unit), ..place }, ..still }, plain),
        (3..6, false) => {
            let turned = |axis: Vector, own: Vector| along(axis, base.place.attitude.apply(unit.cross(&own)));
            let attitude = Columns { x: turned(x, Vector::x()), y: turned(y, Vector::y()), z: turned(z, Vector::z()) };
            (Afloat { place: Place { attitude, ..place }, ..still }, plain)
        }
        (0..3, true) => (Afloat { velocity: along(base.velocity, unit), ..still }, plain),
        (3..6, true) => (Afloat { spin: along(base.spin, unit), ..still }, plain),
        _ => (still, seeded(q, k - 6)),
    }
}

/// All derivatives of a robot that floats, against jets through inverse dynamics of a snapshot, and its dynamics against a dense solution and
/// the scene's own.
#[test]
fn afloat() -> Result<(), Error> {
    const N: usize = 5;
    let (scene, mut noise) = (kit::floating()?, Noise::new(44));
    let over = scene.lift(Dual::of);
    let mut kept = (ByStateAfloat::zero(), Blocks::zero());
    let (mut matrix, mut blocks, mut slopes) = (MassMatrix::zero(), Blocks::zero(), ByStateAfloat::zero());
    for _ in 0..20 {
        let kit::Drift { start, q, v, .. } = kit::drift(&scene, &mut noise)?;
        let base = scene.body_motions(&start)?.get(0).map(Afloat::of).expect("a base");
        let (wrench, torques): ([f64; 6], [f64; N]) = (list(&mut noise, 3.0), list(&mut noise, 3.0));

        let now = scene.snapshot_afloat(base, &q, &v)?;
        let MassMatrix { base: of_base, coupling, joints } = now.mass_matrix();
        let base_by_joints = std::array::from_fn(|i| coupling.map(|column| column[i]));
        let mass = dense(&Blocks { base: of_base, base_by_joints, joints_by_base: coupling, joints });
        let found = scene.mass_matrix_afloat(base.place, &q)?;
        agree(found.base.as_flattened(), of_base.as_flattened(), DIRECT);
        agree(found.coupling.as_flattened(), coupling.as_flattened(), DIRECT);
        agree(found.joints.as_flattened(), joints.as_flattened(), DIRECT);
        // Places that still hold what was found before.
        scene.mass_matrix_afloat_into(base.place, &q, &mut matrix)?;
        assert_eq!(matrix, found);
        scene.mass_inverse_afloat_into(base.place, &q, &mut blocks)?;
        assert_eq!(blocks, scene.mass_inverse_afloat(base.place, &q)?);
        for joint in [None, Some(1), Some(N - 1)] {
            let point = list(&mut noise, 0.5);
            let (found, right) = (scene.jacobian_afloat(base.place, &q, joint, point)?, now.jacobian(joint, point)?);
            agree(found.base.as_flattened(), right.base.as_flattened(), DIRECT);
            agree(found.joints.as_flattened(), right.joints.as_flattened(), DIRECT);
        }
        assert!(scene.jacobian_afloat(base.place, &q, Some(N), [0.0; 3]).is_err());
        let inverse = mass.try_inverse().expect("masses are positive");
        let (a, b) = now.inverse_dynamics(&[0.0; 6], &[0.0; N]);
        let free = |k: usize| if k < 6 { wrench[k] - a[k] } else { torques[k - 6] - b[k - 6] };
        let right = &inverse * DVector::from_fn(6 + N, |k, _| free(k));
        let (of_base, seconds) = scene.forward_dynamics_afloat(base, &q, &v, &wrench, &torques)?;
        agree(&[&of_base[..], &seconds].concat(), right.as_slice(), INVERTED);
        let moved = scene.with_accelerations(start, &Torques(torques))?;
        let (of_base, of_joints) = scene.forward_dynamics_afloat(base, &q, &v, &[0.0; 6], &torques)?;
        let mut own = vec![];
        Rate::visit(moved.acceleration(), &mut |x: f64| own.push(x));
        agree(&[&of_base[..], &of_joints].concat(), &own, INVERTED);
        let (of_base, of_joints) = scene.mass_solved_afloat(base.place, &q, &wrench, &torques)?;
        let right = &inverse * DVector::from_iterator(6 + N, wrench.into_iter().chain(torques));
        agree(&[&of_base[..], &of_joints].concat(), right.as_slice(), INVERTED);
        agree(dense(&scene.mass_inverse_afloat(base.place, &q)?).as_slice(), inverse.as_slice(), INVERTED);

        let (of_base, seconds) = scene.forward_dynamics_afloat(base, &q, &v, &wrench, &torques)?;
        let taken = scene.inverse_dynamics_derivatives_afloat(base, &q, &v, &of_base, &seconds)?;
        scene.inverse_dynamics_derivatives_afloat_into(base, &q, &v, &of_base, &seconds, &mut slopes)?;
        assert_eq!(slopes, taken);
        let (moved, by_torques) = scene.forward_dynamics_derivatives_afloat(base, &q, &v, &wrench, &torques)?;
        scene.forward_dynamics_derivatives_afloat_into(base, &q, &v, &wrench, &torques, &mut kept)?;
        assert_eq!(kept, (moved, by_torques));
        agree(dense(&by_torques).as_slice(), inverse.as_slice(), INVERTED);
        for (rate, taken, moved) in [(false, taken.positions, moved.positions), (true, taken.rates, moved.rates)] {
            let mut by = DMatrix::zeros(6 + N, 6 + N);
            for k in 0..6 + N {
                let (base, list) = nudged(&base, if rate { &v } else { &q }, k, rate);
                let (q, v) = if rate { (q.map(Dual::of), list) } else { (list, v.map(Dual::of)) };
                let now = over.snapshot_afloat(base, &q, &v)?;
                let (a, b) = now.inverse_dynamics(&of_base.map(Dual::of), &seconds.map(Dual::of));
                a.iter().chain(&b).enumerate().for_each(|(i, x)| by[(i, k)] = x.eps[0]);
            }
            agree(dense(&taken).as_slice(), by.as_slice(), DIRECT);
            agree(dense(&moved).as_slice(), (-&inverse * &by).as_slice(), INVERTED);
        }
    }
    Ok(())
}

#[test]
fn lists_of_another_length_are_refused_by_robots_that_float() -> Result<(), catena::Error> {
    let scene = kit::floating()?;
    let place = Place { place: Vector3::zeros(), attitude: Columns::identity() };
    let expected = catena::Fault::Count { list: "numbers of joints", expected: 5, given: 1 };
    let none = [0.0; 6];
    let base = Afloat { place, velocity: Vector3::zeros(), spin: Vector3::zeros() };
    let refused = [
        scene.mass_inverse_afloat(place, &[0.3]).map(|_| ()),
        scene.mass_matrix_afloat(place, &[0.3]).map(|_| ()),
        scene.mass_solved_afloat(place, &[0.3], &none, &[0.0]).map(|_| ()),
        scene.jacobian_afloat(place, &[0.3], None, [0.0; 3]).map(|_| ()),
        scene.forward_dynamics_afloat(base, &[0.3], &[0.0], &none, &[0.0]).map(|_| ()),
        scene.forward_dynamics_derivatives_afloat(base, &[0.3], &[0.0], &none, &[0.0]).map(|_| ()),
        scene.inverse_dynamics_derivatives_afloat(base, &[0.3], &[0.0], &none, &[0.0]).map(|_| ()),
    ];
    for refused in refused {
        assert_eq!(refused.map_err(|error| error.fault), Err(expected));
    }
    Ok(())
}

#[test]
fn a_base_that_carries_no_link_is_refused() -> Result<(), catena::Error> {
    let link = Link::general(3.0_f64, [0.1, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.06, 0.0], [0.0, 0.0, 0.01]]);
    let robot = System::new(Free, (BodyAxes, Hinge::at::<7>([0.3, 0.2, -0.1]), link), Free)?;
    for angle in [0.0, 0.4, 1.1] {
        let (s, c) = f64::sin_cos(angle);
        let attitude = Columns {
            x: Vector3::new(c, s, 0.0),
            y: Vector3::new(-0.6 * s, 0.6 * c, 0.8),
            z: Vector3::new(0.8 * s, -0.8 * c, 0.6),
        };
        let place = Place { place: Vector3::new(1.0, 2.0, 3.0), attitude };
        let refused = robot.mass_inverse_afloat(place, &[0.3]).map_err(|error| error.fault);
        assert_eq!(refused.map(|_| ()), Err(catena::Fault::NonFiniteMotion));
    }
    Ok(())
}
