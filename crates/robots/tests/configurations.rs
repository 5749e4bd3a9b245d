//! Differences of configurations, where they lead, and configurations at random.

#[path = "../../../tests/it/robots/kit.rs"]
#[allow(dead_code)] // each test needs some of it
mod kit;

use catena::robot::*;
use catena::{Error, Fault};
use catena_oracle::{Noise, near};
use catena_robots::{arm7_bare as arm7, humanoid};
use kit::{Drift, agree, drift, fixed, floating, list};
use nalgebra::{Matrix3, Rotation3, Vector3};
use std::f64::consts::PI;

const ROUNDING: f64 = 4e-15;

fn matrix(place: &Place<f64>) -> Matrix3<f64> {
    let Columns { x, y, z } = place.attitude;
    Matrix3::from_columns(&[x, y, z])
}

/// A place with an attitude given by another library.
fn at(place: Vector3<f64>, turn: &Rotation3<f64>) -> Place<f64> {
    let column = |k: usize| turn.matrix().column(k).into_owned();
    Place { place, attitude: Columns { x: column(0), y: column(1), z: column(2) } }
}

fn off(one: &Place<f64>, other: &Place<f64>) -> f64 {
    (matrix(one) - matrix(other)).amax().max((one.place - other.place).amax())
}

/// Any turn up to half a turn, a rounding small and within a rounding of half a turn: there and back, and as another library turns.
#[test]
fn bases_go_where_differences_lead() -> Result<(), Error> {
    let (scene, mut noise) = (floating()?, Noise::new(81));
    let vector = |noise: &mut Noise, size: f64| Vector3::from(list(noise, size));
    for angle in [0.0, 1e-300, 1e-15, 1e-8, 1e-3, 1.0, 3.0, PI - 1e-4, PI - 1e-9, PI - 1e-14] {
        for _ in 0..20 {
            let [q, p]: [[f64; 5]; 2] = std::array::from_fn(|_| list(&mut noise, 2.0));
            let from = at(vector(&mut noise, 2.0), &Rotation3::from_scaled_axis(vector(&mut noise, 3.0)));
            let psi = vector(&mut noise, 1.0).normalize() * angle;
            let to =
                at(vector(&mut noise, 2.0), &(Rotation3::from_matrix_unchecked(matrix(&from)) * Rotation3::new(psi)));
            let (of_base, of_joints) = scene.difference_afloat((from, &q), (to, &p))?;
            let turn = Vector3::new(of_base[3], of_base[4], of_base[5]);
            // Digits of a turn are those of the matrices; its direction turns over at half a turn.
            assert!((turn - psi).norm() < ROUNDING * 4.0, "{angle}: {turn} {psi}");
            let (base, joints) = scene.integrate_afloat((from, &q), (&of_base, &of_joints))?;
            assert!(off(&base, &to) < ROUNDING, "{angle}: {:e}", off(&base, &to));
            agree(&joints, &p, ROUNDING);
        }
    }
    // More than half a turn comes back as the rest of it, and leads to the same place.
    let none = ([0.0; 3], [0.0; 5]);
    let from = at(Vector3::from(none.0), &Rotation3::identity());
    let (to, _) = scene.integrate_afloat((from, &none.1), (&[0.0, 0.0, 0.0, 0.0, 0.0, 4.0], &none.1))?;
    let ([.., turn], _) = scene.difference_afloat((from, &none.1), (to, &none.1))?;
    near(turn, 4.0 - 2.0 * PI, ROUNDING);
    // A hundred thousand steps stay turns.
    let (mut base, step) = (from, [1e-3, 0.0, 0.0, 0.011, -0.023, 0.017]);
    for _ in 0..100_000 {
        (base, _) = scene.integrate_afloat((base, &none.1), (&step, &none.1))?;
    }
    assert!((matrix(&base).transpose() * matrix(&base) - Matrix3::identity()).amax() < ROUNDING);
    let whole = Rotation3::new(Vector3::new(0.011, -0.023, 0.017) * 1e5);
    assert!((matrix(&base) - whole.matrix()).amax() < 1e-10);
    // A turn whose last digit is a thousandth of a radian leads somewhere, but to an attitude.
    let (to, _) = scene.integrate_afloat((from, &none.1), (&[0.0, 0.0, 0.0, 1e13, -2e12, 3e12], &none.1))?;
    assert!((matrix(&to).transpose() * matrix(&to) - Matrix3::identity()).amax() < ROUNDING);
    Ok(())
}

/// A base, positions and rates of joints.
type Seen = (Afloat<f64>, [f64; 5], [f64; 5]);

/// A small difference over its time is the velocity that a scene shows.
#[test]
fn differences_are_velocities_in_their_axes() -> Result<(), Error> {
    const STEP: f64 = 1e-3;
    let (scene, mut noise) = (floating()?.with_gravity([0.0; 3]), Noise::new(82));
    let Drift { start, .. } = drift(&scene, &mut noise)?;
    let seen = |time: f64| -> Result<Seen, Error> {
        let now = scene.simulation(Dop853::tolerance(1e-13)).run(start, time, |_| ())?.motion;
        let (mut v, base) = ([0.0; 11], scene.body_motions(&now)?.get(0).map(Afloat::of).expect("a base"));
        now.rates_into(&mut v)?;
        let q = now.coordinates();
        Ok((base, std::array::from_fn(|k| q[7 + k]), std::array::from_fn(|k| v[6 + k])))
    };
    let [(one, q, _), (middle, _, v), (two, p, _)] = [seen(STEP)?, seen(2.0 * STEP)?, seen(3.0 * STEP)?];
    let (of_base, of_joints) = scene.difference_afloat((one.place, &q), (two.place, &p))?;
    // h² of the third derivative.
    let rates: Vec<f64> = middle.velocity.iter().chain(middle.spin.iter()).chain(&v).copied().collect();
    of_base.iter().chain(&of_joints).zip(rates).for_each(|(x, y)| near(*x / (2.0 * STEP), y, 3e-3));
    Ok(())
}

#[test]
fn joints_go_where_differences_lead() -> Result<(), Error> {
    let (scene, mut noise) = (fixed()?, Noise::new(83));
    for _ in 0..20 {
        let [q, p]: [[f64; 6]; 2] = std::array::from_fn(|_| list(&mut noise, 9.0));
        agree(&scene.integrate(&q, &scene.difference(&q, &p)?)?, &p, ROUNDING);
    }
    let fault = |result: Result<[f64; 6], Error>| result.map_err(|error| error.fault).err();
    let mut spoilt = [0.0; 6];
    spoilt[2] = f64::NAN;
    assert_eq!(fault(scene.difference(&spoilt, &[0.0; 6])), Some(Fault::NonFiniteMotion));
    assert_eq!(fault(scene.integrate(&[0.0; 6], &spoilt)), Some(Fault::NonFiniteMotion));
    let count = Some(Fault::Count { list: "numbers of joints", expected: 6, given: 2 });
    assert_eq!(scene.difference(&[0.0; 2], &[0.0; 2]).map_err(|error| error.fault).err(), count);
    Ok(())
}

/// Limits of a joint of a description, a turn where there are none.
fn range(lower: f64, upper: f64) -> [f64; 2] {
    let none = lower == f64::NEG_INFINITY && upper == f64::INFINITY;
    if none { [-PI, PI] } else { [lower, upper] }
}

/// Limits of descriptions: corners, middles, and nothing beyond.
#[test]
fn joints_at_random_are_within_limits() -> Result<(), Error> {
    let (arm, mut noise) = (arm7::scene::<f64>()?, Noise::new(84));
    let limits = [&arm7::LOWER, &arm7::UPPER];
    for _ in 0..100 {
        let shares: [f64; 7] = std::array::from_fn(|_| 0.5 + 0.5 * noise.next());
        let q = arm.random_configuration(limits, &shares)?;
        for k in 0..7 {
            let [lower, upper] = range(limits[0][k], limits[1][k]);
            assert!((lower..=upper).contains(&q[k]));
            near((q[k] - lower) / (upper - lower), shares[k], 1e-14);
        }
    }
    let corner = |upper: usize| std::array::from_fn(|k| range(limits[0][k], limits[1][k])[upper]);
    assert_eq!(arm.random_configuration(limits, &[0.0; 7])?, corner(0));
    let last = arm.random_configuration(limits, &[1.0 - 0.5 * f64::EPSILON; 7])?;
    assert!(last.iter().zip(corner(1)).all(|(q, upper)| *q <= upper));
    Ok(())
}

/// Hinges without limits, and what has no sense: the first slide of the kit is joint 1, its station 2, beyond hinge and link.
#[test]
fn limits_that_are_none() -> Result<(), Error> {
    let (scene, far) = (fixed()?, f64::INFINITY);
    let with = |joint: usize, [lower, upper]: [f64; 2], share: f64| {
        let (mut limits, mut shares) = ([[-1.0; 6], [1.0; 6]], [0.5; 6]);
        (limits[0][joint], limits[1][joint], shares[joint]) = (lower, upper, share);
        let q = scene.random_configuration([&limits[0], &limits[1]], &shares);
        q.map(|q| q[joint]).map_err(|error| (error.fault, error.place))
    };
    for (limits, right) in [([-far, far], -0.5 * PI), ([1.0, far], 1.0 + 0.5 * PI), ([-far, 2.0], 2.0 - 1.5 * PI)] {
        near(with(0, limits, 0.25).expect("a turn"), right, ROUNDING);
    }
    near(with(0, [-1.7e308, 1.7e308], 0.5).expect("a number"), 0.0, 1e292);
    assert_eq!(with(3, [0.7, 0.7], 0.9), Ok(0.7));
    let place = Some(catena::Place::Station(2));
    assert!(matches!(with(1, [-far, far], 0.5), Err((Fault::NotFinite { .. }, at)) if at == place));
    assert!(matches!(with(1, [0.0, far], 0.5), Err((Fault::NotFinite { .. }, at)) if at == place));
    assert!(matches!(with(1, [1.0, -1.0], 0.5), Err((Fault::Negative { value: -2.0, .. }, at)) if at == place));
    for limits in [[f64::NAN, 1.0], [0.0, f64::NAN], [far, far], [-far, -far], [far, -far]] {
        assert!(matches!(with(1, limits, 0.5), Err((Fault::Negative { .. }, at)) if at == place), "{limits:?}");
    }
    for share in [-0.1, 1.0, f64::NAN] {
        assert!(matches!(with(0, [-1.0, 1.0], share), Err((Fault::OutOfRange { .. }, None))));
    }
    Ok(())
}

/// Means over all attitudes: entries of the matrix are zero, their squares 1/3, by Gauss's two points and regular polygons, which are
/// exact for these.
#[test]
fn attitudes_at_random_are_uniform() -> Result<(), Error> {
    const CORNERS: usize = 8;
    let scene = humanoid::scene::<f64>()?;
    let limits = [&humanoid::LOWER, &humanoid::UPPER];
    let joints = [0.25; humanoid::JOINTS.len()];
    let (mut first, mut second, mut count) = (Matrix3::zeros(), Matrix3::<f64>::zeros(), 0.0);
    let gauss = 0.5 / 3.0_f64.sqrt();
    for share in [0.5 - gauss, 0.5 + gauss] {
        for turn in 0..CORNERS * CORNERS {
            let [one, two] = [turn / CORNERS, turn % CORNERS].map(|k| k as f64 / CORNERS as f64);
            let of_base = [0.0, 0.5, 0.25, share, one, two];
            let corners = [[-1.0, -2.0, 0.0], [1.0, 2.0, 4.0]];
            let (base, q) = scene.random_configuration_afloat(corners, limits, &of_base, &joints)?;
            assert_eq!(base.place, Vector3::new(-1.0, 0.0, 1.0));
            for (k, q) in q.into_iter().enumerate() {
                let [lower, upper] = range(humanoid::LOWER[k], humanoid::UPPER[k]);
                near(q, 0.75 * lower + 0.25 * upper, 1e-15);
            }
            let turn = matrix(&base);
            assert!((turn.transpose() * turn - Matrix3::identity()).amax() < ROUNDING && turn.determinant() > 0.0);
            (first, second, count) = (first + turn, second + turn.component_mul(&turn), count + 1.0);
        }
    }
    assert!((first / count).amax() < 1e-15);
    assert!((second / count).add_scalar(-1.0 / 3.0).amax() < 1e-15, "{}", second / count);
    let refused =
        |corners| scene.random_configuration_afloat(corners, limits, &[0.5; 6], &joints).map_err(|e| e.fault).err();
    assert!(matches!(refused([[0.0; 3], [1.0, -1.0, 1.0]]), Some(Fault::Negative { value: -1.0, .. })));
    assert!(matches!(refused([[0.0; 3], [1.0, f64::INFINITY, 1.0]]), Some(Fault::NotFinite { .. })));
    Ok(())
}
